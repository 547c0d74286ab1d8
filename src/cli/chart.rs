//! `resultant chart`: measures every method on every scene of the lab, and writes diagrams, tables and a summary. It is the only
//! place of the lab with a clock and files.

use super::{Project, Status, Stop};
use crate::lab::curve::{Curve, Measured, Origin, Point};
use crate::lab::report::{Setting, add_peers, points_csv, stress_csv, summary};
use crate::lab::{Method, Scene, diagram, scenes, stress};
use std::hint::black_box;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

/// What `chart` is told.
#[derive(clap::Args, Debug)]
#[command(after_help = "Writes into DIR, made if need be:\n  \
    summary.md   machine, commit, tables and all diagrams on one page\n  \
    SCENE.svg    a work–precision diagram a scene\n  \
    SCENE.csv    its points: method,origin,step,work,error\n  \
    stress.csv   the largest value that each method survives\n\n\
    Points of other engines are taken from benches/peers/results.csv where that file is there.")]
pub struct Args {
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "charts")]
    out: PathBuf,
    /// Fewer repetitions: within a minute
    #[arg(long)]
    quick: bool,
}

/// Runs of a point, of which the median counts.
const RUNS: usize = 9;
/// The same with --quick.
const QUICK_RUNS: usize = 3;
/// A run is repeated until it takes this long: the clock's own time must not count.
const LONG_ENOUGH: Duration = Duration::from_micros(300);
/// A run that takes this long is not repeated with --quick.
const TOO_LONG: Duration = Duration::from_millis(60);

/// Measures and writes.
///
/// # Errors
/// A folder or file cannot be written, or the peers' results cannot be read.
pub fn run(args: &Args, project: &Project, out: &mut dyn Write) -> Result<Status, Stop> {
    let unwritable = |path: &Path, error: std::io::Error| Stop::refused(format!("{}: {error}", path.display()));
    std::fs::create_dir_all(&args.out).map_err(|error| unwritable(&args.out, error))?;
    let peers = project.root().join("benches/peers/results.csv");
    let peers_text = match std::fs::read_to_string(&peers) {
        Ok(text) => Some(text),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
        Err(error) => return Err(unwritable(&peers, error)),
    };
    let bad_peers = |problem| Stop::refused(format!("{}: {problem}", peers.display()));
    if let Some(text) = &peers_text {
        // Before minutes are spent.
        add_peers(text, &mut Vec::new()).map_err(bad_peers)?;
    }

    progress("building scenes and their exact answers");
    let scenes = scenes::all();
    let mut diagrams = Vec::new();
    for (index, scene) in scenes.iter().enumerate() {
        progress(&format!("{}/{} {}", index + 1, scenes.len(), scene.title));
        diagrams.push(measure(scene, args.quick));
    }
    let mut survivals = Vec::new();
    for (index, test) in stress::TESTS.iter().enumerate() {
        let rows = test();
        let name = rows.first().map_or("", |row| row.test);
        progress(&format!("stress {}/{} {name}", index + 1, stress::TESTS.len()));
        survivals.extend(rows);
    }
    if let Some(text) = &peers_text {
        add_peers(text, &mut diagrams).map_err(bad_peers)?;
    }

    let mut write = |name: &str, text: &str| -> Result<(), Stop> {
        let path = args.out.join(name);
        std::fs::write(&path, text).map_err(|error| unwritable(&path, error))?;
        Ok(writeln!(out, "{}", path.display())?)
    };
    for measured in &diagrams {
        let drawn = diagram::svg(measured).map_err(|error| Stop::refused(format!("{}.svg: {error}", measured.name)))?;
        write(&format!("{}.svg", measured.name), &drawn)?;
        write(&format!("{}.csv", measured.name), &points_csv(measured))?;
    }
    write("stress.csv", &stress_csv(&survivals))?;
    let profile = if cfg!(debug_assertions) { "debug" } else { "release" };
    let setting = Setting { machine: machine(), commit: commit(project.root()), profile, quick: args.quick };
    write("summary.md", &summary(&setting, &diagrams, &survivals))?;
    Ok(Status::Done)
}

fn progress(what: &str) {
    // Nothing can be done about a standard error that is closed.
    let _ = writeln!(std::io::stderr(), "{what}");
}

fn measure(scene: &Scene, quick: bool) -> Measured {
    let curves = scene.methods.iter().map(|method| Curve {
        name: method.name.clone(),
        origin: if method.shipped { Origin::Shipped } else { Origin::Lab },
        points: scene.steps.iter().map(|&step| point(scene, method, step, quick)).collect(),
    });
    Measured {
        name: scene.name.to_owned(),
        title: scene.title.clone(),
        error: scene.error.to_owned(),
        work: scene.work.to_owned(),
        tolerance: scene.tolerance,
        shipped_step: scene.shipped_step,
        alike: scene.alike,
        curves: curves.collect(),
    }
}

/// The median of several runs.
fn point(scene: &Scene, method: &Method, step: f64, quick: bool) -> Point {
    let started = Instant::now();
    let error = (method.run)(black_box(step));
    let first = started.elapsed();
    let runs = match (quick, first > TOO_LONG) {
        (true, true) => 1,
        (true, false) => QUICK_RUNS,
        (false, _) => RUNS,
    };
    let repeats = (LONG_ENOUGH.as_secs_f64() / first.as_secs_f64().max(1e-9)).ceil().clamp(1.0, 1e5) as u32;
    let mut times: Vec<f64> = if runs == 1 { vec![first.as_secs_f64()] } else { Vec::new() };
    while times.len() < runs {
        let started = Instant::now();
        for _ in 0..repeats {
            black_box((method.run)(black_box(step)));
        }
        times.push(started.elapsed().as_secs_f64() / f64::from(repeats));
    }
    times.sort_by(f64::total_cmp);
    Point { step, work: times[times.len() / 2] * 1e9 / scene.share, error }
}

/// The kind of machine, without its name.
fn machine() -> String {
    let system = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
    let Ok(text) = std::fs::read_to_string("/proc/cpuinfo") else { return system };
    let model = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    model.map_or(system.clone(), |(_, model)| format!("{}, {system}", model.trim()))
}

/// The commit of the folder, if git knows one.
fn commit(root: &Path) -> Option<String> {
    let ran = Command::new("git").arg("-C").arg(root).args(["rev-parse", "--short", "HEAD"]).output().ok()?;
    let text = String::from_utf8(ran.stdout).ok()?;
    (ran.status.success() && !text.trim().is_empty()).then(|| text.trim().to_owned())
}
