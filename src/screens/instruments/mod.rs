//! What a lesson measures with, beside the flight: a rail of buttons, which I opens, and what each of them shows. It takes the clicks and keys
//! that are its own; the flight has the rest.

mod centre;
#[cfg(feature = "window")]
mod drawing;
pub mod places;
mod plot;

use super::observer::pressed;
use super::{Buttons, Input, Key, Keys, NewFile};
use crate::game::{Game, History};
use crate::view::focus::Focus;
use crate::view::layout::{Area, Frame};
pub use centre::centre_of_mass;
use places::Places;
pub use plot::{Plot, PlotPlaces, Reading};
use std::path::PathBuf;

/// What there is on the rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// The centre of mass of everything that moves.
    Centre,
    /// Curves of what two objects do.
    Plot,
}

impl Tool {
    /// All of them, from the top.
    pub const ALL: [Self; 2] = [Self::Centre, Self::Plot];

    /// What stands on its button.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Centre => "Centre of mass",
            Self::Plot => "Plot",
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
    /// Whether the world stands still, or is watched, and can be taken to another moment of the flight.
    pub seekable: bool,
    /// The run before the last change, where the level is varied: its curves stay, pale, to be compared.
    pub before: Option<&'a History>,
}

/// The instruments.
#[derive(Clone, Debug, Default)]
pub struct Instruments {
    open: bool,
    used: [bool; Tool::ALL.len()],
    rail: Buttons,
    plot: Plot,
}

impl Instruments {
    /// One frame; the answer is what is left of the input for the flight.
    pub fn update(&mut self, input: &Input, stage: &Stage) -> Input {
        let whole = input.frame;
        self.open ^= pressed(input, Key::I);
        // The plot has the foot of the canvas, everything else what is above it.
        let input = &if self.uses(Tool::Plot) { self.plot.update(input, stage) } else { input.clone() };
        let mut rest = Input { frame: whole, ..input.clone() };
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
    pub fn back_to(&mut self, history: &History, tick: u64) {
        self.plot.back_to(history, tick);
    }

    /// The flight was flown again in a level that was varied, or there is another run before: whatever was read is read anew.
    pub fn flown_again(&mut self) {
        self.plot.flown_again();
    }

    /// The same for another flight: what is open stays open, and what was measured is put away.
    #[must_use]
    pub fn of_another_flight(self) -> Self {
        Self { plot: self.plot.of_another_flight(), ..self }
    }

    /// The moment of the flight, in ticks, to which the world is to be taken.
    pub fn take_seek(&mut self) -> Option<u64> {
        self.plot.take_seek()
    }

    /// A file that is to be written.
    pub fn take_export(&mut self) -> Option<NewFile> {
        self.plot.take_export()
    }

    /// What became of it.
    pub fn tell_of_export(&mut self, told: Result<PathBuf, String>) {
        self.plot.tell_of_export(told);
    }

    /// Whether objects are picked out also while the details are closed.
    pub const fn picks(&self) -> bool {
        self.uses(Tool::Plot)
    }

    /// Whether a flight that has ended stays on the screen to be looked at.
    pub const fn stays(&self) -> bool {
        self.uses(Tool::Plot)
    }

    /// The plot.
    pub const fn plot(&self) -> &Plot {
        &self.plot
    }

    /// The part of the canvas in which the flight is.
    pub fn room(&self, frame: &Frame) -> Frame {
        if self.uses(Tool::Plot) { self.plot.above(frame) } else { *frame }
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
        let plot = self.uses(Tool::Plot).then(|| self.plot.area(frame));
        if self.open { self.places(&self.room(frame)).areas().chain(plot).collect() } else { Vec::new() }
    }

    fn places(&self, frame: &Frame) -> Places {
        Places::new(frame, |tool| self.uses(tool))
    }
}
