//! What happens next: the end of an interval.
//!
//! An interval ends at the first impact, at the end of a slide, where something slides off an edge, where a zone begins or ends, or where
//! drag's law has a kink. All are sought on cubics that follow the motions; where a cubic is not the motion itself, the time is polished
//! on the motion (Newton's method on gap and closing speed).

use super::World;
use super::contacts::Contact;
use super::crossing::{border, surface_kink};
use super::flow::Pose;
use super::impact_time::{Cubic, earliest, time_of_impact};
use super::interval::Motion;
use super::tuning::{MAX_CROSSINGS, SLOP};
use glam::DVec2;

/// What ends an interval.
#[derive(Clone, Copy, Debug)]
pub(super) enum Happening {
    /// The end of the tick.
    Nothing,
    /// An impact.
    Hit(Contact),
    /// The slide of this contact ends.
    Stop(Contact),
    /// A contact ends because its bodies no longer face each other.
    Edge,
    /// A hit that the cubics foresaw and the motions do not show yet: look again from nearer.
    Look,
    /// A body enters or leaves an air stream.
    Stream(u32, u32),
    /// The law of motion has a kink: a liquid's surface.
    Kink(u32),
    /// A body leaves the surface on which it bounced.
    Resume(u32),
}

/// m/s and m/s². Where things meet more gently than this it is the rounding of their places that meets: they would sink into each other
/// by less than 1e-11 m within a tick.
const GRAZING_SPEED: f64 = 1e-11;
const GRAZING_ACCELERATION: f64 = 1e-6;
/// How soon to look again, as a part of the interval.
const SECOND_LOOK: f64 = 1.0 / 64.0;
/// Steps to polish the time of an event on the motion itself.
const POLISH: u32 = 4;

impl World {
    /// The first thing that happens within `end` seconds, and when.
    pub(super) fn next_happening(&mut self, end: f64) -> (f64, Happening) {
        let mut first = (end, Happening::Nothing);
        self.draw_cubics(end);
        if self.plan.media() {
            self.next_crossing(&mut first);
            if first.0 < end {
                // Across a kink of its law no cubic follows a motion: draw them up to it.
                self.draw_cubics(first.0);
            }
        }
        for index in 0..self.resumes.len() {
            let t = self.resumes[index].at - self.now;
            if t < first.0 {
                first = (t.max(0.0), Happening::Resume(index as u32));
            }
        }
        self.next_contact_change(&mut first);
        self.next_hit(&mut first);
        first
    }

    /// Cubics that follow the motions for `end` seconds.
    fn draw_cubics(&mut self, end: f64) {
        for index in 0..self.awake.len() {
            let i = self.awake[index] as usize;
            let (x, v) = (self.bodies[i].position, self.bodies[i].velocity);
            let cubic = match self.motions[i] {
                Motion::Still => Cubic::parabola(x, DVec2::ZERO, DVec2::ZERO),
                Motion::Parabola => Cubic::parabola(x, v, self.solved[i]),
                Motion::Flow | Motion::Coupled if end > 0.0 => {
                    let (end_x, end_v) = self.pose(i, end);
                    Cubic::hermite(x, v, end_x, end_v, end)
                }
                Motion::Flow | Motion::Coupled => Cubic::parabola(x, v, self.solved[i]),
            };
            self.cubics[i] = cubic;
        }
    }

    fn cubic(&self, item: u32) -> Cubic {
        self.cubics.get(item as usize).copied().unwrap_or_else(|| Cubic::parabola(self.place(item), DVec2::ZERO, DVec2::ZERO))
    }

    fn moves(&self, item: u32) -> bool {
        self.motions.get(item as usize).is_some_and(|&motion| motion != Motion::Still)
    }

    /// Whether a cubic is the motion itself and not only close to it.
    fn exact(&self, item: u32) -> bool {
        self.motions.get(item as usize).is_none_or(|motion| matches!(motion, Motion::Still | Motion::Parabola))
    }

    fn pose_of(&mut self, item: u32, t: f64) -> Pose {
        if self.immovable(item) { (self.place(item), DVec2::ZERO) } else { self.pose(item as usize, t) }
    }

    fn next_hit(&mut self, first: &mut (f64, Happening)) {
        let mut closed = 0;
        for index in 0..self.candidates.live.len() {
            let pair = self.candidates.live[index];
            while self.contacts.get(closed).is_some_and(|contact| contact.pair < pair) {
                closed += 1;
            }
            let in_contact = self.contacts.get(closed).filter(|contact| contact.pair == pair);
            if in_contact.is_some_and(|contact| contact.normal > 0.0) || !(self.moves(pair.a) || self.moves(pair.b)) {
                continue;
            }
            let motion = self.cubic(pair.a).relative(&self.cubic(pair.b));
            let reach = self.half(pair.a) + self.half(pair.b);
            let Some((t, axis)) = time_of_impact(&motion, reach, first.0) else { continue };
            let path = motion.axis(axis);
            let side = path.at(t).signum();
            if -side * path.slope(t) <= GRAZING_SPEED && -side * path.curvature(t) <= GRAZING_ACCELERATION {
                continue;
            }
            let contact = self.contact_along(pair, axis, side > 0.0, true);
            let (t, happening) = match self.polish(&contact, reach[axis], t, first.0) {
                Some(t) => (t, Happening::Hit(contact)),
                None => (t.max(first.0 * SECOND_LOOK), Happening::Look),
            };
            if t < first.0 {
                *first = (t, happening);
            }
        }
    }

    /// Newton's method for the time at which a contact closes, on the motions themselves; none if they do not close there after all.
    fn polish(&mut self, contact: &Contact, reach: f64, mut t: f64, end: f64) -> Option<f64> {
        let Contact { lo, hi, axis, .. } = *contact;
        if self.exact(lo) && self.exact(hi) {
            return Some(t);
        }
        for step in 0..POLISH {
            let ((lo_x, lo_v), (hi_x, hi_v)) = (self.pose_of(lo, t), self.pose_of(hi, t));
            let gap = hi_x[axis] - lo_x[axis] - reach;
            let closing = lo_v[axis] - hi_v[axis];
            if step == 0 && closing <= 0.0 && gap > -SLOP {
                return None;
            }
            let next = t + gap / closing;
            // Where the boxes only graze, Newton's method would run off to the moment at which they parted.
            if closing <= 0.0 || next <= 0.0 || next > end || next == t {
                break;
            }
            t = next;
        }
        Some(t)
    }

    /// Ends of slides, and things sliding off an edge.
    fn next_contact_change(&mut self, first: &mut (f64, Happening)) {
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            if !(self.moves(contact.lo) || self.moves(contact.hi)) {
                continue;
            }
            let along = 1 - contact.axis;
            let motion = self.cubic(contact.lo).relative(&self.cubic(contact.hi)).axis(along);
            if contact.slides != 0.0
                && let Some(t) = self.end_of_slide(&contact, first.0)
                && t < first.0
            {
                *first = (t, Happening::Stop(contact));
            }
            // Half the slop: a contact needs all of it, so that this one is over then, however the time is rounded.
            let level = self.half(contact.lo)[along] + self.half(contact.hi)[along] - 0.5 * SLOP;
            let off = earliest(motion.rises_through(level, 0.0, first.0), motion.falls_through(-level, 0.0, first.0));
            if let Some(t) = off
                && t < first.0
            {
                *first = (t, Happening::Edge);
            }
        }
    }

    /// When a slide's speed falls to zero.
    fn end_of_slide(&mut self, contact: &Contact, end: f64) -> Option<f64> {
        let along = 1 - contact.axis;
        let sign = contact.slides;
        let speed = sign * (self.velocity(contact.hi) - self.velocity(contact.lo))[along];
        if speed <= 0.0 {
            return None;
        }
        let acceleration = |world: &Self, item: u32| world.solved.get(item as usize).map_or(0.0, |a| a[along]);
        let braking = sign * (acceleration(self, contact.lo) - acceleration(self, contact.hi));
        if self.exact(contact.lo) && self.exact(contact.hi) {
            return (braking > 0.0).then(|| speed / braking);
        }
        let at = |world: &mut Self, t: f64| sign * (world.pose_of(contact.hi, t).1 - world.pose_of(contact.lo, t).1)[along];
        let (mut from, mut to) = (0.0, end);
        let mut last = at(self, end);
        if last > 0.0 {
            return None;
        }
        // Secant steps inside the bracket; an end that stays where it is counts half (the Illinois rule), so that both close in.
        let (mut from_speed, mut t, mut side) = (speed, end, 0);
        for _ in 0..60 {
            let secant = from + (to - from) * from_speed / (from_speed - last);
            t = if secant > from && secant < to { secant } else { 0.5 * (from + to) };
            let now = at(self, t);
            if now.abs() <= f64::EPSILON * speed || to - from <= f64::EPSILON * end {
                break;
            }
            if now > 0.0 {
                (from, from_speed) = (t, now);
                if side > 0 {
                    last *= 0.5;
                }
                side = 1;
            } else {
                (to, last) = (t, now);
                if side < 0 {
                    from_speed *= 0.5;
                }
                side = -1;
            }
        }
        Some(t)
    }

    /// Borders of zones.
    fn next_crossing(&mut self, first: &mut (f64, Happening)) {
        for index in 0..self.awake.len() {
            let i = self.awake[index] as usize;
            if self.motions[i] == Motion::Still || self.crossings[i] >= MAX_CROSSINGS {
                continue;
            }
            let (half, cubic) = (self.bodies[i].half, self.cubics[i]);
            for s in 0..self.media.streams.len() {
                let zone = self.media.streams[s].zone;
                let inside = self.in_stream[i * self.media.streams.len() + s];
                if let Some(t) = border(&cubic, half, &zone, inside, first.0) {
                    *first = (t, Happening::Stream(i as u32, s as u32));
                }
            }
            if self.laws[i].is_near_liquid() {
                for f in 0..self.media.fluids.len() {
                    let zone = self.media.fluids[f].zone;
                    if let Some(t) = surface_kink(&cubic, half, &zone, first.0) {
                        *first = (t, Happening::Kink(i as u32));
                    }
                }
            }
        }
    }
}
