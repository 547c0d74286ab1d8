//! The panel stands at the top right, a line below the other.

use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, Vec2};

/// Widths in heights of the text: of a line's name, slider, number and reset.
const COLUMNS: [f32; 4] = [7.2, 6.0, 7.2, 6.6];
/// Between two columns, and inside the panel's edge.
const GAP: f32 = GRID;
const INSIDE: f32 = 1.5 * GRID;
/// Besides the lines: a heading, two rows of buttons, a message.
const ROWS: f32 = 4.0;
/// The room of a line above its text where the canvas is high enough.
const LEADING: f32 = 8.0;
/// Above and below a button.
const APART: f32 = 2.0;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Layout {
    pub panel: Area,
    /// From the start, from now, reset all, save.
    pub buttons: [Area; 4],
    /// For the name field and for messages.
    pub field: Area,
    top: f32,
    line: f32,
    /// Begin and end of each column.
    columns: [(f32, f32); 4],
}

impl Layout {
    /// On a canvas, with that many lines; closer where they would not fit.
    pub fn new(frame: &Frame, lines: usize) -> Self {
        let text = frame.text_height(DETAILS);
        let rows = lines as f32 + ROWS;
        let room = frame.size.y - 2.0 * GRID - 2.0 * INSIDE - 3.25 * GAP;
        let line = (text * LINE + LEADING).min(room / rows).max(text + 2.0 * APART).floor();
        let width = COLUMNS.iter().sum::<f32>() * text + 3.0 * GAP + 2.0 * INSIDE;
        let min = Vec2::new(frame.size.x - 2.0 * GRID - width, 2.0 * GRID);
        let mut left = min.x + INSIDE;
        let columns = COLUMNS.map(|column| {
            let (begins, ends) = (left, left + column * text);
            left = ends + GAP;
            (begins, ends)
        });
        let row = |index: f32| min.y + INSIDE + index * line;
        let half = (width - 2.0 * INSIDE - GAP) / 2.0;
        let button = |index: usize, y: f32| {
            let x = min.x + INSIDE + index as f32 * (half + GAP);
            inner(Area::new(x, y, half, line))
        };
        let top = row(2.0) + 1.5 * GAP;
        let foot = top + lines as f32 * line + GAP;
        let field = Area::new(min.x + INSIDE, foot + line + 0.75 * GAP, width - 2.0 * INSIDE, line);
        Self {
            panel: Area { min, size: Vec2::new(width, field.max().y + INSIDE - min.y) },
            buttons: [button(0, row(1.0) + 0.5 * GAP), button(1, row(1.0) + 0.5 * GAP), button(0, foot), button(1, foot)],
            field: inner(field),
            top,
            line,
            columns,
        }
    }

    pub fn heading(&self) -> Area {
        Area::new(self.columns[0].0, self.panel.min.y + INSIDE, self.panel.size.x - 2.0 * INSIDE, self.line)
    }

    /// At the right end of the heading: to the other lines.
    pub fn page(&self) -> Area {
        let (left, right) = (self.columns[2].0, self.columns[3].1);
        inner(Area::new(left, self.heading().min.y, right - left, self.line))
    }

    /// All of a line, across the panel.
    pub fn row(&self, line: usize) -> Area {
        Area::new(self.panel.min.x, self.top + line as f32 * self.line, self.panel.size.x, self.line)
    }

    /// Name, slider, number and reset of a line.
    pub fn cells(&self, line: usize) -> [Area; 4] {
        let row = self.row(line);
        let cell = |(begins, ends): (f32, f32)| Area::new(begins, row.min.y, ends - begins, row.size.y);
        let [name, slider, number, reset] = self.columns.map(cell);
        [name, slider, inner(number), inner(reset)]
    }
}

/// Apart from its neighbours above and below.
fn inner(cell: Area) -> Area {
    Area::new(cell.min.x, cell.min.y + APART, cell.size.x, cell.size.y - 2.0 * APART)
}
