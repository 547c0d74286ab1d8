//! The two faces and their glyphs. Glyphs are made ready between frames: an atlas that grows while a frame is being drawn leaves
//! black boxes behind.

use super::layout::{Frame, TEXT_SIZES};
use macroquad::text::{Font, load_ttf_font_from_bytes};
use macroquad::texture::FilterMode;

/// What a line of text is set in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Face {
    /// For words.
    #[default]
    Sans,
    /// For numbers that change, so that nothing jitters.
    Mono,
}

/// Signs that are set in the monospaced face amid words too: the sans face has no arrows and no raised minus, and its π reads like another
/// letter.
const IN_MONO: [char; 6] = ['←', '→', '↑', '↓', 'π', '⁻'];
/// Beyond printable ASCII, the signs that the game writes.
const SIGNS: &str = "−×·÷°±≈≤≥∞→←↑↓‹›–—…µμρπΔ‘’“”£é⁰¹²³⁴⁵⁶⁷⁸⁹⁻";
/// Sizes in physical pixels kept at once; a window dragged through more of them starts a fresh atlas, so that it never grows
/// without end.
const MOST_SIZES: usize = 20;

/// The text cut into runs of one face each.
pub fn runs(text: &str, face: Face) -> Vec<(String, Face)> {
    let face_of = |c: &char| if IN_MONO.contains(c) { Face::Mono } else { face };
    let letters: Vec<char> = text.chars().collect();
    letters.chunk_by(|a, b| face_of(a) == face_of(b)).map(|run| (run.iter().collect(), face_of(&run[0]))).collect()
}

/// The faces with the glyphs that have been made ready.
pub struct Fonts {
    sans: Font,
    mono: Font,
    ready: Vec<u16>,
}

impl Fonts {
    /// Loads both faces.
    ///
    /// # Errors
    /// A face that cannot be read, in words.
    pub fn load() -> Result<Self, String> {
        Ok(Self {
            sans: face("Ubuntu Light", epaint_default_fonts::UBUNTU_LIGHT)?,
            mono: face("Hack", epaint_default_fonts::HACK_REGULAR)?,
            ready: Vec::new(),
        })
    }

    /// Makes the glyphs ready that `frame` needs. Called before anything of a frame is drawn.
    ///
    /// # Errors
    /// As [`Fonts::load`].
    pub fn prepare(&mut self, frame: &Frame, dpi: f32) -> Result<(), String> {
        let sizes = TEXT_SIZES.map(|size| glyph_size(font_size(frame, dpi, size), dpi));
        if sizes.iter().all(|size| self.ready.contains(size)) {
            return Ok(());
        }
        if self.ready.len() + sizes.len() > MOST_SIZES {
            *self = Self::load()?;
        }
        let glyphs: Vec<char> = (' '..='~').chain(SIGNS.chars()).collect();
        for size in sizes {
            if !self.ready.contains(&size) {
                self.sans.populate_font_cache(&glyphs, size);
                self.mono.populate_font_cache(&glyphs, size);
                self.ready.push(size);
            }
        }
        Ok(())
    }

    /// One of the faces.
    pub fn get(&self, face: Face) -> &Font {
        match face {
            Face::Sans => &self.sans,
            Face::Mono => &self.mono,
        }
    }
}

/// The height of text of that size in macroquad's units, which are whole and `dpi` physical pixels each.
pub fn font_size(frame: &Frame, dpi: f32, size: f32) -> u16 {
    (frame.text_height(size) / frame.pixel / dpi).ceil() as u16
}

/// The height at which macroquad makes the glyphs of such text, physical pixels.
pub fn glyph_size(font_size: u16, dpi: f32) -> u16 {
    (f32::from(font_size) * dpi).ceil() as u16
}

fn face(name: &str, bytes: &[u8]) -> Result<Font, String> {
    let mut font = load_ttf_font_from_bytes(bytes).map_err(|error| format!("the typeface {name} cannot be read: {error}"))?;
    // Glyphs are drawn at the size at which they were made: the nearest sample keeps them sharp between pixels.
    font.set_filter(FilterMode::Nearest);
    Ok(font)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_that_the_words_lack_are_set_in_the_other_face() {
        let cut = |text, face| runs(text, face).into_iter().map(|(run, face)| format!("{face:?} {run}")).collect::<Vec<_>>();
        assert_eq!(
            cut("the digits of π, → and so on", Face::Sans),
            ["Sans the digits of ", "Mono π", "Sans , ", "Mono →", "Sans  and so on"]
        );
        assert_eq!(cut("← → walk", Face::Mono), ["Mono ← → walk"]);
        assert!(cut("", Face::Sans).is_empty());
    }
}
