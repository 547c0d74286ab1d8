//! What the plan saves: one second of each shipped level, engine on and off, with the parts that it needs and with all of them.

use criterion::{Criterion, criterion_group, criterion_main};
use resultant::physics::{BodyId, DVec2, Plan, World, WorldDef};
use std::hint::black_box;
use std::path::Path;

fn second(mut world: World) -> World {
    for tick in 0..120 {
        world.set_drive(BodyId(0), DVec2::new(200.0, -2000.0) * f64::from(tick / 40 % 2));
        world.step(1.0 / 120.0);
    }
    world
}

fn compare(c: &mut Criterion, name: &str, def: &WorldDef) {
    let mut group = c.benchmark_group(name);
    for (parts, plan) in [("planned", Plan::of(def)), ("every part", Plan::EVERYTHING)] {
        let Ok(world) = World::with_plan(def.clone(), plan) else { continue };
        group.bench_function(parts, |b| b.iter(|| second(black_box(world.clone()))));
    }
    group.finish();
}

fn levels(c: &mut Criterion) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in ["1", "2", "3"] {
        let Ok(loaded) = resultant::level::load(&root.join("levels").join(name), root) else { continue };
        let def = loaded.level.world_def();
        compare(c, &format!("level {name}"), &def);
        compare(c, &format!("level {name} without air"), &WorldDef { air_density: 0.0, ..def });
    }
}

criterion_group!(benches, levels);
criterion_main!(benches);
