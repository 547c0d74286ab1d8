//! A rope: a spring that never pushes, and does nothing while its ends are nearer than its length.

use crate::physics::data::Spring;
use glam::DVec2;

/// Above 0 where the rope pulls, below 0 where it is slack, m: the smaller one of its stretch and of its pull in stretches.
pub(crate) fn tautness(rope: &Spring, apart: DVec2, parting: DVec2) -> f64 {
    let (stretch, rate) = (apart.length() - rope.length, apart.normalize_or_zero().dot(parting));
    let pull = rope.stiffness * stretch + rope.damping * rate;
    stretch.min(pull / (rope.stiffness + rope.damping).max(f64::MIN_POSITIVE))
}
