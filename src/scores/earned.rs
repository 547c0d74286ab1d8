//! Whether a row of a leaderboard is earned: its flight is flown again in the level as it is, tick by tick, and has to come to the row's
//! score.

use super::{Origin, Row};
use crate::game::{Mismatch, Outcome, PROGRAM, Proof, Replay, TICK_RATE};
use crate::level::Level;
use std::fmt;
use std::sync::Arc;

/// How a row stands.
#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    /// Its flight was flown again and came to its score.
    Proven,
    /// It has no flight: it is from before flights were kept, or was written by hand. Nothing can be said.
    NoFlight,
    /// It does not hold, for this reason.
    Doubtful(Doubt),
}

/// Why a row does not hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Doubt {
    /// Its flight cannot be read.
    Unreadable(String),
    /// The record does not say in which level it was flown.
    NoLevel,
    /// The row names another version of the level than its flight; the row's goes first.
    Version(u64, u64),
    /// The flight is worth another score than the row says; the row's goes first.
    Score(i64, i64),
    /// The flight did not complete the level.
    Unfinished(Outcome),
    /// It was flown at another rate than the game's, ticks a second.
    Rate(f64),
    /// It was flown again and led elsewhere, or the level is another one; with the program that recorded it, where that is not this one.
    Flown(Mismatch, Option<String>),
    /// The level cannot be flown.
    Level(String),
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(problem) => f.write_str(problem),
            Self::NoLevel => write!(f, "its flight does not say in which level it was flown"),
            Self::Version(row, flight) => {
                write!(f, "the row is of version {row:016x} of the level, its flight of version {flight:016x}")
            }
            Self::Score(row, flight) => write!(f, "the row says {row} points, its flight {flight}"),
            Self::Unfinished(outcome) => write!(f, "its flight is {}, not completed", outcome.name()),
            Self::Rate(rate) => write!(f, "it was flown at {rate} ticks a second, expected {TICK_RATE}"),
            Self::Flown(mismatch, program) => {
                let by = program.as_ref().map(|program| format!("; recorded by {program}, this is {PROGRAM}"));
                write!(f, "{mismatch}{}", by.unwrap_or_default())
            }
            Self::Level(problem) => write!(f, "the level cannot be flown: {problem}"),
        }
    }
}

/// A row's flight while it is flown again.
#[derive(Clone, Debug)]
pub struct Claim {
    proof: Proof,
    program: Option<String>,
}

impl Claim {
    /// The flight of a row at its start.
    ///
    /// # Errors
    /// What can be told without flying it.
    pub fn new(row: &Row, origin: &Origin, flight: Replay, level: Arc<Level>) -> Result<Self, Doubt> {
        let flown_in = flight.level_hash.ok_or(Doubt::NoLevel)?;
        if let Some(version) = origin.version.filter(|&version| version != flown_in) {
            return Err(Doubt::Version(version, flown_in));
        }
        if flight.tick_rate != TICK_RATE {
            return Err(Doubt::Rate(flight.tick_rate));
        }
        if flight.score != row.score {
            return Err(Doubt::Score(row.score, flight.score));
        }
        let program = flight.program.clone().filter(|program| program != PROGRAM);
        match Proof::new(Arc::new(flight), level) {
            Ok(Ok(proof)) => Ok(Self { proof, program }),
            Ok(Err(mismatch)) => Err(Doubt::Flown(mismatch, program)),
            Err(error) => Err(Doubt::Level(error.to_string())),
        }
    }

    /// Flies one tick; the answer once it is known.
    pub fn step(&mut self) -> Option<Result<(), Doubt>> {
        let outcome = |claim: &Self| claim.proof.game().outcome();
        match self.proof.step()? {
            Ok(()) if outcome(self) != Outcome::Completed => Some(Err(Doubt::Unfinished(outcome(self)))),
            Ok(()) => Some(Ok(())),
            Err(mismatch) => Some(Err(Doubt::Flown(mismatch, self.program.clone()))),
        }
    }

    /// How many ticks were flown.
    pub fn ticks(&self) -> u64 {
        self.proof.game().ticks()
    }
}
