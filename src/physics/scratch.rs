//! The buffers of a tick, and how islands pass through them: gathered for the event-driven method, and taken over from it into what the
//! world keeps.

#[cfg(all(feature = "validate", debug_assertions))]
use crate::physics::checks::Checks;
use crate::physics::data::lists::refill;
use crate::physics::data::tuning::SLOP;
use crate::physics::data::{Aabb, BodyId, Contact, Impulse, Obstacle};
use crate::physics::exact::item::Item;
use crate::physics::exact::{Events, Scene};
use crate::physics::flight::linked::Member;
use crate::physics::state::State;
use crate::physics::store::motions::{Method, Motions};
use glam::DVec2;

/// The leader of no island.
pub(crate) const NOBODY: u32 = u32::MAX;

/// A surface that stops within a tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stop {
    /// The smallest body of the island.
    pub leader: u32,
    pub surface: u32,
    /// s from the tick's start; infinite where it goes on.
    pub at: f64,
}

/// When a surface stops, s from the tick's start; infinite where it goes on.
pub(crate) fn first_stop(stops: &[Stop], surface: u32) -> f64 {
    stops.iter().filter(|stop| stop.surface == surface).map(|stop| stop.at).fold(f64::INFINITY, f64::min)
}

/// Something for the records, with the smallest body of its island.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Happened {
    pub island: u32,
    pub order: u32,
    pub impulse: Impulse,
    pub normal: DVec2,
    /// Closing speed, m/s.
    pub speed: f64,
    /// Where the two were, m.
    pub places: [DVec2; 2],
}

/// The buffers of a tick. Nothing in them outlives it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    pub events: Events,
    #[cfg(all(feature = "validate", debug_assertions))]
    pub checks: Checks,
    /// What the islands found out, with the smallest body of the island that it came from.
    pub contacts: Vec<(u32, Contact)>,
    pub happened: Vec<Happened>,
    /// Body, surface and force, N.
    pub crushed: Vec<(u32, u32, u32, f64)>,
    /// Which surfaces the islands have stopped because they would have squeezed something.
    pub stops: Vec<Stop>,
    /// All that contacts of the crowd step exert on each body, N.
    pub pressed: Vec<f64>,
    /// Of each body and each surface behind them: its number in the present island.
    local: Vec<u32>,
    /// Which bodies and surfaces begin the tick in contact with something, where there are liquids.
    pub touches: Vec<bool>,
    /// What pulls at each body where its flight through liquids ends, m/s², if that came out of it.
    pub pulls: Vec<Option<DVec2>>,
    /// Bodies of which it is known roughly only where they get.
    pub roughly: Vec<bool>,
    /// Bodies that stand still although nothing holds them: they may fall asleep.
    pub floats: Vec<bool>,
    /// Of the present island: its bodies, and the surfaces near it.
    pub members: Vec<u32>,
    pub surfaces: Vec<u32>,
    /// Contacts known at the start of the tick, sorted: those whose smaller end is body i begin at `starts[i]`. Emptied where they change.
    pub starts: Vec<u32>,
    /// Contacts that the tick has found.
    pub fresh: Vec<Contact>,
    /// Whom the tick has to look at.
    pub awake: Vec<u32>,
    /// Bodies that are linked and awake, ascending; pairs that join them; and those of an island that touch nothing.
    pub linked: Vec<Member>,
    pub pairs: Vec<(u32, u32)>,
    pub flown: Vec<u32>,
}

impl Scratch {
    /// Before the first tick.
    pub fn begin(&mut self, bodies: usize) {
        self.begin_tick(bodies);
        self.starts.clear();
    }

    /// Forgets what the last tick of this many bodies has left.
    pub fn begin_tick(&mut self, bodies: usize) {
        if self.pulls.len() == bodies {
            for i in self.awake.drain(..) {
                let i = i as usize;
                (self.pulls[i], self.floats[i], self.roughly[i]) = (None, false, false);
            }
        } else {
            for flags in [&mut self.floats, &mut self.roughly] {
                refill(flags, bodies, false);
            }
            self.pulls.clear();
            self.pulls.resize(bodies, None);
            self.awake.clear();
        }
        self.contacts.clear();
        self.happened.clear();
        self.crushed.clear();
        self.stops.clear();
        self.members.clear();
        self.surfaces.clear();
    }

    /// When a surface stops, s from the tick's start; infinite where it goes on.
    pub fn stop_of(&self, surface: u32) -> f64 {
        first_stop(&self.stops, surface)
    }

    /// Finds where the contacts of each body begin, unless that is known.
    pub fn index(&mut self, state: &State) {
        let n = state.bodies.len();
        if self.starts.len() == n + 1 {
            return;
        }
        self.starts.clear();
        let mut at = 0;
        for i in 0..=n as u32 {
            while state.contacts.get(at).is_some_and(|contact| contact.ends().0 < i) {
                at += 1;
            }
            self.starts.push(at as u32);
        }
    }

    /// Fills the island of the event-driven method with `members` (in any order) and `surfaces` (some maybe twice), the streams near them and
    /// the contacts known; `searched` says where others were looked for.
    pub fn gather(&mut self, state: &State, scene: &Scene, searched: impl Fn(u32) -> Aabb) {
        let n = state.bodies.len();
        self.index(state);
        let Self { events, local, members, surfaces, stops, starts, linked, .. } = self;
        events.clear();
        members.sort_unstable();
        surfaces.sort_unstable();
        surfaces.dedup();
        local.resize(n + state.surfaces.len(), u32::MAX);
        let mut everything = searched(members[0]);
        for &body in &*members {
            let i = body as usize;
            local[i] = events.items.len() as u32;
            let searched = searched(body);
            everything = everything.union(&searched);
            events.items.push(Item::body(body, &state.bodies[i], state.forces[i].push_of_no_zone(), searched, state.known[i]));
        }
        events.movable = members.len();
        for link in state.links.all.iter().filter(|_| !linked.is_empty()) {
            let inside = |id: u32| members.binary_search(&id).is_ok();
            if inside(link.body.0) || link.other().is_some_and(|other| inside(other.0)) {
                events.links.push(*link);
            }
        }
        for member in &*linked {
            match members.binary_search(&member.id) {
                Ok(at) => (events.items[at].link, events.items[at].known) = (member.mean, false),
                Err(_) => events.ends.push((member.id, member.pose)),
            }
        }
        for &s in &*surfaces {
            let surface = &state.surfaces[s as usize];
            if !surface.present {
                continue;
            }
            local[n + s as usize] = events.items.len() as u32;
            let mut item = Item::surface(s, surface);
            // An earlier solution of the tick may have stopped it.
            item.stops_at = first_stop(stops, s);
            scene.set_on_path(&mut item, 0.0);
            events.items.push(item);
        }
        events.streams.extend(state.media.streams_at(&everything, SLOP).iter());
        for &body in &*members {
            let of_body = starts[body as usize] as usize..starts[body as usize + 1] as usize;
            for contact in &state.contacts[of_body] {
                let (lo, hi) = (local[contact.lo as usize], local[contact.hi as usize]);
                if lo != u32::MAX && hi != u32::MAX {
                    events.contacts.push(Contact { lo, hi, ..*contact });
                }
            }
        }
        for item in &events.items {
            local[if item.surface { n + item.id as usize } else { item.id as usize }] = u32::MAX;
        }
    }

    pub fn take_contacts(&mut self, state: &State) {
        let n = state.bodies.len() as u32;
        let Self { events, contacts, members, .. } = self;
        let items = &events.items;
        let global = |item: u32| if items[item as usize].surface { n + items[item as usize].id } else { items[item as usize].id };
        let global = |contact: &Contact| Contact { lo: global(contact.lo), hi: global(contact.hi), ..*contact };
        contacts.extend(events.contacts.iter().map(|contact| (members[0], global(contact))));
    }

    pub fn scatter(&mut self, state: &State, motions: &mut Motions) {
        self.take_contacts(state);
        let Self { events, happened, stops, crushed, members, .. } = self;
        let leader = members[0];
        let Events { items, movable, .. } = events;
        for item in &items[..*movable] {
            let motion = &mut motions.bodies[item.id as usize];
            motion.end = (item.body.position, item.body.velocity);
            (motion.method, motion.leader) = (Method::Events, leader);
            (motion.acceleration, motion.known) = (item.solved + DVec2::ZERO, item.known);
        }
        for hit in &events.hits {
            let (a, b, sign) = if hit.lo < hit.hi { (hit.lo, hit.hi, -1.0) } else { (hit.hi, hit.lo, 1.0) };
            let mut normal = DVec2::ZERO;
            normal[hit.axis] = sign;
            let other = &items[b as usize];
            let b = if other.surface { Obstacle::Surface(other.id) } else { Obstacle::Body(BodyId(other.id)) };
            let impulse = Impulse { a: BodyId(items[a as usize].id), b, vector: hit.impulse * sign, point: hit.point, at: hit.at };
            let places = if sign < 0.0 { hit.places } else { [hit.places[1], hit.places[0]] };
            happened.push(Happened { island: leader, order: happened.len() as u32, impulse, normal, speed: hit.speed, places });
        }
        for &(body, surface, speed) in &events.squeezed {
            let (of, by) = (&items[body as usize], &items[surface as usize]);
            crushed.push((leader, of.id, by.id, of.body.crushing_force(speed)));
        }
        for item in &items[*movable..] {
            if item.stops_at.is_finite() {
                stops.push(Stop { leader, surface: item.id, at: item.stops_at });
            }
        }
    }
}
