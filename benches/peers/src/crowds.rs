//! The scenes of many bodies, at the usual step and with the usual settings: flights, piles, islands, a tower, what floats, what sleeps,
//! a lift.

use crate::engine::{Box, Lift, Liquid, Spec};
use crate::scenes::{FLOOR, FRICTION, G, Scene, crate_at, fallen, run, scene, spec};
use crate::watch::Run;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::ops::RangeInclusive;

/// All of them.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = vec![
        Scene { pile: true, ..scene("flight-1000", "position after 5 s of fall, m", 5.0, flight(1000), fallen) },
        Scene { pile: true, ..scene("flight-10000", "position after 5 s of fall, m", 5.0, flight(10_000), fallen) },
        Scene {
            pile: true,
            ..scene(
                "flight-drag-10000",
                "position after 5 s of fall (Resultant: quadratic drag; others: linear), m",
                5.0,
                Spec { terminal: 20.0, ..flight(10_000) },
                fall_through_air,
            )
        },
    ];
    let pile = |name, seconds, spec| Scene { pile: true, ..scene(name, "worst overlap at any step, m", seconds, spec, overlap) };
    for (name, n) in [("pile-100", 100), ("pile-1000", 1000), ("pile-5000", 5000)] {
        scenes.push(pile(name, 10.0, rain(n, 1.0..=1.0, 0.0)));
    }
    for (name, n) in [("masses-300", 300), ("masses-1000", 1000), ("masses-5000", 5000)] {
        scenes.push(pile(name, 10.0, rain(n, 0.5..=50.0, 0.0)));
    }
    for (name, n) in [("restitutions-100", 100), ("restitutions-1000", 1000), ("restitutions-5000", 5000)] {
        scenes.push(pile(name, 10.0, rain(n, 1.0..=1.0, 0.8)));
    }
    for (name, n) in [("settled-100", 100), ("settled-1000", 1000), ("settled-5000", 5000)] {
        let spec = Spec { sleep: true, ..rain(n, 1.0..=1.0, 0.0) };
        scenes.push(Scene {
            settle: 30.0,
            what: "largest movement in 10 s after 30 s, m",
            error: movement,
            ..pile(name, 10.0, spec)
        });
    }
    scenes.push(pile("islands-200", 10.0, islands()));
    scenes.push(scene("tower-hit", "worst overlap at any step, m", 5.0, tower(), overlap));
    scenes.push(scene("afloat-64", "worst distance from the depth at which it floats after 20 s, m", 20.0, afloat(), depth));
    scenes.push(Scene { settle: 4.0, ..pile("asleep-1000", 1.0, asleep()) });
    scenes.push(pile("lift", 10.0, lift()));
    scenes
}

/// Two hundred pens with five boxes each, which rain into them and bounce.
fn islands() -> Spec {
    let mut random = Pcg64Mcg::seed_from_u64(11);
    let pen = |i: usize| 4.0 * (i / 5) as f64;
    let bodies = (0..1000).map(|i| Box {
        half: (random.random_range(0.15..0.3), random.random_range(0.15..0.3)),
        position: (pen(i) + random.random_range(-0.5..0.5), -1.0 - 0.8 * (i % 5) as f64),
        velocity: (random.random_range(-2.0..2.0), 0.0),
        restitution: random.random_range(0.0..0.8),
        ..crate_at(0.0, 0.0, 1.0)
    });
    let bodies = bodies.collect();
    let walls = (0..=200).map(|k| ((4.0 * f64::from(k) - 2.0, -50.0), (0.5, 50.0)));
    Spec { statics: walls.chain([((400.0, FLOOR), (500.0, FLOOR))]).collect(), ..spec(bodies) }
}

/// A tower of 7 × 7 crates of 10 kg, hit at half its height by 50 kg at 15 m/s, all in air.
fn tower() -> Spec {
    let mut bodies: Vec<_> = (0..49).map(|i| crate_at(f64::from(i / 7), f64::from(i % 7), 10.0)).collect();
    bodies.push(Box { velocity: (15.0, -3.0), ..crate_at(-6.0, 3.2, 50.0) });
    Spec { terminal: 50.0, ..spec(bodies) }
}

/// Sixty-four crates of 30 to 70 % of the density of water, dropped into it.
fn afloat() -> Spec {
    let mut random = Pcg64Mcg::seed_from_u64(5);
    let bodies = (0..64).map(|i| {
        let half = random.random_range(0.3..0.6);
        Box {
            half: (half, half),
            mass: random.random_range(300.0..700.0) * 4.0 * half * half,
            ..crate_at(2.0 * f64::from(i) - 64.0, 1.0, 1.0)
        }
    });
    let bodies = bodies.collect();
    Spec {
        statics: vec![((0.0, 20.0 + FLOOR), (200.0, FLOOR))],
        liquid: Some(Liquid { zone: ((0.0, 10.0), (200.0, 10.0)), density: 1000.0, damping: 2.0 }),
        ..spec(bodies)
    }
}

/// A thousand crates that rest, two on each other, and ten that are pushed along a little harder than friction holds.
fn asleep() -> Spec {
    let resting = (0..1000).map(|i| crate_at(-2.0 * f64::from(i / 2) - 10.0, f64::from(i % 2), 1.0));
    let pushed =
        (0..10).map(|i| Box { velocity: (1.0, 0.0), force: FRICTION * G + 0.01, ..crate_at(5.0 * f64::from(i), 0.0, 1.0) });
    Spec { sleep: true, statics: vec![((0.0, FLOOR), (5000.0, FLOOR))], ..spec(resting.chain(pushed).collect()) }
}

/// Three hundred boxes that rain into a shaft whose floor goes up and down by 2 m in 4 s, at 2 m/s².
fn lift() -> Spec {
    let rain = rain(300, 1.0..=1.0, 0.3);
    let (floor, walls) = (rain.statics[0], rain.statics[1..].to_vec());
    let ((x, y), (half, high)) = floor;
    Spec { statics: walls, lift: Some(Lift { place: ((x, y), (half - 5.0 - 1e-3, high)), rise: 2.0, period: 4.0 }), ..rain }
}

/// How far a body that floats is from where Archimedes' principle has it.
fn depth(engine: &mut dyn Run, spec: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    let off = |(i, body): (usize, &Box)| {
        let inside = spec.liquid.as_ref().map_or(0.0, |liquid| body.mass / (liquid.density * 2.0 * body.half.0));
        (engine.position(i).1 + body.half.1 - inside).abs()
    };
    spec.bodies.iter().enumerate().map(off).fold(0.0, f64::max)
}

/// Bodies far from each other.
fn flight(n: u32) -> Spec {
    let body = |i: u32| Box { position: (f64::from(i % 100) * 3.0, f64::from(i / 100) * 3.0), ..crate_at(0.0, 0.0, 10.0) };
    Spec { statics: vec![], ..spec((0..n).map(body).collect()) }
}

/// Boxes of 0.3 to 0.6 m raining into a pit, with restitutions up to the one given.
fn rain(n: usize, masses: RangeInclusive<f64>, restitution: f64) -> Spec {
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let columns = (n as f64).sqrt().ceil() as usize;
    let width = columns as f64 * 0.7;
    let bodies = (0..n).map(|i| Box {
        half: (random.random_range(0.15..0.3), random.random_range(0.15..0.3)),
        position: (0.35 + 0.7 * (i % columns) as f64, -1.0 - 0.8 * (i / columns) as f64),
        velocity: (random.random_range(-2.0..2.0), 0.0),
        mass: random.random_range(masses.clone()),
        restitution: restitution * random.random_range(0.0..1.0),
        force: 0.0,
    });
    let statics = vec![
        ((0.5 * width, 0.5), (0.5 * width + 5.0, 0.5)),
        ((-0.5, -1000.0), (0.5, 1000.0)),
        ((width + 0.5, -1000.0), (0.5, 1000.0)),
    ];
    Spec { statics, ..spec(bodies.collect()) }
}

/// The fall through air, from rest: each against its own law.
fn fall_through_air(engine: &mut dyn Run, spec: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    // In units of v_t/g, the time in which gravity alone gives the terminal speed.
    let (unit, t) = (spec.terminal / spec.gravity, steps as f64 * step);
    let tau = t / unit;
    let ways = if engine.quadratic() { tau.cosh().ln() } else { tau + (-tau).exp_m1() };
    let fallen = |(i, body): (usize, &Box)| (engine.position(i).1 - body.position.1 - ways * unit * spec.terminal).abs();
    spec.bodies.iter().enumerate().map(fallen).fold(0.0, f64::max)
}

fn overlap(engine: &mut dyn Run, _: &Spec, steps: usize, step: f64) -> f64 {
    run(engine, steps, step);
    engine.overlap()
}

/// The largest way of any body.
fn movement(engine: &mut dyn Run, spec: &Spec, steps: usize, step: f64) -> f64 {
    let bodies = 0..spec.bodies.len();
    let before: Vec<_> = bodies.clone().map(|i| engine.position(i)).collect();
    run(engine, steps, step);
    let way = |i: usize| {
        let (x, y) = engine.position(i);
        (x - before[i].0).hypot(y - before[i].1)
    };
    bodies.map(way).fold(0.0, f64::max)
}
