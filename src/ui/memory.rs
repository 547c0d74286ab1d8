//! The memory of a screen's widgets from frame to frame: focus, highlight under the pointer, position of each list. Listeners of the game.

use super::input::{ButtonAnswer, Input, Repeat};
use super::scroll::Scroll;
use crate::{draw::layout::Area, draw::layout::Vec2, game::Game, settings::Key, settings::Keys};
use std::collections::BTreeMap;

/// The inputs that a widget answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WidgetKind {
    /// Pointer and keyboard.
    Button,
    /// The pointer alone: its key is the screen's affair.
    Tool,
    /// Both; left and right change its value.
    Choice,
    /// Both; the pointer drags it, left and right move it.
    Slider,
    /// The pointer alone, which drags it.
    Knob,
    /// Both; characters go into it.
    Field,
    /// Arrow keys alone: a row of a list beyond its view, which scrolls there.
    Beyond,
}

impl WidgetKind {
    fn has_focus(self) -> bool {
        !matches!(self, Self::Tool | Self::Knob)
    }

    fn has_pointer(self) -> bool {
        self != Self::Beyond
    }

    /// The same without the keyboard.
    pub(super) const fn by_pointer(self) -> Self {
        match self {
            Self::Button | Self::Choice => Self::Tool,
            Self::Slider => Self::Knob,
            Self::Tool | Self::Knob | Self::Field | Self::Beyond => self,
        }
    }
}

/// A widget in the last frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Widget {
    /// No two of a layer have the same label.
    pub label: String,
    /// Canvas units.
    pub area: Area,
    pub kind: WidgetKind,
    /// Tab goes to the first widget of the next group.
    pub(super) group: usize,
}

/// The widget with the focus, and its place.
#[derive(Clone, Debug, Default, PartialEq)]
struct Spot {
    label: String,
    centre: Vec2,
}

/// The widgets and keys of one pass over a screen.
#[derive(Debug, Default)]
pub(super) struct PassShown {
    /// Of the topmost layer.
    pub widgets: Vec<Widget>,
    pub layer: usize,
    /// The screen takes these keys itself.
    pub claimed: Keys,
    /// No widget answers.
    pub captured: bool,
    /// The widget that has the focus by default.
    pub start: Option<String>,
    /// From the ends of a column arrows go on at its other end.
    pub wraps: bool,
}

#[derive(Debug, Default)]
pub struct Memory {
    pub(super) shown: PassShown,
    /// One a layer.
    focus: Vec<Option<Spot>>,
    pub(super) hover: Option<String>,
    pub(super) pressed: Option<String>,
    /// The dragged widget.
    pub(super) held: Option<String>,
    /// `None` before the first frame: a pointer at rest takes nothing from the keyboard.
    pointer: Option<Vec2>,
    pub(super) scrolls: BTreeMap<String, Scroll>,
    pub(super) repeat: Repeat,
    pub(super) frames: usize,
    settled: bool,
}

impl Memory {
    pub fn widgets(&self) -> &[Widget] {
        &self.shown.widgets
    }

    pub fn focused(&self) -> Option<&str> {
        Some(&self.focus.get(self.shown.layer)?.as_ref()?.label)
    }

    /// The label of the widget under the pointer, where the pointer moved last.
    pub fn hovered(&self) -> Option<&str> {
        self.hover.as_deref()
    }

    /// Whether the last frame has shown the present focus.
    pub fn is_settled(&self) -> bool {
        self.settled
    }

    /// Focuses a widget of the topmost layer; `None`: the screen's default.
    pub(super) fn focus_on(&mut self, label: Option<&str>) {
        let spot = label.map(|label| {
            let centre = self.find(label).map_or(Vec2::ZERO, |widget| widget.area.centre());
            Spot { label: label.to_owned(), centre }
        });
        self.focus.resize(self.shown.layer + 1, None);
        self.focus[self.shown.layer] = spot;
    }

    pub(super) fn follow(&mut self, input: &Input) {
        if self.shown.captured {
            (self.pressed, self.held) = (None, None);
            return;
        }
        let before = (self.hover.clone(), self.focused().map(str::to_owned));
        self.pressed = self.press(input);
        self.hold(input);
        if self.pressed.is_some() {
            input.answer(ButtonAnswer::Pressed);
        } else if self.focused() != before.1.as_deref() || self.hover != before.0 && self.hover.is_some() {
            input.answer(ButtonAnswer::Moved);
        }
    }

    /// Takes over the widgets of a pass. The focus stays on its label; where the label is gone it goes to the nearest widget.
    pub(super) fn adopt(&mut self, shown: PassShown) {
        let before = (self.shown.layer, self.focused().map(str::to_owned));
        self.shown = shown;
        self.focus.resize(self.shown.layer + 1, None);
        let in_view = || self.shown.widgets.iter().filter(|widget| widget.kind.has_focus() && widget.kind.has_pointer());
        let far = |widget: &&Widget, centre: Vec2| widget.area.centre().distance_squared(centre);
        let next = match &self.focus[self.shown.layer] {
            Some(spot) => in_view()
                .find(|widget| widget.label == spot.label)
                .or_else(|| in_view().min_by(|a, b| far(a, spot.centre).total_cmp(&far(b, spot.centre)))),
            None => in_view().find(|widget| Some(&widget.label) == self.shown.start.as_ref()).or_else(|| in_view().next()),
        };
        let spot = next.map(|widget| Spot { label: widget.label.clone(), centre: widget.area.centre() });
        self.focus[self.shown.layer] = spot;
        self.settled = before == (self.shown.layer, self.focused().map(str::to_owned));
        self.frames += 1;
    }

    /// The pointer holds the dragged widget that it pressed as long as its button is down.
    fn hold(&mut self, input: &Input) {
        if input.click {
            let dragged = |widget: &&Widget| matches!(widget.kind, WidgetKind::Slider | WidgetKind::Knob);
            let pressed = self.pressed.as_deref().and_then(|label| self.find(label)).filter(dragged);
            self.held = pressed.map(|widget| widget.label.clone());
        } else if !input.holding {
            self.held = None;
        }
    }

    fn find(&self, label: &str) -> Option<&Widget> {
        self.shown.widgets.iter().find(|widget| widget.label == label)
    }

    fn focused_widget(&self) -> Option<&Widget> {
        self.find(self.focused()?)
    }

    fn takes(&self, input: &Input, key: Key) -> bool {
        input.pressed(key) && !self.shown.claimed.has(key)
    }

    /// The label of the pressed widget.
    fn press(&mut self, input: &Input) -> Option<String> {
        // Later widgets lie above earlier ones.
        let under =
            self.shown.widgets.iter().rfind(|widget| widget.kind.has_pointer() && widget.area.contains(input.pointer)).cloned();
        let label = under.as_ref().map(|widget| widget.label.clone());
        let moved = self.pointer.replace(input.pointer).is_some_and(|before| before != input.pointer);
        if moved || input.click || label != self.hover {
            self.hover = label.filter(|_| moved || input.click);
            // A field keeps its selection until it is clicked.
            let takes_focus = |widget: &&Widget| widget.kind.has_focus() && (input.click || widget.kind != WidgetKind::Field);
            if let (Some(label), Some(_)) = (&self.hover, under.as_ref().filter(takes_focus)) {
                self.focus_on(Some(&label.clone()));
            }
        }
        if let (true, Some(widget)) = (input.click, under) {
            return (widget.kind != WidgetKind::Field).then_some(widget.label);
        }
        self.walk(input);
        let focused = self.focused_widget().filter(|_| self.takes(input, Key::Enter));
        focused.map(|widget| widget.label.clone())
    }

    /// Arrow keys go to the nearest widget in their direction, Tab to the next group.
    fn walk(&mut self, input: &Input) {
        for (key, direction) in [(Key::Up, Vec2::NEG_Y), (Key::Down, Vec2::Y), (Key::Left, Vec2::NEG_X), (Key::Right, Vec2::X)] {
            let sideways = |it: &Widget| matches!(it.kind, WidgetKind::Choice | WidgetKind::Slider | WidgetKind::Field);
            let kept = direction.x != 0.0 && self.focused_widget().is_some_and(sideways);
            if self.takes(input, key) && !kept {
                self.hover = None;
                if let Some(label) = self.neighbour(direction) {
                    self.focus_on(Some(&label));
                }
            }
        }
        let group = self.focused_widget().map_or(0, |widget| widget.group);
        if self.takes(input, Key::Tab) && self.shown.widgets.iter().any(|widget| widget.group != group) {
            let first = |wanted: &dyn Fn(usize) -> bool| self.shown.widgets.iter().find(|widget| wanted(widget.group));
            let next = first(&|other| other == group + 1).or_else(|| first(&|_| true)).map(|widget| widget.label.clone());
            self.focus_on(next.as_deref());
        }
    }

    /// The nearest widget in a direction; a widget straight ahead goes before one aside.
    fn neighbour(&self, direction: Vec2) -> Option<String> {
        let from = self.focused_widget()?.area.centre();
        let distance = |widget: &Widget| {
            let path = widget.area.centre() - from;
            let ahead = path.dot(direction);
            (ahead > 1.0).then(|| ahead + 2.0 * (path - direction * ahead).length())
        };
        let able = self.shown.widgets.iter().filter(|widget| widget.kind.has_focus());
        let candidates = able.filter_map(|widget| Some((widget, distance(widget)?)));
        let next = candidates.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(widget, _)| widget);
        let behind = |widget: &Widget| (from - widget.area.centre()).dot(direction);
        let straight = |widget: &&Widget| (widget.area.centre() - from).perp_dot(direction).abs() < 1.0;
        let able = self.shown.widgets.iter().filter(|widget| self.shown.wraps && widget.kind.has_focus());
        let end = || able.filter(straight).max_by(|a, b| behind(a).total_cmp(&behind(b)));
        next.or_else(end).map(|widget| widget.label.clone())
    }
}

/// Watches attempts tick by tick: particles, sound, the cost of a tick. It changes nothing in them.
pub trait Spectator {
    fn begins(&mut self, _game: &Game) {}
    /// Before each tick.
    fn before_tick(&mut self) {}
    /// After each tick, whose events are in the game.
    fn after_tick(&mut self, _game: &Game) {}
    /// The game has jumped to another moment.
    fn jumped(&mut self, _game: &Game) {}
    /// The attempt goes on in a level that was edited meanwhile.
    fn goes_on(&mut self, _game: &Game) {}
    /// Frames a second of the window; 0 without one.
    fn frames(&self) -> f64 {
        0.0
    }
}

impl Spectator for () {}
