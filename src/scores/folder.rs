//! The folder that holds the scores files: a leaderboard a level, what the players have done, and a line an attempt.

use std::path::PathBuf;
use std::time::Duration;

use super::attempts::{self, AttemptRow};
use super::disk::{self, Change, Rescue};
use super::players::{self, Deed, Players};
use super::{Board, Damage, Name, Placement, ScoresError, table};

/// How long a save waits for another process that saves there. A save takes milliseconds; whoever holds a lock for longer hangs.
pub const PATIENCE: Duration = Duration::from_secs(2);

/// The file of what the players have done.
const PLAYERS: &str = "players.csv";
/// The file of attempts.
const ATTEMPTS: &str = "attempts.csv";

/// The folder of all leaderboards.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scores {
    folder: PathBuf,
}

/// A leaderboard as read for display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loaded {
    /// All rows that could be read.
    pub board: Board,
    /// The places that could not.
    pub damage: Vec<Damage>,
}

/// What a save has done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saved {
    /// The board as it stands on disk now.
    pub board: Board,
    /// What became of the score.
    pub placement: Placement,
    /// Present when the file was damaged.
    pub rescue: Option<Rescue>,
}

impl Scores {
    /// The leaderboards in this folder, which need not exist yet.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// Reads a level's leaderboard and changes nothing. A missing file is an empty board.
    ///
    /// # Errors
    /// A level name that cannot name a file; a file that cannot be read at all.
    pub fn load(&self, level: &str) -> Result<Loaded, ScoresError> {
        let path = self.path(level)?;
        let (board, damage) = table::read(&path, &disk::read_if_there(&path)?.unwrap_or_default());
        Ok(Loaded { board, damage })
    }

    /// Saves a score in a level's leaderboard; the file is on disk, whole, when this returns.
    ///
    /// Waits up to [`PATIENCE`] while another process saves there. A damaged file is kept aside as `<level>.csv.damaged-N` before it is
    /// replaced.
    ///
    /// # Errors
    /// A score below 1; a level name that cannot name a file; a read-only file; a board that is too large; another process that does
    /// not come to an end ([`ScoresError::Busy`]: it may be tried again); whatever the system refuses. The old file is untouched then.
    pub fn save(&self, level: &str, name: &Name, score: i64) -> Result<Saved, ScoresError> {
        self.save_within(PATIENCE, level, name, score)
    }

    /// As [`Scores::save`], with that much patience; without any it returns at once.
    ///
    /// # Errors
    /// As [`Scores::save`].
    pub fn save_within(&self, patience: Duration, level: &str, name: &Name, score: i64) -> Result<Saved, ScoresError> {
        let path = self.path(level)?;
        if score < 1 {
            return Err(ScoresError::NoScore);
        }
        let ((board, placement), rescue) = disk::update(&self.folder, path, patience, |path, old| {
            let (mut board, damage) = table::read(path, old);
            let placement = board.place(name, score)?;
            let bytes = table::write(&board).map_err(ScoresError::file("write the new scores", path))?;
            Ok(Change { bytes, damage, outcome: (board, placement) })
        })?;
        Ok(Saved { board, placement, rescue })
    }

    /// Reads what the players have done and changes nothing, with the places that could not be read. Without a file there are no players.
    ///
    /// # Errors
    /// A file that cannot be read at all.
    pub fn players(&self) -> Result<(Players, Vec<Damage>), ScoresError> {
        let path = self.folder.join(PLAYERS);
        Ok(players::read(&path, &disk::read_if_there(&path)?.unwrap_or_default()))
    }

    /// Writes down what players did; everything else that other processes have written there meanwhile stays. The answer is what is on
    /// disk, whole, when this returns.
    ///
    /// # Errors
    /// As [`Scores::save`].
    pub fn record_within(&self, patience: Duration, deeds: &[Deed]) -> Result<(Players, Option<Rescue>), ScoresError> {
        disk::update(&self.folder, self.folder.join(PLAYERS), patience, |path, old| {
            let (mut players, damage) = players::read(path, old);
            deeds.iter().for_each(|deed| players.apply(deed));
            let bytes = players::write(&players).map_err(ScoresError::file("write the new scores", path))?;
            Ok(Change { bytes, damage, outcome: players })
        })
    }

    /// Adds an attempt at the end of the list of attempts. A file that is no such list is renamed; to what, is the answer.
    ///
    /// # Errors
    /// As [`Scores::save`].
    pub fn append_within(&self, patience: Duration, attempt: &AttemptRow) -> Result<Option<PathBuf>, ScoresError> {
        let path = self.folder.join(ATTEMPTS);
        let row = attempts::line(attempt).map_err(ScoresError::file("write the attempt", &path))?;
        disk::append(&self.folder, path, patience, (attempts::HEADER.as_bytes(), &row))
    }

    /// The file of a level, whose name must be one that stays in the folder on every system and is no other file's.
    fn path(&self, level: &str) -> Result<PathBuf, ScoresError> {
        let plain = !level.is_empty() && !level.chars().any(|c| matches!(c, '/' | '\\' | ':') || c.is_control());
        let file = format!("{level}.csv");
        let taken = [PLAYERS, ATTEMPTS].iter().any(|other| file.eq_ignore_ascii_case(other));
        if !plain || taken || level == "." || level == ".." {
            return Err(ScoresError::LevelName(level.to_owned()));
        }
        Ok(self.folder.join(file))
    }
}
