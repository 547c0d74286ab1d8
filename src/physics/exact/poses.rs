//! The present instant: poses of items, and contacts of two of them.

use crate::physics::data::{Contact, SLOP, SPEED_ROUNDING, Sides};
use crate::physics::exact::{events::Events, events::Scene, item::Item};
use glam::DVec2;

impl Events {
    pub(crate) fn concern(&mut self, item: u32) {
        if self.is_body(item) && !self.is_concerned[item as usize] {
            self.is_concerned[item as usize] = true;
            self.concerned.push(item);
        }
    }

    pub(crate) fn concern_partners(&mut self, item: u32) {
        for index in 0..self.contacts.len() {
            if self.contacts[index].has(item) {
                self.concern(self.contacts[index].other(item));
            }
        }
        for body in 0..self.movable as u32 {
            if self.items[body as usize].train.is_some_and(|train| train.members.contains(&item)) {
                self.concern(body);
            }
        }
    }

    pub(crate) fn concern_linked(&mut self, body: u32) {
        let Item { id, linked, .. } = self.items[body as usize];
        for at in 0..if linked { self.links.len() } else { 0 } {
            let def = self.links[at].def;
            for end in def.ends().filter(|end| def.has(id) && end.0 != id) {
                if let Ok(other) = self.items[..self.movable].binary_search_by_key(&end.0, |item| item.id) {
                    self.concern(other as u32);
                }
            }
        }
    }

    /// The contacts of an item as they were indexed last.
    pub(crate) fn contacts_of(&self, item: u32) -> impl Iterator<Item = &Contact> {
        self.incident.of(item as usize).iter().map(|index| &self.contacts[*index as usize])
    }

    pub(crate) fn release(&mut self) {
        self.concerned.drain(..).for_each(|item| self.is_concerned[item as usize] = false);
        self.touching.clear();
        self.met = None;
        self.is_placed.fill(false);
    }

    pub(crate) fn is_body(&self, item: u32) -> bool {
        (item as usize) < self.movable
    }

    pub(crate) fn speed(&self, item: u32) -> DVec2 {
        self.speeds[item as usize]
    }

    pub(crate) fn stands(&self, surface: u32) -> bool {
        self.speed(surface) == DVec2::ZERO && self.free[surface as usize] == DVec2::ZERO
    }

    /// What a belt adds to the velocity of `hi` relative to `lo` along a contact's face, m/s.
    pub(crate) fn skin_of(&self, contact: &Contact) -> f64 {
        if self.is_body(contact.hi) { -contact.skin } else { contact.skin }
    }

    /// How fast `hi` slides over `lo`, m/s.
    pub(crate) fn sliding(&self, contact: &Contact) -> f64 {
        (self.speed(contact.hi) - self.speed(contact.lo))[1 - contact.axis] + self.skin_of(contact)
    }

    pub(crate) fn contact_along(&self, lo: u32, hi: u32, axis: usize) -> Contact {
        let (first, second) = (&self.items[lo.min(hi) as usize], &self.items[lo.max(hi) as usize]);
        let on_surface = !self.is_body(lo.max(hi));
        let mut contact = Contact::between(lo, hi, axis);
        contact.rub_with(first.body.coefficients().with(second.body.coefficients(), on_surface));
        if on_surface {
            // Clockwise: the top runs to the right, the right side down.
            contact.skin = if (axis == 1) == (lo < hi) { second.belt } else { -second.belt };
        }
        contact
    }

    pub(crate) fn locate(&mut self, scene: &Scene, item: usize) -> DVec2 {
        if !self.is_placed[item] {
            (self.places[item], self.speeds[item]) = self.items[item].pose(scene.media, self.now);
            self.is_placed[item] = true;
            if item >= self.movable {
                (self.free[item], self.solved[item]) = (self.items[item].solved, self.items[item].solved);
            }
        }
        self.places[item]
    }

    /// The contact of two items whose gap along an axis is at most the slop: along that along which they overlap less, and on solid sides only.
    pub(crate) fn contact_now(&mut self, scene: &Scene, a: u32, b: u32) -> Option<Contact> {
        let (a, b) = (a.min(b), a.max(b));
        let apart = self.locate(scene, b as usize) - self.locate(scene, a as usize);
        let gap = apart.abs() - (self.items[a as usize].body.half + self.items[b as usize].body.half);
        let axis = usize::from(gap.x <= gap.y);
        if gap[axis] > SLOP || gap[1 - axis] >= -SLOP {
            return None;
        }
        let sides = self.items[b as usize].sides;
        if sides != Sides::ALL && (!sides.face(axis, apart[axis] <= 0.0) || gap[axis] < -SLOP) {
            return None;
        }
        let (lo, hi) = if apart[axis] > 0.0 { (a, b) } else { (b, a) };
        Some(Contact { closed: gap[axis] <= 0.0, ..self.contact_along(lo, hi, axis) })
    }

    /// Differences of the speeds of two things up to which they are rounding, along each axis, m/s.
    pub(crate) fn speed_rounding(&self, contact: &Contact) -> DVec2 {
        (self.speed(contact.lo).abs() + self.speed(contact.hi).abs()) * SPEED_ROUNDING
    }

    pub(crate) fn approach(&self, contact: &Contact) -> f64 {
        (self.speed(contact.lo) - self.speed(contact.hi))[contact.axis]
    }

    /// The share of a change of relative velocity that each of two items takes: the other's fraction of the mass; a surface takes none.
    pub(crate) fn shares(&self, a: usize, b: usize) -> [f64; 2] {
        if a >= self.movable || b >= self.movable {
            return [a, b].map(|item| if item < self.movable { 1.0 } else { 0.0 });
        }
        let (of_a, of_b) = (self.items[a].body.mass, self.items[b].body.mass);
        [of_b / (of_a + of_b), of_a / (of_a + of_b)]
    }
}
