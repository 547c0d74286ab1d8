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
    saved: Vec<(u32, [f64; 2])>,
}

impl Resistance {
    /// Begins an island.
    pub fn begin(&mut self) {
        self.saved.clear();
    }

    /// Sets the free velocities to what flight made of them.
    pub fn restore(&mut self, bodies: &mut Bodies) {
        for (i, free) in self.saved.drain(..).rev() {
            (bodies.free_vx[i as usize], bodies.free_vy[i as usize]) = free.into();
        }
    }

    /// What stands presses with all its weight: it does not fall through the air.
    pub fn along(&mut self, bodies: &mut Bodies, of: &[u32], dt: f64) {
        for &i in of {
            let i = i as usize;
            let stands = bodies.vy[i] == 0.0 && bodies.uy[i] == 0.0 && bodies.mean_vy[i] == 0.0;
            if stands && bodies.meets_air(i) {
                self.saved.push((i as u32, [bodies.free_vx[i], bodies.free_vy[i]]));
                bodies.free_vy[i] = bodies.ay[i] * dt;
            }
        }
    }

    /// Finds drag across again, and with it the free way; puts the free momentum into `given`. Returns whether that changed anything.
    pub fn across(&mut self, bodies: &mut Bodies, of: &[u32], given: &mut [f64], dt: f64) -> bool {
        let mut any = false;
        for &i in of {
            let i = i as usize;
            if !bodies.meets_air(i) || (bodies.vx[i] == 0.0 && bodies.ux[i] == 0.0) {
                continue;
            }
            // What contacts add to what acts from outside, as if it did so throughout the step.
            let touched = |free: f64, now: f64| (now - free) / dt;
            let pull = DVec2::new(
                bodies.ax[i] + touched(bodies.free_vx[i], bodies.ux[i]),
                bodies.ay[i] + touched(bodies.free_vy[i], bodies.uy[i]),
            );
            let velocity = DVec2::new(bodies.vx[i], bodies.vy[i]);
            let (_, after) = fly_through((DVec2::ZERO, velocity), pull, &bodies.drag_of(i), dt);
            let drag = after.x - (velocity.x + pull.x * dt);
            let change = (velocity.x + bodies.ax[i] * dt + drag) - bodies.free_vx[i];
            self.saved.push((i as u32, [bodies.free_vx[i], bodies.free_vy[i]]));
            bodies.free_vx[i] += change;
            bodies.px[i] += 0.5 * change * dt;
            given[i] += bodies.mass[i] * change;
            any = true;
        }
        any
    }
}
