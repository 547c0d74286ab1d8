//! Worlds of many bodies: the general method behind the same world, forces and events as the exact one.

use crate::support::worst_overlap;
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, ForceKind, Material, SurfaceDef, World, WorldDef};

const TICK: f64 = 1.0 / 120.0;
const G: f64 = 9.81;

fn pit(width: f64) -> Vec<SurfaceDef> {
    let wall = |x0: f64, y0: f64, x1: f64, y1: f64| {
        SurfaceDef::fixed(Aabb::new(DVec2::new(x0, y0), DVec2::new(x1, y1)), Material::ASPHALT)
    };
    vec![wall(-1.0, 0.0, width + 1.0, 1.0), wall(-1.0, -200.0, 0.0, 0.0), wall(width, -200.0, width + 1.0, 0.0)]
}

fn world(bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>) -> World {
    World::new(WorldDef { gravity: G, air_density: 0.0, bodies, surfaces, ..WorldDef::default() }).unwrap()
}

/// The Reaction of what carries a body, N: what it carries itself presses on it by the same name.
fn from_below(world: &World, id: BodyId) -> f64 {
    let forces = world.forces(id);
    let up = forces.forces().iter().filter(|force| force.kind == ForceKind::Reaction && force.vector.y < 0.0);
    up.map(|force| force.vector.y).sum()
}

/// A crowd in which nobody is near anybody has no contacts to list: once a panic in the first tick.
#[test]
fn a_crowd_with_wide_gaps_flies_and_feels_nothing_but_weight() {
    let bodies: Vec<BodyDef> =
        (0..100).map(|i| BodyDef { position: DVec2::new(30.0 * i as f64, -1000.0), ..BodyDef::default() }).collect();
    let mut world = world(bodies, Vec::new());
    world.step(TICK);
    for i in 0..100 {
        assert_eq!(world.forces(BodyId(i)).resultant(), DVec2::new(0.0, G));
    }
}

#[test]
fn a_body_of_a_crowd_that_is_driven_against_a_ceiling_is_held_there() {
    let mut bodies: Vec<BodyDef> = (0..100)
        .map(|i| BodyDef { position: DVec2::new(20.5 + (i % 20) as f64, -0.5 - (i / 20) as f64), ..BodyDef::default() })
        .collect();
    bodies[0] = BodyDef { position: DVec2::new(5.0, -3.0), ..BodyDef::default() };
    let mut surfaces = pit(60.0);
    surfaces.push(SurfaceDef::fixed(Aabb::new(DVec2::new(0.0, -6.0), DVec2::new(10.0, -5.0)), Material::ASPHALT));
    let mut world = world(bodies, surfaces);
    world.set_drive(BodyId(0), DVec2::new(0.0, -25.0));
    for _ in 0..240 {
        world.step(TICK);
    }
    let forces = world.forces(BodyId(0));
    assert_eq!(world.body(BodyId(0)).bounds().min.y, -5.0);
    assert_eq!((world.body(BodyId(0)).velocity, forces.resultant()), (DVec2::ZERO, DVec2::ZERO));
    assert!((forces.total(ForceKind::Reaction).y - (25.0 - G)).abs() < 1e-9, "{forces:?}");
}

/// Rebounds in the air were once listed as more than what had acted.
#[test]
fn the_resultant_is_the_sum_of_what_is_listed_also_where_many_rebound_at_once() {
    let restitution = [0.0, 0.2, 0.5, 0.8, 0.9];
    let bodies: Vec<BodyDef> = (0..100)
        .map(|i| BodyDef {
            position: DVec2::new(1.0 + 1.3 * (i % 10) as f64 + 0.03 * (i % 7) as f64, -1.2 - 1.5 * (i / 10) as f64),
            half: DVec2::new(0.25 + 0.06 * (i % 5) as f64, 0.25 + 0.08 * (i % 4) as f64),
            restitution: restitution[i * 7 % 5],
            ..BodyDef::default()
        })
        .collect();
    let mut world = world(bodies, pit(14.5));
    let mut rebounds = 0;
    for tick in 0..960 {
        world.step(TICK);
        rebounds += world.events().len();
        for i in 0..100 {
            let forces = world.forces(BodyId(i));
            let listed: DVec2 = forces.forces().iter().map(|force| force.vector).sum();
            let largest = forces.forces().iter().fold(0.0_f64, |largest, force| largest.max(force.vector.length()));
            assert!((listed - forces.resultant()).length() <= 1e-11 * largest, "tick {tick}, body {i}: {forces:?}");
        }
    }
    assert!(rebounds > 100, "{rebounds}");
}

#[test]
fn rain_settles_without_overlap_and_every_resultant_is_exactly_zero() {
    let bodies: Vec<BodyDef> = (0..300)
        .map(|i| BodyDef {
            position: DVec2::new(0.6 + (i % 10) as f64 + 0.05 * (i % 7) as f64, -0.6 - (i / 10) as f64),
            half: DVec2::new(0.2 + 0.03 * (i % 5) as f64, 0.2 + 0.03 * (i % 4) as f64),
            mass: 0.5 + (i * 37 % 100) as f64 / 2.0,
            ..BodyDef::default()
        })
        .collect();
    let mut world = world(bodies, pit(12.0));
    for tick in 0..1800 {
        world.step(TICK);
        let overlap = worst_overlap(&world);
        assert!(overlap <= 1e-6, "tick {tick}: {overlap} m");
    }
    for i in 0..300 {
        let id = BodyId(i);
        assert_eq!(world.body(id).velocity, DVec2::ZERO);
        assert_eq!(world.body(id).acceleration, DVec2::ZERO);
        assert_eq!(world.forces(id).resultant(), DVec2::ZERO);
        let listed: DVec2 = world.forces(id).forces().iter().map(|force| force.vector).sum();
        assert!(listed.y.abs() < 1e-6, "body {i}: its forces add up to {listed}");
    }
}

#[test]
fn a_column_of_a_crowd_stands_still_and_shows_every_reaction() {
    let n = 150;
    let bodies: Vec<BodyDef> = (0..n)
        .map(|i| BodyDef { position: DVec2::new(5.0, -0.5 - i as f64), mass: 1.0 + (i % 3) as f64, ..BodyDef::default() })
        .collect();
    let masses: Vec<f64> = bodies.iter().map(|body| body.mass).collect();
    let mut world = world(bodies, pit(10.0));
    for tick in 0..600 {
        for i in [0, 70, 149] {
            let id = BodyId(i as u32);
            let weight: f64 = masses[i..].iter().sum::<f64>() * G;
            let reaction = from_below(&world, id);
            assert!((reaction / -weight - 1.0).abs() < 1e-9, "tick {tick}, block {i}: {reaction} N, expected {}", -weight);
            assert_eq!(world.forces(id).resultant(), DVec2::ZERO);
            assert_eq!(world.body(id).position, DVec2::new(5.0, -0.5 - i as f64));
        }
        world.step(TICK);
    }
}

#[test]
fn the_ship_of_a_crowd_pushes_a_row() {
    // Body 0 pushes three boxes on the floor; the rest of the crowd stands by.
    let mut bodies: Vec<BodyDef> =
        (0..4).map(|i| BodyDef { position: DVec2::new(1.0 + i as f64, -0.5), mass: 10.0, ..BodyDef::default() }).collect();
    bodies.extend((0..140).map(|i| BodyDef {
        position: DVec2::new(40.5 + (i % 20) as f64, -0.5 - (i / 20) as f64),
        mass: 5.0,
        ..BodyDef::default()
    }));
    let mut world = world(bodies, pit(70.0));
    world.set_drive(BodyId(0), DVec2::new(600.0, 0.0));
    let a = 600.0 / 40.0 - 0.65 * G;
    for tick in 1..=120 {
        world.step(TICK);
        let t = tick as f64 * TICK;
        for i in 0..4 {
            let x = world.body(BodyId(i)).position.x;
            assert!((x - 1.0 - i as f64 - 0.5 * a * t * t).abs() < 1e-6, "tick {tick}, box {i}: {x}");
        }
    }
}

#[test]
fn a_fast_body_of_a_crowd_is_reported_when_it_hits() {
    let mut bodies: Vec<BodyDef> = (0..140)
        .map(|i| BodyDef { position: DVec2::new(20.5 + (i % 20) as f64, -0.5 - (i / 20) as f64), ..BodyDef::default() })
        .collect();
    bodies[0] = BodyDef { position: DVec2::new(5.0, -0.5 - 20.0), ..BodyDef::default() };
    let mut world = world(bodies, pit(60.0));
    let hit = (0..600).find_map(|_| {
        world.step(TICK);
        world
            .events()
            .iter()
            .filter_map(|event| match event {
                resultant::physics::Event::Impact { a, speed, normal, .. } => Some((*a, *speed, *normal)),
                resultant::physics::Event::Crushed { .. } => None,
            })
            .find(|(a, ..)| *a == BodyId(0))
    });
    let (_, speed, normal) = hit.unwrap();
    assert!((speed - (2.0 * G * 20.0f64).sqrt()).abs() < 0.1, "{speed}");
    assert_eq!(normal, DVec2::new(0.0, -1.0));
}

/// What is held meets no drag: in air too every reaction is the weight above it.
#[test]
fn a_column_of_a_crowd_in_air_shows_resultants_of_zero() {
    let bodies = (0..100).map(|i| BodyDef { position: DVec2::new(5.0, -0.5 - i as f64), ..BodyDef::default() });
    let def = WorldDef { gravity: G, air_density: 1.2041, bodies: bodies.collect(), surfaces: pit(10.0), ..WorldDef::default() };
    let mut world = World::new(def).unwrap();
    for tick in 0..60 {
        for i in [0, 40, 99] {
            let id = BodyId(i);
            let weight = f64::from(100 - i) * G;
            let reaction = from_below(&world, id);
            assert!((reaction / -weight - 1.0).abs() < 1e-12, "tick {tick}, block {i}: {reaction} N, expected {}", -weight);
            assert_eq!(world.forces(id).resultant(), DVec2::ZERO, "tick {tick}, block {i}");
        }
        world.step(TICK);
    }
}
