//! The origin of a leaderboard's row: flight, version of the level, program.

use crate::game::{LevelHash, Replay};
use crate::words::tr;

/// Columns, in the order in which a save adds them.
const FLIGHT: &str = "flight";
const VERSION: &str = "version";
const PROGRAM: &str = "program";
pub(super) const ENDING: &str = ".replay.csv";

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RowOrigin {
    /// A file in the level's folder of flights.
    pub flight: Option<String>,
    pub version: Option<LevelHash>,
    pub program: Option<String>,
}

impl RowOrigin {
    pub(super) fn of_flight(user: &str, replay: &Replay) -> Self {
        let file = format!("{user}-{}-{:016x}{ENDING}", replay.score, replay.hash);
        Self { flight: Some(file), version: Some(replay.level_hash), program: Some(replay.program.clone()) }
    }

    /// A cell that cannot be read counts as empty.
    pub(super) fn of<'a>(cell: impl Fn(&str) -> Option<&'a str>) -> Self {
        Self {
            flight: cell(FLIGHT).map(str::to_owned),
            version: cell(VERSION).and_then(|text| text.parse().ok()),
            program: cell(PROGRAM).map(str::to_owned),
        }
    }

    pub(super) fn cells(&self) -> [(&'static str, String); 3] {
        let version = self.version.map(|version| version.to_string()).unwrap_or_default();
        [(FLIGHT, self.flight.clone().unwrap_or_default()), (VERSION, version), (PROGRAM, self.program.clone().unwrap_or_default())]
    }

    /// Only a plain name: the cell cannot lead into another folder.
    pub(super) fn file(&self) -> Option<Result<&str, String>> {
        let name = self.flight.as_deref()?;
        let plain = name.ends_with(ENDING)
            && !name.starts_with('.')
            && name.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.'));
        let example = format!("ann-17342-0123456789abcdef{ENDING}");
        let refused =
            || tr!("found the flight {name}, expected a file's name such as {example}", name = format_args!("{name:?}"), example);
        Some(if plain { Ok(name) } else { Err(refused()) })
    }
}
