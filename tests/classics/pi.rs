//! π from collisions: the counts, the places and times, where stepping fails, and the command line.

use crate::support::program::{Ran, resultant};
use crate::support::strategies::cases;
use proptest::prelude::*;
use resultant::classics::pi::{Blocks, Collision, HEAVY_START, LIGHT_START, MAX_N, STEPPED_DURATION, mass_ratio, step_through};

/// The first digits of π, N+1 of them.
fn digits(n: u32) -> u64 {
    3_141_592_653 / 10_u64.pow(MAX_N - n)
}

/// Half the angle by which a round turns the velocities, in the plane of √m₁·u₁ and √m₂·u₂.
fn angle(n: u32) -> f64 {
    mass_ratio(n).sqrt().recip().atan()
}

fn pi(arguments: &[&str]) -> Ran {
    Ran::new(resultant().arg("pi").args(arguments))
}

/// Unfolded at the walls of its wedge, the way of the point (√m₁·x₁, √m₂·x₂) is a straight line, and collision k is where it
/// crosses the ray at angle k·θ: both times and places follow.
#[test]
fn times_and_places_are_those_of_the_straight_line() {
    /// Rounding of all collisions turns the line by no more than this. Near its end the line runs along the rays, and a turn moves a
    /// crossing by a multiple of it.
    const TURN: f64 = 1e-13;
    for n in 0..=7 {
        let (root, theta) = (mass_ratio(n).sqrt(), angle(n));
        let mut blocks = Blocks::new(n);
        for k in 1..=digits(n) {
            let expected = if k % 2 == 1 { Collision::Blocks } else { Collision::Wall };
            assert_eq!(blocks.collide(), Some(expected));
            if n > 5 && k % 101 != 0 && k + 100 < digits(n) {
                continue;
            }
            let turned = k as f64 * theta;
            let time = HEAVY_START - LIGHT_START / (root * turned.tan());
            let error = (blocks.time - time).abs();
            assert!(error < 1e-12 + TURN / (root * turned.sin().powi(2)), "N = {n}, {k}: {} s, not {time} s", blocks.time);
            let (light, heavy) = blocks.positions(blocks.time);
            let place = LIGHT_START / turned.sin() * if k % 2 == 1 { theta.sin() } else { 1.0 / root };
            let error = (heavy / place - 1.0).abs();
            assert!(error < 1e-11 + TURN / turned.sin(), "N = {n}, {k}: {heavy} m, not {place} m");
            assert_eq!(light, if k % 2 == 1 { heavy } else { 0.0 });
        }
        assert_eq!((blocks.collide(), blocks.next_time(), blocks.collisions), (None, None, digits(n)));
        assert!(blocks.time < 0.4 * STEPPED_DURATION);
    }
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn the_same_collisions_come_out_at_any_frame_rate(
        n in 0..=4_u32,
        frames in prop::collection::vec((0.0..0.3, 1..2000_u64), 1..60),
    ) {
        let mut whole = Blocks::new(n);
        let mut cut = whole.clone();
        let mut now = 0.0;
        for (frame, at_most) in frames {
            let made = cut.advance(now + frame, at_most);
            prop_assert!(made <= at_most);
            // With its work used up the scene waits; otherwise all collisions up to now were made.
            now = if made == at_most { cut.time } else { now + frame };
            prop_assert!(cut.time <= now && (made == at_most || cut.next_time().is_none_or(|next| next > now)));
            let (light, heavy) = cut.positions(now);
            prop_assert!(light >= -1e-12 && heavy >= light - 1e-12);
        }
        (0..cut.collisions).for_each(|_| _ = whole.collide());
        prop_assert_eq!(whole, cut);
    }
}

#[test]
fn stepping_is_right_with_small_steps_and_wrong_with_large_ones() {
    let stepped = |n, dt, substeps| step_through(n, dt, substeps).unwrap().collisions;
    assert_eq!([stepped(0, 0.1, 1), stepped(1, 0.01, 1), stepped(2, 1e-3, 1), stepped(3, 1e-3, 1)], [3, 31, 314, 3141]);
    for (n, dt) in [(2, 0.1), (3, 0.1), (4, 0.01), (5, 0.01)] {
        assert_ne!(stepped(n, dt, 1), digits(n), "N = {n}, dt = {dt}");
    }
    assert_eq!(step_through(3, 0.1, 100), step_through(3, 0.001, 1));
}

#[test]
fn the_command_line_prints_the_counts() {
    for n in 0..=5 {
        let ran = pi(&[&n.to_string()]);
        assert_eq!(ran.value("collisions"), digits(n).to_string());
        for key in ["seconds", "last_time", "last_position"] {
            assert!(ran.value(key).parse::<f64>().unwrap() >= 0.0, "{key}");
        }
        assert!(ran.status == 0 && !ran.out.contains("stepped="), "{ran:?}");
    }
    let ran = pi(&["3", "--dt", "0.1", "--substeps", "2"]);
    assert_eq!(ran.value("collisions"), "3141");
    assert_eq!(ran.value("stepped"), step_through(3, 0.05, 1).unwrap().collisions.to_string());
}

#[test]
fn the_command_line_refuses_bad_numbers() {
    let steps = ["0", "-0.1", "nan", "inf", "x", "1e-300", "1e-9", "0.1 --substeps 0", "0.1 --substeps -1"];
    let steps = steps.map(|step| format!("2 --dt {step}"));
    let others = ["10", "-1", "2.5", "x", "", "2 --dt=-1", "2 --substeps 2"];
    for line in steps.iter().map(String::as_str).chain(others) {
        let arguments: Vec<&str> = line.split_whitespace().collect();
        let ran = pi(&arguments);
        assert!(ran.status == 2 && ran.out.is_empty() && (1..1000).contains(&ran.err.len()), "{arguments:?}: {ran:?}");
    }
    assert!(pi(&["2", "--dt", "1e-9"]).err.contains("which makes 2e10 steps, expected at most 1e9"));
}
