//! The path of an item, as the search for impacts needs it: a cubic and the box that it sweeps.

use crate::physics::data::{Aabb, Cubic};
use crate::physics::exact::item::{Item, Travel};
use glam::DVec2;

/// The path of an item from `since` to `until`, s from the tick's start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Track {
    pub since: f64,
    pub until: f64,
    pub motion: Travel,
    pub half: DVec2,
    pub way: Cubic,
    /// m.
    pub swept: Aabb,
    /// Bounds of the rounding of its places, m.
    pub rounding: DVec2,
}

impl Track {
    pub fn new(item: &Item, way: Cubic) -> Self {
        let Item { since, until, motion, .. } = *item;
        let (half, t) = (item.body.half, until - since);
        let swept = item.train.map_or_else(|| way.swept(half, t), |train| train.way);
        // Places on a path are off by less than 64 roundings of the largest coordinate and 1e-6 m.
        let rounding = swept.min.abs().max(swept.max.abs()) * (64.0 * f64::EPSILON) + 1e-6;
        Self { since, until, motion, half, way, swept, rounding }
    }

    pub fn lane(&self, covers: &Aabb) -> Aabb {
        Aabb::new(covers.min - self.rounding, covers.max + self.rounding)
    }

    pub fn is_still(&self) -> bool {
        self.motion == Travel::Still
    }

    /// Whether its cubic is its motion.
    pub fn is_exact(&self) -> bool {
        matches!(self.motion, Travel::Still | Travel::Parabola)
    }

    pub fn way_from(&self, at: f64) -> Cubic {
        self.way.from(at - self.since)
    }

    pub fn bounds_at(&self, at: f64) -> Aabb {
        let t = at - self.since;
        let [x, v, a, j] = self.way.c;
        Aabb::around(x + (v + (a + j * t) * t) * t, self.half + self.rounding)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What moves on a parabola or a cubic stays in its lane.
    #[test]
    fn a_way_lies_within_what_it_sweeps() {
        let (half, t) = (DVec2::new(0.5, 0.25), 0.7);
        let way = Cubic { c: [DVec2::ZERO, DVec2::new(3.0, -4.0), DVec2::new(-5.0, 6.0), DVec2::new(1.0, 0.5)] };
        let lane = way.swept(half, t);
        for part in 0..=20 {
            let place = way.from(t * f64::from(part) / 20.0).c[0];
            assert!(lane.contains(&Aabb::around(place, half), 1e-15));
        }
    }
}
