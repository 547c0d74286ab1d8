//! Surfaces that move, against exact answers: lifts, platforms, belts, walls that push, one-way platforms, presses and doors.

mod belts;
mod doors;
mod lifts;
mod one_way;
mod presses;
mod walls;

use crate::support::{G, area, crushed, deepest, v};
use resultant::physics::{
    Aabb, BodyDef, BodyId, DVec2, Event, ForceKind, Leg, Material, Obstacle, Path, Sides, Source, SurfaceDef, World, WorldDef,
};

const AIR: f64 = 1.2041;
const RATES: [f64; 4] = [30.0, 60.0, 120.0, 240.0];
/// s. Long enough for a drift to show.
const MINUTE: f64 = 60.0;
/// m, m/s. The bar for exact answers.
const EXACT: f64 = 1e-9;
/// Relative. The bar for forces.
const FORCE: f64 = 1e-12;

fn leg(duration: f64, velocity: DVec2, acceleration: DVec2) -> Leg {
    Leg { duration, velocity, acceleration }
}

fn once(legs: &[Leg]) -> Path {
    Path { legs: legs.to_vec(), repeats: false }
}

fn mover(bounds: Aabb, path: Path) -> SurfaceDef {
    SurfaceDef { path, ..SurfaceDef::fixed(bounds, Material::ASPHALT) }
}

/// 4 m wide, its top at y = 0 and its middle at x = 0.
fn platform(path: Path) -> SurfaceDef {
    mover(area(-2.0, 0.0, 2.0, 0.5), path)
}

/// 1 m × 1 m; its bottom edge at `bottom`.
fn block(x: f64, bottom: f64, mass: f64) -> BodyDef {
    BodyDef { position: v(x, bottom - 0.5), mass, ..BodyDef::default() }
}

fn floor() -> SurfaceDef {
    SurfaceDef::fixed(area(-1e4, 0.0, 1e4, 1.0), Material::ASPHALT)
}

fn world_in(air_density: f64, surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> World {
    World::new(WorldDef { gravity: G, air_density, rest_speed: 0.0, surfaces, bodies, ..WorldDef::default() }).unwrap()
}

fn world(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> World {
    world_in(0.0, surfaces, bodies)
}

/// Steps through `seconds`, and hands on the time after each tick.
fn run(world: &mut World, seconds: f64, rate: f64, mut after: impl FnMut(&World, f64)) {
    for tick in 1..=(seconds * rate).round() as u32 {
        world.step(1.0 / rate);
        after(world, f64::from(tick) / rate);
    }
}

fn in_space(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> World {
    World::new(WorldDef { gravity: 0.0, air_density: 0.0, rest_speed: 0.0, surfaces, bodies, ..WorldDef::default() }).unwrap()
}

fn position(world: &World, body: u32) -> DVec2 {
    world.body(BodyId(body)).position
}

fn velocity(world: &World, body: u32) -> DVec2 {
    world.body(BodyId(body)).velocity
}

fn centre(world: &World, surface: usize) -> DVec2 {
    world.surfaces()[surface].bounds.centre()
}

#[track_caller]
fn within(what: &str, error: f64, bar: f64) {
    assert!(error <= bar, "{what}: {error:e}, expected at most {bar:e}");
}

/// The deepest overlap of a body with another, or with a surface that is solid all around, m.
fn overlap(world: &World) -> f64 {
    let solid: Vec<Aabb> = world.surfaces().iter().filter(|surface| surface.present).map(|surface| surface.bounds).collect();
    deepest(world.bodies().iter().map(|body| body.bounds()).collect(), &solid)
}

/// The Reaction of a surface on a body along y, N, upwards.
fn reaction(world: &World, body: u32, surface: u32) -> f64 {
    let forces = world.forces(BodyId(body));
    let of = forces.forces().iter().filter(|force| force.kind == ForceKind::Reaction && force.source == Source::Surface(surface));
    -of.map(|force| force.vector.y).sum::<f64>()
}

fn push(world: &World, from: u32, to: u32) -> f64 {
    let forces = world.forces(BodyId(to));
    let of = forces.forces().iter().filter(|force| force.kind == ForceKind::Push && force.source == Source::Body(BodyId(from)));
    of.map(|force| force.vector.x).sum()
}
