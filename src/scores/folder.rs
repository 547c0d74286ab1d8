//! The folder that holds the scores files, one a level: reading, locking and replacing them.
//!
//! A save holds the lock on `.<level>.csv.lock` while it reads the file, adds the score, writes `.<level>.csv.new` and renames that
//! over the file. So no save of another process is lost, and whoever reads sees the old file or the new one, whole, whatever
//! happens in between. The system frees a lock when its process ends, however it ends. The lock file itself stays: were it
//! deleted, two processes could hold the locks of two different files of that name. Both names begin with a full stop, which keeps
//! them out of sight.
//!
//! A folder may be shared: whoever may write in it may also lock what is in it, and a board keeps its mode and its group whoever saves.
//! Where a board is a link, the file that it leads to is the board, and everything happens beside that.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::{Board, Damage, Name, Placement, ScoresError, table};
use crate::files;

/// How long a save waits for another process that saves there. A save takes milliseconds; whoever holds a lock for longer hangs.
pub const PATIENCE: Duration = Duration::from_secs(2);
/// The pause between two looks at a lock that is held. Where many processes save without end, each gets its turn by luck: with longer
/// pauses some would not get one in time.
const LOCK_PAUSE: Duration = Duration::from_millis(1);

/// How often a rename is tried. Windows refuses it while a virus scanner or a spreadsheet has the target open.
const RENAME_TRIES: u32 = if cfg!(windows) { 50 } else { 1 };
/// The pause between two tries. With fewer or shorter ones a save fails that would have succeeded.
const RENAME_PAUSE: Duration = Duration::from_millis(20);

/// The folder of all leaderboards.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scores {
    folder: PathBuf,
}

/// A leaderboard as read for display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loaded {
    /// All rows that could be read.
    pub board: Board,
    /// The places that could not.
    pub damage: Vec<Damage>,
}

/// What a save has done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saved {
    /// The board as it stands on disk now.
    pub board: Board,
    /// What became of the score.
    pub placement: Placement,
    /// Present when the file was damaged.
    pub rescue: Option<Rescue>,
}

/// How a damaged file was dealt with: its sound rows stand in the fresh file, its bytes in a copy beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rescue {
    /// The places that could not be read, in the damaged file.
    pub damage: Vec<Damage>,
    /// Where the damaged file is kept, byte for byte.
    pub kept: PathBuf,
}

impl Scores {
    /// The leaderboards in this folder, which need not exist yet.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// Reads a level's leaderboard and changes nothing. A missing file is an empty board.
    ///
    /// # Errors
    /// A level name that cannot name a file; a file that cannot be read at all.
    pub fn load(&self, level: &str) -> Result<Loaded, ScoresError> {
        let path = self.path(level)?;
        let (board, damage) = table::read(&path, &read_if_there(&path)?.unwrap_or_default());
        Ok(Loaded { board, damage })
    }

    /// Saves a score in a level's leaderboard; the file is on disk, whole, when this returns.
    ///
    /// Waits up to [`PATIENCE`] while another process saves there. A damaged file is kept aside as `<level>.csv.damaged-N` before it is
    /// replaced.
    ///
    /// # Errors
    /// A score below 1; a level name that cannot name a file; a read-only file; a board that is too large; another process that does
    /// not come to an end ([`ScoresError::Busy`]: it may be tried again); whatever the system refuses. The old file is untouched then.
    pub fn save(&self, level: &str, name: &Name, score: i64) -> Result<Saved, ScoresError> {
        self.save_within(PATIENCE, level, name, score)
    }

    /// As [`Scores::save`], with that much patience; without any it returns at once.
    ///
    /// # Errors
    /// As [`Scores::save`].
    pub fn save_within(&self, patience: Duration, level: &str, name: &Name, score: i64) -> Result<Saved, ScoresError> {
        let path = self.path(level)?;
        if score < 1 {
            return Err(ScoresError::NoScore);
        }
        fs::create_dir_all(&self.folder).map_err(ScoresError::file("create the scores folder", &self.folder))?;
        let path = behind_links(path)?;
        let folder = path.parent().unwrap_or(&self.folder);
        let _lock = lock(folder, &hidden(&path, "lock"), patience)?;

        let old = read_if_there(&path)?;
        let (mut board, damage) = table::read(&path, old.as_deref().unwrap_or_default());
        let placement = board.place(name, score)?;
        let new = table::write(&board).map_err(ScoresError::file("write the new scores", &path))?;
        if new.len() as u64 > files::SCORES {
            return Err(ScoresError::Full(path));
        }

        let mut rescue = None;
        if old.as_ref() != Some(&new) {
            let staged = Staged::write(&path, &new)?;
            if let Some(old) = old.filter(|_| !damage.is_empty()) {
                rescue = Some(Rescue { damage, kept: keep_aside(&path, &old)? });
            }
            staged.replace(&path).inspect_err(|_| {
                // The damaged file is still in its place, so the copy is one too many.
                rescue.iter().for_each(|rescue| drop(fs::remove_file(&rescue.kept)));
            })?;
            sync_folder(folder);
        }
        Ok(Saved { board, placement, rescue })
    }

    /// The file of a level, whose name must be one that stays in the folder on every system.
    fn path(&self, level: &str) -> Result<PathBuf, ScoresError> {
        let plain = !level.is_empty() && !level.chars().any(|c| matches!(c, '/' | '\\' | ':') || c.is_control());
        if !plain || level == "." || level == ".." {
            return Err(ScoresError::LevelName(level.to_owned()));
        }
        Ok(self.folder.join(format!("{level}.csv")))
    }
}

/// The file that a board is: the one that its links lead to.
fn behind_links(path: PathBuf) -> Result<PathBuf, ScoresError> {
    if fs::symlink_metadata(&path).is_ok_and(|found| found.is_symlink()) {
        return path.canonicalize().map_err(ScoresError::file("follow the link to the scores", &path));
    }
    Ok(path)
}

/// The path of a companion of a scores file: `1.csv` and `damaged-1` make `1.csv.damaged-1`. No level's own file ends like that.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    PathBuf::from(name)
}

/// The path of a companion that is nobody's business: `1.csv` and `lock` make `.1.csv.lock`.
fn hidden(path: &Path, ending: &str) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    beside(&path.with_file_name(name), ending)
}

fn read_if_there(path: &Path) -> Result<Option<Vec<u8>>, ScoresError> {
    match files::read(path, files::SCORES) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(ScoresError::file("read the scores", path)(error)),
    }
}

/// Waits for the lock; it lasts until the returned file is dropped.
fn lock(folder: &Path, path: &Path, patience: Duration) -> Result<File, ScoresError> {
    let file = open_lock(folder, path).map_err(ScoresError::file("open the lock file", path))?;
    let begun = Instant::now();
    loop {
        match file.try_lock() {
            Ok(()) => return Ok(file),
            Err(TryLockError::WouldBlock) if begun.elapsed() < patience => std::thread::sleep(LOCK_PAUSE),
            Err(TryLockError::WouldBlock) => return Err(ScoresError::Busy(path.to_owned())),
            Err(TryLockError::Error(error)) => return Err(ScoresError::file("lock the scores", path)(error)),
        }
    }
}

/// Opens the lock file; makes it where there is none, for all who may write in the folder.
fn open_lock(folder: &Path, path: &Path) -> io::Result<File> {
    match File::create_new(path) {
        Ok(file) => {
            share(folder, &file, true)?;
            return Ok(file);
        }
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
        Err(error) => return Err(error),
    }
    if !fs::metadata(path)?.is_file() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "found something else, expected a regular file"));
    }
    // To hold a lock is all that it is for: where another user made it and only reading is allowed, that will do.
    OpenOptions::new().write(true).open(path).or_else(|_| File::open(path))
}

/// Lets all who may write in the folder read the file and write to it, whatever the process' umask says. Whether others may do what they
/// could do is as it was, or, for a file that is nobody else's business, no.
#[cfg(unix)]
fn share(folder: &Path, file: &File, private: bool) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let may_write = fs::metadata(folder)?.permissions().mode() & 0o022;
    let least = if private { 0o600 } else { file.metadata()?.permissions().mode() & 0o777 };
    file.set_permissions(fs::Permissions::from_mode(least | may_write | may_write << 1))
}

#[cfg(not(unix))]
fn share(_: &Path, _: &File, _: bool) -> io::Result<()> {
    Ok(())
}

/// Gives a file the group of what it is going to replace, where that is allowed: who shared the one shares the other.
#[cfg(unix)]
fn keep_group(file: &File, target: &fs::Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    if file.metadata().is_ok_and(|own| own.gid() != target.gid()) {
        // The folder may be shared in another way than by a group.
        let _ = fchown(file, None, Some(target.gid()));
    }
}

#[cfg(not(unix))]
fn keep_group(_: &File, _: &fs::Metadata) {}

/// The new content of a scores file, complete and on disk under a name of its own; gone with this value unless it took the file's
/// place. The lock makes the fixed name safe; what a killed process left there is written over.
struct Staged {
    path: PathBuf,
}

impl Staged {
    fn write(target: &Path, bytes: &[u8]) -> Result<Self, ScoresError> {
        let metadata = fs::metadata(target).ok();
        let permissions = metadata.as_ref().map(fs::Metadata::permissions);
        if permissions.as_ref().is_some_and(fs::Permissions::readonly) {
            return Err(ScoresError::ReadOnly(target.to_owned()));
        }
        let path = hidden(target, "new");
        // What a process that was killed left there may be another user's: it can be removed but not written to.
        if fs::symlink_metadata(&path).is_ok_and(|found| found.is_file()) {
            fs::remove_file(&path).map_err(ScoresError::file("write the new scores", &path))?;
        }
        let mut file = File::create(&path).map_err(ScoresError::file("write the new scores", &path))?;
        if let Some(metadata) = &metadata {
            keep_group(&file, metadata);
        }
        let staged = Self { path };
        let written = file.write_all(bytes).and_then(|()| file.sync_all()).and_then(|()| match permissions {
            Some(permissions) if file.metadata()?.permissions() != permissions => file.set_permissions(permissions),
            Some(_) => Ok(()),
            None => share(target.parent().unwrap_or(target), &file, false),
        });
        written.map_err(ScoresError::file("write the new scores", &staged.path))?;
        Ok(staged)
    }

    fn replace(self, target: &Path) -> Result<(), ScoresError> {
        let mut tries = 1;
        loop {
            match fs::rename(&self.path, target) {
                Ok(()) => return Ok(()),
                Err(error) if error.kind() == io::ErrorKind::PermissionDenied && tries < RENAME_TRIES => {
                    std::thread::sleep(RENAME_PAUSE);
                    tries += 1;
                }
                Err(error) => return Err(ScoresError::file("replace the scores", target)(error)),
            }
        }
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        // After the rename there is nothing to remove; and should this fail, the next save writes over it.
        drop(fs::remove_file(&self.path));
    }
}

/// Copies a damaged file's bytes beside it, under the first number that is free. A kill in the middle leaves a short copy, but then
/// the damaged file itself is still in its place and the next save keeps it under the next number.
fn keep_aside(path: &Path, bytes: &[u8]) -> Result<PathBuf, ScoresError> {
    const ATTEMPT: &str = "keep the damaged scores";
    let mut number = 0_u64;
    loop {
        number += 1;
        let kept = beside(path, &format!("damaged-{number}"));
        let mut file = match File::create_new(&kept) {
            Ok(file) => file,
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
            Err(error) => return Err(ScoresError::file(ATTEMPT, &kept)(error)),
        };
        if let Err(error) = file.write_all(bytes).and_then(|()| file.sync_all()) {
            drop(fs::remove_file(&kept));
            return Err(ScoresError::file(ATTEMPT, &kept)(error));
        }
        return Ok(kept);
    }
}

/// Makes a rename outlast a power cut. By now the new file is in its place, so a file system that cannot do this fails nothing.
fn sync_folder(folder: &Path) {
    if cfg!(unix) {
        drop(File::open(folder).and_then(|folder| folder.sync_all()));
    }
}
