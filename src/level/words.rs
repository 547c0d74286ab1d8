//! Warnings of unreadable words.

use super::draft::Draft;
use super::placed::FromRow;
use super::problem::{Problem, quoted};
use crate::physics::DVec2;
use crate::words::tr;

/// The least width of a letter, in heights of it: only words that run out in any case are reported.
const NARROWEST: f64 = 0.36;

/// Letters that the game's typefaces lack, and texts that run out of a level of `size` metres.
pub(super) fn warn(draft: &Draft, size: DVec2) -> Vec<Problem> {
    let mut warnings = Vec::new();
    for text in &draft.texts {
        let words = &text.item.text;
        warnings.extend(lacking(text, words));
        let end = text.item.position + DVec2::new(words.chars().count() as f64 * NARROWEST, 1.0) * text.item.size;
        let out = text.item.position.cmplt(DVec2::ZERO).any() || end.cmpgt(size + text.item.size * 0.5).any();
        if out {
            warnings.push(text.problem(
                "x",
                tr!("{words}, which runs out of the level", words = quoted(words)),
                tr("words that end within it"),
            ));
        }
    }
    warnings.extend(draft.hints.iter().filter_map(|hint| lacking(hint, &hint.item)));
    warnings
}

/// The first letter of words in a row that would be drawn as a box.
fn lacking<T>(row: &FromRow<T>, words: &str) -> Option<Problem> {
    let letter = words.chars().find(|letter| !is_drawn(*letter))?;
    let found = tr!("{letter}, which would be drawn as a box", letter = quoted(&letter.to_string()));
    Some(row.problem("text", found, tr("letters of Latin, Greek or Cyrillic, signs and arrows, on one line")))
}

/// No line break, and no letter of a script that the typefaces lack.
fn is_drawn(letter: char) -> bool {
    let lacking = matches!(u32::from(letter),
        0x0590..=0x109F | 0x1100..=0x11FF | 0x2E80..=0xA4CF | 0xA960..=0xD7FF | 0xF900..=0xFAFF | 0xFB50..=0xFDFF | 0x1F000..);
    !letter.is_control() && !lacking
}

#[cfg(test)]
mod tests {
    use super::is_drawn;

    #[test]
    fn what_the_typefaces_lack_is_known() {
        assert!("Über → 10 m/s², Ωж ≥ ½ ✓".chars().all(is_drawn));
        for letter in ['日', '한', 'ع', 'ש', '😀', '\n', '\u{7}'] {
            assert!(!is_drawn(letter), "{letter:?}");
        }
    }
}
