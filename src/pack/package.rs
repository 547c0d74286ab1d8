//! A level's files in memory.

use super::path;
use crate::files;
use crate::game::Replay;
use crate::level::{self, FILES, Files, Loaded};
use crate::words::tr;
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

/// The largest archive, bytes.
pub const LARGEST: u64 = 64 << 20;
/// All files together, unpacked, bytes.
pub const UNPACKED: u64 = 64 << 20;
/// From the archive to the screen, bytes.
pub const MEMORY: u64 = 256 << 20;
pub const MOST_FILES: usize = 1000;
/// The folder of a level's flights, and the end of their files' names.
pub(super) const FLIGHTS: &str = "flights/";
pub(super) const FLIGHT: &str = ".replay.csv";

/// By their paths from the level's folder, with forward slashes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Package {
    pub name: String,
    pub files: BTreeMap<String, Vec<u8>>,
}

/// The most bytes of a file at that path; `None` for a file that belongs to no level.
pub(super) fn limit(path: &str) -> Option<u64> {
    let lower = path.to_lowercase();
    match lower.rsplit('.').next() {
        _ if lower.starts_with(FLIGHTS) => lower.ends_with(FLIGHT).then_some(files::INPUTS),
        Some("csv" | "txt" | "md") => Some(files::LEVEL_TABLE),
        Some("png") => Some(files::PICTURE),
        _ => None,
    }
}

/// The files of a level that can be handed on: tables, pictures wherever they lie, flights and notes; and the names of the other
/// files in its folder.
/// Errors: a level's name that no package can have; the level's problems; a file that cannot be read, or is a link; the errors of
/// [`check`].
pub fn gather(folder: &Path, project: &Path) -> Result<(Package, Vec<String>), Vec<String>> {
    let name = files::resolve(folder).ok().as_deref().unwrap_or(folder).file_name().map(|name| name.to_string_lossy().into_owned());
    let name = name.unwrap_or_default();
    path::judge_folder(&name).map_err(|problem| vec![problem])?;
    let level = level::load(folder, project).map_err(|problems| level::listed(&problems))?.level;
    let (mut package, mut left) = (Package { name, files: BTreeMap::new() }, Vec::new());
    let mut take = |path: String, from: &Path, root: &Path, most: u64| {
        if let Some(link) = link_below(root, from) {
            return Err(vec![format!("{}: {}", link.display(), tr("found a link, expected a regular file"))]);
        }
        let bytes = files::read(from, most).map_err(|error| vec![format!("{}: {error}", from.display())])?;
        package.files.insert(path, bytes);
        Ok(())
    };
    for entry in listed(folder)? {
        let table = FILES.contains(&entry.as_str()) || entry.ends_with(".txt") || entry.ends_with(".md");
        match limit(&entry).filter(|_| table || entry.ends_with(".png")) {
            Some(most) => take(entry.clone(), &folder.join(&entry), folder, most)?,
            None if files::is_folder(&folder.join(&entry)) => {}
            None => left.push(entry),
        }
    }
    for entry in listed(&folder.join(FLIGHTS)).unwrap_or_default() {
        let path = format!("{FLIGHTS}{entry}");
        match limit(&path) {
            Some(most) => take(path.clone(), &folder.join(&path), folder, most)?,
            None => left.push(path),
        }
    }
    for picture in level.pictures() {
        let root = if picture.starts_with(folder) { folder } else { project };
        let own = picture.strip_prefix(root).unwrap_or(picture);
        let parts: Vec<_> = own.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
        take(parts.join("/"), picture, root, files::PICTURE)?;
    }
    check(&package, project)?;
    Ok((package, left))
}

/// The first link on the path down from a folder.
fn link_below<'a>(root: &Path, path: &'a Path) -> Option<&'a Path> {
    path.ancestors().take_while(|part| *part != root && part.starts_with(root)).find(|part| files::is_link(part))
}

pub(super) fn listed(folder: &Path) -> Result<Vec<String>, Vec<String>> {
    let entries = files::names(folder).map_err(|error| vec![format!("{}: {error}", folder.display())])?;
    let mut names: Vec<String> = entries.into_iter().filter_map(|name| name.into_string().ok()).collect();
    names.retain(|name| !name.starts_with('.'));
    names.sort_unstable();
    Ok(names)
}

/// Whether a package is a level that loads, with readable flights. Pictures outside the package come from the project.
/// Errors: every problem, a line each.
pub fn check(package: &Package, project: &Path) -> Result<Loaded, Vec<String>> {
    let loaded = level::read(&package.name, &PackedFiles { package, project });
    let mut problems = loaded.as_ref().err().map(|problems| level::listed(problems)).unwrap_or_default();
    for (path, bytes) in package.files.iter().filter(|(path, _)| path.starts_with(FLIGHTS)) {
        match str::from_utf8(bytes) {
            Ok(text) => problems.extend(Replay::parse(path, text).err().into_iter().flat_map(|bad| bad.0)),
            Err(_) => problems.push(format!("{path}: {}", tr("found letters that are not UTF-8, expected a file saved as UTF-8"))),
        }
    }
    match loaded {
        Ok(loaded) if problems.is_empty() => Ok(loaded),
        _ => Err(problems),
    }
}

struct PackedFiles<'a> {
    package: &'a Package,
    project: &'a Path,
}

impl Files for PackedFiles<'_> {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        let parts: Vec<&str> = name.split('/').filter(|part| !matches!(*part, "" | ".")).collect();
        self.package.files.get(&parts.join("/")).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn project_file(&self, path: &str) -> io::Result<Vec<u8>> {
        files::read(&self.project.join(path), files::PICTURE)
    }

    fn names(&self) -> Vec<String> {
        self.package.files.keys().filter(|path| !path.contains('/')).cloned().collect()
    }
}
