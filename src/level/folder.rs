//! The only part of the loader that knows the disk.

use super::problem::{Problem, quoted};
use super::read::{Files, Loaded, read};
use super::rows;
use super::types::Look;
use std::cmp::Ordering;
use std::io;
use std::path::Path;

/// Longest name of a level: it is also the name of its scores file.
const MAX_NAME: usize = 40;

/// Loads the level in `folder`; images are looked up under `project`, the folder that holds `assets/` and `levels/`. The paths in
/// the level can be opened as they are.
///
/// # Errors
/// Every problem in every file; a folder that is none is one problem.
pub fn load(folder: &Path, project: &Path) -> Result<Loaded, Vec<Problem>> {
    // `.` and `..` have a name only once they are resolved.
    let resolved = folder.canonicalize().unwrap_or_else(|_| folder.to_path_buf());
    let name = folder.file_name().or(resolved.file_name()).map_or_else(|| folder.to_string_lossy(), |name| name.to_string_lossy());
    if !folder.is_dir() {
        return Err(vec![rows::PLAYER.problem(1, format!("no folder {}", quoted(&name)), "a level folder")]);
    }
    let mut loaded = read(&name, &Disk { folder, project })?;
    let level = &mut loaded.level;
    level.background = level.background.take().map(|path| folder.join(path));
    for object in &mut level.objects {
        if let Look::Image(path) = &mut object.look {
            *path = project.join(&*path);
        }
    }
    Ok(loaded)
}

struct Disk<'a> {
    folder: &'a Path,
    project: &'a Path,
}

impl Files for Disk<'_> {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        read_regular(&self.folder.join(name))
    }

    fn project_file(&self, path: &str) -> io::Result<Vec<u8>> {
        read_regular(&self.project.join(path))
    }
}

/// Reads a file, unless it is something else that would keep a reader waiting for ever (a pipe, a device).
fn read_regular(path: &Path) -> io::Result<Vec<u8>> {
    let kind = std::fs::metadata(path)?.file_type();
    if kind.is_file() || kind.is_dir() {
        return std::fs::read(path);
    }
    Err(io::Error::new(io::ErrorKind::InvalidInput, "not a regular file"))
}

/// The names of the level folders in `levels`: those named by a number first and in numeric order (2 before 10), the others after,
/// by name. Hidden folders and folders whose name is no text are left out; a folder that cannot be read holds none.
pub fn list(levels: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(levels).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries
        .filter(|entry| entry.path().is_dir())
        .filter_map(|entry| entry.file_name().into_string().ok())
        .filter(|name| !name.starts_with('.'))
        .collect();
    names.sort_by(|a, b| by_number_then_name(a, b));
    names
}

/// Whether a new level may have that name: a word of at most 40 letters, digits, `-` and `_` that begins with a letter or digit.
pub fn is_level_name(name: &str) -> bool {
    name.chars().count() <= MAX_NAME
        && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_'))
        && name.chars().next().is_some_and(char::is_alphanumeric)
}

/// Numbers before words, numbers by value (however long they are), everything else by name.
fn by_number_then_name(a: &str, b: &str) -> Ordering {
    let digits = |name: &str| !name.is_empty() && name.bytes().all(|b| b.is_ascii_digit());
    let value = |name: &str| {
        let value = name.trim_start_matches('0').to_owned();
        (value.len(), value)
    };
    match (digits(a), digits(b)) {
        (true, true) => value(a).cmp(&value(b)).then_with(|| a.cmp(b)),
        (true, false) => Ordering::Less,
        (false, true) => Ordering::Greater,
        (false, false) => a.cmp(b),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_first_and_by_value() {
        let mut names = ["tower", "10", "2", "Alpha", "02", "1b", "0", "99999999999999999999999", "1"];
        names.sort_by(|a, b| by_number_then_name(a, b));
        assert_eq!(names, ["0", "1", "02", "2", "10", "99999999999999999999999", "1b", "Alpha", "tower"]);
    }

    #[test]
    fn level_names_are_words() {
        for name in ["1", "tower", "höhle-2", "a_b", &"x".repeat(40)] {
            assert!(is_level_name(name), "{name}");
        }
        for name in ["", "-a", "_a", "a b", "a/b", "..", "a.b", "C:", "a\\b", &"x".repeat(41)] {
            assert!(!is_level_name(name), "{name}");
        }
    }
}
