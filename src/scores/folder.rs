//! The folder that holds the scores files, one a level: reading, locking and replacing them.
//!
//! A save holds the lock on `<level>.csv.lock` while it reads the file, adds the score, writes `<level>.csv.new` and renames that
//! over the file. So no save of another process is lost, and whoever reads sees the old file or the new one, whole, whatever
//! happens in between. The system frees a lock when its process ends, however it ends. The lock file itself stays: were it
//! deleted, two processes could hold the locks of two different files of that name.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::{Board, Damage, Name, Placement, ScoresError, table};

/// How often a rename is tried. Windows refuses it while a virus scanner or a spreadsheet has the target open.
const RENAME_TRIES: u32 = if cfg!(windows) { 50 } else { 1 };
/// The pause between two tries. With fewer or shorter ones a save fails that would have succeeded.
const RENAME_PAUSE: std::time::Duration = std::time::Duration::from_millis(20);

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
    /// Waits while another process saves there. A damaged file is kept aside as `<level>.csv.damaged-N` before it is replaced.
    ///
    /// # Errors
    /// A score below 1; a level name that cannot name a file; a read-only file; whatever the system refuses. The old file is
    /// untouched then.
    pub fn save(&self, level: &str, name: &Name, score: i64) -> Result<Saved, ScoresError> {
        let path = self.path(level)?;
        if score < 1 {
            return Err(ScoresError::NoScore);
        }
        fs::create_dir_all(&self.folder).map_err(ScoresError::file("create the scores folder", &self.folder))?;
        let _lock = lock(&beside(&path, "lock"))?;

        let old = read_if_there(&path)?;
        let (mut board, damage) = table::read(&path, old.as_deref().unwrap_or_default());
        let placement = board.place(name, score)?;
        let new = table::write(&board).map_err(ScoresError::file("write the new scores", &path))?;

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
            sync_folder(&self.folder);
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

/// The path of a companion of a scores file: `1.csv` and `lock` make `1.csv.lock`. No level's own file ends like that.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    PathBuf::from(name)
}

fn read_if_there(path: &Path) -> Result<Option<Vec<u8>>, ScoresError> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(ScoresError::file("read the scores", path)(error)),
    }
}

/// Waits for the lock; it lasts until the returned file is dropped.
fn lock(path: &Path) -> Result<File, ScoresError> {
    let file = OpenOptions::new().create(true).truncate(false).write(true).open(path);
    let file = file.map_err(ScoresError::file("open the lock file", path))?;
    file.lock().map_err(ScoresError::file("lock the scores", path))?;
    Ok(file)
}

/// The new content of a scores file, complete and on disk under a name of its own; gone with this value unless it took the file's
/// place. The lock makes the fixed name safe; what a killed process left there is written over.
struct Staged {
    path: PathBuf,
}

impl Staged {
    fn write(target: &Path, bytes: &[u8]) -> Result<Self, ScoresError> {
        let permissions = fs::metadata(target).ok().map(|metadata| metadata.permissions());
        if permissions.as_ref().is_some_and(fs::Permissions::readonly) {
            return Err(ScoresError::ReadOnly(target.to_owned()));
        }
        let path = beside(target, "new");
        let mut file = File::create(&path).map_err(ScoresError::file("write the new scores", &path))?;
        let staged = Self { path };
        let written = file.write_all(bytes).and_then(|()| file.sync_all()).and_then(|()| match permissions {
            Some(permissions) if file.metadata()?.permissions() != permissions => file.set_permissions(permissions),
            _ => Ok(()),
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
