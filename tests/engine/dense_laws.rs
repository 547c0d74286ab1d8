//! The laws of the dense method, one by one, against exact answers.

use crate::support::dense::{G, restless, scene, square};
use crate::support::{Ask, Random, TICK as DT, area, block, energy, room};
use resultant::physics::{BodyDef, DVec2, Material, SurfaceDef, World};

fn pile(bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>, gravity: f64) -> World {
    restless(scene(bodies, surfaces, gravity))
}

fn run(pile: &mut World, seconds: f64) {
    pile.steps((seconds / DT).round() as u32, DT);
}

/// An endless wall whose left side is at x = 0.
fn wall() -> Vec<SurfaceDef> {
    vec![block(0.0, -100.0, 1.0, 100.0)]
}

/// From a height, m.
fn bouncing(restitution: f64, height: f64) -> World {
    pile(vec![BodyDef { restitution, ..square(0.0, -0.5 - height) }], vec![block(-5.0, 0.0, 5.0, 1.0)], G)
}

/// The height that a bouncing body's energy carries it to, m.
fn apex(pile: &World) -> f64 {
    0.5 * pile.speed(0).y.powi(2) / G - pile.at(0).y - 0.5
}

#[test]
fn a_wall_holds_what_is_stacked_on_what_it_holds() {
    let mut tower = pile((0..3).map(|i| square(-0.5, -f64::from(i))).collect(), wall(), G);
    tower.drive(0, 4.0 * G / 0.9, 0.0);
    run(&mut tower, 1.0);
    for i in 0..3 {
        assert_eq!(tower.state(i), (DVec2::new(-0.5, -(i as f64)), DVec2::ZERO), "body {i}");
    }
}

#[test]
fn a_ceiling_holds_by_friction() {
    let mut one = pile(vec![square(0.0, 0.5)], vec![block(-50.0, -1.0, 50.0, 0.0)], G);
    one.drive(0, 8.0, -G - 10.0);
    run(&mut one, 1.0);
    assert_eq!(one.state(0), (DVec2::new(0.0, 0.5), DVec2::ZERO));
    one.drive(0, 10.0, -G - 10.0);
    run(&mut one, 1.0);
    assert!((one.speed(0).x - 3.5).abs() < 1e-9, "{}", one.speed(0));
}

/// The middle one drops with a = g − 2·μ_k·N/m.
#[test]
fn bodies_side_by_side_rub() {
    let bodies = vec![square(-1.0, -0.5), BodyDef { half: DVec2::new(0.5, 0.2), ..square(0.0, -0.7) }, square(1.0, -0.5)];
    let mut three = pile(bodies, vec![block(-10.0, 0.0, 10.0, 1.0)], G);
    three.drive(0, 30.0, 0.0);
    three.drive(2, -30.0, 0.0);
    run(&mut three, 0.5);
    assert!(three.speed(1).y.abs() < 1e-9, "{} {}", three.at(1), three.speed(1));
}

/// A body pressed against a standing one hangs there, or slides with a = g − μ_k·N/m, as on a wall; whatever the two weigh.
#[test]
fn a_standing_body_holds_by_friction() {
    for (mass, press, holds) in [(1.0, 30.0, true), (0.1, 30.0, true), (8.0, 120.0, true), (1.0, 8.0, false), (5.0, 8.0, false)] {
        let bodies =
            vec![BodyDef { mass, ..square(-0.5, -10.6) }, BodyDef { half: DVec2::new(0.5, 8.0), mass: 20.0, ..square(0.5, -8.0) }];
        let mut two = pile(bodies, vec![block(-50.0, 0.0, 50.0, 1.0), block(1.0, -100.0, 2.0, 0.0)], G);
        two.drive(0, press, 0.0);
        run(&mut two, 1.0);
        let (x, v) = two.state(0);
        if holds {
            assert_eq!((x, v), (DVec2::new(-0.5, -10.6), DVec2::ZERO), "{mass} kg, {press} N");
        } else {
            let a = G - 0.65 * press / mass;
            assert!((v.y - a).abs() < 1e-9 && (x.y + 10.6 - 0.5 * a).abs() < 1e-9, "{mass} kg, {press} N: {x} {v}, expected {a}");
        }
        assert_eq!(two.state(1), (DVec2::new(0.5, -8.0), DVec2::ZERO));
    }
}

#[test]
fn a_row_hangs_on_a_wall() {
    for count in [2_u32, 3, 6] {
        let bodies = (0..count).map(|i| square(-0.5 - f64::from(i), 0.0)).collect();
        let mut row = pile(bodies, wall(), G);
        row.drive(count as usize - 1, 1.02 * f64::from(count) * G / 0.9, 0.0);
        run(&mut row, 1.0);
        for i in 0..count {
            assert_eq!(row.state(i as usize), (DVec2::new(-0.5 - f64::from(i), 0.0), DVec2::ZERO), "{i} of {count}");
        }
    }
}

/// Law 1: friction in a bounce, up to μ_k·(1 + e)·w and no more than the sliding.
#[test]
fn a_bounce_rubs() {
    for (e, sliding) in [(0.5, 10.0), (1.0, 10.0), (0.8, 4.0)] {
        let body = BodyDef { velocity: DVec2::new(sliding, 8.0), restitution: e, ..square(0.0, -1.0) };
        let mut one = pile(vec![body], vec![block(-50.0, 0.0, 50.0, 1.0)], 0.0);
        run(&mut one, 0.5);
        let left = sliding - (0.65 * (1.0 + e) * 8.0_f64).min(sliding);
        assert!((one.speed(0) - DVec2::new(left, -8.0 * e)).length() < 1e-12, "{} {left}", one.speed(0));
    }
}

/// Law 2: where all are elastic, a crowd step gives back all energy and all momentum. Only the exact method says which block leaves.
#[test]
fn an_elastic_row_keeps_momentum_and_energy() {
    for gap in [0.0, 0.013] {
        for moving in [1, 2] {
            let first = |i: usize| if i < moving { DVec2::new(6.0, 0.0) } else { DVec2::ZERO };
            let place = |i: usize| i as f64 + if i < moving { -0.7 } else { gap * i as f64 };
            let bodies = (0..5).map(|i| BodyDef { velocity: first(i), restitution: 1.0, ..square(place(i), 0.0) }).collect();
            let mut five = pile(bodies, Vec::new(), 0.0);
            run(&mut five, 1.0);
            let momentum: f64 = five.bodies().iter().map(|body| body.velocity.x).sum();
            let energy: f64 = five.bodies().iter().map(|body| body.velocity.length_squared()).sum();
            assert!((momentum - 6.0 * moving as f64).abs() < 1e-12, "gap {gap}, {moving} moving: {momentum}");
            assert!((energy - 36.0 * moving as f64).abs() < 1e-11, "gap {gap}, {moving} moving: {energy}");
            let ordered = five.bodies().windows(2).all(|pair| pair[0].velocity.x <= pair[1].velocity.x + 1e-12);
            assert!(ordered, "gap {gap}, {moving} moving: they part");
        }
    }
}

const SMOOTH: Material = Material { name: "", static_friction: 0.0, kinetic_friction: 0.0, restitution: 0.0 };

#[test]
fn an_elastic_gas_keeps_its_energy() {
    for (gravity, mixed) in [(0.0, false), (0.0, true), (G, true)] {
        let mut random = Random(9);
        let bodies: Vec<BodyDef> = (0..200)
            .map(|i| BodyDef {
                velocity: DVec2::new(20.0 * random.unit() - 10.0, 20.0 * random.unit() - 10.0),
                mass: if mixed { 0.1 + 10.0 * random.unit() } else { 1.0 },
                half: DVec2::splat(0.2),
                restitution: 1.0,
                material: SMOOTH,
                ..square(1.0 + f64::from(i % 20), 1.0 + f64::from(i / 20))
            })
            .collect();
        let walls = room(area(0.0, 0.0, 21.0, 12.0), 1.0).map(|wall| SurfaceDef { material: SMOOTH, ..wall });
        let mut gas = pile(bodies, walls.into(), gravity);
        let before = energy(&gas, gravity, 12.0);
        run(&mut gas, 10.0);
        let gained = energy(&gas, gravity, 12.0) / before - 1.0;
        // With gravity a bounce that would end within the step is none: that takes energy, and gives none.
        let least = if gravity == 0.0 { -1e-9 } else { -0.05 };
        assert!((least..1e-9).contains(&gained), "gravity {gravity}, mixed {mixed}: {gained}");
    }
}

/// Law 3: the n-th apex is H·e^(2n), and all ends at t₀(1 + e)/(1 − e), but for the rest of the step that each of some 15 bounces takes.
#[test]
fn apexes_are_exact_and_bounces_end() {
    let (e, height) = (0.8, 2.0);
    let mut one = bouncing(e, height);
    let fall = (2.0 * height / G).sqrt();
    let end = fall * (1.0 + e) / (1.0 - e);
    let ticks = (1..1000).take_while(|_| {
        one.step(DT);
        one.speed(0).y != 0.0
    });
    let ended = ticks.count() as f64 * DT;
    assert!((-3.0 * DT..15.0 * DT).contains(&(ended - end)), "{ended} {end}");
    one.steps(2, DT);
    assert_eq!((one.at(0).y, one.speed(0).y), (-0.5, 0.0));
    // Between bounces the energy is that of the apex.
    let mut one = bouncing(e, height);
    run(&mut one, fall + 2.0 * fall * e + 0.1);
    assert!((apex(&one) - height * e.powi(4)).abs() < 1e-12, "{}", apex(&one));
}

#[test]
fn an_elastic_bounce_never_ends() {
    for height in [1.0, 1e-3] {
        let mut one = bouncing(1.0, height);
        run(&mut one, 60.0);
        // A part in a million, or a picometre after ten thousands of bounces.
        assert!((apex(&one) - height).abs() < (1e-6 * height).max(1e-12), "{height}: {}", apex(&one));
    }
}

/// A corner holds no body that is level with its top but not over it, nor one beside its wall's line but not beside the wall.
#[test]
fn two_corners_hold_nothing_in_the_air() {
    for turned in [1.0, -1.0] {
        let walls = [block(0.0, 0.0, 1.0, 10.0), block(1.0, -0.5, 11.0, 10.0)];
        let [low, high] = walls.map(|wall| match turned > 0.0 {
            true => wall,
            false => block(-wall.bounds.max.x, wall.bounds.min.y, -wall.bounds.min.x, wall.bounds.max.y),
        });
        let mut one = pile(vec![square(-0.5 * turned, -1.0)], vec![low, high], 0.0);
        one.drive(0, 60_000.0 * turned, 50_000.0);
        run(&mut one, 0.1);
        let (x, v) = one.state(0);
        assert!((x - DVec2::new(0.5 * turned, -0.5)).length() < 1e-9 && v == DVec2::ZERO, "{x} {v}");
    }
}

/// Law 5: seams of a floor of tiles or of resting boxes, at any height and place.
#[test]
fn seams_are_not_felt() {
    for e in [0.0, 0.5] {
        for origin in [0.0, 12_345.678, 1e5] {
            for (tile, of_bodies) in [(1.0, false), (0.3, false), (1.0, true)] {
                let slider = BodyDef { velocity: DVec2::new(20.0, 0.0), restitution: e, ..square(origin, -0.5) };
                let mut bodies = vec![slider];
                let mut surfaces = Vec::new();
                for k in -5..(40.0 / tile) as i32 {
                    let left = origin + tile * f64::from(k);
                    if of_bodies {
                        bodies.push(BodyDef { mass: 1.0, ..square(left + 0.5, 0.5) });
                    } else {
                        surfaces.push(block(left, 0.0, left + tile, 1.0));
                    }
                }
                if of_bodies {
                    surfaces.push(block(origin - 50.0, 1.0, origin + 90.0, 2.0));
                    surfaces.push(block(origin + 34.0 + 1.0, 0.0, origin + 90.0, 1.0));
                    bodies.truncate(41);
                }
                let mut scene = pile(bodies, surfaces, G);
                run(&mut scene, 6.0);
                let (way, exact) = (scene.at(0).x - origin, 400.0 / (2.0 * 0.65 * G));
                let allowed = if of_bodies { 1e-3 } else { 1e-7 };
                let case = format!("e {e}, origin {origin}, tiles {tile}, bodies {of_bodies}");
                assert!((way - exact).abs() < allowed, "{case}: {way}, exact {exact}");
            }
        }
    }
}

/// In a shaft as wide as itself, beside one that rests: the two are in each other by less than they would have to touch.
#[test]
fn a_body_falls_past_another_that_it_grazes() {
    for graze in [1e-10, 5e-10, 9e-10] {
        let bodies = vec![square(0.5, -3.0), square(1.5 - graze, -0.5)];
        let surfaces = vec![block(-1.0, 0.0, 5.0, 1.0), block(-1.0, -20.0, 0.0, 0.0), block(2.0 - graze, -20.0, 5.0, 0.0)];
        let mut pile = pile(bodies, surfaces, 10.0);
        run(&mut pile, 2.0);
        assert!((pile.at(0).y + 0.5).abs() < 1e-9, "{graze}: {}", pile.at(0));
    }
}
