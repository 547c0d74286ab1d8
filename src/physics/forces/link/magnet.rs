//! A magnet: F = s/ℓ² at a distance ℓ, pulling where s is above 0. Nearer than half of both sizes it falls evenly to 0 at no distance, as gravity does
//! inside a ball of even density.

use crate::physics::data::Magnet;
use glam::DVec2;

impl Magnet {
    /// The force on the first end, N; `far`: further than `nearest`.
    pub(crate) fn force(&self, far: bool, apart: DVec2) -> DVec2 {
        let distance = if far { apart.length() } else { self.nearest };
        apart * (self.strength / (distance * distance * distance)).clamp(-f64::MAX, f64::MAX)
    }
}
