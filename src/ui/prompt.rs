//! A panel that asks for one line of text: a new name.

use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, GAP, PADDING, ROW_BUTTON, TEXT, Vec2};
use crate::settings::Key;
use crate::ui::text_field::TextField;
use crate::ui::{FieldEvent, Ui};
use crate::view::{theme, widgets};

/// Width and height of the panel.
const PANEL: Vec2 = Vec2::new(640.0, 264.0);
/// The most letters that the field takes.
const MOST: usize = 60;

/// What came of a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    /// That text.
    Text(String),
    /// Nothing is wanted any more.
    Cancel,
}

/// The panel.
#[derive(Clone, Debug)]
pub struct Prompt {
    heading: String,
    field: TextField,
    note: Option<String>,
    error: Option<String>,
}

impl Prompt {
    /// A panel with that heading, whose field begins with that text.
    pub fn new(heading: impl Into<String>, text: &str) -> Self {
        Self { heading: heading.into(), field: TextField::new(text, MOST), note: None, error: None }
    }

    /// The same with a line below its field.
    #[must_use]
    pub fn with_note(self, note: String) -> Self {
        Self { note: Some(note), ..self }
    }

    /// Says why the text will not do.
    pub fn refuse(&mut self, error: String) {
        self.error = Some(error);
    }

    /// Shows the panel above all else.
    pub fn show(&mut self, ui: &mut Ui<'_>) -> Option<Reply> {
        ui.layer(0.7);
        let panel = Area::around(ui.frame().size / 2.0, PANEL);
        let (middle, room) = (panel.centre().x, panel.size.x - 2.0 * PADDING);
        ui.panel(panel);
        let at = Vec2::new(middle, panel.min.y + 36.0);
        widgets::fitted(ui.canvas(), &self.heading, at, room, &[BUTTON_TEXT, TEXT, DETAILS], theme::text());
        let area = Area::new(panel.min.x + PADDING, panel.min.y + 72.0, room, 52.0);
        let typed = ui.field("Name", area, &mut self.field);
        if typed == Some(FieldEvent::Changed) {
            self.error = None;
        }
        let below = [(self.error.as_deref(), theme::bad()), (self.note.as_deref(), theme::quiet())];
        if let Some((words, colour)) = below.into_iter().find_map(|(words, colour)| Some((words?, colour))) {
            let at = Vec2::new(middle, area.max().y + 28.0);
            widgets::fitted(ui.canvas(), words, at, room, &[TEXT, DETAILS], colour);
        }
        ui.group();
        let at = Vec2::new(middle - ROW_BUTTON.x - GAP / 2.0, panel.max().y - PADDING - ROW_BUTTON.y);
        let button = |i: f32| Area { min: at + Vec2::new(i * (ROW_BUTTON.x + GAP), 0.0), size: ROW_BUTTON };
        let pressed = ui.buttons(vec![button(0.0), button(1.0)], &["OK", "Cancel"]);
        if ui.key(Key::Escape) || pressed == Some("Cancel") {
            return Some(Reply::Cancel);
        }
        let given = pressed == Some("OK") || typed == Some(FieldEvent::Entered);
        given.then(|| Reply::Text(self.field.text().trim().to_owned()))
    }
}
