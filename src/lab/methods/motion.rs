//! Smooth motion: one step of length h of a point under v′ = A − (k·|u| + c)·u, u = v − w, by each of the usual integrators.
//!
//! Nothing here looks at errors: a step is taken as the textbook has it, also where it fails. Sources: E. Hairer, C. Lubich,
//! G. Wanner, *Geometric Numerical Integration*, I.1 (Euler's methods, Verlet), II.5 (splitting); E. Hairer, S. Nørsett, G. Wanner,
//! *Solving Ordinary Differential Equations I*, II.1 (RK4).

use crate::physics::DVec2;

/// What acts on the point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Law {
    /// Acceleration by constant forces A, m/s².
    pub constant: DVec2,
    /// Drag k = ρ·C_d·A/2m, 1/m.
    pub drag: f64,
    /// Drag in proportion to the velocity, c, 1/s.
    pub viscous: f64,
    /// Velocity of the air w, m/s.
    pub wind: DVec2,
}

/// Place (m) and velocity (m/s).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// m.
    pub x: DVec2,
    /// m/s.
    pub v: DVec2,
}

/// One step of so many seconds.
pub type Step = fn(&Law, Point, f64) -> Point;

/// Every method that steps a motion through drag, by the name that charts and tables show.
pub const METHODS: [(&str, Step); 7] = [
    ("explicit Euler", explicit_euler),
    ("semi-implicit Euler", semi_implicit_euler),
    ("velocity Verlet", velocity_verlet),
    ("RK4", rk4),
    ("linearised drag", linearised_drag),
    ("exact drag (Lie)", exact_decay),
    ("Strang", strang),
];

impl Law {
    /// Acceleration at velocity `v`, m/s².
    pub fn acceleration(&self, v: DVec2) -> DVec2 {
        let u = v - self.wind;
        self.constant - u * (self.drag * u.length() + self.viscous)
    }
}

/// Takes steps of `h` seconds until `seconds` are over.
pub fn follow(step: Step, law: &Law, start: Point, seconds: f64, h: f64) -> Point {
    let steps = (seconds / h).round() as u64;
    (0..steps).fold(start, |point, _| step(law, point, h))
}

/// x and v both from the start of the step. First order; gains energy.
pub fn explicit_euler(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    Point { x: x + v * h, v: v + law.acceleration(v) * h }
}

/// v first, then x with the new v. First order; what most game engines do.
pub fn semi_implicit_euler(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    let v = v + law.acceleration(v) * h;
    Point { x: x + v * h, v }
}

/// Second order; the acceleration at the end is taken at the velocity that Euler predicts, since drag depends on it.
pub fn velocity_verlet(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    let a = law.acceleration(v);
    let end = law.acceleration(v + a * h);
    Point { x: x + v * h + a * (0.5 * h * h), v: v + (a + end) * (0.5 * h) }
}

/// The classical Runge–Kutta method. Fourth order.
pub fn rk4(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    let a1 = law.acceleration(v);
    let v2 = v + a1 * (0.5 * h);
    let a2 = law.acceleration(v2);
    let v3 = v + a2 * (0.5 * h);
    let a3 = law.acceleration(v3);
    let v4 = v + a3 * h;
    let a4 = law.acceleration(v4);
    Point { x: x + (v + (v2 + v3) * 2.0 + v4) * (h / 6.0), v: v + (a1 + (a2 + a3) * 2.0 + a4) * (h / 6.0) }
}

/// Drag linearised to −m·u with m = k·|u| + c of the step's start, taken implicitly. First order; never diverges.
pub fn linearised_drag(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    let m = law.drag * (v - law.wind).length() + law.viscous;
    let v = (v + (law.constant + law.wind * m) * h) / (1.0 + m * h);
    Point { x: x + v * h, v }
}

/// The exact decay of drag alone, in the air's frame: u·(1 − c·q)/(1 + k·|u|·q) with q = (1 − e^(−c·h))/c, which is h where c = 0.
pub fn decay(law: &Law, v: DVec2, h: f64) -> DVec2 {
    let u = v - law.wind;
    let q = if law.viscous > 0.0 { -libm::expm1(-law.viscous * h) / law.viscous } else { h };
    law.wind + u * ((1.0 - law.viscous * q) / (1.0 + law.drag * u.length() * q))
}

/// Constant forces for h, then the exact decay of drag for h (Lie splitting). First order; never diverges.
pub fn exact_decay(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    let v = decay(law, v + law.constant * h, h);
    Point { x: x + v * h, v }
}

/// Half of the constant forces, the exact decay, the other half; position by the mean velocity (Strang splitting). Second order;
/// never diverges.
pub fn strang(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    let kick = law.constant * (0.5 * h);
    let end = decay(law, v + kick, h) + kick;
    Point { x: x + (v + end) * (0.5 * h), v: end }
}

/// The exact flow of a fall (A = (0, g) with g > 0, no wind, v = (0, v) with v ≥ 0):
/// v = v_t·tanh(τ + artanh(v₀/v_t)), x = (v_t²/g)·ln(cosh τ + (v₀/v_t)·sinh τ), τ = g·t/v_t, in forms without overflow.
pub fn exact_fall(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    let g = law.constant.y;
    let terminal = (g / law.drag).sqrt();
    let (tau, r) = (g * h / terminal, v.y / terminal);
    let t = libm::tanh(tau);
    let way = tau + libm::log(0.5 * (1.0 + r) + 0.5 * (1.0 - r) * libm::exp(-2.0 * tau));
    Point { x: x + DVec2::new(0.0, terminal * terminal / g * way), v: DVec2::new(0.0, terminal * (r + t) / (1.0 + r * t)) }
}

/// Semi-implicit Euler in `f32`: what single precision does to it.
pub fn semi_implicit_euler_f32(law: &Law, Point { x, v }: Point, h: f64) -> Point {
    let h = h as f32;
    let v = v.as_vec2() + law.acceleration(v).as_vec2() * h;
    let x = x.as_vec2() + v * h;
    Point { x: x.as_dvec2(), v: v.as_dvec2() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Halving the step divides the error by 2^order.
    #[test]
    fn each_method_has_its_order() {
        let law = Law { constant: DVec2::new(0.0, 9.81), drag: 0.05, ..Law::default() };
        let start = Point { x: DVec2::ZERO, v: DVec2::new(0.0, 3.0) };
        let exact = exact_fall(&law, start, 2.0).x.y;
        let methods: [(Step, f64); 7] = [
            (explicit_euler, 1.0),
            (semi_implicit_euler, 1.0),
            (linearised_drag, 1.0),
            (exact_decay, 1.0),
            (velocity_verlet, 2.0),
            (strang, 2.0),
            (rk4, 4.0),
        ];
        for (i, (step, order)) in methods.into_iter().enumerate() {
            let error = |h: f64| (follow(step, &law, start, 2.0, h).x.y - exact).abs();
            let measured = (error(1.0 / 64.0) / error(1.0 / 128.0)).log2();
            assert!((measured - order).abs() < 0.15, "method {i}: order {measured}, expected {order}");
        }
    }

    #[test]
    fn the_exact_fall_can_be_cut_anywhere() {
        let law = Law { constant: DVec2::new(0.0, 9.81), drag: 0.05, ..Law::default() };
        let whole = exact_fall(&law, Point::default(), 6.0);
        let cut = follow(exact_fall, &law, Point::default(), 6.0, 0.1);
        assert!((whole.x - cut.x).length() < 1e-12 && (whole.v - cut.v).length() < 1e-13);
    }
}
