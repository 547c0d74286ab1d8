//! How a tick goes: the chain of intervals, phase by phase (see the module's head for the ideas).

use super::contacts::Contact;
use super::happenings::Happening;
use super::interval::Motion;
use super::media::{Law, moves_across};
use super::tuning::{MAX_INTERVALS, RETRIES, RETRY_PART, SLOP};
use super::{Aabb, Body, World};
use glam::DVec2;

impl World {
    /// Advances the world by exactly one tick of `dt` seconds, in intervals between the things that happen within it.
    pub fn step(&mut self, dt: f64) {
        self.events.clear();
        self.corners.clear();
        if !self.settled {
            self.settled = self.still;
            self.begin_tick();
        }
        if self.still {
            return;
        }
        if let Some(mut crowd) = self.crowd.take() {
            self.step_crowd(&mut crowd, dt);
            self.crowd = Some(crowd);
            return;
        }
        let mut intervals = 0;
        let mut hit = None;
        loop {
            let left = dt - self.now;
            self.refresh_laws();
            if intervals == 0 {
                self.refresh_candidates(left);
            }
            if self.plan.contacts {
                self.resolve_impacts(hit.take(), self.now, left);
                if self.plan.media() {
                    // Impacts turn motions, and with them the side that meets the air.
                    self.refresh_laws();
                }
                self.refresh_candidates(left);
                self.find_contacts();
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
        self.still = self.motions.iter().all(|&motion| motion == Motion::Still);
    }

    fn begin_tick(&mut self) {
        for (previous, body) in self.previous.iter_mut().zip(&self.bodies) {
            *previous = body.position;
        }
        self.now = 0.0;
        self.overflowing = false;
        self.resumes.clear();
        let n = self.bodies.len();
        self.hits.clear();
        self.hits.resize(n, 0);
        self.clung.clear();
        self.clung.resize(n, 0);
        self.crossings.clear();
        self.crossings.resize(n, 0);
        self.find_zones();
    }

    /// Which body feels which stream, from where they are; crossings within the tick keep it true.
    fn find_zones(&mut self) {
        self.in_stream.clear();
        self.across.clear();
        for (body, drive) in self.bodies.iter().zip(&self.drives) {
            let bounds = body.bounds();
            self.in_stream.extend(self.media.streams.iter().map(|stream| bounds.touches(&stream.zone, SLOP)));
            let force = *drive + DVec2::new(0.0, body.mass * self.media.gravity);
            self.across.push(moves_across(body.velocity, force));
        }
    }

    /// The law of motion of every body in the coming interval.
    pub(super) fn refresh_laws(&mut self) {
        self.laws.clear();
        for (i, body) in self.bodies.iter().enumerate() {
            let speed = body.velocity.abs();
            if speed.x != speed.y {
                self.across[i] = speed.x > speed.y;
            }
        }
        for (i, body) in self.bodies.iter().enumerate() {
            self.laws.push(self.law(i, body));
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
        law.area = 2.0 * if self.across[i] { body.half.y } else { body.half.x };
        if self.plan.air && body.feels_air {
            law.air = 0.5 * self.media.air_density * body.drag * law.area / body.mass;
        }
        if self.plan.liquids {
            let reach = body.half + body.velocity.abs() + DVec2::ONE;
            let near = Aabb::around(body.position, reach);
            law.wet = self.media.fluids.iter().any(|fluid| near.touches(&fluid.zone, 0.0));
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
        self.poses.clear();
        for i in 0..self.bodies.len() {
            let pose = self.pose(i, t);
            self.poses.push(pose);
        }
    }

    /// Whether some pair of which one is no cubic overlaps at the new poses, and more than before.
    fn has_sunk(&self) -> bool {
        let follows = |item: u32| self.motions.get(item as usize).is_some_and(|m| matches!(m, Motion::Flow | Motion::Coupled));
        let after = |item: u32| self.poses.get(item as usize).map_or_else(|| self.place(item), |pose| pose.0);
        self.candidates.pairs.iter().any(|pair| {
            let reach = self.half(pair.a) + self.half(pair.b);
            let depth = |a: DVec2, b: DVec2| (reach - (b - a).abs()).min_element();
            let now = depth(after(pair.a), after(pair.b));
            now > 2.0 * SLOP && (follows(pair.a) || follows(pair.b)) && now > depth(self.place(pair.a), self.place(pair.b)) + SLOP
        })
    }

    /// Moves everything to the poses found.
    fn commit(&mut self) {
        for (body, &(position, velocity)) in self.bodies.iter_mut().zip(&self.poses) {
            (body.position, body.velocity) = (position, velocity);
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
                self.crossings[body as usize] += 1;
            }
            Happening::Kink(body) => {
                let i = body as usize;
                let v = self.bodies[i].velocity;
                self.across[i] = v.x.abs() > v.y.abs();
                self.crossings[i] += 1;
            }
            Happening::Resume(index) => {
                let resume = self.resumes.swap_remove(index as usize);
                self.bodies[resume.body as usize].velocity[resume.axis] += resume.speed;
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
        self.refresh_laws();
        self.refresh_candidates(0.0);
        if self.plan.contacts {
            self.find_contacts();
        }
        self.solve_accelerations();
        self.choose_motions(0.0, 0.0);
        self.show_forces();
    }
}
