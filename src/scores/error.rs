use std::fmt::{self, Display};
use std::path::{Path, PathBuf};

use crate::files::{BadCell, CellFault, SaveError, place};
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
    /// These places of the file cannot be read, and would be lost.
    Damaged(Vec<String>),
    /// It is no list of such rows.
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
