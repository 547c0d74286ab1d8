//! The same scenes on Resultant, Rapier (f32 and f64) and Box2D, one thread, rotation off, 60 steps a second, everything else at its
//! defaults; `README.md` says what each scene is. Prints a table and what falls short of the aims, and writes `results.csv`, from which
//! `resultant chart` takes its peers' points.
//!
//! Run it with `cargo run --release` in this folder; names of scenes after `--` choose those (and write nothing). Sleep is off in all
//! engines but for the scenes that are about it.

mod box2d;
mod engine;
mod ours;
mod rapier;
mod scenes;
mod watch;

use cpu_time::ThreadTime;
use engine::Engine;
use scenes::Scene;
use std::fmt::Write as _;
use std::path::Path;
use std::time::Duration;
use watch::{Run, Watched};

/// Runs of a scene, of which the median counts.
const RUNS: usize = 5;
/// Short scenes are run several times over until they take so long: the clock's own time must not count.
const LONG_ENOUGH: Duration = Duration::from_millis(5);
/// How many times faster, and how many times more accurate, Resultant shall be.
const FASTER: f64 = 4.0;
const BETTER: f64 = 100.0;

/// One engine on one scene.
struct Row {
    engine: &'static str,
    /// CPU time for a simulated second and body, ns.
    work: f64,
    error: f64,
    /// The deepest overlap of any two things after any step, m.
    overlap: f64,
    /// The speed of the fastest body at the end, m/s.
    speed: f64,
}

fn measure<E: Engine>(scene: &Scene) -> Option<Row> {
    let steps = (scene.seconds / scene.step).round() as usize;
    let mut engine = E::new(&scene.spec)?;
    let settled = scene.settle > 0.0;
    (0..(scene.settle / scene.step).round() as usize).for_each(|_| engine.step(scene.step));
    let mut watched = Watched::new(&mut engine, &scene.spec);
    let error = (scene.error)(&mut watched, &scene.spec, steps, scene.step);
    let (overlap, speed) = (watched.overlap(), watched.speed());
    let mut time = |repeats: usize| {
        // What has settled is as good after a run as before it.
        let mut fresh: Vec<E> = if settled {
            Vec::new()
        } else {
            (0..repeats).filter_map(|_| E::new(&scene.spec)).collect()
        };
        let started = ThreadTime::now();
        if settled {
            (0..steps * repeats).for_each(|_| engine.step(scene.step));
        }
        for engine in &mut fresh {
            (0..steps).for_each(|_| engine.step(scene.step));
        }
        started.elapsed().as_secs_f64() / repeats as f64
    };
    let repeats = (LONG_ENOUGH.as_secs_f64() / time(1)).ceil().clamp(1.0, 100.0) as usize;
    let mut times: Vec<f64> = (0..RUNS).map(|_| time(repeats)).collect();
    times.sort_by(f64::total_cmp);
    let work = times[RUNS / 2] * 1e9 / (scene.seconds * scene.spec.bodies.len() as f64);
    Some(Row {
        engine: E::NAME,
        work,
        error,
        overlap,
        speed,
    })
}

/// All engines on a scene, Resultant first.
fn run(scene: &Scene) -> Vec<Row> {
    let ours = if scene.pile {
        measure::<ours::Piles>(scene)
    } else {
        measure::<ours::Scenes>(scene)
    };
    let rows = [
        ours,
        measure::<rapier::single::Rapier>(scene),
        measure::<rapier::double::Rapier>(scene),
        measure::<box2d::Box2d>(scene),
    ];
    rows.into_iter().flatten().collect()
}

/// What of the aims a peer's row shows not to be reached.
fn shortfall(scene: &Scene, ours: &Row, peer: &Row, text: &mut String) {
    let (faster, better) = (peer.work / ours.work, peer.error / ours.error);
    if faster < FASTER {
        let _ = writeln!(text, "{}: {faster:.1} times as fast as {}", scene.name, peer.engine);
    }
    // Two errors of nothing are alike.
    if better < BETTER {
        let _ = writeln!(text, "{}: {better:.1} times as accurate as {}", scene.name, peer.engine);
    }
}

fn main() -> std::io::Result<()> {
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    let mut csv = "scene,engine,step,work,error,overlap,speed,times\n".to_owned();
    let mut short = String::new();
    println!(
        "{:<21} {:<11} {:>12} {:>12} {:>8} {:>9} {:>11} {:>9}  error is",
        "scene", "engine", "ns/body/step", "ns/step", "× ours", "error", "overlap, m", "end, m/s"
    );
    for scene in scenes::all() {
        if !chosen.is_empty() && !chosen.iter().any(|name| name == scene.name) {
            continue;
        }
        let rows = run(&scene);
        let n = scene.spec.bodies.len() as f64;
        for row in &rows {
            let times = row.work / rows[0].work;
            let step = row.work * scene.step;
            println!(
                "{:<21} {:<11} {:>12.1} {:>12.0} {:>8.1} {:>9.1e} {:>11.1e} {:>9.1e}  {}",
                scene.name,
                row.engine,
                step,
                step * n,
                times,
                row.error,
                row.overlap,
                row.speed,
                scene.what
            );
            let _ = writeln!(
                csv,
                "{},{},{:e},{:e},{:e},{:e},{:e},{:e}",
                scene.name, row.engine, scene.step, row.work, row.error, row.overlap, row.speed, times
            );
        }
        for peer in rows.iter().skip(1) {
            shortfall(&scene, &rows[0], peer, &mut short);
        }
    }
    let short = if short.is_empty() { "nothing\n" } else { &short };
    print!("\nShort of {FASTER} times as fast and {BETTER} times as accurate:\n{short}");
    if chosen.is_empty() {
        std::fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("results.csv"), csv)?;
    }
    Ok(())
}
