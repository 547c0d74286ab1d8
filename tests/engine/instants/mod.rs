//! What happens within a tick is right at its instant, whatever the tick: each kind of scene against exact answers, in random cases.

mod cradles;
mod heaps;
mod linked;
mod media;
mod movers;
mod trains;

use crate::support::{Ask, Random, area, elastic, v};
use proptest::prelude::*;
use resultant::physics::{BodyDef, DVec2, FieldDef, Leg, Material, Path, SurfaceDef, World, WorldDef};

/// Ticks a second.
const RATES: [f64; 5] = [30.0, 60.0, 120.0, 240.0, 480.0];

fn rates() -> impl Strategy<Value = f64> {
    prop::sample::select(RATES.to_vec())
}

fn rough(held: f64, slid: f64) -> Material {
    Material { static_friction: held, kinetic_friction: slid, ..Material::STEEL }
}

fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

fn in_space(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { gravity: 0.0, air_density: 0.0, surfaces, bodies, ..WorldDef::default() }
}

fn without_air(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { air_density: 0.0, surfaces, bodies, ..WorldDef::default() }
}
