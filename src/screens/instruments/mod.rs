//! What a lesson measures with, beside the flight: a rail of buttons, which I opens, and what each of them shows. It takes the clicks and keys
//! that are its own; the flight has the rest.

mod centre;
#[cfg(feature = "window")]
mod drawing;
pub mod places;

use super::observer::pressed;
use super::{Buttons, Input, Key, Keys};
use crate::game::{Game, History};
use crate::view::focus::Focus;
use crate::view::layout::{Area, Frame};
pub use centre::centre_of_mass;
use places::Places;

/// What there is on the rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// The centre of mass of everything that moves.
    Centre,
}

impl Tool {
    /// All of them, from the top.
    pub const ALL: [Self; 1] = [Self::Centre];

    /// What stands on its button.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Centre => "Centre of mass",
        }
    }
}

/// What is shown while the instruments look on.
pub struct Stage<'a> {
    /// The game at the moment that is shown.
    pub game: &'a Game,
    /// The flight that led to it, and goes beyond it where someone went back.
    pub history: &'a History,
    /// Who is followed.
    pub focus: &'a Focus,
}

/// The instruments.
#[derive(Clone, Debug, Default)]
pub struct Instruments {
    open: bool,
    used: [bool; Tool::ALL.len()],
    rail: Buttons,
}

impl Instruments {
    /// One frame; the answer is what is left of the input for the flight.
    pub fn update(&mut self, input: &Input, _stage: &Stage) -> Input {
        let mut rest = input.clone();
        self.open ^= pressed(input, Key::I);
        if !self.open {
            return rest;
        }
        let places = self.places(&input.frame);
        self.rail.place(places.rail.clone());
        // Arrows and Enter fly.
        let pointer_only = Input { pressed: Keys::default(), ..input.clone() };
        if let Some(tool) = self.rail.update(&pointer_only) {
            self.used[tool] ^= true;
        }
        rest.click &= !places.areas().any(|area| area.contains(input.pointer));
        rest
    }

    /// The flight was left at that tick and goes on otherwise.
    pub fn back_to(&mut self, _history: &History, _tick: u64) {}

    /// The same for another flight: what is open stays open, and what was measured is put away.
    #[must_use]
    pub fn of_another_flight(self) -> Self {
        self
    }

    /// Whether the rail is there.
    pub const fn is_open(&self) -> bool {
        self.open
    }

    /// Whether a tool is in use.
    pub const fn uses(&self, tool: Tool) -> bool {
        self.open && self.used[tool as usize]
    }

    /// What covers the flight.
    pub fn areas(&self, frame: &Frame) -> Vec<Area> {
        if self.open { self.places(frame).areas().collect() } else { Vec::new() }
    }

    fn places(&self, frame: &Frame) -> Places {
        Places::new(frame, |tool| self.uses(tool))
    }
}
