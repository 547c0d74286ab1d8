//! What the window's loop asks of a desktop; a browser's page answers the same in `page`.

use crate::screens::Stack;
use crate::ui::{Spectator, input::Input};
use macroquad::input::get_dropped_files;
use std::path::PathBuf;
use std::time::{Duration, SystemTime};

pub use std::time::Instant;

/// Since 1970, s; 0 before that.
pub fn now() -> f64 {
    SystemTime::UNIX_EPOCH.elapsed().unwrap_or_default().as_secs_f64()
}

pub fn pause(time: Duration) {
    std::thread::sleep(time);
}

/// The system's, such as `de_AT.UTF-8`; empty where it names none.
pub fn language() -> String {
    ["LC_ALL", "LC_MESSAGES", "LANG"]
        .into_iter()
        .filter_map(|name| std::env::var(name).ok())
        .find(|name| !name.is_empty())
        .unwrap_or_default()
}

/// The files that were dropped since the last frame.
pub fn dropped() -> Vec<PathBuf> {
    get_dropped_files().into_iter().filter_map(|file| file.path).collect()
}

/// Before a frame. A desktop asks for nothing.
pub const fn begin_frame(_: &mut Stack, _: &mut Input, _: &mut dyn Spectator) {}

/// After a frame is drawn. A desktop waits before the next one, and asks when the window is closed.
pub const fn end_frame(_: f64, _: bool) {}
