//! `resultant verify --scores`: flies the flight of every row of every leaderboard again, and names the rows that do not hold.

use super::project::Project;
use super::stop::{CommandError, Readers, Silence, Status, TICKS_A_LOOK, shown};
use crate::classics::jumper::scene::LEADERBOARD;
use crate::level;
use crate::scores::{LoadedBoard, Name, Scores, Standing, judge};
use std::io::{self, Write};
use std::sync::Arc;

/// Of results and of problems.
type Outputs<'a> = (&'a mut dyn Write, &'a mut dyn Write);

/// For each board a line with its number of proven rows goes to `out`; for each row that fails a line goes to standard error.
pub fn run(project: &Project, out: &mut dyn Write) -> Result<Status, CommandError> {
    let scores = Scores::new(project.scores());
    let mut err = Readers::of(io::stderr().lock());
    let mut status = Status::Done;
    for name in scores.boards() {
        if name == LEADERBOARD {
            continue;
        }
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
