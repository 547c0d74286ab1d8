//! Smooth motion: one step of length h of a point under v′ = A − s·x − (k·|u| + c)·u, u = v − w, by each usual integrator, also where it fails.
//! Sources: E. Hairer, C. Lubich, G. Wanner, *Geometric Numerical Integration*, I.1 (Euler's methods, Verlet), II.5 (splitting); E. Hairer,
//! S. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.1 (midpoint, Heun, RK4), II.4 (control of the step); *II*, IV.3 (A-stable:
//! implicit Euler, midpoint, trapezoid); P. Bogacki, L. F. Shampine, "A 3(2) pair of Runge–Kutta formulas", Applied Mathematics Letters 2 (1989)
//! 321–325; H. Yoshida, "Construction of higher order symplectic integrators", Physics Letters A 150 (1990) 262–268. Exact flows of drag are in any
//! text on mechanics; g = A, v_t = √(g/k), τ = g·t/v_t. Implicit Euler takes y′ = λ·y by 1/(1 − z), the other two by (1 + z/2)/(1 − z/2), z = h·λ.

use crate::physics::DVec2;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionLaw {
    /// Acceleration by constant forces A, m/s².
    pub constant: DVec2,
    /// Drag k = ρ·C_d·A/2m, 1/m.
    pub drag: f64,
    /// Drag in proportion to the velocity, c, 1/s.
    pub viscous: f64,
    /// Velocity of the air w, m/s.
    pub wind: DVec2,
    /// A force back to the origin in proportion to the distance, s, 1/s²: a floating body or a body on a spring swings with ω = √s.
    pub spring: f64,
    /// The distance from the origin at which that force is 0, m.
    pub slack: f64,
}

/// Place (m) and velocity (m/s).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointState {
    pub x: DVec2,
    pub v: DVec2,
}

/// One step: law, point, step (s).
pub type MotionStep = fn(&MotionLaw, PointState, f64) -> PointState;

/// The name of the method that chooses its steps itself.
pub const ADAPTIVE: &str = "adaptive 3(2)";

impl MotionLaw {
    /// Acceleration at place `x` (m) and velocity `v` (m/s), m/s².
    pub fn acceleration(&self, PointState { x, v }: PointState) -> DVec2 {
        let u = v - self.wind;
        self.pull(x) - u * (self.drag * u.length() + self.viscous)
    }

    /// The part that does not depend on the velocity, m/s².
    fn pull(&self, x: DVec2) -> DVec2 {
        if self.slack == 0.0 {
            return self.constant - x * self.spring;
        }
        self.constant - x * (self.spring * (1.0 - self.slack / x.length()))
    }

    /// The point that leaves `from` and keeps the rates at `at` for `h` seconds.
    pub(super) fn along(&self, from: PointState, at: PointState, h: f64) -> PointState {
        PointState { x: from.x + at.v * h, v: from.v + self.acceleration(at) * h }
    }
}

pub fn follow(step: MotionStep, law: &MotionLaw, start: PointState, seconds: f64, h: f64) -> PointState {
    let steps = (seconds / h).round() as u64;
    (0..steps).fold(start, |point, _| step(law, point, h))
}

/// x and v both from the start of the step. First order; gains energy.
pub fn explicit_euler(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    law.along(point, point, h)
}

/// v first, then x with the new v. First order; symplectic without drag. Most game engines use it.
pub fn semi_implicit_euler(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    let v = point.v + law.acceleration(point) * h;
    PointState { x: point.x + v * h, v }
}

/// Second order; symplectic without drag. The acceleration at the end is taken at the velocity that Euler predicts, since drag depends on it.
pub fn velocity_verlet(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    let PointState { x, v } = point;
    let a = law.acceleration(point);
    let x = x + v * h + a * (0.5 * h * h);
    let end = law.acceleration(PointState { x, v: v + a * h });
    PointState { x, v: v + (a + end) * (0.5 * h) }
}

/// Euler to the middle of the step, whose rates hold for the whole of it. Second order.
pub fn midpoint(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    law.along(point, law.along(point, point, 0.5 * h), h)
}

/// The mean of Euler's step and of one with the rates at its end. Second order.
pub fn heun(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    let first = law.along(point, point, h);
    let second = law.along(point, first, h);
    PointState { x: (first.x + second.x) * 0.5, v: (first.v + second.v) * 0.5 }
}

/// The classical Runge–Kutta method. Fourth order.
pub fn rk4(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    let PointState { x, v } = point;
    let p2 = law.along(point, point, 0.5 * h);
    let p3 = law.along(point, p2, 0.5 * h);
    let p4 = law.along(point, p3, h);
    let [a1, a2, a3, a4] = [point, p2, p3, p4].map(|stage| law.acceleration(stage));
    PointState { x: x + (v + (p2.v + p3.v) * 2.0 + p4.v) * (h / 6.0), v: v + (a1 + (a2 + a3) * 2.0 + a4) * (h / 6.0) }
}

/// m/s. The error that [`adaptive`] allows itself in a second: after ten seconds, the tolerance of a scene.
const ALLOWED: f64 = crate::lab::TOLERANCE / 10.0;
/// s. The shortest part of a step that [`adaptive`] takes, whatever its error is.
const SHORTEST: f64 = 1e-6;

/// Bogacki and Shampine's pair of orders 3 and 2: cuts a step into as many parts as keep the difference of the two within the allowed error a second.
pub fn adaptive(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    adaptive_to(ALLOWED, law, point, h)
}

/// The tolerance, m/s, that stands for a step of a ladder: h³.
pub fn tolerance(h: f64) -> f64 {
    h * h * h
}

/// The same with another allowed error a second, m/s; a step may be a whole scene.
pub fn adaptive_to(allowed: f64, law: &MotionLaw, point: PointState, h: f64) -> PointState {
    let (mut point, mut left, mut part) = (point, h, h);
    while left > 0.0 {
        part = part.min(left);
        let (end, error) = bogacki_shampine(law, point, part);
        let allowed = allowed * part;
        // The difference grows with the part's third power, the allowed error with the first; 0.9 as in the textbook. Not finite: the largest cut.
        let fits = if error.is_finite() { 0.9 * (allowed / error.max(f64::MIN_POSITIVE)).sqrt() } else { 0.0 };
        if error <= allowed || part <= SHORTEST {
            (point, left) = (end, if part == left { 0.0 } else { left - part });
        }
        part = (part * fits.clamp(0.2, 5.0)).max(SHORTEST);
    }
    point
}

/// The third order of that pair alone, in a single part: [`adaptive`] repeats it.
pub fn third_order(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    bogacki_shampine(law, point, h).0
}

/// One step of the pair: the end by the third order, and how far the second order is from it, m with a velocity of 1 m/s counted as 1 m.
fn bogacki_shampine(law: &MotionLaw, point: PointState, h: f64) -> (PointState, f64) {
    let p2 = law.along(point, point, 0.5 * h);
    let p3 = law.along(point, p2, 0.75 * h);
    let rates = [point, p2, p3].map(|stage| (stage.v, law.acceleration(stage)));
    let mixed = |weights: &[(f64, (DVec2, DVec2))]| {
        weights
            .iter()
            .fold(PointState::default(), |sum, (weight, (v, a))| PointState { x: sum.x + *v * *weight, v: sum.v + *a * *weight })
    };
    let way = mixed(&[(2.0 / 9.0, rates[0]), (1.0 / 3.0, rates[1]), (4.0 / 9.0, rates[2])]);
    let end = PointState { x: point.x + way.x * h, v: point.v + way.v * h };
    let last = (end.v, law.acceleration(end));
    let apart = mixed(&[(-5.0 / 72.0, rates[0]), (1.0 / 12.0, rates[1]), (1.0 / 9.0, rates[2]), (-1.0 / 8.0, last)]);
    (end, h * (apart.x.length_squared() + apart.v.length_squared()).sqrt())
}

/// Drag linearised to −m·u with m = k·|u| + c of the step's start, taken implicitly. First order; never diverges.
pub fn linearised_drag(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    let m = law.drag * (v - law.wind).length() + law.viscous;
    let v = (v + (law.pull(x) + law.wind * m) * h) / (1.0 + m * h);
    PointState { x: x + v * h, v }
}

/// The exact decay of drag alone, in the air's frame: u·(1 − c·q)/(1 + k·|u|·q) with q = (1 − e^(−c·h))/c, which is h where c = 0.
pub fn decay(law: &MotionLaw, v: DVec2, h: f64) -> DVec2 {
    let u = v - law.wind;
    let q = if law.viscous != 0.0 { -libm::expm1(-law.viscous * h) / law.viscous } else { h };
    law.wind + u * ((1.0 - law.viscous * q) / (1.0 + law.drag * u.length() * q))
}

/// Constant forces for h, then the exact decay of drag for h (Lie splitting). First order; never diverges.
pub fn exact_decay(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    let v = decay(law, v + law.pull(x) * h, h);
    PointState { x: x + v * h, v }
}

/// Half of the forces without drag, its exact decay, the other half; position by the mean velocity. Second order; never diverges by drag.
pub fn strang(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    let before = v + law.pull(x) * (0.5 * h);
    let after = decay(law, before, h);
    let x = x + (before + after) * (0.5 * h);
    PointState { x, v: after + law.pull(x) * (0.5 * h) }
}

/// The outer two of [`yoshida`]'s three parts, 1/(2 − 2^⅓); the middle one is 1 less two of these, below 0.
const OUTER: f64 = 1.351_207_191_959_657_8;

/// Three of [`strang`], the middle one backwards, where drag speeds up: no answer from k·|u|·h = 1/1.7 on. Fourth order; symplectic without drag.
pub fn yoshida(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    [OUTER, 1.0 - 2.0 * OUTER, OUTER].into_iter().fold(point, |point, part| strang(law, point, part * h))
}

/// The exact flow of a fall (A = (0, g) with g > 0, no wind, v = (0, v) with v ≥ 0):
/// v = v_t·tanh(τ + artanh(v₀/v_t)), x = (v_t²/g)·ln(cosh τ + (v₀/v_t)·sinh τ), τ = g·t/v_t, in forms without overflow.
pub fn exact_fall(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    let g = law.constant.y;
    let terminal = (g / law.drag).sqrt();
    let (tau, r) = (g * h / terminal, v.y / terminal);
    let t = libm::tanh(tau);
    let way = tau + libm::log(0.5 * (1.0 + r) + 0.5 * (1.0 - r) * libm::exp(-2.0 * tau));
    PointState { x: x + DVec2::new(0.0, terminal * terminal / g * way), v: DVec2::new(0.0, terminal * (r + t) / (1.0 + r * t)) }
}

/// Semi-implicit Euler in `f32`, to show the effect of single precision.
pub fn semi_implicit_euler_f32(law: &MotionLaw, point: PointState, h: f64) -> PointState {
    let h = h as f32;
    let v = point.v.as_vec2() + law.acceleration(point).as_vec2() * h;
    let x = point.x.as_vec2() + v * h;
    PointState { x: x.as_dvec2(), v: v.as_dvec2() }
}

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

/// Drag in proportion to the velocity (k = 0): v = v∞ + (v₀ − v∞)·e^(−c·t), v∞ = w + A/c.
pub fn in_liquid(law: &MotionLaw, PointState { x, v }: PointState, h: f64) -> PointState {
    let end = law.wind + law.constant / law.viscous;
    let passed = -libm::expm1(-law.viscous * h);
    PointState { x: x + end * h + (v - end) * (passed / law.viscous), v: v + (end - v) * passed }
}

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
    use crate::lab::methods::motion::{MotionStep, implicit_euler, implicit_midpoint, trapezoid, yoshida};
    use crate::lab::stability::growth;

    const ORDERS: [(MotionStep, f64); 13] = [
        (explicit_euler, 1.0),
        (semi_implicit_euler, 1.0),
        (linearised_drag, 1.0),
        (exact_decay, 1.0),
        (velocity_verlet, 2.0),
        (midpoint, 2.0),
        (heun, 2.0),
        (strang, 2.0),
        (rk4, 4.0),
        (implicit_euler, 1.0),
        (implicit_midpoint, 2.0),
        (trapezoid, 2.0),
        (yoshida, 4.0),
    ];

    /// Halving the step divides the error by 2^order.
    #[test]
    fn each_method_has_its_order() {
        let law = MotionLaw { constant: DVec2::new(0.0, 9.81), drag: 0.05, ..MotionLaw::default() };
        let start = PointState { x: DVec2::ZERO, v: DVec2::new(0.0, 3.0) };
        let exact = exact_fall(&law, start, 2.0).x.y;
        for (i, (step, order)) in ORDERS.into_iter().enumerate() {
            let error = |h: f64| (follow(step, &law, start, 2.0, h).x.y - exact).abs();
            let measured = (error(1.0 / 64.0) / error(1.0 / 128.0)).log2();
            assert!((measured - order).abs() < 0.15, "method {i}: order {measured}, expected {order}");
        }
    }

    /// Where nothing but a spring pulls, too: the places at which it is taken count as much as the velocities.
    #[test]
    fn each_method_has_its_order_on_a_spring() {
        let law = MotionLaw { spring: 9.0, ..MotionLaw::default() };
        let start = PointState { x: DVec2::new(0.0, 1.0), v: DVec2::ZERO };
        let exact = libm::cos(3.0 * 2.0);
        for (step, order) in ORDERS {
            let error = |h: f64| (follow(step, &law, start, 2.0, h).x.y - exact).abs();
            let measured = (error(1.0 / 128.0) / error(1.0 / 256.0)).log2();
            assert!((measured - order).abs() < 0.2, "order {measured}, expected {order}");
        }
    }

    #[test]
    fn the_pair_has_orders_three_and_two_and_keeps_what_it_allows_itself() {
        let law = MotionLaw { constant: DVec2::new(0.0, 9.81), drag: 0.05, ..MotionLaw::default() };
        let start = PointState { x: DVec2::ZERO, v: DVec2::new(0.0, 3.0) };
        let exact = |h: f64| exact_fall(&law, start, h).x.y;
        // A single step: one power more than the order.
        let (error, apart) =
            (|h: f64| (bogacki_shampine(&law, start, h).0.x.y - exact(h)).abs(), |h: f64| bogacki_shampine(&law, start, h).1);
        assert!(((error(0.1) / error(0.05)).log2() - 4.0).abs() < 0.3, "{}", (error(0.1) / error(0.05)).log2());
        assert!(((apart(0.1) / apart(0.05)).log2() - 3.0).abs() < 0.3, "{}", (apart(0.1) / apart(0.05)).log2());
        for h in [2.0, 0.5, 1.0 / 60.0] {
            let found = follow(adaptive, &law, start, 10.0, h).x.y;
            assert!((found - exact(10.0)).abs() < crate::lab::TOLERANCE, "{h} s");
        }
    }

    #[test]
    fn the_adaptive_method_ends_where_all_is_lost() {
        let law = MotionLaw { drag: f64::MAX, ..MotionLaw::default() };
        assert!(!adaptive(&law, PointState { x: DVec2::ZERO, v: DVec2::new(1e300, 0.0) }, 1e-5).v.x.is_finite());
    }

    #[test]
    fn the_exact_fall_can_be_cut_anywhere() {
        let law = MotionLaw { constant: DVec2::new(0.0, 9.81), drag: 0.05, ..MotionLaw::default() };
        let whole = exact_fall(&law, PointState::default(), 6.0);
        let cut = follow(exact_fall, &law, PointState::default(), 6.0, 0.1);
        assert!((whole.x - cut.x).length() < 1e-12 && (whole.v - cut.v).length() < 1e-13);
    }

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
