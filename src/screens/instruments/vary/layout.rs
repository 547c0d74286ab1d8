//! The panel stands at the top right, a line below the other.

use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, Vec2};

/// Widths in heights of the text: of a line's name, slider, number and reset.
const COLUMNS: [f32; 4] = [7.2, 6.0, 7.2, 6.6];
/// Between two columns, and inside the panel's edge.
const GAP: f32 = GRID;
const INSIDE: f32 = 1.5 * GRID;
/// The room of a line above its text.
const LEADING: f32 = 8.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    FromStart,
    FromNow,
    Restore,
    Save,
}

impl Button {
    pub const ALL: [Self; 4] = [Self::FromStart, Self::FromNow, Self::Restore, Self::Save];
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Layout {
    pub panel: Area,
    pub buttons: [Area; 4],
    /// For the name field and for messages.
    pub field: Area,
    top: f32,
    line: f32,
    /// Begin and end of each column.
    columns: [(f32, f32); 4],
}

impl Layout {
    /// On a canvas, with that many lines.
    pub fn new(frame: &Frame, lines: usize) -> Self {
        let text = frame.text_height(DETAILS);
        let line = (text * LINE + LEADING).round();
        let width = COLUMNS.iter().sum::<f32>() * text + 3.0 * GAP + 2.0 * INSIDE;
        let min = Vec2::new(frame.size.x - 2.0 * GRID - width, 2.0 * GRID);
        let mut left = min.x + INSIDE;
        let columns = COLUMNS.map(|column| {
            let (begins, ends) = (left, left + column * text);
            left = ends + GAP;
            (begins, ends)
        });
        // A heading, a row of buttons, the lines, a row of buttons, a message.
        let row = |index: f32| min.y + INSIDE + index * line;
        let half = (width - 2.0 * INSIDE - GAP) / 2.0;
        let button = |index: usize, y: f32| {
            let x = min.x + INSIDE + index as f32 * (half + GAP);
            Area::new(x, y, half, line)
        };
        let top = row(2.0) + 1.5 * GAP;
        let foot = top + lines as f32 * line + GAP;
        let field = Area::new(min.x + INSIDE, foot + line + 0.75 * GAP, width - 2.0 * INSIDE, line);
        Self {
            panel: Area { min, size: Vec2::new(width, field.max().y + INSIDE - min.y) },
            buttons: [button(0, row(1.0) + 0.5 * GAP), button(1, row(1.0) + 0.5 * GAP), button(0, foot), button(1, foot)],
            field,
            top,
            line,
            columns,
        }
    }

    fn cell(&self, line: usize, column: usize) -> Area {
        let (begins, ends) = self.columns[column];
        Area::new(begins, self.top + line as f32 * self.line, ends - begins, self.line)
    }

    pub fn name(&self, line: usize) -> Area {
        self.cell(line, 0)
    }

    pub fn slider(&self, line: usize) -> Area {
        self.cell(line, 1)
    }

    pub fn number(&self, line: usize) -> Area {
        self.cell(line, 2)
    }

    pub fn reset(&self, line: usize) -> Area {
        self.cell(line, 3)
    }

    pub fn heading(&self) -> Area {
        Area::new(self.columns[0].0, self.panel.min.y + INSIDE, self.panel.size.x - 2.0 * INSIDE, self.line)
    }

    /// `lines` is their number.
    pub fn line_at(&self, at: Vec2, lines: usize) -> Option<usize> {
        (0..lines).find(|line| {
            let (left, right) = (self.panel.min.x, self.panel.max().x);
            let row = self.cell(*line, 0);
            Area::new(left, row.min.y, right - left, row.size.y).contains(at)
        })
    }

    pub fn button_at(&self, at: Vec2) -> Option<Button> {
        Button::ALL.into_iter().zip(self.buttons).find(|(_, area)| area.contains(at)).map(|(button, _)| button)
    }

    /// The part of a slider at a pointer, 0 … 1.
    pub fn part(&self, at: Vec2) -> f64 {
        let (begins, ends) = self.way();
        f64::from(((at.x - begins) / (ends - begins)).clamp(0.0, 1.0))
    }

    /// The ends of sliders: their knobs stay in their column.
    pub fn way(&self) -> (f32, f32) {
        let ((begins, ends), knob) = (self.columns[1], self.knob());
        (begins + knob, ends - knob)
    }

    pub fn knob(&self) -> f32 {
        self.line * 0.26
    }

    /// Half a canvas unit as a part of a slider.
    pub fn half_a_pixel(&self) -> f64 {
        let (begins, ends) = self.way();
        0.5 / f64::from(ends - begins)
    }
}
