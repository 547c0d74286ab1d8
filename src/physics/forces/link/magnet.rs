//! A magnet: F = s/ℓ² at a distance ℓ, pulling where s is above 0. Nearer than half of both sizes it falls evenly to 0 at no distance, as gravity does
//! inside a ball of even density.

use glam::DVec2;

/// A pull that falls with the square of the distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Magnet {
    /// N·m²; below 0 it pushes.
    pub strength: f64,
    /// The distance of its largest force, m; a world takes half of both sizes, if that is more.
    pub nearest: f64,
}

impl Magnet {
    /// The force on the first end, N; `far`: further than `nearest`.
    pub(crate) fn force(&self, far: bool, apart: DVec2) -> DVec2 {
        let distance = if far { apart.length() } else { self.nearest };
        apart * (self.strength / (distance * distance * distance)).clamp(-f64::MAX, f64::MAX)
    }
}
