//! The same scenes on Resultant, Rapier (f32 and f64) and Box2D, one thread, rotation off; `README.md` says what each scene is, and with
//! which steps and settings it is run. Prints a table and what falls short of the aims, and writes `results.csv`, from which `resultant
//! chart` takes its peers' points.
//!
//! Run it with `cargo run --release` in this folder; names of scenes after `--` choose those, whose rows are then replaced. Sleep is off
//! in all engines but for the scenes that are about it.

mod box2d;
mod crowds;
mod engine;
mod exact;
mod ours;
mod rapier;
mod scenes;
mod watch;

use cpu_time::ThreadTime;
use engine::{Engine, Spec};
use scenes::{STEP, Scene};
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

/// The columns of `results.csv`.
const HEAD: &str = "scene,engine,version,settings,step,work,error,overlap,speed,times";

/// One engine on one scene.
struct Row {
    engine: &'static str,
    version: String,
    settings: String,
    /// s.
    step: f64,
    /// CPU time for a simulated second and body, ns.
    work: f64,
    error: f64,
    /// The deepest overlap of any two things after any step, m.
    overlap: f64,
    /// The speed of the fastest body at the end, m/s.
    speed: f64,
}

#[allow(clippy::disallowed_methods)] // it measures
fn measure<E: Engine>(scene: &Scene, spec: &Spec, step: f64) -> Option<Row> {
    let steps = (scene.seconds / step).round() as usize;
    let mut engine = E::new(spec)?;
    let settled = scene.settle > 0.0;
    (0..(scene.settle / step).round() as usize).for_each(|_| engine.step(step));
    let mut watched = Watched::new(&mut engine, spec);
    let error = (scene.error)(&mut watched, spec, steps, step);
    let (overlap, speed) = (watched.overlap(), watched.speed());
    let mut time = |repeats: usize| {
        // What has settled is as good after a run as before it.
        let mut fresh: Vec<E> = if settled { Vec::new() } else { (0..repeats).filter_map(|_| E::new(spec)).collect() };
        let started = ThreadTime::now();
        if settled {
            (0..steps * repeats).for_each(|_| engine.step(step));
        }
        for engine in &mut fresh {
            (0..steps).for_each(|_| engine.step(step));
        }
        started.elapsed().as_secs_f64() / repeats as f64
    };
    let repeats = (LONG_ENOUGH.as_secs_f64() / time(1)).ceil().clamp(1.0, 100.0) as usize;
    let mut times: Vec<f64> = (0..RUNS).map(|_| time(repeats)).collect();
    times.sort_by(f64::total_cmp);
    let work = times[RUNS / 2] * 1e9 / (scene.seconds * spec.bodies.len() as f64);
    Some(Row { engine: E::NAME, version: E::version(), settings: E::settings(spec.stiff), step, work, error, overlap, speed })
}

/// All engines on a scene at a step, Resultant first; those that can be made stiff so, too, where that is asked for.
fn run(scene: &Scene, step: f64) -> Vec<Row> {
    let spec = &scene.spec;
    let ours = if scene.pile { measure::<ours::Crowds>(scene, spec, step) } else { measure::<ours::Scenes>(scene, spec, step) };
    let mut rows = vec![
        ours,
        measure::<rapier::single::Rapier>(scene, spec, step),
        measure::<rapier::double::Rapier>(scene, spec, step),
        measure::<box2d::Box2d>(scene, spec, step),
    ];
    if scene.stiffly {
        let stiff = Spec { stiff: true, ..spec.clone() };
        rows.push(measure::<rapier::double::Rapier>(scene, &stiff, step));
        rows.push(measure::<box2d::Box2d>(scene, &stiff, step));
    }
    rows.into_iter().flatten().collect()
}

/// What of the aims a peer's row shows not to be reached.
fn shortfall(scene: &Scene, ours: &Row, peer: &Row, text: &mut String) {
    let (faster, better) = (peer.work / ours.work, peer.error / ours.error);
    if faster < FASTER {
        let _ = writeln!(text, "{}: {faster:.1} times as fast as {}, {}", scene.name, peer.engine, peer.settings);
    }
    // Two errors of nothing are alike.
    if better < BETTER {
        let _ = writeln!(text, "{}: {better:.1} times as accurate as {}, {}", scene.name, peer.engine, peer.settings);
    }
}

/// The rows of `results.csv`, as far as they are of that form.
fn kept(path: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let lines = text.strip_prefix(HEAD).unwrap_or_default().lines();
    lines.filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

/// Prints the rows of one scene and step, and gives them as lines of `results.csv`.
fn tell(scene: &Scene, rows: &[Row]) -> String {
    let n = scene.spec.bodies.len() as f64;
    let mut lines = String::new();
    for row in rows {
        let times = row.work / rows[0].work;
        let each = row.work * row.step;
        println!(
            "{:<21} {:<11} {:<22} {:>6.0} {:>12.1} {:>12.0} {:>8.1} {:>9.1e} {:>11.1e} {:>9.1e}  {}",
            scene.name,
            row.engine,
            row.settings,
            1.0 / row.step,
            each,
            each * n,
            times,
            row.error,
            row.overlap,
            row.speed,
            scene.what
        );
        let numbers = [row.step, row.work, row.error, row.overlap, row.speed, times];
        let numbers = numbers.map(|number| format!("{number:e}")).join(",");
        let _ = writeln!(lines, "{},{},{},\"{}\",{numbers}", scene.name, row.engine, row.version, row.settings);
    }
    lines
}

fn main() -> std::io::Result<()> {
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("results.csv");
    let before = kept(&path);
    let mut csv = format!("{HEAD}\n");
    let mut short = String::new();
    println!(
        "{:<21} {:<11} {:<22} {:>6} {:>12} {:>12} {:>8} {:>9} {:>11} {:>9}  error is",
        "scene", "engine", "settings", "steps", "ns/body/step", "ns/step", "× ours", "error", "overlap, m", "end, m/s"
    );
    for scene in exact::scenes().into_iter().chain(crowds::scenes()) {
        if !chosen.is_empty() && !chosen.iter().any(|name| name == scene.name) {
            let mine = |line: &&String| line.split(',').next() == Some(scene.name);
            before.iter().filter(mine).for_each(|line| csv.extend([line.as_str(), "\n"]));
            continue;
        }
        for &step in scene.steps {
            let rows = run(&scene, step);
            csv += &tell(&scene, &rows);
            for peer in rows.iter().skip(1).filter(|_| step == STEP) {
                shortfall(&scene, &rows[0], peer, &mut short);
            }
        }
    }
    let short = if short.is_empty() { "nothing\n" } else { &short };
    print!("\nShort of {FASTER} times as fast and {BETTER} times as accurate at 60 steps a second:\n{short}");
    std::fs::write(path, csv)
}
