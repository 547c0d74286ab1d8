//! Which impacts of a crowd step bounce, and how fast what they hit leaves.

use crate::physics::crowd::bodies::{Bodies, Thing};
use crate::physics::crowd::contacts::Contact;

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

    /// The restitution of a pair that merges, if its impact bounces.
    pub fn of(self, bodies: &Bodies, contact: &Contact, axis: usize) -> Option<f64> {
        let (i, j) = (contact.first as usize, contact.second as usize);
        let restitution = bodies.coefficients(i.min(j), i.max(j)).restitution;
        let (a, b) = (&bodies[i], &bodies[j]);
        let side = if b.from[axis] < a.from[axis] { -1.0 } else { 1.0 };
        let gap = ((b.from - a.from).abs() - a.half - b.half)[axis].max(0.0);
        let pull = ((a.free - a.before) - (b.free - b.before))[axis] * side / self.dt;
        let closing = (a.before - b.before)[axis] * side;
        let speed = (closing * closing.abs() + 2.0 * pull * gap).max(0.0).sqrt();
        (self.leaves(restitution, speed, pull) > 0.0).then_some(restitution)
    }
}

/// One body along one axis: velocity at the start and at the end if nothing were touched, how far the solution has it go, m, and how fast it
/// ends, m/s.
pub(crate) struct Fall {
    pub before: f64,
    pub free: f64,
    pub way: f64,
    pub end: f64,
}

impl Fall {
    /// Of a body along gravity that goes so far and ends so fast.
    pub fn of(body: &Thing, way: f64, end: f64) -> Self {
        Self { before: body.before.y, free: body.free.y, way, end }
    }

    /// The velocity with which it leaves what has stopped it, m/s.
    pub fn rebound(&self, restitution: f64, bounces: Bounces) -> f64 {
        let side = if self.free < self.end { -1.0 } else { 1.0 };
        let (closing, pull) = ((self.before - self.end) * side, (self.free - self.before) / bounces.dt * side);
        let square = closing * closing.abs() + 2.0 * pull * (self.way - self.end * bounces.dt) * side;
        self.end - side * bounces.leaves(restitution, square.max(0.0).sqrt(), pull)
    }
}
