//! The end of a tick: its contacts and accelerations, with which the next tick begins.

use crate::physics::data::{Contact, Pose, SLOP, SPEED_ROUNDING, SPEED_TOLERANCE};
use crate::physics::exact::events::{Events, Scene};
use crate::physics::{contact::axis::Parts, exact::item::Travel, forces::link::links_on};
use glam::DVec2;

impl Events {
    pub(crate) fn end_of(&self, id: u32) -> Pose {
        if let Ok(at) = self.items[..self.movable].binary_search_by_key(&id, |item| item.id) {
            return (self.places[at], self.speeds[at]);
        }
        self.ends.iter().find(|end| end.0 == id).map(|end| end.1).unwrap_or_default()
    }

    /// Solves contacts and accelerations where media have changed them since the last path began.
    pub(crate) fn settle(&mut self, scene: &Scene) {
        self.is_placed.fill(false);
        (0..self.items.len()).for_each(|i| _ = self.locate(scene, i));
        self.end_contacts(scene);
        for i in 0..self.movable {
            if self.has_another_law(scene, i) {
                self.renew_law(scene, i);
                self.concern(i as u32);
            }
        }
        let solves = self.contacts.iter().any(|contact| self.changes(contact.lo) || self.changes(contact.hi));
        for i in 0..self.movable {
            let changes = self.changes(i as u32);
            let item = &mut self.items[i];
            if changes || solves {
                self.free[i] = scene.media.acceleration(&item.body, &item.law, item.body.position, item.body.velocity);
            }
            if changes {
                (item.solved, self.solved[i]) = (self.free[i], self.free[i]);
            }
        }
        if solves {
            self.contacts.sort_unstable_by_key(Contact::ends);
            self.reactions.accelerate(&mut self.contacts, &Parts { masses: &self.masses, free: &self.free }, &mut self.solved);
            self.items[..self.movable].iter_mut().zip(&self.solved).for_each(|(item, solved)| item.solved = *solved);
        }
        self.release();
    }

    /// Ends the contacts whose ends media have parted since their last event, and turns the slides that media have turned.
    fn end_contacts(&mut self, scene: &Scene) {
        for index in (0..self.contacts.len()).rev() {
            let contact = self.contacts[index];
            let slides = self.slides(&contact);
            let parts = !(self.stays(&contact) || self.rides(&contact));
            if parts {
                self.trial.push(self.contacts.remove(index));
                contact.pair().iter().for_each(|item| self.items[*item as usize].known = false);
            }
            let rate = |item: u32| self.items[item as usize].solved[1 - contact.axis];
            // What friction drives back has stopped just now; what has given way just now is driven on.
            let stops = slides == 0.0 && contact.slides * (rate(contact.hi) - rate(contact.lo)) < 0.0;
            let turns = stops || slides != 0.0 && slides != contact.slides;
            if turns && !parts {
                self.contacts[index].slides = slides;
            }
            if parts || turns {
                // What else they touch carries something else now.
                contact.pair().into_iter().for_each(|item| self.concern(item));
            }
        }
        self.list_ends(scene, true);
        self.trial.clear();
    }

    /// Whether another law acts on a body than on its last path: it crossed a border, its links pull otherwise, or other liquids are near.
    fn has_another_law(&mut self, scene: &Scene, i: usize) -> bool {
        // A link that broke in this tick pulls no more.
        let linked = !self.links.is_empty() || self.items[i].link != DVec2::ZERO;
        let pulled = linked || !self.streams.is_empty();
        if linked {
            self.items[i].link = links_on(&self.links, self.items[i].id, |id| self.end_of(id));
        }
        let item = &self.items[i];
        pulled && scene.media.constant(&item.body, self.force_on(scene, i)) != item.law.constant
            || !scene.media.fluids.is_empty() && !item.law.displaced.near.contains(&item.body.bounds(), 0.0)
    }

    /// Gives all that rides on a moving surface its place and its speed exactly: over many ticks roundings would lead them apart.
    pub(crate) fn follow_surfaces(&mut self) {
        if self.items[self.movable..].iter().all(|surface| surface.motion == Travel::Still) {
            return;
        }
        for index in 0..self.contacts.len() {
            let (body, surface) = self.contacts[index].ends();
            if !self.is_body(surface) {
                self.follow(index, body);
            }
        }
        let mut next = 0;
        while let Some(&carrier) = self.concerned.get(next) {
            next += 1;
            for index in 0..self.contacts.len() {
                let contact = &self.contacts[index];
                if contact.has(carrier) && self.is_body(contact.ends().1) {
                    self.follow(index, contact.other(carrier));
                }
            }
        }
        self.release();
    }

    fn follow(&mut self, index: usize, body: u32) {
        let contact = self.contacts[index];
        let (axis, along, carrier) = (contact.axis, 1 - contact.axis, contact.other(body));
        if self.is_concerned[body as usize] || contact.normal <= 0.0 {
            return;
        }
        let side = if contact.hi == body { 1.0 } else { -1.0 };
        let of = &self.items[carrier as usize].body;
        let (mut velocity, reach) = (of.velocity, of.half + self.items[body as usize].body.half);
        let place = of.position[axis] + side * reach[axis];
        velocity[along] += contact.skin;
        let item = &mut self.items[body as usize].body;
        let off = (item.velocity - velocity).abs();
        let rounding = (item.velocity.abs() + velocity.abs()) * SPEED_ROUNDING + SPEED_TOLERANCE;
        // Each of its paths in this tick began where the one before ended, to a rounding of the coordinate.
        let strayed = SLOP + f64::EPSILON * place.abs() * f64::from(self.ways[body as usize]);
        if off[axis] > rounding[axis] || (item.position[axis] - place).abs() > strayed {
            return;
        }
        (item.velocity[axis], item.position[axis]) = (velocity[axis], place);
        if contact.slides == 0.0 && off[along] <= rounding[along] {
            item.velocity[along] = velocity[along];
        }
        self.concern(body);
    }

    fn changes(&self, item: u32) -> bool {
        let of = &self.items[item as usize];
        self.is_concerned[item as usize] || !of.law.is_constant() && of.motion != Travel::Still
    }
}
