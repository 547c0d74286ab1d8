//! One body on one immovable face, the direct answer: the same bits as [`crate::physics::contact::reactions`].

use crate::physics::data::{Contact, FORCE_TOLERANCE, on_axis};
use glam::DVec2;

/// Sets Reaction and Friction of a contact between a body of `mass` (kg, along each axis) and a face. Returns the acceleration of the body from
/// the `free` one, m/s², both as seen from the face; none, and nothing done, where the body does not press or nothing draws it along a wall.
/// `body_is_hi`: on which side of the contact it is.
pub(crate) fn press(contact: &mut Contact, mass: DVec2, free: DVec2, body_is_hi: bool) -> Option<DVec2> {
    let (axis, along) = (contact.axis, 1 - contact.axis);
    let away = if body_is_hi { 1.0 } else { -1.0 };
    let normal = -away * (mass[axis] * free[axis]);
    if normal <= 0.0 || (axis == 0 && free[along] == 0.0) {
        return None;
    }
    contact.normal = normal;
    let force = mass[along] * free[along];
    if contact.slides == 0.0 {
        let limit = contact.static_friction * normal;
        if force.abs() - limit <= force.abs() * FORCE_TOLERANCE {
            contact.friction = -away * force.signum() * force.abs().min(limit) + 0.0;
            return Some(DVec2::ZERO);
        }
        contact.slides = away * force.signum();
    }
    contact.friction = -contact.slides * (contact.kinetic_friction * normal);
    Some(on_axis(axis, 0.0, (force + away * contact.friction) / mass[along]))
}
