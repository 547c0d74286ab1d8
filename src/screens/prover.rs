//! Judges the rows of a leaderboard while it is looked at, a little in each frame.

use crate::game::Medals;
use crate::level::Level;
use crate::scores::{Board, Judge, Name, Scores, Standing};
use std::sync::Arc;

/// How many ticks are flown in a frame, and where the frame before took longer than that, s: some ms.
const TICKS_A_FRAME: u64 = 300;
const TICKS_A_SLOW_FRAME: u64 = 60;
const SLOW_FRAME: f64 = 1.0 / 40.0;

/// The judgement of one board, as far as it has come.
#[derive(Debug)]
pub struct Prover {
    judge: Judge,
}

impl Prover {
    /// What is plain of the rows of that level's board.
    pub fn new(scores: Scores, level: Arc<Level>, board: &Board) -> Self {
        Self { judge: Judge::new(scores, level, board) }
    }

    /// How the row of that name stands; `None` as long as that is not known.
    pub fn standing(&self, name: &Name) -> Option<&Standing> {
        self.judge.standing(name)
    }

    /// How long its flight took, s, where that is known.
    pub fn time(&self, name: &Name) -> Option<f64> {
        self.judge.time(name)
    }

    /// What its flight has earned, once it is proven.
    pub fn medals(&self, name: &Name) -> Medals {
        self.judge.medals(name)
    }

    /// One frame, in which those rows are in view.
    pub fn update(&mut self, board: &Board, view: impl IntoIterator<Item = usize>, frame_time: f64) {
        // To read a file is enough for a frame.
        if frame_time > 0.0 && self.judge.begin(board, view).is_none() {
            self.judge.fly(if frame_time > SLOW_FRAME { TICKS_A_SLOW_FRAME } else { TICKS_A_FRAME });
        }
    }
}
