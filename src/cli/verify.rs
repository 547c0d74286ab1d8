//! `resultant verify`: flies recorded runs, or with `--scores` the flight of every row of every leaderboard, again, and names what does not hold.
//! `resultant code`: a recorded flight as one line of text, which `resultant verify` and the game's list of flights take.

use super::{CommandError, Readers, Silence, Status, TICKS_A_LOOK, project::Project, shown};
use crate::classics::jumper::LEADERBOARD;
use crate::files::{self, INPUTS};
use crate::game::{Mismatch, PROGRAM, Replay};
use crate::level::{self, Level};
use crate::scores::{LoadedBoard, Name, Scores, Standing, judge};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
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
pub fn verify_flights(args: &VerifyArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    if args.scores {
        return verify_scores(project, out);
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
        match fly(&name, &replay, level.clone(), &mut err)? {
            Ok(()) => {
                let player = replay.player.map(|player| format!("; saved by {}", shown(player))).unwrap_or_default();
                write!(out, "{name}: ok, score {}, hash {:016x}", replay.score, replay.hash)?;
                writeln!(out, "; level {}, {} ticks{player}", shown(&level.name), replay.inputs.ticks())?;
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

/// The flight of a file or of a code.
pub fn record(project: &Project, path: &Path) -> Result<Replay, CommandError> {
    let code = path.to_str().filter(|text| text.len() >= SHORTEST_CODE && !files::is_file(&project.input(path)));
    match code {
        Some(code) => {
            Replay::from_code(code).map_err(|problem| CommandError::Refused(format!("the code {}: {problem}", short(code))))
        }
        None => Replay::parse(&path.display().to_string(), &project.read_text(path, INPUTS)?).map_err(CommandError::refused),
    }
}

fn read(project: &Project, path: &Path) -> Result<(Replay, Arc<Level>), CommandError> {
    let replay = record(project, path)?;
    let named = |stop| match stop {
        CommandError::Refused(problem) => CommandError::Refused(format!("{}: {problem}", shown(path.display()))),
        other => other,
    };
    let level = project.flown_in(&replay).map_err(named)?;
    Ok((replay, level))
}

type Outputs<'a> = (&'a mut dyn Write, &'a mut dyn Write);

/// For each board a line with its number of proven rows goes to `out`; for each row that fails a line goes to standard error.
pub fn verify_scores(project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let scores = Scores::new(project.scores());
    let mut err = Readers::of(io::stderr().lock());
    let mut status = Status::Done;
    for name in scores.boards().into_iter().filter(|name| name != LEADERBOARD) {
        if !judge_board(project, &scores, &name, (out, &mut err))? {
            status = Status::Wrong;
        }
    }
    // The screens report a file that cannot be read.
    let players = scores.players().map(|(players, _)| players).unwrap_or_default();
    let claims: usize = players.all().iter().map(crate::scores::PlayerRecord::done).sum();
    if claims > 0 {
        writeln!(out, "players.csv: {claims} levels done, on the players' own word")?;
    }
    Ok(status)
}

/// The answer says whether all rows hold.
fn judge_board(project: &Project, scores: &Scores, name: &str, (out, err): Outputs<'_>) -> Result<bool, CommandError> {
    let shown_name = shown(name);
    let LoadedBoard { board, damage } = match scores.load(name) {
        Ok(loaded) => loaded,
        Err(error) => {
            writeln!(err, "{shown_name}: {}", shown(error))?;
            return Ok(false);
        }
    };
    for damage in &damage {
        writeln!(err, "{}", shown(damage))?;
    }
    let level = level::load(&project.levels().join(name), project.root());
    let level = level
        .map(|loaded| Arc::new(loaded.level))
        .map_err(|problems| problems.first().map(ToString::to_string).unwrap_or_default());
    let (mut silence, mut ticks) = (Silence::new(), 0_u64);
    let standings = judge(scores, name, level, &board, |row| {
        ticks += 1;
        if ticks.is_multiple_of(TICKS_A_LOOK) && silence.is_over() {
            // A closed standard error does not stop the judgement.
            let _ = writeln!(err, "{shown_name}: {row} of {} rows judged, {ticks} ticks flown", board.rows().len());
        }
    });
    let (mut proven, mut unproven, mut copies, mut doubtful) = (0, 0, 0, 0);
    for (index, (row, standing)) in board.rows().iter().zip(&standings).enumerate() {
        let place = format!("{shown_name}: rank {}, {}, {} points", index + 1, row.name, row.score);
        match standing {
            Standing::Proven => proven += 1,
            Standing::Unproven => unproven += 1,
            Standing::Copies(others) => {
                copies += 1;
                let others: Vec<&str> = others.iter().map(Name::as_str).collect();
                writeln!(err, "{place}: the same keys as the flight of {}", others.join(", "))?;
            }
            Standing::Doubtful(doubt) => {
                doubtful += 1;
                writeln!(err, "{place}: does not hold: {}", shown(doubt))?;
            }
        }
    }
    write!(out, "{shown_name}: {proven} proven")?;
    for (count, word) in [(unproven, "unproven"), (copies, "with the keys of another"), (doubtful, "not")] {
        if count > 0 {
            write!(out, ", {count} {word}")?;
        }
    }
    writeln!(out)?;
    Ok(copies == 0 && doubtful == 0 && damage.is_empty())
}

#[derive(clap::Args, Debug)]
pub struct CodeArgs {
    /// A recorded run, as `run --record` and the game write them
    replay: PathBuf,
}

/// Errors: a record that cannot be read, or that has no code.
pub fn write_code(args: &CodeArgs, project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let name = args.replay.display().to_string();
    let replay = record(project, &args.replay)?;
    let code = replay.code().map_err(|problem| CommandError::Refused(format!("{}: {problem}", shown(name))))?;
    writeln!(out, "{code}")?;
    Ok(Status::Done)
}
