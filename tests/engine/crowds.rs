//! Worlds of many bodies: the general method behind the same world, forces and events as the exact one.

use crate::support::dense::{G, scene, square, surface};
use crate::support::{Ask, TICK, from_below};
use resultant::physics::{BodyDef, BodyId, DVec2, Event, ForceKind, SurfaceDef, World, WorldDef};

fn pit(width: f64) -> Vec<SurfaceDef> {
    vec![surface(-1.0, 0.0, width + 1.0, 1.0), surface(-1.0, -200.0, 0.0, 0.0), surface(width, -200.0, width + 1.0, 0.0)]
}

fn world(bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>) -> World {
    World::new(scene(bodies, surfaces, G)).unwrap()
}

/// Stacked from x = 20 m on, 20 a row.
fn bystander(i: usize) -> BodyDef {
    square(20.5 + (i % 20) as f64, -0.5 - (i / 20) as f64)
}

#[test]
fn a_body_of_a_crowd_that_is_driven_against_a_ceiling_is_held_there() {
    let mut bodies: Vec<BodyDef> = (0..100).map(bystander).collect();
    bodies[0] = square(5.0, -3.0);
    let mut surfaces = pit(60.0);
    surfaces.push(surface(0.0, -6.0, 10.0, -5.0));
    let mut world = world(bodies, surfaces);
    world.drive(0, 0.0, -25.0);
    for _ in 0..240 {
        world.step(TICK);
    }
    let forces = world.forces(BodyId(0));
    assert_eq!(world.body(BodyId(0)).bounds().min.y, -5.0);
    assert_eq!((world.speed(0), forces.resultant()), (DVec2::ZERO, DVec2::ZERO));
    assert!((forces.total(ForceKind::Reaction).y - (25.0 - G)).abs() < 1e-9, "{forces:?}");
}

/// The list of forces once had more in it than had acted on bodies that rebound in the air.
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
fn a_fast_body_of_a_crowd_is_reported_when_it_hits() {
    let mut bodies: Vec<BodyDef> = (0..140).map(bystander).collect();
    bodies[0] = square(5.0, -0.5 - 20.0);
    let mut world = world(bodies, pit(60.0));
    let hit = (0..600).find_map(|_| {
        world.step(TICK);
        world.events().iter().find_map(|event| match *event {
            Event::Impact { a: BodyId(0), speed, normal, .. } => Some((speed, normal)),
            _ => None,
        })
    });
    let (speed, normal) = hit.unwrap();
    assert!((speed - (2.0 * G * 20.0f64).sqrt()).abs() < 0.1, "{speed}");
    assert_eq!(normal, DVec2::new(0.0, -1.0));
}

/// A held body meets no drag: in air, too, every reaction is the weight above it.
#[test]
fn a_column_of_a_crowd_in_air_shows_resultants_of_zero() {
    let column = (0..100).map(|i| square(5.0, -0.5 - f64::from(i))).collect();
    let mut world = World::new(WorldDef { air_density: 1.2041, ..scene(column, pit(10.0), G) }).unwrap();
    for tick in 0..60 {
        for i in [0, 40, 99] {
            let id = BodyId(i);
            let weight = f64::from(100 - i) * G;
            let reaction = from_below(&world, id);
            assert!((reaction / -weight - 1.0).abs() < 1e-12, "tick {tick}, block {i}: {reaction} N, expected {}", -weight);
            assert_eq!(world.forces(id).resultant(), DVec2::ZERO, "tick {tick}, block {i}");
            assert_eq!(world.body(id).position, DVec2::new(5.0, -0.5 - f64::from(i)), "tick {tick}");
        }
        world.step(TICK);
    }
}
