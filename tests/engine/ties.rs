//! Ties and shares: the order of rows, a mirror or a shift changes nothing.

use crate::support::{Ask, G, TICK, block};
use resultant::physics::{BodyDef, BodyId, DVec2, ForceKind, Material, Obstacle, Plan, Source, SurfaceDef, World, WorldDef};

fn free(bodies: Vec<BodyDef>) -> WorldDef {
    WorldDef { gravity: 0.0, air_density: 0.0, bodies, ..WorldDef::default() }
}

fn boxed(position: DVec2, half: DVec2, mass: f64, velocity: DVec2, restitution: f64) -> BodyDef {
    BodyDef { position, half, mass, velocity, restitution, ..BodyDef::default() }
}

fn orders(count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let with = |order: &Vec<usize>, at: usize| {
        let mut order = order.clone();
        order.insert(at, count - 1);
        order
    };
    orders(count - 1).iter().flat_map(|order| (0..count).map(move |at| with(order, at))).collect()
}

/// Expects these velocities after `seconds`, in every order of rows, mirrored, turned by a quarter, and shifted.
fn hold(bodies: &[BodyDef], expected: &[DVec2], seconds: f64) {
    let turns: [fn(DVec2) -> DVec2; 4] = [|v| v, |v| DVec2::new(-v.x, v.y), |v| DVec2::new(v.y, v.x), |v| DVec2::new(v.y, -v.x)];
    for (turn, of) in turns.into_iter().enumerate() {
        for shift in [DVec2::ZERO, DVec2::new(0.1, 0.3), DVec2::new(-7.77, 12.34), DVec2::new(1234.567, -876.54)] {
            for order in orders(bodies.len()) {
                let turned = |body: &BodyDef| BodyDef {
                    position: of(body.position) + shift,
                    velocity: of(body.velocity),
                    half: of(body.half).abs(),
                    ..body.clone()
                };
                let mut world = World::new(free(order.iter().map(|i| turned(&bodies[*i])).collect())).unwrap();
                world.steps((seconds / TICK) as u32, TICK);
                for (row, i) in order.iter().enumerate() {
                    let found = world.speed(row);
                    let apart = found.distance(of(expected[*i]));
                    assert!(apart < 1e-9, "turn {turn}, shift {shift}, order {order:?}: body {i} has {found} m/s");
                }
            }
        }
    }
}

#[test]
fn two_that_hit_a_third_from_both_sides_leave_it_in_the_middle() {
    let at = |x: f64, mass: f64, speed: f64| boxed(DVec2::new(x, 0.0), DVec2::splat(0.5), mass, DVec2::new(speed, 0.0), 0.5);
    let speeds = |of: [f64; 3]| of.map(|speed| DVec2::new(speed, 0.0));
    hold(&[at(-1.7, 1.0, 6.0), at(0.0, 2.0, 0.0), at(1.7, 1.0, -6.0)], &speeds([-3.0, 0.0, 3.0]), 0.2);
    // Of other masses too: the middle one stands, and so do both others after the loss of half their speed.
    hold(&[at(-1.7, 3.0, 2.0), at(0.0, 0.5, 0.0), at(1.7, 3.0, -2.0)], &speeds([-1.0, 0.0, 1.0]), 0.5);
}

/// The largest restitution, that of one body, decides about its pair alone.
#[test]
fn pairs_of_other_restitution_leave_each_with_their_own() {
    let at = |x: f64, speed: f64, e: f64| boxed(DVec2::new(x, 0.0), DVec2::splat(0.5), 1.0, DVec2::new(speed, 0.0), e);
    // Approach speeds of 6 m/s become 0.5·6 and 0.2·6; the momentum is 0.
    let (left, right) = (3.0, 1.2);
    let middle = (left - right) / 3.0;
    let expected = [middle - left, middle, middle + right].map(|speed| DVec2::new(speed, 0.0));
    hold(&[at(-1.7, 6.0, 0.5), at(0.0, 0.0, 0.0), at(1.7, -6.0, 0.2)], &expected, 0.2);
}

#[test]
fn one_that_hits_two_at_once_gives_both_its_speed() {
    let small = |y: f64| boxed(DVec2::new(2.3, y), DVec2::new(0.5, 0.45), 5.0, DVec2::ZERO, 1.0);
    let large = boxed(DVec2::ZERO, DVec2::new(0.5, 1.0), 10.0, DVec2::new(6.0, 0.0), 1.0);
    let fast = DVec2::new(6.0, 0.0);
    hold(&[large, small(-0.5), small(0.5)], &[DVec2::ZERO, fast, fast], 0.5);
}

/// The cradle is no tie: bodies that touch and rest do not approach.
#[test]
fn a_cradle_hit_from_both_sides_sends_both_back() {
    let at = |x: f64, speed: f64| boxed(DVec2::new(x, 0.0), DVec2::splat(0.5), 1.0, DVec2::new(speed, 0.0), 1.0);
    let row = [at(-2.7, 4.0), at(-1.0, 0.0), at(0.0, 0.0), at(1.0, 0.0), at(2.7, -4.0)];
    hold(&row, &[-4.0, 0.0, 0.0, 0.0, 4.0].map(|speed| DVec2::new(speed, 0.0)), 0.5);
}

/// Two rows of boxes fall in air, the upper ones over the gaps of the lower ones, and bounce: what meets at one instant does so in any order of rows.
#[test]
fn a_mirrored_pile_that_bounces_in_air_stays_mirrored() {
    let at = |x: f64, y: f64, mass: f64| boxed(DVec2::new(x, y), DVec2::splat(0.5), mass, DVec2::ZERO, 0.95);
    let pile = [at(0.0, -0.9, 7.5), at(1.1, -0.9, 9.7), at(-1.1, -0.9, 9.7), at(0.55, -2.0, 5.6), at(-0.55, -2.0, 5.6)];
    for order in orders(pile.len()) {
        let row = |body: usize| order.iter().position(|of| *of == body).unwrap();
        let bodies = order.iter().map(|i| pile[*i].clone()).collect();
        let mut world = World::new(WorldDef { bodies, surfaces: vec![block(-9.0, 0.0, 9.0, 1.0)], ..WorldDef::default() }).unwrap();
        for tick in 0..200 {
            world.step(TICK);
            for (right, left) in [(1, 2), (3, 4), (0, 0)] {
                let ([a, b], [v, w]) =
                    ([right, left].map(|body| world.at(row(body))), [right, left].map(|body| world.speed(row(body))));
                let apart = (a - b * DVec2::new(-1.0, 1.0)).length().max((v - w * DVec2::new(-1.0, 1.0)).length());
                assert!(apart < 1e-9, "{order:?}, tick {tick}: {right} and {left} are {apart} apart");
            }
        }
    }
}

#[test]
fn a_corner_is_the_same_in_either_order_of_its_walls() {
    let walls = [block(-5.0, 3.0, 5.0, 4.0), block(3.0, -5.0, 4.0, 3.0)];
    let after = |surfaces: Vec<SurfaceDef>, mirror: f64| {
        let surfaces = surfaces.into_iter().map(|surface| {
            let (min, max) = (surface.bounds.min, surface.bounds.max);
            let (left, right) = if mirror < 0.0 { (-max.x, -min.x) } else { (min.x, max.x) };
            block(left, min.y, right, max.y)
        });
        let body = boxed(DVec2::ZERO, DVec2::splat(0.5), 2.0, DVec2::new(5.0 * mirror, 5.0), 0.6);
        let mut world = World::new(WorldDef { surfaces: surfaces.collect(), ..free(vec![body]) }).unwrap();
        world.steps(90, TICK);
        let velocity = world.speed(0);
        DVec2::new(velocity.x * mirror, velocity.y)
    };
    let [floor, wall] = walls;
    let first = after(vec![floor.clone(), wall.clone()], 1.0);
    for found in [
        after(vec![wall.clone(), floor.clone()], 1.0),
        after(vec![floor.clone(), wall.clone()], -1.0),
        after(vec![wall, floor], -1.0),
    ] {
        assert!(found.distance(first) < 1e-12, "{found}, not {first}");
    }
}

/// None of the impulses pulls, and their sum is that of a bounce on one block.
#[test]
fn what_bounces_on_several_tiles_hits_each_equally() {
    for count in [2, 3, 5] {
        for e in [0.5, 1.0] {
            let width = 2.0 / f64::from(count);
            let tile = |i: i32| block(-1.0 + width * f64::from(i), 0.0, -1.0 + width * f64::from(i + 1), 1.0);
            let body = boxed(DVec2::new(0.0, -2.5), DVec2::new(1.0, 0.5), 3.0, DVec2::ZERO, e);
            let surfaces = (0..count).map(tile).collect();
            let def = WorldDef { air_density: 0.0, surfaces, bodies: vec![body], ..WorldDef::default() };
            let mut world = World::new(def).unwrap();
            while world.impulses().is_empty() {
                world.step(TICK);
            }
            let whole = 3.0 * (1.0 + e) * (2.0 * G * 2.0_f64).sqrt();
            assert_eq!(world.impulses().len(), count as usize);
            for impulse in world.impulses() {
                assert!(matches!(impulse.b, Obstacle::Surface(_)) && impulse.vector.x == 0.0);
                assert!((impulse.vector.y + whole / f64::from(count)).abs() < 1e-9, "{count} tiles: {impulse:?}");
            }
        }
    }
}

#[test]
fn what_stands_on_several_things_loads_each_equally() {
    for dense in [false, true] {
        for count in [2, 3, 4] {
            let (width, mass) = (4.0 / f64::from(count), 12.0);
            let material = |i: i32| if i == 0 { Material::ICE } else { Material::ASPHALT };
            let tile = |i: i32| {
                let bounds = block(width * f64::from(i), 0.0, width * f64::from(i + 1), 1.0).bounds;
                SurfaceDef::fixed(bounds, material(i))
            };
            let body = boxed(DVec2::new(2.0, -0.5), DVec2::new(2.0, 0.5), mass, DVec2::ZERO, 0.0);
            let surfaces = (0..count).map(tile).collect();
            let def = WorldDef { air_density: 0.0, surfaces, bodies: vec![body], ..WorldDef::default() };
            let mut world = World::with_plan(def.clone(), Plan { dense, ..Plan::of(&def) }).unwrap();
            world.steps(20, TICK);
            let share = mass * G / f64::from(count);
            let forces = world.forces(BodyId(0));
            let loads: Vec<f64> = forces
                .forces()
                .iter()
                .filter(|force| force.kind == ForceKind::Reaction && matches!(force.source, Source::Surface(_)))
                .map(|force| -force.vector.y)
                .collect();
            assert_eq!(loads.len(), count as usize, "dense {dense}: {loads:?}");
            assert!(loads.iter().all(|load| (load - share).abs() < 1e-9 * share), "dense {dense}: {loads:?}, not {share}");
        }
    }
}
