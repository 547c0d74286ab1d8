//! `resultant code`: a recorded flight as one line of text, which `resultant verify` and the game's list of flights take.

use super::project::Project;
use super::stop::{CommandError, Status, shown};
use crate::files::INPUTS;
use crate::game::Replay;
use std::io::Write;
use std::path::PathBuf;

#[derive(clap::Args, Debug)]
pub struct CodeArgs {
    /// A recorded run, as `run --record` and the game write them
    replay: PathBuf,
}

/// Errors: a record that cannot be read, or that has no code.
pub fn run(args: &CodeArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let name = args.replay.display().to_string();
    let replay = Replay::parse(&name, &project.read_text(&args.replay, INPUTS)?).map_err(CommandError::refused)?;
    let code = replay.code().map_err(|problem| CommandError::Refused(format!("{}: {problem}", shown(name))))?;
    writeln!(out, "{code}")?;
    Ok(Status::Done)
}
