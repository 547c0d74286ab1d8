//! The buffers of a tick, and how islands pass through them: gathered for the method of events, and taken over from it.

#[cfg(all(feature = "validate", debug_assertions))]
use crate::physics::checks::Checks;
use crate::physics::data::{Aabb, Contact, Hit, NONE, Pose, SLOP};
use crate::physics::exact::{Events, Scene, item::Item};
use crate::physics::{contact::resting::RestingGroup, flight::linked::Linked, flight::linked::Pull, forces::Law, forces::Link};
use crate::physics::{state::Records, state::State, store::motions::Method, store::motions::Motions};
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Stop {
    pub leader: u32,
    pub surface: u32,
    /// s from the tick's start; infinite where it goes on.
    pub at: f64,
}

/// When a surface stops, s from the tick's start; infinite where it goes on.
pub(crate) fn first_stop(stops: &[Stop], surface: u32) -> f64 {
    stops.iter().filter(|stop| stop.surface == surface).map(|stop| stop.at).fold(f64::INFINITY, f64::min)
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    pub events: Events,
    #[cfg(all(feature = "validate", debug_assertions))]
    pub checks: Checks,
    /// What the islands found out, with the smallest body of the island that it came from; impacts in the order of their finding.
    pub contacts: Vec<(u32, Contact)>,
    pub happened: Vec<(u32, u32, Hit)>,
    /// Island, body, surface and force, N.
    pub crushed: Vec<(u32, u32, u32, f64)>,
    pub stops: Vec<Stop>,
    /// All that contacts of the crowd step exert on each body, N.
    pub pressed: Vec<f64>,
    /// Of each body and each surface behind them: its number in the present island.
    local: Vec<u32>,
    /// Whether each body and surface begins the tick in contact with something, where there are liquids or streams.
    pub touches: Vec<bool>,
    /// The law of each body near a liquid by the tick before, and the bodies that go by it now.
    pub laws: Vec<Law>,
    pub swimming: Vec<u32>,
    /// Of the present island: its bodies, and the surfaces near it.
    pub members: Vec<u32>,
    pub surfaces: Vec<u32>,
    /// Contacts known at the start of the tick, sorted: those whose smaller end is body i begin at `starts[i]`. Emptied where they change.
    pub starts: Vec<u32>,
    pub fresh: Vec<Contact>,
    pub awake: Vec<u32>,
    /// Bodies that are linked and awake, ascending; pairs that join them; and those of an island that touch nothing.
    pub linked: Vec<Linked>,
    /// The links of the group that flies, and all that have broken in this tick.
    pub pulls: Vec<Pull>,
    pub snapped: Vec<u32>,
    /// Whether links have broken whose bodies went from event to event.
    pub tried: Vec<(u32, bool)>,
    pub pairs: Vec<(u32, u32)>,
    /// Of a tick that goes in parts, else empty: its records so far, and the poses from which it began.
    pub whole: Records,
    pub begun: Vec<Pose>,
    pub flown: Vec<u32>,
    pub resting: RestingGroup,
}

impl Scratch {
    pub fn begin_tick(&mut self) {
        self.contacts.clear();
        self.happened.clear();
        self.crushed.clear();
        self.stops.clear();
        self.members.clear();
        self.surfaces.clear();
    }

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

    /// Fills the island with `members` (in any order), `surfaces` (some maybe twice), and what is near; others were looked for in `searched`.
    pub fn gather(&mut self, state: &State, scene: &Scene, searched: impl Fn(u32) -> Aabb) {
        let n = state.bodies.len();
        self.index(state);
        let Self { events, local, members, surfaces, stops, starts, snapped, .. } = self;
        events.clear();
        members.sort_unstable();
        surfaces.sort_unstable();
        surfaces.dedup();
        local.resize(n + state.surfaces.len(), NONE);
        let mut everything = searched(members[0]);
        for &body in &*members {
            let i = body as usize;
            local[i] = events.items.len() as u32;
            let searched = searched(body);
            everything = everything.union(&searched);
            events.items.push(Item::body(body, &state.bodies[i], state.forces[i].push_of_no_zone(), searched, state.known[i]));
        }
        events.movable = members.len();
        // Those that have broken on the way that touches nothing may hold on another.
        let holds = |number: u32, link: &Link| link.acts() || link.broken && snapped.contains(&number);
        for (number, link) in (0..).zip(&state.links.all).filter(|(number, link)| holds(*number, link)) {
            let link = Link { broken: false, ..*link };
            if !link.def.ends().any(|end| members.binary_search(&end.0).is_ok()) {
                continue;
            }
            events.links.push(link);
            events.link_numbers.push(number);
            let begun = link.sooner(scene.tick, scene.tick);
            for end in link.def.ends().map(|end| end.0) {
                match members.binary_search(&end) {
                    Ok(at) => {
                        let item = &mut events.items[at];
                        item.link += begun.on(end, |id| state.pose_of(id));
                        (item.linked, item.known) = (true, false);
                    }
                    Err(_) => events.ends.push((end, state.pose_of(end))),
                }
            }
        }
        let present = |s: &&u32| state.surfaces[**s as usize].present;
        for &s in surfaces.iter().filter(present) {
            local[n + s as usize] = events.items.len() as u32;
            let mut item = Item::surface(s, &state.surfaces[s as usize]);
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
                if lo != NONE && hi != NONE {
                    events.contacts.push(Contact { lo, hi, passed: [0.0; 2], rubbed: contact.friction, ..*contact });
                }
            }
        }
        for item in &events.items {
            local[if item.surface { n + item.id as usize } else { item.id as usize }] = NONE;
        }
    }

    /// Whether `members` that rest in contact with each other and with what stands can stay so under the forces of now.
    pub fn stand(&mut self, state: &State, motions: &mut Motions) -> bool {
        self.index(state);
        let Self { resting, local, members, starts, contacts, .. } = self;
        let n = state.bodies.len();
        local.resize(n + state.surfaces.len(), NONE);
        resting.clear();
        members.sort_unstable();
        for (k, &i) in members.iter().enumerate() {
            local[i as usize] = k as u32;
            resting.forces.push(state.bodies[i as usize].mass * motions.bodies[i as usize].pull);
        }
        let known = || members.iter().flat_map(|i| &state.contacts[starts[*i as usize] as usize..starts[*i as usize + 1] as usize]);
        let place = |item: u32| if (item as usize) < n { local[item as usize] } else { item };
        resting.contacts.extend(known().map(|contact| Contact { lo: place(contact.lo), hi: place(contact.hi), ..*contact }));
        members.iter().for_each(|i| local[*i as usize] = NONE);
        let stands = |contact: &Contact| {
            let surface = (contact.ends().1 as usize).checked_sub(n).map(|s| &state.surfaces[s]);
            contact.slides == 0.0 && contact.lasts && surface.is_none_or(|surface| surface.present)
        };
        if !known().all(stands) || !resting.holds() {
            return false;
        }
        let leader = members.first().copied().unwrap_or(NONE);
        let solved = |(known, solved): (&Contact, &Contact)| (leader, Contact { lo: known.lo, hi: known.hi, ..*solved });
        contacts.extend(known().zip(&resting.contacts).map(solved));
        for i in members.iter().map(|i| *i as usize) {
            let motion = &mut motions.bodies[i];
            motion.end = (state.bodies[i].position, DVec2::ZERO);
            (motion.method, motion.leader, motion.acceleration, motion.known) = (Method::Events, leader, DVec2::ZERO, true);
        }
        true
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
        let Self { events, happened, stops, crushed, members, tried, .. } = self;
        let leader = members[0];
        let Events { items, movable, .. } = events;
        for item in &items[..*movable] {
            let motion = &mut motions.bodies[item.id as usize];
            motion.end = (item.body.position, item.body.velocity);
            (motion.method, motion.leader) = (Method::Events, leader);
            (motion.acceleration, motion.known) = (item.solved + DVec2::ZERO, item.known);
        }
        tried.extend(events.link_numbers.iter().zip(&events.links).map(|(number, link)| (*number, link.broken)));
        let from = happened.len() as u32;
        happened.extend((from..).zip(&events.hits).map(|(k, hit)| (leader, k, *hit)));
        for &(body, surface, speed) in &events.squeezed {
            let (of, by) = (&items[body as usize], &items[surface as usize]);
            crushed.push((leader, of.id, by.id, of.body.crushing_force(speed)));
        }
        let stopped = items[*movable..].iter().filter(|item| item.stops_at.is_finite());
        stops.extend(stopped.map(|item| Stop { leader, surface: item.id, at: item.stops_at }));
    }
}
