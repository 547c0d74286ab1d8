//! Files as values under keys, as a browser keeps them for a page: a path is a key, and a folder is there while a file lies in it.

use super::read::{Symlinks, too_large};
use super::storage::{FileKind, Found, Lock, Manner, Storage};
use crate::words::tr;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Component, Path, PathBuf};
use std::{collections::BTreeSet, ffi::OsString, io, time::Duration};

/// The reason why a value is not kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeepingFault {
    Full,
    Forbidden,
    /// The value is not one that this program has written.
    Damaged,
}

impl From<KeepingFault> for io::Error {
    fn from(fault: KeepingFault) -> Self {
        let (kind, words) = match fault {
            KeepingFault::Full => {
                (io::ErrorKind::StorageFull, tr("the browser's room for this page is full: see “Your data” in the menu"))
            }
            KeepingFault::Forbidden => (io::ErrorKind::PermissionDenied, tr("the browser keeps no data for this page")),
            KeepingFault::Damaged => (io::ErrorKind::InvalidData, tr("the browser's data for this file are damaged")),
        };
        Self::new(kind, words)
    }
}

pub trait Keeper: Sync {
    fn get(&self, key: &str) -> Result<Option<Vec<u8>>, KeepingFault>;
    /// After an error the old value stands.
    fn set(&self, key: &str, value: &[u8]) -> Result<(), KeepingFault>;
    fn remove(&self, key: &str);
    fn keys(&self) -> Vec<String>;
}

#[derive(Debug)]
pub struct PageFiles<K>(pub K);

impl<K: Keeper> PageFiles<K> {
    fn bytes(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.0.get(&key(path)?)?.ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn refuse_taken(&self, path: &Path) -> io::Result<()> {
        if self.look(path, Symlinks::Never).is_ok() { Err(io::ErrorKind::AlreadyExists.into()) } else { Ok(()) }
    }

    /// The keys of a file, or of all files below a folder.
    fn below(&self, key: &str) -> Vec<String> {
        let folder = folder(key);
        self.0.keys().into_iter().filter(|other| other == key || other.starts_with(&folder)).collect()
    }
}

/// The beginning of the keys below a folder.
fn folder(key: &str) -> String {
    if key.is_empty() { String::new() } else { format!("{key}/") }
}

fn key(path: &Path) -> io::Result<String> {
    let mut parts = Vec::new();
    for part in path.components() {
        match part {
            Component::Normal(name) => parts.push(name.to_str().ok_or(io::ErrorKind::InvalidFilename)?),
            Component::ParentDir => drop(parts.pop()),
            _ => {}
        }
    }
    Ok(parts.join("/"))
}

impl<K: Keeper> Storage for PageFiles<K> {
    fn look(&self, path: &Path, _: Symlinks) -> io::Result<Found> {
        let key = key(path)?;
        if let Some(bytes) = self.0.get(&key)? {
            let mut hasher = DefaultHasher::new();
            bytes.hash(&mut hasher);
            let stamp = (None, hasher.finish());
            return Ok(Found { kind: FileKind::File, length: bytes.len() as u64, read_only: false, stamp });
        }
        if key.is_empty() || !self.below(&key).is_empty() {
            return Ok(Found { kind: FileKind::Folder, length: 0, read_only: false, stamp: (None, 0) });
        }
        Err(io::ErrorKind::NotFound.into())
    }

    fn names(&self, path: &Path) -> io::Result<Vec<OsString>> {
        let key = key(path)?;
        let (folder, below) = (folder(&key), self.below(&key));
        let name =
            |other: &String| Some(other.strip_prefix(&folder)?.split('/').next()?.to_owned()).filter(|name| !name.is_empty());
        let names: BTreeSet<String> = below.iter().filter_map(name).collect();
        if names.is_empty() && !key.is_empty() {
            return Err(io::ErrorKind::NotFound.into());
        }
        Ok(names.into_iter().map(OsString::from).collect())
    }

    fn resolve(&self, path: &Path) -> io::Result<PathBuf> {
        self.look(path, Symlinks::Followed)?;
        Ok(PathBuf::from(key(path)?))
    }

    fn read(&self, path: &Path, at_most: u64, _: Symlinks) -> io::Result<Vec<u8>> {
        let bytes = self.bytes(path)?;
        let length = bytes.len() as u64;
        if length > at_most { Err(too_large(Some(length), at_most)) } else { Ok(bytes) }
    }

    fn replace(&self, path: &Path, bytes: &[u8], _: Manner) -> io::Result<()> {
        Ok(self.0.set(&key(path)?, bytes)?)
    }

    fn create(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.refuse_taken(path)?;
        Ok(self.0.set(&key(path)?, bytes)?)
    }

    fn put(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.create(path, bytes)
    }

    fn make_folder(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn make_shared_folder(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn create_folder(&self, path: &Path, fill: &mut dyn FnMut(&Path) -> io::Result<()>) -> io::Result<()> {
        self.refuse_taken(path)?;
        let key = key(path)?;
        fill(path).inspect_err(|_| self.below(&key).iter().for_each(|key| self.0.remove(key)))
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
        self.bytes(path)?;
        self.0.remove(&key(path)?);
        Ok(())
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        let (from, to) = (key(from)?, key(to)?);
        let olds = self.below(&from);
        if olds.is_empty() {
            return Err(io::ErrorKind::NotFound.into());
        }
        let new = |old: &str| format!("{to}{}", &old[from.len()..]);
        for (moved, old) in olds.iter().enumerate() {
            let copied = self.0.get(old).and_then(|value| self.0.set(&new(old), &value.unwrap_or_default()));
            if let Err(fault) = copied {
                olds[..moved].iter().for_each(|old| self.0.remove(&new(old)));
                return Err(fault.into());
            }
        }
        olds.iter().for_each(|old| self.0.remove(old));
        Ok(())
    }

    /// A page changes a file within one call, and no other page comes between.
    fn lock(&self, _: &Path, _: Duration) -> io::Result<Lock> {
        Ok(Lock::of_nothing())
    }
}

#[cfg(test)]
pub use tests::MemoryStorage;

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;
    use std::sync::{Mutex, MutexGuard, PoisonError};

    /// A storage of limited room in memory.
    pub struct MemoryStorage {
        kept: Mutex<BTreeMap<String, Vec<u8>>>,
        /// Bytes.
        room: usize,
    }

    impl MemoryStorage {
        pub fn with_room(room: usize) -> Self {
            Self { kept: Mutex::default(), room }
        }

        fn kept(&self) -> MutexGuard<'_, BTreeMap<String, Vec<u8>>> {
            self.kept.lock().unwrap_or_else(PoisonError::into_inner)
        }
    }

    impl Keeper for MemoryStorage {
        fn get(&self, key: &str) -> Result<Option<Vec<u8>>, KeepingFault> {
            Ok(self.kept().get(key).cloned())
        }

        fn set(&self, key: &str, value: &[u8]) -> Result<(), KeepingFault> {
            let mut kept = self.kept();
            let others: usize = kept.iter().filter(|(other, _)| *other != key).map(|(_, value)| value.len()).sum();
            if others + value.len() > self.room {
                return Err(KeepingFault::Full);
            }
            kept.insert(key.to_owned(), value.to_vec());
            Ok(())
        }

        fn remove(&self, key: &str) {
            self.kept().remove(key);
        }

        fn keys(&self) -> Vec<String> {
            self.kept().keys().cloned().collect()
        }
    }

    fn little(room: usize) -> PageFiles<MemoryStorage> {
        PageFiles(MemoryStorage::with_room(room))
    }

    fn text(kept: &PageFiles<MemoryStorage>, path: &str) -> io::Result<String> {
        kept.read(Path::new(path), 1 << 20, Symlinks::Followed).map(|bytes| String::from_utf8(bytes).unwrap())
    }

    #[test]
    fn a_full_storage_loses_nothing() {
        let kept = little(10);
        let manner = Manner { links: Symlinks::Followed, durable: true, shared: false };
        kept.replace(Path::new("scores/1.csv"), b"12345", manner).unwrap();
        let full = kept.replace(Path::new("scores/1.csv"), b"12345678901", manner).unwrap_err();
        assert_eq!(full.kind(), io::ErrorKind::StorageFull);
        assert_eq!(text(&kept, "scores/1.csv").unwrap(), "12345");
        let folder = kept.create_folder(Path::new("levels/mine"), &mut |begun| {
            kept.create(&begun.join("a"), b"123")?;
            kept.create(&begun.join("b"), b"123")
        });
        assert_eq!(folder.unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert_eq!(kept.look(Path::new("levels"), Symlinks::Followed).unwrap_err().kind(), io::ErrorKind::NotFound);
        kept.create(&Path::new("levels").join("a/x"), b"123").unwrap();
        assert!(kept.rename(Path::new("levels/a"), Path::new("levels/bb")).is_err());
        assert_eq!((text(&kept, "levels/a/x").unwrap().as_str(), kept.0.keys().len()), ("123", 2));
    }

    #[test]
    fn folders_are_there_while_a_file_lies_in_them() {
        let kept = little(1000);
        for file in ["levels/b/player.csv", "levels/a/flights/x.replay.csv", "levels.txt"] {
            kept.create(Path::new(file), b"x").unwrap();
        }
        assert_eq!(kept.names(Path::new("./levels")).unwrap(), ["a", "b"]);
        assert_eq!(kept.names(Path::new(".")).unwrap(), ["levels", "levels.txt"]);
        kept.rename(Path::new("levels/a"), Path::new("levels/c")).unwrap();
        assert_eq!(text(&kept, "levels/../levels/c/flights/x.replay.csv").unwrap(), "x");
        kept.remove(Path::new("levels/c/flights/x.replay.csv")).unwrap();
        assert_eq!(kept.names(Path::new("levels")).unwrap(), ["b"]);
        assert_eq!(kept.create(Path::new("levels/b"), b"").unwrap_err().kind(), io::ErrorKind::AlreadyExists);
    }
}
