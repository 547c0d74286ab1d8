use super::{CommandError, files::read_text, shown};
use crate::game::{Replay, level_hash};
use crate::level::{self, Level};
use crate::{files, pack};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// The folder that holds `scores/` and the player's own levels and flights. The shipped levels, experiments and assets are in it, or the
/// built-in ones lie beneath it. The settings lie in it too, but where the system has another folder for them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Project {
    root: PathBuf,
    settings_folder: PathBuf,
    /// The system knows no folder of the user's.
    homeless: bool,
}

impl Project {
    /// `data` if it is given; else the program's folder, where a file `portable` lies in it; else the working directory or the first folder above it
    /// with the levels of a game; else the system's folders for the user's files, or the working directory where it has none. Errors: `data` is no
    /// folder.
    pub fn find(data: Option<&Path>) -> Result<Self, CommandError> {
        if let Some(data) = data {
            return if data.is_dir() {
                Ok(Self::above_lessons(data.to_path_buf()))
            } else {
                Err(CommandError::Refused(format!("--data {}: there is no such folder", data.display())))
            };
        }
        let program = std::env::current_exe().ok().and_then(|path| path.parent().map(Path::to_path_buf));
        let portable = program.filter(|folder| files::is_file(&folder.join(PORTABLE)));
        let working = std::env::current_dir().ok();
        let above = working.iter().flat_map(|folder| folder.ancestors().skip(1).map(Path::to_path_buf));
        let mut places = [PathBuf::from(".")].into_iter().chain(above);
        if let (None, Some(root)) = (&portable, places.find(|folder| has_levels(folder))) {
            return Ok(Self::above_lessons(root));
        }
        let project = match (portable, users_folders()) {
            (Some(root), _) => Self::at(root),
            (None, Some([root, settings_folder])) => Self { root, settings_folder, homeless: false },
            (None, None) => Self { homeless: true, ..Self::at(PathBuf::from(".")) },
        };
        files::ship_at(&project.root);
        Ok(project)
    }

    /// The levels of that folder; experiments and assets that it lacks are the built-in ones.
    fn above_lessons(root: PathBuf) -> Self {
        files::ship_lessons_at(&root);
        Self::at(root)
    }

    fn at(root: PathBuf) -> Self {
        Self { settings_folder: root.clone(), root, homeless: false }
    }

    /// Makes the folder. A line says where that failed, or where the system names none.
    pub fn settle(&self) -> Vec<String> {
        let homeless = "the system names no home folder: all is kept in the working folder";
        let unmade = files::make_folder(&self.root)
            .err()
            .map(|error| format!("{}: {error}; nothing is kept until that folder can be made", self.root.display()));
        self.homeless.then(|| homeless.to_owned()).into_iter().chain(unmade).collect()
    }

    pub fn settings_folder(&self) -> &Path {
        &self.settings_folder
    }

    /// The start of image paths in level files.
    pub fn root(&self) -> &Path {
        &self.root
    }

    pub fn assets(&self) -> PathBuf {
        self.root.join("assets")
    }

    pub fn levels(&self) -> PathBuf {
        self.root.join("levels")
    }

    pub fn scores(&self) -> PathBuf {
        self.root.join("scores")
    }

    /// A name under `levels/`, such as `1` or `experiments/hooke`, or any folder.
    pub fn level_folder(&self, level: impl AsRef<Path>) -> Result<PathBuf, CommandError> {
        let level = level.as_ref();
        let listed = self.levels().join(level);
        if is_name(level) && files::is_folder(&listed) {
            return Ok(listed);
        }
        if files::is_folder(level) {
            return Ok(level.to_path_buf());
        }
        Err(CommandError::Refused(format!("no level {level:?}: neither {} nor {level:?} is a folder", shown(listed.display()))))
    }

    /// A file that a command reads: as it is named, or below the root, such as `assets/tile_run/map.txt`.
    pub fn input(&self, path: &Path) -> PathBuf {
        let below = self.root.join(path);
        if is_name(path) && !files::is_taken(path) && files::is_file(&below) { below } else { path.to_path_buf() }
    }

    /// Such a file's text. Messages name it as the user did. Errors: it cannot be read, is no regular one, too large, or no UTF-8.
    pub fn read_text(&self, path: &Path, at_most: u64) -> Result<String, CommandError> {
        read_text(path, &self.input(path), at_most)
    }

    /// The level in which a record was flown: by its name, or by its hash where another level has that name or none has.
    pub fn flown_in(&self, replay: &Replay) -> Result<Arc<Level>, CommandError> {
        let folder = self.recorded_level(&replay.level)?;
        let none = || CommandError::Refused(format!("no level {:?}: {} is no folder", replay.level, shown(folder.display())));
        let named = if files::is_folder(&folder) { self.load_folder(&folder) } else { Err(none()) };
        match named {
            Ok(level) if level_hash(&level) == replay.level_hash => Ok(level),
            other => pack::of_hash(replay.level_hash, &self.levels(), &self.root).map_or(other, Ok),
        }
    }

    /// Where a record's level would lie: right below `levels/`, because a record may come from a stranger.
    fn recorded_level(&self, level: &str) -> Result<PathBuf, CommandError> {
        let mut parts = Path::new(level).components();
        let own = matches!((parts.next(), parts.next()), (Some(Component::Normal(own)), None) if own == level);
        if !own || level.contains('\\') {
            let expected = "expected the plain name of a folder below levels/";
            return Err(CommandError::Refused(format!("found a record of the level {level:?}, {expected}")));
        }
        Ok(self.levels().join(level))
    }

    /// The error lists every problem.
    pub fn load_level(&self, name: impl AsRef<Path>) -> Result<Arc<Level>, CommandError> {
        self.load_folder(&self.level_folder(name)?)
    }

    pub fn load_folder(&self, folder: &Path) -> Result<Arc<Level>, CommandError> {
        let loaded =
            level::load(folder, &self.root).map_err(|problems| CommandError::Refused(level::listed(&problems).join("\n")))?;
        Ok(Arc::new(loaded.level))
    }
}

/// Whether it is a path below something: `.` and `..` are places.
fn is_name(path: &Path) -> bool {
    !path.as_os_str().is_empty() && path.components().all(|part| matches!(part, Component::Normal(_)))
}

/// Beside the program, this file makes the program's folder the place of all files.
const PORTABLE: &str = "portable";

/// Whether a folder's `levels/` is that of a game: another program's folder of that name holds no level.
fn has_levels(folder: &Path) -> bool {
    let levels = folder.join("levels");
    files::is_file(&levels.join("shipped.csv"))
        || files::names(&levels).is_ok_and(|names| names.iter().any(|name| files::is_file(&levels.join(name).join("player.csv"))))
}

/// For scores, levels and flights, and for the settings.
#[cfg(not(target_arch = "wasm32"))]
fn users_folders() -> Option<[PathBuf; 2]> {
    directories::ProjectDirs::from("", "", "Resultant")
        .map(|places| [places.data_dir(), places.config_dir()].map(Path::to_path_buf))
}

#[cfg(target_arch = "wasm32")]
fn users_folders() -> Option<[PathBuf; 2]> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_goes_before_all_and_a_folder_of_levels_has_a_level() {
        let data = tempfile::tempdir().unwrap();
        assert_eq!(Project::find(Some(data.path())).unwrap().root(), data.path());
        assert!(Project::find(Some(&data.path().join("missing"))).is_err());
        let levels = data.path().join("levels");
        std::fs::create_dir_all(levels.join("7")).unwrap();
        assert!(!has_levels(data.path()), "another program's levels");
        std::fs::write(levels.join("7/player.csv"), "").unwrap();
        assert!(has_levels(data.path()));
    }

    #[test]
    fn a_record_leads_nowhere_but_to_a_level() {
        let data = tempfile::tempdir().unwrap();
        for folder in ["levels/7/deep", "evil"] {
            std::fs::create_dir_all(data.path().join(folder)).unwrap();
        }
        let project = Project::find(Some(data.path())).unwrap();
        assert_eq!(project.recorded_level("7").unwrap(), data.path().join("levels").join("7"));
        let absolute = data.path().join("evil");
        for away in ["", ".", "..", "../evil", "7/..", "7/deep", "./7", "7/", "..\\evil", absolute.to_str().unwrap()] {
            let Err(CommandError::Refused(problem)) = project.recorded_level(away) else { panic!("{away:?} leads somewhere") };
            assert!(problem.contains("expected the plain name"), "{problem}");
        }
    }

    #[test]
    fn a_level_is_a_name_under_levels_or_a_folder() {
        let data = tempfile::tempdir().unwrap();
        let own = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(data.path().join("levels/7")).unwrap();
        let project = Project::find(Some(data.path())).unwrap();
        assert_eq!(project.level_folder("7").unwrap(), data.path().join("levels").join("7"));
        assert_eq!(project.level_folder(own.path().to_str().unwrap()).unwrap(), own.path());
        // A place is no name, even if levels/ has such a place.
        std::fs::create_dir_all(data.path().join("levels/7/flights")).unwrap();
        assert_eq!(project.level_folder(".").unwrap(), Path::new("."));
        for none in ["", "8"] {
            assert!(project.level_folder(none).is_err(), "{none:?}");
        }
        #[cfg(target_os = "linux")]
        {
            use std::os::unix::ffi::OsStrExt;
            let bytes = std::ffi::OsStr::from_bytes(b"h\xf6hle");
            std::fs::create_dir(own.path().join(bytes)).unwrap();
            assert_eq!(project.level_folder(own.path().join(bytes)).unwrap(), own.path().join(bytes));
        }
    }
}
