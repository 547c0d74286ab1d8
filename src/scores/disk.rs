//! One file that several processes may change at once: locking, reading, replacing, appending.
//!
//! A change holds the lock on `.<file>.lock` while it reads the file, makes the new content, writes `.<file>.new` and renames that over
//! the file. So no change of another process is lost, and whoever reads sees the old file or the new one, whole, whatever happens in
//! between. The system frees a lock when its process ends, however it ends. The lock file itself stays: were it deleted, two processes
//! could hold the locks of two different files of that name. Both names begin with a full stop, which keeps them out of sight.
//!
//! A folder may be shared: whoever may write in it may also lock what is in it, and a file keeps its mode and its group whoever saves.
//! Where a file is a link, the file that it leads to is changed, and everything happens beside that.

use std::cell::Cell;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::{Damage, ScoresError};
use crate::files;

/// The pause between two looks at a lock that is held. Where many processes save without end, each gets its turn by luck: with longer
/// pauses some would not get one in time.
const LOCK_PAUSE: Duration = Duration::from_millis(1);

thread_local! {
    static PAUSES: Cell<u32> = const { Cell::new(0) };
}

/// How often this thread has paused for a lock that is held, so far: a frame never does.
pub fn pauses() -> u32 {
    PAUSES.get()
}

/// How often a rename is tried. Windows refuses it while a virus scanner or a spreadsheet has the target open.
const RENAME_TRIES: u32 = if cfg!(windows) { 50 } else { 1 };
/// The pause between two tries. With fewer or shorter ones a save fails that would have succeeded.
const RENAME_PAUSE: Duration = Duration::from_millis(20);

/// How a damaged file was dealt with: its sound rows stand in the fresh file, its bytes in a copy beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rescue {
    /// The places that could not be read, in the damaged file.
    pub damage: Vec<Damage>,
    /// Where the damaged file is kept, byte for byte.
    pub kept: PathBuf,
}

/// What a file becomes.
pub(super) struct Change<T> {
    /// All of its new content.
    pub bytes: Vec<u8>,
    /// The places of the old content that could not be read, and are not in the new one.
    pub damage: Vec<Damage>,
    /// What whoever asked for it wants to know.
    pub outcome: T,
}

/// A file in the folder of scores, for as long as its lock is held.
struct Locked {
    path: PathBuf,
    folder: PathBuf,
    _lock: File,
}

impl Locked {
    fn new(folder: &Path, path: PathBuf, patience: Duration) -> Result<Self, ScoresError> {
        fs::create_dir_all(folder).map_err(ScoresError::file("create the scores folder", folder))?;
        let path = behind_links(path)?;
        let folder = path.parent().unwrap_or(folder).to_path_buf();
        let lock = lock(&folder, &hidden(&path, "lock"), patience)?;
        Ok(Self { path, folder, _lock: lock })
    }
}

/// Changes a file of that folder, which need not exist yet: `change` is given its path and its content. Where that changes nothing, nothing
/// is written.
///
/// # Errors
/// Those of `change`; a read-only file; one that would become too large; a lock that is held for longer than `patience`; whatever the
/// system refuses. The file is untouched then.
pub(super) fn update<T>(
    folder: &Path,
    path: PathBuf,
    patience: Duration,
    change: impl FnOnce(&Path, &[u8]) -> Result<Change<T>, ScoresError>,
) -> Result<(T, Option<Rescue>), ScoresError> {
    let Locked { path, folder, _lock } = Locked::new(folder, path, patience)?;
    let old = read_if_there(&path)?;
    let Change { bytes: new, damage, outcome } = change(&path, old.as_deref().unwrap_or_default())?;
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
        sync_folder(&folder);
    }
    Ok((outcome, rescue))
}

/// Writes a file of a folder within that of the scores, whole or not at all; there may be one of that name already. Whoever calls holds a
/// lock that nobody writes there without.
///
/// # Errors
/// A read-only file; whatever the system refuses. What was there is untouched then.
pub(super) fn write_within(scores: &Path, folders: &[&str], file: &str, bytes: &[u8]) -> Result<PathBuf, ScoresError> {
    let mut folder = scores.to_owned();
    for name in folders {
        folder.push(name);
        make_folder(&folder).map_err(ScoresError::file("create the folder", &folder))?;
    }
    let path = behind_links(folder.join(file))?;
    Staged::write(&path, bytes)?.replace(&path)?;
    sync_folder(&folder);
    Ok(path)
}

/// Makes a folder where there is none, for all who may write in the one around it.
pub(super) fn make_folder(folder: &Path) -> io::Result<()> {
    match fs::create_dir(folder) {
        Ok(()) => {
            if let Some(around) = folder.parent() {
                // Where that is not allowed, it is whoever made the folder that can write in it.
                let _ = fs::metadata(around).and_then(|around| fs::set_permissions(folder, around.permissions()));
            }
            Ok(())
        }
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists && folder.is_dir() => Ok(()),
        Err(error) => Err(error),
    }
}

/// Adds a line at the end of a file of that folder. A file that does not begin with `header` is renamed to `<file>.damaged-N` first, and
/// a fresh one begins with it; the old one's new path is the answer. The system writes it to disk when it likes: a line is not worth a
/// frame of the game.
///
/// # Errors
/// As [`update`]; the file is as it was then.
pub(super) fn append(
    folder: &Path,
    path: PathBuf,
    patience: Duration,
    (header, line): (&[u8], &[u8]),
) -> Result<Option<PathBuf>, ScoresError> {
    const ATTEMPT: &str = "add a line";
    let Locked { path, folder, _lock } = Locked::new(folder, path, patience)?;
    let found = fs::metadata(&path).ok();
    if let Some(found) = &found {
        if !found.is_file() {
            let other = io::Error::new(io::ErrorKind::InvalidInput, "found something else, expected a regular file");
            return Err(ScoresError::file(ATTEMPT, &path)(other));
        }
        if found.permissions().readonly() {
            return Err(ScoresError::ReadOnly(path));
        }
    }
    let mut aside = None;
    let mut file = open_for_lines(&path).map_err(ScoresError::file(ATTEMPT, &path))?;
    if !begins_with(&mut file, header).map_err(ScoresError::file(ATTEMPT, &path))? {
        drop(file);
        aside = Some(move_aside(&path)?);
        file = open_for_lines(&path).map_err(ScoresError::file(ATTEMPT, &path))?;
    }
    add(&mut file, header, line).map_err(ScoresError::file(ATTEMPT, &path))?;
    if found.is_none() {
        share(&folder, &file, false).map_err(ScoresError::file(ATTEMPT, &path))?;
    }
    Ok(aside)
}

fn open_for_lines(path: &Path) -> io::Result<File> {
    OpenOptions::new().read(true).append(true).create(true).open(path)
}

/// Whether a file is empty or begins with that line, as editors leave it: with a byte-order mark, or with another line end.
fn begins_with(file: &mut File, header: &[u8]) -> io::Result<bool> {
    let mut first = Vec::new();
    file.take(header.len() as u64 + 3).read_to_end(&mut first)?;
    let first = first.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&first);
    Ok(first.is_empty() || first.starts_with(header.trim_ascii_end()))
}

/// Writes the line, behind the header where there is nothing yet and on a line of its own whatever an editor left; or nothing at all.
fn add(file: &mut File, header: &[u8], line: &[u8]) -> io::Result<()> {
    let length = file.metadata()?.len();
    let mut bytes = Vec::new();
    if length == 0 {
        bytes.extend_from_slice(header);
    } else {
        let mut last = [0];
        file.seek(SeekFrom::End(-1))?;
        file.read_exact(&mut last)?;
        if last != [b'\n'] {
            bytes.extend_from_slice(b"\r\n");
        }
    }
    bytes.extend_from_slice(line);
    file.write_all(&bytes).inspect_err(|_| {
        // What was written before the disk was full. Should this fail, the next line stands on its own all the same.
        let _ = file.set_len(length);
    })?;
    // A line that was told as written outlasts a power cut.
    file.sync_data()
}

/// The file that a path means: the one that its links lead to.
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

pub(super) fn read_if_there(path: &Path) -> Result<Option<Vec<u8>>, ScoresError> {
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
            Err(TryLockError::WouldBlock) if begun.elapsed() < patience => {
                PAUSES.set(PAUSES.get().wrapping_add(1));
                std::thread::sleep(LOCK_PAUSE);
            }
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

/// Gives a file another name beside its own, under the first number that is free.
fn move_aside(path: &Path) -> Result<PathBuf, ScoresError> {
    let mut number = 0_u64;
    let kept = loop {
        number += 1;
        let kept = beside(path, &format!("damaged-{number}"));
        if fs::symlink_metadata(&kept).is_err() {
            break kept;
        }
    };
    fs::rename(path, &kept).map_err(ScoresError::file("keep the damaged file", path))?;
    Ok(kept)
}

/// Makes a rename outlast a power cut. By now the new file is in its place, so a file system that cannot do this fails nothing.
fn sync_folder(folder: &Path) {
    if cfg!(unix) {
        drop(File::open(folder).and_then(|folder| folder.sync_all()));
    }
}
