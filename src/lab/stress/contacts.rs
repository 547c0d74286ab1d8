//! Where methods of impact fail: thin things, and many contacts at one instant.

use super::picture::Picture;
use super::{TICK, Test};
use crate::lab::methods::impact::{Block, Line};
use crate::lab::scenes::{collisions, tunnelling};
use crate::lab::shipped;
use crate::physics::{BodyDef, DVec2, World};

/// Places of all blocks after each step.
type Paths = Vec<Vec<f64>>;

/// Whether a box of 0.5 m never gets through something of 0.1 m and `mass` (kg; infinite: a wall) at 60 Hz, by hand.
pub fn stays_out(line: Line, speed: f64, mass: f64) -> bool {
    fails_by_hand(line, speed, mass).is_none()
}

/// The same by the shipped engine.
pub fn shipped_stays_out(speed: f64, mass: f64) -> bool {
    fails_by_engine(speed, mass).is_none()
}

/// The phase of the step at which it does.
fn fails_by_hand(line: Line, speed: f64, mass: f64) -> Option<usize> {
    tunnelling::fails_at(&|blocks, seconds, h| collisions::by_hand(line, blocks, seconds, h), speed, mass, TICK)
}

fn fails_by_engine(speed: f64, mass: f64) -> Option<usize> {
    tunnelling::fails_at(&|blocks, seconds, h| collisions::by_engine(&blocks, seconds, h), speed, mass, TICK)
}

/// The way of each block over the steps since `first`.
fn with_paths(picture: Picture, paths: &Paths, first: usize) -> Picture {
    let blocks = 0..paths.first().map_or(0, Vec::len);
    let way =
        |block: usize| paths.iter().enumerate().skip(first).filter_map(move |(i, places)| Some((i as f64, *places.get(block)?)));
    blocks.fold(picture, |picture, block| picture.found(way(block)))
}

/// The ways of box and thin thing over the steps in which they meet, at the phase at which they fail, if any.
fn meeting(phase: Option<usize>, (speed, mass): (f64, f64), paths: impl Fn(Vec<Block>) -> Paths) -> Picture {
    let (blocks, met) = tunnelling::start_at(phase.unwrap_or(0), speed, mass, TICK);
    let (found, thin) = (paths(blocks.clone()), blocks[1].x);
    let end = tunnelling::STEPS as f64;
    let (box_after, thin_after) = tunnelling::after(speed, mass);
    let exact = |x: f64, before: f64, after: f64| {
        let at = |steps: f64| (steps, x + before * met.min(steps * TICK) + after * (steps * TICK - met).max(0.0));
        [0.0, met / TICK, end].map(at)
    };
    let picture = Picture::of("steps", "place, m").exact(exact(blocks[0].x, speed, box_after));
    if mass.is_infinite() {
        let alone: Paths = found.iter().map(|places| places[..1].to_vec()).collect();
        let half = 0.5 * tunnelling::THIN;
        with_paths(picture, &alone, 0).solid(thin - half, thin + half)
    } else {
        with_paths(picture, &found, 0).exact(exact(thin, 0.0, thin_after))
    }
}

fn tunnels(name: &'static str, mass: f64) -> Test {
    let mut test = Test::of(name, "speed at h = 1/60 s, m/s", (1.0, 1e6));
    for (name, line) in collisions::METHODS {
        test = test.method(name, move |speed| stays_out(line, speed, mass)).drawn(move |speed| {
            let paths = |blocks| collisions::paths_by_hand(line, blocks, tunnelling::STEPS, TICK);
            meeting(fails_by_hand(line, speed, mass), (speed, mass), paths)
        });
    }
    test.shipped(move |speed| shipped_stays_out(speed, mass)).drawn(move |speed| {
        let paths = |blocks: Vec<Block>| collisions::paths_by_engine(&blocks, tunnelling::STEPS, TICK);
        meeting(fails_by_engine(speed, mass), (speed, mass), paths)
    })
}

/// A wall.
pub fn tunnelling() -> Test {
    tunnels("0.5 m box against a 0.1 m wall", f64::INFINITY)
}

/// Something that can move.
pub fn tunnelling_of_bodies() -> Test {
    tunnels("0.5 m box against a 0.1 m plate that can move", 3.0)
}

/// s. The strike comes after two thirds of a second.
const STRUCK: f64 = 1.0;

/// The velocities after the cradle of `n` has been struck, in units of the first one's.
pub fn cradle(run: impl Fn(Vec<Block>) -> Vec<Block>, n: usize) -> Vec<f64> {
    run(collisions::cradle_of(n)).iter().map(|block| block.v / collisions::STRIKE).collect()
}

/// By hand.
pub fn cradle_by_hand(line: Line, n: usize) -> Vec<f64> {
    cradle(|blocks| collisions::by_hand(line, blocks, STRUCK, TICK), n)
}

/// By the shipped engine.
pub fn cradle_by_engine(n: usize) -> Vec<f64> {
    cradle(|blocks| collisions::by_engine(&blocks, STRUCK, TICK), n)
}

fn last_leaves(velocities: &[f64]) -> bool {
    let last = velocities.len().saturating_sub(1);
    !velocities.is_empty() && velocities.iter().enumerate().all(|(i, v)| (v - f64::from(u8::from(i == last))).abs() <= 1e-9)
}

/// The ways of all blocks from half a strike on, and how they should be.
fn struck(n: usize, paths: &Paths) -> Picture {
    let (steps, meet) = (STRUCK / TICK, 2.0 / collisions::STRIKE / TICK);
    let first = (steps / 2.0) as usize;
    let mut picture = with_paths(Picture::of("steps", "places, m"), paths, first);
    for (block, at) in collisions::cradle_of(n).iter().enumerate() {
        let place = |step: f64| match block {
            0 => at.x + collisions::STRIKE * step.min(meet) * TICK,
            _ if block + 1 == n => at.x + collisions::STRIKE * (step - meet).max(0.0) * TICK,
            _ => at.x,
        };
        picture = picture.exact([first as f64, meet, steps].map(|step| (step, place(step))));
    }
    picture
}

/// A cradle's pattern with every method by hand: 0, …, 0, v.
fn cradles(name: &'static str) -> Test {
    let count = |n: f64| n.floor() as usize;
    let mut test = Test::of_whole(name, "blocks, at h = 1/60 s", (2.0, 20.0));
    for (name, line) in collisions::METHODS {
        test = test.method(name, move |n| last_leaves(&cradle_by_hand(line, count(n)))).drawn(move |n| {
            let blocks = collisions::cradle_of(count(n));
            struck(count(n), &collisions::paths_by_hand(line, blocks, (STRUCK / TICK) as usize, TICK))
        });
    }
    test
}

/// A cradle alone.
pub fn simultaneous_impacts() -> Test {
    let count = |n: f64| n.floor() as usize;
    cradles("cradle: the last leaves alone").shipped(move |n| last_leaves(&cradle_by_engine(count(n)))).drawn(move |n| {
        let blocks = collisions::cradle_of(count(n));
        struck(count(n), &collisions::paths_by_engine(&blocks, (STRUCK / TICK) as usize, TICK))
    })
}

/// Blocks beside the cradle in a crowd.
const CROWD: usize = 200;

/// A cradle of `n` among 200 blocks that rest side by side, in the shipped engine: they are a crowd, and the cradle an island of its own.
fn crowd(n: usize) -> Option<World> {
    let mut def = shipped::line(&collisions::cradle_of(n), 1.0);
    let resting = |i: usize| BodyDef { position: DVec2::new(i as f64, 10.0), ..BodyDef::default() };
    def.bodies.extend((0..CROWD).map(resting));
    World::new(def).ok()
}

/// The velocities of its blocks after it has been struck, in units of the first one's.
pub fn cradle_in_a_crowd(n: usize) -> Vec<f64> {
    let Some(mut world) = crowd(n) else { return Vec::new() };
    for _ in 0..(STRUCK / TICK).round() as u32 {
        world.step(TICK);
    }
    world.bodies().iter().take(n).map(|body| body.velocity.x / collisions::STRIKE).collect()
}

/// A cradle's pattern where many others are stepped with it.
pub fn simultaneous_impacts_in_a_crowd() -> Test {
    let count = |n: f64| n.floor() as usize;
    let test = cradles("the same among 200 others");
    test.shipped(move |n| last_leaves(&cradle_in_a_crowd(count(n)))).drawn(move |n| {
        let start = collisions::cradle_of(count(n)).iter().map(|block| block.x).collect();
        let after = crowd(count(n)).map(|world| shipped::places_in(world, (STRUCK / TICK).round() as usize, TICK));
        let after = after.unwrap_or_default().into_iter();
        let paths = after.map(|bodies| bodies.iter().take(count(n)).map(|body| body.x.x).collect());
        struck(count(n), &std::iter::once(start).chain(paths).collect())
    })
}
