//! A contact: two boxes that touch, along which axis, with what friction, and what passes through it.

use crate::physics::data::material::Coefficients;

/// Two things that touch. Along `axis` the lower one (`lo`) has the smaller coordinate. Items are the bodies of an island in ascending
/// order, and after them its surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Contact {
    pub lo: u32,
    pub hi: u32,
    /// 0: x, 1: y.
    pub axis: usize,
    pub static_friction: f64,
    pub kinetic_friction: f64,
    /// The speed of a belt's skin along the face, m/s: on top of the velocity of the surface.
    pub skin: f64,
    /// Whether the gap is closed; a hair of it is left where only resting contact is asked for.
    pub closed: bool,
    /// Whether its ends were in contact before.
    pub lasts: bool,
    /// Whether its ends part by mere rounding and count as resting.
    pub clings: bool,
    /// Which way `hi` slides over `lo` along the other axis: −1, 0 (it sticks) or 1.
    pub slides: f64,
    /// Whether it slides because static friction gave way in the last solve for forces.
    pub gave_way: bool,
    /// Push of `lo` on `hi` along the axis, N, ≥ 0 (N·s in an impact).
    pub normal: f64,
    /// Friction of `lo` on `hi` along the other axis, N (N·s).
    pub friction: f64,
}

impl Contact {
    /// A closed contact without friction.
    pub const fn between(lo: u32, hi: u32, axis: usize) -> Self {
        Self {
            lo,
            hi,
            axis,
            static_friction: 0.0,
            kinetic_friction: 0.0,
            skin: 0.0,
            closed: true,
            lasts: false,
            clings: false,
            slides: 0.0,
            gave_way: false,
            normal: 0.0,
            friction: 0.0,
        }
    }

    pub fn rub_with(&mut self, of: Coefficients) {
        (self.static_friction, self.kinetic_friction) = (of.static_friction, of.kinetic_friction);
    }

    pub fn has(&self, item: u32) -> bool {
        self.lo == item || self.hi == item
    }

    /// Whether it is between these two, whichever is the lower one.
    pub fn is_of(&self, a: u32, b: u32) -> bool {
        (self.lo == a && self.hi == b) || (self.lo == b && self.hi == a)
    }

    /// What it carries along an axis: its push along its own, its friction along the other.
    pub fn along(&mut self, axis: usize) -> &mut f64 {
        if axis == self.axis { &mut self.normal } else { &mut self.friction }
    }

    pub fn other(&self, item: u32) -> u32 {
        if self.lo == item { self.hi } else { self.lo }
    }

    /// The ends in ascending order.
    pub fn ends(&self) -> (u32, u32) {
        (self.lo.min(self.hi), self.lo.max(self.hi))
    }
}
