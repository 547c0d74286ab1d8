//! What happens within a tick is right at its instant, whatever the tick: each kind of scene against exact answers, in random cases.

mod cradles;
mod heaps;
mod linked;
mod media;
mod movers;
mod trains;

use crate::support::{Ask, Random, area};
use proptest::prelude::*;
use resultant::physics::{BodyDef, DVec2, FieldDef, Leg, Material, Path, SurfaceDef, World, WorldDef};

fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Cases of a property, each a seed of [`Random`].
fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

/// Without gravity and air.
fn in_space(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { gravity: 0.0, air_density: 0.0, surfaces, bodies, ..WorldDef::default() }
}

fn without_air(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { air_density: 0.0, surfaces, bodies, ..WorldDef::default() }
}
