//! Free flight of crowds: each of many bodies flies as exactly as one alone does.

use resultant::physics::{BodyDef, BodyId, DVec2, StreamDef, World, WorldDef};

const G: f64 = 9.81;
/// Bodies, m apart: a crowd that never meets.
const APART: f64 = 1e4;

/// A crowd of copies of `body` of which the first stands for all.
fn crowd_of(body: &BodyDef, streams: Vec<StreamDef>) -> World {
    let at = |i: usize| DVec2::new(APART * (i % 10) as f64, APART * (i / 10) as f64);
    let bodies = (0..100).map(|i| BodyDef { position: body.position + at(i), ..body.clone() });
    World::new(WorldDef { gravity: G, air_density: 1.0, bodies: bodies.collect(), streams, ..WorldDef::default() }).unwrap()
}

/// A body of drag k = ½·C_d·A/m per metre.
fn light(k: f64, velocity: DVec2) -> BodyDef {
    BodyDef { mass: 0.5 / k, velocity, ..BodyDef::default() }
}

/// physics.md: x = (v_t²/g)·ln(cosh τ) from rest.
#[test]
fn falls_with_drag_are_right_to_a_micrometre_at_any_weight() {
    for rate in [60.0, 120.0, 240.0] {
        for k in [1e-3, 0.01, 0.1, 0.3, 1.0, 30.0, 1e3, 1e6] {
            let mut world = crowd_of(&light(k, DVec2::ZERO), Vec::new());
            (0..(6.0 * rate) as u32).for_each(|_| world.step(1.0 / rate));
            let terminal = (G / k).sqrt();
            let tau = G * 6.0 / terminal;
            let exact = terminal * terminal / G * (tau + (-2.0 * tau).exp().ln_1p() - 2f64.ln());
            let body = world.body(BodyId(0));
            assert!((body.position.y - exact).abs() < 1e-6, "{rate} Hz, k {k}: {} m, exact {exact} m", body.position.y);
            let speed = terminal * tau.tanh();
            assert!((body.velocity.y / speed - 1.0).abs() < 1e-6, "{rate} Hz, k {k}: {} m/s, exact {speed}", body.velocity.y);
        }
    }
}

/// RK4 at 2e-5 s.
fn reference(body: &BodyDef, seconds: f64) -> DVec2 {
    const H: f64 = 2e-5;
    let acceleration = |v: DVec2| {
        let shown = 2.0 * (body.half.x * v.y.abs() + body.half.y * v.x.abs());
        DVec2::new(0.0, G) - v * (0.5 * body.drag * shown / body.mass)
    };
    let (mut x, mut v) = (body.position, body.velocity);
    for _ in 0..(seconds / H).round() as u32 {
        let a1 = acceleration(v);
        let a2 = acceleration(v + a1 * (0.5 * H));
        let a3 = acceleration(v + a2 * (0.5 * H));
        let a4 = acceleration(v + a3 * H);
        x += (v + (a1 + a2 + a3) * (H / 6.0)) * H;
        v += (a1 + 2.0 * (a2 + a3) + a4) * (H / 6.0);
    }
    x
}

#[test]
fn projectiles_are_right_to_a_micrometre() {
    for (k, velocity) in [(0.05, DVec2::new(20.0, -20.0)), (0.1, DVec2::new(20.0, -10.0)), (0.1, DVec2::new(-3.0, -19.0))] {
        let exact = reference(&light(k, velocity), 3.0);
        for rate in [60.0, 120.0] {
            let mut world = crowd_of(&light(k, velocity), Vec::new());
            (0..(3.0 * rate) as u32).for_each(|_| world.step(1.0 / rate));
            let error = world.body(BodyId(0)).position.distance(exact);
            assert!(error < 1e-8, "{rate} Hz, k {k}, {velocity}: {error} m");
        }
    }
}

/// To the bit, over the apex of a throw and for feathers, too.
#[test]
fn a_body_of_a_crowd_flies_as_it_does_alone() {
    for (mass, round) in [(10.0, false), (10.0, true), (0.01, false), (1e-7, false)] {
        let half = DVec2::new(0.2, 1.5);
        let body = BodyDef { half, mass, round, velocity: DVec2::new(20.0, -13.0), ..BodyDef::default() };
        for rate in [30.0, 60.0, 120.0] {
            let mut world = crowd_of(&body, Vec::new());
            let def = WorldDef { gravity: G, air_density: 1.0, bodies: vec![body.clone()], ..WorldDef::default() };
            let mut alone = World::new(def).unwrap();
            for tick in 0..(3.0 * rate) as u32 {
                world.step(1.0 / rate);
                alone.step(1.0 / rate);
                let pose = |world: &World| (world.body(BodyId(0)).position, world.body(BodyId(0)).velocity);
                assert_eq!(pose(&world), pose(&alone), "{mass} kg, round {round}, {rate} Hz, tick {tick}");
            }
            if mass == 10.0 && !round {
                let error = world.body(BodyId(0)).position.distance(reference(&body, 3.0));
                assert!(error < 1e-8, "{rate} Hz: {error} m");
            }
        }
    }
}

/// 40 m/s relative to the air, without gravity: v = v₀/(1 + kv₀t), s = ln(1 + kv₀t)/k.
#[test]
fn a_gust_never_turns_a_light_thing_round() {
    for rate in [60.0, 120.0] {
        for k in [0.1, 1.0, 300.0, 1e5] {
            let body = light(k, DVec2::new(40.0, 0.0));
            let bodies = (0..100).map(|i| BodyDef { position: DVec2::new(0.0, 10.0 * f64::from(i)), ..body.clone() });
            let def = WorldDef { gravity: 0.0, air_density: 1.0, bodies: bodies.collect(), ..WorldDef::default() };
            let mut world = World::new(def).unwrap();
            for tick in 1..=(rate as u32) {
                world.step(1.0 / rate);
                let t = f64::from(tick) / rate;
                let body = world.body(BodyId(0));
                let exact = (k * 40.0 * t).ln_1p() / k;
                assert!(body.velocity.x > 0.0, "{rate} Hz, k {k}, tick {tick}: turned round");
                assert!((body.position.x - exact).abs() < 1e-6, "{rate} Hz, k {k}, tick {tick}: {} m off", body.position.x - exact);
            }
        }
    }
}
