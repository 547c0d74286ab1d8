//! Which impacts of a crowd step bounce, and how fast what they hit leaves.

use crate::physics::crowd::{bodies::Bodies, bodies::Member, contacts::CrowdContact};

/// Closing speeds up to this are none, m/s. Smaller: rounding bounces.
const SLOWEST: f64 = 1e-9;

/// Which impacts bounce: those that leave faster than `rest_speed`, m/s, unless they are elastic, and come back after the step of `dt` s.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bounces {
    pub dt: f64,
    pub rest_speed: f64,
}

impl Bounces {
    /// The speed with which an impact leaves, m/s; `pull` is what pulls it back, m/s².
    fn leaves(self, restitution: f64, speed: f64, pull: f64) -> f64 {
        let leaves = restitution * speed;
        let lasts = leaves > SLOWEST && 2.0 * leaves > pull * self.dt;
        if lasts && (restitution == 1.0 || leaves >= self.rest_speed) { leaves } else { 0.0 }
    }

    pub fn of(self, bodies: &Bodies, contact: &CrowdContact, axis: usize) -> Option<f64> {
        let (i, j) = (contact.first as usize, contact.second as usize);
        let restitution = bodies.coefficients(i.min(j), i.max(j)).restitution;
        let (speed, pull) = self.closing([&bodies[i], &bodies[j]], axis, false);
        (self.leaves(restitution, speed, pull) > 0.0).then_some(restitution)
    }

    /// The speed with which a pair closes along an axis when it touches, m/s, and the pull of one towards the other, m/s². A second one that
    /// `rests` does not fall along with the first.
    pub fn closing(self, [a, b]: [&Member; 2], axis: usize, rests: bool) -> (f64, f64) {
        let side = if b.from[axis] < a.from[axis] { -1.0 } else { 1.0 };
        let gap = ((b.from - a.from).abs() - a.half - b.half)[axis].max(0.0);
        let gained = (a.free - a.before)[axis] - if rests { 0.0 } else { (b.free - b.before)[axis] };
        let (closing, pull) = ((a.before - b.before)[axis] * side, gained * side / self.dt);
        ((closing * closing.abs() + 2.0 * pull * gap).max(0.0).sqrt(), pull)
    }

    /// The velocity along gravity, m/s, with which a body leaves an impact that ends its `way` (m) with the velocity `end`.
    pub fn rebound(self, body: &Member, way: f64, end: f64, restitution: f64) -> f64 {
        let (before, free) = (body.before.y, body.free.y);
        let side = if free < end { -1.0 } else { 1.0 };
        let (closing, pull) = ((before - end) * side, (free - before) / self.dt * side);
        let square = closing * closing.abs() + 2.0 * pull * (way - end * self.dt) * side;
        end - side * self.leaves(restitution, square.max(0.0).sqrt(), pull)
    }
}
