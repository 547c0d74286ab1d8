//! One file that several processes may change at once. A change holds the lock on `.<file>.lock` while it reads, makes new content
//! and replaces the file: no change is lost, and a reader finds the old file or the new one, whole. In a shared folder a file keeps
//! its mode and group; a link stays, and its target changes. A program that ends during a lock puts its rows into
//! `<file>.waiting-N`.

use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::error::ScoresError;
use crate::files::{self, Lock, Manner, Symlinks};

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
    pub bytes: String,
    /// The unreadable places of the old content, which the new one lacks.
    pub damage: Vec<String>,
    /// Files whose rows are in the new content: they go once that is on the disk.
    pub taken_up: Vec<PathBuf>,
    pub outcome: T,
}

/// A file in the folder of scores while this process holds its lock.
struct Locked {
    path: PathBuf,
    /// Whether a link leads to it.
    is_link: bool,
    _lock: Lock,
}

impl Locked {
    fn new(folder: &Path, path: PathBuf, patience: Duration) -> Result<Self, ScoresError> {
        files::make_folder(folder).map_err(ScoresError::file("create the folder", folder))?;
        let named = path;
        let path = behind_links(&named)?;
        let held = hidden(&path, "lock");
        let lock = Lock::wait(&held, patience).map_err(|error| match error.kind() {
            io::ErrorKind::WouldBlock => ScoresError::Busy(held),
            _ => ScoresError::file("lock the file", &held)(error),
        })?;
        Ok(Self { is_link: path != named, path, _lock: lock })
    }
}

/// Changes a file of that folder, which need not exist yet: `change` gets its path and content. Equal content is not written.
/// Errors: the errors of `change`; a read-only file; one that becomes too large; a lock that another process holds longer than
/// `patience`; the system's. The file is untouched then.
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
    if old.as_deref() != Some(new.as_bytes()) {
        if let Some(old) = old.filter(|_| !damage.is_empty()) {
            rescue = Some(Rescue { damage, kept: keep_beside(&path, "damaged", &old)? });
        }
        replace(&path, new.as_bytes()).inspect_err(|_| {
            // The damaged file is still in place: the copy is one too many.
            rescue.iter().for_each(|rescue| drop(files::remove(&rescue.kept)));
        })?;
    }
    // A file that stays is taken up once more, which changes nothing.
    taken_up.iter().for_each(|path| drop(files::remove(path)));
    Ok((outcome, rescue))
}

/// Writes a file in a folder below that of the scores, over one of that name, whole or not at all. The caller holds the folder's
/// lock.
/// Errors: a read-only file; the system's. The old file is untouched then.
pub(super) fn write_within(scores: &Path, folders: &[&str], file: &str, bytes: &[u8]) -> Result<PathBuf, ScoresError> {
    let mut folder = scores.to_owned();
    for name in folders {
        folder.push(name);
        files::make_shared_folder(&folder).map_err(ScoresError::file("create the folder", &folder))?;
    }
    let path = behind_links(&folder.join(file))?;
    replace(&path, bytes)?;
    Ok(path)
}

/// Adds a line at the end of a file of that folder. A file without `header` at its start is renamed to `<file>.damaged-N`, which is
/// the answer, and a fresh one begins; one behind a link is refused. It does not wait for the disk: a line is not worth a frame of the game.
pub(super) fn append(
    folder: &Path,
    path: PathBuf,
    patience: Duration,
    (header, line): (&str, &str),
) -> Result<Option<PathBuf>, ScoresError> {
    let (header, line) = (header.as_bytes(), line.as_bytes());
    let Locked { path, is_link, _lock } = Locked::new(folder, path, patience)?;
    let taken_up: Vec<(PathBuf, Vec<u8>)> = waiting(&path).into_iter().filter(|(_, bytes)| bytes.starts_with(header)).collect();
    let lines: Vec<u8> = taken_up.iter().flat_map(|(_, bytes)| &bytes[header.len()..]).chain(line).copied().collect();
    if lines.is_empty() {
        return Ok(None);
    }
    if files::is_read_only(&path) {
        return Err(ScoresError::ReadOnly(path));
    }
    let mut aside = None;
    let add = || files::append(&path, header, &lines).map_err(ScoresError::file("add a line", &path));
    if !add()? {
        if is_link {
            return Err(ScoresError::Foreign(path));
        }
        aside = Some(move_aside(&path)?);
        add()?;
    }
    // After a kill between these two the lines stand there twice; the other order could lose them.
    taken_up.iter().for_each(|(path, _)| drop(files::remove(path)));
    Ok(aside)
}

/// Puts rows beside a file whose lock another program holds. The next change of the file takes them up.
pub(super) fn put_by(folder: &Path, path: PathBuf, text: &str) -> Result<(), ScoresError> {
    files::make_folder(folder).map_err(ScoresError::file("create the folder", folder))?;
    keep_beside(&behind_links(&path)?, WAITING, text.as_bytes()).map(drop)
}

/// The files that wait beside a file, with their bytes.
pub(super) fn waiting(path: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let beginning = format!("{name}.{WAITING}-");
    let names = files::text_names(files::around(path));
    let paths: Vec<PathBuf> =
        names.iter().filter(|other| other.starts_with(&beginning)).map(|other| path.with_file_name(other)).collect();
    let read = |path: PathBuf| files::read_with(&path, files::SCORES, Symlinks::Never).ok().map(|bytes| (path, bytes));
    paths.into_iter().filter_map(read).collect()
}

fn behind_links(path: &Path) -> Result<PathBuf, ScoresError> {
    files::behind_links(path).map_err(ScoresError::file("follow the link", path))
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
    files::read_if_there(path, files::SCORES).map_err(ScoresError::file("read the scores", path))
}

/// Replaces a file of scores, or makes it for every user who may write in its folder.
fn replace(path: &Path, bytes: &[u8]) -> Result<(), ScoresError> {
    if files::is_read_only(path) {
        return Err(ScoresError::ReadOnly(path.to_owned()));
    }
    let manner = Manner { links: Symlinks::Followed, durable: true, shared: true };
    files::replace_with(path, bytes, manner).map_err(ScoresError::file("write the new scores", path))
}

/// Keeps bytes beside a file under the first free number: `1.csv` and `damaged` make `1.csv.damaged-1`.
fn keep_beside(path: &Path, ending: &str, bytes: &[u8]) -> Result<PathBuf, ScoresError> {
    files::create_numbered(&beside(path, ending), bytes)
        .map_err(ScoresError::file("write the new scores and keep the old ones", path))
}

/// Renames a file beside its own name, under the first free number.
fn move_aside(path: &Path) -> Result<PathBuf, ScoresError> {
    let mut names = (1_u64..).map(|number| beside(path, &format!("damaged-{number}")));
    let kept = names.find(|kept| !files::is_taken(kept)).unwrap_or_default();
    files::rename(path, &kept).map_err(ScoresError::file("keep the damaged file", path))?;
    Ok(kept)
}
