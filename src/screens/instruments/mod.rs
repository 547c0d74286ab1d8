//! What a lesson measures with, beside the flight: a rail of buttons, which I opens, and what each of them shows. It takes the clicks and keys
//! that are its own; the flight has the rest.

mod dock;
mod drawing;
mod figures;
mod measure;
mod measured;
mod panels;
pub mod places;
mod plot;
mod ruler;
pub mod vary;
mod vectors;

use super::{Buttons, Input, Keys, NewFile};
use crate::draw::layout::{Area, Frame};
use crate::game::{Game, History};
use crate::settings::Action;
use crate::view::focus::Focus;
pub use figures::Table;
pub use measure::Measures;
use places::Places;
pub use plot::{Plot, PlotPlaces, Reading};
use std::path::PathBuf;
use vary::Vary;

/// What there is on the rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// The centre of mass of everything that moves.
    Centre,
    /// Where things were, ten times a second.
    Trails,
    /// Arrows of velocity and acceleration.
    Vectors,
    /// A ruler.
    Ruler,
    /// A stop clock.
    StopClock,
    /// Momentum, energy and work.
    Figures,
    /// Curves of what two objects do.
    Plot,
    /// Numbers of the level are varied.
    Vary,
}

impl Tool {
    /// All of them, from the top.
    pub const ALL: [Self; 8] =
        [Self::Centre, Self::Trails, Self::Vectors, Self::Ruler, Self::StopClock, Self::Figures, Self::Plot, Self::Vary];

    /// What stands on its button.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Centre => "Centre of mass",
            Self::Trails => "Trails",
            Self::Vectors => "v and a",
            Self::Ruler => "Ruler",
            Self::StopClock => "Stop clock",
            Self::Figures => "Energy, work",
            Self::Plot => "Plot",
            Self::Vary => "What if …",
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
    /// The level that can be varied, where it can.
    pub varied: Option<vary::Varied<'a>>,
    /// Whether the world stands still, or is watched, and can be taken to another moment of the flight.
    pub seekable: bool,
    /// The run before the last change, where the level is varied: it stays, and its curves, pale, to be compared.
    pub before: Option<&'a History>,
}

/// The instruments.
#[derive(Clone, Debug, Default)]
pub struct Instruments {
    open: bool,
    used: [bool; Tool::ALL.len()],
    rail: Buttons,
    measures: Measures,
    plot: Plot,
    vary: Vary,
    /// Whether the level that is shown can be varied: not that of a flight which is watched.
    can_vary: bool,
}

impl Instruments {
    /// One frame; the answer is what is left of the input for the flight.
    pub fn update(&mut self, input: &Input, stage: &Stage) -> Input {
        let whole = input.frame;
        self.can_vary = stage.varied.is_some();
        // The plot has the foot of the canvas, everything else what is above it.
        let above = Input { frame: self.room(&whole), ..input.clone() };
        let input = Input { frame: whole, ..self.vary.update(&above, stage, self.uses(Tool::Vary)) };
        self.open ^= input.acts(Action::Instruments);
        let input = if self.uses(Tool::Plot) { self.plot.update(&input, stage) } else { input };
        if !self.open {
            return Input { frame: whole, ..input };
        }
        let places = self.places(&input.frame);
        self.rail.place(places.rail.clone());
        // Arrows and Enter fly.
        let pointer_only = Input { pressed: Keys::default(), ..input.clone() };
        if let Some(tool) = self.rail.update(&pointer_only).filter(|tool| self.offers(Tool::ALL[*tool])) {
            self.used[tool] ^= true;
        }
        let used = self.used;
        let covered = self.areas(&whole).iter().any(|area| area.contains(input.pointer));
        let mut rest = self.measures.update(&input, stage, (&places.rail, covered), |tool| used[tool as usize]);
        if self.areas(&whole).iter().any(|area| area.contains(input.pointer)) {
            (rest.click, rest.wheel) = (false, 0.0);
        }
        Input { frame: whole, ..rest }
    }

    /// Reads what is known of the moment that is drawn, at the end of its frame.
    pub fn read(&mut self, stage: &Stage) {
        if self.open {
            let used = self.used;
            self.measures.read(stage, |tool| used[tool as usize]);
        }
    }

    /// The flight was left at that tick and goes on otherwise.
    pub fn back_to(&mut self, history: &History, tick: u64) {
        self.measures.back_to(tick);
        self.plot.back_to(history, tick);
    }

    /// The flight was flown again in a level that was varied, or there is another run before: whatever was read is read anew.
    pub fn flown_again(&mut self) {
        self.measures.flown_again();
        self.plot.flown_again();
    }

    /// The panel that varies the level.
    pub const fn vary(&self) -> &Vary {
        &self.vary
    }

    /// The same, to take its wishes and to tell it what became of them.
    pub(super) const fn vary_mut(&mut self) -> &mut Vary {
        &mut self.vary
    }

    /// The same for another flight: what is open stays open, and what was measured is put away.
    #[must_use]
    pub fn of_another_flight(self) -> Self {
        Self { measures: self.measures.of_another_flight(), plot: self.plot.of_another_flight(), ..self }
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

    /// Whether a tool can be used here.
    pub fn offers(&self, tool: Tool) -> bool {
        tool != Tool::Vary || self.can_vary
    }

    /// Whether a tool is in use.
    pub const fn uses(&self, tool: Tool) -> bool {
        self.open && self.used[tool as usize]
    }

    /// What covers the flight.
    pub fn areas(&self, frame: &Frame) -> Vec<Area> {
        if !self.open {
            return Vec::new();
        }
        let plot = self.uses(Tool::Plot).then(|| self.plot.area(frame));
        let places = self.places(&self.room(frame));
        places.areas().chain(plot).chain(self.measures.areas()).chain(self.vary.area()).collect()
    }

    /// What is measured with at the left.
    pub const fn measures(&self) -> &Measures {
        &self.measures
    }

    fn places(&self, frame: &Frame) -> Places {
        Places::new(frame, |tool| self.uses(tool))
    }
}
