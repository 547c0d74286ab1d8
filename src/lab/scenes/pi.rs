//! π from collisions: which step size still counts right, and at which cost. Exact: ⌈π/atan(√(m/M))⌉ − 1 collisions.

use crate::classics::pi::{Blocks, step_through};
use crate::lab::curve::PI;
use crate::lab::{LabScene, SceneMethod};

/// Digits after the 3 that steps are tried on.
const DIGITS: std::ops::RangeInclusive<u32> = 0..=5;

/// The right counts: the first digits of π.
pub const COUNTS: [u64; 10] = [3, 31, 314, 3141, 31_415, 314_159, 3_141_592, 31_415_926, 314_159_265, 3_141_592_653];

fn error(n: u32, found: u64) -> f64 {
    let exact = COUNTS[n as usize] as f64;
    (found as f64 - exact).abs() / exact
}

/// Counts in steps of `h` s; `None` where that would take too long.
pub fn stepped(n: u32, h: f64) -> Option<u64> {
    step_through(n, h, 1).ok().map(|stepped| stepped.collisions)
}

/// A method a digit.
pub fn digits() -> LabScene {
    let last = *DIGITS.end();
    let stepped =
        |n: u32| SceneMethod::new(format!("time steps, N = {n}"), move |h| stepped(n, h).map_or(f64::NAN, |count| error(n, count)));
    let exact = move |_| {
        let mut blocks = Blocks::new(last);
        while blocks.collide().is_some() {}
        error(last, blocks.collisions)
    };
    let exact = SceneMethod { name: format!("exact times of impact, N = {last}"), ..SceneMethod::shipped(exact) };
    LabScene {
        error: "relative error of the count",
        work: "CPU time for the count, ns",
        tolerance: 0.5 / COUNTS[last as usize] as f64,
        alike: false,
        steps: vec![1e-1, 1.0 / 60.0, 1.0 / 120.0, 1e-3, 1e-4, 1e-5],
        methods: DIGITS.map(stepped).chain([exact]).collect(),
        ..LabScene::new(PI, "π from collisions: counting in time steps, and by exact times of impact", 1.0, 1)
    }
}
