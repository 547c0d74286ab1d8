//! Who and what the game is made of, and under which licences.

use super::scroll::{Bar, Scroll, bar_beside};
use super::{Buttons, Input, Key, Request};
use crate::view::layout::{Area, DETAILS, Frame, GAP, LINE, MONO_ADVANCE, PADDING, ROW_BUTTON, TEXT, Vec2};

/// The game's own licence, word for word.
const LICENCE: &str = include_str!("../../LICENSE");
/// Typefaces, and their licences.
const FONTS: [(&str, &str); 2] = [
    ("Ubuntu Light, a typeface: Dalton Maag, Canonical", "Ubuntu Font Licence 1.0"),
    ("Hack, a typeface: C. Simpkins, DejaVu, Bitstream", "MIT; Bitstream Vera"),
];
/// Crates, by their names before the colon, and their licences.
const CRATES: [(&str, &str); 17] = [
    ("epaint_default_fonts and ttf-parser: typefaces", "MIT or Apache 2.0"),
    ("macroquad and miniquad: window, keys, drawing", "MIT or Apache 2.0"),
    ("gilrs: gamepads", "MIT or Apache 2.0"),
    ("libloading: finds the sound system of Linux", "ISC"),
    ("cpal: sound on Windows and macOS", "Apache 2.0"),
    ("glam: vectors", "MIT or Apache 2.0"),
    ("serde: rows of files as structs", "MIT or Apache 2.0"),
    ("csv: the cells of files", "Unlicense or MIT"),
    ("rand and rand_pcg: random numbers", "MIT or Apache 2.0"),
    ("libm: sines and logarithms, the same everywhere", "MIT"),
    ("clap: the command line", "MIT or Apache 2.0"),
    ("sha2 and unicode-normalization: hashes, names", "MIT or Apache 2.0"),
    ("png: pictures", "MIT or Apache 2.0"),
    ("zip: levels as one file", "MIT"),
    ("tempfile: files that are written whole", "MIT or Apache 2.0"),
    ("libc: how each system opens a file", "MIT or Apache 2.0"),
    ("cpu-time: a clock", "MIT or Apache 2.0"),
];
/// The longest line of the licence, characters.
const MOST_COLUMNS: usize = 78;
/// From the panel's sides to what is in it.
const LEFT: f32 = 2.0 * PADDING;
const RIGHT: f32 = 3.0 * PADDING;
/// From the canvas' edges to the panel.
const MARGIN: Vec2 = Vec2::new(120.0, 112.0);

/// A line of the credits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Line {
    /// A heading.
    Heading(&'static str),
    /// Words.
    Words(&'static str),
    /// A line of a licence.
    Licence(String),
    /// A part, and its licence.
    Part(&'static str, &'static str),
}

/// The credits.
#[derive(Debug)]
pub struct Credits {
    lines: Vec<Line>,
    frame: Frame,
    panel: Area,
    scroll: Scroll,
    back: Buttons,
}

impl Default for Credits {
    fn default() -> Self {
        let (scroll, back) = (Scroll::default(), Buttons::default());
        let mut credits = Self { lines: Vec::new(), frame: Frame::default(), panel: Area::default(), scroll, back };
        credits.place(Frame::default());
        credits
    }
}

impl Credits {
    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        if self.frame != input.frame {
            self.place(input.frame);
        }
        self.scroll.update(input);
        (self.back.update(input).is_some() || input.pressed(Key::Escape)).then_some(Request::Menu)
    }

    /// All that is said.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// The lines in view.
    pub fn range(&self) -> std::ops::Range<usize> {
        self.scroll.range()
    }

    /// The scroll bar, where not all lines are in view.
    pub fn bar(&self) -> Option<Bar> {
        self.scroll.bar()
    }

    /// Its button: Back.
    pub fn buttons(&self) -> &Buttons {
        &self.back
    }

    fn place(&mut self, frame: Frame) {
        self.frame = frame;
        self.panel = Area { min: MARGIN, size: frame.size - 2.0 * MARGIN };
        let panel = self.panel;
        let columns = (panel.size.x - LEFT - RIGHT) / (frame.text_height(DETAILS) * MONO_ADVANCE);
        self.lines = lines((columns as usize).min(MOST_COLUMNS));
        let room = ((panel.size.y - 2.0 * PADDING) / line_height(&frame)).floor().max(1.0) as usize;
        let bar = bar_beside(panel, panel.min.y + PADDING, panel.max().y - PADDING);
        self.scroll.place(self.lines.len(), room, bar);
        self.back.place(frame.row(1, panel.max().y + (MARGIN.y - ROW_BUTTON.y + GAP) / 2.0));
    }
}

/// All that is said, with the licence in lines of at most so many characters.
fn lines(columns: usize) -> Vec<Line> {
    let heading = [Line::Heading("Resultant"), Line::Words("Levels, art, sounds, text and code were made for this game.")];
    let between = [Line::Words(""), Line::Heading("Built with")];
    let parts = FONTS.into_iter().chain(CRATES).map(|(part, licence)| Line::Part(part, licence));
    let own = [Line::Words(""), Line::Heading("The game's licence")];
    let licence = LICENCE.split("\n\n").flat_map(|paragraph| filled(paragraph, columns)).map(Line::Licence);
    heading.into_iter().chain(between).chain(parts).chain(own).chain(licence).collect()
}

/// The words of a paragraph in lines of at most so many characters, and a line of none below them. A longer word has its own line.
fn filled(paragraph: &str, columns: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in paragraph.split_whitespace() {
        let line = lines.len() - 1;
        if lines[line].is_empty() {
            lines[line].push_str(word);
        } else if lines[line].chars().count() + 1 + word.chars().count() <= columns {
            lines[line].push(' ');
            lines[line].push_str(word);
        } else {
            lines.push(word.to_owned());
        }
    }
    lines.push(String::new());
    lines
}

fn line_height(frame: &Frame) -> f32 {
    frame.text_height(TEXT) * LINE
}

mod drawing {
    use super::{Credits, LEFT, Line, MARGIN, RIGHT, line_height};
    use crate::draw::{Canvas, Style};
    use crate::view::layout::{DETAILS, PADDING, TEXT, Vec2};
    use crate::view::{theme, widgets};

    impl Credits {
        /// Draws what is in view.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            widgets::heading(canvas, "Credits", MARGIN.y / 2.0);
            widgets::panel(canvas, self.panel);
            let step = line_height(canvas.frame());
            let (left, right) = (self.panel.min.x + LEFT, self.panel.max().x - RIGHT);
            for (row, line) in self.scroll.range().enumerate() {
                let y = self.panel.min.y + PADDING + (row as f32 + 0.5) * step;
                let style = |colour| Style::new(TEXT, colour).middle();
                match &self.lines[line] {
                    Line::Heading(words) => canvas.text(words, Vec2::new(left, y), style(theme::accent())),
                    Line::Licence(words) => {
                        let mono = Style::new(DETAILS, theme::quiet()).mono().middle();
                        canvas.text(words, Vec2::new(left, y), mono);
                    }
                    Line::Words(words) => canvas.text(words, Vec2::new(left, y), style(theme::text())),
                    Line::Part(part, licence) => {
                        canvas.text(part, Vec2::new(left, y), style(theme::text()));
                        canvas.text(licence, Vec2::new(right, y), style(theme::quiet()).right());
                    }
                }
            }
            if let Some(bar) = self.scroll.bar() {
                widgets::scroll_bar(canvas, bar.track, bar.handle, bar.held);
            }
            if let Some(area) = self.back.areas().first() {
                widgets::button(canvas, *area, "Back", self.back.hover().is_some(), true);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// The crates that the game asks for itself, and miniquad, which is half of macroquad.
    #[test]
    fn the_credits_name_the_crates_that_are_built_in_and_no_other() {
        let mut asked = BTreeSet::from(["miniquad"]);
        let mut wanted = false;
        for line in include_str!("../../Cargo.toml").lines() {
            if line.starts_with('[') {
                wanted = line == "[dependencies]" || line.starts_with("[target.") && line.ends_with(".dependencies]");
            } else if let Some((name, _)) = line.split_once(" = ").filter(|_| wanted && !line.starts_with('#')) {
                asked.insert(name.trim());
            }
        }
        let names = CRATES.iter().flat_map(|(part, _)| part.split_once(": ").unwrap().0.split(" and "));
        assert_eq!(names.collect::<BTreeSet<_>>(), asked);
        let lock = include_str!("../../Cargo.lock").replace("\r\n", "\n");
        let macroquad = lock.split("\n\n").find(|entry| entry.contains("name = \"macroquad\"")).unwrap();
        assert!(macroquad.contains("\"miniquad\""), "{macroquad}");
    }
}
