//! Streams and liquids in crowds: a body crosses their borders within a tick as it would alone.

use crate::support::dense::{G, square, surface};
use crate::support::{Ask, area, assert_all_at_rest, worst_overlap};
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, FluidDef, ForceKind, StreamDef, SurfaceDef, World, WorldDef};

fn wind(zone: Aabb, x: f64, y: f64) -> StreamDef {
    StreamDef { zone, force: DVec2::new(x, y) }
}

/// The largest distance between `body` alone and as one of a hundred of which the others are far away, over some seconds, m.
fn apart(body: BodyDef, streams: Vec<StreamDef>, fluids: Vec<FluidDef>, surfaces: Vec<SurfaceDef>, rate: f64, seconds: f64) -> f64 {
    let def = WorldDef { gravity: G, air_density: 1.2, streams, fluids, surfaces, bodies: vec![body], ..WorldDef::default() };
    let mut many = def.clone();
    many.bodies.extend((0..100).map(|i| square(1e4 + 10.0 * f64::from(i), 0.0)));
    let (mut alone, mut crowd) = (World::new(def).unwrap(), World::new(many).unwrap());
    let mut worst = 0.0f64;
    for _ in 0..(seconds * rate) as u32 {
        alone.step(1.0 / rate);
        crowd.step(1.0 / rate);
        worst = worst.max(alone.at(0).distance(crowd.at(0)));
    }
    worst
}

#[test]
fn the_border_of_a_stream_is_crossed_when_it_is_reached() {
    let streams = || vec![wind(area(-5.0, 2.0, 5.0, 3.0), 300.0, 0.0), wind(area(0.5, 5.0, 50.0, 5.2), -100.0, -400.0)];
    for rate in [60.0, 120.0, 240.0] {
        for velocity in [DVec2::ZERO, DVec2::new(3.0, 10.0), DVec2::new(-8.0, 55.0)] {
            let body = BodyDef { velocity, mass: 10.0, drag: 1.1, ..BodyDef::default() };
            let apart = apart(body, streams(), Vec::new(), Vec::new(), rate, 3.0);
            assert!(apart < 1e-6, "{rate} Hz, {velocity} m/s: {apart} m");
        }
    }
}

#[test]
fn a_splash_and_what_floats_are_as_alone() {
    let pool = || vec![FluidDef { zone: area(-50.0, 4.0, 50.0, 30.0), density: 1000.0, viscosity: 0.001 }];
    for rate in [60.0, 120.0] {
        for (mass, half, velocity) in [
            (400.0, DVec2::splat(0.5), DVec2::new(0.0, 2.0)),
            (400.0, DVec2::new(0.9, 0.3), DVec2::new(6.0, -2.0)),
            (5000.0, DVec2::splat(0.5), DVec2::new(1.0, 20.0)),
        ] {
            let body = BodyDef { mass, half, velocity, ..BodyDef::default() };
            let apart = apart(body, Vec::new(), pool(), Vec::new(), rate, 4.0);
            assert!(apart < 1e-6, "{rate} Hz, {mass} kg: {apart} m");
        }
    }
}

/// A touching body's exact path is not sought, and the end of a slide is no event: the error is millimetres, where sampling costs centimetres.
#[test]
fn a_slide_through_a_stream_is_much_as_alone() {
    let floor = surface(-100.0, 0.0, 100.0, 1.0);
    let streams = vec![wind(area(1.0, -2.0, 3.0, -0.2), 500.0, 0.0)];
    let body = BodyDef { velocity: DVec2::new(9.0, 0.0), mass: 10.0, feels_air: false, ..square(0.0, -0.5) };
    let apart = apart(body, streams, Vec::new(), vec![floor], 120.0, 4.0);
    assert!(apart < 5e-3, "{apart} m");
}

/// A stream right below the floor never reaches the bodies on the floor.
#[test]
fn what_rests_crosses_nothing() {
    let floor = surface(-1000.0, 0.0, 1000.0, 1e-4);
    let bodies = (0..100).map(|i| square(2.0 * f64::from(i), -0.5));
    let streams = vec![wind(area(-1000.0, 1e-4, 1000.0, 5.0), 5000.0, -5000.0)];
    let def = WorldDef { gravity: G, bodies: bodies.collect(), surfaces: vec![floor], streams, ..WorldDef::default() };
    let mut world = World::new(def).unwrap();
    for _ in 0..240 {
        world.step(1.0 / 120.0);
        assert_eq!(world.speed(7), DVec2::ZERO);
        assert_eq!(world.forces(BodyId(7)).total(ForceKind::Wind), DVec2::ZERO);
    }
}

/// A pit of that width with its bottom at 10 m, filled with water up to `level`.
fn full_pit(width: f64, level: f64, bodies: Vec<BodyDef>) -> World {
    let wall = |left: f64, top: f64, right: f64| surface(left, top, right, if top < 0.0 { 10.0 } else { 11.0 });
    let surfaces = vec![wall(-1.0, 10.0, width + 1.0), wall(-1.0, -20.0, 0.0), wall(width, -20.0, width + 1.0)];
    let fluids = vec![FluidDef { zone: area(0.0, level, width, 10.0), density: 1000.0, viscosity: 0.001 }];
    World::new(WorldDef { gravity: G, air_density: 1.2, bodies, surfaces, fluids, ..WorldDef::default() }).unwrap()
}

#[test]
fn a_raft_calms_down() {
    let bodies: Vec<BodyDef> = (0..90)
        .map(|i| BodyDef {
            position: DVec2::new(0.6 + f64::from(i % 28) * 1.02, 0.4 - 1.02 * f64::from(i / 28)),
            mass: 300.0 + f64::from(i % 9) * 30.0,
            ..BodyDef::default()
        })
        .collect();
    let mut world = full_pit(30.0, 1.0, bodies);
    for tick in 0..3600 {
        world.step(1.0 / 120.0);
        assert!(world.bodies().iter().all(|body| body.velocity.length() < 10.0), "tick {tick}");
        assert!(worst_overlap(&world) <= 1e-6, "tick {tick}: {} m", worst_overlap(&world));
    }
    let fastest = world.bodies().iter().map(|body| body.velocity.length()).fold(0.0, f64::max);
    // Bobbing under quadratic drag slows down as 1/t.
    assert!(fastest < 0.2, "{fastest} m/s");
}

#[test]
fn a_heap_under_water_comes_to_rest() {
    let bodies: Vec<BodyDef> = (0..100)
        .map(|i| BodyDef {
            position: DVec2::new(0.7 + 1.1 * f64::from(i % 10) + 0.03 * f64::from(i % 7), -0.6 - 1.1 * f64::from(i / 10)),
            half: DVec2::new(0.3 + 0.02 * f64::from(i % 5), 0.3 + 0.02 * f64::from(i % 4)),
            mass: 1500.0 + 10.0 * f64::from(i % 9),
            ..BodyDef::default()
        })
        .collect();
    let mut world = full_pit(12.0, 2.0, bodies);
    world.steps(2400, 1.0 / 120.0);
    assert_all_at_rest(&world);
}
