//! Whether a row of a leaderboard is earned: its flight is flown again in the level as it is and has to come to the row's score.
//! Checks without a flight come first.

use super::board::BoardRow;
use super::name::Name;
use super::origin::RowOrigin;
use crate::game::{LevelHash, MOST_SECONDS, Medals, Mismatch, Outcome, PROGRAM, Proof, Replay, ScoreParts, TICK_RATE, level_hash};
use crate::level::Level;
use crate::words::tr;
use std::fmt;
use std::sync::Arc;

/// Ticks: an hour, in which a record has a hash for each second.
const LONGEST: u64 = MOST_SECONDS as u64 * TICK_RATE as u64;

#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    Proven,
    /// Without a flight: written by hand.
    Unproven,
    Doubtful(Doubt),
}

#[derive(Clone, Debug, PartialEq)]
pub enum Doubt {
    Emptied,
    /// Score, most by the rules, and the record's time (s) where it has been read.
    TooMuch(i64, i64, Option<f64>),
    /// The same flight stands under this name, too.
    Twice(Name),
    /// The record has another player's name.
    Player(String),
    /// The flight's file has this fault.
    Unreadable(String),
    /// The row's version of the level, then the flight's.
    Version(LevelHash, LevelHash),
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
        f.write_str(&match self {
            Self::Emptied => tr("the row says how it was flown, but its cell for the flight is empty").to_owned(),
            Self::TooMuch(score, most, time) => {
                let within = time.map(|time| tr!(" in {time} s", time)).unwrap_or_default();
                tr!("{score} points are more than the {most} that the rules allow{within}", score, most, within)
            }
            Self::Twice(name) => tr!("its flight stands under the name {name}, too", name),
            Self::Player(player) => tr!("its flight was saved by {player}", player),
            Self::Unreadable(problem) => problem.clone(),
            Self::Version(row, flight) => {
                let (row, flight) = (row.short(), flight.short());
                tr!("the row is of version {row}… of the level, its flight of version {flight}…", row, flight)
            }
            Self::Score(row, flight) => tr!("the row says {row} points, its flight {flight}", row, flight),
            Self::Unfinished(outcome) => tr!("its flight is {outcome}, not completed", outcome = outcome.shown()),
            Self::Rate(rate) => tr!("it was flown at {rate} ticks a second, expected {usual}", rate, usual = TICK_RATE),
            Self::TooLong(ticks) => {
                tr!("its flight has {ticks} ticks, expected at most {most}, which is an hour", ticks, most = LONGEST)
            }
            Self::Seconds(found, expected) => {
                tr!("its flight has the hashes of {found} seconds, expected {expected}", found, expected)
            }
            Self::Flown(mismatch, program) => {
                let by = |program| tr!("; recorded by {program}, this is {here}", program, here = PROGRAM);
                mismatch.to_string() + &program.as_ref().map(by).unwrap_or_default()
            }
            Self::Level(problem) => tr!("the level cannot be flown: {problem}", problem),
        })
    }
}

/// `None` where the flight decides.
pub(super) fn at_sight(row: &BoardRow, origin: &RowOrigin, level: &Level) -> Option<Standing> {
    let most = ScoreParts::most(0.0, level.optimal_time);
    match &origin.flight {
        _ if row.score > most => Some(Standing::Doubtful(Doubt::TooMuch(row.score, most, None))),
        Some(_) => None,
        None if origin.version.is_some() || origin.program.is_some() => Some(Standing::Doubtful(Doubt::Emptied)),
        None => Some(Standing::Unproven),
    }
}

#[derive(Clone, Debug)]
pub(super) struct Claim {
    proof: Proof,
    program: Option<String>,
}

impl Claim {
    /// The flight at its start, or a doubt that needs no flight.
    pub fn new(row: &BoardRow, origin: &RowOrigin, flight: Replay, level: Arc<Level>) -> Result<Self, Doubt> {
        let (flown_in, here) = (flight.level_hash, level_hash(&level));
        if let Some(version) = origin.version.filter(|&version| version != flown_in) {
            return Err(Doubt::Version(version, flown_in));
        }
        let program = Some(flight.program.clone()).filter(|program| program != PROGRAM);
        if here != flown_in {
            return Err(Doubt::Flown(Mismatch::Level(flown_in, here), program));
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
        let most = ScoreParts::most(flight.time, level.optimal_time);
        if row.score > most {
            return Err(Doubt::TooMuch(row.score, most, Some(flight.time)));
        }
        if let Some(mismatch) = flight.runs_on() {
            return Err(Doubt::Flown(mismatch, program));
        }
        let ticks = flight.inputs.ticks();
        if ticks > LONGEST {
            return Err(Doubt::TooLong(ticks));
        }
        // A forged flight costs no more than its honest part: the first second that departs ends the judgement.
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

    /// Flies one tick. `Some` once the answer is known: the medals of the flight.
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
