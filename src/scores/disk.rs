//! One file that several processes may change at once. A change holds the lock on `.<file>.lock` while it reads, makes new content
//! and replaces the file: no change is lost, and a reader finds the old file or the new one, whole. In a shared folder a file keeps
//! its mode and group; a link stays, and its target changes. A program that ends during a lock puts its rows into
//! `<file>.waiting-N`.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::error::ScoresError;
use crate::files::{self, Lock, Replacement, Symlinks, share, sync_folder};

const WAITING: &str = "waiting";

/// The rescue of a damaged file: the sound rows stand in the fresh file, all bytes in a copy beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rescue {
    /// The unreadable places of the damaged file.
    pub damage: Vec<String>,
    /// The copy, byte for byte.
    pub kept: PathBuf,
}

pub(super) struct ScoresChange<T> {
    /// The whole file.
    pub bytes: Vec<u8>,
    /// The unreadable places of the old content, which the new one lacks.
    pub damage: Vec<String>,
    /// Files whose rows are in the new content: they go once that is on the disk.
    pub taken_up: Vec<PathBuf>,
    pub outcome: T,
}

/// A file in the folder of scores while this process holds its lock.
struct Locked {
    path: PathBuf,
    folder: PathBuf,
    _lock: Lock,
}

impl Locked {
    fn new(folder: &Path, path: PathBuf, patience: Duration) -> Result<Self, ScoresError> {
        fs::create_dir_all(folder).map_err(ScoresError::file("create the scores folder", folder))?;
        let path = behind_links(&path)?;
        let folder = path.parent().unwrap_or(folder).to_path_buf();
        let held = hidden(&path, "lock");
        let lock = Lock::wait(&held, patience).map_err(|error| match error.kind() {
            io::ErrorKind::WouldBlock => ScoresError::Busy(held),
            _ => ScoresError::file("lock the scores", &held)(error),
        })?;
        Ok(Self { path, folder, _lock: lock })
    }
}

/// Changes a file of that folder, which need not exist yet: `change` gets its path and content. Equal content is not written.
///
/// # Errors
/// The errors of `change`; a read-only file; one that becomes too large; a lock that another process holds longer than `patience`;
/// the system's. The file is untouched then.
pub(super) fn update<T>(
    folder: &Path,
    path: PathBuf,
    patience: Duration,
    change: impl FnOnce(&Path, &[u8]) -> Result<ScoresChange<T>, ScoresError>,
) -> Result<(T, Option<Rescue>), ScoresError> {
    let Locked { path, _lock, .. } = Locked::new(folder, path, patience)?;
    let old = read_if_there(&path)?;
    let ScoresChange { bytes: new, damage, taken_up, outcome } = change(&path, old.as_deref().unwrap_or_default())?;
    if new.len() as u64 > files::SCORES {
        return Err(ScoresError::Full(path));
    }
    let mut rescue = None;
    if old.as_ref() != Some(&new) {
        let staged = stage(&path, &new)?;
        if let Some(old) = old.filter(|_| !damage.is_empty()) {
            rescue = Some(Rescue { damage, kept: keep_beside(&path, "damaged", &old)? });
        }
        staged.finish().map_err(ScoresError::file("replace the scores", &path)).inspect_err(|_| {
            // The damaged file is still in place: the copy is one too many.
            rescue.iter().for_each(|rescue| drop(fs::remove_file(&rescue.kept)));
        })?;
    }
    // A file that stays is taken up once more, which changes nothing.
    taken_up.iter().for_each(|path| drop(fs::remove_file(path)));
    Ok((outcome, rescue))
}

/// Writes a file in a folder below that of the scores, over one of that name, whole or not at all. The caller holds the folder's
/// lock.
///
/// # Errors
/// A read-only file; the system's. The old file is untouched then.
pub(super) fn write_within(scores: &Path, folders: &[&str], file: &str, bytes: &[u8]) -> Result<PathBuf, ScoresError> {
    let mut folder = scores.to_owned();
    for name in folders {
        folder.push(name);
        make_folder(&folder).map_err(ScoresError::file("create the folder", &folder))?;
    }
    let path = behind_links(&folder.join(file))?;
    stage(&path, bytes)?.finish().map_err(ScoresError::file("replace the scores", &path))?;
    Ok(path)
}

/// Makes a folder, if there is none, for each user who may write in the one around it.
pub(super) fn make_folder(folder: &Path) -> io::Result<()> {
    match fs::create_dir(folder) {
        Ok(()) => {
            if let Some(around) = folder.parent() {
                // Where that is refused, only its maker can write in the folder.
                let _ = fs::metadata(around).and_then(|around| fs::set_permissions(folder, around.permissions()));
            }
            Ok(())
        }
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists && folder.is_dir() => Ok(()),
        Err(error) => Err(error),
    }
}

/// Adds a line at the end of a file of that folder. A file without `header` at its start is renamed to `<file>.damaged-N`, which is
/// the answer, and a fresh one begins. It does not wait for the disk: a line is not worth a frame of the game.
///
/// # Errors
/// As [`update`].
pub(super) fn append(
    folder: &Path,
    path: PathBuf,
    patience: Duration,
    (header, line): (&[u8], &[u8]),
) -> Result<Option<PathBuf>, ScoresError> {
    const ATTEMPT: &str = "add a line";
    let Locked { path, folder, _lock } = Locked::new(folder, path, patience)?;
    let taken_up: Vec<(PathBuf, Vec<u8>)> = waiting(&path).into_iter().filter(|(_, bytes)| bytes.starts_with(header)).collect();
    let lines: Vec<u8> = taken_up.iter().flat_map(|(_, bytes)| &bytes[header.len()..]).chain(line).copied().collect();
    if lines.is_empty() {
        return Ok(None);
    }
    let is_new = fs::symlink_metadata(&path).is_err();
    if fs::metadata(&path).is_ok_and(|found| found.is_file() && found.permissions().readonly()) {
        return Err(ScoresError::ReadOnly(path));
    }
    let mut aside = None;
    let mut file = open_for_lines(&path).map_err(ScoresError::file(ATTEMPT, &path))?;
    if !begins_with(&mut file, header).map_err(ScoresError::file(ATTEMPT, &path))? {
        drop(file);
        aside = Some(move_aside(&path)?);
        file = open_for_lines(&path).map_err(ScoresError::file(ATTEMPT, &path))?;
    }
    add(&mut file, header, &lines).map_err(ScoresError::file(ATTEMPT, &path))?;
    // After a kill between these two the lines stand there twice; the other order could lose them.
    taken_up.iter().for_each(|(path, _)| drop(fs::remove_file(path)));
    if is_new {
        share(&folder, &file, false).map_err(ScoresError::file(ATTEMPT, &path))?;
        sync_folder(&folder);
    }
    Ok(aside)
}

fn open_for_lines(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).append(true);
    match files::open(&options, path, Symlinks::Followed) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => options.create_new(true).open(path),
        opened => opened.map(|(file, _)| file),
    }
}

/// Puts rows beside a file whose lock another program holds. The next change of the file takes them up.
pub(super) fn put_by(folder: &Path, path: PathBuf, bytes: &[u8]) -> Result<(), ScoresError> {
    fs::create_dir_all(folder).map_err(ScoresError::file("create the scores folder", folder))?;
    keep_beside(&behind_links(&path)?, WAITING, bytes).map(drop)
}

/// The files that wait beside a file, with their bytes.
pub(super) fn waiting(path: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let beginning = format!("{name}.{WAITING}-");
    let entries = path.parent().and_then(|folder| fs::read_dir(folder).ok()).into_iter().flatten().flatten();
    let named = entries.filter(|entry| entry.file_name().to_string_lossy().starts_with(&beginning));
    let mut paths: Vec<PathBuf> = named.map(|entry| entry.path()).collect();
    paths.sort();
    let read = |path: PathBuf| files::read_with(&path, files::SCORES, Symlinks::Never).ok().map(|bytes| (path, bytes));
    paths.into_iter().filter_map(read).collect()
}

/// Whether a file is empty or begins with that line, also with a byte-order mark or another line end from an editor.
fn begins_with(file: &mut File, header: &[u8]) -> io::Result<bool> {
    let mut first = Vec::new();
    file.take(header.len() as u64 + 3).read_to_end(&mut first)?;
    let first = first.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&first);
    Ok(first.is_empty() || first.starts_with(header.trim_ascii_end()))
}

/// Writes the line: behind the header in an empty file, on a line of its own after any editor; or nothing at all.
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
        // Cuts the bytes of a full disk off. If that fails, the next line still stands on its own.
        let _ = file.set_len(length);
    })?;
    // A line that is reported as written outlasts a power cut.
    file.sync_data()
}

fn behind_links(path: &Path) -> Result<PathBuf, ScoresError> {
    files::behind_links(path).map_err(ScoresError::file("follow the link to the scores", path))
}

/// `1.csv` and `damaged-1` make `1.csv.damaged-1`. No level's own file ends like that.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    PathBuf::from(name)
}

/// `1.csv` and `lock` make `.1.csv.lock`.
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

/// New content, complete and on disk under another name.
fn stage(path: &Path, bytes: &[u8]) -> Result<Replacement, ScoresError> {
    if fs::metadata(path).is_ok_and(|found| found.is_file() && found.permissions().readonly()) {
        return Err(ScoresError::ReadOnly(path.to_owned()));
    }
    let written = Replacement::begin(path, Symlinks::Followed).and_then(|mut staged| {
        staged.file().write_all(bytes)?;
        if staged.is_new() {
            share(path.parent().unwrap_or(path), staged.file(), false)?;
        }
        staged.seal()?;
        Ok(staged)
    });
    written.map_err(ScoresError::file("write the new scores", path))
}

/// Keeps bytes beside a file under the first free number: `1.csv` and `damaged` make `1.csv.damaged-1`.
fn keep_beside(path: &Path, ending: &str, bytes: &[u8]) -> Result<PathBuf, ScoresError> {
    let mut number = 0_u64;
    loop {
        number += 1;
        let kept = beside(path, &format!("{ending}-{number}"));
        match files::create(&kept, bytes) {
            Ok(()) => return Ok(kept),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(ScoresError::file("keep a copy", &kept)(error)),
        }
    }
}

/// Renames a file beside its own name, under the first free number.
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
