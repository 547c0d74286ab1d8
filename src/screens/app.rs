//! The one place where screens change: every [`Request`] is granted here, and what can fail in granting it lands on a screen that
//! says why.

use super::leaderboard::subject;
use super::level_select::Entry;
use super::library::{Library, Refusal};
use super::{
    Attempt, Classic, Classics, Flight, Gain, Input, Jumper, Key, Lab, Leaderboard, LevelSelect, Menu, Purpose, Request, SaveScore,
    Scoring, Screen, SettingsPanel, Spectator, TileRun,
};
use crate::game::{Outcome, RunResult};
use crate::scores::{Damage, Name, PATIENCE, Placement, Saved, Scores, ScoresError};
use crate::settings::Settings;
use crate::settings::file::SettingsFile;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::Duration;

/// What is shown while another program is saving.
const WAITING: &str = "Another game is saving there: waiting for it …";

/// Where the game's files are.
#[derive(Clone, Debug)]
pub struct Places {
    /// Where image paths in level files start from.
    pub root: PathBuf,
    /// A folder a level.
    pub levels: PathBuf,
    /// A file a leaderboard.
    pub scores: PathBuf,
}

/// A sitting: the screen, and what outlasts it.
#[derive(Debug)]
pub struct App {
    library: Library,
    scores: Scores,
    screen: Screen,
    /// How long the screen has been there, s.
    shown_for: f64,
    /// The name that the last score was saved under.
    user: Option<Name>,
    /// The level that was last chosen: where the keyboard is when the list comes back.
    last_level: Option<String>,
    /// Levels completed in this sitting.
    completed: BTreeSet<String>,
    settings: Settings,
    settings_file: SettingsFile,
    /// What is wrong with the settings' file, a line each.
    settings_problems: Vec<String>,
    /// How many menus there have been: each has other balls.
    menus: u64,
    /// A score that another program keeps from being saved.
    waiting: Option<Waiting>,
}

/// A score to be saved as soon as another program lets go of the board.
#[derive(Debug)]
struct Waiting {
    gain: Gain,
    name: Name,
    /// s.
    since: f64,
}

impl App {
    /// A sitting that begins with the menu.
    pub fn new(places: Places) -> Self {
        let settings_file = SettingsFile::new(places.root.join("settings.csv"));
        let (settings, settings_problems) = settings_file.load("");
        let mut app = Self {
            settings,
            settings_file,
            settings_problems,
            library: Library::new(places.root.clone(), places.levels),
            scores: Scores::new(places.scores),
            screen: Screen::Menu(Box::new(Menu::new(None, 0))),
            shown_for: 0.0,
            user: None,
            last_level: None,
            completed: BTreeSet::new(),
            menus: 0,
            waiting: None,
        };
        app.screen = app.menu();
        app
    }

    /// One frame; `false` when the player has chosen to quit.
    pub fn update(&mut self, input: &Input, spectator: &mut dyn Spectator) -> bool {
        let settings = self.with_settings(input);
        let open = self.update_with(&settings, spectator);
        input.answer.set(settings.answer.get());
        open
    }

    fn update_with(&mut self, input: &Input, spectator: &mut dyn Spectator) -> bool {
        self.shown_for += input.frame_time;
        match self.update_screen(input, spectator) {
            Some(Request::Quit) => return false,
            Some(request) => self.grant(request, spectator),
            None => self.save_what_waits(input.frame_time),
        }
        // Whatever has just opened knows its places, and what is under the pointer, before it is drawn.
        let nothing_more = self.update_screen(&input.without_edges(), spectator);
        debug_assert!(nothing_more.is_none(), "{nothing_more:?} was asked for by no one");
        true
    }

    /// The input with what the player has set; F11 and Alt+Enter fill the screen, or give it back, and mean nothing else.
    fn with_settings(&mut self, input: &Input) -> Input {
        let alt_enter = input.held.has(Key::Alt) && input.pressed.has(Key::Enter);
        if input.pressed.has(Key::F11) || alt_enter {
            self.set(Settings { fullscreen: !self.settings.fullscreen, ..self.settings });
        }
        let mut input = Input { settings: self.settings, ..input.clone() };
        input.pressed = input.pressed.without(Key::F11);
        if alt_enter {
            input.pressed = input.pressed.without(Key::Enter);
        }
        input
    }

    fn update_screen(&mut self, input: &Input, spectator: &mut dyn Spectator) -> Option<Request> {
        match &mut self.screen {
            Screen::Menu(screen) => screen.update(input),
            Screen::LevelSelect(screen) => screen.update(input),
            Screen::Flight(screen) => screen.update(input, spectator),
            Screen::Scoring(screen) => screen.update(input),
            Screen::SaveScore(screen) => screen.update(input),
            Screen::Leaderboard(screen) => screen.update(input),
            Screen::Classics(screen) => screen.update(input),
            Screen::Lab(screen) => screen.update(input),
            Screen::TileRun(screen) => screen.update(input),
            Screen::Jumper(screen) => screen.update(input),
            Screen::Pi(screen) => screen.update(input),
            Screen::Settings(screen) => screen.update(input),
        }
    }

    /// What is on the screen.
    pub fn screen(&self) -> &Screen {
        &self.screen
    }

    /// How long it has been there, s.
    pub fn shown_for(&self) -> f64 {
        self.shown_for
    }

    /// Goes to the screen that is asked for, or to one that says why it cannot be had.
    pub fn grant(&mut self, request: Request, spectator: &mut dyn Spectator) {
        let next = match request {
            Request::Menu => self.menu(),
            Request::LevelSelect(purpose) => Screen::LevelSelect(self.level_select(purpose)),
            Request::Play(name) => match self.library.load(&name) {
                Ok(level) => self.flight(Attempt { level, inputs: None }, spectator),
                Err(refusal) => self.refused(Purpose::Play, &name, refusal),
            },
            Request::Attempt(attempt) => self.flight(attempt, spectator),
            Request::Score(attempt, result) => self.scoring(attempt, result),
            Request::SaveScore(gain) => Screen::SaveScore(Box::new(SaveScore::new(gain, self.user.as_ref()))),
            Request::Submit(gain, name) => match self.save(Waiting { gain, name, since: 0.0 }) {
                Some(screen) => screen,
                None => return,
            },
            Request::Leaderboard(level) => self.leaderboard(&level),
            Request::Classics(left) => Screen::Classics(Classics::new(left, None)),
            Request::Lab => Screen::Lab(Box::new(Lab::new(self.library.charts()))),
            Request::Classic(classic) => self.classic(classic),
            Request::Climbed(scene) => Screen::Jumper(Box::new(Jumper::ended(*scene))),
            Request::Settings => Screen::Settings(Box::new(SettingsPanel::new(self.settings, self.settings_problems.clone()))),
            Request::Set(settings) => return self.set(settings),
            Request::Quit => return,
        };
        self.screen = next;
        self.shown_for = 0.0;
    }

    /// Takes new settings over, keeps them, and says where that failed.
    fn set(&mut self, settings: Settings) {
        self.settings = settings;
        self.settings_problems = match self.settings_file.save("", &settings) {
            Ok(()) => self.settings_file.load("").1,
            Err(problem) => vec![problem],
        };
        match &mut self.screen {
            Screen::Settings(screen) => screen.tell(settings, self.settings_problems.clone()),
            Screen::Flight(screen) => screen.tell_of_settings(settings, &self.settings_problems),
            _ => {}
        }
    }

    /// What the player has set.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    fn menu(&mut self) -> Screen {
        self.menus += 1;
        let names = self.library.names();
        let playable = |name: &&String| self.library.load(name).is_ok();
        let open = names.iter().filter(|name| !self.is_completed(name)).find(playable);
        let next = open.or_else(|| names.iter().find(playable));
        Screen::Menu(Box::new(Menu::new(next.cloned(), self.menus)))
    }

    fn level_select(&self, purpose: Purpose) -> LevelSelect {
        let entry = |name: String| Entry {
            title: self.library.load(&name).map(|level| level.title.clone()),
            completed: self.is_completed(&name),
            name,
        };
        let mut screen = LevelSelect::new(purpose, self.library.names().into_iter().map(entry).collect());
        if let Some(name) = &self.last_level {
            screen.turn_to_level(name);
        }
        screen
    }

    fn flight(&mut self, attempt: Attempt, spectator: &mut dyn Spectator) -> Screen {
        let name = attempt.level.name.clone();
        self.last_level = Some(name.clone());
        match Flight::new(attempt, spectator) {
            Ok(mut flight) => {
                flight.tell_of_settings(self.settings, &self.settings_problems);
                Screen::Flight(Box::new(flight))
            }
            Err(error) => self.refused(Purpose::Play, &name, vec![error.to_string()]),
        }
    }

    /// The list of levels with what is wrong with one of them.
    fn refused(&self, purpose: Purpose, name: &str, refusal: Refusal) -> Screen {
        let mut screen = self.level_select(purpose);
        screen.show_problems(name, refusal);
        Screen::LevelSelect(screen)
    }

    fn scoring(&mut self, attempt: Attempt, result: RunResult) -> Screen {
        if result.outcome == Outcome::Completed {
            self.completed.insert(result.level.clone());
        }
        let next = self.library.after(&result.level);
        Screen::Scoring(Box::new(Scoring::new(attempt, result, next)))
    }

    /// A classic at its beginning, or the list of them with what is wrong.
    fn classic(&self, classic: Classic) -> Screen {
        match classic {
            Classic::TileRun => match self.library.tile_run() {
                Ok((map, commands)) => Screen::TileRun(Box::new(TileRun::new(map, commands))),
                Err(problem) => Screen::Classics(Classics::new(Some(classic), Some(problem))),
            },
            Classic::Jumper => Screen::Jumper(Box::default()),
            Classic::Pi => Screen::Pi(Box::default()),
        }
    }

    /// Tries again to save the score that waits, if the player still does; no frame is spent on waiting.
    fn save_what_waits(&mut self, frame_time: f64) {
        let still = |waiting: &Waiting| matches!(&self.screen, Screen::SaveScore(screen) if screen.text() == waiting.name.as_str());
        let Some(mut waiting) = self.waiting.take().filter(still) else { return };
        waiting.since += frame_time;
        if let Some(screen) = self.save(waiting) {
            self.screen = screen;
            self.shown_for = 0.0;
        }
    }

    /// Saves a score; `None` when that failed or has to wait, which the screen for the name then says.
    fn save(&mut self, waiting: Waiting) -> Option<Screen> {
        let Waiting { gain, name, since } = waiting;
        match self.scores.save_within(Duration::ZERO, &gain.board, &name, gain.points) {
            Ok(Saved { board, placement, rescue }) => {
                let damage = rescue.map(|rescue| {
                    format!("{} The damaged file was kept as {}.", damage_text(&rescue.damage), rescue.kept.display())
                });
                let remark = match placement {
                    Placement::Kept { best, .. } => Some(format!("Your best of {best} points stays.")),
                    Placement::New { .. } | Placement::Raised { .. } => None,
                };
                let screen = Leaderboard::new(&gain.board, board, Some(&name), damage, remark);
                self.user = Some(name);
                Some(Screen::Leaderboard(screen))
            }
            Err(error) => {
                let error = match error {
                    ScoresError::Busy(_) if since < PATIENCE.as_secs_f64() => {
                        self.waiting = Some(Waiting { gain, name, since });
                        WAITING.to_owned()
                    }
                    error => error.to_string(),
                };
                if let Screen::SaveScore(screen) = &mut self.screen {
                    screen.refuse(error);
                }
                None
            }
        }
    }

    fn leaderboard(&mut self, level: &str) -> Screen {
        self.last_level = Some(level.to_owned());
        match self.scores.load(level) {
            Ok(loaded) => {
                let damage = (!loaded.damage.is_empty()).then(|| damage_text(&loaded.damage));
                Screen::Leaderboard(Leaderboard::new(level, loaded.board, None, damage, None))
            }
            Err(error) => {
                let mut screen = self.level_select(Purpose::Leaderboard);
                screen.show(format!("The scores of {} cannot be read", subject(level)), vec![error.to_string()]);
                Screen::LevelSelect(screen)
            }
        }
    }

    /// Whether someone has a score there, or it was completed in this sitting.
    fn is_completed(&self, name: &str) -> bool {
        let has_scores = || self.scores.load(name).is_ok_and(|loaded| !loaded.board.rows().is_empty());
        self.completed.contains(name) || has_scores()
    }
}

/// What is wrong with a scores file, in one line.
fn damage_text(damage: &[Damage]) -> String {
    match damage {
        [] => String::new(),
        [one] => format!("{one}."),
        [first, rest @ ..] => format!("{first} (and {} more).", rest.len()),
    }
}
