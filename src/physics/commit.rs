//! The end of a tick: poses, accelerations, contacts, impacts and events of all methods become those of the state and its records.

use crate::physics::data::{Aabb, BALANCED, BodyId, Coefficients, Contact, Hit, Impulse, NONE, Obstacle, REPORT_SPEED, on_axis};
use crate::physics::{crowd::ContactImpulse, crowd::CrowdImpact, space::Space, state::Event, state::State};
use crate::physics::{store::motions::Method, world::World};
use glam::DVec2;

impl World {
    pub(super) fn commit(&mut self, dt: f64) {
        self.commit_bodies();
        let Self { state, scratch, space, .. } = self;
        for member in &scratch.linked {
            let i = member.id as usize;
            if space.motions.bodies[i].method != Method::Events {
                let force = state.forces[i].push() + state.links.on(member.id, |id| state.pose_of(id));
                let acceleration = state.media.acceleration_under(&state.bodies[i], force);
                state.bodies[i].acceleration = if member.rests { DVec2::ZERO } else { acceleration };
            }
        }
        scratch.fresh.clear();
        scratch.fresh.extend(scratch.contacts.iter().map(|&(_, contact)| contact));
        self.commit_dense(dt);
        self.take_contacts();
    }

    fn commit_bodies(&mut self) {
        let Self { state, plan, space, records, .. } = self;
        let State { bodies, known, media, forces, .. } = state;
        let (bare, in_air) = (!plan.media(), media.fluids.is_empty() && !plan.streams);
        let methods = &mut records.methods;
        methods.asleep = space.sleep.sleepers as u32;
        for i in space.sleep.looked_at.iter().map(|i| *i as usize) {
            let (body, motion) = (&mut bodies[i], &mut space.motions.bodies[i]);
            let before = (body.position, body.velocity);
            space.motions.before[i] = before;
            (body.position, body.velocity) = motion.end;
            let sleeps = space.sleep.asleep[i];
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
            body.acceleration = match motion.method {
                Method::Linked | Method::Events => motion.acceleration,
                Method::Flight if motion.pulled => motion.acceleration,
                // A body at rest is held by contacts that were not listed.
                Method::Crowd if !motion.listed && motion.end == (before.0, DVec2::ZERO) => DVec2::ZERO,
                _ if bare => motion.pull,
                _ if in_air => motion.pull + DVec2::ZERO - body.velocity * space.motions.drags[i].rate(body.velocity),
                _ => media.acceleration_under(body, forces[i].push()),
            };
        }
        methods.free = bodies.len() as u32 - methods.asleep - methods.by_events - methods.in_one_step;
    }

    /// Lists the contacts of the crowd step, lasting ones as forces and impacts as impulses; the accelerations are those of the forces listed.
    fn commit_dense(&mut self, dt: f64) {
        let Self { state, scratch, space, records, .. } = self;
        let n = state.bodies.len();
        list_crowd_hits(state, space, &mut records.events);
        let (listed, motions) = (&space.crowd.dense.report.list, &space.motions.bodies);
        let listed = || listed.iter().filter(|contact| motions[contact.a as usize].method == Method::Crowd);
        let ends = || listed().flat_map(|contact| [contact.a as usize, contact.b as usize]).filter(|item| *item < n);
        scratch.pressed.resize(n, 0.0);
        ends().for_each(|body| scratch.pressed[body] = 0.0);
        for &ContactImpulse { a, b, axis, normal, friction, point, impact, .. } in listed() {
            let vector = on_axis(axis, normal, friction);
            if impact {
                let impulse = Impulse { a: BodyId(a), b: state.obstacle(b), vector, point, at: dt, impact: true };
                let at = |item: u32| state.bodies.get(item as usize).map_or(point, |body| body.position);
                let hit = Hit { impulse, normal: on_axis(axis, normal.signum(), 0.0), speed: 0.0, places: [at(a), at(b)] };
                scratch.happened.push((NONE, scratch.happened.len() as u32, hit));
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
        // Rest is exact; unless part of what held the body was an impact, which is no force.
        for i in ends() {
            let body = &mut state.bodies[i];
            let rests = body.velocity == DVec2::ZERO && body.position == space.motions.before[i].0;
            if rests && (body.mass * body.acceleration).length() <= BALANCED * scratch.pressed[i] {
                body.acceleration = DVec2::ZERO;
            }
        }
    }

    pub(super) fn record(&mut self) {
        let Self { scratch, records, .. } = self;
        scratch.happened.sort_unstable_by(|a, b| a.2.impulse.at.total_cmp(&b.2.impulse.at).then(a.1.cmp(&b.1)));
        for &(.., Hit { impulse, normal, speed, places }) in &scratch.happened {
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
        let crushed = |&(_, body, by, force): &(u32, u32, u32, f64)| Event::Crushed { body: BodyId(body), by, force };
        records.events.extend(scratch.crushed.iter().map(crushed));
    }

    /// Puts the contacts that this tick has found in place of those known of the same bodies. Sleeping bodies keep theirs.
    pub(crate) fn take_contacts(&mut self) {
        let Self { state, scratch, space, .. } = self;
        if state.contacts.is_empty() && scratch.fresh.is_empty() {
            return;
        }
        put_in_order(&mut scratch.fresh);
        let same_face = |(old, new): (&Contact, &Contact)| (old.lo, old.hi, old.axis) == (new.lo, new.hi, new.axis);
        if state.contacts.len() == scratch.fresh.len() && state.contacts.iter().zip(&scratch.fresh).all(same_face) {
            return state.contacts.copy_from_slice(&scratch.fresh);
        }
        scratch.index(state);
        let advanced = |body: u32| space.motions.bodies[body as usize].method != Method::Flight;
        let over = |body: u32| !space.sleep.asleep[body as usize] || advanced(body);
        let of = |body: u32| scratch.starts[body as usize] as usize..scratch.starts[body as usize + 1] as usize;
        let before: usize = space.sleep.looked_at.iter().filter(|body| over(**body)).map(|body| of(*body).len()).sum();
        let alike = |new: &[Contact]| {
            let old = &state.contacts[of(new[0].ends().0)];
            old.len() == new.len() && old.iter().zip(new).all(same_face)
        };
        let by_body = |a: &Contact, b: &Contact| a.ends().0 == b.ends().0;
        if before == scratch.fresh.len() && scratch.fresh.chunk_by(by_body).all(alike) {
            for new in scratch.fresh.chunk_by(by_body) {
                state.contacts[of(new[0].ends().0)].copy_from_slice(new);
            }
            return;
        }
        state.contacts.retain(|contact| !over(contact.ends().0));
        let sorted = state.contacts.is_empty();
        state.contacts.extend_from_slice(&scratch.fresh);
        if !sorted {
            put_in_order(&mut state.contacts);
        }
        scratch.starts.clear();
    }
}

fn list_crowd_hits(state: &State, space: &Space, events: &mut Vec<Event>) {
    for hit in &space.impacts {
        let CrowdImpact { a, b, axis, speed, .. } = *hit;
        if space.motions.bodies[a as usize].method == Method::Crowd && speed >= REPORT_SPEED {
            let (mine, at) = (state.bounds_of(a), state.bounds_of(b));
            let normal = on_axis(axis, if mine.centre()[axis] < at.centre()[axis] { -1.0 } else { 1.0 }, 0.0);
            let point = mine.shared_middle(&at);
            events.push(Event::Impact { a: BodyId(a), b: state.obstacle(b), point, normal, speed });
        }
    }
}

impl State {
    fn coefficients(&self, a: u32, b: u32) -> Coefficients {
        let mine = self.bodies[a as usize].coefficients();
        match self.obstacle(b) {
            Obstacle::Surface(s) => mine.with(self.surfaces[s as usize].material.coefficients(), true),
            Obstacle::Body(b) => mine.with(self.bodies[b.index()].coefficients(), false),
        }
    }

    pub(crate) fn obstacle(&self, item: u32) -> Obstacle {
        let surface = item.checked_sub(self.bodies.len() as u32);
        surface.map_or(Obstacle::Body(BodyId(item)), Obstacle::Surface)
    }

    pub(crate) fn bounds_of(&self, item: u32) -> Aabb {
        match self.obstacle(item) {
            Obstacle::Surface(s) => self.surfaces[s as usize].bounds,
            Obstacle::Body(b) => self.bodies[b.index()].bounds(),
        }
    }
}

/// Sorts contacts, and makes one of those at a face: crowds list push and friction apart. The key is total, as sorts treat equals by their number.
fn put_in_order(contacts: &mut Vec<Contact>) {
    if contacts.is_sorted_by(|a, b| (a.ends(), a.axis) < (b.ends(), b.axis)) {
        return;
    }
    contacts.sort_unstable_by(|a, b| {
        let face = (a.ends(), a.axis).cmp(&(b.ends(), b.axis));
        face.then(b.normal.total_cmp(&a.normal)).then(a.friction.total_cmp(&b.friction)).then(a.lo.cmp(&b.lo))
    });
    contacts.dedup_by(|next, kept| {
        let turned = next.lo != kept.lo;
        let joins = next.ends() == kept.ends() && next.axis == kept.axis && (!turned || next.normal == 0.0);
        if joins {
            kept.normal += next.normal;
            kept.friction += if turned { -next.friction } else { next.friction };
        }
        joins
    });
}
