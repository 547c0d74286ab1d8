//! A name for a score, where whoever plays has none yet, or where saving takes a second try.

use super::leaderboard::Way;
use super::name_field::{Entry, NameField};
use super::{Buttons, Flown, Input, Request};
use crate::scores::Name;
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
    /// Where the way back leads.
    pub back: Box<Request>,
    /// Where the leaderboard leads once it is saved.
    pub ways: Vec<Way>,
}

/// The field for the name.
#[derive(Debug)]
pub struct SaveScore {
    gain: Gain,
    field: NameField,
}

impl SaveScore {
    /// The field for that score, with the name of whoever plays.
    pub fn new(gain: Gain, name: Option<&Name>) -> Self {
        Self { gain, field: NameField::new(name.map_or("", Name::as_str)) }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        Some(match self.field.update(input)? {
            Entry::Name(name) => Request::Submit(self.gain.clone(), name),
            Entry::Back => (*self.gain.back).clone(),
        })
    }

    /// Shows why the score could not be saved.
    pub fn refuse(&mut self, error: String) {
        self.field.refuse(error);
    }

    /// What is in the field.
    pub fn text(&self) -> String {
        self.field.text()
    }

    /// What is wrong, while it is.
    pub fn error(&self) -> Option<&str> {
        self.field.error()
    }

    /// Its buttons: Save, Back.
    pub fn buttons(&self) -> &Buttons {
        self.field.buttons()
    }
}

mod drawing {
    use super::SaveScore;
    use crate::draw::Canvas;
    use crate::view::widgets;

    impl SaveScore {
        /// Draws the field; `time` (s) makes the caret blink.
        pub fn draw(&self, canvas: &Canvas, time: f64) {
            widgets::graph_paper(canvas);
            widgets::heading(canvas, "Save score", canvas.size().y * 0.2);
            let score = format!("{} points in {}", self.gain.points, self.gain.subject);
            self.field.draw(canvas, (&score, "Save"), time);
        }
    }
}
