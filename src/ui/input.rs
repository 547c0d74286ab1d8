//! What the player did in one frame, in canvas units and without a window.

use crate::draw::layout::{Frame, Vec2};
use crate::physics::{BodyId, DVec2};
use crate::settings::{Action, Key, Keys, Settings};
use std::cell::{Cell, RefCell};
use std::path::PathBuf;
use std::rc::Rc;

/// What the buttons made of an input, for the ear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The keyboard or the pointer went to another button.
    Moved,
    /// A button was pressed.
    Pressed,
}

/// A key that went down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keyed {
    /// Which.
    pub key: Key,
    /// How many characters had been typed before it in that frame.
    pub after: usize,
    /// Which of Shift, Control and Alt were down then.
    pub held: Keys,
}

/// What was done with the keyboard, one thing after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A character was typed.
    Letter(char),
    /// A key went down, while these were down.
    Key(Key, Keys),
}

/// What is copied to be pasted: in a window the system's, where that says anything, else the text that was copied here.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Clipboard {
    own: Rc<RefCell<String>>,
    #[cfg(feature = "window")]
    pub(crate) of_system: bool,
}

impl Clipboard {
    /// What is on it.
    pub fn text(&self) -> String {
        #[cfg(feature = "window")]
        if self.of_system
            && let Some(text) = macroquad::miniquad::window::clipboard_get().filter(|text| !text.is_empty())
        {
            return text;
        }
        self.own.borrow().clone()
    }

    /// Puts a text on it.
    pub fn keep(&self, text: String) {
        #[cfg(feature = "window")]
        if self.of_system {
            macroquad::miniquad::window::clipboard_set(&text);
        }
        *self.own.borrow_mut() = text;
    }
}

/// What the player did since the last frame, and what is held down now.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Input {
    /// The canvas as it is laid out now.
    pub frame: Frame,
    /// Since the last frame, s.
    pub frame_time: f64,
    /// How much of that the window has waited on purpose, s.
    pub waited: f64,
    /// How long the player has done nothing, s; the app keeps it.
    pub idle: f64,
    /// Another window has the keyboard, or this one is hidden.
    pub away: bool,
    /// Where the pointer is.
    pub pointer: Vec2,
    /// The left button went down.
    pub click: bool,
    /// The left button is down.
    pub holding: bool,
    /// The right button went down.
    pub right_click: bool,
    /// The right or the middle button is down.
    pub dragging: bool,
    /// Notches of the wheel, positive away from the player (up).
    pub wheel: f32,
    /// Keys that went down, also those that are up again by now.
    pub pressed: Keys,
    /// Keys that are down.
    pub held: Keys,
    /// Files and folders that were dropped on the window.
    pub dropped: Vec<PathBuf>,
    /// Characters that were typed, in order.
    pub typed: String,
    /// Those of the keys that went down whose moment is known, in order: not those of a gamepad.
    pub keyed: Vec<Keyed>,
    /// What is copied to be pasted.
    pub clipboard: Clipboard,
    /// The body of the game under the pointer, if there is one.
    pub pointed: Option<BodyId>,
    /// Where in the game's level the pointer is, m, where a game is shown.
    pub place: Option<DVec2>,
    /// What the player has set.
    pub settings: Settings,
    /// What the buttons made of it, also of a copy that leaves something out: they say so with [`Input::answer`].
    pub answer: Rc<Cell<Option<Answer>>>,
}

impl Input {
    /// Whether the key went down: true in one frame for one press.
    pub fn pressed(&self, key: Key) -> bool {
        has(self.pressed, key)
    }

    /// Whether a key went down that does this in flight.
    pub fn acts(&self, action: Action) -> bool {
        self.settings.keys.does(action, self.pressed)
    }

    /// Whether a key is down that does this in flight.
    pub fn keeps(&self, action: Action) -> bool {
        self.settings.keys.does(action, self.held)
    }

    /// Whether something went down, was turned, typed or dropped.
    pub fn has_news(&self) -> bool {
        let pointer = self.click || self.right_click || self.wheel != 0.0;
        pointer || !self.pressed.is_empty() || !self.typed.is_empty() || !self.dropped.is_empty()
    }

    /// How long the last frame took to be made, s: 0 only where no time has passed.
    pub fn worked(&self) -> f64 {
        if self.frame_time > 0.0 { (self.frame_time - self.waited).max(f64::MIN_POSITIVE) } else { 0.0 }
    }

    /// What was typed and which of `keys` went down, in order; of keys whose moment is not known it is at the end.
    pub fn strokes(&self, keys: &[Key]) -> Vec<Stroke> {
        // Systems type the letter of a command, too.
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

    /// The same moment once everything new in it has been taken: no time has passed and nothing was pressed, turned or typed.
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

    /// A button says what it made of this input; a press goes before a move.
    pub fn answer(&self, answer: Answer) {
        if self.answer.get() != Some(Answer::Pressed) {
            self.answer.set(Some(answer));
        }
    }

    /// Whether the key is down.
    pub fn held(&self, key: Key) -> bool {
        has(self.held, key)
    }
}

/// Whether a key is among those, or the button of a gamepad that does the same.
fn has(keys: Keys, key: Key) -> bool {
    keys.has(key) || key.on_pad().is_some_and(|pad| keys.has(pad))
}

/// Keeps what was pressed until a tick has taken it: a press shorter than a frame is not lost in a frame without a tick, and is not
/// repeated in a frame with two.
#[derive(Clone, Copy, Debug, Default)]
pub struct KeyLatch {
    held: Keys,
    pressed: Keys,
}

impl KeyLatch {
    /// Takes note of a frame.
    pub fn frame(&mut self, input: &Input) {
        self.held = input.held;
        self.pressed = self.pressed | input.pressed;
    }

    /// The keys of the next tick.
    pub fn take(&mut self) -> Keys {
        self.held | std::mem::take(&mut self.pressed)
    }
}

/// How long a key is held before it repeats, s.
const REPEAT_AFTER: f64 = 0.4;
/// From one repetition to the next, s.
const REPEAT_EVERY: f64 = 0.05;

/// Repeats keys that are held, for moving through text and lists. Buttons never repeat.
#[derive(Clone, Debug, Default)]
pub struct Repeat {
    key: Option<Key>,
    /// Until the next repetition, s.
    wait: f64,
}

impl Repeat {
    /// How often each of `keys` acts in this frame; call it once a frame, with all keys of one screen.
    pub fn strokes(&mut self, input: &Input, keys: &[Key]) -> Vec<Key> {
        let mut strokes: Vec<Key> = keys.iter().copied().filter(|key| input.pressed(*key)).collect();
        if let Some(last) = strokes.last() {
            *self = Self { key: Some(*last), wait: REPEAT_AFTER };
        } else if let Some(key) = self.key.filter(|key| input.held(*key)) {
            self.wait -= input.frame_time;
            if self.wait <= 0.0 {
                // At most one a frame: a hitch must not run to the end of the list.
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
        copy.answer(Answer::Moved);
        assert_eq!(input.answer.get(), Some(Answer::Moved));
        copy.answer(Answer::Pressed);
        input.answer(Answer::Moved);
        assert_eq!(input.answer.get(), Some(Answer::Pressed));
        input.without_edges().answer(Answer::Moved);
        assert_eq!(input.answer.get(), Some(Answer::Pressed), "the same moment again answers nothing");
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
