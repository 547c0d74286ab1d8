//! Tooltips: words beside the pointer, above all else.

use super::Ui;
use crate::draw::layout::{Area, DETAILS, GRID, Vec2};
use crate::draw::{Canvas, Style};
use crate::view::{theme, widgets as paint};
use crate::words::tr;

/// The longest line, canvas units.
const WIDEST: f32 = 360.0;
/// From the pointer to the box: right of and below the arrow.
const BESIDE: Vec2 = Vec2::new(14.0, 22.0);

impl Ui<'_> {
    /// Shows these words while the pointer is in that area, and no button is down.
    pub fn tip(&mut self, area: Area, words: &str) {
        self.note_tip(area, words, None);
    }

    /// The same with the foot of its box at that height, so that it covers nothing below.
    pub fn tip_above(&mut self, area: Area, words: &str, foot: f32) {
        self.note_tip(area, words, Some(foot));
    }

    fn note_tip(&mut self, area: Area, words: &str, foot: Option<f32>) {
        if self.is_live() && !self.input.holding && area.contains(self.input.pointer) {
            self.tip = Some((tr(words).to_owned(), foot));
        }
    }

    /// Draws the tooltip of the pass.
    pub(super) fn draw_tip(&self) {
        if let Some((words, foot)) = &self.tip {
            draw(self.canvas, words, (self.input.pointer, *foot));
        }
    }
}

/// Above that foot; else below the pointer, or above it where there is no room.
fn draw(canvas: &Canvas, words: &str, (pointer, foot): (Vec2, Option<f32>)) {
    let (style, line) = (Style::new(DETAILS, theme::text()), canvas.line_height(DETAILS));
    let lines = paint::lines(canvas, words, WIDEST, style);
    let widest = lines.iter().map(|words| canvas.width(words, style)).fold(0.0, f32::max);
    let size = Vec2::new(widest, lines.len() as f32 * line) + Vec2::new(2.0, 1.0) * GRID;
    let below = pointer + BESIDE;
    let beside = if below.y + size.y > canvas.size().y { pointer.y - GRID - size.y } else { below.y };
    let y = foot.map_or(beside, |foot| foot - size.y);
    let most = (canvas.size() - size).max(Vec2::ZERO);
    let area = Area { min: Vec2::new(below.x, y).clamp(Vec2::ZERO, most), size };
    canvas.end_layer();
    paint::panel_in(canvas, area, theme::panel_hover(), theme::solid_top());
    for (i, words) in lines.iter().enumerate() {
        canvas.text(words, area.min + Vec2::new(GRID, 0.5 * GRID + i as f32 * line), style);
    }
}
