//! How a tick goes: the chain of intervals, phase by phase (see the module's head for the ideas).

use super::contacts::Contact;
use super::happenings::Happening;
use super::interval::Motion;
use super::media::Law;
use super::tuning::{MAX_INTERVALS, RETRIES, RETRY_PART, SLOP};
use super::{Body, World};
use glam::DVec2;

impl World {
    /// Advances the world by exactly one tick of `dt` seconds.
    pub fn step(&mut self, dt: f64) {
        self.events.clear();
        self.corners.clear();
        if self.awake.is_empty() {
            return;
        }
        self.tick = dt;
        self.begin_tick();
        if let Some(mut crowd) = self.crowd.take() {
            self.step_crowd(&mut crowd, dt);
            self.crowd = Some(crowd);
            return;
        }
        self.refresh_candidates(dt);
        if !(self.plan.direct && self.fly(dt)) {
            self.chain_intervals(dt);
            self.put_to_rest();
        }
    }

    /// The general way through a tick: interval by interval between the things that happen within it.
    fn chain_intervals(&mut self, dt: f64) {
        self.begin_chain();
        let mut intervals = 0;
        let mut hit = None;
        loop {
            let left = dt - self.now;
            if intervals > 0 {
                self.refresh_laws();
            }
            if self.plan.contacts {
                let hit = hit.take();
                let turned = self.resolve_impacts(hit, self.now, left);
                if turned {
                    // Impacts turn motions, and with them what they may meet.
                    self.refresh_laws();
                }
                if turned || intervals > 0 {
                    self.refresh_candidates(left);
                }
                self.find_contacts(hit.map(|contact| contact.pair));
            }
            self.solve_accelerations();
            let longest = self.choose_motions(left, dt);
            let (t, happening) = self.next_happening(longest);
            let (t, happening) = self.advance(t, happening);
            intervals += 1;
            self.overflowing = intervals > MAX_INTERVALS / 2;
            let last = (matches!(happening, Happening::Nothing) && t >= left) || intervals > MAX_INTERVALS;
            if last {
                // Shown are the forces at the beginning of the interval that leads to what is shown with them.
                self.show_forces();
            }
            self.commit();
            self.now += t;
            if last {
                break;
            }
            hit = self.apply(happening);
        }
        self.overflows += u64::from(self.overflowing);
    }

    fn begin_tick(&mut self) {
        for &body in &self.awake {
            let i = body as usize;
            self.previous[i] = self.bodies[i].position;
        }
        if self.plan.media() {
            self.find_zones();
        }
        self.refresh_laws();
    }

    fn begin_chain(&mut self) {
        self.now = 0.0;
        self.overflowing = false;
        self.resumes.clear();
        for &body in &self.awake {
            let i = body as usize;
            (self.hits[i], self.clung[i], self.crossings[i]) = (0, 0, 0);
        }
    }

    /// Which body feels which stream, from where they are; crossings within the tick keep it true.
    fn find_zones(&mut self) {
        let streams = self.media.streams.len();
        for &index in &self.awake {
            let i = index as usize;
            let body = &self.bodies[i];
            let bounds = body.bounds();
            for (stream, inside) in self.media.streams.iter().zip(&mut self.in_stream[i * streams..]) {
                let now = bounds.touches(&stream.zone, SLOP);
                self.forces_hold &= *inside == now;
                *inside = now;
            }
            self.crossings[i] = 0;
        }
    }

    /// The law of motion of every body in the coming interval.
    pub(super) fn refresh_laws(&mut self) {
        if self.laws_hold && !self.plan.media() {
            return;
        }
        let (hold, zones) = (self.laws_hold, self.plan.streams || self.plan.liquids);
        self.laws_hold = true;
        for &index in &self.awake {
            let i = index as usize;
            let body = &self.bodies[i];
            if hold && !zones {
                continue;
            }
            let law = self.law(i, body);
            self.forces_hold &= !law.is_near_liquid();
            self.laws[i] = law;
        }
    }

    /// The law of motion of body `i`, being as `body`.
    pub(super) fn law(&self, i: usize, body: &Body) -> Law {
        let mut force = self.drives[i];
        for (stream, inside) in self.media.streams.iter().zip(&self.in_stream[i * self.media.streams.len()..]) {
            if *inside {
                force += stream.force;
            }
        }
        let mut law = Law { constant: DVec2::new(0.0, self.media.gravity) + force / body.mass, ..Law::default() };
        if self.plan.air {
            law.air = self.media.air(body);
        }
        if self.plan.liquids {
            law.liquids = self.media.liquids_near(body, law.constant, self.tick);
        }
        law
    }

    /// Finds where everything is after `t` seconds. Where a motion is no cubic, an impact can have been overlooked: if anything has sunk
    /// into anything on the way, the interval was too long, and a part of it is taken instead.
    fn advance(&mut self, mut t: f64, mut happening: Happening) -> (f64, Happening) {
        for _ in 0..RETRIES {
            self.find_poses(t);
            if !self.plan.media() || !self.has_sunk() {
                return (t, happening);
            }
            t *= RETRY_PART;
            happening = Happening::Look;
        }
        self.find_poses(t);
        (t, happening)
    }

    fn find_poses(&mut self, t: f64) {
        for index in 0..self.awake.len() {
            let i = self.awake[index] as usize;
            self.poses[i] = self.pose(i, t);
        }
    }

    /// Whether some pair of which one is no cubic overlaps at the new poses, and more than before.
    fn has_sunk(&self) -> bool {
        let follows = |item: u32| self.motions.get(item as usize).is_some_and(|m| matches!(m, Motion::Flow | Motion::Coupled));
        let after = |item: u32| self.poses.get(item as usize).map_or_else(|| self.place(item), |pose| pose.0);
        self.candidates.live.iter().any(|pair| {
            let reach = self.half(pair.a) + self.half(pair.b);
            let depth = |a: DVec2, b: DVec2| (reach - (b - a).abs()).min_element();
            let now = depth(after(pair.a), after(pair.b));
            now > 2.0 * SLOP && (follows(pair.a) || follows(pair.b)) && now > depth(self.place(pair.a), self.place(pair.b)) + SLOP
        })
    }

    /// Moves everything to the poses found.
    fn commit(&mut self) {
        for &body in &self.awake {
            let i = body as usize;
            (self.bodies[i].position, self.bodies[i].velocity) = self.poses[i];
        }
    }

    /// Does what ended the interval; returns the pair that met, if that was it.
    fn apply(&mut self, happening: Happening) -> Option<Contact> {
        match happening {
            Happening::Nothing | Happening::Edge | Happening::Look => {}
            Happening::Hit(contact) => {
                self.place_against(&contact);
                return Some(contact);
            }
            Happening::Stop(contact) => {
                let items = self.bodies.len() + self.blocks.len();
                self.reactions.merge_speeds(&contact, &self.contacts, &mut self.bodies, items);
            }
            Happening::Stream(body, stream) => {
                let at = body as usize * self.media.streams.len() + stream as usize;
                self.in_stream[at] = !self.in_stream[at];
                self.forces_hold = false;
                self.crossings[body as usize] += 1;
            }
            Happening::Kink(body) => {
                let i = body as usize;
                self.laws_hold = false;
                self.crossings[i] += 1;
            }
            Happening::Resume(index) => {
                let resume = self.resumes.swap_remove(index as usize);
                let speed = &mut self.bodies[resume.body as usize].velocity[resume.axis];
                // Whatever was hit meanwhile bounces no more as it did.
                if *speed == 0.0 {
                    *speed = resume.speed;
                }
            }
        }
        None
    }

    /// Sets a body exactly against the immovable face that it met: no rounding of the time of impact is left.
    fn place_against(&mut self, contact: &Contact) {
        let axis = contact.axis;
        let (body, other, side) =
            if self.immovable(contact.hi) { (contact.lo, contact.hi, -1.0) } else { (contact.hi, contact.lo, 1.0) };
        if !self.immovable(other) {
            return;
        }
        let at = self.place(other)[axis] + side * (self.half(other)[axis] + self.half(body)[axis]);
        self.bodies[body as usize].position[axis] = at;
    }

    /// The forces before the first tick.
    pub(super) fn show_start(&mut self) {
        self.begin_tick();
        self.begin_chain();
        self.refresh_candidates(0.0);
        if self.plan.contacts {
            self.gather_touching(None);
            self.find_contacts(None);
        }
        self.solve_accelerations();
        self.choose_motions(0.0, 0.0);
        self.show_forces();
    }
}
