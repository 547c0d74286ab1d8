//! Bodies in contact that move as one through air and liquids are one body, whose forces and masses are sums.

use super::*;
use crate::support::motion::{Bath, force_on, rk4};
use resultant::physics::FluidDef;

const PULL: f64 = 15.0;
const AIR: f64 = 1.2;

fn water() -> FluidDef {
    FluidDef { zone: area(-300.0, 0.0, 300.0, 50.0), density: 1000.0, viscosity: 0.0 }
}

fn world(surfaces: Vec<SurfaceDef>, bodies: Vec<BodyDef>, fluids: Vec<FluidDef>) -> World {
    World::new(WorldDef { gravity: PULL, air_density: AIR, surfaces, bodies, fluids, ..WorldDef::default() }).unwrap()
}

/// Where the first of bodies that move as one is after some seconds, by RK4 at such short steps that its error does not count.
fn as_one(bodies: &[BodyDef], seconds: f64, wet: bool, besides: impl Fn(DVec2) -> DVec2) -> DVec2 {
    let mass: f64 = bodies.iter().map(|body| body.mass).sum();
    let (begin, h) = (bodies[0].position, 1e-4);
    let bath = Bath { density: 1000.0, viscosity: 0.0, depth: if wet { f64::INFINITY } else { 0.0 } };
    let a = |x: DVec2, v: DVec2| {
        let on = |body: &BodyDef| force_on(body, (body.position + x - begin, v), PULL, AIR, bath);
        besides(bodies.iter().map(on).sum::<DVec2>() / mass)
    };
    rk4((begin, bodies[0].velocity), (seconds / h).round() as u32, h, a).0
}

fn box_at(x: f64, y: f64, half: DVec2, mass: f64, drag: f64) -> BodyDef {
    BodyDef { position: v(x, y), half, mass, drag, restitution: 0.0, ..BodyDef::default() }
}

/// How far the first body is off after some seconds, m.
fn off(surfaces: &[SurfaceDef], bodies: &[BodyDef], fluids: &[FluidDef], (seconds, rate): (f64, f64), expected: DVec2) -> f64 {
    let mut world = world(surfaces.to_vec(), bodies.to_vec(), fluids.to_vec());
    world.steps((seconds * rate).round() as u32, 1.0 / rate);
    world.at(0).distance(expected)
}

#[test]
fn bodies_that_fall_through_air_in_contact_fall_as_one() {
    let cases = [([5.0, 1.0], [1.0, 1.0]), ([100.0, 0.4], [1.0, 1.0]), ([0.4, 100.0], [1.0, 0.2]), ([3.0, 2.0], [0.3, 2.0])];
    for (masses, drags) in cases {
        let half = DVec2::splat(0.5);
        // The upper one presses on the lower one while that falls more slowly by itself.
        let mut bodies = [box_at(0.0, -0.5, half, masses[0], drags[0]), box_at(0.0, 0.5, half, masses[1], drags[1])];
        if masses[0] / drags[0] < masses[1] / drags[1] {
            bodies.swap(0, 1);
            (bodies[0].position.y, bodies[1].position.y) = (-0.5, 0.5);
        }
        let expected = as_one(&bodies, 5.0, false, |a| a);
        for rate in [30.0, 120.0, 240.0] {
            let off = off(&[], &bodies, &[], (5.0, rate), expected);
            assert!(off < 1e-7, "{masses:?} kg at {rate} Hz: {off:e} m");
        }
    }
}

#[test]
fn bodies_that_float_in_contact_bob_as_one_and_rest() {
    for (lower, upper, drag) in [(300.0, 200.0, 0.0), (300.0, 200.0, 1.0), (400.0, 2.0, 1.0), (500.0, 100.0, 1.3)] {
        let bodies = [box_at(0.0, -0.6, DVec2::splat(0.5), lower, drag), box_at(0.1, -1.3, v(0.3, 0.2), upper, drag)];
        let expected = as_one(&bodies, 30.0, true, |a| a);
        for rate in [60.0, 120.0, 240.0] {
            let off = off(&[], &bodies, &[water()], (30.0, rate), expected);
            assert!(off < 1e-6, "{lower} and {upper} kg at {rate} Hz: {off:e} m");
        }
        if drag > 0.0 {
            let mut world = world(vec![], bodies.to_vec(), vec![water()]);
            world.steps(120 * 120, 1.0 / 120.0);
            assert_eq!([world.speed(0), world.speed(1)], [DVec2::ZERO; 2], "{lower} and {upper} kg");
        }
    }
}

#[test]
fn bodies_that_slide_through_air_in_contact_slide_as_one() {
    let rough = rough(0.9, 0.3);
    let floor = [SurfaceDef::fixed(area(-300.0, 0.0, 300.0, 1.0), rough)];
    let slides = |x: f64, y: f64, mass: f64, drag: f64| BodyDef {
        velocity: v(7.0, 0.0),
        material: rough,
        ..box_at(x, y, DVec2::splat(0.5), mass, drag)
    };
    let row = [slides(0.0, -0.5, 8.0, 0.5), slides(1.0, -0.5, 1.0, 1.5)];
    let stack = [slides(0.0, -0.5, 8.0, 0.5), slides(0.2, -1.5, 3.0, 1.5)];
    for bodies in [row, stack] {
        let expected = as_one(&bodies, 0.8, false, |a| v(a.x - 0.3 * PULL, 0.0));
        for rate in [30.0, 120.0, 240.0] {
            let off = off(&floor, &bodies, &[], (0.8, rate), expected);
            assert!(off < 1e-7, "at {rate} Hz: {off:e} m");
        }
    }
}

/// At its apex nothing presses in it any more: all partings fall into one tick.
#[test]
fn a_stack_thrown_up_parts_alike_at_any_rate() {
    for (k, masses) in [[65.0, 2.0, 0.5, 9.0], [50.0, 5.0, 0.4, 7.0], [20.0, 10.0, 5.0, 1.0]].into_iter().enumerate() {
        let thrown = |(i, mass): (usize, f64)| {
            let body = box_at(0.03 * i as f64, -3.0 - 0.6 * i as f64, v(0.4 + 0.05 * (i % 2) as f64, 0.3), mass, 1.0);
            BodyDef { velocity: v(1.0, -2.0), ..body }
        };
        let bodies: Vec<_> = masses.into_iter().enumerate().map(thrown).collect();
        let [found, fine] = [30.0, 240.0].map(|rate| {
            let mut world = world(vec![], bodies.clone(), vec![]);
            world.steps(rate as u32, 1.0 / rate);
            world
        });
        let off = (0..4).map(|i| found.at(i).distance(fine.at(i))).fold(0.0, f64::max);
        assert!(off < 1e-6, "{k}: {off:e}");
    }
}
