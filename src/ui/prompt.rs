//! A panel that asks for one line of text: a new name. A panel with a level's problems. A field for a name, and two buttons below it.

use super::{FieldEvent, Turning, Ui, scroll::BAR_WIDTH, scroll::bar_beside, text_field::TextField};
use crate::draw::layout::{Area, BUTTON_TEXT, DETAILS, GAP, LINE, MONO_ADVANCE, PADDING, ROW_BUTTON, TEXT, Vec2, wrapped};
use crate::{draw::Style, scores::NAME_TYPING_MAX, scores::Name, settings::Key, view::theme, view::widgets, words::tr};

const PANEL: Vec2 = Vec2::new(640.0, 264.0);
const MOST: usize = 400;

/// What came of a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    Text(String),
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
    /// A panel with that heading, whose field begins with that text, and with a line below it, if any.
    pub fn new(heading: String, text: &str, note: Option<String>) -> Self {
        Self { heading, field: TextField::new(text, MOST), note, error: None }
    }

    /// Says why the text will not do.
    pub fn refuse(&mut self, error: String) {
        self.error = Some(error);
    }

    /// Shows the panel above all else.
    pub fn show(&mut self, ui: &mut Ui<'_>) -> Option<Reply> {
        ui.layer(0.7);
        let words = ui.canvas().width(&self.heading, Style::new(DETAILS, theme::text())) + 2.0 * PADDING + 1.0;
        let width = PANEL.x.max(words).min(ui.frame().size.x - 2.0 * PADDING);
        let panel = Area::around(ui.frame().size / 2.0, Vec2::new(width, PANEL.y));
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

/// From the canvas' edges to the panel, canvas units, as all lengths here.
const MARGIN: Vec2 = Vec2::new(80.0, 56.0);
const HEAD: f32 = 72.0;
/// From its last line to its bottom: the button.
const FOOT: f32 = 3.0 * PADDING + ROW_BUTTON.y;
const LEFT: f32 = PADDING + 8.0;
/// The part of its width beside the lines, with the scroll bar.
const ASIDE: f32 = LEFT + 2.0 * PADDING + BAR_WIDTH;

/// How far the further lines of a problem are set in, characters.
const INDENT: usize = 4;

/// The panel; it scrolls where it is long.
#[derive(Debug)]
pub struct Problems {
    heading: String,
    problems: Vec<String>,
}

impl Problems {
    /// A panel with a paragraph a problem.
    pub fn new(heading: String, problems: Vec<String>) -> Self {
        Self { heading, problems }
    }

    /// Shows the panel above all else; whether it is to be closed.
    pub fn show(&self, ui: &mut Ui<'_>) -> bool {
        self.answer(ui, &["Close"]).is_some() || ui.key(Key::Escape)
    }

    /// Shows the panel above all else, with these buttons; the one that is pressed.
    pub fn answer(&self, ui: &mut Ui<'_>, answers: &[&'static str]) -> Option<&'static str> {
        let frame = ui.frame();
        let (height, widest) = (frame.text_height(DETAILS), frame.size - 2.0 * MARGIN);
        let columns = ((widest.x - ASIDE) / (height * MONO_ADVANCE)).floor().max(1.0) as usize;
        // A line, and whether it begins a problem.
        let cut = |problem: &String| wrapped(problem, columns, INDENT).into_iter().enumerate().map(|(i, line)| (line, i == 0));
        let lines: Vec<(String, bool)> = self.problems.iter().flat_map(cut).collect();
        let room = ((widest.y - HEAD - FOOT) / (height * LINE)).floor().max(1.0) as usize;
        let page = lines.len().clamp(1, room);
        let panel = Area::around(frame.size / 2.0, Vec2::new(widest.x, HEAD + page as f32 * height * LINE + FOOT));
        ui.layer(0.7);
        ui.panel(panel);
        let at = panel.min + Vec2::new(LEFT, PADDING + 20.0);
        ui.text(&self.heading, at, Style::new(BUTTON_TEXT, theme::bad()).middle());
        let bar = bar_beside(panel, panel.min.y + HEAD, panel.max().y - FOOT);
        let shown = ui.scroll(&self.heading, (lines.len(), page), bar, Turning::Lines);
        for (row, (words, begins)) in lines[shown].iter().enumerate() {
            let colour = if *begins { theme::text() } else { theme::quiet() };
            let at = panel.min + Vec2::new(LEFT, HEAD + row as f32 * height * LINE);
            ui.text(words, at, Style::new(DETAILS, colour).mono());
        }
        ui.buttons(frame.row(answers.len(), panel.max().y - PADDING - ROW_BUTTON.y), answers)
    }
}

const FIELD: Vec2 = Vec2::new(720.0, 56.0);
const NOBODY: &str = "Guest is the player who has no name yet: choose another one.";

/// What came of a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NameEntry {
    /// A name that follows the rules was submitted.
    Name(Name),
    Back,
}

/// The field and its buttons.
#[derive(Debug)]
pub struct NameField {
    field: TextField,
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
}

fn judge(text: &str) -> Result<Name, String> {
    let name = Name::new(text).map_err(|error| error.to_string())?;
    if name.is_guest() { Err(tr(NOBODY).to_owned()) } else { Ok(name) }
}
