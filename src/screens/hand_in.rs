//! Answers to experiments: each goes to the player's file in `results/`, and its sheet says so, or why not. A browser also hands the file
//! to the pupil who presses Save. A sheet outlasts its flight, and what is written on it is saved when the flight is left.

use crate::scores::{ResultRow, time_of};
use crate::screens::App;
use crate::screens::flight::{Flight, Worksheet};
use crate::session::new_file;
use crate::words::tr;

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

    /// Saves an answer of the present player, and says on the sheet what became of it; one that is not saved waits for the end of the sitting.
    pub(super) fn hand_in(&mut self, row: ResultRow) {
        let row = ResultRow { player: self.journal.current().clone(), time: time_of(self.now), ..row };
        let file = self.results.file(&row.player);
        self.unsaved_answers.retain(|other| (&other.player, &other.experiment) != (&row.player, &row.experiment));
        let shown = self.screen.get_mut::<Flight>().and_then(|flight| flight.sheet_of(&row.experiment));
        let told = self.results.append(&row).map(|()| tr!("Saved in {place}.", place = file.display()));
        if shown.is_some() && told.is_ok() {
            new_file::hand_out(&file);
        }
        let told = told.map_err(|error| error.to_string());
        if let Some(sheet) = shown.or_else(|| self.sheets.get_mut(&row.experiment)) {
            sheet.tell(told.clone());
        }
        if told.is_err() {
            self.unsaved_answers.push(row);
        }
    }

    /// Tries once more to save the answers that are not, at the end of a sitting; those that are lost, a line each.
    pub(super) fn close_answers(&mut self) -> Vec<String> {
        let mut losses = Vec::new();
        self.unsaved_answers.retain(|row| match self.results.append(row) {
            Ok(()) => false,
            Err(error) => {
                losses.push(tr!("the answer to {experiment}: {error}", experiment = row.experiment, error));
                true
            }
        });
        losses
    }
}
