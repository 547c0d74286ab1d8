//! Bounces that come thick and fast, passed over in closed form.
//!
//! A series of bounces on something immovable has a sum: after some bounces within one tick the rest of it, or as many whole bounces as fit,
//! is passed over (rest after 2w/(g(1 − e))), during which the mean reaction is that of a body at rest. So has one of two bodies that are pressed
//! together. What nothing pulls at and nothing brakes goes to and fro between two walls for ever: it is back every 2d/w. Meanwhile it counts as
//! lying where it bounced.

use super::item::Resume;
use super::{Events, Scene};
use crate::physics::Sides;
use crate::physics::contact::Contact;
use crate::physics::tuning::{CALM_REACH, SLOP, ZENO_HITS};
use glam::DVec2;

/// The rate × time of a bounce of two bodies up to which drag only takes a little off each. Larger: what it takes is off by more than a tenth;
/// smaller: what is light and bounces in front of something heavy does so a hundred times before it is passed over.
const DAMPED_REACH: f64 = 0.1;

/// Of speeds that fall as e^(−x): where nothing is left of them.
const DAMPED_AWAY: f64 = 40.0;

/// What follows a bounce: how long bounces go on, s, how fast it leaves then, m/s, if it does, and what they pass on meanwhile, N·s.
struct Series {
    time: f64,
    leaves: Option<f64>,
    impulse: f64,
}

impl Series {
    /// As many bounces as fit into `left` seconds, the `first` of which takes so long, s, and begins with so much `speed`, m/s. Each keeps e of
    /// its speed, or loses to drag at a rate of `damping`, 1/s, where e = 1.
    ///
    /// A bounce under a pull a with drag c·v comes back slower by (2c/3a)·v², and takes 2v/a: so speeds fall as e^(−c·t/3).
    fn of(first: f64, left: f64, (speed, e): (f64, f64), damping: f64) -> Self {
        if e < 1.0 {
            // n bounces take first·(1 − eⁿ)/(1 − e).
            let part = left * (1.0 - e) / first;
            let count = if part >= 1.0 { f64::INFINITY } else { (libm::log1p(-part) / libm::log(e)).floor() };
            let time = (first * (1.0 - libm::pow(e, count)) / (1.0 - e)).min(left);
            return Self { time, leaves: count.is_finite().then(|| speed * libm::pow(e, count)), impulse: 0.0 };
        }
        let slowing = damping / 3.0;
        if slowing * left >= DAMPED_AWAY {
            return Self { time: left, leaves: None, impulse: 0.0 };
        }
        if slowing * left <= f64::EPSILON {
            return Self { time: ((left / first).floor() * first).min(left), leaves: Some(speed), impulse: 0.0 };
        }
        let count = (libm::expm1(slowing * left) / (slowing * first)).floor();
        let slower = slowing * first * count;
        Self { time: (libm::log1p(slower) / slowing).min(left), leaves: Some(speed / (1.0 + slower)), impulse: 0.0 }
    }
}

impl Events {
    /// Passes over the rest of a bounce series on a surface that stands still, or of two bodies that nothing else touches, or over whole bounces
    /// of it, where they come thick and fast. They have just left each other with `speed`, m/s.
    pub(super) fn pass_over_bounces(&mut self, scene: &Scene, contact: &Contact, speed: f64, e: f64) {
        let (body, other) = contact.ends();
        if self.items[body as usize].hits < ZENO_HITS {
            return;
        }
        if self.is_body(other) {
            return self.pass_over_bounces_of_two(scene, contact, speed, e);
        }
        let axis = contact.axis;
        let away = if contact.hi == body { 1.0 } else { -1.0 };
        let found = match self.series(scene, contact, speed, e) {
            None if e >= 1.0 => self.back_and_forth(scene, contact, speed),
            found => found,
        };
        let Some(Series { time, leaves, impulse }) = found else { return };
        let mut held = DVec2::ZERO;
        held[axis] = away * impulse - self.items[body as usize].body.mass * self.speeds[body as usize][axis];
        self.note(contact, if body == contact.hi { held } else { -held }, 0.0);
        self.speeds[body as usize][axis] = 0.0;
        if let Some(speed) = leaves {
            let at = (self.now + time).min(scene.tick);
            self.items[body as usize].resume = Some(Resume { at, axis, speed: away * speed, other: None });
        }
    }

    /// The series of bounces on one face, to which the body is pulled back.
    fn series(&self, scene: &Scene, contact: &Contact, speed: f64, e: f64) -> Option<Series> {
        let (body, axis) = (contact.ends().0 as usize, contact.axis);
        let away = if contact.hi as usize == body { 1.0 } else { -1.0 };
        let (left, item) = (scene.tick - self.now, &self.items[body]);
        let pose = (self.places[body], self.speeds[body]);
        let pull = -away * scene.media.acceleration(&item.body, &item.law, pose.0, DVec2::ZERO)[axis];
        let first = 2.0 * speed / pull;
        let thick = pull > 0.0 && first * f64::from(ZENO_HITS) < left;
        if !thick || scene.media.rate(&item.body, &item.law, pose, left) * first > CALM_REACH {
            return None;
        }
        Some(Series::of(first, left, (speed, e), 0.0))
    }

    /// Two bodies that are pressed against each other by what acts on them, as drag presses something light against something heavy that
    /// flies behind it, bounce about their common motion. Meanwhile they count as lying against each other.
    fn pass_over_bounces_of_two(&mut self, scene: &Scene, contact: &Contact, speed: f64, e: f64) {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        if self.touching.len() > 1 || self.items[lo].hits.min(self.items[hi].hits) < ZENO_HITS {
            return;
        }
        let [of_lo, of_hi] = self.shares(lo, hi);
        let together = self.speeds[lo][axis] + of_lo * speed;
        let (mut pull, mut damping, mut stiffness) = (0.0, 0.0, 0.0);
        for (i, sign, share) in [(lo, 1.0, of_lo), (hi, -1.0, of_hi)] {
            let (item, mut velocity) = (&self.items[i], self.speeds[i]);
            velocity[axis] = together;
            pull += sign * scene.media.acceleration(&item.body, &item.law, self.places[i], velocity)[axis];
            let answer = scene.media.stiffness(&item.body, &item.law, self.places[i], velocity);
            damping += share * answer.drag[axis];
            stiffness += answer.lift;
        }
        let (first, left) = (2.0 * speed / pull, scene.tick - self.now);
        let thick = pull > 0.0 && first > 0.0 && first * f64::from(ZENO_HITS) < left;
        if !thick || (damping + stiffness.sqrt()) * first > DAMPED_REACH {
            return;
        }
        let Series { time, leaves, .. } = Series::of(first, left, (speed, e), damping);
        let mut held = DVec2::ZERO;
        held[axis] = -speed * of_lo * self.items[lo].body.mass;
        self.note(contact, held, 0.0);
        (self.speeds[lo][axis], self.speeds[hi][axis]) = (together, together);
        if let Some(speed) = leaves {
            let at = (self.now + time).min(scene.tick);
            self.items[lo].resume = Some(Resume { at, axis, speed, other: Some(contact.hi) });
        }
    }

    /// Lets a body leave what it has bounced on, or both of two bodies.
    pub(super) fn resume(&mut self, scene: &Scene, i: usize) {
        self.locate(scene, i);
        let Some(Resume { axis, speed, other, .. }) = self.items[i].resume.take() else { return };
        let held =
            |contact: &&Contact| contact.axis == axis && contact.has(i as u32) && other.is_none_or(|other| contact.hi == other);
        let contact = self.contacts.iter().find(held).copied();
        let mut impulse = DVec2::ZERO;
        if let Some(other) = other {
            // What pressed them together may have ended: then nothing is left of their bounces either.
            let Some(contact) = contact else { return };
            self.concern(other);
            self.locate(scene, other as usize);
            let [mine, of_other] = self.shares(i, other as usize);
            self.speeds[i][axis] -= mine * speed;
            self.speeds[other as usize][axis] += of_other * speed;
            impulse[axis] = mine * speed * self.items[i].body.mass;
            return self.note(&contact, impulse, 0.0);
        }
        if self.speeds[i][axis] != 0.0 {
            return;
        }
        self.speeds[i][axis] = speed;
        impulse[axis] = self.items[i].body.mass * speed;
        if let Some(contact) = contact {
            self.locate(scene, contact.other(i as u32) as usize);
            self.note(&contact, if contact.hi as usize == i { impulse } else { -impulse }, 0.0);
        }
    }

    /// Ends what bounces of two bodies are passed over, because something else happens to one of them: they leave each other now.
    pub(super) fn resume_concerned(&mut self, scene: &Scene) {
        for k in 0..self.concerned.len() {
            let i = self.concerned[k] as usize;
            if self.items[i].resume.is_some_and(|resume| resume.other.is_some()) {
                self.resume(scene, i);
            }
        }
    }

    /// Ends all bounces that are passed over, because the island is left at this instant: they go on from here.
    pub(super) fn resume_all(&mut self, scene: &Scene) {
        for i in 0..self.movable {
            if self.items[i].resume.is_some() {
                self.concern(i as u32);
                self.resume(scene, i);
            }
        }
        for &i in &self.concerned {
            self.items[i as usize].body.velocity = self.speeds[i as usize];
        }
        self.release();
    }

    /// The way to the opposite wall and back, as often as it fits, of a body that is alone between walls that stand. It lists what that wall
    /// has passed on.
    fn back_and_forth(&mut self, scene: &Scene, contact: &Contact, speed: f64) -> Option<Series> {
        let ((body, _), axis, along) = (contact.ends(), contact.axis, 1 - contact.axis);
        let i = body as usize;
        let away = if contact.hi == body { 1.0 } else { -1.0 };
        let (item, place) = (&self.items[i], self.places[i]);
        let walls = &self.tracks[self.movable..];
        let free = item.law.is_constant() && item.law.constant == DVec2::ZERO && self.speeds[i][along] == 0.0;
        let alone = self.movable == 1 && self.touching.len() == 1 && self.streams.is_empty();
        let stand =
            walls.iter().all(|wall| wall.is_still()) && self.items[self.movable..].iter().all(|wall| wall.sides == Sides::ALL);
        if !(free && alone && stand) {
            return None;
        }
        // How far away what faces it is.
        let distance = |wall: usize| {
            let (apart, reach) = (walls[wall].way.c[0] - place, walls[wall].half + item.body.half);
            let ahead = away * apart[axis] > 0.0 && apart[along].abs() <= reach[along] + SLOP;
            if ahead { away * apart[axis] - reach[axis] } else { f64::INFINITY }
        };
        let wall = (0..walls.len()).min_by(|a, b| distance(*a).total_cmp(&distance(*b)))?;
        let gap = distance(wall);
        let other = &self.items[self.movable + wall].body;
        let faces = (walls[wall].way.c[0] - place)[along].abs() < walls[wall].half[along] + item.body.half[along] - SLOP;
        let elastic = item.body.restitution.max(other.restitution) >= 1.0;
        let time = 2.0 * gap / speed;
        let count = ((scene.tick - self.now) / time).floor();
        if !(faces && elastic && gap > 0.0 && count >= 1.0) {
            return None;
        }
        let impulse = 2.0 * count * item.body.mass * speed;
        let opposite = (self.movable + wall) as u32;
        let (lo, hi) = if away > 0.0 { (body, opposite) } else { (opposite, body) };
        let opposite = self.contact_along(lo, hi, axis);
        let mut passed = DVec2::ZERO;
        passed[axis] = impulse;
        self.locate(scene, self.movable + wall);
        self.places[i][axis] += away * gap;
        self.note(&opposite, passed, speed);
        self.places[i] = place;
        Some(Series { time: (count * time).min(scene.tick - self.now), leaves: Some(speed), impulse })
    }
}

#[cfg(test)]
mod tests {
    use super::Series;

    #[test]
    fn a_series_of_bounces_ends_when_its_sum_does() {
        // 1 + ½ + ¼ + … s.
        let of = |left: f64| Series::of(1.0, left, (8.0, 0.5), 0.0);
        assert_eq!((of(3.0).time, of(3.0).leaves), (2.0, None));
        assert_eq!((of(1.8).time, of(1.8).leaves), (1.75, Some(1.0)));
    }

    #[test]
    fn what_loses_nothing_bounces_as_often_as_fits() {
        let of = Series::of(0.5, 2.25, (8.0, 1.0), 0.0);
        assert_eq!((of.time, of.leaves), (2.0, Some(8.0)));
    }

    /// One bounce after the other under a pull of 2 m/s², with (2c/3a)·v² off the speed of each.
    #[test]
    fn drag_takes_its_part_of_each_bounce() {
        let (damping, pull, mut speed, mut time) = (0.3, 2.0, 0.01, 0.0);
        let of = Series::of(2.0 * speed / pull, 20.0, (speed, 1.0), damping);
        while time + speed < of.time {
            time += 2.0 * speed / pull;
            speed -= 2.0 * damping / (3.0 * pull) * speed * speed;
        }
        assert!(of.time > 19.99 && of.time <= 20.0, "{} s", of.time);
        assert!(of.leaves.is_some_and(|leaves| (leaves / speed - 1.0).abs() < 0.01), "{:?}, not {speed}", of.leaves);
        assert_eq!(Series::of(1.0, 10.0, (8.0, 1.0), 100.0).leaves, None);
    }
}
