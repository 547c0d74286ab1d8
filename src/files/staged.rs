//! Files and folders made whole or not at all: content is staged beside its target under a hidden random name, and renamed once it is on the disk.
//! A staged file is created exclusively, so that no link is followed, and locked: the next write removes one without a lock, of a killed process.

use super::read::{Symlinks, judge, open};
use crate::words::tr;
use std::fs::{self, File, Metadata, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;
use tempfile::{Builder, NamedTempFile};

/// A staged name has random letters between these two.
const PREFIX: &str = ".resultant-";
const SUFFIX: &str = ".new";
const LETTERS: usize = 8;
/// Tries for a name while other processes sweep the folder. Each fails only where a sweep falls between two system calls.
const MOST_SWEPT: usize = 20;

/// Windows refuses a rename while a virus scanner or a spreadsheet has the target open.
const RENAME_TRIES: u32 = if cfg!(windows) { 50 } else { 1 };
/// With fewer or shorter pauses a save fails that would have succeeded.
const RENAME_PAUSE: Duration = Duration::from_millis(20);

/// New content of a file. It is dropped with this value unless [`Replacement::finish`] puts it in place.
#[derive(Debug)]
pub struct Replacement {
    staged: NamedTempFile,
    target: PathBuf,
    found: Option<Metadata>,
    sealed: bool,
}

impl Replacement {
    /// Begins new content for `path`, which need not exist yet. Errors: a read-only file; no regular file; a link without a target; the system's.
    pub fn begin(path: &Path, links: Symlinks) -> io::Result<Self> {
        let (target, found) = target(path, links)?;
        // Other users cannot read the new content before it has the old file's mode.
        let staged = stage(around(&target), if found.is_some() { 0o600 } else { 0o666 })?;
        Ok(Self { staged, target, found, sealed: false })
    }

    pub fn is_new(&self) -> bool {
        self.found.is_none()
    }

    pub fn file(&mut self) -> &mut File {
        self.staged.as_file_mut()
    }

    /// Waits for the disk, so that the content outlasts a power cut.
    pub fn seal(&mut self) -> io::Result<()> {
        self.inherit()?;
        self.sealed = true;
        self.staged.as_file().sync_all()
    }

    /// Gives the staged file the old file's mode and, as far as that is allowed, its owner and group.
    fn inherit(&self) -> io::Result<()> {
        let Some(found) = &self.found else { return Ok(()) };
        let file = self.staged.as_file();
        keep_owner(file, found);
        if file.metadata()?.permissions() == found.permissions() { Ok(()) } else { file.set_permissions(found.permissions()) }
    }

    /// After an error the old file is in its place.
    pub fn finish(self) -> io::Result<()> {
        if !self.sealed {
            self.inherit()?;
        }
        let Self { mut staged, target, sealed, .. } = self;
        if cfg!(windows) {
            // In its new place the lock would keep readers out. Should this fail, it lasts a moment longer.
            let _ = staged.as_file().unlock();
        }
        let mut tries = 1;
        while let Err(refused) = staged.persist(&target) {
            if refused.error.kind() != io::ErrorKind::PermissionDenied || tries >= RENAME_TRIES {
                return Err(refused.error);
            }
            staged = refused.file;
            std::thread::sleep(RENAME_PAUSE);
            tries += 1;
        }
        if sealed {
            sync_folder(around(&target));
        }
        Ok(())
    }
}

impl Write for Replacement {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.staged.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.staged.flush()
    }
}

/// As [`Storage::create`](super::Storage::create), on the disk when this returns.
pub(super) fn create(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if fs::symlink_metadata(path).is_ok() {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    let mut staged = stage(around(path), 0o666)?;
    staged.write_all(bytes)?;
    staged.as_file().sync_all()?;
    staged.persist_noclobber(path).map_err(|taken| taken.error)?;
    sync_folder(around(path));
    Ok(())
}

/// `fill` fills it under another name. Errors: [`io::ErrorKind::AlreadyExists`]; the errors of `fill`; the system's. Nothing is left behind then.
pub(super) fn create_folder(path: &Path, fill: &mut dyn FnMut(&Path) -> io::Result<()>) -> io::Result<()> {
    // A rename would take the place of an empty folder.
    if fs::symlink_metadata(path).is_ok() {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    let around = around(path);
    fs::create_dir_all(around)?;
    sweep(around);
    let begun = (0..MOST_SWEPT).find_map(|_| match builder(0o777).tempdir_in(around) {
        // A folder that cannot be opened cannot be locked, and no sweep removes it.
        Ok(begun) => match open_folder(begun.path()) {
            Ok(lock) => holds(&lock, begun.path()).then_some(Ok((begun, Some(lock)))),
            Err(_) => Some(Ok((begun, None))),
        },
        Err(error) => Some(Err(error)),
    });
    let (begun, _lock) = begun.unwrap_or_else(|| Err(io::ErrorKind::ResourceBusy.into()))?;
    fill(begun.path())?;
    sync_below(begun.path())?;
    fs::rename(begun.path(), path)?;
    // Nothing is left to remove.
    drop(begun.keep());
    sync_folder(around);
    Ok(())
}

/// Makes all below a folder outlast a power cut. One call for the whole file system waits for the disk once, not once a file, and reports failures.
#[cfg(target_os = "linux")]
fn sync_below(folder: &Path) -> io::Result<()> {
    Ok(rustix::fs::syncfs(File::open(folder)?)?)
}

#[cfg(not(target_os = "linux"))]
fn sync_below(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            sync_below(&path)?;
        } else {
            // Windows flushes only what may be written.
            OpenOptions::new().read(true).write(cfg!(windows)).open(&path)?.sync_all()?;
        }
    }
    sync_folder(folder);
    Ok(())
}

/// Makes a new name outlast a power cut. The file is in its place by then: a file system without this fails nothing.
pub fn sync_folder(folder: &Path) {
    let _ = open_folder(folder).and_then(|folder| folder.sync_all());
}

/// Opens only a folder, where the system can.
fn open_folder(folder: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(libc::O_DIRECTORY);
    }
    options.read(true).open(folder)
}

pub fn around(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// The file at the end of a path's links. A link without a target is an error.
pub fn behind_links(path: &Path) -> io::Result<PathBuf> {
    if !fs::symlink_metadata(path).is_ok_and(|found| found.is_symlink()) {
        return Ok(path.to_path_buf());
    }
    path.canonicalize().map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => io::Error::new(io::ErrorKind::NotFound, tr("a link that leads to no file")),
        _ => error,
    })
}

/// The file whose place new content for `path` takes, and the old file there. Errors: as [`Replacement::begin`].
fn target(path: &Path, links: Symlinks) -> io::Result<(PathBuf, Option<Metadata>)> {
    let target = if links == Symlinks::Followed { behind_links(path)? } else { path.to_path_buf() };
    let found = match fs::symlink_metadata(&target) {
        // A pipe or link in that place is replaced, too: a rename does not open it.
        Ok(found) if links == Symlinks::Never && !found.is_file() => None,
        Ok(found) => Some(found),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    if let Some(found) = &found {
        judge(found)?;
        // An administrator could replace read-only files, too.
        if found.permissions().readonly() {
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, tr("the file is read-only")));
        }
    }
    Ok((target, found))
}

/// An empty, locked file.
fn stage(folder: &Path, mode: u32) -> io::Result<NamedTempFile> {
    sweep(folder);
    let held = |staged: &io::Result<NamedTempFile>| staged.as_ref().map_or(true, |staged| holds(staged.as_file(), staged.path()));
    let staged = (0..MOST_SWEPT).map(|_| builder(mode).tempfile_in(folder)).find(held);
    staged.unwrap_or_else(|| Err(io::ErrorKind::ResourceBusy.into()))
}

/// Names for staged files. A file or folder of that mode is open to others as far as the umask says.
fn builder(mode: u32) -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX).rand_bytes(LETTERS);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(mode));
    }
    #[cfg(not(unix))]
    let _ = mode;
    builder
}

/// Locks a staged file. `false` where a sweep came between and holds the lock or has removed the path. A file system without locks has no sweeps.
fn holds(staged: &File, path: &Path) -> bool {
    !matches!(staged.try_lock(), Err(TryLockError::WouldBlock)) && fs::symlink_metadata(path).is_ok()
}

/// Removes the staged files of killed processes. A file that cannot be removed stays.
fn sweep(folder: &Path) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for path in entries.filter(|entry| is_staged(&entry.file_name().to_string_lossy())).map(|entry| entry.path()) {
        let Ok(found) = fs::symlink_metadata(&path) else { continue };
        let opened = if found.is_dir() {
            open_folder(&path)
        } else {
            open(OpenOptions::new().read(true), &path, Symlinks::Never).map(|(file, _)| file)
        };
        let Ok(left) = opened else { continue };
        if left.try_lock().is_ok() {
            let _ = if found.is_dir() { fs::remove_dir_all(&path) } else { fs::remove_file(&path) };
        }
    }
}

fn is_staged(name: &str) -> bool {
    let letters = name.strip_prefix(PREFIX).and_then(|rest| rest.strip_suffix(SUFFIX));
    letters.is_some_and(|letters| letters.len() == LETTERS && letters.bytes().all(|byte| byte.is_ascii_alphanumeric()))
}

/// Gives a file the old file's owner and group, or the group alone, as far as that is allowed, so that the same users share both.
#[cfg(unix)]
fn keep_owner(file: &File, old: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    let same = |own: Metadata| (own.uid(), own.gid()) == (old.uid(), old.gid());
    if !file.metadata().is_ok_and(same) && fchown(file, Some(old.uid()), Some(old.gid())).is_err() {
        // Users may share a folder by other means than a group.
        let _ = fchown(file, None, Some(old.gid()));
    }
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) {}

#[cfg(test)]
mod tests {
    use super::super::{create, create_folder, put, replace};
    use super::{Replacement, Symlinks};
    use std::fs;
    use std::io::{self, Write};
    use std::path::Path;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> =
            fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn what_a_killed_process_left_staged_goes_and_what_is_in_use_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let mut used = Replacement::begin(&path("a"), Symlinks::Followed).unwrap();
        used.file().write_all(b"used").unwrap();
        fs::write(path(".resultant-aB3dE6gH.new"), "half").unwrap();
        fs::create_dir(path(".resultant-12345678.new")).unwrap();
        fs::write(path(".resultant-12345678.new/world.csv"), "half").unwrap();
        let others = [".resultant-aB3dE6g.new", ".resultant-aB3dE6gH.new2", ".resultant-../dE6g.new", "resultant-aB3dE6gH.new"];
        others.iter().filter(|name| !name.contains('/')).for_each(|name| fs::write(path(name), "kept").unwrap());
        replace(&path("b"), b"new", Symlinks::Followed).unwrap();
        let left = names(folder.path());
        assert!(
            !left.iter().any(|name| name.contains("aB3dE6gH.new") && name.len() == 23 || name.contains("12345678")),
            "{left:?}"
        );
        assert_eq!(left.len(), 3 + 2, "{left:?}");
        used.finish().unwrap();
        assert_eq!((fs::read(path("a")).unwrap(), fs::read(path("b")).unwrap()), (b"used".to_vec(), b"new".to_vec()));
    }

    #[test]
    fn a_folder_is_made_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("around/level");
        let failed = create_folder(&path, |begun| put(&begun.join("a"), b"1").and(Err(io::ErrorKind::StorageFull.into())));
        assert_eq!(failed.unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert_eq!(names(&folder.path().join("around")), [""; 0]);
        create_folder(&path, |begun| put(&begun.join("a"), b"1")).unwrap();
        assert_eq!((names(&folder.path().join("around")), names(&path)), (vec!["level".to_owned()], vec!["a".to_owned()]));
        assert_eq!(create_folder(&path, |_| Ok(())).unwrap_err().kind(), io::ErrorKind::AlreadyExists);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_followed_or_replaced_and_no_file_of_a_staged_name_is_opened() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("mine"), "mine").unwrap();
        symlink("mine", path("link")).unwrap();
        symlink("mine", path(".resultant-aB3dE6gH.new")).unwrap();
        replace(&path("link"), b"followed", Symlinks::Followed).unwrap();
        assert_eq!(fs::read(path("mine")).unwrap(), b"followed");
        replace(&path("link"), b"replaced", Symlinks::Never).unwrap();
        assert_eq!(
            (fs::read(path("mine")).unwrap(), fs::read(path("link")).unwrap()),
            (b"followed".to_vec(), b"replaced".to_vec())
        );
        assert!(!path("link").is_symlink() && path(".resultant-aB3dE6gH.new").is_symlink());
        symlink("nowhere", path("lost")).unwrap();
        assert_eq!(replace(&path("lost"), b"", Symlinks::Followed).unwrap_err().to_string(), "a link that leads to no file");
        assert_eq!(create(&path("lost"), b"").unwrap_err().kind(), io::ErrorKind::AlreadyExists);
    }
}
