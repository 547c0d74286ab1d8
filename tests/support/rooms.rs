//! Levels built by hand, for tests of the rules.

use super::Memory;
pub use super::area;
use resultant::game::{Controls, Game};
use resultant::level::{self, Level, Look, Object, Objective, ObjectiveKind, Solid};
use resultant::physics::{Aabb, DVec2, Material};
use std::sync::Arc;

pub const NONE: Controls = Controls { thrust: false, reverse: false, left: false, right: false };
pub const THRUST: Controls = Controls { thrust: true, ..NONE };
pub const REVERSE: Controls = Controls { reverse: true, ..NONE };
pub const LEFT: Controls = Controls { left: true, ..NONE };
pub const RIGHT: Controls = Controls { right: true, ..NONE };

pub fn start(level: Level) -> Game {
    Game::new(Arc::new(level)).expect("the level can be played")
}

pub fn fly(game: &mut Game, controls: Controls, ticks: u32) {
    (0..ticks).for_each(|_| game.step(controls));
}

/// An empty room of 100 m × 100 m without gravity and air, the ship (100 kg, 2000 N, 500 fuel) at rest in its middle, its box
/// from 49.15 m to 50.85 m, and a player objective in the far corner.
pub fn room() -> Level {
    let constants = "title,Room\nwidth,3000\nheight,3000\ngravity,0\nair_density,0\noptimal_time,60\nrest_speed,1\n";
    let files =
        [("constants.csv", constants), ("player.csv", "1500,1500,100,500,2000\n"), ("objectives.csv", "PLAYER,2940,2940,30,30\n")];
    let texts = Memory(files.map(|(file, text)| (file, text.to_owned())).into());
    Level { background: None, ..level::read("room", &texts).expect("the room loads").level }
}

/// The room with gravity and air, a floor, a key object and a box to bump into.
pub fn yard() -> Level {
    let mut level = room();
    (level.gravity, level.air_density) = (15.0, 1.2041);
    level.world = vec![Solid::new(area(0.0, 60.0, 100.0, 61.0), Material::ASPHALT)];
    level.objects = vec![
        crate_at(DVec2::new(55.0, 59.5), DVec2::new(-1.0, 0.0), Some([255, 0, 255])),
        crate_at(DVec2::new(45.0, 40.0), DVec2::new(3.0, 0.0), None),
    ];
    level.objectives.push(objective(ObjectiveKind::Physics, area(98.0, 98.0, 99.0, 99.0)));
    level
}

pub fn objective(kind: ObjectiveKind, bounds: Aabb) -> Objective {
    Objective::new(kind, bounds)
}

/// A box of 1 m × 1 m and 10 kg; a key object where it has a colour.
pub fn crate_at(position: DVec2, velocity: DVec2, key: Option<[u8; 3]>) -> Object {
    Object {
        position,
        velocity,
        size: DVec2::ONE,
        mass: 10.0,
        drag: 1.0,
        restitution: 0.0,
        circular: false,
        look: Look::Box,
        material: Material::ASPHALT,
        key,
        weightless: false,
        name: None,
    }
}
