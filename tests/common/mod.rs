//! Levels built by hand, for tests of the rules.

use resultant::level::{Level, Object, Objective, ObjectiveKind, Player};
use resultant::physics::{Aabb, DVec2};

/// A box by its corners, m.
pub fn area(left: f64, top: f64, right: f64, bottom: f64) -> Aabb {
    Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
}

/// An empty room of 100 m × 100 m without gravity and air, the ship (100 kg, 2000 N, 500 fuel) at rest in its middle, its box
/// from 49.15 m to 50.85 m, and a player objective in the far corner.
pub fn room() -> Level {
    Level {
        name: "room".into(),
        title: "Room".into(),
        metre: 30.0,
        size: DVec2::splat(100.0),
        gravity: 0.0,
        air_density: 0.0,
        optimal_time: 60.0,
        rest_speed: 1.0,
        player: Player {
            position: DVec2::splat(50.0),
            velocity: DVec2::ZERO,
            angle: 0.0,
            mass: 100.0,
            fuel: 500.0,
            thrust: 2000.0,
            feels_air: true,
            material: resultant::physics::Material::ASPHALT,
        },
        world: vec![],
        objects: vec![],
        objectives: vec![objective(ObjectiveKind::Player, area(98.0, 98.0, 99.0, 99.0))],
        obstacles: vec![],
        streams: vec![],
        fluids: vec![],
        texts: vec![],
        background: None,
    }
}

/// An objective block.
pub fn objective(kind: ObjectiveKind, bounds: Aabb) -> Objective {
    Objective { kind, bounds }
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
        look: resultant::level::Look::Box,
        material: resultant::physics::Material::ASPHALT,
        key,
    }
}
