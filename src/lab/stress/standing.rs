//! Solvers of resting contacts fail at unequal masses and in tall columns, methods of impact at thin obstacles and at many contacts at one instant.

use super::{G, StressTest, Trial, picture::FailurePicture};
use crate::lab::contract::{By, Model};
use crate::lab::methods::chain::{Solver, sweeps_needed, swept_loads, weights, worst_load};
use crate::lab::scenes::collisions::{BlockLine, METHODS, Meeting, STEPS, STRIKE, THIN};
use crate::physics::{BodyId, ForceKind, World};
use crate::{lab::TICK, lab::methods::impact::ImpactStep, lab::scenes::stacks::ContactChain};

/// m. The overlap that a resting pair may show at any tick.
pub const OVERLAP: f64 = 1e-6;
/// Relative tolerance of a resting contact's force, of the shipped engine.
pub const FORCE: f64 = 1e-9;
/// Relative tolerance for sweeps.
const SWEPT_FORCE: f64 = 0.01;
const SWEEPS: [u32; 4] = [10, 50, 500, 5000];
/// The solvers that have 2 s to find the forces.
const AT_REST: [(&str, Solver); 5] = [
    ("impulses, 20 sweeps, warm, after 2 s", Solver::Sweeps { sweeps: 20, warm: true }),
    ("impulses, 20 substeps, after 2 s", Solver::Substeps(20)),
    ("soft contacts, 4 substeps, after 2 s", Solver::Soft(4)),
    ("XPBD, 20 substeps, after 2 s", Solver::Positions(20)),
    ("direct", Solver::Direct),
];
/// s. Bodies rest for this time.
const RESTING: f64 = 2.0;
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

/// The places of the first `blocks` over the steps since `first`.
fn with_paths(picture: FailurePicture, paths: &[Vec<f64>], blocks: usize, first: usize) -> FailurePicture {
    let path =
        |block: usize| paths.iter().enumerate().skip(first).filter_map(move |(i, places)| Some((i as f64, *places.get(block)?)));
    (0..blocks).fold(picture, |picture, block| picture.found(path(block)))
}

/// The places of box and obstacle over the steps in which they meet, at the first phase of the step that fails.
fn met(by: By<ImpactStep>, meeting: Meeting) -> FailurePicture {
    let (line, met) = meeting.at_phase(meeting.fails_at(by, TICK).unwrap_or(0), TICK);
    let end = STEPS as f64;
    let (found, thin) = (line.paths(by, end * TICK, TICK), line.blocks[1].x);
    let (box_after, thin_after) = meeting.parting();
    let exact = |x: f64, before: f64, after: f64| {
        let at = |steps: f64| (steps, x + before * met.min(steps * TICK) + after * (steps * TICK - met).max(0.0));
        [0.0, met / TICK, end].map(at)
    };
    let picture = FailurePicture::of("steps", "place, m").exact(exact(line.blocks[0].x, meeting.speed, box_after));
    if meeting.mass.is_infinite() {
        let half = 0.5 * THIN;
        with_paths(picture, &found, 1, 0).solid(thin - half, thin + half)
    } else {
        with_paths(picture, &found, 2, 0).exact(exact(thin, 0.0, thin_after))
    }
}

fn tunnels(name: &'static str, mass: f64) -> StressTest {
    let picture = move |by, speed| met(by, Meeting { speed, mass });
    let methods = Trial::all_showing(METHODS, move |by, speed| Meeting { speed, mass }.fails_at(by, TICK).is_none(), picture);
    StressTest::of(name, "speed at h = 1/60 s, m/s", (1.0, 1e6), methods)
}

pub fn tunnelling() -> StressTest {
    tunnels("0.5 m box against a 0.1 m wall", f64::INFINITY)
}

pub fn tunnelling_of_bodies() -> StressTest {
    tunnels("0.5 m box against a 0.1 m plate that can move", 3.0)
}

/// s. The strike comes after two thirds of a second.
const STRUCK: f64 = 1.0;
/// Bodies beside the cradle in a crowd: in the engine the cradle is an island of its own.
const CROWD: usize = 200;

/// The velocities of a cradle of `n` after the strike, in units of the first one's.
pub fn cradle(by: By<ImpactStep>, n: usize) -> Vec<f64> {
    struck_velocities(by, &BlockLine::cradle(n))
}

fn struck_velocities(by: By<ImpactStep>, cradle: &BlockLine) -> Vec<f64> {
    let blocks = cradle.end(by, STRUCK, TICK).unwrap_or_default();
    blocks.iter().map(|block| block.v / STRIKE).collect()
}

fn last_leaves(velocities: &[f64]) -> bool {
    let last = velocities.len().saturating_sub(1);
    !velocities.is_empty() && velocities.iter().enumerate().all(|(i, v)| (v - f64::from(u8::from(i == last))).abs() <= 1e-9)
}

/// The places of all blocks from half a strike on, and the exact ones.
fn struck(by: By<ImpactStep>, cradle: &BlockLine) -> FailurePicture {
    let (steps, meet) = (STRUCK / TICK, 2.0 / STRIKE / TICK);
    let first = (steps / 2.0) as usize;
    let blocks = cradle.blocks.len();
    let paths = cradle.paths(by, STRUCK, TICK);
    let exact = |picture: FailurePicture, block: usize| {
        picture.exact([first as f64, meet, steps].map(|step| (step, cradle.cradle_place(block, step * TICK))))
    };
    (0..blocks).fold(with_paths(FailurePicture::of("steps", "places, m"), &paths, blocks, first), exact)
}

/// A cradle's pattern: 0, …, 0, v.
fn cradles(name: &'static str, crowd: usize) -> StressTest {
    let cradle = move |n: f64| BlockLine { crowd, ..BlockLine::cradle(n.floor() as usize) };
    let survives = move |by, n| last_leaves(&struck_velocities(by, &cradle(n)));
    let methods = Trial::all_showing(METHODS, survives, move |by, n| struck(by, &cradle(n)));
    StressTest { whole: true, ..StressTest::of(name, "blocks, at h = 1/60 s", (2.0, 20.0), methods) }
}

pub fn simultaneous_impacts() -> StressTest {
    cradles("cradle: the last leaves alone", 0)
}

pub fn simultaneous_impacts_in_a_crowd() -> StressTest {
    cradles("the same among 200 others", CROWD)
}
