//! The motion of one body near or in a liquid, without contacts.
//!
//! The law has a kink wherever a side of the box passes a side of a liquid; between kinks all liquids together are one smooth form
//! ([`crate::physics::forces::bath`]), and no step is taken across one. What holds there decides how the body moves:
//!
//! - wholly inside or wholly outside (the same bath all around), without Stokes' drag: flight through a denser air under less weight,
//!   [`crate::physics::forces::air`];
//! - otherwise steps by their own estimate of their error ([`crate::physics::flight::steps`]).
//!
//! What sinks or rises at its terminal velocity stays on it. What floats with nothing left of its bobbing but rounding is at rest.

use crate::physics::data::body::Body;
use crate::physics::data::impact_time::Cubic;
use crate::physics::data::tuning::TERMINAL_TOLERANCE;
use crate::physics::flight::flow::{Course, Pose};
use crate::physics::flight::steps::Steps;
use crate::physics::forces::air::fly_through;
use crate::physics::forces::bath::{Bath, Regime};
use crate::physics::forces::media::{Law, Media};
use glam::DVec2;

/// Rate × time of one Runge–Kutta step, at most, for what bobs and for what is damped: its stability ends at 1.0 and at 3.3.
const REACH: f64 = 0.7;
const DAMPED_REACH: f64 = 2.5;
/// Rate × time of a step from which on it is implicit, where drag has taken the body to the speed that its place gives it but for such a part.
/// Smaller: more steps are implicit that explicit ones take for less; larger: more that their stability cuts short.
const HEAVY: f64 = 4.0;
const EVEN: f64 = 0.1;
/// Rate × time from which on one such step is enough where nothing but a rough answer is needed.
const AT_ONCE: f64 = 20.0;
/// Steps of one call, at most, and where a rough answer is enough. What needs more leaves and meets the surface hundreds of times within a tick;
/// one implicit step leads it through what is left ([`Swimmer::leap`]).
const MOST_STEPS: u32 = 128;
const MOST_ROUGH_STEPS: u32 = 8;
/// How much a step grows by its error, at most, how much it shrinks, and what of that it does to be sure.
const GROWTH: f64 = 3.0;
const SHRINKAGE: f64 = 0.05;
const CAUTION: f64 = 0.75;
/// How often the end of an exact step is brought nearer to the kink that it passes.
const MOST_CUTS: u32 = 8;
/// Trials of the velocity that an implicit step seeks, at most; and what is exact enough, as a part of it.
const LEAP_TRIALS: usize = 100;
const LEAP_TOLERANCE: f64 = 1e-13;
const ROUGH_LEAP: f64 = 1e-4;
/// Trials after which every other one halves what is left to search.
const SURE_TRIALS: usize = 4;
/// What moves faster than by so many roundings is not at rest.
const NEARLY: f64 = 16.0;

/// One body in its media.
struct Swimmer<'a> {
    body: &'a Body,
    law: &'a Law,
    media: &'a Media,
}

/// By what a motion is told around a place.
enum Kind {
    /// By its terminal velocity, m/s.
    Settled(DVec2),
    /// By flight through what is the same all around, for so many seconds at once.
    Air(f64),
    /// By steps: the rates of all, and of its drag beyond that of what bobs, 1/s, and how long an explicit step may be, s.
    Neither { rate: f64, most: f64, heavy: f64 },
}

/// How a step ends.
pub(crate) struct Taken {
    /// How long it was, s.
    pub time: f64,
    pub end: Pose,
    /// How long the next may be, s.
    pub next: f64,
    /// The acceleration where it ended, m/s², if that came out of it.
    pub pull: Option<DVec2>,
}

/// Where `body` is after `t` seconds under `law`; or at the end of the last step of which `goes_on` says so, or of the first.
pub(crate) fn swim(media: &Media, body: &Body, law: &Law, t: f64, mut goes_on: impl FnMut(f64, Pose) -> bool) -> Course {
    let swimmer = Swimmer { media, body, law };
    let mut pose = (body.position, body.velocity);
    let mut regime = Regime::new(media, body, law, pose.0);
    let (mut left, mut h) = (t, if law.first > 0.0 { law.first } else { f64::INFINITY });
    let (mut pull, mut bobs) = (None, true);
    let most = match media.is_rough() {
        true if swimmer.is_heavy(&regime, pose, t) => 0,
        true => MOST_ROUGH_STEPS,
        false => MOST_STEPS,
    };
    for _ in 0..most {
        if left <= 0.0 {
            break;
        }
        regime.follow(pose.0);
        let (bath, constant, floats) = swimmer.look(&regime, pose);
        if floats && pose.1.x == 0.0 && constant.x == 0.0 {
            return Course { end: pose, time: t, next: h, pull: None };
        }
        let taken = swimmer.take(&regime, &bath, constant, pose, (h, left));
        let (before, begun, last) = (pose, left, pull);
        (pose, pull) = (taken.end, taken.pull);
        bobs = true;
        if floats {
            (pose.0.y, pose.1.y) = (before.0.y, 0.0);
        } else if regime.holds(pose.0) {
            bobs = pose.1.y.abs() * bath.stiffness.sqrt() <= NEARLY * bath.rounding(law.constant, body, before.0.y);
        } else {
            pull = None;
        }
        left -= taken.time;
        if !goes_on(t - left, pose) {
            if begun < t {
                (pose, left, pull) = (before, begun, last);
            }
            return Course { end: pose, time: t - left, next: h, pull };
        }
        // What was cut off to end here says nothing about the next step.
        h = if left <= 0.0 && h.is_finite() { taken.next.max(h) } else { taken.next };
    }
    if left > 0.0 {
        media.end_early();
        (pose, pull, bobs) = (swimmer.leap(&mut regime, pose, left), None, true);
    }
    if bobs {
        swimmer.come_to_rest(&mut regime, &mut pose);
    }
    // What has no velocity up or down may be in balance.
    let pull = pull.filter(|_| pose.1.y != 0.0);
    Course { end: pose, time: t, next: h, pull }
}

impl Swimmer<'_> {
    /// The bath of a body, its constant acceleration, and whether its weight is borne by a liquid: the vertical accelerations then
    /// balance exactly.
    fn look(&self, regime: &Regime, (x, v): Pose) -> (Bath, DVec2, bool) {
        let mut bath = regime.bath(x);
        let mut constant = self.law.constant;
        let floats = v.y == 0.0 && regime.balances(&bath, x, constant.y - bath.lift);
        if floats {
            constant.y = bath.lift;
            (bath.stiffness, bath.waves) = (0.0, 0.0);
        }
        (bath, constant, floats)
    }

    /// Whether a liquid takes a body to the speed that its place gives it long before `t` seconds are over: one implicit step then says roughly
    /// where it gets.
    fn is_heavy(&self, regime: &Regime, pose: Pose, t: f64) -> bool {
        let (bath, constant, _) = self.look(regime, pose);
        match self.kind(regime, &bath, DVec2::new(constant.x, constant.y - bath.lift), pose.1) {
            Kind::Settled(_) => false,
            Kind::Air(longest) => t > AT_ONCE * longest,
            Kind::Neither { heavy, .. } => heavy * t > AT_ONCE,
        }
    }

    /// Ends a bobbing of which nothing is left but rounding.
    fn come_to_rest(&self, regime: &mut Regime, (x, v): &mut Pose) {
        let bath = regime.follow(*x).bath(*x);
        if bath.stiffness > 0.0 && bath.linear + bath.waves > 0.0 {
            let rounding = bath.rounding(self.law.constant, self.body, x.y);
            if v.y.abs() * bath.stiffness.sqrt() <= rounding && (self.law.constant.y - bath.lift).abs() <= rounding {
                v.y = 0.0;
            }
        }
    }

    /// One implicit Euler step of `h` seconds. In a force that falls with the depth at which it lifts, which is what liquids do, it gains no
    /// energy however long it is, and no speed but from constant forces; so it may be off, but leads neither away nor back.
    fn leap(&self, regime: &mut Regime, (x, v): Pose, h: f64) -> Pose {
        let constant = self.law.constant;
        let bath = regime.follow(x).bath(x);
        let across = (v.x + h * constant.x) / (1.0 + h * (bath.drag.rate(v) + bath.linear));
        let beside = x.x + h * across;
        let tolerance = if self.media.is_rough() { ROUGH_LEAP } else { LEAP_TOLERANCE };
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let (mut down, mut found) = (v.y, false);
        for trial in 0..LEAP_TRIALS {
            // v′ − v − h·a(x + h·v′, v′) rises with v′, by at least as much.
            let (there, speed) = (DVec2::new(beside, x.y + h * down), DVec2::new(across, down));
            let bath = regime.follow(there).bath(there);
            let over = down - v.y - h * bath.acceleration(constant, speed).y;
            (low, high) = if over < 0.0 { (down, high.min(down - over)) } else { (low.max(down - over), down) };
            // Where what drags and lifts there changes no more than linearly with the depth: p·v′ + q·v′·|v′| = r.
            let Bath { drag, linear, waves, stiffness, lift, .. } = bath;
            let (along, aside) = if down == 0.0 { (0.0, across.abs()) } else { (speed.length() / down.abs(), 0.0) };
            let p = 1.0 + h * (linear + waves + drag.tall * across.abs() + drag.round * aside) + h * h * stiffness;
            let q = h * (drag.wide + drag.round * along);
            let r = v.y + h * (constant.y - lift) + h * h * stiffness * down;
            let guess = 2.0 * r / (p + (p * p + 4.0 * q * r.abs()).sqrt());
            // Across kinks it may lead to and fro.
            let inside = guess > low && guess < high && (trial < SURE_TRIALS || trial % 2 == 0);
            let next = if inside { guess } else { 0.5 * (low + high) };
            found = (next - down).abs() <= tolerance * down.abs();
            down = next;
            if found {
                break;
            }
        }
        if !found {
            // The slower end of where it is gains nothing.
            down = if low.abs() < high.abs() { low } else { high };
        }
        (DVec2::new(beside, x.y + h * down), DVec2::new(across, down))
    }

    /// By what the motion is told from here on.
    fn kind(&self, regime: &Regime, bath: &Bath, free: DVec2, v: DVec2) -> Kind {
        let same_around = regime.is_same_around();
        if same_around && let Some(velocity) = settled(bath, free, v) {
            return Kind::Settled(velocity);
        }
        let fastest = bath.drag.rate(v).max(bath.drag.rate(free).sqrt());
        if same_around && bath.linear == 0.0 {
            return Kind::Air(REACH / fastest);
        }
        // The greater eigenvalue of what drag answers is 2·s(v); at once it may be as fast as at its terminal velocity.
        let drag = 2.0 * fastest + bath.linear + bath.waves;
        let bobs = bath.stiffness.sqrt();
        let heavy = drag - bobs;
        Kind::Neither { heavy, rate: drag + bobs, most: (REACH / bobs).min(DAMPED_REACH / drag) }
    }

    /// One step of at most `h` of the `left` seconds.
    fn take(&self, regime: &Regime, bath: &Bath, constant: DVec2, pose: Pose, (h, left): (f64, f64)) -> Taken {
        let free = DVec2::new(constant.x, constant.y - bath.lift);
        match self.kind(regime, bath, free, pose.1) {
            Kind::Settled(velocity) => take_exact(regime, pose, left, |t| (pose.0 + velocity * t, velocity)),
            Kind::Air(longest) => take_exact(regime, pose, left.min(longest), |t| fly_through(pose, free, &bath.drag, t)),
            Kind::Neither { rate, most, heavy } => {
                let implicit = heavy * h.min(left) > HEAVY && is_even(bath.acceleration(constant, pose.1), pose.1, heavy);
                let slopes = implicit.then(|| regime.slopes(pose.0, pose.1));
                let steps = Steps { media: self.media, regime, bath, constant, slopes };
                let first = if implicit || h.is_finite() { h } else { steps.first(pose.1, rate, left) };
                let most = if implicit { left } else { most.min(left) };
                steps.take(pose, first.min(most), left).unwrap_or_else(|shortest| {
                    let end = self.leap(&mut regime.clone(), pose, shortest);
                    Taken { time: shortest, end, next: shortest, pull: None }
                })
            }
        }
    }
}

/// A step of at most `h` by an exact flow.
fn take_exact(regime: &Regime, pose: Pose, mut h: f64, flow: impl Fn(f64) -> Pose) -> Taken {
    let mut end = flow(h);
    for _ in 0..MOST_CUTS {
        let way = Cubic::hermite(pose.0, pose.1, end.0, end.1, h);
        let Some(kink) = regime.end_of(&way, h).filter(|kink| *kink < h) else { break };
        h = kink.max(h * f64::EPSILON);
        end = flow(h);
        if regime.all_but_holds(end.0) {
            break;
        }
    }
    Taken { time: h, end, next: f64::INFINITY, pull: None }
}

/// Whether a body, accelerated by `pull`, has come to the speed that its place gives it in a law of that rate, 1/s, but for a small part.
fn is_even(pull: DVec2, v: DVec2, rate: f64) -> bool {
    pull.length() < EVEN * rate * v.length()
}

/// The terminal velocity of what is the same all around, if `v` has reached it; `free` is what pulls besides drag, m/s².
fn settled(bath: &Bath, free: DVec2, v: DVec2) -> Option<DVec2> {
    // Along the pull, u = λ·A with λ²·s(A) + λ·c = 1.
    let root = (bath.linear * bath.linear + 4.0 * bath.drag.rate(free)).sqrt();
    if bath.linear + root == 0.0 {
        return None;
    }
    let terminal = free * (2.0 / (bath.linear + root));
    ((v - terminal).length() <= TERMINAL_TOLERANCE * terminal.length()).then_some(terminal)
}

/// By what factor the next step may be longer, given a root of the error of this one as a part of what is allowed: the fourth root stands for
/// the fifth, which takes longer to find; up to [`GROWTH`] that errs on the side of caution.
pub(crate) fn step_factor(root: f64) -> f64 {
    let factor = CAUTION / root;
    // What is no number is too long.
    if factor >= SHRINKAGE { factor.min(GROWTH) } else { SHRINKAGE }
}
