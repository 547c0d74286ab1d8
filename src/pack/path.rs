//! Paths in an archive that stay in their folder on every system, and name the same file there.

use crate::level::{NameFault, is_device, is_hidden, judge_name};
use crate::words::tr;
use unicode_normalization::UnicodeNormalization;

/// The longest part of a path, bytes, and the most parts.
const LONGEST: usize = 120;
pub(super) const DEEPEST: usize = 8;
/// Windows allows them in no name.
const FORBIDDEN: &str = ":*?\"<>|";

/// The parts of an entry's path: at least one, each a plain name. `None` for hidden files and macOS's notes. Errors: the fault of the path.
pub(super) fn parts(raw: &[u8]) -> Result<Option<Vec<String>>, String> {
    let shown = || format!("{:?}", String::from_utf8_lossy(raw));
    let text =
        str::from_utf8(raw).map_err(|_| tr!("{place}: found a name that is no UTF-8, expected one that is", place = shown()))?;
    let parts: Vec<&str> = text.trim_end_matches('/').split('/').collect();
    if parts.len() > DEEPEST {
        let (place, count, most) = (shown(), parts.len(), DEEPEST);
        return Err(tr!("{place}: found {count} folders in each other, expected at most {most}", place, count, most));
    }
    if let Some(fault) = parts.iter().find_map(|part| fault(part)) {
        let place = shown();
        return Err(tr!("{place}: found a path with {fault}, expected one that stays in the level's folder", place, fault));
    }
    let beside = |part: &&str| part.starts_with('.') || matches!(*part, "__MACOSX" | "Thumbs.db" | "desktop.ini");
    Ok((!parts.iter().any(beside)).then(|| parts.into_iter().map(str::to_owned).collect()))
}

fn fault(part: &str) -> Option<&'static str> {
    match part {
        "" => Some(tr("an empty part")),
        "." | ".." => Some(tr("a part that leads elsewhere")),
        _ if part.len() > LONGEST => Some(tr("a part that is too long")),
        _ if part.contains('\\') => Some(tr("a backslash, where a ZIP archive has / between folders")),
        _ if part.chars().any(is_hidden) => Some(tr("an invisible character")),
        _ if part.chars().any(|c| c.is_control() || FORBIDDEN.contains(c)) => Some(tr("a character that no name has everywhere")),
        _ if part.ends_with(|c: char| c == '.' || c.is_whitespace()) || part.starts_with(char::is_whitespace) => {
            Some(tr("a part that begins or ends with a space or a full stop"))
        }
        _ if is_device(part) => Some(tr("a part that is a device")),
        _ => None,
    }
}

/// The form in which the least particular system compares names: in one case, accents decomposed.
pub(super) fn folded(name: &str) -> String {
    let decomposed: String = name.nfd().collect();
    // There and back: ß becomes ss, as in capitals.
    decomposed.to_lowercase().to_uppercase().to_lowercase().nfd().collect()
}

/// Judges a level's folder name: every system can have it, and no other file of the scores does. The error is the fault with the expected names.
pub(super) fn judge_folder(name: &str) -> Result<(), String> {
    let refusal = match judge_name(name) {
        Err(fault @ (NameFault::Board(_) | NameFault::Device | NameFault::Experiments | NameFault::Hidden(_))) => fault,
        // New levels need a word; an old one only must not lead elsewhere.
        _ if fault(name).is_some() || name.starts_with('.') || name.contains('/') => NameFault::NoWord,
        _ => return Ok(()),
    };
    let (name, expected) = (format!("{name:?}"), refusal.expected());
    Err(tr!("found the level name {name}, expected {expected}", name, expected))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_leads_out_of_the_folder_or_is_no_name_somewhere_is_refused() {
        let long = format!("a/{}", "x".repeat(121));
        for bad in [
            "../a.csv",
            "a/../../b.csv",
            "/etc/passwd",
            "a//b",
            "a/./b",
            "C:/a",
            "a\\b",
            "..\\a",
            "a/b:c",
            "a/con",
            "a/AUX.csv",
            "a/nul.x",
            "a/com1.png",
            "a/con .txt",
            "a/CONIN$.txt",
            "a/conout$",
            "a/b.",
            "a/b ",
            "a/ b",
            "a/b\u{a0}",
            "a/tab\u{202e}vsc.csv",
            "a/\u{200b}.csv",
            "a\u{2067}/b.csv",
            "a/\u{1b}[2J",
            "a/\0",
            "",
            "/",
            "a/x\n.csv",
            "a/*",
            &long,
            "a/b/c/d/e/f/g/h/i",
        ] {
            assert!(parts(bad.as_bytes()).is_err(), "{bad:?}");
        }
        assert!(parts(b"a/\xff.csv").unwrap_err().contains("UTF-8"));
    }

    #[test]
    fn names_are_one_that_are_one_anywhere() {
        let same = ["e\u{301}t\u{e9}", "\u{c9}T\u{c9}", "\u{e9}te\u{301}"];
        assert!(same.iter().all(|name| folded(name) == folded("\u{e9}t\u{e9}")));
        for (one, other) in
            [("straße", "STRASSE"), ("ẞ", "ss"), ("ﬁn", "FIN"), ("όσος", "ΌΣΟΣ"), ("\u{212b}", "å"), ("\u{212a}", "k")]
        {
            assert_eq!(folded(one), folded(other));
        }
        assert_ne!(folded("a"), folded("ä"));
    }

    #[test]
    fn plain_paths_are_taken_and_what_systems_leave_is_passed_over() {
        assert_eq!(parts("höhle/bild 1.png".as_bytes()), Ok(Some(vec!["höhle".into(), "bild 1.png".into()])));
        assert_eq!(parts(b"a/flights/"), Ok(Some(vec!["a".into(), "flights".into()])));
        for beside in ["__MACOSX/a/._world.csv", "a/.DS_Store", "a/Thumbs.db", ".git/config"] {
            assert_eq!(parts(beside.as_bytes()), Ok(None), "{beside}");
        }
    }

    #[test]
    fn level_names_are_those_of_folders_everywhere() {
        for good in ["1", "tower", "a level", "höhle-2", "v1.2"] {
            assert_eq!(judge_folder(good), Ok(()), "{good}");
        }
        assert_eq!(
            judge_folder("to\u{202e}wer").unwrap_err(),
            "found the level name \"to\\u{202e}wer\", expected a name without the invisible character U+202E"
        );
        for bad in ["", ".", "..", "a/b", "a\\b", "con", "LPT1", "jumper", "Players", ".hidden", "a.", "C:"] {
            assert!(judge_folder(bad).is_err(), "{bad:?}");
        }
    }
}
