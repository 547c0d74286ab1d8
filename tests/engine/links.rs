//! Links: forces between two bodies, or a body and a place, against the formulas of springs.

use crate::support::{Ask, block};
use resultant::physics::{
    BodyDef, BodyId, DVec2, ForceKind, LinkDef, LinkEnd, LinkLaw, Source, Spring, SurfaceDef, World, WorldDef,
};

const A: BodyId = BodyId(0);
const B: BodyId = BodyId(1);
const DT: f64 = 1.0 / 120.0;

fn spring(length: f64, stiffness: f64) -> LinkLaw {
    LinkLaw::Spring(Spring { length, stiffness, damping: 0.0 })
}

fn body(x: f64, y: f64, mass: f64) -> BodyDef {
    BodyDef { position: DVec2::new(x, y), mass, half: DVec2::splat(0.1), ..BodyDef::default() }
}

fn world(gravity: f64, bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>) -> World {
    World::new(WorldDef { gravity, air_density: 0.0, bodies, surfaces, ..WorldDef::default() }).unwrap()
}

fn floor() -> SurfaceDef {
    block(-50.0, 0.0, 50.0, 1.0)
}

/// Kinetic energy and that of one spring, J.
fn energy(world: &World, length: f64, stiffness: f64) -> f64 {
    let kinetic: f64 = world.bodies().iter().map(|body| 0.5 * body.mass * body.velocity.length_squared()).sum();
    let stretch = world.at(0).distance(world.at(1)) - length;
    kinetic + 0.5 * stiffness * stretch * stretch
}

/// ω = √(k(1/m₁ + 1/m₂)): d = L + (d₀ − L)·cos ωt, about a centre of mass that moves on evenly.
#[test]
fn two_bodies_on_a_spring_swing_as_the_formula_says() {
    for (m1, m2, k) in [(1.0, 1.0, 100.0), (2.0, 0.5, 40.0), (10.0, 1.0, 3000.0)] {
        let drift = DVec2::new(0.3, -0.2);
        let still = |body: BodyDef| BodyDef { velocity: drift, ..body };
        let mut world = world(0.0, vec![still(body(0.0, 0.0, m1)), still(body(3.0, 0.0, m2))], Vec::new());
        world.link(LinkDef { body: A, to: LinkEnd::Body(B), law: spring(2.5, k) }).unwrap();
        let omega = (k * (1.0 / m1 + 1.0 / m2)).sqrt();
        let (begun, centre) = (energy(&world, 2.5, k), 3.0 * m2 / (m1 + m2));
        for tick in 1..=2400 {
            world.step(DT);
            let t = f64::from(tick) * DT;
            let apart = world.at(1) - world.at(0);
            let exact = 2.5 + 0.5 * (omega * t).cos();
            assert!((apart.x - exact).abs() < 1e-9 && apart.y.abs() < 1e-9, "{m1}, {m2} kg after {t} s: {apart}, not {exact}");
            let at = (world.at(0) * m1 + world.at(1) * m2) / (m1 + m2);
            assert!((at - drift * t - DVec2::new(centre, 0.0)).length() < 1e-9, "the centre of mass is at {at}");
            let momentum = world.speed(0) * m1 + world.speed(1) * m2 - drift * (m1 + m2);
            assert!(momentum.length() < 1e-10, "{momentum} kg·m/s");
            assert!((energy(&world, 2.5, k) / begun - 1.0).abs() < 1e-9, "after {t} s");
        }
    }
}

#[test]
fn a_turning_pair_keeps_energy_and_angular_momentum() {
    let moving = BodyDef { velocity: DVec2::new(0.0, 2.0), ..body(0.0, 0.0, 1.5) };
    let mut world = world(0.0, vec![moving, body(2.0, 0.0, 0.7)], Vec::new());
    world.link(LinkDef { body: A, to: LinkEnd::Body(B), law: spring(1.2, 30.0) }).unwrap();
    let turning =
        |world: &World| -> f64 { world.bodies().iter().map(|body| body.mass * body.position.perp_dot(body.velocity)).sum() };
    let (begun, turned) = (energy(&world, 1.2, 30.0), turning(&world));
    for tick in 0..2400 {
        world.step(DT);
        assert!((energy(&world, 1.2, 30.0) / begun - 1.0).abs() < 1e-9, "tick {tick}");
        assert!((turning(&world) - turned).abs() < 1e-9, "tick {tick}: {}", turning(&world) - turned);
    }
}

/// x = g/ω²·(1 − cos ωt).
#[test]
fn a_body_hangs_on_a_place() {
    let (mass, k, g) = (2.0, 50.0, 10.0);
    let mut world = world(g, vec![body(1.0, 2.0, mass)], Vec::new());
    world.link(LinkDef { body: A, to: LinkEnd::Place(DVec2::new(1.0, 1.0)), law: spring(1.0, k) }).unwrap();
    let omega = (k / mass).sqrt();
    for tick in 1..=1200 {
        world.step(DT);
        let t = f64::from(tick) * DT;
        let exact = 2.0 + g / (omega * omega) * (1.0 - (omega * t).cos());
        let at = world.at(0);
        assert!((at - DVec2::new(1.0, exact)).length() < 1e-9, "after {t} s: {at}, not {exact}");
    }
}

#[test]
fn any_tick_leads_to_the_same_place() {
    let end = |hz: f64| {
        let moving = BodyDef { velocity: DVec2::new(1.0, 2.0), ..body(0.0, 0.0, 1.5) };
        let mut world = world(9.81, vec![moving, body(2.0, 0.5, 0.7)], Vec::new());
        world.link(LinkDef { body: A, to: LinkEnd::Body(B), law: spring(1.8, 30.0) }).unwrap();
        world.steps((4.0 * hz) as u32, 1.0 / hz);
        world.at(0)
    };
    let fine = end(480.0);
    for hz in [30.0, 60.0, 120.0] {
        assert!(end(hz).distance(fine) < 1e-9, "{hz} Hz: {}", end(hz) - fine);
    }
}

/// The floor bears both, and the listed forces follow the law.
#[test]
fn one_end_may_rest_on_the_floor() {
    let (k, length, g) = (200.0, 1.0, 10.0);
    let mut world = world(g, vec![body(0.0, -0.1, 20.0), body(0.0, -1.5, 2.0)], vec![floor()]);
    world.steps(10, DT);
    let (begun, start) = world.state(1);
    world.link(LinkDef { body: A, to: LinkEnd::Body(B), law: spring(length, k) }).unwrap();
    let omega = (k / 2.0f64).sqrt();
    // Up is negative: the spring is slack where the body is at −0.1 − L.
    let middle = -0.1 - length + g / (omega * omega);
    for tick in 1..=1200 {
        world.step(DT);
        let t = f64::from(tick) * DT;
        let exact = middle + (begun.y - middle) * (omega * t).cos() + start.y / omega * (omega * t).sin();
        let upper = world.at(1);
        assert!((upper.y - exact).abs() < 1e-9, "after {t} s: {upper}, not {exact}");
        assert_eq!(world.state(0), (DVec2::new(0.0, -0.1), DVec2::ZERO));
        let pull = k * ((-0.1 - upper.y) - length);
        let (lower, upper) = (world.forces(A), world.forces(B));
        assert!((upper.total(ForceKind::Spring).y - pull).abs() < 1e-9, "{} N, not {pull}", upper.total(ForceKind::Spring));
        assert_eq!(
            lower.get(Source::Link(0), ForceKind::Spring).map(|force| -force),
            upper.get(Source::Link(0), ForceKind::Spring)
        );
        assert_eq!(lower.resultant(), DVec2::ZERO, "after {t} s");
        let borne = lower.total(ForceKind::Reaction).y;
        assert!((borne + 200.0 - pull).abs() < 1e-9, "the floor bears {borne} N, not {}", pull - 200.0);
    }
}

/// The spring pulls more than friction holds.
#[test]
fn a_spring_pulls_two_crates_together() {
    let mut world = world(10.0, vec![body(0.0, -0.1, 2.0), body(3.0, -0.1, 5.0)], vec![floor()]);
    world.link(LinkDef { body: A, to: LinkEnd::Body(B), law: spring(0.0, 60.0) }).unwrap();
    for tick in 0..1200 {
        world.step(DT);
        world.validate().unwrap_or_else(|fault| panic!("tick {tick}: {fault}"));
    }
    let gap = world.at(1).x - world.at(0).x - 0.2;
    assert!(gap.abs() < 1e-9, "{gap} m");
    assert_eq!((world.forces(A).resultant(), world.forces(B).resultant()), (DVec2::ZERO, DVec2::ZERO));
}

#[test]
fn ends_far_apart_pull_and_others_do_not_notice() {
    let bodies =
        || vec![body(0.0, 0.0, 1.0), body(400.0, 0.0, 1.0), BodyDef { velocity: DVec2::new(1.0, 3.0), ..body(200.0, 5.0, 1.0) }];
    let (mut linked, mut free) = (world(3.0, bodies(), Vec::new()), world(3.0, bodies(), Vec::new()));
    let number = linked.link(LinkDef { body: A, to: LinkEnd::Body(B), law: spring(0.0, 0.01) }).unwrap();
    for _ in 0..120 {
        linked.step(DT);
        free.step(DT);
        assert_eq!(linked.bodies()[2], free.bodies()[2]);
    }
    assert!(linked.speed(0).x > 3.9 && linked.speed(1).x < -3.9);
    linked.unlink(number);
    let speed = linked.speed(0).x;
    linked.steps(120, DT);
    assert_eq!((linked.speed(0).x, linked.links().len()), (speed, 0));
    assert_eq!(linked.forces(A).total(ForceKind::Spring), DVec2::ZERO);
}

#[test]
fn links_are_hashed() {
    let hash = |law: Option<LinkLaw>| {
        let mut world = world(0.0, vec![body(0.0, 0.0, 1.0), body(3.0, 0.0, 1.0)], Vec::new());
        law.into_iter().for_each(|law| _ = world.link(LinkDef { body: A, to: LinkEnd::Body(B), law }).unwrap());
        let mut words = Vec::new();
        world.hash_state(&mut |word| words.push(word));
        words
    };
    assert_ne!(hash(None), hash(Some(spring(1.0, 2.0))));
    assert_ne!(hash(Some(spring(1.0, 3.0))), hash(Some(spring(1.0, 2.0))));
}

#[test]
fn nonsense_is_refused() {
    let mut world = world(0.0, vec![body(0.0, 0.0, 1.0), body(3.0, 0.0, 1.0)], Vec::new());
    for (to, law) in [
        (LinkEnd::Body(A), spring(1.0, 1.0)),
        (LinkEnd::Body(BodyId(2)), spring(1.0, 1.0)),
        (LinkEnd::Place(DVec2::new(f64::NAN, 0.0)), spring(1.0, 1.0)),
        (LinkEnd::Body(B), spring(-1.0, 1.0)),
        (LinkEnd::Body(B), spring(1.0, f64::INFINITY)),
        (LinkEnd::Body(B), spring(1.0, 2e8)),
    ] {
        assert!(world.link(LinkDef { body: A, to, law }).is_err(), "{to:?}, {law:?}");
    }
    assert!(world.links().is_empty());
}
