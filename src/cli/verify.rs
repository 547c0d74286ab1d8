//! `resultant verify`: flies recorded runs again and compares where they lead.

use super::project::Project;
use super::stop::{CommandError, Readers, Silence, Status, TICKS_A_LOOK, shown};
use super::verify_scores;
use crate::files::{self, INPUTS};
use crate::game::{Mismatch, PROGRAM, Replay};
use crate::level::Level;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;

/// Bytes: a shorter word is the name of a file.
const SHORTEST_CODE: usize = 80;

#[derive(clap::Args, Debug)]
pub struct VerifyArgs {
    /// Recorded runs, as `run --record` writes them, or codes of flights
    #[arg(required_unless_present = "scores", value_name = "REPLAY")]
    replays: Vec<PathBuf>,
    /// Fly the flight of every saved score again, and name the rows that do not hold
    #[arg(long, conflicts_with = "replays")]
    scores: bool,
}

/// A line for each replay that holds goes to `out`; mismatches and the progress of long flights go to standard error.
/// Errors: a replay that cannot be read, or whose level is refused; none is flown then.
pub fn run(args: &VerifyArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    if args.scores {
        return verify_scores::run(project, out);
    }
    let (mut replays, mut problems) = (Vec::new(), Vec::new());
    for path in &args.replays {
        let name = short(&shown(path.display()));
        match read(project, path) {
            Ok((replay, level)) => replays.push((name, replay, level)),
            Err(CommandError::Refused(problem)) => problems.push(problem),
            Err(other) => return Err(other),
        }
    }
    if !problems.is_empty() {
        return Err(CommandError::Refused(problems.join("\n")));
    }

    let mut status = Status::Done;
    let mut err = Readers::of(io::stderr().lock());
    for (name, replay, level) in replays {
        match fly(&name, &replay, level, &mut err)? {
            Ok(()) => {
                let player = replay.player.map(|player| format!("; saved by {}", shown(player))).unwrap_or_default();
                write!(out, "{name}: ok, score {}, hash {:016x}", replay.score, replay.hash)?;
                writeln!(out, "; level {}, {} ticks{player}", shown(replay.level), replay.inputs.ticks())?;
            }
            Err(mismatch) => {
                let by = Some(replay.program).filter(|program| program != PROGRAM);
                let by = by.map(|program| format!("; recorded by {}, this is {PROGRAM}", shown(program))).unwrap_or_default();
                writeln!(err, "{name}: {mismatch}{by}")?;
                status = Status::Wrong;
            }
        }
    }
    Ok(status)
}

/// A code in a message: its beginning.
fn short(name: &str) -> String {
    let begin: String = name.chars().take(SHORTEST_CODE / 2).collect();
    if name.len() < SHORTEST_CODE || name.contains(['/', '.', '\\']) { name.to_owned() } else { format!("{begin}…") }
}

/// Flies a record and reports the progress from time to time.
fn fly(name: &str, replay: &Replay, level: Arc<Level>, err: &mut dyn Write) -> Result<Result<(), Mismatch>, CommandError> {
    let (ticks, mut silence) = (replay.inputs.ticks(), Silence::new());
    let flown = replay.verify(level, |game| {
        if game.ticks().is_multiple_of(TICKS_A_LOOK) && silence.is_over() {
            // A closed standard error does not stop the verification.
            let _ = writeln!(err, "{name}: {} of {ticks} ticks flown", game.ticks());
        }
    });
    flown.map_err(|error| CommandError::Refused(format!("{name}: {error}")))
}

fn read(project: &Project, path: &std::path::Path) -> Result<(Replay, Arc<Level>), CommandError> {
    let code = path.to_str().filter(|text| text.len() >= SHORTEST_CODE && !files::is_file(&project.input(path)));
    let replay = match code {
        Some(code) => {
            Replay::from_code(code).map_err(|problem| CommandError::Refused(format!("the code {}: {problem}", short(code))))?
        }
        None => Replay::parse(&path.display().to_string(), &project.read_text(path, INPUTS)?).map_err(CommandError::refused)?,
    };
    let named = |stop| match stop {
        CommandError::Refused(problem) => CommandError::Refused(format!("{}: {problem}", shown(path.display()))),
        other => other,
    };
    let level = project.recorded_level(&replay.level).and_then(|folder| project.load_folder(&folder)).map_err(named)?;
    Ok((replay, level))
}
