//! Which method advances an island, and what the islands of a tick come to.
//!
//! An island is whatever could meet within the tick. The least method that is right for it takes it:
//!
//! | what is in it | method | cost, measured on two cores, one thread |
//! |---|---|---|
//! | nothing moves, and nothing that moves comes near | rest | nothing |
//! | one body, near nothing | flight in closed form | 2 ns, with drag 9 ns a body |
//! | up to [`MOST_BY_EVENTS`] bodies | event by event, up to a number of events a tick | 0.2 µs a body, 2 µs an impact |
//! | more, or more events than that | one crowd step | 60 to 200 ns a body |
//!
//! In a gas or a heap the crowd step is cheaper from about 50 bodies on; the count of events makes sure of it for fewer.

use crate::physics::crowd::bodies::{Bodies, Frame, Origin};
use crate::physics::crowd::{CrowdImpact, dense::CrowdEnd, dense::StepSize};
use crate::physics::data::{NONE, Part, called, tuning::MANY};
use crate::physics::exact::{ExactEnd, Scene, item::Item};
use crate::physics::store::{Island, Method, Motions, SurfaceMotion};
use crate::physics::{flight::liquid::flow_through, flight::steps::Course, forces::ForceKind, scratch::Scratch, scratch::Stop};
use crate::physics::{space::Space, state::Guards, state::State};
use glam::DVec2;

/// Islands of more bodies are dense. More: a heap that settles costs more than a millisecond a tick; fewer: gases are less exact.
const MOST_BY_EVENTS: usize = 64;
/// Smaller islands at rest are solved from scratch when a force on them changes: equal supports share alike. Larger: columns cost more.
const MANY_AT_REST: usize = 9;
/// Worlds of more bodies list no contact forces before their first tick.
pub(crate) const MOST_AT_FIRST: usize = 1024;
/// How often an island may grow before the crowd step takes it, which can keep bodies within what was looked for.
const MOST_GROWTHS: u8 = 3;
/// How often a crowd may grow in one tick. Fewer: bodies are kept within what was looked for.
const MOST_CROWD_GROWTHS: usize = 4;

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

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// It is where it is at the end of the step; whether all of it rests.
    Taken { rests: bool },
    /// The crowd step shall take it.
    Left,
    /// Bodies may get further than others were looked for; their swept boxes have been widened.
    Grown,
}

/// An island, and what the solution of it may change.
pub(crate) struct Members<'a> {
    pub motions: &'a mut Motions,
    pub island: Island<'a>,
    /// Bodies that may get further than others were looked for.
    pub grown: &'a mut Vec<u32>,
}

impl Members<'_> {
    /// Widens where others are looked for by `reach` (m) to all sides; the islands are found again then.
    pub fn widen(&mut self, body: u32, reach: DVec2) {
        self.motions.widen(body as usize, reach);
        self.grown.push(body);
    }
}

impl Tick<'_> {
    /// Lets a body fly that has turned out to be near nothing, and of which it is known roughly only where it gets.
    fn fly(&mut self, members: &mut Members<'_>) -> Verdict {
        let i = members.island.members[0];
        let body = &self.state.bodies[i as usize];
        let law = self.scene.media.law(body, self.state.forces[i as usize].push(), self.scene.tick);
        let Course { end, pull, .. } = flow_through(self.scene.media, body, &law, self.scene.tick);
        let motion = &mut members.motions.bodies[i as usize];
        motion.end = end;
        motion.pull_at_end(pull);
        if members.motions.is_swept(i as usize, body.half) {
            return Verdict::Taken { rests: false };
        }
        self.guards.islands_grown += 1;
        members.widen(i, (end.0 - body.position).abs());
        Verdict::Grown
    }

    /// Whether a body that is near nothing has to be advanced all the same: it stands still, and may fall asleep.
    fn minds(&self, motions: &Motions, body: usize) -> bool {
        motions.bodies[body].floats
            || motions.bodies[body].roughly
            || self.scratch.linked(body as u32).is_some()
            || (!self.scene.media.fluids.is_empty() && self.scratch.touches.get(body).is_some_and(|touches| *touches))
    }

    /// Takes an island, or leaves it. In this step it has grown `round` times, after `spent` events.
    fn advance(&mut self, of: &mut Members<'_>, (round, spent): (u8, u32)) -> Verdict {
        let island = of.island;
        let count = island.members.len();
        if island.is_alone() && of.motions.bodies[island.members[0] as usize].roughly {
            return self.fly(of);
        }
        if self.state.links.all.is_empty() && self.leaves_for_good(count) {
            self.guards.dense_ticks += 1;
            return Verdict::Left;
        }
        self.scratch.members.clear();
        self.scratch.surfaces.clear();
        self.scratch.members.extend_from_slice(island.members);
        self.scratch.surfaces.extend(island.surfaces(of.motions.len()));
        if self.rests(of) && self.scratch.stand(self.state, of.motions) {
            return Verdict::Taken { rests: true };
        }
        if let Some(verdict) = self.leave_linked(of) {
            return verdict;
        }
        let (whole, count) = (count, self.scratch.members.len());
        if round > MOST_GROWTHS || self.leaves_for_good(whole) {
            self.guards.dense_ticks += 1;
            return Verdict::Left;
        }
        self.scratch.gather(self.state, &self.scene, |body| of.motions.swept[body as usize]);
        self.scratch.events.spent = u64::from(spent);
        called(Part::Exact);
        let outcome = self.scratch.events.advance(&self.scene);
        self.guards.add(&std::mem::take(&mut self.scratch.events.guards));
        match outcome {
            ExactEnd::Grown => {
                self.guards.islands_grown += 1;
                let fastest = self.scratch.events.fastest() * (2.0 * self.scene.tick);
                for &body in &self.scratch.members {
                    let way = of.motions.swept[body as usize].size() * f64::from(round);
                    of.widen(body, fastest + way);
                }
                Verdict::Grown
            }
            ExactEnd::Done => {
                self.scratch.stop_on_links(self.state);
                self.scratch.scatter(self.state, of.motions);
                let items = &self.scratch.events.items[..count];
                let still = |item: &Item| item.is_still() && item.body.position == self.state.bodies[item.id as usize].position;
                let rests = (whole == count || self.scratch.flown_rest())
                    && self.scene.plan.direct
                    && items.iter().all(still)
                    && self.scratch.events.stands_on_what_stands();
                Verdict::Taken { rests }
            }
            ExactEnd::Busy => {
                self.guards.budgets_used_up += 1;
                Verdict::Left
            }
        }
    }

    /// Whether all of an island rested in the tick before, on what stands, and only constant forces act on it.
    fn rests(&self, of: &Members<'_>) -> bool {
        let Self { state, scratch, .. } = self;
        let island = of.island;
        let rests = |i: &u32| {
            let body = &state.bodies[*i as usize];
            body.velocity == DVec2::ZERO && body.acceleration == DVec2::ZERO
        };
        let carries = |surface: &u32| of.motions.surfaces[*surface as usize].carries();
        (MANY_AT_REST..=MOST_BY_EVENTS).contains(&island.members.len())
            && state.media.streams.is_empty()
            && state.media.fluids.is_empty()
            && state.links.all.is_empty()
            && island.members.iter().all(rests)
            && !scratch.surfaces.iter().any(carries)
    }

    /// Whether an island of this many bodies is a crowd: then it falls asleep as the crowd step leaves it.
    fn leaves_for_good(&self, members: usize) -> bool {
        members > MOST_BY_EVENTS || self.scene.plan.dense
    }

    /// What an earlier solution of the island of this body came to holds no longer.
    fn forget(&mut self, motions: &mut Motions, body: usize) {
        let motion = &mut motions.bodies[body];
        let method = std::mem::take(&mut motion.method);
        motion.known = true;
        if method == Method::Flight || motion.leader as usize != body {
            return;
        }
        let (leader, Scratch { contacts, happened, crushed, stops, .. }) = (body as u32, &mut *self.scratch);
        contacts.retain(|(of, _)| *of != leader);
        happened.retain(|(of, ..)| *of != leader);
        crushed.retain(|(of, ..)| *of != leader);
        stops.retain(|stop| stop.leader != leader);
    }
}

impl Space {
    /// Advances all by `dt` seconds, > 0.
    pub(crate) fn step_with(&mut self, dt: f64, tick: &mut Tick<'_>) {
        self.impacts.clear();
        self.crowd.dense.report.list.clear();
        self.fly(&tick.state.bodies, dt);
        // After a step of another length nobody is known to rest.
        self.crowd.settled.step += if dt == self.last_dt { 1 } else { 2 };
        self.crowd.settled.carried = self.motions.surfaces.iter().any(SurfaceMotion::carries);
        self.last_dt = dt;
        self.solve_islands(dt, tick);
        for surface in &self.moving {
            let motion = &mut self.motions.surfaces[*surface as usize];
            motion.from = motion.to;
        }
    }

    fn solve_islands(&mut self, dt: f64, tick: &mut Tick<'_>) {
        let mut again = false;
        loop {
            self.islands.sort(&tick.state.bodies, self.down);
            self.widened.clear();
            self.islands.find(&self.motions, &self.broad_phase, &self.moving);
            let minds = |tick: &Tick<'_>| self.sleep.looked_at.iter().any(|body| tick.minds(&self.motions, *body as usize));
            if !again && self.islands.are_alone() && (tick.bare || !minds(tick)) {
                // Nobody is near anything: those that are awake fly.
                let Self { motions, sleep, .. } = self;
                for i in sleep.looked_at.iter().map(|i| *i as usize).filter(|i| sleep.asleep[*i]) {
                    motions.bodies[i].end = (tick.state.bodies[i].position, DVec2::ZERO);
                }
                return;
            }
            for k in 0..self.islands.len() {
                if !again || self.begin_again(k, tick) {
                    self.solve(k, dt, tick);
                }
            }
            if self.grown.is_empty() {
                break;
            }
            again = true;
            self.broad_phase.update(&tick.state.bodies, &self.motions, &self.grown, dt);
            self.grown.clear();
            self.rouse_reached();
        }
        let Self { crowd, impacts, motions, .. } = self;
        crowd.dense.report.list.retain(|contact| contact.solved == motions.bodies[contact.a as usize].solved);
        impacts.retain(|hit| hit.solved == motions.bodies[hit.a as usize].solved);
    }

    fn solve(&mut self, k: usize, dt: f64, tick: &mut Tick<'_>) {
        let Self { motions, islands, grown, sleep, .. } = self;
        let island = islands.get(k);
        if sleep.stays_asleep(&tick.state.bodies, motions, island) {
            return;
        }
        let first = island.members[0] as usize;
        if island.is_alone() && !tick.minds(motions, first) {
            return sleep.wake(first);
        }
        // It depends on no other island how often this one has grown, or those of which it is made now.
        let (mut round, mut spent) = (0, 0);
        for i in island.members {
            let motion = &mut motions.bodies[*i as usize];
            motion.solved += 1;
            (round, spent) = (round.max(motion.growths), spent.max(motion.spent));
        }
        tick.scratch.events.count = 0;
        let grows = match tick.advance(&mut Members { motions, island, grown }, (round, spent)) {
            Verdict::Taken { rests } => {
                sleep.note(island, rests);
                false
            }
            Verdict::Grown => true,
            Verdict::Left => self.solve_crowd(k, (dt, round as usize), tick) == CrowdEnd::Grown,
        };
        if grows {
            // All of them are solved again, also where a surface that stands now joins them no longer.
            let spent = spent + tick.scratch.events.count as u32;
            for i in self.islands.get(k).members {
                let motion = &mut self.motions.bodies[*i as usize];
                (motion.growths, motion.spent, motion.again) = (round + 1, spent, true);
            }
        }
    }

    /// The crowd step of an island. Where a surface would squeeze a body it stands for this step, and the island is solved again.
    fn solve_crowd(&mut self, k: usize, (dt, round): (f64, usize), tick: &mut Tick<'_>) -> CrowdEnd {
        let Self { motions, islands, crowd, sleep, impacts, broad_phase, grown, widened, moving, .. } = self;
        let state = tick.state;
        let (bodies, surfaces, bounces) = (&state.bodies[..], &state.surfaces[..], tick.scene.plan.bounces);
        let usual = Frame { swapped: false, down: self.down };
        let (frame, gravity) = match pull_of_fields(state, islands.get(k).members) {
            Some(pull) => (Frame::of(pull), pull.abs().max_element()),
            None => (usual, state.media.gravity.abs()),
        };
        if frame != usual {
            islands.turn(k, |i| frame.turn(state.bodies[i as usize].position).y);
        }
        let islands = &*islands;
        let island = if frame == usual { islands.get(k) } else { islands.turned() };
        let last = round >= MOST_CROWD_GROWTHS;
        let size = StepSize { dt, rest_speed: state.rest_speed, gravity, last };
        // Contacts are listed where forces were asked for, and always of few bodies.
        crowd.dense.report.on = tick.lists || (island.members.len() <= MANY && !tick.scene.plan.dense);
        for _ in 0..=moving.len() {
            let from = Origin { bodies, surfaces, motions, frame, bounces };
            let meets_more = |bodies: &Bodies, k: usize| {
                let swept = bodies.swept(k, frame);
                let me = (bodies.ids[k], &swept);
                !moving.is_empty() || sleep.is_reached(&swept) || islands.meets_more(me, widened, motions, broad_phase)
            };
            let end = crowd.step(from, island, size, meets_more);
            for k in crowd.dense.grown.drain(..) {
                let (i, swept) = (crowd.bodies.ids[k as usize], crowd.bodies.swept(k as usize, frame));
                motions.swept[i as usize] = swept;
                match end {
                    CrowdEnd::Grown => grown.push(i),
                    CrowdEnd::Done => widened.push((i, swept)),
                }
            }
            if end == CrowdEnd::Grown {
                return end;
            }
            if crowd.dense.squeezed.is_empty() {
                break;
            }
            for &(body, surface, speed) in &crowd.dense.squeezed {
                let [body, item] = [body, surface].map(|k| crowd.bodies.ids[k as usize]);
                let surface = item - motions.len() as u32;
                tick.scratch.crushed.push((NONE, body, surface, state.bodies[body as usize].crushing_force(speed)));
                tick.scratch.stops.push(Stop { leader: NONE, surface, at: 0.0 });
                motions.surfaces[surface as usize].stand();
            }
        }
        for i in island.members.iter().map(|i| *i as usize) {
            motions.bodies[i].end = (state.bodies[i].position, DVec2::ZERO);
        }
        for (i, member) in crowd.bodies.ids.iter().zip(crowd.bodies.all()) {
            motions.bodies[*i as usize].end = (frame.turn(member.to), frame.turn(member.end));
        }
        // What falls asleep is read later: its contacts are listed now.
        let may_sleep = tick.scene.plan.direct && tick.leaves_for_good(island.members.len());
        let sleeps = sleep.finish(&state.bodies, motions, (island, may_sleep));
        crowd.dense.report.on |= sleeps;
        if sleeps && crowd.bodies.len() < island.members.len() {
            let from = Origin { bodies, surfaces, motions, frame, bounces };
            crowd.step(from, island, size, |_, _| true);
        }
        for i in island.members {
            let motion = &mut motions.bodies[*i as usize];
            (motion.method, motion.leader, motion.known) = (Method::Crowd, island.members[0], false);
            motion.listed = crowd.dense.report.on;
        }
        for &(a, b, axis, speed) in &crowd.dense.hits {
            let [a, b] = [a, b].map(|k| crowd.bodies.ids[k as usize]);
            impacts.push(CrowdImpact { a, b, axis: frame.axis(axis), speed, solved: motions.bodies[a as usize].solved });
        }
        crowd.finish(frame, |i| motions.bodies[i as usize].solved);
        CrowdEnd::Done
    }

    /// Whether an island of a later round has to be solved; takes back what was solved of it before.
    fn begin_again(&mut self, k: usize, tick: &mut Tick<'_>) -> bool {
        let Self { motions, islands, sleep, .. } = self;
        let members = islands.get(k).members;
        if !members.iter().any(|i| motions.bodies[*i as usize].again) {
            return false;
        }
        for i in members.iter().map(|i| *i as usize) {
            motions.bodies[i].again = false;
            motions.fall_freely(i);
            sleep.wake(i);
            tick.forget(motions, i);
        }
        true
    }
}

/// How strongly gravity and fields pull at these bodies on average, m/s²; none where no field does. Forces of engines and of streams turn no heap.
fn pull_of_fields(state: &State, members: &[u32]) -> Option<DVec2> {
    let field = |i: &u32| state.forces[*i as usize].total(ForceKind::Weight);
    let bodies = || members.iter().map(|i| &state.bodies[*i as usize]);
    let force = || bodies().map(|body| state.media.weight(body)).chain(members.iter().map(field)).sum::<DVec2>();
    let pulled = members.iter().any(|i| field(i) != DVec2::ZERO);
    pulled.then(|| force() / bodies().map(|body| body.mass).sum::<f64>()).filter(|pull| *pull != DVec2::ZERO)
}
