//! Whether a row of a leaderboard is earned: its flight is flown again in the level as it is, tick by tick, and has to come to the row's
//! score. Checks that need no flight come first.

use super::board::BoardRow;
use super::name::Name;
use super::origin::RowOrigin;
use crate::game::{Fingerprint, LevelHash, MOST_SECONDS, Medals, Mismatch, Outcome, PROGRAM, Proof, Replay, ScoreParts, TICK_RATE};
use crate::level::Level;
use std::fmt;
use std::sync::Arc;

/// The longest flight that is judged, ticks: the hour of which a record has a hash for each second.
const LONGEST: u64 = MOST_SECONDS as u64 * TICK_RATE as u64;

/// How a row stands.
#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    /// Its flight was flown again and came to its score.
    Proven,
    /// It has no flight: it is from before flights were kept, or was written by hand.
    Unproven,
    /// It does not hold, for this reason.
    Doubtful(Doubt),
}

/// Why a row does not hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Doubt {
    /// The row says how it was flown, but names no flight.
    Emptied,
    /// The score is above the most that the rules allow, in the record's time (s) where there is one: score, most, time.
    TooMuch(i64, i64, Option<f64>),
    /// The flight stands under this name, too.
    Twice(Name),
    /// The record carries the name of another player.
    Player(String),
    /// Its flight cannot be read.
    Unreadable(String),
    /// The record does not say in which level it was flown.
    NoLevel,
    /// The row names another version of the level than its flight; the row's goes first.
    Version(LevelHash, LevelHash),
    /// The flight is worth another score than the row says; the row's goes first.
    Score(i64, i64),
    /// The flight did not complete the level.
    Unfinished(Outcome),
    /// It was flown at another rate than the game's, ticks a second.
    Rate(f64),
    /// The flight is longer than any that is judged, ticks.
    TooLong(u64),
    /// The number of hashes in the record, one a whole second, and the number expected.
    Seconds(usize, usize),
    /// It was flown again and led elsewhere, or the level is another one; with the program that recorded it, where that is not this one.
    Flown(Mismatch, Option<String>),
    /// The level cannot be flown.
    Level(String),
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Emptied => f.write_str("the row says how it was flown, but its cell for the flight is empty"),
            Self::TooMuch(score, most, time) => {
                let within = time.map(|time| format!(" in {time} s")).unwrap_or_default();
                write!(f, "{score} points are more than the {most} that the rules allow{within}")
            }
            Self::Twice(name) => write!(f, "its flight stands under the name {name}, too"),
            Self::Player(player) => write!(f, "its flight was saved by {player}"),
            Self::Unreadable(problem) => f.write_str(problem),
            Self::NoLevel => write!(f, "its flight does not say in which level it was flown"),
            Self::Version(row, flight) => {
                let (row, flight) = (row.short(), flight.short());
                write!(f, "the row is of version {row}… of the level, its flight of version {flight}…")
            }
            Self::Score(row, flight) => write!(f, "the row says {row} points, its flight {flight}"),
            Self::Unfinished(outcome) => write!(f, "its flight is {}, not completed", outcome.name()),
            Self::Rate(rate) => write!(f, "it was flown at {rate} ticks a second, expected {TICK_RATE}"),
            Self::TooLong(ticks) => write!(f, "its flight has {ticks} ticks, expected at most {LONGEST}, which is an hour"),
            Self::Seconds(found, expected) => write!(f, "its flight has the hashes of {found} seconds, expected {expected}"),
            Self::Flown(mismatch, program) => {
                let by = program.as_ref().map(|program| format!("; recorded by {program}, this is {PROGRAM}"));
                write!(f, "{mismatch}{}", by.unwrap_or_default())
            }
            Self::Level(problem) => write!(f, "the level cannot be flown: {problem}"),
        }
    }
}

/// How a row stands without a look at its flight; `None` where the flight decides.
pub(super) fn at_sight(row: &BoardRow, origin: &RowOrigin, level: &Level) -> Option<Standing> {
    let most = ScoreParts::most(0.0, level.optimal_time);
    match &origin.flight {
        _ if row.score > most => Some(Standing::Doubtful(Doubt::TooMuch(row.score, most, None))),
        Some(_) => None,
        None if origin.version.is_some() || origin.program.is_some() => Some(Standing::Doubtful(Doubt::Emptied)),
        None => Some(Standing::Unproven),
    }
}

/// A row's flight while it is flown again.
#[derive(Clone, Debug)]
pub(super) struct Claim {
    proof: Proof,
    program: Option<String>,
}

impl Claim {
    /// The flight of a row at its start.
    ///
    /// # Errors
    /// A doubt that needs no flight.
    pub fn new(row: &BoardRow, origin: &RowOrigin, flight: Replay, level: Arc<Level>) -> Result<Self, Doubt> {
        let flown_in = flight.level_hash.ok_or(Doubt::NoLevel)?;
        let here = Fingerprint::of(&level);
        if let Some(version) = origin.version.filter(|&version| version != flown_in && !(here.is(version) && here.is(flown_in))) {
            return Err(Doubt::Version(version, flown_in));
        }
        let program = flight.program.clone().filter(|program| program != PROGRAM);
        if !here.is(flown_in) {
            return Err(Doubt::Flown(Mismatch::Level(flown_in, here.beside(flown_in)), program));
        }
        if flight.tick_rate != TICK_RATE {
            return Err(Doubt::Rate(flight.tick_rate));
        }
        if let Some(player) = flight.player.as_ref().filter(|player| *player != row.name.as_str()) {
            return Err(Doubt::Player(player.clone()));
        }
        if flight.score != row.score {
            return Err(Doubt::Score(row.score, flight.score));
        }
        if let Some(time) = flight.time {
            let most = ScoreParts::most(time, level.optimal_time);
            if row.score > most {
                return Err(Doubt::TooMuch(row.score, most, Some(time)));
            }
        }
        if let Some(mismatch) = flight.runs_on() {
            return Err(Doubt::Flown(mismatch, program));
        }
        let ticks = flight.inputs.ticks();
        if ticks > LONGEST {
            return Err(Doubt::TooLong(ticks));
        }
        // Each second that departs ends the judgement: a forged flight costs no more than the honest part of it.
        let seconds = (ticks as f64 / TICK_RATE) as usize;
        if flight.seconds.len() != seconds {
            return Err(Doubt::Seconds(flight.seconds.len(), seconds));
        }
        match Proof::new(Arc::new(flight), level) {
            Ok(Ok(proof)) => Ok(Self { proof, program }),
            Ok(Err(mismatch)) => Err(Doubt::Flown(mismatch, program)),
            Err(error) => Err(Doubt::Level(error.to_string())),
        }
    }

    /// Flies one tick; the answer once it is known: the medals that the flight earns.
    pub fn step(&mut self) -> Option<Result<Medals, Doubt>> {
        match self.proof.step()? {
            Ok(()) => {
                let result = self.proof.game().result();
                Some(match result.outcome {
                    Outcome::Completed => Ok(Medals::of(&self.proof.game().level().awards, &result)),
                    other => Err(Doubt::Unfinished(other)),
                })
            }
            Err(mismatch) => Some(Err(Doubt::Flown(mismatch, self.program.clone()))),
        }
    }
}
