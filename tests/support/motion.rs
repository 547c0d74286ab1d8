//! Motion by a method of fourth order, beside which the engine is held.

use resultant::physics::DVec2;

/// Place and velocity after `steps` steps of `h` seconds by the method of Runge and Kutta, of a body with that acceleration.
pub fn rk4((mut x, mut v): (DVec2, DVec2), steps: u32, h: f64, a: impl Fn(DVec2, DVec2) -> DVec2) -> (DVec2, DVec2) {
    for _ in 0..steps {
        let a1 = a(x, v);
        let (x2, v2) = (x + v * (h / 2.0), v + a1 * (h / 2.0));
        let a2 = a(x2, v2);
        let (x3, v3) = (x + v2 * (h / 2.0), v + a2 * (h / 2.0));
        let a3 = a(x3, v3);
        let (x4, v4) = (x + v3 * h, v + a3 * h);
        let a4 = a(x4, v4);
        (x, v) = (x + (v + 2.0 * (v2 + v3) + v4) * (h / 6.0), v + (a1 + 2.0 * (a2 + a3) + a4) * (h / 6.0));
    }
    (x, v)
}

/// The water of a test: its density and viscosity, and the depth of its bottom below its surface at y = 0, m.
#[derive(Clone, Copy)]
pub struct Bath {
    pub density: f64,
    pub viscosity: f64,
    pub depth: f64,
}

/// Damping ratio of a body that floats at its waterline, per unit of C_d.
pub const WAVES: f64 = 0.15;

/// Weight, drag, lift and waves of a box, N, by a second implementation.
pub fn force_on(body: &resultant::physics::BodyDef, (x, v): (DVec2, DVec2), gravity: f64, air: f64, bath: Bath) -> DVec2 {
    let [w, h] = (2.0 * body.half).to_array();
    let (top, bottom) = (x.y - body.half.y, x.y + body.half.y);
    let inside = (bottom.min(bath.depth) - top.max(0.0)).clamp(0.0, h);
    let f = inside / h;
    let density = f * bath.density + (1.0 - f) * air;
    let stokes = 3.0 * std::f64::consts::PI * bath.viscosity * f * (w + h) / 2.0;
    let drag = 0.5 * density * body.drag * (w * v.y.abs() + h * v.x.abs()) + stokes;
    let (k, r) = (bath.density * gravity * w, bath.density * w * inside / body.mass);
    let emerged = (-top / h).clamp(0.0, 1.0);
    let waves = if f > 0.0 { 2.0 * r / (1.0 + r) * (1.0 - (1.0 - emerged).powi(8)) } else { 0.0 };
    let waves = 2.0 * WAVES * body.drag * (k * body.mass).sqrt() * waves;
    DVec2::new(0.0, body.mass * gravity - k * inside - waves * v.y) - v * drag
}
