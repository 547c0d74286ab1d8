//! The measuring instruments beside the flight: a rail of buttons, which I opens, and a panel each. The flight has what they leave of the input.

mod dock;
mod figures;
mod measure;
mod measured;
mod panels;
mod plot;
mod ruler;
pub mod vary;
mod vectors;

use crate::draw::layout::{Area, DETAILS, Frame, Vec2};
use crate::words::tr;
use crate::{draw::Style, game::Game, game::History, settings::Action, ui::Ui, ui::input::Input, view::focus::Focus, view::theme};
pub use measure::Measures;
pub use plot::{Plot, PlotPlaces};
use vary::Vary;

/// A canvas with less than this many heights of the text in its width has room for one large panel.
const NARROW: f32 = 80.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// Of everything that moves.
    Centre,
    /// Places ten times a second.
    Trails,
    Vectors,
    Ruler,
    Figures,
    Plot,
    Vary,
}

impl Tool {
    /// From the top.
    pub const ALL: [Self; 7] = [Self::Centre, Self::Trails, Self::Vectors, Self::Ruler, Self::Figures, Self::Plot, Self::Vary];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Centre => "Centre of mass",
            Self::Trails => "Trails",
            Self::Vectors => "v and a",
            Self::Ruler => "Ruler",
            Self::Figures => "Energy, work",
            Self::Plot => "Plot",
            Self::Vary => "What if …",
        }
    }
}

fn is_narrow(room: &Frame) -> bool {
    room.size.x < NARROW * room.text_height(DETAILS)
}

pub struct Stage<'a> {
    /// At the moment on the screen.
    pub game: &'a Game,
    /// The whole flight, which may go beyond that moment.
    pub history: &'a History,
    pub focus: &'a Focus,
    pub varied: Option<vary::Varied<'a>>,
    /// Whether the world can go to another moment: in a pause or in a replay.
    pub seekable: bool,
    pub seen: bool,
    /// The height above the flight's foot that its signs need, canvas units.
    pub sign: f32,
    /// The run before the last change of a varied level; its curves stay, pale, for comparison.
    pub before: Option<&'a History>,
}

#[derive(Clone, Debug, Default)]
pub struct Instruments {
    open: bool,
    used: [bool; Tool::ALL.len()],
    measures: Measures,
    pub(super) plot: Plot,
    pub(super) vary: Vary,
    /// Not in a replay.
    can_vary: bool,
}

impl Instruments {
    /// Shows rail and panels on that frame of the canvas; returns the input that remains for the flight.
    pub fn show(&mut self, ui: &mut Ui<'_>, frame: Frame, stage: &Stage) -> Input {
        let input = if ui.is_live() { ui.input().clone() } else { ui.input().without_edges() };
        if self.open {
            ui.canvas().end_layer();
        }
        // Arrows and Enter fly.
        ui.by_pointer(|ui| self.show_panels(ui, &Input { frame, ..input }, stage))
    }

    fn show_panels(&mut self, ui: &mut Ui<'_>, input: &Input, stage: &Stage) -> Input {
        let whole = input.frame;
        self.can_vary = stage.varied.is_some();
        // Typing flies nothing.
        let mut rest = if self.vary.is_typing() { input.without_keys() } else { input.clone() };
        self.open ^= rest.acts(Action::Instruments);
        // Words may have grown since both were opened.
        if self.used[Tool::Vary as usize] && is_narrow(&self.room(&whole)) {
            self.used[Tool::Figures as usize] = false;
        }
        if self.open {
            self.show_rail(ui, &self.room(&whole));
        }
        let is_covered = |instruments: &Self| instruments.areas(&whole).iter().any(|area| area.contains(input.pointer));
        // The plot has the foot of the canvas, the others the room above it.
        rest.frame = self.room(&whole);
        self.measures.used = if self.open { self.used } else { Default::default() };
        if self.open {
            let covered = is_covered(self) || self.plot.is_picking();
            rest = self.measures.show(ui, &rest, stage, covered);
        }
        let free = self.uses(Tool::Vary) && stage.seen && !is_covered(self) && !ui.has_widget_at(input.pointer);
        if let Some(varied) = &stage.varied {
            let inside = rest.frame.area().contains(input.pointer);
            self.vary.lead(&mut rest, (varied, stage.game.level()), free && inside);
        }
        let above = Frame { size: rest.frame.size - Vec2::new(0.0, stage.sign), ..rest.frame };
        self.vary.show(ui, &above, stage, self.uses(Tool::Vary));
        rest.frame = whole;
        if self.uses(Tool::Plot) {
            rest = self.plot.show(ui, &rest, stage);
        }
        if is_covered(self) {
            (rest.click, rest.wheel) = (false, 0.0);
        }
        rest
    }

    fn show_rail(&mut self, ui: &mut Ui<'_>, room: &Frame) {
        for (tool, area) in Tool::ALL.into_iter().zip(dock::rail(room)) {
            let colour = match (self.offers(tool), self.uses(tool)) {
                (false, _) => theme::quiet(),
                (true, true) => theme::accent(),
                (true, false) => theme::text(),
            };
            let pressed = ui.small_button((tool.name(), tr(tool.name())), area, Style::new(DETAILS, colour));
            if pressed && self.offers(tool) {
                self.open_or_close(tool, room);
            }
        }
    }

    /// On a narrow canvas, opens one large panel in the place of another.
    fn open_or_close(&mut self, tool: Tool, room: &Frame) {
        const LARGE: [Tool; 2] = [Tool::Figures, Tool::Vary];
        if is_narrow(room) && !self.used[tool as usize] && LARGE.contains(&tool) {
            LARGE.iter().for_each(|other| self.used[*other as usize] = false);
        }
        self.used[tool as usize] ^= true;
    }

    pub fn read(&mut self, stage: &Stage) {
        if self.open {
            self.measures.read(stage);
        }
    }

    /// The flight was left at that tick and goes on otherwise.
    pub fn back_to(&mut self, history: &History, tick: u64) {
        self.measures.back_to(tick);
        self.plot.back_to(history, tick);
    }

    /// The flight was flown again in a varied level, or another run stands before it: all is read from its start.
    pub fn flown_again(&mut self) {
        self.measures.flown_again();
        self.plot.flown_again();
    }

    pub fn vary_area(&self) -> Option<Area> {
        self.vary.area()
    }

    /// The same for another flight: panels stay open, readings go.
    #[must_use]
    pub fn of_another_flight(self) -> Self {
        Self { measures: self.measures.of_another_flight(), plot: self.plot.of_another_flight(), ..self }
    }

    /// Whether a flight that has ended stays on the screen for its instruments.
    pub const fn stays(&self) -> bool {
        self.uses(Tool::Plot)
    }

    pub const fn plot(&self) -> &Plot {
        &self.plot
    }

    /// The flight's part of the canvas.
    pub fn room(&self, frame: &Frame) -> Frame {
        if self.uses(Tool::Plot) { self.plot.above(frame) } else { *frame }
    }

    pub const fn is_open(&self) -> bool {
        self.open
    }

    pub fn offers(&self, tool: Tool) -> bool {
        tool != Tool::Vary || self.can_vary
    }

    pub const fn uses(&self, tool: Tool) -> bool {
        self.open && self.used[tool as usize]
    }

    pub fn areas(&self, frame: &Frame) -> Vec<Area> {
        if !self.open {
            return Vec::new();
        }
        let plot = self.uses(Tool::Plot).then(|| self.plot.area(frame));
        dock::rail(&self.room(frame)).into_iter().chain(plot).chain(self.measures.areas()).chain(self.vary.area()).collect()
    }

    pub const fn measures(&self) -> &Measures {
        &self.measures
    }
}
