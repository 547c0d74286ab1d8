//! Scenes made to be slow: what their ticks take, in time on the processor, of three runs the shortest each.

use crate::slow::{Scene, growing, scenes};
use cpu_time::ThreadTime;
use resultant::physics::{BodyId, World};

const RUNS: usize = 3;
/// s. The bars of scenes of up to this number of bodies; larger ones may take more, as n·log n.
const MEAN: f64 = 50e-6;
const WORST: f64 = 1e-3;
const MANY: f64 = 64.0;

/// Prints what the scenes take whose names hold that part.
pub fn table(part: &str) {
    println!(
        "| scene | bodies | mean µs | worst µs | at tick | most events | ticks cut short | valid |\n|---|---|---|---|---|---|---|---|"
    );
    let mut missed = 0;
    for scene in scenes().into_iter().chain(growing()).filter(|scene| scene.name.contains(part)) {
        let runs: Vec<Run> = (0..RUNS).map(|_| run(&scene)).collect();
        let ticks: Vec<f64> = (0..scene.ticks).map(|t| runs.iter().map(|run| run.times[t]).fold(f64::INFINITY, f64::min)).collect();
        let mean = ticks.iter().sum::<f64>() / ticks.len() as f64;
        let (at, worst) = ticks.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
        let Run { world, events, valid, .. } = &runs[0];
        let bodies = (scene.def.bodies.len() as f64).max(MANY);
        let more = bodies * bodies.ln() / (MANY * MANY.ln());
        let mark = if mean > more * MEAN || worst > more * WORST { " ✗" } else { "" };
        missed += u32::from(!mark.is_empty());
        let (mean, worst, busy) = (mean * 1e6, worst * 1e6, world.guards().budgets_used_up);
        println!(
            "| {}{mark} | {} | {mean:.1} | {worst:.0} | {at} | {events} | {busy} | {valid} |",
            scene.name,
            scene.def.bodies.len()
        );
    }
    let (mean, worst) = (MEAN * 1e6, WORST * 1e6);
    println!(
        "{missed} of the scenes miss a mean of {mean:.0} µs or a worst of {worst:.0} µs, or n·log n times that beyond {MANY} bodies"
    );
}

/// The time of each tick, s, the world at the end, the most events of a tick, and what was first found wrong.
struct Run {
    times: Vec<f64>,
    world: World,
    events: u64,
    valid: String,
}

fn run(scene: &Scene) -> Run {
    let mut world = World::new(scene.def.clone()).unwrap_or_else(|error| panic!("{}: {error}", scene.name));
    let mut valid = String::from("yes");
    let mut events = 0;
    let times = (0..scene.ticks).map(|tick| {
        world.set_drive(BodyId(0), scene.drive);
        let begun = ThreadTime::now();
        world.step(scene.tick);
        let time = begun.elapsed().as_secs_f64();
        events = events.max(world.followed());
        if scene.def.bodies.len() <= 64
            && valid == "yes"
            && let Err(fault) = world.validate()
        {
            valid = format!("tick {tick}: {}", fault.chars().take(120).collect::<String>());
        }
        time
    });
    Run { times: times.collect(), world, events, valid }
}
