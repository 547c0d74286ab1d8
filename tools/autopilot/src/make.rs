//! Making a level's flights: by their plans as they stand, or where those no longer do by a bounded search over their numbers.

use crate::flight::{Aim, CHANGES, Flight, again, bears};
use crate::pilot::Autopilot;
use crate::plan::FlightPlan;
use crate::sight::Sight;
use crate::{plan_file, plan_of, project};
use rand::SeedableRng;
use rand_pcg::Pcg32;
use resultant::game::{Controls, Game, Inputs, Outcome, Recorder, Replay, SHIP};
use resultant::level::Level;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How many variations of a plan are tried where the plan does not do.
const TRIALS: u32 = 3000;
/// By what share of itself each quantity may change without moving a careful flight's end by a tick, and without losing it.
const SAME: f64 = 1e-5;
const LATE: f64 = 1e-3;
/// The plans that the search finds bear errors larger by this factor.
const SPARE: f64 = 3.0;

/// How flights are made.
pub struct Options {
    /// The only flight that is wanted, by its name.
    pub only: Option<String>,
    /// Variations to be tried in any case.
    pub trials: Option<u32>,
    pub seed: u64,
    /// Whether the plan is written, too.
    pub keep: bool,
    pub trace: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { only: None, trials: None, seed: 1, keep: false, trace: false }
    }
}

impl Options {
    fn wants(&self, aim: Aim) -> bool {
        self.only.as_deref().is_none_or(|only| only == aim.name())
    }
}

/// Flies a level for each aim and records the flights; what went wrong with one keeps no other from being made.
pub fn record(level: &Arc<Level>, options: &Options) -> Result<(), String> {
    let made = Aim::ALL
        .into_iter()
        .filter(|aim| options.wants(*aim))
        .map(|aim| make(level, aim, options).map_err(|problem| (aim, problem)));
    let failed: Vec<String> =
        made.filter_map(Result::err).map(|(aim, problem)| format!("{}: not recorded: {problem}", aim.name())).collect();
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n")) }
}

/// The plan for an aim; the careful plan is where the others begin.
fn plan_for(level: &Level, aim: Aim) -> Result<FlightPlan, String> {
    plan_of(&level.name, aim.name()).or_else(|problem| plan_of(&level.name, Aim::Careful.name()).map_err(|_| problem))
}

fn make(level: &Arc<Level>, aim: Aim, options: &Options) -> Result<(), String> {
    let plan = plan_for(level, aim)?;
    if options.trace {
        trace(level, &plan);
    }
    let (mut flight, mut plan) = (Flight::by_plan(level, &plan), plan);
    let lacks = |flight: &Flight, plan: &FlightPlan| lacks(flight, aim, level, plan);
    let trials = options.trials.unwrap_or(if lacks(&flight, &plan).is_none() { 0 } else { TRIALS });
    if trials > 0 {
        report("as planned", aim, level, &flight);
        let enough = |flight: &Flight, plan: &FlightPlan| options.trials.is_none() && lacks(flight, plan).is_none();
        (flight, plan) = Search { level, aim, trials, seed: options.seed }.climb((flight, plan), enough);
    }
    report(&level.name, aim, level, &flight);
    if options.keep {
        write(&plan_file(&level.name, aim.name()), &plan.to_string())?;
    }
    if let Some(problem) = lacks(&flight, &plan) {
        return Err(problem);
    }
    keep(level, aim, &replay(level, &flight.inputs)?)
}

/// What keeps a flight by that plan from being recorded; `None` where nothing does.
fn lacks(flight: &Flight, aim: Aim, level: &Level, plan: &FlightPlan) -> Option<String> {
    let firm = || aim != Aim::Careful || bears(level, &flight.inputs, SAME, LATE);
    flight.lacks(aim, level, plan.settings.par).or_else(|| (!firm()).then(|| "its keys bear no small change".to_owned()))
}

/// Flies the recorded flights of a level again by their keys, and records them as they are flown now; what has changed is said. A flight
/// that no longer does what its name says stays as it was recorded, and is named.
pub fn fly_again(level: &Arc<Level>, options: &Options) -> Result<(), String> {
    let mut failed = Vec::new();
    for aim in Aim::ALL.into_iter().filter(|aim| options.wants(*aim)) {
        let file = record_file(level, aim);
        let text = std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let before = Replay::parse(aim.name(), &text).map_err(|problems| problems.to_string())?;
        let (flight, plan) = (Flight::by_keys(level, &before.inputs), plan_for(level, aim)?);
        let after = replay(level, &flight.inputs)?;
        println!("{} {}: {}", level.name, aim.name(), changes(&before, &after));
        match lacks(&flight, aim, level, &plan) {
            Some(problem) => failed.push(format!("{}: not recorded: {problem}", aim.name())),
            None => keep(level, aim, &after)?,
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n")) }
}

/// What differs between a record and the flight by its keys now, in words.
fn changes(before: &Replay, after: &Replay) -> String {
    let outcome = |replay: &Replay| replay.outcome.name();
    let time = |replay: &Replay| format!("{:.3} s", replay.time);
    let figures = [
        ("outcome", outcome(before).to_owned(), outcome(after).to_owned()),
        ("time", time(before), time(after)),
        ("score", before.score.to_string(), after.score.to_string()),
        ("hash", format!("{:016x}", before.hash), format!("{:016x}", after.hash)),
        (
            "first second that differs",
            "none".to_owned(),
            departs(before, after).map_or_else(|| "none".to_owned(), |at| at.to_string()),
        ),
    ];
    let changed = figures.into_iter().filter(|(_, before, after)| before != after);
    let words: Vec<String> = changed.map(|(what, before, after)| format!("{what} {before} is now {after}")).collect();
    if words.is_empty() { "as recorded".to_owned() } else { words.join(", ") }
}

/// The first second after which the states differ.
fn departs(before: &Replay, after: &Replay) -> Option<usize> {
    before.seconds.iter().zip(&after.seconds).position(|(before, after)| before != after).map(|second| second + 1)
}

fn record_file(level: &Level, aim: Aim) -> PathBuf {
    project().join("levels").join(&level.name).join("flights").join(format!("{}.replay.csv", aim.name()))
}

/// Writes the record of a flight, and of a careful one the inputs that people read.
fn keep(level: &Level, aim: Aim, replay: &Replay) -> Result<(), String> {
    write(&record_file(level, aim), &replay.to_string())?;
    if aim == Aim::Careful {
        write(&project().join("tests/inputs").join(&level.name).with_extension("csv"), &replay.inputs.to_string())?;
    }
    Ok(())
}

/// The record of a flight by those keys.
fn replay(level: &Arc<Level>, keys: &Inputs) -> Result<Replay, String> {
    let mut game = Game::new(Arc::clone(level)).map_err(|error| error.to_string())?;
    let mut recorder = Recorder::default();
    for controls in keys.clone() {
        game.step(controls);
        recorder.note(&game, controls);
    }
    Ok(recorder.finish(&game))
}

pub fn write(path: &Path, text: &str) -> Result<(), String> {
    let folder = path.parent().unwrap_or(path);
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(path, text))
        .map_err(|error| format!("{}: {error}", path.display()))
}

/// A search for a better plan.
struct Search<'a> {
    level: &'a Arc<Level>,
    aim: Aim,
    trials: u32,
    seed: u64,
}

impl Search<'_> {
    /// Climbs from a plan to better ones, until one is good enough. A careful flight that does not bear small changes never replaces one
    /// that does.
    fn climb(&self, begin: (Flight, FlightPlan), enough: impl Fn(&Flight, &FlightPlan) -> bool) -> (Flight, FlightPlan) {
        let mut random = Pcg32::seed_from_u64(self.seed);
        let mut best_rank = self.rank(&begin.0, (false, f64::NEG_INFINITY));
        let mut best = begin;
        for trial in 0..self.trials {
            let plan = best.1.varied(&mut random);
            let flight = Flight::by_plan(self.level, &plan);
            let rank = self.rank(&flight, best_rank);
            if rank > best_rank {
                let result = &flight.result;
                eprintln!(
                    "trial {trial}: worth {:.0}, {:.3} s, fuel {:.3}, {} rows",
                    rank.1, result.time, result.fuel, flight.rows
                );
                (best, best_rank) = ((flight, plan), rank);
                if enough(&best.0, &best.1) {
                    break;
                }
            }
        }
        best
    }

    /// Whether a flight bears small changes, and what it is worth. What is costly to find out is not asked where the flight stays behind the
    /// best one anyhow.
    fn rank(&self, flight: &Flight, best: (bool, f64)) -> (bool, f64) {
        let worth = flight.worth(self.aim, self.level);
        if self.aim != Aim::Careful || worth < -1e5 {
            return (worth >= -1e5, worth);
        }
        if best.0 && worth <= best.1 {
            return (false, worth);
        }
        let firm = [SPARE, 1.0].into_iter().all(|times| bears(self.level, &flight.inputs, times * SAME, times * LATE));
        (firm, worth)
    }
}

fn report(name: &str, aim: Aim, level: &Level, flight: &Flight) {
    let result = &flight.result;
    println!(
        "{name} {}: {} in {:.3} s, score {}, damaging hits {}, pushes {}, burns {}, fuel {:.3}, top speed {:.1} m/s, {} rows, steps {}, {:.2} m to go, worth {:.0}",
        aim.name(),
        result.outcome.name(),
        result.time,
        result.score.total,
        result.collisions,
        result.pushes,
        result.burns,
        result.fuel,
        result.top_speed,
        flight.rows,
        flight.steps,
        flight.distance,
        flight.worth(aim, level),
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
    if aim != Aim::Careful {
        return;
    }
    for by in [1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        let worst = CHANGES.map(|(what, change)| {
            let both = [by, -by].map(|by| again(level, &flight.inputs, change, by));
            format!("{what} {:?}/{:?}", both[0], both[1])
        });
        println!("  changed by {by:e}: {}", worst.join(", "));
    }
}

/// Prints where the ship is, ten times a second.
fn trace(level: &Arc<Level>, plan: &FlightPlan) {
    let Ok(mut game) = Game::new(Arc::clone(level)) else { return };
    let mut pilot = Autopilot::new(plan, &Sight::of(&game));
    while game.outcome() == Outcome::Running && game.elapsed() < 2.0 * plan.settings.par {
        let controls = pilot.keys(&Sight::of(&game));
        let before = *game.world().guards();
        game.step(controls);
        if *game.world().guards() != before {
            eprintln!("{:6.2} s a guard acted", game.elapsed());
        }
        trace_line(&game, pilot.step(), controls);
    }
    for (name, count) in game.world().guards().all().filter(|(_, count)| *count > 0) {
        eprintln!("guard {name}: {count}");
    }
}

/// Prints where everything is, if a tenth of a second is over.
pub fn trace_line(game: &Game, step: usize, keys: Controls) {
    if !game.ticks().is_multiple_of(12) {
        return;
    }
    let (ship, metre) = (game.world().body(SHIP), game.level().metre);
    let (at, v) = (ship.position * metre, ship.velocity);
    let objects: Vec<String> = (game.world().bodies()[1..].iter())
        .map(|body| (body.position * metre, body.velocity))
        .map(|(at, v)| format!("({:.0}, {:.0}; {:.1}, {:.1})", at.x, at.y, v.x, v.y))
        .collect();
    eprintln!(
        "{:6.2} s step {} at ({:.0}, {:.0}) v ({:.1}, {:.1}) angle {} thrust {}{} met {:?} fuel {:.0} objects {}",
        game.elapsed(),
        step + 1,
        at.x,
        at.y,
        v.x,
        v.y,
        game.ship().angle,
        u8::from(keys.thrust),
        if keys.reverse { "-" } else { "" },
        game.met().iter().map(|met| u8::from(*met)).collect::<Vec<_>>(),
        game.fuel(),
        objects.join(" "),
    );
}
