//! The two typefaces: the signs that each sets, and their widths.

use std::sync::LazyLock;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Typeface {
    /// For words: Ubuntu Light.
    #[default]
    Sans,
    /// For numbers that change, so that nothing jitters: Hack.
    Mono,
}

impl Typeface {
    pub const fn file(self) -> (&'static str, &'static [u8]) {
        match self {
            Self::Sans => ("Ubuntu Light", epaint_default_fonts::UBUNTU_LIGHT),
            Self::Mono => ("Hack", epaint_default_fonts::HACK_REGULAR),
        }
    }
}

/// Signs that are set in the monospaced face amid words too: the sans face has no arrows, no raised minus and no prime, and its π is hard to read.
const IN_MONO: [char; 7] = ['←', '→', '↑', '↓', 'π', '⁻', '′'];
/// Width of a sign where a typeface cannot be read, in heights of the text.
const UNKNOWN_ADVANCE: f32 = 0.62;

/// The text cut into runs of one face each.
pub fn runs(text: &str, face: Typeface) -> impl Iterator<Item = (&str, Typeface)> {
    let face_of = move |sign: char| if IN_MONO.contains(&sign) { Typeface::Mono } else { face };
    let mut rest = text;
    std::iter::from_fn(move || {
        let face = face_of(rest.chars().next()?);
        let (run, after) = rest.split_at(rest.find(|sign| face_of(sign) != face).unwrap_or(rest.len()));
        rest = after;
        Some((run, face))
    })
}

/// The width of a line of text in the unit of `height`, the height of its letters.
pub fn width(text: &str, face: Typeface, height: f32) -> f32 {
    runs(text, face).map(|(run, face)| run_width(run, face, height)).sum()
}

/// The width of a run of one face in the unit of `height`: the same sum, in the same order, as that of the glyphs on the screen.
pub fn run_width(run: &str, face: Typeface, height: f32) -> f32 {
    let Some(advances) = &FACES[face as usize] else { return run.chars().count() as f32 * UNKNOWN_ADVANCE * height };
    let scale = height / advances.units_per_em;
    run.chars().fold(0.0, |width, sign| width + scale * advances.of(sign))
}

/// How far the signs of a face advance, in its own units.
struct Advances {
    face: ttf_parser::Face<'static>,
    units_per_em: f32,
    /// From the space to the tilde.
    ascii: [f32; 95],
}

static FACES: LazyLock<[Option<Advances>; 2]> = LazyLock::new(|| [Typeface::Sans, Typeface::Mono].map(Advances::read));

impl Advances {
    fn read(face: Typeface) -> Option<Self> {
        let face = ttf_parser::Face::parse(face.file().1, 0).ok()?;
        let ascii = std::array::from_fn(|i| advance(&face, char::from(b' ' + i as u8)));
        Some(Self { units_per_em: f32::from(face.units_per_em()), ascii, face })
    }

    fn of(&self, sign: char) -> f32 {
        let known = (sign as usize).checked_sub(' ' as usize).and_then(|i| self.ascii.get(i));
        known.copied().unwrap_or_else(|| advance(&self.face, sign))
    }
}

/// A sign that the face lacks is shown as its first glyph, an empty box.
fn advance(face: &ttf_parser::Face, sign: char) -> f32 {
    face.glyph_hor_advance(face.glyph_index(sign).unwrap_or_default()).map_or(0.0, f32::from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::layout::MONO_ADVANCE;
    use crate::words::{self, Language};

    #[test]
    fn signs_that_the_words_lack_are_set_in_the_other_face() {
        let cut = |text, face| runs(text, face).map(|(run, face)| format!("{face:?} {run}")).collect::<Vec<_>>();
        assert_eq!(
            cut("the digits of π, → and so on", Typeface::Sans),
            ["Sans the digits of ", "Mono π", "Sans , ", "Mono →", "Sans  and so on"]
        );
        assert_eq!(cut("← → walk", Typeface::Mono), ["Mono ← → walk"]);
        assert!(cut("", Typeface::Sans).is_empty());
    }

    #[test]
    fn every_sign_of_every_language_is_in_its_typeface() {
        for (english, text) in Language::ALL.into_iter().flat_map(words::rows) {
            for (run, face) in runs(&english, Typeface::Sans).chain(runs(&text, Typeface::Sans)) {
                let face = &FACES[face as usize].as_ref().unwrap().face;
                assert_eq!(run.chars().find(|sign| *sign != '\n' && face.glyph_index(*sign).is_none()), None, "{text}");
            }
        }
    }

    #[test]
    fn every_sign_of_the_monospaced_face_is_as_wide_as_the_layout_takes_it_for() {
        for sign in (' '..='~').chain(IN_MONO) {
            assert!((width(&sign.to_string(), Typeface::Mono, 1.0) - MONO_ADVANCE).abs() < 1e-3, "{sign}");
        }
        assert!((width("−×π→", Typeface::Sans, 10.0) - 2.0 * 5.64 - 2.0 * 6.02).abs() < 0.1);
    }
}
