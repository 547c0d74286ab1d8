//! The stages of a step of joined items.

use crate::physics::data::{Pose, Quintic};
use crate::physics::flight::steps::{ERROR, sum};
use glam::DVec2;

/// An item's part of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CoupledStep {
    pub start: Pose,
    /// How far from there it is at the present stage, and how fast: bodies that move as one have the same bits, whatever their places.
    pub end: Pose,
    /// Velocities and accelerations at the stages.
    pub speeds: [DVec2; 7],
    pub pulls: [DVec2; 7],
    /// Whether an acceleration differs from the first.
    pub bends: bool,
}

impl CoupledStep {
    pub fn stage(&self) -> Pose {
        (self.start.0 + self.end.0, self.end.1)
    }

    /// m.
    pub fn error(&self, h: f64) -> f64 {
        (sum(&self.speeds, &ERROR) * h).abs().max((sum(&self.pulls, &ERROR) * (h * h)).abs()).max_element()
    }

    /// The path through both ends of `h` seconds, from a time on, with the accelerations there; a cubic where contacts change just before the end.
    pub fn course(&self, since: f64, h: f64, changes: bool) -> Quintic {
        let Self { start: (x, v), end: (way, w), pulls: [a, .., b], .. } = *self;
        let b = if changes { (6.0 * way / h - 2.0 * v - 4.0 * w) / -h } else { b };
        Quintic::through(since, [x, v, a], [way, w, b], h)
    }
}
