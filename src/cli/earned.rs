//! `resultant verify --scores`: flies the flight of every row of every leaderboard again, and names the rows that do not hold.

use super::project::Project;
use super::stop::{CommandError, Readers, Silence, Status, TICKS_A_LOOK, shown};
use crate::classics::jumper::scene::LEADERBOARD;
use crate::game::level_hash;
use crate::level;
use crate::scores::{Board, Doubt, Judge, LoadedBoard, Scores, Standing};
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
    let level = level::load(&project.levels().join(name), project.root());
    let level = level.map_err(|problems| problems.first().map(ToString::to_string).unwrap_or_default());
    let shown_name = shown(name);
    let loaded = match &level {
        Ok(loaded) => scores.load_version(name, level_hash(&loaded.level)),
        Err(_) => scores.load(name).map(|loaded| (loaded, 0)),
    };
    let (LoadedBoard { board, damage }, others) = match loaded {
        Ok(loaded) => loaded,
        Err(error) => {
            writeln!(err, "{shown_name}: {}", shown(error))?;
            return Ok(false);
        }
    };
    for damage in &damage {
        writeln!(err, "{}", shown(damage))?;
    }
    let standings: Vec<Standing> = match level {
        Ok(loaded) => {
            let mut judge = Judge::new(scores.clone(), Arc::new(loaded.level), &board);
            judge_all(&mut judge, &board, &shown_name, err)?;
            board.rows().iter().filter_map(|row| judge.standing(&row.name).cloned()).collect()
        }
        Err(problem) => {
            let standing =
                |row| board.origin(row).flight.map_or(Standing::Unproven, |_| Standing::Doubtful(Doubt::Level(problem.clone())));
            (0..board.rows().len()).map(standing).collect()
        }
    };
    let holds = report(&board, &standings, &shown_name, (&mut *out, &mut *err))?;
    if others > 0 {
        write!(out, "; {others} boards of other versions of the level aside")?;
    }
    writeln!(out)?;
    Ok(holds && damage.is_empty())
}

/// The counts of a board's rows go to `out`, each row that fails to `err`. The answer says whether all rows hold.
fn report(board: &Board, standings: &[Standing], name: &str, (out, err): Outputs<'_>) -> io::Result<bool> {
    let (mut proven, mut unproven, mut doubtful) = (0, 0, 0);
    for (index, (row, standing)) in board.rows().iter().zip(standings).enumerate() {
        match standing {
            Standing::Proven => proven += 1,
            Standing::Unproven => unproven += 1,
            Standing::Doubtful(doubt) => {
                doubtful += 1;
                let doubt = shown(doubt);
                writeln!(err, "{name}: rank {}, {}, {} points: does not hold: {doubt}", index + 1, row.name, row.score)?;
            }
        }
    }
    write!(out, "{name}: {proven} proven")?;
    if unproven > 0 {
        write!(out, ", {unproven} unproven")?;
    }
    if doubtful > 0 {
        write!(out, ", {doubtful} not")?;
    }
    Ok(doubtful == 0)
}

/// Flies all flights of a board, and reports the progress from time to time.
fn judge_all(judge: &mut Judge, board: &Board, name: &str, err: &mut dyn Write) -> Result<(), CommandError> {
    let (mut silence, mut next) = (Silence::new(), 0);
    loop {
        while let Some(row) = judge.begin(board, next..board.rows().len()) {
            next = row + 1;
        }
        if !judge.flies() {
            return Ok(());
        }
        judge.fly(TICKS_A_LOOK);
        if silence.is_over() {
            let judged = board.rows().iter().filter(|row| judge.standing(&row.name).is_some()).count();
            writeln!(err, "{name}: {judged} of {} rows judged, {} ticks flown", board.rows().len(), judge.ticks())?;
        }
    }
}
