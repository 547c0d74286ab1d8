use std::fmt::{self, Display};
use std::io;
use std::path::{Path, PathBuf};

use crate::files::{BadCell, CellFault, place};
use crate::words::tr;

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
        f.write_str(&match self {
            Self::NoScore => tr("a score of 0 cannot be saved, expected 1 or more").to_owned(),
            Self::LevelName(name) => tr!(
                "the level's name {name} cannot name a scores file, expected a name without / \\ : and control characters, other than players and attempts",
                name = format_args!("{name:?}")
            ),
            Self::ReadOnly(path) => {
                tr!("{path}: the file is read-only, expected one that may be replaced", path = path.display())
            }
            Self::Busy(path) => tr!(
                "{path}: another program is saving there and does not come to an end; nothing was saved, try again",
                path = path.display()
            ),
            Self::Foreign(path) => tr!(
                "{path}: a link leads to this file, which holds other lines, expected a list of such rows",
                path = path.display()
            ),
            Self::Full(path) => {
                let most = crate::files::SCORES;
                tr!("{path}: the file is full, expected one that stays below {most} bytes", path = path.display(), most)
            }
            Self::File { attempt, path, source } => {
                tr!("{path}: cannot {attempt}: {source}", path = path.display(), attempt = tr(attempt), source)
            }
        })
    }
}
