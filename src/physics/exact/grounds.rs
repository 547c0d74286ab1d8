//! Surfaces within a tick: they begin the legs of their paths, and stop for what they would squeeze.

use crate::physics::data::contact::Contact;
use crate::physics::data::tuning::{SLOP, STRAY};
use crate::physics::exact::events::{Events, Scene};
use crate::physics::exact::item::{Item, Motion, Next};
use glam::DVec2;

impl Scene<'_> {
    /// Puts a surface where its path leads it `at` seconds from the tick's start, or to where it stopped before.
    pub fn set_on_path(&self, item: &mut Item, at: f64) {
        let surface = &self.surfaces[item.id as usize];
        let point = if at < item.stops_at { surface.at(at) } else { surface.at(item.stops_at).at_rest() };
        item.since = at;
        let end = if at < item.stops_at { item.stops_at } else { f64::INFINITY };
        item.until = (at + point.lasts).min(end).min(self.tick);
        (item.body.position, item.body.velocity) = (point.offset, point.velocity);
        (item.solved, item.mean) = (point.acceleration, point.acceleration);
        let still = point.velocity == DVec2::ZERO && point.acceleration == DVec2::ZERO;
        item.motion = if still { Motion::Still } else { Motion::Parabola };
    }
}

impl Events {
    /// Begins the next leg of a surface's path: whatever touches it is concerned.
    pub(crate) fn turn(&mut self, scene: &Scene, i: usize) {
        self.set_out(scene, i);
        self.predict(scene, i);
        if !self.concerned.is_empty() {
            self.look(scene);
        }
    }

    /// Stops a surface for the rest of the tick, where it was `late` seconds ago.
    pub(crate) fn halt(&mut self, scene: &Scene, surface: u32, late: f64) {
        self.guards.surfaces_stopped += 1;
        self.halted = true;
        let item = &mut self.items[surface as usize];
        item.stops_at = item.stops_at.min((self.now - late).max(0.0));
        self.set_out(scene, surface as usize);
    }

    /// Where paths are foreseen roughly, a surface is found to squeeze a body a hair too late: it is in the body, or has pressed it into
    /// another surface. Puts back the bodies in between. Returns how late that is, s, for a surface that comes with `speed`, m/s.
    pub(crate) fn give_back(&mut self, contacts: &[Contact], squeezing: &Contact, speed: f64) -> f64 {
        let (axis, (body, surface)) = (squeezing.axis, squeezing.ends());
        let forwards = surface == squeezing.lo;
        self.behind.clear();
        self.behind.push(body);
        let (mut depth, mut next) = (0.0, 0);
        while let Some(&carrier) = self.behind.get(next) {
            next += 1;
            for contact in contacts.iter().filter(|contact| contact.axis == axis) {
                let (near, far) = if forwards { (contact.lo, contact.hi) } else { (contact.hi, contact.lo) };
                if near != carrier || far == surface {
                    continue;
                }
                if !self.is_body(far) {
                    depth = f64::max(depth, self.depth_of(contact));
                } else if !self.behind.contains(&far) {
                    self.behind.push(far);
                }
            }
        }
        let way = depth + self.depth_of(squeezing).max(0.0);
        if way <= SLOP || way > STRAY || speed <= 0.0 {
            return 0.0;
        }
        for &item in &self.behind {
            self.places[item as usize][axis] -= if forwards { depth } else { -depth };
        }
        way / speed
    }

    /// Sets a surface on the part of its path that begins now. Concerns whatever is in contact with it.
    fn set_out(&mut self, scene: &Scene, i: usize) {
        let item = &mut self.items[i];
        scene.set_on_path(item, self.now);
        self.foresee(scene, i);
        self.nexts[i] = Next::NEVER;
        let item = &self.items[i];
        (self.places[i], self.speeds[i], self.is_placed[i]) = (item.body.position, item.body.velocity, true);
        (self.free[i], self.solved[i]) = (item.solved, item.solved);
        self.concern_partners(i as u32);
    }
}
