//! What the force managers show: every force by name and source, and the resultant that the solver found.

use super::{BodyId, Force, ForceKind, Source, World};
use glam::DVec2;

impl World {
    /// Lists the forces that act now.
    pub(super) fn show_forces(&mut self) {
        let streams = self.media.streams.len();
        for (i, forces) in self.forces.iter_mut().enumerate() {
            let inside = &self.in_stream[i * streams..];
            self.media.list(&self.bodies[i], &self.laws[i], self.drives[i], |stream| inside[stream], forces.renew());
        }
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            let (mut normal, mut friction) = (DVec2::ZERO, DVec2::ZERO);
            normal[contact.axis] = contact.normal;
            friction[1 - contact.axis] = contact.friction;
            for (item, other, sign) in [(contact.lo, contact.hi, -1.0), (contact.hi, contact.lo, 1.0)] {
                let Some(forces) = self.forces.get_mut(item as usize) else { continue };
                let surface = (other as usize).checked_sub(self.bodies.len());
                let source = surface.map_or(Source::Body(BodyId(other)), |surface| Source::Surface(surface as u32));
                // What carries a body is a Reaction; what another object does to it from above or from the side is a Push.
                let below = contact.axis == 1 && (sign < 0.0) == (self.media.gravity >= 0.0);
                let kind = if surface.is_some() || below { ForceKind::Reaction } else { ForceKind::Push };
                for (kind, vector) in [(kind, normal * sign), (ForceKind::Friction, friction * sign)] {
                    if vector != DVec2::ZERO {
                        forces.add(Force { kind, source, vector: vector + DVec2::ZERO });
                    }
                }
            }
        }
        for (i, body) in self.bodies.iter_mut().enumerate() {
            let solved = self.in_contact[i].then(|| self.solved[i] * body.mass);
            let resultant = self.forces[i].close(solved);
            body.acceleration = if self.in_contact[i] { self.solved[i] + DVec2::ZERO } else { resultant / body.mass };
        }
    }
}
