//! Widgets without a window. A screen is one function over a [`Ui`]: it names its widgets, which are laid out and recorded on a
//! [`Canvas`], and the same call returns the player's input to each. The first pass of a frame acts: it sees presses, and its picture is
//! dropped. The others show, without presses and time; the last one is the picture. Labels identify widgets; [`Memory`] keeps their state.

mod entry;
pub mod input;
pub mod keyboard;
mod memory;
pub mod pace;
pub mod prompt;
pub mod scroll;
pub mod text_field;
mod widgets;

pub use entry::{EntryEvent, EntryField, SliderMove, SliderShown};
pub use memory::{Memory, Spectator, Widget, WidgetKind};
pub use widgets::{FieldEvent, Rows, Touch, Turning};

use crate::draw::Canvas;
use crate::draw::layout::{Area, Frame, Vec2};
use crate::settings::{Action, Key, Keys};
use input::Input;
use memory::PassShown;

pub struct Ui<'a> {
    input: &'a Input,
    canvas: &'a Canvas,
    memory: &'a mut Memory,
    /// Watches the ticks of a game that the screen flies.
    pub spectator: &'a mut dyn Spectator,
    shown: PassShown,
    group: usize,
    /// Age of the screen, s: carets blink by it.
    time: f64,
    acting: bool,
    by_pointer: bool,
    /// The words beside the pointer, and the foot of its box where it has a place of its own.
    tip: Option<(String, Option<f32>)>,
}

/// The parts of a pass outside the screen's memory.
pub struct PassInput<'a> {
    pub input: &'a Input,
    pub canvas: &'a Canvas,
    pub spectator: &'a mut dyn Spectator,
    /// Age of the screen, s.
    pub time: f64,
}

impl Memory {
    /// The pass that acts, on the widgets of the last frame.
    pub fn act<T>(&mut self, stage: PassInput<'_>, screen: impl FnOnce(&mut Ui<'_>) -> T) -> T {
        self.follow(stage.input);
        self.pass(stage, true, screen).0
    }

    /// A pass that shows, with an input without presses.
    pub fn show<T>(&mut self, stage: PassInput<'_>, screen: impl FnOnce(&mut Ui<'_>) -> T) -> T {
        self.pressed = None;
        let (result, shown) = self.pass(stage, false, screen);
        self.adopt(shown);
        result
    }

    fn pass<T>(&mut self, stage: PassInput<'_>, acting: bool, screen: impl FnOnce(&mut Ui<'_>) -> T) -> (T, PassShown) {
        let PassInput { input, canvas, spectator, time } = stage;
        let shown = PassShown::default();
        let mut ui = Ui { input, canvas, memory: self, spectator, shown, group: 0, time, acting, by_pointer: false, tip: None };
        let result = screen(&mut ui);
        ui.draw_tip();
        (result, ui.shown)
    }
}

impl<'a> Ui<'a> {
    /// All input, also to widgets.
    pub fn input(&self) -> &'a Input {
        self.input
    }

    pub fn canvas(&self) -> &'a Canvas {
        self.canvas
    }

    pub fn frame(&self) -> Frame {
        self.input.frame
    }

    /// Age of the screen, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    pub fn opens(&self) -> bool {
        self.memory.frames == 0
    }

    /// Whether the present layer is the topmost one: the others answer nothing.
    pub fn is_live(&self) -> bool {
        self.shown.layer == self.memory.shown.layer
    }

    pub fn key(&self, key: Key) -> bool {
        self.is_live() && self.input.pressed(key)
    }

    pub fn acts(&self, action: Action) -> bool {
        self.is_live() && self.input.acts(action)
    }

    /// How often each of these keys acts in this frame; a held key repeats. Claims the keys. Call it once a frame.
    pub fn strokes(&mut self, keys: &[Key]) -> Vec<Key> {
        self.claim(keys.iter().copied());
        if self.is_live() { self.memory.repeat.strokes(self.input, keys) } else { Vec::new() }
    }

    /// These keys are the screen's own: no widget answers them.
    pub fn claim(&mut self, keys: impl IntoIterator<Item = Key>) {
        self.shown.claimed = self.shown.claimed | keys.into_iter().collect::<Keys>();
    }

    /// From the ends of a column arrows go on at its other end.
    pub fn wrap(&mut self) {
        self.shown.wraps = true;
    }

    /// No widget answers in the next frame: all its input is the screen's own.
    pub fn capture(&mut self) {
        self.shown.captured = true;
    }

    /// The following widgets are another group for the Tab key.
    pub fn group(&mut self) {
        self.group += 1;
    }

    /// The following widgets lie above all before, which is darkened and answers nothing any more.
    pub fn layer(&mut self, darkened: f32) {
        crate::view::widgets::curtain(self.canvas, darkened);
        let layer = self.shown.layer + 1;
        self.shown = PassShown { layer, ..PassShown::default() };
        (self.group, self.tip) = (0, None);
    }

    /// Focuses the widget of that label when the layer opens.
    pub fn start_at(&mut self, label: &str) {
        self.shown.start = Some(label.to_owned());
    }

    /// Focuses the widget of that label; `None`: the layer's default.
    pub fn focus(&mut self, label: Option<&str>) {
        self.memory.focus_on(label);
    }

    /// Whether a widget of the last frame is there.
    pub fn has_widget_at(&self, at: Vec2) -> bool {
        self.memory.widgets().iter().any(|widget| widget.area.contains(at))
    }

    pub fn has_focus(&self, label: &str) -> bool {
        self.is_live() && self.memory.focused() == Some(label)
    }

    /// These widgets answer the pointer alone: the keys have other work. An open entry keeps its keys.
    pub fn by_pointer<T>(&mut self, show: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.by_pointer, true);
        let result = show(self);
        self.by_pointer = before;
        result
    }

    /// A widget whose drawing is the screen's own. The second of two with the same label gets another label.
    pub fn touch(&mut self, label: &str, area: Area, kind: WidgetKind) -> Touch {
        let mut label = label.to_owned();
        while self.shown.widgets.iter().any(|widget| widget.label == label) {
            label.push('′');
        }
        let kind = if self.by_pointer { kind.by_pointer() } else { kind };
        let is = |known: Option<&str>| self.is_live() && known == Some(&label);
        let (hover, focus, pressed) = (is(self.memory.hovered()), is(self.memory.focused()), is(self.memory.pressed.as_deref()));
        self.shown.widgets.push(Widget { label, area, kind, group: self.group });
        Touch { hover, focus, pressed }
    }
}

#[cfg(test)]
mod tests;
