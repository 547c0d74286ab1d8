//! What the force managers show: every force by name and source, and the resultant that the solver found.

use super::{BodyId, Force, ForceKind, Source, World};
use glam::DVec2;

impl World {
    /// Lists the forces that act now.
    pub(super) fn show_forces(&mut self) {
        if self.forces_hold {
            return self.show_forces_of_air();
        }
        for index in 0..self.awake.len() {
            self.list_media_forces(self.awake[index] as usize);
        }
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            let (mut normal, mut friction) = (DVec2::ZERO, DVec2::ZERO);
            normal[contact.axis] = contact.normal;
            friction[1 - contact.axis] = contact.friction;
            self.list_contact_forces(contact.lo, contact.hi, -normal, -friction);
            self.list_contact_forces(contact.hi, contact.lo, normal, friction);
        }
        self.forces_hold = true;
        for &index in &self.awake {
            let i = index as usize;
            let body = &mut self.bodies[i];
            let solved = self.in_contact[i].then(|| self.solved[i] * body.mass);
            let resultant = self.forces[i].close(solved);
            body.acceleration = if self.in_contact[i] { self.solved[i] + DVec2::ZERO } else { resultant / body.mass };
        }
    }

    /// Where all else is as it was, only the air's forces on what flies are listed anew.
    pub(super) fn show_forces_of_air(&mut self) {
        for index in 0..self.awake.len() {
            let i = self.awake[index] as usize;
            if !self.laws[i].air.is_none() {
                self.list_media_forces(i);
                self.bodies[i].acceleration = self.forces[i].close(None) / self.bodies[i].mass;
            }
        }
    }

    /// Begins a body's list with the forces that need no contact.
    pub(super) fn list_media_forces(&mut self, i: usize) {
        let inside = &self.in_stream[i * self.media.streams.len()..];
        self.media.list(&self.bodies[i], &self.laws[i], self.drives[i], |stream| inside[stream], self.forces[i].renew());
    }

    /// Lists what `other` exerts on `item` in a contact, N. What a surface does, and what carries a body from below, is a Reaction; what
    /// another object does to it from above or from the side is a Push.
    pub(super) fn list_contact_forces(&mut self, item: u32, other: u32, normal: DVec2, friction: DVec2) {
        let surface = (other as usize).checked_sub(self.bodies.len());
        let Some(forces) = self.forces.get_mut(item as usize) else { return };
        let source = surface.map_or(Source::Body(BodyId(other)), |surface| Source::Surface(surface as u32));
        let carries = normal.y != 0.0 && (normal.y < 0.0) == (self.media.gravity >= 0.0);
        let kind = if surface.is_some() || carries { ForceKind::Reaction } else { ForceKind::Push };
        for (kind, vector) in [(kind, normal), (ForceKind::Friction, friction)] {
            if vector != DVec2::ZERO {
                forces.add(Force { kind, source, vector: vector + DVec2::ZERO });
            }
        }
    }
}
