//! Where things go: sizes and boxes on the virtual canvas. Plain arithmetic, without a window.

use super::text;
pub use glam::Vec2;

/// The canvas on which every screen is designed; a window of another shape gets more of it along one axis, never less.
pub const DESIGN: Vec2 = Vec2::new(1280.0, 720.0);
/// Words that can be read from the back of a classroom, canvas units: those of a page grow up to this, if the player wants them large.
pub const LEGIBLE: f32 = 24.0;
/// The smallest text, physical pixels.
pub const SMALLEST_TEXT: f32 = 12.0;

/// Height of the text in details boxes.
pub const DETAILS: f32 = 13.0;
pub const TEXT: f32 = 18.0;
pub const BUTTON_TEXT: f32 = 24.0;
pub const HEADING: f32 = 40.0;
pub const TITLE: f32 = 84.0;
pub const TEXT_SIZES: [f32; 5] = [DETAILS, TEXT, BUTTON_TEXT, HEADING, TITLE];
/// From one line of text to the next, in heights of the text.
pub const LINE: f32 = 1.35;
/// Width of every glyph of the monospaced face, in heights of the text.
pub const MONO_ADVANCE: f32 = 0.602;

/// Width of the widest usual line of words, in heights of the text and for each character: a bound that needs no typeface.
const WIDE_ADVANCE: f32 = 0.62;

/// The reach of a line of words above and below the middle of its capitals, in heights of the text.
const LINE_REACH: (f32, f32) = (0.37, 0.57);

/// The width of a line of words in the unit of `height`, the height of its letters.
pub fn words_width(words: &str, height: f32) -> f32 {
    text::width(words, text::Typeface::Sans, height)
}

/// The box of a line of words, from the left end of the middle of its capitals.
pub fn words_box(words: &str, height: f32, from: Vec2) -> Area {
    let (above, below) = LINE_REACH;
    Area { min: from - Vec2::new(0.0, above * height), size: Vec2::new(words_width(words, height), (above + below) * height) }
}

/// The size of type next to the wanted one.
pub fn nearest_size(wanted: f32) -> f32 {
    TEXT_SIZES.into_iter().min_by(|a, b| (a - wanted).abs().total_cmp(&(b - wanted).abs())).unwrap_or(wanted)
}

/// An upper bound of the room of a line of words, in the unit of `height`, the height of its letters.
pub fn text_room(words: &str, height: f32) -> Vec2 {
    Vec2::new(words.chars().count() as f32 * WIDE_ADVANCE, LINE) * height
}

/// Signs before which a language leaves a gap.
const SIGNS: [&str; 5] = [":", ";", "?", "!", "»"];

/// Words in lines that are at most `widest` wide.
pub fn lines(words: &str, widest: f32, width: impl Fn(&str) -> f32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}")) <= widest => {
                line.push(' ');
                line.push_str(word);
            }
            // No line begins with a sign: the word before it comes along.
            Some(line) if SIGNS.contains(&word) && line.contains(' ') => {
                let before = line.split_off(line.rfind(' ').unwrap_or(line.len()));
                lines.push(format!("{} {word}", before.trim_start()));
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Lines of at most `columns` characters, cut between words where a cut fits; lines after the first are indented by `indent`.
pub fn wrapped(text: &str, columns: usize, indent: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let (mut line, mut length) = (String::new(), 0);
    let mut end = |line: &mut String, length: &mut usize| {
        lines.push(line.trim_end().to_owned());
        *line = " ".repeat(indent);
        *length = indent;
    };
    for word in text.split_inclusive(' ') {
        if !line.trim().is_empty() && length + word.trim_end().chars().count() > columns {
            end(&mut line, &mut length);
        }
        for character in word.chars() {
            // A line takes one character at least, however far it is set in.
            if length >= columns && character != ' ' && !line.trim().is_empty() {
                end(&mut line, &mut length);
            }
            line.push(character);
            length += 1;
        }
    }
    end(&mut line, &mut length);
    lines
}

/// The step of the grid on which everything stands.
pub const GRID: f32 = 8.0;
pub const CORNER: f32 = 8.0;
pub const PADDING: f32 = 16.0;
pub const EDGE: f32 = 2.0;
pub const WIDE_BUTTON: Vec2 = Vec2::new(320.0, 48.0);
pub const ROW_BUTTON: Vec2 = Vec2::new(200.0, 48.0);
pub const GAP: f32 = 16.0;
/// Between a row of buttons and the canvas' sides, a tool bar and its foot.
pub const MARGIN: f32 = 24.0;

/// A box on the canvas, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Area {
    pub min: Vec2,
    pub size: Vec2,
}

impl Area {
    pub const fn new(x: f32, y: f32, width: f32, height: f32) -> Self {
        Self { min: Vec2::new(x, y), size: Vec2::new(width, height) }
    }

    pub fn around(centre: Vec2, size: Vec2) -> Self {
        Self { min: centre - size / 2.0, size }
    }

    pub fn max(&self) -> Vec2 {
        self.min + self.size
    }

    pub fn centre(&self) -> Vec2 {
        self.min + self.size / 2.0
    }

    /// In order round, from the top left.
    pub fn corners(&self) -> [Vec2; 4] {
        let (a, b) = (self.min, self.max());
        [a, Vec2::new(b.x, a.y), b, Vec2::new(a.x, b.y)]
    }

    /// The point at parts (0 … 1) of the width to the right and of the height upwards.
    pub fn part(&self, (right, up): (f64, f64)) -> Vec2 {
        Vec2::new(self.min.x + self.size.x * right as f32, self.max().y - self.size.y * up as f32)
    }

    pub fn contains(&self, point: Vec2) -> bool {
        point.cmpge(self.min).all() && point.cmplt(self.max()).all()
    }

    /// The gap to another box; negative where they overlap.
    pub fn gap(&self, other: &Self) -> f32 {
        (other.min - self.max()).max(self.min - other.max()).max_element()
    }

    pub fn covers_none(&self, others: &[Self]) -> bool {
        others.iter().all(|other| self.gap(other) >= 0.0)
    }

    /// The interval of distances from `from` within which a line lies inside; `None` where it passes by.
    pub fn stretch(&self, from: Vec2, along: Vec2, length: f32) -> Option<(f32, f32)> {
        let (mut enters, mut leaves) = (0.0_f32, length);
        for axis in 0..2 {
            let (low, high) = (self.min[axis] - from[axis], self.max()[axis] - from[axis]);
            if along[axis] == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
                continue;
            }
            let (a, b) = (low / along[axis], high / along[axis]);
            (enters, leaves) = (enters.max(a.min(b)), leaves.min(a.max(b)));
        }
        (enters < leaves).then_some((enters, leaves))
    }

    /// The box whose edges lie `by` further in (or out, where negative).
    pub fn inset(&self, by: f32) -> Self {
        Self { min: self.min + by, size: self.size - 2.0 * by }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Canvas units: at least [`DESIGN`].
    pub size: Vec2,
    /// Canvas units a physical pixel.
    pub pixel: f32,
    /// Scale of the words, 1 as designed.
    pub text: f32,
    /// Words do not grow beyond this height, canvas units.
    pub most: f32,
}

impl Frame {
    /// The canvas in a window of this size in physical pixels: one scale for both axes, all of [`DESIGN`] in view.
    pub fn of_window(pixels: Vec2) -> Self {
        let pixels = pixels.max(Vec2::ONE);
        let pixel = (DESIGN / pixels).max_element();
        Self { size: pixels * pixel, pixel, text: 1.0, most: f32::INFINITY }
    }

    /// Words are `text` times as large as designed.
    #[must_use]
    pub const fn with_text(self, text: f32) -> Self {
        Self { text, ..self }
    }

    /// The same, but for words that are larger than [`LEGIBLE`] by then.
    #[must_use]
    pub const fn with_legible(self, text: f32) -> Self {
        Self { text, most: LEGIBLE, ..self }
    }

    pub fn area(&self) -> Area {
        Area { min: Vec2::ZERO, size: self.size }
    }

    /// The drawn height of text of that size: the legible minimum in a small window, else the size itself.
    pub fn text_height(&self, size: f32) -> f32 {
        ((size * self.text).min(size.max(self.most)) / self.pixel).round().max(SMALLEST_TEXT) * self.pixel
    }

    /// Wide buttons from `top` down, in the middle of the canvas.
    pub fn column(&self, count: usize, top: f32) -> Vec<Area> {
        let left = (self.size.x - WIDE_BUTTON.x) / 2.0;
        (0..count).map(|i| Area::new(left, top + i as f32 * (WIDE_BUTTON.y + GAP), WIDE_BUTTON.x, WIDE_BUTTON.y)).collect()
    }

    /// Buttons beside each other at `top`, in the middle of the canvas; narrower where there are many.
    pub fn row(&self, count: usize, top: f32) -> Vec<Area> {
        self.row_of(&vec![0.0; count], top)
    }

    /// The same, each at least that wide, as far as the canvas is.
    pub fn row_of(&self, least: &[f32], top: f32) -> Vec<Area> {
        let count = least.len().max(1) as f32;
        let room = self.size.x - 2.0 * MARGIN + GAP;
        let usual = (room / count).min(ROW_BUTTON.x + GAP) - GAP;
        let fits = |part: f32| least.iter().map(|width| width.max(part) + GAP).sum::<f32>() <= room + 0.01;
        // Where words need more, the others have less.
        let part = (0..=10).map(|step| usual * (1.0 - 0.1 * step as f32)).find(|part| fits(*part)).unwrap_or(0.0);
        let whole: f32 = least.iter().map(|width| width.max(part) + GAP).sum();
        let (shrunk, mut left) = ((room / whole).min(1.0), (self.size.x - whole.min(room) + GAP) / 2.0);
        let place = |width: &f32| {
            let pitch = (width.max(part) + GAP) * shrunk;
            left += pitch;
            Area::new(left - pitch, top, pitch - GAP, ROW_BUTTON.y)
        };
        least.iter().map(place).collect()
    }
}

impl Default for Frame {
    fn default() -> Self {
        Self { size: DESIGN, pixel: 1.0, text: 1.0, most: f32::INFINITY }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_window_shows_the_whole_design_at_one_scale() {
        for (w, h) in [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0), (500.0, 1200.0), (2560.0, 400.0)] {
            let frame = Frame::of_window(Vec2::new(w, h));
            assert!(frame.size.x >= DESIGN.x - 1e-3 && frame.size.y >= DESIGN.y - 1e-3, "{w} × {h}: {frame:?}");
            assert!((frame.size / Vec2::new(w, h) - frame.pixel).abs().max_element() < 1e-5, "{w} × {h}: {frame:?}");
        }
    }

    #[test]
    fn text_stays_legible_in_a_small_window() {
        let small = Frame::of_window(Vec2::new(900.0, 500.0));
        for size in TEXT_SIZES {
            assert!(small.text_height(size) / small.pixel >= SMALLEST_TEXT - 1e-3);
        }
        assert_eq!(Frame::default().text_height(DETAILS), DETAILS);
    }

    #[test]
    fn a_line_is_inside_of_a_box_from_where_it_enters_to_where_it_leaves() {
        let area = Area::new(0.0, 0.0, 1000.0, 500.0);
        let stretch = |x: f32, y: f32, along: Vec2, length: f32| area.stretch(Vec2::new(x, y), along, length);
        assert_eq!(stretch(100.0, 100.0, Vec2::X, 50.0), Some((0.0, 50.0)));
        assert_eq!(stretch(100.0, 100.0, Vec2::X, 1e9), Some((0.0, 900.0)));
        assert_eq!(stretch(100.0, 900.0, -Vec2::Y, 1e9), Some((400.0, 900.0)));
        assert_eq!(stretch(-100.0, 100.0, -Vec2::X, 1e9), None);
        assert_eq!(stretch(100.0, 900.0, Vec2::X, 1e9), None);
    }

    #[test]
    fn long_lines_are_cut_between_words_and_lose_nothing() {
        assert_eq!(wrapped("· one two three", 46, 2), ["· one two three"]);
        assert_eq!(wrapped("· one two three four", 9, 2), ["· one two", "  three", "  four"]);
        assert_eq!(wrapped("· incompressible", 16, 2), ["· incompressible"]);
        assert_eq!(wrapped("ab cdefgh", 3, 0), ["ab", "cde", "fgh"]);
        assert_eq!(wrapped("", 3, 2), [""]);
        assert_eq!(wrapped("abc", 1, 4), ["a", "    b", "    c"], "no room is still room for one character");
        let text = "world.csv:3: column \"width\": found a-word-that-is-longer-than-the-whole-panel, expected > 0";
        for columns in [20, 30, 200] {
            let lines = wrapped(text, columns, 4);
            assert!(lines.iter().all(|line| line.chars().count() <= columns), "{lines:?}");
            assert_eq!(lines.concat().replace(' ', ""), text.replace(' ', ""));
        }
    }

    #[test]
    fn a_row_and_a_column_stand_in_the_middle() {
        let frame = Frame::default();
        let row = frame.row(3, 600.0);
        assert_eq!(row[0].min.x, frame.size.x - row[2].max().x);
        assert_eq!(row[1].min.x - row[0].max().x, GAP);
        let full = frame.row(7, 600.0);
        assert!((full[0].min.x - MARGIN).abs() < 1e-3 && (frame.size.x - full[6].max().x - MARGIN).abs() < 1e-3, "{full:?}");
        let column = frame.column(2, 100.0);
        assert_eq!(column[0].min.x, frame.size.x - column[0].max().x);
        assert_eq!(column[1].min.y - column[0].max().y, GAP);
    }
}
