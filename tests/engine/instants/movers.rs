//! Scenes on movers: at constant velocity they are the scene at rest (Galilei), on surfaces that accelerate the scene in a field (equivalence).

use super::*;
use crate::support::G;

/// With a velocity for ever, m/s.
fn moving(surface: &SurfaceDef, velocity: DVec2) -> SurfaceDef {
    SurfaceDef { path: Path::steady(velocity), ..surface.clone() }
}

/// From rest with an acceleration for ever, m/s².
fn accelerating(surface: &SurfaceDef, acceleration: DVec2) -> SurfaceDef {
    let leg = Leg { duration: 1e3, velocity: DVec2::ZERO, acceleration };
    SurfaceDef { path: Path { legs: vec![leg], repeats: false }, ..surface.clone() }
}

/// A floor 40 m wide, its top at y = 0, and piles of up to four crates on it, which drift at up to `fastest`, m/s.
fn piles(random: &mut Random, fastest: f64) -> (SurfaceDef, Vec<BodyDef>) {
    let floor = SurfaceDef::fixed(area(-20.0, 0.0, 20.0, 1.0), random.pick(&Material::FIRM));
    let mut bodies = Vec::new();
    for pile in 0..4 {
        let (mut top, drift) = (0.0, random.between(-fastest, fastest));
        for _ in 0..=random.below(4) {
            let half = v(random.between(0.3, 0.6), random.between(0.2, 0.5));
            let position = v(-9.0 + 6.0 * f64::from(pile) + random.between(-0.1, 0.1), top - half.y);
            top -= 2.0 * half.y;
            let (mass, material) = (random.decades(-1.0, 2.0), random.pick(&Material::FIRM));
            bodies.push(BodyDef { position, half, mass, material, velocity: v(drift, 0.0), ..BodyDef::default() });
        }
    }
    (floor, bodies)
}

/// The greatest distance of the bodies of two worlds after each tick, where the second one is seen `by` so far beside, m.
fn apart(defs: [WorldDef; 2], ticks: u32, hz: f64, by: impl Fn(f64) -> DVec2) -> f64 {
    let [mut one, mut other] = defs.map(|def| World::new(def).unwrap());
    let mut worst = 0.0_f64;
    for tick in 1..=ticks {
        one.step(1.0 / hz);
        other.step(1.0 / hz);
        let way = by(f64::from(tick) / hz);
        let off = |i: usize| one.at(i).distance(other.at(i) - way);
        worst = (0..one.bodies().len()).map(off).fold(worst, f64::max);
    }
    worst
}

#[test]
fn what_slips_on_a_mover_follows_it_by_kinetic_friction() {
    for hz in [30.0, 60.0, 120.0, 240.0] {
        for stacked in [1, 2, 3] {
            let floor = SurfaceDef::fixed(area(-5.0, 0.0, 5.0, 1.0), Material::ICE);
            let of = |i: i32| BodyDef { position: v(0.0, -0.5 - f64::from(i)), mass: 2.0, ..BodyDef::default() };
            let def = without_air(vec![accelerating(&floor, v(7.0, 0.0))], (0..stacked).map(of).collect());
            let mut world = World::new(def).unwrap();
            for tick in 1..=(0.5 * hz) as u32 {
                world.step(1.0 / hz);
                let exact = Material::ICE.kinetic_friction * G * f64::from(tick) / hz;
                for i in 0..stacked as usize {
                    assert!((world.speed(i).x - exact).abs() < 1e-12, "{hz} Hz, {i} of {stacked}: {}", world.speed(i));
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn a_scene_at_constant_velocity_is_the_scene_at_rest(seed in any::<u64>(), hz in prop::sample::select(vec![30.0, 60.0, 120.0, 240.0])) {
        let random = &mut Random(seed);
        let (floor, bodies) = piles(random, 2.0);
        let velocity = v(random.between(-6.0, 6.0), random.between(-6.0, 6.0));
        let carried = bodies.iter().map(|body| BodyDef { velocity: body.velocity + velocity, ..body.clone() }).collect();
        let defs = [without_air(vec![floor.clone()], bodies), without_air(vec![moving(&floor, velocity)], carried)];
        let off = apart(defs, (2.0 * hz) as u32, hz, |t| velocity * t);
        prop_assert!(off <= 1e-9, "{} m at {} m/s", off, velocity);
    }

    #[test]
    fn a_surface_that_accelerates_is_a_field(seed in any::<u64>(), hz in prop::sample::select(vec![30.0, 60.0, 120.0, 240.0])) {
        let random = &mut Random(seed);
        let (floor, bodies) = piles(random, 0.0);
        let pull = v(random.between(-8.0, 8.0), random.between(-10.0, 5.0));
        let field = FieldDef { zone: area(-100.0, -100.0, 100.0, 100.0), strength: -pull };
        let at_rest = WorldDef { fields: vec![field], ..without_air(vec![floor.clone()], bodies.clone()) };
        let defs = [at_rest, without_air(vec![accelerating(&floor, pull)], bodies)];
        let off = apart(defs, hz as u32, hz, |t| pull * (0.5 * t * t));
        prop_assert!(off <= 1e-9, "{} m at {} m/s²", off, pull);
    }
}
