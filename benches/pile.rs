//! How long the pile engine takes: raining, settled, flying. Times are of whole runs; divide by bodies and steps.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use glam::DVec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use resultant::physics::Aabb;
use resultant::physics::pile::{Pile, PileBody, PileDef, PileSurface};
use std::hint::black_box;

const DT: f64 = 1.0 / 60.0;
/// Ten seconds.
const RAIN_STEPS: usize = 600;
/// Forty seconds, after which even the liveliest rest.
const SETTLED_STEPS: usize = 2400;
const FLIGHT_STEPS: usize = 300;

/// Boxes of 0.3 to 0.6 m raining into a pit, restitutions from 0 to the one given.
fn rain(n: usize, masses: std::ops::RangeInclusive<f64>, restitution: f64, sleep: bool) -> PileDef {
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let columns = (n as f64).sqrt().ceil() as usize;
    let width = columns as f64 * 0.7;
    let bodies = (0..n)
        .map(|i| PileBody {
            half: DVec2::new(random.random_range(0.15..0.3), random.random_range(0.15..0.3)),
            position: DVec2::new(0.35 + 0.7 * (i % columns) as f64, -1.0 - 0.8 * (i / columns) as f64),
            velocity: DVec2::new(random.random_range(-2.0..2.0), 0.0),
            mass: random.random_range(masses.clone()),
            restitution: restitution * random.random_range(0.0..1.0),
            ..PileBody::default()
        })
        .collect();
    let surface = |left, top, right, bottom| PileSurface {
        bounds: Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom)),
        static_friction: 0.9,
        kinetic_friction: 0.65,
    };
    let surfaces =
        vec![surface(-5.0, 0.0, width + 5.0, 1.0), surface(-1.0, -2000.0, 0.0, 0.0), surface(width, -2000.0, width + 1.0, 0.0)];
    PileDef { bodies, surfaces, sleep, ..PileDef::default() }
}

fn shower(air_density: f64) -> PileDef {
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let bodies = (0..10_000)
        .map(|i| PileBody {
            position: DVec2::new(f64::from(i % 100), f64::from(i / 100)) * 3.0,
            // Too slow to meet within the run.
            velocity: DVec2::new(random.random_range(-0.1..0.1), random.random_range(-0.1..0.1)),
            mass: 10.0,
            drag_area: DVec2::splat(0.5),
            ..PileBody::default()
        })
        .collect();
    PileDef { bodies, air_density, sleep: false, ..PileDef::default() }
}

fn run(criterion: &mut Criterion, name: &str, def: PileDef, steps: usize) {
    let new = || Pile::new(def.clone()).expect("the scene is valid");
    criterion.bench_function(name, |bencher| {
        bencher.iter_batched_ref(new, |pile| (0..steps).for_each(|_| pile.step(DT)), BatchSize::PerIteration);
    });
}

fn piles(criterion: &mut Criterion) {
    let (alike, mixed) = (1.0..=1.0, 0.5..=50.0);
    for n in [100, 1000, 5000] {
        run(criterion, &format!("rain {n}"), rain(n, alike.clone(), 0.0, false), RAIN_STEPS);
        run(criterion, &format!("rain {n}, mixed masses"), rain(n, mixed.clone(), 0.0, false), RAIN_STEPS);
        run(criterion, &format!("rain {n}, mixed restitutions"), rain(n, alike.clone(), 0.8, false), RAIN_STEPS);
        run(criterion, &format!("rain {n}, mixed masses and restitutions"), rain(n, mixed.clone(), 0.8, false), RAIN_STEPS);
        for (name, sleep) in [("asleep", true), ("kept awake", false)] {
            let mut settled = Pile::new(rain(n, alike.clone(), 0.8, sleep)).expect("the scene is valid");
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
