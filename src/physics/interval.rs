//! Motion between two events: how each body moves, and when something next happens.
//!
//! A tick is a chain of intervals in each of which every body follows one smooth law. An interval ends at the first impact, at the end
//! of a slide, where something slides off an edge, where a zone begins or ends, or where drag's law has a kink. Free bodies follow
//! their own flow; bodies in contact follow the solved accelerations, which are constant unless a medium acts on one of them: then all
//! of them are integrated together by RK4 with a contact solve in every stage.

use super::contacts::Contact;
use super::flow::{Pose, flow, parabola};
use super::impact_time::{Cubic, earliest, time_of_impact};
use super::tuning::{COUPLED_REACH, COUPLED_STEP, MAX_CROSSINGS, MIN_SPLIT, SLOP};
use super::{Aabb, World};
use glam::DVec2;

/// How a body moves during an interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Motion {
    /// Not at all.
    Still,
    /// With constant acceleration.
    Parabola,
    /// By its own flow through the media.
    Flow,
    /// In contact and in a medium: integrated together with all its kind.
    Coupled,
}

/// What ends an interval.
#[derive(Clone, Copy, Debug)]
pub(super) enum Happening {
    /// The end of the tick.
    Nothing,
    /// An impact.
    Hit(Contact),
    /// A slide along this axis ends.
    Stop(usize),
    /// A contact ends because its bodies no longer face each other.
    Edge,
    /// A hit that the cubics foresaw and the motions do not show yet: look again from nearer.
    Look,
    /// A body enters or leaves an air stream.
    Stream(u32, u32),
    /// The law of motion has a kink: a liquid's surface, or the exposed side of a body changes.
    Kink(u32),
    /// A body leaves the surface on which it bounced.
    Resume(u32),
}

/// The rate of the fastest change within an interval that a cubic still follows.
const CUBIC_REACH: f64 = 0.5;
/// The shortest interval into which light things near others cut a tick, as a fraction of it.
const SHORTEST: f64 = 1.0 / 16.0;
/// m/s and m/s². Where things meet more gently than this it is the rounding of their places that meets: they would sink into each other
/// by less than 1e-11 m within a tick.
const GRAZING_SPEED: f64 = 1e-11;
const GRAZING_ACCELERATION: f64 = 1e-6;
/// How soon to look again, as a part of the interval.
const SECOND_LOOK: f64 = 1.0 / 64.0;
/// Steps to polish the time of an event on the motion itself.
const POLISH: u32 = 4;

impl World {
    /// Decides how everything moves during the next interval, at most `left` seconds of a `tick`, and returns its greatest length.
    pub(super) fn choose_motions(&mut self, left: f64, tick: f64) -> f64 {
        let mut longest = left;
        self.motions.clear();
        let (mut coupled, mut fastest) = (false, 0.0f64);
        self.in_contact.clear();
        self.in_contact.resize(self.bodies.len(), false);
        for contact in &self.contacts {
            for item in [contact.lo, contact.hi] {
                if let Some(flag) = self.in_contact.get_mut(item as usize) {
                    *flag = true;
                }
            }
        }
        for (i, body) in self.bodies.iter().enumerate() {
            let law = &self.laws[i];
            let at_rest = body.velocity == DVec2::ZERO && self.solved[i] == DVec2::ZERO;
            let media = law.air > 0.0 || law.wet;
            let motion = match (at_rest, media, self.in_contact[i]) {
                (true, _, true) | (true, false, false) => Motion::Still,
                (_, false, _) => Motion::Parabola,
                (_, true, false) => Motion::Flow,
                (_, true, true) => Motion::Coupled,
            };
            if matches!(motion, Motion::Flow | Motion::Coupled) {
                let rate = self.media.rate(body, law, body.velocity);
                if motion == Motion::Coupled {
                    fastest = rate.max(fastest);
                }
                if rate * left > CUBIC_REACH && self.candidates.has_neighbours(i) {
                    longest = longest.min((CUBIC_REACH / rate).max(tick * SHORTEST));
                }
            }
            coupled |= motion == Motion::Coupled;
            self.motions.push(motion);
        }
        if coupled {
            self.stage_free.clear();
            self.stage_free.extend_from_slice(&self.free);
            // Forces pass from one body in contact to the next: whatever moves in contact moves with them.
            for (motion, in_contact) in self.motions.iter_mut().zip(&self.in_contact) {
                if *in_contact && *motion != Motion::Still {
                    *motion = Motion::Coupled;
                }
            }
        }
        self.coupled_at = f64::NAN;
        self.coupled_nodes.clear();
        let reach = fastest * longest;
        if reach > COUPLED_REACH {
            for (i, law) in self.laws.iter_mut().enumerate() {
                if self.motions[i] == Motion::Coupled {
                    law.soft =
                        (COUPLED_REACH / (self.media.rate(&self.bodies[i], law, self.bodies[i].velocity) * longest)).min(1.0);
                }
            }
        }
        let steps = (reach.min(COUPLED_REACH) / COUPLED_STEP).ceil().max(1.0);
        self.coupled_steps = steps as usize;
        self.coupled_step = longest / steps;
        longest
    }

    /// Where a body is `t` seconds into the interval.
    pub(super) fn pose(&mut self, body: usize, t: f64) -> Pose {
        let state = &self.bodies[body];
        match self.motions[body] {
            Motion::Still => (state.position, DVec2::ZERO),
            Motion::Parabola => parabola((state.position, state.velocity), self.solved[body], t),
            Motion::Flow => flow(&self.media, state, &self.laws[body], t),
            Motion::Coupled => {
                if self.coupled_at != t {
                    self.integrate_coupled(t);
                    self.coupled_at = t;
                }
                self.coupled[body]
            }
        }
    }

    /// RK4 for all coupled bodies at once. The states after whole steps are kept: the search for events asks for many times.
    fn integrate_coupled(&mut self, t: f64) {
        let n = self.bodies.len();
        let whole = ((t / self.coupled_step) as usize).min(self.coupled_steps - 1);
        let known = (self.coupled_nodes.len() / n).saturating_sub(1);
        self.coupled.clear();
        if self.coupled_nodes.is_empty() {
            self.coupled_nodes.extend(self.bodies.iter().map(|body| (body.position, body.velocity)));
        }
        let from = known.min(whole);
        self.coupled.extend_from_slice(&self.coupled_nodes[from * n..(from + 1) * n]);
        for step in from..whole {
            self.step_coupled(self.coupled_step, step == 0);
            self.coupled_nodes.extend_from_slice(&self.coupled);
        }
        self.step_coupled(t - whole as f64 * self.coupled_step, whole == 0);
    }

    /// One step of all coupled bodies from `self.coupled`; the interval's first begins with the accelerations already solved.
    fn step_coupled(&mut self, h: f64, first: bool) {
        // Stage poses, and the weighted sums of velocities and accelerations.
        self.stage.clear();
        self.stage.extend_from_slice(&self.coupled);
        self.sums.clear();
        self.sums.resize(self.bodies.len(), (DVec2::ZERO, DVec2::ZERO));
        for (index, (weight, reach)) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)].into_iter().enumerate() {
            if index == 0 && first {
                self.stage_accelerations.clear();
                self.stage_accelerations.extend_from_slice(&self.solved);
            } else {
                self.stage_solve();
            }
            for i in 0..self.bodies.len() {
                if self.motions[i] != Motion::Coupled {
                    continue;
                }
                let (a, v) = (self.stage_accelerations[i], self.stage[i].1);
                self.sums[i].0 += v * weight;
                self.sums[i].1 += a * weight;
                let (x0, v0) = self.coupled[i];
                self.stage[i] = (x0 + v * (reach * h), v0 + a * (reach * h));
            }
        }
        let sixth = h / 6.0;
        for i in 0..self.bodies.len() {
            if self.motions[i] == Motion::Coupled {
                let (x, v) = &mut self.coupled[i];
                *x += self.sums[i].0 * sixth;
                *v += self.sums[i].1 * sixth;
            }
        }
    }

    /// Accelerations at the stage poses. The contacts keep their forces of the interval's start: those are what is shown.
    fn stage_solve(&mut self) {
        self.free.clear();
        for i in 0..self.bodies.len() {
            let (x, v) = self.stage[i];
            self.free.push(match self.motions[i] {
                Motion::Coupled => self.media.acceleration(&self.bodies[i], &self.laws[i], x, v),
                _ => self.stage_free[i],
            });
        }
        self.stage_contacts.clear();
        self.stage_contacts.extend_from_slice(&self.contacts);
        self.stage_accelerations.clear();
        self.stage_accelerations.extend_from_slice(&self.free);
        let items = self.bodies.len() + self.blocks.len();
        self.reactions.accelerate(&mut self.stage_contacts, &self.bodies, items, &self.free, &mut self.stage_accelerations);
    }

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
        self.cubics.clear();
        for i in 0..self.bodies.len() {
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
            self.cubics.push(cubic);
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
        for index in 0..self.candidates.pairs.len() {
            let pair = self.candidates.pairs[index];
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
                *first = (t, Happening::Stop(along));
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
        // Secant steps kept inside the bracket.
        let (mut from_speed, mut t) = (speed, end);
        for _ in 0..40 {
            let secant = from + (to - from) * from_speed / (from_speed - last);
            t = if secant > from && secant < to { secant } else { 0.5 * (from + to) };
            let now = at(self, t);
            if now.abs() <= f64::EPSILON * speed || to - from <= f64::EPSILON * end {
                break;
            }
            if now > 0.0 {
                (from, from_speed) = (t, now);
                last *= 0.5; // the Illinois rule: keeps the far end from standing still
            } else {
                (to, last) = (t, now);
                from_speed *= 0.5;
            }
        }
        Some(t)
    }

    /// Borders of zones, and kinks of drag.
    fn next_crossing(&mut self, first: &mut (f64, Happening)) {
        for i in 0..self.bodies.len() {
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
            if self.laws[i].wet {
                for f in 0..self.media.fluids.len() {
                    let zone = self.media.fluids[f].zone;
                    if let Some(t) = surface_kink(&cubic, half, &zone, first.0) {
                        *first = (t, Happening::Kink(i as u32));
                    }
                }
            }
            if (self.laws[i].air > 0.0 || self.laws[i].wet)
                && half.x != half.y
                && let Some(t) = self.change_of_side(i, first.0)
                && t < first.0
            {
                *first = (t, Happening::Kink(i as u32));
            }
        }
    }

    /// When a body begins to move more across than up or down, or the other way round.
    fn change_of_side(&mut self, i: usize, end: f64) -> Option<f64> {
        let across = self.across[i];
        let lead = |v: DVec2| if across { v.x.abs() - v.y.abs() } else { v.y.abs() - v.x.abs() };
        let (mut from, mut to) = (MIN_SPLIT, end);
        if to <= from || lead(self.pose(i, to).1) >= 0.0 || lead(self.pose(i, from).1) < 0.0 {
            return None;
        }
        while to - from > MIN_SPLIT {
            let middle = 0.5 * (from + to);
            if lead(self.pose(i, middle).1) >= 0.0 {
                from = middle;
            } else {
                to = middle;
            }
        }
        Some(to)
    }
}

/// When a body enters (or, from inside, leaves) a zone.
fn border(cubic: &Cubic, half: DVec2, zone: &Aabb, inside: bool, end: f64) -> Option<f64> {
    let centre = zone.centre();
    let reach = half + zone.size() * 0.5;
    let still = Cubic::parabola(centre, DVec2::ZERO, DVec2::ZERO);
    let motion = still.relative(cubic);
    let mut best: Option<f64> = None;
    for axis in 0..2 {
        let (path, other) = (motion.axis(axis), motion.axis(1 - axis));
        let level = reach[axis];
        let t = if inside {
            earliest(path.rises_through(level, 0.0, end), path.falls_through(-level, 0.0, end))
        } else {
            earliest(path.falls_through(level, 0.0, end), path.rises_through(-level, 0.0, end))
                .filter(|&t| other.at(t).abs() <= reach[1 - axis])
        };
        best = earliest(best, t.filter(|&t| t < end));
    }
    best
}

/// When the submerged part of a body begins, ends, or starts or stops to change along an axis.
fn surface_kink(cubic: &Cubic, half: DVec2, zone: &Aabb, end: f64) -> Option<f64> {
    let still = Cubic::parabola(zone.centre(), DVec2::ZERO, DVec2::ZERO);
    let motion = still.relative(cubic);
    let zone_half = zone.size() * 0.5;
    let mut best: Option<f64> = None;
    for axis in 0..2 {
        let (path, other) = (motion.axis(axis), motion.axis(1 - axis));
        for level in [zone_half[axis] + half[axis], (zone_half[axis] - half[axis]).abs()] {
            for level in [level, -level] {
                let t = earliest(path.falls_through(level, MIN_SPLIT, end), path.rises_through(level, MIN_SPLIT, end));
                let meets = |t: &f64| *t < end && other.at(*t).abs() <= zone_half[1 - axis] + half[1 - axis];
                best = earliest(best, t.filter(meets));
            }
        }
    }
    best
}
