//! The last word on energy along gravity: no step leaves more of it than there was.
//!
//! The passes before are made to dissipate each by itself. But a body in a wild crowd that is merged with what goes another way, or
//! parted from it, may end higher than its velocity allows for; then all that was touched in the step is slowed down by one factor,
//! so that kinetic and potential energy together do not grow. It seldom acts: the tests of random crowds fail without it once in some
//! thousand scenes. Its limit: the factor does not conserve momentum, which gravity and the ground take part in anyway.

use super::bodies::Bodies;
use super::bounce::Axis;

/// Energy gained that is no more than rounding, as a part of the kinetic energy. Smaller: rounding slows what it should not.
const ROUNDING: f64 = 1e-12;

/// The kinetic energy along one axis that a step has left beyond what was there and what forces from outside did, J. What nothing
/// touched does not count. `None` where none was gained, or no more than rounding.
pub(super) fn gained(bodies: &Bodies, axis: Axis, dt: f64) -> Option<f64> {
    let (v, free, u) = velocities(bodies, axis);
    let (mut gained, mut brought) = (0.0, 0.0);
    for i in 0..bodies.len() {
        let before = bodies.mass[i] * v[i] * v[i];
        brought += before;
        if u[i] != free[i] {
            gained += 0.5 * (bodies.mass[i] * u[i] * u[i] - before) - work(bodies, axis, dt, i);
        }
    }
    Some(gained).filter(|gained| *gained > ROUNDING * brought)
}

/// The work that the forces from outside did on a body along one axis, J. Drag takes part of it on the way that the body went, but
/// gives nothing back to one that was thrown the other way.
pub(super) fn work(bodies: &Bodies, axis: Axis, dt: f64, i: usize) -> f64 {
    let (v, free, _) = velocities(bodies, axis);
    let (x, px, pull) = match axis {
        Axis::Across => (bodies.x[i], bodies.px[i], bodies.ax[i]),
        Axis::Gravity => (bodies.y[i], bodies.py[i], bodies.ay[i]),
    };
    let (way, mean) = (px - x, (free[i] - v[i]) / dt);
    bodies.mass[i] * way * if way * v[i] >= 0.0 { mean } else { pull }
}

/// Slows down along gravity what was touched, if energy was gained.
pub(super) fn restrain(bodies: &mut Bodies, dt: f64) {
    let Some(gained) = gained(bodies, Axis::Gravity, dt) else { return };
    let touched = |bodies: &Bodies, i: usize| bodies.uy[i] != bodies.free_vy[i];
    let kinetic = |i: usize| if touched(bodies, i) { 0.5 * bodies.mass[i] * bodies.uy[i] * bodies.uy[i] } else { 0.0 };
    let left: f64 = (0..bodies.len()).map(kinetic).sum();
    let part = if left > gained { (1.0 - gained / left).sqrt() } else { 0.0 };
    for i in 0..bodies.len() {
        if touched(bodies, i) {
            bodies.uy[i] *= part;
        }
    }
}

fn velocities(bodies: &Bodies, axis: Axis) -> (&[f64], &[f64], &[f64]) {
    match axis {
        Axis::Across => (&bodies.vx, &bodies.free_vx, &bodies.ux),
        Axis::Gravity => (&bodies.vy, &bodies.free_vy, &bodies.uy),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body that was lifted by 1 m against 10 N/kg and kept its 6 m/s has 10 J a kilogram too many; it keeps what it can pay for.
    #[test]
    fn what_was_lifted_pays_for_it() {
        let mut bodies = Bodies::new(2, 0);
        for i in 0..2 {
            (bodies.mass[i], bodies.ay[i], bodies.vy[i], bodies.free_vy[i]) = (2.0, 10.0, -6.0, -5.0);
            (bodies.py[i], bodies.uy[i]) = (-1.0, -6.0);
        }
        // The second one flies on untouched, and whatever the flight says is right.
        bodies.uy[1] = -5.0;
        restrain(&mut bodies, 0.1);
        assert!((bodies.uy[0] + 16f64.sqrt()).abs() < 1e-12, "{}", bodies.uy[0]);
        assert_eq!(bodies.uy[1], -5.0);
        assert_eq!(gained(&bodies, Axis::Gravity, 0.1), None);
    }
}
