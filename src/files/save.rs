//! The one way to save a file that several programs may change: under the lock `.<file>.lock` beside it the old bytes are read, and the new ones take
//! their place, whole, once on the disk: no change is lost. In a shared folder a file keeps its mode and group; a link stays, its target changes.

use super::storage::Manner;
use super::{Lock, PATIENCE, Symlinks, around, behind_links, is_read_only, make_folder, read_if_there, replace_with};
use crate::words::tr;
use std::path::{Path, PathBuf};
use std::{ffi::OsString, fmt, io};

/// The file on disk is as it was before.
#[derive(Debug)]
pub enum SaveError {
    ReadOnly(PathBuf),
    /// Another program holds this lock for longer than [`PATIENCE`].
    Busy(PathBuf),
    /// The file would be larger than this, bytes.
    Full(PathBuf, u64),
    /// The attempt as in "cannot …".
    File {
        attempt: &'static str,
        path: PathBuf,
        source: io::Error,
    },
}

impl SaveError {
    /// For `map_err`.
    pub fn file(attempt: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::File { attempt, path: path.to_owned(), source }
    }
}

impl fmt::Display for SaveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&match self {
            Self::ReadOnly(path) => {
                tr!("{path}: the file is read-only, expected one that may be replaced", path = path.display())
            }
            Self::Busy(path) => tr!(
                "{path}: another program is saving there and does not come to an end; nothing was saved, try again",
                path = path.display()
            ),
            Self::Full(path, most) => {
                tr!("{path}: the file is full, expected one that stays below {most} bytes", path = path.display(), most)
            }
            Self::File { attempt, path, source } => {
                tr!("{path}: cannot {attempt}: {source}", path = path.display(), attempt = tr(attempt), source)
            }
        })
    }
}

impl std::error::Error for SaveError {}

/// Changes a file, which need not exist yet: `change` gets its bytes and answers with the new ones. Equal bytes are not written.
/// Errors: the errors of `change`; see [`SaveError`].
pub fn update<T, E: From<SaveError>>(
    path: &Path,
    at_most: u64,
    change: impl FnOnce(&[u8]) -> Result<(Vec<u8>, T), E>,
) -> Result<T, E> {
    make_folder(around(path)).map_err(SaveError::file("create the folder", around(path)))?;
    let path = behind_links(path).map_err(SaveError::file("follow the link", path))?;
    let held = lock_of(&path);
    let _lock = Lock::wait(&held, PATIENCE).map_err(|error| match error.kind() {
        io::ErrorKind::WouldBlock => SaveError::Busy(held),
        _ => SaveError::file("lock the file", &held)(error),
    })?;
    let old = read_if_there(&path, at_most).map_err(SaveError::file("read the file", &path))?;
    let (new, outcome) = change(old.as_deref().unwrap_or_default())?;
    if new.len() as u64 > at_most {
        return Err(SaveError::Full(path, at_most).into());
    }
    if old.as_ref() != Some(&new) {
        write(&path, &new)?;
    }
    Ok(outcome)
}

/// Makes or replaces a file whole, for every user who may write in its folder. The caller holds a lock.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), SaveError> {
    if is_read_only(path) {
        return Err(SaveError::ReadOnly(path.to_owned()));
    }
    let manner = Manner { links: Symlinks::Followed, durable: true, shared: true };
    replace_with(path, bytes, manner).map_err(SaveError::file("write the file", path))
}

/// `1.csv` has `.1.csv.lock`.
fn lock_of(path: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(".lock");
    path.with_file_name(name)
}
