use crate::files::{BadCell, CellFault, SaveError, place};
use crate::words::tr;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt::{self, Display};
use std::path::{Path, PathBuf};

/// Characters.
pub const NAME_MAX: usize = 15;
/// Characters that a text field takes; [`Name::new`] judges them on submit.
pub const NAME_TYPING_MAX: usize = 40;

const GUEST: &str = "Guest";

/// 1 to [`NAME_MAX`] characters, the first one a letter, the others letters, digits, `-` or `_`. Letters are those of ASCII: every font draws them,
/// no two look alike, and no spreadsheet reads such a name as a formula. Names that differ in case are different users.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Deserialize, Serialize)]
#[serde(try_from = "String")]
pub struct Name(String);

impl TryFrom<String> for Name {
    type Error = NameError;

    fn try_from(text: String) -> Result<Self, NameError> {
        Self::new(&text)
    }
}

/// Its text is for the player.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameError {
    Empty,
    /// This number of characters.
    TooLong(usize),
    /// With this character, which is no letter.
    StartsWith(char),
    NotAllowed(char),
}

impl Name {
    /// Spaces around the name are not cut off. The error is the first broken rule, in the order of [`NameError`].
    pub fn new(text: &str) -> Result<Self, NameError> {
        let length = text.chars().count();
        let Some(first) = text.chars().next() else { return Err(NameError::Empty) };
        if length > NAME_MAX {
            return Err(NameError::TooLong(length));
        }
        if !first.is_ascii_alphabetic() {
            return Err(NameError::StartsWith(first));
        }
        match text.chars().find(|&c| !(c.is_ascii_alphanumeric() || c == '-' || c == '_')) {
            Some(other) => Err(NameError::NotAllowed(other)),
            None => Ok(Self(text.to_owned())),
        }
    }

    /// The text of a name in a file, or what is expected in its place.
    pub(super) fn cell(text: &str) -> Result<Cow<'_, str>, String> {
        Self::new(text).map(|_| text.into()).map_err(|error| tr!("a user name: {error}", error))
    }

    pub fn guest() -> Self {
        Self(GUEST.to_owned())
    }

    /// In any case of the letters.
    pub fn is_guest(&self) -> bool {
        self.0.eq_ignore_ascii_case(GUEST)
    }

    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.0)
    }
}

impl fmt::Display for NameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str(&tr!("The name is empty: type 1 to {most} characters.", most = NAME_MAX)),
            Self::TooLong(length) => {
                f.write_str(&tr!("The name is too long: {length} characters, at most {most} are allowed.", length, most = NAME_MAX))
            }
            Self::StartsWith(first) => {
                f.write_str(&tr!("The name must start with a letter (a–z, A–Z), not with {first}.", first = shown(*first)))
            }
            Self::NotAllowed(other) => {
                let other = shown(*other);
                f.write_str(&tr!("The character {other} is not allowed: use letters (a–z, A–Z), digits, - and _.", other))
            }
        }
    }
}

/// A character in quotation marks, or its number where it is invisible.
fn shown(character: char) -> String {
    match character {
        ' ' => tr("a space").to_owned(),
        _ if character.is_control() || character.is_whitespace() => format!("U+{:04X}", u32::from(character)),
        _ => format!("“{character}”"),
    }
}

pub(super) const MOST_DAMAGE: usize = 1000;

/// The unreadable places of one file, each on a line `file:line: column "name": found …, expected …`.
pub(super) struct DamageReport<'a> {
    path: &'a Path,
    damage: Vec<String>,
}

impl<'a> DamageReport<'a> {
    pub fn of(path: &'a Path) -> Self {
        Self { path, damage: Vec::new() }
    }

    pub fn add(&mut self, line: usize, column: Option<&str>, found: impl Display, expected: impl Display) {
        let path = self.path.display();
        if self.damage.len() < MOST_DAMAGE {
            let place = column.map_or_else(|| format!("{path}:{line}"), |column| place(&path, line, column));
            self.damage.push(tr!("{place}: {found}, expected {expected}", place, found, expected));
        } else if self.damage.len() == MOST_DAMAGE {
            let (place, most) = (format_args!("{path}:{line}"), MOST_DAMAGE);
            self.damage.push(tr!(
                "{place}: one more place that cannot be read, expected at most {most} in a file; from here on they are not listed",
                place,
                most
            ));
        }
    }

    pub fn fault(&mut self, line: usize, fault: CellFault) {
        let (found, expected) = fault.words();
        self.add(line, None, found, expected);
    }

    pub fn cells(&mut self, line: usize, wrong: impl IntoIterator<Item = BadCell>) {
        wrong.into_iter().for_each(|BadCell { column, found, expected }| self.add(line, Some(column), found, expected));
    }

    pub fn into_all(self) -> Vec<String> {
        self.damage
    }
}

/// The file on disk is as it was before.
#[derive(Debug)]
pub enum ScoresError {
    /// Below 1.
    NoScore,
    LevelName(String),
    /// These places of the file cannot be read, and would be lost.
    Damaged(Vec<String>),
    Foreign(PathBuf),
    Save(SaveError),
}

impl From<SaveError> for ScoresError {
    fn from(error: SaveError) -> Self {
        Self::Save(error)
    }
}

/// What is wrong with a scores file, in one line.
pub fn damage_text(damage: &[String]) -> String {
    match damage {
        [] => String::new(),
        [one] => format!("{one}."),
        [first, rest @ ..] => tr!("{first} (and {count} more).", first, count = rest.len()),
    }
}

impl fmt::Display for ScoresError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&match self {
            Self::NoScore => tr("a score of 0 cannot be saved, expected 1 or more").to_owned(),
            Self::LevelName(name) => tr!(
                "the level's name {name} cannot name a scores file, expected a name without / \\ : and control characters, other than players and attempts",
                name = format_args!("{name:?}")
            ),
            Self::Damaged(damage) => {
                tr!("Nothing was saved; mend the file and try again: {damage}", damage = damage_text(damage))
            }
            Self::Foreign(path) => tr!(
                "{path}: this file holds other lines, expected a list of such rows; nothing was saved",
                path = path.display()
            ),
            Self::Save(error) => error.to_string(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_follow_the_rules_are_kept_as_typed() {
        for text in ["bob445", "bobbillson", "bobby404-_", "a", "bbbbbbbbbbbbbbb", "c_c------------", "d1", "Zed"] {
            assert_eq!(Name::new(text).as_ref().map(Name::as_str), Ok(text));
        }
    }

    #[test]
    fn each_broken_rule_is_told_apart() {
        for (text, error) in [
            ("", NameError::Empty),
            ("---bob", NameError::StartsWith('-')),
            ("1", NameError::StartsWith('1')),
            ("1bob1", NameError::StartsWith('1')),
            ("1234b", NameError::StartsWith('1')),
            ("_bob", NameError::StartsWith('_')),
            (" bob", NameError::StartsWith(' ')),
            ("=bob", NameError::StartsWith('=')),
            ("+bob", NameError::StartsWith('+')),
            ("@bob", NameError::StartsWith('@')),
            ("élan", NameError::StartsWith('é')),
            ("abbbbbbbbbbbbbbc", NameError::TooLong(16)),
            ("1bbbbbbbbbbbbbbc", NameError::TooLong(16)),
            (&"a".repeat(NAME_TYPING_MAX), NameError::TooLong(40)),
            ("bob ", NameError::NotAllowed(' ')),
            ("bo,b", NameError::NotAllowed(',')),
            ("bo\"b", NameError::NotAllowed('"')),
            ("bo\nb", NameError::NotAllowed('\n')),
            ("Zoë", NameError::NotAllowed('ë')),
        ] {
            assert_eq!(Name::new(text), Err(error), "{text:?}");
        }
    }

    #[test]
    fn length_counts_characters_not_bytes() {
        assert_eq!(Name::new("aééééééééééééé").unwrap_err(), NameError::NotAllowed('é'));
        assert_eq!(Name::new("aééééééééééééééé").unwrap_err(), NameError::TooLong(16));
    }

    #[test]
    fn each_refusal_has_its_own_message() {
        for (text, message) in [
            ("", "The name is empty: type 1 to 15 characters."),
            ("abbbbbbbbbbbbbbc", "The name is too long: 16 characters, at most 15 are allowed."),
            ("1bob1", "The name must start with a letter (a–z, A–Z), not with “1”."),
            (" bob", "The name must start with a letter (a–z, A–Z), not with a space."),
            ("bob!", "The character “!” is not allowed: use letters (a–z, A–Z), digits, - and _."),
            ("bob\t", "The character U+0009 is not allowed: use letters (a–z, A–Z), digits, - and _."),
        ] {
            assert_eq!(Name::new(text).unwrap_err().to_string(), message);
        }
    }
}
