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

use crate::physics::data::plan::{Part, called};
use crate::physics::exact::item::Item;
use crate::physics::exact::{Outcome, Scene};
use crate::physics::flight::flow::{Course, flow_through};
use crate::physics::guards::Guards;
use crate::physics::scratch::{After, NOBODY, Scratch, Stop, first_stop};
use crate::physics::store::driver::advance::{Advance, Store, Verdict};
use crate::physics::world::State;

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
    /// How often islands are advanced anew in one tick until they agree when a surface stops that several of them meet. After that it
    /// stands still for the whole tick, and after twice as often islands are left as they are.
    const MOST_ROUNDS: u32 = 8;
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
    fn fly(&mut self, store: &mut Store<'_>) -> Verdict {
        let i = self.scratch.members[0];
        let body = &self.state.bodies[i as usize];
        let media = self.scene.media;
        let force = self.state.forces[i as usize].push();
        let law = media.law(body, force, self.scene.tick);
        media.ask_roughly(false);
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
    fn leave(&mut self, store: &mut Store<'_>) -> Verdict {
        self.scratch.leave();
        self.stop_surfaces(store);
        Verdict::Left
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
        floats[body]
            || roughly[body]
            || self.scratch.linked(body as u32).is_some()
            || touches.get(body).is_some_and(|touches| *touches)
    }

    fn minds_nobody(&self) -> bool {
        self.bare
    }

    fn advance(&mut self, store: &mut Store<'_>, round: usize) -> Verdict {
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
            return self.leave(store);
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
                self.leave(store)
            }
        }
    }

    fn lists(&self, members: usize) -> bool {
        self.lists || members <= Choice::ALWAYS_LISTED
    }

    fn leaves_for_good(&self, members: usize) -> bool {
        members > Choice::MOST_BY_EVENTS || self.scene.dense
    }

    fn forget(&mut self, body: usize) {
        let noted = self.scratch.after[body].noted;
        let After { members, leader, .. } = std::mem::replace(&mut self.scratch.after[body], After { noted, ..After::default() });
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

    fn disagree(&mut self, bodies: &mut Vec<u32>) {
        let Scratch { stops, met, rounds, .. } = &mut *self.scratch;
        let differs = |met: &Stop, stops: &[Stop]| met.at != first_stop(stops, met.surface);
        if stops.is_empty() || *rounds > 2 * Choice::MOST_ROUNDS || !met.iter().any(|met| differs(met, stops)) {
            return;
        }
        *rounds += 1;
        if *rounds > Choice::MOST_ROUNDS {
            for &Stop { surface, .. } in met.iter() {
                if first_stop(stops, surface) > 0.0 && met.iter().any(|met| met.surface == surface && differs(met, stops)) {
                    self.guards.surfaces_stopped += 1;
                    stops.push(Stop { leader: NOBODY, surface, at: 0.0 });
                }
            }
        }
        bodies.extend(met.iter().filter(|met| differs(met, stops)).map(|met| met.leader));
    }
}
