//! Whether a level's files have changed on disk since they were read: looked at a few times a second, and read only where sizes or times
//! differ. What is in them is the loader's affair.

use crate::files;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// From one look to the next, s. A change counts when two looks have found the same: an editor may be writing still.
const EVERY: f64 = 0.1;

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stamp(Vec<(PathBuf, u64, (Option<SystemTime>, u64))>);

impl Stamp {
    /// Of the tables and pictures of a folder, and of these files.
    pub fn of(folder: &Path, more: &[PathBuf]) -> Self {
        let entries = files::names(folder).into_iter().flatten().map(|name| folder.join(name));
        let mut files: Vec<PathBuf> = entries.filter(|path| counts(path)).chain(more.iter().cloned()).collect();
        files.sort_unstable();
        files.dedup();
        let seen = |path: PathBuf| {
            let found = files::look(&path).ok()?;
            Some((path, found.length, found.stamp))
        };
        Self(files.into_iter().filter_map(seen).collect())
    }

    fn content(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        for (path, ..) in &self.0 {
            (path, files::read(path, files::PICTURE).ok()).hash(&mut hasher);
        }
        hasher.finish()
    }
}

/// Whether a file of a level's folder counts: no hidden one, and none that is the author's own.
fn counts(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
    !name.starts_with('.') && (name.ends_with(".csv") || name.ends_with(".png"))
}

#[derive(Debug)]
pub struct FolderWatch {
    pub folder: PathBuf,
    /// Pictures from elsewhere.
    more: Vec<PathBuf>,
    /// As it was when it was read.
    known: Stamp,
    content: u64,
    last: Stamp,
    /// Until the next look, s.
    wait: f64,
}

impl FolderWatch {
    /// Watches a folder, and these files besides, from now on.
    pub fn new(folder: PathBuf, more: Vec<PathBuf>) -> Self {
        let known = Stamp::of(&folder, &more);
        Self { content: known.content(), last: known.clone(), known, folder, more, wait: EVERY }
    }

    /// Looks, if it is time to; whether what is there has changed since it was last said so.
    pub fn update(&mut self, frame_time: f64) -> bool {
        self.wait -= frame_time;
        if self.wait > 0.0 {
            return false;
        }
        self.wait = EVERY;
        let now = Stamp::of(&self.folder, &self.more);
        let settled = now == self.last;
        self.last = now;
        settled && self.last != self.known && self.take()
    }

    /// Takes what is there for known; whether it is something else than before.
    pub fn take(&mut self) -> bool {
        self.known = Stamp::of(&self.folder, &self.more);
        let content = self.known.content();
        std::mem::replace(&mut self.content, content) != content
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    /// Frames, at 60 a second, until the watch reports a change.
    fn frames(watch: &mut FolderWatch) -> Option<usize> {
        (0..60).find(|_| watch.update(1.0 / 60.0))
    }

    #[test]
    fn a_change_is_told_once_and_within_half_a_second() {
        let folder = tempfile::tempdir().unwrap();
        let (table, picture) = (folder.path().join("world.csv"), folder.path().join("background.png"));
        fs::write(&table, "1,2,3,4\n").unwrap();
        let mut watch = FolderWatch::new(folder.path().to_path_buf(), Vec::new());
        assert_eq!(frames(&mut watch), None);
        // As long as before, at whatever time.
        fs::write(&table, "1,2,3,5\n").unwrap();
        assert!(frames(&mut watch).is_some_and(|frames| frames < 25));
        assert_eq!(frames(&mut watch), None);
        fs::write(&picture, "no picture").unwrap();
        assert!(frames(&mut watch).is_some());
        fs::remove_file(&picture).unwrap();
        assert!(frames(&mut watch).is_some());
        // A file that is written again with the same content, and one that is none of the level's.
        fs::write(&table, "1,2,3,5\n").unwrap();
        fs::write(folder.path().join(".autosave"), "x").unwrap();
        fs::write(folder.path().join("notes.txt"), "x").unwrap();
        assert_eq!(frames(&mut watch), None);
    }
}
