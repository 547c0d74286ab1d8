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
}

impl Spectator for () {}
