//! The one place where screens change: every [`Request`] is granted here, and what can fail in granting it lands on a screen that
//! says why.

use super::journal::{Journal, damage_text, rescue_text};
use super::leaderboard::subject;
use super::library::{Library, Refusal};
use super::{
    Attempt, Classic, Classics, Editor, Facts, Flight, Fresh, Gain, Input, Jumper, Key, Lab, Leaderboard, LevelSelect, Menu,
    Players, Purpose, Request, SaveScore, Scoring, Screen, SettingsPanel, Spectator, TileRun, Watch, Way, jumper,
};
use crate::classics::jumper::scene::LEADERBOARD;
use crate::game::{Medals, Outcome, RunResult};
use crate::level::Awards;
use crate::scores::{Board, Name, PATIENCE, Placement, Saved, Scores, ScoresError};
use crate::settings::Settings;
use crate::settings::file::SettingsFile;
use std::path::PathBuf;
use std::time::Duration;

/// What is shown while another program is saving.
const WAITING: &str = "Another game is saving there: waiting for it …";

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
}

/// A sitting: the screen, and what outlasts it.
#[derive(Debug)]
pub struct App {
    pub(super) library: Library,
    scores: Scores,
    pub(super) screen: Screen,
    /// How long the screen has been there, s.
    shown_for: f64,
    /// Who plays, and what they have done.
    pub(super) journal: Journal,
    /// What the attempt on the screen, which has ended, brought whoever flew.
    pub(super) ended: Option<String>,
    /// The level that was last chosen: where the keyboard is when the list comes back.
    pub(super) last_level: Option<String>,
    pub(super) settings: Settings,
    settings_file: SettingsFile,
    /// What is wrong with the settings' file, a line each.
    settings_problems: Vec<String>,
    /// How many menus there have been: each has other balls.
    menus: u64,
    /// A score that another program keeps from being saved.
    waiting: Option<Waiting>,
    /// The files of the level that is flown.
    pub(super) watch: Option<Watch>,
    /// The editor, while what is edited is flown.
    pub(super) editing: Option<Box<Editor>>,
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
    /// A sitting that begins with the menu, of whoever played here last.
    pub fn new(places: Places) -> Self {
        let scores = Scores::new(places.scores);
        let settings_file = SettingsFile::new(places.root.join("settings.csv"));
        let (library, journal) = (Library::new(places.root, places.levels), Journal::new(scores.clone()));
        let (settings, settings_problems) = settings_file.load(whose(journal.current()));
        Self {
            settings,
            settings_file,
            settings_problems,
            screen: menu(&library, &journal, 0),
            library,
            journal,
            scores,
            shown_for: 0.0,
            ended: None,
            last_level: None,
            menus: 0,
            waiting: None,
            watch: None,
            editing: None,
        }
    }

    /// One frame; `false` when the player has chosen to quit.
    pub fn update(&mut self, input: &Input, spectator: &mut dyn Spectator) -> bool {
        let input = &self.with_settings(input);
        if let Some(path) = &input.dropped {
            self.open_dropped(path, spectator);
        }
        self.look_at_files(input.frame_time, spectator);
        self.refresh_view(input.frame_time);
        self.shown_for += input.frame_time;
        self.journal.update(input.frame_time);
        let asked = self.update_screen(input, spectator);
        self.note_end();
        match asked {
            Some(Request::Quit) => {
                self.journal.close();
                return false;
            }
            Some(request) => self.grant(request, spectator),
            None => self.save_what_waits(input.frame_time),
        }
        self.fill_in_view();
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
            Screen::Editor(screen) => screen.update(input),
            Screen::Scoring(screen) => screen.update(input),
            Screen::SaveScore(screen) => screen.update(input),
            Screen::Leaderboard(screen) => screen.update(input),
            Screen::Players(screen) => screen.update(input),
            Screen::Credits(screen) => screen.update(input),
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

    /// Who plays.
    pub fn player(&self) -> &Name {
        self.journal.current()
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
            Request::Play(name) => {
                self.library.close();
                match self.library.load(&name) {
                    Ok(level) => self.flight(Attempt { level, inputs: None }, spectator),
                    Err(refusal) => self.refused(Purpose::Play, &name, refusal),
                }
            }
            Request::Restart => return self.restart(spectator),
            Request::Edit(name) => self.edit(&name),
            Request::Make(make) => match self.make(&make) {
                Ok(screen) => screen,
                Err(reason) => {
                    if let Screen::LevelSelect(screen) = &mut self.screen {
                        screen.refuse(reason);
                    }
                    return;
                }
            },
            Request::TestFly(level) => self.test_fly(level, spectator),
            Request::BackToEditor(how) => self.back_to_editor(how),
            Request::Attempt(attempt) => self.flight(attempt, spectator),
            Request::Score(attempt, result) => self.scoring(attempt, result),
            Request::SaveScore(gain) => self.save_score(gain),
            Request::Submit(gain, name) => match self.save(Waiting { gain, name, since: 0.0 }) {
                Ok(saved) => saved,
                Err(reason) => return self.refuse(reason),
            },
            Request::Players => self.players(),
            Request::Choose(name, named) => {
                self.choose(name, named);
                self.menu()
            }
            Request::Credits => Screen::Credits(Box::default()),
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
        let player = whose(self.journal.current());
        self.settings_problems = match self.settings_file.save(player, &settings) {
            Ok(()) => self.settings_file.load(player).1,
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
        menu(&self.library, &self.journal, self.menus)
    }

    /// Somebody plays from now on, with the settings of theirs.
    fn choose(&mut self, name: Name, named: bool) {
        self.journal.choose(name, named);
        (self.settings, self.settings_problems) = self.settings_file.load(whose(self.journal.current()));
    }

    fn players(&mut self) -> Screen {
        self.journal.read();
        let trouble = self.journal.trouble().map(str::to_owned);
        Screen::Players(Box::new(Players::new(self.journal.players(), self.journal.current(), trouble)))
    }

    pub(super) fn level_select(&mut self, purpose: Purpose) -> LevelSelect {
        self.library.close();
        let mut screen = LevelSelect::new(purpose, self.library.names());
        if let Some(name) = &self.last_level {
            screen.turn_to_level(name);
        }
        screen
    }

    fn flight(&mut self, attempt: Attempt, spectator: &mut dyn Spectator) -> Screen {
        let name = attempt.level.name.clone();
        self.last_level = Some(name.clone());
        self.ended = None;
        self.watch = Some(self.library.watch(&attempt.level));
        match Flight::new(attempt, spectator) {
            Ok(mut flight) => {
                flight.tell_of_settings(self.settings, &self.settings_problems);
                Screen::Flight(Box::new(flight))
            }
            Err(error) => self.refused(Purpose::Play, &name, vec![error.to_string()]),
        }
    }

    /// The list of levels with what is wrong with one of them.
    fn refused(&mut self, purpose: Purpose, name: &str, refusal: Refusal) -> Screen {
        let mut screen = self.level_select(purpose);
        screen.show_problems(name, refusal);
        Screen::LevelSelect(screen)
    }

    fn scoring(&mut self, attempt: Attempt, result: RunResult) -> Screen {
        let next = self.library.after(&result.level);
        let remark = self.ended.clone().unwrap_or_default();
        Screen::Scoring(Box::new(Scoring::new(attempt, result, next, remark)))
    }

    /// Takes note of the attempt on the screen, once, when it has ended. Who watches a recording has flown nothing.
    fn note_end(&mut self) {
        let Screen::Flight(flight) = &self.screen else { return };
        if self.editing.is_some() {
            return;
        }
        let game = flight.game();
        if game.outcome() == Outcome::Running {
            self.ended = None;
        } else if self.ended.is_none() {
            self.ended =
                Some(if flight.is_by_hand() { self.journal.note(game, flight.is_assisted()) } else { RECORDING.to_owned() });
        }
    }

    /// Saves a score under the name of whoever plays, or asks for the name of who has none.
    fn save_score(&mut self, gain: Gain) -> Screen {
        let name = self.journal.current().clone();
        if name.is_guest() {
            return Screen::SaveScore(Box::new(SaveScore::new(gain, None)));
        }
        self.save(Waiting { gain: gain.clone(), name: name.clone(), since: 0.0 }).unwrap_or_else(|reason| {
            let mut screen = SaveScore::new(gain, Some(&name));
            screen.refuse(reason);
            Screen::SaveScore(Box::new(screen))
        })
    }

    /// Says why a score could not be saved, where its name is asked for.
    fn refuse(&mut self, reason: String) {
        if let Screen::SaveScore(screen) = &mut self.screen {
            screen.refuse(reason);
        }
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
        match self.save(waiting) {
            Ok(saved) => (self.screen, self.shown_for) = (saved, 0.0),
            Err(reason) => self.refuse(reason),
        }
    }

    /// Saves a score; the leaderboard then, or why that failed or has to wait.
    fn save(&mut self, waiting: Waiting) -> Result<Screen, String> {
        let Waiting { gain, name, since } = waiting;
        let Saved { board, placement, rescue } = match self.scores.save_within(Duration::ZERO, &gain.board, &name, gain.points) {
            Ok(saved) => saved,
            Err(ScoresError::Busy(_)) if since < PATIENCE.as_secs_f64() => {
                self.waiting = Some(Waiting { gain, name, since });
                return Err(WAITING.to_owned());
            }
            Err(error) => return Err(error.to_string()),
        };
        let damage = rescue.map(|rescue| rescue_text(&rescue));
        let remark = match placement {
            Placement::Kept { best, .. } => Some(format!("Your best of {best} points stays.")),
            Placement::New { .. } | Placement::Raised { .. } => None,
        };
        if name != *self.journal.current() {
            self.choose(name.clone(), true);
        }
        let fresh = Fresh { name, remark };
        let medals = self.medals(&gain.board, &board);
        Ok(Screen::Leaderboard(Leaderboard::new(gain.subject, board, Some(fresh), damage, gain.ways).with_medals(medals)))
    }

    /// What a level has brought each of those on its board.
    fn medals(&self, level: &str, board: &Board) -> Vec<Medals> {
        let awards = self.library.load(level).map_or_else(|_| Awards::default(), |level| level.awards);
        let player = |name: &Name| self.journal.players().get(name);
        let medals = |name: &Name| player(name).map(|player| player.medals(level).with_best(&awards, player.best(level)));
        board.rows().iter().map(|row| medals(&row.name).unwrap_or_default()).collect()
    }

    fn leaderboard(&mut self, level: &str) -> Screen {
        let (subject, back) = if level == LEADERBOARD {
            (jumper::SUBJECT.to_owned(), Request::Classic(Classic::Jumper))
        } else {
            self.last_level = Some(level.to_owned());
            let title = self.library.load(level).map_or_else(|_| level.to_owned(), |level| level.title.clone());
            (subject(level, &title), Request::LevelSelect(Purpose::Leaderboard))
        };
        match self.scores.load(level) {
            Ok(loaded) => {
                let damage = (!loaded.damage.is_empty()).then(|| damage_text(&loaded.damage));
                let ways = vec![Way { label: "Back", to: back }];
                let medals = self.medals(level, &loaded.board);
                Screen::Leaderboard(Leaderboard::new(subject, loaded.board, None, damage, ways).with_medals(medals))
            }
            Err(error) => {
                let mut screen = self.level_select(Purpose::Leaderboard);
                screen.show(format!("The scores of {subject} cannot be read"), vec![error.to_string()]);
                Screen::LevelSelect(screen)
            }
        }
    }
}

/// Whose settings of play hold while this one plays: a guest has none of their own.
fn whose(player: &Name) -> &str {
    if player.is_guest() { "" } else { player.as_str() }
}

/// The menu for whoever plays; Play opens the first level that can be played and that they have not done.
fn menu(library: &Library, journal: &Journal, seed: u64) -> Screen {
    let names = library.names();
    let playable = |name: &String| Some((name.clone(), library.load(name).ok()?.title.clone()));
    let open = names.iter().filter(|name| journal.medals(name).medal.is_none()).find_map(playable);
    let next = open.or_else(|| names.iter().find_map(playable));
    let (player, trouble) = (journal.current().clone(), journal.trouble().map(str::to_owned));
    Screen::Menu(Box::new(Menu::new(Facts { next, player, trouble }, seed)))
}
