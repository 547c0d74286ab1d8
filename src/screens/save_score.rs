//! A name for a score.

use super::text_field::TextField;
use super::{Buttons, Input, Key, Request};
use crate::scores::{NAME_TYPING_MAX, Name};
use crate::view::layout::{Area, Frame, ROW_BUTTON, Vec2};

/// Width and height of the field.
const FIELD: Vec2 = Vec2::new(720.0, 56.0);

/// What is to be saved.
#[derive(Clone, Debug)]
pub struct Gain {
    /// The leaderboard: that of a level, by its name, or that of the jumper.
    pub board: String,
    /// The score.
    pub points: i64,
    /// Where the way back leads.
    pub back: Box<Request>,
}

/// The field for the name.
#[derive(Debug)]
pub struct SaveScore {
    gain: Gain,
    field: TextField,
    field_area: Area,
    /// What is wrong with the name or went wrong with saving it.
    error: Option<String>,
    /// Whether the keyboard is on the buttons.
    on_buttons: bool,
    buttons: Buttons,
}

impl SaveScore {
    /// The field for that score, with the name used before.
    pub fn new(gain: Gain, name: Option<&Name>) -> Self {
        Self {
            gain,
            field: TextField::new(name.map_or("", Name::as_str), NAME_TYPING_MAX),
            field_area: Area::default(),
            error: None,
            on_buttons: false,
            buttons: Buttons::default(),
        }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.field_area = field_area(&input.frame);
        self.buttons.place(input.frame.row(2, input.frame.size.y * 0.5 + 104.0));
        if input.pressed(Key::Escape) {
            return Some((*self.gain.back).clone());
        }
        if self.move_keyboard(input) {
            return None;
        }
        let to_field = Input { pressed: super::Keys::default(), held: super::Keys::default(), ..input.clone() };
        if self.field.update(if self.on_buttons { &to_field } else { input }) {
            self.on_buttons = false;
            // Once a name was refused, what is wrong stays in view until it is mended.
            self.error = self.error.as_ref().and_then(|_| Name::new(&self.field.text()).err()).map(|error| error.to_string());
        }
        if !self.on_buttons && input.pressed(Key::Enter) {
            return self.submit();
        }
        // While the keyboard is in the field the buttons have the mouse only.
        let to_buttons = Input { pressed: super::Keys::default(), ..input.clone() };
        match self.buttons.update(if self.on_buttons { input } else { &to_buttons })? {
            0 => self.submit(),
            _ => Some((*self.gain.back).clone()),
        }
    }

    /// Shows why the score could not be saved.
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

    /// Its buttons: Save, Back.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    fn submit(&mut self) -> Option<Request> {
        match Name::new(&self.field.text()) {
            Ok(name) => Some(Request::Submit(self.gain.clone(), name)),
            Err(error) => {
                self.error = Some(error.to_string());
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
        } else if input.pressed(Key::Up) || (input.click && self.field_area.contains(input.pointer)) {
            self.on_buttons = false;
        }
        self.on_buttons != before
    }
}

fn field_area(frame: &Frame) -> Area {
    Area::around(frame.size / 2.0 - Vec2::new(0.0, ROW_BUTTON.y / 2.0), FIELD)
}

#[cfg(feature = "window")]
mod drawing {
    use super::SaveScore;
    use crate::screens::leaderboard;
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{Area, BUTTON_TEXT, PADDING, TEXT, Vec2};
    use crate::view::{theme, widgets};

    impl SaveScore {
        /// Draws the field; `time` (s) makes the caret blink.
        pub fn draw(&self, canvas: &Canvas, time: f64) {
            widgets::graph_paper(canvas);
            let middle = canvas.size().x / 2.0;
            widgets::heading(canvas, "Save score", canvas.size().y * 0.2);
            let area = self.field_area;
            let quiet = Style::new(TEXT, theme::QUIET).middle();
            let score = format!("{} points in {}", self.gain.points, leaderboard::subject(&self.gain.board));
            canvas.text(&score, Vec2::new(middle, area.min.y - 88.0), quiet.centred());
            canvas.text("Your name", area.min - Vec2::new(0.0, 24.0), quiet);
            canvas.text("up to 15 characters", Vec2::new(area.max().x, area.min.y - 24.0), quiet.right());
            widgets::panel(canvas, area);
            if !self.on_buttons {
                widgets::focus_ring(canvas, area);
            }
            let style = Style::new(BUTTON_TEXT, theme::TEXT).mono().middle();
            let start = Vec2::new(area.min.x + PADDING, area.centre().y);
            canvas.text(&self.field.text(), start, style);
            if !self.on_buttons && time.fract() < 0.5 {
                let x = start.x + canvas.width(&self.field.before_caret(), style);
                canvas.rounded(Area::new(x, start.y - 16.0, 2.0, 32.0), 0.0, theme::ACCENT);
            }
            if let Some(error) = &self.error {
                let at = Vec2::new(middle, area.max().y + 36.0);
                widgets::fitted(canvas, error, at, canvas.size().x - 64.0, &[TEXT], theme::BAD);
            }
            // On its first frame the screen has no places for its buttons yet.
            for (i, (label, area)) in ["Save", "Back"].into_iter().zip(self.buttons.areas()).enumerate() {
                let focus = self.on_buttons && self.buttons.focus() == i;
                widgets::button(canvas, *area, label, self.buttons.hover() == Some(i), focus);
            }
        }
    }
}
