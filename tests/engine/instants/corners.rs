//! Corners that meet: neither face is hit before the other.

use super::*;
use resultant::physics::Aabb;

const RATES: [f64; 5] = [30.0, 60.0, 120.0, 240.0, 480.0];

/// How far two boxes are in each other, m.
fn depth(a: &Aabb, b: &Aabb) -> f64 {
    (a.max.min(b.max) - a.min.max(b.min)).min_element()
}

fn shot(position: DVec2, velocity: DVec2, e: f64) -> BodyDef {
    BodyDef { position, velocity, restitution: e, half: DVec2::splat(0.5), mass: 2.0, ..BodyDef::default() }
}

/// Steps until `seconds` are over, and asks after each tick how deep the first body is in the second one, or in the first surface, m.
fn deepest_of(def: WorldDef, hz: f64, seconds: f64) -> (World, f64) {
    let mut world = World::new(def).unwrap();
    let mut deepest = f64::NEG_INFINITY;
    for _ in 0..(seconds * hz).ceil() as u32 {
        world.step(1.0 / hz);
        let other = world.bodies().get(1).map_or_else(|| world.surfaces()[0].bounds, |body| body.bounds());
        deepest = deepest.max(depth(&world.bodies()[0].bounds(), &other));
    }
    (world, deepest)
}

proptest! {
    #![proptest_config(cases(60))]

    /// Aimed at 45° at the corner of a body, of a wall and of a mover.
    #[test]
    fn nothing_enters_what_its_corner_meets(seed in any::<u64>(), hz in prop::sample::select(RATES.to_vec())) {
        let random = &mut Random(seed);
        let (speed, e) = (random.decades(-0.5, 4.0), random.pick(&[0.0, 0.5, 1.0]));
        let signs = v(random.pick(&[-1.0, 1.0]), random.pick(&[-1.0, 1.0]));
        let (velocity, seconds) = (signs * speed, random.between(0.05, 0.4));
        let place = v(random.between(-9.0, 9.0), random.between(-9.0, 9.0));
        let from = place - signs - velocity * seconds;
        let drift = v(random.between(-3.0, 3.0), random.between(-3.0, 3.0));
        let block = SurfaceDef::fixed(Aabb::around(place, DVec2::splat(0.5)), Material::ICE);
        let mover = SurfaceDef { path: Path::steady(drift), ..block.clone() };
        let scenes = [
            ("body", in_space(vec![], vec![shot(from, velocity, e), shot(place, DVec2::ZERO, e)])),
            ("wall", in_space(vec![block], vec![shot(from, velocity, e)])),
            ("mover", in_space(vec![mover], vec![shot(from, velocity + drift, e)])),
        ];
        for (of, def) in scenes {
            let (_, deepest) = deepest_of(def, hz, 1.5 * seconds);
            prop_assert!(deepest <= 1e-9, "{} m in a {} at {} m/s", deepest, of, velocity);
        }
    }
}

#[test]
fn corners_that_close_alike_bounce_along_both_axes() {
    for hz in RATES {
        for e in [0.0, 0.5, 1.0] {
            let def = in_space(vec![], vec![shot(v(0.0, 0.0), v(60.0, 60.0), e), shot(v(5.0, 5.0), DVec2::ZERO, e)]);
            let (world, deepest) = deepest_of(def, hz, 0.2);
            let [slow, fast] = [0.5 * (1.0 - e), 0.5 * (1.0 + e)].map(|part| DVec2::splat(60.0 * part));
            assert!(deepest <= 1e-9, "{hz} Hz, e {e}: {deepest} m");
            assert!(
                world.speed(0).distance(slow) < 1e-9 && world.speed(1).distance(fast) < 1e-9,
                "{hz} Hz, e {e}: {}",
                world.speed(0)
            );
        }
    }
}

#[test]
fn corners_bounce_along_the_axis_on_which_they_close_faster() {
    let block =
        || SurfaceDef::fixed(Aabb::around(DVec2::ZERO, DVec2::splat(0.5)), Material { kinetic_friction: 0.0, ..Material::ICE });
    for hz in RATES {
        for (velocity, after) in [(v(8.0, 2.0), v(-8.0, 2.0)), (v(-3.0, 90.0), v(-3.0, -90.0)), (v(2000.0, -1.0), v(-2000.0, -1.0))]
        {
            let from = -velocity.signum() - velocity * 0.125;
            let (world, deepest) = deepest_of(in_space(vec![block()], vec![shot(from, velocity, 1.0)]), hz, 0.2);
            assert!(deepest <= 1e-9 && world.speed(0).distance(after) < 1e-9, "{hz} Hz: {deepest} m in, {}", world.speed(0));
        }
    }
}
