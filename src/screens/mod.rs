//! The screens: folders by what a person does, run and tested without a window. A screen takes an [`Input`] a frame and may answer with a
//! [`Request`], which the [`Stack`] of open screens grants. Rules of the game, scores, names and files are in the modules below.

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

pub use crate::session::library::{Attempt, Rival};
pub use crate::session::{Places, recordings::Visit, worker::Worker};
pub use crate::settings::{Key, Keys};
pub use crate::ui::{Spectator, input::Input, pace::Picture};
pub use boards::{Leaderboard, flights::Flights};
pub use classics::{Classics, jumper::Jumper, pi::Pi, tile_run::TileRun};
pub use editor::Editor;
pub use flight::Flight;
pub use flight::instruments::{Plot, PlotPlaces, Stage, Tool as Instrument};
pub use flight::observer::PACES as OBSERVED_PACES;
pub use flight::race::{Gap, MOST_RIVALS, Split};
pub use lab::{Half, Lab};
pub use levels::LevelSelect;
pub use menu::{Closing, Menu, credits::Credits};
pub use players::PlayerList;
pub use scoring::Scoring;
pub use screen::{Classic, Destination, Effect, GameScene, Noise, PAGES, Page, Purpose, Request, Screen};
pub use settings::SettingsPanel;
pub use stack::Stack;
