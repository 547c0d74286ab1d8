//! Contacts, and what impacts pass on.

use crate::physics::data::{body::BodyId, material::Coefficients};
use glam::DVec2;

/// Two boxes that touch. Along `axis` `lo` has the smaller coordinate. Items are the bodies of an island in ascending order, then its surfaces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Contact {
    pub lo: u32,
    pub hi: u32,
    /// 0: x, 1: y.
    pub axis: usize,
    pub static_friction: f64,
    pub kinetic_friction: f64,
    /// The speed of a belt's skin along the face, m/s: on top of the velocity of the surface.
    pub skin: f64,
    /// Whether the gap is closed; resting contact needs it no closer than the slop.
    pub closed: bool,
    pub lasts: bool,
    /// Whether its ends part by mere rounding and count as resting.
    pub clings: bool,
    /// The direction in which `hi` slides over `lo` along the other axis: −1, 0 (it sticks) or 1.
    pub slides: f64,
    /// Whether it slides because static friction gave way in the last solve for forces.
    pub gave_way: bool,
    /// Push of `lo` on `hi` along the axis, N, ≥ 0 (N·s in an impact).
    pub normal: f64,
    /// The push that the last solve for forces began with, N: who solves the same again begins with it and ends at the same bits.
    pub begun: f64,
    /// Friction of `lo` on `hi` along the other axis, N (N·s).
    pub friction: f64,
    /// What both have passed on in this tick, up to the last event, N·s.
    pub passed: [f64; 2],
    /// Friction as the tick begins, N.
    pub rubbed: f64,
}

impl Contact {
    /// A closed contact without friction.
    pub fn between(lo: u32, hi: u32, axis: usize) -> Self {
        Self { lo, hi, axis, closed: true, ..Self::default() }
    }

    pub fn rub_with(&mut self, of: Coefficients) {
        (self.static_friction, self.kinetic_friction) = (of.static_friction, of.kinetic_friction);
    }

    pub fn has(&self, item: u32) -> bool {
        self.lo == item || self.hi == item
    }

    pub fn is_of(&self, a: u32, b: u32) -> bool {
        (self.lo == a && self.hi == b) || (self.lo == b && self.hi == a)
    }

    pub fn pair(&self) -> [u32; 2] {
        [self.lo, self.hi]
    }

    pub fn along(&mut self, axis: usize) -> &mut f64 {
        if axis == self.axis { &mut self.normal } else { &mut self.friction }
    }

    pub fn other(&self, item: u32) -> u32 {
        if self.lo == item { self.hi } else { self.lo }
    }

    pub fn ends(&self) -> (u32, u32) {
        (self.lo.min(self.hi), self.lo.max(self.hi))
    }
}

/// What a body can run into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Obstacle {
    /// The surface of that index in `World::surfaces`.
    Surface(u32),
    /// Another body.
    Body(BodyId),
}

/// What one impact passed on to `a`, and the opposite to a body `b`; or what a contact that ended within the tick did: no list of forces has that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impulse {
    /// The body that felt it.
    pub a: BodyId,
    /// What exerted it.
    pub b: Obstacle,
    /// N·s, normal and friction together.
    pub vector: DVec2,
    /// The middle of the shared edge, m.
    pub point: DVec2,
    /// When in the tick it was, s from the tick's start.
    pub at: f64,
    /// Whether it is an impact.
    pub impact: bool,
}

impl Impulse {
    /// Its name as shown to the player.
    pub const NAME: &'static str = "Impact";

    /// What a body felt of it, N·s, and from what.
    pub fn on(&self, body: BodyId) -> Option<(DVec2, Obstacle)> {
        let opposite = || (self.b == Obstacle::Body(body)).then_some((-self.vector, Obstacle::Body(self.a)));
        if self.a == body { Some((self.vector, self.b)) } else { opposite() }
    }
}

/// An impulse with what events and paths tell of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    pub impulse: Impulse,
    /// From `b` towards `a`.
    pub normal: DVec2,
    /// Closing speed just before, m/s; 0 where what had bounced goes on.
    pub speed: f64,
    /// Where `a` and `b` were, m.
    pub places: [DVec2; 2],
}
