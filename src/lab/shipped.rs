//! Worlds of the shipped engine for the lab's models, with the game's defaults.

use super::methods::impact::LineBlock;
use super::methods::motion::{MotionLaw, PointState};
use crate::physics::{Aabb, BodyDef, DVec2, FluidDef, Material, SurfaceDef, WorldDef};

/// A floor whose top is at y = 0.
pub(super) fn floor() -> SurfaceDef {
    SurfaceDef::fixed(Aabb::new(DVec2::new(-1e4, 0.0), DVec2::new(1e4, 1.0)), Material::ASPHALT)
}

/// Bodies above that floor, without air.
pub(super) fn on_floor(gravity: f64, rest_speed: f64, bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { gravity, rest_speed, air_density: 0.0, bodies, surfaces: vec![floor()], ..WorldDef::default() }
}

/// A box of 1 m whose lower side is at height `y` above the floor.
pub(super) fn crate_at(x: f64, y: f64, mass: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, -0.5 - y), mass, ..BodyDef::default() }
}

/// A world with one body that obeys `law`, which pulls downwards only. The body is round, since the law's drag does not depend on the
/// direction. Uniform wind is another frame of reference: in it the air stands still.
pub(super) fn in_air(law: &MotionLaw, start: PointState) -> WorldDef {
    let body = BodyDef { position: start.x, velocity: start.v - law.wind, drag: 2.0 * law.drag, round: true, ..BodyDef::default() };
    WorldDef { gravity: law.constant.y, air_density: 1.0, bodies: vec![body], ..WorldDef::default() }
}

/// A world with one box of 1 m in a liquid of that density (kg/m³), so thick that it slows the box of `mass` kg by `viscous` of its
/// velocity a second: Stokes' 3π·η·d/m with d = 1 m.
pub(super) fn in_liquid(viscous: f64, density: f64, mass: f64, gravity: f64, start: PointState) -> WorldDef {
    let zone = Aabb::around(start.x, DVec2::splat(1e4));
    let fluid = FluidDef { zone, density, viscosity: viscous * mass / (3.0 * std::f64::consts::PI) };
    let body = BodyDef { position: start.x, velocity: start.v, mass, drag: 0.0, ..BodyDef::default() };
    WorldDef { gravity, air_density: 0.0, bodies: vec![body], fluids: vec![fluid], ..WorldDef::default() }
}

/// A world with one body on a wide and deep liquid whose surface is at y = 0.
pub(super) fn on_water(gravity: f64, density: f64, body: BodyDef) -> WorldDef {
    let zone = Aabb::new(DVec2::new(-1e3, 0.0), DVec2::new(1e3, 1e3));
    let fluid = FluidDef { zone, density, viscosity: 0.0 };
    WorldDef { gravity, air_density: 0.0, bodies: vec![body], fluids: vec![fluid], ..WorldDef::default() }
}

/// A line of blocks without gravity and air; a block of infinite mass is a wall.
pub(super) fn line(blocks: &[LineBlock], e: f64) -> WorldDef {
    let movable = blocks.iter().filter(|block| block.mass.is_finite());
    let bodies = movable.map(|block| BodyDef {
        position: DVec2::new(block.x, 0.0),
        velocity: DVec2::new(block.v, 0.0),
        half: DVec2::new(block.half, 0.5),
        mass: block.mass,
        restitution: e,
        ..BodyDef::default()
    });
    let walls = blocks.iter().filter(|block| block.mass.is_infinite());
    let surfaces = walls
        .map(|block| SurfaceDef::fixed(Aabb::around(DVec2::new(block.x, 0.0), DVec2::new(block.half, 100.0)), Material::STEEL));
    WorldDef { gravity: 0.0, air_density: 0.0, bodies: bodies.collect(), surfaces: surfaces.collect(), ..WorldDef::default() }
}
