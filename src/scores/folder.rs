//! The folder of the scores files: a leaderboard a level with the flights of its rows, the players' records, and a line an attempt.

use std::path::PathBuf;
use std::time::Duration;

use super::attempts::{self, AttemptRow};
use super::board::{Board, Placement};
use super::disk::{self, Rescue, ScoresChange};
use super::error::ScoresError;
use super::name::Name;
use super::players::{self, Deed, Players};
use super::table;
use crate::files::{self, PATIENCE};
use crate::game::Replay;
use crate::words::tr;

const PLAYERS: &str = "players.csv";
const ATTEMPTS: &str = "attempts.csv";
/// Each level has a folder in it.
const FLIGHTS: &str = "flights";
const ENDING: &str = ".replay.csv";

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scores {
    folder: PathBuf,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadedBoard {
    pub board: Board,
    /// The unreadable places.
    pub damage: Vec<String>,
}

#[derive(Clone, Copy, Debug)]
pub struct Score<'a> {
    pub name: &'a Name,
    pub points: i64,
    /// The proof of the row.
    pub flight: Option<&'a Replay>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saved {
    /// As on disk.
    pub board: Board,
    pub placement: Placement,
    /// `Some` for a damaged file.
    pub rescue: Option<Rescue>,
}

impl Scores {
    /// The folder need not exist yet.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// Reads a leaderboard and changes nothing. A missing file is an empty board.
    /// Errors: a level name that cannot name a file; a file that cannot be read at all.
    pub fn load(&self, level: &str) -> Result<LoadedBoard, ScoresError> {
        let path = self.path(level)?;
        let (board, damage) = table::read(&path, &disk::read_if_there(&path)?.unwrap_or_default());
        Ok(LoadedBoard { board, damage })
    }

    /// Saves a score; the file is on disk, whole, when this returns. It waits up to [`PATIENCE`] for another process. A damaged
    /// file is kept as `<level>.csv.damaged-N`.
    /// Errors: a score below 1; a level name that cannot name a file; a read-only file; a board that is too large; a lock that
    /// another process keeps ([`ScoresError::Busy`]: a later try may succeed); the system's. The old file is untouched then.
    pub fn save(&self, level: &str, name: &Name, score: i64) -> Result<Saved, ScoresError> {
        self.save_within(PATIENCE, level, Score { name, points: score, flight: None })
    }

    /// As [`Scores::save`], with a flight, which is on disk before the row that names it; without patience it returns at once.
    pub fn save_within(&self, patience: Duration, level: &str, score: Score<'_>) -> Result<Saved, ScoresError> {
        let path = self.path(level)?;
        let Score { name, points, flight } = score;
        if points < 1 {
            return Err(ScoresError::NoScore);
        }
        let ((board, placement), rescue) = disk::update(&self.folder, path, patience, |path, old| {
            let (mut board, damage) = table::read(path, old);
            let placement = board.place(name, points)?;
            if !matches!(placement, Placement::Kept { .. }) {
                let kept = flight.map(|flight| {
                    let file = format!("{name}-{}-{:016x}{ENDING}", flight.score, flight.hash);
                    let record = Replay { player: Some(name.to_string()), ..flight.clone() }.to_string();
                    disk::write_within(&self.folder, &[FLIGHTS, level], &file, record.as_bytes())?;
                    Ok((flight.time, file))
                });
                board.set_flight(name, kept.transpose()?);
            }
            Ok(ScoresChange { bytes: table::write(&board), damage, taken_up: Vec::new(), outcome: (board, placement) })
        })?;
        Ok(Saved { board, placement, rescue })
    }

    /// The record of a row's flight, by the file that the row names: a plain name, which leads into no other folder. The error is the
    /// fault of its name or file.
    pub fn flight(&self, level: &str, file: &str) -> Result<Replay, String> {
        let plain = file.ends_with(ENDING)
            && !file.starts_with('.')
            && file.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.'));
        if !plain {
            let (name, example) = (format_args!("{file:?}"), format!("ann-17342-0123456789abcdef{ENDING}"));
            return Err(tr!("found the flight {name}, expected a file's name such as {example}", name, example));
        }
        self.path(level).map_err(|error| error.to_string())?;
        let path = self.folder.join(FLIGHTS).join(level).join(file);
        let named = path.display().to_string();
        let text = files::read_text(&path, files::INPUTS).map_err(|error| format!("{named}: {error}"))?;
        Replay::parse(&named, &text).map_err(|problems| problems.to_string())
    }

    /// The names of all leaderboards' files: levels and other games.
    pub fn boards(&self) -> Vec<String> {
        let names = files::text_names(&self.folder).into_iter();
        let board = |name: String| Some(name.strip_suffix(".csv")?.to_owned()).filter(|name| !name.starts_with('.'));
        let mut boards: Vec<String> = names.filter_map(board).filter(|level| self.path(level).is_ok()).collect();
        boards.sort_unstable();
        boards
    }

    /// The players, and the unreadable places. Without a file there are no players.
    /// Errors: a file that cannot be read at all.
    pub fn players(&self) -> Result<(Players, Vec<String>), ScoresError> {
        let path = self.folder.join(PLAYERS);
        Ok(players::read(&path, &disk::read_if_there(&path)?.unwrap_or_default()))
    }

    /// Saves deeds; rows that other processes have written meanwhile stay. The answer is what is on disk, whole.
    pub fn record_within(&self, patience: Duration, deeds: &[Deed]) -> Result<(Players, Option<Rescue>), ScoresError> {
        disk::update(&self.folder, self.folder.join(PLAYERS), patience, |path, old| {
            let (mut players, damage) = players::read(path, old);
            let mut taken_up = Vec::new();
            for (path, bytes) in disk::waiting(path) {
                let (waiting, damage) = players::read(&path, &bytes);
                players.merge(waiting);
                // A damaged file stays for people to look at.
                if damage.is_empty() {
                    taken_up.push(path);
                }
            }
            deeds.iter().for_each(|deed| players.apply(deed));
            Ok(ScoresChange { bytes: players::write(&players), damage, taken_up, outcome: players })
        })
    }

    /// Adds an attempt. A file that is no list of attempts is renamed; the answer is its new path.
    pub fn append_within(&self, patience: Duration, attempt: &AttemptRow) -> Result<Option<PathBuf>, ScoresError> {
        disk::append(&self.folder, self.folder.join(ATTEMPTS), patience, (attempts::HEADER, &attempts::line(attempt)))
    }

    /// Puts deeds and attempts aside while another program holds the locks: the next sitting takes them up.
    pub fn put_by(&self, deeds: &[Deed], attempts: impl IntoIterator<Item = AttemptRow>) -> Result<(), ScoresError> {
        let mut players = Players::default();
        deeds.iter().for_each(|deed| players.apply(deed));
        if !players.all().is_empty() {
            disk::put_by(&self.folder, self.folder.join(PLAYERS), &players::write(&players))?;
        }
        let lines: String = attempts.into_iter().map(|attempt| attempts::line(&attempt)).collect();
        if lines.is_empty() {
            return Ok(());
        }
        disk::put_by(&self.folder, self.folder.join(ATTEMPTS), &(attempts::HEADER.to_owned() + &lines))
    }

    /// Takes up what earlier sittings have put aside; after an error it stays there.
    pub fn take_up(&self, patience: Duration) -> Result<(), ScoresError> {
        let (players, attempts) = (self.folder.join(PLAYERS), self.folder.join(ATTEMPTS));
        if !disk::waiting(&players).is_empty() {
            self.record_within(patience, &[])?;
        }
        if !disk::waiting(&attempts).is_empty() {
            disk::append(&self.folder, attempts, patience, (attempts::HEADER, ""))?;
        }
        Ok(())
    }

    /// The file of a level whose name stays in the folder on every system and is no other file's.
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
