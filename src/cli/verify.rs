//! `resultant verify`: flies recorded runs again and compares where they lead.

use super::files::read_text;
use super::{Project, Status, Stop, load_level};
use crate::game::Replay;
use crate::level::Level;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;

/// What to verify.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Recorded runs, as `run --record` writes them
    #[arg(required = true, value_name = "REPLAY")]
    replays: Vec<PathBuf>,
}

/// Verifies the replays: a line for each that holds goes to `out`, for each that does not to standard error.
///
/// # Errors
/// A replay that cannot be read, or whose level is refused; none is flown then.
pub fn run(args: &Args, project: &Project, out: &mut dyn Write) -> Result<Status, Stop> {
    let (mut replays, mut problems) = (Vec::new(), Vec::new());
    for path in &args.replays {
        let name = path.display().to_string();
        match read(project, path) {
            Ok((replay, level)) => replays.push((name, replay, level)),
            Err(Stop::Refused(problem)) => problems.push(problem),
            Err(other) => return Err(other),
        }
    }
    if !problems.is_empty() {
        return Err(Stop::Refused(problems.join("\n")));
    }

    let mut status = Status::Done;
    for (name, replay, level) in replays {
        match replay.verify(level).map_err(|error| Stop::Refused(format!("{name}: {error}")))? {
            Ok(()) => writeln!(out, "{name}: ok, score {}, hash {:016x}", replay.score, replay.hash)?,
            Err(mismatch) => {
                writeln!(io::stderr(), "{name}: {mismatch}")?;
                status = Status::Wrong;
            }
        }
    }
    Ok(status)
}

fn read(project: &Project, path: &std::path::Path) -> Result<(Replay, Arc<Level>), Stop> {
    let replay = Replay::parse(&path.display().to_string(), &read_text(path)?).map_err(Stop::refused)?;
    let level = load_level(project, &replay.level)?;
    Ok((replay, level))
}
