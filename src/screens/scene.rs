//! The game on a screen, as the window's view draws it.

use super::instruments::Instruments;
use super::race::Race;
use crate::draw::layout::{Area, Frame};
use crate::game::Game;
use crate::view::{GhostShip, Overlays};

pub struct GameScene<'a> {
    pub game: &'a Game,
    /// Between the last two ticks, 0 … 1.
    pub alpha: f64,
    /// The part of the canvas for the game.
    pub room: Frame,
    /// Without the settings.
    pub overlays: Overlays,
    /// Factor on the time of the view; 0 where the world stands still.
    pub speed: f64,
    /// Whether the view stands still too.
    pub paused: bool,
    /// Whether it is seen and not heard.
    pub quiet: bool,
    pub ghosts: Vec<GhostShip>,
    pub race: Option<&'a Race>,
    /// The places above the game: they cover it.
    pub panels: Vec<Area>,
    pub instruments: &'a Instruments,
}
