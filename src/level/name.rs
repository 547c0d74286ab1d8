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
    /// Another file among the leaderboards has this name.
    Board(&'static str),
    Device,
}

impl NameFault {
    pub fn expected(self) -> String {
        match self {
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
    if word { judge_taken(name) } else { Err(NameFault::NoWord) }
}

/// Refuses the names of devices and of other files among the leaderboards, in any case.
pub(super) fn judge_taken(name: &str) -> Result<(), NameFault> {
    let lower = name.to_lowercase();
    if let Some(name) = OTHER_FILES.into_iter().find(|file| *file == lower) {
        return Err(NameFault::Board(name));
    }
    if is_device(&lower) { Err(NameFault::Device) } else { Ok(()) }
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
