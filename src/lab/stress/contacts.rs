//! Methods of impact fail at thin obstacles and at many contacts at one instant.

use super::picture::FailurePicture;
use super::{StressTest, TICK, Trial};
use crate::lab::contract::{By, Model};
use crate::lab::methods::impact::ImpactStep;
use crate::lab::scenes::collisions::{BlockLine, METHODS, STRIKE};
use crate::lab::scenes::tunnelling::{self, Meeting};

/// Whether a box of 0.5 m never gets through an obstacle of 0.1 m and `mass` (kg; infinite: a wall) at 60 Hz.
pub fn stays_out(by: By<ImpactStep>, speed: f64, mass: f64) -> bool {
    Meeting { speed, mass }.fails_at(by, TICK).is_none()
}

/// The places of the first `blocks` over the steps since `first`.
fn with_paths(picture: FailurePicture, paths: &[Vec<f64>], blocks: usize, first: usize) -> FailurePicture {
    let path =
        |block: usize| paths.iter().enumerate().skip(first).filter_map(move |(i, places)| Some((i as f64, *places.get(block)?)));
    (0..blocks).fold(picture, |picture, block| picture.found(path(block)))
}

/// The places of box and obstacle over the steps in which they meet, at the first phase of the step that fails.
fn met(by: By<ImpactStep>, meeting: Meeting) -> FailurePicture {
    let (line, met) = meeting.at_phase(meeting.fails_at(by, TICK).unwrap_or(0), TICK);
    let end = tunnelling::STEPS as f64;
    let (found, thin) = (line.paths(by, end * TICK, TICK), line.blocks[1].x);
    let (box_after, thin_after) = meeting.parting();
    let exact = |x: f64, before: f64, after: f64| {
        let at = |steps: f64| (steps, x + before * met.min(steps * TICK) + after * (steps * TICK - met).max(0.0));
        [0.0, met / TICK, end].map(at)
    };
    let picture = FailurePicture::of("steps", "place, m").exact(exact(line.blocks[0].x, meeting.speed, box_after));
    if meeting.mass.is_infinite() {
        let half = 0.5 * tunnelling::THIN;
        with_paths(picture, &found, 1, 0).solid(thin - half, thin + half)
    } else {
        with_paths(picture, &found, 2, 0).exact(exact(thin, 0.0, thin_after))
    }
}

fn tunnels(name: &'static str, mass: f64) -> StressTest {
    let picture = move |by, speed| met(by, Meeting { speed, mass });
    let methods = Trial::all_showing(METHODS, move |by, speed| stays_out(by, speed, mass), picture);
    StressTest::of(name, "speed at h = 1/60 s, m/s", (1.0, 1e6), methods)
}

pub fn tunnelling() -> StressTest {
    tunnels("0.5 m box against a 0.1 m wall", f64::INFINITY)
}

pub fn tunnelling_of_bodies() -> StressTest {
    tunnels("0.5 m box against a 0.1 m plate that can move", 3.0)
}

/// s. The strike comes after two thirds of a second.
const STRUCK: f64 = 1.0;
/// Bodies beside the cradle in a crowd: in the engine the cradle is an island of its own.
const CROWD: usize = 200;

/// The velocities of a cradle of `n` after the strike, in units of the first one's.
pub fn cradle(by: By<ImpactStep>, n: usize) -> Vec<f64> {
    struck_velocities(by, &BlockLine::cradle(n))
}

fn struck_velocities(by: By<ImpactStep>, cradle: &BlockLine) -> Vec<f64> {
    let blocks = cradle.end(by, STRUCK, TICK).unwrap_or_default();
    blocks.iter().map(|block| block.v / STRIKE).collect()
}

fn last_leaves(velocities: &[f64]) -> bool {
    let last = velocities.len().saturating_sub(1);
    !velocities.is_empty() && velocities.iter().enumerate().all(|(i, v)| (v - f64::from(u8::from(i == last))).abs() <= 1e-9)
}

/// The places of all blocks from half a strike on, and the exact ones.
fn struck(by: By<ImpactStep>, cradle: &BlockLine) -> FailurePicture {
    let (steps, meet) = (STRUCK / TICK, 2.0 / STRIKE / TICK);
    let first = (steps / 2.0) as usize;
    let blocks = cradle.blocks.len();
    let paths = cradle.paths(by, STRUCK, TICK);
    let exact = |picture: FailurePicture, block: usize| {
        picture.exact([first as f64, meet, steps].map(|step| (step, cradle.cradle_place(block, step * TICK))))
    };
    (0..blocks).fold(with_paths(FailurePicture::of("steps", "places, m"), &paths, blocks, first), exact)
}

/// A cradle's pattern: 0, …, 0, v.
fn cradles(name: &'static str, crowd: usize) -> StressTest {
    let cradle = move |n: f64| BlockLine { crowd, ..BlockLine::cradle(n.floor() as usize) };
    let survives = move |by, n| last_leaves(&struck_velocities(by, &cradle(n)));
    let methods = Trial::all_showing(METHODS, survives, move |by, n| struck(by, &cradle(n)));
    StressTest { whole: true, ..StressTest::of(name, "blocks, at h = 1/60 s", (2.0, 20.0), methods) }
}

pub fn simultaneous_impacts() -> StressTest {
    cradles("cradle: the last leaves alone", 0)
}

pub fn simultaneous_impacts_in_a_crowd() -> StressTest {
    cradles("the same among 200 others", CROWD)
}
