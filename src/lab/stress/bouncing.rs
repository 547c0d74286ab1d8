//! Floors fail by jitter at rest, stops that are short or never come, bounces that end too early or never, energy from nothing.

use super::picture::FailurePicture;
use super::{G, StressTest, Trial};
use crate::lab::contract::{By, Model};
use crate::lab::methods::bounce::{Ball, Bounce, energy, event_loop, impact_times};
use crate::lab::methods::slide::{SlideStep, Slider, by_sign};
use crate::lab::scenes::bouncing::{self, BouncingBall, METHODS, bounces_until, energy_kept, lossy_apex_at, series_end};
use crate::lab::scenes::sliding::{self, SlidingBox};
use crate::lab::{TICK, TOLERANCE};

/// s.
const RESTING: f64 = 5.0;
/// Ticks in a picture.
const JITTERS: usize = 30;
/// s.
const MINUTE: f64 = 60.0;
/// Relative tolerance of the end of the bounces and of the energy.
const RIGHT: f64 = 0.01;
pub const SLIDING: SlidingBox = SlidingBox { gravity: G };
/// Impacts after which an event loop counts as endless.
pub const ENDLESS: u32 = 1_000_000;

fn laid(e: f64) -> BouncingBall {
    BouncingBall { height: 0.0, e, rest_speed: 1.0 }
}

/// The speed (m/s) that remains.
pub fn jitter(by: By<Bounce>, e: f64) -> f64 {
    laid(e).end(by, RESTING, TICK).map_or(f64::NAN, |(_, v)| v.abs())
}

/// Rest is exact at every restitution.
pub fn resting_jitter() -> StressTest {
    let picture = |by: By<Bounce>, e: f64| {
        let velocities: Vec<(f64, f64)> = laid(e).running(by, TICK).each(RESTING, |t, ball| (t, ball.1)).collect();
        let last = velocities.len().saturating_sub(JITTERS);
        FailurePicture::of("time, s", "velocity, m/s").found(velocities.into_iter().skip(last)).within(0.0, 0.0)
    };
    let methods = Trial::all_showing(METHODS, |by, e| jitter(by, e) == 0.0, picture);
    StressTest::of("rest without jitter", "restitution e, at h = 1/60 s", (0.01, 1.0), methods)
}

/// The time after each step, place and velocity of a slide of 5 s.
fn slides(by: By<SlideStep>, h: f64) -> impl Iterator<Item = (f64, Slider)> {
    SLIDING.running(by, h).each(RESTING, |t, slider| (t, *slider))
}

/// m and m/s.
pub fn slide(by: By<SlideStep>, h: f64) -> Slider {
    SLIDING.end(by, RESTING, h).unwrap_or((f64::NAN, f64::NAN))
}

/// The places about the stop.
fn stopping(by: By<SlideStep>, h: f64) -> FailurePicture {
    let around = (12.0 * h).max(0.1);
    let (from, to) = (SLIDING.stops_after() - around, SLIDING.stops_after() + around);
    let line = slides(by, h).map(|(t, (x, _))| (t, x - SLIDING.stop())).skip_while(|(t, _)| *t < from);
    let picture = FailurePicture::of("time, s", "place beyond the stop, m").found(line.take_while(|(t, _)| *t <= to));
    picture.within(0.0, TOLERANCE)
}

/// The velocities about the stop, in units of friction's change in a step.
fn chattering(h: f64) -> FailurePicture {
    let first = ((SLIDING.stops_after() / h) as usize).saturating_sub(8);
    let line = slides(By::Hand(by_sign), h).enumerate().skip(first).take(24);
    let line = line.map(|(i, (_, (_, v)))| ((i + 1 - first) as f64, v / (SLIDING.brake() * h)));
    FailurePicture::of("steps about the stop", "velocity / friction's in a step").found(line).within(0.0, 0.0)
}

/// Stops dead at v₀²/2μg, within a tenth of a pixel.
pub fn coulomb_stop() -> StressTest {
    let right = |(x, v): Slider| v == 0.0 && (x - SLIDING.stop()).abs() <= TOLERANCE;
    let mut methods = Trial::all_showing(sliding::METHODS, move |by, h| right(slide(by, h)), stopping);
    methods[0].shown = Some(Box::new(chattering));
    StressTest::of("a slide stops dead, and in the right place", "step h, s", (1e-5, 0.5), methods)
}

/// The balls of a series of bounces from 1 m, a fifth beyond its end, at 60 Hz.
fn series(by: By<Bounce>, e: f64) -> impl Iterator<Item = (f64, Ball)> {
    BouncingBall::of(e).path(by, 1.2 * series_end(e), TICK)
}

/// The end of all its bounces, s.
pub fn end_of_bounces(by: By<Bounce>, e: f64) -> f64 {
    bounces_until(series(by, e))
}

/// The height that remains to a ball at the end of the series of its bounces: the second half of their time, and a fifth more.
fn ending(by: By<Bounce>, e: f64) -> FailurePicture {
    let (end, fall) = (series_end(e), (2.0 * bouncing::HEIGHT / G).sqrt());
    let from = 0.5 * (end + fall);
    let line = series(by, e).map(|(t, ball)| (t, energy(ball, G) / G)).skip_while(|(t, _)| *t < from);
    let exact = (0..=150).map(|i| from + (1.2 * end - from) * f64::from(i) / 150.0).map(|t| (t, lossy_apex_at(e, t)));
    FailurePicture::of("time, s", "height that is left, m").found(line).exact(exact)
}

/// Infinitely many bounces in a finite time, up to e = 0.98.
pub fn zeno() -> StressTest {
    let right = |e: f64, end: f64| (end - series_end(e)).abs() <= RIGHT * series_end(e) + TICK;
    let alone = |e| event_loop((bouncing::HEIGHT, 0.0), G, e, 1.2 * series_end(e), ENDLESS) < ENDLESS;
    let impacts = |e| {
        let times = impact_times((bouncing::HEIGHT, 0.0), G, e).take(60).enumerate();
        let line = times.map(|(i, t)| ((i + 1) as f64, t / series_end(e)));
        FailurePicture::of("impacts", "time / end of the series").found(line).exact([(1.0, 1.0), (60.0, 1.2)])
    };
    let mut methods = vec![Trial::new("event loop alone", alone).showing(impacts)];
    methods.extend(Trial::all_showing(METHODS, move |by, e| right(e, end_of_bounces(by, e)), ending));
    StressTest::of("endless bounces end when the series does", "restitution e, at h = 1/60 s", (0.1, 0.98), methods)
}

/// E/E₀ after a minute of perfect bouncing from 1 m.
pub fn minute(by: By<Bounce>, h: f64) -> f64 {
    energy_kept(by, MINUTE, h)
}

/// Keeps its energy to 1 % for a minute.
pub fn minute_of_bounces() -> StressTest {
    let picture = |by: By<Bounce>, h: f64| {
        let energy = |t: f64, ball: &Ball| (t, energy(*ball, G) / (G * bouncing::HEIGHT));
        let line = BouncingBall::of(1.0).running(by, h).each(MINUTE, energy);
        FailurePicture::of("time, s", "energy / first one").found(line).within(1.0, RIGHT)
    };
    let methods = Trial::all_showing(METHODS, |by, h| (minute(by, h) - 1.0).abs() <= RIGHT, picture);
    StressTest::of("perfect bouncing for 60 s keeps its energy to 1 %", "step h, s", (1e-4, 0.5), methods)
}
