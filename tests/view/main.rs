//! Places of the picture's parts, its words, and the sound; nothing is drawn.

mod camera;
mod goals;
mod hud;
mod labels;
mod onlook;
mod overlay;
mod overlay_places;
mod overlay_truth;
mod sound;
#[path = "../support/mod.rs"]
mod support;
mod terrain;
mod textbook;
