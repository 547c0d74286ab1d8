//! Whether the rows of a leaderboard are earned: each flight is flown again and has to come to the row's score. Checks without a flight come first.

use super::board::{Board, BoardRow};
use super::{folder::Scores, name::Name};
use crate::game::{Inputs, MOST_SECONDS, Mismatch, Outcome, PROGRAM, Replay, ScoreParts, TICK_RATE, level_hash};
use crate::level::Level;
use std::{collections::HashMap, fmt, sync::Arc};

/// Ticks: an hour, in which a record has a hash for each second.
const LONGEST: u64 = MOST_SECONDS as u64 * TICK_RATE as u64;

#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    Proven,
    /// Without a flight: written by hand.
    Unproven,
    /// The flight holds, and its keys are those of these rows' flights: nothing tells who flew it.
    Copies(Vec<Name>),
    Doubtful(Doubt),
}

#[derive(Clone, Debug, PartialEq)]
pub enum Doubt {
    /// Score, most by the rules, and the record's time (s) where it has been read.
    TooMuch(i64, i64, Option<f64>),
    /// The record has another player's name, or none.
    Player(Option<String>),
    /// The flight's file has this fault.
    Unreadable(String),
    /// The row's score, then the flight's.
    Score(i64, i64),
    /// The flight ends so.
    Unfinished(Outcome),
    /// Not the game's tick rate, Hz.
    Rate(f64),
    /// Ticks.
    TooLong(u64),
    /// Hashes in the record, one a whole second, and the expected number.
    Seconds(usize, usize),
    /// With the record's program, if it is another one.
    Flown(Mismatch, Option<String>),
    /// The level does not load, for this reason.
    Level(String),
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooMuch(score, most, None) => write!(f, "{score} points are more than the {most} that the rules allow"),
            Self::TooMuch(score, most, Some(time)) => {
                write!(f, "{score} points are more than the {most} that the rules allow in {time} s")
            }
            Self::Player(Some(player)) => write!(f, "its flight was saved by {player}"),
            Self::Player(None) => f.write_str("its flight names no player"),
            Self::Unreadable(problem) => f.write_str(problem),
            Self::Score(row, flight) => write!(f, "the row says {row} points, its flight {flight}"),
            Self::Unfinished(outcome) => write!(f, "its flight is {}, not completed", outcome.name()),
            Self::Rate(rate) => write!(f, "it was flown at {rate} ticks a second, expected {TICK_RATE}"),
            Self::TooLong(ticks) => write!(f, "its flight has {ticks} ticks, expected at most {LONGEST}, which is an hour"),
            Self::Seconds(found, expected) => write!(f, "its flight has the hashes of {found} seconds, expected {expected}"),
            Self::Flown(mismatch, program) => {
                write!(f, "{mismatch}")?;
                program.as_ref().map_or(Ok(()), |program| write!(f, "; recorded by {program}, this is {PROGRAM}"))
            }
            Self::Level(problem) => write!(f, "the level cannot be flown: {problem}"),
        }
    }
}

/// How each row of a level's board stands; the error says why the level does not load. `watch` is called after each tick, with the row's index.
pub fn judge(
    scores: &Scores,
    name: &str,
    level: Result<Arc<Level>, String>,
    board: &Board,
    mut watch: impl FnMut(usize),
) -> Vec<Standing> {
    let mut flights: HashMap<String, Vec<usize>> = HashMap::new();
    let mut standings = Vec::new();
    for (index, row) in board.rows().iter().enumerate() {
        let proven = board.flight(index).map(|file| {
            let level = level.clone().map_err(Doubt::Level)?;
            let flight = scores.flight(name, file).map_err(Doubt::Unreadable)?;
            prove(row, &flight, level, || watch(index))?;
            Ok(flight.inputs)
        });
        standings.push(match proven {
            None => too_much(row, &level).map_or(Standing::Unproven, Standing::Doubtful),
            Some(Err(doubt)) => Standing::Doubtful(doubt),
            Some(Ok(inputs)) => {
                flights.entry(from_first_key(&inputs)).or_default().push(index);
                Standing::Proven
            }
        });
    }
    for rows in flights.into_values().filter(|rows| rows.len() > 1) {
        for &row in &rows {
            let others = rows.iter().filter(|other| **other != row).map(|other| board.rows()[*other].name.clone());
            standings[row] = Standing::Copies(others.collect());
        }
    }
    standings
}

/// The keys of a flight as text, however its rows are parted and however long it waited for the first one.
fn from_first_key(inputs: &Inputs) -> String {
    let mut keys = Inputs::default();
    inputs.after(inputs.idle().unwrap_or(0)).for_each(|controls| keys.record(controls));
    keys.to_string()
}

fn too_much(row: &BoardRow, level: &Result<Arc<Level>, String>) -> Option<Doubt> {
    let most = ScoreParts::most(0.0, level.as_ref().ok()?.optimal_time);
    (row.score > most).then_some(Doubt::TooMuch(row.score, most, None))
}

/// A forged flight costs no more ticks than its honest part: the first second that departs ends the judgement.
fn prove(row: &BoardRow, flight: &Replay, level: Arc<Level>, mut watch: impl FnMut()) -> Result<(), Doubt> {
    let program = || Some(flight.program.clone()).filter(|program| program != PROGRAM);
    let (flown_in, here) = (flight.level_hash, level_hash(&level));
    if flown_in != here {
        return Err(Doubt::Flown(Mismatch::Level(flown_in, here), program()));
    }
    if flight.tick_rate != TICK_RATE {
        return Err(Doubt::Rate(flight.tick_rate));
    }
    if flight.player.as_deref() != Some(row.name.as_str()) {
        return Err(Doubt::Player(flight.player.clone()));
    }
    if flight.score != row.score {
        return Err(Doubt::Score(row.score, flight.score));
    }
    if flight.outcome != Outcome::Completed {
        return Err(Doubt::Unfinished(flight.outcome));
    }
    let most = ScoreParts::most(flight.time, level.optimal_time);
    if row.score > most {
        return Err(Doubt::TooMuch(row.score, most, Some(flight.time)));
    }
    if let Some(mismatch) = flight.runs_on() {
        return Err(Doubt::Flown(mismatch, program()));
    }
    let ticks = flight.inputs.ticks();
    if ticks > LONGEST {
        return Err(Doubt::TooLong(ticks));
    }
    let seconds = (ticks as f64 / TICK_RATE) as usize;
    if flight.seconds.len() != seconds {
        return Err(Doubt::Seconds(flight.seconds.len(), seconds));
    }
    let flown = flight.verify(level, |_| watch()).map_err(|error| Doubt::Level(error.to_string()))?;
    flown.map_err(|mismatch| Doubt::Flown(mismatch, program()))
}
