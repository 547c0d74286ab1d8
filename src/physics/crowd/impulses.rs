//! What contacts of a crowd step gave.

use crate::physics::crowd::Other;
use crate::physics::data::axis::Axis;
use glam::DVec2;

/// What a contact gave during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactImpulse {
    /// The body that feels it (the other one feels the opposite).
    pub a: usize,
    /// What exerts it.
    pub b: Other,
    /// The normal's direction.
    pub axis: Axis,
    /// The component along the normal, N·s: positive towards larger x or y.
    pub normal: f64,
    /// Friction, along the other direction, N·s.
    pub friction: f64,
    /// The middle of the contact, m.
    pub point: DVec2,
    /// Whether the two came together in this step; if not, what a lasting contact exerted.
    pub impact: bool,
    /// How often the island had been solved.
    pub solved: u32,
}

impl ContactImpulse {
    /// The bodies that it acts on.
    pub fn ends(&self) -> impl Iterator<Item = usize> + use<> {
        let other = match self.b {
            Other::Body(b) => Some(b),
            Other::Surface(_) => None,
        };
        std::iter::once(self.a).chain(other)
    }
}

/// One contact in the island's numbers; impulses on `a`, N·s, `normal` along the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record {
    pub a: u32,
    pub b: u32,
    pub axis: Axis,
    pub normal: f64,
    pub friction: f64,
}

/// A contact through which a cluster was merged, in the island's numbers, and the impulse that went through it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Edge {
    pub a: u32,
    pub b: u32,
    /// On `b`, N·s.
    pub impulse: f64,
    /// Which part of it the contact returns when the step ends.
    pub restitution: f64,
}
