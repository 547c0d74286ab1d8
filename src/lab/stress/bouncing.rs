//! Where floors fail: jitter at rest, stops that are short or never come, bounces that end too early or never, energy from nothing.

use super::picture::Picture;
use super::{G, TICK, Test};
use crate::lab::methods::bounce::{Ball, Bounce, energy, event_loop, impact_times};
use crate::lab::methods::friction::{self, Slide, Slider, by_sign, clamped};
use crate::lab::scenes::bouncing::{self, METHODS, bounces_until, by_engine, by_hand, energy_kept, lossy_apex_at, series_end};
use crate::lab::{TOLERANCE, shipped};
use crate::physics::{BodyDef, DVec2, Material};

/// s.
const RESTING: f64 = 5.0;
/// Ticks of them that a picture shows.
const JITTERS: usize = 30;
/// s.
const MINUTE: f64 = 60.0;
/// Relative: how right the end of the bounces and the energy have to be.
const RIGHT: f64 = 0.01;
/// m/s. Where the slides begin.
const SLIDE: f64 = 10.0;
/// Impacts after which an event loop counts as endless.
pub const ENDLESS: u32 = 1_000_000;

/// The velocities (m/s) after each tick of a ball that was put on the floor, by hand.
fn laid(bounce: Bounce, e: f64) -> Vec<f64> {
    let mut ball = (0.0, 0.0);
    let after_step = |_| {
        ball = bounce(ball, G, e, TICK);
        ball.1
    };
    (0..(RESTING / TICK) as u32).map(after_step).collect()
}

/// The same by the shipped engine.
fn shipped_laid(e: f64) -> Vec<f64> {
    let body = BodyDef { restitution: e, ..shipped::crate_at(0.0, 0.0, 1.0) };
    let bodies = shipped::places(shipped::on_floor(G, 1.0, vec![body]), (RESTING / TICK) as usize, TICK);
    bodies.into_iter().map(|bodies| -bodies[0].v.y).collect()
}

/// The speed (m/s) that is left on it, by hand.
pub fn jitter(bounce: Bounce, e: f64) -> f64 {
    laid(bounce, e).last().map_or(f64::NAN, |v| v.abs())
}

/// The same by the shipped engine.
pub fn shipped_jitter(e: f64) -> f64 {
    shipped_laid(e).last().map_or(f64::NAN, |v| v.abs())
}

/// Rest is exact, whatever the restitution.
pub fn resting_jitter() -> Test {
    let picture = |velocities: Vec<f64>| {
        let last = velocities.len().saturating_sub(JITTERS);
        let line = velocities.into_iter().enumerate().skip(last).map(|(i, v)| ((i + 1) as f64 * TICK, v));
        Picture::of("time, s", "velocity, m/s").found(line).within(0.0, 0.0)
    };
    let mut test = Test::of("rest without jitter", "restitution e, at h = 1/60 s", (0.01, 1.0));
    for (name, bounce) in METHODS {
        test = test.method(name, move |e| jitter(bounce, e) == 0.0).drawn(move |e| picture(laid(bounce, e)));
    }
    test.shipped(|e| shipped_jitter(e) == 0.0).drawn(move |e| picture(shipped_laid(e)))
}

/// Deceleration on Asphalt, m/s².
pub fn brake() -> f64 {
    Material::ASPHALT.kinetic_friction * G
}

/// Where a slide from 10 m/s is after each step, and how fast, for 5 s, by hand.
fn slides(slide: Slide, h: f64) -> impl Iterator<Item = Slider> {
    let mut slider = (0.0, SLIDE);
    (0..(RESTING / h).round() as u64).map(move |_| {
        slider = slide(slider, brake(), h);
        slider
    })
}

/// The same by the shipped engine.
fn shipped_slides(h: f64) -> impl Iterator<Item = Slider> {
    let body = BodyDef { velocity: DVec2::new(SLIDE, 0.0), ..shipped::crate_at(0.0, 0.0, 1.0) };
    let bodies = shipped::places(shipped::on_floor(G, 1.0, vec![body]), (RESTING / h).round() as usize, h);
    bodies.into_iter().map(|bodies| (bodies[0].x.x, bodies[0].v.x))
}

/// Where it ends, and how fast it still is then, by hand.
pub fn slide(slide: Slide, h: f64) -> (f64, f64) {
    slides(slide, h).last().unwrap_or((f64::NAN, f64::NAN))
}

/// The same by the shipped engine.
pub fn shipped_slide(h: f64) -> (f64, f64) {
    shipped_slides(h).last().unwrap_or((f64::NAN, f64::NAN))
}

/// Where a slide ends, m.
fn stop() -> f64 {
    SLIDE * SLIDE / (2.0 * brake())
}

/// The places about the stop.
fn stopping(h: f64, sliders: impl Iterator<Item = Slider>) -> Picture {
    let (from, to) = about_the_stop(h);
    let line = sliders.enumerate().map(|(i, (x, _))| ((i + 1) as f64 * h, x - stop())).skip_while(|(t, _)| *t < from);
    let picture = Picture::of("time, s", "place beyond the stop, m").found(line.take_while(|(t, _)| *t <= to));
    picture.within(0.0, TOLERANCE)
}

/// From and to when a picture shows it, s.
fn about_the_stop(h: f64) -> (f64, f64) {
    let stops = SLIDE / brake();
    (stops - (12.0 * h).max(0.1), stops + (12.0 * h).max(0.1))
}

/// The velocities about the stop, in units of what friction takes in a step.
fn chattering(h: f64) -> Picture {
    let first = ((SLIDE / brake() / h) as usize).saturating_sub(8);
    let line = slides(by_sign, h).enumerate().skip(first).take(24);
    let line = line.map(|(i, (_, v))| ((i + 1 - first) as f64, v / (brake() * h)));
    Picture::of("steps about the stop", "velocity / friction's in a step").found(line).within(0.0, 0.0)
}

/// Stops dead at v₀²/2μg, within a tenth of a pixel.
pub fn coulomb_stop() -> Test {
    let right = |(x, v): (f64, f64)| v == 0.0 && (x - stop()).abs() <= TOLERANCE;
    Test::of("a slide stops dead, and in the right place", "step h, s", (1e-5, 0.5))
        .method("friction by sign", move |h| right(slide(by_sign, h)))
        .drawn(chattering)
        .method("friction clamped", move |h| right(slide(clamped, h)))
        .drawn(|h| stopping(h, slides(clamped, h)))
        .method("exact stop", move |h| right(slide(friction::exact, h)))
        .drawn(|h| stopping(h, slides(friction::exact, h)))
        .shipped(move |h| right(shipped_slide(h)))
        .drawn(|h| stopping(h, shipped_slides(h)))
}

/// When all bounces from 1 m are over, by hand, at 60 Hz, s.
pub fn end_by_hand(bounce: Bounce, e: f64) -> f64 {
    bounces_until(by_hand(bounce, e, 1.2 * series_end(e), TICK))
}

/// The same by the shipped engine.
pub fn end_by_engine(e: f64) -> f64 {
    bounces_until(by_engine(e, 1.2 * series_end(e), TICK))
}

/// The height that is left to a ball at the end of the series of its bounces: the second half of their time, and a fifth more.
fn ending(e: f64, balls: impl Iterator<Item = (f64, Ball)>) -> Picture {
    let (end, fall) = (series_end(e), (2.0 * bouncing::HEIGHT / G).sqrt());
    let from = 0.5 * (end + fall);
    let line = balls.map(|(t, ball)| (t, energy(ball, G) / G)).skip_while(|(t, _)| *t < from);
    let exact = (0..=150).map(|i| from + (1.2 * end - from) * f64::from(i) / 150.0).map(|t| (t, lossy_apex_at(e, t)));
    Picture::of("time, s", "height that is left, m").found(line).exact(exact)
}

/// Infinitely many bounces in a finite time, up to e = 0.98.
pub fn zeno() -> Test {
    let right = |e: f64, end: f64| (end - series_end(e)).abs() <= RIGHT * series_end(e) + TICK;
    let mut test = Test::of("endless bounces end when the series does", "restitution e, at h = 1/60 s", (0.1, 0.98))
        .method("event loop alone", |e| event_loop((bouncing::HEIGHT, 0.0), G, e, 1.2 * series_end(e), ENDLESS) < ENDLESS)
        .drawn(|e| {
            let times = impact_times((bouncing::HEIGHT, 0.0), G, e).take(60).enumerate();
            let line = times.map(|(i, t)| ((i + 1) as f64, t / series_end(e)));
            Picture::of("impacts", "time / end of the series").found(line).exact([(1.0, 1.0), (60.0, 1.2)])
        });
    for (name, bounce) in METHODS {
        test = test.method(name, move |e| right(e, end_by_hand(bounce, e)));
        test = test.drawn(move |e| ending(e, by_hand(bounce, e, 1.2 * series_end(e), TICK)));
    }
    test.shipped(move |e| right(e, end_by_engine(e))).drawn(|e| ending(e, by_engine(e, 1.2 * series_end(e), TICK)))
}

/// E/E₀ after a minute of perfect bouncing from 1 m, by hand.
pub fn minute_by_hand(bounce: Bounce, h: f64) -> f64 {
    energy_kept(by_hand(bounce, 1.0, MINUTE, h))
}

/// The same by the shipped engine.
pub fn minute_by_engine(h: f64) -> f64 {
    energy_kept(by_engine(1.0, MINUTE, h))
}

/// Keeps its energy to 1 % for a minute.
pub fn minute_of_bounces() -> Test {
    let right = |kept: f64| (kept - 1.0).abs() <= RIGHT;
    let picture = |balls: &mut dyn Iterator<Item = (f64, Ball)>| {
        let line = balls.map(|(t, ball)| (t, energy(ball, G) / (G * bouncing::HEIGHT)));
        Picture::of("time, s", "energy / first one").found(line).within(1.0, RIGHT)
    };
    let mut test = Test::of("perfect bouncing for 60 s keeps its energy to 1 %", "step h, s", (1e-4, 0.5));
    for (name, bounce) in METHODS {
        test = test.method(name, move |h| right(minute_by_hand(bounce, h)));
        test = test.drawn(move |h| picture(&mut by_hand(bounce, 1.0, MINUTE, h)));
    }
    test.shipped(move |h| right(minute_by_engine(h))).drawn(move |h| picture(&mut by_engine(1.0, MINUTE, h)))
}
