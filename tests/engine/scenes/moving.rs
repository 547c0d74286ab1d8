//! Random rooms with surfaces that move: finite, nothing in anything, nothing leaves, the same bits twice, and no bit from far away.

use crate::support::bits;
use crate::support::strategies::{cases, materials};
use proptest::prelude::*;
use resultant::physics::{Aabb, BodyDef, DVec2, Event, Leg, Obstacle, Path, Sides, SurfaceDef, World, WorldDef};

/// m.
const ROOM: Aabb = Aabb::new(DVec2::ZERO, DVec2::new(24.0, 18.0));
const SECONDS: f64 = 4.0;
/// m. Of an overlap, for bodies that stand still; and of a fast body's path within a tick, as a part.
const EXACT: f64 = 1e-9;

fn vector(most: f64) -> impl Strategy<Value = DVec2> {
    (-most..most, -most..most).prop_map(|(x, y)| DVec2::new(x, y))
}

/// Legs that lead back to where they began; `pull` is their largest acceleration, m/s².
fn paths(pull: f64) -> impl Strategy<Value = Path> {
    let leg = (0.05..1.5f64, vector(6.0), vector(1.0)).prop_map(move |(duration, velocity, way)| Leg {
        duration,
        velocity,
        acceleration: way * pull,
    });
    (prop::collection::vec(leg, 1..5), 0.2..2.0f64, any::<bool>()).prop_map(|(mut legs, duration, waits)| {
        let offset: DVec2 = legs.iter().map(|leg| (leg.velocity + leg.acceleration * (0.5 * leg.duration)) * leg.duration).sum();
        legs.push(Leg { duration, velocity: -offset / duration, acceleration: DVec2::ZERO });
        if waits {
            legs.push(Leg { duration, velocity: DVec2::ZERO, acceleration: DVec2::ZERO });
        }
        Path { legs, repeats: true }
    })
}

fn movers(pull: f64) -> impl Strategy<Value = Vec<SurfaceDef>> {
    let size = (0.3..5.0f64, 0.05..1.5f64);
    let mover = (0.0..20.0f64, 7.0..15.0f64, size, paths(pull), -6.0..6.0f64, 0..4u8, materials());
    prop::collection::vec(mover, 1..6).prop_map(|list| {
        let surface = |(x, y, (w, h), path, belt, kind, material): (f64, f64, (f64, f64), Path, f64, u8, _)| SurfaceDef {
            bounds: Aabb::new(DVec2::new(x, y), DVec2::new(x + w, y + h)),
            material,
            path: if kind == 0 { Path::default() } else { path },
            sides: if kind == 1 { Sides::TOP } else { Sides::ALL },
            belt: if kind == 2 { 0.0 } else { belt },
            present: true,
            ..SurfaceDef::default()
        };
        list.into_iter().map(surface).collect()
    })
}

/// One body a cell of a grid, so that none begins inside another or a surface.
fn bodies() -> impl Strategy<Value = Vec<BodyDef>> {
    let body = (0.1..0.5f64, 0.1..0.5f64, -1.0..3.0f64, prop_oneof![Just(0.0), Just(1.0), 0.0..1.0f64], vector(8.0), materials());
    prop::collection::vec(body, 1..13).prop_map(|list| {
        let def = |(i, (w, h, log_mass, restitution, velocity, material)): (usize, (f64, f64, f64, f64, DVec2, _))| BodyDef {
            position: DVec2::new(2.0 + 3.0 * (i % 7) as f64, 1.5 + 3.0 * (i / 7) as f64),
            velocity,
            half: DVec2::new(w, h),
            mass: 10f64.powf(log_mass),
            restitution,
            material,
            ..BodyDef::default()
        };
        list.into_iter().enumerate().map(def).collect()
    })
}

fn rates() -> impl Strategy<Value = f64> {
    prop_oneof![Just(30.0), Just(60.0), Just(120.0), Just(240.0)]
}

fn room(gravity: f64, pull: f64) -> impl Strategy<Value = WorldDef> {
    (bodies(), movers(pull), any::<bool>()).prop_map(move |(mut bodies, surfaces, air)| {
        let air = air && gravity > 0.0;
        if air {
            // Bodies that air presses together bounce without end where a bounce loses nothing.
            bodies.iter_mut().for_each(|body| body.restitution = body.restitution.min(0.8));
        }
        let air_density = if air { 1.2041 } else { 0.0 };
        WorldDef { gravity, air_density, rest_speed: 0.0, bounds: Some(ROOM), bodies, surfaces, ..WorldDef::default() }
    })
}

/// The deepest overlap of a body with another or with a surface that is solid all around, m, and the names of the two.
fn overlap(world: &World, sides: &[Sides]) -> (f64, String) {
    let mut worst = (0.0f64, String::new());
    for (i, a) in world.bodies().iter().enumerate() {
        let others = world.bodies().iter().enumerate().skip(i + 1).map(|(j, b)| (b.bounds(), format!("bodies {i} and {j}")));
        let solid = |s: usize| sides.get(s).is_none_or(|sides| *sides == Sides::ALL);
        let surfaces = world.surfaces().iter().enumerate().filter(|(s, _)| solid(*s));
        for (b, what) in others.chain(surfaces.map(|(s, b)| (b.bounds, format!("body {i} and surface {s}")))) {
            let depth = -a.bounds().gap(&b).max_element();
            if depth > worst.0 {
                worst = (depth, what);
            }
        }
    }
    worst
}

fn fastest(world: &World) -> f64 {
    let bodies = world.bodies().iter().map(|body| body.velocity.length());
    bodies.chain(world.surfaces().iter().map(|surface| surface.velocity.length())).fold(0.0, f64::max)
}

/// Relative to all impulses: a rider follows its surface exactly at the end of a tick, and no impulse stands for its roundings.
const MOMENTUM: f64 = 1e-9;

fn keeps_every_law(def: WorldDef, rate: f64, far: usize) -> Result<(), TestCaseError> {
    let sides: Vec<Sides> = def.surfaces.iter().map(|surface| surface.sides).collect();
    let count = def.bodies.len();
    let mut crowded = def.clone();
    crowded.bodies.extend((0..far).map(|i| BodyDef { position: DVec2::new(1e5 + 2.0 * i as f64, 0.0), ..BodyDef::default() }));
    let mut world = World::new(def.clone()).unwrap();
    let mut twin = World::new(def).unwrap();
    let mut crowded = World::new(crowded).unwrap();
    let mut before = fastest(&world);
    for tick in 0..(SECONDS * rate) as u32 {
        world.step(1.0 / rate);
        twin.step(1.0 / rate);
        crowded.step(1.0 / rate);
        prop_assert!(world.bodies().iter().all(|b| b.position.is_finite() && b.velocity.is_finite() && b.acceleration.is_finite()));
        let now = fastest(&world);
        let bar = EXACT * (1.0 + before.max(now) / rate);
        let (depth, what) = overlap(&world, &sides);
        prop_assert!(depth <= bar, "tick {}: {} overlap by {} m", tick, what, depth);
        prop_assert!(world.bodies().iter().all(|b| ROOM.contains(&b.bounds(), bar)), "tick {}", tick);
        for (i, (a, b)) in world.bodies().iter().zip(&crowded.bodies()[..count]).enumerate() {
            prop_assert!(a == b, "tick {}: bodies far away change body {}: {:?}, {:?}", tick, i, a, b);
        }
        before = now;
    }
    prop_assert_eq!(bits(&world), bits(&twin));
    Ok(())
}

fn momentum_comes_from_impulses(def: WorldDef, rate: f64) -> Result<(), TestCaseError> {
    let mut world = World::new(def).unwrap();
    for tick in 0..(SECONDS * rate) as u32 {
        let before: Vec<DVec2> = world.bodies().iter().map(|body| body.velocity * body.mass).collect();
        world.step(1.0 / rate);
        for (i, (body, before)) in world.bodies().iter().zip(before).enumerate() {
            let mut listed = DVec2::ZERO;
            let mut scale = before.length() + 1.0;
            for impulse in world.impulses() {
                let sign = if impulse.a.index() == i {
                    1.0
                } else if impulse.b == Obstacle::Body(resultant::physics::BodyId(i as u32)) {
                    -1.0
                } else {
                    continue;
                };
                listed += impulse.vector * sign;
                scale += impulse.vector.length();
            }
            // Where the budget is used up a lasting contact lists a force.
            if world.methods().in_one_step > 0 {
                continue;
            }
            let error = (body.velocity * body.mass - before - listed).length();
            prop_assert!(error <= MOMENTUM * scale, "tick {}: body {} is off by {} N·s of {}", tick, i, error, scale);
        }
        let told =
            world.events().iter().all(|event| !matches!(event, Event::Crushed { force, .. } if *force <= 0.0 || force.is_nan()));
        prop_assert!(told, "tick {}: {:?}", tick, world.events());
    }
    Ok(())
}

#[test]
fn rooms_that_once_broke_a_law_keep_it() {
    let rooms = include!("../../fixtures/found/moving_rooms.rs");
    for (i, (def, rate, far)) in rooms.into_iter().enumerate() {
        keeps_every_law(def, rate, far).unwrap_or_else(|fault| panic!("room {i}: {fault}"));
    }
    let (def, rate) = include!("../../fixtures/found/weightless_room.rs");
    momentum_comes_from_impulses(def, rate).unwrap();
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn a_room_of_movers_keeps_every_law(def in room(15.0, 8.0), rate in rates(), far in prop_oneof![Just(1usize), Just(10)]) {
        keeps_every_law(def, rate, far)?;
    }

    #[test]
    fn without_gravity_momentum_comes_from_impulses_alone(def in room(0.0, 0.0), rate in rates()) {
        momentum_comes_from_impulses(def, rate)?;
    }
}
