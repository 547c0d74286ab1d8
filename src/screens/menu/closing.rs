//! The question before the window closes while something is neither saved nor kept: what would be lost, and whether to stay.

use crate::screens::screen::{Request, Screen};
use crate::settings::Key;
use crate::ui::Ui;
use crate::ui::prompt::Problems;
use crate::view::widgets;
use crate::words::tr;
use std::path::Path;

/// Loses nothing: Enter presses it, and Esc does the same.
const STAY: &str = "Stay here";
const AGAIN: &str = "Try again";
const ANYWAY: &str = "Close anyway";

#[derive(Debug)]
pub struct Closing {
    losses: Problems,
    /// Whether something of that could not be written.
    failed: bool,
}

impl Closing {
    /// What would be lost, a line each, and whether some of that could not be written.
    pub fn new(losses: Vec<String>, failed: bool) -> Self {
        Self { losses: Problems::new(tr("This is not saved, and would be lost").to_owned(), losses), failed }
    }
}

impl Screen for Closing {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        widgets::graph_paper(ui.canvas());
        let answers = if self.failed { &[STAY, AGAIN, ANYWAY][..] } else { &[STAY, ANYWAY] };
        let answer = self.losses.answer(ui, answers);
        if ui.key(Key::Escape) || answer == Some(STAY) {
            return Some(Request::Pop);
        }
        answer.map(|answer| if answer == AGAIN { Request::Quit } else { Request::QuitAnyway })
    }

    fn tune(&self) -> Option<&str> {
        None
    }

    fn takes(&self, _: &Path) -> bool {
        false
    }
}
