//! One step of the whole store: flight, islands, and each island by the dense method, until none wants to grow.

pub(crate) mod advance;
pub(crate) mod later;
pub(crate) mod look;
pub(crate) mod sleep;

use crate::physics::crowd::dense::{Outcome, StepSize};
use crate::physics::crowd::report::ContactImpulse;
use crate::physics::crowd::{Axis, CrowdImpact, Other, Squeeze};
use crate::physics::space::Space;
use crate::physics::store::bodies::Bodies;
pub(crate) use crate::physics::store::driver::advance::{Advance, Store, Verdict};
use crate::physics::store::driver::later::{Held, Placed};
use crate::physics::store::islands::Island;
use glam::DVec2;

/// How often islands may grow in one step. Fewer: bodies are clipped to what was looked for.
const GROWTHS: usize = 4;

/// Where a surface is at the end of the step, m, and how fast it moves then, m/s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    pub surface: u32,
    pub centre: DVec2,
    pub velocity: DVec2,
}

/// What the driver keeps from step to step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Driver {
    pub events: Vec<CrowdImpact>,
    /// Surfaces that have moved, and where they go next.
    pub moving: Vec<u32>,
    pub targets: Vec<Target>,
    /// What they sweep on the way, where that is no straight line: left, right, top, bottom.
    pub ways: Vec<(u32, [f64; 4])>,
    pub squeezed: Vec<Squeeze>,
    /// Who sleeps, by the numbers outside, and how many.
    asleep: Vec<bool>,
    sleepers: usize,
    /// Who fell asleep in this step.
    fresh: Vec<u32>,
    /// Bodies that slept and were woken since this was emptied.
    pub woken: Vec<u32>,
    /// Whom a step looks at, by the numbers outside, and as slots; the others are `aside` (see `sleep`).
    looked_at: Vec<u32>,
    slots: Vec<u32>,
    aside: Vec<bool>,
    /// Whose islands the last step has left asleep.
    undisturbed: Vec<bool>,
    /// By slot: how often its island has grown in this step.
    growths: Vec<u32>,
    /// By slot: whether the island has to be solved again.
    again: Vec<bool>,
    disagreeing: Vec<u32>,
    /// Surfaces that begin later for an island, and where.
    held: Vec<Held>,
    placed: Vec<Placed>,
}

impl Driver {
    pub fn new(count: usize) -> Self {
        let no = || vec![false; count];
        let looked_at = (0..count as u32).collect();
        Self { asleep: no(), again: no(), aside: no(), undisturbed: no(), looked_at, ..Self::with_room(count) }
    }

    fn with_room(count: usize) -> Self {
        let room = || Vec::with_capacity(count);
        Self {
            events: Vec::with_capacity(count),
            fresh: room(),
            growths: room(),
            slots: Vec::with_capacity(2 * count),
            ..Self::default()
        }
    }

    /// How often an island has grown in this step, or those of which it is made now. It depends on no other island.
    fn growths_of(&self, island: Island<'_>) -> usize {
        island.members.iter().map(|i| self.growths[*i as usize]).max().unwrap_or(0) as usize
    }

    fn note_growth(&mut self, island: Island<'_>, round: usize) {
        island.members.iter().for_each(|i| self.growths[*i as usize] = round as u32 + 1);
    }

    /// Notes that a surface moves. Returns whether that is new.
    pub fn add_moving(&mut self, surface: usize) -> bool {
        let new = !self.moving.contains(&(surface as u32));
        if new {
            self.moving.push(surface as u32);
        }
        new
    }
}

impl Space {
    /// Whether a body is awake or a surface moves.
    pub(crate) fn is_stirred(&self) -> bool {
        let carries = |j: &u32| self.bodies.carries(self.bodies.len() + *j as usize);
        !self.driver.all_asleep() || !self.driver.targets.is_empty() || self.driver.moving.iter().any(carries)
    }

    /// Advances all by `dt` seconds, > 0; `other` may take an island before the crowd step does.
    pub(crate) fn step_with<A: Advance>(&mut self, dt: f64, other: &mut A) {
        self.driver.events.clear();
        self.driver.squeezed.clear();
        self.driver.fresh.clear();
        if self.is_stirred() {
            self.look_at(dt);
            self.last_dt = dt;
            let asleep = &self.driver.asleep;
            self.dense.report.list.retain(|contact| asleep[contact.a]);
            self.move_surfaces(dt);
            self.fly(dt);
            self.solve_islands(dt, other);
            self.stop_presses(dt, other);
            self.bodies.commit();
        }
        for (id, ..) in self.bodies.guided.drain(..) {
            self.bodies.is_guided[id as usize] = false;
        }
        self.driver.targets.clear();
        self.driver.ways.clear();
    }

    fn move_surfaces(&mut self, dt: f64) {
        let n = self.bodies.len();
        let bodies = &mut self.bodies;
        let still = |bodies: &mut Bodies, j: usize| {
            (bodies.was_vx[j], bodies.was_vy[j]) = (bodies.vx[j], bodies.vy[j]);
            (bodies.px[j], bodies.py[j]) = (bodies.x[j], bodies.y[j]);
            set_velocity(bodies, j, (0.0, 0.0));
        };
        self.driver.moving.iter().for_each(|j| still(bodies, n + *j as usize));
        for Target { surface, centre, velocity } in &self.driver.targets {
            let j = n + *surface as usize;
            (bodies.px[j], bodies.py[j]) = (centre.x, centre.y);
            set_velocity(bodies, j, ((centre.x - bodies.x[j]) / dt, (centre.y - bodies.y[j]) / dt));
            set_final_velocity(bodies, j, (velocity.x, velocity.y));
        }
    }

    /// Where surfaces would squeeze bodies, those that move stay for this step, and all is solved again.
    fn stop_presses<A: Advance>(&mut self, dt: f64, other: &mut A) {
        for _ in 0..=self.driver.moving.len() {
            if self.dense.squeezed.is_empty() {
                return;
            }
            let n = self.bodies.len();
            for (body, surface, speed) in self.dense.squeezed.drain(..) {
                let body = self.bodies.id[body as usize] as usize;
                self.driver.squeezed.push(Squeeze { body, surface: surface as usize - n, speed });
                other.stand(surface as usize - n);
                let j = surface as usize;
                (self.bodies.px[j], self.bodies.py[j]) = (self.bodies.x[j], self.bodies.y[j]);
                set_velocity(&mut self.bodies, j, (0.0, 0.0));
            }
            self.solve_all_again(dt, other);
        }
        self.dense.squeezed.clear();
    }

    fn solve_all_again<A: Advance>(&mut self, dt: f64, other: &mut A) {
        let Self { dense, driver, bodies, .. } = self;
        driver.events.clear();
        driver.wake_fresh();
        dense.report.list.retain(|contact| driver.asleep[contact.a]);
        // As wide as at first: how far others had to be looked for in between is no concern of theirs.
        for &i in &driver.slots {
            let i = i as usize;
            (bodies.px[i], bodies.py[i]) = (bodies.free_x[i], bodies.free_y[i]);
            other.forget(bodies.id[i] as usize);
        }
        bodies.sweep(&driver.slots);
        bodies.sweep_surfaces(&driver.moving);
        self.look_at_surfaces();
        self.solve_islands(dt, other);
    }

    fn solve_islands<A: Advance>(&mut self, dt: f64, other: &mut A) {
        let n = self.bodies.len();
        let minds = |other: &A| !other.minds_nobody() && self.driver.looked_at.iter().any(|body| other.minds(*body as usize));
        if self.neighbours.is_empty() && !minds(other) {
            let Self { bodies, driver, .. } = self;
            if driver.looks_at_all() && driver.sleepers == 0 {
                bodies.ux[..n].copy_from_slice(&bodies.free_vx[..n]);
                bodies.uy[..n].copy_from_slice(&bodies.free_vy[..n]);
                return;
            }
            for &i in &driver.slots {
                let i = i as usize;
                (bodies.ux[i], bodies.uy[i]) = (bodies.free_vx[i], bodies.free_vy[i]);
                if driver.sleepers > 0 && driver.asleep[bodies.id[i] as usize] {
                    bodies.stay(i);
                }
            }
            return;
        }
        self.islands.sort(&self.bodies);
        self.driver.growths.clear();
        self.driver.growths.resize(n, 0);
        let mut again = false;
        loop {
            let Self { bodies, neighbours, islands, dense, driver, .. } = self;
            islands.find(bodies, neighbours);
            for k in 0..islands.len() {
                let island = islands.get(k);
                if again && !driver.begin_again(bodies, island, &mut dense.report.list, other) {
                    continue;
                }
                if driver.stays_asleep(bodies, island) {
                    continue;
                }
                if island.is_alone() && !other.minds(bodies.id[island.members[0] as usize] as usize) {
                    let i = island.members[0] as usize;
                    (bodies.ux[i], bodies.uy[i]) = (bodies.free_vx[i], bodies.free_vy[i]);
                    driver.wake(bodies.id[i] as usize);
                    continue;
                }
                driver.forget(bodies, island, &mut dense.report.list);
                let round = if again { driver.growths_of(island) } else { 0 };
                let size = StepSize { dt, rest_speed: self.rest_speed, gravity: self.gravity, last: round >= GROWTHS };
                driver.placed.clear();
                let (placed, targets) = (&mut driver.placed, driver.targets.as_slice());
                let mut store = Store { bodies, island, grown: &mut dense.grown, placed, targets, down: self.down };
                let verdict = other.advance(&mut store, round);
                match verdict {
                    Verdict::Taken { rests } => {
                        driver.note_sleep(bodies, island, self.may_sleep && rests);
                        continue;
                    }
                    Verdict::Grown => {
                        driver.note_growth(island, round);
                        continue;
                    }
                    Verdict::Left => {}
                }
                if !driver.placed.is_empty() {
                    driver.hold_surfaces(bodies, dt);
                }
                dense.report.on = other.lists(island.members.len());
                if dense.step(bodies, island, size) == Outcome::Done {
                    let may_sleep = self.may_sleep && other.leaves_for_good(island.members.len());
                    driver.finish(bodies, island, may_sleep);
                    driver.list_impacts(bodies, &dense.hits);
                    dense.finish(bodies, island, self.down);
                } else {
                    driver.note_growth(island, round);
                }
                driver.release_surfaces(bodies);
            }
            driver.again.fill(false);
            again = true;
            if dense.grown.is_empty() {
                driver.disagreeing.clear();
                other.disagree(&mut driver.disagreeing);
                if driver.disagreeing.is_empty() {
                    return;
                }
                driver.disagreeing.iter().for_each(|body| driver.again[bodies.slot[*body as usize] as usize] = true);
                continue;
            }
            dense.grown.iter().for_each(|i| driver.again[*i as usize] = true);
            neighbours.follow(bodies, &dense.grown);
            if !driver.looks_at_all() {
                // Whom they reach now is found from them alone: they are put behind all others once more.
                let from = driver.slots.len();
                driver.slots.extend_from_slice(&dense.grown);
                dense.grown.clear();
                self.rouse_reached(from);
                self.driver.slots.sort_unstable();
                self.driver.slots.dedup();
                self.islands.look_at(&self.driver.slots);
            }
            self.dense.grown.clear();
            self.look_at_moving();
            if self.islands.are_others() {
                self.islands.sort(&self.bodies);
            }
        }
    }
}

impl Driver {
    /// Whether an island of a later round has to be solved; takes back what was solved of it before.
    fn begin_again<A: Advance>(
        &mut self,
        bodies: &mut Bodies,
        island: Island<'_>,
        report: &mut Vec<ContactImpulse>,
        other: &mut A,
    ) -> bool {
        if !island.members.iter().any(|i| self.again[*i as usize]) {
            return false;
        }
        for &i in island.members {
            let i = i as usize;
            (bodies.px[i], bodies.py[i]) = (bodies.free_x[i], bodies.free_y[i]);
            self.wake(bodies.id[i] as usize);
            other.forget(bodies.id[i] as usize);
        }
        let Self { events, .. } = self;
        let inside = |body: usize| island.members.contains(&bodies.slot[body]);
        events.retain(|event| !inside(event.a));
        report.retain(|contact| !inside(contact.a));
        true
    }

    fn list_impacts(&mut self, bodies: &Bodies, hits: &[(u32, u32, Axis, f64)]) {
        let (n, id) = (bodies.len(), &bodies.id);
        let other = |i: usize| if i < n { Other::Body(id[i] as usize) } else { Other::Surface(i - n) };
        for &(a, b, axis, speed) in hits {
            self.events.push(CrowdImpact { a: id[a as usize] as usize, b: other(b as usize), axis, speed });
        }
    }
}

/// Sets the velocity of a surface throughout the step.
fn set_velocity(bodies: &mut Bodies, j: usize, (vx, vy): (f64, f64)) {
    (bodies.vx[j], bodies.mean_vx[j]) = (vx, vx);
    (bodies.vy[j], bodies.mean_vy[j]) = (vy, vy);
    set_final_velocity(bodies, j, (vx, vy));
}

/// Sets how fast a surface moves when the step ends: what rides on it does so, too.
fn set_final_velocity(bodies: &mut Bodies, j: usize, (vx, vy): (f64, f64)) {
    (bodies.free_vx[j], bodies.ux[j]) = (vx, vx);
    (bodies.free_vy[j], bodies.uy[j]) = (vy, vy);
}
