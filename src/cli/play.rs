//! `resultant` and `resultant play LEVEL`: opens the game.

use super::project::Project;
use super::{CommandError, Status};
#[cfg(feature = "window")]
use crate::cli::shown;
#[cfg(feature = "window")]
use crate::files::INPUTS;
#[cfg(feature = "window")]
use crate::game::Inputs;
#[cfg(feature = "window")]
use crate::level;
#[cfg(feature = "window")]
use crate::screens::Places;
#[cfg(feature = "window")]
use crate::session::library::Attempt;
#[cfg(feature = "window")]
use crate::window::{Start, open};
use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
#[cfg(feature = "window")]
use std::{ffi::OsStr, path::Path, sync::Arc};

#[derive(clap::Args, Debug, Default)]
pub struct PlayArgs {
    /// A name under levels/, or a level's folder; without it the game opens with its menu
    pub level: Option<OsString>,
    /// Play these recorded inputs instead of the keys, from the first tick on
    #[arg(long, value_name = "FILE", requires = "level")]
    pub inputs: Option<PathBuf>,
}

/// Returns when the window is closed. Errors: a refused level or inputs; a missing folder of levels; no display.
#[cfg(feature = "window")]
pub fn run(args: &PlayArgs, project: &Project, _out: &mut dyn Write) -> Result<Status, CommandError> {
    // A level that is named needs no others beside it.
    if args.level.is_none() && !crate::files::is_folder(&project.levels()) {
        let missing = project.levels();
        return Err(CommandError::Refused(format!(
            "there is no folder {}, which holds the game's levels: say with --data DIR where levels/ is",
            missing.display()
        )));
    }
    show(project, args.level.as_deref().map(|level| start(level, args.inputs.as_deref(), project)).transpose()?)
}

/// Returns when the window is closed.
#[cfg(feature = "window")]
pub fn show(project: &Project, start: Option<Start>) -> Result<Status, CommandError> {
    project.settle().into_iter().for_each(|line| drop(writeln!(std::io::stderr(), "{line}")));
    let (root, settings) = (project.root().to_path_buf(), project.settings_folder().join("settings.csv"));
    let places = Places { root, levels: project.levels(), scores: project.scores(), settings };
    open(places, start).map_err(CommandError::Refused)?;
    Ok(Status::Done)
}

/// Before a window opens. An unfinished level is tried out, with its problems on standard error.
#[cfg(feature = "window")]
fn start(level: &OsStr, inputs: Option<&Path>, project: &Project) -> Result<Start, CommandError> {
    let folder = project.level_folder(level)?;
    let loaded = match level::load(&folder, project.root()) {
        Ok(loaded) => loaded,
        Err(problems) => {
            let problems = level::listed(&problems);
            let lines: String = problems.iter().map(|problem| format!("{}/{problem}\n", shown(level.display()))).collect();
            let unfinished = level::load_unfinished(&folder, project.root()).ok().filter(|_| inputs.is_none());
            let Some(unfinished) = unfinished else { return Err(CommandError::Refused(lines)) };
            let _ =
                writeln!(std::io::stderr(), "{lines}{}: not finished yet, its flights count for nothing", shown(level.display()));
            return Ok(Start::Test(folder, Arc::new(unfinished.level), problems));
        }
    };
    let inputs = inputs
        .map(|file| Inputs::parse(&file.display().to_string(), &project.read_text(file, INPUTS)?).map_err(CommandError::refused));
    let attempt = Attempt { level: Arc::new(loaded.level), inputs: inputs.transpose()?.map(Arc::new), rivals: Vec::new() };
    Ok(Start::Play(folder, attempt))
}

#[cfg(not(feature = "window"))]
pub fn run(args: &PlayArgs, project: &Project, _out: &mut dyn Write) -> Result<Status, CommandError> {
    args.level.as_ref().map(|level| project.load_level(level)).transpose()?;
    Err(CommandError::Refused("this build of resultant has no window: see --help for what it does without one".into()))
}
