//! Places of the head-up display's parts.

use crate::draw::layout::{Area, Frame, GRID, TEXT, Vec2};
use crate::game::Game;

/// Width and height of the fuel bar as shares of the window's: the ring around the ship says the same.
const BAR: Vec2 = Vec2::new(0.16, 0.025);
/// Height of the panel at the top left.
const STATUS_HEIGHT: f32 = 72.0;
/// Width of a column of the strip, in heights of text.
const RACE_COLUMN: f32 = 6.6;

/// Nothing else should cover these places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HudLayout {
    /// Timer and objectives, at the top left.
    pub status: Area,
    /// The fuel bar, at the bottom left.
    pub fuel: Area,
}

impl HudLayout {
    pub fn new(frame: &Frame) -> Self {
        let bar = frame.size * BAR;
        Self {
            status: Area::new(
                2.0 * GRID,
                2.0 * GRID,
                15.2 * frame.text_height(TEXT),
                STATUS_HEIGHT.max(frame.text_height(TEXT) * 3.2),
            ),
            fuel: Area::new(2.0 * GRID, frame.size.y - bar.y - 2.0 * GRID, bar.x, bar.y),
        }
    }

    /// The parts in a game in which the ship plays a part.
    pub fn shown(frame: &Frame, game: &Game) -> Vec<Area> {
        if game.level().ship_plays() { Self::new(frame).areas().to_vec() } else { Vec::new() }
    }

    /// The strip beside the timer.
    pub fn race(&self, frame: &Frame, columns: usize) -> Area {
        let left = self.status.max().x + GRID;
        let column = RACE_COLUMN * frame.text_height(TEXT);
        let width = (column * columns as f32).min(frame.size.x - left - 2.0 * GRID);
        Area::new(left, self.status.min.y, width, frame.text_height(TEXT) * 2.8)
    }

    pub fn areas(&self) -> [Area; 2] {
        [self.status, self.fuel]
    }
}
