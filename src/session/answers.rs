//! Answers to experiments: each goes to the player's file in `results/`, and its sheet says so, or why not. A browser also hands the file
//! to the pupil who presses Save. A sheet outlasts its flight, and what is written on it is saved when the flight is left.

use super::library;
use super::library::Experiment;
use crate::scores::{Name, ResultRow, Results, time_of};
use crate::ui::EntryField;
use crate::words::tr;
use std::collections::BTreeMap;

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

    /// Saves the rows of a sheet, handed in by that player at that time, s; what is not saved waits for the end. What became of it, in words.
    ///
    /// # Errors
    /// Why it is not saved.
    pub fn hand_in(&mut self, rows: Vec<ResultRow>, player: &Name, now: f64) -> Result<String, String> {
        let own = |row| ResultRow { player: player.clone(), time: time_of(now), ..row };
        let rows: Vec<ResultRow> = rows.into_iter().map(own).collect();
        self.unsaved.retain(|other| rows.iter().all(|row| (&other.player, &other.experiment) != (&row.player, &row.experiment)));
        match self.results.append(&rows) {
            Ok(()) => {
                let file = self.results.file(player);
                library::hand_out(&file);
                Ok(tr!("Saved in {place}.", place = file.display()))
            }
            Err(error) => {
                self.unsaved.extend(rows);
                Err(error.to_string())
            }
        }
    }

    /// Tries once more to save the answers that are not; those that are lost, a line each.
    pub fn close(&mut self) -> Vec<String> {
        let mut losses = Vec::new();
        self.unsaved.retain(|row| match self.results.append(std::slice::from_ref(row)) {
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

/// A cell of the sheet's table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    pub text: String,
    /// The moment of the flight on the screen when it was written.
    pub tick: u64,
}

/// What is written on a sheet: the prediction, and the readings in the order of the experiment's quantities.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WrittenSheet {
    pub prediction: String,
    pub readings: Vec<Reading>,
}

/// The sheet of an experiment.
#[derive(Debug)]
pub struct Worksheet {
    pub experiment: Experiment,
    /// Whether it stands beside the flight.
    pub open: bool,
    pub entry: EntryField,
    pub written: WrittenSheet,
    /// When the prediction was made, s since 1970-01-01, 0 UTC: it stays from then on.
    pub predicted: Option<f64>,
    /// Whether the world has been let go: a prediction made after that is none.
    pub begun: bool,
    /// Whether the answer is shown: the readings stay as they are then.
    pub answered: bool,
    /// What was saved last, and before that.
    saved: [WrittenSheet; 2],
    /// The outcome of the last press; an error is a problem.
    pub message: Result<String, String>,
}

impl Worksheet {
    pub fn new(experiment: Experiment) -> Self {
        let blank = WrittenSheet { prediction: String::new(), readings: vec![Reading::default(); experiment.readings.len()] };
        Self {
            experiment,
            open: true,
            entry: EntryField::default(),
            saved: [blank.clone(), blank.clone()],
            written: blank,
            predicted: None,
            begun: false,
            answered: false,
            message: Ok(String::new()),
        }
    }

    pub fn folder(&self) -> &str {
        &self.experiment.folder
    }

    /// Whether a prediction can still be made or changed.
    pub const fn predicts(&self) -> bool {
        self.predicted.is_none() && !self.begun
    }

    /// The prediction stays as it is from that moment on, s.
    pub fn fix_prediction(&mut self, now: f64) {
        if self.predicts() && !self.written.prediction.is_empty() {
            self.predicted = Some(now);
        }
    }

    /// What became of the rows that were to be saved.
    pub fn set_message(&mut self, message: Result<String, String>) {
        if message.is_err() {
            self.saved[0] = self.saved[1].clone();
        }
        self.message = message;
    }

    /// What is written and not saved yet, the prediction in the first row; it counts as saved from now on.
    pub fn take_unsaved(&mut self) -> Vec<ResultRow> {
        let row = |experiment: &Experiment| ResultRow {
            player: Name::guest(),
            experiment: experiment.folder.clone(),
            time: String::new(),
            prediction: String::new(),
            predicted: String::new(),
            prediction_right: None,
            quantity: String::new(),
            reading: String::new(),
            unit: String::new(),
            tick: None,
            reading_right: None,
            answer: experiment.answer.clone(),
        };
        let wanted = self.experiment.readings.iter().zip(self.written.readings.iter().zip(&self.saved[0].readings));
        let fresh = wanted.filter(|(_, (now, before))| now.text != before.text);
        let mut rows: Vec<ResultRow> = fresh
            .map(|(wanted, (now, _))| ResultRow {
                quantity: wanted.what.clone(),
                reading: now.text.clone(),
                unit: wanted.unit.clone(),
                tick: Some(now.tick),
                reading_right: wanted.judge(&now.text),
                ..row(&self.experiment)
            })
            .collect();
        if self.written.prediction != self.saved[0].prediction {
            if rows.is_empty() {
                rows.push(row(&self.experiment));
            }
            rows[0].prediction = self.written.prediction.clone();
            rows[0].predicted = self.predicted.map_or_else(String::new, time_of);
            rows[0].prediction_right = self.experiment.judge_prediction(&self.written.prediction);
        }
        self.saved = [self.written.clone(), self.saved[0].clone()];
        rows
    }

    pub fn is_unsaved(&self) -> bool {
        self.written != self.saved[0]
    }
}
