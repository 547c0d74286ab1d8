//! The gamepads of a desktop.

use super::is_down;
use crate::settings::{Key, Keys};
use gilrs::{Axis, Button, EventType, Gamepad, Gilrs};

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

/// What is down on one gamepad.
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
