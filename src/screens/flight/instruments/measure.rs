//! The instruments at the left: trails, vectors, the ruler, the table of momentum, energy and work. They have the pointer before the flight.

use super::dock::{self, dock};
use super::figures::{Figures, Table, in_focus};
use super::{Stage, Tool, ruler::Click, ruler::Ruler, vectors::Scales};
use crate::draw::layout::{Area, Frame, GRID, Vec2};
use crate::{instruments::track::Trail, physics::BodyId};
use crate::{ui::Ui, ui::input::Input, view::focus::Focus};

/// Ticks of reading in a frame, at most.
const AHEAD: u64 = 600;
/// The pointer takes the line of zero potential energy up to this far away, pixels of the level.
const ZERO_NEAR: f64 = 10.0;
/// The words on the buttons of the table.
pub const TABLE_WORDS: [&str; 3] = ["From now", "From start", "Zero here"];
/// The longest arrow, in parts of the window's height.
const LONGEST: f64 = 0.25;
/// The least characters of the table's names and of its numbers, so that it seldom changes its width.
const NAMES: usize = 16;
const NUMBERS: usize = 10;
/// The least pitch of the table's rows, in lines.
const TIGHT: f32 = 0.8;

#[derive(Clone, Debug, Default)]
pub struct Measures {
    pub(super) focus: Focus,
    pub trail: Trail,
    pub(super) scales: Scales,
    pub ruler: Ruler,
    pub(super) figures: Figures,
    pub(super) used: [bool; Tool::ALL.len()],
    pub(super) panels: Vec<(Tool, Area)>,
    pub(super) frame: Frame,
    foot: f32,
    /// Each panel's offset from its place, and the held panel with the last place of the pointer.
    dragged: [Vec2; Tool::ALL.len()],
    hold: Option<(Tool, Vec2)>,
}

impl Measures {
    /// Shows the panels beside the rail; `covered` where another instrument has the pointer. Returns the rest of the input.
    pub fn show(&mut self, ui: &mut Ui<'_>, input: &Input, stage: &Stage, covered: bool) -> Input {
        let mut rest = input.clone();
        let world = stage.game.world();
        if self.uses(Tool::Vectors) {
            let most = LONGEST * f64::from(input.frame.size.y) / stage.game.level().metre;
            let bodies = in_focus(stage.focus, stage.game);
            self.scales.update(input.frame_time, world, &bodies, (most, stage.focus.length()));
        }
        self.frame = input.frame;
        self.drag(input, ui.has_widget_at(input.pointer));
        for (tool, area) in self.panels.clone() {
            if tool == Tool::Figures {
                self.show_table(ui, area, stage.game);
            }
        }
        let free = !covered && input.frame.area().contains(input.pointer);
        let level = stage.game.level();
        if self.uses(Tool::Figures) && self.figures.drag_zero(input, level, (ZERO_NEAR / level.metre, free)) {
            rest.click = false;
            return rest;
        }
        if self.uses(Tool::Ruler) {
            match self.ruler.update(input, world, stage.game.level().metre, free) {
                Click::Others => {}
                Click::Rulers => rest.click = false,
                Click::GivenBack => rest.click = true,
            }
        }
        rest
    }

    pub(super) const fn uses(&self, tool: Tool) -> bool {
        self.used[tool as usize]
    }

    /// Reads the trails and the table of the moment on the screen, and places the panels.
    pub fn read(&mut self, stage: &Stage) {
        self.focus = *stage.focus;
        if self.uses(Tool::Trails) {
            let all = || (0..stage.game.world().bodies().len() as u32).map(BodyId).collect();
            let bodies = self.focus.followed.map_or_else(all, |_| in_focus(&self.focus, stage.game));
            self.trail.go(stage.history, stage.game.ticks(), AHEAD, &bodies);
        }
        if self.uses(Tool::Figures) {
            self.figures.update(stage);
        }
        self.foot = dock::foot(&self.frame, stage.sign);
        let shown: Vec<(Tool, Vec2)> = [Tool::Vectors, Tool::Figures]
            .into_iter()
            .filter(|tool| self.uses(*tool))
            .map(|tool| (tool, self.size(tool, &self.frame)))
            .collect();
        let sizes: Vec<Vec2> = shown.iter().map(|(_, size)| *size).collect();
        let docked = dock(self.foot, &dock::rail(&self.frame), &sizes).into_iter();
        self.panels = shown.iter().zip(docked).map(|((tool, _), area)| (*tool, self.where_dragged(*tool, area))).collect();
    }

    /// The pointer takes a panel anywhere but at its buttons, and moves it.
    fn drag(&mut self, input: &Input, at_button: bool) {
        if let Some((tool, from)) = self.hold.filter(|_| input.holding) {
            self.dragged[tool as usize] += input.pointer - from;
            self.hold = Some((tool, input.pointer));
        } else {
            let taken = self.panels.iter().find(|(_, area)| input.click && !at_button && area.contains(input.pointer));
            self.hold = taken.map(|(tool, _)| (*tool, input.pointer));
        }
    }

    fn where_dragged(&mut self, tool: Tool, docked: Area) -> Area {
        let most = (self.frame.size - docked.size).max(Vec2::ZERO);
        let min = (docked.min + self.dragged[tool as usize]).clamp(Vec2::ZERO, most);
        if self.hold.is_none() {
            // The next drag begins at the clamped place.
            self.dragged[tool as usize] = min - docked.min;
        }
        Area { min, ..docked }
    }

    /// The same for another flight: panels stay in their places, readings go.
    #[must_use]
    pub fn of_another_flight(self) -> Self {
        Self { dragged: self.dragged, ..Self::default() }
    }

    /// The flight starts again in another level: the ruler stays.
    pub fn flown_again(&mut self) {
        (self.trail, self.figures) = (Trail::default(), self.figures.flown_again());
    }

    pub fn back_to(&mut self, tick: u64) {
        self.trail.back_to(tick);
        self.figures.back_to(tick);
    }

    pub fn areas(&self) -> impl Iterator<Item = Area> {
        self.panels.iter().map(|(_, area)| *area)
    }

    pub const fn table(&self) -> &Table {
        self.figures.table()
    }

    /// The characters of the table's names and of each column.
    pub(super) fn columns(&self) -> (usize, usize) {
        let table = self.figures.table();
        let count = |text: &String| text.chars().count();
        let numbers = table.lines.iter().filter(|line| !line.values.is_empty());
        let names = numbers.clone().map(|line| count(&line.name)).fold(NAMES, usize::max);
        let values = numbers.flat_map(|line| &line.values).chain(&table.columns).map(count).fold(NUMBERS, usize::max);
        (names, values + 1)
    }

    /// From one row of the table to the next, less than a line where all of them would not fit, and whether there is room for bars.
    pub(super) fn table_rows(&self) -> (f32, bool) {
        let (table, line) = (self.figures.table(), dock::line(&self.frame));
        let room = self.foot - GRID - line - 4.5 * GRID;
        let (least, lines) = (TIGHT * line, table.lines.len() + 1);
        let pitch = |rows: usize| (room / rows as f32).min(line);
        let all = pitch(lines + table.bars.len());
        if all >= least { (all, true) } else { (pitch(lines).max(least), false) }
    }

    fn size(&self, tool: Tool, frame: &Frame) -> Vec2 {
        let line = dock::line(frame);
        let inside = match tool {
            Tool::Vectors => Vec2::new(dock::width(frame, 25), 2.0 * line),
            _ => {
                let (names, values) = self.columns();
                let table = self.figures.table();
                let characters = names + values * table.columns.len();
                let buttons = dock::row(frame, Vec2::ZERO, &TABLE_WORDS).last().map_or(0.0, |last| last.max().x);
                let (pitch, bars) = self.table_rows();
                let rows = table.lines.len() + 1 + if bars { table.bars.len() } else { 0 };
                Vec2::new(dock::width(frame, characters).max(buttons), rows as f32 * pitch + line + 2.5 * GRID)
            }
        };
        inside + 2.0 * GRID
    }
}
