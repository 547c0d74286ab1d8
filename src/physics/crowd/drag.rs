//! Drag on what does not fly.
//!
//! Flight tells how the air slows a body that touches nothing: one that stands would fall within the step, and show its top to the air; one
//! that friction brakes would be faster. So where something rubs, drag is told anew: by a flight on which what the contacts leave pulls at it
//! besides. That is stable however light it is.

use crate::physics::flight::air::fly_through;
use crate::physics::forces::air::Drag;
use crate::physics::store::bodies::Bodies;
use glam::DVec2;

/// Free flight as it was before drag was told anew.
#[derive(Clone, Debug, Default)]
pub(crate) struct Resistance {
    saved: Vec<(u32, [f64; 2])>,
}

impl Resistance {
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

    /// Tells drag across anew, and with it the free way; puts the free momentum into `given`. Returns whether that changed anything.
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

impl Bodies {
    /// Whether nothing but the air slows the flight of a body, and it does.
    pub(crate) fn meets_air(&self, i: usize) -> bool {
        self.airy && self.drag_wide[i] + self.drag_tall[i] + self.drag_round[i] > 0.0 && !self.is_guided[i]
    }

    /// The drag of the air on a body.
    pub(crate) fn drag_of(&self, i: usize) -> Drag {
        Drag { tall: self.drag_tall[i], wide: self.drag_wide[i], round: self.drag_round[i] }
    }
}
