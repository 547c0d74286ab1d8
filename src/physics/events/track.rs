//! What the others ask of an item when they seek what they meet. All tracks of an island lie side by side, apart from what else is known of
//! its items: each such question goes to every one of them.

use super::item::{Item, Motion};
use crate::physics::Aabb;
use crate::physics::impact_time::Cubic;
use glam::DVec2;

/// m, and as a part of the largest coordinate: the roundings that places on a way are sure to stay below.
const ROUNDING: f64 = 1e-6;
const RELATIVE_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The way of an item from `since` to `until`, s from the tick's start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Track {
    pub since: f64,
    pub until: f64,
    pub motion: Motion,
    pub half: DVec2,
    pub way: Cubic,
    /// What it sweeps, m.
    pub swept: Aabb,
    /// Bounds of its speed along each axis, m/s, and of the rounding of its places, m.
    fastest: DVec2,
    rounding: DVec2,
}

impl Track {
    /// Of something on a way.
    pub fn new(item: &Item, way: Cubic) -> Self {
        let Item { since, until, motion, .. } = *item;
        let (half, t) = (item.body.half, until - since);
        let (x, y) = (way.axis(0).bounds(t), way.axis(1).bounds(t));
        let swept = Aabb::new(DVec2::new(x.0, y.0) - half, DVec2::new(x.1, y.1) + half);
        let [_, v, a, j] = way.c;
        let fastest = v.abs() + (2.0 * a.abs() + 3.0 * j.abs() * t) * t;
        let rounding = swept.min.abs().max(swept.max.abs()) * RELATIVE_ROUNDING + ROUNDING;
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
