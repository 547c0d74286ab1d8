//! A level's files in memory; the flights in its folder, flown again in the level as it is; and the memory of a packed level before it is unpacked,
//! by the sizes in the archive, to which reading holds it, and by its pictures' heads.

use super::path;
use crate::files::{self, Symlinks, read_text};
use crate::game::{Game, Goal, LevelHash, Medal, Prize, Replay, RunResult, goals, level_hash};
use crate::level::document::{Document, LevelFolder, Opened};
use crate::level::{self, FILES, Files, Level, Loaded, Problem};
use crate::{number::hundredths, words::tr};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fmt::Display, io, sync::Arc};

/// Bytes of the largest archive, of all files unpacked, and of memory from the archive to the screen.
pub const LARGEST: u64 = 64 << 20;
pub const UNPACKED: u64 = 64 << 20;
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

/// The files of a level that can be handed on: tables, pictures wherever they lie, flights and notes; and the names of the other files in its folder.
/// Errors: a level's name that no package can have; the level's problems; a file that cannot be read, or is a link; the errors of [`check`].
pub fn gather(folder: &Path, project: &Path) -> Result<(Package, Vec<String>), Vec<String>> {
    let resolved = files::resolve(folder).unwrap_or_else(|_| folder.to_owned());
    let name = resolved.file_name().unwrap_or_default().to_string_lossy().into_owned();
    path::judge_folder(&name).map_err(|problem| vec![problem])?;
    let level = level::load(folder, project).map_err(|problems| level::listed(&problems))?.level;
    let (mut package, mut left) = (Package { name, files: BTreeMap::new() }, Vec::new());
    let mut take = |path: String, from: &Path, root: &Path, most: u64| {
        let mut below = from.ancestors().take_while(|part| *part != root && part.starts_with(root));
        if let Some(link) = below.find(|part| files::is_link(part)) {
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

pub(super) fn listed(folder: &Path) -> Result<Vec<String>, Vec<String>> {
    let entries = files::names(folder).map_err(|error| vec![format!("{}: {error}", folder.display())])?;
    let names = entries.into_iter().filter_map(|name| name.into_string().ok()).filter(|name| !name.starts_with('.'));
    Ok(names.collect::<BTreeSet<String>>().into_iter().collect())
}

/// Whether a package is a level that loads, with readable flights. Pictures outside the package come from the project.
/// Errors: every problem, a line each.
pub fn check(package: &Package, project: &Path) -> Result<Loaded, Vec<String>> {
    let loaded = load(package, project);
    let mut problems = loaded.as_ref().err().map(|problems| level::listed(problems)).unwrap_or_default();
    for (path, bytes) in package.files.iter().filter(|(path, _)| path.starts_with(FLIGHTS)) {
        match str::from_utf8(bytes) {
            Ok(text) => problems.extend(Replay::parse(path, text).err().into_iter().flat_map(|bad| bad.0)),
            Err(_) => problems.push(format!("{path}: {}", tr("found letters that are not UTF-8, expected a file saved as UTF-8"))),
        }
    }
    loaded.ok().filter(|_| problems.is_empty()).ok_or(problems)
}

/// The level of a package. Pictures outside the package come from the project.
pub fn load(package: &Package, project: &Path) -> Result<Loaded, Vec<Problem>> {
    level::read(&package.name, &PackedFiles { package, project })
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

/// The level with that hash in a folder of levels, whatever its name; the first of several.
pub fn of_hash(hash: LevelHash, levels: &Path, project: &Path) -> Option<Arc<Level>> {
    let load = |name: String| level::load(&levels.join(name), project).ok().map(|loaded| loaded.level);
    level::list(levels).into_iter().filter_map(load).find(|level| level_hash(level) == hash).map(Arc::new)
}

/// The most ticks of all flights of a level together: two hours. The rest is not flown.
const MOST_TICKS: u64 = 1_000_000;
/// The files of the flights that prove a level's medals.
pub const PROVE: [(&str, Prize); 4] = [
    ("careful", Prize::Medal(Medal::Bronze)),
    ("silver", Prize::Medal(Medal::Silver)),
    ("gold", Prize::Medal(Medal::Gold)),
    ("mark", Prize::Mark),
];

/// What the flights of a level prove by their names, in words. Errors, which forbid nothing: the flights that end elsewhere than they say, or do not
/// earn the medal of their name; where all hold, the medals that none of them earns.
pub fn proven(folder: &Path, level: &Arc<Level>) -> (Vec<String>, Vec<Problem>) {
    let names = listed(&folder.join(FLIGHTS)).unwrap_or_default();
    let mut left = MOST_TICKS;
    let (mut flown, mut proven, mut problems) = (Vec::new(), Vec::new(), Vec::new());
    for name in names.iter().filter(|name| name.ends_with(FLIGHT)) {
        match fly(&folder.join(FLIGHTS), name, level, &mut left) {
            Ok((reached, proves)) => {
                proven.extend(proves);
                flown.push(reached);
            }
            Err((found, expected)) => problems.push(problem(format!("{FLIGHTS}{name}"), found, expected)),
        }
    }
    if problems.is_empty() {
        problems = beyond(&flown);
    }
    (proven, problems)
}

/// Makes a flight a proof of its level: writes it into the level's folder under that name of [`PROVE`], and where it is one of gold or silver
/// the time that it took into constants.csv. The answer is the flight's file.
/// Errors: every reason why it proves nothing there, a line each, and nothing was written; the disk's.
pub fn prove(folder: &Path, project: &Path, stem: &str, replay: Replay) -> Result<PathBuf, Vec<String>> {
    let Opened { mut document, mut folder, .. } = LevelFolder::open_to_edit(folder, project).map_err(|problem| vec![problem])?;
    prove_in((&mut folder, &mut document), stem, replay)
}

/// As [`prove`], of a level that is open to be edited: with the time all its edits are saved.
pub fn prove_in((opened, edited): (&mut LevelFolder, &mut Document), stem: &str, replay: Replay) -> Result<PathBuf, Vec<String>> {
    let one = |problem: String| vec![problem];
    let mut document = edited.clone();
    if let Some(setting) = ["gold", "silver"].into_iter().find(|setting| *setting == stem) {
        let time = hundredths(replay.time);
        document.set_setting(setting, &format!("{}.{:02}", time / 100, time % 100), None).map_err(one)?;
    }
    let loaded = opened.check(&document).map_err(|problems| level::listed(&problems))?;
    let level = Arc::new(loaded.level);
    let replay = Replay { level: level.name.clone(), ..replay };
    let flights = opened.path().join(FLIGHTS);
    let path = flights.join(format!("{stem}{FLIGHT}"));
    let text = replay.to_string();
    let (_, proof) = earn(stem, replay, &level).map_err(|(found, expected)| one(files::found_instead(stem, found, expected)))?;
    proof.ok_or_else(|| one(format!("{stem}: the level has no medal or mark of that name")))?;
    let refused = |error: io::Error| one(format!("{}: {error}", path.display()));
    files::make_folder(&flights).map_err(refused)?;
    files::replace(&path, text.as_bytes(), Symlinks::Followed).map_err(refused)?;
    opened.save(&document).map_err(|error| one(error.to_string()))?;
    *edited = document;
    Ok(path)
}

fn problem(file: String, found: String, expected: &str) -> Problem {
    Problem { file, line: 0, column: String::new(), found, expected: expected.to_owned() }
}

/// The medals that no flight earns, of the goals that each flight has reached.
fn beyond(flown: &[Vec<Goal>]) -> Vec<Problem> {
    let Some(first) = flown.first() else { return Vec::new() };
    let missed = first.iter().filter(|goal| {
        let same = flown.iter().flatten().filter(|other| other.prize == goal.prize);
        same.into_iter().all(|other| other.missing.is_some())
    });
    let found = |goal: &Goal| format!("a medal ({}) that no flight in {FLIGHTS} earns", goal.asks);
    let expected = "a flight that does, or a goal in reach of them";
    missed.map(|goal| problem("constants.csv".to_owned(), found(goal), expected)).collect()
}

fn unreadable(why: &dyn Display) -> String {
    format!("a file that cannot be read ({why})")
}

/// The goals that a flight reaches, and in words what it proves by its name.
type Reached = (Vec<Goal>, Option<String>);

fn fly(folder: &Path, name: &str, level: &Arc<Level>, left: &mut u64) -> Result<Reached, (String, &'static str)> {
    let readable = "a flight that can be read";
    let text = read_text(&folder.join(name), files::INPUTS).map_err(|error| (unreadable(&error), readable))?;
    let replay = Replay::parse(name, &text).map_err(|bad| (unreadable(&bad.0.into_iter().next().unwrap_or_default()), readable))?;
    let ticks = replay.inputs.ticks();
    *left = left.checked_sub(ticks).ok_or_else(|| {
        (format!("{ticks} ticks, too many to be flown here"), "flights of two hours together, or `resultant verify`")
    })?;
    earn(name.trim_end_matches(FLIGHT), replay, level)
}

fn earn(stem: &str, replay: Replay, level: &Arc<Level>) -> Result<Reached, (String, &'static str)> {
    let recorded = replay.level_hash;
    // With the level's own hash any version of the level flies: the first second that departs says more.
    let flown = Replay { level_hash: level_hash(level), ..replay };
    let mut last: Option<RunResult> = None;
    let note = |game: &Game| last = Some(game.result());
    let again = "a flight recorded in the level as it is";
    match flown.verify(level.clone(), note).map_err(|error| (error.to_string(), again))? {
        Err(mismatch) => return Err((format!("a flight that no longer holds: {mismatch}"), again)),
        Ok(()) if recorded != flown.level_hash => {
            return Err(("a flight of another version of the level, though it leads where it did".to_owned(), again));
        }
        Ok(()) => {}
    }
    let goals = last.map(|result| goals(&level.awards, &result)).unwrap_or_default();
    let prize = PROVE.iter().find(|(file, _)| *file == stem).map(|(_, prize)| *prize);
    let Some(goal) = goals.iter().find(|goal| Some(goal.prize) == prize) else { return Ok((goals, None)) };
    let Goal { asks, missing, .. } = goal;
    if let Some(lacks) = missing {
        return Err((format!("a flight that does not earn what it is named by ({asks}): {lacks}"), "a flight that does"));
    }
    let proves = format!("{stem} ({asks})");
    Ok((goals, Some(proves)))
}

/// Bytes of memory a byte of a table, for reading, checks and building: `/usr/bin/time` shows 29 for tables of solids and objects at their limits.
const TABLE: u64 = 32;
/// Bytes of memory a byte of a flight, with some room. Only one flight is in memory at a time.
const EACH_FLIGHT: u64 = 6;
/// Bytes a pixel: unpacked, as a texture and as a graphics driver's copy, 4 bytes each; or at 16 bits a channel while it is unpacked.
const PIXEL: u64 = 12;
const DEEP_PIXEL: u64 = 8;
/// A PNG's first bytes; then length and name of its head, width and height.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
const SIDES: usize = 16;

#[derive(Debug, Default)]
pub(super) struct Cost {
    /// The archive and its unpacked files.
    files: u64,
    tables: u64,
    largest_flight: u64,
    pixels: u64,
    most_pixels: u64,
}

impl Cost {
    /// Bytes of a file that tell its cost.
    pub const HEAD: u64 = 24;

    pub fn of_archive(packed: u64) -> Self {
        Self { files: packed, ..Self::default() }
    }

    pub fn add(&mut self, path: &str, size: u64, head: &[u8]) {
        self.files = self.files.saturating_add(size);
        if path.to_lowercase().ends_with(FLIGHT) {
            self.largest_flight = self.largest_flight.max(size);
        } else if path.rsplit('/').next().is_some_and(|name| FILES.contains(&name)) {
            // The size of a larger one refuses it.
            self.tables += size.min(files::LEVEL_TABLE);
        }
        if let Some(pixels) = pixels(head) {
            self.pixels = self.pixels.saturating_add(pixels);
            self.most_pixels = self.most_pixels.max(pixels);
        }
    }

    pub fn bytes(&self) -> u64 {
        let Self { files, tables, largest_flight, pixels, most_pixels } = *self;
        let pictures = pixels.saturating_mul(PIXEL).saturating_add(most_pixels.saturating_mul(DEEP_PIXEL));
        files.saturating_add(tables * TABLE).saturating_add(largest_flight.saturating_mul(EACH_FLIGHT)).saturating_add(pictures)
    }
}

fn pixels(head: &[u8]) -> Option<u64> {
    let side = |at: usize| Some(u64::from(u32::from_be_bytes(*head.get(at..)?.first_chunk()?)));
    if head.starts_with(SIGNATURE) { Some(side(SIDES)?.saturating_mul(side(SIDES + 4)?)) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(width: u32, height: u32) -> Vec<u8> {
        [SIGNATURE, b"\0\0\0\x0dIHDR", &width.to_be_bytes(), &height.to_be_bytes()].concat()
    }

    #[test]
    fn each_kind_of_file_costs_what_it_becomes() {
        let one = |path: &str, size: u64, head: &[u8]| {
            let mut cost = Cost::default();
            cost.add(path, size, head);
            cost.bytes()
        };
        assert_eq!(one("t/notes.txt", 100, b""), 100);
        assert_eq!(one("t/world.csv", 100, b""), 100 + 100 * TABLE);
        assert_eq!(one("t/flights/a.replay.csv", 100, b""), 100 + 100 * EACH_FLIGHT);
        assert_eq!(one("t/a.png", 100, &head(1000, 500)), 100 + 500_000 * (PIXEL + DEEP_PIXEL));
        assert_eq!(one("t/a.png", 100, &head(u32::MAX, u32::MAX)), u64::MAX);
        assert_eq!((one("t/a.png", 9, b"no picture"), one("t/a.png", 9, SIGNATURE)), (9, 9));
    }

    #[test]
    fn of_several_flights_and_pictures_one_at_a_time_is_read() {
        let mut cost = Cost::of_archive(1000);
        for path in ["t/flights/a.replay.csv", "t/flights/b.replay.csv"] {
            cost.add(path, 10, b"");
        }
        cost.add("t/a.png", 1, &head(10, 10));
        cost.add("t/b.png", 1, &head(20, 10));
        assert_eq!(cost.bytes(), 1000 + 20 + 10 * EACH_FLIGHT + 2 + 300 * PIXEL + 200 * DEEP_PIXEL);
    }
}
