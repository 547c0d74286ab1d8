//! Bodies in contact along an axis. Exact: a resting body stays; a row pushed along a floor accelerates with F/Σm − μg, all of it alike.

use crate::lab::curve::worst;
use crate::lab::{LabScene, SceneMethod, TICK, contract};
use crate::physics::{BodyDef, BodyId, DVec2, Material, World};
use crate::{lab::contract::By, lab::contract::Model, lab::methods::chain::Chain, lab::methods::chain::Solver};

/// N/kg.
const G: f64 = 9.81;
const COLUMN: usize = 20;
const ROW: usize = 20;
const TOWER: usize = 10;
/// m. Between the blocks of a column that is dropped.
const DROP: f64 = 0.05;
/// m/s. Slower, a block rests.
const RESTS: f64 = 1e-3;
/// s.
const SECONDS: f64 = 10.0;
/// m/s².
const ROW_ACCELERATION: f64 = 1.0;

/// The solvers by hand, from the cheapest.
pub const SOLVERS: [(&str, Solver); 9] = [
    ("impulses, 4 sweeps, warm", Solver::Sweeps { sweeps: 4, warm: true }),
    ("impulses, 20 sweeps, cold", Solver::Sweeps { sweeps: 20, warm: false }),
    ("impulses, 20 sweeps, warm", Solver::Sweeps { sweeps: 20, warm: true }),
    ("impulses, 4 substeps", Solver::Substeps(4)),
    ("impulses, 20 substeps", Solver::Substeps(20)),
    ("soft contacts, 4 substeps", Solver::Soft(4)),
    ("soft contacts, 20 substeps", Solver::Soft(20)),
    ("XPBD, 20 substeps", Solver::Positions(20)),
    ("direct", Solver::Direct),
];

/// Bodies in contact along an axis, 1 m apart: standing on a floor, or a row of blocks of 1 kg that slide along it.
#[derive(Clone, Debug)]
pub struct ContactChain {
    /// kg, from the floor or from the pushed end.
    pub masses: Vec<f64>,
    /// Of each body along the axis, m/s²; of an immovable floor first.
    accelerations: Vec<f64>,
    standing: bool,
    /// m. Between the blocks at the start.
    gap: f64,
    /// m/s². Of all blocks across the axis.
    pull: f64,
}

impl ContactChain {
    /// A column of these masses (kg).
    pub fn standing(masses: Vec<f64>) -> Self {
        let accelerations = std::iter::once(0.0).chain(masses.iter().map(|_| -G)).collect();
        Self { masses, accelerations, standing: true, gap: 0.0, pull: 0.0 }
    }

    /// A column of `n` blocks, each pushed sideways with half of what friction can bear.
    pub fn tower(n: usize) -> Self {
        Self { pull: 0.5 * Material::ASPHALT.static_friction * G, ..Self::standing(vec![1.0; n]) }
    }

    /// A column of `n` blocks with gaps below each.
    pub fn dropped(n: usize) -> Self {
        Self { gap: DROP, ..Self::standing(vec![1.0; n]) }
    }

    /// When it does, s: infinite where a block still moves after `seconds`.
    pub fn found_at_rest(&self, by: By<Solver>, seconds: f64, h: f64) -> f64 {
        let moves = |chain: &Chain| chain.velocities.iter().any(|v| v.is_nan() || v.abs() > RESTS);
        let moving = self.running(by, h).each(seconds, |t, chain| (t, moves(chain)));
        let last = moving.fold((0.0, 0.0), |(last, _), (t, moves)| (if moves { t } else { last }, t));
        if last.0 < last.1 { last.0 } else { f64::INFINITY }
    }

    /// A row of `n` blocks that is pushed from behind. Every block slides from the first step on.
    fn pushed(n: usize) -> Self {
        let mut accelerations = vec![-Material::ASPHALT.kinetic_friction * G; n];
        accelerations[0] += push(n);
        Self { masses: vec![1.0; n], accelerations, standing: false, gap: 0.0, pull: 0.0 }
    }

    /// The largest distance by which a body of a standing column ever leaves its place, m.
    pub fn sag(&self, by: By<Solver>, seconds: f64, h: f64) -> f64 {
        let size = |x: &f64| if x.is_finite() { x.abs() } else { f64::INFINITY };
        let moved = |chain: &Chain| chain.places.iter().chain(&chain.across).map(size).fold(0.0, f64::max);
        worst(self.running(by, h).each(seconds, |_, chain| moved(chain)))
    }

    /// The worst error of a place in the pushed row, m.
    fn row_error(&self, by: By<Solver>, seconds: f64, h: f64) -> f64 {
        let exact = |t: f64| match by {
            // Of a method of first order only the solver's error counts: its steps are a parabola of h more.
            By::Hand(solver) => 0.5 * ROW_ACCELERATION * t * (t + h / f64::from(solver.parts())),
            By::Engine => ROW_START * t + 0.5 * ROW_ACCELERATION * t * t,
        };
        let error = |t: f64, chain: &Chain| chain.places.iter().map(|x| (x - exact(t)).abs()).fold(0.0, f64::max);
        worst(self.running(by, h).each(seconds, error))
    }
}

/// m/s. The engine's row is in motion already, so that kinetic friction acts from the first tick on, as in the chain.
const ROW_START: f64 = 1e-3;

impl Model for ContactChain {
    type State = Chain;
    type Method = Solver;

    fn start(&self) -> Chain {
        let chain = Chain::new(&self.masses, self.standing);
        let places = (0..chain.places.len()).map(|i| i as f64 * self.gap).collect();
        let friction = if self.pull > 0.0 { Material::ASPHALT.static_friction } else { 0.0 };
        Chain { places, friction, pull: self.pull, ..chain }
    }

    fn step(&self, solver: Solver, chain: &mut Chain, h: f64) {
        chain.step(&self.accelerations, solver, h);
    }

    fn world(&self) -> Option<World> {
        if self.standing {
            let up = |i: usize| i as f64 + (i + 1) as f64 * self.gap;
            let bodies = self.masses.iter().enumerate().map(|(i, &mass)| contract::crate_at(0.0, up(i), mass));
            let mut world = World::new(contract::on_floor(G, 1.0, bodies.collect())).ok()?;
            for (i, mass) in self.masses.iter().enumerate().filter(|_| self.pull > 0.0) {
                world.set_drive(BodyId(i as u32), DVec2::new(mass * self.pull, 0.0));
            }
            return Some(world);
        }
        let n = self.masses.len();
        let velocity = DVec2::new(ROW_START, 0.0);
        let row = (0..n).map(|i| BodyDef { velocity, ..contract::crate_at(i as f64, 0.0, 1.0) });
        let mut world = World::new(contract::on_floor(G, 1.0, row.collect())).ok()?;
        world.set_drive(BodyId(0), DVec2::new(push(n), 0.0));
        Some(world)
    }

    fn read(&self, world: &World, _: f64, chain: &mut Chain) {
        let anchor = usize::from(self.standing);
        for (i, body) in world.bodies().iter().enumerate() {
            let (standing, x) = (self.standing, body.position.x);
            chain.places[anchor + i] = if standing { -(body.position.y + 0.5 + i as f64) } else { x - i as f64 };
            chain.velocities[anchor + i] = if standing { -body.velocity.y } else { body.velocity.x };
            chain.across[anchor + i] = if standing { x } else { 0.0 };
        }
    }
}

/// The force on the first block of 1 kg that makes `n` of them move with [`ROW_ACCELERATION`], N.
fn push(n: usize) -> f64 {
    n as f64 * (ROW_ACCELERATION + Material::ASPHALT.kinetic_friction * G)
}

fn standing(name: &'static str, title: String, column: ContactChain) -> LabScene {
    let scene = LabScene { world: column.world(), ..LabScene::new(name, title, SECONDS, column.masses.len()) };
    let solvers = SOLVERS.into_iter().filter(|(_, solver)| column.pull == 0.0 || *solver != Solver::Direct);
    let methods = SceneMethod::all(solvers.collect::<Vec<_>>(), move |by, h| column.sag(by, SECONDS, h));
    LabScene { error: "largest movement of a body at rest, m", methods, ..scene }
}

pub fn column() -> LabScene {
    standing("column", format!("A column of {COLUMN} equal blocks, 10 s"), ContactChain::standing(vec![1.0; COLUMN]))
}

pub fn heavy_on_light() -> LabScene {
    standing("heavy-on-light", "10 000 kg resting on 1 kg, 10 s".to_owned(), ContactChain::standing(vec![1.0, 10_000.0]))
}

pub fn friction_tower() -> LabScene {
    let title = format!("A tower of {TOWER} blocks, pushed sideways by half of what friction bears, 10 s");
    standing("friction-tower", title, ContactChain::tower(TOWER))
}

pub fn time_to_rest() -> LabScene {
    let pile = ContactChain::dropped(TOWER);
    let world = pile.world();
    // s: all fall alike, and the topmost falls through all gaps.
    let exact = (2.0 * pile.gap * pile.masses.len() as f64 / G).sqrt();
    let methods = SceneMethod::all(SOLVERS, move |by, h| (pile.found_at_rest(by, SECONDS, h) - exact).abs());
    let title = format!("A pile of {TOWER} falling blocks comes to rest");
    let note = "At rest: no block is faster than 1 mm/s from then on. Upper edge: never within 10 s.";
    let scene = LabScene::new("rest-time", title, SECONDS, TOWER);
    LabScene { error: "error of the time of rest, s", tolerance: TICK, note, methods, world, ..scene }
}

pub fn pushed_row() -> LabScene {
    let (seconds, row) = (1.0, ContactChain::pushed(ROW));
    let world = row.world();
    let methods = SceneMethod::all(SOLVERS, move |by, h| row.row_error(by, seconds, h));
    let scene = LabScene::new("pushed-row", format!("A row of {ROW} blocks pushed along a floor, 1 s"), seconds, ROW);
    LabScene { error: "worst error of a position, m", methods, world, ..scene }
}
