//! The motion of one body through media, without contacts: as exact as it can be had at each cost.
//!
//! Nothing that depends on velocity or place: the parabola, exact at any step. Drag: classical Runge–Kutta of fourth order (RK4), in as
//! many steps as keep rate × time below [`RK4_REACH`]; one for ordinary things at a hundred ticks a second (error 1e-9 m after
//! seconds), many for feathers and gusts, where a fixed step diverges. A feather that has reached its terminal velocity
//! `√(A/k)` along A stays on it, which bounds the work for things of any lightness. In a liquid, motion that settles many times within
//! a tick (a grain in treacle) takes exponential steps, `v → v∞ + (v − v∞)·e^(−mt)` with the damping m frozen, stable at any rate;
//! something so light that it would bob many times within a tick is damped down to its waterline instead.

use super::Body;
use super::media::{Law, Media};
use super::tuning::{EXPONENTIAL_STEPS, MIN_SPLIT, RK4_REACH, RK4_STEPS, STIFF_REACH, TERMINAL_TOLERANCE};
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
    let pose = (body.position, body.velocity);
    if !law.wet {
        return fly_through(pose, law.constant, law.air, t);
    }
    let acceleration = |x, v| media.acceleration(body, law, x, v);
    let rate = |v| media.rate(body, law, v);
    let at_rest = rate(DVec2::ZERO);
    // A splash is fast for as long as its speed is high, and takes a few more steps; what stays fast at any speed is stiff.
    let stiff =
        |pose, left| (at_rest * left > STIFF_REACH).then(|| decay(pose, left, acceleration, rate, |x| media.floats(body, x)));
    follow(pose, t, acceleration, rate, stiff)
}

/// Where something is after `t` seconds of v′ = `a` − `k`·|v|·v: flight through air.
pub(super) fn fly_through(pose: Pose, a: DVec2, k: f64, t: f64) -> Pose {
    if k == 0.0 {
        return parabola(pose, a, t);
    }
    let pull = a.length();
    let slowest = (k * pull).sqrt();
    let rate = |v: DVec2| k * v.length() + slowest;
    let settled = |(x, v): Pose, left| {
        let terminal = a * (1.0 / slowest);
        let reached = pull > 0.0 && (v - terminal).length() <= TERMINAL_TOLERANCE * terminal.length();
        reached.then(|| (x + terminal * left, terminal))
    };
    follow(pose, t, |_, v| a - v * (k * v.length()), rate, settled)
}

/// Runge–Kutta steps for `t` seconds, as many as `rate` asks for; `shortcut` is asked before each and can end the journey at once.
fn follow(
    mut pose: Pose,
    t: f64,
    acceleration: impl Fn(DVec2, DVec2) -> DVec2,
    rate: impl Fn(DVec2) -> f64,
    shortcut: impl Fn(Pose, f64) -> Option<Pose>,
) -> Pose {
    let mut left = t;
    for _ in 0..RK4_STEPS {
        let rate = rate(pose.1);
        if rate * left <= RK4_REACH {
            return rk4(pose, left, acceleration);
        }
        if let Some(end) = shortcut(pose, left) {
            return end;
        }
        let h = RK4_REACH / rate;
        pose = rk4(pose, h, &acceleration);
        left -= h;
    }
    decay(pose, left, acceleration, rate, |_| 0.0)
}

/// Exponential steps for `t` seconds: x and v of v′ = a − m·(v − v₀), with s = (1 − e^(−mt))/m. Up and down something that `floats` with
/// stiffness K (1/s²) is also drawn to its waterline, v′ = a − K·(y − y₀): taken at the step's end (backward Euler), which is stable at any
/// K and lets what is far lighter than its liquid come to rest there instead of bobbing for ever.
fn decay(
    mut pose: Pose,
    t: f64,
    acceleration: impl Fn(DVec2, DVec2) -> DVec2,
    rate: impl Fn(DVec2) -> f64,
    floats: impl Fn(DVec2) -> f64,
) -> Pose {
    let h = t / EXPONENTIAL_STEPS;
    for _ in 0..EXPONENTIAL_STEPS as u32 {
        let (x, v) = pose;
        let (a, damping) = (acceleration(x, v), rate(v));
        let s = -libm::expm1(-damping * h) / damping;
        pose = (x + v * h + a * ((h - s) / damping), v + a * s);
        let stiffness = floats(x);
        if stiffness > 0.0 {
            pose.1.y = v.y + (a.y - stiffness * h * v.y) / (1.0 + stiffness * h * s) * s;
            pose.0.y = x.y + pose.1.y * h;
        }
    }
    pose
}

/// Whether something that moved more across than up or down (or, not `across`, the other way round) does so no longer at velocity `v`.
pub(super) fn has_turned(across: bool, v: DVec2) -> bool {
    let v = v.abs();
    if across { v.x < v.y } else { v.y < v.x }
}

/// When something begins to move more across than up or down, or, `across` now, the other way round: the side that meets the air
/// changes, and with it the law.
pub(super) fn time_of_turn(across: bool, end: f64, mut velocity: impl FnMut(f64) -> DVec2) -> Option<f64> {
    let mut turned = |t| has_turned(across, velocity(t));
    let (mut from, mut to) = (MIN_SPLIT, end);
    if to <= from || !turned(to) || turned(from) {
        return None;
    }
    while to - from > MIN_SPLIT {
        let middle = 0.5 * (from + to);
        if turned(middle) { to = middle } else { from = middle }
    }
    Some(to)
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
