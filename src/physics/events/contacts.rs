//! What touches what at an event: contacts begin, last and end, and what meets is brought exactly together.

use super::{Events, Item, Scene, WORK_OF_A_CONTACT, WORK_OF_A_LOOK, WORK_OF_AN_ITEM};
use crate::physics::Aabb;
use crate::physics::contact::Contact;
use crate::physics::reactions::Parts;
use crate::physics::tuning::{MAX_CLINGS, MICRO_SPEED, SLOP, SPEED_ROUNDING, SPEED_TOLERANCE};

/// Steps of Newton's method for the time at which two motions meet.
const POLISH: u32 = 4;
/// Halvings of a time, at most, where it does not end.
const HALVINGS: u32 = 64;
/// m. A gap of bodies that have met is left if it is smaller than this.
const CLOSED: f64 = 1e-12;
/// m. What is deeper in something than this did not get there by rounding.
const DEEP: f64 = 1e-5;

impl Events {
    /// Lists what touches anything concerned, and counts to that whatever is joined to it by touching.
    pub(super) fn collect(&mut self, scene: &Scene, hit: Option<Contact>) {
        self.touching.clear();
        let mut next = 0;
        while next < self.concerned.len() {
            let i = self.concerned[next];
            next += 1;
            self.locate(scene, i as usize);
            // What it was in contact with until now has to know even if that is over.
            for index in 0..self.contacts.len() {
                let contact = self.contacts[index];
                if contact.has(i) {
                    self.concern(contact.other(i));
                }
            }
            let bounds = Aabb::around(self.places[i as usize], self.items[i as usize].body.half);
            let mut near = std::mem::take(&mut self.near);
            self.lanes.touching(&bounds, &mut near);
            for &j in &near {
                let looked_at = || self.concerned[..next].contains(&j);
                if j == i || !self.may_touch(&bounds, j as usize) || looked_at() {
                    continue;
                }
                let met = hit.filter(|contact| contact.is_of(i, j));
                if let Some(contact) = met.or_else(|| self.contact_now(scene, i, j)) {
                    self.concern(j);
                    self.locate(scene, j as usize);
                    let contact = self.touch(scene, contact, met.is_some());
                    if !contact.lasts && met.is_none() && self.is_in(&contact) {
                        self.close(scene, &contact);
                    }
                    self.touching.push(contact);
                }
            }
            self.near = near;
        }
        self.concerned.sort_unstable();
        self.touching.sort_unstable_by_key(Contact::ends);
        self.work += (WORK_OF_AN_ITEM + WORK_OF_A_LOOK * self.items.len() as u64) * self.concerned.len() as u64;
    }

    /// Whether two things that meet are in each other by more than the slop: something else happened on the rest of a way that was foreseen
    /// roughly.
    fn is_in(&self, contact: &Contact) -> bool {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let reach = self.items[lo].body.half[axis] + self.items[hi].body.half[axis];
        self.places[hi][axis] - self.places[lo][axis] - reach < -SLOP
    }

    /// Whether an item may touch a box now.
    fn may_touch(&self, bounds: &Aabb, item: usize) -> bool {
        let track = &self.tracks[item];
        bounds.touches(&track.swept, SLOP) && (!track.is_exact() || bounds.touches(&track.bounds_at(self.now), SLOP))
    }

    /// What is known of two things that touch now.
    fn touch(&mut self, scene: &Scene, mut contact: Contact, met: bool) -> Contact {
        contact.lasts = self.contacts.iter().any(|known| known.is_of(contact.lo, contact.hi));
        contact.closed |= contact.lasts || met;
        // What has just come together by a hair's breadth has done so, whatever pulls at it alone.
        let grazes = met && (-MICRO_SPEED..=0.0).contains(&self.approach(&contact));
        contact.clings = grazes || self.clings(scene, &contact);
        if contact.clings {
            for item in [contact.lo, contact.hi] {
                self.items[item as usize].clung += 1;
                self.guards.clinging_given_up += u64::from(self.items[item as usize].clung == MAX_CLINGS + 1);
            }
        }
        contact
    }

    /// Keeps those of the touching pairs as contacts that neither part nor (impacts are over by now) approach. Of the pair that has just
    /// `met` only the impact was along the axis in which it met.
    pub(super) fn find_contacts(&mut self, scene: &Scene, met: Option<Contact>) {
        let is_concerned = &self.is_concerned;
        self.contacts.retain(|contact| {
            let concerned = |item: u32| is_concerned[item as usize];
            !(concerned(contact.lo) || concerned(contact.hi))
        });
        let kept = self.contacts.len();
        for index in 0..self.touching.len() {
            let mut contact = self.touching[index];
            if met.is_some_and(|met| met.is_of(contact.lo, contact.hi)) {
                match self.contact_now(scene, contact.lo, contact.hi) {
                    Some(again) => contact = again,
                    None => continue,
                }
            }
            if self.stays(&contact) {
                let slides = self.slides(&contact);
                let fresh = Contact { closed: true, lasts: true, clings: false, lossy_hits: 0, ..contact };
                self.contacts.push(Contact { slides, normal: 0.0, friction: 0.0, ..fresh });
            }
        }
        self.work += WORK_OF_A_CONTACT * (self.contacts.len() - kept) as u64;
    }

    /// Whether the ends of a contact neither part nor approach, but for rounding.
    pub(super) fn stays(&self, contact: &Contact) -> bool {
        self.approach(contact).abs() <= self.speed_rounding(contact)[contact.axis]
    }

    /// Whether a contact presses on a surface that moves: the sums of many ticks leave them some roundings apart.
    pub(super) fn rides(&self, contact: &Contact) -> bool {
        let surface = contact.lo.max(contact.hi);
        contact.normal > 0.0 && !self.is_body(surface) && !self.stands(surface) && self.approach(contact).abs() <= SPEED_TOLERANCE
    }

    /// Which way a contact slides now: a speed that is nothing but rounding is none.
    pub(super) fn slides(&self, contact: &Contact) -> f64 {
        let along = 1 - contact.axis;
        let sliding = self.sliding(contact);
        let rounding = self.speed_rounding(contact)[along] + SPEED_ROUNDING * contact.skin.abs();
        if sliding.abs() <= rounding { 0.0 } else { sliding.signum() }
    }

    /// Moves the contacts of what is concerned into `trial`.
    pub(super) fn take_contacts_of_concerned(&mut self) {
        self.trial.clear();
        let (is_concerned, trial) = (&self.is_concerned, &mut self.trial);
        self.contacts.retain(|contact| {
            let concerned = is_concerned[contact.lo as usize] || is_concerned[contact.hi as usize];
            if concerned {
                trial.push(*contact);
            }
            !concerned
        });
        // The order decides about the last bits of an answer.
        trial.sort_unstable_by_key(Contact::ends);
    }

    /// Brings two things to the instant at which they meet, and exactly together: a way foreseen as a cubic may be off by a hair, so Newton's
    /// method ends on the motions themselves. What is left of the gap is shared as their masses say; a surface gives way to nothing. Returns
    /// false if they meet so much later that something else happens before: then they have to be looked at again from here.
    pub(super) fn put_together(&mut self, scene: &Scene, contact: &Contact) -> bool {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let reach = self.items[lo].body.half[axis] + self.items[hi].body.half[axis];
        if !(self.tracks[lo].is_exact() && self.tracks[hi].is_exact()) {
            let begin = self.items[lo].since.max(self.items[hi].since);
            let others = self.nexts.iter().enumerate().filter(|(k, next)| *k != lo && *k != hi && !self.is_void(next));
            let others = others.map(|(_, next)| next.at);
            let end = others.fold(self.items[lo].until.min(self.items[hi].until).min(scene.tick), f64::min);
            for _ in 0..POLISH {
                let (a, b) = (self.items[lo].pose(scene.media, self.now), self.items[hi].pose(scene.media, self.now));
                let (gap, closing) = (b.0[axis] - a.0[axis] - reach, a.1[axis] - b.1[axis]);
                let next = self.now + gap / closing;
                // Where they only graze, Newton's method would run off to the moment at which they parted.
                if closing <= 0.0 || next < begin || next == self.now {
                    break;
                }
                if next > end {
                    return gap <= SLOP;
                }
                self.now = next;
            }
            self.bracket(scene, contact, reach);
        }
        self.close(scene, contact);
        true
    }

    /// Takes away the gap, or the overlap, that the roughness of a foreseen way has left of two things that meet now: shared as their masses
    /// say; a surface gives way to nothing.
    fn close(&mut self, scene: &Scene, contact: &Contact) {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let reach = self.items[lo].body.half[axis] + self.items[hi].body.half[axis];
        let gap = self.locate(scene, hi)[axis] - self.locate(scene, lo)[axis] - reach;
        let weight = |item: usize| if item < self.movable { 1.0 / self.items[item].body.mass } else { 0.0 };
        let (of_lo, of_hi) = (weight(lo), weight(hi));
        if gap < -DEEP && !self.were_apart(scene, contact, reach) {
            // They began in each other: nothing is put right at a stroke.
        } else if of_lo == 0.0 || of_hi == 0.0 {
            let (body, ground, side) = if of_lo == 0.0 { (hi, lo, 1.0) } else { (lo, hi, -1.0) };
            self.places[body][axis] = self.places[ground][axis] + side * reach;
            if gap < -CLOSED {
                self.lift_load(scene, body as u32, axis, -side * gap);
            }
        } else if gap.abs() > CLOSED {
            self.places[lo][axis] += gap * (of_lo / (of_lo + of_hi));
            self.places[hi][axis] -= gap * (of_hi / (of_lo + of_hi));
        }
    }

    /// Whether two things were not in each other where their ways began.
    fn were_apart(&self, scene: &Scene, contact: &Contact, reach: f64) -> bool {
        let (lo, hi) = (&self.items[contact.lo as usize], &self.items[contact.hi as usize]);
        let at = lo.since.max(hi.since);
        let place = |item: &Item| item.pose(scene.media, at).0[contact.axis];
        at < self.now && place(hi) - place(lo) - reach >= -SLOP
    }

    /// Where Newton's method has ended with two things in each other: halves the time between the last event, when they were not, and now,
    /// until they are not by more than the slop.
    fn bracket(&mut self, scene: &Scene, contact: &Contact, reach: f64) {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let gap = |events: &Self, at: f64| {
            let place = |item: usize| events.items[item].pose(scene.media, at).0[axis];
            place(hi) - place(lo) - reach
        };
        let mut apart = self.items.iter().map(|item| item.since).fold(0.0, f64::max);
        if apart >= self.now || gap(self, self.now) >= -SLOP || gap(self, apart) < 0.0 {
            return;
        }
        let mut met = self.now;
        for _ in 0..HALVINGS {
            self.work += WORK_OF_AN_ITEM;
            let middle = 0.5 * (apart + met);
            let between = gap(self, middle);
            if between >= -SLOP {
                apart = middle
            } else {
                met = middle
            }
            if between.abs() <= SLOP {
                break;
            }
        }
        self.now = apart;
    }

    /// What lies on a body that has been put out of a surface goes with it by as much (m, along `axis`), and so does what lies on that: it
    /// would be left in it, a little deeper each time.
    fn lift_load(&mut self, scene: &Scene, body: u32, axis: usize, way: f64) {
        let (mut carrier, mut next) = (body, self.concerned.len());
        loop {
            for index in 0..self.contacts.len() {
                let contact = self.contacts[index];
                let (below, above) = if way > 0.0 { (contact.lo, contact.hi) } else { (contact.hi, contact.lo) };
                let lies = contact.axis == axis && below == carrier && self.is_body(above) && !self.is_concerned[above as usize];
                if lies {
                    self.concern(above);
                    self.locate(scene, above as usize);
                    self.places[above as usize][axis] += way;
                }
            }
            let Some(&above) = self.concerned.get(next) else { return };
            (carrier, next) = (above, next + 1);
        }
    }

    /// Ends a slide: what stops and whatever moves with it has one speed along the face from now on.
    pub(super) fn stop_slide(&mut self, scene: &Scene, a: u32, b: u32) {
        let Some(stopped) = self.contacts.iter().find(|contact| contact.is_of(a, b)).copied() else { return };
        let mut next = 0;
        while next < self.concerned.len() {
            let item = self.concerned[next];
            self.locate(scene, item as usize);
            next += 1;
            for index in 0..self.contacts.len() {
                let contact = self.contacts[index];
                if contact.has(item) {
                    self.concern(contact.other(item));
                    self.locate(scene, contact.other(item) as usize);
                }
            }
        }
        self.take_contacts_of_concerned();
        self.before.clone_from(&self.speeds);
        let parts = Parts { masses: &self.masses, free: &self.before, grounds: &self.ground_speeds };
        self.reactions.merge_speeds(&stopped, &self.trial, &parts, &mut self.speeds);
        self.contacts.append(&mut self.trial);
    }
}
