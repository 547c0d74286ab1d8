//! Contacts at an event: they begin, last and end, and the two are brought exactly together.

use crate::physics::data::{Aabb, Contact, MAX_CLINGS, MICRO_SPEED, SLOP, SPEED_ROUNDING, SPEED_TOLERANCE, on_axis};
use crate::physics::{contact::axis::Parts, exact::events::Events, exact::events::Scene};

impl Events {
    /// Lists the contacts of all items concerned, and concerns all that these join.
    pub(crate) fn collect(&mut self, scene: &Scene) {
        self.touching.clear();
        self.incident.index(self.items.len(), self.contacts.iter().map(Contact::pair));
        let mut next = 0;
        while next < self.concerned.len() {
            let i = self.concerned[next];
            next += 1;
            self.end_train(scene, i as usize);
            self.locate(scene, i as usize);
            self.concern_linked(i);
            // What it was in contact with until now has to know even if that is over.
            for slot in self.incident.slots(i as usize) {
                self.concern(self.contacts[self.incident.list[slot] as usize].other(i));
            }
            let bounds = Aabb::around(self.places[i as usize], self.items[i as usize].body.half);
            for j in 0..self.items.len() as u32 {
                let looked_at = || self.concerned[..next].contains(&j);
                if j == i || !self.may_touch(&bounds, j as usize) || looked_at() {
                    continue;
                }
                let met = self.met.filter(|contact| contact.is_of(i, j));
                if let Some(contact) = met.or_else(|| self.contact_now(scene, i, j)) {
                    self.concern(j);
                    self.locate(scene, j as usize);
                    let contact = self.touch(scene, contact, met.is_some());
                    if !contact.lasts && met.is_none() && self.depth_of(&contact) > SLOP {
                        self.close(scene, &contact);
                    }
                    self.touching.push(contact);
                }
            }
        }
        self.concerned.sort_unstable();
        self.touching.sort_unstable_by_key(Contact::ends);
        self.count += self.concerned.len() as u64;
    }

    fn may_touch(&self, bounds: &Aabb, item: usize) -> bool {
        let track = &self.tracks[item];
        bounds.meets(&self.lanes[item])
            && bounds.touches(&track.swept, SLOP)
            && (!track.is_exact() || bounds.touches(&track.bounds_at(self.now), SLOP))
    }

    pub(super) fn touch(&mut self, scene: &Scene, mut contact: Contact, met: bool) -> Contact {
        contact.lasts = self.contacts_of(contact.lo).any(|known| known.has(contact.hi));
        contact.closed |= contact.lasts || met;
        // What has just come together by a hair's breadth has done so, whatever pulls at it alone.
        contact.clings = met && (-MICRO_SPEED..=0.0).contains(&self.approach(&contact)) || self.clings(scene, &contact);
        for item in contact.pair().into_iter().filter(|_| contact.clings) {
            self.items[item as usize].clung += 1;
            self.guards.clinging_given_up += u64::from(self.items[item as usize].clung == MAX_CLINGS + 1);
        }
        contact
    }

    /// Adds to what the contacts of items concerned, or all, have passed on in this tick.
    pub(crate) fn pass_on(&mut self, all: bool) {
        for contact in &mut self.contacts {
            let body = contact.ends().0 as usize;
            if (all || self.is_concerned[body]) && contact.normal > 0.0 {
                let t = self.now - self.items[body].since;
                let [normal, friction] = contact.passed;
                contact.passed = [normal + contact.normal * t, friction + contact.friction * t];
            }
        }
    }

    /// Lists what those of the `trial` contacts that have `ended` or press no more have passed on in this tick.
    pub(crate) fn list_ends(&mut self, scene: &Scene, ended: bool) {
        for index in 0..self.trial.len() {
            let contact = self.trial[index];
            let [normal, friction] = contact.passed;
            if normal > 0.0 && (ended || contact.normal == 0.0) {
                self.trial[index].passed = [0.0; 2];
                self.locate(scene, contact.ends().1 as usize);
                self.note(&contact, on_axis(contact.axis, normal, friction), None);
            }
        }
    }

    /// Lists what lasting contacts have passed on in this tick beyond their forces at its ends. Media change a force all the time.
    pub(crate) fn list_surplus(&mut self, scene: &Scene) {
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            let changes = |item: u32| !self.items[item as usize].law.is_constant() || self.items[item as usize].linked;
            if contact.normal <= 0.0 || changes(contact.lo) || changes(contact.hi) {
                continue;
            }
            let [pressed, rubbed] = contact.passed;
            let negligible = 1e-12 * contact.normal * scene.tick;
            let surplus = pressed - contact.normal * scene.tick;
            let (surplus, rubs) = if surplus > negligible {
                (surplus, rubbed - contact.friction * scene.tick)
            } else {
                let lasted = (pressed / contact.normal).max(0.0);
                let [least, most] = [contact.rubbed.min(contact.friction), contact.rubbed.max(contact.friction)];
                let rubs = rubbed - rubbed.clamp(least * lasted, most * lasted);
                // Of one that began within the tick a part of its push goes with that: no row leaves the cone of friction.
                let goes_with = surplus < -negligible && rubs != 0.0;
                (if goes_with { (rubs.abs() / contact.kinetic_friction).min(pressed) } else { 0.0 }, rubs)
            };
            if surplus > negligible || rubs.abs() > negligible {
                self.locate(scene, contact.ends().1 as usize);
                self.note(&contact, on_axis(contact.axis, surplus, rubs), None);
            }
        }
    }

    /// Keeps the touching pairs as contacts that neither part nor approach. The pair that has just `met` may touch along the other axis.
    pub(crate) fn find_contacts(&mut self, scene: &Scene) {
        self.take_contacts_of_concerned();
        for index in 0..self.touching.len() {
            let touching = self.touching[index];
            let met = self.met.is_some_and(|met| met.is_of(touching.lo, touching.hi));
            let now = if met { self.contact_now(scene, touching.lo, touching.hi) } else { Some(touching) };
            if let Some(contact) = now.filter(|contact| self.stays(contact)) {
                let slides = self.slides(&contact);
                let (passed, rubbed) = self.passed_by(&contact);
                let fresh = Contact { closed: true, lasts: true, clings: false, passed, rubbed, ..contact };
                self.contacts.push(Contact { slides, normal: 0.0, friction: 0.0, ..fresh });
            }
        }
        self.list_ends(scene, true);
    }

    /// What a contact has passed on so far in this tick, N·s, and its friction as the tick began, N.
    fn passed_by(&mut self, contact: &Contact) -> ([f64; 2], f64) {
        let known = self.trial.binary_search_by_key(&contact.ends(), Contact::ends);
        let known = known.ok().map(|at| &mut self.trial[at]).filter(|known| (known.lo, known.axis) == (contact.lo, contact.axis));
        known.map(|known| (std::mem::take(&mut known.passed), known.rubbed)).unwrap_or_default()
    }

    /// Whether the ends of a contact neither part nor approach, but for rounding.
    pub(crate) fn stays(&self, contact: &Contact) -> bool {
        self.approach(contact).abs() <= self.speed_rounding(contact)[contact.axis]
    }

    /// Whether a contact presses on a surface that moves: the sums of many ticks leave them some roundings apart.
    pub(crate) fn rides(&self, contact: &Contact) -> bool {
        let surface = contact.lo.max(contact.hi);
        contact.normal > 0.0 && !self.is_body(surface) && !self.stands(surface) && self.approach(contact).abs() <= SPEED_TOLERANCE
    }

    /// Which way a contact slides now: a speed that is nothing but rounding is none.
    pub(crate) fn slides(&self, contact: &Contact) -> f64 {
        let sliding = self.sliding(contact);
        let rounding = self.speed_rounding(contact)[1 - contact.axis] + SPEED_ROUNDING * contact.skin.abs();
        if sliding.abs() <= rounding { 0.0 } else { sliding.signum() }
    }

    pub(crate) fn take_contacts_of_concerned(&mut self) {
        let is_concerned = &self.is_concerned;
        let concerned = |contact: &mut Contact| is_concerned[contact.lo as usize] || is_concerned[contact.hi as usize];
        self.trial.clear();
        self.trial.extend(self.contacts.extract_if(.., concerned));
        // The order decides about the last bits of an answer.
        self.trial.sort_unstable_by_key(Contact::ends);
    }

    pub(crate) fn stop_slide(&mut self, scene: &Scene, a: u32, b: u32) {
        let Some(stopped) = self.contacts.iter().find(|contact| contact.is_of(a, b)).copied() else { return };
        let mut next = 0;
        while let Some(&item) = self.concerned.get(next) {
            self.locate(scene, item as usize);
            self.concern_partners(item);
            next += 1;
        }
        self.take_contacts_of_concerned();
        (0..self.trial.len()).for_each(|index| _ = self.locate(scene, self.trial[index].ends().1 as usize));
        self.before.clone_from(&self.speeds);
        let parts = Parts { masses: &self.masses, free: &self.before };
        self.reactions.joined.merge_speeds(&stopped, &self.trial, &parts, &mut self.speeds);
        self.contacts.append(&mut self.trial);
    }
}
