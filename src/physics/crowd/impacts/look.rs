//! Which pairs touch next: a binary heap of predictions, each void as soon as one of its bodies is hit.

use crate::physics::crowd::impacts::course::{Course, time_of_impact};
use crate::physics::crowd::impacts::{Around, Impacts, NONE, SLOWEST};
use crate::physics::store::bodies::Bodies;
use std::cmp::Ordering;

/// A pair of e < 1 that has bounced so often in one step is left to the plastic solution: such series have a sum. Fewer: bounces end
/// early; more: inelastic collapse costs more.
const RATTLE: u32 = 12;

/// Two that bounce off each other; the pairs of a body are a chain of links 2·pair (as its first) and 2·pair + 1 (as its second).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub a: u32,
    pub b: u32,
    pub restitution: f64,
    /// How often it has bounced in this step.
    pub hits: u32,
    next: [u32; 2],
}

/// A pair will touch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Due {
    /// s from the start of the step.
    pub time: f64,
    /// Closing speed then, m/s.
    pub speed: f64,
    pub pair: u32,
    /// How many courses its bodies had taken: after one more it is void.
    pub courses: u32,
    pub axis: usize,
}

impl PartialEq for Due {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Due {}

impl PartialOrd for Due {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Due {
    /// The greatest is the earliest, then the fastest, then the first of the list.
    fn cmp(&self, other: &Self) -> Ordering {
        (other.time.total_cmp(&self.time)).then(self.speed.total_cmp(&other.speed)).then(other.pair.cmp(&self.pair))
    }
}

impl Impacts {
    /// The next impact that still comes.
    pub(crate) fn next_due(&mut self) -> Option<Due> {
        loop {
            let due = self.calendar.pop()?;
            if self.courses_of(&self.pairs[due.pair as usize]) == due.courses {
                return Some(due);
            }
        }
    }

    fn courses_of(&self, pair: &Pair) -> u32 {
        self.flyers[pair.a as usize].courses + self.flyers[pair.b as usize].courses
    }

    /// Adds a pair if it bounces. Returns whether it does.
    pub(crate) fn add(&mut self, bodies: &Bodies, i: u32, j: u32) -> bool {
        let (a, b) = (i as usize, j as usize);
        let restitution = bodies.coefficients(a, b).restitution;
        if b >= bodies.len() {
            let course = [Course::straight(bodies.x[b], bodies.vx[b]), Course::straight(bodies.y[b], bodies.vy[b])];
            self.flyers[b].course = course;
        }
        if restitution == 0.0 || self.flyers[a].braked || (b < bodies.len() && self.flyers[b].braked) {
            return false;
        }
        let pair = self.pairs.len() as u32;
        let mut pair_of = |i: usize, link: u32| std::mem::replace(&mut self.flyers[i].chain, link);
        let next_of_a = pair_of(a, 2 * pair);
        let next_of_b = if b < bodies.len() { pair_of(b, 2 * pair + 1) } else { NONE };
        self.pairs.push(Pair { a: i, b: j, restitution, hits: 0, next: [next_of_a, next_of_b] });
        true
    }

    /// Adds a pair if it bounces, and predicts when.
    pub(crate) fn meet(&mut self, bodies: &Bodies, i: u32, j: u32) {
        if self.add(bodies, i, j) {
            let due = self.touches(bodies, self.pairs.len() as u32 - 1, 0.0);
            self.calendar.extend(due);
        }
    }

    /// Body i is on another course from `time` on: predicts what it touches, also where that is further than contacts were looked for.
    pub(crate) fn leave(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, i: usize, time: f64) {
        self.flyers[i].courses += 1;
        if !bodies.is_swept(i) {
            around.reach.widen(bodies, around.neighbours, around.island, i, around.last);
            for &(a, b) in &around.reach.new {
                self.add(bodies, a, b);
            }
        }
        let mut at = self.flyers[i].chain;
        while at != NONE {
            let due = self.touches(bodies, at / 2, time);
            self.calendar.extend(due);
            at = self.pairs[at as usize / 2].next[at as usize % 2];
        }
    }

    /// When a pair touches after `now`, on the courses of its bodies.
    fn touches(&self, bodies: &Bodies, pair: u32, now: f64) -> Option<Due> {
        let of = &self.pairs[pair as usize];
        let (a, b, left) = (of.a as usize, of.b as usize, self.dt - now);
        let reach = [bodies.hx[a] + bodies.hx[b], bodies.hy[a] + bodies.hy[b]];
        let (mine, other) = (&self.flyers[a].course, &self.flyers[b].course);
        let mut motion = [[0.0; 4]; 2];
        for (axis, motion) in motion.iter_mut().enumerate() {
            let (of_a, of_b) = (&mine[axis], &other[axis]);
            let apart = of_b.place(now) - of_a.place(now);
            let side = if apart < 0.0 { -1.0 } else { 1.0 };
            let gap = apart * side - reach[axis];
            let (closing, pull) = ((of_a.speed(now) - of_b.speed(now)) * side, (of_a.pull - of_b.pull) * side);
            // Too far to touch in the rest of the step.
            if gap > (closing.max(0.0) + 0.5 * pull.max(0.0) * left) * left + self.touch {
                return None;
            }
            *motion = [gap, closing, pull, side];
        }
        let mut best: Option<Due> = None;
        for axis in 0..2 {
            let [gap, closing, pull, side] = motion[axis];
            if gap < -self.touch {
                continue;
            }
            let Some((after, speed)) = time_of_impact(if gap > self.hair { gap } else { 0.0 }, closing, pull) else { continue };
            let time = now + after;
            if time >= self.dt || best.is_some_and(|best| best.time <= time) {
                continue;
            }
            let beside = (other[1 - axis].place(time) - mine[1 - axis].place(time)).abs() - reach[1 - axis];
            let open = b >= bodies.len() && !bodies.sides[b].face(axis, side < 0.0);
            let ends = of.restitution < 1.0 && (of.restitution * speed < self.rest_speed || of.hits >= RATTLE);
            if beside < -self.touch && !open && speed > SLOWEST && !ends {
                best = Some(Due { time, speed, pair, courses: self.courses_of(of), axis });
            }
        }
        best
    }
}
