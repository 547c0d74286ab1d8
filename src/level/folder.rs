//! The only part of the loader that knows the disk.
//! Names of levels: a folder's name is also the name of its leaderboard's file.

use super::problem::{Problem, quoted};
use super::read::{Loaded, read, read_unfinished};
use super::schema::{Kind, Table, Word};
use super::types::{Landscape, Look};
use super::{image::Files, table};
use crate::files::{self, CsvFile};
use crate::words::tr;
use std::path::{Path, PathBuf};
use std::{cmp::Ordering, io};

/// Images are looked up in `folder`, then under `project`, the folder that holds `assets/` and `levels/`. The paths in the level can be opened as
/// they are. Errors: every problem in every file; a folder that does not exist, or that has the name of another leaderboard, is one problem.
pub fn load(folder: &Path, project: &Path) -> Result<Loaded, Vec<Problem>> {
    load_from(&LevelDisk { folder, project }, &LevelDisk { folder, project }, read)
}

/// The level 1 of the tests' own project, which changes with no shipped level.
#[cfg(test)]
pub(crate) fn fixture() -> super::Level {
    let project = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    load(&project.join("levels/1"), &project).expect("it loads").level
}

/// As [`load`], of an unfinished level: see [`read_unfinished`].
pub fn load_unfinished(folder: &Path, project: &Path) -> Result<Loaded, Vec<Problem>> {
    load_from(&LevelDisk { folder, project }, &LevelDisk { folder, project }, read_unfinished)
}

/// [`read()`] or [`read_unfinished`].
pub(super) type ReadLevel = fn(&str, &dyn Files) -> Result<Loaded, Vec<Problem>>;

/// As [`load`], with the level's files from elsewhere.
pub(super) fn load_from(disk: &LevelDisk, files: &dyn Files, read: ReadLevel) -> Result<Loaded, Vec<Problem>> {
    let LevelDisk { folder, .. } = disk;
    // `.` and `..` have a name only once they are resolved.
    let resolved = files::resolve(folder).unwrap_or_else(|_| folder.to_path_buf());
    let name = folder.file_name().or(resolved.file_name()).map_or_else(|| folder.to_string_lossy(), |name| name.to_string_lossy());
    if !files::is_folder(folder) {
        return Err(vec![Kind::Ship.schema().problem(1, tr!("no folder {name}", name = quoted(&name)), tr("a level folder"))]);
    }
    let found = || tr!("a level folder named {name}", name = quoted(&name));
    let fault = judge_taken(&name).err().map(|fault| (fault, Problem::new("folder", 1, "name", found(), fault.expected())));
    if let Some((NameFault::Board(_), problem)) = fault {
        return Err(vec![problem]);
    }
    let mut loaded = read(&name, files)?;
    // The level plays here, but not every system takes a folder of its name.
    loaded.warnings.extend(fault.map(|(_, problem)| problem));
    let level = &mut loaded.level;
    level.background = level.background.take().map(|path| folder.join(path));
    let looks =
        level.objects.iter_mut().map(|object| &mut object.look).chain(level.decoration.iter_mut().map(|shown| &mut shown.look));
    for look in looks {
        if let Look::Image(path) = look {
            *path = disk.picture(path);
        }
    }
    Ok(loaded)
}

pub(super) struct LevelDisk<'a> {
    pub folder: &'a Path,
    pub project: &'a Path,
}

impl LevelDisk<'_> {
    /// In the level's folder, else in the project's.
    pub fn picture(&self, name: &Path) -> PathBuf {
        let own = self.folder.join(name);
        if files::look(&own).is_ok() { own } else { self.project.join(name) }
    }
}

impl Files for LevelDisk<'_> {
    fn level_file(&self, name: &str) -> io::Result<Vec<u8>> {
        let table = name.ends_with(".csv");
        let path = self.folder.join(name);
        let read = files::read(&path, if table { files::LEVEL_TABLE } else { files::PICTURE });
        match read {
            // A broken link is no missing file.
            Err(error) if error.kind() == io::ErrorKind::NotFound && files::is_link(&path) => {
                Err(io::Error::other("a link to a file that is not there"))
            }
            read => read,
        }
    }

    fn names(&self) -> Vec<String> {
        files::text_names(self.folder)
    }

    fn flights(&self) -> Vec<String> {
        files::text_names(&self.folder.join("flights"))
    }

    fn project_file(&self, path: &str) -> io::Result<Vec<u8>> {
        files::read(&self.project.join(path), files::PICTURE)
    }
}

/// The title in a level's constants.csv, the only file that is read.
pub fn title(folder: &Path) -> Option<String> {
    setting(folder, "title")
}

/// The world of a level that comes with the game.
pub fn landscape(folder: &Path) -> Option<Landscape> {
    let word = is_shipped(folder).then(|| setting(folder, "world"))??;
    Landscape::words().into_iter().find(|(name, _)| word.eq_ignore_ascii_case(name)).map(|(_, landscape)| landscape)
}

fn setting(folder: &Path, name: &str) -> Option<String> {
    let bytes = files::read(&folder.join(Table::Constants.file()), files::LEVEL_TABLE).ok()?;
    let table = table::read(Table::Constants.rows(), &bytes, &mut Vec::new());
    let rows = table.records.iter().filter(|row| row.text("name").is_some_and(|given| given.eq_ignore_ascii_case(name)));
    rows.filter_map(|row| row.text("value")).next().filter(|value| !value.is_empty()).map(str::to_owned)
}

/// The lists of the levels that come with the game, each beside the levels' folders.
const SHIPPED: [&str; 2] = ["shipped.csv", "experiments.csv"];

/// Whether a level comes with the game, so that it is edited as a copy: a list beside its folder names it.
pub fn is_shipped(folder: &Path) -> bool {
    let Ok(folder) = files::resolve(folder) else { return false };
    let (Some(name), Some(beside)) = (folder.file_name().and_then(|name| name.to_str()), folder.parent()) else { return false };
    let named = |list: &str| {
        let bytes = files::read(&beside.join(list), files::LEVEL_TABLE).unwrap_or_default();
        let mut rows = CsvFile { name: list, columns: &["folder"], comments: true }.rows(&bytes);
        rows.next().is_some_and(|header| header.is_header(1)) && rows.any(|row| row.get("folder") == name)
    };
    SHIPPED.into_iter().any(named)
}

/// Whether that is what the folder of the experiments is called among those of the levels, in any case.
fn is_experiments(name: &str) -> bool {
    Path::new(files::EXPERIMENTS).file_name().is_some_and(|own| own.eq_ignore_ascii_case(name))
}

/// The names of the level folders in `levels`: numbers first, in numeric order (2 before 10), then words. Hidden folders, that of the
/// experiments and folders whose name is no text are left out; an unreadable folder holds none.
pub fn list(levels: &Path) -> Vec<String> {
    let mut names = files::text_names(levels);
    names.retain(|name| !name.starts_with('.') && !is_experiments(name) && files::is_folder(&levels.join(name)));
    names.sort_by(|a, b| by_number_then_name(a, b));
    names
}

/// Numbers of any length before words, by value; words by their letters, with the numbers in them by value.
pub(crate) fn by_number_then_name(a: &str, b: &str) -> Ordering {
    let digits = |name: &str| !name.is_empty() && name.bytes().all(|b| b.is_ascii_digit());
    let value = |name: &str| {
        let value = name.trim_start_matches('0').to_owned();
        (value.len(), value)
    };
    match (digits(a), digits(b)) {
        (true, true) => value(a).cmp(&value(b)).then_with(|| a.cmp(b)),
        (true, false) => Ordering::Less,
        (false, true) => Ordering::Greater,
        (false, false) => runs(a).cmp(&runs(b)).then_with(|| a.cmp(b)),
    }
}

/// A name in runs of digits and of other letters; digits come first and count by value: lev2 is before lev10.
fn runs(name: &str) -> Vec<(bool, usize, &str)> {
    let mut runs = Vec::new();
    let mut rest = name;
    while let Some(first) = rest.chars().next() {
        let digits = first.is_ascii_digit();
        let end = rest.find(|c: char| c.is_ascii_digit() != digits).unwrap_or(rest.len());
        let (run, after) = rest.split_at(end);
        let value = run.trim_start_matches('0');
        runs.push(if digits { (false, value.len(), value) } else { (true, 0, run) });
        rest = after;
    }
    runs
}

/// Longest name of a new level, characters.
const MAX_NAME: usize = 40;
/// Files among the leaderboards that belong to no level: the Jumper's board, what the players have done, and the list of attempts.
const OTHER_FILES: [&str; 3] = ["jumper", "players", "attempts"];
/// Names that Windows takes for devices, with any ending: no folder and no file of scores can have one there.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "conin$", "conout$"];
/// Devices that a digit follows.
const NUMBERED_DEVICES: [&str; 2] = ["com", "lpt"];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameFault {
    NoWord,
    /// A character that nobody sees, or that turns the others around.
    Hidden(char),
    /// Another file among the leaderboards has this name.
    Board(&'static str),
    Device,
    /// The folder of the experiments has this name.
    Experiments,
}

impl NameFault {
    pub fn expected(self) -> String {
        match self {
            Self::Hidden(c) => tr!("a name without the invisible character {code}", code = format_args!("U+{:04X}", c as u32)),
            Self::NoWord => tr!("up to {most} letters, digits, - and _, the first a letter or digit", most = MAX_NAME),
            Self::Board(name) => tr!("another name, as scores/{name}.csv is a list of another kind", name),
            Self::Experiments => tr("another name, as that folder holds the experiments").to_owned(),
            Self::Device => tr("another name, as Windows takes that one for a device").to_owned(),
        }
    }
}

/// Judges the name of a new level: a word of at most 40 letters, digits, `-` and `_` that begins with a letter or digit and is not taken in any case.
pub fn judge_name(name: &str) -> Result<(), NameFault> {
    let word = name.chars().count() <= MAX_NAME
        && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_'))
        && name.chars().next().is_some_and(char::is_alphanumeric);
    let taken = if is_experiments(name) { Err(NameFault::Experiments) } else { judge_taken(name) };
    if word || matches!(taken, Err(NameFault::Hidden(_))) { taken } else { Err(NameFault::NoWord) }
}

/// Refuses hidden characters, and the names of devices and of other files among the leaderboards, in any case.
pub(super) fn judge_taken(name: &str) -> Result<(), NameFault> {
    if let Some(hidden) = name.chars().find(|c| is_hidden(*c)) {
        return Err(NameFault::Hidden(hidden));
    }
    let lower = name.to_lowercase();
    if let Some(name) = OTHER_FILES.into_iter().find(|file| *file == lower) {
        return Err(NameFault::Board(name));
    }
    if is_device(&lower) { Err(NameFault::Device) } else { Ok(()) }
}

/// Characters of Unicode 16 that show nothing, or change the direction of those behind them: line and paragraph separators, the blank of
/// Braille, format characters, and those of the property Default_Ignorable_Code_Point. The first and the last of each range.
const HIDDEN: [u32; 54] = [
    0xad, 0xad, 0x34f, 0x34f, 0x600, 0x605, 0x61c, 0x61c, 0x6dd, 0x6dd, 0x70f, 0x70f, 0x890, 0x891, 0x8e2, 0x8e2, 0x115f, 0x1160,
    0x17b4, 0x17b5, 0x180b, 0x180f, 0x200b, 0x200f, 0x2028, 0x202e, 0x2060, 0x206f, 0x2800, 0x2800, 0x3164, 0x3164, 0xfe00, 0xfe0f,
    0xfeff, 0xfeff, 0xffa0, 0xffa0, 0xfff0, 0xfffb, 0x110bd, 0x110bd, 0x110cd, 0x110cd, 0x13430, 0x1343f, 0x1bca0, 0x1bca3,
    0x1d159, 0x1d159, 0x1d173, 0x1d17a, 0xe0000, 0xe0fff,
];

/// Whether nobody sees that character in a name, or it turns the others around.
pub fn is_hidden(c: char) -> bool {
    HIDDEN.chunks_exact(2).any(|ends| (ends[0]..=ends[1]).contains(&u32::from(c)))
}

/// Whether Windows takes a file or folder of that name for a device: `con`, `CON .txt`, `com1.csv`, `CONIN$`.
pub fn is_device(name: &str) -> bool {
    let lower = name.to_lowercase();
    let stem = lower.split('.').next().unwrap_or_default().trim_end();
    let numbered = NUMBERED_DEVICES.iter().filter_map(|device| stem.strip_prefix(device)).any(|rest| {
        let mut rest = rest.chars();
        rest.next().is_some_and(|c| c.is_ascii_digit() || matches!(c, '¹' | '²' | '³')) && rest.next().is_none()
    });
    numbered || DEVICES.contains(&stem)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_names_count_by_value() {
        let mut names = ["lev100", "lev2b", "lev10", "lev1", "lev", "level", "lev2"];
        names.sort_by(|a, b| by_number_then_name(a, b));
        assert_eq!(names, ["lev", "lev1", "lev2", "lev2b", "lev10", "lev100", "level"]);
    }

    #[test]
    fn numbers_come_first_and_by_value() {
        let mut names = ["tower", "10", "2", "Alpha", "02", "1b", "0", "99999999999999999999999", "1"];
        names.sort_by(|a, b| by_number_then_name(a, b));
        assert_eq!(names, ["0", "1", "02", "2", "10", "99999999999999999999999", "1b", "Alpha", "tower"]);
    }

    #[test]
    fn level_names_are_words() {
        for name in ["1", "tower", "höhle-2", "a_b", &"x".repeat(40)] {
            assert_eq!(judge_name(name), Ok(()), "{name}");
        }
        for name in ["", "-a", "_a", "a b", "a/b", "..", "a.b", "C:", "a\\b", &"x".repeat(41)] {
            assert_eq!(judge_name(name), Err(NameFault::NoWord), "{name}");
        }
    }

    #[test]
    fn no_name_has_a_character_that_nobody_sees() {
        for hidden in ['\u{202e}', '\u{200b}', '\u{2066}', '\u{feff}', '\u{3164}', '\u{e0041}', '\u{ad}', '\u{1160}', '\u{180e}'] {
            assert_eq!(judge_name(&format!("to{hidden}wer")), Err(NameFault::Hidden(hidden)), "{hidden:?}");
        }
        assert!(!"höhle-2 Ωж漢字かなਪੰ".chars().any(is_hidden) && HIDDEN.is_sorted());
    }

    #[test]
    fn names_that_are_taken_are_none_in_any_case() {
        for name in ["jumper", "Jumper", "JUMPER", "players", "Attempts"] {
            assert!(matches!(judge_name(name), Err(NameFault::Board(_))), "{name}");
        }
        for name in ["CON", "aux", "NUL", "prn", "COM1", "com0", "Lpt9", "com¹"] {
            assert_eq!(judge_name(name), Err(NameFault::Device), "{name}");
        }
        assert_eq!(judge_name("Experiments"), Err(NameFault::Experiments));
        assert_eq!(judge_taken("aux.2"), Err(NameFault::Device));
        for name in ["con .txt", "CONIN$", "conout$.csv", "COM1 .png"] {
            assert!(is_device(name), "{name}");
        }
        for name in ["jumper2", "the-jumper", "icon", "console", "com", "com10", "lpt-1", "auxiliary", "nul1"] {
            assert_eq!(judge_name(name), Ok(()), "{name}");
        }
    }
}
