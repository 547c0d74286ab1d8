//! The one trait behind which files stand, whatever their home: a disk, or what a browser keeps; files on a disk; and locks between programs. The
//! system frees a lock when its process ends. The lock file stays; where a holder removes it, the next one locks the file of its name by then.

use super::read::{Symlinks, open, read_file};
use super::staged::{self, Replacement, around};
use std::ffi::OsString;
use std::fs::{self, File, Metadata, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    File,
    Folder,
    /// Only where links are not followed.
    Link,
    /// A pipe or a device.
    Other,
}

/// A file or a folder from the outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Found {
    pub kind: FileKind,
    /// Bytes; 0 for a folder.
    pub length: u64,
    pub read_only: bool,
    /// Another value after every write, as far as the home can tell.
    pub stamp: (Option<SystemTime>, u64),
}

/// The manner of a replacement.
#[derive(Clone, Copy, Debug)]
pub struct Manner {
    pub links: Symlinks,
    /// The content outlasts a power cut once the write has returned.
    pub durable: bool,
    /// Every user who may write in the folder may write a new file.
    pub shared: bool,
}

pub trait Storage: Sync {
    /// Errors: [`io::ErrorKind::NotFound`]; the home's.
    fn look(&self, path: &Path, links: Symlinks) -> io::Result<Found>;
    /// In any order.
    fn names(&self, folder: &Path) -> io::Result<Vec<OsString>>;
    /// The path without links and dots.
    fn resolve(&self, path: &Path) -> io::Result<PathBuf>;
    /// At most `at_most` bytes. Errors: no regular file, or a larger one; the home's.
    fn read(&self, path: &Path, at_most: u64, links: Symlinks) -> io::Result<Vec<u8>>;

    /// Makes or replaces a file. After an error the old content is in its place.
    fn replace(&self, path: &Path, bytes: &[u8], manner: Manner) -> io::Result<()>;

    /// Makes a file where there is none. Errors: [`io::ErrorKind::AlreadyExists`]; the home's. Nothing is left behind then.
    fn create(&self, path: &Path, bytes: &[u8]) -> io::Result<()>;

    /// Writes a new file of a folder that [`Storage::create_folder`] fills, which makes it durable with all others.
    fn put(&self, path: &Path, bytes: &[u8]) -> io::Result<()>;

    /// Makes a folder with those around it. One that is there stays.
    fn make_folder(&self, path: &Path) -> io::Result<()>;

    /// Makes a folder, if there is none, for every user who may write in the one around it.
    fn make_shared_folder(&self, path: &Path) -> io::Result<()>;

    /// Makes a folder where there is none, whole or not at all: `fill` fills the folder of the path that it is given.
    fn create_folder(&self, path: &Path, fill: &mut dyn FnMut(&Path) -> io::Result<()>) -> io::Result<()>;
    fn remove(&self, path: &Path) -> io::Result<()>;
    fn rename(&self, from: &Path, to: &Path) -> io::Result<()>;
    fn lock(&self, path: &Path, patience: Duration) -> io::Result<Lock>;
}

#[derive(Debug)]
pub struct Disk;

impl Storage for Disk {
    fn look(&self, path: &Path, links: Symlinks) -> io::Result<Found> {
        let found = match links {
            Symlinks::Followed => fs::metadata(path)?,
            Symlinks::Never => fs::symlink_metadata(path)?,
        };
        let kind = match found.file_type() {
            kind if kind.is_file() => FileKind::File,
            kind if kind.is_dir() => FileKind::Folder,
            kind if kind.is_symlink() => FileKind::Link,
            _ => FileKind::Other,
        };
        let length = if kind == FileKind::File { found.len() } else { 0 };
        let stamp = (found.modified().ok(), changed(&found));
        Ok(Found { kind, length, read_only: found.permissions().readonly(), stamp })
    }

    fn names(&self, folder: &Path) -> io::Result<Vec<OsString>> {
        fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name())).collect()
    }

    fn resolve(&self, path: &Path) -> io::Result<PathBuf> {
        path.canonicalize()
    }

    fn read(&self, path: &Path, at_most: u64, links: Symlinks) -> io::Result<Vec<u8>> {
        read_file(path, at_most, links)
    }

    fn replace(&self, path: &Path, bytes: &[u8], manner: Manner) -> io::Result<()> {
        let mut fresh = Replacement::begin(path, manner.links)?;
        fresh.file().write_all(bytes)?;
        if manner.shared && fresh.is_new() {
            super::share(around(path), fresh.file(), false)?;
        }
        if manner.durable {
            fresh.seal()?;
        }
        fresh.finish()
    }

    fn create(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        staged::create(path, bytes)
    }

    fn put(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        File::create_new(path)?.write_all(bytes)
    }

    fn make_folder(&self, path: &Path) -> io::Result<()> {
        fs::create_dir_all(path)
    }

    fn make_shared_folder(&self, path: &Path) -> io::Result<()> {
        match fs::create_dir(path) {
            Ok(()) => {
                if let Some(around) = path.parent() {
                    // Where that is refused, only its maker can write in the folder.
                    let _ = fs::metadata(around).and_then(|around| fs::set_permissions(path, around.permissions()));
                }
                Ok(())
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && path.is_dir() => Ok(()),
            Err(error) => Err(error),
        }
    }

    fn create_folder(&self, path: &Path, fill: &mut dyn FnMut(&Path) -> io::Result<()>) -> io::Result<()> {
        staged::create_folder(path, fill)
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
        fs::remove_file(path)
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        fs::rename(from, to)
    }

    fn lock(&self, path: &Path, patience: Duration) -> io::Result<Lock> {
        Lock::of_file(path, patience)
    }
}

/// Another value after every write, even where the time stays; ns.
#[cfg(unix)]
fn changed(found: &Metadata) -> u64 {
    use std::os::unix::fs::MetadataExt;
    (found.ctime() as u64).wrapping_mul(1_000_000_000).wrapping_add(found.ctime_nsec() as u64) ^ found.ino().rotate_left(32)
}

#[cfg(not(unix))]
fn changed(_: &Metadata) -> u64 {
    0
}

/// A write takes milliseconds: a process that holds a lock for longer hangs.
pub const PATIENCE: Duration = Duration::from_secs(2);

/// Between two looks at a held lock. Where many processes save without end, each gets its turn by luck: with longer pauses some would come too late.
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

    pub(super) fn of_file(path: &Path, patience: Duration) -> io::Result<Self> {
        let mut file = open_lock(path)?;
        let begun = Instant::now();
        loop {
            match file.try_lock() {
                Ok(()) if is_at(&file, path) => return Ok(Self { held: Some(file) }),
                // The holder before has removed the file.
                Ok(()) => file = open_lock(path)?,
                Err(TryLockError::WouldBlock) if begun.elapsed() < patience => std::thread::sleep(PAUSE),
                Err(TryLockError::WouldBlock) => return Err(io::ErrorKind::WouldBlock.into()),
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
    }
}

fn open_lock(path: &Path) -> io::Result<File> {
    match File::create_new(path) {
        Ok(file) => return share(around(path), &file, true).map(|()| file),
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
        Err(error) => return Err(error),
    }
    // The file only carries the lock: of another user's file, a reader's rights are enough.
    let opened = open(OpenOptions::new().write(true), path, Symlinks::Never);
    opened.or_else(|_| open(OpenOptions::new().read(true), path, Symlinks::Never)).map(|(file, _)| file)
}

#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let same = |(a, b): (Metadata, Metadata)| a.dev() == b.dev() && a.ino() == b.ino();
    file.metadata().ok().zip(fs::symlink_metadata(path).ok()).is_some_and(same)
}

/// Elsewhere an open file cannot be removed.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// Lets every user who may write in the folder read and write the file, against the umask. Others keep their rights, or have none to a private file.
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
