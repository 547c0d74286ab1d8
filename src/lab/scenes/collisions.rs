//! Elastic collisions along a line. Exact: of a cradle the last block leaves with the first one's velocity; nothing gets through a thin obstacle;
//! π from collisions counts ⌈π/atan(√(m/M))⌉ − 1.

use crate::lab::contract::{self, By, Model};
use crate::lab::methods::impact::{ImpactStep, LineBlock, at_once, discrete, exact, speculative, swept};
use crate::physics::{BodyDef, DVec2, World};
use crate::{classics::pi::Blocks, classics::pi::step_through, lab::LabScene, lab::SceneMethod, lab::curve::PI};

/// s.
const SECONDS: f64 = 10.0;
/// m/s. Of the first block of a cradle.
pub const STRIKE: f64 = 3.0;

pub const METHODS: [(&str, ImpactStep); 5] = [
    ("overlap at tick ends", discrete),
    ("swept, rest of tick lost", swept),
    ("speculative contacts", speculative),
    ("all contacts at once", at_once),
    ("exact times of impact", exact),
];

/// Blocks on a line that collide without loss; blocks of infinite mass are walls, which stand behind the others.
#[derive(Clone, Debug)]
pub struct BlockLine {
    /// From left to right.
    pub blocks: Vec<LineBlock>,
    /// Bodies that rest beside them in the engine's world, 10 m below the line.
    pub crowd: usize,
}

impl BlockLine {
    pub fn of(blocks: Vec<LineBlock>) -> Self {
        Self { blocks, crowd: 0 }
    }

    /// A cradle: `n` equal blocks of 1 m, the first 2 m before the others and moving towards them.
    pub fn cradle(n: usize) -> Self {
        let block = |i: usize| LineBlock { x: i as f64, v: 0.0, mass: 1.0, half: 0.5 };
        let mut blocks: Vec<_> = (0..n).map(block).collect();
        blocks[0] = LineBlock { x: -2.0, v: STRIKE, ..block(0) };
        Self::of(blocks)
    }

    /// The exact place of a block of a cradle after `t` s, m.
    pub fn cradle_place(&self, block: usize, t: f64) -> f64 {
        let (at, meet) = (self.blocks[block].x, 2.0 / STRIKE);
        match block {
            0 => at + STRIKE * t.min(meet),
            _ if block + 1 == self.blocks.len() => at + STRIKE * (t - meet).max(0.0),
            _ => at,
        }
    }

    /// Places of all blocks at the start and after each step, m.
    pub fn paths(&self, by: By<ImpactStep>, seconds: f64, h: f64) -> Vec<Vec<f64>> {
        let places = |blocks: &[LineBlock]| blocks.iter().map(|block| block.x).collect();
        let after = self.running(by, h).each(seconds, |_, blocks| places(blocks));
        std::iter::once(places(&self.blocks)).chain(after).collect()
    }
}

impl Model for BlockLine {
    type State = Vec<LineBlock>;
    type Method = ImpactStep;

    fn start(&self) -> Vec<LineBlock> {
        self.blocks.clone()
    }

    fn step(&self, method: ImpactStep, blocks: &mut Vec<LineBlock>, h: f64) {
        method(blocks, 1.0, h);
    }

    fn world(&self) -> Option<World> {
        let mut def = contract::line(&self.blocks, 1.0);
        let resting = |i: usize| BodyDef { position: DVec2::new(i as f64, 10.0), ..BodyDef::default() };
        def.bodies.extend((0..self.crowd).map(resting));
        World::new(def).ok()
    }

    fn read(&self, world: &World, _: f64, blocks: &mut Vec<LineBlock>) {
        let movable = blocks.iter_mut().filter(|block| block.mass.is_finite());
        for (block, body) in movable.zip(world.bodies()) {
            (block.x, block.v) = (body.position.x, body.velocity.x);
        }
    }
}

pub fn cradle() -> LabScene {
    let line = BlockLine::cradle(5);
    let places: Vec<f64> = (0..5).map(|block| line.cradle_place(block, SECONDS)).collect();
    let scene = LabScene::new("cradle", "Newton's cradle of five blocks, 10 s", SECONDS, places.len());
    let world = line.world();
    let methods = SceneMethod::all(METHODS, move |by, h| {
        let error = |blocks: Vec<LineBlock>| blocks.iter().zip(&places).map(|(block, x)| (block.x - x).abs()).fold(0.0, f64::max);
        line.end(by, SECONDS, h).map_or(f64::NAN, error)
    });
    LabScene { error: "worst error of a position at the end, m", methods, world, ..scene }
}

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
