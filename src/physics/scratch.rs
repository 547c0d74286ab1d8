//! The buffers of a tick, and how islands pass through them: gathered for the event-driven method, and taken over from it into what the
//! world keeps.

use super::contact::Contact;
use super::events::{Events, Item, Scene};
use super::impulse::Impulse;
use super::media::Media;
#[cfg(all(feature = "validate", debug_assertions))]
use super::validate::Checks;
use super::world::{Obstacle, State};
use super::zones::{self, Around};
use super::{Aabb, Body, BodyId};
use glam::DVec2;

/// The leader of no island.
pub(super) const NOBODY: u32 = u32::MAX;

/// A surface that stops within a tick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stop {
    /// The smallest body of the island.
    pub leader: u32,
    pub surface: u32,
    /// s from the tick's start; infinite where it goes on.
    pub at: f64,
}

/// Islands have come to different answers about when a surface stops.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dispute {
    pub surface: u32,
    /// How often they had to be advanced anew for it.
    pub rounds: u32,
    /// Whether they have to now.
    pub open: bool,
}

/// When a surface stops, s from the tick's start; infinite where it goes on.
pub(super) fn first_stop(stops: &[Stop], surface: u32) -> f64 {
    stops.iter().filter(|stop| stop.surface == surface).map(|stop| stop.at).fold(f64::INFINITY, f64::min)
}

/// How a body ends a tick that its island was advanced in.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct After {
    pub acceleration: DVec2,
    /// Whether contacts and acceleration are those of the end of the tick.
    pub known: bool,
    /// Whether the dense method took it, or the rest of its tick.
    pub dense: bool,
    /// Whether the budget of its island was used up.
    pub busy: bool,
    /// What else pulls at it, m/s², if its contacts were solved for rest.
    pub held: Option<DVec2>,
    /// How many bodies its island had, and the smallest of them; 0 where it flew or rested by itself.
    pub members: u32,
    pub leader: u32,
    /// Of a leader: how many impacts its island had.
    pub hits: u32,
}

/// Something for the records, with the smallest body of its island.
#[derive(Clone, Copy, Debug)]
pub(super) struct Happened {
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
pub(super) struct Scratch {
    pub events: Events,
    #[cfg(all(feature = "validate", debug_assertions))]
    pub checks: Checks,
    /// How each body ends the tick.
    pub after: Vec<After>,
    /// What the islands found out, with the smallest body of the island that it came from.
    pub contacts: Vec<(u32, Contact)>,
    pub happened: Vec<Happened>,
    /// Body, surface and force, N.
    pub crushed: Vec<(u32, u32, u32, f64)>,
    /// Which surfaces the islands have stopped because they would have squeezed something.
    pub stops: Vec<Stop>,
    /// Which moving surfaces each island has met, and when these stopped for it.
    pub met: Vec<Stop>,
    pub disputes: Vec<Dispute>,
    /// All that contacts of the dense method exert on each body, N.
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
    /// What streams there are around each body, once one has been near.
    pub around: Vec<Around>,
    /// What the islands of each body have used up since the tick was begun, or begun anew for all: however often they are advanced in between,
    /// they share one budget.
    pub used: Vec<u64>,
    /// Contacts known at the start of the tick, sorted: those whose smaller end is body i begin at `starts[i]`. Emptied where they change.
    pub starts: Vec<u32>,
    /// Contacts that the tick has found.
    pub fresh: Vec<Contact>,
    /// Whom the tick has to look at.
    pub awake: Vec<u32>,
}

impl Scratch {
    /// Before the first tick.
    pub fn begin(&mut self, bodies: usize) {
        self.after.clear();
        self.begin_tick(bodies, &[]);
        self.starts.clear();
    }

    /// For a tick of so many bodies: what the last one has left of those that it looked at is forgotten.
    pub fn begin_tick(&mut self, bodies: usize, looked_at: &[u32]) {
        if self.after.len() == bodies {
            for &i in looked_at {
                let i = i as usize;
                (self.after[i], self.used[i], self.pulls[i]) = (After::default(), 0, None);
                (self.floats[i], self.roughly[i]) = (false, false);
            }
        } else {
            self.after.clear();
            self.after.resize(bodies, After::default());
            self.used.clear();
            self.used.resize(bodies, 0);
            for flags in [&mut self.floats, &mut self.roughly] {
                flags.clear();
                flags.resize(bodies, false);
            }
            self.around.clear();
            self.pulls.clear();
            self.pulls.resize(bodies, None);
        }
        self.contacts.clear();
        self.happened.clear();
        self.crushed.clear();
        self.stops.clear();
        self.met.clear();
        self.members.clear();
        self.surfaces.clear();
        self.disputes.clear();
    }

    /// What streams there are around a body, whether or not that is still known.
    pub fn around(&mut self, body: usize) -> &mut Around {
        if self.around.len() < self.after.len() {
            self.around.resize(self.after.len(), Around::unknown());
        }
        &mut self.around[body]
    }

    /// The force of a body's engine, and of all streams that it feels, N.
    pub fn force_on(&self, media: &Media, i: usize, body: &Body, drive: DVec2) -> DVec2 {
        match self.around.get(i) {
            Some(around) => around.force_on(media, body, drive),
            None => zones::force_on(media, body, drive),
        }
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
        let Self { events, local, members, surfaces, stops, starts, around, .. } = self;
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
            events.items.push(Item::body(body, &state.bodies[i], state.drives[i], searched, state.known[i]));
        }
        events.movable = members.len();
        for &s in &*surfaces {
            let surface = &state.surfaces[s as usize];
            if !surface.present {
                continue;
            }
            local[n + s as usize] = events.items.len() as u32;
            let mut item = Item::surface(s, surface);
            item.stops_at = first_stop(stops, s);
            scene.set_on_path(&mut item, 0.0);
            events.items.push(item);
        }
        state.media.streams_near(&everything, &mut events.streams);
        if !events.streams.is_empty() {
            let of = |body: &u32| around.get(*body as usize).cloned();
            events.around.extend(members.iter().map(|body| of(body).unwrap_or_else(Around::unknown)));
        }
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

    /// Takes over the contacts of the island.
    pub fn take_contacts(&mut self, state: &State) {
        let n = state.bodies.len() as u32;
        let Self { events, contacts, members, .. } = self;
        let items = &events.items;
        let global = |item: u32| if items[item as usize].surface { n + items[item as usize].id } else { items[item as usize].id };
        let global = |contact: &Contact| Contact { lo: global(contact.lo), hi: global(contact.hi), ..*contact };
        contacts.extend(events.contacts.iter().map(|contact| (members[0], global(contact))));
    }

    /// Takes over what the island came to; `known` unless its budget was used up.
    pub fn scatter(&mut self, state: &State, known: bool) {
        if known {
            self.take_contacts(state);
        }
        let Self { events, after, happened, stops, met, crushed, members, .. } = self;
        let (leader, count) = (members[0], members.len() as u32);
        let Events { items, movable, .. } = events;
        for item in &items[..*movable] {
            let (acceleration, known) = (item.solved + DVec2::ZERO, known && item.known);
            after[item.id as usize] = After { acceleration, known, held: item.held, members: count, leader, ..After::default() };
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
            if !state.surfaces[item.id as usize].def.path.is_still() {
                let stop = Stop { leader, surface: item.id, at: item.stops_at };
                if stop.at < first_stop(stops, stop.surface) {
                    stops.push(stop);
                }
                met.push(stop);
            }
        }
    }

    /// Notes that the dense method takes the island, or what is left of its tick.
    pub fn leave(&mut self) {
        let (leader, members) = (self.members[0], self.members.len() as u32);
        for &body in &self.members {
            self.after[body as usize] = After { dense: true, members, leader, ..After::default() };
        }
    }
}
