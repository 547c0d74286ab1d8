//! The screens: folders by what a person does, run and tested without a window. A screen takes an [`Input`] a frame and may answer with
//! a [`Request`]; the [`Stack`] of open screens grants it in one place, by the [`Session`] that outlasts them. Rules of the game, scores, names and files are
//! not here but in the modules below; the window is above.

mod boards;
mod classics;
mod destinations;
mod editor;
mod flight;
mod lab;
mod levels;
mod menu;
mod players;
mod scoring;
mod screen;
mod settings;
mod stack;

pub use crate::session::folder_watch::{FolderWatch, Stamp};
pub use crate::session::library::{Attempt, Experiment, Flown, Library, NewFile, Rival, Shown};
pub use crate::session::recordings::{BoardRival, FlightCandidate, FlightSource, Visit};
pub use crate::session::worker::{Errand, Worker};
pub use crate::session::{Places, Session};
pub use crate::settings::{Key, Keys};
pub use crate::ui::Spectator;
pub use crate::ui::input::{ButtonAnswer, Clipboard, Input, Keyed};
pub use crate::ui::pace::{Motion, Pace, Picture};
pub use crate::ui::prompt::{NameEntry, NameField, Problems, Prompt, Reply};
pub use crate::ui::scroll::Bar;
pub use boards::Leaderboard;
pub use boards::flights::Flights;
pub use classics::Classics;
pub use classics::jumper::Jumper;
pub use classics::pi::Pi;
pub use classics::tile_run::TileRun;
pub use destinations::{LinkTarget, PageLink};
pub use editor::Editor;
pub use flight::Flight;
pub use flight::instruments::vary::Varied;
pub use flight::instruments::{Instruments, Measures, Plot, PlotPlaces, Stage, Table as Figures, Tool as Instrument};
pub use flight::observer::{Observer, PACES as OBSERVED_PACES};
pub use flight::race::{Gap, Ghost, MOST_RIVALS, Race, Split};
pub use lab::{Half, Lab};
pub use levels::{LevelEntry, LevelSelect};
pub use menu::credits::Credits;
pub use menu::{Closing, Menu, MenuFacts};
pub use players::PlayerList;
pub use scoring::Scoring;
pub use screen::{
    AboveGame, Classic, Destination, Effect, Finished, GameScene, Make, Noise, Onward, PAGES, Page, Purpose, Request, Screen,
};
pub use settings::SettingsPanel;
pub use stack::Stack;
