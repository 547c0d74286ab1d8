//! Scenes made to be slow: what their ticks take, in time on the processor, of three runs the shortest each.

use crate::random::Random;
use cpu_time::ThreadTime;
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, FluidDef, Material, StreamDef, SurfaceDef, World, WorldDef};

const TICK: f64 = 1.0 / 120.0;
const RUNS: usize = 3;
/// s. The bars.
const MEAN: f64 = 50e-6;
const WORST: f64 = 1e-3;

/// A scene, and the force on its first body, N.
struct Scene {
    name: String,
    def: WorldDef,
    drive: DVec2,
    ticks: usize,
}

/// Prints what the scenes take whose names hold that part.
pub fn table(part: &str) {
    println!("| scene | bodies | mean µs | worst µs | at tick | budgets used up | valid |\n|---|---|---|---|---|---|---|");
    let mut missed = 0;
    for scene in scenes().into_iter().filter(|scene| scene.name.contains(part)) {
        let runs: Vec<(Vec<f64>, World, String)> = (0..RUNS).map(|_| run(&scene)).collect();
        let ticks: Vec<f64> = (0..scene.ticks).map(|t| runs.iter().map(|run| run.0[t]).fold(f64::INFINITY, f64::min)).collect();
        let mean = ticks.iter().sum::<f64>() / ticks.len() as f64;
        let (at, worst) = ticks.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
        let (_, world, valid) = &runs[0];
        let mark = if mean > MEAN || worst > WORST { " ✗" } else { "" };
        missed += u32::from(!mark.is_empty());
        let (mean, worst, busy) = (mean * 1e6, worst * 1e6, world.guards().budgets_used_up);
        println!("| {}{mark} | {} | {mean:.1} | {worst:.0} | {at} | {busy} | {valid} |", scene.name, scene.def.bodies.len());
    }
    println!("{missed} of the scenes miss a mean of {:.0} µs or a worst of {:.0} µs", MEAN * 1e6, WORST * 1e6);
}

/// The time of each tick, the world at the end, and what was first found wrong.
fn run(scene: &Scene) -> (Vec<f64>, World, String) {
    let mut world = World::new(scene.def.clone()).unwrap_or_else(|error| panic!("{}: {error}", scene.name));
    let mut valid = String::from("yes");
    let times = (0..scene.ticks).map(|tick| {
        world.set_drive(BodyId(0), scene.drive);
        let begun = ThreadTime::now();
        world.step(TICK);
        let time = begun.elapsed().as_secs_f64();
        if let (Err(fault), "yes") = (world.validate(), valid.as_str()) {
            valid = format!("tick {tick}: {}", fault.chars().take(120).collect::<String>());
        }
        time
    });
    (times.collect(), world, valid)
}

fn area(left: f64, top: f64, right: f64, bottom: f64) -> Aabb {
    Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
}

fn floor() -> SurfaceDef {
    SurfaceDef::fixed(area(-1000.0, 0.0, 1000.0, 10.0), Material::ASPHALT)
}

fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let mut add = |name: String, def: WorldDef, drive: DVec2, ticks: usize| scenes.push(Scene { name, def, drive, ticks });
    for crates in [3, 9, 16, 25] {
        for speed in [10.0, 25.0] {
            let name = format!("ship at {speed} m/s into {crates} stacked crates in air");
            add(name, stack(crates, speed), DVec2::new(3000.0, 0.0), 360);
        }
    }
    for viscosity in [0.001, 1000.0] {
        add(format!("8 × 8 wall in water, η {viscosity}"), wall(viscosity), DVec2::ZERO, 360);
    }
    for upper in [0.01, 0.1] {
        add(format!("two boxes under water, the upper {upper} kg"), under_water(upper), DVec2::ZERO, 360);
    }
    for speed in [10.0, 100.0] {
        for air in [0.0, 1.2041] {
            add(format!("gas of 1e-3 … 1e3 kg at {speed} m/s, air {air}"), gas(64, speed, air), DVec2::ZERO, 240);
        }
    }
    add("200 streams, 64 bodies".into(), zones(200, 0), DVec2::ZERO, 360);
    add("200 liquids, 64 bodies".into(), zones(0, 200), DVec2::ZERO, 360);
    add("60 boxes in a room".into(), room(60, 0.0), DVec2::new(2000.0, -2000.0), 600);
    add("60 boxes in a room that bounce".into(), room(60, 0.8), DVec2::new(2000.0, -2000.0), 600);
    add("three that bounce beside a fan".into(), fan(), DVec2::ZERO, 600);
    add("e = 1 between walls at 3e5 m/s".into(), between_walls(1), DVec2::ZERO, 240);
    add("8 with e = 1 between walls at 3e5 m/s".into(), between_walls(8), DVec2::ZERO, 240);
    scenes
}

/// The ship flies into columns of crates as high as there are many.
fn stack(crates: usize, speed: f64) -> WorldDef {
    let columns = (crates as f64).sqrt() as usize;
    let ship = BodyDef {
        position: DVec2::new(-6.0, -0.86),
        velocity: DVec2::new(speed, -1.0),
        half: DVec2::splat(0.85),
        mass: 100.0,
        drag: 1.15,
        ..BodyDef::default()
    };
    let block = |i: usize| BodyDef {
        position: DVec2::new((i % columns) as f64 * 1.02, -0.5 - (i / columns) as f64),
        mass: 20.0,
        drag: 1.05,
        ..BodyDef::default()
    };
    let bodies = std::iter::once(ship).chain((0..crates).map(block)).collect();
    WorldDef { bodies, surfaces: vec![floor()], ..WorldDef::default() }
}

fn wall(viscosity: f64) -> WorldDef {
    let block = |i: usize| BodyDef {
        position: DVec2::new((i % 8) as f64, -0.5 - (i / 8) as f64),
        mass: 1200.0 + 10.0 * (i % 5) as f64,
        ..BodyDef::default()
    };
    let fluids = vec![FluidDef { zone: area(-50.0, -6.5, 50.0, 0.0), density: 1000.0, viscosity }];
    let mut bodies: Vec<BodyDef> = (0..63).map(block).collect();
    bodies.insert(
        0,
        BodyDef { position: DVec2::new(-5.0, -3.0), velocity: DVec2::new(8.0, 0.0), mass: 1500.0, ..BodyDef::default() },
    );
    WorldDef { bodies, fluids, surfaces: vec![floor()], ..WorldDef::default() }
}

fn under_water(upper: f64) -> WorldDef {
    let fluids = vec![FluidDef { zone: area(-50.0, -20.0, 50.0, 0.0), density: 1000.0, viscosity: 0.001 }];
    let lower = BodyDef { position: DVec2::new(0.0, -0.5), mass: 900.0, ..BodyDef::default() };
    let upper = BodyDef { position: DVec2::new(0.3, -1.5), mass: upper, ..BodyDef::default() };
    WorldDef { bodies: vec![lower, upper], fluids, surfaces: vec![floor()], ..WorldDef::default() }
}

fn gas(count: usize, speed: f64, air_density: f64) -> WorldDef {
    let mut random = Random(3);
    let body = |i: usize| BodyDef {
        position: DVec2::new(1.0 + 1.2 * (i % 8) as f64, 1.0 + 1.2 * (i / 8) as f64),
        velocity: DVec2::new(random.between(-speed, speed), random.between(-speed, speed)),
        half: DVec2::splat(0.3),
        mass: random.decades(-3.0, 3.0),
        restitution: 1.0,
        ..BodyDef::default()
    };
    let bodies = (0..count).map(body).collect();
    WorldDef { gravity: 0.0, air_density, bounds: Some(area(0.0, 0.0, 11.0, 11.0)), bodies, ..WorldDef::default() }
}

fn zones(streams: usize, liquids: usize) -> WorldDef {
    let mut random = Random(5);
    let mut zone = || {
        let (x, y) = (random.between(0.0, 18.0), random.between(0.0, 18.0));
        area(x, y, x + random.between(0.5, 4.0), y + random.between(0.5, 4.0))
    };
    let streams = (0..streams).map(|i| StreamDef { zone: zone(), force: DVec2::new(20.0, -30.0) * (i % 5) as f64 }).collect();
    let fluids = (0..liquids).map(|i| FluidDef { zone: zone(), density: 100.0 * (i % 10) as f64, viscosity: 0.5 }).collect();
    WorldDef { streams, fluids, ..room(64, 0.3) }
}

fn room(count: usize, restitution: f64) -> WorldDef {
    let mut random = Random(7);
    let body = |i: usize| BodyDef {
        position: DVec2::new(1.2 + 2.0 * (i % 9) as f64, 1.2 + 2.0 * (i / 9) as f64),
        velocity: DVec2::new(random.between(-6.0, 6.0), random.between(-6.0, 6.0)),
        half: DVec2::new(random.between(0.3, 0.8), random.between(0.3, 0.8)),
        mass: random.decades(0.0, 2.0),
        drag: 1.05,
        restitution: restitution * random.unit(),
        ..BodyDef::default()
    };
    WorldDef { bounds: Some(area(0.0, 0.0, 20.0, 20.0)), bodies: (0..count).map(body).collect(), ..WorldDef::default() }
}

fn fan() -> WorldDef {
    let ball = |i: usize| BodyDef {
        position: DVec2::new(1.0 + 1.5 * i as f64, -2.0 - i as f64),
        half: DVec2::splat(0.4),
        mass: 20.0 + 15.0 * i as f64,
        drag: 0.5,
        round: true,
        restitution: 0.6 + 0.1 * i as f64,
        ..BodyDef::default()
    };
    let streams = vec![StreamDef { zone: area(2.0, -6.0, 4.0, 0.0), force: DVec2::new(0.0, -700.0) }];
    let surfaces = vec![floor(), SurfaceDef::fixed(area(5.5, -8.0, 6.0, 0.0), Material::ASPHALT)];
    WorldDef { bodies: (0..3).map(ball).collect(), streams, surfaces, ..WorldDef::default() }
}

fn between_walls(count: usize) -> WorldDef {
    let body = |i: usize| BodyDef {
        position: DVec2::new(5.0, 1.0 + 1.2 * i as f64),
        velocity: DVec2::new(3e5, 0.0),
        restitution: 1.0,
        ..BodyDef::default()
    };
    let bodies = (0..count).map(body).collect();
    WorldDef { gravity: 0.0, air_density: 0.0, bounds: Some(area(0.0, 0.0, 10.0, 12.0)), bodies, ..WorldDef::default() }
}
