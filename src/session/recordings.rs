//! Recorded flights on disk, as the screens list them, read them and keep them.

use crate::files::{self, INPUTS, LEVEL_TABLE, read_text};
use crate::game::{LevelHash, Outcome, Reel, Replay, TICK_RATE, level_hash};
use crate::scores::{Board, Name, Scores};
use crate::session::library::{Attempt, Flown, NewFile, Rival};
use crate::{level::Level, pack, session::Session, words::tr};
use std::path::{Path, PathBuf};
use std::{rc::Rc, sync::Arc};

#[derive(Clone, Debug)]
pub struct Visit {
    /// The level's folder name.
    pub level: String,
    pub flown: Option<Rc<Flown>>,
    /// The file of the board's flight that is looked for.
    pub chosen: Option<String>,
}

impl Visit {
    pub fn of(level: &str) -> Self {
        Self { level: level.to_owned(), flown: None, chosen: None }
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FlightSource {
    Flown,
    Level(PathBuf),
    Row(String),
    Code(String),
}

#[derive(Clone, Debug, PartialEq)]
pub struct FlightCandidate {
    pub name: String,
    pub about: String,
    pub score: Option<i64>,
    /// s.
    pub time: Option<f64>,
    pub source: FlightSource,
}

impl FlightCandidate {
    pub fn just_flown(flown: &Flown) -> Self {
        Self {
            name: tr("This flight").to_owned(),
            about: tr("just flown").to_owned(),
            score: Some(flown.replay.score),
            time: Some(flown.replay.time),
            source: FlightSource::Flown,
        }
    }
}

/// A flight of the level's own, which stands among the rows without a rank.
#[derive(Clone, Debug, PartialEq)]
pub struct BoardRival {
    pub name: &'static str,
    pub score: i64,
    /// s, where its record says it.
    pub time: Option<f64>,
}

/// The folder in a level's with its own flights, and each of them: file, name, what it shows.
const FLIGHTS: &str = "flights";
const OWN: [(&str, &str, &str); 4] = [
    ("gold", "Gold", "the level's own, for gold"),
    ("silver", "Silver", "the level's own, for silver"),
    ("mark", "Mark", "the level's own, for its mark"),
    ("careful", "Careful", "the level's own, slow and safe"),
];
const ENDING: &str = ".replay.csv";

/// The flights of a level: what was just flown, the player's best, the level's own in its folder, and the rest of the board.
pub fn candidates(visit: &Visit, folder: &Path, board: &Board, player: &Name) -> Vec<FlightCandidate> {
    let flown = visit.flown.as_deref().map(FlightCandidate::just_flown);
    let own = OWN.iter().filter_map(|(file, name, about)| {
        let path = folder.join(FLIGHTS).join(format!("{file}{ENDING}"));
        files::is_file(&path).then(|| FlightCandidate {
            name: tr(name).to_owned(),
            about: tr(about).to_owned(),
            score: None,
            time: None,
            source: FlightSource::Level(path),
        })
    });
    let mut rows: Vec<FlightCandidate> = Vec::new();
    let mut best = None;
    for (index, row) in board.rows().iter().enumerate() {
        let Some(file) = board.flight(index) else { continue };
        let yours = row.name == *player;
        let about = if yours { tr!("your best, rank {rank}", rank = index + 1) } else { tr!("rank {rank}", rank = index + 1) };
        let candidate = FlightCandidate {
            name: row.name.to_string(),
            about,
            score: Some(row.score),
            time: board.time(index),
            source: FlightSource::Row(file.to_owned()),
        };
        if yours { best = Some(candidate) } else { rows.push(candidate) }
    }
    flown.into_iter().chain(best).chain(own).chain(rows).collect()
}

/// The level's own flights as rivals on its board: those that were flown in this version of it. None is so long as to need more than a table.
pub fn rivals(folder: &Path, level: &Level) -> Vec<BoardRival> {
    let here = level_hash(level);
    let rival = |(file, name, _): &(&str, &'static str, &str)| {
        let replay = own(folder, file, here)?;
        Some(BoardRival { name, score: replay.score, time: Some(replay.time) })
    };
    OWN.iter().filter_map(rival).collect()
}

pub fn gold(folder: &Path, level: Arc<Level>) -> Option<Reel> {
    let replay = for_gold(folder, &level)?;
    Reel::new(level, &replay.inputs, replay.tick_rate).ok()
}

pub fn for_gold(folder: &Path, level: &Level) -> Option<Replay> {
    own(folder, OWN[0].0, level_hash(level))
}

/// One of the level's own flights, where it was completed in this version of it.
fn own(folder: &Path, file: &str, here: LevelHash) -> Option<Replay> {
    let text = read_text(&folder.join(FLIGHTS).join(format!("{file}{ENDING}")), LEVEL_TABLE).ok()?;
    let replay = Replay::parse(file, &text).ok().filter(|replay| replay.level_hash == here)?;
    (replay.outcome == Outcome::Completed).then_some(replay)
}

/// The record of one of them, which was flown in that level. Errors: it cannot be read, or it was flown in another level, in words.
pub fn record(visit: &Visit, candidate: &FlightCandidate, scores: &Scores, level: &Level) -> Result<Replay, String> {
    let replay = read(visit, &candidate.source, scores)?;
    if replay.level_hash == level_hash(level) {
        return Ok(replay);
    }
    Err(tr!("{name}: flown in another version of the level, or in another level.", name = candidate.name))
}

/// The record of a flight as it lies there, in whatever level it was flown. Errors: it cannot be read, in words.
pub fn read(visit: &Visit, source: &FlightSource, scores: &Scores) -> Result<Replay, String> {
    Ok(match source {
        FlightSource::Flown => visit.flown.as_ref().map(|flown| flown.replay.clone()).ok_or(tr("there is no flight"))?,
        FlightSource::Level(path) => {
            let named = path.display().to_string();
            let text = read_text(path, INPUTS).map_err(|error| format!("{named}: {error}"))?;
            Replay::parse(&named, &text).map_err(|problems| problems.0.first().cloned().unwrap_or_default())?
        }
        FlightSource::Code(code) => Replay::from_code(code)?,
        FlightSource::Row(file) => {
            scores.flight(&visit.level, file).map_err(|problems| problems.lines().next().unwrap_or_default().to_owned())?
        }
    })
}

impl Session {
    fn level_of(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<Arc<Level>, String> {
        match (&candidate.source, &visit.flown) {
            // As it was then.
            (FlightSource::Flown, Some(flown)) => Ok(flown.level.clone()),
            _ => self.library.load(&visit.level).map_err(|refusal| refusal.into_iter().next().unwrap_or_default()),
        }
    }

    /// A flight that is to be watched, and its title. Errors: it cannot be read, or was flown in another level, in words; so of all that follow.
    pub fn reel(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<(String, Reel), String> {
        let level = self.level_of(visit, candidate)?;
        let title = format!("{} · {}", tr(&level.title), candidate.name);
        let reel = match (&candidate.source, &visit.flown) {
            (FlightSource::Flown, Some(flown)) => Reel::flown(flown.history.clone()),
            _ => {
                let replay = record(visit, candidate, &self.scores, &level)?;
                Reel::new(level, &replay.inputs, replay.tick_rate).map_err(|error| error.to_string())?
            }
        };
        Ok((title, reel))
    }

    pub fn race(&self, visit: &Visit, candidates: &[FlightCandidate]) -> Result<Attempt, String> {
        let level = self.library.load(&visit.level).map_err(|refusal| refusal.into_iter().next().unwrap_or_default())?;
        let rival = |candidate: &FlightCandidate| {
            let replay = record(visit, candidate, &self.scores, &level)?;
            if replay.tick_rate != TICK_RATE {
                return Err(tr!(
                    "{name}: flown at {rate} ticks a second, the game has {here}.",
                    name = candidate.name,
                    rate = replay.tick_rate,
                    here = TICK_RATE
                ));
            }
            Ok(Rival { name: candidate.name.clone(), inputs: Arc::new(replay.inputs) })
        };
        let rivals = candidates.iter().map(rival).collect::<Result<_, String>>()?;
        Ok(Attempt { rivals, ..Attempt::by_hand(level) })
    }

    pub fn keep_flight(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<String, String> {
        let replay = self.named_record(visit, candidate)?;
        let whose: String = candidate.name.to_lowercase().chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
        let stem = format!("{}-{whose}-{}", visit.level, replay.score);
        let bytes = replay.to_string().into_bytes();
        let file = NewFile { stem, ending: ENDING, bytes, what: tr("the flight"), same_up_to: INPUTS };
        let path = file.write(&self.places.root.join("flights"))?;
        Ok(tr!("Kept as {path}", path = path.display()))
    }

    pub fn copy_code(&mut self, visit: &Visit, candidate: &FlightCandidate) -> Result<String, String> {
        let replay = self.named_record(visit, candidate)?;
        let code = replay.code()?;
        let words = tr!("Copied: {count} characters", count = code.len());
        self.clipboard.keep(code);
        Ok(words)
    }

    fn named_record(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<Replay, String> {
        let level = self.level_of(visit, candidate)?;
        let mut replay = record(visit, candidate, &self.scores, &level)?;
        let player = self.journal.current();
        if candidate.source == FlightSource::Flown && !player.is_guest() {
            replay.player = Some(player.to_string());
        }
        Ok(replay)
    }

    /// The flight of a code, where it holds. Its length is bounded: two seconds at most.
    pub fn prove_code(&self, visit: &Visit, code: String) -> Result<FlightCandidate, String> {
        let replay = Replay::from_code(&code).map_err(|problem| tr!("No code of a flight: {problem}", problem))?;
        let name = replay.player.clone().unwrap_or_else(|| tr("Somebody").to_owned());
        let about = tr("by its code, proven").to_owned();
        let (score, time) = (Some(replay.score), Some(replay.time));
        let candidate = FlightCandidate { name, about, score, time, source: FlightSource::Code(code) };
        let level = self.level_of(visit, &candidate)?;
        if level_hash(&level) != replay.level_hash {
            let own = pack::of_hash(replay.level_hash, self.library.levels(), self.library.root());
            let name = own.map_or_else(|| replay.level.clone(), |level| level.name.clone());
            if name != visit.level {
                return Err(tr!(
                    "This flight is of level {level}, here are those of level {here}.",
                    level = name,
                    here = visit.level
                ));
            }
        }
        let flown = replay.verify(level, |_| {}).map_err(|error| error.to_string())?;
        flown.map_err(|mismatch| tr!("This flight does not hold: {mismatch}", mismatch))?;
        Ok(candidate)
    }
}
