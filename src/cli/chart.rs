//! `resultant chart` measures every method on every scene of the lab, and writes diagrams, tables and a summary. The clock is the
//! thread's CPU time, as in `benches/peers`: other work of the machine counts for little.

use super::files::{OutputFile, Staged, read_text};
use super::project::Project;
use super::{CommandError, Status};
use crate::draw::chart::look::CurveOrigin;
use crate::files::{self, CHART};
use crate::lab::charts::{Charts, MeasuredWith};
use crate::lab::curve::{CoursePoint, Measured, MethodCurve, OverTime, WorkPoint};
use crate::lab::drawing::picture;
use crate::lab::kept::add_peers;
use crate::lab::report::{shipped_csv, summary};
use crate::lab::{LabScene, SceneMethod, scenes, stability, stress};
use std::hint::black_box;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

#[cfg(any(unix, windows))]
use cpu_time::ThreadTime as Clock;
#[cfg(not(any(unix, windows)))]
use std::time::Instant as Clock;

#[derive(clap::Args, Debug)]
#[command(after_help = "Writes into DIR, made if need be:\n  \
    summary.md   machine, commit, tables and all diagrams on one page\n  \
    SCENE.svg    a work–precision diagram a scene\n  \
    SCENE.csv    its points: method,origin,step,work,error\n  \
    SCENE-over-time.svg, .csv  error and energy while it runs, of some scenes\n  \
    scenes.csv   the diagrams: titles, axes, tolerances\n  \
    shipped.csv  what the shipped engine costs in each scene, and the cheapest method\n  \
    stress.csv   the largest value that each method survives\n  \
    stability.svg, .csv, stability-limits.csv  where methods are stable, on the complex plane\n  \
    setting.csv  machine, commit, build\n\n\
    All files are written when everything has been measured, or none. Points of other engines are taken from\n\
    benches/peers/results.csv where that file is there. The game's Lab shows what is in charts/ of its data folder.")]
pub struct ChartArgs {
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "charts")]
    out: PathBuf,
    /// Fewer repetitions: within a minute
    #[arg(long)]
    quick: bool,
}

/// s. The usual step of physics engines, at which methods are followed over time.
const FOLLOWED: f64 = 1.0 / 60.0;
/// Runs of a point; the median counts.
const RUNS: usize = 9;
const QUICK_RUNS: usize = 3;
/// A run repeats until it takes this long, so that the clock's own cost, about 1 µs, does not count.
const LONG_ENOUGH: Duration = Duration::from_micros(300);
/// With --quick a run of this length does not repeat.
const TOO_LONG: Duration = Duration::from_millis(60);

/// Errors: a folder that cannot be written, or peers' results that cannot be read, before any measurement. A later fault of the
/// disk leaves no file half written.
pub fn run(args: &ChartArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    if args.out.exists() && !args.out.is_dir() {
        return Err(CommandError::Refused(format!(
            "--out {}: found a file, expected a folder or the name of a new one",
            args.out.display()
        )));
    }
    let peers = peers(project)?;
    progress("building scenes and their exact answers");
    let scenes = scenes::all();
    std::fs::create_dir_all(&args.out).map_err(|error| CommandError::refused(format!("{}: {error}", args.out.display())))?;
    for scene in &scenes {
        OutputFile::create(&args.out.join(format!("{}.csv", scene.name)))?;
        OutputFile::create(&args.out.join(format!("{}.svg", scene.name)))?;
    }

    let mut diagrams = Vec::new();
    for (index, scene) in scenes.iter().enumerate() {
        progress(&format!("{}/{} {}", index + 1, scenes.len(), scene.title));
        diagrams.push(measure(scene, args.quick));
    }
    let mut survivals = Vec::new();
    for (index, test) in stress::TESTS.iter().enumerate() {
        let test = test();
        progress(&format!("stress {}/{} {}", index + 1, stress::TESTS.len(), test.name));
        survivals.extend(test.rows());
    }
    if let Some((path, text)) = &peers {
        add_peers(path, text, &mut diagrams).map_err(CommandError::Refused)?;
    }

    let profile = if cfg!(debug_assertions) { "debug" } else { "release" }.to_owned();
    let setting = MeasuredWith { machine: machine(), commit: commit(project.root()), profile, quick: args.quick };
    let charts = Charts { setting, diagrams, stress: survivals, savings: Vec::new() };
    let files = all_files(&charts);
    let staged = stage(&args.out, &files)?;
    for (name, _) in &files {
        writeln!(out, "{}", args.out.join(name).display())?;
    }
    out.flush()?;
    Staged::place_all(staged)?;
    Ok(Status::Done)
}

/// Names and contents.
fn all_files(charts: &Charts) -> Vec<(String, String)> {
    let mut files = charts.files();
    for measured in &charts.diagrams {
        files.push((format!("{}.svg", measured.name), picture::measured(measured)));
        files.extend(picture::over_time(measured).map(|drawn| (format!("{}-over-time.svg", measured.name), drawn)));
    }
    let regions = stability::regions();
    files.push((stability::SVG.to_owned(), picture::stability(&regions)));
    files.extend(stability::csv(&regions).map(|(name, text)| (name.to_owned(), text)));
    files.push(("shipped.csv".to_owned(), shipped_csv(&charts.diagrams)));
    files.push(("summary.md".to_owned(), summary(charts, &regions)));
    files
}

/// The file's name and checked text, if there is such a file.
fn peers(project: &Project) -> Result<Option<(String, String)>, CommandError> {
    let path = project.root().join("benches/peers/results.csv");
    if !path.exists() {
        return Ok(None);
    }
    let (name, text) = (path.display().to_string(), read_text(&path, &path, CHART)?);
    add_peers(&name, &text, &mut Vec::new()).map_err(CommandError::Refused)?;
    Ok(Some((name, text)))
}

/// Writes all files before any takes its place.
fn stage(folder: &Path, files: &[(String, String)]) -> Result<Vec<Staged>, CommandError> {
    let stage = |(name, text): &(String, String)| {
        let mut file = OutputFile::create(&folder.join(name))?;
        file.write_all(text.as_bytes())?;
        file.stage()
    };
    files.iter().map(stage).collect()
}

fn progress(what: &str) {
    // A closed standard error does not stop the measurement.
    let _ = writeln!(std::io::stderr(), "{what}");
}

fn measure(scene: &LabScene, quick: bool) -> Measured {
    let curves = scene.methods.iter().map(|method| MethodCurve {
        name: method.name.clone(),
        origin: if method.shipped { CurveOrigin::Shipped } else { CurveOrigin::Lab },
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
        note: scene.note.to_owned(),
        curves: curves.collect(),
        over_time: over_time(scene),
    }
}

/// At the game's step; `None` for a scene that is not followed.
fn over_time(scene: &LabScene) -> Option<OverTime> {
    let course = |method: &SceneMethod| {
        let origin = if method.shipped { CurveOrigin::Shipped } else { CurveOrigin::Lab };
        Some(MethodCurve { name: method.name.clone(), origin, points: (method.shown.as_ref()?)(FOLLOWED) })
    };
    let courses: Vec<MethodCurve<CoursePoint>> = scene.methods.iter().filter_map(course).collect();
    (!courses.is_empty()).then_some(OverTime { step: FOLLOWED, courses })
}

fn point(scene: &LabScene, method: &SceneMethod, step: f64, quick: bool) -> WorkPoint {
    let started = Clock::now();
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
        let started = Clock::now();
        for _ in 0..repeats {
            black_box((method.run)(black_box(step)));
        }
        times.push(started.elapsed().as_secs_f64() / f64::from(repeats));
    }
    times.sort_by(f64::total_cmp);
    WorkPoint { step, work: times[times.len() / 2] * 1e9 / scene.share, error }
}

/// Without the machine's name.
fn machine() -> String {
    let system = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
    let Ok(text) = files::read_text(Path::new("/proc/cpuinfo"), files::INPUTS) else { return system };
    let model = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    model.map_or(system.clone(), |(_, model)| format!("{}, {system}", model.trim()))
}

/// The commit of the measured code, if git knows one: of the working directory, or else of the project.
fn commit(root: &Path) -> Option<String> {
    [Path::new("."), root].into_iter().find_map(|folder| {
        let ran =
            Command::new("git").arg("-C").arg(folder).args(["describe", "--always", "--dirty", "--exclude=*"]).output().ok()?;
        let text = String::from_utf8(ran.stdout).ok()?;
        (ran.status.success() && !text.trim().is_empty()).then(|| text.trim().to_owned())
    })
}
