//! The list of classics.

use super::{Buttons, Input, Key, Request};
use crate::view::layout::Frame;

/// The words on the buttons, from top to bottom.
pub const LABELS: [&str; 4] = ["Tile Run", "Jumper", "π from Collisions", "Back"];
/// From the canvas' top to the first button, of the canvas' height.
const BUTTONS_AT: f32 = 0.36;

/// The list of classics.
#[derive(Debug, Default)]
pub struct Classics {
    buttons: Buttons,
}

impl Classics {
    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.buttons.place(places(&input.frame));
        if input.pressed(Key::Escape) {
            return Some(Request::Menu);
        }
        match self.buttons.update(input)? {
            3 => Some(Request::Menu),
            _ => None,
        }
    }

    /// Its buttons: Tile Run, Jumper, π from Collisions, Back.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }
}

fn places(frame: &Frame) -> Vec<crate::view::layout::Area> {
    frame.column(LABELS.len(), (frame.size.y * BUTTONS_AT).round())
}

#[cfg(feature = "window")]
mod drawing {
    use super::{Classics, LABELS};
    use crate::view::canvas::Canvas;
    use crate::view::widgets;

    impl Classics {
        /// Draws the list.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            widgets::heading(canvas, "Classics", canvas.size().y * 0.2);
            for (i, area) in self.buttons.areas().iter().enumerate() {
                widgets::button(canvas, *area, LABELS[i], self.buttons.hover() == Some(i), self.buttons.focus() == i);
            }
        }
    }
}
