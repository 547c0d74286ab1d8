//! What scenes of the dense method are built from.

use super::area;
use resultant::physics::DVec2;
use resultant::physics::pile::{PileBody, PileDef, PileSurface};

/// The gravity of these scenes, N/kg.
pub const G: f64 = 9.81;

/// A solid by its corners, m.
pub fn surface(left: f64, top: f64, right: f64, bottom: f64) -> PileSurface {
    PileSurface { bounds: area(left, top, right, bottom), static_friction: 0.9, kinetic_friction: 0.65 }
}

/// A square of the default size and mass.
pub fn square(x: f64, y: f64) -> PileBody {
    PileBody { position: DVec2::new(x, y), ..PileBody::default() }
}

/// Where nothing comes to rest for being slow.
pub fn scene(bodies: Vec<PileBody>, surfaces: Vec<PileSurface>, gravity: f64) -> PileDef {
    PileDef { bodies, surfaces, gravity, rest_speed: 0.0, ..PileDef::default() }
}
