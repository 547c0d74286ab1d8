//! The game's listeners.

use crate::game::Game;

/// Watches attempts tick by tick: particles, sound, the cost of a tick. It changes nothing in them.
pub trait Spectator {
    /// An attempt begins.
    fn begins(&mut self, _game: &Game) {}
    /// A tick is about to be computed.
    fn before_tick(&mut self) {}
    /// A tick has been computed; its events are in the game.
    fn after_tick(&mut self, _game: &Game) {}
    /// The game has jumped to another moment.
    fn jumped(&mut self, _game: &Game) {}
    /// The attempt goes on in a level that was edited meanwhile.
    fn goes_on(&mut self, _game: &Game) {}
}

impl Spectator for () {}
