//! The wreck of a lost ship: pieces that fly, fall and bounce by the engine's own laws, in a world of their own: the game does not
//! change.

use super::camera::Viewport;
use super::theme;
use crate::draw::{Canvas, Colour};
use crate::game::Game;
use crate::level::{Level, SHIP_HALF};
use crate::physics::{BodyDef, BodyId, DVec2, World, WorldDef};

/// Pause before the ship breaks, s.
const HIT_STOP: f64 = 0.09;
/// Pieces along each axis.
const PIECES: u32 = 3;
/// The share of its cell that a piece fills: pieces do not begin in each other.
const FILLED: f64 = 0.9;
/// Speed of the pieces away from the ship's middle, m/s a metre, and the share of the ship's speed that they keep.
const BURST: f64 = 6.0;
const KEPT: f64 = 0.6;
/// s; and the most ticks a frame: after a hitch pieces may skip time, but must not freeze the game.
const TICK: f64 = 1.0 / 120.0;
const MOST_TICKS: u32 = 8;

pub struct Wreck {
    world: World,
    /// Since the ship was lost, s.
    age: f64,
    /// Time not yet simulated, s.
    left: f64,
}

impl Wreck {
    /// The pieces of a game's ship; `None` where there is no room for them.
    pub fn new(game: &Game, ship: BodyId) -> Option<Self> {
        let body = game.world().body(ship);
        let world = World::new(definition(game.level(), body.position, body.velocity)).ok()?;
        Some(Self { world, age: 0.0, left: 0.0 })
    }

    pub fn advance(&mut self, frame_time: f64) {
        self.age += frame_time;
        if self.is_whole() {
            return;
        }
        self.left = (self.left + frame_time).min(f64::from(MOST_TICKS) * TICK);
        while self.left >= TICK {
            self.left -= TICK;
            self.world.step(TICK);
        }
    }

    /// Whether the ship has not broken yet.
    pub fn is_whole(&self) -> bool {
        self.age < HIT_STOP
    }

    pub fn draw(&self, view: &Viewport, canvas: &Canvas) {
        for (i, body) in self.world.bodies().iter().enumerate() {
            let area = view.rect(&body.bounds());
            canvas.rectangle(area, colour(i as u32));
            canvas.rectangle_edge(area, 1.0, theme::ground());
        }
    }
}

/// The hull is white, the belly slate, the trim orange.
fn colour(piece: u32) -> Colour {
    match (piece % PIECES, piece / PIECES) {
        (1, 0) => theme::accent(),
        (_, 0) => Colour::WHITE,
        (1, 1) => Colour::hex(0x6FB7E8),
        (_, 1) => Colour::hex(0xE6EBF2),
        _ => theme::solid_top(),
    }
}

/// The level with pieces for bodies.
fn definition(level: &Level, centre: DVec2, velocity: DVec2) -> WorldDef {
    let cell = SHIP_HALF * 2.0 / f64::from(PIECES);
    let piece = |i: u32| {
        let place = DVec2::new(f64::from(i % PIECES), f64::from(i / PIECES)) - 0.5 * f64::from(PIECES - 1);
        let from_middle = place * cell;
        BodyDef {
            position: centre + from_middle,
            // Each a little differently, so that the wreck has no symmetry.
            velocity: velocity * KEPT + from_middle * BURST * (1.0 + 0.25 * f64::from(i * 5 % 7)),
            half: cell * 0.5 * FILLED,
            mass: level.player.mass / f64::from(PIECES * PIECES),
            restitution: 0.4,
            ..BodyDef::default()
        }
    };
    WorldDef { bodies: (0..PIECES * PIECES).map(piece).collect(), links: Vec::new(), ..level.world_def() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pieces_take_the_ships_mass_fall_and_come_to_rest_inside_the_level() {
        let level = crate::level::fixture();
        let mut world = World::new(definition(&level, level.player.position, DVec2::new(4.0, -9.0))).unwrap();
        let mass: f64 = world.bodies().iter().map(|body| body.mass).sum();
        assert!((mass - level.player.mass).abs() < 1e-9);
        for _ in 0..1200 {
            world.step(TICK);
        }
        for body in world.bodies() {
            assert!(body.velocity.length() < 0.1 && level.bounds().contains(&body.bounds(), 1e-6), "{body:?}");
        }
    }
}
