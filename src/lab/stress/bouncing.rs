//! Where floors fail: jitter at rest, stops that are short or never come, bounces that end too early or never, energy from nothing.

use super::{G, Rows, Survival, TICK};
use crate::lab::methods::bounce::{Bounce, event_loop};
use crate::lab::methods::friction::{self, Slide, by_sign, clamped};
use crate::lab::scenes::bouncing::{self, METHODS, bounces_until, by_engine, by_hand, energy_kept, series_end};
use crate::lab::{TOLERANCE, shipped};
use crate::physics::{BodyDef, BodyId, DVec2, Material};

/// s.
const RESTING: f64 = 5.0;
/// s.
const MINUTE: f64 = 60.0;
/// Relative: how right the end of the bounces and the energy have to be.
const RIGHT: f64 = 0.01;
/// m/s. Where the slides begin.
const SLIDE: f64 = 10.0;
/// Impacts after which an event loop counts as endless.
pub const ENDLESS: u32 = 1_000_000;

/// The speed (m/s) that is left on a ball that was put on the floor, by hand.
pub fn jitter(bounce: Bounce, e: f64) -> f64 {
    let ticks = 0..(RESTING / TICK) as u32;
    let (_, v) = ticks.fold((0.0, 0.0), |ball, _| bounce(ball, G, e, TICK));
    v.abs()
}

/// The same by the shipped engine.
pub fn shipped_jitter(e: f64) -> f64 {
    let body = BodyDef { restitution: e, ..shipped::crate_at(0.0, 0.0, 1.0) };
    let world = shipped::run(shipped::on_floor(G, 1.0, vec![body]), RESTING, TICK);
    world.map_or(f64::NAN, |world| world.body(BodyId(0)).velocity.length())
}

/// Rest is exact, whatever the restitution.
pub fn resting_jitter() -> Vec<Survival> {
    let range = (0.01, 1.0);
    let mut rows = Rows::of("rest without jitter", "restitution e");
    for (name, bounce) in METHODS {
        rows = rows.method(name, range, |e| jitter(bounce, e) == 0.0);
    }
    rows.shipped(range, |e| shipped_jitter(e) == 0.0)
}

/// Deceleration on Asphalt, m/s².
pub fn brake() -> f64 {
    Material::ASPHALT.kinetic_friction * G
}

/// Where a slide from 10 m/s ends, and how fast it still is after 5 s, by hand.
pub fn slide(slide: Slide, h: f64) -> (f64, f64) {
    let steps = 0..(RESTING / h).round() as u64;
    steps.fold((0.0, SLIDE), |slider, _| slide(slider, brake(), h))
}

/// The same by the shipped engine.
pub fn shipped_slide(h: f64) -> (f64, f64) {
    let body = BodyDef { velocity: DVec2::new(SLIDE, 0.0), ..shipped::crate_at(0.0, 0.0, 1.0) };
    let world = shipped::run(shipped::on_floor(G, 1.0, vec![body]), RESTING, h);
    world.map_or((f64::NAN, f64::NAN), |world| (world.body(BodyId(0)).position.x, world.body(BodyId(0)).velocity.x))
}

/// Stops dead at v₀²/2μg, within a tenth of a pixel.
pub fn coulomb_stop() -> Vec<Survival> {
    let range = (1e-5, 0.5);
    let right = |(x, v): (f64, f64)| v == 0.0 && (x - SLIDE * SLIDE / (2.0 * brake())).abs() <= TOLERANCE;
    Rows::of("a slide stops dead, and in the right place", "step, s")
        .method("friction by sign", range, |h| right(slide(by_sign, h)))
        .method("friction clamped", range, |h| right(slide(clamped, h)))
        .method("exact stop", range, |h| right(slide(friction::exact, h)))
        .shipped(range, |h| right(shipped_slide(h)))
}

/// When all bounces from 1 m are over, by hand, at 60 Hz, s.
pub fn end_by_hand(bounce: Bounce, e: f64) -> f64 {
    bounces_until(by_hand(bounce, e, 1.2 * series_end(e), TICK))
}

/// The same by the shipped engine.
pub fn end_by_engine(e: f64) -> f64 {
    bounces_until(by_engine(e, 1.2 * series_end(e), TICK))
}

/// Infinitely many bounces in a finite time, up to e = 0.98.
pub fn zeno() -> Vec<Survival> {
    let range = (0.1, 0.98);
    let right = |e: f64, end: f64| (end - series_end(e)).abs() <= RIGHT * series_end(e) + TICK;
    let mut rows = Rows::of("endless bounces end when the series does", "restitution e")
        .method("event loop alone", range, |e| event_loop((bouncing::HEIGHT, 0.0), G, e, 1.2 * series_end(e), ENDLESS) < ENDLESS);
    for (name, bounce) in METHODS {
        rows = rows.method(name, range, |e| right(e, end_by_hand(bounce, e)));
    }
    rows.shipped(range, |e| right(e, end_by_engine(e)))
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
pub fn minute_of_bounces() -> Vec<Survival> {
    let range = (1e-4, 0.5);
    let right = |kept: f64| (kept - 1.0).abs() <= RIGHT;
    let mut rows = Rows::of("perfect bouncing for 60 s keeps its energy to 1 %", "step, s");
    for (name, bounce) in METHODS {
        rows = rows.method(name, range, |h| right(minute_by_hand(bounce, h)));
    }
    rows.shipped(range, |h| right(minute_by_engine(h)))
}
