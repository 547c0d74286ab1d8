//! How long the crowd step takes: raining, settled, flying. Times are of whole runs; divide by bodies and steps.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use resultant::physics::{Aabb, BodyDef, Material, Plan, SurfaceDef, World, WorldDef};
use std::hint::black_box;

const DT: f64 = 1.0 / 60.0;
/// Ten seconds.
const RAIN_STEPS: usize = 600;
/// Forty seconds, after which even the liveliest rest.
const SETTLED_STEPS: usize = 2400;
const FLIGHT_STEPS: usize = 300;

/// Boxes of 0.3 to 0.6 m raining into a pit, restitutions from 0 to the one given.
fn rain(n: usize, masses: std::ops::RangeInclusive<f64>, restitution: f64) -> WorldDef {
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let columns = (n as f64).sqrt().ceil() as usize;
    let width = columns as f64 * 0.7;
    let bodies = (0..n)
        .map(|i| BodyDef {
            half: DVec2::new(random.random_range(0.15..0.3), random.random_range(0.15..0.3)),
            position: DVec2::new(0.35 + 0.7 * (i % columns) as f64, -1.0 - 0.8 * (i / columns) as f64),
            velocity: DVec2::new(random.random_range(-2.0..2.0), 0.0),
            mass: random.random_range(masses.clone()),
            restitution: restitution * random.random_range(0.0..1.0),
            ..BodyDef::default()
        })
        .collect();
    let surface = |left, top, right, bottom| {
        SurfaceDef::fixed(Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom)), Material::ASPHALT)
    };
    let surfaces =
        vec![surface(-5.0, 0.0, width + 5.0, 1.0), surface(-1.0, -2000.0, 0.0, 0.0), surface(width, -2000.0, width + 1.0, 0.0)];
    WorldDef { bodies, surfaces, gravity: 9.81, air_density: 0.0, rest_speed: 1.0, ..WorldDef::default() }
}

fn shower(air_density: f64) -> WorldDef {
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let bodies = (0..10_000)
        .map(|i| BodyDef {
            position: DVec2::new(f64::from(i % 100), f64::from(i / 100)) * 3.0,
            // Too slow to meet within the run.
            velocity: DVec2::new(random.random_range(-0.1..0.1), random.random_range(-0.1..0.1)),
            mass: 10.0,
            drag: 0.5,
            ..BodyDef::default()
        })
        .collect();
    WorldDef { bodies, gravity: 9.81, air_density, ..WorldDef::default() }
}

/// A world of which every island takes the crowd step.
fn crowd(def: WorldDef, sleep: bool) -> World {
    let plan = Plan { dense: true, direct: sleep, ..Plan::of(&def) };
    World::with_plan(def, plan).expect("the scene is valid")
}

fn run(criterion: &mut Criterion, name: &str, def: WorldDef, steps: usize) {
    let new = || crowd(def.clone(), false);
    criterion.bench_function(name, |bencher| {
        bencher.iter_batched_ref(new, |pile| (0..steps).for_each(|_| pile.step(DT)), BatchSize::PerIteration);
    });
}

fn piles(criterion: &mut Criterion) {
    let (alike, mixed) = (1.0..=1.0, 0.5..=50.0);
    for n in [100, 1000, 5000] {
        run(criterion, &format!("rain {n}"), rain(n, alike.clone(), 0.0), RAIN_STEPS);
        run(criterion, &format!("rain {n}, mixed masses"), rain(n, mixed.clone(), 0.0), RAIN_STEPS);
        run(criterion, &format!("rain {n}, mixed restitutions"), rain(n, alike.clone(), 0.8), RAIN_STEPS);
        run(criterion, &format!("rain {n}, mixed masses and restitutions"), rain(n, mixed.clone(), 0.8), RAIN_STEPS);
        for (name, sleep) in [("asleep", true), ("kept awake", false)] {
            let mut settled = crowd(rain(n, alike.clone(), 0.8), sleep);
            (0..SETTLED_STEPS).for_each(|_| settled.step(DT));
            let name = format!("settled {n}, mixed restitutions, {name}, one step");
            criterion.bench_function(&name, |bencher| bencher.iter(|| black_box(&mut settled).step(DT)));
        }
    }
    run(criterion, "flight 10 000", shower(0.0), FLIGHT_STEPS);
    run(criterion, "flight 10 000 with drag", shower(1.2041), FLIGHT_STEPS);
}

criterion_group! { name = benches; config = Criterion::default().sample_size(10); targets = piles }
criterion_main!(benches);
