//! The list of classics.

use super::{Buttons, Input, Key, Request};
use crate::view::layout::{Area, Frame};

/// One of the classics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Classic {
    /// A run through a map of tiles.
    TileRun,
    /// A climb.
    Jumper,
    /// π from collisions.
    Pi,
}

/// The classics, in the order of their buttons.
const ALL: [Classic; 3] = [Classic::TileRun, Classic::Jumper, Classic::Pi];
/// The words on the buttons, from top to bottom.
pub const LABELS: [&str; 4] = ["Tile Run", "Jumper", "π from Collisions", "Back"];
/// From the canvas' top to the first button, of the canvas' height.
const BUTTONS_AT: f32 = 0.3;

/// The list of classics.
#[derive(Debug)]
pub struct Classics {
    buttons: Buttons,
    problem: Option<String>,
}

impl Classics {
    /// The list, with the keyboard on the one that was left, and with why one cannot be had.
    pub fn new(left: Option<Classic>, problem: Option<String>) -> Self {
        let focus = ALL.iter().position(|classic| Some(*classic) == left).unwrap_or(0);
        Self { buttons: Buttons::focused_on(focus), problem }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.buttons.place(places(&input.frame));
        if input.pressed(Key::Escape) {
            return Some(Request::Menu);
        }
        let pressed = self.buttons.update(input)?;
        Some(ALL.get(pressed).map_or(Request::Menu, |classic| Request::Classic(*classic)))
    }

    /// Its buttons: Tile Run, Jumper, π from Collisions, Back.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    /// Why a classic cannot be had.
    pub fn problem(&self) -> Option<&str> {
        self.problem.as_deref()
    }
}

fn places(frame: &Frame) -> Vec<Area> {
    frame.column(LABELS.len(), (frame.size.y * BUTTONS_AT).round())
}

mod drawing {
    use super::{Classics, LABELS};
    use crate::draw::{Canvas, Style};
    use crate::view::layout::{TEXT, Vec2};
    use crate::view::{theme, widgets};

    /// What each classic is, beneath the buttons while its button has the keyboard or the pointer.
    const ABOUT: [&str; 4] = [
        "A point runs and jumps through a map of tiles, one command a frame, exact to the last bit.",
        "Climb an endless tower, alone or together, before the view leaves you behind.",
        "Two blocks and a wall: count their collisions, and read the digits of π.",
        "",
    ];

    impl Classics {
        /// Draws the list.
        pub fn draw(&self, canvas: &Canvas) {
            widgets::graph_paper(canvas);
            widgets::heading(canvas, "Classics", canvas.size().y * 0.2);
            for (i, area) in self.buttons.areas().iter().enumerate() {
                widgets::button(canvas, *area, LABELS[i], self.buttons.hover() == Some(i), self.buttons.focus() == i);
            }
            let at = Vec2::new(canvas.size().x / 2.0, canvas.size().y * 0.8);
            match &self.problem {
                Some(problem) => widgets::fitted(canvas, problem, at, canvas.size().x - 64.0, &[TEXT], theme::bad()),
                None => {
                    let about = ABOUT[self.buttons.hover().unwrap_or(self.buttons.focus())];
                    canvas.text(about, at, Style::new(TEXT, theme::quiet()).centred().middle());
                }
            }
        }
    }
}
