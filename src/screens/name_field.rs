//! A field for a name, and two buttons below it.

use super::text_field::TextField;
use super::{Buttons, Input, Key, Keys};
use crate::scores::{NAME_TYPING_MAX, Name};
use crate::view::layout::{Area, Frame, ROW_BUTTON, Vec2};

/// Width and height of the field.
const FIELD: Vec2 = Vec2::new(720.0, 56.0);
/// What is wrong with the name of those who have none.
const NOBODY: &str = "Guest is whoever has no name yet: choose another one.";

/// What came of a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Entry {
    /// A name that follows the rules was submitted.
    Name(Name),
    /// The way back was chosen.
    Back,
}

/// The field and its buttons.
#[derive(Debug)]
pub struct NameField {
    field: TextField,
    area: Area,
    /// What is wrong with the name or went wrong with it.
    error: Option<String>,
    /// Whether the keyboard is on the buttons.
    on_buttons: bool,
    buttons: Buttons,
}

impl NameField {
    /// A field that begins with that text.
    pub fn new(text: &str) -> Self {
        Self {
            field: TextField::new(text, NAME_TYPING_MAX),
            area: Area::default(),
            error: None,
            on_buttons: false,
            buttons: Buttons::default(),
        }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Entry> {
        self.area = field_area(&input.frame);
        self.buttons.place(input.frame.row(2, input.frame.size.y * 0.5 + 104.0));
        if input.pressed(Key::Escape) {
            return Some(Entry::Back);
        }
        if self.move_keyboard(input) {
            return None;
        }
        let to_field = Input { pressed: Keys::default(), held: Keys::default(), ..input.clone() };
        if self.field.update(if self.on_buttons { &to_field } else { input }) {
            self.on_buttons = false;
            // Once a name was refused, what is wrong stays in view until it is mended.
            self.error = self.error.as_ref().and_then(|_| judge(&self.field.text()).err());
        }
        if !self.on_buttons && input.pressed(Key::Enter) {
            return self.submit();
        }
        // While the keyboard is in the field the buttons have the mouse only.
        let to_buttons = Input { pressed: Keys::default(), ..input.clone() };
        let pressed = self.buttons.update(if self.on_buttons { input } else { &to_buttons });
        self.on_buttons |= self.buttons.hover().is_some();
        match pressed? {
            0 => self.submit(),
            _ => Some(Entry::Back),
        }
    }

    /// Shows what went wrong with the name.
    pub fn refuse(&mut self, error: String) {
        self.error = Some(error);
    }

    /// What is in the field.
    pub fn text(&self) -> String {
        self.field.text()
    }

    /// What is wrong, while it is.
    pub fn error(&self) -> Option<&str> {
        self.error.as_deref()
    }

    /// The buttons: submit, back.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    fn submit(&mut self) -> Option<Entry> {
        match judge(&self.field.text()) {
            Ok(name) => Some(Entry::Name(name)),
            Err(error) => {
                self.error = Some(error);
                None
            }
        }
    }

    /// ↓, ↑, Tab and the mouse move the keyboard between the field and the buttons; whether they just did.
    fn move_keyboard(&mut self, input: &Input) -> bool {
        let before = self.on_buttons;
        if input.pressed(Key::Tab) {
            self.on_buttons = !self.on_buttons;
        } else if input.pressed(Key::Down) {
            self.on_buttons = true;
        } else if input.pressed(Key::Up) || (input.click && self.area.contains(input.pointer)) {
            self.on_buttons = false;
        }
        if before && !self.on_buttons {
            self.field.select_all();
        }
        self.on_buttons != before
    }
}

fn judge(text: &str) -> Result<Name, String> {
    let name = Name::new(text).map_err(|error| error.to_string())?;
    if name.is_guest() { Err(NOBODY.to_owned()) } else { Ok(name) }
}

fn field_area(frame: &Frame) -> Area {
    Area::around(frame.size / 2.0 - Vec2::new(0.0, ROW_BUTTON.y / 2.0), FIELD)
}

mod drawing {
    use super::NameField;
    use crate::draw::{Canvas, Style};
    use crate::view::layout::{BUTTON_TEXT, PADDING, TEXT, Vec2};
    use crate::view::{theme, widgets};

    impl NameField {
        /// Draws the field with a line above it, and the buttons; `time` (s) makes the caret blink.
        pub fn draw(&self, canvas: &Canvas, (above, submit): (&str, &str), time: f64) {
            let middle = canvas.size().x / 2.0;
            let area = self.area;
            let quiet = Style::new(TEXT, theme::quiet()).middle();
            let widest = canvas.size().x - 64.0;
            widgets::fitted(canvas, above, Vec2::new(middle, area.min.y - 88.0), widest, &[TEXT], theme::quiet());
            canvas.text("Your name", area.min - Vec2::new(0.0, 24.0), quiet);
            canvas.text("up to 15 characters", Vec2::new(area.max().x, area.min.y - 24.0), quiet.right());
            widgets::panel(canvas, area);
            if !self.on_buttons {
                widgets::focus_ring(canvas, area);
            }
            self.field.draw(canvas, area, (BUTTON_TEXT, PADDING), (!self.on_buttons).then_some(time));
            if let Some(error) = &self.error {
                let at = Vec2::new(middle, area.max().y + 36.0);
                widgets::fitted(canvas, error, at, widest, &[TEXT], theme::bad());
            }
            // On its first frame the screen has no places for its buttons yet.
            for (i, (label, area)) in [submit, "Back"].into_iter().zip(self.buttons.areas()).enumerate() {
                let focus = self.on_buttons && self.buttons.focus() == i;
                widgets::button(canvas, *area, label, self.buttons.hover() == Some(i), focus);
            }
        }
    }
}
