//! Impacts in rounds, the fastest first (`docs/physics.md`, Impacts and their order). In a round no body is struck twice, but by hits that tie.

use crate::physics::data::tuning::{COLLAPSE, MAX_CLINGS, MICRO_SPEED, MOST_BOUNCES};
use crate::physics::data::{Aabb, BodyId, Contact, EQUAL_SPEED, Hit, Impulse, Obstacle, Part, SLOP, called, on_axis};
use crate::physics::exact::events::{Events, Scene, Tie};
use crate::physics::{contact::axis::Parts, exact::item::Item};
use glam::DVec2;

impl Events {
    /// Ends every approach of items that touch. Returns false if the budget of events is used up.
    pub(crate) fn resolve_impacts(&mut self, scene: &Scene) -> bool {
        if self.bounces && self.squeezes(scene) {
            return true;
        }
        self.struck.fill([false; 2]);
        while let Some((index, speed, e)) = self.next_impact(scene) {
            if self.is_struck(&self.touching[index]) {
                // Nothing else approaches: the next round begins.
                self.struck.fill([false; 2]);
                continue;
            }
            if e == 0.0 && self.closing_at_a_corner(&self.touching[index], speed).is_none() {
                self.stop_together(scene);
                break;
            }
            self.count += 1;
            if self.is_busy() {
                return false;
            }
            self.find_ties(scene, index, speed);
            match self.ties[..] {
                [] => self.bounce(scene, index, speed, e),
                [Tie { index, e, .. }] => self.bounce(scene, index, speed, e),
                _ => self.resolve_ties(scene, speed),
            }
        }
        true
    }

    /// Whether an impact of this round has changed the speed of one of the bodies of a contact along its axis.
    pub(crate) fn is_struck(&self, contact: &Contact) -> bool {
        contact.pair().into_iter().any(|item| self.is_body(item) && self.struck[item as usize][contact.axis])
    }

    /// Stops the surfaces that squeeze bodies before anything bounces: in a gap that closes it would bounce without end.
    fn squeezes(&mut self, scene: &Scene) -> bool {
        let hits = |contact: &Contact| {
            let surface = contact.lo.max(contact.hi);
            !self.is_body(surface) && !self.stands(surface) && self.approach(contact) > 0.0
        };
        if !self.touching.iter().any(hits) {
            return false;
        }
        let touching = std::mem::take(&mut self.touching);
        self.asked.clone_from(&touching);
        self.asked.iter_mut().for_each(|contact| contact.clings = false);
        self.before.clone_from(&self.speeds);
        self.means.clone_from(&self.speeds);
        self.reactions.collide(&mut self.asked, &Parts { masses: &self.masses, free: &self.before }, &mut self.means);
        let any = self.stop_surfaces(scene, &touching, Self::speed);
        self.touching = touching;
        any
    }

    /// The plastic solve of all that touches. A push on one side may lift a body off the other by next to nothing; where it is pulled back at once,
    /// it stays, or the two sides would take turns for ever. A surface that would squeeze a body only stops.
    fn stop_together(&mut self, scene: &Scene) {
        let mut touching = std::mem::take(&mut self.touching);
        let mut may_cling = true;
        for _ in 0..=touching.len() + 1 {
            self.before.clone_from(&self.speeds);
            self.reactions.collide(&mut touching, &Parts { masses: &self.masses, free: &self.before }, &mut self.speeds);
            if !self.reactions.joined.squeezed.is_empty() && touching.iter().any(|contact| contact.clings) {
                // What clings gives way: only what cannot squeezes.
                touching.iter_mut().for_each(|contact| contact.clings = false);
                self.speeds.clone_from(&self.before);
                may_cling = false;
                continue;
            }
            if self.stop_surfaces(scene, &touching, Self::speed) {
                // The surfaces keep the speeds to which they have just been stopped.
                self.speeds[..self.movable].copy_from_slice(&self.before[..self.movable]);
                break;
            }
            let mut lifted = false;
            for contact in &mut touching {
                self.note_plastic(scene, contact);
                if may_cling && !contact.clings && self.clings(scene, contact) {
                    (contact.clings, lifted) = (true, true);
                }
            }
            if !lifted {
                break;
            }
        }
        self.touching = touching;
    }

    /// Stops the surfaces that close on squeezed bodies by their `rate`, velocity or acceleration. Returns whether there are any.
    pub(crate) fn stop_surfaces(&mut self, scene: &Scene, contacts: &[Contact], rate: impl Fn(&Self, u32) -> DVec2) -> bool {
        let squeezed = std::mem::take(&mut self.reactions.joined.squeezed);
        let known = self.squeezed.len();
        for contact in contacts {
            let (body, surface) = contact.ends();
            if self.is_body(surface) || !squeezed.contains(&(body, contact.axis)) {
                continue;
            }
            let side = if surface == contact.lo { 1.0 } else { -1.0 };
            if side * rate(self, surface)[contact.axis] > 0.0 {
                let (speed, pull) = (self.speed(surface)[contact.axis], self.free[surface as usize][contact.axis]);
                self.squeezed.push((body, surface, side * speed + (side * pull).max(0.0) * (scene.tick - self.now)));
            }
        }
        self.reactions.joined.squeezed = squeezed;
        (known..self.squeezed.len()).for_each(|index| self.halt(scene, self.squeezed[index].1));
        self.squeezed.len() > known
    }

    /// Whether two items part so slowly that they rest on each other, if nothing pulls them apart.
    pub(crate) fn clings(&self, scene: &Scene, contact: &Contact) -> bool {
        let tried = |item: u32| self.items[item as usize].clung > MAX_CLINGS;
        if !(-MICRO_SPEED..0.0).contains(&self.approach(contact)) || contact.pair().into_iter().any(tried) {
            return false;
        }
        (self.pull(scene, contact.lo) - self.pull(scene, contact.hi))[contact.axis] >= 0.0
    }

    /// Acceleration without contacts now, m/s².
    pub(crate) fn pull(&self, scene: &Scene, item: u32) -> DVec2 {
        let of = &self.items[item as usize];
        if self.is_body(item) {
            scene.media.acceleration(&of.body, &of.law, self.places[item as usize], self.speeds[item as usize])
        } else {
            self.free[item as usize]
        }
    }

    /// The next pair: its index, closing speed and restitution. Bouncing pairs first, of them those not struck in this round, of these the fastest.
    fn next_impact(&self, scene: &Scene) -> Option<(usize, f64, f64)> {
        let mut best = None;
        for (index, contact) in self.touching.iter().enumerate() {
            let speed = self.approach(contact);
            let rounding = self.speed_rounding(contact)[contact.axis];
            if speed <= 0.0 && !contact.clings || speed > 0.0 && speed <= rounding && contact.closed && contact.lasts {
                continue;
            }
            let e = if self.bounces && speed > 0.0 { self.restitution(scene, contact, speed) } else { 0.0 };
            let rank = (e > 0.0, !self.is_struck(contact), speed);
            // A bounce needs a closed gap, or it would lose energy; what only comes to rest may do so within the slop.
            if best.is_none_or(|(first, _)| rank > first) && (e == 0.0 || self.is_shut(contact, speed)) {
                best = Some((rank, (index, speed, e)));
            }
        }
        best.map(|(_, next)| next)
    }

    /// Restitution of a pair at a closing speed: 0 where the bounce ends.
    pub(crate) fn restitution(&self, scene: &Scene, contact: &Contact, speed: f64) -> f64 {
        called(Part::Bounces);
        let (lo, hi) = (&self.items[contact.lo as usize], &self.items[contact.hi as usize]);
        let e = lo.body.coefficients().with(hi.body.coefficients(), false).restitution;
        let slow = e < 1.0 && (e * speed < scene.rest_speed || e * speed <= MICRO_SPEED);
        // What neither loses anything nor is squeezed ends of itself.
        let stands = |surface: &Item| surface.is_still() && surface.stops_at.is_infinite();
        let ends = || e < 1.0 || speed <= MICRO_SPEED || !self.items[self.movable..].iter().all(stands);
        let rattles = || [lo, hi].iter().all(|item| item.hits.0 > MOST_BOUNCES && self.now <= item.hits.1 + COLLAPSE);
        if slow || rattles() && ends() { 0.0 } else { e.min(1.0) }
    }

    pub(crate) fn count_hit(&mut self, contact: &Contact) {
        let ends = [contact.lo, contact.hi].map(|item| item as usize);
        for item in ends {
            let (hits, since) = &mut self.items[item].hits;
            if self.now > *since + COLLAPSE {
                (*hits, *since) = (0, self.now);
            }
            *hits += 1;
            self.struck[item][contact.axis] = true;
        }
        let fewest = ends.map(|item| self.items[item].hits.0).into_iter().min();
        self.guards.bounces_ended += u64::from(fewest == Some(MOST_BOUNCES + 1));
    }

    fn bounce(&mut self, scene: &Scene, index: usize, speed: f64, e: f64) {
        let contact = self.touching[index];
        let axis = contact.axis;
        self.count_hit(&contact);
        let [lo_share, hi_share] = self.shares(contact.lo as usize, contact.hi as usize);
        let (share, of) = if self.is_body(contact.hi) { (hi_share, contact.hi) } else { (lo_share, contact.lo) };
        let reduced = share * self.items[of as usize].body.mass;
        let change = (1.0 + e) * speed;
        let relative = self.sliding(&contact);
        // Friction changes the sliding by at most μ_k times the change along the normal, and stops it at most.
        let rubs = -relative.signum() * (contact.kinetic_friction * change).min(relative.abs());
        let rub = self.closing_at_a_corner(&contact, speed).map_or(rubs, |closing| -(1.0 + e) * closing);
        self.note(&contact, on_axis(axis, reduced * change, if rub == 0.0 { 0.0 } else { reduced * rub }), Some(speed));
        let ground = contact.pair().into_iter().find(|&item| !self.is_body(item)).map(|surface| self.speed(surface)[axis]);
        for (item, share, sign) in [(contact.lo, lo_share, -1.0), (contact.hi, hi_share, 1.0)] {
            if !self.is_body(item) {
                continue;
            }
            let velocity = &mut self.speeds[item as usize];
            match ground {
                // Exactly −e times the speed it came with, and exactly zero where friction stops it.
                Some(ground) => velocity[axis] = ground + sign * e * speed,
                None => velocity[axis] += sign * share * change,
            }
            if rub != 0.0 {
                velocity[1 - axis] += sign * share * rub;
            }
        }
        self.begin_train(scene, &contact, e * speed, e);
    }

    /// The velocity of `hi` relative to `lo` along the other axis, m/s, where two corners have met that close along both axes alike: both faces
    /// are hit.
    fn closing_at_a_corner(&self, contact: &Contact, speed: f64) -> Option<f64> {
        let (lo, hi, along) = (contact.lo as usize, contact.hi as usize, 1 - contact.axis);
        let apart = (self.places[hi] - self.places[lo])[along];
        let reach = (self.items[lo].body.half + self.items[hi].body.half)[along];
        let closing = (self.speeds[hi] - self.speeds[lo])[along];
        let alike = (-closing * apart.signum() - speed).abs() <= EQUAL_SPEED * speed;
        (speed > 0.0 && reach - apart.abs() <= 2.0 * SLOP && alike).then_some(closing)
    }

    fn note_plastic(&mut self, scene: &Scene, contact: &mut Contact) {
        // A surface pulls nothing: what keeps a body that clings to it is taken off what it has pushed in this tick.
        if contact.normal < 0.0 && !self.is_body(contact.ends().1) {
            self.take_off(scene, contact);
        }
        if contact.normal == 0.0 && contact.friction == 0.0 {
            return;
        }
        let before = |item: u32| self.before[item as usize][contact.axis];
        let closing = (before(contact.lo) - before(contact.hi)).max(0.0);
        self.note(contact, on_axis(contact.axis, contact.normal, contact.friction), Some(closing));
    }

    /// Takes the pull of a surface off its last pushes in this tick on the same body, and off what their lasting contact passes on in it.
    fn take_off(&mut self, scene: &Scene, contact: &mut Contact) {
        let ((body, surface), axis) = (contact.ends(), contact.axis);
        let sign = if body == contact.lo { -1.0 } else { 1.0 };
        let ends = (BodyId(self.items[body as usize].id), Obstacle::Surface(self.items[surface as usize].id));
        let pushes = |hit: &&mut Hit| hit.impulse.impact && hit.normal[axis] == sign && (hit.impulse.a, hit.impulse.b) == ends;
        for hit in self.hits.iter_mut().rev().filter(pushes) {
            let push = &mut hit.impulse.vector[axis];
            let taken = (sign * *push).min(-contact.normal);
            *push -= sign * taken;
            contact.normal += taken;
        }
        let lasts = scene.tick - self.items[body as usize].since;
        if let Some(known) = self.contacts.iter_mut().find(|known| known.ends() == contact.ends() && known.axis == axis) {
            let taken = (known.passed[0] + known.normal * lasts).min(-contact.normal).max(0.0);
            known.passed[0] -= taken;
            contact.normal += taken;
        }
    }

    /// Lists an impulse: of an impact with its closing speed.
    pub(crate) fn note(&mut self, contact: &Contact, impulse: DVec2, speed: Option<f64>) {
        let (first, second) = contact.ends();
        let sign = if first == contact.lo { -1.0 } else { 1.0 };
        let bounds = |item: u32| Aabb::around(self.places[item as usize], self.items[item as usize].body.half);
        let other = &self.items[second as usize];
        let b = if other.surface { Obstacle::Surface(other.id) } else { Obstacle::Body(BodyId(other.id)) };
        let (a, point) = (BodyId(self.items[first as usize].id), bounds(first).shared_middle(&bounds(second)));
        let places = [first, second].map(|item| self.places[item as usize]);
        let impulse = Impulse { a, b, vector: impulse * sign, point, at: self.now, impact: speed.is_some() };
        let normal = on_axis(contact.axis, sign, 0.0);
        self.hits.push(Hit { impulse, normal, speed: speed.unwrap_or(0.0), places });
    }
}
