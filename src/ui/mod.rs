//! Widgets without a window. A screen is one function over a [`Ui`]: it says what is there, which is laid out and recorded on a
//! [`Canvas`], and learns in the same call what the player did with it, by mouse, keys and gamepad.
//!
//! A frame runs a screen's function twice or more. The first pass acts: it sees what was pressed, and nothing of it is shown. The passes
//! after it show: nothing is pressed in them, no time passes, and what the last of them records is the picture. A widget is known by its
//! label; between frames [`Memory`] keeps the focus, the highlight and how far lists are scrolled.

pub mod input;
mod memory;
pub mod scroll;
mod spectator;
pub mod text_field;
mod widgets;

pub use memory::{Memory, Widget, WidgetKind};
pub use spectator::Spectator;
pub use widgets::{Rows, Touch, Turning, Typed};

use crate::draw::Canvas;
use crate::draw::layout::{Area, Frame};
use crate::settings::{Action, Key, Keys};
use input::Input;
use memory::PassShown;

/// One pass over a screen.
pub struct Ui<'a> {
    input: &'a Input,
    canvas: &'a Canvas,
    memory: &'a mut Memory,
    /// Watches the ticks of a game that the screen flies.
    pub spectator: &'a mut dyn Spectator,
    shown: PassShown,
    group: usize,
    /// How long the screen has been there, s: carets blink by it.
    time: f64,
}

/// What a pass needs besides the memory of the screen.
pub struct PassInput<'a> {
    /// What the player did.
    pub input: &'a Input,
    /// Where it is drawn.
    pub canvas: &'a Canvas,
    /// Watches the ticks of a game.
    pub spectator: &'a mut dyn Spectator,
    /// How long the screen has been there, s.
    pub time: f64,
}

impl Memory {
    /// The pass that acts: the screen learns what was done with the widgets of the last frame.
    pub fn act<T>(&mut self, stage: PassInput<'_>, screen: impl FnOnce(&mut Ui<'_>) -> T) -> T {
        self.follow(stage.input);
        self.pass(stage, screen).0
    }

    /// A pass that shows, with an input in which nothing is pressed.
    pub fn show<T>(&mut self, stage: PassInput<'_>, screen: impl FnOnce(&mut Ui<'_>) -> T) -> T {
        self.pressed = None;
        let (result, shown) = self.pass(stage, screen);
        self.adopt(shown);
        result
    }

    fn pass<T>(&mut self, stage: PassInput<'_>, screen: impl FnOnce(&mut Ui<'_>) -> T) -> (T, PassShown) {
        let PassInput { input, canvas, spectator, time } = stage;
        let mut ui = Ui { input, canvas, memory: self, spectator, shown: PassShown::default(), group: 0, time };
        let result = screen(&mut ui);
        (result, ui.shown)
    }
}

impl<'a> Ui<'a> {
    /// All that the player did, also with widgets.
    pub fn input(&self) -> &'a Input {
        self.input
    }

    /// Where it is drawn.
    pub fn canvas(&self) -> &'a Canvas {
        self.canvas
    }

    /// The canvas as it is laid out now.
    pub fn frame(&self) -> Frame {
        self.input.frame
    }

    /// How long the screen has been there, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Whether the screen shows its first frame.
    pub fn opens(&self) -> bool {
        self.memory.is_new()
    }

    /// Whether the layer that is being shown is the topmost one: the others answer nothing.
    pub fn is_live(&self) -> bool {
        self.shown.layer == self.memory.layer()
    }

    /// Whether the key went down.
    pub fn key(&self, key: Key) -> bool {
        self.is_live() && self.input.pressed(key)
    }

    /// Whether a key went down that does this in flight.
    pub fn acts(&self, action: Action) -> bool {
        self.is_live() && self.input.acts(action)
    }

    /// How often each of these keys acts in this frame; a key that is held repeats. They are the screen's own: no widget answers them. Call
    /// it once a frame.
    pub fn strokes(&mut self, keys: &[Key]) -> Vec<Key> {
        self.claim(keys.iter().copied());
        if self.is_live() { self.memory.repeat.strokes(self.input, keys) } else { Vec::new() }
    }

    /// These keys are the screen's own: no widget answers them.
    pub fn claim(&mut self, keys: impl IntoIterator<Item = Key>) {
        self.shown.claimed = self.shown.claimed | keys.into_iter().collect::<Keys>();
    }

    /// No widget answers anything in the next frame: all that is done then is the screen's own.
    pub fn capture(&mut self) {
        self.shown.captured = true;
    }

    /// The widgets that follow are another group for the Tab key.
    pub fn group(&mut self) {
        self.group += 1;
    }

    /// What follows lies above all before it, which is darkened and answers nothing any more.
    pub fn layer(&mut self, darkened: f32) {
        crate::view::widgets::curtain(self.canvas, darkened);
        let layer = self.shown.layer + 1;
        self.shown = PassShown { layer, ..PassShown::default() };
        self.group = 0;
    }

    /// The widget of that label has the focus when the layer opens.
    pub fn start_at(&mut self, label: &str) {
        self.shown.start = Some(label.to_owned());
    }

    /// The widget of that label has the focus from now on; `None`: the one that the layer begins with.
    pub fn focus(&mut self, label: Option<&str>) {
        self.memory.focus_on(label);
    }

    /// Whether the widget of that label has the focus.
    pub fn has_focus(&self, label: &str) -> bool {
        self.is_live() && self.memory.focused() == Some(label)
    }

    /// A widget whose drawing is the screen's own. Of two that have the same label the second is called otherwise.
    pub fn touch(&mut self, label: &str, area: Area, kind: WidgetKind) -> Touch {
        let mut label = label.to_owned();
        while self.shown.widgets.iter().any(|widget| widget.label == label) {
            label.push('′');
        }
        let is = |known: Option<&str>| self.is_live() && known == Some(&label);
        let (hover, focus, pressed) = (is(self.memory.hovered()), is(self.memory.focused()), is(self.memory.pressed.as_deref()));
        self.shown.widgets.push(Widget { label, area, kind, group: self.group });
        Touch { hover, focus, pressed }
    }
}

#[cfg(test)]
mod tests;
