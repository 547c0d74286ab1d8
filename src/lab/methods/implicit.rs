//! Steps whose end stands on both sides of their rule: one step of length h of the law of [`super::motion`]. All three are stable
//! wherever the truth is (A-stable; E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, IV.3): on y′ = λ·y they multiply
//! by 1/(1 − z), and by (1 + z/2)/(1 − z/2) both others, z = h·λ. Each solves for the velocity at its end by Newton's method.

use super::motion::{MotionLaw, PointState};
use crate::physics::DVec2;

/// Newton's steps, at most. Without quadratic drag and slack the first one is exact.
const MOST: u32 = 20;
/// Relative: a change of the velocity below this is rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The change of an acceleration with a vector r that acts by s(|r|)·r: s along r's normal, and `along` more along r.
fn turned(change: DVec2, r: DVec2, across: f64, along: f64) -> DVec2 {
    let squared = r.length_squared();
    if squared == 0.0 { change * across } else { change * across + r * (along * r.dot(change) / squared) }
}

/// v′ = v + h·a(x + h·v′, v′), x′ = x + h·v′. First order; what swings fades, the faster the larger ω·h is.
pub fn implicit_euler(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    let end = |v: DVec2| PointState { x: x + v * h, v };
    let mut found = v;
    for _ in 0..MOST {
        let PointState { x: place, v: velocity } = end(found);
        let (u, miss) = (velocity - law.wind, found - v - law.acceleration(end(found)) * h);
        let (stretch, speed) = (place.length(), u.length());
        let free = if law.slack == 0.0 || stretch == 0.0 { 0.0 } else { law.spring * law.slack / stretch };
        let column = |change: DVec2| {
            let pull = turned(change, place, law.spring - free, free);
            let drag = turned(change, u, law.drag * speed + law.viscous, law.drag * speed);
            change + pull * (h * h) + drag * h
        };
        let (right, up) = (column(DVec2::X), column(DVec2::Y));
        let change = DVec2::new(miss.perp_dot(up), right.perp_dot(miss)) / right.perp_dot(up);
        found -= change;
        if change.length() <= ROUNDING * found.length() {
            break;
        }
    }
    end(found)
}

/// y′ = y + h·f((y + y′)/2): half an implicit step, and as far again. Second order; symplectic without drag.
pub fn implicit_midpoint(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    let middle = implicit_euler(law, point, 0.5 * h);
    PointState { x: middle.x * 2.0 - point.x, v: middle.v * 2.0 - point.v }
}

/// y′ = y + h·(f(y) + f(y′))/2: half a step of explicit Euler, then half an implicit one. Second order.
pub fn trapezoid(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    implicit_euler(law, law.along(point, point, 0.5 * h), 0.5 * h)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::methods::motion::{MotionStep, yoshida};
    use crate::lab::stability::growth;

    /// |1/(1 − z)| and |(1 + z/2)/(1 − z/2)|, at stiff and at swinging motions.
    #[test]
    fn the_growth_is_that_of_the_closed_form() {
        let size = |re: f64, im: f64| f64::hypot(re, im);
        for (re, im) in [(-1.0, 0.5), (-0.01, 3.0), (0.0, 1.0), (-400.0, 30.0), (0.7, 2.0), (-5.0, 0.0)] {
            let backward = 1.0 / size(1.0 - re, im);
            let trapezoidal = size(1.0 + 0.5 * re, 0.5 * im) / size(1.0 - 0.5 * re, 0.5 * im);
            for (step, exact) in
                [(implicit_euler as MotionStep, backward), (implicit_midpoint, trapezoidal), (trapezoid, trapezoidal)]
            {
                let found = growth(step, (re, im));
                assert!((found / exact - 1.0).abs() < 2e-7, "{re} {im}: {found}, {exact}");
            }
        }
    }

    /// With (w₁, w₀, w₁) for the parts, half the trace of a swing's matrix is 1 − z²/2 + z⁴/24 − w₁³·w₀·(w₀ + w₁)²·z⁶/8: a swing lasts while that is
    /// within ±1, up to ω·h = 1.573.
    #[test]
    fn the_fourth_order_is_stable_up_to_where_its_trace_says() {
        let outer = 1.0 / (2.0 - libm::cbrt(2.0));
        let inner = 1.0 - 2.0 * outer;
        let last = -outer.powi(3) * inner * (outer + inner).powi(2) / 8.0;
        let square = ((1.0 / 24.0f64).powi(2) + 2.0 * last).sqrt() / (2.0 * last) - 1.0 / (48.0 * last);
        let limit = square.sqrt();
        assert!((limit - 1.5734).abs() < 1e-4, "{limit}");
        assert!(growth(yoshida, (0.0, 0.9999 * limit)) < 1.0 + 1e-9 && growth(yoshida, (0.0, 1.0001 * limit)) > 1.0001);
    }

    /// Quadratic drag and a taut spring are solved to rounding: the end fulfils its own rule.
    #[test]
    fn what_newton_finds_is_an_end() {
        let law = MotionLaw {
            constant: DVec2::new(0.0, 9.81),
            drag: 0.3,
            viscous: 0.1,
            wind: DVec2::new(4.0, 0.0),
            spring: 50.0,
            slack: 1.0,
        };
        let start = PointState { x: DVec2::new(1.0, 1.5), v: DVec2::new(20.0, -7.0) };
        for h in [0.5, 0.1, 1e-3] {
            let end = implicit_euler(&law, start, h);
            let again = law.along(start, end, h);
            assert!((again.v - end.v).length() < 1e-12 && (again.x - end.x).length() < 1e-12, "{h}: {end:?} {again:?}");
        }
    }
}
