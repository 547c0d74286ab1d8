//! `resultant verify --scores`: flies the flight of every row of every leaderboard again, and names the rows that do not hold.

use super::{Project, Readers, Status, Stop, shown};
use crate::classics::jumper::scene::LEADERBOARD;
use crate::game::level_hash;
use crate::level::{self, Level};
use crate::scores::{Board, Claim, Doubt, Scores, Standing};
use std::io::{self, Write};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// How long a flight is flown without a word, and how long from one word to the next.
const SILENCE: Duration = Duration::from_secs(2);
/// How often the clock is asked, ticks: asking it must not count.
const TICKS_A_LOOK: u64 = 4096;

/// Verifies all boards: a line for each goes to `out`, with how many of its rows are proven; a line for each row that does not hold goes to
/// standard error.
///
/// # Errors
/// The results cannot be written.
pub fn run(project: &Project, out: &mut dyn Write) -> Result<Status, Stop> {
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
    Ok(status)
}

/// Judges a level's board; whether all of it holds.
fn judge_board(project: &Project, scores: &Scores, name: &str, (out, err): (&mut dyn Write, &mut dyn Write)) -> Result<bool, Stop> {
    let level = match level::load(&project.levels().join(name), project.root()) {
        Ok(loaded) => Ok(Arc::new(loaded.level)),
        Err(problems) => Err(problems.first().map(ToString::to_string).unwrap_or_default()),
    };
    let shown_name = shown(name);
    let loaded = match &level {
        Ok(level) => scores.load_version(name, level_hash(level)),
        Err(_) => scores.load(name).map(|loaded| (loaded, 0)),
    };
    let (loaded, others) = match loaded {
        Ok(loaded) => loaded,
        Err(error) => {
            writeln!(err, "{shown_name}: {}", shown(error))?;
            return Ok(false);
        }
    };
    for damage in &loaded.damage {
        writeln!(err, "{}", shown(damage))?;
    }
    let (mut proven, mut without, mut doubtful) = (0, 0, 0);
    for (index, row) in loaded.board.rows().iter().enumerate() {
        let called = format!("{shown_name}: rank {}, {}, {} points", index + 1, row.name, row.score);
        match judge(scores, name, &loaded.board, index, (&level, &called, err))? {
            Standing::Proven => proven += 1,
            Standing::NoFlight => without += 1,
            Standing::Doubtful(doubt) => {
                doubtful += 1;
                writeln!(err, "{called}: does not hold: {}", shown(doubt))?;
            }
        }
    }
    write!(out, "{shown_name}: {proven} proven")?;
    if without > 0 {
        write!(out, ", {without} without a flight")?;
    }
    if doubtful > 0 {
        write!(out, ", {doubtful} not")?;
    }
    if others > 0 {
        write!(out, "; {others} boards of other versions of the level aside")?;
    }
    writeln!(out)?;
    Ok(doubtful == 0 && loaded.damage.is_empty())
}

/// What comes of flying a row again; of a long flight it is said from time to time how far it is.
fn judge(
    scores: &Scores,
    name: &str,
    board: &Board,
    index: usize,
    (level, called, err): (&Result<Arc<Level>, String>, &str, &mut dyn Write),
) -> Result<Standing, Stop> {
    let origin = board.origin(index);
    let flight = match (scores.flight(name, &origin), level) {
        (None, _) => return Ok(Standing::NoFlight),
        (Some(_), Err(problem)) => return Ok(Standing::Doubtful(Doubt::Level(problem.clone()))),
        (Some(Err(problem)), Ok(_)) => return Ok(Standing::Doubtful(Doubt::Unreadable(problem))),
        (Some(Ok(flight)), Ok(level)) => (flight, level.clone()),
    };
    let ticks = flight.0.inputs.ticks();
    let mut claim = match Claim::new(&board.rows()[index], &origin, flight.0, flight.1) {
        Ok(claim) => claim,
        Err(doubt) => return Ok(Standing::Doubtful(doubt)),
    };
    let mut last = Instant::now();
    loop {
        if let Some(verdict) = claim.step() {
            return Ok(verdict.map_or_else(Standing::Doubtful, |()| Standing::Proven));
        }
        if claim.ticks().is_multiple_of(TICKS_A_LOOK) && last.elapsed() >= SILENCE {
            last = Instant::now();
            writeln!(err, "{called}: {} of {ticks} ticks flown", claim.ticks())?;
        }
    }
}
