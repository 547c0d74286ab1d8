//! A row of buttons at the foot of a scene whose arrow keys have other work: each has a key of its own.

use super::{ButtonAnswer, Buttons, Input, Key, Keys};
use crate::draw::layout::{Area, Frame, GAP, ROW_BUTTON, Vec2};

/// From the row to the canvas' foot and sides.
const MARGIN: f32 = 24.0;

/// The row.
#[derive(Clone, Debug, Default)]
pub struct Toolbar {
    buttons: Buttons,
}

impl Toolbar {
    /// Lays out a button for each key and returns the index of the one that was clicked or whose key was pressed.
    pub fn update(&mut self, input: &Input, keys: &[Key]) -> Option<usize> {
        self.buttons.place(places(&input.frame, keys.len()));
        let pointer_only = Input { pressed: Keys::default(), ..input.clone() };
        let pressed = self.buttons.update(&pointer_only).or_else(|| keys.iter().position(|key| input.pressed(*key)));
        if pressed.is_some() {
            input.answer(ButtonAnswer::Pressed);
        }
        pressed
    }

    /// The buttons.
    pub fn buttons(&self) -> &Buttons {
        &self.buttons
    }
}

fn places(frame: &Frame, count: usize) -> Vec<Area> {
    let all = frame.size.x - 2.0 * MARGIN + GAP;
    let pitch = (all / count.max(1) as f32).min(ROW_BUTTON.x + GAP);
    let left = (frame.size.x - pitch * count as f32 + GAP) / 2.0;
    let (top, size) = (frame.size.y - ROW_BUTTON.y - MARGIN, Vec2::new(pitch - GAP, ROW_BUTTON.y));
    (0..count).map(|i| Area { min: Vec2::new(left + i as f32 * pitch, top), size }).collect()
}

mod drawing {
    use super::Toolbar;
    use crate::draw::Canvas;
    use crate::view::widgets;

    impl Toolbar {
        /// Draws the row: on each button what it does, and its key.
        pub fn draw(&self, canvas: &Canvas, labels: &[(&str, &str)]) {
            for ((i, area), (label, key)) in self.buttons.areas().iter().enumerate().zip(labels.iter().copied()) {
                widgets::keyed_button(canvas, *area, (label, key), (self.buttons.hover() == Some(i), false));
            }
        }
    }
}
