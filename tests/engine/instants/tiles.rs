//! Throws on floors of tiles: where friction stops a slide nothing is left of it, and nothing pushes what has stopped.

use super::*;

proptest! {
    #![proptest_config(cases(40))]

    /// Tiles of a third of the body's width are hit together.
    #[test]
    fn what_slides_over_tiles_is_only_slowed(
        seed in any::<u64>(),
        hz in prop::sample::select(vec![30.0, 60.0, 120.0, 240.0, 480.0]),
    ) {
        let random = &mut Random(seed);
        let (width, material) = (random.between(0.25, 0.3), random.pick(&Material::FIRM));
        let tile = |i: i32| SurfaceDef::fixed(area(width * f64::from(i), 0.0, width * f64::from(i + 1), 1.0), material);
        let body = BodyDef {
            position: v(4.0, -0.4 - random.between(0.5, 3.0)),
            half: DVec2::splat(0.4),
            velocity: v(random.between(0.3, 3.0), 0.0),
            mass: random.decades(-1.0, 2.0),
            restitution: random.between(0.3, 0.9),
            material: random.pick(&Material::FIRM),
            ..BodyDef::default()
        };
        let mut world = World::new(without_air((0..120).map(tile).collect(), vec![body])).unwrap();
        let mut before = world.speed(0).x;
        for tick in 0..(6.0 * hz) as u32 {
            world.step(1.0 / hz);
            let speed = world.speed(0).x;
            prop_assert!((0.0..=before).contains(&speed), "tick {}: {} m/s after {} m/s", tick, speed, before);
            before = speed;
        }
    }
}
