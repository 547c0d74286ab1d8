//! Builders of worlds of which every island takes the crowd step.

use super::{Random, block};
use resultant::physics::{BodyDef, DVec2, Plan, SurfaceDef, World, WorldDef};

/// The gravity of these scenes, N/kg.
pub const G: f64 = 9.81;

/// A square of the default size and mass.
pub fn square(x: f64, y: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, y), ..BodyDef::default() }
}

pub fn scene(bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>, gravity: f64) -> WorldDef {
    WorldDef { bodies, surfaces, gravity, air_density: 0.0, ..WorldDef::default() }
}

/// The world of a definition of which every island takes the crowd step.
pub fn dense(def: WorldDef) -> World {
    let plan = Plan { dense: true, ..Plan::of(&def) };
    World::with_plan(def, plan).unwrap()
}

pub fn restless(def: WorldDef) -> World {
    let plan = Plan { dense: true, direct: false, ..Plan::of(&def) };
    World::with_plan(def, plan).unwrap()
}

/// Boxes of 0.3 to 0.6 m that rain into a pit of `columns` boxes from `left` on, m; their masses in kg.
pub fn rain_into(left: f64, n: usize, columns: usize, masses: (f64, f64), mut random: Random, restitution: f64) -> WorldDef {
    let right = left + columns as f64 * 0.7;
    let bodies = (0..n)
        .map(|i| BodyDef {
            half: DVec2::new(0.15 + 0.15 * random.unit(), 0.15 + 0.15 * random.unit()),
            position: DVec2::new(left + 0.35 + 0.7 * (i % columns) as f64, -1.0 - 0.8 * (i / columns) as f64),
            velocity: DVec2::new(4.0 * random.unit() - 2.0, 0.0),
            mass: masses.0 + (masses.1 - masses.0) * random.unit(),
            restitution: restitution * random.unit(),
            ..BodyDef::default()
        })
        .collect();
    let floor = block(left - 5.0, 0.0, right + 5.0, 1.0);
    let surfaces = vec![floor, block(left - 1.0, -900.0, left, 0.0), block(right, -900.0, right + 1.0, 0.0)];
    WorldDef { bodies, surfaces, ..empty() }
}

/// Whether no body was computed in the last tick.
pub fn all_asleep(world: &World) -> bool {
    world.methods().asleep as usize == world.bodies().len()
}

/// Nothing, without air; rebounds below 1 m/s are none.
pub fn empty() -> WorldDef {
    WorldDef { gravity: G, air_density: 0.0, rest_speed: 1.0, ..WorldDef::default() }
}
