use glam::DVec2;

/// The impulse of a contact in the last step, in the numbers of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactImpulse {
    /// The body that feels it, and the body or surface that exerts it and feels the opposite.
    pub a: u32,
    pub b: u32,
    pub axis: usize,
    /// N·s along the axis, and friction along the other one, on `a`.
    pub normal: f64,
    pub friction: f64,
    /// The middle of the contact, m.
    pub point: DVec2,
    /// Whether the two came together in this step; if not, what a lasting contact exerted.
    pub impact: bool,
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
