//! Listeners of the game.

use crate::game::Game;

/// Watches attempts tick by tick: particles, sound, the cost of a tick. It changes nothing in them.
pub trait Spectator {
    fn begins(&mut self, _game: &Game) {}
    /// Before each tick.
    fn before_tick(&mut self) {}
    /// After each tick, whose events are in the game.
    fn after_tick(&mut self, _game: &Game) {}
    /// The game has jumped to another moment.
    fn jumped(&mut self, _game: &Game) {}
    /// The attempt goes on in a level that was edited meanwhile.
    fn goes_on(&mut self, _game: &Game) {}
    /// Frames a second of the window; 0 without one.
    fn frames(&self) -> f64 {
        0.0
    }
}

impl Spectator for () {}
