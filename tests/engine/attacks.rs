//! Scenes in which this engine once failed, or in which engines fail: tunnelling, results that depend on the tick, infinities, time that
//! stands still.

use crate::support::{Ask, BODY, G, Random, TICK, area, block, crate_at, elastic, floor, pool, run, v, world};
use resultant::physics::{BodyDef, BodyId, DVec2, Guards, Material, StreamDef, WorldDef};

/// Neighbours were once sought along weight and drive alone, and buoyancy shot a light cube through the lid.
#[test]
fn a_light_cube_under_water_stays_under_a_thin_lid() {
    for mass in [0.01, 0.1, 1.0, 10.0] {
        for below in [0.0, 0.3, 2.0, 8.0] {
            for hz in [2.0, 10.0, 30.0, 120.0] {
                let bodies = vec![BodyDef { half: DVec2::splat(0.2), ..crate_at(0.0, 5.3 + below, mass) }];
                let surfaces = vec![block(-3.0, 5.0, 3.0, 5.1)];
                let mut world = world(WorldDef { bodies, surfaces, fluids: vec![pool(1000.0, 0.001)], ..WorldDef::default() });
                run(&mut world, 3.0, 1.0 / hz);
                let top = world.body(BODY).bounds().min.y;
                assert!((top - 5.1).abs() < 1e-9, "{mass} kg from {below} m below at {hz} Hz: its top is at {top} m");
            }
        }
    }
}

/// The number of bounces of a train in air overflowed, and a place became no number.
#[test]
fn something_heavy_that_flies_into_something_light_in_air_stays_finite() {
    for (hz, air, heavy, speed) in [(120.0, 1.2041, 100.0, 300.0), (120.0, 65.0, 100.0, 20.0), (30.0, 1.2041, 100.0, 100.0)] {
        let at = |x: f64, mass: f64, speed: f64| elastic(v(x, 0.0), mass, speed);
        let bodies = vec![at(0.0, heavy, speed), at(1.5, 1e-3, 0.0)];
        let mut world = world(WorldDef { gravity: 0.0, air_density: air, bodies, ..WorldDef::default() });
        run(&mut world, 1.0, 1.0 / hz);
        assert!(world.bodies().iter().all(|body| body.position.is_finite() && body.velocity.is_finite()), "{hz} Hz, {air} kg/m³");
    }
}

#[test]
fn what_is_pushed_hard_stops_at_the_wall() {
    for (force, hz) in [(1e6, 120.0), (3e3, 2.0), (1e6, 2.0), (1e9, 30.0), (1e9, 1.0)] {
        for distance in [0.0, 0.01, 1.0, 30.0] {
            let surfaces = vec![floor(Material::ICE), block(10.0, -5.0, 10.1, 0.0)];
            let mut world = world(WorldDef { bodies: vec![crate_at(9.5 - distance, -0.5, 10.0)], surfaces, ..WorldDef::default() });
            world.drive(0, force, 0.0);
            run(&mut world, 4.0, 1.0 / hz);
            let right = world.body(BODY).bounds().max.x;
            assert!((right - 10.0).abs() < 1e-9, "{force} N at {hz} Hz from {distance} m: its right edge is at {right} m");
        }
    }
}

/// A stream once lasted a tick too long where a body left it just as a tick ended.
#[test]
fn a_stream_that_is_left_at_the_end_of_a_tick_has_passed_on_what_it_should() {
    for ticks in 5..=52 {
        for (mass, way) in [(1.0, 2.0), (3.0, 0.7), (70.0, 11.3)] {
            let time = f64::from(ticks) * TICK;
            let pull = 2.0 * way / (time * time);
            let zone = area(0.0, -2.0, 20.0, 2.0);
            let bodies = vec![BodyDef { half: DVec2::splat(0.5), ..crate_at(20.5 - way, 0.0, mass) }];
            let streams = vec![StreamDef { zone, force: DVec2::new(mass * pull, 0.0) }];
            let def = WorldDef { gravity: 0.0, air_density: 0.0, bodies, streams, ..WorldDef::default() };
            let mut world = world(def);
            run(&mut world, time + 4.0 * TICK, TICK);
            let (found, exact) = (world.speed(0).x, pull * time);
            assert!((found / exact - 1.0).abs() < 1e-9, "{ticks} ticks, {mass} kg, {way} m: {found} m/s, exact {exact} m/s");
        }
    }
}

#[test]
fn many_streams_within_a_tick_pass_on_what_they_should() {
    for (count, speed) in [(4, 300.0), (9, 600.0), (20, 1000.0), (60, 5000.0)] {
        for force in [1000.0, -1000.0] {
            let zone = |i: i32| area(2.0 + 0.1 * f64::from(i), -1.0, 2.05 + 0.1 * f64::from(i), 1.0);
            let streams = (0..count).map(|i| StreamDef { zone: zone(i), force: DVec2::new(force, 0.0) }).collect();
            let body = BodyDef { velocity: DVec2::new(speed, 0.0), half: DVec2::splat(0.02), mass: 2.0, ..BodyDef::default() };
            let mut world = world(WorldDef { gravity: 0.0, air_density: 0.0, bodies: vec![body], streams, ..WorldDef::default() });
            run(&mut world, 0.1, TICK);
            let work = f64::from(count) * force * (0.05 + 0.04);
            let exact = (speed * speed + work).sqrt();
            let found = world.speed(0).x;
            assert!((found / exact - 1.0).abs() < 1e-12, "{count} streams of {force} N: {found} m/s, exact {exact} m/s");
        }
    }
}

/// The height of a ball that falls from `height` and keeps the part `e` of its speed at each bounce, m.
fn bouncing(height: f64, e: f64, time: f64) -> f64 {
    let fall = (2.0 * height / G).sqrt();
    if time < fall {
        return height - 0.5 * G * time * time;
    }
    let (mut speed, mut since) = (e * G * fall, time - fall);
    while since > 2.0 * speed / G {
        since -= 2.0 * speed / G;
        speed *= e;
    }
    speed * since - 0.5 * G * since * since
}

/// Accepted numbers from which NaN once came.
#[test]
fn something_light_and_fast_on_something_heavy_in_thick_liquid_stays_finite() {
    for viscosity in [0.001, 1.0, 50.0, 1e3] {
        for density in [1.0, 1000.0] {
            for mass in [1e-6, 1e-3, 0.01] {
                for speed in [500.0, 1e6] {
                    let dart = BodyDef { velocity: v(speed, 0.1 * speed), half: DVec2::splat(0.1), ..crate_at(0.0, 3.9, mass) };
                    let surfaces = vec![block(-20.0, 5.0, 20.0, 6.0)];
                    let fluids = vec![pool(density, viscosity)];
                    let mut world =
                        world(WorldDef { bodies: vec![dart, crate_at(0.0, 4.5, 1000.0)], surfaces, fluids, ..WorldDef::default() });
                    run(&mut world, 0.3, TICK);
                    let fastest = world.bodies().iter().map(|body| body.velocity.length()).fold(0.0, f64::max);
                    assert!(fastest <= 1.1 * speed, "{viscosity} Pa·s, {density} kg/m³, {mass} kg, {speed} m/s: {fastest} m/s");
                }
            }
        }
    }
}

#[test]
fn any_tick_rate_will_do() {
    for hz in [1.0, 7.0, 60.0, 1e3, 1e5, 1e6] {
        let bodies = vec![
            BodyDef { velocity: DVec2::new(2.0, 0.0), ..crate_at(0.0, -0.5, 20.0) },
            BodyDef { restitution: 1.0, ..crate_at(10.0, -1.5, 3.0) },
            crate_at(2000.0, 0.0, 1.0),
        ];
        let mut world =
            world(WorldDef { air_density: 0.0, bodies, surfaces: vec![floor(Material::ASPHALT)], ..WorldDef::default() });
        world.steps(hz as u32, 1.0 / hz);
        world.validate().unwrap();
        let [slid, bounced, fell] = [0, 1, 2].map(|i| world.at(i));
        assert!((slid.x - 4.0 / (2.0 * 0.65 * G)).abs() < 1e-9, "{hz} Hz: slid {slid}");
        assert!((-0.5 - bounced.y - bouncing(1.0, 1.0, 1.0)).abs() < 1e-8, "{hz} Hz: bounced to {bounced}");
        assert!((fell.y - 0.5 * G).abs() < 1e-8, "{hz} Hz: fell to {fell}");
    }
}

#[test]
fn nothing_tunnels_far_from_the_origin() {
    for distance in [0.0, 1e4, 1e5, 1e6, 1e7] {
        for speed in [5.0, 400.0, 1e4, 1e6] {
            let surfaces = vec![block(distance + 10.0, distance - 5.0, distance + 10.05, distance + 5.0)];
            let dart = BodyDef { velocity: DVec2::new(speed, 0.0), half: DVec2::splat(0.1), ..crate_at(distance, distance, 1.0) };
            let mut world = world(WorldDef { gravity: 0.0, air_density: 0.0, bodies: vec![dart], surfaces, ..WorldDef::default() });
            run(&mut world, 2.0, TICK);
            let right = world.body(BODY).bounds().max.x - distance;
            let rounding = 1e-9 + 4.0 * f64::EPSILON * distance;
            assert!(right <= 10.0 + rounding && right > 9.0, "{speed} m/s, {distance} m away: its right edge is at {right} m");
        }
    }
}

/// With e = 1 a body loses neither speed nor time, however many bounces fall into a tick: its path is a straight one, folded at the walls.
#[test]
fn what_goes_to_and_fro_between_walls_is_where_its_way_says_at_any_speed() {
    for (speed, gap) in [(30.0, 1.0), (3e3, 1.0), (1e4, 2.0)] {
        let half = DVec2::splat(0.1);
        let body = BodyDef { restitution: 1.0, velocity: DVec2::new(speed, 0.0), half, ..crate_at(0.1 + 0.3 * gap, 0.0, 1.0) };
        let surfaces = vec![block(-1.0, -5.0, 0.0, 5.0), block(0.2 + gap, -5.0, 1.2 + gap, 5.0)];
        let mut world = world(WorldDef { gravity: 0.0, air_density: 0.0, bodies: vec![body], surfaces, ..WorldDef::default() });
        for tick in 1..=60 {
            world.step(TICK);
            let way = (0.3 * gap + speed * TICK * f64::from(tick)).rem_euclid(2.0 * gap);
            let (expected, ahead) = if way < gap { (way, 1.0) } else { (2.0 * gap - way, -1.0) };
            let (place, velocity) = (world.body(BODY).bounds().min.x, world.speed(0).x);
            let near_a_wall = expected.min(gap - expected) < 1e-6;
            assert!((velocity.abs() / speed - 1.0).abs() < 1e-12, "tick {tick}: {speed} m/s became {velocity} m/s");
            assert!(near_a_wall || velocity * ahead > 0.0, "tick {tick}: {velocity} m/s at {place} m");
            assert!((place - expected).abs() < 1e-6, "tick {tick} at {speed} m/s: at {place} m, not at {expected} m");
        }
        let Guards { budgets_used_up, dense_ticks, .. } = *world.guards();
        assert_eq!((budgets_used_up, dense_ticks), (0, 0), "{speed} m/s");
    }
}

/// Drag presses the light body against the heavy one behind it, and with e = 1 it bounces there without end, thousands of times a tick.
/// Drag c·v takes (2c/3a)·w² off the speed w of each bounce, which takes 2w/a: so w falls as e^(−c·t/3), in one tick or in a thousand.
#[test]
fn what_bounces_in_front_of_something_heavy_keeps_what_drag_leaves_it() {
    let (fast, bounce, time, half) = (10.0, 0.2, 1e-3, DVec2::splat(0.3));
    let def = || {
        let of = |x: f64, mass: f64, speed: f64| BodyDef { drag: 1.05, half, ..elastic(v(x, 0.0), mass, speed) };
        WorldDef { gravity: 0.0, bodies: vec![of(0.0, 1e6, fast), of(0.6, 1e-3, fast + bounce)], ..WorldDef::default() }
    };
    let k = 0.5 * def().air_density * 1.05 * 0.6 / 1e-3;
    let (pull, rate) = (k * fast * fast, 2.0 * k * fast);
    let expected = bounce * (-rate * time / 3.0).exp();
    for ticks in [1, 2, 1000] {
        let mut world = world(def());
        (0..ticks).for_each(|_| world.step(time / f64::from(ticks)));
        let [heavy, light] = [0, 1].map(|i| world.body(BodyId(i)));
        let (gap, speed) = (light.position.x - heavy.position.x - 0.6, light.velocity.x - heavy.velocity.x);
        // The speed with which it is back.
        let left = (speed * speed + 2.0 * pull * gap).sqrt();
        assert!((left / expected - 1.0).abs() < 0.1, "{ticks} ticks: {left} m/s, not {expected} m/s");
        assert!(ticks > 2 || world.impulses().len() < 20, "{} impacts are listed", world.impulses().len());
        assert_eq!(world.guards().budgets_used_up, 0);
    }
}

/// The edge of a stream 1e-14 s away once took the whole budget of a tick, and time stood still: every tick must lead on as far as the
/// velocities at its ends say.
#[test]
fn time_advances_beside_a_fan() {
    for seed in 0..60 {
        let mut random = Random(seed);
        let ball = |i: usize| BodyDef {
            velocity: DVec2::new(random.between(-3.0, 3.0), random.between(-3.0, 3.0)),
            half: DVec2::splat(random.between(0.2, 0.5)),
            drag: 0.5,
            round: true,
            restitution: random.between(0.3, 1.0),
            ..crate_at(0.5 + 1.5 * i as f64, -2.0 - 1.2 * i as f64, 10.0 + 15.0 * i as f64)
        };
        let bodies: Vec<BodyDef> = (0..3).map(ball).collect();
        let (lift, aside) = (random.between(300.0, 1500.0), random.pick(&[0.0, 200.0]));
        let most = bodies.iter().map(|body| (lift + aside) / body.mass).fold(0.0, f64::max);
        let streams = vec![StreamDef { zone: area(2.0, -6.0, 4.0, 0.0), force: DVec2::new(aside, -lift) }];
        let surfaces = vec![floor(Material::ASPHALT), block(-1.5, -8.0, -1.0, 0.0), block(5.5, -8.0, 6.0, 0.0)];
        let mut world = world(WorldDef { bodies, streams, surfaces, ..WorldDef::default() });
        let mut free = 0;
        for tick in 0..600 {
            let before: Vec<(DVec2, DVec2)> = world.bodies().iter().map(|body| (body.position, body.velocity)).collect();
            world.step(TICK);
            world.validate().unwrap_or_else(|fault| panic!("seed {seed}, tick {tick}: {fault}"));
            for (i, (body, (position, velocity))) in world.bodies().iter().zip(before).enumerate() {
                if world.impulses().iter().any(|impulse| impulse.on(BodyId(i as u32)).is_some()) {
                    continue;
                }
                free += 1;
                let way = body.position - position;
                let mean = (velocity + body.velocity) * (0.5 * TICK);
                // A force that begins within the tick changes its way by a quarter of a·dt²/2 at most.
                assert!((way - mean).length() <= most * TICK * TICK, "seed {seed}, tick {tick}: body {i} went {way}, not {mean}");
            }
        }
        assert!(free > 1200, "seed {seed}: {free}");
    }
}

/// A ship of 21 kg at 1e6 m/s in air passed a block of 33 cm.
#[test]
fn what_is_fast_in_air_stops_at_a_thin_block() {
    for speed in [300.0, 1e4, 1e5, 1e6] {
        for (distance, air_density) in [(0.5, 1.2041), (5.0, 1.2041), (80.0, 1.2041), (5.0, 100.0)] {
            let ship = BodyDef {
                velocity: DVec2::new(speed, 0.0),
                half: DVec2::splat(0.85),
                drag: 1.15,
                ..crate_at(-0.85 - distance, 0.0, 21.0)
            };
            let surfaces = vec![block(0.0, -50.0, 0.33, 50.0)];
            let mut world = world(WorldDef { air_density, bodies: vec![ship], surfaces, ..WorldDef::default() });
            run(&mut world, 1.0, TICK);
            let right = world.body(BODY).bounds().max.x;
            assert!(right <= 1e-9, "{speed} m/s from {distance} m in {air_density} kg/m³: its right edge is at {right} m");
        }
    }
}
