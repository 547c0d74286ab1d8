//! How a tick goes, phase by phase.
//!
//! The store of all bodies, with its broad phase, flight and islands, is that of [`super::pile`]; the world tells it what acts on each body,
//! and takes over where it has come. In between, each island is advanced by the least method that is right for it (`islands`).

use super::contact::Contact;
use super::events::{Item, Scene};
use super::impulse::Impulse;
use super::islands::{Choice, Tick};
use super::pile::{Axis, Other};
use super::scratch::{Happened, Scratch};
use super::tuning::{REPORT_SPEED, SLOP};
use super::world::{Event, Methods, Obstacle, State, World};
use super::{Body, BodyId};
use glam::DVec2;

/// Relative to all that contacts exert on a body: what rounding leaves of their balance with what acts on it besides.
const BALANCED: f64 = 1e-9;

/// m. What is nearer to a surface that changes is looked at.
const MARGIN: f64 = 1e-3;

impl World {
    /// Advances the world by exactly one tick of `dt` seconds.
    pub fn step(&mut self, dt: f64) {
        let worked = self.worked();
        self.scratch.begin_tick(self.state.bodies.len(), self.pile.looked_at());
        self.clear_records();
        self.bring_back_surfaces();
        self.move_surfaces(dt);
        self.say_what_acts(dt);
        let Self { state, records, plan, scratch, pile, .. } = self;
        let lists = self.asked.replace(false);
        let guards = &mut records.guards;
        let scene = Scene::of(state, plan, dt);
        pile.step_with(dt, &mut Tick { state, scene, guards, scratch, lists });
        records.guards.add(&pile.take_guards());
        records.guards.flows_ended_early += state.media.take_ended_early();
        self.commit(dt);
        self.record();
        self.go_on_paths(dt);
        self.records.work = self.worked() - worked;
        #[cfg(all(feature = "validate", debug_assertions))]
        self.assert_valid();
    }

    /// What has been counted from the beginning, in units of work.
    fn worked(&self) -> u64 {
        let events = &self.scratch.events;
        self.state.media.spent() + events.solving() + events.total
    }

    /// For tests: it is in no other build.
    ///
    /// # Panics
    /// [`World::validate`] finds something.
    #[cfg(all(feature = "validate", debug_assertions))]
    fn assert_valid(&mut self) {
        let mut checks = std::mem::take(&mut self.scratch.checks);
        if let Err(fault) = self.validate_with(&mut checks) {
            panic!("after tick {}: {fault}", self.state.ticks);
        }
        self.scratch.checks = checks;
    }

    /// The forces before the first tick, of worlds that are not too large to be looked at as one island.
    ///
    /// All touch all for this once, which takes time with the square of their number.
    pub(super) fn begin(&mut self) {
        let Self { state, plan, scratch, .. } = self;
        let n = state.bodies.len();
        if n == 0 || n > Choice::MOST_AT_FIRST {
            return;
        }
        let scene = Scene::of(state, plan, 0.0);
        scratch.begin(n);
        scratch.members.extend(0..n as u32);
        scratch.surfaces.extend(0..state.surfaces.len() as u32);
        scratch.gather(state, &scene, |_| super::Aabb::around(DVec2::ZERO, DVec2::splat(f64::MAX)));
        scratch.events.begin_world(&scene);
        scratch.take_contacts(state);
        state.contacts.extend(scratch.contacts.drain(..).map(|(_, contact)| contact));
        scratch.starts.clear();
        for item in &scratch.events.items[..n] {
            state.bodies[item.id as usize].acceleration = item.solved + DVec2::ZERO;
        }
    }

    fn clear_records(&mut self) {
        self.records.events.clear();
        self.records.impulses.clear();
        self.records.corners.clear();
        for &i in self.pile.looked_at() {
            if !self.pile.is_sleeping(i as usize) {
                self.records.previous[i as usize] = self.state.bodies[i as usize].position;
            }
        }
    }

    /// Something about a body, or what it touches, has changed: it has to be looked at.
    pub(super) fn disturb(&mut self, body: u32) {
        self.state.held[body as usize] = None;
        self.look_again(body);
    }

    /// What pulls at a body may have changed: it has to be looked at.
    pub(super) fn look_again(&mut self, body: u32) {
        let i = body as usize;
        self.state.known[i] = false;
        self.pile.wake(i);
        self.records.previous[i] = self.state.bodies[i].position;
    }

    /// Something about a surface has changed: whatever touches it has to be looked at.
    pub(super) fn disturb_around(&mut self, surface: usize) {
        let bounds = self.state.surfaces[surface].bounds;
        self.disturb_in(&bounds);
    }

    /// Something about a place has changed: whatever touches it has to be looked at.
    pub(super) fn disturb_in(&mut self, bounds: &super::Aabb) {
        for i in 0..self.state.bodies.len() {
            if self.state.bodies[i].bounds().touches(bounds, MARGIN) {
                self.disturb(i as u32);
            }
        }
    }

    /// Brings back surfaces that are wanted and in the way of nothing.
    fn bring_back_surfaces(&mut self) {
        for k in (0..self.awaited.len()).rev() {
            let s = self.awaited[k] as usize;
            let surface = &self.state.surfaces[s];
            let free = |body: &Body| !body.bounds().overlaps(&surface.bounds, SLOP);
            let awaited = surface.wanted && !surface.present;
            if awaited && !self.state.bodies.iter().all(free) {
                continue;
            }
            self.awaited.swap_remove(k);
            if awaited {
                self.state.surfaces[s].present = true;
                self.pile.set_present(s, true);
                self.disturb_around(s);
            }
        }
    }

    /// Tells where surfaces go, and wakes whatever one may touch that moves within the next `dt` seconds.
    fn move_surfaces(&mut self, dt: f64) {
        for k in 0..self.on_paths.len() {
            let s = self.on_paths[k] as usize;
            let surface = &self.state.surfaces[s];
            if !surface.concerns(dt) {
                continue;
            }
            let swept = surface.swept(dt);
            if surface.moves_within(dt) {
                self.pile.lead_surface(s, surface.at(dt).offset, Some(surface.arrives(dt)));
                self.pile.sweep_surface(s, &swept);
            }
            for i in 0..self.state.bodies.len() {
                if self.state.bodies[i].bounds().touches(&swept, MARGIN) {
                    self.disturb(i as u32);
                }
            }
        }
    }

    fn go_on_paths(&mut self, dt: f64) {
        for &s in &self.on_paths {
            let surface = &mut self.state.surfaces[s as usize];
            let stop = self.scratch.stop_of(s);
            surface.go_on(dt.min(stop));
            if stop < dt {
                self.pile.place_surface(s as usize, surface.bounds.centre());
            }
        }
    }

    /// Counts the impacts of each island, with the smallest of its bodies.
    fn count_hits(&mut self) {
        let Self { scratch, pile, .. } = self;
        let Scratch { after, happened, .. } = &mut **scratch;
        happened.iter().for_each(|happened| after[happened.island as usize].hits += 1);
        for hit in pile.impacts() {
            let of = after[hit.a];
            if of.dense {
                after[of.leader as usize].hits += 1;
            }
        }
    }

    /// Makes what the islands came to the state of the world.
    fn commit(&mut self, dt: f64) {
        self.count_hits();
        let Self { state, scratch, pile, .. } = self;
        let State { bodies, known, held, media, drives, pauses, ahead, ticks, .. } = state;
        for &i in pile.looked_at() {
            let i = i as usize;
            let after = &scratch.after[i];
            let body = &mut bodies[i];
            let moves = body.velocity != DVec2::ZERO || pile.velocity(i) != DVec2::ZERO;
            pauses[i].go_on(after, moves, scratch.after[after.leader as usize].hits, *ticks);
            if after.members == 0 && pile.is_sleeping(i) {
                continue;
            }
            if let Some(ahead) = ahead.get_mut(i) {
                ahead.alone = after.members == 0 && ahead.law.wet;
            }
            (body.position, body.velocity) = (pile.position(i), pile.velocity(i));
            (known[i], held[i]) = (after.known, after.held);
            if after.members == 0 {
                // It flew by itself.
                let pull = scratch.pulls[i];
                body.acceleration =
                    pull.unwrap_or_else(|| media.acceleration_under(body, scratch.force_on(media, i, body, drives[i])));
                known[i] = true;
            } else if after.dense {
                // What contacts add is known when they are listed.
                body.acceleration = media.acceleration_under(body, scratch.force_on(media, i, body, drives[i]));
            } else {
                body.acceleration = after.acceleration;
            }
        }
        *ticks += 1;
        self.scratch.fresh.clear();
        self.scratch.fresh.extend(self.scratch.contacts.iter().map(|&(_, contact)| contact));
        self.commit_dense(dt);
        self.count_methods();
        self.take_contacts();
    }

    /// Counts by which method how many bodies were advanced.
    fn count_methods(&mut self) {
        let aside = self.state.bodies.len() - self.pile.looked_at().len();
        let mut methods = Methods { asleep: aside as u32, ..Methods::default() };
        for &i in self.pile.looked_at() {
            let (i, after) = (i as usize, &self.scratch.after[i as usize]);
            let count = match (after.members, after.dense) {
                (0, _) if self.pile.is_sleeping(i) => &mut methods.asleep,
                (0, _) => &mut methods.free,
                (_, false) => &mut methods.by_events,
                (_, true) => &mut methods.in_one_step,
            };
            *count += 1;
        }
        self.records.methods = methods;
    }

    /// Lists the contacts of what was advanced by the dense method: what lasts as forces, what hit as impulses; and makes the accelerations
    /// those that the forces listed come to.
    fn commit_dense(&mut self, dt: f64) {
        let Self { state, scratch, pile, records, .. } = self;
        let n = state.bodies.len();
        scratch.pressed.resize(n, 0.0);
        pile.looked_at().iter().for_each(|i| scratch.pressed[*i as usize] = 0.0);
        for contact in pile.listed() {
            let a = contact.a;
            if scratch.after[a].members == 0 || !scratch.after[a].dense {
                continue;
            }
            let (b, other) = match contact.b {
                Other::Body(b) => (b as u32, Obstacle::Body(BodyId(b as u32))),
                Other::Surface(s) => ((n + s) as u32, Obstacle::Surface(s as u32)),
            };
            let axis = usize::from(contact.axis == Axis::Gravity);
            let mut vector = DVec2::ZERO;
            (vector[axis], vector[1 - axis]) = (contact.normal, contact.friction);
            if contact.impact {
                let impulse = Impulse { a: BodyId(a as u32), b: other, vector, point: contact.point, at: dt };
                let mut normal = DVec2::ZERO;
                normal[axis] = contact.normal.signum();
                let at = |item: u32| state.bodies.get(item as usize).map_or(contact.point, |body| body.position);
                let places = [at(a as u32), at(b)];
                let order = scratch.happened.len() as u32;
                scratch.happened.push(Happened { island: u32::MAX, order, impulse, normal, speed: 0.0, places });
            } else {
                let (lo, hi) = if contact.normal < 0.0 { (a as u32, b) } else { (b, a as u32) };
                let sign = if contact.normal < 0.0 { -1.0 } else { 1.0 };
                let mut lasting = Contact { lasts: true, ..Contact::between(lo, hi, axis) };
                (lasting.normal, lasting.friction) = (contact.normal.abs() / dt, sign * contact.friction / dt);
                (lasting.static_friction, lasting.kinetic_friction) = state.friction_of(a, contact.b);
                scratch.fresh.push(lasting);
                let mut felt = DVec2::ZERO;
                (felt[axis], felt[1 - axis]) = (contact.normal / dt, contact.friction / dt);
                for (item, sign) in [(a, 1.0), (b as usize, -1.0)] {
                    if let Some(body) = state.bodies.get_mut(item) {
                        scratch.pressed[item] += felt.length();
                        body.acceleration += felt * (sign / body.mass);
                    }
                }
            }
        }
        // What rests, rests exactly; unless part of what held it was an impact, which is no force.
        for &i in pile.looked_at().iter().filter(|i| scratch.after[**i as usize].dense) {
            let i = i as usize;
            let body = &mut state.bodies[i];
            let rests = body.velocity == DVec2::ZERO && body.position == records.previous[i];
            if rests && (body.mass * body.acceleration).length() <= BALANCED * scratch.pressed[i] {
                body.acceleration = DVec2::ZERO;
            }
        }
        for hit in pile.impacts() {
            if scratch.after[hit.a].dense && hit.speed >= REPORT_SPEED {
                let axis = usize::from(hit.axis == Axis::Gravity);
                let (b, at) = match hit.b {
                    Other::Body(b) => (Obstacle::Body(BodyId(b as u32)), state.bodies[b].bounds()),
                    Other::Surface(s) => (Obstacle::Surface(s as u32), state.surfaces[s].bounds),
                };
                let mine = state.bodies[hit.a].bounds();
                let mut normal = DVec2::ZERO;
                normal[axis] = if mine.centre()[axis] < at.centre()[axis] { -1.0 } else { 1.0 };
                let point = (mine.min.max(at.min) + mine.max.min(at.max)) * 0.5;
                records.events.push(Event::Impact { a: BodyId(hit.a as u32), b, point, normal, speed: hit.speed });
            }
        }
        for squeeze in pile.squeezed() {
            let force = state.bodies[squeeze.body].crushing_force(squeeze.speed);
            scratch.crushed.push((u32::MAX, squeeze.body as u32, squeeze.surface as u32, force));
        }
    }

    /// Lists what happened, in the order of its times.
    fn record(&mut self) {
        let Self { scratch, records, .. } = self;
        scratch.happened.sort_unstable_by(|a, b| a.impulse.at.total_cmp(&b.impulse.at).then(a.order.cmp(&b.order)));
        for happened in &scratch.happened {
            let Happened { impulse, normal, speed, places, .. } = *happened;
            records.impulses.push(impulse);
            records.corners.push((impulse.a.0, impulse.at, places[0]));
            if let Obstacle::Body(b) = impulse.b {
                records.corners.push((b.0, impulse.at, places[1]));
            }
            if speed >= REPORT_SPEED {
                let (a, b, point) = (impulse.a, impulse.b, impulse.point);
                records.events.push(Event::Impact { a, b, point, normal, speed });
            }
        }
        for &(_, body, by, force) in &scratch.crushed {
            records.events.push(Event::Crushed { body: BodyId(body), by, force });
        }
    }
}

impl State {
    /// The coefficients with which a pair slides, static and kinetic: a surface gives its own, two bodies the smaller of theirs.
    fn friction_of(&self, a: usize, b: Other) -> (f64, f64) {
        let mine = self.bodies[a].material;
        match b {
            Other::Surface(s) => (self.surfaces[s].material.static_friction, self.surfaces[s].material.kinetic_friction),
            Other::Body(b) => {
                let other = self.bodies[b].material;
                (mine.static_friction.min(other.static_friction), mine.kinetic_friction.min(other.kinetic_friction))
            }
        }
    }
}

impl Item {
    /// Whether nothing moved it in this tick.
    pub(super) fn rests(&self, before: DVec2) -> bool {
        self.is_still() && self.body.position == before
    }
}
