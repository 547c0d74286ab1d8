//! Flight through air: u′ = A − s(u)·u with the drag per mass s ([`crate::physics::forces::air`]) and the constant acceleration A.
//! With q = exp(∫s dt) and Q = ∫q dt, u = (u₀ + A·Q)/q exactly, and Q″ = s(u₀ + A·Q) from Q = 0, Q′ = 1.
//!
//! - **Boxes.** While no component of u changes its sign, s is linear along the way: Q″ = s₀ + σ·Q, whose solution is
//!   Q = h·S + s₀·h²·C, q = 1 + z·C + s₀·h·S with z = σ·h², S = Σzⁿ/(2n+1)!, C = Σzⁿ/(2n+2)!. Velocities are right to rounding at any
//!   step. At a change of sign, where u₀ + A·Q = 0 along an axis, s has a corner, and the step ends.
//! - **Round bodies.** Q″ = k·|u₀ + A·Q| by Nyström's method of fifth order (Nyström 1925; Hairer, Nørsett, Wanner, *Solving Ordinary
//!   Differential Equations I*, II.14), in finer steps where |u| passes its minimum within a few steps.
//!
//! Places follow from velocities, accelerations and their rates j = (2s² − σ)·u − s·A at both ends by two-point Hermite quadrature of sixth order,
//! x = ½h(u₀ + u₁) + h²/10·(a₀ − a₁) + h³/120·(j₀ + j₁). A body with h·s or h·√s(A) beyond [`LIGHT`] takes several steps.

use crate::physics::{data::Pose, data::TERMINAL_TOLERANCE, data::parabola, forces::air::Drag};
use glam::DVec2;

/// The largest h·s and h·√s(A) of one step. Larger: errors of position above 1e-9 m a metre; smaller: more bodies take several steps.
const LIGHT: f64 = 0.0625;
/// Round things: the fewest steps in which |u| may pass its minimum. Fewer: 1e-6 m are lost at the apex of a steep throw.
const SHARP: f64 = 8.0;
/// Steps of one body in a tick, then it has its terminal velocity. Speed falls by a part of [`LIGHT`] in each: from 1e54 times that in some 3000.
const MOST_STEPS: u32 = 16_384;

/// u₁ = (u₀ + A·reach)·slower and x₁ = x₀ + (u₀·carry + A·lift) along both axes.
#[derive(Clone, Copy, Debug, Default)]
struct AirStep {
    /// Q, s.
    reach: f64,
    /// 1/q.
    slower: f64,
    /// s.
    carry: f64,
    /// s².
    lift: f64,
    /// Whether one step serves this body; else [`in_parts`] does.
    fits: bool,
}

impl AirStep {
    /// From Q/h, 1/q, and h·s and h²·σ at both ends.
    #[inline(always)]
    fn along(h: f64, stretch: f64, slower: f64, [(p, start), (q, end)]: [(f64, f64); 2]) -> Self {
        let reach = h * stretch;
        let carry_start = 0.5 - p * 0.1 - (start - 2.0 * p * p) * (1.0 / 120.0);
        let carry_end = (0.5 + q * 0.1 - (end - 2.0 * q * q) * (1.0 / 120.0)) * slower;
        let lift = h * (carry_end * reach) - h * h * ((p + q) * (1.0 / 120.0));
        Self { reach, slower, carry: h * (carry_start + carry_end), lift, fits: true }
    }
}

#[inline(always)]
fn box_step(h: f64, v: DVec2, a: DVec2, drag: &Drag) -> AirStep {
    let (tall, wide) = (drag.tall, drag.wide);
    let ahead = |u: f64, a: f64| if u * a < 0.0 { -a.abs() } else { a.abs() };
    let p = h * (tall * v.x.abs() + wide * v.y.abs());
    let z = h * h * (tall * ahead(v.x, a.x) + wide * ahead(v.y, a.y));
    let c = 0.5 + z * (1.0 / 24.0 + z * (1.0 / 720.0 + z * (1.0 / 40_320.0)));
    let s = 1.0 + z * (1.0 / 6.0 + z * (1.0 / 120.0 + z * (1.0 / 5040.0)));
    let stretch = s + p * c;
    let slower = 1.0 / (1.0 + (z * c + p * s));
    let end = (p + z * stretch) * slower;
    let eager = h * h * (tall * a.x.abs() + wide * a.y.abs());
    let reach = h * stretch;
    let corner = (tall * (v.x * (v.x + a.x * reach)) < 0.0) | (wide * (v.y * (v.y + a.y * reach)) < 0.0);
    let fits = !((p > LIGHT) | (eager > LIGHT * LIGHT) | corner);
    AirStep { fits, ..AirStep::along(h, stretch, slower, [(p, z), (end, z)]) }
}

#[inline(always)]
fn round_step(h: f64, v: DVec2, a: DVec2, round: f64) -> AirStep {
    let bend = h * round;
    let rate = |v: DVec2| bend * (v.x * v.x + v.y * v.y).sqrt();
    let at = |q: f64| rate(v + a * (h * q));
    let pull = a.x * a.x + a.y * a.y;
    let slope = |v: DVec2, rate: f64| h * bend * (bend * (v.x * a.x + v.y * a.y)) / (rate + f64::MIN_POSITIVE);
    let start = rate(v);
    let second = at(1.0 / 5.0 + start * (1.0 / 50.0));
    let third = at(2.0 / 3.0 + (7.0 * second - start) * (1.0 / 27.0));
    let fourth = at(1.0 + (21.0 * start - 4.0 * second + 18.0 * third) * (1.0 / 70.0));
    let stretch = 1.0 + (7.0 * start + 50.0 * second + 27.0 * third) * (1.0 / 168.0);
    let slower = 1.0 / (1.0 + (14.0 * start + 125.0 * second + 162.0 * third + 35.0 * fourth) * (1.0 / 336.0));
    let last = (v + a * (h * stretch)) * slower;
    let end = rate(last);
    let light = start > LIGHT || bend * bend * h * h * pull > LIGHT * LIGHT * LIGHT * LIGHT;
    let near = SHARP * h;
    let sharp = v.x * v.x + v.y * v.y < 2.0 * pull * (near * near) && bends(v, a);
    let ends = [(start, slope(v, start)), (end, slope(last, end))];
    AirStep { fits: !light && !sharp, ..AirStep::along(h, stretch, slower, ends) }
}

/// Whether |u₀ + A·Q| is not linear from here on: its minimum |u × A|/|A| lies ahead, or behind but not in zero. The square of the angle between
/// u and A up to which a round thing moves along a line is 1e-8: larger, a body that falls nearly straight loses digits.
#[inline(always)]
fn bends(v: DVec2, a: DVec2) -> bool {
    let (along, past) = (v.x * a.x + v.y * a.y, v.x * a.y - v.y * a.x);
    along < 0.0 || past * past > 1e-8 * (along * along)
}

#[inline(always)]
fn step(h: f64, v: DVec2, a: DVec2, drag: &Drag) -> AirStep {
    if drag.round > 0.0 { round_step(h, v, a, drag.round) } else { box_step(h, v, a, drag) }
}

fn take((x, v): Pose, a: DVec2, step: &AirStep) -> Pose {
    (x + (v * step.carry + a * step.lift), (v + a * step.reach) * step.slower)
}

/// The pose after `t` seconds of v′ = `a` − s(v)·v.
pub(crate) fn fly_through(pose: Pose, a: DVec2, drag: &Drag, t: f64) -> Pose {
    fly_in_steps(pose, a, drag, t).0
}

fn fly_in_steps(pose: Pose, a: DVec2, drag: &Drag, t: f64) -> (Pose, u32) {
    if drag.is_none() {
        return (parabola(pose, a, t), 0);
    }
    let whole = step(t, pose.1, a, drag);
    if whole.fits { (take(pose, a, &whole), 1) } else { in_parts(pose, a, drag, t) }
}

fn in_parts(mut pose: Pose, a: DVec2, drag: &Drag, t: f64) -> (Pose, u32) {
    if a == DVec2::ZERO {
        // Drag alone: u = u₀/(1 + s₀·t), x = u₀·ln(1 + s₀·t)/s₀.
        let ((x, v), rate) = (pose, drag.rate(pose.1));
        let way = if rate > 0.0 { libm::log1p(rate * t) / rate } else { t };
        return ((x + v * way, v / (1.0 + rate * t)), 1);
    }
    let slowest = drag.rate(a).sqrt();
    let terminal = if slowest > 0.0 { a / slowest } else { DVec2::ZERO };
    let same = |v: DVec2, other: DVec2| slowest > 0.0 && (v - other).length() <= TERMINAL_TOLERANCE * other.length();
    let (mut left, mut steps, mut before) = (t, 0, None);
    // Nyström's method ends 3e-10 beside the terminal velocity: a round thing whose velocity no longer changes has reached it.
    let settled = |v: DVec2, before: Option<DVec2>| same(v, terminal) || before.is_some_and(|before| same(v, before));
    while steps < MOST_STEPS && !settled(pose.1, before) {
        steps += 1;
        before = (drag.round > 0.0).then_some(pose.1);
        let fast = drag.rate(pose.1).max(slowest);
        let mut h = if fast * left > LIGHT { LIGHT * (1.0 - f64::EPSILON) / fast } else { left };
        // Shorter parts at the apex of a throw than 1/128: more work for 1e-12 m.
        if drag.round > 0.0 && bends(pose.1, a) {
            h = h.min((pose.1.length() / (SHARP * a.length())).max(t / 128.0)).min(left);
        }
        let mut whole = step(h, pose.1, a, drag);
        let corner = if drag.round > 0.0 { None } else { next_corner(pose.1, a, drag, whole.reach) };
        if let Some((axis, reach)) = corner {
            h = time_of(reach, h, pose.1, a, drag);
            whole = step(h, pose.1, a, drag);
            pose = take(pose, a, &whole);
            pose.1[axis] = 0.0;
        } else {
            pose = take(pose, a, &whole);
        }
        left -= h;
        if left <= 0.0 {
            return (pose, steps);
        }
    }
    ((pose.0 + terminal * left, terminal), steps)
}

/// The first axis along which u₀ + A·Q changes its sign before Q is `reach`, and the Q at which it does.
fn next_corner(v: DVec2, a: DVec2, drag: &Drag, reach: f64) -> Option<(usize, f64)> {
    let at = |axis: usize, drag: f64| {
        let q = -v[axis] / a[axis];
        (drag > 0.0 && v[axis] * (v[axis] + a[axis] * reach) < 0.0 && q > 0.0).then_some((axis, q.min(reach)))
    };
    match (at(0, drag.tall), at(1, drag.wide)) {
        (Some(x), Some(y)) => Some(if x.1 <= y.1 { x } else { y }),
        (x, y) => x.or(y),
    }
}

/// When Q is `reach`: within the `h` seconds of a step in which no component of u changes its sign before.
fn time_of(reach: f64, h: f64, v: DVec2, a: DVec2, drag: &Drag) -> f64 {
    let mut t = reach.min(h);
    // Six steps of Newton: the error is squared in each.
    for _ in 0..6 {
        let AirStep { reach: got, slower, .. } = step(t, v, a, drag);
        let next = (t + (reach - got) * slower).clamp(0.0, h);
        if next == t {
            break;
        }
        t = next;
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    /// However light it is, and whatever it begins with; a step is some 50 ns.
    #[test]
    fn what_has_reached_its_terminal_velocity_takes_no_more_steps() {
        for k in [1e2, 1e4, 1e6, 1e9] {
            for drag in [Drag { tall: k, wide: k, round: 0.0 }, Drag { round: k, ..Drag::default() }] {
                for v in [DVec2::ZERO, DVec2::new(0.0, -3.0), DVec2::new(1e-4, 0.0), DVec2::new(-0.4, 79.0)] {
                    let a = DVec2::new(570.0, 1e4);
                    let ((_, after), steps) = fly_in_steps((DVec2::ZERO, v), a, &drag, 1.0 / 120.0);
                    assert!(steps < 1000, "{drag:?}, {v}: {steps} steps");
                    let terminal = a / drag.rate(a).sqrt();
                    assert!((after - terminal).length() < 1e-2 * terminal.length() || k < 1e3, "{drag:?}, {v}: {after}");
                }
            }
        }
    }
}
