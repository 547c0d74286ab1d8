//! The faults of scores and their files, each with its place.

use std::fmt::{self, Display};
use std::io;
use std::path::{Path, PathBuf};

use super::name::Name;
use crate::files::RowFault;

/// The number of places that a report lists; more of a file that is something else altogether would say no more.
pub(super) const MOST_DAMAGE: usize = 1000;

/// The places of one file that could not be read as rows, a line each: `file:line: column "name": what was found, what is expected`.
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
            let column = column.map(|column| format!("column \"{column}\": ")).unwrap_or_default();
            self.damage.push(format!("{path}:{line}: {column}{found}, expected {expected}"));
        } else if self.damage.len() == MOST_DAMAGE {
            let most = format!("expected at most {MOST_DAMAGE} in a file; from here on they are not listed");
            self.damage.push(format!("{path}:{line}: one more place that cannot be read, {most}"));
        }
    }

    pub fn fault(&mut self, line: usize, fault: RowFault) {
        let (found, expected) = fault.words();
        self.add(line, None, found, expected);
    }

    /// The name in a cell, or a report about it.
    pub fn name(&mut self, line: usize, column: &str, cell: &str) -> Option<Name> {
        let refused = |error| self.add(line, Some(column), format_args!("{cell:?}"), format_args!("a user name: {error}"));
        Name::new(cell).map_err(refused).ok()
    }

    pub fn into_all(self) -> Vec<String> {
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
    /// The scores file is marked read-only, so that it is to stay as it is.
    ReadOnly(PathBuf),
    /// Another process holds the lock of the board and does not let go: with the lock file. It may be tried again.
    Busy(PathBuf),
    /// With one row more the file would be larger than it may be.
    Full(PathBuf),
    /// The system refused something.
    File {
        /// The attempt, as in "cannot …".
        attempt: &'static str,
        /// With which file or folder.
        path: PathBuf,
        /// The system's error.
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
