//! Where integrators fail: things so light that a step overshoots their terminal velocity, and gusts that turn them round.

use super::picture::Picture;
use super::{G, TICK, Test};
use crate::lab::methods::motion::{INTEGRATORS, Law, METHODS, Point, Step, exact_fall};
use crate::lab::scenes::oscillator;
use crate::lab::shipped;
use crate::physics::DVec2;

/// Steps after which a fall has long settled.
const LONG: usize = 2000;
/// Steps that a picture shows.
const SHOWN: usize = 30;
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

/// The velocities after each step of a fall at z = g·h/v_t, by hand, in units of the terminal one, as its start is; those beyond all
/// bounds left out, and what comes after them.
fn falls(step: Step, z: f64, start: f64) -> Vec<f64> {
    let (law, terminal) = falling(z);
    let mut point = Point { x: DVec2::ZERO, v: DVec2::new(0.0, start * terminal) };
    let velocities = (0..LONG).map(|_| {
        point = step(&law, point, TICK);
        point.v.y / terminal
    });
    velocities.take_while(|v| v.abs() <= BOUNDS).collect()
}

/// A fall at z = g·h/v_t, by hand, given its start in units of the terminal velocity.
pub fn fall(step: Step, z: f64, start: f64) -> Fall {
    let velocities = falls(step, z, start);
    let right = velocities.iter().rev().take_while(|v| (*v - 1.0).abs() <= RIGHT).count();
    match (velocities.len(), right) {
        (..LONG, _) => Fall::Diverges,
        (_, 11..) => Fall::Right,
        (_, _) => Fall::Wrong,
    }
}

/// The same fall by the shipped engine: the largest relative error of its velocity over a second from half a second on.
pub fn shipped_fall_error(z: f64) -> f64 {
    let (law, terminal) = falling(z);
    let seconds = 20.0 * terminal / G + 1.0;
    let end = shipped::flight(&law, Point::default(), (seconds / TICK).ceil() * TICK, TICK);
    (end.v.y / terminal - 1.0).abs()
}

/// The last of some velocities of a fall, in units of the terminal one.
fn settled(velocities: &[f64]) -> Picture {
    let first = velocities.len().saturating_sub(SHOWN);
    let line = velocities.iter().enumerate().skip(first).map(|(i, v)| ((i + 1) as f64, *v));
    Picture::of("steps since the start", "velocity / v_t").found(line).within(1.0, RIGHT)
}

/// z = g·h/v_t: above 1, half a dozen methods do not find the terminal velocity any more.
pub fn terminal_velocity() -> Test {
    let parameter = "z = g·h/v_t: step h = 1/60 s, terminal velocity v_t";
    let mut test = Test::of("terminal velocity to 1 %", parameter, (0.01, 1e3));
    for (name, step) in METHODS.into_iter().chain([("exact flow", exact_fall as Step)]) {
        test = test.method(name, move |z| fall(step, z, 0.0) == Fall::Right).drawn(move |z| settled(&falls(step, z, 0.0)));
    }
    test.shipped(|z| shipped_fall_error(z) <= RIGHT).drawn(|z| {
        let (law, terminal) = falling(z);
        let velocities = shipped::places(shipped::in_air(&law, Point::default()), LONG, TICK).into_iter();
        settled(&velocities.map(|bodies| bodies[0].v.y / terminal).collect::<Vec<_>>())
    })
}

/// Swings that are followed.
const SWINGS: f64 = 100.0;
/// Relative: how right their amplitude has to stay.
const AMPLITUDE: f64 = 0.1;

/// The swings done after each step and the amplitude then, over that at the start, by hand at ω·h = `turn`.
fn swings_of(step: Step, turn: f64) -> impl Iterator<Item = (f64, f64)> {
    let law = Law { spring: (turn / TICK) * (turn / TICK), ..Law::default() };
    let mut point = Point { x: DVec2::new(0.0, 1.0), v: DVec2::ZERO };
    (1..=steps_of(turn) as u64).map(move |i| {
        point = step(&law, point, TICK);
        (i as f64 * turn / std::f64::consts::TAU, oscillator::energy(&point, law.spring, 1.0).sqrt())
    })
}

fn steps_of(turn: f64) -> f64 {
    (SWINGS * std::f64::consts::TAU / turn).ceil()
}

/// The same of a floating box, by the shipped engine.
fn shipped_swings(turn: f64) -> impl Iterator<Item = (f64, f64)> {
    let omega = turn / TICK;
    let mass = oscillator::DENSITY * oscillator::G / (omega * omega);
    // A fifth of its depth, or of what is left above the water.
    let depth = mass / oscillator::DENSITY;
    let start = 0.2 * depth.min(1.0 - depth);
    let points = oscillator::by_engine(mass, start, steps_of(turn) * TICK, TICK);
    points.map(move |(t, point)| (t * omega / std::f64::consts::TAU, oscillator::energy(&point, omega * omega, start).sqrt()))
}

/// ω·h: a swing is a circle that steps cut off.
pub fn swings() -> Test {
    let keeps = |swings: &mut dyn Iterator<Item = (f64, f64)>| {
        swings.last().is_some_and(|(_, amplitude)| (amplitude - 1.0).abs() <= AMPLITUDE)
    };
    let picture = |swings: &mut dyn Iterator<Item = (f64, f64)>| {
        Picture::of("swings", "amplitude / first one").found(swings).within(1.0, AMPLITUDE)
    };
    let parameter = "ω·h: step h = 1/60 s, a swing in 2π/ω";
    let mut test = Test::of("amplitude of 100 swings afloat to 10 %", parameter, (0.09, 10.0));
    for &(name, step) in INTEGRATORS {
        test = test.method(name, move |turn| keeps(&mut swings_of(step, turn)));
        test = test.drawn(move |turn| picture(&mut swings_of(step, turn)));
    }
    test.shipped(move |turn| keeps(&mut shipped_swings(turn))).drawn(move |turn| picture(&mut shipped_swings(turn)))
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
    let bodies = shipped::places(shipped::in_air(&gust_law(), start), (1.0 / TICK) as usize, TICK);
    bodies.into_iter().map(|bodies| bodies[0].v.x).collect()
}

/// What becomes of a velocity in the first steps, over that of the air, and what should.
fn blown(velocities: &[f64], speed: f64) -> Picture {
    let after = velocities.iter().take(SHOWN / 3).enumerate().map(|(i, v)| ((i + 1) as f64, v / speed));
    let found = Picture::of("steps since the start", "velocity / the air's").found(std::iter::once((0.0, 1.0)).chain(after));
    let k = gust_law().drag;
    found.exact((0..=SHOWN / 3).map(|steps| steps as f64).map(|steps| (steps, 1.0 / (1.0 + k * speed * steps * TICK))))
}

fn gusts(name: &'static str, survives: fn(&[f64], f64) -> bool) -> Test {
    let mut test = Test::of(name, "wind on v_t = 2 m/s at h = 1/60 s, m/s", (1.0, 1e4));
    for (name, step) in METHODS {
        test = test.method(name, move |speed| survives(&gust(step, speed), speed));
        test = test.drawn(move |speed| blown(&gust(step, speed), speed));
    }
    test.shipped(move |speed| survives(&shipped_gust(speed), speed)).drawn(|speed| blown(&shipped_gust(speed), speed))
}

/// Drag may slow something down; it never turns it round.
pub fn gust_reversal() -> Test {
    gusts("a gust never reverses", |velocities, _| velocities.iter().all(|v| *v >= 0.0))
}

/// Nor does it make it faster.
pub fn gust_blow_up() -> Test {
    gusts("a gust never speeds up", |velocities, speed| velocities.iter().all(|v| v.abs() <= speed))
}
