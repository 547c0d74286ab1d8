//! Sliding to a stop on a floor: one step of a velocity v (m/s) and a place x (m) under Coulomb friction of deceleration a = μ·g
//! (m/s²), by the usual methods. Exact: the stop is at v₀²/2a after v₀/a.

/// Place, m, and velocity, m/s.
pub type Slider = (f64, f64);

/// One step: slider, deceleration (m/s²), step (s).
pub type SlideStep = fn(Slider, f64, f64) -> Slider;

/// Friction against the sign of v, semi-implicit Euler: chatters for ever within ±a·h.
pub fn by_sign((x, v): Slider, a: f64, h: f64) -> Slider {
    let sign = if v > 0.0 {
        1.0
    } else if v < 0.0 {
        -1.0
    } else {
        0.0
    };
    let v = v - sign * a * h;
    (x + v * h, v)
}

/// Friction that takes at most all of v in a step: stops dead, but short by about v₀·h/2.
pub fn clamped((x, v): Slider, a: f64, h: f64) -> Slider {
    let v = v - v.clamp(-a * h, a * h);
    (x + v * h, v)
}

/// The parabola up to the stop within the step.
pub fn exact((x, v): Slider, a: f64, h: f64) -> Slider {
    if v.abs() <= a * h {
        return (x + v * v.abs() / (2.0 * a), 0.0);
    }
    let brake = -a.copysign(v);
    (x + (v + 0.5 * brake * h) * h, v + brake * h)
}
