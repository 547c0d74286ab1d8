//! The flights in a level's folder are flown again in the level as it is.

use super::package::{FLIGHT, FLIGHTS, listed};
use crate::files::{self, read_text};
use crate::game::{Game, Goal, Medal, Prize, Replay, RunResult, goals, level_hash};
use crate::level::{Level, Problem};
use std::fmt::Display;
use std::path::Path;
use std::sync::Arc;

/// The most ticks of all flights of a level together: two hours. The rest is not flown.
const MOST_TICKS: u64 = 1_000_000;
/// The files of the flights that prove a level's medals.
const PROVE: [(&str, Prize); 3] =
    [("careful", Prize::Medal(Medal::Bronze)), ("gold", Prize::Medal(Medal::Gold)), ("mark", Prize::Mark)];

/// The flights that end elsewhere than they say, or do not earn the medal of their name; where all hold, the medals that none of them earns.
pub fn stale(folder: &Path, level: &Arc<Level>) -> Vec<Problem> {
    let names = listed(&folder.join(FLIGHTS)).unwrap_or_default();
    let mut left = MOST_TICKS;
    let problem = |name: &str, (found, expected): (String, &str)| Problem {
        file: format!("{FLIGHTS}{name}"),
        line: 0,
        column: String::new(),
        found,
        expected: expected.to_owned(),
    };
    let mut flown = Vec::new();
    let mut problems = Vec::new();
    for name in names.iter().filter(|name| name.ends_with(FLIGHT)) {
        match fly(&folder.join(FLIGHTS), name, level, &mut left) {
            Ok(reached) => flown.push(reached),
            Err(fault) => problems.push(problem(name, fault)),
        }
    }
    if problems.is_empty() { beyond(&flown) } else { problems }
}

/// The medals that no flight earns, of the goals that each flight has reached.
fn beyond(flown: &[Vec<Goal>]) -> Vec<Problem> {
    let Some(first) = flown.first() else { return Vec::new() };
    let missed = first.iter().filter(|goal| {
        let same = flown.iter().flatten().filter(|other| other.prize == goal.prize);
        same.into_iter().all(|other| other.missing.is_some())
    });
    let problem = |goal: &Goal| Problem {
        file: "constants.csv".to_owned(),
        line: 0,
        column: String::new(),
        found: format!("a medal ({}) that no flight in {FLIGHTS} earns", goal.asks),
        expected: "a flight that does, or a goal in reach of them".to_owned(),
    };
    missed.map(problem).collect()
}

fn unreadable(why: &dyn Display) -> String {
    format!("a file that cannot be read ({why})")
}

fn fly(folder: &Path, name: &str, level: &Arc<Level>, left: &mut u64) -> Result<Vec<Goal>, (String, &'static str)> {
    let readable = "a flight that can be read";
    let text = read_text(&folder.join(name), files::INPUTS).map_err(|error| (unreadable(&error), readable))?;
    let replay = Replay::parse(name, &text).map_err(|bad| (unreadable(&bad.0.into_iter().next().unwrap_or_default()), readable))?;
    let ticks = replay.inputs.ticks();
    *left = left.checked_sub(ticks).ok_or_else(|| {
        (format!("{ticks} ticks, too many to be flown here"), "flights of two hours together, or `resultant verify`")
    })?;
    let recorded = replay.level_hash;
    // With the level's own hash any version of the level flies: the first second that departs says more.
    let flown = Replay { level_hash: level_hash(level), ..replay };
    let mut last: Option<RunResult> = None;
    let note = |game: &Game| last = Some(game.result());
    let again = "a flight recorded in the level as it is";
    match flown.verify(level.clone(), note).map_err(|error| (error.to_string(), again))? {
        Err(mismatch) => return Err((format!("a flight that no longer holds: {mismatch}"), again)),
        Ok(()) if recorded != flown.level_hash => {
            return Err(("a flight of another version of the level, though it leads where it did".to_owned(), again));
        }
        Ok(()) => {}
    }
    let stem = name.trim_end_matches(FLIGHT);
    let proves = PROVE.iter().find(|(file, _)| *file == stem).map(|(_, prize)| *prize);
    let goals = last.map(|result| goals(&level.awards, &result)).unwrap_or_default();
    let missed = goals
        .iter()
        .find(|goal| Some(goal.prize) == proves)
        .and_then(|goal| goal.missing.clone().map(|lacks| (goal.asks.clone(), lacks)));
    match missed {
        Some((asks, lacks)) => {
            Err((format!("a flight that does not earn what it is named by ({asks}): {lacks}"), "a flight that does"))
        }
        None => Ok(goals),
    }
}
