//! The same scenes on Resultant, Rapier (f32 and f64) and Box2D, one thread, rotation off, sleep off, 60 steps a second, everything
//! else at its defaults. Prints a table and writes `results.csv`, from which `resultant chart` takes its peers' points.
//!
//! Run it with `cargo run --release` in this folder. Sleep is off in all of them; only the shortcut that our small-scene engine has
//! for a world in which nothing moves at all cannot be turned off: it shows in the column, the heavy pair and at the end of the
//! slide.

mod box2d;
mod engine;
mod ours;
mod rapier;
mod scenes;

use cpu_time::ThreadTime;
use engine::Engine;
use scenes::Scene;
use std::fmt::Write as _;
use std::path::Path;
use std::time::Duration;

/// Runs of a scene, of which the median counts.
const RUNS: usize = 5;
/// Short scenes are run several times over until they take so long: the clock's own time must not count.
const LONG_ENOUGH: Duration = Duration::from_millis(5);

/// One engine on one scene.
struct Row {
    scene: &'static str,
    engine: &'static str,
    step: f64,
    /// CPU time for a simulated second and body, ns.
    work: f64,
    error: f64,
}

fn measure<E: Engine>(scene: &Scene) -> Option<Row> {
    let steps = (scene.seconds / scene.step).round() as usize;
    let mut engine = E::new(&scene.spec)?;
    let error = (scene.error)(&mut engine, &scene.spec, steps, scene.step);
    let time = |repeats: u32| {
        let mut engines: Vec<E> = (0..repeats).filter_map(|_| E::new(&scene.spec)).collect();
        let started = ThreadTime::now();
        for engine in &mut engines {
            for _ in 0..steps {
                engine.step(scene.step);
            }
        }
        started.elapsed().as_secs_f64() / engines.len() as f64
    };
    let repeats = (LONG_ENOUGH.as_secs_f64() / time(1)).ceil().clamp(1.0, 100.0) as u32;
    let mut times: Vec<f64> = (0..RUNS).map(|_| time(repeats)).collect();
    times.sort_by(f64::total_cmp);
    let work = times[RUNS / 2] * 1e9 / (scene.seconds * scene.spec.bodies.len() as f64);
    Some(Row {
        scene: scene.name,
        engine: E::NAME,
        step: scene.step,
        work,
        error,
    })
}

/// The engine on the scene, if it takes part in it.
fn run(scene: &Scene, rows: &mut Vec<Row>) {
    if scene.pile {
        rows.extend(measure::<ours::Piles>(scene));
    } else {
        rows.extend(measure::<ours::Scenes>(scene));
    }
    rows.extend(measure::<rapier::single::Rapier>(scene));
    rows.extend(measure::<rapier::double::Rapier>(scene));
    rows.extend(measure::<box2d::Box2d>(scene));
}

fn main() -> std::io::Result<()> {
    let mut csv = "scene,engine,step,work,error\n".to_owned();
    println!(
        "{:<16} {:<14} {:>16} {:>12}  error is",
        "scene", "engine", "ns/body/step", "error"
    );
    for scene in scenes::all() {
        eprintln!("{}", scene.name);
        let mut rows = Vec::new();
        run(&scene, &mut rows);
        for row in rows {
            println!(
                "{:<16} {:<14} {:>16.1} {:>12.2e}  {}",
                row.scene,
                row.engine,
                row.work * row.step,
                row.error,
                scene.what
            );
            let _ = writeln!(
                csv,
                "{},{},{:e},{:e},{:e}",
                row.scene, row.engine, row.step, row.work, row.error
            );
        }
    }
    std::fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("results.csv"), csv)
}
