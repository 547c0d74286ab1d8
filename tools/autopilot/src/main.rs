//! Flies levels by plans of way points, closed loop on the real game, and records what it did; measures how difficult a level is, and
//! looks for what its author did not mean. README.md has the commands and the format of a plan.

mod adversary;
mod difficulty;
mod flight;
mod judgement;
mod make;
mod pilot;
mod plan;
#[path = "../../../tests/support/random.rs"]
#[allow(dead_code)]
mod random;
mod sight;
#[allow(clippy::disallowed_methods)] // it measures
mod speed;

use make::Options;
use plan::FlightPlan;
use resultant::level::{self, Level};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

const USAGE: &str = "\
autopilot all [OPTIONS]                  makes all flights of all levels
autopilot LEVEL… [OPTIONS]               makes those of some levels
    --only careful|gold|mark  --tune TRIALS  --seed N  --keep  --trace
autopilot again [LEVEL…] [--only …]      flies the recorded flights again by their keys and records them as they are flown now
autopilot difficulty [LEVEL…] [--trace --seed N] [--tune TRIALS --seed N --keep]
                                         the share of 50 unsteady flights that succeed
autopilot speed [LEVEL…]                 how long ticks take along the recorded flights, and opening a level
autopilot adversary [LEVEL…] [--minutes M] [--seed N]
                                         looks for traps, ways out and short cuts";

fn main() -> ExitCode {
    match run(std::env::args().skip(1).collect()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(problem) => {
            eprintln!("{problem}\n{USAGE}");
            ExitCode::from(2)
        }
    }
}

/// Does what is asked for; whether all went well.
fn run(arguments: Vec<String>) -> Result<bool, String> {
    let mut arguments = arguments.into_iter().peekable();
    let task = arguments
        .next_if(|word| matches!(word.as_str(), "all" | "again" | "difficulty" | "adversary" | "speed"))
        .unwrap_or_default();
    let (mut options, mut levels, mut minutes) = (Options::default(), Vec::new(), 30.0);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument} wants a value"));
        match argument.as_str() {
            "--only" => options.only = Some(value()?),
            "--tune" => options.trials = Some(number(&value()?)?),
            "--seed" => options.seed = number(&value()?)?,
            "--minutes" => minutes = number(&value()?)?,
            "--keep" => options.keep = true,
            "--trace" => options.trace = true,
            level if !level.starts_with('-') => levels.push(level.to_owned()),
            _ => return Err(format!("{argument} is not known")),
        }
    }
    if levels.is_empty() && !task.is_empty() {
        levels = level::list(&project().join("levels"));
    }
    if levels.is_empty() {
        return Err("which levels?".to_owned());
    }
    if task == "speed" {
        println!("{}", speed::HEAD);
    }
    let mut all_well = true;
    for name in &levels {
        let done = load(name).and_then(|level| match task.as_str() {
            "again" => make::fly_again(&level, &options),
            "difficulty" => difficulty::measure(&level, &options),
            "speed" => speed::measure(&level, &project()),
            "adversary" => hunt(&level, minutes, options.seed),
            _ => make::record(&level, &options),
        });
        if let Err(problem) = done {
            eprintln!("level {name}: {problem}");
            all_well = false;
        }
    }
    Ok(all_well)
}

fn number<T: std::str::FromStr>(text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("found {text:?}, expected a number"))
}

/// Lets the adversary at a level and tells what it found.
fn hunt(level: &Arc<Level>, minutes: f64, seed: u64) -> Result<(), String> {
    let report = adversary::hunt(level, 60.0 * minutes, seed);
    println!("{}: {report}", level.name);
    if report.findings.is_empty() { Ok(()) } else { Err(format!("{} findings", report.findings.len())) }
}

/// The repository.
fn project() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn load(name: &str) -> Result<Arc<Level>, String> {
    let loaded = level::load(&project().join("levels").join(name), &project());
    let lines = |problems: Vec<level::Problem>| problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    loaded.map(|loaded| Arc::new(loaded.level)).map_err(lines)
}

/// Reads one of a level's plans.
fn plan_of(level: &str, flight: &str) -> Result<FlightPlan, String> {
    let file = plan_file(level, flight);
    let text = std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    FlightPlan::parse(&text).map_err(|problem| format!("{}: {problem}", file.display()))
}

fn plan_file(level: &str, flight: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("plans").join(level).join(flight).with_extension("csv")
}
