//! A fast box against a thin obstacle. Exact: it never gets through.

use crate::lab::contract::{By, Model};
use crate::lab::methods::impact::{ImpactStep, LineBlock};
use crate::lab::scenes::collisions::{BlockLine, METHODS};
use crate::lab::{LabScene, SceneMethod};

/// m. Widths of the flying box and of the obstacle in its path.
pub const BOX: f64 = 0.5;
/// m.
pub const THIN: f64 = 0.1;
/// Starting places within one step of travel: some phase of the step is the worst one.
const PHASES: usize = 16;
/// Steps within which box and obstacle meet and part.
pub const STEPS: usize = 4;

/// A box of 1 kg at `speed` (m/s) against an obstacle of `mass` (kg; infinite: a wall).
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// m/s.
    pub speed: f64,
    /// kg.
    pub mass: f64,
}

impl Meeting {
    /// Box and obstacle, such that they meet after `delay` s.
    fn after(self, delay: f64) -> BlockLine {
        let x = self.speed * delay + 0.5 * (BOX + THIN);
        BlockLine::of(vec![
            LineBlock { x: 0.0, v: self.speed, mass: 1.0, half: 0.5 * BOX },
            LineBlock { x, v: 0.0, mass: self.mass, half: 0.5 * THIN },
        ])
    }

    /// The start at that phase of the step, and the time of the impact, s.
    pub fn at_phase(self, phase: usize, h: f64) -> (BlockLine, f64) {
        let delay = (1.0 + phase as f64 / PHASES as f64) * h;
        (self.after(delay), delay)
    }

    /// Velocities of box and obstacle after an impact without loss, m/s.
    pub fn parting(self) -> (f64, f64) {
        let Self { speed, mass } = self;
        if mass.is_infinite() { (-speed, 0.0) } else { (speed * (1.0 - mass) / (1.0 + mass), 2.0 * speed / (1.0 + mass)) }
    }

    /// The first phase of the step at which the box does not stay on its side, if there is one.
    pub fn fails_at(self, by: By<ImpactStep>, h: f64) -> Option<usize> {
        let stays = |blocks: Vec<LineBlock>| blocks[0].x <= blocks[1].x && blocks[0].v <= blocks[1].v;
        (0..PHASES).find(|&phase| !self.at_phase(phase, h).0.end(by, STEPS as f64 * h, h).is_some_and(stays))
    }

    /// The worst error of the box's place half a second after it has bounced off, over all phases of the step, m.
    fn worst_error(self, by: By<ImpactStep>, h: f64) -> f64 {
        let mut worst: f64 = 0.0;
        for phase in 0..PHASES {
            let steps = (0.5 / h).round().max(2.0);
            let delay = (0.5 * steps + phase as f64 / PHASES as f64) * h;
            let exact = self.speed * delay + self.parting().0 * (steps * h - delay);
            let found = self.after(delay).end(by, steps * h, h);
            let error = found.map_or(f64::NAN, |blocks| (blocks[0].x - exact).abs());
            worst = if error.is_finite() { worst.max(error) } else { f64::INFINITY };
        }
        worst
    }
}

/// A wall of 10 cm.
pub fn thin_wall() -> LabScene {
    let wall = Meeting { speed: 100.0, mass: f64::INFINITY };
    let methods = SceneMethod::all(METHODS, move |by, h| wall.worst_error(by, h));
    let (error, title) =
        ("worst error of position 0.25 s after the impact, m", "A box of 0.5 m at 100 m/s against a wall of 0.1 m");
    LabScene { error, methods, world: wall.after(0.25).world(), ..LabScene::new("thin-wall", title, 0.5 * PHASES as f64, 1) }
}
