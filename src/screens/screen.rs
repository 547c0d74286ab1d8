//! What a screen is.

use crate::game::{Game, RunResult};
use crate::session::library::{Attempt, Flown, NewFile};
use crate::ui::{Spectator, Ui, input::Input, pace::Motion};
use crate::view::{GhostShip, Overlays, camera::Viewport, hud::Aside};
use crate::{classics::jumper::JumperScene, draw::Canvas, instruments::vary::Variation, level::Level, scores::Name};
use crate::{draw::layout::Area, draw::layout::Frame, session::worker::Brought, session::worker::Ticket};
use crate::{session::Session, session::recordings::FlightCandidate, session::recordings::Visit, settings::Settings};
use std::{any::Any, fmt, path::Path, path::PathBuf, rc::Rc, sync::Arc};

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

    /// The frame with words as large as the settings ask for: those of a page grow until they can be read from afar.
    fn with_words(&self, frame: Frame, settings: &Settings) -> Frame {
        frame.with_legible((f32::from(settings.scale) / 100.0).max(1.0))
    }

    /// Takes over the settings that hold now, and the problems of their file, a line each.
    fn tell_of_settings(&mut self, _settings: &Settings, _problems: &[String]) {}

    /// Where [`Request::Pop`] leads from it where nothing is below.
    fn parent(&self) -> Destination {
        Destination::Menu
    }

    /// The level that is read before that is done, by its name.
    fn reads(&self, _effect: &Effect, _session: &Session) -> Option<String> {
        None
    }

    /// Does what it has asked for; a request that follows from that.
    fn carry_out(&mut self, _effect: Effect, _session: &mut Session, _spectator: &mut dyn Spectator) -> Option<Request> {
        None
    }

    /// Whether the game of the screen below is seen behind it.
    fn lies_over(&self) -> bool {
        false
    }

    /// Shows why what it has asked for cannot be had.
    fn refuse(&mut self, _reason: String) {}

    /// Looks at files, before a frame.
    fn look(&mut self, _frame_time: f64, _session: &mut Session) {}

    /// Gives the session what has happened in a frame, and takes what it needs for the next one.
    fn attend(&mut self, _session: &mut Session) {}

    /// Takes what the worker has read for it.
    fn receive(&mut self, _ticket: Ticket, _brought: Brought, _session: &mut Session, _spectator: &mut dyn Spectator) {}

    /// The game pauses.
    fn halt(&mut self) {}

    /// Another screen is shown from now on.
    fn leave(&mut self, _session: &mut Session) {}

    /// It is shown again, after `above`.
    fn come_back(&mut self, _above: &dyn Screen, _session: &mut Session, _spectator: &mut dyn Spectator) {}

    /// Writes down what waits in it.
    /// Errors: why that cannot be, in words.
    fn write_down(&mut self, _session: &mut Session) -> Result<(), String> {
        Ok(())
    }

    /// Whether something in it is not written yet. Nothing is tried.
    fn is_at_risk(&self) -> bool {
        false
    }

    /// The game on it, in a canvas of that frame: the window's view draws it below the widgets.
    fn scene(&self, _frame: &Frame) -> Option<GameScene<'_>> {
        None
    }
}

impl dyn Screen {
    pub fn is<T: Screen>(&self) -> bool {
        (self as &dyn Any).is::<T>()
    }

    /// The screen, where it is of that type.
    pub fn get<T: Screen>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }

    pub fn get_mut<T: Screen>(&mut self) -> Option<&mut T> {
        (self as &mut dyn Any).downcast_mut()
    }
}

/// What a screen draws between its game and its widgets.
pub trait AboveGame {
    /// In the level, between the last two ticks by `alpha`, 0 … 1.
    fn draw_in_level(&self, alpha: f64, view: &Viewport, canvas: &Canvas);

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
    Jump,
    /// Somebody landed, this hard: 0 … 1.
    Landing(f64),
    Bump,
    /// Two blocks collided, however often.
    Collision,
}

/// What a level is chosen for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Purpose {
    #[default]
    Play,
    Leaderboard,
    Edit,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Page {
    #[default]
    Overview,
    Charts,
    Stability,
    Survival,
    SideBySide,
    Euler,
    Experiments,
}

/// In the order of their tabs.
pub const PAGES: [(Page, &str); 7] = [
    (Page::Overview, "Overview"),
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
    TileRun,
    Jumper,
    Pi,
}

/// A folder that is to be made or named.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Make {
    New(String),
    Copy(String, String),
    /// A copy of the level in that folder, of that name.
    CopyOf(PathBuf, String),
    Rename(String, String),
}

/// What an author does with a level in the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OnLevel {
    /// Makes one file of it.
    Share(String),
    Bin(String),
    /// Takes the last one out of the bin.
    TakeBack,
    Folder(String),
}

/// What a screen asks for.
#[derive(Clone, Debug)]
pub enum Request {
    /// A screen above this one, which comes back with [`Request::Pop`].
    Push(Destination),
    /// A screen in the place of this one.
    Replace(Destination),
    /// A screen in the place of all.
    Reset(Destination),
    /// The screen below, or where this one belongs if it is the lowest.
    Pop,
    /// Something that the session does for the screen, which stays.
    Do(Effect),
    /// The end, unless something would be lost.
    Quit,
    /// The end, whatever is lost.
    QuitAnyway,
}

/// A screen, with what it needs.
#[derive(Clone, Debug)]
pub enum Destination {
    Menu,
    Levels(Purpose),
    /// The level of that name, read again.
    Play(String),
    /// An attempt at a level that is there.
    Fly(Attempt),
    /// A level as the editor below has it in memory, or as much of a level's files as loads, with the problems that are left, a line each.
    TryOut {
        level: Arc<Level>,
        problems: Vec<String>,
        in_memory: bool,
        /// A stopped flight that goes on in it.
        on: Option<Box<Game>>,
    },
    /// The editor of the level of that name; of one that comes with the game a copy is made first, unless the original is wanted.
    Edit {
        name: String,
        original: bool,
    },
    Score(Box<Finished>),
    /// The leaderboard of a level, by its name, or of the jumper.
    Board(Visit),
    Flights(Visit),
    Watch(Visit, FlightCandidate),
    Race(Visit, Vec<FlightCandidate>),
    Players,
    Credits,
    Settings,
    /// The list of classics, with the keyboard on the one that was left.
    Classics(Option<Classic>),
    Classic(Classic),
    Climbed(Box<JumperScene>),
    /// The Lab, with the list of experiments at the one that was left.
    Lab(Option<String>),
    Experiment(String),
    Dropped(PathBuf),
    Link(String),
    #[cfg(all(feature = "window", browser))]
    PageData,
}

/// What the session does for a screen.
#[derive(Clone, Debug)]
pub enum Effect {
    /// Begins the attempt again, in the level as its files are now.
    Restart,
    Make(Make),
    OnLevel(OnLevel),
    /// Saves the level that is flown as it is varied, under that name, or any where that is empty.
    SaveVaried(Variation, String),
    Export(NewFile),
    /// The player's prediction for an experiment stays as it is from now on.
    Predict,
    HandIn,
    Keep(FlightCandidate),
    CopyCode(FlightCandidate),
    /// Proves a flight by its code, and lists it.
    PasteCode(String),
    /// Somebody plays from now on; whether they have just said their name.
    Choose(Name, bool),
    Set(Settings),
}

/// An attempt that has ended.
#[derive(Clone, Debug)]
pub struct Finished {
    pub attempt: Attempt,
    pub result: RunResult,
    /// The flight, where it was flown by hand.
    pub flown: Option<Rc<Flown>>,
    /// What it brought the player, in words.
    pub remark: String,
    /// The level as it has left it.
    pub end: Box<Game>,
}
