//! A slider: a knob on a track, dragged by the pointer, and moved by left and right where it has the focus.

use super::{Touch, Ui, WidgetKind};
use crate::draw::Colour;
use crate::draw::layout::{Area, Vec2};
use crate::settings::Key;
use crate::view::{theme, widgets as paint};

/// Radius of the knob, in heights of the slider.
const KNOB: f32 = 0.26;
/// Canvas units.
const TRACK: f32 = 3.0;
const MARK: f32 = 2.0;

/// A slider as it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderShown {
    /// The knob's place on the track, 0 … 1.
    pub part: f64,
    /// The place of a mark for comparison, 0 … 1.
    pub mark: f64,
    /// Its colour; `None`: the slider is closed.
    pub knob: Option<Colour>,
}

/// The player's act with a slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SliderMove {
    /// To that place, 0 … 1; `goes_on` in all frames of a drag but its first.
    To { part: f64, goes_on: bool },
    /// +1 by the right key, −1 by the left one.
    Step(f64),
}

impl Ui<'_> {
    /// Its ends are inside the area by the knob's radius.
    pub fn slider(&mut self, label: &str, area: Area, shown: &SliderShown) -> Option<SliderMove> {
        let Touch { focus, .. } = self.touch(label, area, WidgetKind::Slider);
        let held = self.is_live() && self.memory.held.as_deref() == Some(label);
        let (knob, y) = (KNOB * area.size.y, area.centre().y);
        let (begins, length) = (area.min.x + knob, area.size.x - 2.0 * knob);
        let place = |part: f64| Vec2::new(begins + length * part.clamp(0.0, 1.0) as f32, y);
        let canvas = self.canvas();
        canvas.line(place(0.0), place(1.0), TRACK, theme::solid());
        let (mark, half) = (place(shown.mark), Vec2::new(0.0, knob));
        canvas.line(mark - half, mark + half, MARK, theme::quiet());
        if focus {
            paint::focus_ring(canvas, area);
        }
        let colour = shown.knob?;
        canvas.disc(place(shown.part), knob, if held { theme::accent() } else { colour });
        if !self.acting {
            return None;
        }
        let keys = [(Key::Right, 1.0), (Key::Left, -1.0)];
        if let Some((_, step)) = keys.into_iter().find(|(key, _)| focus && self.key(*key)) {
            return Some(SliderMove::Step(step));
        }
        let part = f64::from(((self.input.pointer.x - begins) / length).clamp(0.0, 1.0));
        // A click that moves nothing changes nothing: the value need not lie on a whole pixel.
        let moved = held && (part - shown.part).abs() > 0.5 / f64::from(length);
        moved.then_some(SliderMove::To { part, goes_on: !self.input.click })
    }

    /// Notches of the wheel with the pointer in that area, positive upwards.
    pub fn wheel(&self, area: Area) -> f32 {
        let here = self.acting && self.is_live() && area.contains(self.input.pointer);
        if here { self.input.wheel } else { 0.0 }
    }
}
