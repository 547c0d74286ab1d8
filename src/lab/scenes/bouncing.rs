//! Bouncing on a floor from H = 1 m. Exact, with t₀ = √(2H/g): the n-th apex at H·e^(2n), all bounces over at t₀(1+e)/(1−e).

use crate::lab::course::{Moment, sampled, worst};
use crate::lab::methods::bounce::{Ball, Bounce, energy, every_tick, exact, reflect, snap, swept, verlet_snap};
use crate::lab::{Scene, shipped};
use crate::physics::{BodyDef, BodyId, World};

/// N/kg.
pub const G: f64 = 9.81;
/// m.
pub const HEIGHT: f64 = 1.0;
/// The lossy ball's restitution.
pub const LOSSY: f64 = 0.9;
/// Apexes that are compared.
pub const APEXES: usize = 10;
/// s. By then the lossy ball has made its ten bounces and is not yet at rest.
const LOSSY_SECONDS: f64 = 6.0;
/// s.
const PERFECT_SECONDS: f64 = 60.0;
/// Energies up to this times the largest at the end are the same jitter.
const JITTER: f64 = 2.0;
/// J/kg. Less than this counts as rest.
const REST: f64 = 1e-12;

/// The hand-written ways.
pub const METHODS: [(&str, Bounce); 6] = [
    ("snap to the floor", snap),
    ("reflect", reflect),
    ("Verlet and snap", verlet_snap),
    ("restitution every tick", every_tick),
    ("swept, rest of tick lost", swept),
    ("exact time of impact", exact),
];

/// The times after each step and the ball then.
pub fn by_hand(bounce: Bounce, e: f64, seconds: f64, h: f64) -> impl Iterator<Item = (f64, Ball)> {
    let steps = (seconds / h).round() as u64;
    let mut ball = (HEIGHT, 0.0);
    (1..=steps).map(move |step| {
        ball = bounce(ball, G, e, h);
        (step as f64 * h, ball)
    })
}

/// The same with the shipped engine, every bounce kept.
pub fn by_engine(e: f64, seconds: f64, h: f64) -> impl Iterator<Item = (f64, Ball)> {
    let body = BodyDef { restitution: e, ..shipped::crate_at(0.0, HEIGHT, 1.0) };
    let mut world = World::new(shipped::on_floor(G, 0.0, vec![body])).ok();
    let steps = (seconds / h).round() as u64;
    (1..=steps).map(move |step| {
        let ball = world.as_mut().map_or((f64::NAN, f64::NAN), |world| {
            world.step(h);
            let body = world.body(BodyId(0));
            (-0.5 - body.position.y, -body.velocity.y)
        });
        (step as f64 * h, ball)
    })
}

/// Energy at the end over that at the start.
pub fn energy_kept(balls: impl Iterator<Item = (f64, Ball)>) -> f64 {
    balls.last().map_or(f64::NAN, |(_, ball)| energy(ball, G)) / (G * HEIGHT)
}

/// The first apexes: the height that the energy reaches where the ball turns, which needs no tick just there.
pub fn apex_heights(balls: impl Iterator<Item = (f64, Ball)>) -> Vec<f64> {
    let mut rising = false;
    let turns = balls.filter(|(_, ball)| {
        let turned = rising && ball.1 <= 0.0;
        rising = ball.1 > 0.0;
        turned
    });
    turns.map(|(_, ball)| energy(ball, G) / G).take(APEXES).collect()
}

/// When the bouncing was over, s: from then on the ball has no more energy than at the very end, which is none, or the jitter that the
/// method keeps for ever.
pub fn bounces_until(balls: impl Iterator<Item = (f64, Ball)>) -> f64 {
    let energies: Vec<(f64, f64)> = balls.map(|(t, ball)| (t, energy(ball, G))).collect();
    let end = energies.len() - energies.len() / 10;
    let kept = energies[end..].iter().map(|(_, energy)| *energy).fold(REST, f64::max);
    energies.iter().rev().find(|(_, energy)| *energy > JITTER * kept).map_or(0.0, |(t, _)| *t)
}

/// When all bounces are over, s.
pub fn series_end(e: f64) -> f64 {
    (2.0 * HEIGHT / G).sqrt() * (1.0 + e) / (1.0 - e)
}

/// Where a ball that loses nothing is after `t` seconds: from floor to floor it takes twice the fall.
pub fn height_at(t: f64) -> f64 {
    let fall = (2.0 * HEIGHT / G).sqrt();
    let since = (t + fall) % (2.0 * fall);
    G * since * (fall - 0.5 * since)
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

/// How far a ball that loses nothing is from its place at the worst of all steps, m. A height alone would forgive one that is late.
pub fn worst_place(balls: impl Iterator<Item = (f64, Ball)>) -> f64 {
    worst(balls.map(|(t, ball)| (ball.0 - height_at(t)).abs()))
}

fn moments(balls: impl Iterator<Item = (f64, Ball)>) -> Vec<Moment> {
    let full = G * HEIGHT;
    sampled(balls.map(|(time, ball)| {
        let energy = Some(energy(ball, G) / full);
        Moment { time, error: (ball.0 - height_at(time)).abs(), energy }
    }))
}

/// For a minute without loss.
pub fn perfect() -> Scene {
    let mut scene = Scene::new("bounce-perfect", "Perfect bouncing (e = 1) for 60 s", PERFECT_SECONDS, 1)
        .measuring("worst error of the place at any time, m");
    for (name, bounce) in METHODS {
        scene = scene
            .method(name, move |h| worst_place(by_hand(bounce, 1.0, PERFECT_SECONDS, h)))
            .over_time(move |h| moments(by_hand(bounce, 1.0, PERFECT_SECONDS, h)));
    }
    scene
        .shipped(move |h| worst_place(by_engine(1.0, PERFECT_SECONDS, h)))
        .over_time(move |h| moments(by_engine(1.0, PERFECT_SECONDS, h)))
}

/// The worst of the first ten apexes, m; the whole height where there are fewer.
pub fn apexes_error(found: &[f64]) -> f64 {
    if found.len() < APEXES {
        return HEIGHT;
    }
    let exact = std::iter::successors(Some(HEIGHT * LOSSY * LOSSY), |height| Some(height * LOSSY * LOSSY));
    found.iter().zip(exact).map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max)
}

/// Ten bounces at e = 0.9.
pub fn apexes() -> Scene {
    let mut scene = Scene::new("bounce-apexes", "Ten bounces at restitution 0.9", LOSSY_SECONDS, 1)
        .measuring("worst error of the first ten apexes, m");
    for (name, bounce) in METHODS {
        scene = scene.method(name, move |h| apexes_error(&apex_heights(by_hand(bounce, LOSSY, LOSSY_SECONDS, h))));
    }
    scene.shipped(move |h| apexes_error(&apex_heights(by_engine(LOSSY, LOSSY_SECONDS, h))))
}
