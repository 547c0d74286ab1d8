//! Integrators fail where a body is so light that a step overshoots its terminal velocity, and where gusts turn it round.

use super::{G, StressTest, Trial, picture::FailurePicture};
use crate::lab::contract::{By, Model};
use crate::lab::methods::motion::{MotionLaw, MotionStep, PointState, exact_fall};
use crate::{lab::TICK, lab::scenes::flight::FlyingBody, physics::DVec2};
use crate::{lab::methods::INTEGRATORS, lab::methods::METHODS, lab::scenes::oscillator, lab::scenes::springs};

/// Steps after which a fall has long settled.
const LONG: usize = 2000;
const SHOWN: usize = 30;
/// m/s. Terminal velocity of the body in the gust.
const LIGHT: f64 = 2.0;
/// Relative tolerance of the terminal velocity.
const RIGHT: f64 = 0.01;

/// Terminal velocities: beyond, a fall has diverged.
const BOUNDS: f64 = 1e6;

/// The outcome of a fall from rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FallOutcome {
    /// To 1 %.
    Right,
    /// Settles elsewhere, or never.
    Wrong,
    Diverges,
}

/// A fall with z = g·h/v_t that begins at `start` terminal velocities, and that velocity, m/s.
fn falling(z: f64, start: f64) -> (FlyingBody, f64) {
    let terminal = G * TICK / z;
    let law = MotionLaw { constant: DVec2::new(0.0, G), drag: G / (terminal * terminal), ..MotionLaw::default() };
    (FlyingBody::in_air(law, PointState { x: DVec2::ZERO, v: DVec2::new(0.0, start * terminal) }), terminal)
}

/// The velocities after each step of a fall, in terminal velocities; up to the first beyond all bounds.
fn falls(by: By<MotionStep>, z: f64, start: f64) -> Vec<f64> {
    let (body, terminal) = falling(z, start);
    let velocities = body.running(by, TICK).each(LONG as f64 * TICK, |_, point| point.v.y / terminal);
    velocities.take_while(|v| v.abs() <= BOUNDS).collect()
}

/// A fall at z = g·h/v_t by hand that begins at `start` terminal velocities.
pub fn fall(step: MotionStep, z: f64, start: f64) -> FallOutcome {
    let velocities = falls(By::Hand(step), z, start);
    let right = velocities.iter().rev().take_while(|v| (*v - 1.0).abs() <= RIGHT).count();
    match (velocities.len(), right) {
        (..LONG, _) => FallOutcome::Diverges,
        (_, 11..) => FallOutcome::Right,
        (_, _) => FallOutcome::Wrong,
    }
}

/// The relative error of the shipped engine's velocity at the end of the same fall from rest.
pub fn shipped_fall_error(z: f64) -> f64 {
    let (body, terminal) = falling(z, 0.0);
    let seconds = 20.0 * terminal / G + 1.0;
    let end = body.end(By::Engine, (seconds / TICK).ceil() * TICK, TICK);
    end.map_or(f64::NAN, |end| (end.v.y / terminal - 1.0).abs())
}

/// The last velocity of a fall, in units of the terminal one.
fn settled(velocities: &[f64]) -> FailurePicture {
    let first = velocities.len().saturating_sub(SHOWN);
    let line = velocities.iter().enumerate().skip(first).map(|(i, v)| ((i + 1) as f64, *v));
    FailurePicture::of("steps since the start", "velocity / v_t").found(line).within(1.0, RIGHT)
}

/// z = g·h/v_t: above 1, half a dozen methods do not find the terminal velocity any more.
pub fn terminal_velocity() -> StressTest {
    let parameter = "z = g·h/v_t: step h = 1/60 s, terminal velocity v_t";
    let survives = |by: By<MotionStep>, z: f64| match by {
        By::Hand(step) => fall(step, z, 0.0) == FallOutcome::Right,
        By::Engine => shipped_fall_error(z) <= RIGHT,
    };
    let methods = METHODS.into_iter().chain([("exact flow", exact_fall as MotionStep)]);
    let methods = Trial::all_showing(methods, survives, |by, z| settled(&falls(by, z, 0.0)));
    StressTest::of("terminal velocity to 1 %", parameter, (0.01, 1e3), methods)
}

const SWINGS: f64 = 100.0;
/// Relative tolerance of the amplitude.
const AMPLITUDE: f64 = 0.1;

/// The swings done after each step and the amplitude then, over that at the start, at ω·h = `turn`.
fn swings_of(by: By<MotionStep>, turn: f64) -> impl Iterator<Item = (f64, f64)> {
    let omega = turn / TICK;
    let mass = oscillator::DENSITY * oscillator::G / (omega * omega);
    let depth = mass / oscillator::DENSITY;
    let start = match by {
        By::Hand(_) => 1.0,
        // A fifth of the box's depth, or of its height above the water.
        By::Engine => 0.2 * depth.min(1.0 - depth),
    };
    let seconds = (SWINGS * std::f64::consts::TAU / turn).ceil() * TICK;
    oscillator::afloat(omega * omega, mass, start)
        .running(by, TICK)
        .each(seconds, move |t, point| (t * omega / std::f64::consts::TAU, oscillator::energy(point, omega * omega, start).sqrt()))
}

/// ω·h: a swing is a circle that steps cut off.
pub fn swings() -> StressTest {
    let keeps = |by: By<MotionStep>, turn: f64| {
        swings_of(by, turn).last().is_some_and(|(_, amplitude)| (amplitude - 1.0).abs() <= AMPLITUDE)
    };
    let picture = |by: By<MotionStep>, turn: f64| {
        FailurePicture::of("swings", "amplitude / first one").found(swings_of(by, turn)).within(1.0, AMPLITUDE)
    };
    let parameter = "ω·h: step h = 1/60 s, a swing in 2π/ω";
    let methods = Trial::all_showing(INTEGRATORS.iter().copied(), keeps, picture);
    StressTest::of("amplitude of 100 swings afloat to 10 %", parameter, (0.09, 10.0), methods)
}

/// The turns after each step of a body on a spring or a pendulum, and its energy then, over that at the start.
fn energies(body: FlyingBody, by: By<MotionStep>, omega: f64) -> impl Iterator<Item = (f64, f64)> {
    let (law, first) = (body.law, springs::energy(&body.law, &body.start));
    let seconds = (SWINGS * std::f64::consts::TAU / omega / TICK).ceil() * TICK;
    let turns = move |t: f64| t * omega / std::f64::consts::TAU;
    body.running(by, TICK).each(seconds, move |t, point| (turns(t), springs::energy(&law, point) / first))
}

/// A test of the energy after 100 swings, at ω·h.
fn energy_kept(name: &'static str, parameter: &'static str, most: f64, body: fn(f64) -> FlyingBody) -> StressTest {
    let of = move |by: By<MotionStep>, turn: f64| energies(body(turn / TICK), by, turn / TICK);
    let keeps = move |by, turn: f64| {
        let right = |energy: f64| (energy - 1.0).abs() <= AMPLITUDE;
        let mut count = 0;
        let held = of(by, turn).inspect(|_| count += 1).all(|(_, energy)| energy < 10.0 && energy.is_finite());
        held && count > 0 && of(by, turn).last().is_some_and(|(_, energy)| right(energy))
    };
    let picture = move |by, turn| {
        let mut over = false;
        let line = of(by, turn).take_while(|(_, energy)| !std::mem::replace(&mut over, energy.is_nan() || *energy >= 10.0));
        FailurePicture::of("swings", "energy / first one").found(line).within(1.0, AMPLITUDE)
    };
    StressTest::of(name, parameter, (0.02, most), Trial::all_showing(INTEGRATORS.iter().copied(), keeps, picture))
}

/// A body on a spring, which is a link of the engine.
pub fn spring_swings() -> StressTest {
    let parameter = "ω·h: step h = 1/60 s, a swing in 2π/ω";
    energy_kept("energy of 100 swings on a spring to 10 %", parameter, 10.0, |omega| springs::oscillator(omega * omega, 1.0, false))
}

/// A pendulum on a spring 40 times as stiff as m·g/L.
pub fn pendulum() -> StressTest {
    let parameter = "ω·h: step h = 1/60 s, ω² = g/L";
    energy_kept("energy of 100 swings of a pendulum to 10 %", parameter, 2.0, |omega| springs::pendulum(G / (omega * omega), 0.5))
}

/// Drag alone on a body with a terminal velocity of 2 m/s.
pub fn gust_law() -> MotionLaw {
    MotionLaw { constant: DVec2::ZERO, drag: G / (LIGHT * LIGHT), ..MotionLaw::default() }
}

/// The velocities (m/s) after each of a second's ticks, of a body in a wind of `speed`.
pub fn gust(by: By<MotionStep>, speed: f64) -> Vec<f64> {
    let start = PointState { x: DVec2::ZERO, v: DVec2::new(speed, 0.0) };
    FlyingBody::in_air(gust_law(), start).running(by, TICK).each(1.0, |_, point| point.v.x).collect()
}

/// The velocity in the first steps over that of the air, and its exact value.
fn blown(velocities: &[f64], speed: f64) -> FailurePicture {
    let after = velocities.iter().take(SHOWN / 3).enumerate().map(|(i, v)| ((i + 1) as f64, v / speed));
    let found = FailurePicture::of("steps since the start", "velocity / the air's").found(std::iter::once((0.0, 1.0)).chain(after));
    let k = gust_law().drag;
    found.exact((0..=SHOWN / 3).map(|steps| steps as f64).map(|steps| (steps, 1.0 / (1.0 + k * speed * steps * TICK))))
}

fn gusts(name: &'static str, survives: fn(&[f64], f64) -> bool) -> StressTest {
    let survives = move |by: By<MotionStep>, speed: f64| {
        let velocities = gust(by, speed);
        !velocities.is_empty() && survives(&velocities, speed)
    };
    let methods = Trial::all_showing(METHODS, survives, |by, speed| blown(&gust(by, speed), speed));
    StressTest::of(name, "wind on v_t = 2 m/s at h = 1/60 s, m/s", (1.0, 1e4), methods)
}

/// Drag may slow a body down; it never turns it round.
pub fn gust_reversal() -> StressTest {
    gusts("a gust never reverses", |velocities, _| velocities.iter().all(|v| *v >= 0.0))
}

/// Nor does it make it faster.
pub fn gust_blow_up() -> StressTest {
    gusts("a gust never speeds up", |velocities, speed| velocities.iter().all(|v| v.abs() <= speed))
}
