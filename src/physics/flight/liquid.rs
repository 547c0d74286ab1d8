//! The motion of one body near or in a liquid, without contacts.
//!
//! The law has a kink wherever a side of the box passes a side of a liquid; between kinks all liquids together are one smooth form
//! ([`crate::physics::forces::displaced`]), and no step crosses one. The media between them decide how the body moves:
//!
//! - wholly inside or wholly outside (the same bath all around), without Stokes' drag: flight through a denser air under less weight,
//!   [`crate::physics::flight::air`];
//! - otherwise steps by their own estimate of their error ([`crate::physics::flight::steps`]).
//!
//! A body that sinks or rises at its terminal velocity stays on it. A body whose bobbing is down to rounding is at rest.

use crate::physics::data::body::{Body, Pose};
use crate::physics::data::impact_time::Cubic;
use crate::physics::data::tuning::{BOBBING_REACH, HEAVY_REACH, TERMINAL_TOLERANCE};
use crate::physics::flight::air::fly_through;
use crate::physics::flight::steps::{Course, Steps};
use crate::physics::forces::law::Law;
use crate::physics::forces::liquid::{Bath, Regime};
use crate::physics::forces::media::Media;
use glam::DVec2;

/// A body in its media on its way.
#[derive(Clone)]
struct Swimmer<'a> {
    regime: Regime<'a>,
    /// Whether nothing but a rough answer is needed.
    rough: bool,
}

/// The media at a place, and the constant acceleration there, m/s².
struct Place {
    bath: Bath,
    constant: DVec2,
    /// Whether a liquid bears its weight: the vertical accelerations then balance exactly.
    floats: bool,
}

impl Place {
    /// The acceleration besides drag, m/s².
    fn free(&self) -> DVec2 {
        DVec2::new(self.constant.x, self.constant.y - self.bath.lift)
    }
}

/// How a body moves around a place.
enum Kind {
    /// By its terminal velocity, m/s.
    Settled(DVec2),
    /// By flight through one medium all around, for this many seconds at once.
    Air(f64),
    /// By steps: the sum of its rates, the rate of drag beyond that of bobbing, 1/s, and the longest explicit step, s.
    Neither { rate: f64, most: f64, heavy: f64 },
}

/// Where `body` is after `t` seconds under `law`; or at the end of the last step of which `goes_on` says so, or of the first.
pub(crate) fn swim(media: &Media, body: &Body, law: &Law, t: f64, mut goes_on: impl FnMut(f64, Pose) -> bool) -> Course {
    let mut pose = (body.position, body.velocity);
    let mut swimmer = Swimmer { regime: law.regime(media, body, pose.0), rough: law.rough };
    let (mut left, mut h) = (t, if law.first > 0.0 { law.first } else { f64::INFINITY });
    let (mut pull, mut bobs) = (None, true);
    for _ in 0..swimmer.most_steps(pose, t) {
        if left <= 0.0 {
            break;
        }
        swimmer.regime.follow(pose.0);
        let place = swimmer.look(pose);
        if place.floats && pose.1.x == 0.0 && place.constant.x == 0.0 {
            return Course { end: pose, time: t, next: h, pull: None };
        }
        let taken = swimmer.take(&place, pose, h, left);
        let (before, begun, last) = (pose, left, pull);
        (pose, pull) = (taken.end, taken.pull);
        bobs = true;
        if place.floats {
            (pose.0.y, pose.1.y) = (before.0.y, 0.0);
        } else if swimmer.regime.displaced.holds(pose.0) {
            // A body that moves faster than by 16 roundings is not at rest.
            let rounding = place.bath.rounding(law.constant, body, before.0.y);
            bobs = pose.1.y.abs() * place.bath.stiffness.sqrt() <= 16.0 * rounding;
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
        // A step cut off to end here says nothing about the next one.
        h = if left <= 0.0 && h.is_finite() { taken.next.max(h) } else { taken.next };
    }
    if left > 0.0 {
        if !law.rough {
            media.end_early();
        }
        (pose, pull, bobs) = (swimmer.leap(pose, left), None, true);
    }
    if bobs {
        swimmer.come_to_rest(&mut pose);
    }
    // A body without velocity up or down may be in balance.
    let pull = pull.filter(|_| pose.1.y != 0.0);
    Course { end: pose, time: t, next: h, pull }
}

impl Swimmer<'_> {
    fn look(&self, (x, v): Pose) -> Place {
        let (mut bath, mut constant) = (self.regime.bath(x), self.regime.constant);
        let floats = v.y == 0.0 && self.regime.balances(&bath, x, constant.y - bath.lift);
        if floats {
            constant.y = bath.lift;
            (bath.stiffness, bath.waves) = (0.0, 0.0);
        }
        Place { bath, constant, floats }
    }

    /// The most steps of `t` seconds. A body that needs more leaves and meets the surface hundreds of times within a tick; one implicit step leads
    /// it through the rest ([`Swimmer::leap`]). Where a rough answer is enough, one such step leads a body through all of it that a liquid brings
    /// to the speed of its place long before the end.
    fn most_steps(&self, pose: Pose, t: f64) -> u32 {
        if !self.rough {
            return 128;
        }
        let reach = match self.kind(&self.look(pose), pose.1) {
            Kind::Settled(_) => 0.0,
            Kind::Air(longest) => t / longest,
            Kind::Neither { heavy, .. } => heavy * t,
        };
        if reach > 20.0 { 0 } else { 8 }
    }

    /// Ends a bobbing of which nothing is left but rounding.
    fn come_to_rest(&mut self, (x, v): &mut Pose) {
        let bath = self.regime.follow(*x).bath(*x);
        if bath.stiffness > 0.0 && bath.linear + bath.waves > 0.0 {
            let (constant, body) = (self.regime.constant, self.regime.body);
            let rounding = bath.rounding(constant, body, x.y);
            if v.y.abs() * bath.stiffness.sqrt() <= rounding && (constant.y - bath.lift).abs() <= rounding {
                v.y = 0.0;
            }
        }
    }

    /// One implicit Euler step of `h` seconds. Liquids lift more with the depth: in such a force the step gains no energy however long it is, and no
    /// speed but from constant forces; so it may be off, but leads neither away nor back.
    fn leap(&mut self, (x, v): Pose, h: f64) -> Pose {
        let constant = self.regime.constant;
        let bath = self.regime.follow(x).bath(x);
        let across = (v.x + h * constant.x) / (1.0 + h * (bath.drag.rate(v) + bath.linear));
        let beside = x.x + h * across;
        let tolerance = if self.rough { 1e-4 } else { 1e-13 };
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let (mut down, mut found) = (v.y, false);
        for trial in 0..100 {
            // v′ − v − h·a(x + h·v′, v′) rises with v′, by at least as much.
            let (there, speed) = (DVec2::new(beside, x.y + h * down), DVec2::new(across, down));
            let bath = self.regime.follow(there).bath(there);
            let over = down - v.y - h * bath.acceleration(constant, speed).y;
            (low, high) = if over < 0.0 { (down, high.min(down - over)) } else { (low.max(down - over), down) };
            // As if drag and lift changed linearly with the depth there: p·v′ + q·v′·|v′| = r.
            let Bath { drag, linear, waves, stiffness, lift, .. } = bath;
            let (along, aside) = if down == 0.0 { (0.0, across.abs()) } else { (speed.length() / down.abs(), 0.0) };
            let p = 1.0 + h * (linear + waves + drag.tall * across.abs() + drag.round * aside) + h * h * stiffness;
            let q = h * (drag.wide + drag.round * along);
            let r = v.y + h * (constant.y - lift) + h * h * stiffness * down;
            let guess = 2.0 * r / (p + (p * p + 4.0 * q * r.abs()).sqrt());
            // Across kinks it may lead to and fro: after four trials every other one halves the bracket.
            let inside = guess > low && guess < high && (trial < 4 || trial % 2 == 0);
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

    fn kind(&self, place: &Place, v: DVec2) -> Kind {
        let (bath, free) = (&place.bath, place.free());
        let same_around = self.regime.displaced.is_same_around();
        if same_around && let Some(velocity) = settled(bath, free, v) {
            return Kind::Settled(velocity);
        }
        let fastest = bath.drag.rate(v).max(bath.drag.rate(free).sqrt());
        if same_around && bath.linear == 0.0 {
            return Kind::Air(BOBBING_REACH / fastest);
        }
        // The greater eigenvalue of drag's linearisation is 2·s(v); at once it may be as fast as at its terminal velocity.
        let drag = 2.0 * fastest + bath.linear + bath.waves;
        let bobs = bath.stiffness.sqrt();
        let heavy = drag - bobs;
        // The stability of an explicit step ends at a rate × time of 3.3 where it is damped.
        Kind::Neither { heavy, rate: drag + bobs, most: (BOBBING_REACH / bobs).min(2.5 / drag) }
    }

    /// One step of at most `h` of the `left` seconds.
    fn take(&self, place: &Place, pose: Pose, h: f64, left: f64) -> Course {
        let (regime, bath, constant, free) = (&self.regime, &place.bath, place.constant, place.free());
        match self.kind(place, pose.1) {
            Kind::Settled(velocity) => take_exact(regime, pose, left, |t| (pose.0 + velocity * t, velocity)),
            Kind::Air(longest) => take_exact(regime, pose, left.min(longest), |t| fly_through(pose, free, &bath.drag, t)),
            Kind::Neither { rate, most, heavy } => {
                let implicit = heavy * h.min(left) > HEAVY_REACH && is_even(bath.acceleration(constant, pose.1), pose.1, heavy);
                let slopes = implicit.then(|| regime.slopes(pose.0, pose.1));
                let steps = Steps { regime, bath, constant, slopes, rough: if self.rough { 1e-3 } else { 0.0 } };
                let first = if implicit || h.is_finite() { h } else { steps.first(pose.1, rate, left) };
                let most = if implicit { left } else { most.min(left) };
                steps.take(pose, first.min(most), left).unwrap_or_else(|shortest| {
                    let end = self.clone().leap(pose, shortest);
                    Course { time: shortest, end, next: shortest, pull: None }
                })
            }
        }
    }
}

/// A step of at most `h` by an exact flow.
fn take_exact(regime: &Regime, pose: Pose, mut h: f64, flow: impl Fn(f64) -> Pose) -> Course {
    let mut end = flow(h);
    for _ in 0..8 {
        let way = Cubic::hermite(pose.0, pose.1, end.0, end.1, h);
        let Some(kink) = regime.displaced.end_of(&way, h).filter(|kink| *kink < h) else { break };
        h = kink.max(h * f64::EPSILON);
        end = flow(h);
        if regime.displaced.all_but_holds(end.0) {
            break;
        }
    }
    Course { time: h, end, next: f64::INFINITY, pull: None }
}

/// Whether a body, accelerated by `pull`, has come to the speed that its place gives it in a law of that rate, 1/s, but for a tenth.
fn is_even(pull: DVec2, v: DVec2, rate: f64) -> bool {
    pull.length() < 0.1 * rate * v.length()
}

/// The terminal velocity in one medium all around, if `v` has reached it; `free` is the acceleration besides drag, m/s².
fn settled(bath: &Bath, free: DVec2, v: DVec2) -> Option<DVec2> {
    // Along the pull, u = λ·A with λ²·s(A) + λ·c = 1.
    let root = (bath.linear * bath.linear + 4.0 * bath.drag.rate(free)).sqrt();
    if bath.linear + root == 0.0 {
        return None;
    }
    let terminal = free * (2.0 / (bath.linear + root));
    ((v - terminal).length() <= TERMINAL_TOLERANCE * terminal.length()).then_some(terminal)
}
