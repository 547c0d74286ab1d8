//! Exact flows of drag, where there are any: a rise and fall, drag alone, a thick liquid. Each takes a step of any length and can be
//! cut anywhere. Derived in any text on mechanics; with g = A, v_t = √(g/k) and τ = g·t/v_t throughout.

use super::motion::{MotionLaw, PointState, decay, exact_fall};
use crate::physics::DVec2;

/// Thrown straight up and falling again (A = (0, g) with g > 0, no wind): with φ = artan(v₀/v_t) the speed upwards is
/// v_t·tan(φ − τ) until the top, (v_t²/2g)·ln(1 + v₀²/v_t²) above, and a fall from rest from then on.
pub fn rise_and_fall(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    if v.y >= 0.0 {
        return exact_fall(law, PointState { x, v }, h);
    }
    let g = law.constant.y;
    let terminal = (g / law.drag).sqrt();
    let up = -v.y / terminal;
    let (phi, tau) = (libm::atan(up), g * h / terminal);
    let scale = terminal * terminal / g;
    if tau < phi {
        // cos(φ − τ)/cos φ, by the theorem of addition.
        let risen = scale * libm::log(libm::cos(tau) + up * libm::sin(tau));
        return PointState { x: x - DVec2::new(0.0, risen), v: DVec2::new(0.0, -terminal * libm::tan(phi - tau)) };
    }
    let top = 0.5 * scale * libm::log1p(up * up);
    exact_fall(law, PointState { x: x - DVec2::new(0.0, top), v: DVec2::ZERO }, (tau - phi) * terminal / g)
}

/// Quadratic drag alone (A = 0, c = 0), in any direction: v = v₀/(1 + k·|v₀|·t), s = ln(1 + k·|v₀|·t)/k in the air's frame.
pub fn drag_alone(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    let u = v - law.wind;
    let speed = u.length();
    let way = if speed > 0.0 { u * (libm::log1p(law.drag * speed * h) / (law.drag * speed)) } else { DVec2::ZERO };
    PointState { x: x + law.wind * h + way, v: decay(law, v, h) }
}

/// Drag in proportion to the velocity (k = 0): v = v∞ + (v₀ − v∞)·e^(−c·t), v∞ = w + A/c.
pub fn in_liquid(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    let end = law.wind + law.constant / law.viscous;
    let passed = -libm::expm1(-law.viscous * h);
    PointState { x: x + end * h + (v - end) * (passed / law.viscous), v: v + (end - v) * passed }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::methods::motion::{MotionStep, follow, rk4};

    /// Against RK4, and cut into steps.
    fn agrees(flow: MotionStep, law: MotionLaw, v: DVec2) {
        let start = PointState { x: DVec2::new(1.0, 2.0), v };
        let whole = flow(&law, start, 3.0);
        for (other, most) in [(follow(flow, &law, start, 3.0, 0.125), 1e-13), (follow(rk4, &law, start, 3.0, 1e-3), 1e-10)] {
            assert!(
                (whole.x - other.x).length() < most * 100.0 && (whole.v - other.v).length() < most * 100.0,
                "{whole:?} {other:?}"
            );
        }
    }

    #[test]
    fn exact_flows_agree_with_fine_steps_and_can_be_cut_anywhere() {
        let g = DVec2::new(0.0, 9.81);
        agrees(rise_and_fall, MotionLaw { constant: g, drag: 0.05, ..MotionLaw::default() }, DVec2::new(0.0, -20.0));
        agrees(drag_alone, MotionLaw { drag: 0.05, wind: DVec2::new(4.0, 0.0), ..MotionLaw::default() }, DVec2::new(20.0, -15.0));
        agrees(in_liquid, MotionLaw { constant: g, viscous: 0.5, ..MotionLaw::default() }, DVec2::new(2.0, -3.0));
    }

    #[test]
    fn what_was_thrown_up_comes_back_slower_as_the_formula_says() {
        let law = MotionLaw { constant: DVec2::new(0.0, 9.81), drag: 0.05, ..MotionLaw::default() };
        let terminal = (9.81f64 / 0.05).sqrt();
        let start = PointState { x: DVec2::ZERO, v: DVec2::new(0.0, -20.0) };
        // The moment at which it is back, by bisection.
        let (mut early, mut late) = (1.0, 10.0);
        for _ in 0..60 {
            let middle = 0.5 * (early + late);
            if rise_and_fall(&law, start, middle).x.y < 0.0 { early = middle } else { late = middle }
        }
        let back = rise_and_fall(&law, start, early).v.y;
        assert!((back - 20.0 * terminal / (400.0 + terminal * terminal).sqrt()).abs() < 1e-12, "{back}");
    }
}
