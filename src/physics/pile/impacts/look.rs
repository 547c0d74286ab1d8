//! Looking ahead: who touches whom next.
//!
//! Each body knows the first pair of its own that will touch, and no other. Who sets out on another way looks at all of its pairs, each up to
//! what the other one knows of already; so of two that touch, the one that has looked last knows. What somebody knew of one that has
//! gone another way is void: it looks again if that time comes (after Lubachevsky 1991). What a pair comes to is always reckoned from
//! when the later of the two set out.

use super::super::bodies::Bodies;
use super::super::islands::apart;
use super::course::time_of_impact;
use super::due::{Due, Pair};
use super::{Around, Impacts, NONE, RATTLE, SLOWEST, WORK_OF_A_LINK, WORK_OF_A_LOOK};

/// How deep what has sunk may be in a surface, as a part of the smaller half of the body.
const SUNK: f64 = 0.5;

impl Impacts {
    /// Looks ahead from the start of the step, for both of the pair that was added last.
    pub(super) fn look_first(&mut self, bodies: &Bodies, i: u32, j: u32) {
        self.work += WORK_OF_A_LINK;
        if apart(&self.looks[i as usize].lane, &self.looks[j as usize].lane) {
            return;
        }
        self.work += WORK_OF_A_LOOK;
        let Some(due) = self.touches(bodies, self.pairs.len() as u32 - 1, self.dt) else { return };
        for by in [i, j].into_iter().filter(|by| (*by as usize) < bodies.len()) {
            self.calendar.offer(by as usize, due);
        }
    }

    /// Notes what each has found first of all.
    pub(super) fn note_first_looks(&mut self, bodies: &Bodies) {
        self.calendar.open();
        for k in 0..self.calendar.finders().len() {
            let i = self.calendar.finders()[k] as usize;
            let time = self.calendar.due(i).time;
            (self.looks[i].lane, self.looks[i].next) = (self.lane(bodies, i, (0.0, time)), time);
        }
    }

    /// Whether what body `by` has found comes now. If it is void, the body looks again.
    pub(super) fn is_next(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, by: usize, due: &Due) -> bool {
        self.clock = due.time;
        let holds = self.ways_of(&self.pairs[due.pair as usize]) == due.ways;
        if !holds {
            self.look_on(bodies, around, by);
        }
        holds
    }

    /// A pair has touched: if that changed nothing for who has found it, it looks for what comes after that.
    pub(super) fn pass(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, by: usize, due: &Due) {
        self.pairs[due.pair as usize].passed = due.ways;
        let known = self.calendar.due(by);
        if (known.pair, known.ways) == (due.pair, due.ways) {
            self.look_on(bodies, around, by);
        }
    }

    /// Body i sets out on another way, which is its own from `time` on.
    pub(super) fn leave(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, i: usize, time: f64) {
        self.departures += 1;
        let looked = &mut self.looks[i];
        looked.ways += 1;
        (looked.since, looked.departure) = (time, self.departures);
        self.look_on(bodies, around, i);
    }

    /// Body i looks ahead, also where that leads it further than contacts were looked for.
    fn look_on(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, i: usize) {
        self.look(bodies, i);
        let (lane, swept, touch) = (&self.looks[i].lane, &bodies.swept[i], self.touch);
        let strays =
            (0..2).any(|axis| lane[2 * axis] + touch < swept[2 * axis] || lane[2 * axis + 1] - touch > swept[2 * axis + 1]);
        if strays && !bodies.is_swept(i) {
            self.widen(bodies, around, i);
            self.look(bodies, i);
        }
    }

    /// The box that something does not leave between two times, m.
    pub(super) fn lane(&self, bodies: &Bodies, i: usize, (from, to): (f64, f64)) -> [f64; 4] {
        let mut lane = [0.0; 4];
        for (axis, half) in [bodies.hx[i], bodies.hy[i]].into_iter().enumerate() {
            let course = &self.courses[i][axis];
            let (begin, end) = (course.place(from), course.place(to));
            // A parabola strays no further from its chord.
            let reach = half + 0.125 * course.pull.abs() * (to - from) * (to - from) + self.touch;
            (lane[2 * axis], lane[2 * axis + 1]) = (begin.min(end) - reach, begin.max(end) + reach);
        }
        lane
    }

    fn ways_of(&self, pair: &Pair) -> u32 {
        let of = |i: u32| self.looks[i as usize].ways;
        of(pair.a).wrapping_add(of(pair.b))
    }

    /// Finds what body i touches next.
    fn look(&mut self, bodies: &Bodies, i: usize) {
        let mut lane = self.lane(bodies, i, (self.clock, self.dt));
        let mut best: Option<Due> = None;
        let mut at = self.chain[i];
        while at != NONE {
            let link = self.links[at as usize];
            self.work += WORK_OF_A_LINK;
            let other = &self.looks[link.other as usize];
            if !apart(&lane, &other.lane) {
                let known = if (link.other as usize) < bodies.len() { other.next } else { f64::INFINITY };
                self.work += WORK_OF_A_LOOK;
                let until = best.map_or(known, |best| best.time.min(known));
                let due = self.touches(bodies, at / 2, until).filter(|due| due.time <= known);
                if let Some(due) = due.filter(|due| best.is_none_or(|best| *due > best)) {
                    lane = self.lane(bodies, i, (self.clock, due.time));
                    best = Some(due);
                }
            }
            at = link.next;
        }
        (self.looks[i].lane, self.looks[i].next) = (lane, best.map_or(f64::INFINITY, |due| due.time));
        self.calendar.replace(i, best);
    }

    /// When a pair touches, on the ways that its bodies are on now; nobody asks for what comes after `until`, s.
    fn touches(&mut self, bodies: &Bodies, pair: u32, until: f64) -> Option<Due> {
        let of = &self.pairs[pair as usize];
        let Pair { a, b, restitution, passed, hits } = *of;
        let (a, b, ways) = (a as usize, b as usize, self.ways_of(of));
        if passed == ways {
            return None;
        }
        let (of_a, of_b) = (&self.looks[a], &self.looks[b]);
        let now = if of_a.departure >= of_b.departure { of_a.since } else { of_b.since };
        let left = until.min(self.dt) - now;
        let reach = [bodies.hx[a] + bodies.hx[b], bodies.hy[a] + bodies.hy[b]];
        let (mine, other) = (&self.courses[a], &self.courses[b]);
        let mut motion = [[0.0; 4]; 2];
        for (axis, motion) in motion.iter_mut().enumerate() {
            let (of_a, of_b) = (&mine[axis], &other[axis]);
            let apart = of_b.place(now) - of_a.place(now);
            let side = if apart < 0.0 { -1.0 } else { 1.0 };
            let gap = apart * side - reach[axis];
            let (closing, pull) = ((of_a.speed(now) - of_b.speed(now)) * side, (of_a.pull - of_b.pull) * side);
            // Too far to touch in what is left.
            if gap > (closing.max(0.0) + 0.5 * pull.max(0.0) * left) * left + self.touch {
                return None;
            }
            *motion = [gap, closing, pull, side];
        }
        if motion.iter().all(|[_, closing, pull, _]| *closing == 0.0 && *pull == 0.0) {
            return None;
        }
        let mut best: Option<Due> = None;
        for axis in 0..2 {
            let [gap, closing, pull, side] = motion[axis];
            if gap < -self.touch && !has_sunk(bodies, (a, b), (gap, motion[1 - axis][0]), closing * (self.dt - now)) {
                continue;
            }
            let Some((after, speed)) = time_of_impact(if gap > self.hair { gap } else { 0.0 }, closing, pull) else { continue };
            let time = now + after;
            if time >= self.dt || best.is_some_and(|best| best.time <= time) {
                continue;
            }
            let (across_a, across_b) = (&self.courses[a][1 - axis], &self.courses[b][1 - axis]);
            let beside = (across_b.place(time) - across_a.place(time)).abs() - reach[1 - axis];
            let open = b >= bodies.len() && !bodies.sides[b].face(axis, side < 0.0);
            if beside >= -self.touch || open {
                continue;
            }
            let ends = restitution < 1.0 && (restitution * speed < self.rest_speed || hits >= RATTLE);
            if speed <= SLOWEST || ends {
                self.ends = true;
                continue;
            }
            best = Some(Due { time, speed, pair, ways, axis });
        }
        best
    }
}

/// Whether a body that is this deep in a surface that stands (m, negative; and so along the other axis) has come into it through the face of
/// this axis, and would go through it on its `way`, m: what is hit while its bounces are passed over may be a little below where it bounces.
fn has_sunk(bodies: &Bodies, (body, surface): (usize, usize), (gap, other): (f64, f64), way: f64) -> bool {
    let stands = surface >= bodies.len() && bodies.vx[surface] == 0.0 && bodies.vy[surface] == 0.0;
    let little = SUNK * bodies.hx[body].min(bodies.hy[body]);
    stands && gap > other && gap > -little && way > little
}
