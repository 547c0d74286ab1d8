//! What the pilot takes the game to be: as it is, or as a person imagines it who saw it a while ago.

use resultant::game::{Game, SHIP};
use resultant::physics::{Body, BodyId, DVec2};

/// What is seen.
#[derive(Clone, Copy, Debug)]
pub struct Sight<'a> {
    pub game: &'a Game,
    /// Where the ship is, m.
    pub position: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// Degrees.
    pub angle: f64,
}

impl<'a> Sight<'a> {
    pub fn of(game: &'a Game) -> Self {
        let ship = game.world().body(SHIP);
        Self { game, position: ship.position, velocity: ship.velocity, angle: game.ship().angle }
    }

    /// A body as it is seen.
    pub fn body(&self, id: BodyId) -> &'a Body {
        self.game.world().body(id)
    }
}
