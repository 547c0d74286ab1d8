//! Elastic collisions along a line. A pair keeps momentum and energy; of a cradle of n equal blocks the last one leaves with the first
//! one's velocity and all others stand still.

use crate::lab::methods::impact::{Block, Line, at_once, discrete, exact, swept};
use crate::lab::{Scene, shipped};
use crate::physics::World;

/// s.
const SECONDS: f64 = 10.0;
/// m/s. What the cradle is struck with.
pub const STRIKE: f64 = 3.0;

/// The hand-written ways.
pub const METHODS: [(&str, Line); 4] = [
    ("overlap at tick ends", discrete),
    ("swept, rest of tick lost", swept),
    ("all contacts at once", at_once),
    ("exact times of impact", exact),
];

/// The pair of the golden numbers, 10 m apart.
fn pair() -> Vec<Block> {
    vec![Block { x: 0.0, v: 25.7, mass: 75.0, half: 0.5 }, Block { x: 11.0, v: -11.3, mass: 150.0, half: 0.5 }]
}

/// `n` equal blocks of 1 m, the first 2 m before the others and moving towards them.
pub fn cradle_of(n: usize) -> Vec<Block> {
    let block = |i: usize| Block { x: i as f64, v: 0.0, mass: 1.0, half: 0.5 };
    let mut blocks: Vec<_> = (0..n).map(block).collect();
    blocks[0] = Block { x: -2.0, v: STRIKE, ..block(0) };
    blocks
}

/// Runs blocks by hand.
pub fn by_hand(line: Line, mut blocks: Vec<Block>, seconds: f64, h: f64) -> Vec<Block> {
    for _ in 0..(seconds / h).round() as u64 {
        line(&mut blocks, 1.0, h);
    }
    blocks
}

/// Runs them with the shipped engine. Nothing where it refuses them.
pub fn by_engine(blocks: &[Block], seconds: f64, h: f64) -> Vec<Block> {
    let read = |world: World| {
        let found = world.bodies().iter().zip(blocks);
        found.map(|(body, block)| Block { x: body.position.x, v: body.velocity.x, ..*block }).collect()
    };
    shipped::run(shipped::line(blocks, 1.0), seconds, h).map(read).unwrap_or_default()
}

/// Where they are at the start and after each of so many steps, by hand, m.
pub fn paths_by_hand(line: Line, mut blocks: Vec<Block>, steps: usize, h: f64) -> Vec<Vec<f64>> {
    let places = |blocks: &[Block]| blocks.iter().map(|block| block.x).collect::<Vec<f64>>();
    let mut paths = vec![places(&blocks)];
    for _ in 0..steps {
        line(&mut blocks, 1.0, h);
        paths.push(places(&blocks));
    }
    paths
}

/// The same with the shipped engine: of what can move.
pub fn paths_by_engine(blocks: &[Block], steps: usize, h: f64) -> Vec<Vec<f64>> {
    let movable = blocks.iter().filter(|block| block.mass.is_finite());
    let after = shipped::places(shipped::line(blocks, 1.0), steps, h).into_iter();
    let after = after.map(|bodies| bodies.iter().map(|body| body.x.x).collect());
    std::iter::once(movable.map(|block| block.x).collect()).chain(after).collect()
}

/// The largest error of a place, m.
fn worst(found: &[Block], places: &[f64]) -> f64 {
    if found.len() != places.len() {
        return f64::NAN;
    }
    found.iter().zip(places).map(|(block, x)| (block.x - x).abs()).fold(0.0, f64::max)
}

fn scene(name: &'static str, title: &str, blocks: Vec<Block>, places: Vec<f64>) -> Scene {
    let mut scene = Scene::new(name, title, SECONDS, blocks.len()).measuring("worst error of a position at the end, m");
    for (name, line) in METHODS {
        let (blocks, places) = (blocks.clone(), places.clone());
        scene = scene.method(name, move |h| worst(&by_hand(line, blocks.clone(), SECONDS, h), &places));
    }
    scene.shipped(move |h| worst(&by_engine(&blocks, SECONDS, h), &places))
}

/// 75 kg at 25.7 m/s against 150 kg at −11.3 m/s.
pub fn head_on() -> Scene {
    let blocks = pair();
    let (a, b) = (blocks[0], blocks[1]);
    let meet = 10.0 / (a.v - b.v);
    let (va, vb) = crate::classics::pi::elastic(a.mass, a.v, b.mass, b.v);
    let places = vec![a.x + a.v * meet + va * (SECONDS - meet), b.x + b.v * meet + vb * (SECONDS - meet)];
    scene("head-on", "An elastic head-on collision, 10 s", blocks, places)
}

/// Five equal blocks.
pub fn cradle() -> Scene {
    let blocks = cradle_of(5);
    let meet = 2.0 / STRIKE;
    let mut places: Vec<f64> = blocks.iter().map(|block| block.x).collect();
    places[0] = 0.0;
    places[4] += STRIKE * (SECONDS - meet);
    scene("cradle", "Newton's cradle of five blocks, 10 s", blocks, places)
}
