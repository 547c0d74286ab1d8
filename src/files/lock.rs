//! Locks between programs. The system frees a lock when its process ends. The lock file stays; where a holder removes it, the next one
//! locks the file that has its name by then.

use super::read::{Symlinks, open};
use super::staged::around;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::Path;
use std::time::{Duration, Instant};

/// A write takes milliseconds: a process that holds a lock for longer hangs.
pub const PATIENCE: Duration = Duration::from_secs(2);

/// Between two looks at a held lock. Where many processes save without end, each gets its turn by luck: with longer pauses some
/// would come too late.
const PAUSE: Duration = Duration::from_millis(1);

/// Held until the value is dropped.
#[derive(Debug)]
pub struct Lock {
    held: Option<File>,
}

impl Lock {
    /// The lock of a home without other programs.
    #[cfg(any(browser, test))]
    pub const fn of_nothing() -> Self {
        Self { held: None }
    }

    /// Writes into the locked file who holds it.
    pub fn sign(&self, who: &str) -> io::Result<()> {
        let Some(mut file) = self.held.as_ref() else { return Ok(()) };
        file.set_len(0)?;
        file.write_all(who.as_bytes())
    }

    /// As [`Lock::wait`], on a disk.
    pub(super) fn of_file(path: &Path, patience: Duration) -> io::Result<Self> {
        let mut file = open_lock(path)?;
        let begun = Instant::now();
        loop {
            match file.try_lock() {
                Ok(()) if is_at(&file, path) => return Ok(Self { held: Some(file) }),
                // The holder before has removed the file.
                Ok(()) => file = open_lock(path)?,
                Err(TryLockError::WouldBlock) if begun.elapsed() < patience => {
                    std::thread::sleep(PAUSE);
                }
                Err(TryLockError::WouldBlock) => return Err(io::ErrorKind::WouldBlock.into()),
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
    }
}

fn open_lock(path: &Path) -> io::Result<File> {
    match File::create_new(path) {
        Ok(file) => {
            share(around(path), &file, true)?;
            return Ok(file);
        }
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
        Err(error) => return Err(error),
    }
    // The file only carries the lock: of another user's file, a reader's rights are enough.
    let opened = open(OpenOptions::new().write(true), path, Symlinks::Never);
    opened.or_else(|_| open(OpenOptions::new().read(true), path, Symlinks::Never)).map(|(file, _)| file)
}

#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::fs::{Metadata, symlink_metadata};
    use std::os::unix::fs::MetadataExt;
    let same = |a: Metadata, b: Metadata| a.dev() == b.dev() && a.ino() == b.ino();
    file.metadata().ok().zip(symlink_metadata(path).ok()).is_some_and(|(a, b)| same(a, b))
}

/// Elsewhere an open file cannot be removed.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// Lets every user who may write in the folder read and write the file, against the process' umask. Other users keep their rights,
/// or have none to a private file.
#[cfg(unix)]
pub fn share(folder: &Path, file: &File, private: bool) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let may_write = std::fs::metadata(folder)?.permissions().mode() & 0o022;
    let least = if private { 0o600 } else { file.metadata()?.permissions().mode() & 0o777 };
    file.set_permissions(std::fs::Permissions::from_mode(least | may_write | may_write << 1))
}

/// Other systems have no such modes.
#[cfg(not(unix))]
pub fn share(_: &Path, _: &File, _: bool) -> io::Result<()> {
    Ok(())
}
