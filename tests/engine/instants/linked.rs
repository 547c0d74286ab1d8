//! Linked bodies that touch something: impact, slip and stick are events on the flow of links, whatever the tick.

use super::*;
use resultant::physics::{BodyId, LinkDef, LinkEnd, LinkLaw, Spring};

const PULL: f64 = 10.0;

fn spring(length: f64, stiffness: f64) -> LinkLaw {
    LinkLaw::Spring(Spring { length, stiffness, damping: 0.0 })
}

fn crate_on(material: Material, x: f64, mass: f64, restitution: f64) -> BodyDef {
    BodyDef { position: v(x, -0.5), half: DVec2::splat(0.5), mass, material, restitution, ..BodyDef::default() }
}

fn world(gravity: f64, material: Material, bodies: Vec<BodyDef>, links: &[LinkDef]) -> World {
    let floor = SurfaceDef::fixed(area(-300.0, 0.0, 300.0, 1.0), material);
    let mut world = World::new(WorldDef { gravity, ..without_air(vec![floor], bodies) }).unwrap();
    links.iter().for_each(|link| _ = world.link(*link).unwrap());
    world
}

#[test]
fn a_ball_that_bounces_on_a_spring_keeps_its_energy() {
    let (place, length, stiffness) = (v(0.3, -2.2), 1.0, 40.0);
    let energy = |world: &World| {
        let stretch = world.at(0).distance(place) - length;
        0.5 * world.speed(0).length_squared() - PULL * world.at(0).y + 0.5 * stiffness * stretch * stretch
    };
    for rate in RATES {
        let ball = BodyDef { position: v(0.0, -1.5), ..crate_on(rough(0.0, 0.0), 0.0, 1.0, 1.0) };
        let link = LinkDef::new(BodyId(0), LinkEnd::Place(place), spring(length, stiffness));
        let mut world = world(PULL, rough(0.0, 0.0), vec![ball], &[link]);
        let begun = energy(&world);
        world.steps((30.0 * rate) as u32, 1.0 / rate);
        let off = (energy(&world) / begun - 1.0).abs();
        assert!(off < 1e-6, "{rate} Hz: {off:e}");
    }
}

#[test]
fn linked_bodies_that_collide_keep_energy_and_momentum() {
    for (m1, m2) in [(1.0, 1.0), (1.0, 7.0), (30.0, 0.5)] {
        let body = |x: f64, mass: f64, velocity: DVec2| BodyDef {
            position: v(x, -50.0),
            velocity,
            ..crate_on(rough(0.0, 0.0), x, mass, 1.0)
        };
        let energy = |world: &World| {
            let stretch = world.at(0).distance(world.at(1)) - 0.4;
            let of = |i: usize| 0.5 * world.bodies()[i].mass * world.speed(i).length_squared();
            of(0) + of(1) + 0.5 * 60.0 * stretch * stretch
        };
        for rate in RATES {
            let bodies = vec![body(0.0, m1, v(0.1, 0.0)), body(2.5, m2, v(0.2, 0.01))];
            let link = LinkDef::new(BodyId(0), LinkEnd::Body(BodyId(1)), spring(0.4, 60.0));
            let mut world = world(0.0, Material::STEEL, bodies, &[link]);
            let begun = energy(&world);
            world.steps((30.0 * rate) as u32, 1.0 / rate);
            let off = (energy(&world) / begun - 1.0).abs();
            let momentum = world.speed(0) * m1 + world.speed(1) * m2 - v(0.1 * m1 + 0.2 * m2, 0.01 * m2);
            assert!(off < 1e-6 && momentum.length() < 1e-9, "{m1}, {m2} kg at {rate} Hz: {off:e}, {momentum}");
        }
    }
}

/// A crate on a rough floor, pulled by a spring that a winch shortens: it slips by 2A + uθ/ω, θ = 2π − 2·atan(Aω/u), where A is how much further the
/// spring is drawn when it slips than friction draws it then.
#[test]
fn stick_and_slip_are_where_the_formula_says() {
    let (mass, stiffness, speed) = (2.0, 50.0, 0.5);
    let omega = f64::sqrt(stiffness / mass);
    let [held, slid] = [0.6, 0.4].map(|friction| friction * mass * PULL / stiffness);
    let further = held - slid;
    let angle = std::f64::consts::TAU - 2.0 * (further * omega / speed).atan();
    let (way, period) = (speed * angle / omega + 2.0 * further, angle / omega + 2.0 * further / speed);
    let place = v(30.0, -0.5);
    for rate in RATES {
        let link = LinkDef::new(BodyId(0), LinkEnd::Place(place), spring(1.0, stiffness));
        let link = LinkDef { as_found: true, rate: -speed, ..link };
        let mut world = world(PULL, rough(0.6, 0.4), vec![crate_on(rough(0.6, 0.4), 0.0, mass, 0.0)], &[link]);
        let time = held / speed + 8.0 * period - further / speed;
        world.steps((time * rate).round() as u32, 1.0 / rate);
        let off = (world.at(0).x - 8.0 * way).abs();
        assert!(off < 1e-6 && world.speed(0) == DVec2::ZERO, "{rate} Hz: {off:e} m, {}", world.speed(0));
    }
}

/// Each half swing ends nearer to where the spring is loose by 2μmg/k.
#[test]
fn a_spring_that_slides_stops_where_the_formula_says() {
    let (mass, stiffness) = (2.0, 50.0);
    let nearer = 2.0 * 0.2 * mass * PULL / stiffness;
    let mut end: f64 = 2.0;
    while end.abs() > 0.3 * mass * PULL / stiffness {
        end = -(end.abs() - nearer) * end.signum();
    }
    for rate in RATES {
        let link = LinkDef::new(BodyId(0), LinkEnd::Place(v(-10.0, -0.5)), spring(10.0, stiffness));
        let mut world = world(PULL, rough(0.3, 0.2), vec![crate_on(rough(0.3, 0.2), 2.0, mass, 0.0)], &[link]);
        world.steps((15.0 * rate) as u32, 1.0 / rate);
        let off = (world.at(0).x - end).abs();
        assert!(off < 1e-7 && world.speed(0) == DVec2::ZERO, "{rate} Hz: {off:e} m, {}", world.speed(0));
    }
}

/// A body flies off on a rope until that is taut, and draws a crate along as soon as friction does not hold that.
#[test]
fn a_rope_that_becomes_taut_starts_a_crate_at_once() {
    let (heavy, light, stiffness, speed, friction) = (5.0, 2.0, 1000.0, 4.0, 0.5 * 5.0 * PULL);
    let omega = f64::sqrt(stiffness / light);
    // Taut after half a second; then the body swings alone until the rope pulls as hard as friction holds.
    let alone = f64::asin(friction / stiffness * omega / speed) / omega;
    let (mut x, mut v1) = (0.0, 0.0);
    let (mut y, mut v2) = (3.0 + friction / stiffness, speed * (omega * alone).cos());
    let seconds = 0.6;
    let h = (seconds - 0.5 - alone) * 1e-5;
    for _ in 0..100_000 {
        let pull = |x: f64, y: f64| stiffness * (y - x - 3.0);
        let rates = |x: f64, v1: f64, y: f64, v2: f64| (v1, (pull(x, y) - friction) / heavy, v2, -pull(x, y) / light);
        let a = rates(x, v1, y, v2);
        let b = rates(x + a.0 * h / 2.0, v1 + a.1 * h / 2.0, y + a.2 * h / 2.0, v2 + a.3 * h / 2.0);
        (x, v1, y, v2) = (x + b.0 * h, v1 + b.1 * h, y + b.2 * h, v2 + b.3 * h);
    }
    for rate in RATES {
        let flying = BodyDef {
            velocity: v(speed, 0.0),
            weightless: true,
            half: DVec2::splat(0.1),
            ..crate_on(Material::STEEL, 1.0, light, 0.0)
        };
        let rope = LinkLaw::Rope(Spring { length: 3.0, stiffness, damping: 0.0 });
        let link = LinkDef::new(BodyId(0), LinkEnd::Body(BodyId(1)), rope);
        let mut world = world(PULL, rough(0.5, 0.5), vec![crate_on(rough(0.5, 0.5), 0.0, heavy, 0.0), flying], &[link]);
        world.steps((seconds * rate).round() as u32, 1.0 / rate);
        let off = (world.at(0).x - x).abs().max((world.at(1).x - y).abs());
        assert!(off < 1e-6, "{rate} Hz: {off:e} m");
    }
}

#[test]
fn a_chain_of_springs_slips_alike_at_any_rate() {
    for seed in 0..4 {
        let random = &mut Random(seed);
        let rough = rough(0.36, 0.3);
        let mut bodies: Vec<_> = (0..12).map(|i| crate_on(rough, 1.5 * f64::from(i), random.decades(-0.3, 0.5), 0.0)).collect();
        bodies[0].velocity.x = -random.between(1.0, 4.0);
        let ends = |i: u32| (BodyId(i), LinkEnd::Body(BodyId(i - 1)));
        let links: Vec<_> = (1..12).map(|i| LinkDef::new(ends(i).0, ends(i).1, spring(1.5, random.decades(1.5, 2.5)))).collect();
        let [found, fine] = [30.0, 480.0].map(|rate| {
            let mut world = world(PULL, rough, bodies.clone(), &links);
            world.steps(rate as u32, 1.0 / rate);
            world
        });
        let off = (0..12).map(|i| found.at(i).distance(fine.at(i))).fold(0.0, f64::max);
        assert!(off < 1e-6, "{seed}: {off:e}");
    }
}
