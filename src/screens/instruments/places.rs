//! The rail and the panels stand beside the head-up display and each other, and away from the middle, where the ship is.

use super::Tool;
use crate::draw::layout::{Area, DETAILS, Frame, GRID, LINE, Vec2, text_room};
use crate::view::hud::HudLayout;

const GAP: f32 = 4.0;

#[derive(Clone, Debug, PartialEq)]
pub struct Places {
    /// A button a tool, from the top.
    pub rail: Vec<Area>,
}

impl Places {
    pub fn new(frame: &Frame, _uses: impl Fn(Tool) -> bool) -> Self {
        let top = HudLayout::new(frame).status.max().y + 2.0 * GRID;
        let text = frame.text_height(DETAILS);
        let widest = Tool::ALL.iter().map(|tool| text_room(tool.name(), text).x).fold(0.0, f32::max);
        let size = Vec2::new(widest + 2.0 * GRID, text * LINE + GRID);
        let button = |i: usize| Area { min: Vec2::new(2.0 * GRID, top + i as f32 * (size.y + GAP)), size };
        Self { rail: (0..Tool::ALL.len()).map(button).collect() }
    }

    pub fn areas(&self) -> impl Iterator<Item = Area> {
        self.rail.iter().copied()
    }
}
