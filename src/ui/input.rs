//! The player's input of one frame, in canvas units and without a window.

use crate::settings::{Action, Key, Keys, Settings};
use crate::{draw::layout::Frame, draw::layout::Vec2, physics::BodyId, physics::DVec2};
use std::{cell::Cell, cell::RefCell, path::PathBuf, rc::Rc};

/// The buttons' answer to an input, for the sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ButtonAnswer {
    Moved,
    Pressed,
}

/// A key that went down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keyed {
    pub key: Key,
    /// The number of characters typed before it in that frame.
    pub after: usize,
    /// Of Shift, Control and Alt, the keys that were down then.
    pub held: Keys,
}

/// A single act with the keyboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    Letter(char),
    /// A key that went down, and the modifiers held then.
    Key(Key, Keys),
}

/// The clipboard: in a window the system's, else the text that was copied here.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Clipboard {
    own: Rc<RefCell<String>>,
    #[cfg(feature = "window")]
    pub(crate) of_system: bool,
}

impl Clipboard {
    pub fn text(&self) -> String {
        #[cfg(feature = "window")]
        if self.of_system
            && let Some(text) = macroquad::miniquad::window::clipboard_get().filter(|text| !text.is_empty())
        {
            return text;
        }
        self.own.borrow().clone()
    }

    pub fn keep(&self, text: String) {
        #[cfg(feature = "window")]
        if self.of_system {
            macroquad::miniquad::window::clipboard_set(&text);
        }
        *self.own.borrow_mut() = text;
    }
}

/// The player's input since the last frame, and the keys and buttons held down now.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Input {
    pub frame: Frame,
    /// Whether a game is seen behind the screen.
    pub over: bool,
    /// Since the last frame, s.
    pub frame_time: f64,
    /// The share of the frame time that the window has waited on purpose, s.
    pub waited: f64,
    /// Time without any input, s; the app keeps it.
    pub idle: f64,
    /// Another window has the keyboard, or this one is hidden.
    pub away: bool,
    pub pointer: Vec2,
    /// Left button.
    pub click: bool,
    /// Left button.
    pub holding: bool,
    /// Right button.
    pub right_click: bool,
    /// Right or middle button.
    pub dragging: bool,
    /// Notches of the wheel, positive away from the player (up).
    pub wheel: f32,
    /// Keys that went down, even if they are up again by now.
    pub pressed: Keys,
    pub held: Keys,
    pub dropped: Vec<PathBuf>,
    /// In order.
    pub typed: String,
    /// The pressed keys whose moment is known, in order: not those of a gamepad.
    pub keyed: Vec<Keyed>,
    pub clipboard: Clipboard,
    /// The body of the game under the pointer.
    pub pointed: Option<BodyId>,
    /// The pointer's place in the game's level, m.
    pub place: Option<DVec2>,
    pub settings: Settings,
    /// The buttons' answer; copies of the input share it.
    pub answer: Rc<Cell<Option<ButtonAnswer>>>,
}

impl Input {
    pub fn pressed(&self, key: Key) -> bool {
        has(self.pressed, key)
    }

    /// Whether a key of the flight's action went down.
    pub fn acts(&self, action: Action) -> bool {
        self.settings.keys.does(action, self.pressed)
    }

    /// Whether a key of the flight's action is down.
    pub fn keeps(&self, action: Action) -> bool {
        self.settings.keys.does(action, self.held)
    }

    /// Whether a press, a turn of the wheel, a character or a drop is new.
    pub fn has_news(&self) -> bool {
        let pointer = self.click || self.right_click || self.wheel != 0.0;
        pointer || !self.pressed.is_empty() || !self.typed.is_empty() || !self.dropped.is_empty()
    }

    /// The time in which the last frame was made, s: 0 only where no time has passed.
    pub fn worked(&self) -> f64 {
        if self.frame_time > 0.0 { (self.frame_time - self.waited).max(f64::MIN_POSITIVE) } else { 0.0 }
    }

    /// The typed characters and the presses of `keys`, in order; a press whose moment is not known is last.
    pub fn strokes(&self, keys: &[Key]) -> Vec<Stroke> {
        // Systems also type the letter of a command.
        let command = self.keyed.is_empty() && self.held(Key::Control) && !self.held(Key::Alt);
        let mut letters = self.typed.chars().filter(|_| !command).map(Stroke::Letter);
        let (mut strokes, mut typed) = (Vec::new(), 0);
        for Keyed { key, after, held } in self.keyed.iter().filter(|keyed| self.pressed.has(keyed.key) && keys.contains(&keyed.key))
        {
            strokes.extend(letters.by_ref().take(after.saturating_sub(typed)));
            typed = typed.max(*after);
            strokes.push(Stroke::Key(*key, *held));
        }
        strokes.extend(letters);
        let known = |key: Key| self.keyed.iter().any(|keyed| keyed.key == key);
        strokes.extend(keys.iter().filter(|key| self.pressed(**key) && !known(**key)).map(|key| Stroke::Key(*key, self.held)));
        strokes
    }

    /// The same input without edges: no time, press, turn or character.
    pub fn without_edges(&self) -> Self {
        Self {
            frame: self.frame,
            pointer: self.pointer,
            holding: self.holding,
            dragging: self.dragging,
            held: self.held,
            idle: self.idle,
            away: self.away,
            settings: self.settings,
            clipboard: self.clipboard.clone(),
            ..Self::default()
        }
    }

    /// The same input without the keyboard, for a screen whose keys go into a line of text.
    pub fn without_keys(&self) -> Self {
        Self { pressed: Keys::default(), held: Keys::default(), typed: String::new(), ..self.clone() }
    }

    /// A press goes before a move.
    pub fn answer(&self, answer: ButtonAnswer) {
        if self.answer.get() != Some(ButtonAnswer::Pressed) {
            self.answer.set(Some(answer));
        }
    }

    pub fn held(&self, key: Key) -> bool {
        has(self.held, key)
    }
}

/// Whether the set holds the key, or the button of a gamepad that does the same.
fn has(keys: Keys, key: Key) -> bool {
    keys.has(key) || key.on_pad().is_some_and(|pad| keys.has(pad))
}

/// Keys that something else has been given: they count once they were released.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stale {
    keys: Keys,
    /// In the last frame.
    held: Keys,
}

impl Stale {
    /// What is held now does not count.
    pub fn all(self) -> Self {
        Self { keys: self.keys | self.held, ..self }
    }

    /// Takes what is held in this frame, of which `given` is not given to others; returns what counts of it.
    pub fn sift(&mut self, input: &Input, given: Keys) -> Keys {
        let stale = self.keys | input.held.less(given);
        // The keys of both.
        self.keys = stale.less(stale.less(input.held)).less(input.pressed);
        self.held = input.held;
        given.less(self.keys)
    }
}

/// Keeps presses until a tick takes them: a press shorter than a frame is not lost in a frame without a tick, and does not repeat
/// in a frame with two. What is held at its beginning counts once it was released.
#[derive(Clone, Copy, Debug, Default)]
pub struct KeyLatch {
    held: Keys,
    pressed: Keys,
    stale: Option<Stale>,
}

impl KeyLatch {
    pub fn frame(&mut self, input: &Input) {
        let stale = self.stale.get_or_insert(Stale { keys: input.held, held: input.held });
        self.held = stale.sift(input, input.held);
        self.pressed = self.pressed | input.pressed;
    }

    pub fn take(&mut self) -> Keys {
        self.held | std::mem::take(&mut self.pressed)
    }
}

/// Time for which a key is held before it repeats, s.
const REPEAT_AFTER: f64 = 0.4;
/// Time between repetitions, s.
const REPEAT_EVERY: f64 = 0.05;

/// Repeats held keys, for moving through text and lists. Buttons never repeat.
#[derive(Clone, Debug, Default)]
pub struct Repeat {
    key: Option<Key>,
    /// Time to the next repetition, s.
    wait: f64,
}

impl Repeat {
    /// The actions of `keys` in this frame, repetitions included; call it once a frame, with all keys of one screen.
    pub fn strokes(&mut self, input: &Input, keys: &[Key]) -> Vec<Key> {
        let mut strokes: Vec<Key> = keys.iter().copied().filter(|key| input.pressed(*key)).collect();
        if let Some(last) = strokes.last() {
            *self = Self { key: Some(*last), wait: REPEAT_AFTER };
        } else if let Some(key) = self.key.filter(|key| input.held(*key)) {
            self.wait -= input.frame_time;
            if self.wait <= 0.0 {
                // One a frame at most: a hitch must not run to the end of the list.
                self.wait = REPEAT_EVERY;
                strokes.push(key);
            }
        } else {
            self.key = None;
        }
        strokes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(pressed: &[Key], held: &[Key]) -> Input {
        Input {
            frame_time: 0.11,
            pressed: pressed.iter().copied().collect(),
            held: held.iter().copied().collect(),
            ..Input::default()
        }
    }

    #[test]
    fn a_copy_answers_for_its_original_and_a_press_goes_before_a_move() {
        let input = Input::default();
        let copy = Input { pressed: Keys::default(), ..input.clone() };
        copy.answer(ButtonAnswer::Moved);
        assert_eq!(input.answer.get(), Some(ButtonAnswer::Moved));
        copy.answer(ButtonAnswer::Pressed);
        input.answer(ButtonAnswer::Moved);
        assert_eq!(input.answer.get(), Some(ButtonAnswer::Pressed));
        input.without_edges().answer(ButtonAnswer::Moved);
        assert_eq!(input.answer.get(), Some(ButtonAnswer::Pressed), "the same moment again answers nothing");
    }

    #[test]
    fn a_held_key_repeats_after_a_while_and_stops_when_released() {
        let mut repeat = Repeat::default();
        assert_eq!(repeat.strokes(&frame(&[Key::Down], &[Key::Down]), &[Key::Down]), [Key::Down]);
        let strokes = (0..6).map(|_| repeat.strokes(&frame(&[], &[Key::Down]), &[Key::Down]).len()).collect::<Vec<_>>();
        assert_eq!(strokes, [0, 0, 0, 1, 1, 1]);
        assert!(repeat.strokes(&frame(&[], &[]), &[Key::Down]).is_empty());
        assert!(repeat.strokes(&frame(&[], &[Key::Down]), &[Key::Down]).is_empty(), "held from before is no press");
    }
}
