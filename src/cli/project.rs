use super::stop::{CommandError, shown};
use crate::files;
use crate::level::{self, Level};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// The folder with `assets/`, `levels/` and `scores/`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Project {
    root: PathBuf,
}

impl Project {
    /// `data` if it is given; else the first folder with `levels/` among the working directory, its parents, the executable's
    /// folder and the folder of the build; else the working directory, above the levels and assets that are built in.
    /// Errors: `data` is no folder.
    pub fn find(data: Option<&Path>) -> Result<Self, CommandError> {
        if let Some(data) = data {
            return if data.is_dir() {
                Ok(Self { root: data.to_path_buf() })
            } else {
                Err(CommandError::Refused(format!("--data {}: there is no such folder", data.display())))
            };
        }
        let executable = std::env::current_exe().ok().and_then(|path| path.parent().map(Path::to_path_buf));
        let package = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        let working = std::env::current_dir().ok();
        let above = working.iter().flat_map(|folder| folder.ancestors().skip(1).map(Path::to_path_buf));
        let others = executable.into_iter().chain([package]);
        let project = Self::first_with_levels([PathBuf::from(".")].into_iter().chain(above).chain(others));
        if !files::is_folder(&project.levels()) {
            files::ship_at(&project.root);
        }
        Ok(project)
    }

    fn first_with_levels(mut candidates: impl Iterator<Item = PathBuf>) -> Self {
        let root = candidates.find(|folder| files::is_folder(&folder.join("levels")));
        Self { root: root.unwrap_or_else(|| PathBuf::from(".")) }
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

    /// A name under `levels/`, or any folder.
    pub fn level_folder(&self, level: impl AsRef<Path>) -> Result<PathBuf, CommandError> {
        let level = level.as_ref();
        let listed = self.levels().join(level);
        // `.` and `..` are places, not names under levels/.
        let is_name = level.components().all(|part| matches!(part, Component::Normal(_)));
        if is_name && !level.as_os_str().is_empty() && files::is_folder(&listed) {
            return Ok(listed);
        }
        if files::is_folder(level) {
            return Ok(level.to_path_buf());
        }
        Err(CommandError::Refused(format!("no level {level:?}: neither {} nor {level:?} is a folder", shown(listed.display()))))
    }

    /// The folder of a record's level: right below `levels/`, because a record may come from a stranger.
    pub fn recorded_level(&self, level: &str) -> Result<PathBuf, CommandError> {
        let mut parts = Path::new(level).components();
        let own = matches!((parts.next(), parts.next()), (Some(Component::Normal(own)), None) if own == level);
        if !own || level.contains('\\') {
            let expected = "expected the plain name of a folder below levels/";
            return Err(CommandError::Refused(format!("found a record of the level {level:?}, {expected}")));
        }
        let folder = self.levels().join(level);
        if files::is_folder(&folder) {
            Ok(folder)
        } else {
            Err(CommandError::Refused(format!("no level {level:?}: {} is no folder", shown(folder.display()))))
        }
    }

    /// The error lists every problem.
    pub fn load_level(&self, name: impl AsRef<Path>) -> Result<Arc<Level>, CommandError> {
        self.load_folder(&self.level_folder(name)?)
    }

    /// The error lists every problem.
    pub fn load_folder(&self, folder: &Path) -> Result<Arc<Level>, CommandError> {
        let loaded =
            level::load(folder, &self.root).map_err(|problems| CommandError::Refused(level::listed(&problems).join("\n")))?;
        Ok(Arc::new(loaded.level))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_folder_with_levels_is_taken_and_data_goes_before_all() {
        let (bare, one, two) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        for folder in [&one, &two] {
            std::fs::create_dir(folder.path().join("levels")).unwrap();
        }
        let candidates = || [&bare, &one, &two].into_iter().map(|folder| folder.path().to_path_buf());
        assert_eq!(Project::first_with_levels(candidates()).root(), one.path());
        assert_eq!(Project::first_with_levels(candidates().take(1)).root(), Path::new("."));
        assert_eq!(Project::find(Some(bare.path())).unwrap().root(), bare.path());
        assert!(Project::find(Some(&bare.path().join("missing"))).is_err());
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
        assert!(
            matches!(project.recorded_level("8"), Err(CommandError::Refused(problem)) if problem.starts_with("no level \"8\""))
        );
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
