//! Solvers of resting contacts fail at unequal masses and in tall columns.

use super::picture::FailurePicture;
use super::{G, StressTest, TICK, Trial};
use crate::lab::contract::{By, Model};
use crate::lab::methods::chain::{Solver, sweeps_needed, swept_loads, weights, worst_load};
use crate::lab::scenes::stacks::ContactChain;
use crate::physics::{BodyId, ForceKind, World};

/// m. The overlap that a resting pair may show at any tick.
pub const OVERLAP: f64 = 1e-6;
/// Relative tolerance of a resting contact's force, of the shipped engine.
pub const FORCE: f64 = 1e-9;
/// Relative tolerance for sweeps.
const SWEPT_FORCE: f64 = 0.01;
const SWEEPS: [u32; 4] = [10, 50, 500, 5000];
/// The solvers that have 2 s to find the forces.
const AT_REST: [(&str, Solver); 3] = [
    ("impulses, 20 sweeps, warm, after 2 s", Solver::Sweeps { sweeps: 20, warm: true }),
    ("impulses, 20 substeps, after 2 s", Solver::Substeps(20)),
    ("direct", Solver::Direct),
];
/// s. Bodies rest for this time.
const RESTING: f64 = 2.0;
/// The upward label of every picture.
const LOAD: &str = "worst force / right one";

/// The force that carries a body itself, N: the reaction from below without the push of the bodies above, which is their weight.
fn carried(world: &World, body: usize) -> f64 {
    let forces = world.forces(BodyId(body as u32));
    -forces.total(ForceKind::Reaction).y - forces.total(ForceKind::Push).y
}

/// Whether a column of these masses stands with the shipped engine: nothing moves, and every reaction is the weight above.
pub fn stands(masses: &[f64]) -> bool {
    let Some(mut world) = ContactChain::standing(masses.to_vec()).world() else { return false };
    let above = weights(masses);
    (0..(RESTING / TICK) as u32).all(|_| {
        world.step(TICK);
        (0..masses.len()).all(|i| {
            let still = (world.body(BodyId(i as u32)).position.y + 0.5 + i as f64).abs() <= OVERLAP;
            still && (carried(&world, i) - masses[i] * G).abs() <= FORCE * above[i] * G
        })
    })
}

/// The load furthest from its exact value after each tick, with its time (s), by the shipped engine.
fn shipped_loads(masses: &[f64]) -> Vec<(f64, f64)> {
    let Some(mut world) = ContactChain::standing(masses.to_vec()).world() else { return Vec::new() };
    let exact: Vec<f64> = masses.iter().map(|mass| mass * G).collect();
    let after_step = |tick: u32| {
        world.step(TICK);
        let found: Vec<f64> = (0..masses.len()).map(|i| carried(&world, i)).collect();
        (f64::from(tick) * TICK, worst_load(&found, &exact))
    };
    (1..=(RESTING / TICK) as u32).map(after_step).collect()
}

/// The same by hand.
fn loads(masses: &[f64], solver: Solver) -> Vec<(f64, f64)> {
    let exact: Vec<f64> = weights(masses).iter().map(|mass| mass * G * TICK / f64::from(solver.parts())).collect();
    let column = ContactChain::standing(masses.to_vec());
    column.running(By::Hand(solver), TICK).each(RESTING, |t, chain| (t, worst_load(&chain.impulses, &exact))).collect()
}

/// Whether a column of these masses, after a while at rest and solved by hand, shows the right impulses, to 1 %.
pub fn carries(masses: &[f64], solver: Solver) -> bool {
    loads(masses, solver).last().is_some_and(|(_, load)| (load - 1.0).abs() <= SWEPT_FORCE)
}

fn solvers(column: fn(f64) -> Vec<f64>) -> Vec<Trial> {
    let over_time = |loads: Vec<(f64, f64)>| FailurePicture::of("time, s", LOAD).found(loads).within(1.0, SWEPT_FORCE);
    let from_cold = SWEEPS.map(|sweeps| {
        let survives = move |value| sweeps_needed(&column(value), SWEPT_FORCE, sweeps).is_some();
        Trial::new(format!("impulses from cold, {sweeps} sweeps"), survives).showing(move |value| {
            let loads = (1..=sweeps).map(f64::from).zip(swept_loads(&column(value)));
            FailurePicture::of("sweeps", LOAD).found(loads).within(1.0, SWEPT_FORCE)
        })
    });
    let at_rest = AT_REST.map(|(name, solver)| {
        Trial::new(name, move |value| carries(&column(value), solver))
            .showing(move |value| over_time(loads(&column(value), solver)))
    });
    let shipped = Trial::shipped(move |value| stands(&column(value)));
    let shipped = shipped.showing(move |value| over_time(shipped_loads(&column(value))));
    from_cold.into_iter().chain(at_rest).chain([shipped]).collect()
}

pub fn heavy_on_light() -> StressTest {
    let methods = solvers(|ratio| vec![1.0, ratio]);
    StressTest::of("heavy on light: forces to 1 %", "mass ratio R at h = 1/60 s", (1.0, 1e8), methods)
}

pub fn columns() -> StressTest {
    let methods = solvers(|n| vec![1.0; n.floor() as usize]);
    let test = StressTest::of("column: forces to 1 %", "equal blocks N at h = 1/60 s", (1.0, 200.0), methods);
    StressTest { whole: true, ..test }
}

/// The sag of a resting pair of 1 kg and `ratio` kg with the shipped engine, m.
pub fn shipped_sag(ratio: f64) -> f64 {
    ContactChain::standing(vec![1.0, ratio]).sag(By::Engine, RESTING, TICK)
}
