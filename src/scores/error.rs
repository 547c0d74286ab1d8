use std::fmt::{self, Display};
use std::io;
use std::path::{Path, PathBuf};

use super::name::Name;
use crate::files::CellFault;

/// The most places in a report.
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
            let column = column.map(|column| format!("column \"{column}\": ")).unwrap_or_default();
            self.damage.push(format!("{path}:{line}: {column}{found}, expected {expected}"));
        } else if self.damage.len() == MOST_DAMAGE {
            let most = format!("expected at most {MOST_DAMAGE} in a file; from here on they are not listed");
            self.damage.push(format!("{path}:{line}: one more place that cannot be read, {most}"));
        }
    }

    pub fn fault(&mut self, line: usize, fault: CellFault) {
        let (found, expected) = fault.words();
        self.add(line, None, found, expected);
    }

    /// The name in a cell, or a line of the report.
    pub fn name(&mut self, line: usize, column: &str, cell: &str) -> Option<Name> {
        let refused = |error| self.add(line, Some(column), format_args!("{cell:?}"), format_args!("a user name: {error}"));
        Name::new(cell).map_err(refused).ok()
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
    /// It cannot name a file.
    LevelName(String),
    /// The file is marked read-only.
    ReadOnly(PathBuf),
    /// Another process holds this lock file for too long; a later try may succeed.
    Busy(PathBuf),
    /// A link leads to it, and it is no list of such rows.
    Foreign(PathBuf),
    /// With one more row the file would be too large.
    Full(PathBuf),
    File {
        /// As in "cannot …".
        attempt: &'static str,
        path: PathBuf,
        source: io::Error,
    },
}

impl ScoresError {
    /// For `map_err`.
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
            Self::Foreign(path) => {
                write!(f, "{}: a link leads to this file, which holds other lines, expected a list of such rows", path.display())
            }
            Self::Full(path) => {
                write!(f, "{}: the file is full, expected one that stays below {} bytes", path.display(), crate::files::SCORES)
            }
            Self::File { attempt, path, source } => write!(f, "{}: cannot {attempt}: {source}", path.display()),
        }
    }
}
