//! Free flight of crowds: each of many bodies flies to the bit as one alone does, and that is the exact answer.

use crate::support::Ask;
use crate::support::dense::G;
use resultant::physics::{BodyDef, DVec2, World, WorldDef};

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
