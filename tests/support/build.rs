//! Builders of scenes.

use super::Random;
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, FluidDef, Material, SurfaceDef, World, WorldDef};

/// The game's tick, s.
pub const TICK: f64 = 1.0 / 120.0;
/// The game's gravity, N/kg.
pub const G: f64 = 15.0;
/// The ship, and any other single body.
pub const BODY: BodyId = BodyId(0);

pub fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

pub fn area(left: f64, top: f64, right: f64, bottom: f64) -> Aabb {
    Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
}

pub fn block(left: f64, top: f64, right: f64, bottom: f64) -> SurfaceDef {
    SurfaceDef::fixed(area(left, top, right, bottom), Material::ASPHALT)
}

/// Four walls of asphalt around an area, so thick, m.
pub fn room(inner: Aabb, thick: f64) -> [SurfaceDef; 4] {
    let (a, b) = (inner.min, inner.max);
    [
        block(a.x - thick, a.y - thick, b.x + thick, a.y),
        block(a.x - thick, b.y, b.x + thick, b.y + thick),
        block(a.x - thick, a.y, a.x, b.y),
        block(b.x, a.y, b.x + thick, b.y),
    ]
}

/// A floor whose top is at y = 0, 2 km wide.
pub fn floor(material: Material) -> SurfaceDef {
    SurfaceDef::fixed(area(-1000.0, 0.0, 1000.0, 1.0), material)
}

/// A crate of 1 m × 1 m.
pub fn crate_at(x: f64, y: f64, mass: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, y), mass, ..BodyDef::default() }
}

/// A crate that moves along x.
pub fn elastic(position: DVec2, mass: f64, speed: f64) -> BodyDef {
    BodyDef { position, velocity: v(speed, 0.0), mass, restitution: 1.0, ..BodyDef::default() }
}

/// A liquid 30 m deep whose surface is at y = 0.
pub fn pool(density: f64, viscosity: f64) -> FluidDef {
    FluidDef { zone: area(-100.0, 0.0, 100.0, 30.0), density, viscosity }
}

pub fn world(def: WorldDef) -> World {
    World::new(def).unwrap()
}

/// Bodies of all kinds, one a cell of a grid with `columns` cells of 1.6 m a row, so that none begins inside another.
pub fn crowd(random: &mut Random, count: usize, columns: usize) -> Vec<BodyDef> {
    let body = |i: usize| BodyDef {
        position: DVec2::new(1.0 + 1.6 * (i % columns) as f64, 1.0 + 1.6 * (i / columns) as f64),
        velocity: DVec2::new(random.between(-8.0, 8.0), random.between(-8.0, 8.0)),
        half: DVec2::new(random.between(0.15, 0.75), random.between(0.15, 0.75)),
        mass: random.decades(-1.0, 3.0),
        drag: random.between(0.0, 2.0),
        round: random.chance(0.3),
        restitution: if random.chance(0.5) { random.unit() } else { 0.0 },
        material: random.pick(&Material::FIRM),
        ..BodyDef::default()
    };
    (0..count).map(body).collect()
}
