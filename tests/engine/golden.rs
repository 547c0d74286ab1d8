//! The golden numbers of the engine: each comes out of the force manager or of a step, never from a copy of the formula.

use crate::support::{Ask, BODY, TICK, area, block, crate_at, elastic, v};
use resultant::physics::{BodyDef, BodyId, DVec2, Event, ForceKind, StreamDef, SurfaceDef, World, WorldDef};

fn floor(width: f64) -> SurfaceDef {
    block(-width / 2.0, 0.0, width / 2.0, 1.0)
}

fn standing(mass: f64, velocity: f64) -> BodyDef {
    BodyDef { velocity: DVec2::new(velocity, 0.0), ..crate_at(0.0, -0.5, mass) }
}

fn world(bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>) -> World {
    World::new(WorldDef { air_density: 0.0, bodies, surfaces, ..WorldDef::default() }).unwrap()
}

#[test]
fn weight_and_reaction_cancel_exactly() {
    for (mass, weight) in [(75.0, 1125.0), (100.0, 1500.0)] {
        let mut world = world(vec![standing(mass, 0.0)], vec![floor(100.0)]);
        for _ in 0..1000 {
            let forces = world.forces(BODY);
            assert_eq!(forces.total(ForceKind::Weight), DVec2::new(0.0, weight));
            assert_eq!(forces.total(ForceKind::Reaction), DVec2::new(0.0, -weight));
            assert_eq!(forces.resultant(), DVec2::ZERO);
            assert_eq!(world.body(BODY).acceleration, DVec2::ZERO);
            world.step(TICK);
        }
        assert_eq!(world.at(0), DVec2::new(0.0, -0.5));
    }
}

#[test]
fn sliding_on_asphalt_is_braked_by_kinetic_friction() {
    for (mass, friction) in [(75.0, -731.25), (100.0, -975.0)] {
        let world = world(vec![standing(mass, 9.6)], vec![floor(100.0)]);
        assert_eq!(world.forces(BODY).total(ForceKind::Friction), DVec2::new(friction, 0.0));
    }
}

#[test]
fn friction_is_gone_once_it_has_slid_off_the_edge() {
    let mut world = world(vec![standing(75.0, 9.6)], vec![floor(2.0)]);
    let mut fell = false;
    for _ in 0..60 {
        world.step(TICK);
        let friction = world.forces(BODY).total(ForceKind::Friction);
        if world.previous_position(BODY).x > 1.5 {
            assert_eq!(friction, DVec2::ZERO);
            assert_eq!(world.body(BODY).acceleration, DVec2::new(0.0, 15.0));
            fell = true;
        } else if world.at(0).x < 1.5 {
            assert_eq!(friction, DVec2::new(-731.25, 0.0));
        }
    }
    assert!(fell);
}

#[test]
fn all_masses_fall_alike() {
    for mass in [0.5, 75.0, 10_000.0] {
        let mut world = world(vec![BodyDef { mass, ..BodyDef::default() }], Vec::new());
        assert_eq!(world.body(BODY).acceleration, DVec2::new(0.0, 15.0));
        world.step(0.02552524);
        assert!((world.speed(0).y - 0.3828786).abs() < 1e-12);
    }
}

#[test]
fn the_original_proof_comes_out() {
    // An exposed height of 1.1163 m at 1 m depth.
    let half = DVec2::new(0.5, 1.1163 / 2.0);
    let ship = BodyDef { velocity: DVec2::new(23.49957, 0.0), half, drag: 1.15, ..crate_at(0.0, -half.y, 100.0) };
    let mut world = World::new(WorldDef { bodies: vec![ship], surfaces: vec![floor(1000.0)], ..WorldDef::default() }).unwrap();
    let up = -683.5;
    world.set_drive(BODY, DVec2::new((2000.0f64 * 2000.0 - up * up).sqrt(), up));
    world.step(1e-9);
    let forces = world.forces(BODY);
    let near = |kind, x: f64, y: f64| {
        let found = forces.total(kind);
        assert!((found - DVec2::new(x, y)).abs().max_element() < 0.05, "{kind:?}: {found}, expected ({x}, {y})");
    };
    near(ForceKind::Weight, 0.0, 1500.0);
    near(ForceKind::Reaction, 0.0, -816.5);
    near(ForceKind::Friction, -530.7, 0.0);
    near(ForceKind::AirResistance, -426.8, 0.0);
    let resultant = forces.resultant();
    assert!((resultant.x - 922.0).abs() < 0.5 && resultant.y == 0.0, "{resultant}");
    assert!((world.body(BODY).acceleration.x - 9.22).abs() < 0.005);
}

/// Along an axis it is the textbook's, nothing jumps between; round bodies show their diameter.
#[test]
fn air_resistance_is_that_of_the_area_shown() {
    let listed = |half: DVec2, velocity: DVec2, round: bool| {
        let body = BodyDef { half, velocity, round, drag: 1.15, ..BodyDef::default() };
        let world = World::new(WorldDef { bodies: vec![body], ..WorldDef::default() }).unwrap();
        world.forces(BODY).total(ForceKind::AirResistance)
    };
    let (half, k) = (DVec2::new(1.0, 0.25), 0.5 * 1.2041 * 1.15);
    let near = |found: DVec2, x: f64, y: f64| {
        let expected = DVec2::new(x, y) * k;
        assert!((found - expected).length() < 1e-12 * expected.length(), "{found}, not {expected}");
    };
    near(listed(half, DVec2::new(8.0, 0.0), false), -0.5 * 64.0, 0.0);
    near(listed(half, DVec2::new(0.0, -8.0), false), 0.0, 2.0 * 64.0);
    near(listed(half, DVec2::new(3.0, -4.0), false), -3.0 * (2.0 * 4.0 + 0.5 * 3.0), 4.0 * (2.0 * 4.0 + 0.5 * 3.0));
    near(listed(half, DVec2::new(3.0, -4.0), true), -3.0 * 5.0 * 1.25, 4.0 * 5.0 * 1.25);
    let jump = listed(half, DVec2::new(3.0, 3.0 + 1e-9), false) - listed(half, DVec2::new(3.0 + 1e-9, 3.0), false);
    assert!(jump.length() < 1e-6, "{jump}");
}

#[test]
fn a_stream_gives_everything_the_same_wind() {
    let stream = StreamDef { zone: area(-5.0, -5.0, 5.0, 5.0), force: DVec2::new(1200.0, 0.0) };
    let bodies = [1.0, 75.0, 500.0].map(|mass| BodyDef { half: DVec2::splat(0.1), ..crate_at(0.0, mass / 200.0, mass) });
    let world = World::new(WorldDef { streams: vec![stream], bodies: bodies.to_vec(), ..WorldDef::default() }).unwrap();
    for id in 0..3 {
        assert_eq!(world.forces(BodyId(id)).total(ForceKind::Wind), DVec2::new(1200.0, 0.0));
    }
}

#[test]
fn an_elastic_collision_conserves_momentum_and_energy() {
    let bodies = vec![elastic(v(-1.0, 0.0), 75.0, 25.7), elastic(v(1.0, 0.0), 150.0, -11.3)];
    let mut world = World::new(WorldDef { gravity: 0.0, air_density: 0.0, bodies, ..WorldDef::default() }).unwrap();
    world.steps(60, TICK);
    let v = [0, 1].map(|id| world.body(BodyId(id)).velocity.x);
    assert!((v[0] + 23.0 + 19.0 / 30.0).abs() < 1e-12 && (v[1] - 13.0 - 11.0 / 30.0).abs() < 1e-12, "{v:?}");
}

#[test]
fn a_ball_at_5_m_per_s_and_restitution_a_half_leaves_at_2_5() {
    let ball = BodyDef { position: DVec2::new(0.0, -0.5 - 5.0 / 6.0), restitution: 0.5, ..BodyDef::default() };
    let mut world = world(vec![ball], vec![floor(10.0)]);
    let mut hit = None;
    for _ in 0..60 {
        let before = world.speed(0).y;
        world.step(TICK);
        if hit.is_none() && world.speed(0).y < 0.0 {
            let Event::Impact { speed, .. } = world.events()[0] else { panic!("{:?}", world.events()) };
            let fallen = (5.0 - before) / 15.0;
            hit = Some((speed, world.speed(0).y - 15.0 * (TICK - fallen)));
        }
    }
    let (speed, left) = hit.unwrap();
    assert!((speed - 5.0).abs() < 1e-12 && (left + 2.5).abs() < 1e-12, "{speed} {left}");
}

#[test]
fn a_slow_rebound_ends_the_bounce_unless_the_scene_asks_for_every_one() {
    for (rest_speed, bounces) in [(1.0, false), (0.0, true)] {
        let ball = BodyDef { position: DVec2::new(0.0, -0.5 - 1.5 * 1.5 / 30.0), restitution: 0.5, ..BodyDef::default() };
        let def = WorldDef { air_density: 0.0, rest_speed, surfaces: vec![floor(10.0)], bodies: vec![ball], ..WorldDef::default() };
        let mut world = World::new(def).unwrap();
        let rose = (0..40).any(|_| {
            world.step(TICK);
            world.speed(0).y < -0.1
        });
        assert_eq!(rose, bounces);
    }
}
