//! The one place where screens change: every [`Request`] is granted here, and what can fail in granting it lands on a screen that
//! says why.

use super::journal::{Journal, damage_text, rescue_text};
use super::leaderboard::subject;
use super::library::{Library, Refusal};
use super::loading::Loading;
use super::pace;
use super::worker::{Ticket, Worker};
use super::{
    Attempt, Classic, Classics, Clipboard, Editor, Facts, Flight, FlightCandidate, Flights, Flown, FolderWatch, Fresh, Gain, Input,
    Jumper, Key, Lab, Leaderboard, LevelSelect, Menu, Pace, Picture, Players, Prover, Purpose, Request, Rival, SaveScore, Scoring,
    Screen, SettingsPanel, Source, Spectator, TileRun, Visit, Watch, Way, footage, jumper,
};
use crate::classics::jumper::scene::LEADERBOARD;
use crate::game::{Fingerprint, Outcome, Reel, RunResult, TICK_RATE};
use crate::level::Level;
use crate::pack::{self, Installed};
use crate::scores::{Board, Loaded, Name, PATIENCE, Placement, Saved, Score, Scores, ScoresError};
use crate::settings::Settings;
use crate::settings::file::SettingsFile;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;
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
    places: Places,
    pub(super) library: Library,
    pub(super) scores: Scores,
    pub(super) screen: Screen,
    /// How long the screen has been there, s.
    shown_for: f64,
    pace: Pace,
    /// Who plays, and what they have done.
    pub(super) journal: Journal,
    /// What the attempt on the screen, which has ended, brought whoever flew.
    pub(super) ended: Option<String>,
    /// The same of the attempt before that one, which was lost.
    pub(super) lost: Option<String>,
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
    pub(super) watch: Option<FolderWatch>,
    /// The editor, while what is edited is flown.
    pub(super) editing: Option<Box<Editor>>,
    /// The flight that editing began from, and its level's folder.
    pub(super) behind: Option<(Box<Flight>, PathBuf)>,
    /// What is copied to be pasted.
    pub(super) clipboard: Clipboard,
    /// What reads levels.
    pub(super) worker: Worker,
    /// The request that waits for it.
    pub(super) loading: Option<Loading>,
    /// The level that is flown, while it is read again.
    pub(super) reading: Option<Ticket>,
    /// The cards and the list that it is asked for, by the levels' names; the list has none.
    pub(super) asked: BTreeMap<String, Ticket>,
    /// What it has brought for the screen that is to open.
    pub(super) opened: Option<Result<Box<Editor>, String>>,
    pub(super) installed: Option<Result<Installed, Refusal>>,
}

/// A score to be saved as soon as another program lets go of the board.
#[derive(Debug)]
struct Waiting {
    gain: Gain,
    name: Name,
    /// s.
    since: f64,
}

/// The window may be closed without a word to the game.
impl Drop for App {
    fn drop(&mut self) {
        self.close();
    }
}

impl App {
    /// A sitting that begins with the menu, of the last player; levels are read at once, on the screen's thread.
    pub fn new(places: Places) -> Self {
        Self::with_worker(places, Worker::here())
    }

    /// The same; that worker reads the levels.
    pub fn with_worker(places: Places, worker: Worker) -> Self {
        let scores = Scores::new(&places.scores);
        let settings_file = SettingsFile::new(places.root.join("settings.csv"));
        let (library, journal) = (Library::new(&places.root, &places.levels), Journal::new(scores.clone()));
        let (settings, settings_problems) = settings_file.load(whose(journal.current()));
        let mut app = Self {
            places,
            settings,
            settings_file,
            settings_problems,
            screen: menu(&journal, 0),
            library,
            journal,
            scores,
            shown_for: 0.0,
            pace: Pace::default(),
            ended: None,
            lost: None,
            last_level: None,
            menus: 0,
            waiting: None,
            watch: None,
            editing: None,
            behind: None,
            clipboard: Clipboard::default(),
            worker,
            loading: None,
            reading: None,
            asked: BTreeMap::new(),
            opened: None,
            installed: None,
        };
        app.ask_for_next();
        app
    }

    /// One frame; `false` when the player has chosen to quit.
    pub fn update(&mut self, input: &Input, spectator: &mut dyn Spectator) -> bool {
        let input = &self.with_settings(input);
        self.look_at_files(input.frame_time);
        self.take_what_is_brought(spectator);
        self.refresh_view(input.frame_time);
        let waiting = self.wait_for_loading(input);
        let input = waiting.as_ref().unwrap_or(input);
        self.shown_for += input.frame_time;
        self.journal.update(input.frame_time);
        self.save_settings(input.frame_time);
        let asked = self.update_screen(input, spectator);
        self.note_end();
        let asked = asked.or_else(|| input.dropped.first().filter(|path| self.takes(path)).cloned().map(Request::Open));
        match asked {
            Some(Request::Quit) => {
                self.close();
                return false;
            }
            Some(request) => self.grant(request, spectator),
            None => self.save_what_waits(input.frame_time),
        }
        self.fill_in_view();
        self.take_what_is_brought(spectator);
        // Whatever has just opened knows its places, and what is under the pointer, before it is drawn.
        let nothing_more = self.update_screen(&input.without_edges(), spectator);
        debug_assert!(nothing_more.is_none(), "{nothing_more:?} was asked for by no one");
        self.pace.decide(self.screen.motion(input), input.frame_time, self.shown_for);
        true
    }

    /// The input with what the player has set; F11 and Alt+Enter fill the screen, or give it back, and mean nothing else.
    fn with_settings(&mut self, input: &Input) -> Input {
        let alt_enter = input.held.has(Key::Alt) && input.pressed.has(Key::Enter);
        if input.pressed.has(Key::F11) || alt_enter {
            self.set(Settings { fullscreen: !self.settings.fullscreen, ..self.settings });
        }
        let frame_time = pace::passed(input.frame_time);
        let mut input = Input { settings: self.settings, clipboard: self.clipboard.clone(), frame_time, ..input.clone() };
        input.idle = self.pace.note(&input);
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
            Screen::Watch(screen) => screen.update(input, spectator),
            Screen::Flights(screen) => screen.update(input),
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

    /// How much of it its curtain still hides, 0 … 1.
    pub fn veil(&self) -> f64 {
        pace::veil(self.shown_for)
    }

    /// The least time from the last frame to the one with that input, s.
    pub fn interval(&self, input: &Input) -> f64 {
        self.pace.interval(self.screen.motion(input), input)
    }

    /// What becomes of the frame that was updated last.
    pub const fn picture(&self) -> Picture {
        self.pace.picture()
    }

    /// Goes to the screen that is asked for, or to one that says why it cannot be had, with what the worker has brought for it.
    pub(super) fn enter(&mut self, request: Request, spectator: &mut dyn Spectator) {
        let next = match request {
            Request::Menu => self.menu(),
            Request::LevelSelect(purpose) => Screen::LevelSelect(self.level_select(purpose)),
            Request::Play(name) => {
                self.library.close();
                match self.library.load(&name) {
                    Ok(level) => self.flight(Attempt::by_hand(level), spectator),
                    Err(refusal) => self.refused(Purpose::Play, &name, refusal),
                }
            }
            Request::Restart => return self.restart(spectator),
            Request::Edit(name) => self.edit_or_copy(&name),
            Request::EditOriginal(name) => self.edit(&name),
            Request::LeaveEditor => self.leave_editor(spectator),
            Request::Make(make) => match self.make(&make) {
                Ok(()) => return self.after_making(&make, spectator),
                Err(reason) => {
                    if let Screen::LevelSelect(screen) = &mut self.screen {
                        screen.refuse(reason);
                    }
                    return;
                }
            },
            Request::SaveVaried(variation, name) => return self.save_varied(&variation, &name),
            Request::TestFly(level, left) => self.test_fly(level, left, spectator),
            Request::BackToEditor(how) => self.back_to_editor(how),
            Request::Attempt(attempt) => self.flight(attempt, spectator),
            // Nothing comes of an experiment but what was seen.
            Request::Score(attempt, ..) if attempt.level.experiment => self.lab(Some(&attempt.level.name)),
            Request::Score(attempt, result, flown) => self.scoring(attempt, result, flown),
            Request::Flights(visit) => self.flights(visit),
            Request::Watch(visit, candidate) => match self.watch(visit, &candidate, spectator) {
                Ok(screen) => screen,
                Err(problem) => return self.tell_flights(problem, true),
            },
            Request::Race(visit, candidates) => match self.race(&visit, &candidates) {
                Ok(attempt) => self.flight(attempt, spectator),
                Err(problem) => return self.tell_flights(problem, true),
            },
            Request::Keep(visit, candidate) => {
                let kept = self.keep(&visit, &candidate);
                let bad = kept.is_err();
                return self.tell_flights(kept.unwrap_or_else(|problem| problem), bad);
            }
            Request::Export(file) => {
                let told = file.write(&self.places.root.join("exports"));
                match &mut self.screen {
                    Screen::Flight(screen) => screen.tell_of_export(told),
                    Screen::Watch(screen) => screen.tell_of_export(told),
                    _ => {}
                }
                return;
            }
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
            Request::Lab => self.lab(None),
            Request::Experiments(left) => self.lab(Some(&left)),
            Request::Experiment(name) => {
                let folder = self.library.experiment(&name);
                self.open_folder(&folder, spectator)
            }
            Request::Classic(classic) => self.classic(classic),
            Request::Climbed(scene) => Screen::Jumper(Box::new(Jumper::ended(*scene))),
            Request::Settings => Screen::Settings(Box::new(SettingsPanel::new(self.settings, self.settings_problems.clone()))),
            Request::Set(settings) => return self.set(settings),
            Request::Open(path) => self.open(&path, spectator),
            Request::Quit => return,
        };
        self.show(next);
    }

    /// Another screen; what its predecessor asked for nobody waits for any more.
    pub(super) fn show(&mut self, next: Screen) {
        self.asked.values().for_each(|ticket| self.worker.forget(*ticket));
        self.asked.clear();
        (self.screen, self.shown_for) = (next, 0.0);
    }

    /// Takes new settings over, keeps them, and says where that failed.
    fn set(&mut self, settings: Settings) {
        self.settings = settings;
        self.settings_file.set(whose(self.journal.current()), &settings);
        self.save_settings(0.0);
        self.tell_of_settings();
    }

    /// Tries to write down what was set, and says what is wrong with its file once that is known.
    fn save_settings(&mut self, frame_time: f64) {
        if let Some(problems) = self.settings_file.update(frame_time) {
            self.settings_problems = problems;
            self.tell_of_settings();
        }
    }

    fn tell_of_settings(&mut self) {
        let settings = self.settings;
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
        self.ask_for_next();
        menu(&self.journal, self.menus)
    }

    /// Somebody plays from now on, with the settings of theirs.
    fn choose(&mut self, name: Name, named: bool) {
        let closed = self.settings_file.close(PATIENCE);
        self.journal.choose(name, named);
        (self.settings, self.settings_problems) = self.settings_file.load(whose(self.journal.current()));
        self.settings_problems.extend(closed.err().map(|error| error.to_string()));
    }

    /// Writes down what waits, at the end of the sitting.
    fn close(&mut self) {
        let (journal, settings) = (self.journal.close(PATIENCE), self.settings_file.close(PATIENCE));
        let problems = [journal.err().map(|error| error.to_string()), settings.err().map(|error| error.to_string())];
        for problem in problems.into_iter().flatten() {
            // The window is gone, and nothing can be done about a standard error that is closed.
            let _ = writeln!(io::stderr(), "{problem}");
        }
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

    pub(super) fn flight(&mut self, attempt: Attempt, spectator: &mut dyn Spectator) -> Screen {
        let name = attempt.level.name.clone();
        self.last_level = Some(name.clone());
        (self.ended, self.behind) = (None, None);
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

    /// The lab, on the page with an experiment that was left.
    fn lab(&mut self, left: Option<&str>) -> Screen {
        Screen::Lab(Box::new(Lab::new(self.library.charts(), self.library.experiments(), left)))
    }

    /// Whether what is dropped on the window is taken: nothing that is written or edited gets lost by it, and nobody who flies is
    /// interrupted by an archive. Whoever drops a level's folder then wants to fly that.
    fn takes(&self, path: &Path) -> bool {
        match &self.screen {
            Screen::Flight(flight) => self.editing.is_none() && (flight.pause().is_some() || is_of_level(path)),
            Screen::Editor(editor) => !editor.is_unsaved(),
            Screen::SaveScore(_) => false,
            _ => true,
        }
    }

    /// Opens what was dropped: an archive is installed, and the list of levels says what became of it; a level's folder, or a file of one,
    /// is flown where it is.
    fn open(&mut self, path: &Path, spectator: &mut dyn Spectator) -> Screen {
        if is_of_level(path) {
            return self.open_folder(path, spectator);
        }
        let installed = self.installed.take();
        let (heading, lines) =
            match installed.unwrap_or_else(|| pack::install_file(path, self.library.levels(), self.library.root())) {
                Ok(Installed::New(folder)) => {
                    self.last_level = folder.file_name().map(|name| name.to_string_lossy().into_owned());
                    (format!("Installed: {}", self.last_level.as_deref().unwrap_or_default()), vec![folder.display().to_string()])
                }
                Ok(Installed::Already(folder, more)) => {
                    self.last_level = folder.file_name().map(|name| name.to_string_lossy().into_owned());
                    let beside = more.into_iter().map(|file| format!("also in its folder: {file}"));
                    ("This level is there already".to_owned(), [folder.display().to_string()].into_iter().chain(beside).collect())
                }
                Err(problems) => ("This file cannot be opened".to_owned(), problems),
            };
        let mut screen = self.level_select(Purpose::Play);
        screen.show(heading, lines);
        Screen::LevelSelect(screen)
    }

    /// The flights of a level, or why there is no such level.
    fn flights(&mut self, visit: Visit) -> Screen {
        self.last_level = Some(visit.level.clone());
        let level = match self.library.load(&visit.level) {
            Ok(level) => level,
            Err(refusal) => return self.refused(Purpose::Play, &visit.level, refusal),
        };
        let (board, problem) = match self.scores.load_version(&visit.level, Fingerprint::of(&level)) {
            Ok((loaded, _)) => (loaded.board, None),
            Err(error) => (Board::default(), Some(error.to_string())),
        };
        let folder = self.places.levels.join(&visit.level);
        let candidates = footage::candidates(&visit, &folder, &board, self.journal.current());
        let mut screen = Flights::new(visit, subject(&level.name, &level.title), candidates);
        if let Some(problem) = problem {
            screen.tell(problem, true);
        }
        Screen::Flights(Box::new(screen))
    }

    /// The level of a flight that is looked at.
    fn level_of(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<Arc<Level>, String> {
        match (&candidate.source, &visit.flown) {
            // As it was then.
            (Source::Flown, Some(flown)) => Ok(flown.level.clone()),
            _ => self.library.load(&visit.level).map_err(|refusal| refusal.into_iter().next().unwrap_or_default()),
        }
    }

    fn watch(&self, visit: Visit, candidate: &FlightCandidate, spectator: &mut dyn Spectator) -> Result<Screen, String> {
        let level = self.level_of(&visit, candidate)?;
        let title = format!("{} · {}", level.title, candidate.name);
        let reel = match (&candidate.source, &visit.flown) {
            (Source::Flown, Some(flown)) => Reel::flown(flown.history.clone()),
            _ => {
                let replay = footage::record(&visit, candidate, &self.scores, &level)?;
                Reel::new(level, &replay.inputs, replay.tick_rate).map_err(|error| error.to_string())?
            }
        };
        Ok(Screen::Watch(Box::new(Watch::new(visit, title, reel, spectator))))
    }

    /// A flight by hand against those.
    fn race(&self, visit: &Visit, candidates: &[FlightCandidate]) -> Result<Attempt, String> {
        let level = self.library.load(&visit.level).map_err(|refusal| refusal.into_iter().next().unwrap_or_default())?;
        let rival = |candidate: &FlightCandidate| {
            let replay = footage::record(visit, candidate, &self.scores, &level)?;
            if replay.tick_rate != TICK_RATE {
                return Err(format!("{}: flown at {} ticks a second, the game has {TICK_RATE}.", candidate.name, replay.tick_rate));
            }
            Ok(Rival { name: candidate.name.clone(), inputs: Arc::new(replay.inputs) })
        };
        let rivals = candidates.iter().map(rival).collect::<Result<_, String>>()?;
        Ok(Attempt { rivals, ..Attempt::by_hand(level) })
    }

    /// Keeps a flight as a file, and says where.
    fn keep(&self, visit: &Visit, candidate: &FlightCandidate) -> Result<String, String> {
        let level = self.level_of(visit, candidate)?;
        let mut replay = footage::record(visit, candidate, &self.scores, &level)?;
        let player = self.journal.current();
        if candidate.source == Source::Flown && !player.is_guest() {
            replay.player = Some(player.to_string());
        }
        let path = footage::keep(&self.places.root.join("flights"), &visit.level, &candidate.name, &replay)?;
        Ok(format!("Kept as {}", path.display()))
    }

    /// Says on the list of flights what became of something.
    fn tell_flights(&mut self, words: String, bad: bool) {
        if let Screen::Flights(screen) = &mut self.screen {
            screen.tell(words, bad);
        }
    }

    fn scoring(&mut self, attempt: Attempt, result: RunResult, flown: Option<Rc<Flown>>) -> Screen {
        let next = self.library.after(&result.level);
        // Asked for while the next attempt is being flown, it is that of the attempt before.
        let remark = self.ended.get_or_insert_with(|| self.lost.take().unwrap_or_default()).clone();
        let best = self.journal.best(&result.level);
        Screen::Scoring(Box::new(Scoring::new(attempt, result, flown, next, remark).with_best(best)))
    }

    /// Takes note of the attempt on the screen, once, when it has ended. Who watches a recording has flown nothing.
    fn note_end(&mut self) {
        let Screen::Flight(flight) = &self.screen else { return };
        let game = flight.game();
        if flight.is_test() || game.level().experiment {
            return;
        }
        if flight.variation().is_some() {
            self.ended = None;
            return;
        }
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
        let flight = gain.flown.as_ref().map(|flown| &flown.replay);
        let version = gain.flown.as_ref().map(|flown| Fingerprint::of(&flown.level));
        let score = Score { name: &name, points: gain.points, flight, version };
        let Saved { board, placement, rescue } = match self.scores.save_within(Duration::ZERO, &gain.board, score) {
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
        Ok(self.judged(&gain.board, Leaderboard::new(gain.subject, board, Some(fresh), damage, gain.ways)))
    }

    /// A board with a judge of its rows and the level's own flights, where the level loads.
    fn judged(&self, name: &str, screen: Leaderboard) -> Screen {
        let Ok(level) = self.library.load(name) else { return Screen::Leaderboard(screen) };
        let rivals = footage::rivals(&self.library.folder(name), &level);
        let prover = Prover::new(self.scores.clone(), level, screen.board());
        Screen::Leaderboard(screen.with_prover(prover).with_rivals(rivals))
    }

    fn leaderboard(&mut self, name: &str) -> Screen {
        if name == LEADERBOARD {
            let ways = vec![Way { label: "Back", to: Request::Classic(Classic::Jumper) }];
            let shown = self.scores.load(name).map(|loaded| (loaded, 0));
            return self.board(jumper::SUBJECT.to_owned(), name, shown, ways);
        }
        self.last_level = Some(name.to_owned());
        let level = self.library.load(name).ok();
        let title = level.as_ref().map_or(name, |level| &level.title);
        // Of a level that does not load nobody can say which version it is.
        let shown = match &level {
            Some(level) => self.scores.load_version(name, Fingerprint::of(level)),
            None => self.scores.load(name).map(|loaded| (loaded, 0)),
        };
        let back = Request::Leaderboard(name.to_owned());
        let flights =
            Way { label: "Flights", to: Request::Flights(Visit { level: name.to_owned(), flown: None, back: Box::new(back) }) };
        let back = Way { label: "Back", to: Request::LevelSelect(Purpose::Leaderboard) };
        let is_empty = shown.as_ref().is_ok_and(|(loaded, _)| loaded.board.rows().is_empty());
        let play = (is_empty && level.is_some()).then(|| Way { label: "Play", to: Request::Play(name.to_owned()) });
        let ways = play.into_iter().chain(level.iter().map(|_| flights.clone())).chain([back]).collect();
        self.board(subject(name, title), name, shown, ways)
    }

    /// A board with its buttons, and how many other versions of the level have boards of their own; or the list of levels, where it cannot
    /// be read.
    fn board(&mut self, subject: String, name: &str, shown: Result<(Loaded, usize), ScoresError>, ways: Vec<Way>) -> Screen {
        match shown {
            Ok((Loaded { board, damage }, others)) => {
                let damage = (!damage.is_empty()).then(|| damage_text(&damage));
                self.judged(name, Leaderboard::new(subject, board, None, damage, ways).with_other_versions(others))
            }
            Err(error) => {
                let mut screen = self.level_select(Purpose::Leaderboard);
                screen.show(format!("The scores of {subject} cannot be read"), vec![error.to_string()]);
                Screen::LevelSelect(screen)
            }
        }
    }
}

/// Whether that is a folder, or a file as levels have them.
pub(super) fn is_of_level(path: &Path) -> bool {
    path.is_dir() || path.extension().is_some_and(|ending| ["csv", "png"].iter().any(|own| ending.eq_ignore_ascii_case(own)))
}

/// Whose settings of play hold while this one plays: a guest has none of their own.
fn whose(player: &Name) -> &str {
    if player.is_guest() { "" } else { player.as_str() }
}

/// The menu for the present player; the worker brings the level that Play opens.
fn menu(journal: &Journal, seed: u64) -> Screen {
    let (player, trouble) = (journal.current().clone(), journal.trouble().map(str::to_owned));
    Screen::Menu(Box::new(Menu::new(Facts { next: None, player, trouble }, seed)))
}
