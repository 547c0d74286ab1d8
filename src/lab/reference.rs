//! Motion with quadratic drag in two dimensions has no closed form. It is found by RK4 with a step of 1e-5 s, finer where drag is so
//! fast that this would be coarse, and, as a check, by a second method that shares neither its equation nor its code: with
//! q = exp(∫k|u|dt) and Q = ∫q dt the velocity in the air's frame is u = (u₀ + A·Q)/Q′ exactly, and Q″ = k·|u₀ + A·Q| is one scalar
//! equation.

use super::methods::motion::{MotionLaw, PointState, rk4};

/// s. The longest step. Finer, and rounding grows.
pub const STEP: f64 = 1e-5;
/// How much of its velocity drag may take in a step. Coarser, and a gust of 40 m/s on the lightest thing costs RK4 5e-9 m.
const LOST: f64 = 0.01;

/// By RK4 in steps of [`STEP`], or of less where drag is fast.
pub fn drag_in_two_dimensions(law: &MotionLaw, start: PointState, seconds: f64) -> PointState {
    // Whole steps that fill the time: a sum of many rounded steps would miss its end.
    let steps = (seconds / STEP).ceil().max(1.0);
    let h = seconds / steps;
    (0..steps as u64).fold(start, |point, _| {
        let rate = law.drag * (point.v - law.wind).length() + law.viscous;
        let parts = (rate * h / LOST).ceil().max(1.0);
        (0..parts as u64).fold(point, |point, _| rk4(law, point, h / parts))
    })
}

/// By the scalar equation, started again in each step of `h` s, so that Q′ cannot overflow; Q by RK4 and the distance by Simpson's rule on
/// the same stages.
pub fn by_scalar_equation(law: &MotionLaw, start: PointState, seconds: f64, h: f64) -> PointState {
    let steps = (seconds / h).round() as u64;
    (0..steps).fold(start, |PointState { x, v }, _| {
        let u0 = v - law.wind;
        let curve = |q: f64| law.drag * (u0 + law.constant * q).length();
        let (mut q, mut rate) = (0.0, 1.0);
        let mut middle = (0.0, 1.0);
        // Two half steps of RK4, for Simpson's rule needs the velocity in the middle.
        for half in 0..2 {
            let d = 0.5 * h;
            let k1 = (rate, curve(q));
            let k2 = (rate + 0.5 * d * k1.1, curve(q + 0.5 * d * k1.0));
            let k3 = (rate + 0.5 * d * k2.1, curve(q + 0.5 * d * k2.0));
            let k4 = (rate + d * k3.1, curve(q + d * k3.0));
            q += d / 6.0 * (k1.0 + 2.0 * (k2.0 + k3.0) + k4.0);
            rate += d / 6.0 * (k1.1 + 2.0 * (k2.1 + k3.1) + k4.1);
            if half == 0 {
                middle = (q, rate);
            }
        }
        let velocity = |(q, rate): (f64, f64)| (u0 + law.constant * q) / rate;
        let end = velocity((q, rate));
        PointState { x: x + law.wind * h + (u0 + velocity(middle) * 4.0 + end) * (h / 6.0), v: end + law.wind }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::DVec2;

    #[test]
    fn two_methods_agree() {
        for (drag, v) in
            [(0.05, DVec2::new(20.0, -20.0)), (9.81 / 0.0324, DVec2::new(40.0, 0.0)), (9.81 / 0.0324, DVec2::new(-36.0, 0.0))]
        {
            let law = MotionLaw { constant: DVec2::new(0.0, 9.81), drag, wind: DVec2::new(4.0, 0.0), ..MotionLaw::default() };
            let start = PointState { x: DVec2::ZERO, v };
            let one = drag_in_two_dimensions(&law, start, 0.5);
            let other = by_scalar_equation(&law, start, 0.5, 0.5 * STEP);
            assert!((one.x - other.x).length() < 1e-10, "{one:?} {other:?}");
            assert!((one.v - other.v).length() < 1e-10, "{one:?} {other:?}");
        }
    }

    #[test]
    fn any_time_is_met_exactly() {
        let law = MotionLaw::default();
        let start = PointState { x: DVec2::ZERO, v: DVec2::new(3.0, -4.0) };
        for seconds in [1.0 / 60.0, 1.234_567, 1e-7] {
            let end = drag_in_two_dimensions(&law, start, seconds);
            assert!((end.x - start.v * seconds).length() < 1e-10 * seconds.max(1e-3), "{seconds} s");
        }
    }
}
