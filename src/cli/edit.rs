//! `resultant edit LEVEL`: opens the editor.

use super::project::Project;
use super::stop::{CommandError, Status};
use std::ffi::OsString;
use std::io::Write;

#[derive(clap::Args, Debug)]
pub struct EditArgs {
    /// A name under levels/, or a level's folder
    pub level: OsString,
    /// Edit a level that comes with the game itself, and not a copy of it
    #[arg(long)]
    pub original: bool,
}

/// Returns when the window is closed.
/// Errors: no such level; no display.
#[cfg(feature = "window")]
pub fn run(args: &EditArgs, project: &Project, _out: &mut dyn Write) -> Result<Status, CommandError> {
    use crate::screens::Editor;
    use crate::window::Start;
    let folder = project.level_folder(&args.level)?;
    // A level that does not open is refused before a window opens.
    let name = Editor::open(&folder, project.root()).map_err(CommandError::Refused)?.name().to_owned();
    super::play::show(project, Some(Start::Edit(folder, name, args.original)))
}

#[cfg(not(feature = "window"))]
pub fn run(args: &EditArgs, project: &Project, _out: &mut dyn Write) -> Result<Status, CommandError> {
    project.level_folder(&args.level)?;
    Err(CommandError::Refused("this build of resultant has no window: see --help for what it does without one".into()))
}
