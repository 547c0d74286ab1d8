//! Many bodies at once: nothing overlaps, nothing passes through, everything comes to rest, the same bits every time.

use crate::support::dense::{self, all_asleep, dense, empty, restless};
use crate::support::{Ask, Random, assert_all_at_rest, block, crate_at, energy, worst_overlap};
use resultant::physics::{BodyDef, DVec2, World, WorldDef};

const DT: f64 = 1.0 / 60.0;
const MOST_OVERLAP: f64 = 1e-6;

fn rain(n: usize, masses: (f64, f64), restitution: f64) -> WorldDef {
    rain_into(n, (n as f64).sqrt().ceil() as usize, 7, masses, restitution)
}

fn rain_into(n: usize, columns: usize, seed: u64, masses: (f64, f64), restitution: f64) -> WorldDef {
    dense::rain_into(0.0, n, columns, masses, Random(seed), restitution)
}

fn floor(bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { bodies, surfaces: vec![block(-100.0, 0.0, 100.0, 1.0)], ..empty() }
}

/// Runs until all sleep; asserts that nothing ever overlaps and that energy, kinetic and potential, never rises.
fn settles(def: WorldDef, most_steps: usize) -> World {
    let gravity = def.gravity;
    let mut pile = dense(def);
    let mut before = energy(&pile, gravity, 0.0);
    let rounding = 1e-12 * before.abs();
    for step in 0..most_steps {
        pile.step(DT);
        let (deepest, now) = (worst_overlap(&pile), energy(&pile, gravity, 0.0));
        assert!(deepest <= MOST_OVERLAP, "step {step}: overlap {deepest}");
        assert!(now <= before + rounding, "step {step}: energy from {before} to {now}");
        before = now;
        if all_asleep(&pile) {
            assert_all_at_rest(&pile);
            return pile;
        }
    }
    panic!("still awake");
}

/// How many steps the highest of the bodies would bounce all alone: T = t₀(1 + e)/(1 − e), t₀ = √(2H/g).
fn lone_bounces(def: &WorldDef, restitution: f64) -> usize {
    let height = def.bodies.iter().fold(0.0, |most: f64, body| most.max(-body.position.y));
    let fall = (2.0 * height / def.gravity).sqrt();
    (fall * (1.0 + restitution) / (1.0 - restitution) / DT) as usize
}

#[test]
fn rain_comes_to_rest_and_never_overlaps() {
    for (n, masses) in [(100, (1.0, 1.0)), (600, (1.0, 1.0)), (300, (0.5, 50.0))] {
        settles(rain(n, masses, 0.0), 600);
    }
}

/// With mixed restitutions a pile rests no later than the last ball would that bounces all alone.
#[test]
fn rain_of_mixed_restitutions_comes_to_rest() {
    for n in [100, 300, 1000, 2500] {
        let def = rain(n, (1.0, 1.0), 0.8);
        let most = lone_bounces(&def, 0.8);
        let pile = settles(def.clone(), most);
        // Boxes that do not turn lie loosely, but they lie.
        let top = (0..n).fold(0.0, |top: f64, i| top.min(pile.bodies()[i].bounds().min.y));
        let area: f64 = def.bodies.iter().map(|body| 4.0 * body.half.x * body.half.y).sum();
        let filled = area / (-top * def.surfaces[2].bounds.min.x);
        assert!((0.4..1.0).contains(&filled), "{n}: filled to {filled}");
    }
}

#[test]
fn a_large_heap_does_not_creep() {
    for seed in [7, 8] {
        let n = 2500;
        let mut pile = restless(rain_into(n, 50, seed, (1.0, 1.0), 0.8));
        pile.steps(140, DT);
        let moving = (0..n).filter(|i| pile.speed(*i) != DVec2::ZERO).count();
        assert!(moving < n / 3, "seed {seed}: {moving} of {n} move");
    }
}

/// A heavy body throws a light one up to three times as fast, so these bounce for longer than any alone.
#[test]
fn rain_of_mixed_masses_and_restitutions_comes_to_rest_in_pits_of_any_shape() {
    for seed in 1..5 {
        for columns in [6, 14, 50] {
            settles(rain_into(200, columns, seed, (0.5, 50.0), 0.8), 3600);
        }
    }
}

/// A body that falls on a resting heap leaves it with its own part of the closing speed, as from the ground.
#[test]
fn a_ball_bounces_on_a_resting_heap() {
    let mut def = rain(60, (1.0, 5.0), 0.0);
    let heap = settles(def.clone(), 600);
    for (i, body) in def.bodies.iter_mut().enumerate() {
        (body.position, body.velocity) = (heap.at(i), DVec2::ZERO);
    }
    let top = (0..60).fold(0.0, |top: f64, i| top.min(heap.bodies()[i].bounds().min.y));
    let below = (0..60).find(|i| heap.bodies()[*i].bounds().min.y == top).unwrap();
    let drop = 4.0;
    let ball = BodyDef {
        half: DVec2::splat(0.1),
        position: DVec2::new(heap.at(below).x, top - 0.1 - drop),
        restitution: 0.9,
        ..BodyDef::default()
    };
    def.bodies.push(ball);
    let mut pile = dense(def.clone());
    let heights: Vec<(f64, f64)> = (0..180)
        .map(|_| {
            pile.step(DT);
            (top - 0.1 - pile.at(60).y, pile.speed(60).y)
        })
        .collect();
    let thrown = heights.iter().position(|(_, velocity)| *velocity < 0.0).unwrap();
    let apex = heights[thrown..].iter().fold(0.0, |most: f64, (height, _)| most.max(*height));
    assert!((apex / (0.81 * drop) - 1.0).abs() < 1e-3, "apex {apex} m after a drop of {drop} m");
    settles(def, 3600);
}

#[test]
fn sleep_changes_no_bit() {
    let run = |sleep| {
        let def = rain(100, (0.5, 50.0), 0.0);
        let mut pile = if sleep { dense(def) } else { restless(def) };
        pile.steps(400, DT);
        (0..100).map(|i| pile.at(i).to_array().map(f64::to_bits)).collect::<Vec<_>>()
    };
    assert_eq!(run(true), run(false));
}

#[test]
fn static_friction_holds_a_row_below_its_limit_to_the_bit() {
    let limit = 0.9 * 9.81 * 2.0 * 5.0;
    let mut pile = dense(floor((0..5).map(|i| crate_at(f64::from(i), -0.5, 2.0)).collect()));
    pile.drive(0, 0.99 * limit, 0.0);
    pile.steps(1200, DT);
    (0..5).for_each(|i| assert_eq!(pile.at(i), DVec2::new(i as f64, -0.5)));
    pile.drive(0, 1.02 * limit, 0.0);
    pile.step(DT);
    let a = (1.02 * 0.9 - 0.65) * 9.81;
    (0..5).for_each(|i| assert!((pile.speed(i).x / DT - a).abs() < 1e-6 * a, "{}", pile.speed(i).x / DT));
}

#[test]
fn a_tower_is_dragged_along() {
    let mut pile = dense(floor((0..10).map(|i| crate_at(0.0, -0.5 - f64::from(i), 1.0)).collect()));
    pile.drive(0, 10.0 * (0.65 + 0.3) * 9.81, 0.0);
    pile.steps(60, DT);
    (0..10).for_each(|i| assert!((pile.speed(i).x - 0.3 * 9.81).abs() < 1e-9, "body {i}: {}", pile.speed(i).x));
}

#[test]
fn a_drive_pushes_into_the_pile_from_any_side() {
    for direction in [DVec2::X, -DVec2::X, DVec2::Y, -DVec2::Y] {
        let mut def = rain(80, (0.5, 5.0), 0.3);
        def.surfaces.push(block(-1.0, -12.0, 20.0, -11.0));
        let mut pile = dense(def);
        pile.drive(0, 200.0 * direction.x, 200.0 * direction.y);
        for step in 0..400 {
            pile.step(DT);
            let deepest = worst_overlap(&pile);
            assert!(deepest <= MOST_OVERLAP, "{direction} step {step}: overlap {deepest}");
            assert!((0..80).all(|i| pile.speed(i).length() < 1e3));
        }
    }
}
