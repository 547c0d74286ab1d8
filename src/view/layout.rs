//! Where things go: sizes and boxes on the virtual canvas. Plain arithmetic, so that the screens are laid out and tested without a
//! window.

use crate::game::Game;
pub use glam::Vec2;

/// The canvas on which every screen is designed; a window of another shape gets more of it along one axis, never less.
pub const DESIGN: Vec2 = Vec2::new(1280.0, 720.0);
/// No text is drawn smaller than this, physical pixels.
pub const SMALLEST_TEXT: f32 = 12.0;

/// Height of the text in details boxes.
pub const DETAILS: f32 = 13.0;
/// Height of running text.
pub const TEXT: f32 = 18.0;
/// Height of the words on buttons.
pub const BUTTON_TEXT: f32 = 24.0;
/// Height of headings.
pub const HEADING: f32 = 40.0;
/// Height of the title.
pub const TITLE: f32 = 84.0;
/// Every size of text that is used: their glyphs are made ready before they are drawn.
pub const TEXT_SIZES: [f32; 5] = [DETAILS, TEXT, BUTTON_TEXT, HEADING, TITLE];
/// From one line of text to the next, in heights of the text.
pub const LINE: f32 = 1.35;
/// Width of every glyph of the monospaced face, in heights of the text.
pub const MONO_ADVANCE: f32 = 0.602;

/// Width of the widest usual line of words, in heights of the text and for each character: a bound that needs no typeface.
const WIDE_ADVANCE: f32 = 0.62;

/// Widths of the words' face from the space to the tilde, in thousandths of the height of the text.
const ADVANCES: [u16; 95] = [
    228, 274, 392, 653, 564, 831, 648, 240, 310, 310, 472, 564, 246, 282, 246, 359, 564, 564, 564, 564, 564, 564, 564, 564, 564,
    564, 246, 246, 564, 564, 564, 380, 940, 641, 630, 609, 702, 555, 520, 658, 692, 248, 487, 599, 502, 865, 709, 774, 592, 774,
    618, 517, 548, 680, 624, 921, 608, 569, 560, 310, 359, 310, 564, 490, 376, 509, 583, 460, 583, 548, 376, 573, 569, 237, 237,
    495, 255, 863, 569, 582, 583, 583, 374, 428, 387, 569, 480, 775, 499, 474, 455, 319, 262, 319, 564,
];
/// A line of words reaches from here above the middle of its capitals to there below it, in heights of the text.
const LINE_REACH: (f32, f32) = (0.37, 0.57);

/// The width of a line of words in the unit of `height`, the height of its letters; of signs beyond ASCII a bound.
pub fn words_width(words: &str, height: f32) -> f32 {
    let advance =
        |sign: char| (sign as usize).checked_sub(32).and_then(|i| ADVANCES.get(i)).map_or(WIDE_ADVANCE, |a| f32::from(*a) / 1000.0);
    words.chars().map(advance).sum::<f32>() * height
}

/// The box of a line of words, from the left end of the middle of its capitals.
pub fn words_box(words: &str, height: f32, from: Vec2) -> Area {
    let (above, below) = LINE_REACH;
    Area { min: from - Vec2::new(0.0, above * height), size: Vec2::new(words_width(words, height), (above + below) * height) }
}

/// The size of type next to one that is wanted.
pub fn nearest_size(wanted: f32) -> f32 {
    TEXT_SIZES.into_iter().min_by(|a, b| (a - wanted).abs().total_cmp(&(b - wanted).abs())).unwrap_or(wanted)
}

/// Width and height of the room that a line of words may need at most, in the unit of `height`, the height of its letters.
pub fn text_room(words: &str, height: f32) -> Vec2 {
    Vec2::new(words.chars().count() as f32 * WIDE_ADVANCE, LINE) * height
}

/// A text in lines of at most `columns` characters, cut between words where it can be; those after the first are set in by `indent`.
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
/// Radius of a panel's corners.
pub const CORNER: f32 = 8.0;
/// From a panel's edge to what is in it.
pub const PADDING: f32 = 16.0;
/// Width of a panel's edge.
pub const EDGE: f32 = 2.0;
/// A button in a column.
pub const WIDE_BUTTON: Vec2 = Vec2::new(320.0, 48.0);
/// A button in a row.
pub const ROW_BUTTON: Vec2 = Vec2::new(200.0, 48.0);
/// Between two buttons.
pub const GAP: f32 = 16.0;

/// A box on the canvas, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Area {
    /// Its top left corner.
    pub min: Vec2,
    /// Its width and height.
    pub size: Vec2,
}

impl Area {
    /// The box of that corner and size.
    pub const fn new(x: f32, y: f32, width: f32, height: f32) -> Self {
        Self { min: Vec2::new(x, y), size: Vec2::new(width, height) }
    }

    /// The box of that size around a point.
    pub fn around(centre: Vec2, size: Vec2) -> Self {
        Self { min: centre - size / 2.0, size }
    }

    /// Its bottom right corner.
    pub fn max(&self) -> Vec2 {
        self.min + self.size
    }

    /// Its middle.
    pub fn centre(&self) -> Vec2 {
        self.min + self.size / 2.0
    }

    /// Whether a point lies in it.
    pub fn contains(&self, point: Vec2) -> bool {
        point.cmpge(self.min).all() && point.cmplt(self.max()).all()
    }

    /// The gap to another box; negative where they overlap.
    pub fn gap(&self, other: &Self) -> f32 {
        (other.min - self.max()).max(self.min - other.max()).max_element()
    }

    /// Whether it overlaps none of the others.
    pub fn covers_none(&self, others: &[Self]) -> bool {
        others.iter().all(|other| self.gap(other) >= 0.0)
    }

    /// From where to where, seen from its start, a line is inside; `None` where it passes by.
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

/// The canvas as the window shows it now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Its width and height in canvas units: at least [`DESIGN`].
    pub size: Vec2,
    /// Canvas units a physical pixel.
    pub pixel: f32,
    /// How large words are, 1 as designed.
    pub text: f32,
}

impl Frame {
    /// The canvas in a window of so many physical pixels: one scale for both axes, so that all of [`DESIGN`] is in view.
    pub fn of_window(pixels: Vec2) -> Self {
        let pixels = pixels.max(Vec2::ONE);
        let pixel = (DESIGN / pixels).max_element();
        Self { size: pixels * pixel, pixel, text: 1.0 }
    }

    /// The same with words `text` times as large as designed.
    #[must_use]
    pub const fn with_text(self, text: f32) -> Self {
        Self { text, ..self }
    }

    /// The whole canvas as a box.
    pub fn area(&self) -> Area {
        Area { min: Vec2::ZERO, size: self.size }
    }

    /// The height at which text of that size is drawn: itself, or what is legible in a small window.
    pub fn text_height(&self, size: f32) -> f32 {
        (size * self.text / self.pixel).round().max(SMALLEST_TEXT) * self.pixel
    }

    /// A column of `count` wide buttons whose top is at `top`, in the middle of the canvas.
    pub fn column(&self, count: usize, top: f32) -> Vec<Area> {
        let left = (self.size.x - WIDE_BUTTON.x) / 2.0;
        let pitch = WIDE_BUTTON.y + GAP;
        (0..count).map(|i| Area::new(left, top + i as f32 * pitch, WIDE_BUTTON.x, WIDE_BUTTON.y)).collect()
    }

    /// A row of `count` buttons with their tops at `top`, in the middle of the canvas.
    pub fn row(&self, count: usize, top: f32) -> Vec<Area> {
        let pitch = ROW_BUTTON.x + GAP;
        let left = (self.size.x - (count as f32 * pitch - GAP)) / 2.0;
        (0..count).map(|i| Area::new(left + i as f32 * pitch, top, ROW_BUTTON.x, ROW_BUTTON.y)).collect()
    }
}

impl Default for Frame {
    fn default() -> Self {
        Self { size: DESIGN, pixel: 1.0, text: 1.0 }
    }
}

/// Width and height of the fuel bar in the head-up display as shares of the window's.
const BAR: Vec2 = Vec2::new(0.75, 0.03);
/// Height of its panel at the top left.
const STATUS_HEIGHT: f32 = 72.0;
/// Width of a ghost's column in a race, in heights of text.
const RACE_COLUMN: f32 = 6.6;

/// Where the parts of the head-up display stand: nothing else should cover them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HudLayout {
    /// Timer and objectives, at the top left.
    pub status: Area,
    /// The fuel bar, at the bottom centre.
    pub fuel: Area,
}

impl HudLayout {
    /// The places on a canvas.
    pub fn new(frame: &Frame) -> Self {
        let bar = frame.size * BAR;
        let left = (frame.size.x - bar.x) / 2.0;
        Self {
            status: Area::new(
                2.0 * GRID,
                2.0 * GRID,
                15.2 * frame.text_height(TEXT),
                STATUS_HEIGHT.max(frame.text_height(TEXT) * 3.2),
            ),
            fuel: Area::new(left, frame.size.y - bar.y - 2.0 * GRID, bar.x, bar.y),
        }
    }

    /// Its parts where it is shown: in a game in which the ship plays a part.
    pub fn shown(frame: &Frame, game: &Game) -> Vec<Area> {
        if game.level().ship_plays() { Self::new(frame).areas().to_vec() } else { Vec::new() }
    }

    /// Where a race stands: a strip beside the timer, with a column for each of so many ghosts.
    pub fn race(&self, frame: &Frame, ghosts: usize) -> Area {
        let left = self.status.max().x + GRID;
        let column = RACE_COLUMN * frame.text_height(TEXT);
        let width = (column * ghosts as f32).min(frame.size.x - left - 2.0 * GRID);
        Area::new(left, self.status.min.y, width, frame.text_height(TEXT) * 2.8)
    }

    /// Every part.
    pub fn areas(&self) -> [Area; 2] {
        [self.status, self.fuel]
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
        let column = frame.column(2, 100.0);
        assert_eq!(column[0].min.x, frame.size.x - column[0].max().x);
        assert_eq!(column[1].min.y - column[0].max().y, GAP);
    }
}
