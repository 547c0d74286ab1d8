//! Motions after an event. A group in contact in media takes implicit steps: a solve with masses M·(1 + θhD + θ²h²K) (`docs/physics.md`, Flight).

use crate::physics::data::{BOBBING_REACH, Contact, Cubic, SPEED_TOLERANCE};
use crate::physics::exact::events::{Events, Implicit, Scene};
use crate::physics::exact::item::{Item, Next, Slide, Track, Travel};
use crate::physics::{contact::axis::Parts, forces::zones};
use glam::DVec2;

/// The shortest part of a tick foreseen near a liquid. Smaller: many foresights in stiff liquids; larger: steps across a surface gain energy.
pub(crate) const SHORTEST: f64 = 1.0 / 64.0;

/// Trials for the length of an implicit step that ends at a kink. Fewer: light stacks gain energy where they leave a liquid.
const KINK_TRIALS: u32 = 8;

/// Corrections of an implicit step; m/s that another may change. Fewer, larger: a feather parts from its crate at the apex; more, smaller: no gain.
const PASSES: u32 = 4;
/// Passes of Newton's method, which halve an overshoot each. Fewer: a body from rest in dense liquid overshoots. `flows_cut_short` counts more.
const STEEP_PASSES: u32 = 32;
const OFF: f64 = 1e-7;

/// How long, s from the tick's start, the cubic of an item in a medium follows its flow; flows through liquids are checked later.
fn end_of_a_cubic(scene: &Scene, item: &Item) -> f64 {
    let wet = item.law.is_near_liquid();
    if wet && item.motion == Travel::Flow {
        return scene.tick;
    }
    // Rate × time, and the shortest part of a tick. Each foresight near liquids costs many times as much.
    let (reach, shortest) = if wet { (0.5, SHORTEST) } else { (0.1, 1.0 / 256.0) };
    let pose = (item.body.position, item.body.velocity);
    let (mut long, least) = (reach / scene.media.rate(&item.body, &item.law, pose, scene.tick - item.since), scene.tick * shortest);
    if wet {
        // The path has a kink where half of the body has entered a liquid: half of the time to that.
        long = long.min((item.body.half / pose.1.abs()).min_element() * 0.5);
    }
    if long >= least {
        return (item.since + long).min(scene.tick);
    }
    let pull = scene.media.acceleration(&item.body, &item.law, pose.0, pose.1).length();
    // In the shortest part the path leaves its tangent by a millimetre at most.
    (item.since + long.max(least.min((1e-3 / pull).sqrt()))).min(scene.tick)
}

impl Events {
    /// Looks at all items concerned again. Returns false where too many impacts fall into that instant.
    pub(crate) fn look(&mut self, scene: &Scene) -> bool {
        // A surface that stops concerns more items: each surface once.
        let known = self.hits.len();
        for _ in self.movable..=self.items.len() {
            self.halted = false;
            self.collect(scene);
            if !self.resolve_impacts(scene) {
                self.hits.truncate(known);
                return false;
            }
            if !self.halted {
                self.settle_concerned(scene);
            }
            if !self.halted {
                break;
            }
        }
        self.go_on(scene);
        true
    }

    fn settle_concerned(&mut self, scene: &Scene) {
        self.pass_on(false);
        for i in self.concerned.iter().map(|i| *i as usize) {
            let item = &mut self.items[i];
            (item.body.position, item.body.velocity) = (self.places[i], self.speeds[i]);
            (item.since, item.end, item.disturbed) = (self.now, None, true);
        }
        self.renew_links(scene);
        (0..self.concerned.len()).for_each(|k| self.renew_law(scene, self.concerned[k] as usize));
        self.find_contacts(scene);
        self.solve_concerned(scene);
    }

    /// The force of the engine, the links and the streams, N.
    pub(crate) fn force_on(&self, scene: &Scene, i: usize) -> DVec2 {
        let item = &self.items[i];
        let push = item.drive + item.link;
        if self.streams.is_empty() { push } else { scene.media.force_of_streams(&item.body, push) }
    }

    pub(crate) fn renew_law(&mut self, scene: &Scene, i: usize) {
        let force = self.force_on(scene, i);
        let item = &mut self.items[i];
        scene.media.renew(&mut item.law, &item.body, force, scene.tick - self.now);
    }

    pub(crate) fn solve_concerned(&mut self, scene: &Scene) {
        for i in self.concerned.iter().map(|i| *i as usize) {
            let item = &self.items[i];
            self.free[i] = scene.media.acceleration(&item.body, &item.law, item.body.position, item.body.velocity);
            self.solved[i] = self.free[i];
        }
        self.take_contacts_of_concerned();
        self.reactions.accelerate(&mut self.trial, &Parts { masses: &self.masses, free: &self.free }, &mut self.solved);
        let solved = std::mem::take(&mut self.trial);
        self.stop_surfaces(scene, &solved, |events, surface| events.free[surface as usize]);
        self.trial = solved;
        self.list_ends(scene, false);
        self.contacts.append(&mut self.trial);
        self.concerned.iter().for_each(|i| self.items[*i as usize].solved = self.solved[*i as usize]);
    }

    pub(crate) fn go_on(&mut self, scene: &Scene) {
        self.choose_motions(scene);
        self.incident.index(self.items.len(), self.contacts.iter().map(Contact::pair));
        (0..self.concerned.len()).for_each(|k| self.foresee(scene, self.concerned[k] as usize));
        let still = self.tracks.iter().all(Track::is_still);
        for i in 0..self.items.len() {
            let item = &self.items[i];
            let stopped = i >= self.movable && item.stops_at <= self.now && item.since == self.now;
            if !(self.is_concerned[i] || stopped) {
                continue;
            }
            if still {
                self.nexts[i] = self.own_next(scene, i);
            } else {
                self.predict(scene, i);
            }
        }
    }

    pub(crate) fn foresee(&mut self, scene: &Scene, i: usize) {
        let way = self.items[i].foresee(scene.media);
        let track = Track::new(&self.items[i], way);
        if i < self.movable && !self.streams.is_empty() && !track.is_still() {
            self.borders[i] = scene.media.streams_at(&track.swept, zones::BESIDE);
        }
        self.lanes[i] = track.lane(&track.swept);
        self.tracks[i] = track;
        self.nexts[i] = Next::NEVER;
        self.ways[i] += 1;
    }

    fn choose_motions(&mut self, scene: &Scene) {
        let left = scene.tick - self.now;
        self.take_contacts_of_concerned();
        self.incident.index(self.items.len(), self.trial.iter().map(Contact::pair));
        let (mut coupled, winds) = (false, self.links.iter().any(|link| link.growth(scene.tick) != 0.0));
        for i in self.concerned.iter().map(|i| *i as usize) {
            let (in_media, linked, touching) = (!self.items[i].law.is_constant(), self.items[i].linked, self.incident.of(i));
            let first = touching.first().map(|index| self.trial[*index as usize]);
            let at_rest = self.speeds[i] == DVec2::ZERO && self.solved[i] == DVec2::ZERO;
            let may_slide = in_media && !linked && touching.len() == 1 && !at_rest;
            let slide = first.filter(|_| may_slide).and_then(|contact| self.slide_of(i, &contact));
            let item = &mut self.items[i];
            (item.mean, item.until, item.slide) = (self.solved[i], scene.tick, slide);
            item.motion = match first {
                _ if item.train.is_some() => Travel::Train,
                _ if at_rest => Travel::Still,
                Some(_) if slide.is_some() => Travel::Slide,
                None if in_media && !linked => Travel::Flow,
                Some(_) | None => Travel::Parabola,
            };
            coupled |= (linked || first.is_some() && in_media) && item.motion == Travel::Parabola || linked && winds;
            if matches!(item.motion, Travel::Flow | Travel::Slide) {
                item.until = end_of_a_cubic(scene, item);
            }
            item.until = item.train.as_ref().map_or(item.until, |train| train.until);
        }
        if coupled && left > 0.0 && !self.fly_coupled(scene, left) {
            self.fly_implicitly(scene, left);
        }
        self.contacts.append(&mut self.trial);
    }

    fn fly_implicitly(&mut self, scene: &Scene, left: f64) {
        let mut h = self.up_to_a_kink(scene, self.while_slides_last(left));
        self.take_mean_accelerations(scene, h);
        // The path of a step depends on its length: trials find the length that ends at a kink or a turn.
        for _ in 0..KINK_TRIALS {
            let sooner = self.up_to_a_kink(scene, h).min(self.up_to_a_turn(scene, h));
            if sooner >= h {
                break;
            }
            h = sooner;
            self.take_mean_accelerations(scene, h);
        }
        for &i in &self.concerned {
            let item = &mut self.items[i as usize];
            if item.motion == Travel::Parabola {
                item.until = item.until.min(self.now + h);
            }
        }
    }

    /// How long a mean acceleration may be taken, of `left` seconds: a quarter longer than the first slide lasts, so that its end is found.
    pub(crate) fn while_slides_last(&self, left: f64) -> f64 {
        let rate = |item: u32, along: usize| self.solved[item as usize][along];
        let ends = self.trial.iter().filter(|contact| contact.slides != 0.0).map(|contact| {
            let along = 1 - contact.axis;
            let braking = contact.slides * (rate(contact.lo, along) - rate(contact.hi, along));
            if braking > 0.0 { 1.25 * contact.slides * self.sliding(contact) / braking } else { f64::INFINITY }
        });
        ends.filter(|&end| end > 0.0).fold(left, f64::min)
    }

    /// How much of the next `h` seconds an implicit step may take: up to a kink, and no longer than bobbing and quadratic drag allow.
    fn up_to_a_kink(&self, scene: &Scene, h: f64) -> f64 {
        let moving = self.concerned.iter().map(|i| &self.items[*i as usize]).filter(|item| item.motion == Travel::Parabola);
        let most = moving.filter(|item| !item.law.is_constant()).map(|item| {
            let (x, v) = (item.body.position, item.body.velocity);
            let longest = BOBBING_REACH / scene.media.bending(&item.body, &item.law, x, item.solved);
            let kink = item.law.displaced.end_of(&Cubic::parabola(x, v, item.mean), h);
            kink.unwrap_or(h).min(longest).max(scene.tick * SHORTEST)
        });
        most.fold(h, f64::min)
    }

    /// How much of the next `h` seconds an implicit step may take whose drag is of a point later than its midpoint: a turn between both gains energy.
    fn up_to_a_turn(&self, scene: &Scene, h: f64) -> f64 {
        let turns = self.implicit.iter().zip(&self.concerned).flat_map(|(of, i)| {
            let (speed, mean) = (self.items[*i as usize].body.velocity, self.means[*i as usize]);
            [0, 1].into_iter().filter(|axis| of.theta[*axis] > 0.5).map(move |axis| -speed[axis] / mean[axis])
        });
        let turn = turns.filter(|turn| *turn > 0.0).fold(h, f64::min);
        // A shorter step of strong drag turns sooner as well.
        if turn < h { turn.min(0.5 * h).max(scene.tick * SHORTEST).min(h) } else { h }
    }

    /// The slide of a body on the one surface that it touches, if that does not speed up.
    fn slide_of(&self, i: usize, contact: &Contact) -> Option<Slide> {
        let surface = contact.other(i as u32);
        if self.is_body(surface) || self.free[surface as usize] != DVec2::ZERO {
            return None;
        }
        let away = if contact.hi as usize == i { 1.0 } else { -1.0 };
        let slides = contact.normal > 0.0 && contact.slides != 0.0;
        slides.then_some(Slide { axis: contact.axis, away, friction: away * contact.slides * contact.kinetic_friction })
    }

    /// The mean accelerations of bodies in contact in media: forces linearised, then those at the point found (second order).
    fn take_mean_accelerations(&mut self, scene: &Scene, h: f64) {
        self.implicit.clear();
        for i in self.concerned.iter().map(|i| *i as usize) {
            let item = &self.items[i];
            let answer = scene.media.stiffness(&item.body, &item.law, item.body.position, item.body.velocity);
            let (drag, stiffness) = (answer.drag, DVec2::new(0.0, answer.lift));
            let rate = drag * h + stiffness * (h * h);
            let theta = |rate: f64| if rate > 2.0 { 1.0 - 1.0 / rate } else { 0.5 };
            let theta = DVec2::new(theta(rate.x), theta(rate.y));
            let response = theta * drag * h + theta * theta * stiffness * (h * h);
            self.implicit.push(Implicit { theta, response, mean: DVec2::ZERO });
            let eased = response + 1.0;
            self.masses[i] = eased * item.body.mass;
            let now = scene.media.acceleration(&item.body, &item.law, item.body.position, item.body.velocity);
            self.free[i] = (now - stiffness * theta * h * item.body.velocity) / eased;
        }
        self.solve_means();
        let (mut before, mut steep) = (f64::INFINITY, false);
        for pass in 1..=STEEP_PASSES {
            let off = self.correct_means(scene, h, &mut steep);
            if off <= OFF || !steep && (off >= before || pass == PASSES) {
                break;
            }
            before = off;
            self.guards.flows_cut_short += u64::from(pass == STEEP_PASSES);
        }
        for i in self.concerned.iter().map(|i| *i as usize) {
            let item = &mut self.items[i];
            self.masses[i] = DVec2::splat(item.body.mass);
            // A liquid that slows a resting body less and less may push it off.
            if item.motion == Travel::Still && self.means[i].abs().max_element() * h > SPEED_TOLERANCE {
                item.motion = Travel::Parabola;
            }
            if item.motion == Travel::Parabola {
                item.mean = self.means[i];
            }
        }
    }

    /// Takes the forces once more at that point. Where drag or lift is so much steeper there that such passes would diverge (from rest quadratic drag
    /// has no slope), they become `steep`: with slopes at their own point (Newton's method). Returns how much the next would change, m/s.
    fn correct_means(&mut self, scene: &Scene, h: f64, steep: &mut bool) -> f64 {
        for (i, Implicit { theta, response, mean }) in self.concerned.iter().map(|i| *i as usize).zip(&mut self.implicit) {
            let (item, a, t) = (&self.items[i], self.means[i], *theta * h);
            let (x, v) = (item.body.position + t * item.body.velocity + t * t * a, item.body.velocity + t * a);
            let answer = scene.media.stiffness(&item.body, &item.law, x, v);
            let there = t * answer.drag + t * t * DVec2::new(0.0, answer.lift);
            *steep |= there.cmpgt(1.0 + 2.0 * *response).any();
            if *steep {
                *response = there;
                self.masses[i] = (there + 1.0) * item.body.mass;
            }
            self.free[i] = (scene.media.acceleration(&item.body, &item.law, x, v) + *response * a) / (*response + 1.0);
            *mean = a;
        }
        self.solve_means();
        let change = |(of, i): (&Implicit, &u32)| ((self.means[*i as usize] - of.mean).abs() * of.response).max_element() * h;
        self.implicit.iter().zip(&self.concerned).map(change).fold(0.0, f64::max)
    }

    pub(crate) fn solve_means(&mut self) {
        self.means.clone_from(&self.free);
        self.asked.clone_from(&self.trial);
        self.reactions.accelerate(&mut self.asked, &Parts { masses: &self.masses, free: &self.free }, &mut self.means);
    }

    pub(crate) fn renew(&mut self, scene: &Scene, i: usize) {
        let item = &mut self.items[i];
        (item.body.position, item.body.velocity) = item.pose(scene.media, self.now);
        (item.since, item.end) = (self.now, None);
        if i < self.movable && item.motion != Travel::Coupled {
            item.until = end_of_a_cubic(scene, item);
        }
        self.foresee(scene, i);
        self.predict(scene, i);
    }
}
