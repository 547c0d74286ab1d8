//! Touching objectives, pods and death boxes.

use crate::level::SHIP_HALF;
use crate::physics::DVec2;

/// Boxes closer than this touch, m. It covers the rounding from pixels to metres; a much larger gap would be visible.
pub const TOUCH: f64 = 1e-9;

/// About the ship's centre, clockwise.
pub(super) const SHIP_BOX: [DVec2; 4] = [
    DVec2::new(-SHIP_HALF.x, -SHIP_HALF.y),
    DVec2::new(SHIP_HALF.x, -SHIP_HALF.y),
    DVec2::new(SHIP_HALF.x, SHIP_HALF.y),
    DVec2::new(-SHIP_HALF.x, SHIP_HALF.y),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::level::{ship_body, sweep_touches};
    use crate::physics::Aabb;
    use proptest::prelude::*;
    use proptest::test_runner::FileFailurePersistence;

    const TARGET: Aabb = Aabb::new(DVec2::new(2.0, 3.0), DVec2::new(4.0, 3.1));
    const HALF: DVec2 = DVec2::new(0.5, 0.25);

    fn corners() -> [DVec2; 4] {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| HALF * DVec2::new(x, y))
    }

    fn touches(from: [f64; 2], to: [f64; 2]) -> bool {
        sweep_touches(&corners(), from.into(), to.into(), &TARGET, TOUCH)
    }

    #[test]
    fn what_flies_through_within_one_sweep_touches() {
        assert!(touches([3.0, -1000.0], [3.0, 1000.0]));
        assert!(touches([3.0, 1000.0], [3.0, -1000.0]));
        assert!(touches([-100.0, 3.05], [100.0, 3.05]));
        assert!(touches([3.0, 3.05], [3.0, 3.05]), "inside, at rest");
    }

    #[test]
    fn what_stops_short_or_passes_by_does_not() {
        assert!(!touches([3.0, 0.0], [3.0, 2.7]));
        assert!(!touches([3.0, 2.7], [3.0, 2.7]));
        assert!(!touches([0.0, 0.0], [0.0, 100.0]));
        assert!(!touches([0.0, 3.5], [2.5, 0.0]), "past the corner");
        assert!(!touches([3.0, 3.4], [3.0, 100.0]), "flying away");
    }

    #[test]
    fn touching_counts() {
        assert!(touches([3.0, 0.0], [3.0, 2.75]), "ends at the edge");
        assert!(touches([0.0, 2.75], [10.0, 2.75]), "slides along the edge");
        assert!(touches([1.5, 2.75], [1.5, 2.75]), "corner to corner");
        assert!(!touches([1.5, 2.75 - 1e-6], [1.5, 2.75 - 1e-6]), "a micrometre away");
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions"))),
            ..ProptestConfig::default()
        })]

        #[test]
        fn a_sweep_finds_whatever_a_walk_along_it_finds(x0 in -5.0..10.0, y0 in -5.0..10.0, x1 in -5.0..10.0, y1 in -5.0..10.0) {
            let (from, to) = (DVec2::new(x0, y0), DVec2::new(x1, y1));
            let touches_at = |t: f64, slop: f64| Aabb::around(from.lerp(to, t), HALF).touches(&TARGET, slop);
            let walked = (0..=1000).any(|i| touches_at(f64::from(i) / 1000.0, 0.0));
            // A step is at most 22 mm.
            let nearly = (0..=1000).any(|i| touches_at(f64::from(i) / 1000.0, 0.022));
            let swept = sweep_touches(&corners(), from, to, &TARGET, TOUCH);
            prop_assert!(swept || !walked, "the sweep misses a touch");
            prop_assert!(nearly || !swept, "the sweep invents a touch");
        }

        #[test]
        fn the_ships_body_touches_what_a_walk_of_its_outline_touches(
            angle in -360.0..360.0, x0 in -4.0..10.0, y0 in -4.0..10.0, x1 in -4.0..10.0, y1 in -4.0..10.0,
        ) {
            let (from, to, body) = (DVec2::new(x0, y0), DVec2::new(x1, y1), ship_body(angle));
            let target = Aabb::new(DVec2::new(2.0, 3.0), DVec2::new(4.0, 5.0));
            // Points of the outline are at most 10 mm apart, at places at most 20 mm apart: none is nearer to a corner of the
            // target than the sweep by more than that.
            let outline = || (0..body.len()).flat_map(|i| {
                let (a, b) = (body[i], body[(i + 1) % body.len()]);
                (0..64).map(move |part| a.lerp(b, f64::from(part) / 64.0))
            });
            let gap = |point: DVec2| (target.min - point).max(point - target.max).max(DVec2::ZERO).length();
            let nearest = (0..=1000)
                .flat_map(|i| outline().map(move |point| from.lerp(to, f64::from(i) / 1000.0) + point))
                .map(gap)
                .fold(f64::INFINITY, f64::min);
            let swept = sweep_touches(&body, from, to, &target, TOUCH);
            prop_assert!(swept || nearest > 0.0, "the sweep misses a touch");
            prop_assert!(!swept || nearest < 0.04, "the sweep invents a touch, {nearest} m away");
        }
    }
}
