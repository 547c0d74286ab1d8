//! Bodies in contact along an axis: a column, something heavy on something light, a row pushed along a floor. Exact: what rests,
//! stays; the row accelerates with F/Σm − μg, all of it alike.

use crate::lab::methods::chain::{Chain, Solver};
use crate::lab::{Scene, shipped};
use crate::physics::{BodyDef, BodyId, DVec2, Material, World};

/// N/kg.
const G: f64 = 9.81;
/// Blocks of the column.
const COLUMN: usize = 20;
/// Blocks of the row.
const ROW: usize = 20;
/// s.
const SECONDS: f64 = 10.0;
/// m/s². What the row's acceleration shall be.
const ROW_ACCELERATION: f64 = 1.0;

/// The solvers by hand, from the cheapest.
pub const SOLVERS: [(&str, Solver); 6] = [
    ("impulses, 4 sweeps, warm", Solver::Sweeps { sweeps: 4, warm: true }),
    ("impulses, 20 sweeps, cold", Solver::Sweeps { sweeps: 20, warm: false }),
    ("impulses, 20 sweeps, warm", Solver::Sweeps { sweeps: 20, warm: true }),
    ("impulses, 4 substeps", Solver::Substeps(4)),
    ("impulses, 20 substeps", Solver::Substeps(20)),
    ("direct", Solver::Direct),
];

/// The largest distance by which a body of a standing column of these masses ever leaves its place, m.
pub fn sag_by_hand(masses: &[f64], solver: Solver, seconds: f64, h: f64) -> f64 {
    let mut chain = Chain::new(masses, true);
    let mut accelerations = vec![-G; masses.len() + 1];
    accelerations[0] = 0.0;
    let mut worst = 0.0;
    for _ in 0..(seconds / h).round() as u64 {
        chain.step(&accelerations, solver, h);
        worst = chain.places.iter().fold(worst, |worst: f64, x| if x.is_finite() { worst.max(x.abs()) } else { f64::INFINITY });
    }
    worst
}

/// The same with the shipped engine.
pub fn sag_by_engine(masses: &[f64], seconds: f64, h: f64) -> f64 {
    let bodies = masses.iter().enumerate().map(|(i, &mass)| shipped::crate_at(0.0, i as f64, mass));
    let Ok(mut world) = World::new(shipped::on_floor(G, 1.0, bodies.collect())) else { return f64::NAN };
    let mut worst: f64 = 0.0;
    for _ in 0..(seconds / h).round() as u64 {
        world.step(h);
        let moved = world.bodies().iter().enumerate().map(|(i, body)| (body.position.y + 0.5 + i as f64).abs());
        worst = moved.fold(worst, f64::max);
    }
    worst
}

fn standing(name: &'static str, title: String, masses: Vec<f64>) -> Scene {
    let mut scene = Scene::new(name, title, SECONDS, masses.len()).measuring("largest movement of a body at rest, m");
    for (name, solver) in SOLVERS {
        let masses = masses.clone();
        scene = scene.method(name, move |h| sag_by_hand(&masses, solver, SECONDS, h));
    }
    scene.shipped(move |h| sag_by_engine(&masses, SECONDS, h))
}

/// Equal blocks, one on the other.
pub fn column() -> Scene {
    standing("column", format!("A column of {COLUMN} equal blocks, 10 s"), vec![1.0; COLUMN])
}

/// Ten thousand times its weight.
pub fn heavy_on_light() -> Scene {
    standing("heavy-on-light", "10 000 kg resting on 1 kg, 10 s".to_owned(), vec![1.0, 10_000.0])
}

/// The worst error of a place in a row that is pushed along a floor, by hand. Every block slides from the first step on.
pub fn row_by_hand(n: usize, solver: Solver, seconds: f64, h: f64) -> f64 {
    let friction = Material::ASPHALT.kinetic_friction * G;
    let mut chain = Chain::new(&vec![1.0; n], false);
    let mut accelerations = vec![-friction; n];
    accelerations[0] += push(n);
    let mut worst = 0.0;
    let steps = (seconds / h).round() as u64;
    for step in 1..=steps {
        chain.step(&accelerations, solver, h);
        // Of a method of first order only what the solver adds shall count: its steps are a parabola of h more.
        let t = step as f64 * h;
        let exact = 0.5 * ROW_ACCELERATION * t * (t + h / substeps(solver));
        worst = chain.places.iter().fold(worst, |worst: f64, x| worst.max((x - exact).abs()));
    }
    worst
}

fn substeps(solver: Solver) -> f64 {
    if let Solver::Substeps(parts) = solver { f64::from(parts) } else { 1.0 }
}

/// The force on the first block of 1 kg that makes `n` of them move with [`ROW_ACCELERATION`], N.
fn push(n: usize) -> f64 {
    n as f64 * (ROW_ACCELERATION + Material::ASPHALT.kinetic_friction * G)
}

/// The same with the shipped engine.
pub fn row_by_engine(n: usize, seconds: f64, h: f64) -> f64 {
    // In motion already, so that it is kinetic friction that acts from the first tick on, as in the chain.
    let start = 1e-3;
    let row = (0..n).map(|i| BodyDef { velocity: DVec2::new(start, 0.0), ..shipped::crate_at(i as f64, 0.0, 1.0) });
    let Ok(mut world) = World::new(shipped::on_floor(G, 1.0, row.collect())) else { return f64::NAN };
    world.set_drive(BodyId(0), DVec2::new(push(n), 0.0));
    let mut worst = 0.0;
    for step in 1..=(seconds / h).round() as u64 {
        world.step(h);
        let t = step as f64 * h;
        let exact = start * t + 0.5 * ROW_ACCELERATION * t * t;
        let errors = world.bodies().iter().enumerate().map(|(i, body)| (body.position.x - i as f64 - exact).abs());
        worst = errors.fold(worst, f64::max);
    }
    worst
}

/// Twenty blocks pushed from behind.
pub fn pushed_row() -> Scene {
    let seconds = 1.0;
    let mut scene = Scene::new("pushed-row", format!("A row of {ROW} blocks pushed along a floor, 1 s"), seconds, ROW)
        .measuring("worst error of a position, m");
    for (name, solver) in SOLVERS {
        scene = scene.method(name, move |h| row_by_hand(ROW, solver, seconds, h));
    }
    scene.shipped(move |h| row_by_engine(ROW, seconds, h))
}
