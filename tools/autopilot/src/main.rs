//! Flies shipped levels by plans of way points, closed loop on the real game, and records the keys that it held:
//! `cargo run --release -- 1 2 3` in this folder reads `plans/N.csv` and writes `tests/inputs/N.csv` of the repository. Where a plan
//! as it stands no longer gives a clean flight, a bounded search over its numbers mends it. README.md has the format and the options.

mod flight;
mod pilot;
mod plan;

use flight::{CHANGES, Flight, again, bears};
use plan::Plan;
use rand::SeedableRng;
use rand_pcg::Pcg32;
use resultant::level::{self, Level};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;

/// How many variations of a plan are tried where the plan does not do.
const TRIALS: u32 = 3000;
/// By what share of itself each quantity may change without moving the end by a tick, and without losing the flight.
const SAME: f64 = 1e-5;
const LATE: f64 = 1e-3;
/// What the search finds bears so many times as much.
const SPARE: f64 = 3.0;

struct Options {
    levels: Vec<String>,
    /// Variations to be tried in any case.
    trials: Option<u32>,
    seed: u64,
    /// Whether the plan is written, too.
    keep: bool,
    trace: bool,
}

fn main() -> ExitCode {
    let options = match options() {
        Ok(options) => options,
        Err(problem) => {
            eprintln!("{problem}\nautopilot LEVEL… [--tune TRIALS] [--seed N] [--keep] [--trace]");
            return ExitCode::from(2);
        }
    };
    let mut code = ExitCode::SUCCESS;
    for name in &options.levels {
        if let Err(problem) = record(name, &options) {
            eprintln!("level {name}: {problem}");
            code = ExitCode::FAILURE;
        }
    }
    code
}

fn options() -> Result<Options, String> {
    let mut options = Options { levels: Vec::new(), trials: None, seed: 1, keep: false, trace: false };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut number = || arguments.next().and_then(|text| text.parse().ok()).ok_or(format!("{argument} wants a number"));
        match argument.as_str() {
            "--tune" => options.trials = Some(number()?),
            "--seed" => options.seed = u64::from(number()?),
            "--keep" => options.keep = true,
            "--trace" => options.trace = true,
            level if !level.starts_with('-') => options.levels.push(level.to_owned()),
            _ => return Err(format!("{argument} is not known")),
        }
    }
    if options.levels.is_empty() { Err("which levels?".to_owned()) } else { Ok(options) }
}

/// Flies a level and records the flight.
fn record(name: &str, options: &Options) -> Result<(), String> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let project = here.join("../..");
    let plan_file = here.join("plans").join(name).with_extension("csv");
    let text = std::fs::read_to_string(&plan_file).map_err(|error| format!("its plan: {error}"))?;
    let plan = Plan::parse(&text).map_err(|problem| format!("its plan: {problem}"))?;
    let loaded = level::load(&project.join("levels").join(name), &project).map_err(|problems| format!("{problems:?}"))?;
    let level = Arc::new(loaded.level);

    if options.trace {
        trace(&level, &plan);
    }
    let (mut flight, mut plan) = (Flight::by_plan(&level, &plan), plan);
    let good = |flight: &Flight, plan: &Plan| flight.is_clean(plan.settings.par) && bears(&level, &flight.inputs, SAME, LATE);
    let trials = options.trials.unwrap_or(if good(&flight, &plan) { 0 } else { TRIALS });
    if trials > 0 {
        report("as planned", &level, &flight);
        (flight, plan) = search(&level, flight, plan, trials, options.seed);
    }
    report(name, &level, &flight);
    if options.keep {
        std::fs::write(&plan_file, plan.to_string()).map_err(|error| format!("its plan: {error}"))?;
    }
    if !good(&flight, &plan) {
        return Err("no clean flight was found; nothing is recorded".to_owned());
    }
    let inputs = project.join("tests/inputs").join(name).with_extension("csv");
    std::fs::write(&inputs, flight.inputs.to_string()).map_err(|error| format!("its inputs: {error}"))
}

/// Climbs from a plan to better ones. A flight that does not bear small changes never replaces one that does.
fn search(level: &Arc<Level>, flight: Flight, plan: Plan, trials: u32, seed: u64) -> (Flight, Plan) {
    let mut random = Pcg32::seed_from_u64(seed);
    let firm = |flight: &Flight| flight.worth() >= 0.0 && bears(level, &flight.inputs, SPARE * SAME, SPARE * LATE);
    let mut best_is_firm = firm(&flight);
    let mut best = (flight, plan);
    for trial in 0..trials {
        let plan = best.1.varied(&mut random);
        let flight = Flight::by_plan(level, &plan);
        if flight.worth() <= best.0.worth() && best_is_firm {
            continue;
        }
        let is_firm = firm(&flight);
        if (is_firm, flight.worth()) > (best_is_firm, best.0.worth()) {
            eprintln!("trial {trial}: worth {:.0}, {} s, {} rows", flight.worth(), flight.result.time, flight.rows);
            (best, best_is_firm) = ((flight, plan), is_firm);
        }
    }
    best
}

fn report(name: &str, level: &Level, flight: &Flight) {
    let result = &flight.result;
    println!(
        "{name}: {} in {:.3} s, score {}, damaging hits {}, fuel {:.3}, {} rows, steps {}, {:.2} m to go, worth {:.0}",
        result.outcome.name(),
        result.time,
        result.score.total,
        result.collisions,
        result.fuel,
        flight.rows,
        flight.steps,
        flight.distance,
        flight.worth(),
    );
    println!(
        "  off red {:.2} m, ticks near walls {}, bumps {}, knocks {}, hardest on objects {:.2}, on the ground {:.2}, at the end {:.2} m/s, {:.2} aside",
        flight.red,
        flight.near_walls,
        flight.bumps,
        flight.knocks,
        flight.hardest_push,
        flight.hardest_landing,
        flight.last_speed,
        flight.aside,
    );
    for by in [1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        let worst = CHANGES.map(|(what, change)| {
            let both = [by, -by].map(|by| again(level, &flight.inputs, change, by));
            format!("{what} {:?}/{:?}", both[0], both[1])
        });
        println!("  changed by {by:e}: {}", worst.join(", "));
    }
}

/// Prints where the ship is, ten times a second.
fn trace(level: &Arc<Level>, plan: &Plan) {
    use resultant::game::{Game, Outcome, SHIP};
    let Ok(mut game) = Game::new(Arc::clone(level)) else { return };
    let mut pilot = pilot::Pilot::new(plan, &game);
    while game.outcome() == Outcome::Running && game.time() < 2.0 * plan.settings.par {
        let controls = pilot.keys(&game);
        game.step(controls);
        if game.ticks() % 12 == 0 {
            let ship = game.world().body(SHIP);
            let (at, v) = (ship.position * level.metre, ship.velocity);
            let objects: Vec<String> = (1..=level.objects.len())
                .map(|index| (game.world().bodies()[index].position * level.metre, game.world().bodies()[index].velocity))
                .map(|(at, v)| format!("({:.0}, {:.0}; {:.1}, {:.1})", at.x, at.y, v.x, v.y))
                .collect();
            eprintln!(
                "{:6.2} s step {} at ({:.0}, {:.0}) v ({:.1}, {:.1}) angle {} thrust {} objects {}",
                game.time(),
                pilot.step(),
                at.x,
                at.y,
                v.x,
                v.y,
                game.ship().angle,
                u8::from(controls.thrust),
                objects.join(" "),
            );
        }
    }
}
