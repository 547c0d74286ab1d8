//! Surfaces within a tick: they begin the legs of their paths, and stop for what they would squeeze.

use super::item::Next;
use super::{Events, Scene};

impl Events {
    /// Begins the next leg of a surface's path: whatever touches it is concerned.
    pub(super) fn turn(&mut self, scene: &Scene, i: usize) {
        self.set_out(scene, i);
        self.predict(scene, i);
        if !self.concerned.is_empty() {
            self.look(scene, None);
        }
    }

    /// Stops a surface for the rest of the tick.
    pub(super) fn halt(&mut self, scene: &Scene, surface: u32) {
        self.guards.surfaces_stopped += 1;
        self.halted = true;
        self.items[surface as usize].stops_at = self.now;
        self.set_out(scene, surface as usize);
    }

    /// Sets a surface on the part of its path that begins now. Concerns whatever is in contact with it.
    fn set_out(&mut self, scene: &Scene, i: usize) {
        let item = &mut self.items[i];
        scene.set_on_path(item, self.now);
        self.foresee(scene, i);
        self.nexts[i] = Next::NEVER;
        let item = &self.items[i];
        let ground = i - self.movable;
        (self.ground_speeds[ground], self.ground_pulls[ground]) = (item.body.velocity, item.solved);
        (self.places[i], self.is_placed[i]) = (item.body.position, true);
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            if contact.has(i as u32) {
                self.concern(contact.other(i as u32));
            }
        }
    }
}
