//! An island that rests and goes on resting, although something about it was changed: an engine that pushes against what holds.
//!
//! Nothing moves, so nothing meets: if those that were changed still touch what they touched, the forces are solved once, and where they leave
//! everything at rest that is the whole tick. Otherwise the tick is gone through as any other.

use crate::physics::contact::axis::Parts;
use crate::physics::data::tuning::SLOP;
use crate::physics::data::{Contact, Part, called};
use crate::physics::exact::events::{Events, Scene};
use crate::physics::exact::item::Motion;
use glam::DVec2;

impl Events {
    /// Tries to end the tick at once. Returns whether everything rests through all of it; if not, nothing has been changed.
    pub(crate) fn rest(&mut self, scene: &Scene) -> bool {
        let (bodies, surfaces) = self.items.split_at(self.movable);
        let rests = scene.direct
            && self.streams.is_empty()
            && self.links.is_empty()
            && bodies.iter().all(|item| item.body.velocity == DVec2::ZERO && item.solved == DVec2::ZERO)
            && surfaces.iter().all(|surface| surface.motion == Motion::Still && surface.until >= scene.tick && surface.belt == 0.0);
        if !rests {
            return false;
        }
        called(Part::Direct);
        self.clear_buffers();
        if !(0..self.movable as u32).all(|i| self.items[i as usize].known || self.touches_the_same(scene, i)) {
            return false;
        }
        for i in 0..self.movable {
            self.renew_law(scene, i);
            let item = &self.items[i];
            self.free[i] = scene.media.acceleration(&item.body, &item.law, item.body.position, item.body.velocity);
            self.solved[i] = self.free[i];
        }
        if !self.solve_rest() {
            return false;
        }
        for item in &mut self.items {
            (item.known, item.since, item.until) = (true, scene.tick, scene.tick);
            item.motion = Motion::Still;
        }
        true
    }

    /// Solves what the contacts have to carry. Returns whether everything rests then; if not, they are as they were.
    fn solve_rest(&mut self) -> bool {
        self.trial.clone_from(&self.contacts);
        for contact in &mut self.trial {
            *contact = Contact { slides: 0.0, normal: 0.0, friction: 0.0, closed: true, lasts: true, ..*contact };
        }
        self.trial.sort_unstable_by_key(Contact::ends);
        let parts = Parts { masses: &self.masses, free: &self.free };
        self.reactions.accelerate(&mut self.trial, &parts, &mut self.solved);
        if !self.reactions.joined.squeezed.is_empty() || self.solved.iter().any(|a| *a != DVec2::ZERO) {
            return false;
        }
        std::mem::swap(&mut self.contacts, &mut self.trial);
        true
    }

    /// Whether a body touches exactly what it is in contact with.
    fn touches_the_same(&mut self, scene: &Scene, i: u32) -> bool {
        let (mut found, mine) = (0, self.items[i as usize].body.bounds());
        for j in 0..self.items.len() as u32 {
            if j == i || !mine.touches(&self.items[j as usize].body.bounds(), SLOP) {
                continue;
            }
            let Some(now) = self.contact_now(scene, i, j) else { continue };
            let like = |known: &Contact| {
                let rubs = (known.static_friction, known.kinetic_friction) == (now.static_friction, now.kinetic_friction);
                (known.lo, known.hi, known.axis) == (now.lo, now.hi, now.axis) && rubs && known.slides == 0.0
            };
            if !self.contacts.iter().any(like) {
                return false;
            }
            found += 1;
        }
        self.contacts.iter().filter(|contact| contact.has(i)).count() == found
    }
}
