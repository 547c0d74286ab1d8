//! The number of an editor among the editors of one level, for as long as it has the level open.

use crate::files::{self, Lock};
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

const KEPT: &str = ".autosave";
/// The most editors of one level that keep unsaved edits.
const MOST_EDITORS: u32 = 100;

/// A lock keeps the number from other editors.
#[derive(Debug)]
pub(super) struct EditorDesk {
    pub kept: PathBuf,
    pub shared: bool,
    /// Held until this editor ends.
    lock: Option<(Lock, PathBuf)>,
}

impl EditorDesk {
    /// Number 1, also where another editor has it.
    pub fn alone(folder: &Path) -> Self {
        Self { kept: folder.join(KEPT), shared: false, lock: None }
    }

    /// The first free number with kept edits, else the first free one.
    pub fn take(folder: &Path) -> Self {
        let left = (1..=MOST_EDITORS).filter(|number| files::is_taken(&Self::name(folder, *number)));
        let mut desks = left.chain(1..=MOST_EDITORS).filter_map(|number| Some((number, Self::at(folder, number)?)));
        let Some((number, mut desk)) = desks.next() else { return Self { kept: folder.join(KEPT), shared: true, lock: None } };
        desk.shared = number != 1 && Self::at(folder, 1).is_none();
        desk
    }

    /// `None` where another editor has that number. A folder without room for a lock, such as a read-only one, keeps no edits either.
    fn at(folder: &Path, number: u32) -> Option<Self> {
        let kept = Self::name(folder, number);
        let path = kept.with_extension("lock");
        match Lock::wait(&path, Duration::ZERO) {
            Ok(lock) => Some(Self { kept, shared: false, lock: Some((lock, path)) }),
            Err(error) if error.kind() == io::ErrorKind::WouldBlock || files::is_taken(&path) => None,
            Err(_) => Some(Self { kept, shared: false, lock: None }),
        }
    }

    fn name(folder: &Path, number: u32) -> PathBuf {
        folder.join(if number == 1 { KEPT.to_owned() } else { format!("{KEPT}-{number}") })
    }
}

impl Drop for EditorDesk {
    fn drop(&mut self) {
        if let Some((_, path)) = &self.lock {
            // The next editor takes over a file that stays.
            let _ = files::remove(path);
        }
    }
}
