//! Distant things change not one bit of any motion, force, impact or event. Laws know no place, no left and no order of rows: those change
//! nothing but rounding.

use crate::support::strategies::cases;
use crate::support::turned::{mirrored, shifted};
use crate::support::{Ask, G, Random, TICK, area, bits_of_body, block, crate_at, crowd, from_below, room, world};
use proptest::prelude::*;
use resultant::physics::{BodyDef, BodyId, DVec2, Event, FluidDef, Material, Obstacle, Path, StreamDef, SurfaceDef, WorldDef};

const TICKS: u32 = 180;
/// m. Far enough that nothing gets there.
const FAR: f64 = 1e5;

#[derive(Clone, Copy, Debug, Default)]
struct Extras {
    /// Air, a pool and a fan.
    media: bool,
    /// A lift, a belt, and a press that closes on the floor.
    movers: bool,
    /// Nothing bounces, and nothing feels the air.
    dull: bool,
}

/// A room with ledges and a crowd in it, that begins `left` metres from the origin.
fn busy_room(seed: u64, left: f64, count: usize, extras: Extras) -> WorldDef {
    let mut random = Random(seed);
    let mut bodies = crowd(&mut random, count, 6);
    for body in &mut bodies {
        body.position.x += left;
        if extras.dull {
            (body.restitution, body.feels_air) = (0.0, false);
        }
    }
    let wall = |x0: f64, y0: f64, x1: f64, y1: f64| block(left + x0, y0, left + x1, y1);
    let mut surfaces: Vec<SurfaceDef> = room(area(left, -9.0, left + 11.0, 12.0), 1.0).into();
    for _ in 0..random.below(4) {
        let (x, y) = (random.between(0.0, 8.0), random.between(8.0, 11.0));
        let ledge = area(left + x, y, left + x + random.between(0.2, 3.0), y + 0.3);
        surfaces.push(SurfaceDef::fixed(ledge, random.pick(&Material::FIRM)));
    }
    if extras.movers {
        let mover = |x0: f64, y0: f64, x1: f64, y1: f64, path: Path| SurfaceDef { path, ..wall(x0, y0, x1, y1) };
        let up = DVec2::new(random.between(-1.0, 1.0), -random.between(1.0, 6.0));
        surfaces.push(mover(1.5, 11.5, 4.0, 11.9, Path::shuttle(up, random.between(0.5, 2.0), 0.2, random.between(0.01, 0.5))));
        let down = DVec2::new(0.0, random.between(1.0, 2.9));
        surfaces.push(mover(6.0, 8.3, 9.0, 9.0, Path::shuttle(down, random.between(0.3, 1.0), 0.1, random.between(0.01, 0.3))));
        surfaces.push(SurfaceDef { belt: random.between(-3.0, 3.0), ..wall(9.0, 10.0, 11.0, 10.4) });
    }
    let pool = FluidDef { zone: area(left, 10.0, left + 6.0, 12.0), density: 1000.0, viscosity: random.decades(-3.0, 2.0) };
    let fan = StreamDef { zone: area(left + 7.0, 3.0, left + 9.0, 12.0), force: DVec2::new(0.0, -300.0) };
    let def = WorldDef { air_density: 0.0, bodies, surfaces, ..WorldDef::default() };
    if extras.media { WorldDef { air_density: 1.2041, fluids: vec![pool], streams: vec![fan], ..def } } else { def }
}

fn with(mut def: WorldDef, other: WorldDef) -> WorldDef {
    def.bodies.extend(other.bodies);
    def.surfaces.extend(other.surfaces);
    def.fluids.extend(other.fluids);
    def.streams.extend(other.streams);
    def
}

fn far_bodies(count: usize) -> WorldDef {
    let bodies = (0..count).map(|i| crate_at(FAR + 3.0 * i as f64, 0.0, 1.0 + i as f64)).collect();
    WorldDef { bodies, ..WorldDef::default() }
}

/// The bits and events of the first `count` bodies, tick by tick.
fn story(def: WorldDef, count: usize, drive: DVec2) -> Vec<(Vec<u64>, Vec<Event>)> {
    let mut world = world(def);
    let of_them = |event: &Event| match *event {
        Event::Impact { a, .. } => a.index() < count,
        Event::Crushed { body, .. } => body.index() < count,
        Event::Snapped { .. } | Event::Hooked { .. } => false,
    };
    let mut tick = |n: u32| {
        world.set_drive(BodyId(0), if n % 60 < 30 { drive } else { DVec2::ZERO });
        world.step(TICK);
        let bits = (0..count).flat_map(|i| bits_of_body(&world, BodyId(i as u32))).collect();
        (bits, world.events().iter().filter(|event| of_them(event)).cloned().collect())
    };
    (0..TICKS).map(&mut tick).collect()
}

fn far_away_changes_nothing(seed: u64, count: usize, drive: DVec2, extras: Extras) -> Result<(), TestCaseError> {
    let def = busy_room(seed, 0.0, count, extras);
    let alone = story(def.clone(), count, drive);
    let everything = Extras { media: true, movers: true, dull: false };
    let others = [
        far_bodies(1),
        far_bodies(10),
        busy_room(!seed, FAR, 20, Extras::default()),
        busy_room(!seed, FAR, 12, everything),
        with(busy_room(!seed, -FAR, 30, Extras { movers: true, ..extras }), far_bodies(10)),
    ];
    for (i, other) in others.into_iter().enumerate() {
        let beside = story(with(def.clone(), other), count, drive);
        let first = alone.iter().zip(&beside).position(|(a, b)| a != b);
        prop_assert_eq!(first, None, "tick at which it first differs, beside scene {}", i);
    }
    Ok(())
}

#[test]
fn what_is_far_away_from_a_room_of_nine_changes_not_one_bit() {
    let extras = Extras { media: true, movers: false, dull: false };
    far_away_changes_nothing(2_257_815_625_286_119_833, 9, DVec2::new(-2_729.458975538596, -643.8956326611807), extras).unwrap();
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn what_is_far_away_changes_not_one_bit(
        seed in any::<u64>(), count in 1..20_usize, fx in -3000.0..3000.0f64, fy in -3000.0..0.0f64,
        extras in (any::<bool>(), any::<bool>(), any::<bool>()).prop_map(|(media, movers, dull)| Extras { media, movers, dull }),
    ) {
        far_away_changes_nothing(seed, count, DVec2::new(fx, fy), extras)?;
    }
}

/// A body that floats at its depth rests there whatever falls far away.
#[test]
fn what_sleeps_near_nothing_stays_asleep() {
    let floats = BodyDef { mass: 500.0, ..crate_at(3.0, -0.0, 500.0) };
    let pool = FluidDef { zone: area(-10.0, 0.0, 10.0, 20.0), density: 1000.0, viscosity: 1.0 };
    let def = WorldDef { bodies: vec![floats], fluids: vec![pool], ..WorldDef::default() };
    let alone = story(def.clone(), 1, DVec2::ZERO);
    assert_eq!(alone.last().map(|(bits, _)| bits[..4].to_vec()), alone.first().map(|(bits, _)| bits[..4].to_vec()));
    let beside = story(with(def, far_bodies(1)), 1, DVec2::ZERO);
    assert_eq!(alone.iter().zip(&beside).position(|(a, b)| a != b), None);
}

/// Scenes that no rounding upsets: bodies that slide, bounce, push, stand, are blown and thrown; if the yard is `wet`, also floating ones.
fn yard(wet: bool) -> WorldDef {
    let at = |x: f64, y: f64, vx: f64, mass: f64| BodyDef { velocity: DVec2::new(vx, 0.0), ..crate_at(x, y, mass) };
    let mut bodies = vec![at(0.0, -0.5, 9.6, 75.0), BodyDef { restitution: 0.7, ..at(20.0, -2.5, 1.0, 3.0) }];
    bodies.extend((0..4).map(|i| at(30.0 + i as f64, -0.5, 0.0, 10.0 + i as f64)));
    bodies.extend((0..5).map(|i| at(40.0, -0.5 - i as f64, 0.0, 8.0 - i as f64)));
    bodies.push(at(43.0, -2.0, -6.0, 4.0));
    bodies.extend([at(62.0, -4.0, 0.0, 20.0), at(70.0, -3.0, 8.0, 2.0)]);
    if wet {
        bodies.extend([at(52.0, 0.7, 0.5, 300.0), at(54.0, -2.0, 0.0, 700.0)]);
    }
    let surfaces = vec![block(-10.0, 0.0, 50.0, 1.0), block(60.0, 0.0, 200.0, 1.0), block(50.0, 9.0, 60.0, 10.0)];
    let fluids = vec![FluidDef { zone: area(50.0, 0.0, 60.0, 9.0), density: 1000.0, viscosity: 1.0 }];
    let streams = vec![StreamDef { zone: area(61.0, -3.0, 63.0, 0.0), force: DVec2::new(50.0, -400.0) }];
    WorldDef { bodies, surfaces, fluids, streams, ..WorldDef::default() }
}

/// The yard after two seconds: position, velocity and acceleration of each body.
fn played(def: WorldDef, pusher: usize, drive: DVec2) -> Vec<[DVec2; 3]> {
    let mut world = world(def);
    world.set_drive(BodyId(pusher as u32), drive);
    crate::support::run(&mut world, 2.0, TICK);
    world.bodies().iter().map(|body| [body.position, body.velocity, body.acceleration]).collect()
}

const PUSHER: usize = 2;
const PUSH: DVec2 = DVec2::new(700.0, 0.0);

fn assert_alike(found: &[[DVec2; 3]], expected: &[[DVec2; 3]], tolerance: f64, what: &str) {
    for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
        for (found, expected) in found.iter().zip(expected) {
            assert!((*found - *expected).abs().max_element() <= tolerance, "{what}: body {i}: {found}, not {expected}");
        }
    }
}

#[test]
fn left_is_as_right() {
    let (def, mirror) = (yard(true), DVec2::new(-1.0, 1.0));
    let found: Vec<[DVec2; 3]> = played(mirrored(&def), PUSHER, PUSH * mirror).iter().map(|of| of.map(|v| v * mirror)).collect();
    assert_alike(&found, &played(def, PUSHER, PUSH), 1e-9, "mirrored");
}

#[test]
fn here_is_as_there() {
    // A floating body amplifies a rounding of its depth, and of the time at which it met the water.
    let near = [(DVec2::new(64.0, -32.0), 1e-9, 1e-7), (DVec2::new(-1024.0, 4096.0), 1e-9, 1e-5)];
    let far = [(DVec2::new(1e5, 1e5), 1e-7, 1e-4), (DVec2::new(-1e7, 1e7), 1e-5, 1e-2)];
    let cases = near.into_iter().chain(far).flat_map(|(shift, dry, wet)| [(shift, false, dry), (shift, true, wet)]);
    for (shift, wet, tolerance) in cases {
        let def = yard(wet);
        let found = played(shifted(&def, shift), PUSHER, PUSH);
        let found: Vec<[DVec2; 3]> = found.iter().map(|[x, v, a]| [*x - shift, *v, *a]).collect();
        assert_alike(&found, &played(def, PUSHER, PUSH), tolerance, &format!("{shift} m away"));
    }
}

/// A body that lands on a sleeping one finds the floor under it all the same, although a rounding lies between them.
#[test]
fn what_has_slept_still_lies_on_its_floor() {
    for seed in 0..40 {
        let mut random = Random(seed);
        let half = random.between(0.1, 0.5);
        let floor = random.between(5.0, 10.0);
        let crate_at = |x: f64, y: f64| BodyDef { half: DVec2::splat(half), ..crate::support::crate_at(x, y, 20.0) };
        let bodies = vec![crate_at(2.0, floor - half), crate_at(2.1, floor - 6.0)];
        let mut world = world(WorldDef { bodies, bounds: Some(area(0.0, 0.0, 10.0, floor)), ..WorldDef::default() });
        crate::support::run(&mut world, 2.0, TICK);
        assert_eq!(world.speed(0), DVec2::ZERO);
        assert!((from_below(&world, BodyId(0)) + 40.0 * G).abs() < 1e-9, "seed {seed}: {} N", from_below(&world, BodyId(0)));
        assert!(world.events().iter().all(|event| !matches!(event, Event::Impact { b: Obstacle::Body(_), .. })));
    }
}
