//! What the plan saves, part by part: one second of a scene that does not need a part, without it and with it; and one second of scenes in
//! which little changes, with direct answers and without.

use criterion::{Criterion, criterion_group, criterion_main};
use resultant::game::{Game, Inputs, SHIP, TICK_RATE};
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, ForceKind, Material, Plan, SurfaceDef, World, WorldDef};
use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;

/// Ticks of a second.
const TICKS: usize = TICK_RATE as usize;

/// A part of the model: its name, and how to switch it on.
type Part = (&'static str, fn(&mut Plan));
const PARTS: [Part; 4] = [
    ("air", |plan| plan.air = true),
    ("streams", |plan| plan.streams = true),
    ("liquids", |plan| plan.liquids = true),
    ("restitution", |plan| plan.bounces = true),
];

/// A world stepped by what drives body 0 in each tick, N.
fn run(mut world: World, drives: &[DVec2]) -> World {
    for &drive in drives {
        world.set_drive(SHIP, drive);
        world.step(1.0 / TICK_RATE);
    }
    world
}

fn compare(c: &mut Criterion, name: &str, def: &WorldDef, drives: &[DVec2], plans: &[(String, Plan)]) {
    let mut group = c.benchmark_group(name);
    for (parts, plan) in plans {
        let Ok(world) = World::with_plan(def.clone(), plan.clone()) else { continue };
        group.bench_function(parts, |b| b.iter(|| run(black_box(world.clone()), drives)));
    }
    group.finish();
}

fn block(x: f64, y: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, -0.5 - y), ..BodyDef::default() }
}

fn world(bodies: Vec<BodyDef>, floor: bool) -> WorldDef {
    let floor = floor.then(|| SurfaceDef::fixed(Aabb::new(DVec2::new(-1e3, 0.0), DVec2::new(1e3, 1.0)), Material::ICE));
    WorldDef { air_density: 0.0, bodies, surfaces: floor.into_iter().collect(), ..WorldDef::default() }
}

/// Each part on its own, added to a scene that does without.
fn parts(c: &mut Criterion) {
    let flight = world(vec![BodyDef { velocity: DVec2::new(3.0, -20.0), ..block(0.0, 50.0) }], false);
    let slide = world(vec![BodyDef { velocity: DVec2::new(40.0, 0.0), ..block(0.0, 0.0) }], true);
    for (name, def) in [("flight", flight), ("slide", slide)] {
        let planned = Plan::of(&def);
        let mut plans = vec![("planned".to_owned(), planned.clone())];
        for (part, switch) in PARTS {
            let mut plan = planned.clone();
            switch(&mut plan);
            if plan != planned {
                plans.push((format!("and {part}"), plan));
            }
        }
        plans.push(("every part, nothing direct".to_owned(), Plan::EVERYTHING));
        compare(c, name, &def, &[DVec2::ZERO; TICKS], &plans);
    }
}

/// Direct answers against computing everything in every tick.
fn direct(c: &mut Criterion) {
    let plans = |def: &WorldDef| {
        let planned = Plan::of(def);
        let indirect = Plan { direct: false, ..planned.clone() };
        [("direct".to_owned(), planned), ("nothing direct".to_owned(), indirect)]
    };
    let aloft = BodyDef { velocity: DVec2::new(1.0, -20.0), ..block(100.0, 200.0) };
    let column = world((0..30).map(|i| block(0.0, f64::from(i))).chain([aloft]).rev().collect(), true);
    compare(c, "a column of 30 under a flight", &column, &[DVec2::ZERO; TICKS], &plans(&column));
    let row = world((0..20).map(|i| block(f64::from(i), 0.0)).collect(), true);
    compare(c, "a pushed row of 20", &row, &[DVec2::new(400.0, 0.0); TICKS], &plans(&row));
    let root = &Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    for name in ["1", "2", "3"] {
        let folder = root.join("levels").join(name);
        let Ok(loaded) = resultant::level::load(&folder, root) else { continue };
        let def = loaded.level.world_def();
        let drives = recorded(Arc::new(loaded.level), &folder.join("flights/careful.replay.csv"));
        compare(c, &format!("the flight of level {name}"), &def, &drives, &plans(&def));
    }
}

/// The drive of the ship in each tick of a recorded flight, N.
fn recorded(level: Arc<resultant::level::Level>, inputs: &Path) -> Vec<DVec2> {
    let text = std::fs::read_to_string(inputs).unwrap_or_default();
    let (Ok(mut game), Ok(inputs)) = (Game::new(level), Inputs::parse("inputs", &text)) else { return Vec::new() };
    let mut tick = |controls| {
        game.step(controls);
        game.world().forces(BodyId(0)).total(ForceKind::Drive)
    };
    inputs.into_iter().map(&mut tick).collect()
}

criterion_group!(benches, parts, direct);
criterion_main!(benches);
