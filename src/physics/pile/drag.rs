//! Drag on what does not fly.
//!
//! Flight tells how the air slows a body that touches nothing: one that stands would fall within the step, and show its top to the air; one
//! that friction brakes would be faster. So where something rubs, drag is told anew from the velocities that the contacts leave, by
//! Simpson's rule over the step along the way, and by the mean fall.

use super::bodies::Bodies;

/// Free flight as it was before drag was told anew.
#[derive(Clone, Debug, Default)]
pub(super) struct Resistance {
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
            let (before, mean, after, fall) = (bodies.vx[i], bodies.mean_vx[i], bodies.ux[i], bodies.mean_vy[i]);
            let at = |speed: f64| bodies.drag_at(i, speed, fall) * speed;
            let drag = -(at(before) + 4.0 * at(mean) + at(after)) / 6.0;
            let change = (bodies.ax[i] + drag) * dt - (bodies.free_vx[i] - before);
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
    fn meets_air(&self, i: usize) -> bool {
        self.airy && self.drag_wide[i] + self.drag_tall[i] + self.drag_round[i] > 0.0 && !self.is_guided[self.id[i] as usize]
    }

    /// By what a velocity across and a fall are multiplied to be a deceleration, 1/s.
    fn drag_at(&self, i: usize, across: f64, fall: f64) -> f64 {
        self.drag_tall[i] * across.abs() + self.drag_wide[i] * fall.abs() + self.drag_round[i] * across.hypot(fall)
    }
}
