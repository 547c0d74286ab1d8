//! Writing a package into the folder of levels.

use super::package::{LARGEST, MOST_FILES, Package, check, listed};
use super::{archive::read, path};
use crate::level::{self, BACKGROUND, FILES, scaffold};
use crate::{files, words::tr};
use std::io;
use std::path::{Path, PathBuf};

const MOST_NAMES: u32 = 1000;

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Installed {
    /// In a new folder.
    New(PathBuf),
    /// The very same level was there, with these further files in its folder.
    Already(PathBuf, Vec<String>),
}

impl Installed {
    pub fn folder(&self) -> &Path {
        match self {
            Self::New(folder) | Self::Already(folder, _) => folder,
        }
    }
}

/// Installs the level of an archive on disk, under another name where its own is taken. Errors: every fault, a line each; nothing was written then.
pub fn install_file(archive: &Path, levels: &Path, project: &Path) -> Result<Installed, Vec<String>> {
    let named = |problem: String| vec![format!("{}: {problem}", archive.display())];
    if archive.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("zip")) {
        return Err(named(tr("expected a level as one file, a .zip that `resultant pack` made").to_owned()));
    }
    let bytes = files::read(archive, LARGEST).map_err(|error| named(error.to_string()))?;
    let package = read(&bytes, &archive.file_stem().unwrap_or_default().to_string_lossy()).map_err(named)?;
    install(&package, levels, project, true)
}

/// Writes a checked package into `levels`: under its own name, or, with `free_name`, under another one where a different level has that name. Errors:
/// every problem of the level; a taken name; the disk's. Nothing is left behind then.
pub fn install(package: &Package, levels: &Path, project: &Path, free_name: bool) -> Result<Installed, Vec<String>> {
    path::judge_folder(&package.name).map_err(|problem| vec![problem])?;
    check(package, project)?;
    let (path, own) = (levels.display(), format!("{:?}", package.name));
    let refused = |error: &io::Error| vec![tr!("{path}: cannot install {name}: {error}", path, name = own, error)];
    let mut problems = Vec::new();
    for number in 1..=MOST_NAMES {
        let name = if number > 1 { format!("{}-{number}", package.name) } else { package.name.clone() };
        let folder = levels.join(&name);
        let folder = match scaffold::taken(levels, &name) {
            Some(other) => levels.join(other),
            None => match files::create_folder(&folder, |begun| fill(package, begun, project, &mut problems)) {
                Ok(()) => return Ok(Installed::New(folder)),
                Err(_) if !problems.is_empty() => return Err(problems),
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists || !files::is_taken(&folder) => {
                    return Err(refused(&error));
                }
                Err(_) => folder,
            },
        };
        match compare(package, &folder) {
            Ok(more) => return Ok(Installed::Already(folder, more)),
            Err(_) if free_name => {}
            Err(differs) => {
                let found = tr!("{path}: there is another level of that name: {differs}", path = folder.display(), differs);
                return Err(vec![format!("{found}; {}", tr("nothing was written, --as NAME gives this one another name"))]);
            }
        }
    }
    Err(vec![tr!("{path}: there are too many levels named {name}", path, name = own)])
}

/// Writes the files, and loads the level from them: a folder there may have the name of a table or a picture.
fn fill(package: &Package, folder: &Path, project: &Path, problems: &mut Vec<String>) -> io::Result<()> {
    for (path, bytes) in &package.files {
        files::put(&folder.join(path), bytes)?;
    }
    level::load(folder, project).map(drop).map_err(|refused| {
        *problems = level::listed(&refused);
        io::ErrorKind::InvalidData.into()
    })
}

/// The files of a folder that the package lacks. The error is a difference that makes another level, in words.
fn compare(package: &Package, folder: &Path) -> Result<Vec<String>, String> {
    for (path, bytes) in &package.files {
        match files::read(&folder.join(path), bytes.len() as u64) {
            Ok(found) if found == *bytes => {}
            Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => {
                return Err(tr!("{path} is not there", path));
            }
            _ => return Err(tr!("{path} is another one", path)),
        }
    }
    let mut more = Vec::new();
    beside(package, folder, "", &mut more);
    match more.iter().find(|path| FILES.contains(&path.as_str()) || *path == BACKGROUND) {
        Some(table) => Err(tr!("{path} lies there, too", path = table)),
        None => Ok(more),
    }
}

/// Adds the files of a folder that the package lacks, by their paths from the level's folder, except hidden ones.
fn beside(package: &Package, folder: &Path, within: &str, more: &mut Vec<String>) {
    for name in listed(&folder.join(within)).unwrap_or_default() {
        let path = if within.is_empty() { name } else { format!("{within}/{name}") };
        let at = folder.join(&path);
        let is_folder = !files::is_link(&at) && files::is_folder(&at);
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
