//! What the window's loop asks of a desktop, and its gamepads; a browser's page answers the same in `page`.

use super::is_down;
use crate::screens::Stack;
use crate::settings::{Key, Keys};
use crate::ui::{Spectator, input::Input};
use gilrs::{Axis, Button, EventType, Gamepad, Gilrs};
use macroquad::input::get_dropped_files;
use std::path::PathBuf;
use std::time::{Duration, SystemTime};

pub use std::time::Instant;

/// Which button is which of ours.
const BUTTONS: [(Button, Key); 12] = [
    (Button::DPadUp, Key::PadUp),
    (Button::DPadDown, Key::PadDown),
    (Button::DPadLeft, Key::PadLeft),
    (Button::DPadRight, Key::PadRight),
    (Button::South, Key::PadA),
    (Button::East, Key::PadB),
    (Button::West, Key::PadX),
    (Button::North, Key::PadY),
    (Button::Start, Key::PadStart),
    (Button::Select, Key::PadSelect),
    (Button::LeftTrigger, Key::PadL1),
    (Button::RightTrigger, Key::PadR1),
];

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

/// All gamepads as one.
pub struct Pads {
    gilrs: Option<Gilrs>,
    held: Keys,
}

impl Pads {
    /// Looks for gamepads; those that are plugged in later are found then.
    pub fn new() -> Self {
        Self { gilrs: Gilrs::new().ok(), held: Keys::default() }
    }

    /// What went down since the last frame, and what is down.
    pub fn read(&mut self) -> (Keys, Keys) {
        let Some(gilrs) = &mut self.gilrs else { return Default::default() };
        let mut pressed = Keys::default();
        while let Some(event) = gilrs.next_event() {
            if let EventType::ButtonPressed(button, _) = event.event
                && let Some((_, key)) = BUTTONS.iter().find(|(known, _)| *known == button)
            {
                // A press shorter than a frame is one.
                pressed.add(*key);
            }
        }
        let before = self.held;
        self.held = gilrs.gamepads().map(|(_, pad)| held(&pad, before)).fold(Keys::default(), |all, keys| all | keys);
        (pressed | self.held.less(before), self.held)
    }
}

fn held(pad: &Gamepad<'_>, before: Keys) -> Keys {
    let buttons = BUTTONS.iter().filter(|(button, _)| pad.is_pressed(*button)).map(|(_, key)| *key);
    let trigger = |button| pad.button_data(button).map_or(0.0, gilrs::ev::state::ButtonData::value);
    let (x, y) = (pad.value(Axis::LeftStickX), pad.value(Axis::LeftStickY));
    let levels = [
        (Key::PadRight, x),
        (Key::PadLeft, -x),
        (Key::PadUp, y),
        (Key::PadDown, -y),
        (Key::PadL2, trigger(Button::LeftTrigger2)),
        (Key::PadR2, trigger(Button::RightTrigger2)),
    ];
    buttons.chain(levels.into_iter().filter(|(key, level)| is_down(*level, before.has(*key))).map(|(key, _)| key)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_gamepads_nothing_is_pressed() {
        let mut pads = Pads { gilrs: None, held: Keys::default() };
        assert_eq!(pads.read(), (Keys::default(), Keys::default()));
    }
}
