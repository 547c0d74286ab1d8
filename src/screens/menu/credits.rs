//! Who and what the game is made of, and under which licences.

use crate::draw::layout::{Area, DETAILS, GAP, LINE, MONO_ADVANCE, PADDING, ROW_BUTTON, TEXT, Vec2, wrapped};
use crate::ui::{Turning, Ui, scroll::bar_beside};
use crate::{draw::Style, settings::Key, words::tr};
use crate::{screens::screen::Request, screens::screen::Screen, view::theme};

const LICENCE: &str = include_str!("../../../LICENSE");
const FONTS: [(&str, &str); 2] = [
    ("Ubuntu Light, a typeface: Dalton Maag, Canonical", "Ubuntu Font Licence 1.0"),
    ("Hack, a typeface: C. Simpkins, DejaVu, Bitstream", "MIT; Bitstream Vera"),
];
/// Crates, by their names before the colon, and their licences.
const CRATES: [(&str, &str); 23] = [
    ("epaint_default_fonts and ttf-parser: typefaces", "MIT or Apache 2.0"),
    ("fontdue: the glyphs of the typefaces", "MIT or Apache 2.0"),
    ("macroquad and miniquad: window, keys, drawing", "MIT or Apache 2.0"),
    ("gilrs: gamepads", "MIT or Apache 2.0"),
    ("libloading: finds the sound system and the keyboard of Linux", "ISC"),
    ("cpal: sound on Windows and macOS", "Apache 2.0"),
    ("glam: vectors", "MIT or Apache 2.0"),
    ("serde: rows of files as structs", "MIT or Apache 2.0"),
    ("csv: the cells of files", "Unlicense or MIT"),
    ("rand and rand_pcg: random numbers", "MIT or Apache 2.0"),
    ("strsim: the word that a misspelt one was meant to be", "MIT"),
    ("libm: sines and logarithms, the same everywhere", "MIT"),
    ("clap: the command line", "MIT or Apache 2.0"),
    ("sha2 and unicode-normalization: hashes, names", "MIT or Apache 2.0"),
    ("base64: flights as text", "MIT or Apache 2.0"),
    ("png: pictures", "MIT or Apache 2.0"),
    ("zip: levels as one file", "MIT"),
    ("serde_json and roxmltree: maps of Tiled", "MIT or Apache 2.0"),
    ("flate2: the tiles of maps", "MIT or Apache 2.0"),
    ("tempfile: files that are written whole", "MIT or Apache 2.0"),
    ("directories: where each system keeps a user's files", "MIT or Apache 2.0"),
    ("libc and rustix: how each system opens and keeps a file", "MIT or Apache 2.0"),
    ("cpu-time: a clock", "MIT or Apache 2.0"),
];
/// The longest line of the licence, characters.
const MOST_COLUMNS: usize = 78;
const LEFT: f32 = 2.0 * PADDING;
const RIGHT: f32 = 3.0 * PADDING;
/// From the canvas' edges to the panel.
const MARGIN: Vec2 = Vec2::new(120.0, 112.0);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Credit {
    Heading(&'static str),
    Words(&'static str),
    Licence(String),
    Part(&'static str, &'static str),
}

#[derive(Debug, Default)]
pub struct Credits {
    columns: usize,
    lines: Vec<Credit>,
}

impl Screen for Credits {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        let frame = ui.frame();
        let panel = Area { min: MARGIN, size: frame.size - 2.0 * MARGIN };
        let columns = (panel.size.x - LEFT - RIGHT) / (frame.text_height(DETAILS) * MONO_ADVANCE);
        let columns = (columns as usize).min(MOST_COLUMNS);
        if self.columns != columns {
            *self = Self { columns, lines: lines(columns) };
        }
        ui.page("Credits", MARGIN.y / 2.0);
        ui.panel(panel);
        let step = frame.text_height(TEXT) * LINE;
        let room = ((panel.size.y - 2.0 * PADDING) / step).floor().max(1.0) as usize;
        let bar = bar_beside(panel, panel.min.y + PADDING, panel.max().y - PADDING);
        let shown = ui.scroll("credits", (self.lines.len(), room), bar, Turning::Lines);
        for (row, line) in self.lines[shown].iter().enumerate() {
            let left = Vec2::new(panel.min.x + LEFT, panel.min.y + PADDING + (row as f32 + 0.5) * step);
            let style = |colour| Style::new(TEXT, colour).middle();
            match line {
                Credit::Heading(words) => ui.text(words, left, style(theme::accent())),
                Credit::Licence(words) => ui.text(words, left, Style { size: DETAILS, ..style(theme::quiet()) }.mono()),
                Credit::Words(words) => ui.text(words, left, style(theme::text())),
                Credit::Part(part, licence) => {
                    ui.text(tr(part), left, style(theme::text()));
                    ui.text(licence, Vec2::new(panel.max().x - RIGHT, left.y), style(theme::quiet()).right());
                }
            }
        }
        let back = ui.row(panel.max().y + (MARGIN.y - ROW_BUTTON.y + GAP) / 2.0, &["Back"]);
        (back.is_some() || ui.key(Key::Escape)).then_some(Request::Pop)
    }
}

/// All that is said, with the licence in lines of `columns` characters at most.
fn lines(columns: usize) -> Vec<Credit> {
    let heading = [Credit::Heading("Resultant"), Credit::Words(tr("Levels, art, sounds, text and code were made for this game."))];
    let between = [Credit::Words(""), Credit::Heading(tr("Built with"))];
    let parts = FONTS.into_iter().chain(CRATES).map(|(part, licence)| Credit::Part(part, licence));
    let own = [Credit::Words(""), Credit::Heading(tr("The game's licence"))];
    // A paragraph, and an empty line below it.
    let filled = |words: &str| {
        wrapped(&words.split_whitespace().collect::<Vec<_>>().join(" "), columns, 0).into_iter().chain([String::new()])
    };
    let licence = LICENCE.split("\n\n").flat_map(filled).map(Credit::Licence);
    heading.into_iter().chain(between).chain(parts).chain(own).chain(licence).collect()
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
        for line in include_str!("../../../Cargo.toml").lines() {
            if line.starts_with('[') {
                wanted = line == "[dependencies]" || line.starts_with("[target.") && line.ends_with(".dependencies]");
            } else if let Some((name, _)) = line.split_once(" = ").filter(|_| wanted && !line.starts_with('#')) {
                asked.insert(name.trim());
            }
        }
        let names = CRATES.iter().flat_map(|(part, _)| part.split_once(": ").unwrap().0.split(" and "));
        assert_eq!(names.collect::<BTreeSet<_>>(), asked);
        let lock = include_str!("../../../Cargo.lock").replace("\r\n", "\n");
        let macroquad = lock.split("\n\n").find(|entry| entry.contains("name = \"macroquad\"")).unwrap();
        assert!(macroquad.contains("\"miniquad\""), "{macroquad}");
    }
}
