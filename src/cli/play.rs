//! `resultant` and `resultant play LEVEL`: opens the game.

use super::{Project, Status, Stop};
use std::io::Write;
use std::path::PathBuf;

/// What to open.
#[derive(clap::Args, Debug, Default)]
pub struct Args {
    /// A name under levels/, or a level's folder; without it the game opens with its menu
    pub level: Option<String>,
    /// Play these recorded inputs instead of the keys, from the first tick on
    #[arg(long, value_name = "FILE", requires = "level")]
    pub inputs: Option<PathBuf>,
}

/// Opens the game and returns when it is closed.
///
/// # Errors
/// This build has no window.
pub fn run(_args: &Args, _project: &Project, _out: &mut dyn Write) -> Result<Status, Stop> {
    Err(Stop::Refused("this build of resultant has no window: see --help for what it does without one".into()))
}
