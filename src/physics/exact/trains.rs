//! Trains of bounces as events. One ends with its last bounce, with the tick, or where something comes near, and then lists what it has passed on.

use crate::physics::data::{Aabb, Contact, Cubic, DAMPED_REACH, MANY_HITS, NONE, SHORT_BOUNCE, SLOP, Sides, on_axis};
use crate::physics::exact::train::{BounceSeries, Train, TrainKind, Wedge};
use crate::physics::{exact::events::Events, exact::events::Scene, exact::motions::SHORTEST, forces::zones};
use glam::DVec2;

impl Events {
    /// Lets two things that have just parted with `speed` (m/s) bounce on in closed form.
    pub(crate) fn begin_train(&mut self, scene: &Scene, contact: &Contact, speed: f64, e: f64) {
        let (axis, along, mut pair) = (contact.axis, 1 - contact.axis, [contact.ends().0, contact.ends().1]);
        let joined = self.is_body(pair[1]);
        if joined && self.items[pair[0] as usize].body.mass < self.items[pair[1] as usize].body.mass {
            // The order of rows decides no last bit.
            pair.reverse();
        }
        let of = pair.map(|item| item as usize);
        if !pair.iter().all(|item| self.may_bounce(*item)) || e < 1.0 && scene.rest_speed > 0.0 {
            return;
        }
        let [mine, others] = self.shares(of[0], of[1]);
        let (parts, side) = ([mine, -others], if contact.hi == pair[0] { 1.0 } else { -1.0 });
        let pull = self.pull(scene, pair[0]);
        let wedge = e == 1.0 && !joined && self.keeps_level(scene, pair[0], axis);
        if wedge && self.begin_wedge(scene, contact, side, pull) {
            return;
        }
        let slides = side * self.sliding(contact);
        let together = self.speeds[of[0]] - on_axis(axis, side * speed, slides) * mine;
        // Accelerations without bounces, and the rates of drag and lift, `t` seconds later, after a way and with a speed along.
        let forces = |k: usize, t: f64, carried: DVec2, way: f64, slides: f64| {
            let (item, [way, slides]) = (&self.items[of[k]], [way, slides].map(|along| on_axis(axis, 0.0, along * parts[k])));
            let place = self.places[of[k]] + (together + carried * (0.5 * t)) * t + way;
            let velocity = together + carried * t + slides;
            let answer = scene.media.stiffness(&item.body, &item.law, place, velocity);
            (scene.media.acceleration(&item.body, &item.law, place, velocity), answer.drag[axis] * parts[k].abs(), answer.lift)
        };
        let calm = of.iter().all(|i| self.items[*i].law.is_constant());
        let begun = [0, 1].map(|k| forces(k, 0.0, DVec2::ZERO, 0.0, slides));
        let damping = if calm { 0.0 } else { begun[0].1 + begun[1].1 };
        let bounces = |pull: DVec2| {
            let (falls, pulled) = (-side * pull[axis], pull[along]);
            BounceSeries { e, friction: contact.kinetic_friction, rises: speed, falls, slides, pulled, damping }
        };
        let mut pulls = begun.map(|of| of.0);
        let first = bounces(pulls[0] - pulls[1]).first();
        if !(first > 0.0 && first <= SHORT_BOUNCE && (damping + (begun[0].2 + begun[1].2).sqrt()) * first <= DAMPED_REACH) {
            return;
        }
        let apart = (self.places[of[0]] - self.places[of[1]])[along];
        let reach = of.map(|i| self.items[i].body.half[along]).iter().sum::<f64>() - 2.0 * SLOP;
        let drift = if joined { 0.0 } else { (together - self.speeds[of[1]])[along] };
        let mut most = if joined { scene.tick } else { scene.tick.min(self.items[of[1]].until) } - self.now;
        loop {
            let mut bounce = bounces(pulls[0] - pulls[1]);
            let mut steady = true;
            if !calm {
                // Those at the middle stand for all.
                let half = 0.5 * most.min(bounce.whole());
                let ([[_, way], [_, slid]], carried) = (bounce.at(half, false), begun[0].0 * others + begun[1].0 * mine);
                pulls = [0, 1].map(|k| forces(k, half, carried, way, slid).0);
                bounce = bounces(pulls[0] - pulls[1]);
                steady = (0..2).all(|k| (pulls[k] - begun[k].0).length() <= DAMPED_REACH * (pulls[0] - pulls[1]).length());
            }
            let (_, stops, holds) = bounce.brakes();
            if stops.is_finite() && !holds {
                most = most.min(bounce.lasts(stops - 1.0));
            }
            let whole = bounce.whole();
            let (lasts, over) = (whole.min(most), whole <= most);
            // Shorter ones are no gain.
            if !(bounce.falls > 0.0 && lasts >= whole.min((2.0 * first).max(scene.tick * SHORTEST))) {
                return;
            }
            let carried = [together, pulls[0] * others + pulls[1] * mine];
            let [[_, slid], _] = bounce.at(lasts, over);
            let (height, hop) = (0.5 * speed * speed / bounce.falls, 0.5 * bounce.pulled.abs() * first * first);
            let trains = [0, 1].map(|k| {
                let swept = Cubic::parabola(self.places[of[k]], carried[0], carried[1]).swept(self.items[of[k]].body.half, lasts);
                let (slid, reach) = (on_axis(axis, 0.0, slid * parts[k]), on_axis(axis, height, hop) * parts[k].abs());
                let way = swept.union(&Aabb::new(swept.min + slid, swept.max + slid));
                let (way, kind) = (Aabb::new(way.min - reach, way.max + reach), TrainKind::Bounces(bounce, parts[k], carried));
                Train { members: [pair[0], pair[1], NONE], axis, side, until: self.now + lasts, over, way, pull: pulls[k], kind }
            });
            let faces = apart.abs().max((apart + slid + drift * lasts).abs()) + hop < reach;
            let clear = |k: usize| !self.is_body(pair[k]) || self.is_clear(scene, of[k], &trains[k]);
            if steady && faces && clear(0) && clear(1) {
                return (0..1 + usize::from(joined)).for_each(|k| self.set_train(of[k], trains[k]));
            }
            most = 0.5 * lasts;
        }
    }

    fn set_train(&mut self, i: usize, train: Train) {
        let (place, speed, item) = (self.places[i], self.speeds[i], &mut self.items[i]);
        (item.body.position, item.body.velocity, item.since, item.train) = (place, speed, self.now, Some(train));
    }

    /// Whether nothing but constant forces, media and steady motion act on an item while it bounces.
    fn may_bounce(&self, item: u32) -> bool {
        let linked = self.links.iter().any(|link| link.def.ends().any(|end| end.0 == self.items[item as usize].id));
        if self.is_body(item) { !linked } else { self.free[item as usize] == DVec2::ZERO }
    }

    /// Whether nothing is near a body in a train but other members, and surfaces that go on in one plane with its own, and are like it.
    fn is_clear(&self, scene: &Scene, i: usize, train: &Train) -> bool {
        let (item, way, axis) = (&self.items[i], &train.way, train.axis);
        let ground = train.members.into_iter().filter(|member| *member != NONE).fold(0, u32::max) as usize;
        let face = |j: usize| self.items[j].body.position[axis] + train.side * self.items[j].body.half[axis];
        let like =
            |j: usize| (self.items[j].body.coefficients(), self.items[j].belt, self.items[j].surface, self.tracks[j].is_still());
        let goes_on = |j: usize| {
            let alike = like(ground) == like(j) && self.items[j].surface && self.items[j].sides == Sides::ALL;
            alike && self.tracks[j].is_still() && (face(j) - face(ground)).abs() <= SLOP
        };
        // A body of a wedge keeps its place on the surfaces under it as long as it faces them.
        let (wedge, apart) = (matches!(train.kind, TrainKind::Wedge(..)), 2.0 * (item.body.half[axis] - SLOP));
        let faces = |floor: &Aabb| way.min[axis] + apart >= floor.min[axis] && way.max[axis] - apart <= floor.max[axis];
        let carries = |j: usize| {
            let of = |contact: &Contact| contact.is_of(i as u32, j as u32) && contact.axis != axis;
            wedge && self.contacts.iter().any(of) && faces(&self.items[j].body.bounds())
        };
        let member = |j: usize| train.members.contains(&(j as u32));
        let near = |j: usize| self.lanes[j].touches(way, 0.0) && !member(j) && !goes_on(j) && !carries(j);
        let stays = |stream: &u32| {
            let zone = &scene.media.streams[*stream as usize].zone;
            zones::stays(way, item.body.half, zone, zones::feels(zone, &item.body, (self.places[i], self.speeds[i])))
        };
        !(0..self.items.len()).any(near) && self.streams.iter().all(stays)
    }

    /// Whether constant forces alone act on a body, none of them across an `axis` but into surfaces that stand and rub nothing.
    fn keeps_level(&self, scene: &Scene, item: u32, axis: usize) -> bool {
        let along = 1 - axis;
        let smooth = |contact: &Contact| {
            let surface = contact.ends().1;
            let holds = contact.normal > 0.0 && contact.static_friction.max(contact.kinetic_friction) <= 0.0;
            holds && !self.is_body(surface) && self.tracks[surface as usize].is_still() && self.approach(contact) == 0.0
        };
        let mut carries = self.contacts.iter().filter(|contact| contact.has(item) && contact.axis == along).peekable();
        let free = carries.peek().is_none();
        let mut level = || if free { self.pull(scene, item)[along] == 0.0 } else { carries.all(smooth) };
        self.items[item as usize].law.is_constant() && level()
    }

    /// Lets a body that has just left a wall go to and fro between that and the next, under the `pull` (m/s²) on it. Returns whether it does.
    fn begin_wedge(&mut self, scene: &Scene, contact: &Contact, side: f64, pull: DVec2) -> bool {
        let (axis, (middle, wall)) = (contact.axis, contact.ends());
        let ahead = |j: u32| {
            let apart = (self.lanes[j as usize].centre() - self.places[middle as usize]) * side;
            let reach = self.items[j as usize].body.half + self.items[middle as usize].body.half;
            (apart[1 - axis].abs() < reach[1 - axis] && apart[axis] > 0.0 && j != wall).then_some(apart[axis] - reach[axis])
        };
        let others = (0..self.items.len() as u32).filter(|j| *j != middle).filter_map(|j| Some((j, ahead(j)?)));
        let Some((far, _)) = others.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|(far, _)| self.is_body(*far)) else { return false };
        self.locate(scene, far as usize);
        let of = [far as usize, middle as usize];
        let (lo, hi) = if side > 0.0 { (middle, far) } else { (far, middle) };
        let next = self.contact_along(lo, hi, axis);
        let slides = [contact, &next].iter().any(|contact| contact.kinetic_friction > 0.0 && self.sliding(contact) != 0.0);
        let touches = self.contacts.iter().any(|contact| contact.has(far) && contact.axis == axis);
        let free = !touches && self.keeps_level(scene, far, axis) && self.may_bounce(far) && self.items[of[0]].train.is_none();
        let pulls = [self.pull(scene, far)[axis], pull[axis]];
        let [masses, speeds] = [of.map(|i| self.items[i].body.mass), of.map(|i| side * self.speeds[i][axis])];
        let gap = -self.depth_of(&next).min(0.0);
        let wedge = Wedge { wall: side * self.speed(wall)[axis], masses, gap, speeds, pulls: pulls.map(|pull| side * pull) };
        let until = scene.tick.min(self.items[wall as usize].until);
        if slides || !free || self.restitution(scene, &next, 1.0) < 1.0 || wedge.hits(until - self.now) < MANY_HITS {
            return false;
        }
        let train = |k: usize, way: Aabb| {
            let kind = TrainKind::Wedge(wedge, k);
            let pull = on_axis(axis, pulls[k], 0.0);
            Train { members: [far, middle, wall], axis, side, until, over: false, way, pull, kind }
        };
        // The other one stays between the wall and its highest place, the one in between on this side of it.
        let (start, half, t) = ((self.places[of[0]], self.speeds[of[0]]), self.items[of[0]].body.half, until - self.now);
        let end = |(way, t): (f64, f64)| start.0 + on_axis(axis, side * (way - gap), start.1[1 - axis] * t);
        let ends = [(wedge.wall.min(0.0) * t, 0.0), (wedge.highest(t), t)].map(end);
        let way = ends.into_iter().fold(Aabb::NOWHERE, |way, end| way.union(&Aabb::around(end, half)));
        let from = |t: f64| Aabb::around(self.places[of[1]] + self.speed(wall) * t, self.items[of[1]].body.half);
        let mut between = way.union(&from(0.0)).union(&from(t));
        let edge = if side > 0.0 { &mut between.max } else { &mut between.min };
        edge[axis] -= side * 2.0 * half[axis];
        let trains = [train(0, way), train(1, between)];
        let clear = (0..2).all(|k| self.is_clear(scene, of[k], &trains[k]));
        if clear {
            self.concern_carried(scene, far);
            (0..2).for_each(|k| self.set_train(of[k], trains[k]));
        }
        clear
    }

    fn concern_carried(&mut self, scene: &Scene, item: u32) {
        if self.is_concerned[item as usize] {
            return;
        }
        self.concern(item);
        for slot in self.incident.slots(item as usize) {
            let touching = self.touch(scene, self.contacts[self.incident.list[slot] as usize], false);
            self.touching.push(touching);
        }
    }

    /// Ends the train of a body and of all that are in it, and lists what its bounces have passed on.
    pub(crate) fn end_train(&mut self, scene: &Scene, i: usize) {
        let Some(Train { members, axis, side, kind, .. }) = self.items[i].train else { return };
        let mut given = [DVec2::ZERO; 3];
        for (k, member) in members.into_iter().enumerate().filter(|(_, member)| *member != NONE) {
            self.concern(member);
            self.locate(scene, member as usize);
            let (place, speed, item) = (self.places[member as usize], self.speed(member), &mut self.items[member as usize]);
            if let Some(train) = item.train.take() {
                given[k] = (speed - item.body.velocity - train.pull * (self.now - item.since)) * item.body.mass;
                (item.body.position, item.body.velocity, item.since, item.known) = (place, speed, self.now, false);
            }
        }
        let lists = match kind {
            TrainKind::Bounces(..) => [(1, 0, given[0]), (1, 0, DVec2::ZERO)],
            TrainKind::Wedge(..) => [(1, 0, given[0]), (2, 1, given[0] + given[1])],
        };
        for (by, on, given) in lists {
            let (lo, hi) = if side > 0.0 { (members[by], members[on]) } else { (members[on], members[by]) };
            let body = &self.items[members[on] as usize].body;
            // Less is the rounding of a flight without a bounce.
            if side * given[axis] > 1e-12 * body.mass * (1.0 + body.velocity.length()) {
                let contact = self.contact_along(lo, hi, axis);
                self.note(&contact, given * side, Some(0.0));
            }
        }
    }
}
