//! The method of events. Every body and surface of an island has a path and a next event of its own; an event ends the paths that it concerns (Alder
//! and Wainwright 1959): `contacts` at its instant, `impacts`, `motions`, and what is next (`predict`). Too many leave the tick to the crowd step.

pub(crate) mod contacts;
pub(crate) mod coupled;
pub(crate) mod end;
pub(crate) mod events;
pub(crate) mod impacts;
pub(crate) mod item;
pub(crate) mod meeting;
pub(crate) mod motions;
pub(crate) mod poses;
pub(crate) mod predict;
pub(crate) mod ties;
pub(crate) mod train;
pub(crate) mod trains;

use crate::physics::data::{Aabb, Contact, EVENTS_OF_A_BODY, MOST_BORDERS, Part, Pose, called};
pub(crate) use crate::physics::exact::events::{Events, ExactEnd, Scene};
use crate::physics::exact::{item::EventKind, item::Item, item::Next, item::Travel, motions::SHORTEST};
use crate::physics::{flight::liquid::flow, forces::law::Law};
use glam::DVec2;

impl Events {
    pub fn advance(&mut self, scene: &Scene) -> ExactEnd {
        let outcome = self.go_through(scene);
        self.total += self.count;
        self.guards.friction_unsettled += std::mem::take(&mut self.reactions.unsettled);
        outcome
    }

    fn go_through(&mut self, scene: &Scene) -> ExactEnd {
        if !self.begin(scene) {
            return ExactEnd::Busy;
        }
        // To begin is no event: a plan that solves once more to the same bits follows as many.
        (self.count, self.reactions.solved) = (0, 0);
        loop {
            if self.grown {
                return ExactEnd::Grown;
            }
            if self.is_busy() {
                return ExactEnd::Busy;
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
        self.items.iter_mut().for_each(|item| item.known = true);
        self.is_placed.fill(false);
        (0..self.movable).for_each(|i| self.end_train(scene, i));
        self.release();
        self.pass_on(true);
        self.list_surplus(scene);
        for item in &mut self.items {
            (item.body.position, item.body.velocity) = item.pose(scene.media, self.now);
            item.since = self.now;
        }
        self.follow_surfaces();
        self.settle(scene);
        ExactEnd::Done
    }

    pub(crate) fn is_busy(&mut self) -> bool {
        self.count += std::mem::take(&mut self.reactions.solved);
        self.spent + self.count > self.budget()
    }

    pub(crate) fn budget(&self) -> u64 {
        EVENTS_OF_A_BODY * (108 + self.movable as u64)
    }

    /// Where the only body of the island gets by the end of the tick, touching nothing.
    pub fn fly(&mut self, scene: &Scene) -> Pose {
        self.contacts.clear();
        self.items[0].known = false;
        self.items[0].searched = Aabb::around(DVec2::ZERO, DVec2::splat(f64::MAX));
        let outcome = self.advance(scene);
        self.hits.clear();
        let item = &self.items[0];
        if outcome == ExactEnd::Done {
            return (item.body.position, item.body.velocity);
        }
        self.guards.flows_cut_short += 1;
        flow(scene.media, &item.body, &Law { rough: true, ..item.law }, scene.tick - item.since)
    }

    /// The greatest speed along each axis, m/s.
    pub fn fastest(&self) -> DVec2 {
        let speed = |item: &Item| item.body.velocity.abs() + item.mean.abs() * (item.until - item.since).clamp(0.0, 1.0);
        self.items.iter().map(speed).fold(DVec2::ZERO, DVec2::max)
    }

    pub fn stands_on_what_stands(&self) -> bool {
        self.contacts.iter().map(|contact| contact.ends().1).all(|surface| self.is_body(surface) || self.stands(surface))
    }

    fn next_event(&self, scene: &Scene) -> Option<(usize, Next)> {
        let due = self.nexts.iter().copied().enumerate().filter(|(_, next)| next.at <= scene.tick);
        due.reduce(|first, next| if next.1.at < first.1.at { next } else { first })
    }

    fn is_void(&self, next: &Next) -> bool {
        next.kind.other().is_some_and(|other| self.ways[other as usize] != next.foreseen_on)
    }

    /// Items that nothing changed go on as the last tick left them; an event concerns all others. Returns false where too many impacts fall into
    /// that.
    pub(crate) fn begin(&mut self, scene: &Scene) -> bool {
        self.clear_buffers();
        self.bounces = scene.plan.bounces && self.items.iter().any(|item| item.body.restitution > 0.0);
        let (all, bodies) = (self.items.len(), self.movable);
        for i in 0..bodies {
            self.solved[i] = self.items[i].solved;
            self.renew_law(scene, i);
            if !self.items[i].known {
                self.concern(i as u32);
            }
        }
        for i in bodies..all {
            self.foresee(scene, i);
            self.nexts[i] = self.own_next(scene, i);
        }
        let begun = self.concerned.is_empty() || self.look(scene);
        self.release();
        if !begun {
            return false;
        }
        for i in 0..bodies {
            if self.items[i].known && !self.items[i].disturbed {
                self.concern(i as u32);
                (self.places[i], self.speeds[i]) = (self.items[i].body.position, self.items[i].body.velocity);
                self.is_placed[i] = true;
            }
        }
        if scene.plan.direct {
            called(Part::Direct);
        } else {
            let Self { contacts, is_concerned, .. } = self;
            let again = |contact: &&mut Contact| contact.pair().iter().any(|item| is_concerned[*item as usize]);
            contacts.iter_mut().filter(again).for_each(|contact| contact.normal = contact.begun);
            self.solve_concerned(scene);
        }
        self.go_on(scene);
        self.release();
        true
    }

    fn happen(&mut self, scene: &Scene, i: usize, kind: EventKind) {
        self.concern(i as u32);
        match kind {
            EventKind::Border => {
                let item = &mut self.items[i];
                let velocity = item.pose(scene.media, self.now).1;
                let back = (velocity * item.crossed.1).min_element() < 0.0 && self.now - item.since < scene.tick * SHORTEST;
                item.crossed = (item.crossed.0 + u32::from(back), velocity);
                self.guards.flows_cut_short += u64::from(back && item.crossed.0 == MOST_BORDERS);
            }
            EventKind::Begin { other } => self.concern(other),
            EventKind::Renew if i >= self.movable => {
                self.set_out(scene, i);
                self.predict(scene, i);
                if !self.concerned.is_empty() {
                    self.look(scene);
                }
                return self.release();
            }
            EventKind::Renew if self.items[i].motion == Travel::Flow => {
                self.renew(scene, i);
                return self.release();
            }
            EventKind::Nothing | EventKind::Edge { .. } | EventKind::Renew => {}
            EventKind::Hit { other, axis, ascending } => {
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
                self.met = Some(contact);
            }
            EventKind::Stop { other } => {
                self.concern(other);
                self.stop_slide(scene, i as u32, other);
            }
        }
        self.look(scene);
        self.release();
    }
}
