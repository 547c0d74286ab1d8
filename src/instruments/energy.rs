//! Momentum, kinetic and potential energy, of a body and of all.
//!
//! The centre of mass of several bodies: without forces from outside it goes on in a straight line, whatever the parts do.

use crate::game::Game;
use crate::level::Level;
use crate::physics::{Body, BodyId, DVec2, Link, LinkEnd};
use std::ops::Add;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyState {
    /// Σ m·v, N·s, y downwards.
    pub momentum: DVec2,
    /// Σ ½mv², J.
    pub kinetic: f64,
    /// −Σ m·g·(r − r₀), J: of the level's own gravity, above [`ground`] or another zero. Gravity of zones has no potential, since their
    /// fields end at their borders.
    pub potential: f64,
    /// The energy of its springs and ropes, J: half of it where a link leads to another body.
    pub elastic: f64,
}

impl EnergyState {
    pub fn of(game: &Game, id: BodyId) -> Self {
        Self::above(ground(game.level()), game, id)
    }

    /// With potential energy from `zero` (m) on.
    pub fn above(zero: DVec2, game: &Game, id: BodyId) -> Self {
        let (level, body) = (game.level(), game.world().body(id));
        let field = if body.weightless { DVec2::ZERO } else { DVec2::new(level.gravity_x, level.gravity) };
        Self {
            momentum: body.mass * body.velocity,
            kinetic: 0.5 * body.mass * body.velocity.length_squared(),
            potential: -body.mass * field.dot(body.position - zero),
            elastic: elastic(game, id),
        }
    }

    /// J.
    pub fn sum(&self) -> f64 {
        self.kinetic + self.potential + self.elastic
    }

    pub fn of_all(game: &Game) -> Self {
        (0..game.world().bodies().len() as u32).map(|id| Self::of(game, BodyId(id))).fold(Self::default(), Self::add)
    }
}

impl Add for EnergyState {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            momentum: self.momentum + other.momentum,
            kinetic: self.kinetic + other.kinetic,
            potential: self.potential + other.potential,
            elastic: self.elastic + other.elastic,
        }
    }
}

fn elastic(game: &Game, id: BodyId) -> f64 {
    let world = game.world();
    let stored = |link: &Link| {
        let def = link.def();
        let share = match def.to {
            LinkEnd::Body(other) if other == id || def.body == id => 0.5,
            LinkEnd::Place(_) if def.body == id => 1.0,
            _ => return 0.0,
        };
        let [from, to] = world.link_ends(link);
        share * link.law().energy(from.distance(to))
    };
    world.links().iter().filter(|link| link.acts()).map(stored).sum()
}

/// Where potential energy is zero, m: the corner of the level to which its gravity pulls, so that nothing has less.
pub fn ground(level: &Level) -> DVec2 {
    let along = |gravity: f64, size: f64| if gravity > 0.0 { size } else { 0.0 };
    DVec2::new(along(level.gravity_x, level.size.x), along(level.gravity, level.size.y))
}

/// Σ m·r / Σ m over bodies, m.
pub fn centre_of_mass(bodies: &[Body]) -> DVec2 {
    let (moment, mass) =
        bodies.iter().fold((DVec2::ZERO, 0.0), |(moment, mass), body| (moment + body.mass * body.position, mass + body.mass));
    moment / mass
}

/// Σ m·v / Σ m over bodies, m/s.
pub fn velocity_of_centre(bodies: &[Body]) -> DVec2 {
    let (momentum, mass) =
        bodies.iter().fold((DVec2::ZERO, 0.0), |(momentum, mass), body| (momentum + body.mass * body.velocity, mass + body.mass));
    momentum / mass
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, World, WorldDef};

    #[test]
    fn potential_energy_counts_from_where_gravity_pulls_to() {
        let level = |gravity_x, gravity| Level { size: DVec2::new(40.0, 20.0), gravity_x, gravity, ..crate::level::fixture() };
        assert_eq!(ground(&level(0.0, 9.81)), DVec2::new(0.0, 20.0));
        assert_eq!(ground(&level(0.0, -9.81)), DVec2::ZERO);
        assert_eq!(ground(&level(2.0, 0.0)), DVec2::new(40.0, 0.0));
        let high = Level { size: DVec2::splat(1000.0), ..level(0.0, 10.0) };
        let game = Game::new(std::sync::Arc::new(high)).expect("a level");
        let ship = game.world().body(BodyId(0));
        let state = EnergyState::of(&game, BodyId(0));
        assert!((state.potential - ship.mass * 10.0 * (1000.0 - ship.position.y)).abs() < 1e-9);
        let all = EnergyState::of_all(&game);
        assert!(all.potential >= state.potential && all.kinetic == 0.0 && all.momentum == DVec2::ZERO);
    }

    #[test]
    fn it_lies_nearer_to_the_heavier() {
        let mut world = World::new(WorldDef::default()).expect("an empty world");
        for (mass, x, speed) in [(1.0, 10.0, 8.0), (3.0, 14.0, -4.0)] {
            let (position, velocity) = (DVec2::new(x, 50.0), DVec2::new(speed, 0.0));
            world.add_body(BodyDef { mass, position, velocity, ..BodyDef::default() }).expect("a body");
        }
        assert_eq!(centre_of_mass(world.bodies()), DVec2::new(13.0, 50.0));
        assert_eq!(velocity_of_centre(world.bodies()), DVec2::new(-1.0, 0.0));
    }
}
