//! One body near or in a liquid, without contacts: as through denser air in one medium all around without Stokes' drag, else by steps; then at rest.

use crate::physics::data::{BOBBING_REACH, Body, Cubic, HEAVY_REACH, Pose, TERMINAL_TOLERANCE};
use crate::physics::flight::air::fly_through;
use crate::physics::flight::steps::{Bob, Bobs, Course, Step, Steps};
use crate::physics::forces::{Bath, Law, Media, Regime, liquid::Vertical};
use glam::DVec2;

#[derive(Clone)]
struct Swimmer<'a> {
    regime: Regime<'a>,
    law: &'a Law,
}

/// The media at a place, and the accelerations there: the constant one, and that with buoyancy, m/s².
struct Surroundings {
    bath: Bath,
    constant: DVec2,
    free: DVec2,
    /// Whether a liquid bears its weight: the vertical accelerations then balance exactly.
    floats: bool,
}

enum FlightKind {
    /// By its terminal velocity, m/s.
    Settled(DVec2),
    /// By flight through one medium all around, for this many seconds at once.
    Air(f64),
    /// By steps: the rates of drag and of bobbing, 1/s.
    Neither { drag: f64, bobs: f64 },
}

pub(crate) fn flow(media: &Media, body: &Body, law: &Law, t: f64) -> Pose {
    flow_through(media, body, law, t).end
}

pub(crate) fn flow_through(media: &Media, body: &Body, law: &Law, t: f64) -> Course {
    flow_while(media, body, law, t, |_, _| true)
}

/// The same up to the last step through a liquid for which `goes_on` holds at its time and end, or to the end of the first step.
pub(crate) fn flow_while(media: &Media, body: &Body, law: &Law, t: f64, goes_on: impl FnMut(f64, Pose) -> bool) -> Course {
    if law.is_near_liquid() {
        return Swimmer::begin(media, body, law).swim(t, goes_on);
    }
    let end = fly_through((body.position, body.velocity), law.constant, &law.air, t);
    Course { end, time: t, next: f64::INFINITY, pull: None }
}

/// The same of bodies near liquids. Those that bob straight up and down take their steps side by side, to the same bits.
pub(crate) fn flow_side_by_side(media: &Media, of: &[u32], all: (&[Body], &[Law]), t: f64, mut out: impl FnMut(u32, Course)) {
    let mut bobs = Bobs::default();
    for of in of.chunks(4) {
        let of = of.iter().map(|i| (*i, &all.0[*i as usize], &all.1[*i as usize])).enumerate();
        let mut bob = [false; 4];
        for (k, (_, body, law)) in of.clone() {
            if let Some(set) = bobs_by(media, body, law, t) {
                bobs.set(k, set);
                bob[k] = true;
            }
        }
        let steps = if bob.contains(&true) { bobs.step(t) } else { [Step::default(); 4] };
        for (k, (i, body, law)) in of {
            if bob[k] && bobs.of[k].is_done_by(&steps[k], &law.displaced, t) {
                out(i, Course { end: steps[k].end, time: t, next: t, pull: Some(steps[k].pull) });
            } else {
                out(i, Swimmer::begin(media, body, law).swim(t, |_, _| true));
            }
        }
    }
}

/// The vertical motion of a body in one surface, if it has one that one step of `t` seconds may resolve.
#[inline(always)]
fn bobs_by(media: &Media, body: &Body, law: &Law, t: f64) -> Option<(Bob, Vertical)> {
    let (x, v) = (body.position, body.velocity);
    if v.y == 0.0 || law.rough || !law.displaced.holds(x) {
        return None;
    }
    let (vertical, bath) = law.around(media, body).vertical(law.constant, x, v)?;
    let drag = rate_of_drag(&bath, DVec2::new(law.constant.x, law.constant.y - bath.lift), v);
    let bobs = bath.stiffness.sqrt();
    let slow = 16.0 * bath.rounding(law.constant, body, x.y) / bobs;
    let bob = Bob { x, v: v.y, pull: bath.acceleration(law.constant, v).y, slow };
    is_slow(drag + bobs, t).then_some((bob, vertical))
}

impl<'a> Swimmer<'a> {
    #[inline(always)]
    fn begin(media: &'a Media, body: &'a Body, law: &'a Law) -> Self {
        Self { regime: law.regime(media, body, body.position), law }
    }

    /// Its course for `t` seconds, or to the end of the last step (at least one) at which `goes_on` holds.
    fn swim(&mut self, t: f64, mut goes_on: impl FnMut(f64, Pose) -> bool) -> Course {
        let (media, body, law) = (self.regime.media, self.regime.body, self.law);
        let mut pose = (body.position, body.velocity);
        let (mut left, mut h) = (t, if law.first > 0.0 { law.first } else { f64::INFINITY });
        let (mut pull, mut bobs) = (None, true);
        for _ in 0..self.most_steps(pose, t) {
            if left <= 0.0 {
                break;
            }
            self.regime.follow(pose.0);
            let place = self.look(pose);
            if place.floats && pose.1.x == 0.0 && place.constant.x == 0.0 {
                return Course { end: pose, time: t, next: h, pull: None };
            }
            let taken = self.take(&place, pose, h, left);
            let (before, begun, last) = (pose, left, pull);
            (pose, pull) = (taken.end, taken.pull);
            bobs = true;
            if place.floats {
                (pose.0.y, pose.1.y) = (before.0.y, 0.0);
            } else if self.regime.displaced.holds(pose.0) {
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
            h = if left <= 0.0 && h.is_finite() { taken.next.max(h) } else { taken.next };
        }
        if left > 0.0 {
            if !law.rough {
                media.end_early();
            }
            (pose, pull, bobs) = (self.leap(pose, left), None, true);
        }
        if bobs {
            self.come_to_rest(&mut pose);
        }
        let pull = pull.filter(|_| pose.1.y != 0.0);
        Course { end: pose, time: t, next: h, pull }
    }

    fn look(&self, (x, v): Pose) -> Surroundings {
        let (mut bath, mut constant) = (self.regime.bath(x), self.regime.constant);
        let floats = v.y == 0.0 && self.regime.balances(&bath, x, constant.y - bath.lift);
        if floats {
            constant.y = bath.lift;
            (bath.stiffness, bath.waves) = (0.0, 0.0);
        }
        Surroundings { bath, constant, free: DVec2::new(constant.x, constant.y - bath.lift), floats }
    }

    /// The most steps of `t` seconds; [`Swimmer::leap`] leads through the rest, or at once where a rough course soon has the speed of its place.
    fn most_steps(&self, pose: Pose, t: f64) -> u32 {
        if !self.law.rough {
            return 128;
        }
        let reach = match self.kind(&self.look(pose), pose.1) {
            FlightKind::Settled(_) => 0.0,
            FlightKind::Air(longest) => t / longest,
            FlightKind::Neither { drag, bobs } => (drag - bobs) * t,
        };
        if reach > 20.0 { 0 } else { 8 }
    }

    fn come_to_rest(&mut self, (x, v): &mut Pose) {
        let bath = self.regime.follow(*x).bath(*x);
        let (constant, damped) = (self.regime.constant, bath.stiffness > 0.0 && bath.linear + bath.waves > 0.0);
        let rounding = bath.rounding(constant, self.regime.body, x.y);
        if damped && v.y.abs() * bath.stiffness.sqrt() <= rounding && (constant.y - bath.lift).abs() <= rounding {
            v.y = 0.0;
        }
    }

    /// One implicit Euler step of `h` seconds: liquids lift more with the depth, so it gains no energy, and no speed but from constant forces.
    fn leap(&mut self, (x, v): Pose, h: f64) -> Pose {
        let constant = self.regime.constant;
        let bath = self.regime.follow(x).bath(x);
        let across = (v.x + h * constant.x) / (1.0 + h * (bath.drag.rate(v) + bath.linear));
        let beside = x.x + h * across;
        let tolerance = if self.law.rough { 1e-4 } else { 1e-13 };
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
            // Across kinks Newton's method may lead to and fro: after four trials every other one halves the bracket.
            let next = if guess > low && guess < high && (trial < 4 || trial % 2 == 0) { guess } else { 0.5 * (low + high) };
            found = (next - down).abs() <= tolerance * down.abs();
            down = next;
            if found {
                break;
            }
        }
        if !found {
            down = if low.abs() < high.abs() { low } else { high };
        }
        (DVec2::new(beside, x.y + h * down), DVec2::new(across, down))
    }

    fn kind(&self, place: &Surroundings, v: DVec2) -> FlightKind {
        let (bath, free) = (&place.bath, place.free);
        let same_around = self.regime.displaced.is_same_around();
        if same_around && let Some(velocity) = settled(bath, free, v) {
            return FlightKind::Settled(velocity);
        }
        if same_around && bath.linear == 0.0 {
            return FlightKind::Air(BOBBING_REACH / fastest(bath, free, v));
        }
        FlightKind::Neither { drag: rate_of_drag(bath, free, v), bobs: bath.stiffness.sqrt() }
    }

    /// One step of at most `h` of the `left` seconds.
    fn take(&self, place: &Surroundings, pose: Pose, h: f64, left: f64) -> Course {
        let (regime, bath, constant, free) = (&self.regime, &place.bath, place.constant, place.free);
        match self.kind(place, pose.1) {
            FlightKind::Settled(velocity) => take_exact(regime, pose, left, |t| (pose.0 + velocity * t, velocity)),
            FlightKind::Air(longest) => take_exact(regime, pose, left.min(longest), |t| fly_through(pose, free, &bath.drag, t)),
            FlightKind::Neither { drag, bobs } => {
                let (rate, heavy) = (drag + bobs, drag - bobs);
                // Implicit once it has come to the speed of its place but for a tenth.
                let even = || bath.acceleration(constant, pose.1).length() < 0.1 * heavy * pose.1.length();
                let implicit = heavy * h.min(left) > HEAVY_REACH && even();
                let slopes = implicit.then(|| regime.slopes(pose.0, pose.1));
                let steps = Steps { regime, bath, constant, slopes, rough: if self.law.rough { 1e-3 } else { 0.0 } };
                let longest = match h.is_finite() {
                    _ if implicit => h.min(left),
                    false if is_slow(rate, left) => left,
                    // The stability of an explicit step ends at a rate × time of 3.3 where it is damped.
                    known => {
                        let first = if known { h } else { steps.first(pose.1, rate) };
                        first.min((BOBBING_REACH / bobs).min(2.5 / drag)).min(left)
                    }
                };
                steps.take(pose, longest, left).unwrap_or_else(|shortest| {
                    let end = self.clone().leap(pose, shortest);
                    Course { time: shortest, end, next: shortest, pull: None }
                })
            }
        }
    }
}

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

/// Whether one step may resolve a law of that rate, 1/s, for `t` seconds.
fn is_slow(rate: f64, t: f64) -> bool {
    rate * t < 0.25
}

/// The rate of quadratic drag, 1/s: at once it may be as fast as at its terminal velocity.
fn fastest(bath: &Bath, free: DVec2, v: DVec2) -> f64 {
    bath.drag.rate(v).max(bath.drag.rate(free).sqrt())
}

/// The greater eigenvalue of drag's linearisation, 1/s: of the quadratic one 2·s(v).
fn rate_of_drag(bath: &Bath, free: DVec2, v: DVec2) -> f64 {
    2.0 * fastest(bath, free, v) + bath.linear + bath.waves
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::data::aabb::Aabb;
    use crate::physics::data::body::BodyDef;
    use crate::physics::data::def::{FluidDef, WorldDef};
    use glam::DVec2;
    use proptest::prelude::*;
    use proptest::test_runner::FileFailurePersistence;

    fn media(gravity: f64, air_density: f64, fluids: Vec<FluidDef>) -> Media {
        Media::new(gravity, air_density, (&[], &[]), fluids)
    }

    /// A body and its law for one tick, refused or not at the door.
    fn at_the_door(media: &Media, def: &BodyDef, drive: DVec2) -> Option<(Body, Law)> {
        let world = WorldDef {
            gravity: media.gravity,
            air_density: media.air_density,
            fluids: media.fluids.clone(),
            bodies: vec![def.clone()],
            ..WorldDef::default()
        };
        world.check().ok()?;
        let body = Body::new(def);
        let law = media.law(&body, drive, 1e10);
        Some((body, law))
    }

    /// Evenly over the powers of ten.
    fn decades(low: f64, high: f64) -> impl Strategy<Value = f64> {
        (low..high).prop_map(|power| 10f64.powf(power))
    }

    fn signed(low: f64, high: f64) -> impl Strategy<Value = f64> {
        (decades(low, high), -1i8..=1).prop_map(|(size, sign)| size * f64::from(sign))
    }

    prop_compose! {
        /// Anything that is accepted, at up to 10⁶ m/s.
        fn things()(
            mass in decades(-9.0, 12.0), hx in decades(-6.0, 9.0), hy in decades(-6.0, 9.0), drag in prop_oneof![Just(0.0), decades(-6.0, 12.0)],
            round in any::<bool>(), vx in signed(-9.0, 6.0), vy in signed(-9.0, 6.0),
        ) -> BodyDef {
            BodyDef { mass, half: DVec2::new(hx, hy), drag, round, velocity: DVec2::new(vx, vy), ..BodyDef::default() }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            cases: 1000,
            failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions"))),
            ..ProptestConfig::default()
        })]

        /// Drag never reverses a motion, and takes energy only: what is gained, the constant force has done.
        #[test]
        fn drag_of_the_air_only_slows(
            def in things(), air in decades(-6.0, 12.0), gravity in prop_oneof![Just(0.0), signed(-3.0, 6.0)], fx in signed(-3.0, 9.0), t in decades(-6.0, 0.0),
        ) {
            let media = media(gravity, air, Vec::new());
            let drive = if gravity == 0.0 { DVec2::ZERO } else { DVec2::new(fx, 0.0) };
            let Some((body, law)) = at_the_door(&media, &def, drive) else { return Ok(()) };
            let (x, v) = flow(&media, &body, &law, t);
            prop_assert!(x.is_finite() && v.is_finite(), "{x} {v}");
            for axis in 0..2 {
                if law.constant[axis] * def.velocity[axis] >= 0.0 {
                    prop_assert!(v[axis] * def.velocity[axis] >= 0.0, "{v}, from {}", def.velocity);
                }
                if law.constant[axis] == 0.0 {
                    prop_assert!(v[axis].abs() <= def.velocity[axis].abs(), "{v}, from {}", def.velocity);
                }
            }
            let (before, after, work) = (def.velocity.length_squared(), v.length_squared(), 2.0 * law.constant.dot(x));
            prop_assert!(after - before - work <= 1e-8 * (before + work.abs()), "v² {after}, from {before}, work {work}");
        }

        /// In a pool as well, at its surface or under it.
        #[test]
        fn a_liquid_only_slows(
            def in things(), depth in -2.0..3.0f64, density in decades(-3.0, 12.0), viscosity in prop_oneof![Just(0.0), decades(-6.0, 12.0)],
            gravity in prop_oneof![Just(0.0), decades(-3.0, 6.0)], t in decades(-6.0, 0.0),
        ) {
            let zone = Aabb::new(DVec2::new(-1e12, 0.0), DVec2::new(1e12, 1e12));
            let media = media(gravity, 1.2, vec![FluidDef { zone, density, viscosity }]);
            let def = BodyDef { position: DVec2::new(0.0, depth * def.half.y), ..def };
            let Some((body, law)) = at_the_door(&media, &def, DVec2::ZERO) else { return Ok(()) };
            let (x, v) = flow(&media, &body, &law, t);
            prop_assert!(x.is_finite() && v.is_finite(), "{x} {v}");
            prop_assert!(v.x * def.velocity.x >= 0.0 && v.x.abs() <= def.velocity.x.abs() * (1.0 + 1e-9), "{v}, from {}", def.velocity);
            // Twice the potential energy per mass: of the weight, and of the displaced liquid.
            let height = 2.0 * body.half.y;
            let lift = density * gravity * 2.0 * body.half.x / body.mass;
            let potential = |y: f64| {
                let wet = (y + body.half.y).clamp(0.0, height);
                let sunk = (y - body.half.y).max(0.0);
                [-2.0 * gravity * y, lift * (wet * wet + 2.0 * height * sunk)]
            };
            let (from, to) = (potential(def.position.y), potential(x.y));
            let (before, after) = (def.velocity.length_squared(), v.length_squared());
            let scale = before + from[0].abs() + from[1].abs() + to[0].abs() + to[1].abs();
            let gained = after - before + (to[0] - from[0]) + (to[1] - from[1]);
            // And what the rounding of its depth is worth, wherever its energy lets it go.
            let rounding = f64::EPSILON * (def.position.y.abs() + x.y.abs() + height) * (scale * lift).sqrt();
            prop_assert!(gained <= 1e-6 * scale + 64.0 * rounding, "gained {gained} of {scale}: v {v}, from {}", def.velocity);
        }
    }
}
