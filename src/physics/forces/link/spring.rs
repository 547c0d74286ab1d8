//! A spring: F = k·(ℓ − L) + c·ℓ′ along its length ℓ, pulling where that is longer than L (Hooke 1678).

use crate::physics::data::Spring;
use glam::DVec2;

impl Spring {
    /// The force on the first end, N; `apart` (m) leads from it to the other end, `parting` (m/s) is the rate of that.
    #[inline]
    pub(crate) fn force(&self, apart: DVec2, parting: DVec2) -> DVec2 {
        let along = apart.normalize_or_zero();
        apart * self.stiffness + along * (self.damping * along.dot(parting) - self.stiffness * self.length)
    }

    /// ½k(ℓ − L)², J.
    pub(crate) fn energy(&self, distance: f64) -> f64 {
        0.5 * self.stiffness * (distance - self.length).powi(2)
    }
}
