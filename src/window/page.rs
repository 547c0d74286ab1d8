//! What the window's loop asks of a browser's page, and its gamepads, in the standard layout; a desktop answers the same in `desktop`.

use super::is_down;
use crate::screens::{Destination, Flight, Request, Stack};
use crate::settings::{Key, Keys, Settings};
use crate::ui::{Spectator, input::Input};
use crate::web;
use std::{path::PathBuf, time::Duration};

pub use crate::web::Instant;

pub use crate::web::language;
pub use macroquad::miniquad::date::now;

/// Which button is which of ours.
const BUTTONS: [(usize, Key); 14] = [
    (0, Key::PadA),
    (1, Key::PadB),
    (2, Key::PadX),
    (3, Key::PadY),
    (4, Key::PadL1),
    (5, Key::PadR1),
    (6, Key::PadL2),
    (7, Key::PadR2),
    (8, Key::PadSelect),
    (9, Key::PadStart),
    (12, Key::PadUp),
    (13, Key::PadDown),
    (14, Key::PadLeft),
    (15, Key::PadRight),
];

/// The browser asks for a frame when it needs one.
pub const fn pause(_: Duration) {}

/// The files that were dropped or chosen since the last frame. One with everything of a page is taken over at once.
pub fn dropped() -> Vec<PathBuf> {
    let mut dropped = web::dropped();
    dropped.retain(|path| {
        let everything = web::is_export(path);
        if everything {
            web::import(path);
        }
        !everything
    });
    dropped
}

/// Before a frame: a page that was hidden pauses its flight, and a new link is followed.
pub fn begin_frame(stack: &mut Stack, input: &mut Input, spectator: &mut dyn Spectator) {
    let flown = stack.screen().get::<Flight>().is_some_and(|flight| flight.is_by_hand() && !flight.is_test());
    if web::was_hidden() && flown && stack.screen().scene(&input.frame).is_some_and(|scene| !scene.paused) {
        input.pressed.add(Key::Escape);
    }
    // The browser's own Esc leaves the full screen, and a page enters it by a press alone.
    if let Some(fullscreen) = web::fullscreen().filter(|fullscreen| *fullscreen != stack.settings().fullscreen) {
        stack.set(Settings { fullscreen, ..*stack.settings() });
    }
    let link = web::link();
    if !link.is_empty() {
        stack.grant(Request::Reset(Destination::Link(link)), spectator);
    }
}

/// After a frame is drawn; the least time until the next one, s, and whether something is lost where the page is left now.
pub fn end_frame(rest: f64, at_risk: bool) {
    web::set_at_risk(at_risk);
    web::end_frame(rest);
}

/// All gamepads as one.
#[derive(Default)]
pub struct Pads(Keys);

impl Pads {
    pub fn new() -> Self {
        Self::default()
    }

    /// What went down since the last frame, and what is down.
    pub fn read(&mut self) -> (Keys, Keys) {
        let levels = web::pads();
        let [.., x, y] = levels;
        let stick = [(Key::PadRight, x), (Key::PadLeft, -x), (Key::PadDown, y), (Key::PadUp, -y)];
        let buttons = BUTTONS.map(|(button, key)| (key, levels[button]));
        let before = std::mem::take(&mut self.0);
        let down = buttons.into_iter().chain(stick).filter(|(key, level)| is_down(*level, before.has(*key)));
        self.0 = down.map(|(key, _)| key).collect();
        (self.0.less(before), self.0)
    }
}
