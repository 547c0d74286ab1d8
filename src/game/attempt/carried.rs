//! An attempt that goes on while the player edits or varies its level.

use super::Game;
use crate::game::event::{GameError, Outcome};
use crate::physics::{Aabb, Body, DVec2, Sides};
use crate::{game::ship::SHIP, level::Level};
use std::sync::Arc;

/// The depth to which two boxes may overlap, m: far above the rounding of contacts, far below a pixel.
const TOUCH: f64 = 1e-4;

impl Game {
    /// Goes on in a level that differs from its own in numbers alone (see [`varied`](crate::level::varied)): every body keeps its state.
    /// Errors: a level that the engine refuses, or that has other bodies or surfaces; nothing has changed then.
    pub fn go_on_in(&mut self, level: Arc<Level>) -> Result<(), GameError> {
        self.world.go_on_by(level.world_def()).map_err(GameError::World)?;
        self.level = level;
        Ok(())
    }

    /// The attempt as it goes on in a changed level. The ship keeps place, velocity, angle, fuel and time, and each object that is the same in
    /// `before` keeps its motion. Changed objects, switches and movers begin again. `None` once the attempt has ended, or where the ship has no room.
    pub fn carried_into(&self, before: &Level, level: &Arc<Level>) -> Option<Self> {
        if self.outcome != Outcome::Running {
            return None;
        }
        let mut start = Level::clone(level);
        let surfaces = level.world_def().surfaces;
        let solid = surfaces.iter().filter(|surface| surface.present && surface.sides == Sides::ALL);
        let surfaces: Vec<Aabb> = solid.map(|surface| surface.bounds).collect();
        let room = |bounds: &Aabb| level.bounds().contains(bounds, TOUCH) && !surfaces.iter().any(|other| overlap(bounds, other));
        let ship = self.world.body(SHIP);
        if before.ship_plays() != level.ship_plays() || level.ship_plays() && !room(&ship.bounds()) {
            return None;
        }
        let mut placed = vec![ship.bounds()];
        for (i, object) in start.objects.iter_mut().enumerate() {
            let body = self.world.bodies().get(i + 1).filter(|_| before.objects.get(i) == Some(object));
            if let Some(Body { position, velocity, .. }) = body.filter(|body| room(&body.bounds())) {
                (object.position, object.velocity) = (*position, *velocity);
            }
            let bounds = Aabb::around(object.position, object.size * 0.5);
            if placed.iter().any(|other| overlap(&bounds, other)) {
                return None;
            }
            placed.push(bounds);
        }
        (start.player.position, start.player.velocity, start.player.angle) = (ship.position, ship.velocity, self.ship.angle);
        let mut game = Self::with_tick_rate(Arc::new(start), self.tick_rate).ok()?;
        game.ship.fill(self.ship.fuel.min(level.player.fuel));
        (game.ticks, game.idle) = (self.ticks, self.idle);
        game.flight = self.flight.clone();
        Some(game)
    }
}

fn overlap(a: &Aabb, b: &Aabb) -> bool {
    let depth: DVec2 = a.max.min(b.max) - a.min.max(b.min);
    depth.min_element() > TOUCH
}
