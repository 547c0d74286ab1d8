//! Which method advances an island, and what the islands of a tick come to.
//!
//! An island is whatever could meet within the tick. The least method that is right for it takes it:
//!
//! | what is in it | method | cost, measured on two cores, one thread |
//! |---|---|---|
//! | nothing moves, and nothing that moves comes near | rest | nothing |
//! | all glide as one, on surfaces that stand | one parabola | 110 ns a body |
//! | one body, near nothing | flight in closed form | 2 ns, with drag 9 ns a body |
//! | [`Choice::FEWEST_OF_A_GAS`] bodies or more that bounce without loss in a vacuum, and lie on nothing | impacts in their order, as a part of the dense method | 0.5 µs a body, 0.5 µs an impact |
//! | up to [`Choice::MOST_BY_EVENTS`] bodies | event by event, within a budget | 0.2 µs a body, 2 µs an impact |
//! | more, or more events than the budget holds | one step of the dense method for the rest of the tick | 50 to 200 ns a body |
//!
//! Event by event costs what happens: in a gas of 64 bodies some 30 impacts a tick, in a heap that settles every contact again and again.
//! There the dense method is cheaper from about 50 bodies on, and the budget makes sure of it for fewer. An island that has used up its budget
//! is taken by the dense method from the start for some ticks, twice as many each time and while as much happens, so that trying costs little
//! on average.

use super::Body;
use super::events::{BUDGET_OF_A_FLIGHT, BUDGET_OF_A_FLOW, Events, Item, Outcome, Scene};
use super::flow::{Course, flow, flow_through};
use super::guards::Guards;
use super::pile::{Advance, Store, Verdict};
use super::scratch::{After, Dispute, NOBODY, Scratch, Stop, first_stop};
use super::world::State;

/// The choice of methods.
pub(super) struct Choice;

impl Choice {
    /// Islands of more bodies are dense. More: a heap that settles costs more than a millisecond a tick; fewer: gases are less exact.
    pub const MOST_BY_EVENTS: usize = 64;
    /// Of fewer an island is no gas. Fewer: impacts are listed without their times where there is time for them; more: gases cost more.
    pub const FEWEST_OF_A_GAS: usize = 16;
    /// Worlds of more bodies list no contact forces before their first tick.
    pub const MOST_AT_FIRST: usize = 1024;
    /// The budget of an island, and what each of its bodies adds to it. Larger: the worst tick lasts longer; smaller: exactness is given up
    /// where fewer impacts fall into one tick.
    const BUDGET: u64 = 200_000;
    const BUDGET_OF_A_BODY: u64 = 1_500;
    /// What the budget of an island of few comes to, and for each body once more: so many bodies as one island may have, in however many islands
    /// they are, stay within what their flights through media may take.
    const BUDGET_OF_FEW: u64 = 16_000;
    /// What a liquid adds to that, and for each body in one once more: bounces in it cost more.
    const BUDGET_OF_WET: u64 = 12_000;
    /// Ticks for which an island is dense after its budget was used up for the first time, and at most.
    const FIRST_PAUSE: u16 = 8;
    const LONGEST_PAUSE: u16 = 128;
    /// How often an island may grow before the dense method takes it, which can keep bodies within what was looked for.
    const MOST_GROWTHS: usize = 3;
    /// Contacts of a dense island are listed if somebody asked for forces in the last tick, or if it has no more bodies than this.
    const ALWAYS_LISTED: usize = 256;
    /// How often islands are advanced anew in one tick until they agree when a surface stops that several of them meet. After that it
    /// stands still for the whole tick, and after twice as often islands are left as they are.
    const MOST_ROUNDS: u32 = 8;
}

/// A body whose island used up its budget.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pause {
    /// The tick from which on its island may be advanced event by event again.
    pub until: u64,
    /// How many ticks that was.
    pub length: u16,
    /// How many impacts its island had in the tick that used up the budget.
    pub hits: u32,
}

impl Pause {
    /// What follows for a body from how it ended tick `now`, in which its island had so many `hits`: a pause; one more, twice as long, if then
    /// still half as much happens as when it began; or, if it `moves` and its island stayed within its budget, that the next one will be a
    /// tick shorter. What rests may not have been looked at.
    pub fn go_on(&mut self, after: &After, moves: bool, hits: u32, now: u64) {
        let goes_on = after.dense && self.until == now + 1 && self.length < Choice::LONGEST_PAUSE && 2 * hits > self.hits;
        if after.busy || goes_on {
            let length = (2 * self.length).clamp(Choice::FIRST_PAUSE, Choice::LONGEST_PAUSE);
            let hits = if after.busy { hits } else { self.hits };
            *self = Self { until: now + 1 + u64::from(length), length, hits };
        } else if moves && !after.dense {
            self.length = self.length.saturating_sub(1);
        }
    }
}

/// A tick, as the islands see it.
pub(super) struct Tick<'a> {
    pub state: &'a State,
    pub scene: Scene<'a>,
    pub guards: &'a mut Guards,
    pub scratch: &'a mut Scratch,
    /// Whether somebody asked for forces in the last tick.
    pub lists: bool,
}

impl Tick<'_> {
    /// Whether the event-driven method pauses for an island.
    fn pauses(&self) -> bool {
        self.scratch.members.iter().any(|body| self.state.pauses[*body as usize].until > self.state.ticks)
    }

    /// Lets a body fly that has turned out to be near nothing, and of which it is known roughly only where it gets.
    fn fly(&mut self, store: &mut Store<'_>) -> Verdict {
        let i = self.scratch.members[0];
        let body = &self.state.bodies[i as usize];
        self.scene.media.allow(BUDGET_OF_A_FLIGHT);
        let Course { end: (position, velocity), pull, .. } =
            flow_through(self.scene.media, body, &self.state.ahead[i as usize].law, self.scene.tick);
        self.scratch.pulls[i as usize] = pull;
        store.bring(i, position, velocity);
        if store.is_swept(i) {
            return Verdict::Taken { rests: false };
        }
        self.guards.islands_grown += 1;
        store.widen(i, (position - body.position).abs());
        Verdict::Grown
    }

    /// Whether flights and impacts are all that there is, and those exact in the dense method too.
    fn is_gas(&self, store: &Store<'_>) -> bool {
        let State { bodies, media, .. } = self.state;
        let flies = |body: &Body| body.restitution == 1.0 && (media.air_density == 0.0 || body.drag == 0.0);
        self.scratch.members.len() >= Choice::FEWEST_OF_A_GAS
            && media.streams.is_empty()
            && media.fluids.is_empty()
            && self.scratch.members.iter().all(|body| flies(&bodies[*body as usize]))
            && store.is_gas()
    }

    /// Says where bodies that liquids or streams act on get in what is `left` of the tick (s): the dense method knows of none.
    fn lead(&self, store: &mut Store<'_>, left: f64) {
        let Events { items, movable, streams, .. } = &self.scratch.events;
        for item in items[..*movable].iter().filter(|item| item.law.is_near_liquid() || !streams.is_empty()) {
            self.scene.media.allow_roughly(BUDGET_OF_A_FLOW);
            let (position, velocity) = flow(self.scene.media, &item.body, &item.law, left);
            store.lead(item.id, position, velocity);
        }
    }

    /// What the island may still use up in this tick, in units of work.
    fn budget(&self) -> u64 {
        let Scratch { members, used, .. } = &*self.scratch;
        let count = members.len() as u64;
        let wet = members.iter().filter(|body| self.state.media.wets(&self.state.bodies[**body as usize].bounds())).count() as u64;
        let of_few = Choice::BUDGET_OF_FEW * (1 + count) + Choice::BUDGET_OF_WET * (wet + wet.min(1));
        let whole = (Choice::BUDGET + Choice::BUDGET_OF_A_BODY * count).min(of_few);
        whole.saturating_sub(members.iter().map(|body| used[*body as usize]).sum())
    }

    /// Notes what it has used up.
    fn use_up(&mut self, work: u64) {
        let Scratch { members, used, .. } = &mut *self.scratch;
        let of_each = work.div_ceil(members.len() as u64);
        members.iter().for_each(|body| used[*body as usize] += of_each);
    }

    /// Tells the dense method which of the surfaces that its island may meet others have stopped, and when it was told so.
    fn stop_surfaces(&mut self, store: &mut Store<'_>) {
        let Scratch { members, surfaces, stops, met, .. } = &mut *self.scratch;
        store.moving_surfaces(surfaces);
        surfaces.sort_unstable();
        surfaces.dedup();
        for &s in &*surfaces {
            let (surface, at) = (&self.state.surfaces[s as usize], first_stop(stops, s));
            met.push(Stop { leader: members[0], surface: s, at });
            if at < self.scene.tick {
                store.place_surface(s, (surface.bounds.centre(), surface.velocity), Some(surface.at(at).offset));
            }
        }
    }

    fn bring(&self, store: &mut Store<'_>) {
        for item in &self.scratch.events.items[..self.scratch.events.movable] {
            store.bring(item.id, item.body.position, item.body.velocity);
        }
    }
}

impl Advance for Tick<'_> {
    fn minds(&self, body: usize) -> bool {
        let Scratch { floats, roughly, touches, .. } = &*self.scratch;
        floats[body] || roughly[body] || touches.get(body).is_some_and(|touches| *touches)
    }

    fn advance(&mut self, store: &mut Store<'_>, round: usize) -> Verdict {
        self.scratch.members.clear();
        self.scratch.surfaces.clear();
        self.scratch.members.extend(store.members());
        self.scratch.members.sort_unstable();
        let count = store.len();
        if store.is_alone() && self.scratch.roughly[self.scratch.members[0] as usize] {
            return self.fly(store);
        }
        let budget = if self.leaves_for_good(count) { 0 } else { self.budget() };
        if round > Choice::MOST_GROWTHS || self.pauses() || budget == 0 {
            self.guards.dense_ticks += 1;
            self.scratch.leave();
            self.stop_surfaces(store);
            return Verdict::Left(f64::INFINITY);
        }
        if self.is_gas(store) {
            self.guards.dense_ticks += 1;
            self.scratch.leave();
            return Verdict::Gas;
        }
        store.surfaces(&mut self.scratch.surfaces);
        if self.is_held_as_before() {
            store.stay();
            return Verdict::Taken { rests: true };
        }
        if self.glides(store) {
            return Verdict::Taken { rests: false };
        }
        self.scratch.gather(self.state, &self.scene, |body| store.swept(body));
        let outcome = self.scratch.events.advance(&self.scene, budget);
        self.use_up(self.scratch.events.spent(&self.scene));
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
                self.scratch.scatter(self.state, true);
                self.bring(store);
                let items = &self.scratch.events.items[..count];
                let still = |item: &Item| item.rests(self.state.bodies[item.id as usize].position);
                let rests = self.scene.direct && items.iter().all(still) && self.scratch.events.stands_on_what_stands();
                Verdict::Taken { rests }
            }
            Outcome::Busy(at) => {
                self.guards.budgets_used_up += 1;
                self.scratch.scatter(self.state, false);
                for &body in &self.scratch.members {
                    let after = &mut self.scratch.after[body as usize];
                    (after.dense, after.busy) = (true, true);
                }
                self.bring(store);
                for item in &self.scratch.events.items[count..] {
                    let stops = match item.stops_at {
                        until if until <= at => Some(item.body.position),
                        until => (until < self.scene.tick).then(|| self.state.surfaces[item.id as usize].at(until).offset),
                    };
                    store.place_surface(item.id, (item.body.position, item.body.velocity), stops);
                }
                let left = self.scene.tick - at;
                self.lead(store, left);
                Verdict::Left(left)
            }
        }
    }

    fn lists(&self, members: usize, _: bool) -> bool {
        self.lists || members <= Choice::ALWAYS_LISTED
    }

    fn leaves_for_good(&self, members: usize) -> bool {
        members > Choice::MOST_BY_EVENTS || self.scene.dense
    }

    fn comes_upon(&mut self, body: usize, surface: usize) {
        if !self.state.surfaces[surface].def.path.is_still() {
            let (leader, surface) = (self.scratch.after[body].leader, surface as u32);
            self.scratch.met.push(Stop { leader, surface, at: f64::INFINITY });
        }
    }

    fn put_off(&mut self, body: usize) {
        let after = &mut self.scratch.after[body];
        self.guards.budgets_used_up += u64::from(after.leader as usize == body);
        after.busy = true;
    }

    fn forget(&mut self, body: usize) {
        let After { members, leader, .. } = std::mem::take(&mut self.scratch.after[body]);
        if members == 0 || leader as usize != body {
            return;
        }
        let Scratch { contacts, happened, crushed, met, stops, .. } = &mut *self.scratch;
        contacts.retain(|(of, _)| *of != leader);
        happened.retain(|happened| happened.island != leader);
        crushed.retain(|(of, ..)| *of != leader);
        met.retain(|met| met.leader != leader);
        stops.retain(|stop| stop.leader != leader);
    }

    fn stand(&mut self, surface: usize) {
        self.scratch.stops.push(Stop { leader: NOBODY, surface: surface as u32, at: 0.0 });
    }

    fn begin_anew(&mut self) {
        self.scratch.used.fill(0);
    }

    fn disagree(&mut self, bodies: &mut Vec<u32>) {
        let Scratch { stops, met, disputes, .. } = &mut *self.scratch;
        if stops.is_empty() {
            return;
        }
        // Each surface by itself: how long others take to agree about another is no concern of it.
        let differs = |met: &Stop, stops: &[Stop]| met.at != first_stop(stops, met.surface);
        for met in met.iter().filter(|met| differs(met, stops)) {
            if !disputes.iter().any(|dispute| dispute.surface == met.surface) {
                disputes.push(Dispute { surface: met.surface, rounds: 0, open: false });
            }
        }
        for Dispute { surface, rounds, open } in disputes.iter_mut() {
            let mine = |met: &&Stop| met.surface == *surface;
            *open = *rounds < 2 * Choice::MOST_ROUNDS && met.iter().filter(mine).any(|met| differs(met, stops));
            *rounds += u32::from(*open);
            if *open && *rounds > Choice::MOST_ROUNDS {
                self.guards.surfaces_stopped += u64::from(*rounds == Choice::MOST_ROUNDS + 1);
                let stops = stops.iter_mut().filter(|stop| stop.surface == *surface);
                stops.for_each(|stop| (stop.leader, stop.at) = (NOBODY, 0.0));
            }
        }
        let open = |surface: u32| disputes.iter().any(|dispute| dispute.open && dispute.surface == surface);
        bodies.extend(met.iter().filter(|met| open(met.surface) && differs(met, stops)).map(|met| met.leader));
    }
}
