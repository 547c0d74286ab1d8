//! Something fast against something thin. Exact: it never gets through.

use crate::lab::Scene;
use crate::lab::methods::impact::Block;
use crate::lab::scenes::collisions::{METHODS, by_engine, by_hand};

/// m. Widths of the flying box and of what it meets.
pub const BOX: f64 = 0.5;
/// m.
pub const THIN: f64 = 0.1;
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
        let (leaves, _) = after(speed, mass);
        let exact = speed * delay + leaves * (steps * h - delay);
        let found = run(blocks, steps * h, h);
        let error = found.first().map_or(f64::NAN, |block| (block.x - exact).abs());
        worst = if error.is_finite() { worst.max(error) } else { f64::INFINITY };
    }
    worst
}

/// Steps within which box and thin thing meet and part.
pub const STEPS: usize = 4;

/// The start of the flight at that phase of the step, and when the two meet, s.
pub fn start_at(phase: usize, speed: f64, mass: f64, h: f64) -> (Vec<Block>, f64) {
    let delay = (1.0 + phase as f64 / PHASES as f64) * h;
    (flight(speed, mass, delay), delay)
}

/// The first phase of the step at which the box does not stay on its side, if there is one.
pub fn fails_at(run: Run<'_>, speed: f64, mass: f64, h: f64) -> Option<usize> {
    (0..PHASES).find(|&phase| {
        let found = run(start_at(phase, speed, mass, h).0, STEPS as f64 * h, h);
        let turned = found.len() < 2 && mass.is_infinite() && found.first().is_some_and(|block| block.v < 0.0);
        let in_order = found.get(1).is_some_and(|other| found[0].x <= other.x && found[0].v <= other.v);
        !(turned || in_order)
    })
}

/// Velocity of the box of 1 kg, and of what it met, after they have met without loss, m/s.
pub fn after(speed: f64, mass: f64) -> (f64, f64) {
    if mass.is_infinite() { (-speed, 0.0) } else { (speed * (1.0 - mass) / (1.0 + mass), 2.0 * speed / (1.0 + mass)) }
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
