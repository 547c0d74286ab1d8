//! Flies the flights of a leaderboard again while it is looked at, a little in each frame: which of its rows are earned.

use crate::level::Level;
use crate::scores::{Board, Claim, Doubt, Scores, Standing};
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

/// How many ticks are flown in a frame, and where the frame before took longer than that, s: some ms.
const TICKS_A_FRAME: u64 = 300;
const TICKS_A_SLOW_FRAME: u64 = 60;
const SLOW_FRAME: f64 = 1.0 / 40.0;

/// What is known of the rows of one board.
#[derive(Debug)]
pub struct Prover {
    scores: Scores,
    level: Arc<Level>,
    standings: HashMap<usize, Standing>,
    /// The row whose flight is in the air.
    flown: Option<(usize, Box<Claim>)>,
}

impl Prover {
    /// Nothing is known yet of the rows of that level's board.
    pub fn new(scores: Scores, level: Arc<Level>) -> Self {
        Self { scores, level, standings: HashMap::new(), flown: None }
    }

    /// How a row stands; `None` as long as that is not known.
    pub fn standing(&self, row: usize) -> Option<&Standing> {
        self.standings.get(&row)
    }

    /// One frame, in which those rows are in view.
    pub fn update(&mut self, board: &Board, view: Range<usize>, frame_time: f64) {
        if frame_time <= 0.0 {
            return;
        }
        for _ in 0..if frame_time > SLOW_FRAME { TICKS_A_SLOW_FRAME } else { TICKS_A_FRAME } {
            let Some((row, claim)) = &mut self.flown else {
                let Some(next) = view.clone().find(|row| !self.standings.contains_key(row)) else { return };
                self.begin(board, next);
                // A file was read: enough for a frame.
                return;
            };
            if let Some(verdict) = claim.step() {
                let standing = verdict.map_or_else(Standing::Doubtful, |()| Standing::Proven);
                self.standings.insert(*row, standing);
                self.flown = None;
            }
        }
    }

    fn begin(&mut self, board: &Board, row: usize) {
        let origin = board.origin(row);
        let claim = match self.scores.flight(&self.level.name, &origin) {
            None => Err(Standing::NoFlight),
            Some(Err(problem)) => Err(Standing::Doubtful(Doubt::Unreadable(problem))),
            Some(Ok(flight)) => Claim::new(&board.rows()[row], &origin, flight, self.level.clone()).map_err(Standing::Doubtful),
        };
        match claim {
            Ok(claim) => self.flown = Some((row, Box::new(claim))),
            Err(standing) => drop(self.standings.insert(row, standing)),
        }
    }
}
