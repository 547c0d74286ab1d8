//! The motion of one body through media, without contacts: as exact as it can be had at each cost.
//!
//! Nothing that depends on velocity or place: the parabola, exact at any step. Drag: classical Runge–Kutta of fourth order (RK4), in as
//! many steps as keep rate × time below [`RK4_REACH`]; one for ordinary things at a hundred ticks a second (error 1e-9 m after
//! seconds), many for feathers and gusts, where a fixed step diverges. A feather that has reached its terminal velocity
//! `√(A/k)` along A stays on it, which bounds the work for things of any lightness. In a liquid, motion that settles many times within
//! a tick (a grain in treacle) takes exponential steps, `v → v∞ + (v − v∞)·e^(−mt)` with the damping m frozen, stable at any rate.

use super::Body;
use super::media::{Law, Media};
use super::tuning::{EXPONENTIAL_STEPS, RK4_REACH, RK4_STEPS, STIFF_REACH, TERMINAL_TOLERANCE};
use glam::DVec2;

/// Place and velocity.
pub(super) type Pose = (DVec2, DVec2);

/// Uniformly accelerated motion for `t` seconds.
pub(super) fn parabola((x, v): Pose, a: DVec2, t: f64) -> Pose {
    (x + (v + a * (0.5 * t)) * t, v + a * t)
}

/// One step of the classical Runge–Kutta method.
pub(super) fn rk4((x, v): Pose, h: f64, acceleration: impl Fn(DVec2, DVec2) -> DVec2) -> Pose {
    let half = 0.5 * h;
    let a1 = acceleration(x, v);
    let v2 = v + a1 * half;
    let a2 = acceleration(x + v * half, v2);
    let v3 = v + a2 * half;
    let a3 = acceleration(x + v2 * half, v3);
    let v4 = v + a3 * h;
    let a4 = acceleration(x + v3 * h, v4);
    let sixth = h / 6.0;
    (x + (v + 2.0 * (v2 + v3) + v4) * sixth, v + (a1 + 2.0 * (a2 + a3) + a4) * sixth)
}

/// Where `body` is after `t` seconds under `law`.
pub(super) fn flow(media: &Media, body: &Body, law: &Law, t: f64) -> Pose {
    let mut pose = (body.position, body.velocity);
    if law.air == 0.0 && !law.wet {
        return parabola(pose, law.constant, t);
    }
    if !law.wet {
        return through_air(pose, law.constant, law.air, t);
    }
    let mut left = t;
    for _ in 0..RK4_STEPS {
        let rate = media.rate(body, law, pose.1);
        // A splash is fast for as long as its speed is high, and takes a few more steps; what stays fast at any speed is stiff.
        if media.rate(body, law, DVec2::ZERO) * left > STIFF_REACH {
            break;
        }
        if rate * left <= RK4_REACH {
            return rk4(pose, left, |x, v| media.acceleration(body, law, x, v));
        }
        let h = RK4_REACH / rate;
        pose = rk4(pose, h, |x, v| media.acceleration(body, law, x, v));
        left -= h;
    }
    let h = left / EXPONENTIAL_STEPS;
    for _ in 0..EXPONENTIAL_STEPS as u32 {
        let (a, damping) = (media.acceleration(body, law, pose.0, pose.1), media.rate(body, law, pose.1));
        pose = exponential(pose, a, damping, h);
    }
    pose
}

/// Flight with quadratic drag `air` (1/m) under a constant acceleration for `t` seconds.
fn through_air(mut pose: Pose, constant: DVec2, air: f64, t: f64) -> Pose {
    let acceleration = |_, v: DVec2| constant - v * (air * v.length());
    let pull = constant.length();
    let settling = (air * pull).sqrt();
    let mut left = t;
    for _ in 0..RK4_STEPS {
        let rate = air * pose.1.length() + settling;
        if rate * left <= RK4_REACH {
            return rk4(pose, left, acceleration);
        }
        if pull > 0.0 {
            let terminal = constant * (1.0 / settling);
            if (pose.1 - terminal).length() <= TERMINAL_TOLERANCE * terminal.length() {
                return (pose.0 + terminal * left, terminal);
            }
        }
        let h = RK4_REACH / rate;
        pose = rk4(pose, h, acceleration);
        left -= h;
    }
    let h = left / EXPONENTIAL_STEPS;
    for _ in 0..EXPONENTIAL_STEPS as u32 {
        pose = exponential(pose, acceleration(pose.0, pose.1), air * pose.1.length() + settling, h);
    }
    pose
}

/// One step of `t` seconds with the acceleration `a` at its start and the damping (1/s) frozen.
fn exponential((x, v): Pose, a: DVec2, damping: f64, t: f64) -> Pose {
    // x and v of v′ = a − m·(v − v₀): with s = (1 − e^(−mt))/m.
    let s = -libm::expm1(-damping * t) / damping;
    (x + v * t + a * ((t - s) / damping), v + a * s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, WorldDef};

    fn body(mass: f64, drag: f64, velocity: DVec2) -> (Media, Body, Law) {
        let def = WorldDef::default();
        let media = Media { gravity: 9.81, air_density: 1.0, streams: def.streams, fluids: def.fluids };
        let body = Body::new(&BodyDef { mass, drag, velocity, ..BodyDef::default() });
        let law = Law { constant: DVec2::new(0.0, 9.81), air: 0.5 * drag / mass, area: 1.0, ..Law::default() };
        (media, body, law)
    }

    /// physics.md: x = (v_t²/g)·ln(cosh τ) from rest.
    #[test]
    fn a_fall_with_drag_follows_the_exact_flow() {
        for mass in [5.0, 0.1, 1e-3, 1e-7] {
            let (media, mut body, law) = body(mass, 1.0, DVec2::ZERO);
            for _ in 0..720 {
                (body.position, body.velocity) = flow(&media, &body, &law, 1.0 / 120.0);
            }
            let terminal = (9.81 / law.air).sqrt();
            let tau = 9.81 * 6.0 / terminal;
            let exact = terminal * terminal / 9.81 * (tau + (-2.0 * tau).exp().ln_1p() - 2f64.ln());
            assert!((body.position.y - exact).abs() < 1e-8, "{mass} kg: {} m, exact {exact} m", body.position.y);
        }
    }

    #[test]
    fn a_gust_neither_reverses_nor_overshoots() {
        let (media, body, law) = body(1e-4, 1.0, DVec2::new(40.0, 0.0));
        let (x, v) = flow(&media, &body, &Law { constant: DVec2::ZERO, ..law }, 1.0 / 60.0);
        let k = law.air;
        assert!((x.x - (k * 40.0 / 60.0).ln_1p() / k).abs() < 1e-9);
        assert!(v.x > 0.0 && (v.x - 40.0 / (1.0 + k * 40.0 / 60.0)).abs() < 1e-6);
    }
}
