//! The levels and experiments that ship, and the flights that are recorded with them.

use resultant::game::Replay;
use resultant::level::{self, Level};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

pub fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

pub fn load(name: &str) -> Arc<Level> {
    load_from(&project().join("levels").join(name))
}

pub fn experiment(name: &str) -> Arc<Level> {
    load_from(&project().join("experiments").join(name))
}

fn load_from(folder: &Path) -> Arc<Level> {
    let loaded = level::load(folder, project()).unwrap_or_else(|problems| panic!("{}: {problems:?}", folder.display()));
    assert!(loaded.warnings.is_empty(), "{}: {:?}", folder.display(), loaded.warnings);
    Arc::new(loaded.level)
}

pub fn experiments() -> Vec<String> {
    let names = level::list(&project().join("experiments"));
    assert!(names.len() >= 12, "{names:?}");
    names
}

pub fn levels() -> Vec<String> {
    let names = level::list(&project().join("levels"));
    assert!(names.len() >= 3, "{names:?}");
    names
}

/// The flights of a level, by their names.
pub fn flights(name: &str) -> BTreeMap<String, Replay> {
    let folder = project().join("levels").join(name).join("flights");
    let files = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let flight = |path: PathBuf| {
        let file = path.file_name().unwrap().to_str().unwrap();
        let flight = file.strip_suffix(".replay.csv").unwrap_or_else(|| panic!("{}: no record", path.display()));
        let replay = Replay::parse(file, &std::fs::read_to_string(&path).unwrap()).unwrap_or_else(|problems| panic!("{problems}"));
        (flight.to_owned(), replay)
    };
    files.map(|entry| flight(entry.unwrap().path())).collect()
}

/// A flight of a level by its name.
pub fn record(level: &str, flight: &str) -> Replay {
    flights(level).remove(flight).unwrap_or_else(|| panic!("level {level} has no flight {flight}"))
}
