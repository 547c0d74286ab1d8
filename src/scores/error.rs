//! What can go wrong with scores, each with its place and what was expected there.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use super::Name;
use crate::files::RowFault;

/// A place in a scores file that could not be read as a row. Its text is
/// `file:line: column "name": what was found, what is expected`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Damage {
    /// The file.
    pub path: PathBuf,
    /// The line as an editor counts it, from 1.
    pub line: usize,
    /// The column, where one cell is to blame.
    pub column: Option<&'static str>,
    /// What stands there.
    pub found: String,
    /// What belongs there.
    pub expected: String,
}

impl fmt::Display for Damage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: ", self.path.display(), self.line)?;
        if let Some(column) = self.column {
            write!(f, "column \"{column}\": ")?;
        }
        write!(f, "{}, {}", self.found, self.expected)
    }
}

/// How many places that cannot be read are told; of a file that is something else altogether more would say no more.
pub(super) const MOST_DAMAGE: usize = 1000;

/// The places of one file that could not be read, as they are found.
pub(super) struct Report<'a> {
    path: &'a Path,
    damage: Vec<Damage>,
}

impl<'a> Report<'a> {
    pub fn of(path: &'a Path) -> Self {
        Self { path, damage: Vec::new() }
    }

    pub fn add(&mut self, line: usize, column: Option<&'static str>, found: impl Into<String>, expected: impl Into<String>) {
        let damage = |column, found, expected| Damage { path: self.path.to_owned(), line, column, found, expected };
        match self.damage.len() {
            0..MOST_DAMAGE => self.damage.push(damage(column, found.into(), expected.into())),
            MOST_DAMAGE => {
                let expected = format!("expected at most {MOST_DAMAGE} in a file; from here on they are not listed");
                self.damage.push(damage(None, "one more place that cannot be read".to_owned(), expected));
            }
            _ => {}
        }
    }

    pub fn fault(&mut self, line: usize, fault: RowFault) {
        let (found, expected) = fault.words();
        self.add(line, None, found, format!("expected {expected}"));
    }

    /// The name in a cell, or a report about it.
    pub fn name(&mut self, line: usize, column: &'static str, cell: &str) -> Option<Name> {
        Name::new(cell)
            .map_err(|error| self.add(line, Some(column), format!("{cell:?}"), format!("expected a user name: {error}")))
            .ok()
    }

    pub fn into_all(self) -> Vec<Damage> {
        self.damage
    }
}

/// Why scores could not be read or saved. Whatever it was, the file on disk is as it was before.
#[derive(Debug)]
pub enum ScoresError {
    /// A score below 1 cannot be saved.
    NoScore,
    /// The level's name cannot name a file.
    LevelName(String),
    /// The scores file is marked read-only: whoever did that wants it left alone.
    ReadOnly(PathBuf),
    /// Another process holds the lock of the board and does not let go: with the lock file. It may be tried again.
    Busy(PathBuf),
    /// With one row more the file would be larger than it may be.
    Full(PathBuf),
    /// The system refused something.
    File {
        /// What was attempted, as in "cannot …".
        attempt: &'static str,
        /// With which file or folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

impl ScoresError {
    /// For `map_err`: the system refused `attempt` with `path`.
    pub(super) fn file(attempt: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::File { attempt, path: path.to_owned(), source }
    }
}

impl fmt::Display for ScoresError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoScore => write!(f, "a score of 0 cannot be saved, expected 1 or more"),
            Self::LevelName(name) => {
                write!(
                    f,
                    "the level's name {name:?} cannot name a scores file, expected a name without / \\ : and control characters, other than players and attempts"
                )
            }
            Self::ReadOnly(path) => write!(f, "{}: the file is read-only, expected one that may be replaced", path.display()),
            Self::Busy(path) => {
                let path = path.display();
                write!(f, "{path}: another program is saving there and does not come to an end; nothing was saved, try again")
            }
            Self::Full(path) => {
                write!(f, "{}: the file is full, expected one that stays below {} bytes", path.display(), crate::files::SCORES)
            }
            Self::File { attempt, path, source } => write!(f, "{}: cannot {attempt}: {source}", path.display()),
        }
    }
}

impl std::error::Error for ScoresError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::NoScore | Self::LevelName(_) | Self::ReadOnly(_) | Self::Busy(_) | Self::Full(_) => None,
            Self::File { source, .. } => Some(source),
        }
    }
}
