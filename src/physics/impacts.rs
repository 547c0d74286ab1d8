//! Impacts: what collisions do to velocities.
//!
//! Pairs that touch and approach are dealt with one after the other, the fastest first, until nothing approaches any more: impulses in
//! this order carry one block's motion through a row to the last (Newton's cradle), where solving them all at once would not. A pair's
//! impulse is (1 + e)·w split by mass fractions, which leaves exactly zero for equal masses. Restitution is the larger of the two; a
//! rebound slower than the rest speed is none, and what only has to stop stops all at once in a plastic solve of the contact network,
//! exact at any mass ratio. Friction acts during an impact too, up to μ_k times the normal impulse, and never reverses the sliding.
//!
//! A bounce series on something immovable has a sum: after some bounces within one tick the rest of it, or as many whole bounces as fit,
//! is passed over in closed form (rest after 2w/(g(1 − e))), during which the mean reaction is that of a body at rest.

use super::contacts::Contact;
use super::tuning::{CALM_REACH, CASCADE_HITS, MAX_CASCADE, MAX_CLINGS, MICRO_SPEED, RATTLE_HITS, REPORT_SPEED, SLOP, ZENO_HITS};
use super::{BodyId, Event, Obstacle, World};
use glam::DVec2;

/// A body passing over whole bounces: at `at` (s from the tick's start) it leaves the surface with `speed` along `axis`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Resume {
    pub at: f64,
    pub body: u32,
    pub axis: usize,
    pub speed: f64,
}

impl World {
    /// Ends every approach of things that touch. `hit` is the pair whose time of impact this is; others bounce when their gap is ≤ 0 or they
    /// rested on each other. `left` is what remains of the tick, s.
    /// Returns whether any velocity was changed.
    pub(super) fn resolve_impacts(&mut self, hit: Option<Contact>, now: f64, left: f64) -> bool {
        self.wake_what_is_touched(hit);
        self.gather_touching(hit);
        let mut turned = false;
        let mut hits = 0;
        while let Some((index, speed, e)) = self.next_impact(hits < MAX_CASCADE) {
            turned = true;
            if e > 0.0 {
                hits += 1;
                self.touching[index].lossy_hits += u32::from(e < 1.0);
                self.bounce(index, speed, e, now, left);
                continue;
            }
            self.report_all_approaching();
            self.stop_together();
            break;
        }
        turned
    }

    /// The plastic solve of all that touches. Pushing one side of a body can lift it off the other by next to nothing; where it is
    /// pulled back at once, it stays, or the two sides would take turns for ever.
    fn stop_together(&mut self) {
        let items = self.bodies.len() + self.blocks.len();
        let mut touching = std::mem::take(&mut self.touching);
        for _ in 0..=touching.len() {
            self.reactions.collide(&mut touching, &mut self.bodies, items, &mut self.speeds);
            let mut lifted = false;
            for contact in &mut touching {
                if !contact.clings && self.clings(contact) {
                    contact.clings = true;
                    lifted = true;
                }
            }
            if !lifted {
                break;
            }
        }
        self.touching = touching;
    }

    /// Lists what touches.
    pub(super) fn gather_touching(&mut self, hit: Option<Contact>) {
        let mut touching = std::mem::take(&mut self.touching);
        touching.clear();
        let mut known = self.contacts.iter().peekable();
        for &pair in &self.candidates.live {
            while known.peek().is_some_and(|contact| contact.pair < pair) {
                known.next();
            }
            let resting = known.peek().is_some_and(|contact| contact.pair == pair);
            let met = hit.filter(|contact| contact.pair == pair);
            if let Some(mut contact) = met.or_else(|| self.contact(pair, SLOP)) {
                contact.closed |= resting || met.is_some();
                // What has just come together by a hair's breadth has done so, whatever pulls at it alone.
                let grazes = met.is_some() && (-MICRO_SPEED..=0.0).contains(&self.approach(&contact));
                contact.clings = grazes || self.clings(&contact);
                if contact.clings {
                    for item in [contact.lo, contact.hi] {
                        if let Some(clung) = self.clung.get_mut(item as usize) {
                            *clung += 1;
                        }
                    }
                }
                touching.push(contact);
            }
        }
        self.touching = touching;
    }

    /// Whether two things part so slowly that they rest on each other, if nothing pulls them apart.
    fn clings(&self, contact: &Contact) -> bool {
        let approach = self.approach(contact);
        if !(-MICRO_SPEED..0.0).contains(&approach) {
            return false;
        }
        let tried = |item: u32| self.clung.get(item as usize).is_some_and(|&clung| clung > MAX_CLINGS);
        if tried(contact.lo) || tried(contact.hi) {
            return false;
        }
        let pull = |item: u32| {
            self.bodies
                .get(item as usize)
                .map_or(DVec2::ZERO, |body| self.media.acceleration(body, &self.laws[item as usize], body.position, body.velocity))
        };
        (pull(contact.lo) - pull(contact.hi))[contact.axis] >= 0.0
    }

    fn approach(&self, contact: &Contact) -> f64 {
        (self.velocity(contact.lo) - self.velocity(contact.hi))[contact.axis]
    }

    /// The next pair of the cascade: its index, its closing speed and its restitution. Bouncing pairs first, the fastest of them.
    fn next_impact(&self, bounces_left: bool) -> Option<(usize, f64, f64)> {
        let mut best: Option<(usize, f64, f64)> = None;
        for (index, contact) in self.touching.iter().enumerate() {
            let speed = self.approach(contact);
            if speed <= 0.0 && !contact.clings {
                continue;
            }
            let e = if bounces_left && self.plan.bounces { self.restitution(contact, speed) } else { 0.0 };
            // A bounce needs a closed gap, or it would lose energy; what only comes to rest may do so within the slop.
            if e > 0.0 && !contact.closed {
                continue;
            }
            let better = best.is_none_or(|(_, fastest, of)| (e > 0.0, speed) > (of > 0.0, fastest));
            if better {
                best = Some((index, speed, e));
            }
        }
        best
    }

    /// Restitution of a pair at a closing speed: zero where the bounce ends.
    fn restitution(&self, contact: &Contact, speed: f64) -> f64 {
        let of = |item: u32| self.bodies.get(item as usize).map_or(0.0, |body| body.restitution);
        let e = of(contact.lo).max(of(contact.hi));
        let movable = !self.immovable(contact.lo) && !self.immovable(contact.hi);
        let rattles = |item: u32| self.hits.get(item as usize).is_some_and(|&hits| hits > RATTLE_HITS);
        let rattled = contact.lossy_hits >= CASCADE_HITS || (e < 1.0 && movable && rattles(contact.lo) && rattles(contact.hi));
        if e * speed < self.rest_speed || rattled || self.overflowing { 0.0 } else { e }
    }

    /// One pair's impulse.
    fn bounce(&mut self, index: usize, speed: f64, e: f64, now: f64, left: f64) {
        let contact = self.touching[index];
        self.report(&contact, speed);
        let axis = contact.axis;
        for item in [contact.lo, contact.hi] {
            if let Some(hits) = self.hits.get_mut(item as usize) {
                *hits += 1;
            }
        }
        let mass = |item: u32| self.bodies.get(item as usize).map(|body| body.mass);
        // The share of the velocity change that each side takes: the other's fraction of the mass.
        let (lo_share, hi_share) = match (mass(contact.lo), mass(contact.hi)) {
            (Some(lo), Some(hi)) => (hi / (lo + hi), lo / (lo + hi)),
            (lo, hi) => (f64::from(u8::from(lo.is_some())), f64::from(u8::from(hi.is_some()))),
        };
        let change = (1.0 + e) * speed;
        let relative = (self.velocity(contact.hi) - self.velocity(contact.lo))[1 - axis];
        // Friction changes the sliding by at most μ_k times the change along the normal, and stops it at most.
        let rub = -relative.signum() * (contact.kinetic_friction * change).min(relative.abs());
        let immovable = self.immovable(contact.lo) || self.immovable(contact.hi);
        for (item, share, sign) in [(contact.lo, lo_share, -1.0), (contact.hi, hi_share, 1.0)] {
            if let Some(body) = self.bodies.get_mut(item as usize) {
                if immovable {
                    // Exactly −e times the speed it came with, and exactly zero where friction stops it.
                    body.velocity[axis] = sign * e * speed;
                } else {
                    body.velocity[axis] += sign * share * change;
                }
                if relative != 0.0 {
                    body.velocity[1 - axis] += sign * share * rub;
                }
            }
        }
        if immovable {
            self.pass_over_bounces(&contact, e * speed, e, now, left);
        }
    }

    /// Passes over the rest of a bounce series, or whole bounces of it, where they come thick and fast within one tick.
    fn pass_over_bounces(&mut self, contact: &Contact, speed: f64, e: f64, now: f64, left: f64) {
        let (item, away) = if self.immovable(contact.lo) { (contact.hi, 1.0) } else { (contact.lo, -1.0) };
        let i = item as usize;
        if self.hits[i] < ZENO_HITS {
            return;
        }
        let (body, law) = (&self.bodies[i], &self.laws[i]);
        let pull = -away * self.media.acceleration(body, law, body.position, DVec2::ZERO)[contact.axis];
        if pull <= 0.0 {
            return;
        }
        let first = 2.0 * speed / pull;
        if first >= left || self.media.rate(body, law, body.velocity) * first > CALM_REACH {
            return;
        }
        let (count, time) = if e >= 1.0 {
            let count = (left / first).floor();
            (count, count * first)
        } else {
            // n bounces take first·(1 − eⁿ)/(1 − e).
            let part = left * (1.0 - e) / first;
            let count = if part >= 1.0 { f64::INFINITY } else { (libm::log1p(-part) / libm::log(e)).floor() };
            (count, first * (1.0 - libm::pow(e, count)) / (1.0 - e))
        };
        self.bodies[i].velocity[contact.axis] = 0.0;
        if count.is_finite() && time < left {
            let speed = away * speed * libm::pow(e, count);
            self.resumes.push(Resume { at: now + time, body: item, axis: contact.axis, speed });
        }
    }

    fn report_all_approaching(&mut self) {
        for index in 0..self.touching.len() {
            let contact = self.touching[index];
            let speed = self.approach(&contact);
            self.report(&contact, speed);
        }
    }

    /// Notes the impact for rules, view and sound.
    pub(super) fn report(&mut self, contact: &Contact, speed: f64) {
        if speed < REPORT_SPEED {
            return;
        }
        let (a, b) = (contact.pair.a, contact.pair.b);
        let (a_at, b_at) = (self.place(a), self.place(b));
        let (a_half, b_half) = (self.half(a), self.half(b));
        let low = (a_at - a_half).max(b_at - b_half);
        let high = (a_at + a_half).min(b_at + b_half);
        let mut normal = DVec2::ZERO;
        normal[contact.axis] = if contact.lo == a { -1.0 } else { 1.0 };
        let b = if self.immovable(b) { Obstacle::Surface(b - self.bodies.len() as u32) } else { Obstacle::Body(BodyId(b)) };
        self.events.push(Event::Impact { a: BodyId(a), b, point: (low + high) * 0.5, normal, speed });
        for item in [contact.lo, contact.hi] {
            if let Some(body) = self.bodies.get(item as usize) {
                self.corners.push((item, body.position));
            }
        }
    }
}
