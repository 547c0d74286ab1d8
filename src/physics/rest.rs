//! What rests: groups of bodies in which nothing moves stay as they were solved, and cost nothing until something touches them.
//!
//! A group is what contacts join. It goes to rest after a tick in which none of its bodies moved, and wakes when the drive of one of them
//! changes or when something that is awake touches one of them: before that instant nothing that happens can reach it, because its
//! acceleration is zero and forces pass through contacts only. What surrounds a body (surfaces, streams, liquids) never changes.
//! A crowd, and a world without direct answers, wakes as a whole.

use super::World;
use super::contacts::Contact;
use super::interval::Motion;
use super::tuning::SLOP;

impl World {
    /// Wakes a body with all that rests with it.
    pub(super) fn wake(&mut self, body: u32) {
        if self.crowd.is_some() {
            self.awake.clear();
            self.awake.extend(0..self.bodies.len() as u32);
            return;
        }
        if !self.resting[body as usize] {
            return;
        }
        if !self.plan.direct {
            (0..self.bodies.len() as u32).for_each(|body| self.wake_one(body));
            return self.sort_contacts();
        }
        self.wake_one(body);
        let mut found = true;
        while found {
            found = false;
            for index in 0..self.resting_contacts.len() {
                let pair = self.resting_contacts[index].pair;
                let (a, b) = (self.rests(pair.a), self.rests(pair.b));
                let joins = !(self.immovable(pair.b) || a == b);
                if joins {
                    self.wake_one(if a { pair.a } else { pair.b });
                    found = true;
                }
            }
        }
        self.awake.sort_unstable();
        self.sort_contacts();
    }

    /// Wakes what rests and is touched by something that is awake.
    pub(super) fn wake_what_is_touched(&mut self, hit: Option<Contact>) {
        if self.awake.len() == self.bodies.len() {
            return;
        }
        let mut index = 0;
        while let Some(&pair) = self.candidates.live.get(index) {
            index += 1;
            let Some(body) = [pair.a, pair.b].into_iter().find(|&item| self.rests(item)) else { continue };
            if hit.is_some_and(|contact| contact.pair == pair) || self.contact(pair, SLOP).is_some() {
                self.wake(body);
                // The list is another one now.
                index = 0;
            }
        }
    }

    fn wake_one(&mut self, body: u32) {
        let i = body as usize;
        self.resting[i] = false;
        self.awake.push(body);
        (self.hits[i], self.clung[i], self.crossings[i]) = (0, 0, 0);
    }

    /// Whether an item is a body at rest.
    pub(super) fn rests(&self, item: u32) -> bool {
        self.resting.get(item as usize).is_some_and(|&resting| resting)
    }

    /// Hands each contact to those of what rests or of what is awake, and lists the pairs anew.
    fn sort_contacts(&mut self) {
        let mut all = std::mem::take(&mut self.found);
        all.clear();
        all.append(&mut self.contacts);
        all.append(&mut self.resting_contacts);
        all.sort_unstable_by_key(|contact: &Contact| contact.pair);
        for contact in all.drain(..) {
            let list = if self.rests(contact.pair.a) { &mut self.resting_contacts } else { &mut self.contacts };
            list.push(contact);
        }
        self.found = all;
        self.answer_holds = false;
        self.list_live_pairs();
    }

    /// Lets every group rest in which nothing moved during the tick; without direct answers all of them or none.
    pub(super) fn put_to_rest(&mut self) {
        let mut some = false;
        for &body in &self.awake {
            let i = body as usize;
            let rests = self.motions[i] == Motion::Still && self.previous[i] == self.bodies[i].position;
            self.resting[i] = rests;
            some |= rests;
        }
        let mut found = some;
        while found {
            found = false;
            for index in 0..self.contacts.len() {
                let pair = self.contacts[index].pair;
                if !self.immovable(pair.b) && self.rests(pair.a) != self.rests(pair.b) {
                    self.resting[pair.a as usize] = false;
                    self.resting[pair.b as usize] = false;
                    found = true;
                }
            }
        }
        if !self.plan.direct && !self.resting.iter().all(|&rests| rests) {
            self.resting.fill(false);
        }
        let before = self.awake.len();
        let resting = &self.resting;
        self.awake.retain(|&body| !resting[body as usize]);
        if self.awake.len() != before {
            self.sort_contacts();
        }
    }
}
