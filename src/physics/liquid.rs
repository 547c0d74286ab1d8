//! The motion of one body near or in a liquid, without contacts.
//!
//! The law has a kink wherever a side of the box passes a side of a liquid; between kinks it is smooth, and no step is taken across one.
//! What holds there decides how the body moves:
//!
//! - wholly inside or wholly outside (the same bath all around), without Stokes' drag: flight through a denser air under less weight,
//!   [`super::air`]; without quadratic drag: the exact flow of linear drag;
//! - cut by the surface, without any drag: the exact sine of a body that bobs, ω = √(ρ·g·b/m);
//! - otherwise the embedded Runge–Kutta pair of J. R. Dormand and P. J. Prince (1980), of fifth order, in steps by its own estimate of
//!   their error;
//! - where that would take hundreds of steps because the linear part is stiff (a grain in treacle, a gram on water): exponential steps
//!   (M. Hochbruck, A. Ostermann, *Exponential integrators*, Acta Numerica 2010), the exact damped spring of the linearised law
//!   ([`super::spring`]), by the difference of one step and two halves. They are stable at any rate.
//!
//! What sinks or rises at its terminal velocity stays on it. What floats with nothing left of its bobbing but rounding is at rest.

use super::air::fly_through;
use super::flow::Pose;
use super::impact_time::Cubic;
use super::media::{Bath, Law, Media};
use super::spring::spring;
use super::tuning::TERMINAL_TOLERANCE;
use super::zones::border;
use super::{Aabb, Body, FluidDef};
use glam::DVec2;

/// m. Error of one step, at most, by its own estimate. Larger: the tick shows in a splash; smaller: more steps for digits nobody sees.
const TOLERANCE: f64 = 1e-10;
/// The same of a stiff step.
const STIFF_TOLERANCE: f64 = 1e-8;
/// Rate × time of one Runge–Kutta step, at most: its stability ends at 1.0 for what bobs and 3.3 for what is damped.
const REACH: f64 = 0.7;
/// Rate × time of the first of some exponential steps.
const FIRST: f64 = 0.1;
/// Runge–Kutta steps from which on exponential steps cost less.
const STIFF_STEPS: f64 = 200.0;
/// Steps of one call, at most; or as many as media may take ([`Media::allow`]). What needs more leaves and meets the surface hundreds of times
/// within a tick; one implicit step leads it through what is left ([`Swimmer::leap`]).
const MOST_STEPS: u32 = 4096;
/// How much a step grows or shrinks by its error, at most.
const GROWTH: f64 = 4.0;
/// Halvings of the time of a kink, at most: it is found to the last bit, also where it comes within a billionth of the step.
const HALVINGS: u32 = 160;
/// Halvings of the velocity that an implicit step seeks.
const LEAP_HALVINGS: u32 = 64;
/// The least part of a step by which the search for a kink goes on.
const SHORTEST: f64 = 1e-12;
/// Places on a step at which the body is looked for on another side of a kink.
const LOOKS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];
/// What a look at the side of a kink, and at each liquid for it, a step of a Runge–Kutta pair, and an exponential step come to.
const WORK_OF_A_SIDE: u64 = 4;
const WORK_OF_A_KINK: u64 = 4;
const WORK_OF_A_STEP: u64 = 80;

/// One body in its media.
struct Swimmer<'a> {
    media: &'a Media,
    body: &'a Body,
    law: &'a Law,
}

/// Where `body` is after `t` seconds under `law`.
pub(super) fn swim(media: &Media, body: &Body, law: &Law, t: f64) -> Pose {
    let swimmer = Swimmer { media, body, law };
    let mut pose = (body.position, body.velocity);
    let (mut left, mut h) = (t, f64::INFINITY);
    for _ in 0..MOST_STEPS {
        if left <= 0.0 || media.is_spent() {
            break;
        }
        let (bath, constant, floats) = swimmer.look(pose);
        if floats && pose.1.x == 0.0 && constant.x == 0.0 {
            return pose;
        }
        let (taken, mut end, next) = swimmer.take(&bath, constant, pose, h, left);
        if floats {
            (end.0.y, end.1.y) = (pose.0.y, 0.0);
        }
        pose = end;
        left -= taken;
        h = next;
    }
    if left > 0.0 {
        pose = swimmer.leap(pose, left);
    }
    swimmer.come_to_rest(&mut pose);
    pose
}

impl Swimmer<'_> {
    /// The bath of a body, its constant acceleration, and whether its weight is borne by a liquid: the vertical accelerations then
    /// balance exactly.
    fn look(&self, (x, v): Pose) -> (Bath, DVec2, bool) {
        let mut bath = self.media.bath(self.body, self.law, x);
        let mut constant = self.law.constant;
        let left_over = (constant.y - bath.lift).abs();
        let floats = v.y == 0.0 && bath.fraction > 0.0 && left_over <= bath.rounding(constant, self.body, x.y);
        if floats {
            constant.y = bath.lift;
            (bath.stiffness, bath.waves) = (0.0, 0.0);
        }
        (bath, constant, floats)
    }

    /// Ends a bobbing of which nothing is left but rounding.
    fn come_to_rest(&self, (x, v): &mut Pose) {
        let bath = self.media.bath(self.body, self.law, *x);
        if bath.stiffness > 0.0 && bath.linear + bath.waves > 0.0 {
            let rounding = bath.rounding(self.law.constant, self.body, x.y);
            if v.y.abs() * bath.stiffness.sqrt() <= rounding && (self.law.constant.y - bath.lift).abs() <= rounding {
                v.y = 0.0;
            }
        }
    }

    /// One implicit Euler step of `h` seconds. In a force that falls with the depth at which it lifts, which is what liquids do, it gains no
    /// energy however long it is, and no speed but from constant forces; so it may be off, but leads neither away nor back.
    fn leap(&self, (x, v): Pose, h: f64) -> Pose {
        let constant = self.law.constant;
        let bath = self.media.bath(self.body, self.law, x);
        let across = (v.x + h * constant.x) / (1.0 + h * (bath.drag.rate(v) + bath.linear));
        let beside = x.x + h * across;
        // v′ − v − h·a(x + h·v′, v′) rises with v′: halvings find its root, within what gravity and all liquids could do to a body.
        let excess = |speed: f64| {
            let bath = self.media.bath(self.body, self.law, DVec2::new(beside, x.y + h * speed));
            speed - v.y - h * bath.acceleration(constant, DVec2::new(across, speed)).y
        };
        let area = 4.0 * self.body.half.x * self.body.half.y;
        let lift = self.media.liquids(self.law).fold(0.0, |sum, (_, fluid)| sum + fluid.density * area);
        let most = h * (constant.y.abs() + self.media.gravity.abs() * lift / self.body.mass);
        let (mut low, mut high) = (v.y.min(0.0) - most, v.y.max(0.0) + most);
        for _ in 0..LEAP_HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if excess(middle) < 0.0 { low = middle } else { high = middle }
        }
        let down = if low.abs() < high.abs() { low } else { high };
        (DVec2::new(beside, x.y + h * down), DVec2::new(across, down))
    }

    /// On which side of all kinks a body at `x` is: four bits an axis of each liquid that it touches.
    fn side(&self, x: DVec2) -> u64 {
        self.media.spend(WORK_OF_A_SIDE + WORK_OF_A_KINK * u64::from(self.law.liquids.len()));
        let (top_left, bottom_right) = (x - self.body.half, x + self.body.half);
        self.media.liquids(self.law).fold(0, |code: u64, (_, FluidDef { zone, .. })| {
            let touches = top_left.cmplt(zone.max).all() && bottom_right.cmpgt(zone.min).all();
            let bits = top_left.cmplt(zone.min).bitmask() << 2 | bottom_right.cmpgt(zone.max).bitmask();
            code.wrapping_mul(31) + if touches { u64::from(bits) + 1 } else { 0 }
        })
    }

    /// One step of at most `h` of the `left` seconds: how long it was, where it led, and how long the next may be.
    fn take(&self, bath: &Bath, constant: DVec2, pose: Pose, h: f64, left: f64) -> (f64, Pose, f64) {
        let free = DVec2::new(constant.x, constant.y - bath.lift);
        if let Some(velocity) = settled(bath, free, pose.1) {
            return self.take_exact(bath, pose, left, |t| (pose.0 + velocity * t, velocity));
        }
        let undamped = bath.drag.is_none() && bath.linear == 0.0 && bath.waves == 0.0;
        if bath.same_around && bath.linear == 0.0 {
            let fast = bath.drag.rate(pose.1).max(bath.drag.rate(free).sqrt());
            return self.take_exact(bath, pose, left.min(REACH / fast), |t| fly_through(pose, free, &bath.drag, t));
        }
        if bath.drag.is_none() && bath.same_around || undamped && bath.same_across {
            // Piece by piece where it could leave the surface and come back within a step.
            let whole = bath.stiffness == 0.0 || self.bobs_within(bath, pose, left);
            let most = if whole { left } else { left.min(REACH / bath.stiffness.sqrt()) };
            return self.take_exact(bath, pose, most, |t| linear_flow(bath, constant, pose, t));
        }
        let answer = bath.answer(pose.1);
        let rate = answer.drag.max_element() + answer.lift.sqrt();
        if (bath.linear + bath.waves + bath.stiffness.sqrt()) * left > STIFF_STEPS * REACH {
            let h = if h < left { h } else { FIRST / rate };
            self.take_stiff(bath, constant, pose, h.min(left), left)
        } else {
            self.take_explicit(bath, constant, pose, h.min(REACH / rate).min(left), left)
        }
    }

    /// A step of at most `h` by an exact flow.
    fn take_exact(&self, bath: &Bath, pose: Pose, h: f64, flow: impl Fn(f64) -> Pose) -> (f64, Pose, f64) {
        let h = self.first_kink(bath, pose, &flow, h);
        (h, flow(h), f64::INFINITY)
    }

    fn take_explicit(&self, bath: &Bath, constant: DVec2, pose: Pose, mut h: f64, left: f64) -> (f64, Pose, f64) {
        let tolerance = TOLERANCE + 8.0 * f64::EPSILON * pose.0.abs().max_element();
        let side = self.side(pose.0);
        let mut next = f64::INFINITY;
        let mut to_kink = false;
        loop {
            let (end, error) = self.dormand_prince(constant, pose, h);
            let factor = step_factor(error / tolerance, 0.2);
            // A step too short to resolve anything is taken as it is.
            if error > tolerance && h > left * f64::EPSILON {
                (h, to_kink) = (h * factor.min(0.5), false);
                continue;
            }
            if to_kink {
                // The cubic may see a kink one rounding before the step meets it: on, until it does.
                if self.side(end.0) != side || h >= next {
                    return (h, end, next);
                }
                h = (2.0 * h + next * SHORTEST).min(next);
                continue;
            }
            let cubic = Cubic::hermite(pose.0, pose.1, end.0, end.1, h);
            let kink = self.first_kink(bath, pose, |t| (DVec2::new(cubic.axis(0).at(t), cubic.axis(1).at(t)), pose.1), h);
            if kink >= h {
                return (h, end, h * factor);
            }
            (next, h, to_kink) = (h, kink, true);
        }
    }

    fn take_stiff(&self, bath: &Bath, constant: DVec2, pose: Pose, mut h: f64, left: f64) -> (f64, Pose, f64) {
        loop {
            self.media.spend(3 * WORK_OF_A_STEP);
            let once = linear_flow(bath, constant, pose, h);
            let middle = linear_flow(bath, constant, pose, 0.5 * h);
            let second = self.media.bath(self.body, self.law, middle.0);
            let end = linear_flow(&second, constant, middle, 0.5 * h);
            let error = (once.0 - end.0).abs().max_element();
            let factor = step_factor(error / STIFF_TOLERANCE, 0.5);
            if error <= STIFF_TOLERANCE || h <= left * f64::EPSILON {
                let flow = |t: f64| {
                    let beyond = t - 0.5 * h;
                    if beyond <= 0.0 {
                        linear_flow(bath, constant, pose, t)
                    } else {
                        linear_flow(&second, constant, middle, beyond)
                    }
                };
                let kink = self.first_kink(bath, pose, flow, h);
                return (kink, if kink < h { flow(kink) } else { end }, h * factor);
            }
            h *= factor.min(0.5);
        }
    }

    /// Whether what bobs freely stays cut by the surface for `t` seconds.
    fn bobs_within(&self, bath: &Bath, (x, v): Pose, t: f64) -> bool {
        let constant = self.law.constant;
        let middle = x.y + (constant.y - bath.lift) / bath.stiffness;
        let amplitude = ((x.y - middle) * (x.y - middle) + v.y * v.y / bath.stiffness).sqrt();
        let reach = (v.x.abs() + constant.x.abs() * t) * t;
        let corners = [(-reach, -amplitude), (-reach, amplitude), (reach, -amplitude), (reach, amplitude)];
        corners.into_iter().all(|(dx, dy)| self.side(DVec2::new(x.x + dx, middle + dy)) == self.side(x))
    }

    /// When a motion first meets a kink within `h` seconds, or just after; `h` if it meets none.
    fn first_kink(&self, bath: &Bath, pose: Pose, flow: impl Fn(f64) -> Pose, h: f64) -> f64 {
        let side = self.side(pose.0);
        let stays = |t: f64| self.side(flow(t).0) == side;
        let refined = |mut from: f64, mut to: f64| {
            for _ in 0..HALVINGS {
                let middle = 0.5 * (from + to);
                if middle <= from || middle >= to {
                    break;
                }
                if stays(middle) { from = middle } else { to = middle }
            }
            to
        };
        if bath.fraction == 0.0 {
            // Out of all liquids: what is fast may fly through one between two looks.
            let end = flow(h);
            let cubic = Cubic::hermite(pose.0, pose.1, end.0, end.1, h);
            let swept = Aabb::around(pose.0, self.body.half).union(&Aabb::around(end.0, self.body.half));
            let reached = self.media.liquids(self.law).filter(|(_, fluid)| swept.touches(&fluid.zone, 0.0));
            let first =
                reached.fold(h, |first, (_, fluid)| border(&cubic, self.body.half, &fluid.zone, false, first).unwrap_or(first));
            // Rounding leaves it before the border: just beyond it.
            let (mut from, mut beyond) = (0.0, h * f64::EPSILON);
            while first < h && beyond < h {
                let t = (first + beyond).min(h);
                if !stays(t) {
                    return refined(from, t);
                }
                (from, beyond) = (t, beyond * 4.0);
            }
        }
        let mut from = 0.0;
        for part in LOOKS {
            let to = part * h;
            if !stays(to) {
                return refined(from, to);
            }
            from = to;
        }
        h
    }

    /// One step of the pair of Dormand and Prince, and its error in m.
    fn dormand_prince(&self, constant: DVec2, (x, v): Pose, h: f64) -> (Pose, f64) {
        self.media.spend(WORK_OF_A_STEP);
        let acceleration = |x: DVec2, v: DVec2| self.media.bath(self.body, self.law, x).acceleration(constant, v);
        let mut speeds = [v; 7];
        let mut pulls = [acceleration(x, v); 7];
        for (i, row) in ROWS.iter().enumerate() {
            let (mut way, mut gain) = (DVec2::ZERO, DVec2::ZERO);
            for (weight, (speed, pull)) in row[..=i].iter().zip(speeds.iter().zip(&pulls)) {
                way += *speed * *weight;
                gain += *pull * *weight;
            }
            speeds[i + 1] = v + gain * h;
            pulls[i + 1] = acceleration(x + way * h, speeds[i + 1]);
            if i + 1 == ROWS.len() {
                let sum = |of: &[DVec2; 7]| of.iter().zip(ERROR).fold(DVec2::ZERO, |sum, (k, weight)| sum + *k * weight);
                let error = (sum(&speeds) * h).abs().max((sum(&pulls) * (h * h)).abs());
                return ((x + way * h, speeds[i + 1]), error.max_element());
            }
        }
        unreachable!()
    }
}

/// The terminal velocity of what is the same all around, if `v` has reached it; `free` is what pulls besides drag, m/s².
fn settled(bath: &Bath, free: DVec2, v: DVec2) -> Option<DVec2> {
    // Along the pull, u = λ·A with λ²·s(A) + λ·c = 1.
    let root = (bath.linear * bath.linear + 4.0 * bath.drag.rate(free)).sqrt();
    if !bath.same_around || bath.linear + root == 0.0 {
        return None;
    }
    let terminal = free * (2.0 / (bath.linear + root));
    ((v - terminal).length() <= TERMINAL_TOLERANCE * terminal.length()).then_some(terminal)
}

/// The motion by the law linearised where it begins: exact for linear drag and a constant stiffness.
fn linear_flow(bath: &Bath, constant: DVec2, (x, v): Pose, t: f64) -> Pose {
    let (a, answer) = (bath.acceleration(constant, v), bath.answer(v));
    let across = spring(v.x, a.x, answer.drag.x, 0.0, t);
    let down = spring(v.y, a.y, answer.drag.y, answer.lift, t);
    (x + DVec2::new(across.0, down.0), DVec2::new(across.1, down.1))
}

/// By what factor the next step may be longer, given the error of this one as a part of what is allowed.
fn step_factor(error: f64, power: f64) -> f64 {
    if error > 0.0 { (0.9 * libm::pow(error, -power)).clamp(1.0 / GROWTH, GROWTH) } else { GROWTH }
}

/// The stages of the pair; the last row is its result.
const ROWS: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19_372.0 / 6561.0, -25_360.0 / 2187.0, 64_448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46_732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18_656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// The difference of its results of fifth and fourth order.
const ERROR: [f64; 7] = [71.0 / 57_600.0, 0.0, -71.0 / 16_695.0, 71.0 / 1920.0, -17_253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
