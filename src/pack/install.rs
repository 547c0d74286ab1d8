//! Writing a package into the folder of levels.

use super::{MOST_FILES, Package, check, listed, path};
use crate::files;
use crate::level::{BACKGROUND, FILES};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// How the folder begins in which a level is put together: a list of levels does not show it.
const HIDDEN: &str = ".new-";
/// How many names are tried for a level whose own is taken.
const MOST_NAMES: u32 = 1000;

/// What became of a package.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Installed {
    /// It has a folder now.
    New(PathBuf),
    /// The very same level is there already; with the other files that lie in its folder.
    Already(PathBuf, Vec<String>),
}

impl Installed {
    /// The level's folder.
    pub fn folder(&self) -> &Path {
        match self {
            Self::New(folder) | Self::Already(folder, _) => folder,
        }
    }
}

/// Writes a package into `levels` after all of it is checked: under its own name, or under another one where `free_name` allows and its own
/// is taken by another level.
///
/// # Errors
/// Every problem of the level; its name is taken; what the disk refuses. Nothing is left behind then.
pub fn install(package: &Package, levels: &Path, project: &Path, free_name: bool) -> Result<Installed, Vec<String>> {
    path::judge_folder(&package.name).map_err(|problem| vec![problem])?;
    check(package, project)?;
    let refused = |error: &io::Error| vec![format!("{}: cannot install {:?}: {error}", levels.display(), package.name)];
    fs::create_dir_all(levels).map_err(|error| refused(&error))?;
    let whole = put_together(package, levels).map_err(|error| refused(&error))?;
    for number in 1..=MOST_NAMES {
        let name = if number > 1 { format!("{}-{number}", package.name) } else { package.name.clone() };
        let folder = levels.join(&name);
        // A rename would take the place of an empty folder.
        if fs::symlink_metadata(&folder).is_err() {
            fs::rename(whole.path(), &folder).map_err(|error| refused(&error))?;
            // There is nothing left to remove.
            drop(whole.keep());
            return Ok(Installed::New(folder));
        }
        let differs = match compare(package, &folder) {
            Ok(more) => return Ok(Installed::Already(folder, more)),
            Err(differs) => differs,
        };
        if !free_name {
            let found = format!("{}: there is another level of that name: {differs}", folder.display());
            return Err(vec![format!("{found}; nothing was written, --as NAME gives this one another name")]);
        }
    }
    Err(vec![format!("{}: there are too many levels named {:?}", levels.display(), package.name)])
}

/// All files in a folder under a hidden name, which goes again unless it becomes the level's.
fn put_together(package: &Package, levels: &Path) -> io::Result<tempfile::TempDir> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As for any new folder; tempfile's own would be for the user's eyes only.
        builder.permissions(fs::Permissions::from_mode(0o777));
    }
    let begun = builder.prefix(HIDDEN).tempdir_in(levels)?;
    for (path, bytes) in &package.files {
        let to = begun.path().join(path);
        fs::create_dir_all(to.parent().unwrap_or(begun.path()))?;
        let mut file = fs::File::create_new(&to)?;
        io::Write::write_all(&mut file, bytes)?;
        file.sync_all()?;
    }
    Ok(begun)
}

/// Compares a package with a folder: the files that lie there beside those of the package.
///
/// # Errors
/// A difference that makes another level of it, in words.
fn compare(package: &Package, folder: &Path) -> Result<Vec<String>, String> {
    for (path, bytes) in &package.files {
        match files::read(&folder.join(path), bytes.len() as u64) {
            Ok(found) if found == *bytes => {}
            Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => {
                return Err(format!("{path} is not there"));
            }
            _ => return Err(format!("{path} is another one")),
        }
    }
    let mut more = Vec::new();
    beside(package, folder, "", &mut more);
    match more.iter().find(|path| FILES.contains(&path.as_str()) || *path == BACKGROUND) {
        Some(table) => Err(format!("{table} lies there, too")),
        None => Ok(more),
    }
}

/// Adds the files of a folder that are not the package's, by their paths from the level's folder. Hidden ones are nobody's business.
fn beside(package: &Package, folder: &Path, within: &str, more: &mut Vec<String>) {
    for name in listed(&folder.join(within)).unwrap_or_default() {
        let path = if within.is_empty() { name } else { format!("{within}/{name}") };
        let is_folder = std::fs::symlink_metadata(folder.join(&path)).is_ok_and(|found| found.is_dir());
        if more.len() >= MOST_FILES {
            return;
        }
        if is_folder && path.split('/').count() < path::DEEPEST {
            beside(package, folder, &path, more);
        } else if !package.files.contains_key(&path) {
            more.push(path);
        }
    }
}
