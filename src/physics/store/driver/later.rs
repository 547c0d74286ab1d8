//! Islands whose step begins later than that of the others, because somebody else has brought them so far; and surfaces that go another way for
//! one island than for the others.

use crate::physics::crowd::flight;
use crate::physics::store::bodies::Bodies;
use crate::physics::store::driver::{Driver, set_final_velocity, set_velocity};
use crate::physics::store::islands::Island;
use glam::DVec2;

/// A body whose start was moved to a later time of the step: its slot, place, velocity and free velocity as they were.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moved {
    slot: u32,
    place: (f64, f64),
    velocity: (f64, f64),
    free: (f64, f64),
}

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
    /// Lets the step of an island begin later, when `left` seconds of it are left: where its bodies are predicted now.
    pub(crate) fn begin_later(&mut self, bodies: &mut Bodies, island: Island<'_>, left: f64, drag: bool) {
        for &slot in island.members {
            let i = slot as usize;
            let (place, velocity) = ((bodies.x[i], bodies.y[i]), (bodies.vx[i], bodies.vy[i]));
            self.moved.push(Moved { slot, place, velocity, free: (bodies.free_vx[i], bodies.free_vy[i]) });
            (bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i]) = (bodies.px[i], bodies.py[i], bodies.ux[i], bodies.uy[i]);
            flight::fly_one(bodies, i, left, drag);
        }
    }

    /// Lets surfaces that move begin where they are when `left` of the step's `dt` seconds are left, for an island that begins then.
    pub(crate) fn begin_surfaces_later(&mut self, bodies: &mut Bodies, dt: f64, left: f64) {
        self.held.clear();
        for target in &self.targets {
            let j = bodies.len() + target.surface as usize;
            let (start, end) = ((bodies.x[j], bodies.y[j]), (bodies.px[j], bodies.py[j]));
            let (velocity, last, was) =
                ((bodies.vx[j], bodies.vy[j]), (bodies.ux[j], bodies.uy[j]), (bodies.was_vx[j], bodies.was_vy[j]));
            self.held.push(Held { slot: j, start, end, velocity, last, was });
            (bodies.x[j], bodies.y[j]) = (start.0 + velocity.0 * (dt - left), start.1 + velocity.1 * (dt - left));
            let Some(placed) = self.placed.iter().find(|placed| placed.surface == target.surface) else { continue };
            (bodies.x[j], bodies.y[j]) = placed.position.into();
            (bodies.was_vx[j], bodies.was_vy[j]) = placed.velocity.into();
            let (end, last) = placed.stops.map_or((end, last), |at| (at.into(), (0.0, 0.0)));
            (bodies.px[j], bodies.py[j]) = end;
            set_velocity(bodies, j, ((end.0 - bodies.x[j]) / left, (end.1 - bodies.y[j]) / left));
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

    /// Gives bodies of which `again` says so back the start of the whole step.
    pub(crate) fn put_back_moved(&mut self, bodies: &mut Bodies, again: impl Fn(u32) -> bool) {
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
