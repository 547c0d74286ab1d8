//! How a tick goes, phase by phase.

use super::contact::Contact;
use super::events::{Events, Item, Motion, Outcome, Scene};
use super::impulse::Impulse;
use super::scratch::{After, Happened, Scratch, Stop};
use super::tuning::{REPORT_SPEED, SLOP};
use super::world::{Event, Obstacle, State, World};
use super::{Aabb, Body, BodyId};
use glam::DVec2;

/// How often islands are sought again in one tick because a body may go further than foreseen. After that all there is is looked at.
const MOST_SEARCHES: u32 = 8;
/// How often islands are advanced anew in one tick until they agree when surfaces stop that several of them meet. After that these stand
/// still for the whole tick.
const MOST_ROUNDS: u32 = 8;
/// m. A box in which others are looked for reaches this much further than the way that is foreseen.
const MARGIN: f64 = 1e-3;
/// m. Beyond all that there is.
const EVERYWHERE: f64 = 1e13;

impl World {
    /// Advances the world by exactly one tick of `dt` seconds.
    pub fn step(&mut self, dt: f64) {
        let mut scratch = std::mem::take(&mut self.scratch);
        self.clear_records();
        self.bring_back_surfaces();
        self.wake_around_moving_surfaces(dt);
        scratch.stops.clear();
        if self.state.resting.iter().any(|rests| !rests) {
            self.sweep(&mut scratch, dt);
            self.advance_islands(&mut scratch, dt);
            self.commit(&mut scratch);
        }
        self.go_on_paths(&scratch, dt);
        self.scratch = scratch;
    }

    /// The forces before the first tick.
    pub(super) fn begin(&mut self) {
        let mut scratch = std::mem::take(&mut self.scratch);
        self.sweep(&mut scratch, 0.0);
        self.advance_islands(&mut scratch, 0.0);
        self.commit(&mut scratch);
        self.state.known.fill(false);
        self.state.resting.fill(false);
        self.scratch = scratch;
    }

    fn clear_records(&mut self) {
        self.records.events.clear();
        self.records.impulses.clear();
        self.records.corners.clear();
        for ((previous, body), rests) in self.records.previous.iter_mut().zip(&self.state.bodies).zip(&self.state.resting) {
            if !rests {
                *previous = body.position;
            }
        }
    }

    /// Something about a body has changed: it has to be looked at.
    pub(super) fn disturb(&mut self, body: u32) {
        self.state.known[body as usize] = false;
        self.state.resting[body as usize] = false;
        self.records.previous[body as usize] = self.state.bodies[body as usize].position;
    }

    /// Something about a surface has changed: whatever touches it has to be looked at.
    pub(super) fn disturb_around(&mut self, surface: usize) {
        let bounds = self.state.surfaces[surface].bounds;
        for i in 0..self.state.bodies.len() {
            if self.state.bodies[i].bounds().touches(&bounds, MARGIN) {
                self.disturb(i as u32);
            }
        }
    }

    /// Brings back surfaces that are wanted and in the way of nothing.
    fn bring_back_surfaces(&mut self) {
        for s in 0..self.state.surfaces.len() {
            let surface = &self.state.surfaces[s];
            let free = |body: &Body| !body.bounds().overlaps(&surface.bounds, SLOP);
            if surface.wanted && !surface.present && self.state.bodies.iter().all(free) {
                self.state.surfaces[s].present = true;
                self.disturb_around(s);
            }
        }
    }

    /// Wakes whatever a surface may touch that moves within the next `dt` seconds.
    fn wake_around_moving_surfaces(&mut self, dt: f64) {
        for s in 0..self.state.surfaces.len() {
            if !self.state.surfaces[s].moves_within(dt) {
                continue;
            }
            let swept = self.state.surfaces[s].swept(dt);
            for i in 0..self.state.bodies.len() {
                if self.state.bodies[i].bounds().touches(&swept, MARGIN) {
                    self.disturb(i as u32);
                }
            }
        }
    }

    fn go_on_paths(&mut self, scratch: &Scratch, dt: f64) {
        for (s, surface) in (0..).zip(&mut self.state.surfaces) {
            surface.go_on(dt.min(scratch.stop_of(s)));
        }
    }

    /// Where each body may get to: along its way under all that acts on it now, and as far as others of its island may throw it.
    fn sweep(&mut self, scratch: &mut Scratch, dt: f64) {
        let State { bodies, media, drives, resting, contacts, surfaces, .. } = &self.state;
        scratch.searched.clear();
        scratch.searched.extend((0..bodies.len()).map(|i| {
            let body = &bodies[i];
            if resting[i] {
                // What rests near it is not looked at until it moves at all.
                return body.bounds();
            }
            let pull = (drives[i] / body.mass).abs() + DVec2::new(0.0, media.gravity.abs()) + body.acceleration.abs();
            grow(&body.bounds(), body.velocity.abs() * dt + pull * (dt * dt) + MARGIN)
        }));
        scratch.resting.clone_from(resting);
        scratch.islands.find(&scratch.searched, resting, contacts);
        let pushing = surfaces.iter().map(|surface| surface.velocity.abs()).fold(DVec2::ZERO, DVec2::max);
        let mut members = scratch.islands.members.as_slice();
        while let Some(&(leader, _)) = members.first() {
            let (island, rest) = members.split_at(members.iter().take_while(|member| member.0 == leader).count());
            members = rest;
            if island.len() == 1 {
                continue;
            }
            let fastest = island.iter().map(|member| bodies[member.1 as usize].velocity.abs()).fold(pushing, DVec2::max);
            for member in island {
                let i = member.1 as usize;
                let reach = grow(&bodies[i].bounds(), 2.0 * fastest * dt + MARGIN);
                scratch.searched[i] = scratch.searched[i].union(&reach);
                scratch.resting[i] = false;
            }
        }
        scratch.islands.find(&scratch.searched, &scratch.resting, contacts);
    }

    /// Advances island by island. Where a body may go further than others were looked for, the islands are sought again, and those advanced
    /// anew that have become others. So are those that met a surface which another island has stopped.
    fn advance_islands(&mut self, scratch: &mut Scratch, dt: f64) {
        scratch.begin(self.state.bodies.len());
        let (mut searches, mut rounds) = (0, 0);
        loop {
            let members = std::mem::take(&mut scratch.islands.members);
            let mut left = members.as_slice();
            let mut grown = false;
            while let Some(&(leader, _)) = left.first() {
                let (island, rest) = left.split_at(left.iter().take_while(|member| member.0 == leader).count());
                left = rest;
                if !scratch.is_done(island) {
                    scratch.discard(island);
                    grown |= !self.advance_island(scratch, island, dt);
                }
            }
            scratch.islands.members = members;
            if grown && searches < MOST_SEARCHES {
                self.widen(scratch, searches, dt);
                scratch.islands.find(&scratch.searched, &scratch.resting, &self.state.contacts);
                searches += 1;
            } else if scratch.agree_on_stops(rounds >= MOST_ROUNDS) {
                return;
            } else {
                rounds += 1;
            }
        }
    }

    /// Widens the search of all islands that have not been advanced.
    fn widen(&mut self, scratch: &mut Scratch, searches: u32, dt: f64) {
        let everywhere = Aabb::around(DVec2::ZERO, DVec2::splat(EVERYWHERE));
        for &(_, body) in &scratch.islands.members {
            let i = body as usize;
            if scratch.after[i].members == 0 {
                scratch.resting[i] = false;
                self.records.guards.islands_grown += 1;
                let reach = scratch.searched[i].size() + (self.state.bodies[i].velocity.abs() * dt);
                scratch.searched[i] = if searches + 1 >= MOST_SEARCHES { everywhere } else { grow(&scratch.searched[i], reach) };
            }
        }
    }

    /// Advances one island by the event-driven method. Returns whether that could be done within where others were looked for.
    fn advance_island(&mut self, scratch: &mut Scratch, island: &[(u32, u32)], dt: f64) -> bool {
        let Self { state, records, plan, .. } = self;
        let scene = Scene {
            media: &state.media,
            rest_speed: state.rest_speed,
            bounces: plan.bounces,
            direct: plan.direct,
            surfaces: &state.surfaces,
            tick: dt,
        };
        gather(state, scratch, island, &scene);
        let outcome = scratch.events.advance(&scene);
        records.guards.add(&std::mem::take(&mut scratch.events.guards));
        if outcome == Outcome::Grown {
            return false;
        }
        if let Outcome::Busy(_) = outcome {
            records.guards.budgets_used_up += 1;
        }
        scatter(state, scratch, island, outcome == Outcome::Done, dt);
        true
    }

    /// Makes what the islands came to the state of the world.
    fn commit(&mut self, scratch: &mut Scratch) {
        let n = self.state.bodies.len();
        self.state.contacts.retain(|contact| {
            let body = contact.lo.min(contact.hi) as usize;
            scratch.after[body].members == 0
        });
        self.state.contacts.extend(scratch.contacts.iter().map(|&(_, contact)| contact));
        self.state.contacts.sort_unstable_by_key(|contact| contact.ends());
        for i in 0..n {
            let after = &scratch.after[i];
            if after.members > 0 {
                let body = &mut self.state.bodies[i];
                (body.position, body.velocity, body.acceleration) = (after.position, after.velocity, after.acceleration);
                self.state.known[i] = after.known;
                self.state.resting[i] = self.plan.direct && after.still && body.position == self.records.previous[i];
            }
        }
        self.keep_groups_awake(n);
        self.record(scratch);
    }

    /// Of a group that contacts join all rest or none.
    fn keep_groups_awake(&mut self, n: usize) {
        let State { contacts, resting, surfaces, .. } = &mut self.state;
        let mut changed = true;
        while changed {
            changed = false;
            for contact in contacts.iter() {
                let (a, b) = (contact.lo.min(contact.hi) as usize, contact.lo.max(contact.hi) as usize);
                let other = if b < n { resting[b] } else { surfaces[b - n].velocity == DVec2::ZERO };
                if resting[a] != other {
                    changed |= resting[a] || (b < n && resting[b]);
                    resting[a] = false;
                    if b < n {
                        resting[b] = false;
                    }
                }
            }
        }
    }

    /// Lists what happened, in the order of its times.
    fn record(&mut self, scratch: &mut Scratch) {
        scratch.happened.sort_unstable_by(|a, b| a.impulse.at.total_cmp(&b.impulse.at).then(a.order.cmp(&b.order)));
        for happened in &scratch.happened {
            let Happened { impulse, normal, speed, places, .. } = *happened;
            self.records.impulses.push(impulse);
            self.records.corners.push((impulse.a.0, impulse.at, places[0]));
            if let Obstacle::Body(b) = impulse.b {
                self.records.corners.push((b.0, impulse.at, places[1]));
            }
            if speed >= REPORT_SPEED {
                let (a, b, point) = (impulse.a, impulse.b, impulse.point);
                self.records.events.push(Event::Impact { a, b, point, normal, speed });
            }
        }
        for &(_, body, by, force) in &scratch.crushed {
            self.records.events.push(Event::Crushed { body: BodyId(body), by, force });
        }
    }
}

/// A box that reaches further to all sides.
fn grow(bounds: &Aabb, reach: DVec2) -> Aabb {
    Aabb::new(bounds.min - reach, bounds.max + reach)
}

/// Fills the island of the event-driven method: its bodies, the surfaces and streams near them, and the contacts known.
fn gather(state: &State, scratch: &mut Scratch, island: &[(u32, u32)], scene: &Scene) {
    let n = state.bodies.len();
    let Scratch { events, searched, local, stops, .. } = scratch;
    events.clear();
    local.resize(n + state.surfaces.len(), u32::MAX);
    let mut everything = searched[island[0].1 as usize];
    for &(_, body) in island {
        let i = body as usize;
        local[i] = events.items.len() as u32;
        everything = everything.union(&searched[i]);
        let known = state.known[i];
        events.items.push(Item::body(body, &state.bodies[i], state.drives[i], searched[i], known));
    }
    events.movable = island.len();
    let near = |bounds: &Aabb| {
        // What has been resting is looked for where it is, which may be a rounding away from what it lies on.
        everything.touches(bounds, MARGIN) && island.iter().any(|member| searched[member.1 as usize].touches(bounds, MARGIN))
    };
    for (s, surface) in state.surfaces.iter().enumerate() {
        if surface.present && near(&surface.swept(scene.tick)) {
            local[n + s] = events.items.len() as u32;
            let mut item = Item::surface(s as u32, surface);
            item.stops_at = stops.iter().filter(|stop| stop.surface == s as u32).map(|stop| stop.at).fold(f64::INFINITY, f64::min);
            scene.set_on_path(&mut item, 0.0);
            events.items.push(item);
        }
    }
    events.streams.extend((0..).zip(&state.media.streams).filter(|(_, stream)| near(&stream.zone)).map(|(index, _)| index));
    for contact in &state.contacts {
        let (lo, hi) = (local[contact.lo as usize], local[contact.hi as usize]);
        if lo != u32::MAX && hi != u32::MAX {
            events.contacts.push(Contact { lo, hi, ..*contact });
        }
    }
    for item in &events.items {
        local[if item.surface { n + item.id as usize } else { item.id as usize }] = u32::MAX;
    }
}

/// Takes over what the island came to.
fn scatter(state: &State, scratch: &mut Scratch, island: &[(u32, u32)], known: bool, dt: f64) {
    let n = state.bodies.len() as u32;
    let leader = island[0].0;
    let Scratch { events, after, contacts, happened, stops, met, crushed, .. } = scratch;
    let Events { items, movable, .. } = events;
    let global = |item: u32| if items[item as usize].surface { n + items[item as usize].id } else { items[item as usize].id };
    for item in &items[..*movable] {
        after[item.id as usize] = After {
            position: item.body.position,
            velocity: item.body.velocity,
            acceleration: item.solved + DVec2::ZERO,
            still: item.motion == Motion::Still,
            known: known && item.known,
            members: island.len() as u32,
        };
    }
    for contact in &events.contacts {
        contacts.push((leader, Contact { lo: global(contact.lo), hi: global(contact.hi), ..*contact }));
    }
    for hit in &events.hits {
        let ((a, b), first_is_lo) = if hit.lo < hit.hi { ((hit.lo, hit.hi), true) } else { ((hit.hi, hit.lo), false) };
        let sign = if first_is_lo { -1.0 } else { 1.0 };
        let mut normal = DVec2::ZERO;
        normal[hit.axis] = sign;
        let other = &items[b as usize];
        let b = if other.surface { Obstacle::Surface(other.id) } else { Obstacle::Body(BodyId(other.id)) };
        let impulse = Impulse { a: BodyId(items[a as usize].id), b, vector: hit.impulse * sign, point: hit.point, at: hit.at };
        let places = if first_is_lo { hit.places } else { [hit.places[1], hit.places[0]] };
        happened.push(Happened { island: leader, order: happened.len() as u32, impulse, normal, speed: hit.speed, places });
    }
    for &(body, surface, speed) in &events.squeezed {
        let of = &items[body as usize];
        let by = &items[surface as usize];
        crushed.push((leader, of.id, by.id, of.body.mass * speed / dt));
        stops.push(Stop { leader, surface: by.id, at: by.stops_at });
    }
    for item in &items[*movable..] {
        if !state.surfaces[item.id as usize].def.path.is_still() {
            met.push(Stop { leader, surface: item.id, at: item.stops_at });
        }
    }
}
