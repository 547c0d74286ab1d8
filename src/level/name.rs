//! Names of levels: a folder's name is also the name of its leaderboard's file.

use crate::words::tr;

/// Longest name of a new level, characters.
const MAX_NAME: usize = 40;
/// Files among the leaderboards that belong to no level: the Jumper's board, what the players have done, and the list of attempts.
const OTHER_FILES: [&str; 3] = ["jumper", "players", "attempts"];
/// Names that Windows takes for devices, with any ending: no folder and no file of scores can have one there.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "conin$", "conout$"];
/// Devices that a digit follows.
const NUMBERED_DEVICES: [&str; 2] = ["com", "lpt"];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameFault {
    NoWord,
    /// A character that nobody sees, or that turns the others around.
    Hidden(char),
    /// Another file among the leaderboards has this name.
    Board(&'static str),
    Device,
}

impl NameFault {
    pub fn expected(self) -> String {
        match self {
            Self::Hidden(c) => tr!("a name without the invisible character {code}", code = format_args!("U+{:04X}", c as u32)),
            Self::NoWord => tr!("up to {most} letters, digits, - and _, the first a letter or digit", most = MAX_NAME),
            Self::Board(name) => tr!("another name, as scores/{name}.csv is a list of another kind", name),
            Self::Device => tr("another name, as Windows takes that one for a device").to_owned(),
        }
    }
}

/// Judges the name of a new level: a word of at most 40 letters, digits, `-` and `_` that begins with a letter or digit and is not taken
/// in any case.
pub fn judge_name(name: &str) -> Result<(), NameFault> {
    let word = name.chars().count() <= MAX_NAME
        && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_'))
        && name.chars().next().is_some_and(char::is_alphanumeric);
    let taken = judge_taken(name);
    if word || matches!(taken, Err(NameFault::Hidden(_))) { taken } else { Err(NameFault::NoWord) }
}

/// Refuses hidden characters, and the names of devices and of other files among the leaderboards, in any case.
pub(super) fn judge_taken(name: &str) -> Result<(), NameFault> {
    if let Some(hidden) = name.chars().find(|c| is_hidden(*c)) {
        return Err(NameFault::Hidden(hidden));
    }
    let lower = name.to_lowercase();
    if let Some(name) = OTHER_FILES.into_iter().find(|file| *file == lower) {
        return Err(NameFault::Board(name));
    }
    if is_device(&lower) { Err(NameFault::Device) } else { Ok(()) }
}

/// Characters of Unicode 16 that show nothing, or change the direction of those behind them: line and paragraph separators, the blank of
/// Braille, format characters, and those of the property Default_Ignorable_Code_Point.
const HIDDEN: [(char, char); 27] = [
    ('\u{ad}', '\u{ad}'),
    ('\u{34f}', '\u{34f}'),
    ('\u{600}', '\u{605}'),
    ('\u{61c}', '\u{61c}'),
    ('\u{6dd}', '\u{6dd}'),
    ('\u{70f}', '\u{70f}'),
    ('\u{890}', '\u{891}'),
    ('\u{8e2}', '\u{8e2}'),
    ('\u{115f}', '\u{1160}'),
    ('\u{17b4}', '\u{17b5}'),
    ('\u{180b}', '\u{180f}'),
    ('\u{200b}', '\u{200f}'),
    ('\u{2028}', '\u{202e}'),
    ('\u{2060}', '\u{206f}'),
    ('\u{2800}', '\u{2800}'),
    ('\u{3164}', '\u{3164}'),
    ('\u{fe00}', '\u{fe0f}'),
    ('\u{feff}', '\u{feff}'),
    ('\u{ffa0}', '\u{ffa0}'),
    ('\u{fff0}', '\u{fffb}'),
    ('\u{110bd}', '\u{110bd}'),
    ('\u{110cd}', '\u{110cd}'),
    ('\u{13430}', '\u{1343f}'),
    ('\u{1bca0}', '\u{1bca3}'),
    ('\u{1d159}', '\u{1d159}'),
    ('\u{1d173}', '\u{1d17a}'),
    ('\u{e0000}', '\u{e0fff}'),
];

/// Whether nobody sees that character in a name, or it turns the others around.
pub fn is_hidden(c: char) -> bool {
    HIDDEN.iter().any(|(first, last)| (*first..=*last).contains(&c))
}

/// Whether Windows takes a file or folder of that name for a device: `con`, `CON .txt`, `com1.csv`, `CONIN$`.
pub fn is_device(name: &str) -> bool {
    let lower = name.to_lowercase();
    let stem = lower.split('.').next().unwrap_or_default().trim_end();
    let numbered = NUMBERED_DEVICES.iter().filter_map(|device| stem.strip_prefix(device)).any(|rest| {
        let mut rest = rest.chars();
        rest.next().is_some_and(|c| c.is_ascii_digit() || matches!(c, '¹' | '²' | '³')) && rest.next().is_none()
    });
    numbered || DEVICES.contains(&stem)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn level_names_are_words() {
        for name in ["1", "tower", "höhle-2", "a_b", &"x".repeat(40)] {
            assert_eq!(judge_name(name), Ok(()), "{name}");
        }
        for name in ["", "-a", "_a", "a b", "a/b", "..", "a.b", "C:", "a\\b", &"x".repeat(41)] {
            assert_eq!(judge_name(name), Err(NameFault::NoWord), "{name}");
        }
    }

    #[test]
    fn no_name_has_a_character_that_nobody_sees() {
        for hidden in ['\u{202e}', '\u{200b}', '\u{2066}', '\u{feff}', '\u{3164}', '\u{e0041}', '\u{ad}', '\u{1160}', '\u{180e}'] {
            assert_eq!(judge_name(&format!("to{hidden}wer")), Err(NameFault::Hidden(hidden)), "{hidden:?}");
        }
        assert!(!"höhle-2 Ωж漢字かなਪੰ".chars().any(is_hidden) && HIDDEN.is_sorted());
    }

    #[test]
    fn names_that_are_taken_are_none_in_any_case() {
        for name in ["jumper", "Jumper", "JUMPER", "players", "Attempts"] {
            assert!(matches!(judge_name(name), Err(NameFault::Board(_))), "{name}");
        }
        for name in ["CON", "aux", "NUL", "prn", "COM1", "com0", "Lpt9", "com¹"] {
            assert_eq!(judge_name(name), Err(NameFault::Device), "{name}");
        }
        assert_eq!(judge_taken("aux.2"), Err(NameFault::Device));
        for name in ["con .txt", "CONIN$", "conout$.csv", "COM1 .png"] {
            assert!(is_device(name), "{name}");
        }
        for name in ["jumper2", "the-jumper", "icon", "console", "com", "com10", "lpt-1", "auxiliary", "nul1"] {
            assert_eq!(judge_name(name), Ok(()), "{name}");
        }
    }
}
