//! An experiment of the Lab, as `experiments/experiments.csv` lists it.

use crate::instruments::reading::{self, Wanted};

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
