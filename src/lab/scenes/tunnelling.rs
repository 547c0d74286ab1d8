//! Something fast against something thin. Exact: it never gets through.

use crate::lab::Scene;
use crate::lab::methods::impact::Block;
use crate::lab::scenes::collisions::{METHODS, by_engine, by_hand};

/// m. Widths of the flying box and of what it meets.
const BOX: f64 = 0.5;
/// m.
const THIN: f64 = 0.1;
/// Starting places within one step of travel: some phase of the step is the worst one.
const PHASES: usize = 16;

/// A box at `speed` (m/s) and something thin of `mass` (kg; infinite: a wall), such that they meet after `delay` s.
fn flight(speed: f64, mass: f64, delay: f64) -> Vec<Block> {
    let way = speed * delay + 0.5 * (BOX + THIN);
    vec![Block { x: 0.0, v: speed, mass: 1.0, half: 0.5 * BOX }, Block { x: way, v: 0.0, mass, half: 0.5 * THIN }]
}

/// How a run is made: blocks, seconds, step.
type Run<'a> = &'a dyn Fn(Vec<Block>, f64, f64) -> Vec<Block>;

/// The worst error of the box's place half a second after it has bounced off, over all phases of the step, m.
pub fn worst_error(run: Run<'_>, speed: f64, mass: f64, h: f64) -> f64 {
    let mut worst: f64 = 0.0;
    for phase in 0..PHASES {
        let steps = (0.5 / h).round().max(2.0);
        let delay = (0.5 * steps + phase as f64 / PHASES as f64) * h;
        let blocks = flight(speed, mass, delay);
        let leaves = if mass.is_infinite() { -speed } else { speed * (1.0 - mass) / (1.0 + mass) };
        let exact = speed * delay + leaves * (steps * h - delay);
        let found = run(blocks, steps * h, h);
        let error = found.first().map_or(f64::NAN, |block| (block.x - exact).abs());
        worst = if error.is_finite() { worst.max(error) } else { f64::INFINITY };
    }
    worst
}

/// Whether the box stays on its side at every phase of the step.
pub fn holds(run: Run<'_>, speed: f64, mass: f64, h: f64) -> bool {
    (0..PHASES).all(|phase| {
        let delay = (1.0 + phase as f64 / PHASES as f64) * h;
        let found = run(flight(speed, mass, delay), 4.0 * h, h);
        found.len() < 2 && mass.is_infinite() && found.first().is_some_and(|block| block.v < 0.0)
            || found.get(1).is_some_and(|other| found[0].x <= other.x && found[0].v <= other.v)
    })
}

fn scene(name: &'static str, title: &str, speed: f64, mass: f64) -> Scene {
    let mut scene = Scene::new(name, title, 0.5 * PHASES as f64, 1).measuring("worst error of position 0.25 s after the impact, m");
    for (name, line) in METHODS {
        scene = scene.method(name, move |h| worst_error(&|blocks, seconds, h| by_hand(line, blocks, seconds, h), speed, mass, h));
    }
    scene.shipped(move |h| worst_error(&|blocks, seconds, h| by_engine(&blocks, seconds, h), speed, mass, h))
}

/// A wall of 10 cm.
pub fn thin_wall() -> Scene {
    scene("thin-wall", "A box of 0.5 m at 100 m/s against a wall of 0.1 m", 100.0, f64::INFINITY)
}

/// A plate of 10 cm that can move.
pub fn bodies() -> Scene {
    scene("thin-body", "A box of 0.5 m at 100 m/s against a plate of 0.1 m and three times its mass", 100.0, 3.0)
}
