//! A point over a floor at 0: one step of length h of its height y (m) and velocity v upwards (m/s), with the usual answers of games to the floor.
//! Sliding to a stop under Coulomb friction of a = μ·g (m/s²), by the usual methods. Exact: the stop is at v₀²/2a after v₀/a.

/// Height above the floor, m, and velocity upwards, m/s.
pub type Ball = (f64, f64);

/// One step: ball, field strength g (N/kg), restitution e, step h (s).
pub type Bounce = fn(Ball, f64, f64, f64) -> Ball;

/// m. A ball this near counts as touching in [`every_tick`]: the slop of the well-known engines.
const TOUCHING: f64 = 0.005;
/// Bounces in one step after which the rest of the series is summed (see [`exact`]).
const SUMMED_AFTER: u32 = 4;

/// Semi-implicit Euler; a ball below the floor is put on it and its velocity turned round.
pub fn snap((y, v): Ball, g: f64, e: f64, h: f64) -> Ball {
    let v = v - g * h;
    let y = y + v * h;
    if y < 0.0 { (0.0, -e * v) } else { (y, v) }
}

/// Semi-implicit Euler; a ball below the floor is mirrored at it.
pub fn reflect((y, v): Ball, g: f64, e: f64, h: f64) -> Ball {
    let v = v - g * h;
    let y = y + v * h;
    if y < 0.0 { (-e * y, -e * v) } else { (y, v) }
}

/// The exact parabola; the floor is looked at only at the end of the step.
pub fn verlet_snap((y, v): Ball, g: f64, e: f64, h: f64) -> Ball {
    let (y, v) = (y + v * h - 0.5 * g * h * h, v - g * h);
    if y < 0.0 { (0.0, -e * v) } else { (y, v) }
}

/// Restitution at every tick of contact, with the position held to the floor: at rest it keeps a velocity of e·g·h/(1+e).
pub fn every_tick((y, v): Ball, g: f64, e: f64, h: f64) -> Ball {
    let v = v - g * h;
    let v = if y <= TOUCHING && v < 0.0 { -e * v } else { v };
    let y = y + v * h;
    (if y < TOUCHING { 0.0 } else { y }, v)
}

/// The time until a ball at (y, v) is on the floor: the later root of y + v·t − g·t²/2, without cancellation.
pub fn time_to_floor((y, v): Ball, g: f64) -> f64 {
    let root = (v * v + 2.0 * g * y).sqrt();
    if v > 0.0 { (v + root) / g } else { 2.0 * y / (root - v).max(f64::MIN_POSITIVE) }
}

/// The path is swept: at the first impact the ball bounces where it is, and the rest of the step is lost.
pub fn swept((y, v): Ball, g: f64, e: f64, h: f64) -> Ball {
    let t = time_to_floor((y, v), g);
    if t > h { (y + (v - 0.5 * g * h) * h, v - g * h) } else { (0.0, e * (v - g * t).abs()) }
}

/// Exact times of impact; after some bounces in a step the rest is the geometric series: all from a take-off at w end after 2w/(g·(1−e)).
pub fn exact((mut y, mut v): Ball, g: f64, e: f64, h: f64) -> Ball {
    let mut left = h;
    let mut bounces = 0;
    loop {
        if y == 0.0 && v == 0.0 {
            return (0.0, 0.0);
        }
        let t = time_to_floor((y, v), g);
        if t > left {
            return (y + (v - 0.5 * g * left) * left, v - g * left);
        }
        left -= t;
        (y, v) = (0.0, e * (v - g * t).abs());
        bounces += 1;
        if bounces > SUMMED_AFTER && e < 1.0 && 2.0 * v / (g * (1.0 - e)) <= left {
            return (0.0, 0.0);
        }
    }
}

/// The times of all impacts without the series, s. With e < 1 they come nearer and nearer to its end.
pub fn impact_times(mut ball: Ball, g: f64, e: f64) -> impl Iterator<Item = f64> {
    let mut time = 0.0;
    std::iter::repeat_with(move || {
        let t = time_to_floor(ball, g);
        time += t;
        ball = (0.0, e * (ball.1 - g * t).abs());
        time
    })
}

/// Impacts within `seconds`, at most `cap`. With e < 1 it meets the cap.
pub fn event_loop(ball: Ball, g: f64, e: f64, seconds: f64, cap: u32) -> u32 {
    (0..cap).zip(impact_times(ball, g, e)).take_while(|(_, time)| *time <= seconds).count() as u32
}

/// E/m over the floor, J/kg.
pub fn energy((y, v): Ball, g: f64) -> f64 {
    g * y + 0.5 * v * v
}

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
pub fn exact_stop((x, v): Slider, a: f64, h: f64) -> Slider {
    if v.abs() <= a * h {
        return (x + v * v.abs() / (2.0 * a), 0.0);
    }
    let brake = -a.copysign(v);
    (x + (v + 0.5 * brake * h) * h, v + brake * h)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exact_bounce_is_the_same_at_any_step() {
        let whole = exact((1.0, 0.0), 10.0, 0.9, 3.0);
        let cut = (0..300).fold((1.0, 0.0), |ball, _| exact(ball, 10.0, 0.9, 0.01));
        assert!((whole.0 - cut.0).abs() < 1e-12 && (whole.1 - cut.1).abs() < 1e-12, "{whole:?} {cut:?}");
    }
}
