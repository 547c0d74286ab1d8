//! Builders of worlds of which every island takes the crowd step.

use super::block;
use resultant::physics::{BodyDef, DVec2, Plan, SurfaceDef, World, WorldDef};

/// The gravity of these scenes, N/kg.
pub const G: f64 = 9.81;

/// A solid of asphalt by its corners, m.
pub fn surface(left: f64, top: f64, right: f64, bottom: f64) -> SurfaceDef {
    block(left, top, right, bottom)
}

/// A square of the default size and mass.
pub fn square(x: f64, y: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, y), ..BodyDef::default() }
}

/// A scene without air.
pub fn scene(bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>, gravity: f64) -> WorldDef {
    WorldDef { bodies, surfaces, gravity, air_density: 0.0, ..WorldDef::default() }
}

/// The world of a definition of which every island takes the crowd step.
pub fn dense(def: WorldDef) -> World {
    let plan = Plan { dense: true, ..Plan::of(&def) };
    World::with_plan(def, plan).unwrap()
}

/// The same without sleep.
pub fn restless(def: WorldDef) -> World {
    let plan = Plan { dense: true, direct: false, ..Plan::of(&def) };
    World::with_plan(def, plan).unwrap()
}

/// Whether no body was computed in the last tick.
pub fn all_asleep(world: &World) -> bool {
    world.methods().asleep as usize == world.bodies().len()
}

/// Nothing, without air; rebounds below 1 m/s are none.
pub fn empty() -> WorldDef {
    WorldDef { gravity: G, air_density: 0.0, rest_speed: 1.0, ..WorldDef::default() }
}
