//! Bounces that come thick and fast, passed over in closed form.
//!
//! A series of bounces on something immovable has a sum: after some bounces within one tick the rest of it, or as many whole bounces as fit,
//! is passed over (rest after 2w/(g(1 − e))), during which the mean reaction is that of a body at rest. What nothing pulls at and nothing
//! brakes goes to and fro between two walls for ever: it is back every 2d/w. Meanwhile it counts as lying where it bounced.

use super::item::Resume;
use super::{Events, Scene};
use crate::physics::Sides;
use crate::physics::contact::Contact;
use crate::physics::tuning::{CALM_REACH, SLOP, ZENO_HITS};
use glam::DVec2;

/// What follows a bounce: how long bounces go on, s, how fast it leaves then, m/s, if it does, and what they pass on meanwhile, N·s.
struct Series {
    time: f64,
    leaves: Option<f64>,
    impulse: f64,
}

impl Events {
    /// Passes over the rest of a bounce series on a surface that stands still, or over whole bounces of it, where they come thick and fast.
    /// The body has just left it with `speed`, m/s.
    pub(super) fn pass_over_bounces(&mut self, scene: &Scene, contact: &Contact, speed: f64, e: f64) {
        let (body, axis) = (contact.ends().0, contact.axis);
        if self.items[body as usize].hits < ZENO_HITS {
            return;
        }
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
            self.items[body as usize].resume = Some(Resume { at: (self.now + time).min(scene.tick), axis, speed: away * speed });
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
        let (count, time) = if e >= 1.0 {
            let count = (left / first).floor();
            (count, (count * first).min(left))
        } else {
            // n bounces take first·(1 − eⁿ)/(1 − e).
            let part = left * (1.0 - e) / first;
            let count = if part >= 1.0 { f64::INFINITY } else { (libm::log1p(-part) / libm::log(e)).floor() };
            (count, (first * (1.0 - libm::pow(e, count)) / (1.0 - e)).min(left))
        };
        Some(Series { time, leaves: count.is_finite().then(|| speed * libm::pow(e, count)), impulse: 0.0 })
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
