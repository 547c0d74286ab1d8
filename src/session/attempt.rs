//! An attempt at a level, and its record.
//!
//! An experiment of the Lab, as `experiments/experiments.csv` lists it.

use crate::game::{History, Inputs, Replay};
use crate::instruments::reading::{self, Wanted};
use crate::level::Level;
use std::sync::Arc;

/// A level, and the inputs that replace the keys, if any.
#[derive(Clone, Debug)]
pub struct Attempt {
    pub level: Arc<Level>,
    /// Recorded inputs, played from the first tick on.
    pub inputs: Option<Arc<Inputs>>,
    /// Recorded flights that fly along as ghosts.
    pub rivals: Vec<Rival>,
}

impl Attempt {
    /// A flight by hand, alone.
    pub const fn by_hand(level: Arc<Level>) -> Self {
        Self { level, inputs: None, rivals: Vec::new() }
    }
}

/// A flight by hand that is over.
#[derive(Clone, Debug)]
pub struct Flown {
    pub level: Arc<Level>,
    pub replay: Replay,
    /// Any tick of it.
    pub history: History,
}

/// A recorded flight that flies along.
#[derive(Clone, Debug)]
pub struct Rival {
    /// Whose it is, in a word or two.
    pub name: String,
    /// What was pressed.
    pub inputs: Arc<Inputs>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Experiment {
    pub folder: String,
    pub question: String,
    pub vary: String,
    pub answer: String,
    /// The guesses to choose from; none: a guess is written.
    pub choices: Vec<String>,
    /// The right choice, or a number with its unit; empty where neither is.
    pub right: String,
    /// The quantities that are to be found.
    pub readings: Vec<Wanted>,
    pub title: String,
}

impl Experiment {
    /// Whether a guess is right; `None` where the experiment has no right one, or the text none that could be.
    pub fn judge_guess(&self, text: &str) -> Option<bool> {
        if !self.choices.is_empty() {
            return self.choices.iter().any(|choice| choice == text).then(|| text == self.right);
        }
        reading::judge(text, &[Wanted::new(&self.question, &self.right)?])
    }

    /// The same of readings: where no quantities are named, they are a guess made after the flight.
    pub fn judge_readings(&self, text: &str) -> Option<bool> {
        if self.readings.is_empty() { self.judge_guess(text) } else { reading::judge(text, &self.readings) }
    }
}
