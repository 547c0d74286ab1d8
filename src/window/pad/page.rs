//! The gamepads of a browser's page, in the standard layout.

use super::is_down;
use crate::settings::{Key, Keys};
use crate::web;

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
