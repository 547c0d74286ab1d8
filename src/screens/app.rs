//! A sitting: the screen that is shown, what outlasts it, and how a frame goes.

use crate::draw::Canvas;
use crate::draw::layout::Frame;
use crate::game::Outcome;
use crate::level::document::Opened;
use crate::pack::Installed;
use crate::scores::{Name, ResultRow, Results, Scores};
use crate::screens::editor::Editor;
use crate::screens::flight::{Flight, Worksheet};
use crate::screens::loading::Loading;
use crate::screens::menu::{Menu, MenuFacts};
use crate::screens::screen::{Request, Screen};
use crate::session::folder_watch::FolderWatch;
use crate::session::journal::Journal;
use crate::session::library::{Library, Refusal};
use crate::session::worker::{Ticket, Worker};
use crate::settings::file::SettingsFile;
use crate::settings::{Key, Keys, Settings};
use crate::ui::input::{Clipboard, Input, Stale};
use crate::ui::pace::{self, Pace, Picture};
use crate::ui::{Memory, PassInput, Spectator, Widget};
use crate::words::{self, tr};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::PathBuf;

/// What is said of a flight that was watched.
const RECORDING: &str = "A recording: what was not flown by hand is not saved.";
/// The most passes that show a frame: the focus has found its place before.
const MOST_PASSES: usize = 3;

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

/// A sitting: the screen, and what outlasts it.
#[derive(Debug)]
pub struct App {
    pub(super) places: Places,
    pub(super) library: Library,
    pub(super) scores: Scores,
    /// The pupils' answers.
    pub(super) results: Results,
    pub(super) screen: Box<dyn Screen>,
    /// What its widgets remember.
    memory: Memory,
    /// The keys that another screen or another window was given.
    stale: Stale,
    /// What it has shown.
    canvas: Canvas,
    /// Physical pixels a logical one.
    pub dpi: f32,
    /// How long the screen has been there, s.
    shown_for: f64,
    pace: Pace,
    /// Who plays, and what they have done.
    pub(super) journal: Journal,
    /// What the attempt on the screen, which has ended, brought the player.
    pub(super) ended: Option<String>,
    /// The same of the attempt before that one, which was lost.
    pub(super) lost: Option<String>,
    /// Losses of this sitting, by the level's name.
    pub(super) losses: BTreeMap<String, u32>,
    /// The level that was last chosen: where the keyboard is when the list comes back.
    pub(super) last_level: Option<String>,
    pub(super) settings: Settings,
    pub(super) settings_file: SettingsFile,
    /// What is wrong with the settings' file, a line each.
    pub(super) settings_problems: Vec<String>,
    /// How many menus there have been: each has other balls.
    pub(super) menus: u64,
    /// The sheets of experiments as they were left, by folder.
    pub(super) sheets: BTreeMap<String, Worksheet>,
    /// Answers to experiments whose files cannot be written.
    pub(super) unsaved_answers: Vec<ResultRow>,
    /// The score that was on the screen before and can still be saved, in words.
    pub(super) unsaved_score: Option<String>,
    /// The files of the level that is flown.
    pub(super) watch: Option<FolderWatch>,
    /// The editor, while what is edited is flown.
    pub(super) editing: Option<Box<Editor>>,
    /// The flight that editing began from, and its level's folder.
    pub(super) behind: Option<(Box<Flight>, PathBuf)>,
    /// What is copied to be pasted.
    pub clipboard: Clipboard,
    /// Since 1970-01-01, 0 UTC, s: the time of an answer.
    pub now: f64,
    /// What reads levels.
    pub(super) worker: Worker,
    /// The request that waits for it.
    pub(super) loading: Option<Loading>,
    /// The level that is flown, while it is read again.
    pub(super) reading: Option<Ticket>,
    /// The cards and the list that it is asked for, by the levels' names; the list has none.
    pub(super) asked: BTreeMap<String, Ticket>,
    /// What it has brought for the screen that is to open.
    pub(super) opened: Option<Result<Box<Opened>, String>>,
    pub(super) installed: Option<Result<Installed, Refusal>>,
}

/// The program may end without a question.
impl Drop for App {
    fn drop(&mut self) {
        for problem in self.write_all() {
            // The window is gone, and nothing can be done about a standard error that is closed.
            let _ = writeln!(io::stderr(), "{problem}");
        }
    }
}

impl App {
    /// A sitting that begins with the menu, of the last player; levels are read at once, on the screen's thread.
    pub fn new(places: Places) -> Self {
        Self::with_worker(places, Worker::here())
    }

    /// The same, with a worker that reads the levels.
    pub fn with_worker(places: Places, worker: Worker) -> Self {
        let scores = Scores::new(&places.scores);
        let settings_file = SettingsFile::new(&places.settings);
        let (library, journal) = (Library::new(&places.root, &places.levels), Journal::new(scores.clone()));
        let loaded = settings_file.load(whose(journal.current()));
        words::speak(loaded.0.spoken());
        // Problems are worded as they are found: once more in that language.
        let (settings, settings_problems) = if loaded.1.is_empty() { loaded } else { settings_file.load(whose(journal.current())) };
        let mut app = Self {
            results: Results::new(places.root.join("results")),
            places,
            settings,
            settings_file,
            settings_problems,
            screen: menu(&journal, 0),
            memory: Memory::default(),
            stale: Stale::default(),
            canvas: Canvas::new(Frame::default()),
            dpi: 1.0,
            library,
            journal,
            scores,
            shown_for: 0.0,
            pace: Pace::default(),
            ended: None,
            lost: None,
            losses: BTreeMap::new(),
            last_level: None,
            menus: 0,
            sheets: BTreeMap::new(),
            unsaved_answers: Vec::new(),
            unsaved_score: None,
            watch: None,
            editing: None,
            behind: None,
            clipboard: Clipboard::default(),
            now: 0.0,
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
        let asked = self.act(input, spectator);
        self.note_end();
        let asked = asked.or_else(|| {
            input.dropped.first().filter(|path| self.editing.is_none() && self.screen.takes(path)).cloned().map(Request::Open)
        });
        match asked {
            Some(Request::QuitAnyway) => return false,
            Some(Request::Quit) => {
                // The question of what would be lost may have been answered by another try.
                self.stay();
                if self.may_close() {
                    return false;
                }
            }
            Some(request) => {
                self.note_score(&request);
                self.grant(request, spectator);
            }
            None => {}
        }
        self.fill_in_view();
        self.take_what_is_brought(spectator);
        self.show_frame(&input.without_edges(), spectator);
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
        input.held = self.stale.sift(&input, if input.away { Keys::default() } else { input.held });
        input.pressed = input.pressed.without(Key::F11);
        if alt_enter {
            input.pressed = input.pressed.without(Key::Enter);
        }
        input
    }

    /// The pass over the screen that acts.
    fn act(&mut self, input: &Input, spectator: &mut dyn Spectator) -> Option<Request> {
        self.canvas.begin(input.frame, self.dpi);
        let stage = PassInput { input, canvas: &self.canvas, spectator, time: self.shown_for };
        self.memory.act(stage, |ui| self.screen.show(ui))
    }

    /// The passes that show the screen as it is now, with the focus where it belongs.
    fn show_frame(&mut self, input: &Input, spectator: &mut dyn Spectator) {
        for _ in 0..MOST_PASSES {
            self.canvas.begin(input.frame, self.dpi);
            let stage = PassInput { input, canvas: &self.canvas, spectator: &mut *spectator, time: self.shown_for };
            let nothing_more = self.memory.show(stage, |ui| self.screen.show(ui));
            debug_assert!(nothing_more.is_none(), "nobody has asked for {nothing_more:?}");
            if self.memory.is_settled() {
                break;
            }
        }
    }

    /// What is on the screen.
    pub fn screen(&self) -> &dyn Screen {
        &*self.screen
    }

    /// The widgets of the last frame: those of the topmost layer.
    pub fn widgets(&self) -> &[Widget] {
        self.memory.widgets()
    }

    /// The label of the widget that has the keyboard's focus.
    pub fn focused(&self) -> Option<&str> {
        self.memory.focused()
    }

    /// The label of the widget under the pointer, where the pointer moved last.
    pub fn hovered(&self) -> Option<&str> {
        self.memory.hovered()
    }

    /// What the last frame has shown.
    pub fn canvas(&self) -> &Canvas {
        &self.canvas
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

    /// Another screen; what its predecessor asked for nobody waits for any more.
    pub(super) fn show(&mut self, next: Box<dyn Screen>) {
        self.keep_sheet();
        self.asked.values().for_each(|ticket| self.worker.forget(*ticket));
        self.asked.clear();
        (self.screen, self.memory, self.stale, self.shown_for) = (next, Memory::default(), self.stale.all(), 0.0);
    }

    /// Takes new settings over, keeps them, and says where that failed.
    pub(super) fn set(&mut self, settings: Settings) {
        self.settings = settings;
        words::speak(settings.spoken());
        self.settings_problems = self.settings_file.set(whose(self.journal.current()), &settings);
        self.screen.tell_of_settings(&self.settings, &self.settings_problems);
    }

    /// What the player has set.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    pub(super) fn menu(&mut self) -> Box<dyn Screen> {
        self.menus += 1;
        self.journal.try_again();
        self.ask_for_next();
        menu(&self.journal, self.menus)
    }

    /// Somebody plays from now on, with the settings of theirs.
    pub(super) fn choose(&mut self, name: Name, named: bool) {
        self.keep_sheet();
        self.sheets.clear();
        let closed = self.settings_file.close();
        self.journal.choose(name, named);
        (self.settings, self.settings_problems) = self.settings_file.load(whose(self.journal.current()));
        words::speak(self.settings.spoken());
        self.settings_problems.extend(closed.err().map(|error| error.to_string()));
    }

    /// Takes note of the attempt on the screen, once, when it has ended. Who watches a recording has flown nothing.
    fn note_end(&mut self) {
        let Some(flight) = self.screen.get_mut::<Flight>() else { return };
        let losses = self.losses.entry(flight.game().level().name.clone()).or_default();
        flight.tell_of_losses(*losses);
        let game = flight.game();
        if flight.is_test() || flight.is_watched() {
            return;
        }
        if flight.variation().is_some() {
            self.ended = None;
            return;
        }
        if game.outcome() == Outcome::Running {
            self.ended = None;
        } else if self.ended.is_none() {
            *losses += u32::from(game.outcome() == Outcome::Failed);
            self.ended =
                Some(if flight.is_by_hand() { self.journal.note(game, flight.is_assisted()) } else { tr(RECORDING).to_owned() });
        }
    }
}

/// Whose settings of play hold while this one plays: a guest has none of their own.
fn whose(player: &Name) -> &str {
    if player.is_guest() { "" } else { player.as_str() }
}

/// The menu for the present player; the worker brings the level that Play opens.
fn menu(journal: &Journal, seed: u64) -> Box<dyn Screen> {
    let (player, trouble) = (journal.current().clone(), journal.trouble().map(str::to_owned));
    Box::new(Menu::new(MenuFacts { next: None, player, trouble }, seed))
}
