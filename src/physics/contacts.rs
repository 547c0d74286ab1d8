//! Contacts: which boxes touch, along which axis, and whether they slide.

use super::candidates::Pair;
use super::tuning::{SLOP, SPEED_ROUNDING};
use super::{Material, World};
use glam::DVec2;

/// Two things that touch. Along `axis` the lower one (`lo`) has the smaller coordinate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    pub pair: Pair,
    /// 0: x, 1: y.
    pub axis: usize,
    /// Body or surface index, counted like those of a pair.
    pub lo: u32,
    pub hi: u32,
    pub static_friction: f64,
    pub kinetic_friction: f64,
    /// Whether the gap is closed; up to [`SLOP`] of it is left where only resting contact is asked for.
    pub closed: bool,
    /// Whether its ends part by mere rounding and count as resting (see `impacts`).
    pub clings: bool,
    /// How often it has bounced with loss in the present cascade of impacts.
    pub lossy_hits: u32,
    /// Which way `hi` slides over `lo` along the other axis: −1, 0 (it sticks) or 1.
    pub slides: f64,
    /// Push of `lo` on `hi` along the axis, N, ≥ 0.
    pub normal: f64,
    /// Friction of `lo` on `hi` along the other axis, N.
    pub friction: f64,
}

impl World {
    /// Whether an index of a pair or contact is that of something immovable.
    pub(super) fn immovable(&self, item: u32) -> bool {
        item as usize >= self.bodies.len()
    }

    pub(super) fn place(&self, item: u32) -> DVec2 {
        match self.bodies.get(item as usize) {
            Some(body) => body.position,
            None => self.blocks[item as usize - self.bodies.len()].0,
        }
    }

    pub(super) fn half(&self, item: u32) -> DVec2 {
        match self.bodies.get(item as usize) {
            Some(body) => body.half,
            None => self.blocks[item as usize - self.bodies.len()].1,
        }
    }

    pub(super) fn velocity(&self, item: u32) -> DVec2 {
        self.bodies.get(item as usize).map_or(DVec2::ZERO, |body| body.velocity)
    }

    /// The coefficients with which a pair slides: a surface gives its own, two bodies the smaller of theirs.
    fn friction_of(&self, pair: Pair) -> (f64, f64) {
        let a = &self.bodies[pair.a as usize].material;
        match self.bodies.get(pair.b as usize).map(|body| &body.material) {
            Some(b) => (a.static_friction.min(b.static_friction), a.kinetic_friction.min(b.kinetic_friction)),
            None => {
                let Material { static_friction, kinetic_friction, .. } =
                    self.surfaces[pair.b as usize - self.bodies.len()].material;
                (static_friction, kinetic_friction)
            }
        }
    }

    /// The contact of a pair whose gap along an axis is at most `touch` (m) while it overlaps along the other. Boxes that overlap
    /// along both touch along the axis along which they overlap less.
    pub(super) fn contact(&self, pair: Pair, touch: f64) -> Option<Contact> {
        let apart = self.place(pair.b) - self.place(pair.a);
        let gap = apart.abs() - (self.half(pair.a) + self.half(pair.b));
        let axis = if gap.x > gap.y { 0 } else { 1 };
        if gap[axis] > touch || gap[1 - axis] >= -SLOP {
            return None;
        }
        let closed = gap[axis] <= 0.0;
        Some(self.contact_along(pair, axis, apart[axis] > 0.0, closed))
    }

    /// The contact of a pair along an axis; `ascending` if its second has the larger coordinate.
    pub(super) fn contact_along(&self, pair: Pair, axis: usize, ascending: bool, closed: bool) -> Contact {
        let (lo, hi) = if ascending { (pair.a, pair.b) } else { (pair.b, pair.a) };
        let (static_friction, kinetic_friction) = self.friction_of(pair);
        Contact {
            pair,
            axis,
            lo,
            hi,
            static_friction,
            kinetic_friction,
            closed,
            clings: false,
            lossy_hits: 0,
            slides: 0.0,
            normal: 0.0,
            friction: 0.0,
        }
    }

    /// Finds the closed contacts among what touches: those that neither part nor (impacts are over by now) approach. `met` is the pair
    /// that has just hit: only its impact was along the axis in which it met.
    pub(super) fn find_contacts(&mut self, met: Option<Pair>) {
        let mut found = std::mem::take(&mut self.found);
        found.clear();
        for touching in &self.touching {
            let again = if met == Some(touching.pair) { self.contact(touching.pair, SLOP) } else { None };
            if met == Some(touching.pair) && again.is_none() {
                continue;
            }
            let contact = again.as_ref().unwrap_or(touching);
            let axis = contact.axis;
            let (lo_speed, hi_speed) = (self.velocity(contact.lo), self.velocity(contact.hi));
            if hi_speed[axis] - lo_speed[axis] == 0.0 {
                let along = 1 - axis;
                let fastest = hi_speed[along].abs().max(lo_speed[along].abs());
                let sliding = hi_speed[along] - lo_speed[along];
                let slides = if sliding.abs() <= SPEED_ROUNDING * fastest { 0.0 } else { sliding.signum() };
                found.push(Contact { closed: true, clings: false, lossy_hits: 0, slides, normal: 0.0, friction: 0.0, ..*contact });
            }
        }
        self.found = found;
    }
}
