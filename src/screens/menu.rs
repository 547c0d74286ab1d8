//! The main menu, with a little game of its own: a right click drops a ball.

use super::balls::Balls;
use super::level_select::Purpose;
use super::{Buttons, Input, Key, Request};
use crate::view::layout::{Area, Frame, GRID, TITLE, Vec2};

/// The words on the buttons, from top to bottom.
pub const LABELS: [&str; 7] = ["Play", "Level Select", "Leaderboards", "Classics", "Lab", "Settings", "Quit"];
/// From the canvas' top to the middle of the title's capitals, of the canvas' height.
const TITLE_AT: f32 = 0.2;
/// The title's letters, in heights of its text: what balls bounce off.
const TITLE_BOX: Vec2 = Vec2::new(4.3, 0.74);
/// From the canvas' top to the first button, of the canvas' height.
const BUTTONS_AT: f32 = 0.3;

/// The main menu.
#[derive(Debug)]
pub struct Menu {
    /// The first level that is not yet completed.
    next: Option<String>,
    buttons: Buttons,
    balls: Balls,
}

impl Menu {
    /// The menu; Play opens `next`. Whatever is random about the balls follows from `seed`.
    pub fn new(next: Option<String>, seed: u64) -> Self {
        Self { next, buttons: Buttons::default(), balls: Balls::new(seed) }
    }

    /// One frame.
    pub fn update(&mut self, input: &Input) -> Option<Request> {
        self.buttons.place(input.frame.column(LABELS.len(), button_top(&input.frame)));
        let mut obstacles = self.buttons.areas().to_vec();
        obstacles.push(title_area(&input.frame));
        self.balls.update(input, &obstacles);
        if input.pressed(Key::Escape) {
            return None; // Quit is a button, so that no one leaves by one key too many.
        }
        Some(match self.buttons.update(input)? {
            0 => self.next.clone().map_or(Request::LevelSelect(Purpose::Play), Request::Play),
            1 => Request::LevelSelect(Purpose::Play),
            2 => Request::LevelSelect(Purpose::Leaderboard),
            3 => Request::Classics(None),
            4 => Request::Lab,
            5 => Request::Settings,
            _ => Request::Quit,
        })
    }

    /// Its buttons: Play, Level Select, Leaderboards, Classics, Lab, Settings, Quit.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }

    /// The boxes of the balls, as they are drawn.
    pub fn balls(&self) -> Vec<Area> {
        self.balls.areas().collect()
    }
}

/// The box of the title's letters.
fn title_area(frame: &Frame) -> Area {
    Area::around(Vec2::new(frame.size.x / 2.0, frame.size.y * TITLE_AT), TITLE_BOX * TITLE)
}

fn button_top(frame: &Frame) -> f32 {
    (frame.size.y * BUTTONS_AT / GRID).round() * GRID
}

#[cfg(feature = "window")]
mod drawing {
    use super::{LABELS, Menu, title_area};
    use crate::view::canvas::{Canvas, Style};
    use crate::view::layout::{TEXT, TITLE, Vec2};
    use crate::view::{theme, widgets};

    /// What the title says.
    const NAME: &str = "Resultant";

    impl Menu {
        /// Draws the menu.
        pub fn draw(&self, canvas: &Canvas) {
            let frame = canvas.frame();
            widgets::graph_paper(canvas);
            for (i, area) in self.buttons.areas().iter().enumerate() {
                widgets::button(canvas, *area, LABELS[i], self.buttons.hover() == Some(i), self.buttons.focus() == i);
            }
            canvas.text(NAME, title_area(frame).centre(), Style::new(TITLE, theme::ACCENT).centred().middle());
            let quiet = Style::new(TEXT, theme::QUIET).centred().middle();
            canvas.text("Right click to drop a ball", Vec2::new(frame.size.x / 2.0, frame.size.y - 40.0), quiet);
            self.balls.draw(canvas);
        }
    }
}
