//! What the others ask of an item when they seek what they meet. All tracks of an island lie side by side, apart from what else is known of
//! its items: each such question goes to every one of them. First it is asked of boxes, [`Lanes`], in which they stay until their next events.

use crate::physics::data::aabb::Aabb;
use crate::physics::data::impact_time::Cubic;
use crate::physics::exact::item::{Item, Motion};
use glam::DVec2;

/// The way of an item from `since` to `until`, s from the tick's start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Track {
    pub since: f64,
    pub until: f64,
    pub motion: Motion,
    pub half: DVec2,
    pub way: Cubic,
    /// What it sweeps, m.
    pub swept: Aabb,
    /// Bounds of its speed along each axis, m/s, and of the rounding of its places, m.
    fastest: DVec2,
    pub rounding: DVec2,
}

impl Track {
    /// Of something on a way.
    pub fn new(item: &Item, way: Cubic) -> Self {
        let Item { since, until, motion, .. } = *item;
        let (half, t) = (item.body.half, until - since);
        let swept = way.swept(half, t);
        let [_, v, a, j] = way.c;
        let fastest = v.abs() + (2.0 * a.abs() + 3.0 * j.abs() * t) * t;
        // Places on a way are off by less than 64 roundings of the largest coordinate and 1e-6 m.
        let rounding = swept.min.abs().max(swept.max.abs()) * (64.0 * f64::EPSILON) + 1e-6;
        Self { since, until, motion, half, way, swept, fastest, rounding }
    }

    pub fn is_still(&self) -> bool {
        self.motion == Motion::Still
    }

    /// Whether it moves as its way says, and not nearly so.
    pub fn is_exact(&self) -> bool {
        matches!(self.motion, Motion::Still | Motion::Parabola)
    }

    /// The way from a later time on.
    pub fn way_from(&self, at: f64) -> Cubic {
        self.way.from(at - self.since)
    }

    /// What it covers at a time, and no more than its rounding besides, if it moves as its way says.
    pub fn bounds_at(&self, at: f64) -> Aabb {
        let t = at - self.since;
        let [x, v, a, j] = self.way.c;
        Aabb::around(x + (v + (a + j * t) * t) * t, self.half + self.rounding)
    }

    /// Whether another item, so far `apart` (m) now, may come within `slop` of it in `t` seconds. It is never told wrongly that it may not.
    pub fn may_meet(&self, other: &Self, apart: DVec2, t: f64, slop: f64) -> bool {
        let reach = self.half + other.half + self.rounding + other.rounding + (self.fastest + other.fastest) * t + slop;
        apart.x.abs() <= reach.x && apart.y.abs() <= reach.y
    }
}

/// The box in which each item stays until its next event, m: separate arrays, of which the compiler makes vector code.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lanes {
    left: Vec<f64>,
    right: Vec<f64>,
    top: Vec<f64>,
    bottom: Vec<f64>,
    /// Of a search: all ones where a box touches.
    touches: Vec<u64>,
}

impl Lanes {
    /// Makes room for so many.
    pub fn resize(&mut self, count: usize) {
        for edges in [&mut self.left, &mut self.right, &mut self.top, &mut self.bottom] {
            edges.clear();
            edges.resize(count, 0.0);
        }
        self.touches.clear();
        self.touches.resize(count, 0);
    }

    /// Sets the box of an item, and how much is added to it for rounding.
    pub fn set(&mut self, i: usize, lane: &Aabb, rounding: DVec2) {
        let (min, max) = (lane.min - rounding, lane.max + rounding);
        (self.left[i], self.right[i], self.top[i], self.bottom[i]) = (min.x, max.x, min.y, max.y);
    }

    /// Lists whose boxes touch this one, in ascending order.
    pub fn touching(&mut self, with: &Aabb, found: &mut Vec<u32>) {
        let count = self.touches.len();
        let (left, right, top, bottom) = (&self.left[..count], &self.right[..count], &self.top[..count], &self.bottom[..count]);
        let (min, max) = (with.min, with.max);
        for (i, touches) in self.touches.iter_mut().enumerate() {
            let apart = (left[i] > max.x) | (right[i] < min.x) | (top[i] > max.y) | (bottom[i] < min.y);
            *touches = u64::from(!apart);
        }
        found.clear();
        found.extend((0u32..).zip(&self.touches).filter(|(_, touches)| **touches != 0).map(|(i, _)| i));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn lanes_find_what_a_look_at_each_finds() {
        let mut generator = Random(1);
        let mut random = |most: f64| most * generator.unit();
        for count in [0, 1, 7, 68] {
            let boxes: Vec<Aabb> = (0..count)
                .map(|_| Aabb::around(DVec2::new(random(10.0), random(10.0)), DVec2::new(random(2.0), random(2.0))))
                .collect();
            let (mut lanes, mut found) = (Lanes::default(), Vec::new());
            lanes.resize(count);
            for (i, of) in boxes.iter().enumerate() {
                lanes.set(i, of, DVec2::ZERO);
            }
            for with in &boxes {
                lanes.touching(with, &mut found);
                let each = (0u32..).zip(&boxes).filter(|(_, of)| of.touches(with, 0.0)).map(|(i, _)| i);
                assert_eq!(found, each.collect::<Vec<_>>());
            }
        }
    }

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
