//! Heaps along four pulls: a heap falls to a wall as it falls to a floor.

use super::*;
use resultant::physics::Aabb;

/// Down, up, right, left.
const TURNS: [fn(DVec2) -> DVec2; 4] = [|v| v, |v| DVec2::new(v.x, -v.y), |v| DVec2::new(v.y, v.x), |v| DVec2::new(-v.y, v.x)];
const PULL: f64 = 10.0;

/// 90 crates above the bottom of a shaft, pulled to it by a field alone.
fn heap(random: &mut Random, most_restitution: f64, turn: fn(DVec2) -> DVec2) -> WorldDef {
    let turned = |of: Aabb| {
        let (a, b) = (turn(of.min), turn(of.max));
        Aabb::new(a.min(b), a.max(b))
    };
    let body = |i: usize| {
        let cell = v(1.1 * (i % 9) as f64 - 4.4, -1.0 - 1.1 * (i / 9) as f64);
        BodyDef {
            position: turn(cell),
            velocity: turn(v(random.between(-2.0, 2.0), 0.0)),
            half: turn(v(random.between(0.15, 0.45), random.between(0.15, 0.45))).abs(),
            mass: random.between(0.5, 5.0),
            restitution: random.between(0.0, most_restitution),
            ..BodyDef::default()
        }
    };
    let bodies = (0..90).map(body).collect();
    let walls = [area(-6.0, 0.0, 6.0, 1.0), area(-6.0, -20.0, -5.0, 0.0), area(5.0, -20.0, 6.0, 0.0)];
    let surfaces = walls.map(|wall| SurfaceDef::fixed(turned(wall), Material::ASPHALT)).into();
    let field = FieldDef { zone: Aabb::around(DVec2::ZERO, DVec2::splat(99.0)), strength: turn(v(0.0, PULL)) };
    WorldDef { fields: vec![field], ..in_space(surfaces, bodies) }
}

/// ½mv² and what the field has left to give, J.
fn energy(world: &World, down: DVec2) -> f64 {
    let of = |body: &resultant::physics::Body| body.mass * (0.5 * body.velocity.length_squared() - PULL * down.dot(body.position));
    world.bodies().iter().map(of).sum()
}

#[test]
fn a_heap_rests_along_any_pull() {
    for turn in TURNS {
        let mut world = World::new(heap(&mut Random(90), 0.0, turn)).unwrap();
        world.steps(5 * 120, 1.0 / 120.0);
        let moving = world.bodies().iter().filter(|body| body.velocity != DVec2::ZERO).count();
        assert_eq!(moving, 0, "pulled along {}", turn(v(0.0, 1.0)));
    }
}

#[test]
fn a_heap_gains_no_energy_along_any_pull() {
    for turn in TURNS {
        for seed in [1, 2] {
            let down = turn(v(0.0, 1.0));
            let mut world = World::new(heap(&mut Random(seed), 0.7, turn)).unwrap();
            let begun = energy(&world, down);
            let mut before = begun;
            for tick in 0..360 {
                world.step(1.0 / 120.0);
                let now = energy(&world, down);
                let rose = now - before;
                let lost = begun - now;
                assert!(rose <= 1e-9 * lost.max(1.0), "along {down}, seed {seed}, tick {tick}: {rose} J of {lost} J");
                before = now;
            }
        }
    }
}

/// Its friction would hold a body that slid alone, and not what stands on it.
#[test]
fn a_tall_block_slides_down_a_tilt_as_one() {
    let (friction, columns, rows) = (0.56, 5, 15);
    let [rough, slippery] = [9.0, friction].map(|k| Material { static_friction: k, kinetic_friction: k, ..Material::ASPHALT });
    let body = |i: usize| BodyDef {
        position: v((i % columns) as f64, -0.5 - (i / columns) as f64),
        half: v(0.5, 0.5),
        material: rough,
        ..BodyDef::default()
    };
    for push in [0.5, 1.0, 1.3, 2.0, 3.0] {
        let surfaces = vec![SurfaceDef::fixed(area(-900.0, 0.0, 900.0, 1.0), slippery)];
        let pull = v(friction * PULL + push, PULL);
        let field = FieldDef { zone: Aabb::around(DVec2::ZERO, DVec2::splat(999.0)), strength: pull };
        let bodies: Vec<BodyDef> = (0..columns * rows).map(body).collect();
        let mut world = World::new(WorldDef { fields: vec![field], ..in_space(surfaces, bodies.clone()) }).unwrap();
        world.steps(4 * 120, 1.0 / 120.0);
        for (from, to) in bodies.iter().zip(world.bodies()) {
            let way = to.position - from.position;
            assert!(way.distance(v(0.5 * push * 16.0, 0.0)) < 1e-9, "{push} m/s²: {from:?} has gone {way}");
        }
    }
}

#[test]
fn nothing_keeps_a_velocity_into_what_stops_it() {
    // Seeds whose friction does not settle, and some others.
    for seed in [985, 1025, 1101, 2443, 2563].into_iter().chain(0..20) {
        let (random, turn) = (&mut Random(seed), TURNS[seed as usize % 4]);
        let mut heap = heap(random, 0.5 * (seed % 2) as f64, turn);
        for body in &mut heap.bodies {
            (body.half, body.mass) = (v(0.5, 0.5), random.decades(-1.5, 1.5));
            body.material = random.pick(&Material::FIRM);
        }
        let mut world = World::new(heap).unwrap();
        let mut pinned = [0; 90];
        for tick in 0..480 {
            let before: Vec<_> = world.bodies().iter().map(|body| (body.position, body.velocity)).collect();
            world.step(1.0 / 120.0);
            for ((body, (place, velocity)), pinned) in world.bodies().iter().zip(before).zip(&mut pinned) {
                let stuck =
                    |k| body.position[k] == place[k] && body.velocity[k] * velocity[k] > 0.0 && body.velocity[k].abs() > 0.05;
                *pinned = if stuck(0) || stuck(1) { *pinned + 1 } else { 0 };
                assert!(*pinned < 6, "seed {seed}, tick {tick}: {body:?} stays");
            }
        }
    }
}
