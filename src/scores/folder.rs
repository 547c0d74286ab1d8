//! The folder that holds the scores files: a leaderboard a level with the flights of its rows, the boards of other versions of a level,
//! what the players have done, and a line an attempt.

use std::path::PathBuf;
use std::time::Duration;

use super::attempts::{self, AttemptRow};
use super::board::{Board, Placement};
use super::disk::{self, FileChange, Rescue};
use super::error::ScoresError;
use super::name::Name;
use super::origin::RowOrigin;
use super::players::{self, Deed, Players};
use super::table;
use crate::files::{self, PATIENCE};
use crate::game::{Fingerprint, LevelHash, Replay};

/// The file of what the players have done.
const PLAYERS: &str = "players.csv";
/// The file of attempts.
const ATTEMPTS: &str = "attempts.csv";
/// The folder of flights, in which each level has one.
const FLIGHTS: &str = "flights";
/// The folder of boards of other versions of the levels.
const ASIDE: &str = "aside";

/// The folder of all leaderboards.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scores {
    folder: PathBuf,
}

/// A leaderboard as read for display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadedBoard {
    /// All rows that could be read.
    pub board: Board,
    /// The places that could not.
    pub damage: Vec<String>,
}

/// A score to be saved.
#[derive(Clone, Copy, Debug)]
pub struct Score<'a> {
    /// Whose.
    pub name: &'a Name,
    /// Points.
    pub points: i64,
    /// How they were flown; by it the row can be proven.
    pub flight: Option<&'a Replay>,
    /// The level's version, where more is known of it than the flight says.
    pub version: Option<Fingerprint>,
}

/// The result of a save.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saved {
    /// The board as it stands on disk now.
    pub board: Board,
    /// The placement of the score.
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
    pub fn load(&self, level: &str) -> Result<LoadedBoard, ScoresError> {
        let path = self.path(level)?;
        let (board, damage) = table::read(&path, &disk::read_if_there(&path)?.unwrap_or_default());
        Ok(LoadedBoard { board, damage })
    }

    /// As [`Scores::load`], for a level of that version: rows that say that they are of another one are not on its board, and those that were
    /// kept aside are. Rows without a flight stand
    /// last. With the number of other versions that there are boards of.
    ///
    /// # Errors
    /// As [`Scores::load`].
    pub fn load_version(&self, level: &str, version: impl Into<Fingerprint>) -> Result<(LoadedBoard, usize), ScoresError> {
        let version = version.into();
        let mut loaded = self.load(level)?;
        let mut others = self.versions_aside(level);
        others.extend(loaded.board.take_other_versions(version).into_iter().map(|(other, _)| other));
        others.retain(|&other| !version.is(other));
        others.sort_unstable();
        others.dedup();
        self.fetch_back(&mut loaded.board, level, version)?;
        loaded.board.rank_by(|_| false);
        Ok((loaded, others.len()))
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
        self.save_within(PATIENCE, level, Score { name, points: score, flight: None, version: None })
    }

    /// As [`Scores::save`], with that much patience, and with the flight: without any patience it returns at once. The flight is on disk
    /// before the row that names it. Rows of other versions of the level than the flight's move to boards of their own.
    ///
    /// # Errors
    /// As [`Scores::save`].
    pub fn save_within(&self, patience: Duration, level: &str, score: Score<'_>) -> Result<Saved, ScoresError> {
        let path = self.path(level)?;
        let Score { name, points, flight, version } = score;
        let version = version.or_else(|| Some(flight?.level_hash?.into()));
        if points < 1 {
            return Err(ScoresError::NoScore);
        }
        let ((board, placement), rescue) = disk::update(&self.folder, path, patience, |path, old| {
            let (mut board, damage) = table::read(path, old);
            if let Some(version) = version {
                self.put_aside(&mut board, level, version, patience)?;
                self.fetch_back(&mut board, level, version)?;
            }
            let placement = board.place(name, points)?;
            if !matches!(placement, Placement::Kept { .. }) {
                let origin = flight.map(|flight| RowOrigin::of_flight(name.as_str(), flight)).unwrap_or_default();
                if let (Some(file), Some(flight)) = (&origin.flight, flight) {
                    let flight = Replay { player: Some(name.to_string()), ..flight.clone() };
                    disk::write_within(&self.folder, &[FLIGHTS, level], file, flight.to_string().as_bytes())?;
                }
                board.set_origin(name, &origin);
            }
            let bytes = table::write(&board).map_err(ScoresError::file("write the new scores", path))?;
            Ok(FileChange { bytes, damage, taken_up: Vec::new(), outcome: (board, placement) })
        })?;
        Ok(Saved { board, placement, rescue })
    }

    /// The flight of a row; `None` where the row names none.
    ///
    /// # Errors
    /// The fault of its name or its file.
    pub fn flight(&self, level: &str, origin: &RowOrigin) -> Option<Result<Replay, String>> {
        let read = |file: &str| {
            self.path(level).map_err(|error| error.to_string())?;
            let path = self.folder.join(FLIGHTS).join(level).join(file);
            let named = path.display().to_string();
            let text = files::read_text(&path, files::INPUTS).map_err(|error| format!("{named}: {error}"))?;
            Replay::parse(&named, &text).map_err(|problems| problems.to_string())
        };
        Some(origin.file()?.and_then(read))
    }

    /// The levels and other games that have a board here, by their files' names.
    pub fn boards(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.folder).into_iter().flatten().flatten();
        let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
        let board = |name: String| Some(name.strip_suffix(".csv")?.to_owned()).filter(|name| !name.starts_with('.'));
        let mut boards: Vec<String> = names.filter_map(board).filter(|level| self.path(level).is_ok()).collect();
        boards.sort_unstable();
        boards
    }

    /// The file of a level's board of another version.
    fn aside(&self, level: &str, version: LevelHash) -> PathBuf {
        self.folder.join(ASIDE).join(format!("{level}.{version}.csv"))
    }

    /// The versions of a level that have boards aside.
    fn versions_aside(&self, level: &str) -> Vec<LevelHash> {
        let entries = std::fs::read_dir(self.folder.join(ASIDE)).into_iter().flatten().flatten();
        let version = |name: String| name.strip_prefix(level)?.strip_prefix('.')?.strip_suffix(".csv")?.parse().ok();
        entries.filter_map(|entry| version(entry.file_name().into_string().ok()?)).collect()
    }

    /// Moves the rows of other versions of the level to their boards. They are on disk there before they leave this one.
    fn put_aside(&self, board: &mut Board, level: &str, version: Fingerprint, patience: Duration) -> Result<(), ScoresError> {
        let mut taken = board.take_other_versions(version);
        while let Some(&(other, _)) = taken.first() {
            let (rows, rest) = taken.into_iter().partition::<Vec<_>, _>(|(version, _)| *version == other);
            taken = rest;
            let folder = self.folder.join(ASIDE);
            disk::make_folder(&folder).map_err(ScoresError::file("create the folder", &folder))?;
            disk::update(&folder, self.aside(level, other), patience, |path, old| {
                let (mut aside, damage) = table::read(path, old);
                rows.iter().for_each(|(_, row)| aside.merge(row));
                let bytes = table::write(&aside).map_err(ScoresError::file("write the scores kept aside", path))?;
                Ok(FileChange { bytes, damage, taken_up: Vec::new(), outcome: () })
            })?;
        }
        Ok(())
    }

    /// Puts the rows on a board that were kept aside when the level was another one for a while.
    fn fetch_back(&self, board: &mut Board, level: &str, version: Fingerprint) -> Result<(), ScoresError> {
        for hash in version.hashes() {
            let path = self.aside(level, hash);
            if let Some(bytes) = disk::read_if_there(&path)? {
                table::read(&path, &bytes).0.all_moved().iter().for_each(|row| board.merge(row));
            }
        }
        Ok(())
    }

    /// Reads what the players have done and changes nothing, with the places that could not be read. Without a file there are no players.
    ///
    /// # Errors
    /// A file that cannot be read at all.
    pub fn players(&self) -> Result<(Players, Vec<String>), ScoresError> {
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
            let mut taken_up = Vec::new();
            for (path, bytes) in disk::waiting(path) {
                let (waiting, damage) = players::read(&path, &bytes);
                players.merge(waiting);
                // A file that was damaged meanwhile stays for people to look at.
                if damage.is_empty() {
                    taken_up.push(path);
                }
            }
            deeds.iter().for_each(|deed| players.apply(deed));
            let bytes = players::write(&players).map_err(ScoresError::file("write the new scores", path))?;
            Ok(FileChange { bytes, damage, taken_up, outcome: players })
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

    /// Puts by what could not be written down because another program holds the locks: the next sitting takes it up.
    ///
    /// # Errors
    /// Whatever the system refuses.
    pub fn put_by(&self, deeds: &[Deed], attempts: impl IntoIterator<Item = AttemptRow>) -> Result<(), ScoresError> {
        let mut players = Players::default();
        deeds.iter().for_each(|deed| players.apply(deed));
        if !players.all().is_empty() {
            let path = self.folder.join(PLAYERS);
            let bytes = players::write(&players).map_err(ScoresError::file("write the new scores", &path))?;
            disk::put_by(&self.folder, path, &bytes)?;
        }
        let (path, mut bytes) = (self.folder.join(ATTEMPTS), Vec::new());
        for attempt in attempts {
            bytes.extend(attempts::line(&attempt).map_err(ScoresError::file("write the attempt", &path))?);
        }
        if bytes.is_empty() {
            return Ok(());
        }
        disk::put_by(&self.folder, path, &[attempts::HEADER.as_bytes(), &bytes].concat())
    }

    /// Takes up what earlier sittings have put by.
    ///
    /// # Errors
    /// As [`Scores::save`]; what was put by stays then.
    pub fn take_up(&self, patience: Duration) -> Result<(), ScoresError> {
        let (players, attempts) = (self.folder.join(PLAYERS), self.folder.join(ATTEMPTS));
        if !disk::waiting(&players).is_empty() {
            self.record_within(patience, &[])?;
        }
        if !disk::waiting(&attempts).is_empty() {
            disk::append(&self.folder, attempts, patience, (attempts::HEADER.as_bytes(), b""))?;
        }
        Ok(())
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
