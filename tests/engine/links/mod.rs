//! Links: forces between two bodies, or a body and a place, against the formulas of springs.

mod hung;

use crate::support::{Ask, bits, block, crate_at, energy as measured, run};
use resultant::physics::{BodyDef, BodyId, DVec2, Event, ForceKind, LinkDef, LinkEnd, LinkLaw, Magnet, Material};
use resultant::physics::{Source, Spring, SurfaceDef, World, WorldDef};

const A: BodyId = BodyId(0);
const B: BodyId = BodyId(1);
const DT: f64 = 1.0 / 120.0;

fn spring(length: f64, stiffness: f64) -> LinkLaw {
    damped_spring(length, stiffness, 0.0)
}

fn damped_spring(length: f64, stiffness: f64, damping: f64) -> LinkLaw {
    LinkLaw::Spring(Spring { length, stiffness, damping })
}

fn body(x: f64, y: f64, mass: f64) -> BodyDef {
    sized(x, y, mass, 0.1, 0.1)
}

fn sized(x: f64, y: f64, mass: f64, half_width: f64, half_height: f64) -> BodyDef {
    BodyDef { half: DVec2::new(half_width, half_height), ..crate_at(x, y, mass) }
}

fn tied(world: &mut World, law: LinkLaw) {
    world.link(LinkDef::new(A, LinkEnd::Body(B), law)).unwrap();
}

fn world(gravity: f64, bodies: Vec<BodyDef>, surfaces: Vec<SurfaceDef>) -> World {
    World::new(WorldDef { gravity, air_density: 0.0, bodies, surfaces, ..WorldDef::default() }).unwrap()
}

fn floor() -> SurfaceDef {
    block(-50.0, 0.0, 50.0, 1.0)
}

/// Kinetic energy with that of one spring, J.
fn energy(world: &World, length: f64, stiffness: f64) -> f64 {
    let stretch = world.at(0).distance(world.at(1)) - length;
    measured(world, 0.0, 0.0) + 0.5 * stiffness * stretch * stretch
}

/// ω = √(k(1/m₁ + 1/m₂)): d = L + (d₀ − L)·cos ωt, about a centre of mass that moves on evenly.
#[test]
fn two_bodies_on_a_spring_swing_as_the_formula_says() {
    for (m1, m2, k) in [(1.0, 1.0, 100.0), (2.0, 0.5, 40.0), (10.0, 1.0, 3000.0)] {
        let drift = DVec2::new(0.3, -0.2);
        let still = |body: BodyDef| BodyDef { velocity: drift, ..body };
        let mut world = world(0.0, vec![still(body(0.0, 0.0, m1)), still(body(3.0, 0.0, m2))], Vec::new());
        tied(&mut world, spring(2.5, k));
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
fn one_end_may_rest_on_the_floor() {
    let (k, length, g) = (200.0, 1.0, 10.0);
    let mut world = world(g, vec![body(0.0, -0.1, 20.0), body(0.0, -1.5, 2.0)], vec![floor()]);
    world.steps(10, DT);
    let (begun, start) = world.state(1);
    tied(&mut world, spring(length, k));
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
        let [on_lower, on_upper] = [&lower, &upper].map(|forces| forces.get(Source::Link(0), ForceKind::Spring));
        assert_eq!(on_lower.map(|force| -force), on_upper);
        assert_eq!(lower.resultant(), DVec2::ZERO, "after {t} s");
        let borne = lower.total(ForceKind::Reaction).y;
        assert!((borne + 200.0 - pull).abs() < 1e-9, "the floor bears {borne} N, not {}", pull - 200.0);
    }
}

#[test]
fn a_spring_pulls_two_crates_together() {
    let mut world = world(10.0, vec![body(0.0, -0.1, 2.0), body(3.0, -0.1, 5.0)], vec![floor()]);
    tied(&mut world, spring(0.0, 60.0));
    run(&mut world, 10.0, DT);
    let gap = world.at(1).x - world.at(0).x - 0.2;
    assert!(gap.abs() < 1e-9, "{gap} m");
    assert_eq!((world.forces(A).resultant(), world.forces(B).resultant()), (DVec2::ZERO, DVec2::ZERO));
}

#[test]
fn ends_far_apart_pull_and_others_do_not_notice() {
    let bodies =
        || vec![body(0.0, 0.0, 1.0), body(400.0, 0.0, 1.0), BodyDef { velocity: (1.0, 3.0).into(), ..body(200.0, 5.0, 1.0) }];
    let (mut linked, mut free) = (world(3.0, bodies(), Vec::new()), world(3.0, bodies(), Vec::new()));
    let number = linked.link(LinkDef::new(A, LinkEnd::Body(B), spring(0.0, 0.01))).unwrap();
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
        law.into_iter().for_each(|law| tied(&mut world, law));
        bits(&world)
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
        assert!(world.link(LinkDef::new(A, to, law)).is_err(), "{to:?}, {law:?}");
    }
    assert!(world.links().is_empty());
}

fn rope(length: f64, stiffness: f64, damping: f64) -> LinkLaw {
    LinkLaw::Rope(Spring { length, stiffness, damping })
}

fn hung(world: &mut World, place: DVec2, law: LinkLaw) {
    world.link(LinkDef::new(A, LinkEnd::Place(place), law)).unwrap();
}

/// x and x′ of m·x″ = −k·x − c·x′ that begins at rest at 1 m, by the closed form of each case.
fn damped(m: f64, k: f64, c: f64, t: f64) -> (f64, f64) {
    let (half, square) = (c / (2.0 * m), k / m);
    let inside = square - half * half;
    let fade = (-half * t).exp();
    if inside > 0.0 {
        let w = inside.sqrt();
        (fade * ((w * t).cos() + half / w * (w * t).sin()), -fade * square / w * (w * t).sin())
    } else if inside == 0.0 {
        (fade * (1.0 + half * t), -fade * square * t)
    } else {
        let w = (-inside).sqrt();
        // Of both roots, the slow one without cancellation.
        let (fast, slow) = (-half - w, -square / (half + w));
        let (a, b) = (fast / (fast - slow), slow / (slow - fast));
        (a * (slow * t).exp() + b * (fast * t).exp(), a * slow * (slow * t).exp() + b * fast * (fast * t).exp())
    }
}

/// Free, damped, critical and aperiodic, at all rates of ticks.
#[test]
fn an_oscillator_keeps_to_its_closed_form_for_a_minute() {
    let (m, k) = (2.0, 200.0);
    for c in [0.0, 0.02, 4.0, 40.0, 400.0] {
        for hz in [30.0, 60.0, 120.0, 480.0] {
            let mut world = world(0.0, vec![body(6.0, 0.0, m)], Vec::new());
            hung(&mut world, DVec2::ZERO, damped_spring(5.0, k, c));
            for tick in 1..=(60.0 * hz) as u32 {
                world.step(1.0 / hz);
                let (x, v) = damped(m, k, c, f64::from(tick) / hz);
                let off = (world.at(0).x - 5.0 - x).abs().max((world.speed(0).x - v).abs() / (k / m).sqrt());
                assert!(off < 1e-9, "c = {c}, {hz} Hz: off by {off} m after {} s", f64::from(tick) / hz);
            }
        }
    }
}

/// x = m·g/k, and rest to the bit; asleep from then on.
#[test]
fn what_hangs_comes_to_rest_exactly() {
    for (law, k) in [(damped_spring(1.0, 50.0, 20.0), 50.0), (rope(1.0, 5000.0, 300.0), 5000.0), (rope(1.0, 8e6, 4000.0), 8e6)] {
        let (m, g) = (2.0, 10.0);
        let mut world = world(g, vec![body(1.0, 1.5, m)], Vec::new());
        hung(&mut world, DVec2::new(1.0, 0.0), law);
        world.steps(6000, DT);
        let below = world.at(0).y - 1.0 - m * g / k;
        assert!(below.abs() < 1e-11, "{k} N/m: {below} m beside its balance");
        assert_eq!((world.speed(0), world.bodies()[0].acceleration), (DVec2::ZERO, DVec2::ZERO), "{k} N/m");
        let forces = world.forces(A);
        assert_eq!(forces.resultant(), DVec2::ZERO);
        assert!((forces.total(law.kind()).y / (-m * g) - 1.0).abs() < 1e-6);
        let at = world.at(0);
        world.steps(100, DT);
        assert_eq!((world.at(0), world.methods().asleep), (at, 1));
        world.drive(0, 1.0, 0.0);
        world.step(DT);
        assert!(world.speed(0).x > 0.0, "a force wakes it");
    }
}

/// F = s/ℓ²: two bodies on an ellipse keep energy, angular momentum and Kepler's third law.
#[test]
fn a_magnet_leads_a_body_round_an_ellipse() {
    let (m, s) = (3.0, 120.0);
    let (near, far): (f64, f64) = (2.0, 6.0);
    let a = 0.5 * (near + far);
    let fastest = (s / m * (2.0 / near - 1.0 / a)).sqrt();
    let moving = BodyDef { velocity: DVec2::new(0.0, fastest), ..body(near, 0.0, m) };
    let mut world = world(0.0, vec![moving], Vec::new());
    hung(&mut world, DVec2::ZERO, LinkLaw::Magnet(Magnet { strength: s, nearest: 0.0 }));
    let period = std::f64::consts::TAU * (a * a * a * m / s).sqrt();
    world.steps(1200, 5.0 * period / 1200.0);
    assert!(world.at(0).distance(DVec2::new(near, 0.0)) < 1e-8, "{}", world.at(0));
    assert!((world.forces(A).total(ForceKind::Magnetic).x + s / (near * near)).abs() < 1e-6);
    // One that pushes, and a body at its very centre: no force, nothing that is no number.
    let mut world = self::world(0.0, vec![body(0.0, 0.0, 1.0), body(0.3, 0.0, 1.0)], Vec::new());
    world.link(LinkDef::new(A, LinkEnd::Place(DVec2::ZERO), LinkLaw::Magnet(Magnet { strength: -3.0, nearest: 0.0 }))).unwrap();
    tied(&mut world, LinkLaw::Magnet(Magnet { strength: -3.0, nearest: 0.0 }));
    world.steps(240, DT);
    let momentum = world.speed(0).x + world.speed(1).x;
    assert!(world.speed(0).is_finite() && world.speed(1).x > 1.0, "{} {momentum}", world.speed(1));
}

#[test]
fn a_link_breaks_at_its_force_within_the_tick() {
    // A drive that grows by the stretch: k·x = 100 N at x = 1 m, from rest under 60 N: x = (60/k)(1 − cos ωt).
    let (m, k) = (4.0, 100.0);
    let mut world = world(0.0, vec![body(2.0, 0.0, m)], Vec::new());
    world.link(LinkDef { breaks: Some(100.0), ..LinkDef::new(A, LinkEnd::Place(DVec2::ZERO), spring(2.0, k)) }).unwrap();
    world.drive(0, 60.0, 0.0);
    let omega = (k / m).sqrt();
    let (at, snapped) = ((1.0f64 - 100.0 / 60.0).acos() / omega, 60.0 / k * omega);
    let speed = snapped * (omega * at).sin();
    let mut broken = 0;
    for tick in 1..=120 {
        world.step(DT);
        broken += world.events().iter().filter(|event| **event == Event::Snapped { link: 0 }).count();
        let late = f64::from(tick) * DT - at;
        assert_eq!(broken, usize::from(late > 0.0));
        if late > 0.0 {
            let exact = 3.0 + speed * late + 0.5 * 60.0 / m * late * late;
            assert!((world.at(0).x - exact).abs() < 1e-9, "{}, not {exact}", world.at(0).x);
        }
    }
    assert!(world.links()[0].is_broken() && world.forces(A).total(ForceKind::Spring) == DVec2::ZERO);
}

/// Momentum of a chain of 70 bodies in free flight, more than the method of events takes.
#[test]
fn a_long_chain_keeps_its_momentum() {
    let bodies = (0..70)
        .map(|i| BodyDef { velocity: DVec2::new(0.0, f64::from(i % 7) - 3.0), ..body(f64::from(i), 0.0, 1.0 + f64::from(i % 3)) });
    let mut world = world(0.0, bodies.collect(), Vec::new());
    for i in 0..69 {
        let link = LinkDef::new(BodyId(i), LinkEnd::Body(BodyId(i + 1)), spring(0.9, 300.0));
        world.link(LinkDef { law: if i % 2 == 0 { link.law } else { rope(1.1, 900.0, 2.0) }, ..link }).unwrap();
    }
    let momentum = |world: &World| world.bodies().iter().map(|body| body.velocity * body.mass).sum::<DVec2>();
    let begun = momentum(&world);
    world.steps(60, DT);
    assert!(momentum(&world).distance(begun) < 1e-9, "{}", momentum(&world) - begun);
    assert_eq!(world.methods().in_one_step, 0);
}

/// Two on a spring; ship, rope and load in air: against steps of a 400th of the tick.
#[test]
fn any_tick_leads_to_the_same_place() {
    let pair = vec![BodyDef { velocity: DVec2::new(1.0, 2.0), ..body(0.0, 0.0, 1.5) }, body(2.0, 0.5, 0.7)];
    let tow = vec![sized(0.0, 0.0, 100.0, 0.85, 0.85), sized(3.0, 2.0, 40.0, 0.4, 0.4)];
    for (air_density, bodies, law, drive) in
        [(0.0, pair, spring(1.8, 30.0), DVec2::ZERO), (1.2041, tow, rope(4.0, 6000.0, 50.0), DVec2::new(300.0, -1700.0))]
    {
        let def = WorldDef { gravity: 10.0, air_density, bodies, ..WorldDef::default() };
        let end = |hz: f64| {
            let mut world = World::new(def.clone()).unwrap();
            tied(&mut world, law);
            world.set_drive(A, drive);
            world.steps((6.0 * hz) as u32, 1.0 / hz);
            world.at(1)
        };
        let fine = end(12_000.0);
        for hz in [30.0, 60.0, 120.0, 480.0] {
            assert!(end(hz).distance(fine) < 1e-8, "{law:?} at {hz} Hz: {}", end(hz) - fine);
        }
    }
}
