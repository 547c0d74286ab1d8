//! A field for a name, and two buttons below it.

use crate::draw::Style;
use crate::draw::layout::{Area, ROW_BUTTON, TEXT, Vec2};
use crate::scores::{NAME_TYPING_MAX, Name};
use crate::settings::Key;
use crate::ui::text_field::TextField;
use crate::ui::{FieldEvent, Ui};
use crate::view::theme;
use crate::words::tr;

/// Width and height of the field.
const FIELD: Vec2 = Vec2::new(720.0, 56.0);
/// What is wrong with the name of a player who has none.
const NOBODY: &str = "Guest is the player who has no name yet: choose another one.";

/// What came of a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NameEntry {
    /// A name that follows the rules was submitted.
    Name(Name),
    /// The way back was chosen.
    Back,
}

/// The field and its buttons.
#[derive(Debug)]
pub struct NameField {
    field: TextField,
    /// What is wrong with the name or went wrong with it.
    error: Option<String>,
}

impl NameField {
    /// A field that begins with that text.
    pub fn new(text: &str) -> Self {
        Self { field: TextField::new(text, NAME_TYPING_MAX), error: None }
    }

    /// Shows the field with a line above it, and the buttons: the one that submits, and Back.
    pub fn show(&mut self, ui: &mut Ui<'_>, (above, submit): (&str, &str)) -> Option<NameEntry> {
        let size = ui.frame().size;
        let area = Area::around(size / 2.0 - Vec2::new(0.0, ROW_BUTTON.y / 2.0), FIELD);
        let quiet = Style::new(TEXT, theme::quiet()).middle();
        ui.fitted(above, Vec2::new(size.x / 2.0, area.min.y - 88.0), &[TEXT], theme::quiet());
        ui.text(tr("Your name"), area.min - Vec2::new(0.0, 24.0), quiet);
        ui.text(tr("up to 15 characters"), Vec2::new(area.max().x, area.min.y - 24.0), quiet.right());
        let typed = ui.field("Your name", area, &mut self.field);
        if let Some(FieldEvent::Changed) = typed {
            // Once a name was refused, what is wrong stays in view until it is mended.
            self.error = self.error.as_ref().and_then(|_| judge(&self.field.text()).err());
        }
        if let Some(error) = &self.error {
            ui.fitted(error, Vec2::new(size.x / 2.0, area.max().y + 36.0), &[TEXT], theme::bad());
        }
        ui.group();
        let pressed = ui.row(size.y * 0.5 + 104.0, &[submit, "Back"]);
        if ui.key(Key::Escape) || pressed == Some("Back") {
            return Some(NameEntry::Back);
        }
        if pressed.is_none() && typed != Some(FieldEvent::Entered) {
            return None;
        }
        judge(&self.field.text()).map(NameEntry::Name).map_err(|error| self.error = Some(error)).ok()
    }

    /// Shows what went wrong with the name.
    pub fn refuse(&mut self, error: String) {
        self.error = Some(error);
    }
}

fn judge(text: &str) -> Result<Name, String> {
    let name = Name::new(text).map_err(|error| error.to_string())?;
    if name.is_guest() { Err(tr(NOBODY).to_owned()) } else { Ok(name) }
}
