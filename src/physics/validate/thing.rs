//! What a check knows of a body or surface.

use crate::physics::data::aabb::Aabb;
use glam::DVec2;

/// A body or surface between two ticks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Thing {
    /// Its number, and which of the two it is.
    pub id: u32,
    pub surface: bool,
    /// The box that it fills, the one that it filled a tick ago, and the one around all of its way, m.
    pub now: Aabb,
    pub before: Aabb,
    pub swept: Aabb,
    /// m/s.
    pub velocity: DVec2,
    /// Whether its way has no corner, and it is known where it was.
    pub straight: bool,
    /// Whether the dense method took it, or the rest of its tick.
    pub dense: bool,
    /// How deep something may be in it, m.
    pub depth: f64,
}

impl Thing {
    pub fn name(&self) -> String {
        format!("{} {}", if self.surface { "surface" } else { "body" }, self.id)
    }
}

/// What the place of a box may be off by, m: 16 roundings.
pub(super) fn rounding(bounds: &Aabb) -> f64 {
    16.0 * f64::EPSILON * bounds.min.abs().max(bounds.max.abs()).max_element()
}
