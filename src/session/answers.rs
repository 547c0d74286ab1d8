//! Answers to experiments: each goes to the player's file in `results/`, and its sheet says so, or why not. A browser also hands the file
//! to the pupil who presses Save. A sheet outlasts its flight, and what is written on it is saved when the flight is left.

use super::attempt::Experiment;
use super::library;
use crate::scores::{Name, ResultRow, Results, time_of};
use crate::ui::text_field::TextField;
use crate::words::tr;
use std::collections::BTreeMap;

/// The most characters of a guess, and of readings.
pub const MOST_LETTERS: (usize, usize) = (80, 240);

/// The answers of this run of the game.
#[derive(Debug)]
pub struct Answers {
    results: Results,
    /// The sheets of experiments as they were left, by folder.
    pub sheets: BTreeMap<String, Worksheet>,
    /// What cannot be written.
    unsaved: Vec<ResultRow>,
}

impl Answers {
    pub const fn new(results: Results) -> Self {
        Self { results, sheets: BTreeMap::new(), unsaved: Vec::new() }
    }

    /// Saves an answer of that player, given at that time, s; one that is not saved waits for the end. What became of it, in words.
    ///
    /// # Errors
    /// Why it is not saved.
    pub fn hand_in(&mut self, row: ResultRow, player: &Name, now: f64) -> Result<String, String> {
        let row = ResultRow { player: player.clone(), time: time_of(now), ..row };
        let file = self.results.file(&row.player);
        self.unsaved.retain(|other| (&other.player, &other.experiment) != (&row.player, &row.experiment));
        match self.results.append(&row) {
            Ok(()) => {
                library::hand_out(&file);
                Ok(tr!("Saved in {place}.", place = file.display()))
            }
            Err(error) => {
                self.unsaved.push(row);
                Err(error.to_string())
            }
        }
    }

    /// Tries once more to save the answers that are not; those that are lost, a line each.
    pub fn close(&mut self) -> Vec<String> {
        let mut losses = Vec::new();
        self.unsaved.retain(|row| match self.results.append(row) {
            Ok(()) => false,
            Err(error) => {
                losses.push(tr!("the answer to {experiment}: {error}", experiment = row.experiment, error));
                true
            }
        });
        losses
    }

    pub const fn is_written(&self) -> bool {
        self.unsaved.is_empty()
    }
}

/// The sheet of an experiment: the pupil's guess and readings.
#[derive(Debug)]
pub struct Worksheet {
    pub experiment: Experiment,
    pub guess: TextField,
    pub readings: TextField,
    /// Whether the answer is shown: the guess stays as it is then.
    pub answered: bool,
    /// What was saved last.
    pub saved: Option<[String; 2]>,
    /// The outcome of the last press; an error is a problem.
    pub message: Result<String, String>,
}

impl Worksheet {
    pub fn new(experiment: Experiment) -> Self {
        Self {
            experiment,
            guess: TextField::new("", MOST_LETTERS.0),
            readings: TextField::new("", MOST_LETTERS.1),
            answered: false,
            saved: None,
            message: Ok(String::new()),
        }
    }

    pub fn folder(&self) -> &str {
        &self.experiment.folder
    }

    /// What became of the answer that was to be saved.
    pub fn set_message(&mut self, message: Result<String, String>) {
        self.saved = self.saved.take().filter(|_| message.is_ok());
        self.message = message;
    }

    /// What is written and not saved yet; it counts as saved from now on.
    pub fn take_unsaved(&mut self) -> Option<ResultRow> {
        if !self.is_unsaved() {
            return None;
        }
        let written = self.written();
        self.saved = Some(written.clone());
        let [guess, readings] = written;
        Some(ResultRow {
            player: Name::guest(),
            experiment: self.experiment.folder.clone(),
            time: String::new(),
            guess_right: self.experiment.judge_guess(&guess),
            readings_right: self.experiment.judge_readings(&readings),
            guess,
            readings,
            answer: self.experiment.answer.clone(),
        })
    }

    pub fn is_unsaved(&self) -> bool {
        let written = self.written();
        !written.iter().all(String::is_empty) && self.saved.as_ref() != Some(&written)
    }

    /// The guess and the readings.
    pub fn written(&self) -> [String; 2] {
        [&self.guess, &self.readings].map(|field| field.text().trim().to_owned())
    }
}
