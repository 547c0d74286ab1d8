//! Surfaces that go another way for one island than for the others.

use crate::physics::store::bodies::Bodies;
use crate::physics::store::driver::{Driver, set_final_velocity, set_velocity};
use glam::DVec2;

/// Where somebody else has left a surface, m and m/s, inside.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed {
    pub surface: u32,
    pub position: DVec2,
    pub velocity: DVec2,
    /// Where it stops before the step ends, m, if it does: there it stays.
    pub stops: Option<DVec2>,
}

/// A surface that begins later for an island: its slot, and for all others where it begins and ends, how fast it goes on average, in the end,
/// and was before.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Held {
    slot: usize,
    start: (f64, f64),
    end: (f64, f64),
    velocity: (f64, f64),
    last: (f64, f64),
    was: (f64, f64),
}

impl Driver {
    /// Lets surfaces that move stop where the island at hand has been told so.
    pub(crate) fn hold_surfaces(&mut self, bodies: &mut Bodies, dt: f64) {
        self.held.clear();
        for target in &self.targets {
            let j = bodies.len() + target.surface as usize;
            let (start, end) = ((bodies.x[j], bodies.y[j]), (bodies.px[j], bodies.py[j]));
            let (velocity, last, was) =
                ((bodies.vx[j], bodies.vy[j]), (bodies.ux[j], bodies.uy[j]), (bodies.was_vx[j], bodies.was_vy[j]));
            self.held.push(Held { slot: j, start, end, velocity, last, was });
            let Some(placed) = self.placed.iter().find(|placed| placed.surface == target.surface) else { continue };
            (bodies.x[j], bodies.y[j]) = placed.position.into();
            (bodies.was_vx[j], bodies.was_vy[j]) = placed.velocity.into();
            let (end, last) = placed.stops.map_or((end, last), |at| (at.into(), (0.0, 0.0)));
            (bodies.px[j], bodies.py[j]) = end;
            set_velocity(bodies, j, ((end.0 - bodies.x[j]) / dt, (end.1 - bodies.y[j]) / dt));
            set_final_velocity(bodies, j, last);
        }
    }

    /// Lets them go on for the other islands.
    pub(crate) fn release_surfaces(&mut self, bodies: &mut Bodies) {
        for Held { slot, start, end, velocity, last, was } in self.held.drain(..) {
            ((bodies.x[slot], bodies.y[slot]), (bodies.px[slot], bodies.py[slot])) = (start, end);
            set_velocity(bodies, slot, velocity);
            set_final_velocity(bodies, slot, last);
            (bodies.was_vx[slot], bodies.was_vy[slot]) = was;
        }
    }
}
