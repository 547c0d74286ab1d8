//! A name for a score, where the player has none yet, or where saving takes a second try.

use super::closing::unsaved_points;
use super::leaderboard::Onward;
use super::name_field::{NameEntry, NameField};
use super::{Flown, Request, Screen};
use crate::scores::Name;
use crate::ui::Ui;
use std::path::Path;
use std::rc::Rc;

/// What is to be saved.
#[derive(Clone, Debug)]
pub struct Gain {
    /// The leaderboard: that of a level, by its name, or that of the jumper.
    pub board: String,
    /// What it is of, in words.
    pub subject: String,
    /// The score.
    pub points: i64,
    /// How they were flown, where that is known.
    pub flown: Option<Rc<Flown>>,
    /// Where Back leads.
    pub back: Box<Request>,
    /// Where the leaderboard leads once it is saved.
    pub onward: Vec<Onward>,
}

/// The field for the name.
#[derive(Debug)]
pub struct SaveScore {
    gain: Gain,
    field: NameField,
    /// Whether it could not be saved.
    failed: bool,
}

impl SaveScore {
    /// The field for that score, with the player's name.
    pub fn new(gain: Gain, name: Option<&Name>) -> Self {
        Self { gain, field: NameField::new(name.map_or("", Name::as_str)), failed: false }
    }

    /// Shows why the score could not be saved.
    pub fn refuse(&mut self, error: String) {
        self.field.refuse(error);
        self.failed = true;
    }
}

impl Screen for SaveScore {
    fn show(&mut self, ui: &mut Ui<'_>) -> Option<Request> {
        ui.page("Save score", ui.frame().size.y * 0.2);
        let score = unsaved_points(self.gain.points, &self.gain.subject);
        Some(match self.field.show(ui, (&score, if self.failed { "Try again" } else { "Save" }))? {
            NameEntry::Name(name) => Request::Submit(self.gain.clone(), name),
            NameEntry::Back => (*self.gain.back).clone(),
        })
    }

    fn tune(&self) -> Option<&str> {
        None
    }

    fn unsaved(&self) -> Option<String> {
        Some(unsaved_points(self.gain.points, &self.gain.subject))
    }

    fn takes(&self, _: &Path) -> bool {
        false
    }
}
