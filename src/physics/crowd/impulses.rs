//! What contacts of a crowd step gave.

use glam::DVec2;

/// What a contact gave during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactImpulse {
    /// The body that feels it, and the body or surface that exerts it and feels the opposite.
    pub a: u32,
    pub b: u32,
    /// The normal's direction.
    pub axis: usize,
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

/// One contact in the island's numbers; impulses on `a`, N·s, `normal` along the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record {
    pub a: u32,
    pub b: u32,
    pub axis: usize,
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
