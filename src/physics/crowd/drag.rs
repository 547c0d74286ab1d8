//! Drag on bodies in contact.
//!
//! Free flight knows no contacts: a standing body would fall within the step and show its top to the air, and a braked one be faster. So drag of
//! bodies in contact is found again, by a flight under the forces of their contacts as well: stable however light the body is.

use crate::physics::{crowd::bodies::Bodies, flight::air::fly_through};
use glam::DVec2;

#[derive(Clone, Debug, Default)]
pub(crate) struct Resistance {
    pub saved: Vec<(u32, DVec2)>,
}

impl Resistance {
    pub fn restore(&mut self, bodies: &mut Bodies) {
        for (i, free) in self.saved.drain(..).rev() {
            bodies[i as usize].free = free;
        }
    }

    pub fn along(&mut self, bodies: &mut Bodies, of: &[u32], dt: f64) {
        // For the rounds of friction as well.
        self.saved.reserve(4 * of.len());
        for &i in of {
            let i = i as usize;
            let stands = bodies[i].before.y == 0.0 && bodies[i].end.y == 0.0 && bodies[i].mean.y == 0.0;
            if stands && bodies.meets_air(i) {
                self.saved.push((i as u32, bodies[i].free));
                bodies[i].free.y = bodies[i].pull.y * dt;
            }
        }
    }

    pub fn across(&mut self, bodies: &mut Bodies, of: &[u32], given: &mut [f64], dt: f64) -> bool {
        let mut any = false;
        for &i in of {
            let i = i as usize;
            if !bodies.meets_air(i) || (bodies[i].before.x == 0.0 && bodies[i].end.x == 0.0) {
                continue;
            }
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
