//! The levels on disk, as the screens list them, the tile run's map and commands, the charts that were measured here, and experiments.
//! Also a new file in a folder, whole or not at all, that never takes the place of another one, and an attempt at a level with its record.

use super::folder_watch::FolderWatch;
use crate::classics::tile_run::{Command, Map};
use crate::files::{self, CHART, CsvFile, CsvRow, EXPERIMENTS, TILE_COMMANDS, TILE_MAP, read_text};
use crate::game::{History, Inputs, Replay};
use crate::lab::{charts::Charts, kept};
use crate::level::{self, Landscape, Level};
use crate::{instruments::reading::Wanted, words::tr};
use std::path::{Path, PathBuf};
use std::{io, sync::Arc};

/// Where the tile run's `map.txt` and `commands.txt` are, from the project's root.
const TILE_RUN: &str = "assets/tile_run";

/// The columns of their list, the first of which are needed.
const EXPERIMENT: [&str; 7] = ["folder", "question", "vary", "answer", "choices", "right", "readings"];
const NEEDED: usize = 4;

/// Where `resultant chart` writes, from the project's root.
const CHARTS: &str = "charts";

pub fn named(name: &str) -> String {
    tr!("level {name}", name)
}

/// Why a level cannot be played: a line a problem.
pub type Refusal = Vec<String>;

#[derive(Clone, Debug, Default)]
pub struct Shown {
    /// Empty where no run could be read.
    pub charts: Charts,
    pub kept: bool,
    pub problem: Option<String>,
}

/// The folder of levels and the folder that their image paths start from.
#[derive(Clone, Debug)]
pub struct Library {
    root: PathBuf,
    levels: PathBuf,
    /// A level's folder that is not one of `levels`, while that level is played or edited.
    outside: Option<PathBuf>,
    /// The level of a folder as the worker has read it, for the screen that opens: [`Library::load`] reads no file then.
    pub prepared: Option<(PathBuf, Result<Arc<Level>, Refusal>)>,
}

impl Library {
    pub fn new(root: impl Into<PathBuf>, levels: impl Into<PathBuf>) -> Self {
        Self { root: root.into(), levels: levels.into(), outside: None, prepared: None }
    }

    /// The names of all levels, those named by a number first and in numeric order. A folder that cannot be read holds none.
    pub fn names(&self) -> Vec<String> {
        level::list(&self.levels)
    }

    pub fn after(&self, name: &str) -> Option<String> {
        self.names().into_iter().skip_while(|other| other != name).nth(1)
    }

    pub fn root(&self) -> &Path {
        &self.root
    }

    pub fn levels(&self) -> &Path {
        &self.levels
    }

    pub fn folder(&self, name: &str) -> PathBuf {
        let outside = self.outside.iter().find(|folder| folder.file_name().is_some_and(|own| own.to_string_lossy() == name));
        outside.cloned().unwrap_or_else(|| self.levels.join(name))
    }

    /// Lets a folder outside of `levels` be the level of its name, until the next call; the name. A file stands for its folder.
    pub fn open(&mut self, path: &Path) -> Option<String> {
        let folder = files::resolve(if files::is_folder(path) { path } else { path.parent()? }).ok()?;
        let name = folder.file_name()?.to_string_lossy().into_owned();
        let listed = files::resolve(&self.levels.join(&name)).is_ok_and(|listed| listed == folder);
        self.outside = (!listed).then_some(folder);
        Some(name)
    }

    /// Every name means a level in `levels` again.
    pub fn close(&mut self) {
        self.outside = None;
    }

    /// A level's title, without loading it; its name where it has none.
    pub fn title(&self, name: &str) -> String {
        level::title(&self.levels.join(name)).unwrap_or_else(|| name.to_owned())
    }

    /// The world of a level that comes with the game.
    pub fn landscape(&self, name: &str) -> Option<Landscape> {
        level::landscape(&self.levels.join(name))
    }

    /// What a level's folder and its pictures look like from the outside.
    pub fn watch(&self, level: &Level) -> FolderWatch {
        let folder = self.folder(&level.name);
        FolderWatch::new(folder, level.pictures().cloned().collect())
    }

    /// Reads a level. Errors: all its problems, a line each.
    pub fn load(&self, name: &str) -> Result<Arc<Level>, Refusal> {
        let folder = self.folder(name);
        if let Some((_, level)) = self.prepared.as_ref().filter(|(known, _)| *known == folder) {
            return level.clone();
        }
        load(&folder, &self.root)
    }

    /// The experiments, as the `experiments.csv` of their folder lists them. Errors: the list is missing or damaged.
    pub fn experiments(&self) -> Result<Vec<Experiment>, String> {
        let folder = self.root.join(EXPERIMENTS);
        let list = format!("{EXPERIMENTS}/experiments.csv");
        let text = read_text(&folder.join("experiments.csv"), files::LEVEL_TABLE).map_err(|error| format!("{list}: {error}"))?;
        let file = CsvFile { name: &list, columns: &EXPERIMENT, comments: true };
        let experiment = |row: CsvRow<'_>| {
            if row.fault().is_some() || !(NEEDED..=EXPERIMENT.len()).contains(&row.used()) {
                return Err(row.row_problem(format_args!("{:?}", row.joined()), file.header()));
            }
            let [folder_name, question, vary, answer, choices, right, readings] =
                EXPERIMENT.map(|column| row.get(column).to_owned());
            let choices: Vec<String> = choices.split('|').map(|choice| choice.trim().to_owned()).collect();
            let choices = if choices.len() > 1 { choices } else { Vec::new() };
            let is_right = if choices.is_empty() { Wanted::new(&question, &right).is_some() } else { choices.contains(&right) };
            if !right.is_empty() && !is_right {
                return Err(row.bad_cell("right", tr("a number, one of the choices, or nothing")));
            }
            let title = level::title(&folder.join(&folder_name)).unwrap_or_else(|| folder_name.clone());
            let Some(readings) = Wanted::all(&readings) else {
                return Err(row.bad_cell("readings", tr("quantities, as in \"height: 2.5 m|time: 1.4 s\"")));
            };
            Ok(Experiment { folder: folder_name, question, vary, answer, choices, right, readings, title })
        };
        file.rows(text.as_bytes()).filter(|row| !row.is_header(NEEDED)).map(experiment).collect()
    }

    pub fn experiment(&self, name: &str) -> PathBuf {
        self.root.join(EXPERIMENTS).join(name)
    }

    /// The map of the tile run and the commands to watch, from `assets/tile_run/`. Errors: the first problem, with file and line.
    pub fn tile_run(&self) -> Result<(Map, Vec<Command>), String> {
        let folder = self.root.join(TILE_RUN);
        Ok((
            read(folder.join("map.txt"), TILE_MAP, Map::parse)?,
            read(folder.join("commands.txt"), TILE_COMMANDS, Command::parse_all)?,
        ))
    }

    /// The charts in `charts/`, where the last `resultant chart` wrote them; where there are none, or they cannot be read, those that
    /// came with the game.
    pub fn charts(&self) -> Shown {
        let folder = self.root.join(CHARTS);
        let problem = match files::look(&folder).is_ok().then(|| Charts::read(|file| text(&folder, file))) {
            Some(Ok(charts)) => return Shown { charts, kept: false, problem: None },
            Some(Err(problem)) => Some(tr!("{folder}/{problem}. These came with the game.", folder = CHARTS, problem)),
            None => None,
        };
        match kept::charts() {
            Ok(charts) => Shown { charts, kept: true, problem },
            Err(problem) => Shown { charts: Charts::default(), kept: true, problem: Some(problem) },
        }
    }
}

fn read<T>(path: PathBuf, at_most: u64, parse: impl Fn(&str) -> Result<T, String>) -> Result<T, String> {
    let text = read_text(&path, at_most).map_err(|error| format!("{}: {error}", path.display()))?;
    parse(&text).map_err(|error| format!("{}:{error}", path.display()))
}

/// As [`Library::load`].
pub fn load(folder: &Path, root: &Path) -> Result<Arc<Level>, Refusal> {
    level::load(folder, root).map(|loaded| Arc::new(loaded.level)).map_err(|problems| level::listed(&problems))
}

fn text(folder: &Path, file: &str) -> Result<String, String> {
    read_text(&folder.join(file), CHART).map_err(|error| format!("{file}: {error}"))
}

pub fn is_of_level(path: &Path) -> bool {
    files::is_folder(path)
        || path.extension().is_some_and(|ending| ["csv", "png"].iter().any(|own| ending.eq_ignore_ascii_case(own)))
}

/// Hands a file of the player's to the browser's downloads; elsewhere it lies where the player finds it.
#[cfg(all(feature = "window", browser))]
pub fn hand_out(path: &Path) {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if let Ok(bytes) = files::read(path, files::SCORES) {
        crate::web::download(&name, &bytes);
    }
}

#[cfg(not(all(feature = "window", browser)))]
pub const fn hand_out(_: &Path) {}

const MOST_OF_A_NAME: u32 = 10_000;

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewFile {
    /// Its name up to a number, which it gets where there is one already.
    pub stem: String,
    /// Its name from there on, with the full stop.
    pub ending: &'static str,
    pub bytes: Vec<u8>,
    /// What it is, for messages: "the flight".
    pub what: &'static str,
    /// One with these very bytes will do, where it is no larger than that.
    pub same_up_to: u64,
}

impl NewFile {
    /// Writes it into a folder, which is made where there is none; the answer is where.
    /// Errors: whatever the system refuses, with the place. Nothing is left behind then.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, String> {
        if let Some(path) = self.handed_out(folder) {
            return Ok(path);
        }
        let refused = |path: &Path, error: &io::Error| {
            tr!("{path}: cannot keep {what}: {error}", path = path.display(), what = self.what, error)
        };
        files::make_folder(folder).map_err(|error| refused(folder, &error))?;
        for number in 1..=MOST_OF_A_NAME {
            let count = if number > 1 { format!("-{number}") } else { String::new() };
            let path = folder.join(format!("{}{count}{}", self.stem, self.ending));
            if files::read(&path, self.same_up_to).is_ok_and(|kept| kept == self.bytes) {
                return Ok(path);
            }
            match files::create(&path, &self.bytes) {
                Ok(()) => return Ok(path),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(refused(&path, &error)),
            }
        }
        Err(tr!("{path}: there are too many files of that name", path = folder.display()))
    }

    /// A page has no folder that the player could open: the browser puts the file among the downloads.
    #[cfg(all(feature = "window", browser))]
    fn handed_out(&self, folder: &Path) -> Option<PathBuf> {
        let name = format!("{}{}", self.stem, self.ending);
        crate::web::download(&name, &self.bytes);
        Some(folder.join(name))
    }

    #[cfg(not(all(feature = "window", browser)))]
    const fn handed_out(&self, _: &Path) -> Option<PathBuf> {
        None
    }
}

#[derive(Clone, Debug)]
pub struct Attempt {
    pub level: Arc<Level>,
    /// Recorded inputs, played from the first tick on.
    pub inputs: Option<Arc<Inputs>>,
    pub rivals: Vec<Rival>,
}

impl Attempt {
    pub const fn by_hand(level: Arc<Level>) -> Self {
        Self { level, inputs: None, rivals: Vec::new() }
    }
}

#[derive(Clone, Debug)]
pub struct Flown {
    pub level: Arc<Level>,
    pub replay: Replay,
    pub history: History,
}

#[derive(Clone, Debug)]
pub struct Rival {
    /// Whose it is, in a word or two.
    pub name: String,
    pub inputs: Arc<Inputs>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Experiment {
    pub folder: String,
    pub question: String,
    pub vary: String,
    pub answer: String,
    /// The predictions to choose from; none: one is written.
    pub choices: Vec<String>,
    /// The right choice, or a number with its unit; empty where neither is.
    pub right: String,
    pub readings: Vec<Wanted>,
    pub title: String,
}

impl Experiment {
    /// Whether a prediction is right; `None` where the experiment has no right one, or the text none that could be.
    pub fn judge_prediction(&self, text: &str) -> Option<bool> {
        if !self.choices.is_empty() {
            return self.choices.iter().any(|choice| choice == text).then(|| text == self.right);
        }
        self.predicted()?.judge(text)
    }

    pub fn predicted(&self) -> Option<Wanted> {
        if self.choices.is_empty() { Wanted::new(&self.question, &self.right) } else { None }
    }
}
