//! Which method advances an island, and what the islands of a tick come to.
//!
//! An island is whatever could meet within the tick. The least method that is right for it takes it:
//!
//! | what is in it | method | cost, measured on two cores, one thread |
//! |---|---|---|
//! | nothing moves, and nothing that moves comes near | rest | nothing |
//! | one body, near nothing | flight in closed form | 2 ns, with drag 9 ns a body |
//! | up to [`Choice::MOST_BY_EVENTS`] bodies | event by event, so many events a tick | 0.2 µs a body, 2 µs an impact |
//! | more, or more events than that | one step of the dense method | 50 to 200 ns a body |
//!
//! Event by event costs what happens: in a gas of 64 bodies some 30 impacts a tick, in a heap that settles every contact again and again.
//! There the dense method is cheaper from about 50 bodies on, and the count of events makes sure of it for fewer.

use crate::physics::crowd::dense::{Outcome as CrowdOutcome, StepSize};
use crate::physics::crowd::{CrowdImpact, Other, Squeeze};
use crate::physics::data::plan::{Part, called};
use crate::physics::exact::item::Item;
use crate::physics::exact::{Outcome, Scene};
use crate::physics::flight::flow::flow_through;
use crate::physics::flight::steps::Course;
use crate::physics::guards::Guards;
use crate::physics::scratch::{After, NOBODY, Scratch, Stop};
use crate::physics::space::{Space, stand};
use crate::physics::state::State;
use crate::physics::store::members::{Members, Verdict};

/// The choice of methods.
pub(crate) struct Choice;

impl Choice {
    /// Islands of more bodies are dense. More: a heap that settles costs more than a millisecond a tick; fewer: gases are less exact.
    pub const MOST_BY_EVENTS: usize = 64;
    /// Worlds of more bodies list no contact forces before their first tick.
    pub const MOST_AT_FIRST: usize = 1024;
    /// How often an island may grow before the dense method takes it, which can keep bodies within what was looked for.
    const MOST_GROWTHS: usize = 3;
    /// Contacts of a dense island are listed if somebody asked for forces in the last tick, or if it has no more bodies than this.
    const ALWAYS_LISTED: usize = 256;
    /// How often a crowd may grow in one tick. Fewer: bodies are kept within what was looked for.
    const MOST_CROWD_GROWTHS: usize = 4;
}

/// A tick, as the islands see it.
pub(crate) struct Tick<'a> {
    pub state: &'a State,
    pub scene: Scene<'a>,
    pub guards: &'a mut Guards,
    pub scratch: &'a mut Scratch,
    /// Whether somebody asked for forces in the last tick.
    pub lists: bool,
    /// Whether nothing but constant forces acts on bodies that touch nothing.
    pub bare: bool,
}

impl Tick<'_> {
    /// Lets a body fly that has turned out to be near nothing, and of which it is known roughly only where it gets.
    fn fly(&mut self, store: &mut Members<'_>) -> Verdict {
        let i = self.scratch.members[0];
        let body = &self.state.bodies[i as usize];
        let media = self.scene.media;
        let force = self.state.forces[i as usize].push();
        let law = media.law(body, force, self.scene.tick);
        let Course { end: (position, velocity), pull, .. } = flow_through(self.scene.media, body, &law, self.scene.tick);
        self.scratch.pulls[i as usize] = pull;
        store.bring(i, position, velocity);
        if store.is_swept(i) {
            return Verdict::Taken { rests: false };
        }
        self.guards.islands_grown += 1;
        store.widen(i, (position - body.position).abs());
        Verdict::Grown
    }

    /// Leaves the whole tick to the dense method.
    fn leave(&mut self) -> Verdict {
        self.scratch.leave();
        Verdict::Left
    }

    fn bring(&self, store: &mut Members<'_>) {
        for item in &self.scratch.events.items[..self.scratch.events.movable] {
            store.bring(item.id, item.body.position, item.body.velocity);
        }
    }
}

impl Tick<'_> {
    /// Whether a body that is near nothing has to be advanced all the same: it stands still, and may fall asleep.
    fn minds(&self, body: usize) -> bool {
        let Scratch { floats, roughly, touches, .. } = &*self.scratch;
        floats[body]
            || roughly[body]
            || self.scratch.linked(body as u32).is_some()
            || touches.get(body).is_some_and(|touches| *touches)
    }

    /// Takes an island, or leaves it. `round` is how often it has grown in this step.
    fn advance(&mut self, store: &mut Members<'_>, round: usize) -> Verdict {
        self.scratch.members.clear();
        self.scratch.surfaces.clear();
        self.scratch.members.extend(store.members());
        self.scratch.lead_by_smallest();
        let count = store.len();
        if store.is_alone() && self.scratch.roughly[self.scratch.members[0] as usize] {
            return self.fly(store);
        }
        if round > Choice::MOST_GROWTHS || self.leaves_for_good(count) {
            self.guards.dense_ticks += 1;
            return self.leave();
        }
        store.surfaces(&mut self.scratch.surfaces);
        if let Some(verdict) = self.leave_linked(store) {
            return verdict;
        }
        self.scratch.lead_by_smallest();
        let (whole, count) = (count, self.scratch.members.len());
        self.scratch.gather(self.state, &self.scene, |body| store.swept(body));
        called(Part::Exact);
        let outcome = self.scratch.events.advance(&self.scene);
        self.guards.add(&std::mem::take(&mut self.scratch.events.guards));
        match outcome {
            Outcome::Grown => {
                self.guards.islands_grown += 1;
                let fastest = self.scratch.events.fastest() * (2.0 * self.scene.tick);
                for k in 0..self.scratch.members.len() {
                    let body = self.scratch.members[k];
                    let way = store.swept(body).size() * round as f64;
                    store.widen(body, fastest + way);
                }
                Verdict::Grown
            }
            Outcome::Done => {
                self.scratch.scatter(self.state);
                self.bring(store);
                let items = &self.scratch.events.items[..count];
                let still = |item: &Item| item.rests(self.state.bodies[item.id as usize].position);
                let rests =
                    whole == count && self.scene.direct && items.iter().all(still) && self.scratch.events.stands_on_what_stands();
                Verdict::Taken { rests }
            }
            Outcome::Busy => {
                self.guards.budgets_used_up += 1;
                self.leave()
            }
        }
    }

    /// Whether the contacts of an island of this many bodies are listed.
    fn lists(&self, members: usize) -> bool {
        self.lists || members <= Choice::ALWAYS_LISTED
    }

    /// Whether an island of so many bodies is a crowd: then it falls asleep as the crowd step leaves it.
    fn leaves_for_good(&self, members: usize) -> bool {
        members > Choice::MOST_BY_EVENTS || self.scene.dense
    }

    /// What an earlier solution of the island of this body came to holds no longer.
    fn forget(&mut self, body: usize) {
        let noted = self.scratch.after[body].noted;
        let After { members, leader, .. } = std::mem::replace(&mut self.scratch.after[body], After { noted, ..After::default() });
        if members == 0 || leader as usize != body {
            return;
        }
        let Scratch { contacts, happened, crushed, stops, .. } = &mut *self.scratch;
        contacts.retain(|(of, _)| *of != leader);
        happened.retain(|happened| happened.island != leader);
        crushed.retain(|(of, ..)| *of != leader);
        stops.retain(|stop| stop.leader != leader);
    }

    /// A surface stands for the whole step.
    fn stand(&mut self, surface: usize) {
        self.scratch.stops.push(Stop { leader: NOBODY, surface: surface as u32, at: 0.0 });
    }
}

impl Space {
    /// Whether a body is awake or a surface moves.
    pub(crate) fn is_stirred(&self) -> bool {
        let carries = |j: &u32| self.bodies.carries(self.bodies.len() + *j as usize);
        !self.sleep.all_asleep() || !self.movers.targets.is_empty() || self.movers.moving.iter().any(carries)
    }

    /// Advances all by `dt` seconds, > 0.
    pub(crate) fn step_with(&mut self, dt: f64, tick: &mut Tick<'_>) {
        self.impacts.clear();
        self.squeezed.clear();
        if self.is_stirred() {
            let Self { sleep, dense, .. } = self;
            dense.report.list.retain(|contact| sleep.sleeps(contact.a));
            self.movers.advance(&mut self.bodies, dt);
            self.fly(dt);
            self.last_dt = dt;
            self.solve_islands(dt, tick);
            self.bodies.commit();
        }
        for (id, ..) in self.bodies.guided.drain(..) {
            self.bodies.is_guided[id as usize] = false;
        }
        self.movers.targets.clear();
        self.movers.ways.clear();
    }

    fn solve_islands(&mut self, dt: f64, tick: &mut Tick<'_>) {
        for k in 0..self.sleep.looked_at().len() {
            let i = self.sleep.looked_at()[k] as usize;
            (self.growths[i], self.again[i]) = (0, false);
        }
        let mut again = false;
        loop {
            self.islands.sort(&self.bodies);
            self.islands.find(&self.bodies, &self.broad_phase, &self.movers.moving);
            let minds = |tick: &Tick<'_>| self.sleep.looked_at().iter().any(|body| tick.minds(*body as usize));
            if !again && self.islands.are_alone() && (tick.bare || !minds(tick)) {
                return self.let_all_fly();
            }
            for k in 0..self.islands.len() {
                if !again || self.begin_again(k, tick) {
                    self.solve(k, dt, tick);
                }
            }
            if self.dense.grown.is_empty() {
                break;
            }
            again = true;
            self.grow(dt);
        }
        let Self { dense, impacts, solved, .. } = self;
        dense.report.list.retain(|contact| contact.solved == solved[contact.a]);
        impacts.retain(|hit| hit.solved == solved[hit.a]);
    }

    /// Nobody is near anything.
    fn let_all_fly(&mut self) {
        let Self { bodies, sleep, .. } = self;
        for i in sleep.looked_at().iter().map(|i| *i as usize) {
            (bodies.ux[i], bodies.uy[i]) = (bodies.free_vx[i], bodies.free_vy[i]);
            if sleep.sleeps(i) {
                bodies.stay(i);
            }
        }
    }

    /// Solves an island by the method that is right for it.
    fn solve(&mut self, k: usize, dt: f64, tick: &mut Tick<'_>) {
        let Self { bodies, islands, dense, sleep, growths, solved, .. } = self;
        let island = islands.get(k);
        if sleep.stays_asleep(bodies, island) {
            return;
        }
        let first = island.members[0] as usize;
        if island.is_alone() && !tick.minds(first) {
            (bodies.ux[first], bodies.uy[first]) = (bodies.free_vx[first], bodies.free_vy[first]);
            return sleep.wake(first);
        }
        island.members.iter().for_each(|i| solved[*i as usize] += 1);
        // It depends on no other island how often this one has grown, or those of which it is made now.
        let round = island.members.iter().map(|i| growths[*i as usize]).max().unwrap_or(0) as usize;
        let mut members = Members { bodies, island, grown: &mut dense.grown, down: self.down };
        let grows = match tick.advance(&mut members, round) {
            Verdict::Taken { rests } => {
                sleep.note(island, self.may_sleep && rests);
                false
            }
            Verdict::Grown => true,
            Verdict::Left => self.solve_crowd(k, (dt, round), tick) == CrowdOutcome::Grown,
        };
        if grows {
            let island = self.islands.get(k);
            island.members.iter().for_each(|i| self.growths[*i as usize] = round as u32 + 1);
        }
    }

    /// The crowd step of an island. Where a surface would squeeze a body it stands for this step, and the island is solved again.
    fn solve_crowd(&mut self, k: usize, (dt, round): (f64, usize), tick: &mut Tick<'_>) -> CrowdOutcome {
        let Self { bodies, islands, dense, sleep, .. } = self;
        let (n, island) = (bodies.len(), islands.get(k));
        let last = round >= Choice::MOST_CROWD_GROWTHS;
        let size = StepSize { dt, rest_speed: self.rest_speed, gravity: self.gravity, last };
        dense.report.on = tick.lists(island.members.len());
        for _ in 0..=self.movers.moving.len() {
            dense.squeezed.clear();
            if dense.step(bodies, island, size) == CrowdOutcome::Grown {
                return CrowdOutcome::Grown;
            }
            if dense.squeezed.is_empty() {
                break;
            }
            for &(body, surface, speed) in &dense.squeezed {
                let body = body as usize;
                self.squeezed.push(Squeeze { body, surface: surface as usize - n, speed });
                tick.stand(surface as usize - n);
                stand(bodies, surface as usize);
            }
            dense.undo(bodies);
            island.members.iter().for_each(|i| bodies.fall_freely(*i as usize));
        }
        sleep.finish(bodies, island, self.may_sleep && tick.leaves_for_good(island.members.len()));
        let other = |i: usize| if i < n { Other::Body(i) } else { Other::Surface(i - n) };
        for &(a, b, axis, speed) in &dense.hits {
            let a = a as usize;
            self.impacts.push(CrowdImpact { a, b: other(b as usize), axis, speed, solved: self.solved[a] });
        }
        let known = dense.report.list.len();
        dense.finish(bodies, island, self.down);
        dense.report.list[known..].iter_mut().for_each(|contact| contact.solved = self.solved[contact.a]);
        CrowdOutcome::Done
    }

    /// Whether an island of a later round has to be solved; takes back what was solved of it before.
    fn begin_again(&mut self, k: usize, tick: &mut Tick<'_>) -> bool {
        let Self { bodies, islands, sleep, again, .. } = self;
        let members = islands.get(k).members;
        if !members.iter().any(|i| again[*i as usize]) {
            return false;
        }
        for i in members.iter().map(|i| *i as usize) {
            again[i] = false;
            bodies.fall_freely(i);
            sleep.wake(i);
            tick.forget(i);
        }
        true
    }

    /// Finds whom those may meet that go further than was looked for.
    fn grow(&mut self, dt: f64) {
        let Self { bodies, broad_phase, dense, again, .. } = self;
        dense.grown.iter().for_each(|i| again[*i as usize] = true);
        broad_phase.update(bodies, &dense.grown, dt);
        dense.grown.clear();
        self.rouse_reached();
    }
}
