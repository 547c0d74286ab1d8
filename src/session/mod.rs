//! What outlasts a screen: who plays, the levels and the worker that reads them, recorded flights, and the files that are written. No
//! screen is known here.

pub mod folder_watch;
pub mod journal;
pub mod library;
pub mod recordings;
pub mod worker;

use crate::game::{Game, Outcome};
use crate::scores::{Name, Placement, Results, Saved, Score, Scores, unsaved_points};
use crate::settings::{Settings, file::SettingsFile};
use crate::ui::input::Clipboard;
use crate::words::{self, tr};
use journal::{Answers, Journal};
use library::{Flown, Library};
use std::{collections::BTreeMap, path::PathBuf, rc::Rc};
use worker::{Brought, Errand, Worker};

const RECORDING: &str = "A recording: what was not flown by hand is not saved.";

#[derive(Clone, Debug)]
pub struct Gain {
    /// The leaderboard: that of a level, by its name, or that of the jumper.
    pub board: String,
    pub subject: String,
    pub points: i64,
    pub flown: Option<Rc<Flown>>,
}

#[derive(Clone, Debug)]
pub struct Places {
    /// Where image paths in level files start from.
    pub root: PathBuf,
    /// A folder a level.
    pub levels: PathBuf,
    /// A file a leaderboard.
    pub scores: PathBuf,
    pub settings: PathBuf,
}

#[derive(Debug)]
pub struct Session {
    pub places: Places,
    pub library: Library,
    pub worker: Worker,
    /// What it has brought, other than a level, for the screen that is to open.
    pub brought: Option<Brought>,
    pub scores: Scores,
    pub journal: Journal,
    /// The best scores that no leaderboard has yet, and whose they are: a guest's wait for a name, the others for a file that can be written.
    unsaved: Vec<(Name, Gain)>,
    pub answers: Answers,
    pub settings: Settings,
    pub settings_file: SettingsFile,
    /// What is wrong with the settings' file, a line each.
    pub settings_problems: Vec<String>,
    /// Losses since the game was opened, by the level's name.
    pub losses: BTreeMap<String, u32>,
    /// The level that was last chosen: where the keyboard is when the list comes back.
    pub last_level: Option<String>,
    /// The level that was flown last: it needs no introduction.
    pub last_flown: Option<String>,
    /// How many menus there have been: each has other balls.
    pub menus: u64,
    pub clipboard: Clipboard,
    /// Since 1970-01-01, 0 UTC, s: the time of an answer.
    pub now: f64,
}

impl Session {
    pub fn new(places: Places, worker: Worker) -> Self {
        let scores = Scores::new(&places.scores);
        let settings_file = SettingsFile::new(&places.settings);
        let journal = Journal::new(scores.clone());
        let loaded = settings_file.load(whose(journal.current()));
        words::speak(loaded.0.spoken());
        // Problems are worded as they are found: once more in that language.
        let (settings, settings_problems) = if loaded.1.is_empty() { loaded } else { settings_file.load(whose(journal.current())) };
        Self {
            library: Library::new(&places.root, &places.levels),
            answers: Answers::new(Results::new(places.root.join("results"))),
            places,
            worker,
            brought: None,
            scores,
            journal,
            unsaved: Vec::new(),
            settings,
            settings_file,
            settings_problems,
            losses: BTreeMap::new(),
            last_level: None,
            last_flown: None,
            menus: 0,
            clipboard: Clipboard::default(),
            now: 0.0,
        }
    }

    pub fn set(&mut self, settings: Settings) {
        self.settings = settings;
        words::speak(settings.spoken());
        self.settings_problems = self.settings_file.set(whose(self.journal.current()), &settings);
    }

    /// Somebody plays from now on, with the settings of theirs.
    pub fn choose(&mut self, name: Name, named: bool) {
        self.answers.sheets.clear();
        let closed = self.settings_file.close();
        if named && self.journal.current().is_guest() {
            let nameless = self.unsaved.iter_mut().filter(|(whose, _)| whose.is_guest());
            nameless.for_each(|(whose, _)| whose.clone_from(&name));
        }
        self.journal.choose(name, named);
        // What cannot be written yet waits for the menu.
        let _ = self.write_scores();
        (self.settings, self.settings_problems) = self.settings_file.load(whose(self.journal.current()));
        words::speak(self.settings.spoken());
        self.settings_problems.extend(closed.err().map(|error| error.to_string()));
    }

    pub fn level_errand(&self, name: &str) -> Errand {
        Errand::Level(self.library.folder(name), self.library.root().to_path_buf())
    }

    pub fn prepare(&mut self, brought: Brought) {
        match brought {
            Brought::Level(folder, level) => self.library.prepared = Some((folder, level)),
            other => self.brought = Some(other),
        }
    }

    pub fn forget_prepared(&mut self) {
        (self.library.prepared, self.brought) = (None, None);
    }

    /// Takes note of an attempt that has ended; what it brought the player, in words.
    pub fn note_end(&mut self, game: &Game, by_hand: bool, assisted: bool) -> String {
        if game.outcome() == Outcome::Failed {
            self.note_loss(&game.level().name);
        }
        if by_hand { self.journal.note(game, assisted) } else { tr(RECORDING).to_owned() }
    }

    pub fn note_loss(&mut self, level: &str) {
        *self.losses.entry(level.to_owned()).or_default() += 1;
    }

    /// Saves a score under the player's name; what is to be said of it. What cannot be saved, or is a guest's, waits.
    /// Errors: why it cannot be saved yet, in words.
    pub fn save(&mut self, gain: Gain) -> Result<Option<String>, String> {
        let name = self.journal.current().clone();
        let saved = if name.is_guest() { Ok(None) } else { write_score(&self.scores, &name, &gain) };
        if saved.is_ok() && !name.is_guest() {
            return saved;
        }
        let same = |(whose, other): &&(Name, Gain)| *whose == name && other.board == gain.board;
        if self.unsaved.iter().find(same).is_none_or(|(_, best)| best.points < gain.points) {
            self.unsaved.retain(|other| !same(&other));
            self.unsaved.push((name, gain));
        }
        saved
    }

    /// Tries once more to save the scores that wait; why each still does.
    pub fn write_scores(&mut self) -> Vec<String> {
        let (mut problems, scores) = (Vec::new(), &self.scores);
        self.unsaved.retain(|(name, gain)| {
            name.is_guest() || write_score(scores, name, gain).map_err(|problem| problems.push(problem)).is_err()
        });
        problems
    }

    /// The points of a guest, in words: they are lost with the window.
    pub fn nameless(&self) -> impl Iterator<Item = (&str, String)> {
        let guests = self.unsaved.iter().filter(|(name, _)| name.is_guest());
        guests.map(|(_, gain)| (&*gain.board, unsaved_points(gain.points, &gain.subject)))
    }

    /// Writes down what waits, as far as that can be done; the rest in words, a line each.
    pub fn write_all(&mut self) -> Vec<String> {
        let journal = self.journal.close().err().map(|error| error.to_string());
        let settings = self.settings_file.close().err().map(|error| error.to_string());
        journal.into_iter().chain(settings).chain(self.write_scores()).chain(self.answers.close()).collect()
    }

    /// Whether all is written. Nothing is tried.
    pub fn is_written(&self) -> bool {
        self.unsaved.is_empty() && self.journal.is_written() && !self.settings_file.waits() && self.answers.is_written()
    }
}

fn write_score(scores: &Scores, name: &Name, gain: &Gain) -> Result<Option<String>, String> {
    let score = Score { name, points: gain.points, flight: gain.flown.as_ref().map(|flown| &flown.replay) };
    let Saved { placement, .. } = scores.save_with_flight(&gain.board, score).map_err(|error| error.to_string())?;
    Ok(match placement {
        Placement::Kept { best, .. } => Some(tr!("Your best of {best} points stays.", best)),
        Placement::New { .. } | Placement::Raised { .. } => None,
    })
}

/// Whose settings of play hold while this one plays: a guest has none of their own.
fn whose(player: &Name) -> &str {
    if player.is_guest() { "" } else { player.as_str() }
}
