//! π from collisions: which step size still counts right, and at which cost. Exact: ⌈π/atan(√(m/M))⌉ − 1 collisions.

use crate::classics::pi::{Blocks, step_through};
use crate::lab::Scene;
use crate::lab::report::PI;

/// Digits after the 3 that steps are tried on.
const DIGITS: std::ops::RangeInclusive<u32> = 0..=5;

/// The right counts: the first digits of π.
pub const COUNTS: [u64; 10] = [3, 31, 314, 3141, 31_415, 314_159, 3_141_592, 31_415_926, 314_159_265, 3_141_592_653];

/// The relative error of a count.
fn error(n: u32, found: u64) -> f64 {
    let exact = COUNTS[n as usize] as f64;
    (found as f64 - exact).abs() / exact
}

/// Counts in steps of `h` s; `None` where that would take too long.
pub fn stepped(n: u32, h: f64) -> Option<u64> {
    step_through(n, h, 1).ok().map(|stepped| stepped.collisions)
}

/// A method a digit.
pub fn digits() -> Scene {
    let mut scene = Scene::new(PI, "π from collisions: counting in time steps, and by exact times of impact", 1.0, 1)
        .measuring("relative error of the count");
    scene.work = "CPU time for the count, ns";
    scene.tolerance = 0.5 / COUNTS[*DIGITS.end() as usize] as f64;
    scene.alike = false;
    scene.steps = vec![1e-1, 1.0 / 60.0, 1.0 / 120.0, 1e-3, 1e-4, 1e-5];
    for n in DIGITS {
        scene = scene.method(format!("time steps, N = {n}"), move |h| stepped(n, h).map_or(f64::NAN, |count| error(n, count)));
    }
    let last = *DIGITS.end();
    let exact = move |_| {
        let mut blocks = Blocks::new(last);
        while blocks.collide().is_some() {}
        error(last, blocks.collisions())
    };
    scene.method(format!("exact times of impact, N = {last}"), exact).shipped()
}
