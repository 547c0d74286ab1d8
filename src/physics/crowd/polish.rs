//! Parts what still closes across when the solution has ended.

use crate::physics::crowd::ACROSS;
use crate::physics::crowd::bodies::Bodies;
use crate::physics::crowd::contacts::Contact;
use crate::physics::crowd::cross::{Cross, Pushes, STILL};
use crate::physics::crowd::impulses::Edge;

/// Sweeps in which what still closes in the end is parted. Fewer: a light body that heavy ones drag against a third keeps a part of its speed.
const SWEEPS: usize = 32;
/// Relative to the velocities: what closes more slowly does not. Smaller: rounding is swept.
const CLOSING: f64 = 1e-12;

impl Cross<'_> {
    /// Parts pairs side by side that still close, in turns with the friction under them, contact by contact: the ways are known, but a light
    /// body between heavy ones that drag it may have any velocity. Returns whether nothing closes any more.
    pub(crate) fn polish(&mut self, bodies: &mut Bodies) -> bool {
        let (n, slack) = (bodies.len(), self.contacts.tolerances.hair / self.dt);
        let side_bounces = |bodies: &Bodies, side: &Contact| self.anchors.bounces.of(bodies, side, ACROSS).is_some();
        let Pushes { parting, .. } = &mut *self.pushes;
        let touches = |bodies: &Bodies, side: &Contact| {
            let (a, b) = (side.first as usize, side.second as usize);
            // What arrives just as the step ends bounces in the next.
            let arrives = |side| bodies.bounces && side_bounces(bodies, side);
            side.live && bodies[a].mean.x - bodies[b].mean.x - side.bound >= -slack && !arrives(side)
        };
        let closes = |bodies: &Bodies, side: &Contact| {
            let (u, v) = (bodies[side.first as usize].end.x, bodies[side.second as usize].end.x);
            u - v > CLOSING * (u.abs() + v.abs()) + STILL
        };
        if !self.contacts.sides.iter().any(|side| closes(bodies, side) && touches(bodies, side)) {
            return true;
        }
        let mut settled = false;
        parting.clear();
        let sides = self.contacts.sides.iter().filter(|side| touches(bodies, side));
        parting.extend(sides.map(|side| Edge { a: side.first, b: side.second, ..Edge::default() }));
        for _ in 0..SWEEPS {
            let (mut most, mut fastest) = (0.0f64, 0.0f64);
            for edge in parting.iter_mut() {
                let (a, b) = (edge.a as usize, edge.b as usize);
                let share = |i: usize| if i < n { 1.0 / bodies[i].mass } else { 0.0 };
                let (of_a, of_b) = (share(a), share(b));
                let more = (edge.impulse + (bodies[a].end.x - bodies[b].end.x) / (of_a + of_b)).max(0.0) - edge.impulse;
                edge.impulse += more;
                bodies[a].end.x -= more * of_a;
                bodies[b].end.x += more * of_b;
                most = most.max(more.abs() * of_a.max(of_b));
                fastest = fastest.max(bodies[a].end.x.abs()).max(bodies[b].end.x.abs());
            }
            most = most.max(self.friction.sweep(bodies));
            settled = most <= CLOSING * fastest + STILL;
            if settled {
                break;
            }
        }
        if self.report.on {
            self.report.sides.extend(parting.iter().filter(|edge| edge.impulse > 0.0));
        }
        settled
    }
}
