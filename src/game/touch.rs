//! Touching objectives and death boxes: pure questions about boxes.

use crate::physics::{Aabb, DVec2};

/// Boxes closer than this touch, m. It makes up for the rounding of pixels to metres; much larger and one would see the gap.
pub const TOUCH: f64 = 1e-9;

/// Whether a box that reaches `half` to each side of its centre touches `target` anywhere while the centre moves straight from
/// `from` to `to`. Seen from the centre the box is a point and the target grows by `half`: a segment against a box, slab by slab
/// (Kay and Kajiya 1986). Touching counts, so a box that only slides along the target's edge touches it.
pub fn sweep_touches(from: DVec2, to: DVec2, half: DVec2, target: &Aabb) -> bool {
    let (min, max) = (target.min - half - TOUCH, target.max + half + TOUCH);
    let way = to - from;
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let (from, way, min, max) = (from[axis], way[axis], min[axis], max[axis]);
        if way == 0.0 {
            if from < min || from > max {
                return false;
            }
        } else {
            let (a, b) = ((min - from) / way, (max - from) / way);
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
    }
    enter <= leave
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::FileFailurePersistence;

    const TARGET: Aabb = Aabb::new(DVec2::new(2.0, 3.0), DVec2::new(4.0, 3.1));
    const HALF: DVec2 = DVec2::new(0.5, 0.25);

    fn touches(from: [f64; 2], to: [f64; 2]) -> bool {
        sweep_touches(from.into(), to.into(), HALF, &TARGET)
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
            // A step of the walk is at most 22 mm.
            let nearly = (0..=1000).any(|i| touches_at(f64::from(i) / 1000.0, 0.022));
            let swept = sweep_touches(from, to, HALF, &TARGET);
            prop_assert!(swept || !walked, "the sweep misses a touch");
            prop_assert!(nearly || !swept, "the sweep invents a touch");
        }
    }
}
