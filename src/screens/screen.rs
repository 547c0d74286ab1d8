//! What a screen is.

use crate::classics::jumper::scene::JumperScene;
use crate::draw::Canvas;
use crate::draw::layout::{Area, Frame};
use crate::game::{Game, RunResult};
use crate::instruments::vary::Variation;
use crate::level::Level;
use crate::scores::{Name, ResultRow};
use crate::session::attempt::{Attempt, Flown};
use crate::session::new_file::NewFile;
use crate::session::recordings::{FlightCandidate, Visit};
use crate::settings::Settings;
use crate::ui::Ui;
use crate::ui::input::Input;
use crate::ui::pace::Motion;
use crate::view::camera::Viewport;
use crate::view::hud::Aside;
use crate::view::{GhostShip, Overlays};
use std::any::Any;
use std::fmt;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

/// The tune of the menus.
const MENU_TUNE: &str = "0";

/// A screen: one function that shows it and answers for it, and a few facts that most leave as they are.
pub trait Screen: Any + fmt::Debug {
    /// One pass over it: the request for another screen, or for something that outlasts it.
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request>;

    /// How it moves by itself, where the player does this.
    fn motion(&self, _input: &Input) -> Motion {
        Motion::Still
    }

    /// The name that its tune follows from; `None`: the tune before goes on.
    fn tune(&self) -> Option<&str> {
        Some(MENU_TUNE)
    }

    /// What was heard of it in the last frame; the ticks of a flight are heard by the spectator.
    fn noises(&self) -> Vec<Noise> {
        Vec::new()
    }

    /// Whether it may be left for a file or a folder that is dropped on the window: nothing that is typed or edited gets lost.
    fn takes(&self, _path: &Path) -> bool {
        true
    }

    /// The score on it that only the player can save, in words: it is lost with the window.
    fn unsaved(&self) -> Option<String> {
        None
    }

    /// How large its words are, in a window with `pixel` canvas units a pixel; 1 as designed.
    fn text_scale(&self, _settings: &Settings, _pixel: f32) -> f32 {
        1.0
    }

    /// Takes over the settings that hold now, and the problems of their file, a line each.
    fn tell_of_settings(&mut self, _settings: &Settings, _problems: &[String]) {}

    /// Takes over what became of a curve that was to be kept as a file.
    fn report_export(&mut self, _told: Result<PathBuf, String>) {}

    /// The game on it, in a canvas of that frame: the window's view draws it below the widgets.
    fn scene(&self, _frame: &Frame) -> Option<GameScene<'_>> {
        None
    }
}

impl dyn Screen {
    /// Whether it is of that type.
    pub fn is<T: Screen>(&self) -> bool {
        (self as &dyn Any).is::<T>()
    }

    /// The screen, where it is of that type.
    pub fn get<T: Screen>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }

    /// The screen, where it is of that type.
    pub fn get_mut<T: Screen>(&mut self) -> Option<&mut T> {
        (self as &mut dyn Any).downcast_mut()
    }
}

/// The empty screen: it stands where another one is taken away.
impl Screen for () {
    fn show(&mut self, _: &mut Ui<'_>) -> Option<Request> {
        None
    }
}

/// What a screen draws between its game and its widgets.
pub trait AboveGame {
    /// In the level, between the last two ticks by `alpha`, 0 … 1.
    fn draw_in_level(&self, alpha: f64, view: &Viewport, canvas: &Canvas);

    /// In the strip beside the timer.
    fn draw_beside_timer(&self, aside: &Aside, canvas: &Canvas);
}

/// What the window's view needs of a screen that shows a game.
pub struct GameScene<'a> {
    pub game: &'a Game,
    /// Between the last two ticks, 0 … 1.
    pub alpha: f64,
    /// The part of the canvas for the game.
    pub room: Frame,
    /// Without the settings.
    pub overlays: Overlays,
    /// Factor on the time of the view; 0 where the world stands still.
    pub speed: f64,
    /// Whether the view stands still too.
    pub paused: bool,
    /// Whether it is seen and not heard.
    pub quiet: bool,
    pub ghosts: Vec<GhostShip>,
    /// The places above the game: they cover it.
    pub panels: Vec<Area>,
    pub above: &'a dyn AboveGame,
}

/// Something that was heard in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Noise {
    /// Somebody jumped.
    Jump,
    /// Somebody landed, this hard: 0 … 1.
    Landing(f64),
    /// Two ran into each other.
    Bump,
    /// Two blocks collided, however often.
    Collision,
}

/// What a level is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// To play it.
    Play,
    /// To see its leaderboard.
    Leaderboard,
    /// To edit it.
    Edit,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Page {
    Charts,
    Stability,
    Survival,
    SideBySide,
    Euler,
    #[default]
    Experiments,
}

/// In the order of their tabs.
pub const PAGES: [(Page, &str); 6] = [
    (Page::Charts, "Charts"),
    (Page::Stability, "Stability"),
    (Page::Survival, "Stress tests"),
    (Page::SideBySide, "Side by side"),
    (Page::Euler, "Why Euler gains"),
    (Page::Experiments, "Experiments"),
];

/// One of the classics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Classic {
    /// A run through a map of tiles.
    TileRun,
    /// A climb.
    Jumper,
    /// π from collisions.
    Pi,
}

/// What is to be saved.
#[derive(Clone, Debug)]
pub struct Gain {
    /// The leaderboard: that of a level, by its name, or that of the jumper.
    pub board: String,
    /// What it is of, in words.
    pub subject: String,
    /// The score.
    pub points: i64,
    /// How they were flown, where that is known.
    pub flown: Option<Rc<Flown>>,
    /// Where Back leads.
    pub back: Box<Request>,
    /// Where the leaderboard leads once it is saved.
    pub onward: Vec<Onward>,
}

/// A button, and where it leads.
#[derive(Clone, Debug)]
pub struct Onward {
    /// The words on it.
    pub label: &'static str,
    /// Where it leads.
    pub to: Request,
}

/// A folder that is to be made or named.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Make {
    /// A new level of that name.
    New(String),
    /// A copy of the first, named like the second.
    Copy(String, String),
    /// A copy of the level in that folder, of that name.
    CopyOf(PathBuf, String),
    /// The first, named like the second.
    Rename(String, String),
}

/// What a screen asks for: the next screen, with what it needs.
#[derive(Clone, Debug)]
pub enum Request {
    /// The main menu.
    Menu,
    /// The list of levels.
    LevelSelect(Purpose),
    /// The level of that name, read afresh.
    Play(String),
    /// The attempt on the screen, from its start, in the level as its files are now.
    Restart,
    /// The level of that name, to be edited; one that comes with the game as a copy.
    Edit(String),
    /// The level of that name itself, to be edited.
    EditOriginal(String),
    /// The end of editing: the flight that it began from, or the list of levels.
    LeaveEditor,
    /// A level is to be made, and edited; or renamed.
    Make(Make),
    /// The level that is flown is to be saved as it is varied, under that name, or any where that is empty.
    SaveVaried(Variation, String),
    /// The level that is edited is to be flown as it is in memory, with the problems that it has left, a line each.
    TestFly(Arc<Level>, Vec<String>),
    /// The editor again, with how the flight of what is edited ended, in words.
    BackToEditor(String),
    /// Another attempt at a level that is there.
    Attempt(Attempt),
    /// An attempt has ended, with the flight where it was flown by hand.
    Score(Attempt, RunResult, Option<Rc<Flown>>),
    /// The flights of a level.
    Flights(Visit),
    /// One of them is watched.
    Watch(Visit, FlightCandidate),
    /// Some of them are raced.
    Race(Visit, Vec<FlightCandidate>),
    /// A curve is to be kept as a file; the screen stays.
    Export(NewFile),
    /// One of them is kept as a file.
    Keep(Visit, FlightCandidate),
    /// The code of one of them is to be copied.
    CopyCode(Visit, FlightCandidate),
    /// A flight's code, to be proven and listed.
    PasteCode(Visit, String),
    /// A score is to be saved under the player's name.
    SaveScore(Gain),
    /// It is saved under that name.
    Submit(Gain, Name),
    /// The leaderboard of the level of that name, or that of the jumper.
    Leaderboard(String),
    /// The list of players.
    Players,
    /// Somebody plays from now on; whether they have just said their name.
    Choose(Name, bool),
    /// Who and what the game is made of.
    Credits,
    /// The settings.
    Settings,
    /// They are to be these from now on; the screen stays.
    Set(Settings),
    /// The list of classics, with the keyboard on the one that was left.
    Classics(Option<Classic>),
    /// Charts, stress tests, two methods side by side, experiments.
    Lab,
    /// The list of experiments, at the one that was left.
    Experiments(String),
    /// The experiment of that folder.
    Experiment(String),
    /// An answer to it is to be saved, of the present player; the screen stays.
    HandIn(ResultRow),
    /// One of them, from its beginning.
    Classic(Classic),
    /// A climb that has ended.
    Climbed(Box<JumperScene>),
    /// A file that was dropped on the window.
    Open(PathBuf),
    /// What a browser keeps for the page.
    #[cfg(all(feature = "window", browser))]
    PageData,
    /// The end, unless something would be lost.
    Quit,
    /// The end, whatever is lost.
    QuitAnyway,
    /// No end: the screen behind the question.
    Stay,
}
