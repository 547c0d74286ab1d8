//! The question before the window closes while something is neither saved nor kept: what would be lost, and whether to stay.

use crate::screens::App;
use crate::screens::editor::Editor;
use crate::screens::flight::Flight;
use crate::screens::screen::{Request, Screen};
use crate::settings::Key;
use crate::ui::Ui;
use crate::ui::problems::Problems;
use crate::view::widgets;
use crate::words::tr;

/// Loses nothing: Enter presses it, and Esc does the same.
const STAY: &str = "Stay here";
const AGAIN: &str = "Try again";
const ANYWAY: &str = "Close anyway";

#[derive(Debug)]
pub struct Closing {
    losses: Problems,
    /// Whether something of that could not be written.
    failed: bool,
    /// The screen that waits.
    behind: Option<Box<dyn Screen>>,
}

impl Screen for Closing {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        widgets::graph_paper(ui.canvas());
        let answers = if self.failed { &[STAY, AGAIN, ANYWAY][..] } else { &[STAY, ANYWAY] };
        let answer = self.losses.answer(ui, answers);
        if ui.key(Key::Escape) || answer == Some(STAY) {
            return Some(Request::Stay);
        }
        answer.map(|answer| if answer == AGAIN { Request::Quit } else { Request::QuitAnyway })
    }

    fn tune(&self) -> Option<&str> {
        None
    }
}

impl App {
    /// Whether the window may close at once: everything is saved, or kept for the next time. Else the screen asks.
    pub fn may_close(&mut self) -> bool {
        if self.screen.is::<Closing>() {
            return false;
        }
        let mut losses = self.write_all();
        let failed = !losses.is_empty();
        losses.extend(self.score_at_risk());
        if losses.is_empty() {
            return true;
        }
        let behind = std::mem::replace(&mut self.screen, Box::new(()));
        let losses = Problems::new(tr("This is not saved, and would be lost").to_owned(), losses);
        self.show(Box::new(Closing { losses, failed, behind: Some(behind) }));
        false
    }

    /// Back to the screen that waits behind the question; a flight is paused.
    pub(super) fn stay(&mut self) {
        let Some(mut behind) = self.screen.get_mut::<Closing>().and_then(|closing| closing.behind.take()) else { return };
        if let Some(flight) = behind.get_mut::<Flight>() {
            flight.halt();
        }
        self.show(behind);
    }

    /// Writes down what waits, as far as that can be done; the rest in words, a line each.
    pub(super) fn write_all(&mut self) -> Vec<String> {
        self.hand_in_sheet();
        let editor = self.editing.as_deref_mut().or_else(|| self.screen.get_mut::<Editor>());
        let edits = editor.and_then(|editor| editor.keep().err());
        let journal = self.journal.close().err().map(|error| error.to_string());
        let settings = self.settings_file.close().err().map(|error| error.to_string());
        [edits, journal, settings].into_iter().flatten().chain(self.close_answers()).collect()
    }

    /// Whether something is not written yet. Nothing is tried.
    pub fn is_at_risk(&self) -> bool {
        let editor = self.editing.as_deref().or_else(|| self.screen.get::<Editor>());
        let sheet = self.screen.get::<Flight>().is_some_and(Flight::has_unsaved_sheet);
        editor.is_some_and(|editor| !editor.is_kept())
            || sheet
            || !self.journal.is_written()
            || self.settings_file.waits()
            || !self.unsaved_answers.is_empty()
            || self.score_at_risk().is_some()
    }

    fn score_at_risk(&self) -> Option<String> {
        self.screen.unsaved().or_else(|| self.unsaved_score.clone())
    }

    /// The score on the screen stays unsaved as long as it can still be saved from where a request leads.
    pub(super) fn note_score(&mut self, request: &Request) {
        let stays = matches!(
            request,
            Request::SaveScore(_)
                | Request::Submit(..)
                | Request::Flights(_)
                | Request::Watch(..)
                | Request::Keep(..)
                | Request::CopyCode(..)
                | Request::PasteCode(..)
                | Request::Export(_)
                | Request::Set(_)
        );
        self.unsaved_score = if stays { self.score_at_risk() } else { None };
    }
}
