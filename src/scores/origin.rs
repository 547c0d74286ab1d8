//! Where a row of a leaderboard comes from: which flight, in which version of the level, with which program. Rows from before there was
//! any of that do not say, and are rows all the same.

use crate::game::{LevelHash, Replay};

/// The columns, in the order in which they are added.
const FLIGHT: &str = "flight";
const VERSION: &str = "version";
const PROGRAM: &str = "program";
/// How the file of a flight ends.
pub(super) const ENDING: &str = ".replay.csv";

/// Where a row comes from, as far as that is known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RowOrigin {
    /// The file of its flight, in the level's folder of flights.
    pub flight: Option<String>,
    /// The version of the level: its hash.
    pub version: Option<LevelHash>,
    /// The program that it was flown with.
    pub program: Option<String>,
}

impl RowOrigin {
    /// The origin of a score that was flown so, and its flight's file.
    pub(super) fn of_flight(user: &str, replay: &Replay) -> Self {
        let file = format!("{user}-{}-{:016x}{ENDING}", replay.score, replay.hash);
        Self { flight: Some(file), version: replay.level_hash, program: replay.program.clone() }
    }

    /// The origin from the cells of those columns; a cell that cannot be read counts as empty.
    pub(super) fn of<'a>(cell: impl Fn(&str) -> Option<&'a str>) -> Self {
        Self {
            flight: cell(FLIGHT).map(str::to_owned),
            version: cell(VERSION).and_then(|text| text.parse().ok()),
            program: cell(PROGRAM).map(str::to_owned),
        }
    }

    /// The columns and their cells.
    pub(super) fn cells(&self) -> [(&'static str, String); 3] {
        let version = self.version.map(|version| version.to_string()).unwrap_or_default();
        [(FLIGHT, self.flight.clone().unwrap_or_default()), (VERSION, version), (PROGRAM, self.program.clone().unwrap_or_default())]
    }

    /// The file of its flight, if that is a plain name: whatever else stands in the cell, no other folder is looked into.
    pub(super) fn file(&self) -> Option<Result<&str, String>> {
        let name = self.flight.as_deref()?;
        let plain = name.ends_with(ENDING)
            && !name.starts_with('.')
            && name.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.'));
        Some(if plain {
            Ok(name)
        } else {
            Err(format!("found the flight {name:?}, expected a file's name such as ann-17342-0123456789abcdef{ENDING}"))
        })
    }
}
