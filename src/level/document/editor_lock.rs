//! One editor of a level at a time.

use crate::files::{self, Lock, Symlinks};
use crate::words::tr;
use std::env;
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::time::Duration;

/// Bytes of a holder's name that are read.
const MOST: u64 = 200;

/// Held until the editor ends. The system frees it when the process ends.
#[derive(Debug)]
pub(super) struct EditorLock {
    _lock: Lock,
    path: PathBuf,
}

impl EditorLock {
    /// `None` in a folder that takes no lock, such as a read-only one.
    /// Errors: another editor has the level, by its user and process, in words.
    pub fn take(folder: &Path) -> Result<Option<Self>, String> {
        let path = folder.join(".autosave.lock");
        match Lock::wait(&path, Duration::ZERO) {
            Ok(lock) => {
                let user = ["USER", "USERNAME"].iter().find_map(|name| env::var(name).ok()).unwrap_or_default();
                // A page has no number, and to ask for one ends it.
                let who = if cfg!(target_family = "wasm") { user } else { format!("{user} ({})", process::id()) };
                // Without it the refusal names nobody.
                let _ = lock.sign(&who);
                Ok(Some(Self { _lock: lock, path }))
            }
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => {
                let bytes = files::read_with(&path, MOST, Symlinks::Never).unwrap_or_default();
                let who: String = String::from_utf8_lossy(&bytes).chars().filter(|letter| !letter.is_control()).collect();
                Err(tr!("another editor has this level open: {who}. Close it there, and try again.", who))
            }
            Err(_) => Ok(None),
        }
    }
}

impl Drop for EditorLock {
    fn drop(&mut self) {
        // The next editor takes over a file that stays.
        let _ = files::remove(&self.path);
    }
}
