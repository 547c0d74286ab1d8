//! Hits at one instant: all are known before one is applied, so rows of bodies keep their symmetry, momentum and energy.

use super::*;

/// A row that is its own mirror image about 0: masses and gaps on either side, hit from both ends.
fn symmetric(random: &mut Random) -> Vec<BodyDef> {
    let at = |x: f64, mass: f64, speed: f64| BodyDef {
        position: v(x, 0.0),
        velocity: v(speed, 0.0),
        half: DVec2::splat(0.5),
        mass,
        restitution: 1.0,
        ..BodyDef::default()
    };
    let odd = random.chance(0.5);
    let mut x = if odd { 0.0 } else { -0.5 };
    let mut bodies: Vec<_> = odd.then(|| at(0.0, random.decades(-1.0, 1.5), 0.0)).into_iter().collect();
    for _ in 0..=random.below(4) {
        x += 1.0 + if random.chance(0.6) { 0.0 } else { random.between(0.01, 0.6) };
        let mass = random.decades(-1.0, 1.5);
        bodies.extend([at(-x, mass, 0.0), at(x, mass, 0.0)]);
    }
    let (mass, speed) = (random.decades(-1.0, 1.5), random.between(0.5, 9.0));
    x += 1.0 + random.between(0.1, 1.0);
    bodies.extend([at(-x, mass, speed), at(x, mass, -speed)]);
    bodies
}

fn sums(world: &World) -> (f64, f64) {
    let of = |body: &resultant::physics::Body| (body.mass * body.velocity.x, 0.5 * body.mass * body.velocity.length_squared());
    world.bodies().iter().map(of).fold((0.0, 0.0), |sum, of| (sum.0 + of.0, sum.1 + of.1))
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn a_symmetric_row_stays_symmetric(seed in any::<u64>(), hz in prop::sample::select(vec![30.0, 120.0, 480.0])) {
        let random = &mut Random(seed);
        let mut rows = symmetric(random);
        // No order of rows plays a part.
        for last in (1..rows.len()).rev() {
            rows.swap(last, random.below(last + 1));
        }
        let mut world = World::new(in_space(vec![], rows.clone())).unwrap();
        let begun = sums(&world);
        for _ in 0..(1.5 * hz) as u32 {
            world.step(1.0 / hz);
        }
        let ended = sums(&world);
        prop_assert!((ended.0 - begun.0).abs() <= 1e-9 && (ended.1 / begun.1 - 1.0).abs() <= 1e-9, "{:?}, not {:?}", ended, begun);
        for (i, row) in rows.iter().enumerate() {
            let mirror = rows.iter().position(|other| (other.position.x + row.position.x).abs() < 1e-9).unwrap();
            let (off, parts) = (world.at(i).x + world.at(mirror).x, world.speed(i).x + world.speed(mirror).x);
            prop_assert!(off.abs() <= 1e-9 && parts.abs() <= 1e-9, "body {} of {}: {} m, {} m/s beside its mirror image", i, rows.len(), off, parts);
        }
    }
}

/// Each heavy one hits its light one twice, and takes back all that it gave.
#[test]
fn two_heavy_ends_leave_two_light_ones_at_rest() {
    let at = |x: f64, mass: f64, speed: f64| BodyDef {
        position: v(x, 0.0),
        velocity: v(speed, 0.0),
        half: DVec2::splat(0.5),
        mass,
        restitution: 1.0,
        ..BodyDef::default()
    };
    let rows = [at(26.0, 3.0, -4.0), at(20.0, 1.0, 0.0), at(21.0, 1.0, 0.0), at(15.0, 3.0, 4.0)];
    let mut world = World::new(in_space(vec![], rows.to_vec())).unwrap();
    world.steps(240, 1.0 / 120.0);
    assert_eq!([0, 1, 2, 3].map(|i| world.speed(i).x), [4.0, 0.0, 0.0, -4.0]);
}
