//! Where methods fail, beyond the table of stress tests: the naive method fails where theory or measurement says it does, and the shipped
//! engine holds there and far beyond.

use resultant::lab::TICK;
use resultant::lab::contract::By;
use resultant::lab::methods::bounce::{by_sign, clamped};
use resultant::lab::methods::chain::sweeps_needed;
use resultant::lab::methods::motion::{MotionStep, exact_decay, explicit_euler, rk4, strang};
use resultant::lab::methods::{bounce, impact};
use resultant::lab::scenes::bouncing as bounces;
use resultant::lab::scenes::stacks::{ContactChain, SOLVERS};
use resultant::lab::stress::motion::{FallOutcome, fall};
use resultant::lab::stress::{G, robustness, standing};

/// Explicit Euler oscillates above z = 1 and diverges from 1.47. RK4 leaves even a fall that has already settled above 1.39, and diverges at
/// 2.06. Splittings settle, but beside the terminal velocity.
#[test]
fn terminal_velocity() {
    use FallOutcome::{Diverges, Right, Wrong};
    let euler = [(0.98, Right), (1.02, Wrong), (1.45, Wrong), (1.48, Diverges)].map(|c| (explicit_euler as MotionStep, 0.0, c));
    let settled = [(1.385, Right), (1.40, Wrong)].map(|c| (rk4 as MotionStep, 0.9999, c));
    let falling = [(2.04, Wrong), (2.08, Diverges)].map(|c| (rk4 as MotionStep, 0.0, c));
    let splittings = [exact_decay as MotionStep, strang].map(|step| [2.1, 10.0, 100.0].map(|z| (step, 0.0, (z, Wrong))));
    for (step, start, (z, outcome)) in [&euler[..], &settled, &falling, splittings.as_flattened()].concat() {
        assert_eq!(fall(step, z, start), outcome, "{z}");
    }
}

#[test]
fn heavy_on_light() {
    for (ratio, sweeps) in [(10.0, 49), (100.0, 463), (1000.0, 4608)] {
        assert_eq!(sweeps_needed(&[1.0, ratio], 0.01, 10_000), Some(sweeps), "R = {ratio}");
        assert_eq!(sweeps_needed(&[1.0, ratio], 0.01, sweeps - 1), None, "R = {ratio}");
    }
    for ratio in [10.0, 1000.0, 1e4, 1e6] {
        assert!(standing::stands(&[1.0, ratio]), "R = {ratio}");
        assert_eq!(ContactChain::standing(vec![1.0, ratio]).sag(By::Engine, 2.0, TICK), 0.0, "R = {ratio}");
    }
}

#[test]
fn columns() {
    for (n, sweeps) in [(2, 7), (5, 47), (10, 192), (20, 776), (50, 4886)] {
        assert_eq!(sweeps_needed(&vec![1.0; n], 0.01, 10_000), Some(sweeps), "N = {n}");
    }
    // The picture: with four sweeps a step a column of twenty sinks into itself.
    let (_, four) = SOLVERS[0];
    assert!(ContactChain::standing(vec![1.0; 20]).sag(By::Hand(four), 10.0, TICK) > 0.5);
    for n in [2, 10, 50, 100] {
        assert!(standing::stands(&vec![1.0; n]), "N = {n}");
    }
}

#[test]
fn resting_jitter() {
    // e·g·h/(1+e) is left: 0.073 m/s at e = 0.8.
    for e in [0.3, 0.8, 0.9] {
        let left = robustness::jitter(By::Hand(bounce::every_tick), e);
        assert!((left / (e * G * TICK / (1.0 + e)) - 1.0).abs() < 1e-9, "e = {e}: {left}");
        assert_eq!(robustness::jitter(By::Engine, e), 0.0, "e = {e}");
    }
    assert!((robustness::jitter(By::Hand(bounce::every_tick), 0.8) - 0.073).abs() < 5e-4);
}

#[test]
fn coulomb_stop() {
    let distance = 100.0 / (2.0 * robustness::SLIDING.brake());
    for h in [1.0 / 30.0, TICK, 1.0 / 120.0] {
        // By sign: never at rest, within ±μgh.
        let (_, v) = robustness::slide(By::Hand(by_sign), h);
        assert!(v != 0.0 && v.abs() <= robustness::SLIDING.brake() * h, "{v}");
        // Clamped: dead, but short by v₀h/2.
        let (x, v) = robustness::slide(By::Hand(clamped), h);
        assert!(v == 0.0 && ((distance - x) / (5.0 * h) - 1.0).abs() < 0.01, "{x}");
        let (x, v) = robustness::slide(By::Engine, h);
        assert!(v == 0.0 && (x - distance).abs() < 1e-9, "{x}");
    }
}

#[test]
fn endless_bounces() {
    let end = bounces::series_end(0.9);
    assert!((end - 8.578_949_178_7).abs() < 1e-9);
    assert_eq!(bounce::event_loop((bounces::HEIGHT, 0.0), G, 0.9, 10.0, robustness::ENDLESS), robustness::ENDLESS);
    let snapped = robustness::end_of_bounces(By::Hand(bounce::snap), 0.9);
    assert!((snapped - 5.75).abs() < 0.1, "snapping ends the bounces after {snapped} s");
    for e in [0.5, 0.9, 0.97] {
        let (found, end) = (robustness::end_of_bounces(By::Engine, e), bounces::series_end(e));
        assert!((found - end).abs() <= TICK, "e = {e}: over after {found} s, the series after {end} s");
    }
}

#[test]
fn a_minute_of_perfect_bouncing() {
    for (bounce, kept) in [(bounce::snap as bounce::Bounce, 0.875), (bounce::reflect, 1.011), (bounce::verlet_snap, 5.935)] {
        let found = robustness::minute(By::Hand(bounce), TICK);
        assert!((found - kept).abs() < 1e-3, "{found}, measured before {kept}");
    }
    for h in [1.0 / 15.0, 1.0 / 30.0, TICK, 1.0 / 120.0] {
        assert!((robustness::minute(By::Hand(bounce::exact), h) - 1.0).abs() < 1e-9);
        let found = robustness::minute(By::Engine, h);
        assert!((found - 1.0).abs() < 1e-6, "{h} s: {found}");
    }
}

#[test]
fn simultaneous_impacts() {
    let found = standing::cradle(By::Hand(impact::at_once), 3);
    for (found, exact) in found.iter().zip([-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]) {
        assert!((found - exact).abs() < 1e-12);
    }
    let (momentum, energy) = (found.iter().sum::<f64>(), found.iter().map(|v| v * v).sum::<f64>());
    assert!((momentum - 1.0).abs() < 1e-12 && (energy - 1.0).abs() < 1e-12);
    for n in [3, 5, 10] {
        let mut pattern = vec![0.0; n];
        pattern[n - 1] = 1.0;
        assert_eq!(standing::cradle(By::Engine, n), pattern);
    }
}

#[test]
fn a_hitch() {
    let frame = 2.0;
    let naive = robustness::frame_as_step(frame);
    assert!(naive.height < -10.0, "the frame's time as step: through the floor, {} m", naive.height);
    assert!(!robustness::ticks_without_cap(frame).survived(), "no cap: the next frame is late too");
    let shipped = robustness::shipped_hitch(frame);
    assert_eq!(shipped.ticks, 8);
    assert!(shipped.survived());
    // Even as one step of two seconds the engine gets it right.
    assert!(robustness::shipped_step(frame).height.abs() < 1e-9);
}
