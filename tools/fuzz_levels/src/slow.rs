//! Scenes made to be slow.

use super::Random;
use resultant::physics::{
    Aabb, BodyDef, BodyId, DVec2, FluidDef, LinkDef, LinkEnd, LinkLaw, Magnet, Material, Path, Spring, StreamDef, SurfaceDef,
    WorldDef,
};

/// A scene, the force on its first body, N, and how it is played.
pub struct Scene {
    pub name: String,
    pub def: WorldDef,
    pub drive: DVec2,
    pub ticks: usize,
    /// s.
    pub tick: f64,
}

fn area(left: f64, top: f64, right: f64, bottom: f64) -> Aabb {
    Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
}

fn floor() -> SurfaceDef {
    SurfaceDef::fixed(area(-1000.0, 0.0, 1000.0, 10.0), Material::ASPHALT)
}

/// All of them, of up to 64 bodies.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let mut add = |name: String, def: WorldDef, drive: DVec2, ticks: usize| {
        scenes.push(Scene { name, def, drive, ticks, tick: 1.0 / 120.0 });
    };
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
    add("64 streams, 64 bodies".into(), zones(64), DVec2::ZERO, 360);
    add("16 liquids side by side, 64 bodies".into(), layers(false), DVec2::ZERO, 360);
    add("60 boxes in a room".into(), room(60, 0.0), DVec2::new(2000.0, -2000.0), 600);
    add("60 boxes in a room that bounce".into(), room(60, 0.8), DVec2::new(2000.0, -2000.0), 600);
    add("three that bounce beside a fan".into(), fan(), DVec2::ZERO, 600);
    add("e = 1 between walls at 3e5 m/s".into(), between_walls(1), DVec2::ZERO, 240);
    add("8 with e = 1 between walls at 3e5 m/s".into(), between_walls(8), DVec2::ZERO, 240);
    add("16 liquids upon each other, 64 bodies".into(), layers(true), DVec2::ZERO, 120);
    add("64 bodies in air of 100 kg/m³".into(), WorldDef { air_density: 100.0, ..gas(64, 10.0, 0.0) }, DVec2::ZERO, 240);
    add("64 crates on 16 lifts".into(), lifts(), DVec2::ZERO, 360);
    for rate in [30.0, 100.0] {
        add(format!("a net of 32 ropes of m·({rate}/s)² in air"), net(rate), DVec2::new(300.0, 0.0), 360);
    }
    for rate in [30.0, 100.0, 300.0, 500.0, 2000.0] {
        add(format!("a chain of 32 ropes of m·({rate}/s)² in air"), chain(rate), DVec2::new(300.0, 0.0), 360);
    }
    add("32 swings on ropes of m·(100/s)² in air".into(), swings(), DVec2::ZERO, 360);
    add("32 magnets in a heap of 24 boxes".into(), magnets(), DVec2::ZERO, 360);
    for rate in [1.0, 10.0, 30.0] {
        for (name, def) in [("60 boxes in a room that bounce", room(60, 0.8)), ("64 boxes in 16 liquids", layers(false))] {
            let drive = DVec2::new(2000.0, -2000.0);
            scenes.push(Scene { name: format!("{name}, {rate} Hz"), def, drive, ticks: 120, tick: 1.0 / rate });
        }
    }
    scenes
}

/// Scenes that grow, by their number of things.
pub fn growing() -> Vec<Scene> {
    let scene = |name: String, def| Scene { name, def, drive: DVec2::ZERO, ticks: 120, tick: 1.0 / 120.0 };
    let mut scenes = Vec::new();
    for n in [64, 128, 256, 512, 1024, 2048] {
        scenes.push(scene(format!("grows: {n} boxes that fall and pile up"), room(n, 0.3)));
        scenes.push(scene(format!("grows: {n} boxes that fly apart from each other"), apart(n)));
        scenes.push(scene(format!("grows: {n} boxes asleep and 10 awake"), asleep(n)));
    }
    for n in [10, 100, 1000, 10_000] {
        scenes.push(scene(format!("grows: {n} surfaces under 20 boxes"), tiles(n)));
    }
    for n in [4, 16] {
        scenes.push(scene(format!("grows: {n} liquids far and wide around 20 boxes"), pools(n)));
    }
    scenes
}

fn apart(count: usize) -> WorldDef {
    let body = |i: usize| BodyDef { position: DVec2::new(4.0 * i as f64, 0.0), drag: 1.05, ..BodyDef::default() };
    WorldDef { bodies: (0..count).map(body).collect(), ..WorldDef::default() }
}

fn asleep(count: usize) -> WorldDef {
    let sleeps = |i: usize| BodyDef { position: DVec2::new(1.5 * i as f64, -0.5), ..BodyDef::default() };
    let awake = |i: usize| BodyDef { position: DVec2::new(-3.0 * i as f64 - 3.0, -60.0), ..BodyDef::default() };
    let bodies = (0..count).map(sleeps).chain((0..10).map(awake)).collect();
    WorldDef { bodies, surfaces: vec![SurfaceDef::fixed(area(-1e4, 0.0, 1e4, 10.0), Material::ASPHALT)], ..WorldDef::default() }
}

/// Steps of a stair, so that no two of them are one face.
fn tiles(count: usize) -> WorldDef {
    let tile = |i: usize| {
        let (x, y) = (i as f64, 0.001 * (i % 7) as f64);
        SurfaceDef::fixed(area(x, y, x + 1.0, y + 1.0), Material::ASPHALT)
    };
    let body = |i: usize| BodyDef {
        position: DVec2::new(1.0 + 1.6 * (i % 5) as f64, -1.0 - 1.2 * (i / 5) as f64),
        velocity: DVec2::new(0.3, 0.0),
        ..BodyDef::default()
    };
    WorldDef { bodies: (0..20).map(body).collect(), surfaces: (0..count).map(tile).collect(), ..WorldDef::default() }
}

fn pools(count: usize) -> WorldDef {
    let pool = |i: usize| {
        let (x, y) = (4.0 * (i % 100) as f64, 4.0 * (i / 100) as f64);
        FluidDef { zone: area(x, y, x + 3.0, y + 3.0), density: 1000.0, viscosity: 0.001 }
    };
    let body = |i: usize| BodyDef { position: DVec2::new(1.5 + 1.9 * i as f64, 0.5), mass: 500.0, ..BodyDef::default() };
    WorldDef { bodies: (0..20).map(body).collect(), fluids: (0..count).map(pool).collect(), ..WorldDef::default() }
}

/// 16 liquids that touch each other fill a room.
fn layers(upon_each_other: bool) -> WorldDef {
    let fluid = |i: usize| {
        let (from, to) = (1.25 * i as f64, 1.25 * (i + 1) as f64);
        let zone = if upon_each_other { area(0.0, from, 20.0, to) } else { area(from, 4.0 + 0.5 * (i % 3) as f64, to, 20.0) };
        FluidDef { zone, density: 100.0 * (i % 10) as f64, viscosity: 0.5 * (i % 3) as f64 }
    };
    WorldDef { fluids: (0..16).map(fluid).collect(), ..room(64, 0.3) }
}

fn lifts() -> WorldDef {
    let lift = |i: usize| SurfaceDef {
        bounds: area(2.0 * i as f64, 0.0, 2.0 * i as f64 + 1.8, 0.5),
        path: Path::shuttle(DVec2::new(0.0, -3.0), 1.0 + 0.1 * i as f64, 0.2, 0.1),
        material: Material::ASPHALT,
        ..SurfaceDef::default()
    };
    let body = |i: usize| BodyDef {
        position: DVec2::new(2.0 * (i % 16) as f64 + 0.9, -0.5 - (i / 16) as f64),
        mass: 5.0 + i as f64,
        drag: 1.05,
        ..BodyDef::default()
    };
    WorldDef { bodies: (0..64).map(body).collect(), surfaces: (0..16).map(lift).collect(), ..WorldDef::default() }
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

fn zones(streams: usize) -> WorldDef {
    let mut random = Random(5);
    let mut zone = || {
        let (x, y) = (random.between(0.0, 18.0), random.between(0.0, 18.0));
        area(x, y, x + random.between(0.5, 4.0), y + random.between(0.5, 4.0))
    };
    let streams = (0..streams).map(|i| StreamDef { zone: zone(), force: DVec2::new(20.0, -30.0) * (i % 5) as f64 }).collect();
    WorldDef { streams, ..room(64, 0.3) }
}

fn room(count: usize, restitution: f64) -> WorldDef {
    let mut random = Random(7);
    let columns = (count as f64).sqrt().ceil().max(9.0);
    let size = 2.0 * columns + 2.0;
    let columns = columns as usize;
    let body = |i: usize| BodyDef {
        position: DVec2::new(1.2 + 2.0 * (i % columns) as f64, 1.2 + 2.0 * (i / columns) as f64),
        velocity: DVec2::new(random.between(-6.0, 6.0), random.between(-6.0, 6.0)),
        half: DVec2::new(random.between(0.3, 0.8), random.between(0.3, 0.8)),
        mass: random.decades(0.0, 2.0),
        drag: 1.05,
        restitution: restitution * random.unit(),
        ..BodyDef::default()
    };
    WorldDef { bounds: Some(area(0.0, 0.0, size, size)), bodies: (0..count).map(body).collect(), ..WorldDef::default() }
}

/// kg. Of each body on ropes.
const KNOT: f64 = 10.0;

/// A rope of 1 m whose stiffness is that `rate`² (1/s²) times the mass of a body.
fn rope(body: usize, to: LinkEnd, rate: f64) -> LinkDef {
    let law = Spring { length: 1.0, stiffness: KNOT * rate * rate, damping: KNOT * 2.0 };
    LinkDef::new(BodyId(body as u32), to, LinkLaw::Rope(law))
}

fn knot(x: f64, y: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, y), half: DVec2::splat(0.1), mass: KNOT, drag: 1.05, ..BodyDef::default() }
}

/// Four bodies side by side and up to five below each other, the upper ones on places.
fn net(rate: f64) -> WorldDef {
    let at = |i: usize| DVec2::new((i % 4) as f64, 0.9 * (i / 4) as f64);
    let body = |number: usize| LinkEnd::Body(BodyId(number as u32));
    let up = |i: usize| if i < 4 { LinkEnd::Place(DVec2::new(i as f64, -0.9)) } else { body(i - 4) };
    let ropes = |i: usize| [Some(rope(i, up(i), rate)), (at(i).x > 0.0).then(|| rope(i, body(i - 1), rate))];
    let links = (0..20).flat_map(ropes).flatten().take(32).collect();
    WorldDef { bodies: (0..20).map(|i| knot(at(i).x, at(i).y)).collect(), links, ..WorldDef::default() }
}

/// It hangs on a place, and begins level.
fn chain(rate: f64) -> WorldDef {
    let up = |i: usize| if i == 0 { LinkEnd::Place(DVec2::ZERO) } else { LinkEnd::Body(BodyId(i as u32 - 1)) };
    let links = (0..32).map(|i| rope(i, up(i), rate)).collect();
    WorldDef { bodies: (0..32).map(|i| knot(0.9 * (i + 1) as f64, 0.0)).collect(), links, ..WorldDef::default() }
}

fn swings() -> WorldDef {
    let place = |i: usize| DVec2::new(3.0 * i as f64, 0.0);
    let links = (0..32).map(|i| rope(i, LinkEnd::Place(place(i)), 100.0)).collect();
    WorldDef { bodies: (0..32).map(|i| knot(place(i).x + 0.9, 0.1 * i as f64 - 1.0)).collect(), links, ..WorldDef::default() }
}

/// Each box attracts the next one and the next but two.
fn magnets() -> WorldDef {
    let law = LinkLaw::Magnet(Magnet { strength: 300.0, nearest: 0.0 });
    let pull =
        |i: usize| LinkDef::new(BodyId(i as u32 % 24), LinkEnd::Body(BodyId((i as u32 % 24 + 1 + 2 * (i as u32 / 24)) % 24)), law);
    WorldDef { links: (0..32).map(pull).collect(), ..room(24, 0.3) }
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
