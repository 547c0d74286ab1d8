//! The screens: a state machine that runs, and is tested, without a window. A screen takes an [`Input`] a frame and may answer with
//! a [`Request`], which carries what the next screen needs; [`App`] grants it in one place. One file a screen; each file's drawing
//! reads the screen and goes through [`crate::view`]. The window, its keys and its clock are in `window`; rules of the game, scores
//! and names are not here but in the modules below.

mod ahead;
mod app;
mod balls;
mod boards;
mod classics;
mod closing;
mod credits;
#[cfg(all(feature = "window", not(browser)))]
mod desktop;
mod editor;
mod files;
mod flight;
mod flights;
mod folder_watch;
mod footage;
mod granting;
mod hand_in;
mod hover;
mod instruments;
mod journal;
mod jumper;
#[cfg(feature = "window")]
mod keyboard;
mod lab;
mod leaderboard;
mod level_select;
mod library;
mod link;
mod loading;
mod menu;
mod miniature;
mod name_field;
mod new_file;
mod noise;
mod observer;
mod pace;
#[cfg(feature = "window")]
mod pad;
#[cfg(all(feature = "window", browser))]
mod page;
#[cfg(all(feature = "window", browser))]
mod page_data;
mod pi;
mod players;
mod problems;
mod prompt;
mod race;
mod save_score;
mod scene;
mod scoring;
mod screen;
mod settings;
#[cfg(all(feature = "window", target_os = "linux", target_pointer_width = "64"))]
mod system_date;
#[cfg(feature = "window")]
mod theatre;
mod tile_run;
mod visits;
#[cfg(feature = "window")]
mod window;
mod worker;

#[cfg(all(feature = "window", not(browser)))]
use desktop as host;
#[cfg(all(feature = "window", browser))]
use page as host;

pub use crate::settings::{Key, Keys};
pub use crate::ui::Spectator;
pub use crate::ui::input::{ButtonAnswer, Clipboard, Input, Keyed};
pub use crate::ui::scroll::Bar;
use crate::ui::{input, scroll, text_field};
pub use app::{App, Places};
pub use classics::{Classic, Classics};
pub use closing::Closing;
pub use credits::Credits;
pub use editor::Editor;
pub use flight::{Attempt, Flight, Flown};
pub use flights::{FlightCandidate, FlightSource, Flights, Visit};
pub use folder_watch::{FolderWatch, Stamp};
pub use instruments::vary::Varied;
pub use instruments::{Instruments, Measures, Plot, PlotPlaces, Stage, Table as Figures, Tool as Instrument};
pub use jumper::Jumper;
pub use lab::{Experiment, Half, Lab, PAGES, Page, Shown};
pub use leaderboard::{BoardRival, Fresh, Leaderboard, Onward};
pub use level_select::{LevelEntry, LevelSelect, Purpose};
pub use library::Library;
pub use link::{LinkTarget, PageLink};
pub use menu::{Menu, MenuFacts};
pub use miniature::{Miniature, MiniaturePart};
pub use name_field::{NameEntry, NameField};
pub use new_file::NewFile;
pub use noise::Noise;
pub use observer::{Observer, PACES as OBSERVED_PACES};
pub use pace::{Motion, Pace, Picture};
pub use pi::Pi;
pub use players::PlayerList;
pub use problems::Problems;
pub use prompt::{Prompt, Reply};
pub use race::{Gap, Ghost, MOST_RIVALS, Race, Rival, Split};
pub use save_score::{Gain, SaveScore};
pub use scene::GameScene;
pub use scoring::Scoring;
pub use screen::Screen;
pub use settings::SettingsPanel;
pub use tile_run::TileRun;
#[cfg(all(feature = "window", browser))]
pub use window::open_page;
#[cfg(feature = "window")]
pub use window::{Start, open};
pub use worker::{Errand, Worker};

use crate::classics::jumper::scene::JumperScene;
use crate::game::RunResult;
use crate::instruments::vary::Variation;
use crate::level::Level;
use crate::scores::{Name, ResultRow};
use crate::settings::Settings;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;

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
