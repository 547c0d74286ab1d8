//! A chart of several curves, one of which the player picks out: by keys, or by its line in the legend.

use crate::draw::layout::Area;
use crate::settings::Key;
use crate::ui::{Ui, WidgetKind};

/// Height of a page's title, and of its words below the chart.
pub(super) const TITLE: f32 = 40.0;
pub(super) const WORDS: f32 = 56.0;

/// The tool that picks out the next curve.
pub(super) const METHOD: (&str, Key, &str) = ("Method", Key::Down, "↓");

#[derive(Debug, Default)]
pub(super) struct LegendPick {
    picked: Option<usize>,
}

impl LegendPick {
    pub fn clear(&mut self) {
        self.picked = None;
    }

    /// Goes `by` curves on, of `count`: from the last one to none, and on to the first one.
    pub fn go(&mut self, by: isize, count: usize) {
        let place = self.picked.map_or(0, |picked| picked as isize + 1);
        self.picked = usize::try_from((place + by).rem_euclid(count as isize + 1) - 1).ok();
    }

    /// Shows the legend's lines; a click picks one out for good, or not any more. Returns the curve under the pointer, or else the
    /// picked one.
    pub fn show<'l>(&mut self, ui: &mut Ui<'_>, lines: impl Iterator<Item = (&'l str, Area)>) -> Option<usize> {
        let mut pointed = None;
        for (line, (name, area)) in lines.enumerate() {
            let touch = ui.touch(name, area, WidgetKind::Tool);
            if touch.pressed {
                self.picked = if self.picked == Some(line) { None } else { Some(line) };
            }
            pointed = pointed.or(touch.hover.then_some(line));
        }
        pointed.or(self.picked)
    }
}

/// The room of a page's chart.
pub(super) fn panel(body: Area) -> Area {
    Area::new(body.min.x, body.min.y + TITLE, body.size.x, body.size.y - TITLE - WORDS)
}
