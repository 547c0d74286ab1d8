//! One step of the whole store: flight, islands, and each island by the dense method, until none wants to grow.

use super::bodies::Bodies;
use super::dense::{Outcome, StepSize};
use super::flight;
use super::impacts::Impacts;
use super::islands::Island;
use super::{ContactImpulse, Other, Pile, PileImpact, Squeeze};
use glam::DVec2;

/// How often islands may grow in one step. Fewer: bodies are clipped to what was looked for.
const GROWTHS: usize = 3;

/// What the driver keeps from step to step.
#[derive(Clone, Debug, Default)]
pub(super) struct Driver {
    pub events: Vec<PileImpact>,
    /// Surfaces that have moved, and where they go next.
    moving: Vec<u32>,
    pub targets: Vec<(u32, DVec2)>,
    pub squeezed: Vec<Squeeze>,
    /// Who sleeps, by the numbers outside, and how many.
    asleep: Vec<bool>,
    sleepers: usize,
    /// By slot: whether the island has to be solved again.
    again: Vec<bool>,
}

impl Driver {
    pub fn new(count: usize) -> Self {
        Self { asleep: vec![false; count], again: vec![false; count], events: Vec::with_capacity(count), ..Self::default() }
    }

    pub fn wake(&mut self, body: usize) {
        self.sleepers -= usize::from(std::mem::replace(&mut self.asleep[body], false));
    }

    pub fn wake_all(&mut self) {
        self.asleep.fill(false);
        self.sleepers = 0;
    }

    pub fn all_asleep(&self) -> bool {
        self.sleepers == self.asleep.len()
    }

    pub fn sleeps(&self, body: usize) -> bool {
        self.asleep[body]
    }

    fn fall_asleep(&mut self, body: usize) {
        self.sleepers += usize::from(!std::mem::replace(&mut self.asleep[body], true));
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

impl Pile {
    /// Advances the pile by `dt` seconds, > 0.
    pub fn step(&mut self, dt: f64) {
        self.driver.events.clear();
        self.driver.squeezed.clear();
        let moving = !self.driver.targets.is_empty()
            || self.driver.moving.iter().any(|j| self.bodies.carries(self.bodies.len() + *j as usize));
        if !self.driver.all_asleep() || moving {
            self.last_dt = dt;
            let asleep = &self.driver.asleep;
            self.dense.report.list.retain(|contact| asleep[contact.a]);
            self.move_surfaces(dt);
            self.fly(dt);
            self.solve_islands(dt);
            self.stop_presses(dt);
            self.bodies.commit();
        }
        self.bodies.guided.clear();
        self.driver.targets.clear();
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
        for (surface, centre) in &self.driver.targets {
            let j = n + *surface as usize;
            (bodies.px[j], bodies.py[j]) = (centre.x, centre.y);
            set_velocity(bodies, j, ((centre.x - bodies.x[j]) / dt, (centre.y - bodies.y[j]) / dt));
        }
    }

    /// Where surfaces would squeeze bodies, those that move stay for this step, and all is solved again.
    fn stop_presses(&mut self, dt: f64) {
        for _ in 0..=self.driver.moving.len() {
            if self.dense.squeezed.is_empty() {
                return;
            }
            let n = self.bodies.len();
            for (body, surface, speed) in self.dense.squeezed.drain(..) {
                let body = self.bodies.id[body as usize] as usize;
                self.driver.squeezed.push(Squeeze { body, surface: surface as usize - n, speed });
                let j = surface as usize;
                (self.bodies.px[j], self.bodies.py[j]) = (self.bodies.x[j], self.bodies.y[j]);
                set_velocity(&mut self.bodies, j, (0.0, 0.0));
            }
            self.solve_again(dt);
        }
        self.dense.squeezed.clear();
    }

    /// Solves all islands from the start of the step, which free flight has left.
    pub(super) fn solve_again(&mut self, dt: f64) {
        let n = self.bodies.len();
        self.bodies.px[..n].copy_from_slice(&self.bodies.free_x);
        self.bodies.py[..n].copy_from_slice(&self.bodies.free_y);
        self.driver.events.clear();
        self.dense.report.list.clear();
        self.driver.wake_all();
        self.solve_islands(dt);
    }

    fn fly(&mut self, dt: f64) {
        let Self { bodies, neighbours, islands, driver, .. } = self;
        neighbours.drift(bodies, dt);
        let inside = flight::fly(bodies, dt, self.drag);
        if (!inside || neighbours.is_stale(bodies)) && neighbours.update(bodies, dt) {
            islands.renumbered();
        }
        let n = bodies.len();
        bodies.free_x.copy_from_slice(&bodies.px[..n]);
        bodies.free_y.copy_from_slice(&bodies.py[..n]);
        bodies.sweep();
        neighbours.find_moving(bodies, &driver.moving);
    }

    fn solve_islands(&mut self, dt: f64) {
        if self.neighbours.is_empty() {
            let bodies = &mut self.bodies;
            let n = bodies.len();
            bodies.ux[..n].copy_from_slice(&bodies.free_vx[..n]);
            bodies.uy[..n].copy_from_slice(&bodies.free_vy[..n]);
            self.driver.wake_all();
            return;
        }
        self.islands.sort(&self.bodies);
        for round in 0..=GROWTHS {
            let Self { bodies, neighbours, islands, dense, driver, .. } = self;
            islands.find(bodies, neighbours);
            let size = StepSize { dt, rest_speed: self.rest_speed, gravity: self.gravity, last: round == GROWTHS };
            for k in 0..islands.len() {
                let island = islands.get(k);
                if round > 0 && !driver.begin_again(bodies, island, &mut dense.report.list) {
                    continue;
                }
                if island.members.len() == 1 && island.near(island.members[0]).is_empty() {
                    let i = island.members[0] as usize;
                    (bodies.ux[i], bodies.uy[i]) = (bodies.free_vx[i], bodies.free_vy[i]);
                    driver.wake(bodies.id[i] as usize);
                    continue;
                }
                if driver.stays_asleep(bodies, island) {
                    continue;
                }
                driver.forget(bodies, island, &mut dense.report.list);
                if dense.step(bodies, island, size) == Outcome::Done {
                    driver.finish(bodies, island, self.may_sleep);
                    driver.list_impacts(bodies, &dense.impacts);
                    dense.finish(bodies, island, self.down);
                }
            }
            if dense.grown.is_empty() {
                return;
            }
            driver.again.fill(false);
            dense.grown.iter().for_each(|i| driver.again[*i as usize] = true);
            neighbours.follow(bodies, &dense.grown);
            dense.grown.clear();
        }
    }
}

impl Driver {
    /// Whether an island of a later round has to be solved; takes back what was solved of it before.
    fn begin_again(&mut self, bodies: &mut Bodies, island: Island<'_>, report: &mut Vec<ContactImpulse>) -> bool {
        if !island.members.iter().any(|i| self.again[*i as usize]) {
            return false;
        }
        for &i in island.members {
            let i = i as usize;
            (bodies.px[i], bodies.py[i]) = (bodies.free_x[i], bodies.free_y[i]);
            self.wake(bodies.id[i] as usize);
        }
        let Self { events, .. } = self;
        let inside = |body: usize| island.members.contains(&bodies.slot[body]);
        events.retain(|event| !inside(event.a));
        report.retain(|contact| !inside(contact.a));
        true
    }

    /// What was told of those that slept holds no longer.
    fn forget(&self, bodies: &Bodies, island: Island<'_>, report: &mut Vec<ContactImpulse>) {
        let slept = |body: usize| self.asleep[body] && island.members.contains(&bodies.slot[body]);
        if self.sleepers > 0 && !report.is_empty() {
            report.retain(|contact| !slept(contact.a));
        }
    }

    /// An island of which all sleep and that nothing moving touches stays as it is.
    fn stays_asleep(&mut self, bodies: &mut Bodies, island: Island<'_>) -> bool {
        if self.sleepers == 0 || !island.members.iter().all(|i| self.asleep[bodies.id[*i as usize] as usize]) {
            return false;
        }
        let n = bodies.len() as u32;
        let carries = |j: u32| j >= n && bodies.carries(j as usize);
        if island.members.iter().any(|i| island.near(*i).iter().any(|j| carries(*j))) {
            return false;
        }
        for &i in island.members {
            let i = i as usize;
            (bodies.px[i], bodies.py[i]) = (bodies.x[i], bodies.y[i]);
            (bodies.ux[i], bodies.uy[i]) = (0.0, 0.0);
        }
        true
    }

    /// A step that moved nothing and left nothing moving would be followed by the same for ever.
    fn finish(&mut self, bodies: &Bodies, island: Island<'_>, may_sleep: bool) {
        let still = |i: usize| {
            let rests = bodies.vy[i] == 0.0 && bodies.vx[i] == 0.0 && bodies.uy[i] == 0.0 && bodies.ux[i] == 0.0;
            rests && bodies.x[i] == bodies.px[i] && bodies.y[i] == bodies.py[i]
        };
        let sleeps = may_sleep && island.members.iter().rev().all(|i| still(*i as usize));
        for &i in island.members {
            if sleeps {
                self.fall_asleep(bodies.id[i as usize] as usize);
            } else if self.sleepers > 0 {
                self.wake(bodies.id[i as usize] as usize);
            }
        }
    }

    fn list_impacts(&mut self, bodies: &Bodies, impacts: &Impacts) {
        let (n, id) = (bodies.len(), &bodies.id);
        let other = |i: usize| if i < n { Other::Body(id[i] as usize) } else { Other::Surface(i - n) };
        let bounced = impacts.all.iter().filter(|hit| hit.speed > 0.0).map(|hit| (hit.a, hit.b, hit.axis, hit.speed));
        for (a, b, axis, speed) in bounced.chain(impacts.plastic.iter().copied()) {
            self.events.push(PileImpact { a: id[a as usize] as usize, b: other(b as usize), axis, speed });
        }
    }
}

fn set_velocity(bodies: &mut Bodies, j: usize, (vx, vy): (f64, f64)) {
    for (list, v) in [(&mut bodies.vx, vx), (&mut bodies.free_vx, vx), (&mut bodies.ux, vx), (&mut bodies.mean_vx, vx)] {
        list[j] = v;
    }
    for (list, v) in [(&mut bodies.vy, vy), (&mut bodies.free_vy, vy), (&mut bodies.uy, vy), (&mut bodies.mean_vy, vy)] {
        list[j] = v;
    }
}
