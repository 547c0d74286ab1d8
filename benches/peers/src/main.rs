//! The same scenes on Resultant, Rapier (f32 and f64) and Box2D, one thread, rotation off; `README.md` says what each scene is, and with
//! which steps and settings it is run. `resultant chart` runs this program: `peers FILE [--quick] [--resume] [--check] [SCENE…]` puts the
//! rows of the scenes, or of all, into FILE, scene by scene. Sleep is off in all engines but for the scenes that are about it.
//!
//! The engines take turns, so that what slows the machine for a while slows all of them.

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
use resultant::lab::curve::median_and_spread;
use resultant::lab::kept::{PEERS_HEAD, PeerRow, peer_rows};
use scenes::Scene;
use std::fs;
use std::path::{Path, PathBuf};
use watch::{Run, Watched};

/// Rounds in which each engine runs once: the least, the most, and s within which more than the least are made.
const ROUNDS: (f64, f64, f64) = (2.0, 5.0, 4.0);
const QUICK_ROUNDS: (f64, f64, f64) = (1.0, 3.0, 0.2);
/// With --quick larger scenes are left out.
const QUICK_BODIES: usize = 2000;
/// Short scenes are run several times over until they take so long, s: the clock's own time must not count.
const LONG_ENOUGH: f64 = 5e-3;

/// One engine on one scene: what its row begins with, what it ends with, and its time for a number of runs, s.
struct Contender<'a> {
    words: String,
    numbers: [f64; 3],
    time: std::boxed::Box<dyn FnMut(usize) -> f64 + 'a>,
}

#[allow(clippy::disallowed_methods)] // it measures
fn contender<'a, E: Engine + 'a>(scene: &Scene, spec: &'a Spec, step: f64) -> Option<Contender<'a>> {
    let steps = (scene.seconds / step).round() as usize;
    let mut engine = E::new(spec)?;
    let settled = scene.settle > 0.0;
    (0..(scene.settle / step).round() as usize).for_each(|_| engine.step(step));
    let mut watched = Watched::new(&mut engine, spec);
    let error = (scene.error)(&mut watched, spec, steps, step);
    let numbers = [error, watched.overlap(), watched.speed()];
    let time = move |repeats: usize| {
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
    let words = format!("{},{},{},\"{}\"", scene.name, E::NAME, E::version(), E::settings(spec.stiff));
    Some(Contender { words, numbers, time: std::boxed::Box::new(time) })
}

/// All engines on a scene at a step, Resultant first; those that can be made stiff so, too, where that is asked for. The rows of the file.
fn measure(scene: &Scene, step: f64, quick: bool) -> Vec<String> {
    let (spec, stiff) = (&scene.spec, Spec { stiff: true, ..scene.spec.clone() });
    let ours = if scene.pile { contender::<ours::Crowds>(scene, spec, step) } else { contender::<ours::Scenes>(scene, spec, step) };
    let mut all = vec![
        ours,
        contender::<rapier::single::Rapier>(scene, spec, step),
        contender::<rapier::double::Rapier>(scene, spec, step),
        contender::<box2d::Box2d>(scene, spec, step),
    ];
    if scene.stiffly {
        all.push(contender::<rapier::double::Rapier>(scene, &stiff, step));
        all.push(contender::<box2d::Box2d>(scene, &stiff, step));
    }
    let mut all: Vec<Contender<'_>> = all.into_iter().flatten().collect();
    let first: Vec<f64> = all.iter_mut().map(|contender| (contender.time)(1)).collect();
    let (least, most, within) = if quick { QUICK_ROUNDS } else { ROUNDS };
    let mut times = vec![Vec::new(); all.len()];
    for _ in 0..(within / first.iter().sum::<f64>()).clamp(least, most) as usize {
        for ((contender, times), first) in all.iter_mut().zip(&mut times).zip(&first) {
            times.push((contender.time)((LONG_ENOUGH / first).ceil().clamp(1.0, 100.0) as usize));
        }
    }
    let row = |(contender, times): (&Contender<'_>, &mut Vec<f64>)| {
        let (time, spread) = median_and_spread(times);
        let work = time * 1e9 / (scene.seconds * spec.bodies.len() as f64);
        let numbers: Vec<String> =
            [step, work, spread].iter().chain(&contender.numbers).map(|number| format!("{number:e}")).collect();
        format!("{},{}\n", contender.words, numbers.join(","))
    };
    all.iter().zip(&mut times).map(row).collect()
}

/// Whether a row is of what is built in here.
fn is_present(row: &PeerRow) -> bool {
    let engines = [
        (ours::Scenes::NAME, ours::Scenes::version()),
        (rapier::single::Rapier::NAME, rapier::single::Rapier::version()),
        (rapier::double::Rapier::NAME, rapier::double::Rapier::version()),
        (box2d::Box2d::NAME, box2d::Box2d::version()),
    ];
    engines.iter().any(|(name, version)| row.engine == *name && row.version == *version)
}

fn write(file: &Path, rows: &[(&str, Vec<String>)]) -> std::io::Result<()> {
    let text = rows.iter().flat_map(|(_, lines)| lines).fold(PEERS_HEAD.join(",") + "\n", |text, line| text + line);
    let part: PathBuf = file.with_extension("part");
    fs::write(&part, text)?;
    fs::rename(part, file)
}

fn main() -> Result<(), String> {
    let (flags, words): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|word| word.starts_with("--"));
    let flag = |name: &str| flags.iter().any(|flag| flag == name);
    let (quick, resume, check) = (flag("--quick"), flag("--resume"), flag("--check"));
    let (file, chosen) = words.split_first().ok_or("found no file, expected peers FILE [--quick] [--resume] [--check] [SCENE…]")?;
    let text = fs::read_to_string(file).unwrap_or_default();
    let known = peer_rows(file, &text).unwrap_or_default();
    let scenes: Vec<Scene> = exact::scenes().into_iter().chain(crowds::scenes()).collect();
    let of = |name: &str| known.iter().zip(text.lines().skip(1)).filter(|(row, _)| row.scene == name).collect::<Vec<_>>();
    let mut rows: Vec<(&str, Vec<String>)> =
        scenes.iter().map(|scene| (scene.name, of(scene.name).iter().map(|(_, line)| format!("{line}\n")).collect())).collect();
    let stale = |name: &str| of(name).is_empty() || !of(name).iter().all(|(row, _)| is_present(row));
    if check {
        let stale: Vec<&str> = scenes.iter().map(|scene| scene.name).filter(|name| stale(name)).collect();
        return if stale.is_empty() {
            Ok(())
        } else {
            Err(format!("measured with other engines than these: {}", stale.join(", ")))
        };
    }
    let wanted = |scene: &Scene| {
        (chosen.is_empty() || chosen.iter().any(|name| name == scene.name))
            && !(resume && !stale(scene.name))
            && !(quick && scene.spec.bodies.len() > QUICK_BODIES)
    };
    let count = scenes.iter().filter(|scene| wanted(scene)).count();
    for (number, (index, scene)) in scenes.iter().enumerate().filter(|(_, scene)| wanted(scene)).enumerate() {
        eprintln!("engines {}/{count} {}: {}", number + 1, scene.name, scene.what);
        let steps = scene.steps.iter().filter(|step| !quick || **step >= 1.0 / 120.0);
        rows[index].1 = steps.flat_map(|step| measure(scene, *step, quick)).collect();
        write(Path::new(file), &rows).map_err(|error| format!("{file}: {error}"))?;
    }
    Ok(())
}
