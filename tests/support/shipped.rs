//! The levels and experiments that ship, and the flights that are recorded with them; levels that stay as they are.

use resultant::files::EXPERIMENTS;
use resultant::game::{Controls, Game, History, Replay};
use resultant::level::{self, Level};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

pub fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The tests' own project, with the levels 1, 2, 3 and 15 that change with no shipped level.
pub fn fixtures() -> PathBuf {
    project().join("tests/fixtures")
}

pub fn fixture(name: &str) -> Arc<Level> {
    load_from(&fixtures(), "levels", name)
}

pub fn load(name: &str) -> Arc<Level> {
    load_from(project(), "levels", name)
}

pub fn experiment(name: &str) -> Arc<Level> {
    load_from(project(), EXPERIMENTS, name)
}

fn load_from(root: &Path, of: &str, name: &str) -> Arc<Level> {
    let folder = root.join(of).join(name);
    let loaded = level::load(&folder, root).unwrap_or_else(|problems| panic!("{}: {problems:?}", folder.display()));
    assert!(loaded.warnings.is_empty(), "{}: {:?}", folder.display(), loaded.warnings);
    Arc::new(loaded.level)
}

pub fn experiments() -> Vec<String> {
    let names = level::list(&project().join(EXPERIMENTS));
    assert!(names.len() >= 12, "{names:?}");
    names
}

pub fn levels() -> Vec<String> {
    let names = level::list(&project().join("levels"));
    assert!(names.len() >= 3, "{names:?}");
    names
}

pub fn flights(name: &str) -> BTreeMap<String, Replay> {
    flights_from(project(), name)
}

fn flights_from(root: &Path, name: &str) -> BTreeMap<String, Replay> {
    let folder = root.join("levels").join(name).join("flights");
    let files = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let flight = |path: PathBuf| {
        let file = path.file_name().unwrap().to_str().unwrap();
        let flight = file.strip_suffix(".replay.csv").unwrap_or_else(|| panic!("{}: no record", path.display()));
        let replay = Replay::parse(file, &std::fs::read_to_string(&path).unwrap()).unwrap_or_else(|problems| panic!("{problems}"));
        (flight.to_owned(), replay)
    };
    files.map(|entry| flight(entry.unwrap().path())).collect()
}

/// Every flight that is recorded with a shipped level, by the names of both.
pub fn recorded() -> impl Iterator<Item = (Arc<Level>, String, Replay)> {
    let of_level = |name: String| {
        let level = load(&name);
        flights(&name).into_iter().map(move |(flight, replay)| (level.clone(), format!("level {name}, {flight}"), replay))
    };
    levels().into_iter().flat_map(of_level)
}

pub fn names(folder: &Path) -> Vec<String> {
    let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names.collect::<BTreeSet<_>>().into_iter().collect()
}

pub fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap().map(Result::unwrap) {
        let to = to.join(entry.file_name());
        if entry.path().is_dir() { copy(&entry.path(), &to) } else { _ = std::fs::copy(entry.path(), to).unwrap() }
    }
}

/// Copies a fixture with its flights into another project.
pub fn copy_fixture(name: &str, root: &Path) {
    copy(&fixtures().join("levels").join(name), &root.join("levels").join(name));
}

pub fn record(level: &str, flight: &str) -> Replay {
    flights_from(&fixtures(), level).remove(flight).unwrap_or_else(|| panic!("level {level} has no flight {flight}"))
}

/// The game that these keys lead to, a tick each, and how it got there.
pub fn flown(level: Arc<Level>, keys: impl IntoIterator<Item = Controls>) -> (Game, History) {
    let mut game = Game::new(level).unwrap();
    let mut history = History::new(&game);
    for controls in keys {
        game.step(controls);
        history.note(&game, controls);
    }
    (game, history)
}
