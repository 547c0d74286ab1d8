//! Who plays, and what they have done: known at once, and on disk as soon as that can be. Answers to experiments: a file a player in `results/`,
//! which a browser also hands to the pupil who presses Save. A sheet outlasts its flight, and what is written on it is saved when the flight is left.

use super::library::{self, Experiment};
use crate::game::{Game, Medals, Outcome, RunResult};
use crate::number::{clock, hundredths};
use crate::scores::{AttemptRow, Deed, Name, PlayerRecord, Players, ResultRow, Results, Scores, ScoresError, damage_text, time_of};
use crate::{ui::EntryField, words::tr};
use std::collections::BTreeMap;

const LOST: &str = "A lost attempt scores 0 and cannot be saved.";

#[derive(Debug)]
pub struct Journal {
    scores: Scores,
    players: Players,
    current: Name,
    deeds: Vec<Deed>,
    attempts: Vec<AttemptRow>,
    /// The deeds of this sitting before the player had a name.
    by_guest: Vec<Deed>,
    trouble: Option<String>,
}

impl Journal {
    /// What is on disk; who was chosen last plays on.
    pub fn new(scores: Scores) -> Self {
        let mut journal = Self {
            scores,
            players: Players::default(),
            current: Name::guest(),
            deeds: Vec::new(),
            attempts: Vec::new(),
            by_guest: Vec::new(),
            trouble: None,
        };
        journal.read();
        if let Some(player) = journal.players.all().first() {
            journal.current = player.name().clone();
        }
        journal
    }

    /// Reads what others have written meanwhile.
    pub fn read(&mut self) {
        match self.scores.players() {
            Ok((players, damage)) => {
                self.players = players;
                self.trouble = (!damage.is_empty()).then(|| damage_text(&damage));
            }
            Err(error) => self.trouble = Some(error.to_string()),
        }
        self.deeds.iter().for_each(|deed| self.players.apply(deed));
    }

    pub fn current(&self) -> &Name {
        &self.current
    }

    pub fn players(&self) -> &Players {
        &self.players
    }

    fn player(&self) -> Option<&PlayerRecord> {
        self.players.get(&self.current)
    }

    /// The player's best time in a level, s; `None` until it is done.
    pub fn best(&self, level: &str) -> Option<f64> {
        self.player().and_then(|player| player.best(level))
    }

    pub fn medals(&self, level: &str) -> Medals {
        self.player().map(|player| player.medals(level)).unwrap_or_default()
    }

    /// What went wrong with writing or reading, while it does.
    pub fn trouble(&self) -> Option<&str> {
        self.trouble.as_deref()
    }

    /// Somebody plays from now on. Who has just said their name also gets what they have done in this sitting without one.
    pub fn choose(&mut self, name: Name, named: bool) {
        self.apply(Deed::Chosen(name.clone()));
        if named && self.current.is_guest() {
            for deed in std::mem::take(&mut self.by_guest) {
                if let Deed::Done { level, time, medals, .. } = deed {
                    self.apply(Deed::Done { player: name.clone(), level, time, medals });
                }
            }
        }
        self.current = name;
        self.save();
    }

    /// Takes note of an attempt that has ended. The answer says what it brought the player, or why it cannot be written down.
    pub fn note(&mut self, game: &Game, assisted: bool) -> String {
        let (level, time, player) = (game.level().name.clone(), game.time(), self.current.clone());
        self.attempts.push(AttemptRow {
            level: level.clone(),
            player: player.clone(),
            result: game.outcome().name(),
            time,
            fuel: game.fuel(),
            hits: game.collisions(),
            cause: game.killed_by().map(|death| death.name(game.level())).unwrap_or_default(),
            assisted,
        });
        let mut brought = game.result().death.map_or(tr(LOST).to_owned(), |death| format!("{death}. {}", tr(LOST)));
        if game.outcome() == Outcome::Completed {
            let before = self.best(&level);
            let medals = Medals::of(&game.level().awards, &RunResult { assisted, ..game.result() });
            let deed = Deed::Done { player: player.clone(), level: level.clone(), time: (!assisted).then_some(time), medals };
            if player.is_guest() {
                self.by_guest.push(deed.clone());
            }
            self.apply(deed);
            let shown = clock(time);
            brought = match before {
                _ if assisted => tr!("{player}: done, with help: neither time nor score is saved.", player),
                None => tr!("{player}: done for the first time, in {time}.", player, time = shown),
                Some(before) if hundredths(time) < hundredths(before) => {
                    tr!("{player}: your best time! It was {before}, it is {time}.", player, before = clock(before), time = shown)
                }
                Some(before) => tr!("{player}: {time}, your best time is {best}.", player, time = shown, best = clock(before)),
            };
        }
        self.save();
        self.trouble.clone().unwrap_or(brought)
    }

    fn apply(&mut self, deed: Deed) {
        self.players.apply(&deed);
        self.deeds.push(deed);
    }

    pub fn try_again(&mut self) {
        if !self.is_written() {
            self.save();
        }
    }

    /// What cannot be written waits for the next deed, the menu or the end of the sitting.
    fn save(&mut self) {
        self.trouble = self.close().err().map(|error| error.to_string());
    }

    /// Writes down what waits. Errors: why it cannot be; it still waits then.
    pub fn close(&mut self) -> Result<(), ScoresError> {
        // A list that cannot be written holds up no other.
        let deeds =
            if self.deeds.is_empty() { Ok(()) } else { self.scores.record(&self.deeds).map(|players| self.players = players) };
        if deeds.is_ok() {
            self.deeds.clear();
        }
        let attempts = self.scores.append(&self.attempts);
        if attempts.is_ok() {
            self.attempts.clear();
        }
        deeds.and(attempts)
    }

    pub fn is_written(&self) -> bool {
        self.deeds.is_empty() && self.attempts.is_empty()
    }
}

#[derive(Debug)]
pub struct Answers {
    results: Results,
    /// The sheets of experiments as they were left, by folder.
    pub sheets: BTreeMap<String, Worksheet>,
    unsaved: Vec<ResultRow>,
}

impl Answers {
    pub const fn new(results: Results) -> Self {
        Self { results, sheets: BTreeMap::new(), unsaved: Vec::new() }
    }

    /// Saves the rows of a sheet, handed in by that player at that time, s; what is not saved waits for the end. What became of it, in words.
    /// Errors: why it is not saved.
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

#[derive(Debug)]
pub struct Worksheet {
    pub experiment: Experiment,
    pub open: bool,
    pub entry: EntryField,
    pub written: WrittenSheet,
    /// When the prediction was made, s since 1970-01-01, 0 UTC: it stays from then on.
    pub predicted: Option<f64>,
    /// Whether the world has been let go: a prediction made after that is none.
    pub begun: bool,
    /// Whether the answer is shown: the readings stay as they are then.
    pub answered: bool,
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

    pub const fn predicts(&self) -> bool {
        self.predicted.is_none() && !self.begun
    }

    /// The prediction stays as it is from that moment on, s.
    pub fn fix_prediction(&mut self, now: f64) {
        if self.predicts() && !self.written.prediction.is_empty() {
            self.predicted = Some(now);
        }
    }

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
