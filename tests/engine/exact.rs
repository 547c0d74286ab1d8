//! The engine against exact answers, at the game's tick.

use crate::support::motion::rk4;
use crate::support::scenes::{column, dart_and_target, slide_in_air, thrown};
use crate::support::{Ask, G, Random, TICK, assert_all_at_rest, from_below, world};
use resultant::physics::{BodyDef, BodyId, DVec2, Guards, World, WorldDef};

fn run(world: &mut World, seconds: f64, tick: f64) {
    (0..(seconds / tick).round() as usize).for_each(|_| world.step(tick));
    let given_up = Guards { dense_ticks: 0, islands_grown: 0, ..*world.guards() };
    assert_eq!(given_up, Guards::default(), "nothing has to be given up");
}

#[test]
fn parabolas_are_exact_at_any_tick() {
    for hz in [30.0, 60.0, 120.0, 240.0] {
        let mut world = world(thrown());
        run(&mut world, 4.0, 1.0 / hz);
        let exact = DVec2::new(28.0, -80.0 + 0.5 * G * 16.0);
        assert!((world.at(0) - exact).length() < 1e-9);
    }
}

/// Against RK4 at 1e-5 s.
#[test]
fn a_projectile_with_drag_agrees_with_a_fine_integration() {
    let (mass, drag, seconds) = (2.0, 1.1, 3.0);
    for (half, v0) in [((0.4, 0.7), (20.0, -20.0)), ((0.1, 1.5), (20.0, -13.0)), ((0.5, 0.5), (-3.0, -19.0))] {
        for round in [false, true] {
            let (half, v0) = (DVec2::from(half), DVec2::from(v0));
            let acceleration = |v: DVec2| {
                let shown = 2.0 * (half.x * v.y.abs() + half.y * v.x.abs());
                let shown = if round { (half.x + half.y) * v.length() } else { shown };
                DVec2::new(0.0, G) - v * (0.5 * 1.2041 * drag * shown / mass)
            };
            let (x, _) = rk4((DVec2::ZERO, v0), 300_000, 1e-5, |_, v| acceleration(v));
            for hz in [15.0, 30.0, 60.0, 120.0] {
                let body = BodyDef { velocity: v0, half, mass, drag, round, ..BodyDef::default() };
                let mut world = World::new(WorldDef { bodies: vec![body], ..WorldDef::default() }).unwrap();
                run(&mut world, seconds, 1.0 / hz);
                let error = world.at(0).distance(x);
                assert!(error < 1e-8, "{half}, {v0}, round {round}, {hz} Hz: {error} m");
            }
        }
    }
}

/// With drag: v′ = −a − k·v², distance ln(1 + k·v₀²/a)/2k.
#[test]
fn a_slide_in_air_ends_where_it_must() {
    let k = 0.5 * 1.2041 / 5.0;
    let mut world = world(slide_in_air());
    run(&mut world, 6.0, TICK);
    let exact = (1.0 + k * 900.0 / (0.65 * G)).ln() / (2.0 * k);
    let found = world.at(0).x;
    assert!((found - exact).abs() < 1e-6, "{found} {exact}");
    assert_eq!(world.speed(0), DVec2::ZERO);
}

/// Equal elastic boxes in a row exchange their velocities: less their widths they are points that pass through each other.
#[test]
fn a_row_of_equal_elastic_boxes_passes_through_itself() {
    const WIDTH: f64 = 0.5;
    for count in [12, 24] {
        let mut random = Random(count as u64);
        let starts: Vec<_> = (0..count).map(|i| (0.2 * i as f64 + 0.1 * random.unit(), random.between(-30.0, 30.0))).collect();
        let body = |(i, (x, v)): (usize, &(f64, f64))| BodyDef {
            position: DVec2::new(x + WIDTH * i as f64, 0.0),
            velocity: DVec2::new(*v, 0.0),
            half: DVec2::splat(0.5 * WIDTH),
            restitution: 1.0,
            ..BodyDef::default()
        };
        let bodies = starts.iter().enumerate().map(body).collect();
        let mut world = world(WorldDef { bodies, gravity: 0.0, air_density: 0.0, ..WorldDef::default() });
        let (mut in_one_step, mut farthest) = (0, 0.0f64);
        for tick in 1..=120 {
            world.step(TICK);
            in_one_step += world.methods().in_one_step;
            let time = f64::from(tick) * TICK;
            let mut points: Vec<(f64, f64)> = starts.iter().map(|(x, v)| (x + v * time, *v)).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (i, (x, _)) in points.iter().enumerate() {
                farthest = farthest.max((world.body(BodyId(i as u32)).position.x - (x + WIDTH * i as f64)).abs());
            }
        }
        assert!(farthest < 1e-9, "{count} boxes: {farthest} m");
        assert_eq!(in_one_step, 0, "{count} boxes");
        assert_eq!(Guards { islands_grown: 0, ..*world.guards() }, Guards::default());
    }
}

#[test]
fn columns_stand_still_and_every_reaction_is_the_weight_above() {
    for n in [10usize, 30, 100] {
        let mut world = world(column(n));
        let masses: Vec<f64> = world.bodies().iter().map(|body| body.mass).collect();
        run(&mut world, 180.0, TICK);
        assert_all_at_rest(&world);
        for i in 0..n {
            assert_eq!(world.at(i), DVec2::new(0.0, -0.5 - i as f64));
            let weight: f64 = masses[i..].iter().sum::<f64>() * G;
            assert!((from_below(&world, BodyId(i as u32)) / -weight - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn nothing_tunnels_at_any_speed() {
    for v in [10.0, 36.0, 400.0, 8_333.0, 1e6] {
        let mut world = world(dart_and_target(v));
        run(&mut world, 2.0, TICK);
        assert!((world.speed(1).x / (v / 4.0) - 1.0).abs() < 1e-12);
    }
}
