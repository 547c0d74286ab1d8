//! Answers to experiments: each goes to the player's file in `results/`, and the pause panel says so, or why not. A browser also hands
//! the file to the pupil.

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
    /// Saves an answer of the present player, now.
    pub(super) fn hand_in(&mut self, row: ResultRow) {
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
        let told = match self.results.append_within(Duration::ZERO, &row) {
            Ok(aside) => {
                let kept =
                    aside.map(|kept| tr!(" What stood there before is {place} now.", place = kept.display())).unwrap_or_default();
                new_file::hand_out(&file);
                Ok(tr!("Saved in {place}.", place = file.display()) + &kept)
            }
            Err(ScoresError::Busy(_)) if since < PATIENCE.as_secs_f64() => {
                self.waiting_answer = Some(WaitingAnswer { row, since });
                return;
            }
            Err(ScoresError::Busy(_)) => self.put_answer_by(&row),
            Err(error) => Err(error.to_string()),
        };
        if let Some(flight) = self.screen.get_mut::<Flight>() {
            flight.tell_of_answer(told);
        }
    }

    /// Puts an answer beside a file that another program keeps to itself.
    pub(super) fn put_answer_by(&self, row: &ResultRow) -> Result<String, String> {
        let file = self.results.file(&row.player);
        let waits =
            || tr!("Another program writes to {place}: the answer waits beside it for your next one.", place = file.display());
        self.results.put_by(row).map(|()| waits()).map_err(|error| error.to_string())
    }

    /// Puts the answer that waits by, at the end of a sitting.
    pub(super) fn close_answers(&mut self) -> Result<(), String> {
        self.waiting_answer.take().map_or(Ok(()), |waiting| self.put_answer_by(&waiting.row).map(drop))
    }
}
