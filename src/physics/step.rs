//! How a tick goes, phase by phase.
//!
//! Forces and surfaces first; then every awake body flies freely, the broad phase finds the pairs that may meet, and each island is advanced by
//! the least method that is right for it (`islands`). Last, the state takes over where all bodies end.

use crate::physics::crowd::CrowdImpact;
use crate::physics::crowd::impulses::ContactImpulse;
use crate::physics::data::tuning::{REPORT_SPEED, SLOP};
use crate::physics::data::{Aabb, Body, BodyId, Coefficients, Contact, Impulse, Obstacle};
use crate::physics::exact::Scene;
use crate::physics::exact::item::Item;
use crate::physics::islands::{Choice, Tick};
use crate::physics::scratch::{Happened, Scratch};
use crate::physics::space::Space;
use crate::physics::state::{Event, Methods, State};
use crate::physics::store::motions::Method;
use crate::physics::world::World;
use glam::DVec2;

/// Relative to all that contacts exert on a body: what rounding leaves of their balance with what acts on it besides.
const BALANCED: f64 = 1e-9;

/// m. What is nearer to a surface that changes is looked at.
const MARGIN: f64 = 1e-3;

impl World {
    /// Advances the world by exactly one tick of `dt` seconds.
    pub fn step(&mut self, dt: f64) {
        let before = self.scratch.events.total;
        let n = self.state.bodies.len();
        self.scratch.begin_tick(n);
        self.clear_records();
        (self.records.dt, self.records.flows_cut_short) = (dt, self.records.guards.flows_cut_short);
        self.bring_back_surfaces();
        self.space.begin_step();
        self.move_surfaces(dt);
        self.fly_linked(dt);
        self.records.methods = Methods { asleep: n as u32, ..Methods::default() };
        if self.space.is_stirred() {
            self.say_what_acts(dt);
            self.advance_islands(dt);
            self.commit(dt);
        }
        self.state.ticks += 1;
        self.record();
        self.go_on_paths(dt);
        self.records.followed = self.scratch.events.total - before;
        #[cfg(all(feature = "validate", debug_assertions))]
        self.assert_valid();
    }

    fn advance_islands(&mut self, dt: f64) {
        let Self { state, records, plan, scratch, space, .. } = self;
        let lists = self.asked.replace(false);
        let guards = &mut records.guards;
        let scene = Scene::of(state, plan, dt);
        let bare = !plan.media() && scratch.linked.is_empty();
        space.step_with(dt, &mut Tick { state, scene, guards, scratch, lists, bare });
        records.guards.add(&space.crowd.dense.take_guards());
        records.guards.flows_cut_short += state.media.take_ended_early();
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
    pub(crate) fn begin(&mut self) {
        let Self { state, plan, scratch, .. } = self;
        let n = state.bodies.len();
        if n == 0 || n > Choice::MOST_AT_FIRST {
            return;
        }
        let scene = Scene::of(state, plan, 0.0);
        scratch.begin(n);
        scratch.members.extend(0..n as u32);
        scratch.surfaces.extend(0..state.surfaces.len() as u32);
        scratch.gather(state, &scene, |_| Aabb::around(DVec2::ZERO, DVec2::splat(f64::MAX)));
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
    }

    /// Something about a body, or what it touches, has changed: it has to be looked at.
    pub(crate) fn disturb(&mut self, body: u32) {
        let i = body as usize;
        self.state.known[i] = false;
        self.space.sleep.wake(i);
    }

    /// Something about a surface has changed: whatever touches it has to be looked at.
    pub(crate) fn disturb_around(&mut self, surface: usize) {
        let bounds = self.state.surfaces[surface].bounds;
        self.disturb_in(&bounds);
    }

    /// Something about a place has changed: whatever touches it has to be looked at.
    pub(crate) fn disturb_in(&mut self, bounds: &Aabb) {
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
                self.space.set_present(s, true);
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
                self.space.lead_surface(s, (surface.at(dt).offset, surface.arrives(dt)), &swept, dt);
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
                self.space.place_surface(s as usize, surface.bounds.centre());
            }
        }
    }

    /// Makes what the islands came to the state of the world.
    fn commit(&mut self, dt: f64) {
        self.commit_bodies();
        let Self { state, scratch, space, .. } = self;
        for member in &scratch.linked {
            let i = member.id as usize;
            if space.motions.bodies[i].method != Method::Events {
                let force = state.forces[i].push() + state.links_on(member.id);
                state.bodies[i].acceleration = state.media.acceleration_under(&state.bodies[i], force);
            }
        }
        scratch.fresh.clear();
        scratch.fresh.extend(scratch.contacts.iter().map(|&(_, contact)| contact));
        self.commit_dense(dt);
        self.take_contacts();
    }

    /// Poses, and accelerations as the tick ends; what contacts of the crowd step add is known when they are listed. Counts by which method how
    /// many bodies were advanced.
    fn commit_bodies(&mut self) {
        let Self { state, plan, scratch, space, records, .. } = self;
        let State { bodies, known, media, forces, .. } = state;
        let bare = !plan.media();
        let methods = &mut records.methods;
        methods.asleep = space.sleep.sleepers() as u32;
        for i in space.sleep.looked_at().iter().map(|i| *i as usize) {
            let (body, motion) = (&mut bodies[i], &mut space.motions.bodies[i]);
            let before = (body.position, body.velocity);
            space.motions.before[i] = before;
            (body.position, body.velocity) = motion.end;
            let sleeps = space.sleep.sleeps(i);
            match motion.method {
                Method::Flight if sleeps => continue,
                Method::Flight => {}
                Method::Linked | Method::Events => methods.by_events += 1,
                Method::Crowd => methods.in_one_step += 1,
            }
            methods.asleep -= u32::from(sleeps);
            if plan.streams {
                media.feel(body, &mut forces[i]);
            }
            known[i] = motion.known;
            body.acceleration = match (motion.method, scratch.pulls[i]) {
                (Method::Linked | Method::Events, _) => motion.acceleration,
                (Method::Flight, Some(pull)) => pull,
                // What rests is held by contacts that were not listed.
                (Method::Crowd, _) if !motion.listed && motion.end == (before.0, DVec2::ZERO) => DVec2::ZERO,
                _ if bare => motion.pull,
                _ => media.acceleration_under(body, forces[i].push()),
            };
        }
        methods.free = bodies.len() as u32 - methods.asleep - methods.by_events - methods.in_one_step;
    }

    /// Lists the contacts of the crowd step: what lasts as forces, what hit as impulses; and makes the accelerations
    /// those that the forces listed come to.
    fn commit_dense(&mut self, dt: f64) {
        let Self { state, scratch, space, records, .. } = self;
        let n = state.bodies.len();
        list_crowd_hits(state, scratch, space, &mut records.events);
        let (listed, motions) = (&space.crowd.dense.report.list, &space.motions.bodies);
        let listed = || listed.iter().filter(|contact| motions[contact.a as usize].method == Method::Crowd);
        let ends = || listed().flat_map(|contact| [contact.a as usize, contact.b as usize]).filter(|item| *item < n);
        scratch.pressed.resize(n, 0.0);
        ends().for_each(|body| scratch.pressed[body] = 0.0);
        for &ContactImpulse { a, b, axis, normal, friction, point, impact, .. } in listed() {
            let mut vector = DVec2::ZERO;
            (vector[axis], vector[1 - axis]) = (normal, friction);
            if impact {
                let impulse = Impulse { a: BodyId(a), b: state.obstacle(b), vector, point, at: dt };
                let sign = normal.signum();
                let mut normal = DVec2::ZERO;
                normal[axis] = sign;
                let at = |item: u32| state.bodies.get(item as usize).map_or(point, |body| body.position);
                let places = [at(a), at(b)];
                let order = scratch.happened.len() as u32;
                scratch.happened.push(Happened { island: u32::MAX, order, impulse, normal, speed: 0.0, places });
            } else {
                let (lo, hi, sign) = if normal < 0.0 { (a, b, -1.0) } else { (b, a, 1.0) };
                let mut lasting = Contact { lasts: true, ..Contact::between(lo, hi, axis) };
                (lasting.normal, lasting.friction) = (normal.abs() / dt, sign * friction / dt);
                lasting.rub_with(state.coefficients(a, b));
                scratch.fresh.push(lasting);
                let felt = vector / dt;
                for (item, sign) in [(a as usize, 1.0), (b as usize, -1.0)] {
                    if let Some(body) = state.bodies.get_mut(item) {
                        scratch.pressed[item] += felt.length();
                        body.acceleration += felt * (sign / body.mass);
                    }
                }
            }
        }
        // What rests, rests exactly; unless part of what held it was an impact, which is no force.
        for i in ends() {
            let body = &mut state.bodies[i];
            let rests = body.velocity == DVec2::ZERO && body.position == space.motions.before[i].0;
            if rests && (body.mass * body.acceleration).length() <= BALANCED * scratch.pressed[i] {
                body.acceleration = DVec2::ZERO;
            }
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

/// Lists the impacts of crowds, and the bodies that surfaces would have squeezed.
fn list_crowd_hits(state: &State, scratch: &mut Scratch, space: &Space, events: &mut Vec<Event>) {
    for hit in &space.impacts {
        let CrowdImpact { a, b, axis, speed, .. } = *hit;
        if space.motions.bodies[a as usize].method == Method::Crowd && speed >= REPORT_SPEED {
            let (mine, at) = (state.bounds_of(a), state.bounds_of(b));
            let mut normal = DVec2::ZERO;
            normal[axis] = if mine.centre()[axis] < at.centre()[axis] { -1.0 } else { 1.0 };
            let point = (mine.min.max(at.min) + mine.max.min(at.max)) * 0.5;
            events.push(Event::Impact { a: BodyId(a), b: state.obstacle(b), point, normal, speed });
        }
    }
    for squeeze in &space.squeezed {
        let force = state.bodies[squeeze.body as usize].crushing_force(squeeze.speed);
        scratch.crushed.push((u32::MAX, squeeze.body, squeeze.surface, force));
    }
}

impl State {
    /// The coefficients of a body with another one or a surface.
    fn coefficients(&self, a: u32, b: u32) -> Coefficients {
        let mine = self.bodies[a as usize].coefficients();
        match self.obstacle(b) {
            Obstacle::Surface(s) => mine.with(self.surfaces[s as usize].material.coefficients(), true),
            Obstacle::Body(b) => mine.with(self.bodies[b.index()].coefficients(), false),
        }
    }

    /// An item of a contact.
    pub(crate) fn obstacle(&self, item: u32) -> Obstacle {
        let surface = item.checked_sub(self.bodies.len() as u32);
        surface.map_or(Obstacle::Body(BodyId(item)), Obstacle::Surface)
    }

    /// The box of an item of a contact.
    pub(crate) fn bounds_of(&self, item: u32) -> Aabb {
        match self.obstacle(item) {
            Obstacle::Surface(s) => self.surfaces[s as usize].bounds,
            Obstacle::Body(b) => self.bodies[b.index()].bounds(),
        }
    }
}

impl Item {
    /// Whether nothing moved it in this tick.
    pub(crate) fn rests(&self, before: DVec2) -> bool {
        self.is_still() && self.body.position == before
    }
}
