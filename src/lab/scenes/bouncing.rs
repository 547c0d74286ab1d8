//! Bouncing on a floor from H = 1 m. Exact, with t₀ = √(2H/g): the n-th apex at H·e^(2n), all bounces over at t₀(1+e)/(1−e).
//! Sliding to a stop on a floor. Exact: d = v₀²/2μg.

use crate::lab::contract::{By, Model};
use crate::lab::curve::{CoursePoint, sampled, worst};
use crate::lab::methods::bounce::{
    Ball, Bounce, SlideStep, Slider, by_sign, clamped, energy, every_tick, exact, exact_stop, reflect, snap, swept, verlet_snap,
};
use crate::lab::{LabScene, SceneMethod, contract};
use crate::physics::{BodyDef, BodyId, DVec2, Material, World};

/// N/kg.
pub const G: f64 = 9.81;
/// m.
pub const HEIGHT: f64 = 1.0;
pub const LOSSY: f64 = 0.9;
/// Apexes that are compared.
pub const APEXES: usize = 10;
/// s. After this time the lossy ball has made its ten bounces and is not yet at rest.
const LOSSY_SECONDS: f64 = 6.0;
/// s.
const PERFECT_SECONDS: f64 = 60.0;
/// Energies up to this times the largest at the end are the same jitter.
const JITTER: f64 = 2.0;
/// J/kg. Less than this counts as rest.
const REST: f64 = 1e-12;

pub const METHODS: [(&str, Bounce); 6] = [
    ("snap to the floor", snap),
    ("reflect", reflect),
    ("Verlet and snap", verlet_snap),
    ("restitution every tick", every_tick),
    ("swept, rest of tick lost", swept),
    ("exact time of impact", exact),
];

/// A ball, or a box, that falls onto a floor.
#[derive(Clone, Copy, Debug)]
pub struct BouncingBall {
    /// m.
    pub height: f64,
    pub e: f64,
    /// m/s. Slower impacts of the engine do not bounce.
    pub rest_speed: f64,
}

impl Model for BouncingBall {
    type State = Ball;
    type Method = Bounce;

    fn start(&self) -> Ball {
        (self.height, 0.0)
    }

    fn step(&self, method: Bounce, ball: &mut Ball, h: f64) {
        *ball = method(*ball, G, self.e, h);
    }

    fn world(&self) -> Option<World> {
        let body = BodyDef { restitution: self.e, ..contract::crate_at(0.0, self.height, 1.0) };
        World::new(contract::on_floor(G, self.rest_speed, vec![body])).ok()
    }

    fn read(&self, world: &World, _: f64, ball: &mut Ball) {
        let body = world.body(BodyId(0));
        *ball = (-0.5 - body.position.y, -body.velocity.y);
    }
}

impl BouncingBall {
    /// From 1 m, every bounce kept.
    pub fn of(e: f64) -> Self {
        Self { height: HEIGHT, e, rest_speed: 0.0 }
    }

    pub fn path(self, by: By<Bounce>, seconds: f64, h: f64) -> impl Iterator<Item = (f64, Ball)> {
        self.running(by, h).each(seconds, |time, ball| (time, *ball))
    }

    /// Height of a ball that loses nothing after `t` s, m: from floor to floor it takes twice the fall.
    pub fn height_at(&self, t: f64) -> f64 {
        let fall = (2.0 * self.height / G).sqrt();
        let since = (t + fall) % (2.0 * fall);
        G * since * (fall - 0.5 * since)
    }
}

/// Energy at the end over that at the start.
pub fn energy_kept(by: By<Bounce>, seconds: f64, h: f64) -> f64 {
    BouncingBall::of(1.0).end(by, seconds, h).map_or(f64::NAN, |ball| energy(ball, G)) / (G * HEIGHT)
}

/// The first apexes: the height that the energy reaches where the ball turns, so that no step needs to end there.
fn apex_heights(balls: impl Iterator<Item = (f64, Ball)>) -> Vec<f64> {
    let mut rising = false;
    let turns = balls.filter(|(_, ball)| {
        let turned = rising && ball.1 <= 0.0;
        rising = ball.1 > 0.0;
        turned
    });
    turns.map(|(_, ball)| energy(ball, G) / G).take(APEXES).collect()
}

/// The end of the bouncing, s: after it the ball has no more energy than at the very end, which is none or the method's jitter.
pub fn bounces_until(balls: impl Iterator<Item = (f64, Ball)>) -> f64 {
    let energies: Vec<(f64, f64)> = balls.map(|(t, ball)| (t, energy(ball, G))).collect();
    let end = energies.len() - energies.len() / 10;
    let kept = energies[end..].iter().map(|(_, energy)| *energy).fold(REST, f64::max);
    energies.iter().rev().find(|(_, energy)| *energy > JITTER * kept).map_or(0.0, |(t, _)| *t)
}

pub fn series_end(e: f64) -> f64 {
    (2.0 * HEIGHT / G).sqrt() * (1.0 + e) / (1.0 - e)
}

/// How high a ball of restitution `e` below 1 reaches in the flight that it is in after `t` seconds, m: 0 once the series is over.
pub fn lossy_apex_at(e: f64, t: f64) -> f64 {
    let fall = (2.0 * HEIGHT / G).sqrt();
    if t < fall {
        return HEIGHT;
    }
    if t >= series_end(e) {
        return 0.0;
    }
    // Each flight takes e times as long as the one before; the first, 2·e·fall.
    let (mut since, mut flight) = (t - fall, 2.0 * e * fall);
    while since > flight {
        since -= flight;
        flight *= e;
    }
    G * flight * flight / 8.0
}

/// For a minute without loss. A height alone would forgive a ball that is late, so the error is that of the place at all steps.
pub fn perfect() -> LabScene {
    let ball = BouncingBall::of(1.0);
    let error = move |t: f64, height: f64| (height - ball.height_at(t)).abs();
    let moment = move |time: f64, at: &Ball| {
        let energy = Some(energy(*at, G) / (G * HEIGHT));
        CoursePoint { time, error: error(time, at.0), energy }
    };
    let worst = move |by, h| worst(ball.running(by, h).each(PERFECT_SECONDS, |t, at| error(t, at.0)));
    let course = move |by, h| sampled(ball.running(by, h).each(PERFECT_SECONDS, moment));
    LabScene {
        error: "worst error of the place at any time, m",
        world: ball.world(),
        methods: SceneMethod::all_showing(METHODS, worst, course),
        ..LabScene::new("bounce-perfect", "Perfect bouncing (e = 1) for 60 s", PERFECT_SECONDS, 1)
    }
}

/// The worst of the first ten apexes, m; the whole height where there are fewer.
fn apexes_error(found: &[f64]) -> f64 {
    if found.len() < APEXES {
        return HEIGHT;
    }
    let exact = std::iter::successors(Some(HEIGHT * LOSSY * LOSSY), |height| Some(height * LOSSY * LOSSY));
    found.iter().zip(exact).map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max)
}

pub fn apexes() -> LabScene {
    let ball = BouncingBall::of(LOSSY);
    let methods = SceneMethod::all(METHODS, move |by, h| apexes_error(&apex_heights(ball.path(by, LOSSY_SECONDS, h))));
    let scene = LabScene::new("bounce-apexes", "Ten bounces at restitution 0.9", LOSSY_SECONDS, 1);
    LabScene { error: "worst error of the first ten apexes, m", methods, world: ball.world(), ..scene }
}

/// N/kg.
const SLIDE_GRAVITY: f64 = 15.0;
/// m/s.
const SPEED: f64 = 10.0;
/// s.
const SLIDE_SECONDS: f64 = 10.0;

pub const SLIDE_METHODS: [(&str, SlideStep); 3] =
    [("friction by sign", by_sign), ("friction clamped", clamped), ("exact stop", exact_stop)];

/// A box at 10 m/s on asphalt.
#[derive(Clone, Copy, Debug)]
pub struct SlidingBox {
    /// N/kg.
    pub gravity: f64,
}

impl SlidingBox {
    /// Deceleration, m/s².
    pub fn brake(&self) -> f64 {
        Material::ASPHALT.kinetic_friction * self.gravity
    }

    /// The place of the stop, m.
    pub fn stop(&self) -> f64 {
        SPEED * SPEED / (2.0 * self.brake())
    }

    /// The time of the stop, s.
    pub fn stops_after(&self) -> f64 {
        SPEED / self.brake()
    }
}

impl Model for SlidingBox {
    type State = Slider;
    type Method = SlideStep;

    fn start(&self) -> Slider {
        (0.0, SPEED)
    }

    fn step(&self, method: SlideStep, slider: &mut Slider, h: f64) {
        *slider = method(*slider, self.brake(), h);
    }

    fn world(&self) -> Option<World> {
        let body = BodyDef { velocity: DVec2::new(SPEED, 0.0), ..contract::crate_at(0.0, 0.0, 1.0) };
        World::new(contract::on_floor(self.gravity, 1.0, vec![body])).ok()
    }

    fn read(&self, world: &World, _: f64, slider: &mut Slider) {
        let body = world.body(BodyId(0));
        *slider = (body.position.x, body.velocity.x);
    }
}

/// From 10 m/s on asphalt: 5.13 m.
pub fn to_a_stop() -> LabScene {
    let sliding = SlidingBox { gravity: SLIDE_GRAVITY };
    let error = move |by, h| sliding.end(by, SLIDE_SECONDS, h).map_or(f64::NAN, |(x, _)| (x - sliding.stop()).abs());
    let methods = SceneMethod::all(SLIDE_METHODS, error);
    LabScene { methods, world: sliding.world(), ..LabScene::new("slide", "Sliding 5.13 m to a stop, 10 s", SLIDE_SECONDS, 1) }
}
