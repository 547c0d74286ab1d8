//! One step of the whole store: flight, islands, and each island by the dense method, until none wants to grow.

use super::bodies::Bodies;
use super::dense::{Outcome, StepSize};
use super::flight;
use super::impacts::Impacts;
use super::islands::Island;
use super::{Aabb, ContactImpulse, Other, Pile, PileImpact, Squeeze};
use glam::DVec2;

/// How often islands may grow in one step. Fewer: bodies are clipped to what was looked for.
const GROWTHS: usize = 4;

/// Who may advance an island before the dense method does.
pub(in crate::physics) trait Advance {
    /// Whether a body that is near nothing has to be advanced all the same: flight alone does not say where it gets.
    fn minds(&self, body: usize) -> bool;

    /// Takes an island, or leaves it. `round` is how often it has grown in this step.
    fn advance(&mut self, store: &mut Store<'_>, round: usize) -> Verdict;

    /// Whether the contacts of an island of so many bodies are to be listed; `on` is whether those of the one before were.
    fn lists(&self, members: usize, on: bool) -> bool;

    /// What it told of the island of this body holds no longer.
    fn forget(&mut self, body: usize);

    /// Bodies whose islands have to be advanced again, because others have come to something that concerns them.
    fn disagree(&mut self, bodies: &mut Vec<u32>);
}

/// What has become of an island.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::physics) enum Verdict {
    /// It is where it is at the end of the step; whether all of it rests.
    Taken { rests: bool },
    /// The dense method shall take what is left of the step, s: all of it, or less if the bodies have been brought to a later time.
    Left(f64),
    /// Bodies may get further than others were looked for; their swept boxes have been widened.
    Grown,
}

/// An island, for whoever takes it, in the numbers of the outside.
#[derive(Debug)]
pub(in crate::physics) struct Store<'a> {
    bodies: &'a mut Bodies,
    island: Island<'a>,
    grown: &'a mut Vec<u32>,
    down: f64,
}

impl Store<'_> {
    /// How many bodies it has.
    pub fn len(&self) -> usize {
        self.island.members.len()
    }

    /// Its bodies, in no order that means anything.
    pub fn members(&self) -> impl Iterator<Item = u32> {
        self.island.members.iter().map(|slot| self.bodies.id[*slot as usize])
    }

    /// Appends the surfaces that they may meet, some more than once.
    pub fn surfaces(&self, into: &mut Vec<u32>) {
        let n = self.bodies.len() as u32;
        for slot in self.island.members {
            into.extend(self.island.near(*slot).iter().filter(|other| **other >= n).map(|other| other - n));
        }
    }

    /// Where others were looked for, m.
    pub fn swept(&self, body: u32) -> Aabb {
        let [left, right, top, bottom] = self.bodies.swept[self.bodies.slot[body as usize] as usize];
        let (top, bottom) = if self.down < 0.0 { (-bottom, -top) } else { (top, bottom) };
        Aabb::new(DVec2::new(left, top), DVec2::new(right, bottom))
    }

    /// Brings a body to a place (m) and velocity (m/s) at the end of the step, or where it is left.
    pub fn bring(&mut self, body: u32, position: DVec2, velocity: DVec2) {
        let i = self.bodies.slot[body as usize] as usize;
        (self.bodies.px[i], self.bodies.py[i]) = (position.x, position.y * self.down);
        (self.bodies.ux[i], self.bodies.uy[i]) = (velocity.x, velocity.y * self.down);
    }

    /// Widens where others are looked for by `reach` (m) to all sides; the islands are found anew then.
    pub fn widen(&mut self, body: u32, reach: DVec2) {
        let slot = self.bodies.slot[body as usize];
        let swept = &mut self.bodies.swept[slot as usize];
        *swept = [swept[0] - reach.x, swept[1] + reach.x, swept[2] - reach.y, swept[3] + reach.y];
        self.grown.push(slot);
    }
}

/// Nobody else: every island is solved by the dense method.
struct AllDense;

impl Advance for AllDense {
    fn minds(&self, _: usize) -> bool {
        false
    }

    fn advance(&mut self, _: &mut Store<'_>, _: usize) -> Verdict {
        Verdict::Left(f64::INFINITY)
    }

    fn lists(&self, _: usize, on: bool) -> bool {
        on
    }

    fn forget(&mut self, _: usize) {}

    fn disagree(&mut self, _: &mut Vec<u32>) {}
}

/// A body whose start was moved to a later time of the step: its slot, place, velocity and free velocity as they were.
#[derive(Clone, Copy, Debug)]
struct Moved {
    slot: u32,
    place: (f64, f64),
    velocity: (f64, f64),
    free: (f64, f64),
}

/// A surface that stands for an island: its slot, and where it began, ends and how fast it goes for all others.
#[derive(Clone, Copy, Debug)]
struct Held {
    slot: usize,
    start: (f64, f64),
    end: (f64, f64),
    velocity: (f64, f64),
}

/// What the driver keeps from step to step.
#[derive(Clone, Debug, Default)]
pub(super) struct Driver {
    pub events: Vec<PileImpact>,
    /// Surfaces that have moved, and where they go next.
    moving: Vec<u32>,
    pub targets: Vec<(u32, DVec2)>,
    /// What they sweep on the way, where that is no straight line: left, right, top, bottom.
    pub ways: Vec<(u32, [f64; 4])>,
    pub squeezed: Vec<Squeeze>,
    /// Who sleeps, by the numbers outside, and how many.
    asleep: Vec<bool>,
    sleepers: usize,
    /// Who fell asleep in this step.
    fresh: Vec<u32>,
    /// By slot: how often its island has grown in this step.
    growths: Vec<u32>,
    /// By slot: whether the island has to be solved again.
    again: Vec<bool>,
    moved: Vec<Moved>,
    disagreeing: Vec<u32>,
    /// Surfaces that stand for an island.
    held: Vec<Held>,
    /// Whose swept boxes reach beyond where their neighbours were sought.
    beyond: Vec<u32>,
}

impl Driver {
    pub fn new(count: usize) -> Self {
        Self { asleep: vec![false; count], again: vec![false; count], ..Self::with_room(count) }
    }

    fn with_room(count: usize) -> Self {
        let room = || Vec::with_capacity(count);
        Self { events: Vec::with_capacity(count), fresh: room(), growths: room(), ..Self::default() }
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
        if !std::mem::replace(&mut self.asleep[body], true) {
            self.sleepers += 1;
            self.fresh.push(body as u32);
        }
    }

    /// Wakes whom this step has let fall asleep.
    fn wake_fresh(&mut self) {
        while let Some(body) = self.fresh.pop() {
            self.wake(body as usize);
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

impl Pile {
    /// Advances the pile by `dt` seconds, > 0.
    pub fn step(&mut self, dt: f64) {
        self.step_with(dt, &mut AllDense);
    }

    /// The same with somebody who may take islands before the dense method does.
    pub(in crate::physics) fn step_with<A: Advance>(&mut self, dt: f64, other: &mut A) {
        self.driver.events.clear();
        self.driver.squeezed.clear();
        self.driver.fresh.clear();
        let moving = !self.driver.targets.is_empty()
            || self.driver.moving.iter().any(|j| self.bodies.carries(self.bodies.len() + *j as usize));
        if !self.driver.all_asleep() || moving {
            self.last_dt = dt;
            let asleep = &self.driver.asleep;
            self.dense.report.list.retain(|contact| asleep[contact.a]);
            self.move_surfaces(dt);
            self.fly(dt);
            self.solve_islands(dt, other);
            self.stop_presses(dt, other);
            self.bodies.commit();
        }
        self.bodies.guided.clear();
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
        for (surface, centre) in &self.driver.targets {
            let j = n + *surface as usize;
            (bodies.px[j], bodies.py[j]) = (centre.x, centre.y);
            set_velocity(bodies, j, ((centre.x - bodies.x[j]) / dt, (centre.y - bodies.y[j]) / dt));
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
                let j = surface as usize;
                (self.bodies.px[j], self.bodies.py[j]) = (self.bodies.x[j], self.bodies.y[j]);
                set_velocity(&mut self.bodies, j, (0.0, 0.0));
            }
            self.solve_all_again(dt, other);
        }
        self.dense.squeezed.clear();
    }

    /// Solves all islands by the dense method from the start of the step, which free flight has left.
    pub(super) fn solve_again(&mut self, dt: f64) {
        self.solve_all_again(dt, &mut AllDense);
    }

    fn solve_all_again<A: Advance>(&mut self, dt: f64, other: &mut A) {
        let n = self.bodies.len();
        self.driver.put_back_moved(&mut self.bodies, |_| true);
        self.bodies.px[..n].copy_from_slice(&self.bodies.free_x);
        self.bodies.py[..n].copy_from_slice(&self.bodies.free_y);
        self.driver.events.clear();
        let Self { dense, driver, .. } = self;
        driver.wake_fresh();
        dense.report.list.retain(|contact| driver.asleep[contact.a]);
        // As wide as at first: how far others had to be looked for in between is no concern of theirs.
        self.look_around();
        (0..n).for_each(|body| other.forget(body));
        self.solve_islands(dt, other);
    }

    fn fly(&mut self, dt: f64) {
        let Self { bodies, neighbours, islands, .. } = self;
        neighbours.drift(bodies, dt);
        let inside = flight::fly(bodies, dt, self.drag);
        if (!inside || neighbours.is_stale(bodies)) && neighbours.update(bodies, dt) {
            islands.renumbered();
        }
        let n = bodies.len();
        bodies.free_x.copy_from_slice(&bodies.px[..n]);
        bodies.free_y.copy_from_slice(&bodies.py[..n]);
        self.look_around();
    }

    /// Sets what all sweep in this step, and finds whom they may meet there.
    fn look_around(&mut self) {
        let Self { bodies, neighbours, driver, .. } = self;
        let n = bodies.len();
        bodies.sweep();
        for &(surface, [left, right, top, bottom]) in &driver.ways {
            let s = &mut bodies.swept[n + surface as usize];
            *s = [s[0].min(left), s[1].max(right), s[2].min(top), s[3].max(bottom)];
        }
        // The boxes in which neighbours were sought are made for many bodies together; what an island comes to must not depend on them.
        driver.beyond.clear();
        driver.beyond.extend((0..n).filter(|&i| !bodies.sweeps_where_neighbours_are(i)).map(|i| i as u32));
        neighbours.follow(bodies, &driver.beyond);
        neighbours.find_moving(bodies, &driver.moving);
    }

    fn solve_islands<A: Advance>(&mut self, dt: f64, other: &mut A) {
        self.driver.moved.clear();
        let n = self.bodies.len();
        if self.neighbours.is_empty() && !(0..n).any(|body| other.minds(body)) {
            let bodies = &mut self.bodies;
            bodies.ux[..n].copy_from_slice(&bodies.free_vx[..n]);
            bodies.uy[..n].copy_from_slice(&bodies.free_vy[..n]);
            if self.driver.sleepers > 0 {
                for i in 0..n {
                    if self.driver.asleep[bodies.id[i] as usize] {
                        bodies.stay(i);
                    }
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
                let alone = island.members.len() == 1 && island.near(island.members[0]).is_empty();
                if alone && !other.minds(bodies.id[island.members[0] as usize] as usize) {
                    let i = island.members[0] as usize;
                    (bodies.ux[i], bodies.uy[i]) = (bodies.free_vx[i], bodies.free_vy[i]);
                    driver.wake(bodies.id[i] as usize);
                    continue;
                }
                driver.forget(bodies, island, &mut dense.report.list);
                let round = driver.growths_of(island);
                let whole = StepSize { dt, rest_speed: self.rest_speed, gravity: self.gravity, last: round >= GROWTHS };
                let mut store = Store { bodies, island, grown: &mut dense.grown, down: self.down };
                let left = match other.advance(&mut store, round) {
                    Verdict::Taken { rests } => {
                        driver.note_sleep(bodies, island, self.may_sleep && rests);
                        continue;
                    }
                    Verdict::Grown => {
                        driver.note_growth(island, round);
                        continue;
                    }
                    Verdict::Left(left) => left.min(dt),
                };
                let size = StepSize { dt: left, ..whole };
                if left < dt {
                    driver.begin_later(bodies, island, left, self.drag);
                    driver.hold_surfaces(bodies, dt - left);
                }
                dense.report.on = other.lists(island.members.len(), dense.report.on);
                if dense.step(bodies, neighbours, island, size) == Outcome::Done {
                    driver.finish(bodies, island, self.may_sleep);
                    driver.list_impacts(bodies, &dense.impacts);
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
            neighbours.find_moving(bodies, &driver.moving);
            dense.grown.clear();
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
        self.put_back_moved(bodies, |slot| island.members.contains(&slot));
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

    /// Lets the step of an island begin later, when `left` seconds of it are left: where its bodies are predicted now.
    fn begin_later(&mut self, bodies: &mut Bodies, island: Island<'_>, left: f64, drag: bool) {
        for &slot in island.members {
            let i = slot as usize;
            let (place, velocity) = ((bodies.x[i], bodies.y[i]), (bodies.vx[i], bodies.vy[i]));
            self.moved.push(Moved { slot, place, velocity, free: (bodies.free_vx[i], bodies.free_vy[i]) });
            (bodies.x[i], bodies.y[i], bodies.vx[i], bodies.vy[i]) = (bodies.px[i], bodies.py[i], bodies.ux[i], bodies.uy[i]);
            flight::fly_one(bodies, i, left, drag);
            bodies.widen(i);
        }
    }

    /// Lets surfaces that move stand where they are `t` seconds into the step, for an island that begins then: whoever left it to begin later
    /// has stopped them there.
    fn hold_surfaces(&mut self, bodies: &mut Bodies, t: f64) {
        self.held.clear();
        for (surface, _) in &self.targets {
            let j = bodies.len() + *surface as usize;
            let (start, velocity) = ((bodies.x[j], bodies.y[j]), (bodies.vx[j], bodies.vy[j]));
            self.held.push(Held { slot: j, start, end: (bodies.px[j], bodies.py[j]), velocity });
            (bodies.x[j], bodies.y[j]) = (start.0 + velocity.0 * t, start.1 + velocity.1 * t);
            (bodies.px[j], bodies.py[j]) = (bodies.x[j], bodies.y[j]);
            set_velocity(bodies, j, (0.0, 0.0));
        }
    }

    /// Lets them go on for the other islands.
    fn release_surfaces(&mut self, bodies: &mut Bodies) {
        for Held { slot, start, end, velocity } in self.held.drain(..) {
            ((bodies.x[slot], bodies.y[slot]), (bodies.px[slot], bodies.py[slot])) = (start, end);
            set_velocity(bodies, slot, velocity);
        }
    }

    /// Gives bodies of which `again` says so back the start of the whole step.
    fn put_back_moved(&mut self, bodies: &mut Bodies, again: impl Fn(u32) -> bool) {
        self.moved.retain(|moved| {
            let again = again(moved.slot);
            if again {
                let i = moved.slot as usize;
                ((bodies.x[i], bodies.y[i]), (bodies.vx[i], bodies.vy[i])) = (moved.place, moved.velocity);
                (bodies.free_vx[i], bodies.free_vy[i]) = moved.free;
            }
            !again
        });
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
        island.members.iter().for_each(|i| bodies.stay(*i as usize));
        true
    }

    /// A step that moved nothing and left nothing moving would be followed by the same for ever.
    fn finish(&mut self, bodies: &Bodies, island: Island<'_>, may_sleep: bool) {
        let still = |i: usize| {
            let rests = bodies.vy[i] == 0.0 && bodies.vx[i] == 0.0 && bodies.uy[i] == 0.0 && bodies.ux[i] == 0.0;
            rests && bodies.x[i] == bodies.px[i] && bodies.y[i] == bodies.py[i]
        };
        let sleeps = may_sleep && island.members.iter().rev().all(|i| still(*i as usize));
        self.note_sleep(bodies, island, sleeps);
    }

    fn note_sleep(&mut self, bodies: &Bodies, island: Island<'_>, sleeps: bool) {
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
