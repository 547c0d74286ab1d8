//! Files of this program's home, by free functions.

use super::storage::{FileKind, Found, Lock, Manner, Storage};
use super::{cells::CellFault, dialect::Encoding, read::Symlinks};
use crate::words::tr;
use std::path::{Path, PathBuf};
use std::{ffi::OsString, io, time::Duration};

const MOST_OF_A_NAME: u32 = 10_000;

#[cfg(not(all(browser, feature = "window")))]
fn home() -> &'static dyn Storage {
    super::shipped::desktop()
}

#[cfg(all(browser, feature = "window"))]
fn home() -> &'static dyn Storage {
    crate::web::storage()
}

pub fn look(path: &Path) -> io::Result<Found> {
    home().look(path, Symlinks::Followed)
}

pub fn is_folder(path: &Path) -> bool {
    look(path).is_ok_and(|found| found.kind == FileKind::Folder)
}

pub fn is_file(path: &Path) -> bool {
    look(path).is_ok_and(|found| found.kind == FileKind::File)
}

pub fn is_read_only(path: &Path) -> bool {
    look(path).is_ok_and(|found| found.kind == FileKind::File && found.read_only)
}

/// Whether that is a link, whatever it leads to.
pub fn is_link(path: &Path) -> bool {
    home().look(path, Symlinks::Never).is_ok_and(|found| found.kind == FileKind::Link)
}

/// Whether anything has that name, if only a link that leads nowhere.
pub fn is_taken(path: &Path) -> bool {
    home().look(path, Symlinks::Never).is_ok()
}

pub fn names(folder: &Path) -> io::Result<Vec<OsString>> {
    home().names(folder)
}

/// The names that are text, in order; none in a folder that cannot be read.
pub fn text_names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = names(folder).into_iter().flatten().filter_map(|name| name.into_string().ok()).collect();
    names.sort_unstable();
    names
}

pub fn resolve(path: &Path) -> io::Result<PathBuf> {
    home().resolve(path)
}

/// At most `at_most` bytes. A file that the program was handed open (`/dev/stdin`, `/dev/fd/3`) may be of any kind. Errors: as [`Storage::read`].
pub fn read(path: &Path, at_most: u64) -> io::Result<Vec<u8>> {
    read_with(path, at_most, Symlinks::Followed)
}

pub fn read_with(path: &Path, at_most: u64, links: Symlinks) -> io::Result<Vec<u8>> {
    home().read(path, at_most, links)
}

/// As [`read`] and [`text()`].
pub fn read_text(path: &Path, at_most: u64) -> io::Result<String> {
    text(&read(path, at_most)?)
}

/// Bytes as text; a byte-order mark tells UTF-16. Bytes that are no text are an error.
pub fn text(bytes: &[u8]) -> io::Result<String> {
    Encoding::text(bytes).map_err(|line| {
        let (found, expected) = CellFault::NotUtf8.words();
        let problem = tr!("found {found} in line {line}, expected {expected}", found, line, expected);
        io::Error::new(io::ErrorKind::InvalidData, problem)
    })
}

fn if_there<T>(read: io::Result<T>) -> io::Result<Option<T>> {
    match read {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        read => read.map(Some),
    }
}

/// As [`read`]; `None` where there is no such file.
pub fn read_if_there(path: &Path, at_most: u64) -> io::Result<Option<Vec<u8>>> {
    if_there(read(path, at_most))
}

/// As [`read_text`]; `None` where there is no such file.
pub fn text_if_there(path: &Path, at_most: u64) -> io::Result<Option<String>> {
    if_there(read_text(path, at_most))
}

/// Replaces a file's content, durable when this returns. The file keeps its mode, and after an error its content.
pub fn replace(path: &Path, bytes: &[u8], links: Symlinks) -> io::Result<()> {
    replace_with(path, bytes, Manner { links, durable: true, shared: false })
}

pub fn replace_with(path: &Path, bytes: &[u8], manner: Manner) -> io::Result<()> {
    home().replace(path, bytes, manner)
}

pub fn create(path: &Path, bytes: &[u8]) -> io::Result<()> {
    home().create(path, bytes)
}

/// Makes a file under the first free one of the names `path-1`, `path-2` …
pub fn create_numbered(path: &Path, bytes: &[u8]) -> io::Result<PathBuf> {
    for number in 1..=MOST_OF_A_NAME {
        let mut name = path.as_os_str().to_owned();
        name.push(format!("-{number}"));
        match create(Path::new(&name), bytes) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            made => return made.map(|()| name.into()),
        }
    }
    Err(io::ErrorKind::AlreadyExists.into())
}

pub fn make_folder(path: &Path) -> io::Result<()> {
    home().make_folder(path)
}

pub fn make_shared_folder(path: &Path) -> io::Result<()> {
    home().make_shared_folder(path)
}

/// As [`Storage::create_folder`]. Errors: [`io::ErrorKind::AlreadyExists`]; the errors of `fill`; the home's. Nothing is left behind then.
pub fn create_folder(path: &Path, fill: impl FnOnce(&Path) -> io::Result<()>) -> io::Result<()> {
    let mut fill = Some(fill);
    home().create_folder(path, &mut |begun| fill.take().map_or(Ok(()), |fill| fill(begun)))
}

/// Copies a regular file into a folder that is being filled.
pub fn copy(from: &Path, to: &Path) -> io::Result<()> {
    put(to, &read(from, u64::MAX - 1)?)
}

/// Writes a new file of a folder that is being filled, and the folders between the two.
pub fn put(path: &Path, bytes: &[u8]) -> io::Result<()> {
    make_folder(super::around(path))?;
    home().put(path, bytes)
}

pub fn remove(path: &Path) -> io::Result<()> {
    home().remove(path)
}

pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    home().rename(from, to)
}

impl Lock {
    /// Locks a file, and makes it where there is none, for every user who may write in its folder. Errors: [`io::ErrorKind::WouldBlock`] where
    /// another program holds it for longer than `patience`; no regular file; the home's.
    pub fn wait(path: &Path, patience: Duration) -> io::Result<Self> {
        home().lock(path, patience)
    }
}
