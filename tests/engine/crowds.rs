//! Worlds of many bodies: the crowd step behind the same world, forces and events as the exact method; each of many bodies flies, and crosses
//! the borders of streams and liquids within a tick, as one alone does.

use crate::support::dense::{G, scene, square};
use crate::support::{Ask, TICK, area, assert_all_at_rest, block, from_below, worst_overlap};
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, Event, FluidDef, ForceKind, StreamDef, SurfaceDef, World, WorldDef};

fn pit(width: f64) -> Vec<SurfaceDef> {
    vec![block(-1.0, 0.0, width + 1.0, 1.0), block(-1.0, -200.0, 0.0, 0.0), block(width, -200.0, width + 1.0, 0.0)]
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
    surfaces.push(block(0.0, -6.0, 10.0, -5.0));
    let mut world = world(bodies, surfaces);
    world.drive(0, 0.0, -25.0);
    (0..240).for_each(|_| world.step(TICK));
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

/// A body of drag k = ½·C_d·A/m per metre.
fn light(k: f64, velocity: DVec2) -> BodyDef {
    BodyDef { mass: 0.5 / k, velocity, ..BodyDef::default() }
}

fn air(gravity: f64, bodies: Vec<BodyDef>) -> World {
    World::new(WorldDef { gravity, air_density: 1.0, bodies, ..WorldDef::default() }).unwrap()
}

/// The body after each tick, alone; the first of a hundred that are 10 km apart has the same bits.
fn flown(gravity: f64, body: &BodyDef, rate: f64, seconds: f64) -> Vec<(DVec2, DVec2)> {
    let far = |i: usize| BodyDef { position: body.position + 1e4 * DVec2::new((i % 10) as f64, (i / 10) as f64), ..body.clone() };
    let (mut alone, mut crowd) = (air(gravity, vec![body.clone()]), air(gravity, (0..100).map(far).collect()));
    let pose = |world: &World| world.state(0);
    let tick = |_| {
        alone.step(1.0 / rate);
        crowd.step(1.0 / rate);
        assert_eq!(pose(&alone), pose(&crowd), "{rate} Hz, {body:?}");
        pose(&alone)
    };
    (0..(seconds * rate) as u32).map(tick).collect()
}

/// x = (v_t²/g)·ln(cosh τ) from rest.
#[test]
fn falls_with_drag_are_right_to_a_micrometre_at_any_weight() {
    for rate in [60.0, 120.0, 240.0] {
        for k in [1e-3, 0.01, 0.1, 0.3, 1.0, 30.0, 1e3, 1e6] {
            let (position, velocity) = *flown(G, &light(k, DVec2::ZERO), rate, 6.0).last().unwrap();
            let terminal = (G / k).sqrt();
            let tau = G * 6.0 / terminal;
            let exact = terminal * terminal / G * (tau + (-2.0 * tau).exp().ln_1p() - 2f64.ln());
            assert!((position.y - exact).abs() < 1e-6, "{rate} Hz, k {k}: {} m, exact {exact} m", position.y);
            let speed = terminal * tau.tanh();
            assert!((velocity.y / speed - 1.0).abs() < 1e-6, "{rate} Hz, k {k}: {} m/s, exact {speed}", velocity.y);
        }
    }
}

/// `exact.rs` holds the place where such a body ends.
#[test]
fn a_body_of_a_crowd_flies_as_it_does_alone() {
    for (mass, round) in [(10.0, false), (10.0, true), (0.01, false), (1e-7, false)] {
        let half = DVec2::new(0.2, 1.5);
        let body = BodyDef { half, mass, round, velocity: DVec2::new(20.0, -13.0), ..BodyDef::default() };
        for rate in [30.0, 60.0, 120.0] {
            flown(G, &body, rate, 3.0);
        }
    }
}

/// 40 m/s relative to the air, without gravity: v = v₀/(1 + kv₀t), s = ln(1 + kv₀t)/k.
#[test]
fn a_gust_never_turns_a_light_thing_round() {
    for rate in [60.0, 120.0] {
        for k in [0.1, 1.0, 300.0, 1e5] {
            for (tick, (position, velocity)) in (1..).zip(flown(0.0, &light(k, DVec2::new(40.0, 0.0)), rate, 1.0)) {
                let exact = (k * 40.0 * f64::from(tick) / rate).ln_1p() / k;
                assert!(velocity.x > 0.0, "{rate} Hz, k {k}, tick {tick}: turned round");
                assert!((position.x - exact).abs() < 1e-6, "{rate} Hz, k {k}, tick {tick}: {} m off", position.x - exact);
            }
        }
    }
}

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
    let floor = block(-100.0, 0.0, 100.0, 1.0);
    let streams = vec![wind(area(1.0, -2.0, 3.0, -0.2), 500.0, 0.0)];
    let body = BodyDef { velocity: DVec2::new(9.0, 0.0), mass: 10.0, feels_air: false, ..square(0.0, -0.5) };
    let apart = apart(body, streams, Vec::new(), vec![floor], 120.0, 4.0);
    assert!(apart < 5e-3, "{apart} m");
}

/// A stream right below the floor never reaches the bodies on the floor.
#[test]
fn what_rests_crosses_nothing() {
    let floor = block(-1000.0, 0.0, 1000.0, 1e-4);
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
    let wall = |left: f64, top: f64, right: f64| block(left, top, right, if top < 0.0 { 10.0 } else { 11.0 });
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
