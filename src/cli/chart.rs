//! `resultant chart` measures every method on every scene of the lab, what the plans of levels and scenes save, and, by `benches/peers`,
//! other engines; and writes diagrams, tables, a summary and the figures of the pages. The clock is the thread's CPU time: other work of
//! the machine counts for little. Methods take turns, so that what slows the machine for a while slows all of them.

use super::files::{OutputFile, Staged, read_text};
use super::{CommandError, Status, project::Project};
use crate::files::{self, CHART};
use crate::game::{Controls, Game, Replay};
use crate::lab::charts::{Charts, MeasuredWith, SETTING};
use crate::lab::curve::{CoursePoint, Measured, MethodCurve, OverTime, WorkPoint, median_and_spread};
use crate::lab::kept::{PEERS, PeerRow, add_peers, is_of_peers, peer_rows};
use crate::lab::report::{PAGES, PageFigures, shipped_csv, summary};
use crate::lab::savings::{self, Saving, TimedRun};
use crate::lab::{LabScene, SceneMethod, scenes, stability, stress};
use crate::physics::{Plan, SOURCES};
use crate::{draw::chart::CurveOrigin, lab::drawing::picture, level};
use std::path::{Path, PathBuf};
use std::{hint::black_box, io::Write, process::Command, sync::Arc};

#[cfg(any(unix, windows))]
use cpu_time::ThreadTime as Clock;
#[cfg(not(any(unix, windows)))]
use std::time::Instant as Clock;

#[derive(clap::Args, Debug)]
#[command(after_help = "Writes into DIR, made if need be:\n  \
    summary.md   with what it was measured, tables and all diagrams on one page\n  \
    SCENE.svg    a work–precision diagram a scene\n  \
    SCENE.csv    its points: method,origin,version,step,work,spread,error\n  \
    SCENE-over-time.svg, .csv  error and energy while it runs, of some scenes\n  \
    scenes.csv   the diagrams: titles, axes, tolerances\n  \
    shipped.csv  what the shipped engine costs in each scene, and the cheapest method\n  \
    stress.csv   the largest value that each method survives\n  \
    savings.svg, .csv  the parts of the model that each level, experiment and scene runs, and what the others would cost\n  \
    peers.csv    the same scenes on other engines, by benches/peers of the project, built by cargo\n  \
    stability.svg, .csv, stability-limits.csv  where methods are stable, on the complex plane\n  \
    setting.csv  machine and build\n\n\
    Points are saved scene by scene. Into docs/charts of the project it writes the figures of its pages as well. The game's Lab shows\n\
    what is in charts/ of its data folder.")]
pub struct ChartArgs {
    /// Only these scenes, of the Lab or of benches/peers; “stress”, “savings”. The rest stays as it is in DIR
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "charts")]
    out: PathBuf,
    /// Fewer repetitions: within two minutes, once benches/peers is built
    #[arg(long)]
    quick: bool,
    /// Leave what is in DIR of this build
    #[arg(long)]
    resume: bool,
    /// Leave the other engines' points as they are in DIR
    #[arg(long)]
    no_peers: bool,
    /// Measure nothing: draw and write again what is in DIR
    #[arg(long)]
    draw: bool,
    /// Measure and write nothing: name what in DIR is of another build, and end with 1 then
    #[arg(long)]
    check: bool,
}

impl ChartArgs {
    fn wants(&self, name: &str) -> bool {
        !self.draw && (self.scenes.is_empty() || self.scenes.iter().any(|scene| scene == name))
    }
}

/// s. The usual step of physics engines, at which methods are followed over time.
const FOLLOWED: f64 = 1.0 / 60.0;
/// Rounds in which each method of a point runs once: the least, the most, and s within which more than the least are made.
const ROUNDS: (f64, f64, f64) = (3.0, 9.0, 10.0);
const QUICK_ROUNDS: (f64, f64, f64) = (1.0, 3.0, 0.2);
/// A run repeats until it takes this long, s, so that the clock's own cost, about 1 µs, does not count.
const LONG_ENOUGH: f64 = 3e-4;
/// Ticks of a level or a scene whose plan is measured, at most.
const TICKS: usize = 1200;
const QUICK_TICKS: usize = 240;

/// Errors: a folder that cannot be written or was measured otherwise, or an unknown scene, before any measurement. A later fault of the
/// disk leaves no file half written.
pub fn run(args: &ChartArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let dir = &args.out;
    let refused = |what: String| CommandError::Refused(format!("{}: {what}", dir.display()));
    if dir.exists() && !dir.is_dir() {
        return Err(refused("found a file, expected a folder or the name of a new one".to_owned()));
    }
    let mut charts = Charts { setting: setting(args.quick), ..Charts::default() };
    let goes_on = args.resume || !args.scenes.is_empty();
    if args.check || args.draw || goes_on && dir.join(SETTING).exists() {
        let text = |name: &str| files::read_text(&dir.join(name), CHART).map_err(|error| format!("{name}: {error}"));
        let before = Charts::read(text).map_err(refused)?;
        if before.setting != charts.setting && !args.draw && !args.check {
            return Err(refused(format!("found points of {:?}, expected {:?} as here", before.setting, charts.setting)));
        }
        charts = before;
    }
    if args.check {
        charts.stale().iter().try_for_each(|name| writeln!(out, "{name}: measured with another build than {SOURCES}"))?;
        return Ok(if charts.stale().is_empty() { Status::Done } else { Status::Wrong });
    }
    progress("building scenes and their exact answers");
    let scenes = scenes::all();
    let known =
        |name: &str| ["stress", "savings"].contains(&name) || is_of_peers(name) || scenes.iter().any(|scene| scene.name == name);
    if let Some(name) = args.scenes.iter().find(|name| !known(name)) {
        return Err(CommandError::Refused(format!("{name}: found no such scene, expected one of the Lab or of benches/peers")));
    }
    std::fs::create_dir_all(dir).map_err(|error| refused(error.to_string()))?;
    for scene in &scenes {
        OutputFile::create(&dir.join(format!("{}.csv", scene.name)))?;
        OutputFile::create(&dir.join(format!("{}.svg", scene.name)))?;
    }
    if !args.no_peers && !args.draw && (args.scenes.is_empty() || args.scenes.iter().any(|name| is_of_peers(name))) {
        measure_peers(args, project)?;
    }
    let peers = read_peers(dir)?;

    let mut before = std::mem::take(&mut charts.diagrams);
    for (index, scene) in scenes.iter().enumerate() {
        let kept = before.iter().position(|measured| measured.name == scene.name).map(|at| before.remove(at));
        match kept {
            Some(mut kept) if !args.wants(scene.name) || args.resume && !kept.is_stale() => {
                kept.curves.retain(|curve| curve.origin != CurveOrigin::Peer);
                charts.diagrams.push(kept);
                continue;
            }
            None if !args.wants(scene.name) => continue,
            _ => {}
        }
        progress(&format!("{}/{} {}", index + 1, scenes.len(), scene.title));
        charts.diagrams.push(measure(scene, args.quick));
        // What was there and is not measured yet stays for the next run.
        let mut sofar = charts.clone();
        sofar.diagrams.extend(before.iter().cloned());
        save(dir, &sofar.files())?;
    }
    if args.wants("stress") {
        charts.stress.clear();
        for (index, test) in stress::TESTS.iter().enumerate() {
            let test = test();
            progress(&format!("stress {}/{} {}", index + 1, stress::TESTS.len(), test.name));
            charts.stress.extend(test.rows());
        }
    }
    if args.wants("savings") && !(args.resume && !charts.savings.is_empty() && !charts.stale().contains(&savings::FILE)) {
        let trials = trials(project, scenes, if args.quick { QUICK_TICKS } else { TICKS });
        let count = trials.len();
        let rows = trials.into_iter().enumerate().map(|(index, (of, name, trial))| {
            progress(&format!("savings {}/{count} {of} {name}", index + 1));
            saving(of, name, &trial, args.quick)
        });
        charts.savings = rows.collect();
    }

    add_peers(&peers, &mut charts.diagrams).map_err(CommandError::Refused)?;
    let files = all_files(&charts);
    save(dir, &files)?;
    for (name, _) in &files {
        writeln!(out, "{}", dir.join(name).display())?;
    }
    let own = project.root().join("docs/charts");
    if own.canonicalize().is_ok_and(|own| dir.canonicalize().is_ok_and(|dir| dir == own)) {
        let figures = PageFigures { charts: &charts, peers: &peers };
        for page in PAGES {
            let text = read_text(&project.root().join(page), Path::new(page), CHART)?;
            let filled = figures.fill(&text).map_err(|problem| CommandError::Refused(format!("{page}: {problem}")))?;
            save(project.root(), &[(page.to_owned(), filled)])?;
        }
    }
    out.flush()?;
    Ok(Status::Done)
}

fn all_files(charts: &Charts) -> Vec<(String, String)> {
    let mut files = charts.files();
    for measured in &charts.diagrams {
        files.push((format!("{}.svg", measured.name), picture::measured(measured)));
        files.extend(picture::over_time(measured).map(|drawn| (format!("{}-over-time.svg", measured.name), drawn)));
    }
    let regions = stability::regions();
    files.push((stability::SVG.to_owned(), picture::stability(&regions)));
    files.extend(stability::csv(&regions).map(|(name, text)| (name.to_owned(), text)));
    files.push(("savings.svg".to_owned(), picture::savings(&charts.savings)));
    files.push(("shipped.csv".to_owned(), shipped_csv(&charts.diagrams)));
    files.push(("summary.md".to_owned(), summary(charts, &regions)));
    files
}

fn read_peers(dir: &Path) -> Result<Vec<PeerRow>, CommandError> {
    let path = dir.join(PEERS);
    if !path.exists() {
        return Ok(Vec::new());
    }
    peer_rows(&path.display().to_string(), &read_text(&path, &path, CHART)?).map_err(CommandError::Refused)
}

/// Runs the workspace's program, which saves scene by scene.
fn measure_peers(args: &ChartArgs, project: &Project) -> Result<(), CommandError> {
    if !project.root().join("benches/peers").is_dir() {
        progress("no benches/peers here: other engines are not measured");
        return Ok(());
    }
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut peers = Command::new(cargo);
    peers.args(["run", "--release", "--package", "peers", "--"]).arg(std::path::absolute(&args.out)?.join(PEERS));
    peers.args([(args.quick, "--quick"), (args.resume, "--resume")].into_iter().filter(|(given, _)| *given).map(|(_, flag)| flag));
    peers.args(args.scenes.iter().filter(|name| is_of_peers(name))).current_dir(project.root());
    match peers.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(CommandError::Refused(format!("benches/peers: ended with {status}"))),
        Err(error) => Err(CommandError::Refused(format!("cargo, to build benches/peers: {error}; --no-peers goes without"))),
    }
}

/// Writes all files that change before any takes its place.
fn save(folder: &Path, files: &[(String, String)]) -> Result<(), CommandError> {
    let changed = files.iter().filter(|(name, text)| std::fs::read(folder.join(name)).ok().as_deref() != Some(text.as_bytes()));
    let stage = |(name, text): &(String, String)| {
        let mut file = OutputFile::create(&folder.join(name))?;
        file.write_all(text.as_bytes())?;
        file.stage()
    };
    Staged::place_all(changed.map(stage).collect::<Result<Vec<_>, _>>()?)
}

fn progress(what: &str) {
    // A closed standard error does not stop the measurement.
    let _ = writeln!(std::io::stderr(), "{what}");
}

fn measure(scene: &LabScene, quick: bool) -> Measured {
    let curve = |method: &SceneMethod| MethodCurve {
        name: method.name.clone(),
        origin: if method.shipped { CurveOrigin::Shipped } else { CurveOrigin::Lab },
        version: SOURCES.to_owned(),
        points: Vec::new(),
    };
    let mut curves: Vec<MethodCurve> = scene.methods.iter().map(curve).collect();
    for &step in &scene.steps {
        let mut errors = vec![f64::NAN; curves.len()];
        let runs = scene
            .methods
            .iter()
            .zip(&mut errors)
            .map(|(method, error)| move |repeats| timed(repeats, || *error = (method.run)(black_box(step))));
        let times = in_turns(&mut runs.collect::<Vec<_>>(), quick);
        for ((curve, (work, spread)), error) in curves.iter_mut().zip(times).zip(errors) {
            curve.points.push(WorkPoint { step, work: work / scene.share, spread, error });
        }
    }
    Measured {
        name: scene.name.to_owned(),
        title: scene.title.clone(),
        error: scene.error.to_owned(),
        work: scene.work.to_owned(),
        tolerance: scene.tolerance,
        shipped_step: scene.shipped_step,
        alike: scene.alike,
        note: scene.note.to_owned(),
        curves,
        over_time: over_time(scene),
    }
}

fn timed(repeats: usize, mut run: impl FnMut()) -> f64 {
    let started = Clock::now();
    (0..repeats).for_each(|_| run());
    started.elapsed().as_secs_f64()
}

/// The median time of each run, ns, and its spread. A run takes a number of repeats and gives their time, s. One run of each follows on
/// one of every other.
fn in_turns(runs: &mut [impl FnMut(usize) -> f64], quick: bool) -> Vec<(f64, f64)> {
    let first: Vec<f64> = runs.iter_mut().map(|run| run(1).max(1e-9)).collect();
    let (least, most, within) = if quick { QUICK_ROUNDS } else { ROUNDS };
    let mut times = vec![Vec::new(); runs.len()];
    for _ in 0..(within / first.iter().sum::<f64>()).clamp(least, most) as usize {
        for ((run, times), first) in runs.iter_mut().zip(&mut times).zip(&first) {
            let repeats = (LONG_ENOUGH / first).ceil().clamp(1.0, 1e5);
            times.push(run(repeats as usize) / repeats * 1e9);
        }
    }
    times.iter_mut().map(|times| median_and_spread(times)).collect()
}

/// At the game's step; `None` for a scene that is not followed.
fn over_time(scene: &LabScene) -> Option<OverTime> {
    let course = |method: &SceneMethod| {
        let origin = if method.shipped { CurveOrigin::Shipped } else { CurveOrigin::Lab };
        Some(MethodCurve { name: method.name.clone(), origin, version: String::new(), points: (method.shown.as_ref()?)(FOLLOWED) })
    };
    let courses: Vec<MethodCurve<CoursePoint>> = scene.methods.iter().filter_map(course).collect();
    (!courses.is_empty()).then_some(OverTime { step: FOLLOWED, courses })
}

/// Levels and experiments under the keys of their first flight, or none, and the scenes of the Lab.
fn trials(project: &Project, scenes: Vec<LabScene>, ticks: usize) -> Vec<(&'static str, String, TimedRun)> {
    let mut trials = Vec::new();
    for (of, folder) in [(savings::LEVEL, project.levels()), ("experiment", project.root().join(files::EXPERIMENTS))] {
        for name in level::list(&folder) {
            let Ok(loaded) = level::load(&folder.join(&name), project.root()) else { continue };
            let Ok(game) = Game::new(Arc::new(loaded.level)) else { continue };
            let keys = first_flight(&folder.join(&name).join("flights"));
            let keys = keys.map_or_else(|| vec![Controls::default(); ticks], |flight| flight.inputs.after(0).take(ticks).collect());
            trials.push((of, name, TimedRun::Game(Box::new(game), keys)));
        }
    }
    let worlds = scenes.into_iter().filter_map(|scene| Some((scene.name, scene.world?)));
    trials.extend(worlds.map(|(name, world)| ("scene", name.to_owned(), TimedRun::World(Box::new(world), ticks))));
    trials
}

fn first_flight(folder: &Path) -> Option<Replay> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder).ok()?.filter_map(|entry| Some(entry.ok()?.path())).collect();
    files.sort();
    files.iter().find_map(|file| Replay::parse("", &files::read_text(file, files::INPUTS).ok()?).ok())
}

fn saving(of: &str, scene: String, trial: &TimedRun, quick: bool) -> Saving {
    let (plan, plans) = (trial.world().plan(), trial.plans());
    let runs = plans.iter().flatten().map(|plan| {
        move |repeats: usize| {
            let mut fresh: Vec<TimedRun> = (0..repeats).map(|_| trial.under(plan)).collect();
            let run = |trial: &mut TimedRun| (0..trial.ticks()).for_each(|tick| trial.tick(tick));
            let mut next = fresh.iter_mut();
            timed(repeats, || next.next().into_iter().for_each(run))
        }
    });
    let ticks = trial.ticks() as f64;
    let mut times = in_turns(&mut runs.collect::<Vec<_>>(), quick).into_iter().map(|(time, spread)| (time / ticks, spread));
    let mut times = plans.iter().map(|plan| plan.as_ref().and_then(|_| times.next()));
    let mut next = || times.next().flatten();
    let (planned, everything) = (next().unwrap_or_default(), next().unwrap_or_default());
    Saving {
        of: of.to_owned(),
        scene,
        version: SOURCES.to_owned(),
        parts: plan.parts().join("; "),
        left_out: plan.left_out().join("; "),
        same_bits: trial.is_alike(&Plan::EVERYTHING),
        planned,
        everything,
        costs: std::array::from_fn(|_| next().map(|(time, _)| time - planned.0)),
    }
}

fn setting(quick: bool) -> MeasuredWith {
    let profile = if cfg!(debug_assertions) { "debug" } else { "release" }.to_owned();
    MeasuredWith { machine: machine(), profile, quick }
}

/// Without the machine's name.
fn machine() -> String {
    let system = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
    let Ok(text) = files::read_text(Path::new("/proc/cpuinfo"), files::INPUTS) else { return system };
    let model = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    model.map_or(system.clone(), |(_, model)| format!("{}, {system}", model.trim()))
}
