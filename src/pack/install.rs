//! Writing a package into the folder of levels.

use super::{Package, check, path};
use crate::files;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// How many names are tried for a level whose own is taken.
const MOST_NAMES: u32 = 1000;

/// What became of a package.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Installed {
    /// It has a folder now.
    New(PathBuf),
    /// The very same level is there already.
    Already(PathBuf),
}

impl Installed {
    /// The level's folder.
    pub fn folder(&self) -> &Path {
        match self {
            Self::New(folder) | Self::Already(folder) => folder,
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
    for number in 1..=MOST_NAMES {
        let name = if number > 1 { format!("{}-{number}", package.name) } else { package.name.clone() };
        let folder = levels.join(&name);
        match files::create_folder(&folder, |begun| fill(package, begun)) {
            Ok(()) => return Ok(Installed::New(folder)),
            Err(error) if error.kind() != io::ErrorKind::AlreadyExists || fs::symlink_metadata(&folder).is_err() => {
                return Err(refused(&error));
            }
            Err(_) if is_same(package, &folder) => return Ok(Installed::Already(folder)),
            Err(_) if free_name => {}
            Err(_) => {
                let found = format!("{}: there is another level of that name", folder.display());
                return Err(vec![format!("{found}; nothing was written, --as NAME gives this one another name")]);
            }
        }
    }
    Err(vec![format!("{}: there are too many levels named {:?}", levels.display(), package.name)])
}

/// All files of a package.
fn fill(package: &Package, folder: &Path) -> io::Result<()> {
    for (path, bytes) in &package.files {
        let to = folder.join(path);
        fs::create_dir_all(to.parent().unwrap_or(folder))?;
        files::put(&to, bytes)?;
    }
    Ok(())
}

/// Whether a folder holds each of these files, with these bytes.
fn is_same(package: &Package, folder: &Path) -> bool {
    package.files.iter().all(|(path, bytes)| files::read(&folder.join(path), bytes.len() as u64).is_ok_and(|found| found == *bytes))
}
