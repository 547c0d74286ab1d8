//! Sliding to a stop on a floor. Exact: d = v₀²/2μg.

use crate::lab::contract::Model;
use crate::lab::methods::slide::{SlideStep, Slider, by_sign, clamped, exact};
use crate::lab::{LabScene, SceneMethod, contract};
use crate::physics::{BodyDef, BodyId, DVec2, Material, World};

/// N/kg.
const G: f64 = 15.0;
/// m/s.
const SPEED: f64 = 10.0;
/// s.
const SECONDS: f64 = 10.0;

pub const METHODS: [(&str, SlideStep); 3] = [("friction by sign", by_sign), ("friction clamped", clamped), ("exact stop", exact)];

/// A box at 10 m/s on asphalt.
#[derive(Clone, Copy, Debug)]
pub struct SlidingBox {
    /// N/kg.
    pub gravity: f64,
}

impl SlidingBox {
    /// Deceleration, m/s².
    pub fn brake(&self) -> f64 {
        Material::ASPHALT.kinetic_friction * self.gravity
    }

    /// The place of the stop, m.
    pub fn stop(&self) -> f64 {
        SPEED * SPEED / (2.0 * self.brake())
    }

    /// The time of the stop, s.
    pub fn stops_after(&self) -> f64 {
        SPEED / self.brake()
    }
}

impl Model for SlidingBox {
    type State = Slider;
    type Method = SlideStep;

    fn start(&self) -> Slider {
        (0.0, SPEED)
    }

    fn step(&self, method: SlideStep, slider: &mut Slider, h: f64) {
        *slider = method(*slider, self.brake(), h);
    }

    fn world(&self) -> Option<World> {
        let body = BodyDef { velocity: DVec2::new(SPEED, 0.0), ..contract::crate_at(0.0, 0.0, 1.0) };
        World::new(contract::on_floor(self.gravity, 1.0, vec![body])).ok()
    }

    fn read(&self, world: &World, _: f64, slider: &mut Slider) {
        let body = world.body(BodyId(0));
        *slider = (body.position.x, body.velocity.x);
    }
}

/// From 10 m/s on asphalt: 5.13 m.
pub fn to_a_stop() -> LabScene {
    let sliding = SlidingBox { gravity: G };
    let error = move |by, h| sliding.end(by, SECONDS, h).map_or(f64::NAN, |(x, _)| (x - sliding.stop()).abs());
    let methods = SceneMethod::all(METHODS, error);
    LabScene { methods, world: sliding.world(), ..LabScene::new("slide", "Sliding 5.13 m to a stop, 10 s", SECONDS, 1) }
}
