//! What the pilot sees of the game: all of it at once, or as late as a person does.

use resultant::game::{Game, SHIP};
use resultant::physics::{Body, BodyId, DVec2};

/// What is seen.
#[derive(Clone, Copy, Debug)]
pub struct Sight<'a> {
    /// The game as it was then.
    pub game: &'a Game,
    /// Where the ship is taken to be, m.
    pub position: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// Degrees. Whoever turns the ship knows how far.
    pub angle: f64,
}

impl<'a> Sight<'a> {
    /// The game as it is.
    pub fn clear(game: &'a Game) -> Self {
        let ship = game.world().body(SHIP);
        Self { game, position: ship.position, velocity: ship.velocity, angle: game.ship().angle }
    }

    /// The game as it was some ticks ago: the ship is taken to have flown on as it flew then.
    pub fn late(then: &'a Game, now: &Game) -> Self {
        let seen = Self::clear(then);
        let late = now.time() - then.time();
        Self { position: seen.position + seen.velocity * late, angle: now.ship().angle, ..seen }
    }

    /// A body as it was seen.
    pub fn body(&self, id: BodyId) -> &'a Body {
        self.game.world().body(id)
    }
}
