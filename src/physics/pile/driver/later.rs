//! Islands whose step begins later than that of the others, because somebody else has brought them so far.

use super::super::bodies::Bodies;
use super::super::flight;
use super::super::islands::Island;
use super::{Driver, set_velocity};

/// A body whose start was moved to a later time of the step: its slot, place, velocity and free velocity as they were.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moved {
    slot: u32,
    place: (f64, f64),
    velocity: (f64, f64),
    free: (f64, f64),
}

/// A surface that stands for an island: its slot, and where it began, ends and how fast it goes for all others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    slot: usize,
    start: (f64, f64),
    end: (f64, f64),
    velocity: (f64, f64),
}

impl Driver {
    /// Lets the step of an island begin later, when `left` seconds of it are left: where its bodies are predicted now.
    pub(super) fn begin_later(&mut self, bodies: &mut Bodies, island: Island<'_>, left: f64, drag: bool) {
        for &slot in island.members {
            let i = slot as usize;
            let (place, velocity) = ((bodies.x[i], bodies.y[i]), (bodies.vx[i], bodies.vy[i]));
            self.moved.push(Moved { slot, place, velocity, free: (bodies.free_vx[i], bodies.free_vy[i]) });
            (bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i]) = (bodies.px[i], bodies.py[i], bodies.ux[i], bodies.uy[i]);
            flight::fly_one(bodies, i, left, drag);
            bodies.widen(i);
        }
    }

    /// Lets surfaces that move stand where they are `t` seconds into the step, for an island that begins then: whoever left it to begin later
    /// has stopped them there.
    pub(super) fn hold_surfaces(&mut self, bodies: &mut Bodies, t: f64) {
        self.held.clear();
        for (surface, _) in &self.targets {
            let j = bodies.len() + *surface as usize;
            let (start, velocity) = ((bodies.x[j], bodies.y[j]), (bodies.vx[j], bodies.vy[j]));
            self.held.push(Held { slot: j, start, end: (bodies.px[j], bodies.py[j]), velocity });
            (bodies.x[j], bodies.y[j]) = (start.0 + velocity.0 * t, start.1 + velocity.1 * t);
            (bodies.px[j], bodies.py[j]) = (bodies.x[j], bodies.y[j]);
            set_velocity(bodies, j, (0.0, 0.0));
        }
    }

    /// Lets them go on for the other islands.
    pub(super) fn release_surfaces(&mut self, bodies: &mut Bodies) {
        for Held { slot, start, end, velocity } in self.held.drain(..) {
            ((bodies.x[slot], bodies.y[slot]), (bodies.px[slot], bodies.py[slot])) = (start, end);
            set_velocity(bodies, slot, velocity);
        }
    }

    /// Gives bodies of which `again` says so back the start of the whole step.
    pub(super) fn put_back_moved(&mut self, bodies: &mut Bodies, again: impl Fn(u32) -> bool) {
        self.moved.retain(|moved| {
            let again = again(moved.slot);
            if again {
                let i = moved.slot as usize;
                ((bodies.x[i], bodies.y[i]), (bodies.vx[i], bodies.vy[i])) = (moved.place, moved.velocity);
                (bodies.free_vx[i], bodies.free_vy[i]) = moved.free;
            }
            !again
        });
    }
}
