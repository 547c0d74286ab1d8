//! A name for a score, where the player has none yet, or where saving takes a second try.

use crate::scores::{Name, unsaved_points};
use crate::screens::screen::{Gain, Request, Screen};
use crate::ui::Ui;
use crate::ui::name_field::{NameEntry, NameField};
use std::path::Path;

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
