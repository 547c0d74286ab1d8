//! Sliding to a stop on a floor. Exact: d = v₀²/2μg.

use crate::lab::methods::friction::{Slide, by_sign, clamped, exact};
use crate::lab::{Scene, shipped};
use crate::physics::{BodyDef, BodyId, DVec2, Material};

/// N/kg.
const G: f64 = 15.0;
/// m/s.
const SPEED: f64 = 10.0;
/// s.
const SECONDS: f64 = 10.0;

/// From 10 m/s on Asphalt: 5.13 m.
pub fn to_a_stop() -> Scene {
    let brake = Material::ASPHALT.kinetic_friction * G;
    let distance = SPEED * SPEED / (2.0 * brake);
    let methods: [(&str, Slide); 3] = [("friction by sign", by_sign), ("friction clamped", clamped), ("exact stop", exact)];
    let mut scene = Scene::new("slide", "Sliding 5.13 m to a stop, 10 s", SECONDS, 1);
    for (name, slide) in methods {
        scene = scene.method(name, move |h| {
            let steps = (SECONDS / h).round() as u64;
            let (x, _) = (0..steps).fold((0.0, SPEED), |slider, _| slide(slider, brake, h));
            (x - distance).abs()
        });
    }
    scene.shipped(move |h| {
        let body = BodyDef { velocity: DVec2::new(SPEED, 0.0), ..shipped::crate_at(0.0, 0.0, 1.0) };
        let world = shipped::run(shipped::on_floor(G, 1.0, vec![body]), SECONDS, h);
        world.map_or(f64::NAN, |world| (world.body(BodyId(0)).position.x - distance).abs())
    })
}
