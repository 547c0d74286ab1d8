//! An island and the buffers of the method of events; surfaces within a tick: the legs of their paths, and their stops.

use crate::physics::data::{Aabb, Contact, Cubic, Hit, Incidence, Plan, Pose, Surface, refill};
use crate::physics::exact::item::{Item, Next, Track, Travel};
use crate::physics::forces::{Link, Media, ZoneList};
use crate::physics::{contact::reactions::Reactions, flight::steps::CoupledStep, state::Guards, state::State};
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene<'a> {
    pub media: &'a Media,
    pub plan: &'a Plan,
    pub rest_speed: f64,
    pub surfaces: &'a [Surface],
    /// Length of the tick, s.
    pub tick: f64,
}

impl<'a> Scene<'a> {
    pub fn of(state: &'a State, plan: &'a Plan, tick: f64) -> Self {
        let State { media, surfaces, rest_speed, .. } = state;
        Self { media, plan, rest_speed: *rest_speed, surfaces, tick }
    }

    pub fn set_on_path(&self, item: &mut Item, at: f64) {
        let surface = &self.surfaces[item.id as usize];
        let (point, stops) =
            if at < item.stops_at { (surface.at(at), item.stops_at) } else { (surface.at(item.stops_at).at_rest(), f64::INFINITY) };
        item.since = at;
        item.until = (at + point.lasts).min(stops).min(self.tick);
        (item.body.position, item.body.velocity) = (point.offset, point.velocity);
        (item.solved, item.mean) = (point.acceleration, point.acceleration);
        let still = point.velocity == DVec2::ZERO && point.acceleration == DVec2::ZERO;
        item.motion = if still { Travel::Still } else { Travel::Parabola };
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ExactEnd {
    Done,
    /// A body may go beyond where others were looked for.
    Grown,
    Busy,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Events {
    /// The bodies in ascending order, then the surfaces.
    pub items: Vec<Item>,
    pub movable: usize,
    pub contacts: Vec<Contact>,
    /// In which of the `contacts` each item is, since the last event was looked at; while motions are chosen, in which of `trial`.
    pub(super) incident: Incidence,
    /// Of each item: its path, and its next event.
    pub(super) tracks: Vec<Track>,
    pub(super) nexts: Vec<Next>,
    /// Of each item: the box in which it stays until its next event, m.
    pub(super) lanes: Vec<Aabb>,
    /// Of each item: how many paths it has had in this tick.
    pub(super) ways: Vec<u32>,
    /// Of each item: the streams that it touches on its path, and maybe some near it.
    pub(super) borders: Vec<ZoneList>,
    pub streams: Vec<u32>,
    /// The links of its bodies as the tick ends, and the poses of other ends of these, which stand or are on another island.
    pub links: Vec<Link>,
    pub link_numbers: Vec<u32>,
    pub ends: Vec<(u32, Pose)>,
    pub(super) ties: Vec<Tie>,
    pub hits: Vec<Hit>,
    /// Bodies squeezed by surfaces, and how fast these would have closed by the end of the tick, m/s.
    pub squeezed: Vec<(u32, u32, f64)>,
    pub guards: Guards,
    /// Events of all islands so far; of this one in this tick, and of it before it grew.
    pub total: u64,
    pub count: u64,
    pub spent: u64,
    pub(super) now: f64,
    pub(super) grown: bool,
    pub(super) bounces: bool,
    /// Whether a surface was stopped while the present event was looked at.
    pub(super) halted: bool,
    pub(super) touching: Vec<Contact>,
    /// The pair whose meeting the present event is.
    pub(super) met: Option<Contact>,
    pub(super) reactions: Reactions,
    /// Of each body: its mass along each axis.
    pub(super) masses: Vec<DVec2>,
    /// Of each item: its acceleration without contacts, and with them; both are the path's for a surface.
    pub(super) free: Vec<DVec2>,
    pub(super) solved: Vec<DVec2>,
    /// Of each item: where it is now, and how fast; how fast it was before an impact.
    pub(super) places: Vec<DVec2>,
    pub(super) speeds: Vec<DVec2>,
    pub(super) before: Vec<DVec2>,
    /// Of each item: where it was when the tick began.
    pub(super) begun: Vec<DVec2>,
    /// The items that the present event concerns; of each item, whether it is one, and whether its pose now is known.
    pub(super) concerned: Vec<u32>,
    pub(super) is_concerned: Vec<bool>,
    pub(super) is_placed: Vec<bool>,
    /// Of each item: whether it has been struck along each axis in the present round of impacts.
    pub(super) struck: Vec<[bool; 2]>,
    /// Contacts of the items concerned, and copies of them for trial solves.
    pub(super) trial: Vec<Contact>,
    pub(super) asked: Vec<Contact>,
    pub(super) behind: Vec<u32>,
    pub(super) pressing: Vec<u32>,
    /// For the implicit step of what is in contact: of each item concerned, and the mean accelerations of all.
    pub(super) implicit: Vec<Implicit>,
    pub(super) means: Vec<DVec2>,
    /// Of each item concerned: its part of a step of joined items; and whether contacts have changed at one of its stages.
    pub(super) coupled: Vec<CoupledStep>,
    pub(super) changed: bool,
    /// Of each item: how long its next such step may be, s, and how long it is where contacts change at once, else infinite.
    pub(super) strides: Vec<[f64; 2]>,
}

/// How the forces of media on a body answer to its own motion within an implicit step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Implicit {
    /// How far into the step the forces are taken, along each axis.
    pub(super) theta: DVec2,
    /// θ·h·D + θ²·h²·K.
    pub(super) response: DVec2,
    /// Its mean acceleration before the last correction, m/s².
    pub(super) mean: DVec2,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Tie {
    /// The place of its contact in the list of what touches.
    pub index: usize,
    pub e: f64,
    /// By how much its approach speed shall fall, m/s.
    pub(super) target: f64,
    pub(super) impulse: f64,
    /// m/s: the target left over, the direction of the search, what that changes.
    pub(super) left: f64,
    pub(super) direction: f64,
    pub(super) change: f64,
}

impl Events {
    pub fn clear(&mut self) {
        self.items.clear();
        self.contacts.clear();
        self.streams.clear();
        self.links.clear();
        self.link_numbers.clear();
        self.ends.clear();
        self.hits.clear();
        self.squeezed.clear();
        (self.movable, self.spent) = (0, 0);
    }

    pub(super) fn clear_buffers(&mut self) {
        let all = self.items.len();
        (self.now, self.count, self.grown, self.reactions.solved) = (0.0, 0, false, 0);
        for vectors in [&mut self.free, &mut self.solved, &mut self.places, &mut self.speeds, &mut self.means] {
            refill(vectors, all, DVec2::ZERO);
        }
        // Few ticks ask for it: it has its room before.
        self.behind.clear();
        self.behind.reserve(self.movable);
        self.masses.clear();
        self.masses.extend(self.items[..self.movable].iter().map(|item| DVec2::splat(item.body.mass)));
        refill(&mut self.nexts, all, Next::NEVER);
        refill(&mut self.ways, all, 0);
        refill(&mut self.struck, all, [false; 2]);
        refill(&mut self.is_concerned, all, false);
        refill(&mut self.is_placed, all, false);
        self.coupled.clear();
        self.coupled.reserve(self.movable);
        refill(&mut self.strides, all, [f64::INFINITY; 2]);
        self.begun.clear();
        self.begun.extend(self.items.iter().map(|item| item.body.position));
        let stands = |item: &Item| Track::new(item, Cubic::parabola(item.body.position, DVec2::ZERO, DVec2::ZERO));
        self.tracks.clear();
        self.tracks.extend(self.items.iter().map(stands));
        self.lanes.clear();
        self.lanes.extend(self.tracks.iter().map(|track| track.lane(&track.swept)));
        refill(&mut self.borders, if self.streams.is_empty() { 0 } else { self.movable }, ZoneList::default());
    }

    pub(crate) fn halt(&mut self, scene: &Scene, surface: u32) {
        self.guards.surfaces_stopped += 1;
        self.halted = true;
        let item = &mut self.items[surface as usize];
        item.stops_at = item.stops_at.min(self.now);
        self.set_out(scene, surface as usize);
    }

    pub(super) fn set_out(&mut self, scene: &Scene, i: usize) {
        scene.set_on_path(&mut self.items[i], self.now);
        self.foresee(scene, i);
        self.nexts[i] = Next::NEVER;
        let item = &self.items[i];
        (self.places[i], self.speeds[i], self.is_placed[i]) = (item.body.position, item.body.velocity, true);
        (self.free[i], self.solved[i]) = (item.solved, item.solved);
        self.concern_partners(i as u32);
    }
}
