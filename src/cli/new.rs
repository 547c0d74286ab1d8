//! `resultant new NAME` makes a level folder that loads, for an author to change.

use super::project::Project;
use super::stop::{CommandError, Status};
use crate::level;
use std::io::Write;

#[derive(clap::Args, Debug)]
pub struct NewArgs {
    /// The level's name: up to 40 letters, digits, - and _
    pub name: String,
}

/// Errors: a name that no level can have, an existing folder, or the disk's; nothing is left behind.
pub fn run(args: &NewArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let NewArgs { name } = args;
    if let Err(fault) = level::judge_name(name) {
        return Err(CommandError::Refused(format!("a level cannot be named {name:?}: expected {}", fault.expected())));
    }
    let levels = project.levels();
    let folder = levels.join(name);
    let cannot = |why: String| CommandError::Refused(format!("cannot make {}: {why}", folder.display()));
    level::scaffold::judge(&levels, name).map_err(cannot)?;
    level::scaffold::make(&levels, name, &level::scaffold::files()).map_err(|error| cannot(error.to_string()))?;
    writeln!(out, "{}", folder.display())?;
    Ok(Status::Done)
}
