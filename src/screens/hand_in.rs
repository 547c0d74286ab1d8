//! Answers to experiments: each goes to the player's file in `results/`, and its sheet says so, or why not. A browser also hands the file
//! to the pupil who presses Save. A sheet outlasts its flight, and what is written on it is saved when the flight is left.

use super::flight::Worksheet;
use super::{App, Flight, new_file};
use crate::daily::time_of;
use crate::scores::{PATIENCE, ResultRow, ScoresError};
use crate::words::tr;
use std::time::Duration;

/// An answer to be saved as soon as another program lets go of its file.
#[derive(Debug)]
pub(super) struct WaitingAnswer {
    row: ResultRow,
    /// s.
    since: f64,
}

impl App {
    /// Gives a flight of an experiment that is listed its sheet, as the player has left it.
    pub(super) fn give_sheet(&mut self, flight: &mut Flight) {
        self.keep_sheet();
        let level = flight.attempt().level.clone();
        if !level.experiment {
            return;
        }
        let listed = || self.library.experiments().ok()?.into_iter().find(|listed| listed.folder == level.name);
        if let Some(sheet) = self.sheets.remove(&level.name).or_else(|| listed().map(Worksheet::new)) {
            flight.give_sheet(sheet);
        }
    }

    /// Keeps the sheet of the flight on the screen, and saves what it has that is not saved.
    pub(super) fn keep_sheet(&mut self) {
        self.hand_in_sheet();
        if let Some(sheet) = self.screen.get_mut::<Flight>().and_then(Flight::take_sheet) {
            self.sheets.insert(sheet.folder().to_owned(), sheet);
        }
    }

    /// Saves what the sheet on the screen has that is not saved.
    pub(super) fn hand_in_sheet(&mut self) {
        let unsaved = self.screen.get_mut::<Flight>().and_then(Flight::take_unsaved);
        unsaved.into_iter().for_each(|row| self.hand_in(row));
    }

    /// Saves an answer of the present player, now; one that waits goes beside its file.
    pub(super) fn hand_in(&mut self, row: ResultRow) {
        if let Some(waiting) = self.waiting_answer.take() {
            let told = self.put_answer_by(&waiting.row);
            self.tell_of_answer(waiting.row, told);
        }
        let row = ResultRow { player: self.journal.current().clone(), time: time_of(self.now), ..row };
        self.save_answer(WaitingAnswer { row, since: 0.0 });
    }

    /// Tries again to save the answer that waits; no frame is spent on waiting.
    pub(super) fn save_waiting_answer(&mut self, frame_time: f64) {
        if let Some(WaitingAnswer { row, since }) = self.waiting_answer.take() {
            self.save_answer(WaitingAnswer { row, since: since + frame_time });
        }
    }

    fn save_answer(&mut self, waiting: WaitingAnswer) {
        let WaitingAnswer { row, since } = waiting;
        let file = self.results.file(&row.player);
        let is_shown = self.screen.get_mut::<Flight>().is_some_and(|flight| flight.sheet_of(&row.experiment).is_some());
        let told = match self.results.append_within(Duration::ZERO, &row) {
            Ok(aside) => {
                let kept =
                    aside.map(|kept| tr!(" What stood there before is {place} now.", place = kept.display())).unwrap_or_default();
                if is_shown {
                    new_file::hand_out(&file);
                }
                Ok(tr!("Saved in {place}.", place = file.display()) + &kept)
            }
            Err(ScoresError::Busy(_)) if since < PATIENCE.as_secs_f64() => {
                self.waiting_answer = Some(WaitingAnswer { row, since });
                return;
            }
            Err(ScoresError::Busy(_)) => self.put_answer_by(&row),
            Err(error) => Err(error.to_string()),
        };
        self.tell_of_answer(row, told);
    }

    /// Says on the sheet what became of its answer; one that is not saved waits for the end of the sitting.
    fn tell_of_answer(&mut self, row: ResultRow, told: Result<String, String>) {
        self.unsaved_answers.retain(|other| (&other.player, &other.experiment) != (&row.player, &row.experiment));
        let shown = self.screen.get_mut::<Flight>().and_then(|flight| flight.sheet_of(&row.experiment));
        if let Some(sheet) = shown.or_else(|| self.sheets.get_mut(&row.experiment)) {
            sheet.tell(told.clone());
        }
        if told.is_err() {
            self.unsaved_answers.push(row);
        }
    }

    /// Puts an answer beside a file that another program keeps to itself.
    pub(super) fn put_answer_by(&self, row: &ResultRow) -> Result<String, String> {
        let file = self.results.file(&row.player);
        let waits =
            || tr!("Another program writes to {place}: the answer waits beside it for your next one.", place = file.display());
        self.results.put_by(row).map(|()| waits()).map_err(|error| error.to_string())
    }

    /// Puts the answer that waits by, at the end of a sitting, and tries once more to save the others; those that are lost, a line each.
    pub(super) fn close_answers(&mut self) -> Vec<String> {
        if let Some(WaitingAnswer { row, .. }) = self.waiting_answer.take() {
            let told = self.put_answer_by(&row);
            self.tell_of_answer(row, told);
        }
        let mut losses = Vec::new();
        self.unsaved_answers.retain(|row| match self.results.append_within(Duration::ZERO, row) {
            Ok(_) => false,
            Err(error) => {
                losses.push(tr!("the answer to {experiment}: {error}", experiment = row.experiment, error));
                true
            }
        });
        losses
    }

    pub(super) fn has_unsaved_answers(&self) -> bool {
        self.waiting_answer.is_some() || !self.unsaved_answers.is_empty()
    }
}
