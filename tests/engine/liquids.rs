//! Liquids: bodies that float, sink, bob and splash, against fine integrations by hand and against formulas, at any tick.

use crate::support::motion::{Bath, WAVES, force_on, rk4};
use crate::support::{Ask, BODY, G, area, block, crate_at, named_forces};
use resultant::physics::{BodyDef, DVec2, FluidDef, ForceKind, Plan, World, WorldDef};

const AIR: f64 = 1.2041;

/// A liquid whose surface is at y = 0.
fn pool(density: f64, viscosity: f64, depth: f64) -> FluidDef {
    FluidDef { zone: area(-100.0, 0.0, 100.0, depth), density, viscosity }
}

fn world(body: BodyDef, pool: FluidDef) -> World {
    World::new(WorldDef { fluids: vec![pool], bodies: vec![body], ..WorldDef::default() }).unwrap()
}

fn run(mut world: World, seconds: f64, hz: f64) -> World {
    world.steps((seconds * hz).round() as u32, 1.0 / hz);
    world
}

/// RK4 at such short steps that its error at the kinks does not count.
fn reference(body: &BodyDef, pool: &FluidDef, seconds: f64, h: f64) -> DVec2 {
    let bath = Bath { density: pool.density, viscosity: pool.viscosity, depth: pool.zone.max.y };
    let a = |x: DVec2, v: DVec2| force_on(body, (x, v), G, AIR, bath) / body.mass;
    rk4((body.position, body.velocity), (seconds / h).round() as u32, h, a).0
}

/// A light crate that carries another one dips in by a hair and leaves the water within a tick. Both left it with up to twenty times their energy.
#[test]
fn a_light_stack_leaves_the_water_no_faster_than_it_came() {
    let half = DVec2::new(0.44, 0.27);
    for (drop, hz) in [(1e-4, 120.0), (1e-3, 60.0), (0.01, 30.0), (0.1, 60.0), (0.1, 30.0)] {
        let low = BodyDef { position: DVec2::new(0.0, -half.y - drop), half, mass: 0.13, drag: 0.0, ..BodyDef::default() };
        let high = BodyDef { position: low.position - DVec2::new(0.1, 2.0 * half.y), mass: 0.15, ..low.clone() };
        let def =
            WorldDef { air_density: 0.0, fluids: vec![pool(1000.0, 0.0, 20.0)], bodies: vec![low, high], ..WorldDef::default() };
        let mut world = World::new(def).unwrap();
        let given = 0.28 * G * drop;
        for _ in 0..(2.0 * hz) as u32 {
            world.step(1.0 / hz);
            let body = world.body(BODY);
            let (depth, speed) = (body.position.y + half.y, body.velocity.length());
            let spring = 0.5 * 1000.0 * G * 2.0 * half.x * depth.max(0.0) * depth.max(0.0);
            let energy = 0.28 * (0.5 * speed * speed - G * depth) + spring;
            assert!(energy <= given * (1.0 + 1e-6), "{drop} m, {hz} Hz: {energy} J of {given} J");
        }
    }
}

/// Half a kilogram that fills a cubic metre was 0.78 m off after two seconds at 30 Hz.
#[test]
fn a_splash_and_a_bob_agree_with_a_fine_integration_at_any_tick() {
    let pool = pool(1000.0, 1e-3, 30.0);
    let body = |mass: f64, half: (f64, f64), y: f64, velocity: (f64, f64)| BodyDef {
        velocity: velocity.into(),
        half: half.into(),
        ..crate_at(0.0, y, mass)
    };
    for body in [
        body(0.5, (0.5, 0.5), -1.0, (0.0, 0.0)),
        body(5.0, (0.5, 0.5), -0.4, (0.0, 0.0)),
        body(300.0, (0.5, 0.5), -1.0, (3.0, 0.0)),
        body(900.0, (0.9, 0.3), -2.0, (8.0, 5.0)),
        body(2000.0, (0.5, 0.5), -1.0, (-2.0, 9.0)),
        // Planks that flew far and met the water within one tick were integrated across its surface in one step, and thrown off by kilometres;
        // a fast splash took the coarse steps that are meant for things without weight in treacle.
        body(8.0, (0.5, 0.02), -1.25, (0.0, 60.0)),
        body(160.0, (2.0, 0.1), -1.25, (10.0, 60.0)),
        body(1.6, (0.02, 0.1), -1.25, (0.0, 60.0)),
        body(20.0, (0.5, 0.5), -1.25, (15.0, 20.0)),
    ] {
        let exact = reference(&body, &pool, 2.0, 2e-6);
        for hz in [15.0, 30.0, 60.0, 120.0, 240.0] {
            let error = run(world(body.clone(), pool.clone()), 2.0, hz).body(BODY).position.distance(exact);
            assert!(error < 5e-6, "{} kg at {hz} Hz: {error} m", body.mass);
        }
    }
}

/// The steps for stiff motion once pumped energy into bodies far lighter than the liquid: a crate of a gram bobbed on water for ever.
#[test]
fn what_floats_comes_to_rest_at_its_waterline_and_then_rests_exactly() {
    let light = [(1e-3, 0.5), (1e-2, 0.5), (0.05, 0.5), (0.05, 0.1), (0.5, 0.5)];
    for (mass, half) in light.into_iter().chain([(1.0, 0.1), (10.0, 0.1), (30.0, 0.5), (300.0, 0.5), (300.0, 1.0)]) {
        for hz in [30.0, 60.0, 120.0, 240.0].into_iter().filter(|hz| mass < 0.05 || [30.0, 120.0].contains(hz)) {
            let body = BodyDef { position: DVec2::new(0.0, -half - 0.3), half: DVec2::splat(half), mass, ..BodyDef::default() };
            let mut world = run(world(body, pool(1000.0, 1e-3, 30.0)), 60.0, hz);
            let (at, waterline) = (world.at(0), mass / (1000.0 * 2.0 * half) - half);
            assert!((at.y - waterline).abs() < 1e-12, "{mass} kg, {hz} Hz: {} m, not {waterline} m", at.y);
            for _ in 0..100 {
                world.step(1.0 / hz);
                let body = world.body(BODY);
                assert_eq!((body.position, body.velocity, body.acceleration), (at, DVec2::ZERO, DVec2::ZERO), "{mass} kg");
                let forces = world.forces(BODY);
                assert_eq!(forces.resultant(), DVec2::ZERO, "{mass} kg");
                assert_eq!(named_forces(&world, BODY), DVec2::ZERO, "{mass} kg");
                assert_eq!(forces.total(ForceKind::Buoyancy), DVec2::new(0.0, -mass * G));
            }
        }
    }
}

#[test]
fn what_bobs_feels_its_drive_at_once_at_any_tick() {
    let end = |hz: f64| {
        let body = BodyDef { position: DVec2::new(0.0, -0.5), velocity: DVec2::new(0.2, 0.0), mass: 300.0, ..BodyDef::default() };
        let mut world = world(body, pool(1000.0, 1e-3, 30.0));
        for tick in 0..(3.0 * hz) as u32 {
            let drives = (1.0..1.5).contains(&(f64::from(tick) / hz));
            world.set_drive(BODY, if drives { DVec2::new(400.0, -600.0) } else { DVec2::ZERO });
            world.step(1.0 / hz);
        }
        world.at(0)
    };
    let fine = end(3840.0);
    assert!(fine.x > 0.8, "{fine}");
    for hz in [30.0, 60.0, 120.0, 240.0] {
        let error = end(hz).distance(fine);
        assert!(error < 1e-6, "{hz} Hz: {error} m");
    }
}

/// ω = √(ρ·g·A/m), after a thousand periods.
#[test]
fn without_drag_it_bobs_for_ever() {
    for (mass, amplitude) in [(300.0, 0.1), (0.5, 1e-4), (100.0, 0.05)] {
        for hz in [30.0, 120.0] {
            let (omega, middle) = ((1000.0 * G / mass).sqrt(), mass / 1000.0 - 0.5);
            let seconds = (1000.0 * 2.0 * std::f64::consts::PI / omega * hz).round() / hz;
            let body = BodyDef { position: DVec2::new(0.0, middle + amplitude), mass, drag: 0.0, ..BodyDef::default() };
            let world = run(world(body, pool(1000.0, 0.0, 30.0)), seconds, hz);
            let (x, v) = (world.at(0).y - middle, world.speed(0).y);
            let swing = (x * x + v * v / (omega * omega)).sqrt();
            assert!((swing - amplitude).abs() < 2e-6, "{mass} kg, {hz} Hz: {swing} m");
            assert!((x - amplitude * (omega * seconds).cos()).abs() < 2e-6, "{mass} kg, {hz} Hz: {x} m");
        }
    }
}

/// Stokes' drag alone in the depths: v = v∞ + (v₀ − v∞)·e^(−t/T), in one step of any length.
#[test]
fn a_thick_liquid_slows_as_the_formula_says() {
    for (mass, viscosity) in [(1500.0, 50.0), (0.01, 1000.0), (1500.0, 1e3)] {
        for hz in [1.0, 30.0, 120.0] {
            let (velocity, half) = (DVec2::new(2.0, -3.0), DVec2::splat(0.05));
            let body = BodyDef { position: DVec2::new(0.0, 500.0), velocity, half, mass, drag: 0.0, ..BodyDef::default() };
            let world = run(world(body, pool(1400.0, viscosity, 1000.0)), 2.0, hz);
            let rate = 3.0 * std::f64::consts::PI * viscosity * 0.1 / mass;
            let end = DVec2::new(0.0, G * (1.0 - 1400.0 * 0.01 / mass) / rate);
            let exact = DVec2::new(0.0, 500.0) + end * 2.0 - (velocity - end) * ((-2.0 * rate).exp_m1() / rate);
            let error = world.at(0).distance(exact);
            assert!(error < 1e-9, "{mass} kg, {viscosity} Pa·s, {hz} Hz: {error} m");
        }
    }
}

/// Grains in treacle: the linear drag is ten to a hundred thousand times a second.
#[test]
fn grains_in_treacle_move_alike_at_any_tick() {
    for (depth, drag) in [(0.3, 1.0), (-0.2, 1.0), (0.04, 0.0)] {
        let velocity = DVec2::new(3.0, 20.0);
        let body = BodyDef { velocity, half: DVec2::splat(0.05), drag, ..crate_at(0.0, depth, 0.01) };
        let end = |hz: f64| run(world(body.clone(), pool(1400.0, 1000.0, 5.0)), 2.0, hz).body(BODY).position;
        let fine = end(7680.0);
        for hz in [15.0, 30.0, 120.0] {
            let error = end(hz).distance(fine);
            assert!(error < 1e-5, "from {depth} m, C_d {drag}, {hz} Hz: {error} m");
        }
    }
}

#[test]
fn a_thin_pool_slows_what_flies_through_it() {
    for speed in [30.0, 300.0, 3000.0] {
        let body = |hz: f64| {
            let (velocity, half) = (DVec2::new(0.0, speed), DVec2::new(0.2, 0.02));
            let body = BodyDef { velocity, half, ..crate_at(0.0, -3.0, 5.0) };
            run(world(body, pool(1000.0, 1e-3, 0.01)), 1.0, hz).body(BODY).clone()
        };
        let (fine, coarse) = (body(61_440.0), body(30.0));
        assert!(fine.velocity.y < speed, "{speed} m/s");
        assert!(coarse.position.distance(fine.position) < 1e-6 * speed, "{speed} m/s: {} {}", coarse.position, fine.position);
    }
}

/// A liquid that stops a body within a millisecond ends its bounces as soon, whatever its restitution: dense steps know its terminal
/// velocity alone, with which it would bounce for ever.
#[test]
fn what_a_thick_liquid_presses_on_comes_to_rest_in_dense_steps() {
    let ceiling = block(-5.0, -1.0, 5.0, 0.0);
    for restitution in [0.3, 0.9, 1.0] {
        let velocity = DVec2::new(0.0, 0.7);
        let bodies = vec![BodyDef { velocity, half: DVec2::splat(0.25), restitution, ..crate_at(0.0, 0.6, 0.5) }];
        let (surfaces, fluids) = (vec![ceiling.clone()], vec![pool(1000.0, 200.0, 30.0)]);
        let def = WorldDef { surfaces, fluids, bodies, ..WorldDef::default() };
        let plan = Plan { dense: true, ..Plan::of(&def) };
        let world = run(World::with_plan(def, plan).unwrap(), 1.0, 120.0);
        let body = world.body(BODY);
        assert!(world.methods().in_one_step == 1 || world.methods().asleep == 1, "{:?}", world.methods());
        assert!((body.position.y - 0.25).abs() < 1e-9 && body.velocity.length() < 1e-6, "e = {restitution}: {body:?}");
        assert_eq!(world.guards().energy_taken_out, 0, "e = {restitution}");
    }
}

/// The waves of a body that floats at its waterline: 2·ζ·C_d·√(K·m)·v.
#[test]
fn what_is_listed_is_the_formula() {
    let (mass, v) = (300.0, DVec2::new(0.0, 0.5));
    let body = BodyDef { position: DVec2::new(0.0, -0.2), velocity: v, mass, ..BodyDef::default() };
    let world = world(body, pool(1000.0, 2.0, 30.0));
    let viscous = 0.3 * 3.0 * std::f64::consts::PI * 2.0 * 0.5;
    let waves = 2.0 * WAVES * (1000.0f64 * G * mass).sqrt() * (1.0 - 0.3f64.powi(8)) * 0.5;
    let expected = DVec2::new(0.0, -(0.3 * 500.0 * 0.25 + viscous + waves));
    let found = world.forces(BODY).total(ForceKind::ViscousDrag);
    assert!((found - expected).length() < 1e-9, "{found}, not {expected}");
    assert!((world.forces(BODY).total(ForceKind::AirResistance).y + 0.7 * 0.5 * AIR * 0.25).abs() < 1e-12);
    assert!((named_forces(&world, BODY) - world.forces(BODY).resultant()).length() < 1e-9);
}

#[test]
fn an_edge_at_the_surface_is_not_inside() {
    let body = BodyDef { position: DVec2::new(0.0, -0.5), ..BodyDef::default() };
    let world = world(body, pool(1000.0, 1.0, 30.0));
    assert_eq!(world.forces(BODY).total(ForceKind::Buoyancy), DVec2::ZERO);
}
