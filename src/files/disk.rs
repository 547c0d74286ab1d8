//! Files on a disk.

use super::lock::Lock;
use super::read::{Symlinks, read_file};
use super::staged::{self, Replacement, around};
use super::storage::{FileKind, Found, Manner, Storage};
use std::ffi::OsString;
use std::fs::{self, File, Metadata};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

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
