//! One body on one immovable face, the direct answer: a crate that lies, slides or is about to, on a floor or a wall.
//!
//! Along the normal the face pushes back as hard as the body presses. Along the face, static friction holds up to μ_s·N; what it cannot
//! hold, or what slides already, feels μ_k·N against the motion. The contact network (`reactions`) comes to the same bits: this is what
//! its blocks and flows are for a single node.

use crate::physics::data::contact::Contact;
use crate::physics::data::tuning::FORCE_TOLERANCE;
use glam::DVec2;

/// Reaction and Friction of a contact between a body of `mass` (kg, along each axis) and a face, and the body's acceleration from the one it
/// would have without (m/s²), both as seen from the face; none, and nothing done, where the body does not press or nothing draws it along a wall. `body_is_hi`: on which side of
/// the contact it is.
pub(crate) fn press(contact: &mut Contact, mass: DVec2, free: DVec2, body_is_hi: bool) -> Option<DVec2> {
    let (axis, along) = (contact.axis, 1 - contact.axis);
    let away = if body_is_hi { 1.0 } else { -1.0 };
    let normal = -away * (mass[axis] * free[axis]);
    if normal <= 0.0 || (axis == 0 && free[along] == 0.0) {
        return None;
    }
    contact.normal = normal;
    let mut acceleration = DVec2::ZERO;
    let force = mass[along] * free[along];
    if contact.slides == 0.0 {
        let limit = contact.static_friction * normal;
        if force.abs() - limit <= force.abs() * FORCE_TOLERANCE {
            contact.friction = -away * force.signum() * force.abs().min(limit) + 0.0;
            return Some(acceleration);
        }
        contact.slides = away * force.signum();
    }
    contact.friction = -contact.slides * (contact.kinetic_friction * normal);
    acceleration[along] = (force + away * contact.friction) / mass[along];
    Some(acceleration)
}
