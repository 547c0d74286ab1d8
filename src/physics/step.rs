//! How a tick goes, phase by phase: `docs/physics.md` lists the stages.

use crate::physics::data::{Aabb, Body, Impulse, Part, SLOP, called};
use crate::physics::exact::Scene;
use crate::physics::{islands::MOST_AT_FIRST, islands::Tick, scratch::first_stop, state::Methods, state::Records, world::World};
use glam::DVec2;

/// m. Bodies nearer to a surface that changes are looked at.
const MARGIN: f64 = 1e-3;

impl World {
    /// Advances the world by exactly one tick of `dt` seconds.
    pub fn step(&mut self, dt: f64) {
        let before = self.scratch.events.total;
        self.state.ticks += 1;
        self.scratch.begun.clear();
        self.records.since = 0.0;
        self.records.flows_cut_short = self.records.guards.flows_cut_short;
        match if self.plan.links { self.state.links.parts(dt) } else { 1 } {
            1 => self.advance(dt),
            parts => self.advance_in_parts(dt / f64::from(parts), parts),
        }
        self.records.followed = self.scratch.events.total - before;
    }

    /// The parts of a tick that stiff links need, of `dt` seconds each. Its records are those of all parts.
    fn advance_in_parts(&mut self, dt: f64, parts: u32) {
        self.scratch.begun.extend((0..self.state.bodies.len() as u32).map(|id| self.state.pose_of(id)));
        for part in 0..parts {
            self.records.since = 0.0;
            self.advance(dt);
            self.records.since = f64::from(part) * dt;
            let Records { events, impulses, corners, since: from, .. } = &mut self.records;
            let whole = &mut self.scratch.whole;
            whole.events.append(events);
            whole.impulses.extend(impulses.drain(..).map(|hit| Impulse { at: *from + hit.at, ..hit }));
            whole.corners.extend(corners.drain(..).map(|(body, at, place)| (body, *from + at, place)));
        }
        let (records, whole) = (&mut self.records, &mut self.scratch.whole);
        records.events.append(&mut whole.events);
        records.impulses.append(&mut whole.impulses);
        records.corners.append(&mut whole.corners);
    }

    fn advance(&mut self, dt: f64) {
        let n = self.state.bodies.len();
        self.scratch.begin_tick();
        self.records.events.clear();
        self.records.impulses.clear();
        self.records.corners.clear();
        self.records.dt = dt;
        self.bring_back_surfaces();
        self.space.begin_step();
        if self.plan.moving {
            self.move_surfaces(dt);
        }
        if self.plan.links {
            self.fly_linked(dt);
        }
        self.records.methods = Methods { asleep: n as u32, ..Methods::default() };
        if self.space.is_stirred() {
            self.say_what_acts(dt);
            self.advance_islands(dt);
            self.commit(dt);
        }
        self.record();
        if self.plan.links {
            self.tend_links();
        }
        if self.plan.moving {
            self.go_on_paths(dt);
        }
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
        for (number, broken) in scratch.tried.drain(..) {
            let link = &mut state.links.all[number as usize];
            if std::mem::replace(&mut link.broken, broken) != broken {
                scratch.snapped.retain(|of| *of != number);
                scratch.snapped.extend(Some(number).filter(|_| broken));
            }
        }
        records.guards.add(&space.crowd.dense.take_guards());
        records.guards.flows_cut_short += state.media.take_ended_early();
    }

    /// Panics where [`World::validate`] finds something.
    #[cfg(all(feature = "validate", debug_assertions))]
    fn assert_valid(&mut self) {
        let mut checks = std::mem::take(&mut self.scratch.checks);
        if let Err(fault) = self.validate_with(&mut checks) {
            panic!("after tick {}: {fault}", self.state.ticks);
        }
        self.scratch.checks = checks;
    }

    /// The forces before the first tick, as of one island: the time grows with the square of the number of bodies.
    pub(crate) fn begin(&mut self) {
        let Self { state, plan, scratch, .. } = self;
        let n = state.bodies.len();
        if n == 0 || n > MOST_AT_FIRST {
            return;
        }
        let scene = Scene::of(state, plan, 0.0);
        scratch.begin_tick();
        scratch.starts.clear();
        scratch.members.extend(0..n as u32);
        scratch.surfaces.extend(0..state.surfaces.len() as u32);
        scratch.gather(state, &scene, |_| Aabb::around(DVec2::ZERO, DVec2::splat(f64::MAX)));
        scratch.events.begin(&scene);
        scratch.events.settle(&scene);
        scratch.take_contacts(state);
        state.contacts.extend(scratch.contacts.drain(..).map(|(_, contact)| contact));
        scratch.starts.clear();
        for item in &scratch.events.items[..n] {
            state.bodies[item.id as usize].acceleration = item.solved + DVec2::ZERO;
        }
    }

    /// Something about a body, or about its contacts, has changed.
    pub(crate) fn disturb(&mut self, body: u32) {
        let i = body as usize;
        self.state.known[i] = false;
        self.space.crowd.settled.forget(i);
        self.space.sleep.wake(i);
    }

    pub(crate) fn disturb_around(&mut self, surface: usize) {
        let bounds = self.state.surfaces[surface].bounds;
        self.disturb_in(&bounds);
    }

    /// Something about a place has changed: all bodies that touch it have to be looked at.
    pub(crate) fn disturb_in(&mut self, bounds: &Aabb) {
        for i in 0..self.state.bodies.len() {
            if self.state.bodies[i].bounds().touches(bounds, MARGIN) {
                self.disturb(i as u32);
            }
        }
    }

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

    /// Leads surfaces along their paths, and wakes all bodies that one may touch within the next `dt` seconds.
    fn move_surfaces(&mut self, dt: f64) {
        called(Part::Moving);
        for k in 0..self.on_paths.len() {
            let s = self.on_paths[k] as usize;
            let surface = &self.state.surfaces[s];
            if !(surface.moved || surface.moves_within(dt)) {
                continue;
            }
            let swept = surface.swept(dt);
            if surface.moves_within(dt) {
                self.space.lead_surface(s, (surface.at(dt).offset, surface.arrives(dt)), &swept, dt);
            }
            self.disturb_in(&swept);
        }
    }

    fn go_on_paths(&mut self, dt: f64) {
        for &s in &self.on_paths {
            let surface = &mut self.state.surfaces[s as usize];
            let stop = first_stop(&self.scratch.stops, s);
            surface.go_on(dt.min(stop));
            if stop < dt {
                self.space.motions.surfaces[s as usize].from = surface.bounds.centre();
            }
        }
    }
}
