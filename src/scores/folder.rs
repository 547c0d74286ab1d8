//! The folder of the scores files: a leaderboard a level with the flights of its rows, the players' records, and `attempts.csv`, a line for each
//! finished attempt, for spreadsheets and people: the game only adds to it, and reads none of its rows. RFC 4180, CRLF, UTF-8.

use super::board::{self, Board, Placement};
use super::name::{Name, ScoresError};
use super::players::{self, Deed, Players, harmless};
use crate::files::{self, SaveError};
use crate::{game::Replay, words::tr};
use serde::{Serialize, Serializer};
use std::path::{Path, PathBuf};

const PLAYERS: &str = "players.csv";
const ATTEMPTS: &str = "attempts.csv";
const FLIGHTS: &str = "flights";
const ENDING: &str = ".replay.csv";

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scores {
    folder: PathBuf,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadedBoard {
    pub board: Board,
    pub damage: Vec<String>,
}

#[derive(Clone, Copy, Debug)]
pub struct Score<'a> {
    pub name: &'a Name,
    pub points: i64,
    pub flight: Option<&'a Replay>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saved {
    /// As on disk.
    pub board: Board,
    pub placement: Placement,
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
        let (board, damage) = board::read(&path, &bytes(&path)?);
        Ok(LoadedBoard { board, damage })
    }

    /// As [`Scores::save_with_flight`], of a score that no flight proves.
    pub fn save(&self, level: &str, name: &Name, points: i64) -> Result<Saved, ScoresError> {
        self.save_with_flight(level, Score { name, points, flight: None })
    }

    /// Saves a score; the file is on disk, whole, when this returns, and the flight before the row that names it. Errors: a score below 1; a level
    /// name that cannot name a file; a board with places that cannot be read; see [`SaveError`]. The old file is untouched then.
    pub fn save_with_flight(&self, level: &str, score: Score<'_>) -> Result<Saved, ScoresError> {
        let path = self.path(level)?;
        let Score { name, points, flight } = score;
        if points < 1 {
            return Err(ScoresError::NoScore);
        }
        files::update(&path, files::SCORES, |old| {
            let mut board = sound(board::read(&path, old))?;
            let placement = board.place(name, points)?;
            if !matches!(placement, Placement::Kept { .. }) {
                let kept = flight.map(|flight| Ok::<_, SaveError>((flight.time, self.keep_flight(level, name, flight)?)));
                board.set_flight(name, kept.transpose()?);
            }
            let text = board::write(&board);
            Ok((text.into_bytes(), Saved { board, placement }))
        })
    }

    /// Writes the record of a row's flight; the answer is its file. The caller holds the board's lock.
    fn keep_flight(&self, level: &str, name: &Name, flight: &Replay) -> Result<String, SaveError> {
        let file = format!("{name}-{}-{:016x}{ENDING}", flight.score, flight.hash);
        let mut folder = self.folder.clone();
        for part in [FLIGHTS, level] {
            folder.push(part);
            files::make_shared_folder(&folder).map_err(SaveError::file("create the folder", &folder))?;
        }
        let record = Replay { player: Some(name.to_string()), ..flight.clone() };
        files::write(&folder.join(&file), record.to_string().as_bytes())?;
        Ok(file)
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

    /// The players, and the unreadable places. Without a file there are no players. Errors: a file that cannot be read at all.
    pub fn players(&self) -> Result<(Players, Vec<String>), ScoresError> {
        let path = self.folder.join(PLAYERS);
        Ok(players::read(&path, &bytes(&path)?))
    }

    /// Saves deeds; rows that other processes have written meanwhile stay. The answer is what is on disk, whole.
    pub fn record(&self, deeds: &[Deed]) -> Result<Players, ScoresError> {
        let path = self.folder.join(PLAYERS);
        files::update(&path, files::SCORES, |old| {
            let mut players = sound(players::read(&path, old))?;
            deeds.iter().for_each(|deed| players.apply(deed));
            Ok((players::write(&players).into_bytes(), players))
        })
    }

    pub fn append(&self, attempts: &[AttemptRow]) -> Result<(), ScoresError> {
        let lines: String = attempts.iter().map(line).collect();
        append(&self.folder.join(ATTEMPTS), HEADER, &lines)
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

fn bytes(path: &Path) -> Result<Vec<u8>, ScoresError> {
    let read = files::read_if_there(path, files::SCORES).map_err(SaveError::file("read the file", path))?;
    Ok(read.unwrap_or_default())
}

/// A file with places that cannot be read is not replaced.
fn sound<T>((rows, damage): (T, Vec<String>)) -> Result<T, ScoresError> {
    if damage.is_empty() { Ok(rows) } else { Err(ScoresError::Damaged(damage)) }
}

pub(super) const HEADER: &str = "level,player,result,time,fuel,hits,cause,assisted\r\n";

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AttemptRow {
    #[serde(serialize_with = "as_text")]
    pub level: String,
    pub player: Name,
    /// `completed` or `failed`.
    pub result: &'static str,
    /// s.
    #[serde(serialize_with = "as_thousandths")]
    pub time: f64,
    /// The fraction of the fuel left, 0 … 1.
    #[serde(serialize_with = "as_thousandths")]
    pub fuel: f64,
    /// Damaging ones.
    pub hits: u32,
    /// As `resultant run` names it; empty without a loss.
    #[serde(serialize_with = "as_text")]
    pub cause: String,
    pub assisted: bool,
}

/// The most bytes of a list. A page has some 5 MB in all, and the oldest lines go there.
const MOST: usize = if cfg!(browser) { 128 << 10 } else { files::INPUTS as usize };

/// Adds lines to a list that begins with that header, or makes one. A last line without an end gets one.
pub(super) fn append(path: &Path, header: &str, lines: &str) -> Result<(), ScoresError> {
    if lines.is_empty() {
        return Ok(());
    }
    files::update(path, MOST as u64, |old| {
        let plain = |text: &'_ [u8]| text.strip_prefix("\u{feff}".as_bytes()).unwrap_or(text).to_vec();
        if !old.is_empty() && !plain(old).starts_with(plain(header.as_bytes()).trim_ascii_end()) {
            return Err(ScoresError::Foreign(path.to_owned()));
        }
        let before = if old.is_empty() { header.as_bytes() } else { old };
        let end: &[u8] = if before.ends_with(b"\n") { b"" } else { b"\r\n" };
        let new = [before, end, lines.as_bytes()].concat();
        Ok((if cfg!(browser) { newest(new) } else { new }, ()))
    })
}

/// The header and the newest lines, as many as there is room for.
fn newest(mut list: Vec<u8>) -> Vec<u8> {
    if list.len() > MOST {
        let first = list.iter().position(|byte| *byte == b'\n').map_or(0, |end| end + 1);
        let surplus = list.len() - MOST + first;
        let whole = list[surplus..].iter().position(|byte| *byte == b'\n').map_or(list.len(), |end| surplus + end + 1);
        list.drain(first..whole);
    }
    list
}

/// A row with its line end.
pub(super) fn line(row: &impl Serialize) -> String {
    let mut writer = csv::WriterBuilder::new().terminator(csv::Terminator::CRLF).has_headers(false).from_writer(Vec::new());
    // Memory takes all writes, and the cells are text.
    drop(writer.serialize(row));
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// Text that no spreadsheet reads as a formula.
pub(super) fn as_text<S: Serializer>(text: &str, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&harmless(text))
}

/// Three decimals, which differ between any two ticks.
fn as_thousandths<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
    to.collect_str(&format_args!("{value:.3}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_opens_in_a_spreadsheet() {
        let mut row = AttemptRow {
            level: "Höhle, \"tief\"".to_owned(),
            player: Name::new("ann").unwrap(),
            result: "completed",
            time: 5.483_333,
            fuel: 0.85,
            hits: 2,
            cause: String::new(),
            assisted: false,
        };
        assert_eq!(line(&row), "\"Höhle, \"\"tief\"\"\",ann,completed,5.483,0.850,2,,false\r\n");
        for level in ["=cmd|' /C calc'!A0", "+1", "-1", "@SUM(A1)", "\t=1"] {
            row.level = level.to_owned();
            assert!(line(&row).trim_start_matches('"').starts_with('\''), "{}", line(&row));
        }
    }

    #[test]
    fn the_header_names_the_columns_of_a_line() {
        let row = AttemptRow {
            level: "1".to_owned(),
            player: Name::guest(),
            result: "failed",
            time: 1.0,
            fuel: 1.0,
            hits: 0,
            cause: "obstacle 2".to_owned(),
            assisted: true,
        };
        let mut writer = csv::WriterBuilder::new().terminator(csv::Terminator::CRLF).from_writer(Vec::new());
        writer.serialize(&row).unwrap();
        let text = String::from_utf8(writer.into_inner().unwrap()).unwrap();
        assert_eq!(text, format!("{HEADER}1,Guest,failed,1.000,1.000,0,obstacle 2,true\r\n"));
    }
}
