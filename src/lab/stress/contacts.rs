//! Where contact methods fail: thin things, unequal masses, tall columns, many contacts at one instant.

use super::{G, Rows, Survival, TICK};
use crate::lab::methods::chain::{Chain, Solver, sweeps_needed};
use crate::lab::methods::impact::{Block, Line};
use crate::lab::scenes::{collisions, stacks, tunnelling};
use crate::lab::shipped;
use crate::physics::{BodyDef, BodyId, DVec2, ForceKind, Plan, World};

/// m. The overlap that a resting pair may show at any tick.
pub const OVERLAP: f64 = 1e-6;
/// Relative: how right a resting contact's force has to be, of the shipped engine.
pub const FORCE: f64 = 1e-9;
/// Relative: how right it has to be for sweeps.
const SWEPT_FORCE: f64 = 0.01;
/// Sweeps of the solvers in the table.
const SWEEPS: [u32; 4] = [10, 50, 500, 5000];
/// Those that have 2 s to find the forces.
const AT_REST: [(&str, Solver); 3] = [
    ("impulses, 20 sweeps, warm, after 2 s", Solver::Sweeps { sweeps: 20, warm: true }),
    ("impulses, 20 substeps, after 2 s", Solver::Substeps(20)),
    ("direct", Solver::Direct),
];
/// s. How long things have to rest.
const RESTING: f64 = 2.0;

/// Whether a box of 0.5 m never gets through something of 0.1 m and `mass` (kg; infinite: a wall) at 60 Hz, by hand.
pub fn stays_out(line: Line, speed: f64, mass: f64) -> bool {
    tunnelling::holds(&|blocks, seconds, h| collisions::by_hand(line, blocks, seconds, h), speed, mass, TICK)
}

/// The same by the shipped engine.
pub fn shipped_stays_out(speed: f64, mass: f64) -> bool {
    tunnelling::holds(&|blocks, seconds, h| collisions::by_engine(&blocks, seconds, h), speed, mass, TICK)
}

fn tunnels(test: &'static str, mass: f64) -> Vec<Survival> {
    let range = (1.0, 1e6);
    let mut rows = Rows::of(test, "speed at 60 Hz, m/s");
    for (name, line) in collisions::METHODS {
        rows = rows.method(name, range, |speed| stays_out(line, speed, mass));
    }
    rows.shipped(range, |speed| shipped_stays_out(speed, mass))
}

/// A wall.
pub fn tunnelling() -> Vec<Survival> {
    tunnels("0.5 m box against a 0.1 m wall", f64::INFINITY)
}

/// Something that can move.
pub fn tunnelling_of_bodies() -> Vec<Survival> {
    tunnels("0.5 m box against a 0.1 m plate that can move", 3.0)
}

/// Whether a column of these masses stands with the shipped engine: nothing moves, and every reaction is the weight above.
pub fn stands(masses: &[f64]) -> bool {
    let bodies = masses.iter().enumerate().map(|(i, &mass)| shipped::crate_at(0.0, i as f64, mass));
    let Ok(mut world) = World::new(shipped::on_floor(G, 1.0, bodies.collect())) else { return false };
    (0..(RESTING / TICK) as u32).all(|_| {
        world.step(TICK);
        let mut above = 0.0;
        (0..masses.len()).rev().all(|i| {
            let id = BodyId(i as u32);
            let carried = above;
            above += masses[i] * G;
            // Its reactions from below and from above; the latter is the weight of what it carries.
            let reaction = -world.forces(id).total(ForceKind::Reaction).y - world.forces(id).total(ForceKind::Push).y;
            let still = (world.body(id).position.y + 0.5 + i as f64).abs() <= OVERLAP;
            still && (reaction - (above - carried)).abs() <= FORCE * above
        })
    })
}

/// Whether a column of these masses that has rested for a while is carried by the right impulses, to 1 %, solved by hand.
pub fn carries(masses: &[f64], solver: Solver) -> bool {
    let mut chain = Chain::new(masses, true);
    let mut accelerations = vec![-G; masses.len() + 1];
    accelerations[0] = 0.0;
    for _ in 0..(RESTING / TICK) as u32 {
        chain.step(&accelerations, solver, TICK);
    }
    let parts = if let Solver::Substeps(parts) = solver { f64::from(parts) } else { 1.0 };
    let weight = |i: usize| masses[i..].iter().sum::<f64>() * G * TICK / parts;
    chain.impulses.iter().enumerate().all(|(i, impulse)| (impulse / weight(i) - 1.0).abs() <= SWEPT_FORCE)
}

/// R times its mass on a block.
pub fn heavy_on_light() -> Vec<Survival> {
    let mut rows = Rows::of("heavy on light: forces to 1 %", "mass ratio R");
    for sweeps in SWEEPS {
        rows = rows.method(format!("impulses from cold, {sweeps} sweeps"), (1.0, 1e8), |ratio| {
            sweeps_needed(&[1.0, ratio], SWEPT_FORCE, sweeps).is_some()
        });
    }
    for (name, solver) in AT_REST {
        rows = rows.method(name, (1.0, 1e8), |ratio| carries(&[1.0, ratio], solver));
    }
    rows.shipped((1.0, 1e8), |ratio| stands(&[1.0, ratio]))
}

/// N equal blocks.
pub fn columns() -> Vec<Survival> {
    let mut rows = Rows::of("column: forces to 1 %", "equal blocks N");
    let column = |n: f64| vec![1.0; n.floor() as usize];
    for sweeps in SWEEPS {
        rows = rows.method(format!("impulses from cold, {sweeps} sweeps"), (1.0, 200.0), |n| {
            sweeps_needed(&column(n), SWEPT_FORCE, sweeps).is_some()
        });
    }
    for (name, solver) in AT_REST {
        rows = rows.method(name, (1.0, 200.0), |n| carries(&column(n), solver));
    }
    let mut rows = rows.shipped((1.0, 200.0), |n| stands(&column(n)));
    for row in &mut rows {
        row.largest = row.largest.floor();
    }
    rows
}

/// The velocities after the cradle of `n` has been struck, in units of the first one's.
pub fn cradle(run: impl Fn(Vec<Block>) -> Vec<Block>, n: usize) -> Vec<f64> {
    run(collisions::cradle_of(n)).iter().map(|block| block.v / collisions::STRIKE).collect()
}

/// s. The strike comes after two thirds of a second.
const STRUCK: f64 = 1.0;

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

/// A cradle's pattern: 0, …, 0, v.
pub fn simultaneous_impacts() -> Vec<Survival> {
    let range = (2.0, 20.0);
    let count = |n: f64| n.floor() as usize;
    let mut rows = Rows::of("cradle: the last leaves alone", "blocks");
    for (name, line) in collisions::METHODS {
        rows = rows.method(name, range, |n| last_leaves(&cradle_by_hand(line, count(n))));
    }
    let mut rows = rows.shipped(range, |n| last_leaves(&cradle_by_engine(count(n))));
    for row in &mut rows {
        row.largest = row.largest.floor();
    }
    rows
}

/// By the shipped engine's dense method, the one for crowds, among 200 blocks that rest side by side.
pub fn cradle_in_a_crowd(n: usize) -> Vec<f64> {
    let mut def = shipped::line(&collisions::cradle_of(n), 1.0);
    let resting = |i: usize| BodyDef { position: DVec2::new(i as f64, 10.0), ..BodyDef::default() };
    def.bodies.extend((0..CROWD).map(resting));
    let plan = Plan { dense: true, ..Plan::of(&def) };
    let Ok(mut world) = World::with_plan(def, plan) else { return Vec::new() };
    for _ in 0..(STRUCK / TICK).round() as u32 {
        world.step(TICK);
    }
    world.bodies().iter().take(n).map(|body| body.velocity.x / collisions::STRIKE).collect()
}

/// Blocks beside the cradle in a crowd.
const CROWD: usize = 200;

/// A cradle's pattern where many others are stepped with it.
pub fn simultaneous_impacts_in_a_crowd() -> Vec<Survival> {
    let range = (2.0, 20.0);
    let count = |n: f64| n.floor() as usize;
    let mut rows = Rows::of("the same among 200 others, stepped densely", "blocks");
    for (name, line) in collisions::METHODS {
        rows = rows.method(name, range, |n| last_leaves(&cradle_by_hand(line, count(n))));
    }
    let mut rows = rows.shipped(range, |n| last_leaves(&cradle_in_a_crowd(count(n))));
    for row in &mut rows {
        row.largest = row.largest.floor();
    }
    rows
}

/// The sag of a resting pair of 1 kg and `ratio` kg with the shipped engine, m.
pub fn shipped_sag(ratio: f64) -> f64 {
    stacks::sag_by_engine(&[1.0, ratio], RESTING, TICK)
}
