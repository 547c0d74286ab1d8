//! The editor's panes, each as wide as its words need: tools at the left, the panel at the right, problems below, commands above, picture between.

use crate::draw::layout::{Area, DETAILS, Frame, LINE, MONO_ADVANCE, TEXT, Vec2};
use crate::level::document::SETTINGS;

/// A command: the height of its two lines in heights of their texts, and the width of its key, in letters.
const TWO_LINES: f32 = 1.15;
const COMMAND: f32 = 7.4;
/// The commands, and the room between them for the level's name, in letters: where it is missing they take two rows.
const COMMANDS: f32 = 11.0;
const NAME: f32 = 8.0;
/// Width of the tools: their mark and the space around it, and their longest name in heights of text.
const TOOL_MARK: f32 = 50.0;
const TOOL_NAME: f32 = 5.7;
/// The longest name of a column, and the room of a cell in its field, in letters.
const LABEL: f32 = 13.2;
const CELL: f32 = 15.0;
/// The level in small, in a window of the design's size, canvas units.
const MAP: Vec2 = Vec2::new(160.0, 96.0);
/// From the edge of a pane to its contents, and between two buttons, canvas units.
pub const INSIDE: f32 = 8.0;
pub const BETWEEN: f32 = 4.0;
pub const PROBLEM_LINES: usize = 4;
const OFFERS: usize = 8;
/// The most room of the heading above the fields, canvas units.
const HEAD: f32 = 60.0;

/// How large words are in a window with `pixel` canvas units a pixel: they grow less than a large window.
pub fn text_scale(pixel: f32) -> f32 {
    (1.25 * pixel).clamp(0.75, 1.0)
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Panes {
    pub top: Area,
    pub left: Area,
    pub right: Area,
    pub bottom: Area,
    pub middle: Area,
    pub map: Area,
    /// From one line of small text to the next.
    pub line: f32,
    /// From one field to the next.
    pub field: f32,
    /// Width of a letter of small text.
    pub letter: f32,
    command: Vec2,
    /// From the right pane's top to its first field.
    head: f32,
    text: f32,
}

impl Panes {
    pub fn new(frame: &Frame, problems: usize) -> Self {
        let height_of_text = frame.text_height(DETAILS);
        let (line, letter, text) = (height_of_text * LINE, height_of_text * MONO_ADVANCE, frame.text.min(1.0));
        let Vec2 { x: width, y: height } = frame.size;
        let high = (height_of_text + frame.text_height(TEXT)) * TWO_LINES + 1.5 * INSIDE;
        let command = Vec2::new(COMMAND * letter + 3.0 * INSIDE, high - 2.0 * BETWEEN);
        let in_a_row = COMMANDS * (command.x + BETWEEN) + NAME * letter <= width;
        let top = if in_a_row { high } else { 2.0 * high - BETWEEN };
        let head = (3.0 * INSIDE + 2.0 * line).min(HEAD);
        let left = TOOL_MARK + TOOL_NAME * height_of_text;
        let right = (LABEL + CELL) * letter + 5.0 * INSIDE;
        let bottom = (problems as f32 + 1.0) * line + 1.5 * INSIDE;
        let middle = Area::new(left, top, width - left - right, height - top - bottom);
        let map = MAP * text;
        Self {
            top: Area::new(0.0, 0.0, width, top),
            left: Area::new(0.0, top, left, height - top),
            right: Area::new(width - right, top, right, height - top),
            bottom: Area::new(left, height - bottom, width - left - right, bottom),
            middle,
            map: Area { min: middle.max() - Vec2::splat(1.5 * INSIDE) - map, size: map },
            line,
            field: (frame.text_height(TEXT) * 1.5).max(28.0 * text).min((height - top - head) / SETTINGS.len() as f32),
            letter,
            command,
            head,
            text,
        }
    }

    /// Commands from the left, and from the right in the same row or the one below; the room of the level's name beside the latter.
    pub fn commands(&self, left: usize, right: usize) -> (Vec<Area>, Area) {
        let (size, end) = (self.command, self.top.size.x - INSIDE);
        let low = self.top.size.y - BETWEEN - size.y;
        let from_left = (0..left).map(|i| Vec2::new(INSIDE + i as f32 * (size.x + BETWEEN), BETWEEN));
        let from_right = (0..right).map(|i| Vec2::new(end - (right - i) as f32 * (size.x + BETWEEN) + BETWEEN, low));
        let areas: Vec<Area> = from_left.chain(from_right).map(|min| Area { min, size }).collect();
        let before = areas[..left].last().filter(|area| area.min.y == low).map_or(0.0, |area| area.max().x);
        let name =
            Area::new(before + INSIDE, low, areas[left..].first().map_or(end, |area| area.min.x) - before - 2.0 * INSIDE, size.y);
        (areas, name)
    }

    pub fn tools(&self, count: usize) -> Vec<Area> {
        let pitch = ((self.left.size.y - INSIDE) / count as f32).min(44.0 * self.text);
        let size = Vec2::new(self.left.size.x - 2.0 * INSIDE, pitch - BETWEEN);
        (0..count).map(|i| Area { min: self.left.min + Vec2::new(INSIDE, INSIDE / 2.0 + i as f32 * pitch), size }).collect()
    }

    /// The field of a column, counted from 0 below the panel's heading.
    pub fn field(&self, index: usize) -> Area {
        let top = self.right.min.y + self.head + index as f32 * self.field;
        let left = self.right.min.x + 2.0 * INSIDE + LABEL * self.letter;
        // Large words stand closer.
        let apart = (self.field - self.letter / MONO_ADVANCE).clamp(1.0, BETWEEN);
        Area::new(left, top, self.right.max().x - INSIDE - left, self.field - apart)
    }

    /// The line of a picture that is offered, counted from 0, below `fields` fields and a heading.
    pub fn offer(&self, fields: usize, index: usize) -> Area {
        let top = self.field(fields).min.y + (index + 1) as f32 * self.line;
        Area::new(self.right.min.x + INSIDE, top, self.right.size.x - 2.0 * INSIDE, self.line)
    }

    pub fn offers(&self, fields: usize) -> usize {
        (((self.right.max().y - self.offer(fields, 0).min.y) / self.line) as usize).min(OFFERS)
    }

    /// The line of a problem, counted from 0.
    pub fn problem(&self, index: usize) -> Area {
        let top = self.bottom.min.y + 0.75 * INSIDE + (index + 1) as f32 * self.line;
        Area::new(self.bottom.min.x + INSIDE, top, self.bottom.size.x - 2.0 * INSIDE - 16.0, self.line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_fill_the_window_and_do_not_overlap() {
        for (width, height) in [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0), (800.0, 800.0)] {
            let frame = Frame::of_window(Vec2::new(width, height));
            let frame = frame.with_text(text_scale(frame.pixel));
            let parts = Panes::new(&frame, PROBLEM_LINES);
            let sum: f32 = [parts.top, parts.left, parts.right, parts.bottom, parts.middle]
                .iter()
                .map(|part| part.size.element_product())
                .sum();
            assert!((sum / frame.size.element_product() - 1.0).abs() < 1e-4, "{width} × {height}");
            let share = |problems: usize| Panes::new(&frame, problems).middle.size.element_product() / frame.size.element_product();
            let least = if width < 1000.0 { 0.5 } else { 0.6 };
            assert!(share(0) > least, "the picture has {} of {width} × {height}", share(0));
            assert!(parts.offer(13, 3).max().y < frame.size.y, "thirteen columns: {width} × {height}");
            assert!(parts.offer(16, 0).max().y < frame.size.y, "the settings: {width} × {height}");
            assert!(parts.tools(16).last().unwrap().max().y <= frame.size.y);
            assert!(parts.problem(PROBLEM_LINES - 1).max().y <= frame.size.y + 0.1);
            let (commands, name) = parts.commands(8, 3);
            assert!(name.size.x >= NAME * parts.letter && parts.offers(13) >= 3);
            assert!(commands[7].max().x < commands[8].min.x && commands[10].max().x <= width.max(frame.size.x));
        }
    }
}
