//! Resultant: a rocket ship flown through levels by named forces alone.
//!
//! SI units in `f64`; x to the right, y **down**; angles clockwise, in radians inside and in degrees at the edges (files, keys,
//! the screen). Time advances in fixed ticks of 1/[`game::TICK_RATE`] s and nowhere else. Arrows point downwards only:
//! `physics ← level ← game ← scores ← settings ← screens → view`.
//!
//! - [`physics`]: the engine: bodies, named forces, contacts, impacts, motion. It knows no pixel, key, clock or file.
//! - [`level`]: the text of a level folder becomes a valid [`level::Level`], or the list of all its problems.
//! - [`game`]: one run of a level: controls, fuel, objectives, hazards, events, score.
//! - [`instruments`]: what a lesson measures with: quantities, curves, work; it reads a flight and changes nothing in it.
//! - [`pack`]: a level as one file that is handed on, and what may be taken of one that came from anywhere.
//! - [`scores`]: user names and leaderboards, and their files.
//! - [`settings`]: what a player has set, and the file that keeps it.
//! - [`classics`]: a tile run, a jumper, and π from collisions, each with just the model that it needs.
//! - [`lab`]: accuracy against speed: scenes with exact answers, methods, stress tests, charts.
//! - [`draw`]: a frame as a list of shapes, and the pens that play it.
//! - [`ui`]: widgets without a window: they are laid out and recorded, and answer mouse, keys and gamepad by their labels.
//! - [`session`]: what outlasts a screen: who plays, levels and the worker that reads them, recorded flights.
//! - [`screens`]: folders of screens by what a person does; tested without a window, which is in `window`.
//! - [`view`]: drawing only: it reads the game and changes nothing in it. `sound`, with the window: what it sounds like, and the mixer.
//! - [`cli`]: one file a subcommand. [`import`]: maps of another editor as levels.
//! - [`words`]: the languages of the screens.
//! - [`number`]: how results print numbers, and every screen a time. [`files`]: reading with a limit, locks, and writing whole or not at all.

mod built_in;
pub mod classics;
pub mod cli;
pub mod draw;
pub mod files;
pub mod game;
pub mod import;
pub mod instruments;
pub mod lab;
pub mod level;
pub mod number;
pub mod pack;
pub mod physics;
/// Random numbers for unit tests: those of the tests in `tests/`.
#[cfg(test)]
#[allow(dead_code)] // The other tests need more of it.
#[path = "../tests/support/random.rs"]
mod random;
pub mod scores;
pub mod screens;
pub mod session;
pub mod settings;
#[cfg(feature = "window")]
#[allow(clippy::disallowed_methods)] // the device is waited for
pub mod sound;
/// Forms of a table for unit tests: those of the tests in `tests/`.
#[cfg(test)]
#[path = "../tests/support/spreadsheets.rs"]
mod spreadsheets;
#[cfg(all(target_os = "linux", feature = "window"))]
mod system_library;
pub mod ui;
pub mod view;
#[cfg(all(browser, feature = "window"))]
mod web;
#[cfg(feature = "window")]
#[allow(clippy::disallowed_methods)] // frames are timed
pub mod window;
pub mod words;
