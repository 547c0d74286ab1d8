//! Media within one tick: regressions where impacts, slides and surfaces of liquids meet drag.

use crate::support::{Ask, area, crate_at, floor, named_forces};
use resultant::physics::{BodyDef, BodyId, DVec2, Material, StreamDef, World, WorldDef};

/// A bounce that turned a plank from falling to flying across once left the forces shown not to add up to the resultant, and an error that
/// depended on the tick.
#[test]
fn a_plank_that_bounces_in_air_lands_where_it_does_at_any_tick() {
    let end = |ticks: u32| {
        let (velocity, half) = (DVec2::new(6.0, 8.0), DVec2::new(1.0, 0.2));
        let plank = BodyDef { velocity, half, drag: 1.15, restitution: 0.5, ..crate_at(0.0, -1.2, 2.0) };
        let surfaces = vec![floor(Material::ICE)];
        let mut world = World::new(WorldDef { surfaces, bodies: vec![plank], rest_speed: 0.0, ..WorldDef::default() }).unwrap();
        for tick in 0..ticks {
            world.step(0.5 / f64::from(ticks));
            let (sum, resultant) = (named_forces(&world, BodyId(0)), world.forces(BodyId(0)).resultant());
            assert!((sum - resultant).length() <= 1e-12 * resultant.length(), "tick {tick} of {ticks}: {sum} N, not {resultant} N");
        }
        world.at(0)
    };
    let fine = end(4000);
    for ticks in [15, 30, 60, 120] {
        assert!(end(ticks).distance(fine) < 1e-6, "{ticks} ticks: {} m off", end(ticks).distance(fine));
    }
}

/// Two blocks that moved as one but for the last bit of their speeds were taken to slide on each other. The slide ended after 1e-18 s, the
/// next plastic solve brought the last bit back, and one tick of a pile in air took a minute.
#[test]
fn speeds_that_differ_by_a_rounding_do_not_slide() {
    let speed = 0.193_602_083_850_716_34_f64;
    for above in [speed.next_down(), speed, speed.next_up()] {
        let block = |y: f64, speed: f64| BodyDef { velocity: DVec2::new(speed, 0.0), ..crate_at(0.0, y, 5.0) };
        let bodies = vec![block(-0.5, speed), block(-1.5, above)];
        let world = World::new(WorldDef { air_density: 0.0, surfaces: vec![floor(Material::ICE)], bodies, ..WorldDef::default() });
        for body in world.unwrap().bodies() {
            assert!((body.acceleration.x + 0.03 * 15.0).abs() < 1e-12, "{} m/s², not −0.45", body.acceleration.x);
        }
    }
}

/// Both ends of the tick lie outside the stream: its slop gives back 6e-7 J, and the check of energies has to allow for that.
#[test]
fn a_stream_that_throws_a_feather_back_within_a_tick_is_no_fault() {
    let feather = BodyDef { half: DVec2::ONE, velocity: DVec2::new(0.0, 3.2), ..crate_at(0.0, -1.0063, 0.2) };
    let stream = StreamDef { zone: area(-1.0, 0.0, 1.0, 9.0), force: DVec2::new(0.0, -300.0) };
    let mut world =
        World::new(WorldDef { air_density: 0.0, bodies: vec![feather], streams: vec![stream], ..WorldDef::default() }).unwrap();
    let mut turned = false;
    for _ in 0..4 {
        let before = world.speed(0).y;
        world.step(1.0 / 120.0);
        let body = world.body(BodyId(0));
        turned |= before > 0.0 && body.velocity.y < 0.0 && body.position.y < -1.0;
        let energy = 0.5 * body.velocity.length_squared() - 15.0 * (body.position.y + 1.0063);
        assert!((energy - 5.12).abs() < 1e-5, "{energy} J/kg");
    }
    assert!(turned);
}

/// A driven feather that slid on a crate from rest was thrown back at 17 m/s: one implicit step foresaw the drag of its first speed alone.
#[test]
fn air_does_not_throw_back_a_feather_that_slides_on_a_crate() {
    let feather = BodyDef { half: DVec2::new(0.03, 0.5646736810234176), ..crate_at(0.0, -1.3646736810234176, 0.0107) };
    let crate_ = BodyDef { half: DVec2::new(0.6, 0.4), ..crate_at(0.0, -0.4, 0.75) };
    let def = WorldDef { surfaces: vec![floor(Material::ICE)], bodies: vec![feather, crate_], ..WorldDef::default() };
    for hz in [60.0, 120.0] {
        let mut world = World::new(def.clone()).unwrap();
        world.drive(0, -107.0, 107.0);
        for _ in 0..6 {
            world.step(1.0 / hz);
            let body = world.body(BodyId(0));
            assert!(body.velocity.x <= 0.0 && body.position.x <= 0.0, "{hz} Hz: {} at {}", body.velocity, body.position);
        }
    }
}

/// A feather on a heavy crate that rises and falls again leaves it at the apex. The step that led over the apex gained a 10⁻⁵ part of its energy.
#[test]
fn a_feather_on_a_thrown_crate_gains_nothing_at_the_apex() {
    let (low, high) = (DVec2::new(0.03, 0.598), DVec2::new(0.35, 0.289));
    for speed in 0..125 {
        let velocity = DVec2::new(0.0, -0.5 - 0.001 * f64::from(speed));
        let crate_ = BodyDef { velocity, half: low, mass: 31.0, ..BodyDef::default() };
        let feather = BodyDef { position: DVec2::new(0.1, -low.y - high.y), half: high, mass: 0.0133, ..crate_.clone() };
        let mut world = World::new(WorldDef { bodies: vec![crate_, feather], ..WorldDef::default() }).unwrap();
        // Each step checks the energy of the island.
        world.steps(8, 1.0 / 120.0);
        let apart = world.at(0).y - world.at(1).y;
        assert!(apart > low.y + high.y + 1e-6, "{velocity}: {apart} m");
    }
}
