//! Writing a package into the folder of levels.

use super::{LARGEST, Package, check, path, read};
use crate::files;
use crate::level::scaffold;
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

/// Installs the level of an archive on disk among the others: under a name of its own, where its name is another level's.
///
/// # Errors
/// All that is wrong with it, a line each; nothing was written then.
pub fn install_file(archive: &Path, levels: &Path, project: &Path) -> Result<Installed, Vec<String>> {
    let named = |problem: String| vec![format!("{}: {problem}", archive.display())];
    if archive.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("zip")) {
        return Err(named("expected a level as one file, a .zip that `resultant pack` made".to_owned()));
    }
    let bytes = files::read(archive, LARGEST).map_err(|error| named(error.to_string()))?;
    let package = read(&bytes, &archive.file_stem().unwrap_or_default().to_string_lossy()).map_err(named)?;
    install(&package, levels, project, true)
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
        let other = scaffold::taken(levels, &name);
        if other.is_none() {
            fs::rename(whole.path(), &folder).map_err(|error| refused(&error))?;
            // There is nothing left to remove.
            drop(whole.keep());
            return Ok(Installed::New(folder));
        }
        let folder = other.map_or(folder, |other| levels.join(other));
        if is_same(package, &folder) {
            return Ok(Installed::Already(folder));
        }
        if !free_name {
            let found = format!("{}: there is another level of that name", folder.display());
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

/// Whether a folder holds each of these files, with these bytes.
fn is_same(package: &Package, folder: &Path) -> bool {
    package.files.iter().all(|(path, bytes)| files::read(&folder.join(path), bytes.len() as u64).is_ok_and(|found| found == *bytes))
}
