//! A panel that asks for one line of text: a new name.

use super::text_field::TextField;
use super::{Buttons, Input, Key, Keys};
use crate::view::layout::{Area, Frame, GAP, PADDING, ROW_BUTTON, Vec2};

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
    panel: Area,
    buttons: Buttons,
}

impl Prompt {
    /// A panel with that heading, whose field begins with that text.
    pub fn new(heading: impl Into<String>, text: &str) -> Self {
        let mut prompt = Self {
            heading: heading.into(),
            field: TextField::new(text, MOST),
            note: None,
            error: None,
            panel: Area::default(),
            buttons: Buttons::default(),
        };
        prompt.place(&Frame::default());
        prompt
    }

    /// The same with a line below its field.
    #[must_use]
    pub fn with_note(self, note: String) -> Self {
        Self { note: Some(note), ..self }
    }

    fn place(&mut self, frame: &Frame) {
        self.panel = Area::around(frame.size / 2.0, PANEL);
        let (centre, y) = (self.panel.centre().x, self.panel.max().y - PADDING - ROW_BUTTON.y);
        let left = centre - ROW_BUTTON.x - GAP / 2.0;
        let button = |i: usize| Area { min: Vec2::new(left + i as f32 * (ROW_BUTTON.x + GAP), y), size: ROW_BUTTON };
        self.buttons.place(vec![button(0), button(1)]);
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Reply> {
        self.place(&input.frame);
        if input.pressed(Key::Escape) {
            return Some(Reply::Cancel);
        }
        if self.field.update(input) {
            self.error = None;
        }
        let mouse = Input { pressed: Keys::default(), ..input.clone() };
        match (self.buttons.update(&mouse), input.pressed(Key::Enter)) {
            (Some(1), _) => Some(Reply::Cancel),
            (Some(_), _) | (None, true) => Some(Reply::Text(self.field.text().trim().to_owned())),
            (None, false) => None,
        }
    }

    /// Says why the text will not do.
    pub fn refuse(&mut self, error: String) {
        self.error = Some(error);
    }

    /// What is asked for.
    pub fn heading(&self) -> &str {
        &self.heading
    }

    /// What is in the field.
    pub fn text(&self) -> String {
        self.field.text()
    }

    /// The line below its field, where there is one.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// Why the text will not do, while that is shown.
    pub fn error(&self) -> Option<&str> {
        self.error.as_deref()
    }

    /// The buttons: OK, Cancel.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }
}

mod drawing {
    use super::Prompt;
    use crate::draw::Canvas;
    use crate::view::layout::{Area, BUTTON_TEXT, DETAILS, PADDING, TEXT, Vec2};
    use crate::view::{theme, widgets};

    impl Prompt {
        /// Draws the panel above all else.
        pub fn draw(&self, canvas: &Canvas, time: f64) {
            widgets::curtain(canvas, 0.7);
            let panel = self.panel;
            widgets::panel(canvas, panel);
            let middle = panel.centre().x;
            let at = Vec2::new(middle, panel.min.y + 36.0);
            widgets::fitted(canvas, &self.heading, at, panel.size.x - 2.0 * PADDING, &[BUTTON_TEXT, TEXT, DETAILS], theme::text());
            let field = Area::new(panel.min.x + PADDING, panel.min.y + 72.0, panel.size.x - 2.0 * PADDING, 52.0);
            widgets::panel_in(canvas, field, theme::ground(), theme::accent());
            self.field.draw(canvas, field, (BUTTON_TEXT, PADDING), Some(time));
            let below = [(self.error.as_deref(), theme::bad()), (self.note(), theme::quiet())];
            if let Some((words, colour)) = below.into_iter().find_map(|(words, colour)| Some((words?, colour))) {
                let at = Vec2::new(middle, field.max().y + 28.0);
                widgets::fitted(canvas, words, at, panel.size.x - 2.0 * PADDING, &[TEXT, DETAILS], colour);
            }
            for (i, (label, area)) in ["OK", "Cancel"].into_iter().zip(self.buttons.areas()).enumerate() {
                widgets::button(canvas, *area, label, self.buttons.hover() == Some(i), i == 0);
            }
        }
    }
}
