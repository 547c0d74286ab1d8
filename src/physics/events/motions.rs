//! What an event leaves behind: contacts, accelerations, and how everything concerned moves on.
//!
//! What flies follows its own flow. What is in contact moves with the accelerations that its contacts allow; these are constant unless media
//! act. Where they do, one body that slides on one surface follows the exact law of its slide; a group takes the mean acceleration of an
//! implicit midpoint step, which is stable at any rate: in `v′ = f − D·v − K·x` the step is one contact solve with the masses
//! M·(1 + ½hD + ¼h²K). So a group in a medium needs one more solve than one without, and its ways are parabolas as well.

use super::item::{Kind, Motion, Next, Slide};
use super::{Events, Implicit, Scene, WORK_OF_A_CONTACT, WORK_OF_AN_ITEM};
use crate::physics::contact::Contact;
use crate::physics::media::Law;
use crate::physics::reactions::Parts;
use crate::physics::tuning::{MAX_CLINGS, MICRO_SPEED, SLOP, SPEED_ROUNDING, SPEED_TOLERANCE};
use crate::physics::{Aabb, zones};
use glam::DVec2;

/// The rate × time up to which a cubic follows a flow through air. Larger: impacts in the midst of it are found off the way.
const CUBIC_REACH: f64 = 0.1;
/// The same near liquids, where each foresight costs many times as much.
const CUBIC_REACH_IN_LIQUID: f64 = 0.5;
/// How far beyond the end of a slide a mean acceleration reaches, as a part of its time: so that the end is found before.
const BEYOND_A_STOP: f64 = 1.25;
/// Steps of Newton's method for the time at which two motions meet.
const POLISH: u32 = 4;
/// m. A gap of bodies that have met is left if it is smaller than this.
const CLOSED: f64 = 1e-12;
/// m. What is deeper in something than this did not get there by rounding.
const DEEP: f64 = 1e-5;
/// The shortest part of a tick for which the way of something light in air is foreseen at once.
const SHORTEST: f64 = 1.0 / 256.0;
/// The same near liquids.
const SHORTEST_IN_LIQUID: f64 = 1.0 / 64.0;

/// s from now. How long the cubic of something in a medium follows its flow, for a rate of its change in 1/s.
fn reach_of_a_cubic(law: &Law, rate: f64, tick: f64) -> f64 {
    let (reach, shortest) =
        if law.is_near_liquid() { (CUBIC_REACH_IN_LIQUID, SHORTEST_IN_LIQUID) } else { (CUBIC_REACH, SHORTEST) };
    (reach / rate).max(tick * shortest)
}

impl Events {
    /// Looks at everything concerned anew: what touches it, its impacts, contacts, accelerations and motion.
    pub(super) fn look(&mut self, scene: &Scene, hit: Option<Contact>) {
        // Where a surface is stopped that would have squeezed something, other things concern it as well: each of them once.
        for _ in self.movable..=self.items.len() {
            self.halted = false;
            self.collect(scene, hit);
            self.resolve_impacts(scene);
            if !self.halted {
                self.settle_concerned(scene, hit);
            }
            if !self.halted {
                break;
            }
        }
        self.go_on(scene);
    }

    /// Lets everything concerned begin anew where it is now: its law, contacts and accelerations.
    fn settle_concerned(&mut self, scene: &Scene, hit: Option<Contact>) {
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            let (place, speed) = (self.places[i], self.speeds[i]);
            let item = &mut self.items[i];
            (item.body.position, item.body.velocity, item.since) = (place, speed, self.now);
            item.disturbed = true;
            if item.resume.is_some_and(|resume| resume.at <= self.now || speed[resume.axis] != 0.0) {
                item.resume = None;
            }
            self.renew_law(scene, i);
        }
        self.find_contacts(scene, hit);
        self.solve_concerned(scene);
    }

    /// Lists what touches anything concerned, and counts to that whatever is joined to it by touching.
    fn collect(&mut self, scene: &Scene, hit: Option<Contact>) {
        self.touching.clear();
        let mut next = 0;
        while next < self.concerned.len() {
            let i = self.concerned[next];
            next += 1;
            self.locate(scene, i as usize);
            // What it was in contact with until now has to know even if that is over.
            for index in 0..self.contacts.len() {
                let contact = self.contacts[index];
                if contact.lo == i || contact.hi == i {
                    self.concern(contact.other(i));
                }
            }
            let bounds = Aabb::around(self.places[i as usize], self.items[i as usize].body.half);
            for j in 0..self.items.len() as u32 {
                let looked_at = || self.concerned[..next].contains(&j);
                if j == i || !bounds.touches(&self.items[j as usize].swept, SLOP) || looked_at() {
                    continue;
                }
                let met = hit.filter(|contact| contact.is_of(i, j));
                if let Some(contact) = met.or_else(|| self.contact_now(scene, i, j)) {
                    self.concern(j);
                    self.locate(scene, j as usize);
                    let contact = self.touch(scene, contact, met.is_some());
                    self.touching.push(contact);
                }
            }
        }
        self.concerned.sort_unstable();
        self.touching.sort_unstable_by_key(Contact::ends);
        self.work += WORK_OF_AN_ITEM * self.concerned.len() as u64;
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

    /// The law of a body's motion from now on.
    pub(super) fn renew_law(&mut self, scene: &Scene, i: usize) {
        let item = &mut self.items[i];
        let mut force = item.drive;
        for &stream in &self.streams {
            let stream = &scene.media.streams[stream as usize];
            if zones::feels(&stream.zone, &item.body, (item.body.position, item.body.velocity)) {
                force += stream.force;
            }
        }
        item.law = scene.media.law(&item.body, force, scene.tick - self.now);
    }

    /// Keeps those of the touching pairs as contacts that neither part nor (impacts are over by now) approach. Of the pair that has just
    /// `met` only the impact was along the axis in which it met.
    fn find_contacts(&mut self, scene: &Scene, met: Option<Contact>) {
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
    fn stays(&self, contact: &Contact) -> bool {
        self.approach(contact).abs() <= self.speed_rounding(contact)[contact.axis]
    }

    /// Whether a contact presses on a surface that moves: the sums of many ticks leave them some roundings apart.
    fn rides(&self, contact: &Contact) -> bool {
        let surface = contact.lo.max(contact.hi);
        contact.normal > 0.0 && !self.is_body(surface) && !self.stands(surface) && self.approach(contact).abs() <= SPEED_TOLERANCE
    }

    /// Which way a contact slides now: a speed that is nothing but rounding is none.
    fn slides(&self, contact: &Contact) -> f64 {
        let along = 1 - contact.axis;
        let sliding = self.sliding(contact);
        let rounding = self.speed_rounding(contact)[along] + SPEED_ROUNDING * contact.skin.abs();
        if sliding.abs() <= rounding { 0.0 } else { sliding.signum() }
    }

    /// The accelerations of what is concerned, and what its contacts carry.
    pub(super) fn solve_concerned(&mut self, scene: &Scene) {
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            let item = &self.items[i];
            self.free[i] = scene.media.acceleration(&item.body, &item.law, item.body.position, item.body.velocity);
            self.solved[i] = self.free[i];
        }
        self.take_contacts_of_concerned();
        let parts = Parts { masses: &self.masses, free: &self.free, grounds: &self.ground_pulls };
        self.reactions.accelerate(&mut self.trial, &parts, &mut self.solved);
        let solved = std::mem::take(&mut self.trial);
        self.stop_surfaces(scene, &solved, |events, surface| events.ground_pulls[surface as usize - events.movable]);
        self.trial = solved;
        self.contacts.append(&mut self.trial);
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            self.items[i].solved = self.solved[i];
        }
    }

    /// Moves the contacts of what is concerned into `trial`.
    fn take_contacts_of_concerned(&mut self) {
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

    /// Sets everything concerned on its way, and seeks what happens to it next.
    pub(super) fn go_on(&mut self, scene: &Scene) {
        self.choose_motions(scene);
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            let item = &mut self.items[i];
            item.foresee(scene.media);
            if !item.searched.contains(&item.swept, 0.0) {
                self.grown = true;
            }
        }
        for i in 0..self.items.len() {
            let stopped_now = |item: usize| self.items[item].stops_at == self.now;
            let stale = match self.items[i].next.kind {
                Kind::Hit { other, .. } | Kind::Stop { other } => self.is_concerned[other as usize] || stopped_now(other as usize),
                Kind::Edge => true,
                _ => false,
            };
            if stale || stopped_now(i) || self.is_concerned[i] {
                self.predict(scene, i);
            }
        }
    }

    /// How everything concerned moves from now on.
    fn choose_motions(&mut self, scene: &Scene) {
        let left = scene.tick - self.now;
        self.take_contacts_of_concerned();
        let mut coupled = false;
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            let in_media = !self.items[i].law.is_constant();
            let mut touching = self.trial.iter().filter(|contact| contact.lo as usize == i || contact.hi as usize == i);
            let (first, more) = (touching.next().copied(), touching.next().is_some());
            let at_rest = self.speeds[i] == DVec2::ZERO && self.solved[i] == DVec2::ZERO;
            let slide = first.filter(|_| in_media && !more && !at_rest).and_then(|contact| self.slide_of(i, &contact));
            let item = &mut self.items[i];
            (item.mean, item.until, item.slide) = (self.solved[i], scene.tick, slide);
            item.motion = match first {
                _ if at_rest => Motion::Still,
                Some(_) if slide.is_some() => Motion::Slide,
                None if in_media => Motion::Flow,
                Some(_) | None => Motion::Parabola,
            };
            coupled |= first.is_some() && in_media && item.motion == Motion::Parabola;
            if matches!(item.motion, Motion::Flow | Motion::Slide) {
                let rate = scene.media.rate(&item.body, &item.law, item.body.velocity);
                item.until = (self.now + reach_of_a_cubic(&item.law, rate, scene.tick)).min(scene.tick);
            }
        }
        if coupled && left > 0.0 {
            let h = self.while_slides_last(left);
            self.take_mean_accelerations(scene, h);
            for k in 0..self.concerned.len() {
                let item = &mut self.items[self.concerned[k] as usize];
                if item.motion == Motion::Parabola {
                    item.until = item.until.min(self.now + h);
                }
            }
        }
        self.contacts.append(&mut self.trial);
    }

    /// How long a mean acceleration may be taken for, of `left` seconds: what a heavy load brakes stands soon, and friction acts no longer.
    fn while_slides_last(&self, left: f64) -> f64 {
        let rate = |item: u32, along: usize| {
            let i = item as usize;
            if i < self.movable { self.solved[i][along] } else { self.ground_pulls[i - self.movable][along] }
        };
        let ends = self.trial.iter().filter(|contact| contact.slides != 0.0).map(|contact| {
            let along = 1 - contact.axis;
            let braking = contact.slides * (rate(contact.lo, along) - rate(contact.hi, along));
            if braking > 0.0 { BEYOND_A_STOP * contact.slides * self.sliding(contact) / braking } else { f64::INFINITY }
        });
        ends.filter(|&end| end > 0.0).fold(left, f64::min)
    }

    /// The slide of a body that touches nothing but one surface which does not speed up, if it is one.
    fn slide_of(&self, i: usize, contact: &Contact) -> Option<Slide> {
        let surface = contact.other(i as u32);
        if self.is_body(surface) || self.ground_pulls[surface as usize - self.movable] != DVec2::ZERO {
            return None;
        }
        let away = if contact.hi as usize == i { 1.0 } else { -1.0 };
        let slides = contact.normal > 0.0 && contact.slides != 0.0;
        slides.then_some(Slide { axis: contact.axis, away, friction: away * contact.slides * contact.kinetic_friction })
    }

    /// The mean accelerations of what is in contact in media, for the next `h` seconds: an implicit midpoint step, with linearised forces and
    /// then once more with those at the midpoint found, which makes it second order whatever the linearisation neglects. Where a rate is so
    /// high that the midpoint would be passed by far, the point moves towards the end (the θ-method), so that nothing rings.
    fn take_mean_accelerations(&mut self, scene: &Scene, h: f64) {
        self.implicit.clear();
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            let item = &self.items[i];
            let answer = scene.media.stiffness(&item.body, &item.law, item.body.position, item.body.velocity);
            let (drag, stiffness) = (answer.drag, DVec2::new(0.0, answer.lift));
            let rate = drag * h + stiffness * (h * h);
            let theta = DVec2::new(theta(rate.x), theta(rate.y));
            let response = theta * drag * h + theta * theta * stiffness * (h * h);
            self.implicit.push(Implicit { theta, response });
            let eased = response + 1.0;
            self.masses[i] = eased * item.body.mass;
            let now = scene.media.acceleration(&item.body, &item.law, item.body.position, item.body.velocity);
            self.free[i] = (now - stiffness * theta * h * item.body.velocity) / eased;
        }
        self.solve_means();
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            let (item, Implicit { theta, response }) = (&self.items[i], self.implicit[k]);
            let (x, v, a, t) = (item.body.position, item.body.velocity, self.means[i], theta * h);
            let forced = scene.media.acceleration(&item.body, &item.law, x + t * v + t * t * a, v + t * a);
            self.free[i] = (forced + response * a) / (response + 1.0);
        }
        self.solve_means();
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            let item = &mut self.items[i];
            self.masses[i] = DVec2::splat(item.body.mass);
            if item.motion == Motion::Parabola {
                item.mean = self.means[i];
            }
        }
    }

    fn solve_means(&mut self) {
        self.means.clone_from(&self.free);
        self.asked.clone_from(&self.trial);
        let parts = Parts { masses: &self.masses, free: &self.free, grounds: &self.ground_pulls };
        self.reactions.accelerate(&mut self.asked, &parts, &mut self.means);
        self.work += WORK_OF_A_CONTACT * self.trial.len() as u64;
    }

    /// Goes on with a flow that was foreseen up to now only, or with the next leg of a surface's path.
    pub(super) fn renew(&mut self, scene: &Scene, i: usize) {
        let (position, velocity) = self.items[i].pose(scene.media, self.now);
        let item = &mut self.items[i];
        (item.body.position, item.body.velocity, item.since) = (position, velocity, self.now);
        if i < self.movable {
            let rate = scene.media.rate(&item.body, &item.law, velocity);
            item.until = (self.now + reach_of_a_cubic(&item.law, rate, scene.tick)).min(scene.tick);
        }
        item.foresee(scene.media);
        self.grown |= i < self.movable && !self.items[i].searched.contains(&self.items[i].swept, 0.0);
        self.work += WORK_OF_AN_ITEM;
        self.predict(scene, i);
    }

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

    /// Stops all surfaces that move: for the rest of the tick the island is taken in one step, with surfaces that stand.
    pub(super) fn halt_all(&mut self, scene: &Scene) {
        for i in self.movable..self.items.len() {
            if self.items[i].motion != Motion::Still {
                self.halt(scene, i as u32);
            }
        }
        self.release();
    }

    /// Sets a surface on the part of its path that begins now. Concerns whatever is in contact with it.
    fn set_out(&mut self, scene: &Scene, i: usize) {
        let item = &mut self.items[i];
        scene.set_on_path(item, self.now);
        item.foresee(scene.media);
        item.next = Next::NEVER;
        let ground = i - self.movable;
        (self.ground_speeds[ground], self.ground_pulls[ground]) = (item.body.velocity, item.solved);
        (self.places[i], self.is_placed[i]) = (item.body.position, true);
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            if contact.lo as usize == i || contact.hi as usize == i {
                self.concern(contact.other(i as u32));
            }
        }
    }

    /// Brings two things to the instant at which they meet, and exactly together: a way foreseen as a cubic may be off by a hair, so Newton's
    /// method ends on the motions themselves. What is left of the gap is shared as their masses say; a surface gives way to nothing. Returns
    /// false if they meet so much later that something else happens before: then they have to be looked at again from here.
    pub(super) fn put_together(&mut self, scene: &Scene, contact: &Contact) -> bool {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let reach = self.items[lo].body.half[axis] + self.items[hi].body.half[axis];
        let exact = |item: &super::Item| matches!(item.motion, Motion::Still | Motion::Parabola);
        if !(exact(&self.items[lo]) && exact(&self.items[hi])) {
            let begin = self.items[lo].since.max(self.items[hi].since);
            let others = self.items.iter().enumerate().filter(|(k, _)| *k != lo && *k != hi).map(|(_, item)| item.next.at);
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
        }
        let gap = self.locate(scene, hi)[axis] - self.locate(scene, lo)[axis] - reach;
        let weight = |item: usize| if item < self.movable { 1.0 / self.items[item].body.mass } else { 0.0 };
        let (of_lo, of_hi) = (weight(lo), weight(hi));
        if gap < -DEEP {
            // They began in each other: nothing is put right at a stroke.
        } else if of_lo == 0.0 || of_hi == 0.0 {
            let (body, ground, side) = if of_lo == 0.0 { (hi, lo, 1.0) } else { (lo, hi, -1.0) };
            self.places[body][axis] = self.places[ground][axis] + side * reach;
        } else if gap.abs() > CLOSED {
            self.places[lo][axis] += gap * (of_lo / (of_lo + of_hi));
            self.places[hi][axis] -= gap * (of_hi / (of_lo + of_hi));
        }
        true
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
                if contact.lo == item || contact.hi == item {
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

    /// Lets a body leave the surface on which it has bounced.
    pub(super) fn resume(&mut self, scene: &Scene, i: usize) {
        self.locate(scene, i);
        let Some(resume) = self.items[i].resume.take() else { return };
        if self.speeds[i][resume.axis] != 0.0 {
            return;
        }
        self.speeds[i][resume.axis] = resume.speed;
        let mut impulse = DVec2::ZERO;
        impulse[resume.axis] = self.items[i].body.mass * resume.speed;
        let held = |contact: &&Contact| contact.axis == resume.axis && (contact.lo as usize == i || contact.hi as usize == i);
        if let Some(contact) = self.contacts.iter().find(held).copied() {
            self.locate(scene, contact.other(i as u32) as usize);
            self.note(&contact, if contact.hi as usize == i { impulse } else { -impulse }, 0.0);
        }
    }

    /// The contacts and accelerations of the instant at which the tick ends, where media make them others than when the last way began.
    pub(super) fn settle(&mut self, scene: &Scene) {
        self.is_placed.fill(false);
        for i in 0..self.items.len() {
            self.locate(scene, i);
        }
        // Media may have parted what pressed when it set out, and what slides may do so since.
        for index in (0..self.contacts.len()).rev() {
            let contact = self.contacts[index];
            if !(self.stays(&contact) || self.rides(&contact)) {
                self.contacts.remove(index);
                self.items[contact.lo as usize].known = false;
                self.items[contact.hi as usize].known = false;
            }
        }
        for index in 0..self.contacts.len() {
            let slides = self.slides(&self.contacts[index]);
            if slides != 0.0 {
                self.contacts[index].slides = slides;
            }
        }
        // What has crossed the border of a stream just as the tick ends is on its other side.
        if !self.streams.is_empty() {
            for i in 0..self.movable {
                let constant = self.items[i].law.constant;
                self.renew_law(scene, i);
                if self.items[i].law.constant != constant {
                    self.concern(i as u32);
                }
            }
        }
        for i in 0..self.movable {
            let item = &mut self.items[i];
            if self.is_concerned[i] || !item.law.is_constant() && item.motion != Motion::Still {
                self.free[i] = scene.media.acceleration(&item.body, &item.law, item.body.position, item.body.velocity);
                (item.solved, self.solved[i]) = (self.free[i], self.free[i]);
            }
        }
        let changes = |item: u32| self.changes(item) || self.is_concerned[item as usize];
        if self.contacts.iter().any(|contact| changes(contact.lo) || changes(contact.hi)) {
            for i in 0..self.movable {
                if !self.changes(i as u32) {
                    self.free[i] =
                        scene.media.acceleration(&self.items[i].body, &self.items[i].law, self.places[i], self.speeds[i]);
                }
            }
            self.contacts.sort_unstable_by_key(Contact::ends);
            let parts = Parts { masses: &self.masses, free: &self.free, grounds: &self.ground_pulls };
            self.reactions.accelerate(&mut self.contacts, &parts, &mut self.solved);
            for i in 0..self.movable {
                self.items[i].solved = self.solved[i];
            }
        }
        self.release();
    }

    /// Gives what rides on a surface that moves its place and its speed exactly, and so on with what is carried by that: the sums of many
    /// ticks would lead them away from each other by their roundings.
    pub(super) fn follow_surfaces(&mut self) {
        if self.items[self.movable..].iter().all(|surface| surface.motion == Motion::Still) {
            return;
        }
        let mut next = 0;
        loop {
            let carrier = self.concerned.get(next).copied();
            for index in 0..self.contacts.len() {
                let contact = self.contacts[index];
                let (body, surface) = contact.ends();
                match carrier {
                    None if next == 0 && !self.is_body(surface) => self.follow(&contact, body),
                    Some(carrier) if self.is_body(surface) && (carrier == body || carrier == surface) => {
                        self.follow(&contact, contact.other(carrier));
                    }
                    _ => {}
                }
            }
            if carrier.is_some() {
                next += 1;
            }
            if next == self.concerned.len() {
                break;
            }
        }
        self.release();
    }

    /// Lets a body follow the other end of a contact that presses.
    fn follow(&mut self, contact: &Contact, body: u32) {
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
        if off[axis] > rounding[axis] || (item.position[axis] - place).abs() > SLOP {
            return;
        }
        (item.velocity[axis], item.position[axis]) = (velocity[axis], place);
        if contact.slides == 0.0 && off[along] <= rounding[along] {
            item.velocity[along] = velocity[along];
        }
        self.concern(body);
    }

    /// Whether what acts on an item changes while it moves.
    fn changes(&self, item: u32) -> bool {
        let of = &self.items[item as usize];
        self.is_concerned[item as usize] || !of.law.is_constant() && of.motion != Motion::Still
    }
}

/// How far into an implicit step of so much rate × time its forces are taken.
fn theta(rate: f64) -> f64 {
    if rate > 2.0 { 1.0 - 1.0 / rate } else { 0.5 }
}
