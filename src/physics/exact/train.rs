//! Trains of bounces: one event each, found from the state. They begin where bounces are short, or many are to come, and nothing else comes within
//! reach; they end with the last bounce, with the tick, or where something comes near, and then list what they have passed on.

use crate::physics::data::{Aabb, Contact, Cubic, DAMPED_REACH, MANY_HITS, NONE, Pose, SHORT_BOUNCE, SLOP, STEADY, Sides, on_axis};
use crate::physics::exact::bounces::Bounces;
use crate::physics::exact::events::{Events, Scene};
use crate::physics::exact::item::Item;
use crate::physics::exact::motions::SHORTEST;
use crate::physics::exact::wedge::Wedge;
use crate::physics::forces::zones;
use glam::DVec2;

/// One body's part in a train.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Train {
    pub members: [u32; 3],
    axis: usize,
    /// On which side of the one before it each member is: 1 or −1.
    side: f64,
    /// s from the tick's start; whether no bounce is left then.
    pub until: f64,
    over: bool,
    /// The box in which it stays, m.
    pub way: Aabb,
    /// Its acceleration without bounces, m/s².
    pull: DVec2,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    /// A `part` of how the first moves relative to the second; both are carried with a velocity and an acceleration.
    Bounces { of: Bounces, part: f64, carried: [DVec2; 2] },
    /// A member of a row.
    Wedge { of: Wedge, member: usize },
}

impl Train {
    /// At a time, s from the tick's start, from the pose in which it began, `t` seconds before.
    pub fn pose(&self, (place, speed): Pose, t: f64, at: f64) -> Pose {
        match self.kind {
            Kind::Bounces { of, part, carried: [v, a] } => {
                let [way, moves] = of.at(t, self.over && at >= self.until);
                let turned = |[up, along]: [f64; 2]| on_axis(self.axis, self.side * up, along) * part;
                (place + (v + a * (0.5 * t)) * t + turned(way), v + a * t + turned(moves))
            }
            Kind::Wedge { of, member } => {
                let [way, row] = of.at(t)[member].map(|along| self.side * along);
                let across = speed[1 - self.axis];
                (place + on_axis(self.axis, way, across * t), on_axis(self.axis, row, across))
            }
        }
    }
}

/// Two things that have just parted: the body that is the first end of their contact, and the other one.
struct Parting<'a> {
    scene: &'a Scene<'a>,
    contact: Contact,
    pair: [u32; 2],
    side: f64,
    /// What each takes of their relative motion; their velocity without that.
    parts: [f64; 2],
    together: DVec2,
    bounces: Bounces,
}

impl Events {
    /// Lets two things that have just parted with `speed` (m/s) bounce on in closed form.
    pub(crate) fn begin_train(&mut self, scene: &Scene, contact: &Contact, speed: f64, e: f64) {
        let (axis, (body, other)) = (contact.axis, contact.ends());
        if ![body, other].into_iter().all(|item| self.may_bounce(item)) {
            return;
        }
        let [mine, others] = self.shares(body as usize, other as usize);
        let side = if contact.hi == body { 1.0 } else { -1.0 };
        let slides = side * self.sliding(contact);
        let together = self.speed(body) - on_axis(axis, side * speed, slides) * mine;
        let (friction, rises) = (contact.kinetic_friction, speed);
        let bounces = Bounces { e, friction, rises, slides, falls: 0.0, pulled: 0.0, damping: 0.0 };
        let (pair, parts) = ([body, other], [mine, -others]);
        let mut parting = Parting { scene, contact: *contact, pair, side, parts, together, bounces };
        let (mut pulls, mut stiffness, mut calm) = ([DVec2::ZERO; 2], 0.0, true);
        for (k, item) in pair.into_iter().enumerate().filter(|(_, item)| self.is_body(*item)) {
            let (of, place) = (&self.items[item as usize], self.places[item as usize]);
            let velocity = together + on_axis(axis, 0.0, slides) * parts[k];
            pulls[k] = scene.media.acceleration(&of.body, &of.law, place, velocity);
            if !of.law.is_constant() {
                let answer = scene.media.stiffness(&of.body, &of.law, place, velocity);
                (calm, stiffness) = (false, stiffness + answer.lift);
                parting.bounces.damping += parts[k].abs() * answer.drag[axis];
            }
        }
        if calm && e == 1.0 && pulls == [DVec2::ZERO; 2] {
            return self.begin_wedge(scene, contact);
        }
        let first = 2.0 * speed / (side * (pulls[1] - pulls[0])[axis]);
        if !(first > 0.0 && first <= SHORT_BOUNCE && (parting.bounces.damping + stiffness.sqrt()) * first <= DAMPED_REACH) {
            return;
        }
        let turns = if self.is_body(other) { scene.tick } else { self.items[other as usize].until };
        let mut most = turns.min(scene.tick) - self.now;
        while let Some(mut trains) = self.trains_of(&parting, pulls, most) {
            most = 0.5 * most.min(trains[0].until - self.now);
            let ends = self.ends_of(&parting, &trains);
            let apart = |of: [DVec2; 2]| (of[0] - of[1])[1 - axis].abs();
            let reach = pair.map(|item| self.items[item as usize].body.half[1 - axis]).iter().sum::<f64>() - 2.0 * SLOP;
            let hop = 0.5 * (pulls[0] - pulls[1])[1 - axis].abs() * first * first;
            let mut fits = apart(pair.map(|item| self.places[item as usize])).max(apart(ends.map(|end| end.0))) + hop < reach;
            if !calm {
                let later = [0, 1].map(|k| self.pull_on(scene, pair[k], ends[k]));
                let mean = [0, 1].map(|k| 0.5 * (pulls[k] + later[k]));
                let change = (later[0] - later[1]) - (pulls[0] - pulls[1]);
                fits &= change.length() <= STEADY * (pulls[0] - pulls[1]).length();
                let Some(again) = self.trains_of(&parting, mean, 2.0 * most) else { return };
                trains = again;
            }
            let clear = |k: usize| !self.is_body(pair[k]) || self.is_clear(scene, pair[k] as usize, &trains[k]);
            if fits && clear(0) && clear(1) {
                for (item, train) in pair.into_iter().zip(trains) {
                    self.items[item as usize].train = self.is_body(item).then_some(train);
                }
                return;
            }
        }
    }

    /// Whether nothing but constant forces, media and steady motion act on an item while it bounces.
    fn may_bounce(&self, item: u32) -> bool {
        let linked = self.links.iter().any(|link| link.def.ends().any(|end| end.0 == self.items[item as usize].id));
        if self.is_body(item) { !linked } else { self.free[item as usize] == DVec2::ZERO }
    }

    /// The trains of both under their accelerations without bounces, for `most` seconds at most; none where hardly a bounce fits in.
    fn trains_of(&self, parting: &Parting, pulls: [DVec2; 2], most: f64) -> Option<[Train; 2]> {
        let Parting { scene, contact, pair, side, parts, together, bounces } = *parting;
        let (axis, rest, [mine, others]) = (contact.axis, scene.rest_speed, parts.map(f64::abs));
        let pull = pulls[0] - pulls[1];
        let of = Bounces { falls: -side * pull[axis], pulled: pull[1 - axis], ..bounces };
        let whole = if of.e < 1.0 && rest == 0.0 { of.lasts(f64::INFINITY) } else { f64::INFINITY };
        let (stops, holds) = of.stops_after();
        let turned = if stops.is_finite() && !holds { of.lasts(stops - 1.0) } else { f64::INFINITY };
        // Slower rebounds are none.
        let slowest = if of.e < 1.0 && rest > 0.0 { (libm::log(rest / of.rises) / libm::log(of.e)).floor() } else { f64::INFINITY };
        let most = most.min(turned).min(if slowest.is_finite() { of.lasts(slowest) } else { f64::INFINITY });
        let lasts = whole.min(most);
        if !(of.falls > 0.0 && lasts >= whole.min((2.0 * of.first()).max(scene.tick * SHORTEST))) {
            return None;
        }
        let (over, carried) = (whole <= most, [together, pulls[0] * others + pulls[1] * mine]);
        let [[_, slid], _] = of.at(lasts, over);
        let hop = 0.5 * of.pulled.abs() * of.first() * of.first();
        let room = [slid.min(0.0) - hop, slid.max(0.0) + hop];
        let height = 0.5 * of.rises * of.rises / of.falls;
        Some([0, 1].map(|k| {
            let item = &self.items[pair[k] as usize];
            let carrier = Cubic::parabola(self.places[pair[k] as usize], carried[0], carried[1]).swept(item.body.half, lasts);
            let ways = room.map(|slid| on_axis(axis, side * height, slid) * parts[k]);
            let way =
                Aabb::new(carrier.min + ways[0].min(ways[1]).min(DVec2::ZERO), carrier.max + ways[0].max(ways[1]).max(DVec2::ZERO));
            let kind = Kind::Bounces { of, part: parts[k], carried };
            Train { members: [pair[0], pair[1], NONE], axis, side, until: self.now + lasts, over, way, pull: pulls[k], kind }
        }))
    }

    /// Where both are at the end of their trains, and how fast without bouncing.
    fn ends_of(&self, parting: &Parting, trains: &[Train; 2]) -> [Pose; 2] {
        [0, 1].map(|k| {
            let (i, train) = (parting.pair[k] as usize, &trains[k]);
            let (start, t) = ((self.places[i], self.speeds[i]), train.until - self.now);
            let Kind::Bounces { carried: [v, a], .. } = train.kind else { return start };
            if i >= self.movable {
                return (start.0 + start.1 * t, start.1);
            }
            let (place, mut speed) = train.pose(start, t, train.until);
            speed[train.axis] = (v + a * t)[train.axis];
            (place, speed)
        })
    }

    /// Acceleration of a body without contacts, m/s²; of a surface none.
    fn pull_on(&self, scene: &Scene, item: u32, (place, speed): Pose) -> DVec2 {
        if !self.is_body(item) {
            return DVec2::ZERO;
        }
        let item = &self.items[item as usize];
        scene.media.acceleration(&item.body, &item.law, place, speed)
    }

    /// Whether nothing comes near a body in a train but the other members, and surfaces in one plane with its own, and like it.
    fn is_clear(&self, scene: &Scene, i: usize, train: &Train) -> bool {
        let (item, way) = (&self.items[i], &train.way);
        let near =
            |j: usize| self.lanes[j].touches(way, 0.0) && !train.members.contains(&(j as u32)) && !self.is_ground(i, j, train);
        let stays = |stream: &u32| {
            let zone = &scene.media.streams[*stream as usize].zone;
            zones::stays(way, item.body.half, zone, zones::feels(zone, &item.body, (self.places[i], self.speeds[i])))
        };
        !(0..self.items.len()).any(|j| j != i && near(j)) && self.streams.iter().all(stays)
    }

    /// Whether a surface that stands goes on in one plane with the one on which a body bounces, and bounces and rubs alike.
    fn is_ground(&self, i: usize, j: usize, train: &Train) -> bool {
        let [ground, of] = [train.members[1] as usize, j].map(|item| &self.items[item]);
        if !(ground.surface && of.surface && of.sides == Sides::ALL && self.tracks[j].is_still()) {
            return false;
        }
        let face = |item: &Item| item.body.position[train.axis] + train.side * item.body.half[train.axis];
        let alike = |item: &Item| {
            let coefficients = self.items[i].body.coefficients().with(item.body.coefficients(), true);
            (coefficients.kinetic_friction, coefficients.restitution, item.belt)
        };
        (face(of) - face(ground)).abs() <= SLOP && alike(of) == alike(ground)
    }

    /// Lets a body go to and fro in closed form between the one that it has just left and the next one on its other side, if nothing else acts.
    fn begin_wedge(&mut self, scene: &Scene, contact: &Contact) {
        let axis = contact.axis;
        for (near, middle, side) in [(contact.lo, contact.hi, 1.0), (contact.hi, contact.lo, -1.0)] {
            if !self.is_body(middle) {
                continue;
            }
            let between = |events: &Self, j: u32| {
                let (of, from) = (&events.items[j as usize], &events.items[middle as usize].body);
                let apart = events.lanes[j as usize].centre() - events.places[middle as usize];
                let faces = apart[1 - axis].abs() < of.body.half[1 - axis] + from.half[1 - axis];
                (faces && side * apart[axis] > 0.0 && j != near && j != middle).then_some(side * apart[axis] - of.body.half[axis])
            };
            let all = 0..self.items.len() as u32;
            let next = all.filter_map(|j| Some((j, between(self, j)?))).min_by(|a, b| a.1.total_cmp(&b.1));
            let Some((far, _)) = next else { continue };
            self.locate(scene, far as usize);
            // A wall is the first.
            let (row, side) = if self.is_body(far) { ([near, middle, far], side) } else { ([far, middle, near], -side) };
            if self.begin_row(scene, row, axis, side) {
                return;
            }
        }
    }

    fn begin_row(&mut self, scene: &Scene, row: [u32; 3], axis: usize, side: f64) -> bool {
        let of = row.map(|item| &self.items[item as usize]);
        let lossless = |a: u32, b: u32| {
            let contact = if side > 0.0 { self.contact_along(a, b, axis) } else { self.contact_along(b, a, axis) };
            self.restitution(scene, &contact, 1.0) == 1.0 && (contact.kinetic_friction == 0.0 || self.sliding(&contact) == 0.0)
        };
        let free = |item: u32| {
            !self.is_body(item)
                || self.items[item as usize].law.is_constant() && self.items[item as usize].law.constant == DVec2::ZERO
        };
        let joins = |item: &u32| self.may_bounce(*item) && free(*item) && self.items[*item as usize].train.is_none();
        if !self.is_body(row[2]) || !row.iter().all(joins) || !lossless(row[0], row[1]) || !lossless(row[1], row[2]) {
            return false;
        }
        let at = row.map(|item| side * self.places[item as usize][axis]);
        let half = of.map(|item| item.body.half[axis]);
        let gaps = [0, 1].map(|k| (at[k + 1] - at[k] - half[k] - half[k + 1]).max(0.0));
        let inverse = row.map(|item| if self.is_body(item) { 1.0 / self.items[item as usize].body.mass } else { 0.0 });
        let wedge = Wedge::new(inverse, gaps, row.map(|item| side * self.speed(item)[axis]));
        if wedge.hits() < MANY_HITS {
            return false;
        }
        let until = if self.is_body(row[0]) { scene.tick } else { scene.tick.min(self.items[row[0] as usize].until) };
        let train = |member: usize, way: Aabb| {
            let kind = Kind::Wedge { of: wedge, member };
            Train { members: row, axis, side, until, over: false, way, pull: DVec2::ZERO, kind }
        };
        // The outer ones are driven outwards alone; the middle one stays between them.
        let mut ways = [0, 1, 2].map(|k| {
            let (i, half, t) = (row[k] as usize, of[k].body.half, until - self.now);
            let start = (self.places[i], self.speeds[i]);
            let ends = [start.0, start.0 + start.1 * t, train(k, Aabb::NOWHERE).pose(start, t, until).0];
            ends.into_iter().fold(Aabb::NOWHERE, |way, end| way.union(&Aabb::around(end, half)))
        });
        let [before, behind] = if side > 0.0 { [0, 2] } else { [2, 0] };
        ways[1].min[axis] = ways[before].min[axis] + 2.0 * of[before].body.half[axis];
        ways[1].max[axis] = ways[behind].max[axis] - 2.0 * of[behind].body.half[axis];
        if !row.iter().enumerate().all(|(k, item)| !self.is_body(*item) || self.is_clear(scene, *item as usize, &train(k, ways[k])))
        {
            return false;
        }
        for (k, item) in row.into_iter().enumerate() {
            self.concern(item);
            self.items[item as usize].train = self.is_body(item).then(|| train(k, ways[k]));
        }
        true
    }

    /// Ends the train of a body and of all that are in it, and lists what its bounces have passed on.
    pub(crate) fn end_train(&mut self, scene: &Scene, i: usize) {
        let Some(Train { members, axis, side, kind, .. }) = self.items[i].train else { return };
        let given = members.map(|item| {
            if item == NONE {
                return DVec2::ZERO;
            }
            self.concern(item);
            self.locate(scene, item as usize);
            let (place, speed) = (self.places[item as usize], self.speed(item));
            let body = self.is_body(item);
            let item = &mut self.items[item as usize];
            let Some(train) = item.train.take().filter(|_| body) else { return DVec2::ZERO };
            let change = speed - item.body.velocity - train.pull * (self.now - item.since);
            (item.body.position, item.body.velocity, item.since, item.known) = (place, speed, self.now, false);
            change * item.body.mass
        });
        match kind {
            Kind::Bounces { .. } => self.list_train([members[1], members[0]], axis, side, given[0]),
            Kind::Wedge { .. } => {
                self.list_train([members[1], members[2]], axis, side, given[2]);
                self.list_train([members[0], members[1]], axis, side, given[1] + given[2]);
            }
        }
    }

    /// Lists the impulse (N·s) that the second of two, on that side of the first, has been given.
    fn list_train(&mut self, [by, on]: [u32; 2], axis: usize, side: f64, given: DVec2) {
        let [lo, hi] = if side > 0.0 { [by, on] } else { [on, by] };
        let contact = self.contact_along(lo, hi, axis);
        // Less is the rounding of a flight without a bounce.
        let body = &self.items[contact.ends().0 as usize].body;
        if side * given[axis] > 1e-12 * body.mass * (1.0 + body.velocity.length()) {
            self.note(&contact, given * side, 0.0);
        }
    }
}
