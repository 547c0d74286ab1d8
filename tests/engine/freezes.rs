//! Time goes on, whatever happens in a tick: scenes in which the world once stood still for good or for seconds, or let a body through.

use crate::support::{BODY, Random, TICK, area, block, crate_at, floor, run, world};
use resultant::physics::{BodyDef, BodyId, DVec2, Material, StreamDef, WorldDef};

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
