//! The levels, experiments and assets that are built in, and a home above them: a file of the home hides a shipped one of its path,
//! and a shipped one can be neither removed nor renamed.

use super::read::{Symlinks, too_large};
use super::storage::{Disk, FileKind, Found, Lock, Manner, Storage};
use crate::{built_in::SHIPPED, words::tr};
use std::path::{Component, Path, PathBuf};
use std::{collections::BTreeSet, ffi::OsString, io, sync::OnceLock, time::Duration};

static ABOVE_SHIPPED: OnceLock<AboveShipped<Disk>> = OnceLock::new();

/// From now on the shipped files lie beneath that folder of the disk, for all of this process. A second call changes nothing.
pub fn ship_at(root: &Path) {
    let _ = ABOVE_SHIPPED.set(AboveShipped::new(Disk, root));
}

/// As [`ship_at`], with the experiments and the assets alone: the levels are those of the folder.
pub fn ship_lessons_at(root: &Path) {
    let _ = ABOVE_SHIPPED.set(AboveShipped { lessons: true, ..AboveShipped::new(Disk, root) });
}

#[cfg(not(all(browser, feature = "window")))]
pub(super) fn desktop() -> &'static dyn Storage {
    ABOVE_SHIPPED.get().map_or(&Disk, |over| over as &dyn Storage)
}

/// A home with the shipped files beneath its folder `root`.
#[derive(Debug)]
pub struct AboveShipped<H> {
    home: H,
    root: PathBuf,
    /// `root` without links.
    resolved: PathBuf,
    /// Only [`LESSONS`] lie beneath, and of them no folder that the home has.
    lessons: bool,
}

/// Where the experiments are, from a project's root: in the folder of its levels, though none of them.
pub const EXPERIMENTS: &str = "levels/experiments";

const LESSONS: [&str; 2] = [EXPERIMENTS, "assets"];

enum ShippedItem {
    File(&'static [u8]),
    Folder,
}

impl<H: Storage> AboveShipped<H> {
    pub fn new(home: H, root: &Path) -> Self {
        let resolved = home.resolve(root).unwrap_or_else(|_| root.to_path_buf());
        Self { home, root: root.to_path_buf(), resolved, lessons: false }
    }

    pub const fn home(&self) -> &H {
        &self.home
    }

    /// The path from the root, with forward slashes; `None` outside of it.
    fn within(&self, path: &Path) -> Option<String> {
        let within = path.strip_prefix(&self.root).or_else(|_| path.strip_prefix(&self.resolved)).ok()?;
        let mut parts = Vec::new();
        for part in within.components() {
            match part {
                Component::Normal(name) => parts.push(name.to_str()?),
                Component::CurDir => {}
                _ => return None,
            }
        }
        Some(parts.join("/"))
    }

    /// Whether shipped files show at a path from the root.
    fn shows(&self, path: &str) -> bool {
        let shows_below = |folder: &str| {
            let Ok(below) = Path::new(path).strip_prefix(folder) else { return false };
            let hidden = |name| self.home.look(&self.root.join(folder).join(name), Symlinks::Followed).is_ok();
            !below.components().next().is_some_and(hidden)
        };
        !self.lessons || LESSONS.into_iter().any(shows_below)
    }

    fn shipped(&self, path: &Path) -> Option<ShippedItem> {
        let path = self.within(path).filter(|path| self.shows(path))?;
        let (first, folder) = from(&path);
        match SHIPPED.get(first) {
            Some((file, bytes)) if *file == path => Some(ShippedItem::File(bytes)),
            Some((file, _)) if file.starts_with(&folder) => Some(ShippedItem::Folder),
            _ => None,
        }
    }

    /// What the home answers, or, where it has nothing there, what the shipped files do.
    fn or_shipped<T>(&self, path: &Path, own: io::Result<T>, shipped: impl FnOnce(ShippedItem) -> io::Result<T>) -> io::Result<T> {
        match own {
            Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => {
                match self.shipped(path) {
                    Some(item) => shipped(item),
                    // A user's folder below a file: what it lacks is simply not there.
                    None if error.kind() == io::ErrorKind::NotADirectory && !self.lessons => Err(io::ErrorKind::NotFound.into()),
                    None => Err(error),
                }
            }
            own => own,
        }
    }

    /// Makes the home's folder for a new file of a shipped folder.
    fn make_room(&self, path: &Path) -> io::Result<()> {
        let around = super::around(path);
        if matches!(self.shipped(around), Some(ShippedItem::Folder)) { self.home.make_folder(around) } else { Ok(()) }
    }

    fn refuse_taken(&self, path: &Path) -> io::Result<()> {
        self.shipped(path).map_or(Ok(()), |_| Err(io::ErrorKind::AlreadyExists.into()))
    }
}

/// The number of the first shipped file at or below a path, and the beginning of the paths below it.
fn from(path: &str) -> (usize, String) {
    let folder = if path.is_empty() { String::new() } else { format!("{path}/") };
    // A file `a` and a folder `a/` never stand together; `a.txt` comes before `a/`, hence the two searches.
    let exact = SHIPPED.binary_search_by(|(file, _)| (*file).cmp(path));
    (exact.unwrap_or_else(|_| SHIPPED.partition_point(|(file, _)| *file < folder.as_str())), folder)
}

fn ships() -> io::Error {
    io::Error::new(io::ErrorKind::PermissionDenied, tr("it comes with the game, and stays as it is"))
}

impl<H: Storage> Storage for AboveShipped<H> {
    fn look(&self, path: &Path, links: Symlinks) -> io::Result<Found> {
        self.or_shipped(path, self.home.look(path, links), |item| {
            let (kind, length) = match item {
                ShippedItem::File(bytes) => (FileKind::File, bytes.len() as u64),
                ShippedItem::Folder => (FileKind::Folder, 0),
            };
            Ok(Found { kind, length, read_only: false, stamp: (None, 0) })
        })
    }

    fn names(&self, folder: &Path) -> io::Result<Vec<OsString>> {
        let own = self.or_shipped(folder, self.home.names(folder), |item| match item {
            ShippedItem::File(_) => Err(io::ErrorKind::NotADirectory.into()),
            ShippedItem::Folder => Ok(Vec::new()),
        })?;
        let mut names: BTreeSet<OsString> = own.into_iter().collect();
        if let Some(path) = self.within(folder).filter(|path| self.shows(path)) {
            let (first, beginning) = from(&path);
            let below = SHIPPED[first..].iter().map_while(|(file, _)| file.strip_prefix(beginning.as_str()));
            names.extend(below.filter_map(|file| file.split('/').next()).map(OsString::from));
        }
        Ok(names.into_iter().collect())
    }

    fn resolve(&self, path: &Path) -> io::Result<PathBuf> {
        let within = || self.resolved.join(self.within(path).unwrap_or_default());
        self.or_shipped(path, self.home.resolve(path), |_| Ok(within()))
    }

    fn read(&self, path: &Path, at_most: u64, links: Symlinks) -> io::Result<Vec<u8>> {
        self.or_shipped(path, self.home.read(path, at_most, links), |item| match item {
            ShippedItem::File(bytes) if bytes.len() as u64 > at_most => Err(too_large(Some(bytes.len() as u64), at_most)),
            ShippedItem::File(bytes) => Ok(bytes.to_vec()),
            ShippedItem::Folder => Err(io::ErrorKind::IsADirectory.into()),
        })
    }

    fn replace(&self, path: &Path, bytes: &[u8], manner: Manner) -> io::Result<()> {
        self.make_room(path)?;
        self.home.replace(path, bytes, manner)
    }

    fn create(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.refuse_taken(path)?;
        self.make_room(path)?;
        self.home.create(path, bytes)
    }

    fn put(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.home.put(path, bytes)
    }

    fn make_folder(&self, path: &Path) -> io::Result<()> {
        self.home.make_folder(path)
    }

    fn make_shared_folder(&self, path: &Path) -> io::Result<()> {
        self.home.make_shared_folder(path)
    }

    fn create_folder(&self, path: &Path, fill: &mut dyn FnMut(&Path) -> io::Result<()>) -> io::Result<()> {
        self.refuse_taken(path)?;
        self.home.create_folder(path, fill)
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
        self.or_shipped(path, self.home.remove(path), |_| Err(ships()))
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        self.refuse_taken(to)?;
        if self.shipped(from).is_some() {
            return Err(ships());
        }
        self.home.rename(from, to)
    }

    fn lock(&self, path: &Path, patience: Duration) -> io::Result<Lock> {
        self.home.lock(path, patience)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::LEVEL_TABLE;
    use std::fs;

    fn is_folder(over: &AboveShipped<Disk>, path: &str) -> bool {
        over.look(&over.root.join(path), Symlinks::Followed).is_ok_and(|found| found.kind == FileKind::Folder)
    }

    #[test]
    fn shipped_files_lie_beneath_the_users() {
        let folder = tempfile::tempdir().unwrap();
        let over = AboveShipped::new(Disk, folder.path());
        let path = |name: &str| folder.path().join(name);
        let read = |name: &str| over.read(&path(name), LEVEL_TABLE, Symlinks::Followed);
        let shipped = read("levels/1/player.csv").unwrap();
        assert_eq!(shipped, fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/levels/1/player.csv")).unwrap());
        assert!(is_folder(&over, "levels") && is_folder(&over, "levels/1") && is_folder(&over, "") && !is_folder(&over, "level"));
        assert_eq!(read("levels/1/no.csv").unwrap_err().kind(), io::ErrorKind::NotFound);
        assert_eq!(read("levels").unwrap_err().kind(), io::ErrorKind::IsADirectory);
        assert_eq!(over.read(&path("levels/1/player.csv"), 3, Symlinks::Followed).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        over.create_folder(&path("levels/mine"), &mut |begun| fs::write(begun.join("player.csv"), "mine")).unwrap();
        over.replace(&path("levels/1/player.csv"), b"other", Manner { links: Symlinks::Never, durable: false, shared: false })
            .unwrap();
        assert_eq!(
            (read("levels/mine/player.csv").unwrap(), read("levels/1/player.csv").unwrap()),
            (b"mine".to_vec(), b"other".to_vec())
        );
        let names = over.names(&path("levels")).unwrap();
        assert!(
            names.contains(&"mine".into()) && names.contains(&"1".into()) && names.contains(&"shipped.csv".into()),
            "{names:?}"
        );
        over.remove(&path("levels/1/player.csv")).unwrap();
        assert_eq!(read("levels/1/player.csv").unwrap(), shipped);
        for refused in [over.remove(&path("levels/1/player.csv")), over.rename(&path("levels/1"), &path("levels/one"))] {
            assert_eq!(refused.unwrap_err().kind(), io::ErrorKind::PermissionDenied);
        }
        assert_eq!(over.create_folder(&path("levels/1"), &mut |_| Ok(())).unwrap_err().kind(), io::ErrorKind::AlreadyExists);
        assert_eq!(over.resolve(&path("levels/./1")).unwrap(), folder.path().canonicalize().unwrap().join("levels/1"));
    }

    #[test]
    fn the_list_is_in_order_and_holds_what_a_player_needs() {
        assert!(SHIPPED.is_sorted_by_key(|(path, _)| *path), "it is searched by halves");
        for needed in
            ["levels/shipped.csv", "levels/experiments/experiments.csv", "assets/tile_run/map.txt", "assets/sprites/ball.png"]
        {
            assert!(SHIPPED.iter().any(|(path, _)| *path == needed), "{needed}");
        }
    }
}
