//! Drag on what does not fly.
//!
//! The drag of free flight is that of a body that touches nothing: a body that stands would fall within the step and show its top to the air; a
//! body that friction brakes would be faster. So drag of what rubs is found again, by a flight under the forces of its contacts as well. That is
//! stable however light the body is.

use crate::physics::crowd::bodies::Bodies;
use crate::physics::flight::air::fly_through;
use glam::DVec2;

/// Free flight as it was before drag was found again.
#[derive(Clone, Debug, Default)]
pub(crate) struct Resistance {
    saved: Vec<(u32, DVec2)>,
}

impl Resistance {
    /// Begins an island.
    pub fn begin(&mut self) {
        self.saved.clear();
    }

    /// Sets the free velocities to what flight made of them.
    pub fn restore(&mut self, bodies: &mut Bodies) {
        for (i, free) in self.saved.drain(..).rev() {
            bodies[i as usize].free = free;
        }
    }

    /// What stands presses with all its weight: it does not fall through the air.
    pub fn along(&mut self, bodies: &mut Bodies, of: &[u32], dt: f64) {
        for &i in of {
            let i = i as usize;
            let stands = bodies[i].before.y == 0.0 && bodies[i].end.y == 0.0 && bodies[i].mean.y == 0.0;
            if stands && bodies.meets_air(i) {
                self.saved.push((i as u32, bodies[i].free));
                bodies[i].free.y = bodies[i].pull.y * dt;
            }
        }
    }

    /// Finds drag across again, and with it the free way; puts the free momentum into `given`. Returns whether that changed anything.
    pub fn across(&mut self, bodies: &mut Bodies, of: &[u32], given: &mut [f64], dt: f64) -> bool {
        let mut any = false;
        for &i in of {
            let i = i as usize;
            if !bodies.meets_air(i) || (bodies[i].before.x == 0.0 && bodies[i].end.x == 0.0) {
                continue;
            }
            // What contacts add to what acts from outside, as if it did so throughout the step.
            let body = &mut bodies[i];
            let pull = body.pull + (body.end - body.free) / dt;
            let (_, after) = fly_through((DVec2::ZERO, body.before), pull, &body.drag, dt);
            let drag = after.x - (body.before.x + pull.x * dt);
            let change = (body.before.x + body.pull.x * dt + drag) - body.free.x;
            self.saved.push((i as u32, body.free));
            body.free.x += change;
            body.to.x += 0.5 * change * dt;
            given[i] += body.mass * change;
            any = true;
        }
        any
    }
}
