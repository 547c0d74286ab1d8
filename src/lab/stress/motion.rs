//! Where integrators fail: things so light that a step overshoots their terminal velocity, and gusts that turn them round.

use super::{G, Rows, Survival, TICK};
use crate::lab::methods::motion::{INTEGRATORS, Law, METHODS, Point, Step, exact_fall, follow};
use crate::lab::scenes::oscillator;
use crate::lab::shipped;
use crate::physics::DVec2;

/// Steps after which a fall has long settled.
const LONG: u32 = 2000;
/// m/s. Terminal velocity of the thing in the gust.
const LIGHT: f64 = 2.0;
/// Relative: how near to the terminal velocity counts as right.
const RIGHT: f64 = 0.01;

/// Terminal velocities: beyond, a fall has diverged.
const BOUNDS: f64 = 1e6;

/// What becomes of a fall from rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fall {
    /// It settles at the terminal velocity, to 1 %.
    Right,
    /// It settles elsewhere, or never.
    Wrong,
    /// Its velocity leaves all bounds.
    Diverges,
}

/// The law of a fall with z = g·h/v_t.
fn falling(z: f64) -> (Law, f64) {
    let terminal = G * TICK / z;
    (Law { constant: DVec2::new(0.0, G), drag: G / (terminal * terminal), ..Law::default() }, terminal)
}

/// A fall at z = g·h/v_t, by hand, given its start in units of the terminal velocity.
pub fn fall(step: Step, z: f64, start: f64) -> Fall {
    let (law, terminal) = falling(z);
    let mut point = Point { x: DVec2::ZERO, v: DVec2::new(0.0, start * terminal) };
    let mut right = 0;
    for _ in 0..LONG {
        point = step(&law, point, TICK);
        if !point.v.is_finite() || point.v.length() > BOUNDS * terminal {
            return Fall::Diverges;
        }
        right = if (point.v.y / terminal - 1.0).abs() <= RIGHT { right + 1 } else { 0 };
    }
    if right > 10 { Fall::Right } else { Fall::Wrong }
}

/// The same fall by the shipped engine: the largest relative error of its velocity over a second from half a second on.
pub fn shipped_fall_error(z: f64) -> f64 {
    let (law, terminal) = falling(z);
    let seconds = 20.0 * terminal / G + 1.0;
    let end = shipped::flight(&law, Point::default(), (seconds / TICK).ceil() * TICK, TICK);
    (end.v.y / terminal - 1.0).abs()
}

/// z = g·h/v_t: above 1, half a dozen methods do not find the terminal velocity any more.
pub fn terminal_velocity() -> Vec<Survival> {
    let range = (0.01, 1e3);
    let mut rows = Rows::of("terminal velocity to 1 %", "z = g·h/v_t, with the step h");
    for (name, step) in METHODS {
        rows = rows.method(name, range, |z| fall(step, z, 0.0) == Fall::Right);
    }
    rows.method("exact flow", range, |z| fall(exact_fall, z, 0.0) == Fall::Right).shipped(range, |z| shipped_fall_error(z) <= RIGHT)
}

/// Swings that are followed.
const SWINGS: f64 = 100.0;
/// Relative: how right their amplitude has to stay.
const AMPLITUDE: f64 = 0.1;

/// The amplitude after a hundred swings of ω·h, over that at the start, by hand.
pub fn swing(step: Step, turn: f64) -> f64 {
    let law = Law { spring: (turn / TICK) * (turn / TICK), ..Law::default() };
    let start = Point { x: DVec2::new(0.0, 1.0), v: DVec2::ZERO };
    let steps = (SWINGS * std::f64::consts::TAU / turn).ceil();
    oscillator::energy(&follow(step, &law, start, steps * TICK, TICK), law.spring, 1.0).sqrt()
}

/// The same of a floating box, by the shipped engine.
pub fn shipped_swing(turn: f64) -> f64 {
    let steps = (SWINGS * std::f64::consts::TAU / turn).ceil();
    let omega = turn / TICK;
    let mass = oscillator::DENSITY * oscillator::G / (omega * omega);
    // A fifth of its depth, or of what is left above the water.
    let depth = mass / oscillator::DENSITY;
    let start = 0.2 * depth.min(1.0 - depth);
    let end = oscillator::by_engine(mass, start, steps * TICK, TICK).last();
    end.map_or(f64::NAN, |(_, point)| oscillator::energy(&point, omega * omega, start).sqrt())
}

/// ω·h: a swing is a circle that steps cut off.
pub fn swings() -> Vec<Survival> {
    let range = (0.09, 10.0);
    let keeps = |amplitude: f64| (amplitude - 1.0).abs() <= AMPLITUDE;
    let mut rows = Rows::of("amplitude of 100 swings afloat to 10 %", "ω·h, with the step h");
    for &(name, step) in INTEGRATORS {
        rows = rows.method(name, range, |turn| keeps(swing(step, turn)));
    }
    rows.shipped(range, |turn| keeps(shipped_swing(turn)))
}

/// Drag alone on something with a terminal velocity of 2 m/s.
pub fn gust_law() -> Law {
    Law { constant: DVec2::ZERO, drag: G / (LIGHT * LIGHT), ..Law::default() }
}

/// The velocities (m/s) after each of a second's ticks, of something hit by air at `speed`.
pub fn gust(step: Step, speed: f64) -> Vec<f64> {
    let mut point = Point { x: DVec2::ZERO, v: DVec2::new(speed, 0.0) };
    let ticks = 0..(1.0 / TICK) as u32;
    ticks
        .map(|_| {
            point = step(&gust_law(), point, TICK);
            point.v.x
        })
        .collect()
}

/// The same by the shipped engine.
pub fn shipped_gust(speed: f64) -> Vec<f64> {
    let start = Point { x: DVec2::ZERO, v: DVec2::new(speed, 0.0) };
    let Ok(mut world) = crate::physics::World::new(shipped::in_air(&gust_law(), start)) else { return vec![f64::NAN] };
    let ticks = 0..(1.0 / TICK) as u32;
    ticks
        .map(|_| {
            world.step(TICK);
            world.bodies()[0].velocity.x
        })
        .collect()
}

fn gusts(test: &'static str, survives: impl Fn(&[f64], f64) -> bool) -> Vec<Survival> {
    let range = (1.0, 1e4);
    let mut rows = Rows::of(test, "wind on v_t = 2 m/s at 60 Hz, m/s");
    for (name, step) in METHODS {
        rows = rows.method(name, range, |speed| survives(&gust(step, speed), speed));
    }
    rows.shipped(range, |speed| survives(&shipped_gust(speed), speed))
}

/// Drag may slow something down; it never turns it round.
pub fn gust_reversal() -> Vec<Survival> {
    gusts("a gust never reverses", |velocities, _| velocities.iter().all(|v| *v >= 0.0))
}

/// Nor does it make it faster.
pub fn gust_blow_up() -> Vec<Survival> {
    gusts("a gust never speeds up", |velocities, speed| velocities.iter().all(|v| v.abs() <= speed))
}
