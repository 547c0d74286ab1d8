//! Where the editor's parts are: tools at the left, what is selected at the right, problems below, a row of commands above.

use crate::view::layout::{Area, DETAILS, Frame, LINE, TEXT, Vec2};

/// Height of the row of commands.
pub const TOP: f32 = 56.0;
/// Width of the tools.
const LEFT: f32 = 148.0;
/// Width of the panel of what is selected.
const RIGHT: f32 = 324.0;
/// Width of the level in small.
const MAP: f32 = 160.0;
/// From the edge of a part to what is in it, and between two buttons.
pub const INSIDE: f32 = 8.0;
pub const BETWEEN: f32 = 4.0;
/// How many problems are in view.
pub const PROBLEM_LINES: usize = 4;

/// The parts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    pub top: Area,
    pub left: Area,
    pub right: Area,
    pub bottom: Area,
    /// The picture.
    pub middle: Area,
    /// The level in small, beside the problems.
    pub map: Area,
    /// From one line of small text to the next.
    pub line: f32,
    /// From one field to the next.
    pub field: f32,
}

impl Parts {
    /// The parts in that frame.
    pub fn new(frame: &Frame) -> Self {
        let line = frame.text_height(DETAILS) * LINE;
        let Vec2 { x: width, y: height } = frame.size;
        let bottom = (PROBLEM_LINES as f32 + 1.0) * line + 2.5 * INSIDE;
        let middle = Area::new(LEFT, TOP, width - LEFT - RIGHT, height - TOP - bottom);
        let map = Vec2::new(MAP, bottom - 2.0 * INSIDE);
        Self {
            top: Area::new(0.0, 0.0, width, TOP),
            left: Area::new(0.0, TOP, LEFT, height - TOP),
            right: Area::new(width - RIGHT, TOP, RIGHT, height - TOP),
            bottom: Area::new(LEFT, height - bottom, width - LEFT - RIGHT, bottom),
            middle,
            map: Area { min: Vec2::new(middle.max().x - INSIDE - MAP, height - bottom + INSIDE), size: map },
            line,
            field: (frame.text_height(TEXT) * 1.5).max(28.0),
        }
    }

    /// A row of commands from the left, and as many from the right.
    pub fn commands(&self, left: usize, right: usize) -> Vec<Area> {
        let size = Vec2::new(76.0, TOP - 2.0 * BETWEEN);
        let from_left = (0..left).map(|i| INSIDE + i as f32 * (size.x + BETWEEN));
        let from_right = (0..right).map(|i| self.top.size.x - INSIDE - (right - i) as f32 * (size.x + BETWEEN) + BETWEEN);
        from_left.chain(from_right).map(|x| Area { min: Vec2::new(x, BETWEEN), size }).collect()
    }

    /// A column of tools.
    pub fn tools(&self, count: usize) -> Vec<Area> {
        let pitch = ((self.left.size.y - INSIDE) / count as f32).min(44.0);
        let size = Vec2::new(self.left.size.x - 2.0 * INSIDE, pitch - BETWEEN);
        (0..count).map(|i| Area { min: self.left.min + Vec2::new(INSIDE, INSIDE / 2.0 + i as f32 * pitch), size }).collect()
    }

    /// The field of a column, counted from 0 below the panel's heading.
    pub fn field(&self, index: usize) -> Area {
        let top = self.right.min.y + 3.0 * INSIDE + 2.0 * self.line + index as f32 * self.field;
        Area::new(self.right.min.x + 140.0, top, 124.0, self.field - BETWEEN)
    }

    /// The line of a problem, counted from 0.
    pub fn problem(&self, index: usize) -> Area {
        let top = self.bottom.min.y + INSIDE + (index + 1) as f32 * self.line;
        Area::new(self.bottom.min.x + INSIDE, top, self.bottom.size.x - 4.0 * INSIDE - MAP - 16.0, self.line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_fill_the_window_and_do_not_overlap() {
        for (width, height) in [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0), (800.0, 800.0)] {
            let frame = Frame::of_window(Vec2::new(width, height));
            let parts = Parts::new(&frame);
            let sum: f32 = [parts.top, parts.left, parts.right, parts.bottom, parts.middle]
                .iter()
                .map(|part| part.size.element_product())
                .sum();
            assert!((sum / frame.size.element_product() - 1.0).abs() < 1e-4, "{width} × {height}");
            assert!(parts.field(13).max().y < frame.size.y, "fourteen columns: {width} × {height}");
            assert!(parts.tools(16).last().unwrap().max().y <= frame.size.y);
            assert!(parts.problem(PROBLEM_LINES - 1).max().y <= frame.size.y + 0.1);
            let commands = parts.commands(8, 3);
            assert!(commands[7].max().x < commands[8].min.x && commands[10].max().x <= width.max(frame.size.x));
        }
    }
}
