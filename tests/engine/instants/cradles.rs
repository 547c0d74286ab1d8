//! Hits at one instant: all are known before one is applied, so rows of bodies keep their symmetry, momentum and energy; and of corners that
//! meet neither face is hit before the other.

use super::*;
use resultant::physics::Aabb;

/// A row that is its own mirror image about 0: masses and gaps on either side, hit from both ends.
fn symmetric(random: &mut Random) -> Vec<BodyDef> {
    let at = |x: f64, mass: f64, speed: f64| elastic(v(x, 0.0), mass, speed);
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
        (0..(1.5 * hz) as u32).for_each(|_| world.step(1.0 / hz));
        let ended = sums(&world);
        prop_assert!((ended.0 - begun.0).abs() <= 1e-9 && (ended.1 / begun.1 - 1.0).abs() <= 1e-9, "{:?}, not {:?}", ended, begun);
        for (i, row) in rows.iter().enumerate() {
            let mirror = rows.iter().position(|other| (other.position.x + row.position.x).abs() < 1e-9).unwrap();
            let (off, parts) = (world.at(i).x + world.at(mirror).x, world.speed(i).x + world.speed(mirror).x);
            prop_assert!(off.abs() <= 1e-9 && parts.abs() <= 1e-9, "body {} of {}: {} m, {} m/s beside its mirror image", i, rows.len(), off, parts);
        }
    }
}

/// Rows on all four sides of one body, hit from outside: no axis comes first.
#[test]
fn a_cross_stays_alike_along_both_axes() {
    let arm = [(1.0, 18.28, 0.0), (2.0, 1.297, 0.0), (3.69984, 3.47, -30.0)];
    let sides = [v(1.0, 0.0), v(-1.0, 0.0), v(0.0, 1.0), v(0.0, -1.0)];
    let of = |side: DVec2, (away, mass, speed)| BodyDef { velocity: side * speed, ..elastic(side * away, mass, 0.0) };
    let row = |side: DVec2| arm.map(|body| of(side, body));
    let middle = elastic(DVec2::ZERO, 0.945, 0.0);
    let bodies = std::iter::once(middle).chain(sides.into_iter().flat_map(row));
    let mut world = World::new(in_space(vec![], bodies.collect())).unwrap();
    for tick in 0..240 {
        world.step(1.0 / 240.0);
        for k in 0..3 {
            let out = sides.iter().enumerate().map(|(side, way)| world.speed(1 + 3 * side + k).dot(*way));
            let (least, most) = out.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), speed| (a.min(speed), b.max(speed)));
            assert!(most - least <= 1e-9, "tick {tick}: bodies {k} from the middle leave with {least} to {most} m/s");
        }
    }
}

/// Each heavy one hits its light one twice, and takes back all that it gave.
#[test]
fn two_heavy_ends_leave_two_light_ones_at_rest() {
    let at = |x: f64, mass: f64, speed: f64| elastic(v(x, 0.0), mass, speed);
    let rows = [at(26.0, 3.0, -4.0), at(20.0, 1.0, 0.0), at(21.0, 1.0, 0.0), at(15.0, 3.0, 4.0)];
    let mut world = World::new(in_space(vec![], rows.to_vec())).unwrap();
    world.steps(240, 1.0 / 120.0);
    assert_eq!([0, 1, 2, 3].map(|i| world.speed(i).x), [4.0, 0.0, 0.0, -4.0]);
}

/// How far two boxes are in each other, m.
fn depth(a: &Aabb, b: &Aabb) -> f64 {
    (a.max.min(b.max) - a.min.max(b.min)).min_element()
}

fn shot(position: DVec2, velocity: DVec2, e: f64) -> BodyDef {
    BodyDef { velocity, restitution: e, ..elastic(position, 2.0, 0.0) }
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
    fn nothing_enters_what_its_corner_meets(seed in any::<u64>(), hz in rates()) {
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
            let found = world.speed(0);
            assert!(found.distance(slow) < 1e-9 && world.speed(1).distance(fast) < 1e-9, "{hz} Hz, e {e}: {found}");
        }
    }
}

#[test]
fn corners_bounce_along_the_axis_on_which_they_close_faster() {
    let block = || SurfaceDef::fixed(Aabb::around(DVec2::ZERO, DVec2::splat(0.5)), rough(0.0, 0.0));
    let cases = [(v(8.0, 2.0), v(-8.0, 2.0)), (v(-3.0, 90.0), v(-3.0, -90.0)), (v(2000.0, -1.0), v(-2000.0, -1.0))];
    for hz in RATES {
        for (velocity, after) in cases {
            let from = -velocity.signum() - velocity * 0.125;
            let (world, deepest) = deepest_of(in_space(vec![block()], vec![shot(from, velocity, 1.0)]), hz, 0.2);
            assert!(deepest <= 1e-9 && world.speed(0).distance(after) < 1e-9, "{hz} Hz: {deepest} m in, {}", world.speed(0));
        }
    }
}
