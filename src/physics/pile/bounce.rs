//! Restitution: impacts found by the plastic solve get their rebound after the move.
//!
//! A contact that had to stop more than [`IMPACT`] steps of gravity is an impact. Its closing speed is that at the moment of
//! touching, w² = v² + 2·a·gap; the pair leaves with e·w, e the larger restitution of the two, unless that is below the world's
//! rest speed. On what the ground holds only the upper body turns round; in the air both do, with equal and opposite impulses.
//! No rebound leaves a pair with more kinetic energy than it had.

use super::bodies::Bodies;

/// A contact that stops more than this many steps of gravity is an impact. Below 1: resting contacts bounce for ever.
const IMPACT: f64 = 2.0;
/// The smallest impact, m/s, where there is no gravity to compare with.
const SMALLEST: f64 = 1e-6;

/// The direction of a contact's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Left and right.
    Across,
    /// Up and down.
    Gravity,
}

/// An impact in this step, by inner numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Impact {
    pub a: u32,
    pub b: u32,
    pub axis: Axis,
    /// Closing speed when touching, m/s.
    pub speed: f64,
}

/// The impacts of one step.
#[derive(Clone, Debug, Default)]
pub(super) struct Impacts {
    pub all: Vec<Impact>,
    threshold: f64,
}

impl Impacts {
    pub fn clear(&mut self, gravity: f64, dt: f64) {
        self.all.clear();
        self.threshold = (IMPACT * gravity.abs() * dt).max(SMALLEST);
    }

    /// Remembers a contact in which the solver stopped `excess` m/s.
    pub fn note(&mut self, a: usize, b: usize, axis: Axis, excess: f64) {
        if excess > self.threshold {
            self.all.push(Impact { a: a as u32, b: b as u32, axis, speed: excess });
        }
    }

    /// Finds the closing speeds when touching and forgets what did not close.
    pub fn measure(&mut self, bodies: &Bodies, dt: f64) {
        let n = bodies.len();
        let threshold = self.threshold;
        self.all.retain_mut(|hit| {
            let (a, b) = (hit.a as usize, hit.b as usize);
            let (x, v, free, half) = match hit.axis {
                Axis::Across => (&bodies.x, &bodies.vx, &bodies.free_vx, &bodies.hx),
                Axis::Gravity => (&bodies.y, &bodies.vy, &bodies.free_vy, &bodies.hy),
            };
            let side = if x[b] >= x[a] { 1.0 } else { -1.0 };
            let gap = ((x[b] - x[a]).abs() - half[a] - half[b]).max(0.0);
            // What stands on the ground does not fall along with what falls on it.
            let held = b >= n || (hit.axis == Axis::Gravity && bodies.uy[b] == 0.0);
            let gained = (free[a] - v[a]) - if held { 0.0 } else { free[b] - v[b] };
            let before = side * (v[a] - v[b]);
            hit.speed = (before * before.abs() + 2.0 * side * gained / dt * gap).max(0.0).sqrt();
            hit.speed > threshold
        });
    }

    /// Gives every impact its rebound.
    pub fn rebound(&self, bodies: &mut Bodies, anchored: &[bool], rest_speed: f64) {
        let n = bodies.len();
        if self.all.is_empty() {
            return;
        }
        // No more than was taken is given back, in a pair and altogether, by axis.
        let mut lost = [taken(&bodies.mass, &bodies.free_vx, &bodies.ux), taken(&bodies.mass, &bodies.free_vy, &bodies.uy)];
        for hit in &self.all {
            let (a, b) = (hit.a as usize, hit.b as usize);
            let rebound = hit.speed * bodies.traits[a].restitution.max(bodies.traits[b].restitution);
            if rebound <= 0.0 || rebound < rest_speed {
                continue;
            }
            let (x, u, free) = match hit.axis {
                Axis::Across => (&bodies.x, &mut bodies.ux, &bodies.free_vx),
                Axis::Gravity => (&bodies.y, &mut bodies.uy, &bodies.free_vy),
            };
            let side = if x[b] >= x[a] { 1.0 } else { -1.0 };
            let wanted = rebound + side * (u[a] - u[b]);
            if wanted <= 0.0 {
                continue;
            }
            let share = |fixed: bool, i: usize| if fixed { 0.0 } else { 1.0 / bodies.mass[i] };
            let held = |i: usize| i >= n || (hit.axis == Axis::Gravity && anchored[i]);
            // The upper of two is turned round even if it is anchored: it was, on the other.
            let upper_is_a = b >= n || x[a] <= x[b];
            let (of_a, of_b) = match hit.axis {
                Axis::Gravity if a < n && upper_is_a => (share(false, a), share(held(b), b)),
                Axis::Gravity if b < n && a >= n => (0.0, share(false, b)),
                _ => (share(a >= n, a), share(b >= n, b)),
            };
            if of_a + of_b <= 0.0 {
                continue;
            }
            let impulse = side * wanted / (of_a + of_b);
            let (next_a, next_b) = (u[a] - impulse * of_a, u[b] + impulse * of_b);
            let energy = |v: f64, part: f64| if part > 0.0 { 0.5 * v * v / part } else { 0.0 };
            let after = energy(next_a, of_a) + energy(next_b, of_b);
            let gain = after - energy(u[a], of_a) - energy(u[b], of_b);
            let left = &mut lost[usize::from(hit.axis == Axis::Gravity)];
            if after <= energy(free[a], of_a) + energy(free[b], of_b) && gain <= *left {
                (u[a], u[b]) = (next_a, next_b);
                *left -= gain;
            }
        }
    }
}

/// The kinetic energy along one axis that the plastic solve took, J.
fn taken(mass: &[f64], free: &[f64], solved: &[f64]) -> f64 {
    mass.iter().zip(free).zip(solved).map(|((m, before), after)| 0.5 * m * (before * before - after * after)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball that was stopped by the floor at 5 m/s leaves at 2.5 m/s with restitution 0.5, and stays with a rest speed of 3.
    #[test]
    fn leaves_the_floor_with_its_part_of_the_closing_speed() {
        for (rest_speed, leaves) in [(1.0, -2.5), (3.0, 0.0)] {
            let mut bodies = Bodies::new(1, 1);
            (bodies.y[1], bodies.hy[0], bodies.hy[1]) = (1.0, 0.5, 0.5);
            (bodies.vy[0], bodies.free_vy[0], bodies.mass[0]) = (5.0, 5.1, 2.0);
            bodies.traits[0].restitution = 0.5;
            let mut impacts = Impacts::default();
            impacts.clear(10.0, 0.01);
            impacts.note(0, 1, Axis::Gravity, 5.1);
            impacts.measure(&bodies, 0.01);
            impacts.rebound(&mut bodies, &[true, true], rest_speed);
            assert_eq!(bodies.uy[0], leaves);
        }
    }
}
