//! When a body crosses the border of a zone, on a cubic that follows its motion.

use super::Aabb;
use super::impact_time::{Cubic, earliest};
use super::tuning::MIN_SPLIT;
use glam::DVec2;

/// When a body enters (or, from inside, leaves) a zone.
pub(super) fn border(cubic: &Cubic, half: DVec2, zone: &Aabb, inside: bool, end: f64) -> Option<f64> {
    let centre = zone.centre();
    let reach = half + zone.size() * 0.5;
    let still = Cubic::parabola(centre, DVec2::ZERO, DVec2::ZERO);
    let motion = still.relative(cubic);
    let mut best: Option<f64> = None;
    for axis in 0..2 {
        let (path, other) = (motion.axis(axis), motion.axis(1 - axis));
        let level = reach[axis];
        let t = if inside {
            earliest(path.rises_through(level, 0.0, end), path.falls_through(-level, 0.0, end))
        } else {
            earliest(path.falls_through(level, 0.0, end), path.rises_through(-level, 0.0, end))
                .filter(|&t| other.at(t).abs() <= reach[1 - axis])
        };
        best = earliest(best, t.filter(|&t| t < end));
    }
    best
}

/// When the submerged part of a body begins, ends, or starts or stops to change along an axis.
pub(super) fn surface_kink(cubic: &Cubic, half: DVec2, zone: &Aabb, end: f64) -> Option<f64> {
    let still = Cubic::parabola(zone.centre(), DVec2::ZERO, DVec2::ZERO);
    let motion = still.relative(cubic);
    let zone_half = zone.size() * 0.5;
    let mut best: Option<f64> = None;
    for axis in 0..2 {
        let (path, other) = (motion.axis(axis), motion.axis(1 - axis));
        for level in [zone_half[axis] + half[axis], (zone_half[axis] - half[axis]).abs()] {
            for level in [level, -level] {
                let t = earliest(path.falls_through(level, MIN_SPLIT, end), path.rises_through(level, MIN_SPLIT, end));
                let meets = |t: &f64| *t < end && other.at(*t).abs() <= zone_half[1 - axis] + half[1 - axis];
                best = earliest(best, t.filter(meets));
            }
        }
    }
    best
}
