//! Weight: m·g downwards. A weightless body has none.

use crate::physics::data::body::Body;
use crate::physics::forces::media::Media;
use glam::DVec2;

impl Media {
    /// N/kg downwards.
    pub fn gravity_on(&self, body: &Body) -> f64 {
        if body.weightless { 0.0 } else { self.gravity }
    }

    /// N.
    pub fn weight(&self, body: &Body) -> DVec2 {
        DVec2::new(0.0, body.mass * self.gravity_on(body))
    }
}

/// The acceleration along y by gravity and a force per mass, m/s²; 0 where they balance but for rounding.
pub(crate) fn fall(gravity: f64, force: f64) -> f64 {
    let sum = gravity + force;
    if sum.abs() <= 4.0 * f64::EPSILON * gravity.abs() { 0.0 } else { sum }
}
