//! What outlasts a screen: who plays, the levels and the worker that reads them, recorded flights, and the files that are written. No
//! screen is known here.

pub mod answers;
pub mod attempt;
pub mod folder_watch;
pub mod journal;
pub mod library;
pub mod recordings;
pub mod worker;

use crate::game::{Game, Outcome};
use crate::scores::{Name, Placement, Results, Saved, Score, Scores};
use crate::settings::Settings;
use crate::settings::file::SettingsFile;
use crate::ui::input::Clipboard;
use crate::words::{self, tr};
use answers::Answers;
use attempt::Flown;
use journal::Journal;
use library::Library;
use std::collections::BTreeMap;
use std::path::PathBuf;
use worker::{Brought, Errand, Worker};

/// What is said of a flight that was watched.
const RECORDING: &str = "A recording: what was not flown by hand is not saved.";

/// Where the game's files are.
#[derive(Clone, Debug)]
pub struct Places {
    /// Where image paths in level files start from.
    pub root: PathBuf,
    /// A folder a level.
    pub levels: PathBuf,
    /// A file a leaderboard.
    pub scores: PathBuf,
    /// The file of settings.
    pub settings: PathBuf,
}

#[derive(Debug)]
pub struct Session {
    pub places: Places,
    pub library: Library,
    /// What reads levels.
    pub worker: Worker,
    /// What it has brought, other than a level, for the screen that is to open.
    pub brought: Option<Brought>,
    pub scores: Scores,
    /// Who plays, and what they have done.
    pub journal: Journal,
    pub answers: Answers,
    pub settings: Settings,
    pub settings_file: SettingsFile,
    /// What is wrong with the settings' file, a line each.
    pub settings_problems: Vec<String>,
    /// Losses since the game was opened, by the level's name.
    pub losses: BTreeMap<String, u32>,
    /// The level that was last chosen: where the keyboard is when the list comes back.
    pub last_level: Option<String>,
    /// How many menus there have been: each has other balls.
    pub menus: u64,
    /// What is copied to be pasted.
    pub clipboard: Clipboard,
    /// Since 1970-01-01, 0 UTC, s: the time of an answer.
    pub now: f64,
}

impl Session {
    /// The last player's.
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
            settings,
            settings_file,
            settings_problems,
            losses: BTreeMap::new(),
            last_level: None,
            menus: 0,
            clipboard: Clipboard::default(),
            now: 0.0,
        }
    }

    /// Takes new settings over and saves them.
    pub fn set(&mut self, settings: Settings) {
        self.settings = settings;
        words::speak(settings.spoken());
        self.settings_problems = self.settings_file.set(whose(self.journal.current()), &settings);
    }

    /// Somebody plays from now on, with the settings of theirs.
    pub fn choose(&mut self, name: Name, named: bool) {
        self.answers.sheets.clear();
        let closed = self.settings_file.close();
        self.journal.choose(name, named);
        (self.settings, self.settings_problems) = self.settings_file.load(whose(self.journal.current()));
        words::speak(self.settings.spoken());
        self.settings_problems.extend(closed.err().map(|error| error.to_string()));
    }

    /// The reading of a level, by its name.
    pub fn level_errand(&self, name: &str) -> Errand {
        Errand::Level(self.library.folder(name), self.library.root().to_path_buf())
    }

    /// Holds ready what the worker has read, for the screen that opens.
    pub fn prepare(&mut self, brought: Brought) {
        match brought {
            Brought::Level(folder, level) => self.library.prepare(folder, level),
            other => self.brought = Some(other),
        }
    }

    /// Every file is read again.
    pub fn forget_prepared(&mut self) {
        self.library.forget_prepared();
        self.brought = None;
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

    /// Saves a score under a name, who plays from then on; what is to be said of it besides its row.
    ///
    /// # Errors
    /// Why it cannot be saved, in words.
    pub fn save_score(&mut self, board: &str, points: i64, flown: Option<&Flown>, name: &Name) -> Result<Option<String>, String> {
        let score = Score { name, points, flight: flown.map(|flown| &flown.replay) };
        let Saved { placement, .. } = self.scores.save_with_flight(board, score).map_err(|error| error.to_string())?;
        if *name != *self.journal.current() {
            self.choose(name.clone(), true);
        }
        Ok(match placement {
            Placement::Kept { best, .. } => Some(tr!("Your best of {best} points stays.", best)),
            Placement::New { .. } | Placement::Raised { .. } => None,
        })
    }

    /// Writes down what waits, as far as that can be done; the rest in words, a line each.
    pub fn write_all(&mut self) -> Vec<String> {
        let journal = self.journal.close().err().map(|error| error.to_string());
        let settings = self.settings_file.close().err().map(|error| error.to_string());
        journal.into_iter().chain(settings).chain(self.answers.close()).collect()
    }

    /// Whether all is written. Nothing is tried.
    pub fn is_written(&self) -> bool {
        self.journal.is_written() && !self.settings_file.waits() && self.answers.is_written()
    }
}

/// Whose settings of play hold while this one plays: a guest has none of their own.
fn whose(player: &Name) -> &str {
    if player.is_guest() { "" } else { player.as_str() }
}
