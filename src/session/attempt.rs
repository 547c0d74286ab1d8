//! An attempt at a level, and its record.
//!
//! An experiment of the Lab, as `experiments/experiments.csv` lists it.

use crate::game::{History, Inputs, Replay};
use crate::instruments::reading::Wanted;
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
    /// The predictions to choose from; none: one is written.
    pub choices: Vec<String>,
    /// The right choice, or a number with its unit; empty where neither is.
    pub right: String,
    /// The quantities that are to be found.
    pub readings: Vec<Wanted>,
    pub title: String,
}

impl Experiment {
    /// Whether a prediction is right; `None` where the experiment has no right one, or the text none that could be.
    pub fn judge_prediction(&self, text: &str) -> Option<bool> {
        if !self.choices.is_empty() {
            return self.choices.iter().any(|choice| choice == text).then(|| text == self.right);
        }
        self.predicted()?.judge(text)
    }

    /// The number that is to be predicted, where one is.
    pub fn predicted(&self) -> Option<Wanted> {
        if self.choices.is_empty() { Wanted::new(&self.question, &self.right) } else { None }
    }
}
