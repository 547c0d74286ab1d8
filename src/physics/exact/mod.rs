//! The event-driven method: an island, from one thing that happens to the next.
//!
//! Every item of an island (bodies, and the surfaces near them) has a way of its own, with its own beginning and its own next event; an event
//! ends the ways of what it touches, and of nothing else. So a tick costs what happens in it: flight is one formula, an impact concerns two
//! bodies and what they are in contact with, and everything else goes on as foreseen (event-driven dynamics with local clocks, after
//! Alder and Wainwright 1959).
//!
//! At an event the items concerned are brought to its instant (`collect`), impacts are resolved (`impacts`), contacts and accelerations
//! follow (`motions`), and the next events are sought (`predict`). Events are counted, and not the clock: the
//! tick of an island in which too many happen is taken in one step of the dense method. So no time is lost, and no tick lasts longer than so
//! many events and one such step.
//!
//! Forces at the end of the tick are those of that instant: contacts are solved there once more where media act on them. The next tick
//! begins with them, if nothing has changed meanwhile.

pub(crate) mod bounces;
pub(crate) mod contacts;
pub(crate) mod end;
pub(crate) mod grounds;
pub(crate) mod impacts;
pub(crate) mod item;
pub(crate) mod meeting;
pub(crate) mod motions;
pub(crate) mod predict;
pub(crate) mod rest;
pub(crate) mod ties;
pub(crate) mod track;

use crate::physics::contact::reactions::Reactions;
use crate::physics::data::aabb::Aabb;
use crate::physics::data::body::Pose;
use crate::physics::data::contact::Contact;
use crate::physics::data::impact_time::Cubic;
use crate::physics::data::plan::Plan;
use crate::physics::data::surface::Surface;
use crate::physics::data::tuning::SLOP;
pub(crate) use crate::physics::exact::impacts::Hit;
pub(crate) use crate::physics::exact::item::{Item, Motion};
use crate::physics::exact::item::{Kind, Next};
use crate::physics::exact::ties::Tie;
use crate::physics::exact::track::{Lanes, Track};
use crate::physics::flight::flow::flow;
use crate::physics::forces::law::Law;
use crate::physics::forces::link::LinkDef;
use crate::physics::forces::media::Media;
use crate::physics::forces::zones::ZoneList;
use crate::physics::guards::Guards;
use crate::physics::world::State;
use glam::DVec2;

/// Events of an island in a tick, and for each of its bodies, at most; an event counts as often as bodies are looked at for it. More: the worst tick
/// lasts longer; fewer: exactness is given up where fewer impacts fall into one tick.
const MOST_EVENTS: u64 = 1024;
const MOST_OF_A_BODY: u64 = 32;

/// What all islands of a tick share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene<'a> {
    pub media: &'a Media,
    pub rest_speed: f64,
    /// Whether anything bounces.
    pub bounces: bool,
    /// Whether what did not change is taken over from the last tick, instead of being solved once more to the same bits.
    pub direct: bool,
    /// Whether the dense method takes every island.
    pub dense: bool,
    /// All surfaces of the world.
    pub surfaces: &'a [Surface],
    /// Length of the tick, s.
    pub tick: f64,
}

impl Scene<'_> {
    /// Puts a surface where its path leads it `at` seconds from the tick's start, or to where it stopped before.
    pub fn set_on_path(&self, item: &mut Item, at: f64) {
        let surface = &self.surfaces[item.id as usize];
        let point = if at < item.stops_at { surface.at(at) } else { surface.at(item.stops_at).at_rest() };
        item.since = at;
        let end = if at < item.stops_at { item.stops_at } else { f64::INFINITY };
        item.until = (at + point.lasts).min(end).min(self.tick);
        (item.body.position, item.body.velocity) = (point.offset, point.velocity);
        (item.solved, item.mean) = (point.acceleration, point.acceleration);
        let still = point.velocity == DVec2::ZERO && point.acceleration == DVec2::ZERO;
        item.motion = if still { Motion::Still } else { Motion::Parabola };
    }

    /// A tick of a world.
    pub fn of<'a>(state: &'a State, plan: &Plan, tick: f64) -> Scene<'a> {
        Scene {
            media: &state.media,
            rest_speed: state.rest_speed,
            bounces: plan.bounces,
            direct: plan.direct,
            dense: plan.dense,
            surfaces: &state.surfaces,
            tick,
        }
    }
}

/// How an island ended its tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// All of it is at the end of the tick.
    Done,
    /// A body may go beyond where others were looked for.
    Grown,
    /// Too much has happened: the tick is another method's.
    Busy,
}

/// An island, and the buffers of the method.
#[derive(Clone, Debug, Default)]
pub(crate) struct Events {
    /// The bodies in ascending order, then the surfaces.
    pub items: Vec<Item>,
    /// How many of the items are bodies.
    pub movable: usize,
    pub contacts: Vec<Contact>,
    /// Of each item: how it goes on, and its next event.
    tracks: Vec<Track>,
    lanes: Lanes,
    nexts: Vec<Next>,
    /// Of each item: how many ways it has had in this tick.
    ways: Vec<u32>,
    /// Of each item: the streams that it touches on its way, and maybe some near it.
    borders: Vec<ZoneList>,
    /// The air streams near the island.
    pub streams: Vec<u32>,
    /// The links of its bodies, and where other ends of these get.
    pub links: Vec<LinkDef>,
    pub ends: Vec<(u32, Pose)>,
    /// Impacts at one instant.
    ties: Vec<Tie>,
    /// What happened.
    pub hits: Vec<Hit>,
    /// Bodies squeezed by surfaces, and how fast these would have closed by the end of the tick, m/s.
    pub squeezed: Vec<(u32, u32, f64)>,
    pub guards: Guards,
    /// Events of all islands so far, and of this one in this tick.
    pub total: u64,
    count: u64,
    now: f64,
    grown: bool,
    /// Whether anything of the island bounces: what does elsewhere is of no concern to it.
    bounces: bool,
    /// Whether a surface was stopped while the present event was looked at.
    halted: bool,
    touching: Vec<Contact>,
    /// The pair whose meeting the present event is.
    met: Option<Contact>,
    reactions: Reactions,
    /// Of each body: its mass along each axis, what would accelerate it without contacts, and what does.
    masses: Vec<DVec2>,
    free: Vec<DVec2>,
    solved: Vec<DVec2>,
    /// Of each item: where it is now; of each body: how fast.
    places: Vec<DVec2>,
    speeds: Vec<DVec2>,
    before: Vec<DVec2>,
    /// Of each item: where it was when the tick began.
    begun: Vec<DVec2>,
    /// Of each surface: velocity and acceleration now.
    ground_speeds: Vec<DVec2>,
    ground_pulls: Vec<DVec2>,
    /// What the present event concerns, and whether an item belongs to it; whether its pose now is known.
    concerned: Vec<u32>,
    is_concerned: Vec<bool>,
    is_placed: Vec<bool>,
    /// Contacts of what is concerned, and copies of them that can be asked what else they would carry.
    trial: Vec<Contact>,
    asked: Vec<Contact>,
    /// What stands behind a body that gives way.
    behind: Vec<u32>,
    /// What presses on the item whose next event is sought, and who is near.
    pressing: Vec<u32>,
    near: Vec<u32>,
    /// For the implicit step of what is in contact: of each item concerned, and the mean accelerations of all.
    implicit: Vec<Implicit>,
    means: Vec<DVec2>,
}

/// How the forces of media on a body answer to its own motion within an implicit step.
#[derive(Clone, Copy, Debug)]
struct Implicit {
    /// How far into the step the forces are taken, along each axis.
    theta: DVec2,
    /// θ·h·D + θ²·h²·K.
    response: DVec2,
}

impl Events {
    /// Empties the island.
    pub fn clear(&mut self) {
        self.items.clear();
        self.contacts.clear();
        self.streams.clear();
        self.links.clear();
        self.ends.clear();
        self.hits.clear();
        self.squeezed.clear();
        self.movable = 0;
    }

    /// Advances the island by a tick.
    pub fn advance(&mut self, scene: &Scene) -> Outcome {
        let outcome = self.go_through(scene);
        self.total += self.count;
        self.guards.friction_unsettled += std::mem::take(&mut self.reactions.unsettled);
        outcome
    }

    fn go_through(&mut self, scene: &Scene) -> Outcome {
        if self.rest(scene) {
            return Outcome::Done;
        }
        self.begin(scene);
        // To begin is no event: a plan that solves once more to the same bits follows as many.
        (self.count, self.reactions.solved) = (0, 0);
        loop {
            if self.grown {
                return Outcome::Grown;
            }
            if self.is_busy() {
                return Outcome::Busy;
            }
            let Some((i, next)) = self.next_event(scene) else { break };
            self.now = next.at;
            // A void one counts as well: no chain of them goes on for ever.
            self.count += 1;
            if self.is_void(&next) {
                self.predict(scene, i);
            } else {
                self.happen(scene, i, next.kind);
            }
        }
        self.now = scene.tick;
        self.stop_here(scene);
        self.items.iter_mut().for_each(|item| item.known = true);
        self.follow_surfaces();
        self.settle(scene);
        Outcome::Done
    }

    /// Whether more has happened in this tick than is followed event by event.
    pub(crate) fn is_busy(&mut self) -> bool {
        self.count += std::mem::take(&mut self.reactions.solved);
        self.count > MOST_EVENTS + MOST_OF_A_BODY * self.movable as u64
    }

    /// Contacts and accelerations before the first tick: no impact is resolved yet.
    pub fn begin_world(&mut self, scene: &Scene) {
        self.begin(scene);
        self.settle(scene);
    }

    /// Where the only body of the island gets by the end of the tick, touching nothing.
    pub fn fly(&mut self, scene: &Scene) -> Pose {
        self.contacts.clear();
        self.items[0].known = false;
        // It meets nothing, however far the streams take it.
        self.items[0].searched = Aabb::around(DVec2::ZERO, DVec2::splat(f64::MAX));
        let outcome = self.advance(scene);
        self.hits.clear();
        let item = &self.items[0];
        if outcome == Outcome::Done {
            return (item.body.position, item.body.velocity);
        }
        self.guards.flows_cut_short += 1;
        flow(scene.media, &item.body, &Law { rough: true, ..item.law }, scene.tick - item.since)
    }

    /// The greatest speed along each axis at which something moves, m/s.
    pub fn fastest(&self) -> DVec2 {
        let speed = |item: &Item| item.body.velocity.abs() + item.mean.abs() * (item.until - item.since).clamp(0.0, 1.0);
        self.items.iter().map(speed).fold(DVec2::ZERO, DVec2::max)
    }

    /// Whether no surface of a contact moves.
    pub fn stands_on_what_stands(&self) -> bool {
        self.contacts.iter().all(|contact| {
            let surface = contact.lo.max(contact.hi);
            self.is_body(surface) || self.stands(surface)
        })
    }

    /// The first event of all, if it falls into the tick.
    fn next_event(&self, scene: &Scene) -> Option<(usize, Next)> {
        let mut first = (0, Next::NEVER);
        for (i, next) in self.nexts.iter().enumerate() {
            if next.at < first.1.at {
                first = (i, *next);
            }
        }
        (first.1.at <= scene.tick).then_some(first)
    }

    /// Whether with whom it was to happen has gone another way since. Nothing has happened to the item then, but from now on others may.
    fn is_void(&self, next: &Next) -> bool {
        next.kind.other().is_some_and(|other| self.ways[other as usize] != next.foreseen_on)
    }

    /// Makes room for all items.
    fn clear_buffers(&mut self) {
        let (all, bodies) = (self.items.len(), self.movable);
        (self.now, self.count, self.grown) = (0.0, 0, false);
        self.reactions.solved = 0;
        for vectors in [&mut self.masses, &mut self.free, &mut self.solved, &mut self.speeds, &mut self.means] {
            vectors.clear();
            vectors.resize(bodies, DVec2::ZERO);
        }
        for vectors in [&mut self.ground_speeds, &mut self.ground_pulls] {
            vectors.clear();
            vectors.resize(all - bodies, DVec2::ZERO);
        }
        self.nexts.clear();
        self.nexts.resize(all, Next::NEVER);
        self.ways.clear();
        self.ways.resize(all, 0);
        for lists in [&mut self.near, &mut self.behind] {
            lists.clear();
            lists.reserve(all);
        }
        self.begun.clear();
        self.begun.extend(self.items.iter().map(|item| item.body.position));
        self.tracks.clear();
        self.tracks
            .extend(self.items.iter().map(|item| Track::new(item, Cubic::parabola(item.body.position, DVec2::ZERO, DVec2::ZERO))));
        self.lanes.resize(all);
        for (i, track) in self.tracks.iter().enumerate() {
            self.lanes.set(i, &track.swept, track.rounding);
        }
        self.borders.clear();
        if !self.streams.is_empty() {
            self.borders.resize(bodies, ZoneList::default());
        }
        self.pressing.clear();
        self.pressing.reserve(all);
        self.places.clear();
        self.places.resize(all, DVec2::ZERO);
        for flags in [&mut self.is_concerned, &mut self.is_placed] {
            flags.clear();
            flags.resize(all, false);
        }
    }

    /// Prepares the buffers, and how everything moves at the start of the tick.
    fn begin(&mut self, scene: &Scene) {
        self.clear_buffers();
        self.bounces = scene.bounces && self.items.iter().any(|item| item.body.restitution > 0.0);
        let (all, bodies) = (self.items.len(), self.movable);
        for i in 0..bodies {
            self.masses[i] = DVec2::splat(self.items[i].body.mass);
            self.solved[i] = self.items[i].solved;
        }
        for i in 0..bodies {
            self.renew_law(scene, i);
        }
        for i in bodies..all {
            self.foresee(scene, i);
            if self.items[i].until < scene.tick {
                self.nexts[i].or_earlier(self.items[i].until, Kind::Renew);
            }
        }
        self.start(scene);
    }

    /// What happened last tick goes on where nothing changed; everything else is looked at as if something had happened to it.
    fn start(&mut self, scene: &Scene) {
        for i in 0..self.movable {
            if !self.items[i].known {
                self.concern(i as u32);
            }
        }
        if !self.concerned.is_empty() {
            self.look(scene, None);
        }
        self.release();
        for i in 0..self.movable {
            if self.items[i].known && !self.items[i].disturbed {
                self.concern(i as u32);
                (self.places[i], self.speeds[i]) = (self.items[i].body.position, self.items[i].body.velocity);
                self.is_placed[i] = true;
            }
        }
        if !scene.direct {
            self.solve_concerned(scene);
        }
        self.go_on(scene);
        self.release();
    }

    /// Does what an event says.
    fn happen(&mut self, scene: &Scene, i: usize, kind: Kind) {
        self.concern(i as u32);
        let mut hit = None;
        match kind {
            Kind::Nothing | Kind::Edge { .. } | Kind::Border => {}
            Kind::Begin { other } => self.concern(other),
            Kind::Renew if i >= self.movable => {
                self.turn(scene, i);
                return self.release();
            }
            Kind::Renew if self.items[i].motion == Motion::Flow => {
                self.renew(scene, i);
                return self.release();
            }
            Kind::Renew => {}
            Kind::Hit { other, axis, ascending } => {
                self.concern(other);
                let (lo, hi) = if ascending { (i as u32, other) } else { (other, i as u32) };
                let contact = self.contact_along(lo, hi, axis);
                let begin = self.now;
                if !self.put_together(scene, &contact) {
                    self.now = begin;
                    self.renew(scene, i);
                    self.renew(scene, other as usize);
                    return self.release();
                }
                hit = Some(contact);
            }
            Kind::Stop { other } => {
                self.concern(other);
                self.stop_slide(scene, i as u32, other);
            }
            Kind::Resume => self.resume(scene, i),
        }
        self.look(scene, hit);
        self.release();
    }

    /// Brings everything to the present instant.
    fn stop_here(&mut self, scene: &Scene) {
        for i in 0..self.items.len() {
            let (position, velocity) = self.items[i].pose(scene.media, self.now);
            let item = &mut self.items[i];
            (item.body.position, item.body.velocity, item.since) = (position, velocity, self.now);
        }
    }

    /// Counts an item to what the present event concerns.
    fn concern(&mut self, item: u32) {
        if self.is_body(item) && !self.is_concerned[item as usize] {
            self.is_concerned[item as usize] = true;
            self.concerned.push(item);
        }
    }

    /// Ends an event.
    fn release(&mut self) {
        for &item in &self.concerned {
            self.is_concerned[item as usize] = false;
        }
        self.concerned.clear();
        self.touching.clear();
        self.met = None;
        self.is_placed.fill(false);
    }

    pub(crate) fn is_body(&self, item: u32) -> bool {
        (item as usize) < self.movable
    }

    /// Velocity now, m/s.
    fn speed(&self, item: u32) -> DVec2 {
        let i = item as usize;
        if i < self.movable { self.speeds[i] } else { self.ground_speeds[i - self.movable] }
    }

    /// Whether a surface stands still.
    fn stands(&self, surface: u32) -> bool {
        let i = surface as usize - self.movable;
        self.ground_speeds[i] == DVec2::ZERO && self.ground_pulls[i] == DVec2::ZERO
    }

    /// What a belt adds to the velocity of `hi` relative to `lo` along a contact's face, m/s.
    fn skin_of(&self, contact: &Contact) -> f64 {
        if self.is_body(contact.hi) { -contact.skin } else { contact.skin }
    }

    /// How fast `hi` slides over `lo`, m/s.
    fn sliding(&self, contact: &Contact) -> f64 {
        (self.speed(contact.hi) - self.speed(contact.lo))[1 - contact.axis] + self.skin_of(contact)
    }

    /// The contact of two items along an axis.
    fn contact_along(&self, lo: u32, hi: u32, axis: usize) -> Contact {
        let (first, second) = (&self.items[lo.min(hi) as usize], &self.items[lo.max(hi) as usize]);
        let on_surface = !self.is_body(lo.max(hi));
        let mut contact = Contact::between(lo, hi, axis);
        contact.rub_with(first.body.coefficients().with(second.body.coefficients(), on_surface));
        if on_surface {
            // Clockwise: the top runs to the right, the right side down.
            let above_or_right = (axis == 1) == (lo < hi);
            contact.skin = if above_or_right { second.belt } else { -second.belt };
        }
        contact
    }

    /// The middle of the edge that two items share now, m.
    fn point_of(&self, contact: &Contact) -> DVec2 {
        let (a, b) = (contact.lo as usize, contact.hi as usize);
        let (a_half, b_half) = (self.items[a].body.half, self.items[b].body.half);
        let low = (self.places[a] - a_half).max(self.places[b] - b_half);
        let high = (self.places[a] + a_half).min(self.places[b] + b_half);
        (low + high) * 0.5
    }

    /// Where an item is now, found once an event.
    fn locate(&mut self, scene: &Scene, item: usize) -> DVec2 {
        if !self.is_placed[item] {
            let (place, speed) = self.items[item].pose(scene.media, self.now);
            self.is_placed[item] = true;
            self.places[item] = place;
            if item < self.movable {
                self.speeds[item] = speed;
            } else {
                let ground = item - self.movable;
                (self.ground_speeds[ground], self.ground_pulls[ground]) = (speed, self.items[item].solved);
            }
        }
        self.places[item]
    }

    /// The contact of two items whose gap along an axis is at most the slop while they overlap along the other. Boxes that overlap along both
    /// touch along the axis along which they overlap less; a surface is touched on its solid sides only, and from outside.
    fn contact_now(&mut self, scene: &Scene, a: u32, b: u32) -> Option<Contact> {
        let (a, b) = (a.min(b), a.max(b));
        let apart = self.locate(scene, b as usize) - self.locate(scene, a as usize);
        let gap = apart.abs() - (self.items[a as usize].body.half + self.items[b as usize].body.half);
        let axis = usize::from(gap.x <= gap.y);
        if gap[axis] > SLOP || gap[1 - axis] >= -SLOP {
            return None;
        }
        let sides = self.items[b as usize].sides;
        if sides != crate::physics::data::surface::Sides::ALL && (!sides.face(axis, apart[axis] <= 0.0) || gap[axis] < -SLOP) {
            return None;
        }
        let (lo, hi) = if apart[axis] > 0.0 { (a, b) } else { (b, a) };
        Some(Contact { closed: gap[axis] <= 0.0, ..self.contact_along(lo, hi, axis) })
    }
}
