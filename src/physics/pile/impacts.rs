//! Impacts with restitution: one pair after the other, in the order of their times.
//!
//! Before the step is solved as a whole, pairs that bounce are followed through it on their parabolas: the time of impact of two faces is
//! the root of a quadratic, and the closing speed w is the one at that time. A pair leaves with e·w (e is the larger restitution of the
//! two), by an impulse that is shared by mass; simultaneous impacts come fastest first, which carries one block's motion through a
//! touching row to the last one (Newton's cradle). Friction changes the sliding by at most μ_k times the impulse and never reverses it.
//! What rests on the ground is ground for what falls on it.
//!
//! On something immovable the bounces of e < 1 have a sum: once all of them end within the step, the body stays; where many would come,
//! as many whole ones as fit are passed over in closed form. What is left after [`Impacts::budget`] impacts is left to the plastic solution.

use super::bodies::Bodies;
use super::contacts::Contacts;
use super::dense::StepSize;
use super::gravity::Anchors;
use super::islands::Island;
use super::neighbours::Neighbours;
use super::reach::Reach;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Impacts slower than this are none, m/s. Smaller: rounding bounces.
const SLOWEST: f64 = 1e-9;
/// A bounce this part of what is left of the step long, or shorter, is passed over with those that follow.
const SHORT: f64 = 0.25;

/// A pair of e < 1 that has bounced so often in one step is left to the plastic solution: such series have a sum. Fewer: bounces end
/// early; more: inelastic collapse costs the whole budget.
const RATTLE: u32 = 12;

/// The direction of a contact's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Left and right.
    Across,
    /// Up and down.
    Gravity,
}

/// One impact, by slots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Impact {
    pub a: u32,
    pub b: u32,
    pub axis: Axis,
    /// Closing speed when touching, m/s; 0: no impact, but what lasted until one.
    pub speed: f64,
    /// Impulse on `a` along the axis and along the other one, N·s.
    pub normal: f64,
    pub friction: f64,
    /// Middle of the contact, m.
    pub point: (f64, f64),
}

#[derive(Clone, Copy, Debug)]
struct Pair {
    a: u32,
    b: u32,
    restitution: f64,
    /// Counts how often its bodies were hit: what was due before is void.
    version: u32,
    /// How often it has bounced.
    hits: u32,
}

/// A pair will touch.
#[derive(Clone, Copy, Debug)]
struct Due {
    time: f64,
    speed: f64,
    pair: u32,
    version: u32,
    axis: usize,
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

/// The motion of one body along one axis: at the step's start as if it had never been hit, and its acceleration.
#[derive(Clone, Copy, Debug, Default)]
struct Course {
    at: f64,
    velocity: f64,
    pull: f64,
}

impl Course {
    fn place(&self, t: f64) -> f64 {
        self.at + (self.velocity + 0.5 * self.pull * t) * t
    }

    fn speed(&self, t: f64) -> f64 {
        self.velocity + self.pull * t
    }
}

/// Where bodies may be thrown.
pub(super) struct Around<'a> {
    pub island: Island<'a>,
    pub neighbours: &'a mut Neighbours,
    pub reach: &'a mut Reach,
    /// Whether islands may not grow any more.
    pub last: bool,
}

/// The impacts of one island, and what it takes to find them.
#[derive(Clone, Debug, Default)]
pub(super) struct Impacts {
    /// Those of this step, in their order.
    pub all: Vec<Impact>,
    /// Those that did not bounce: pair, axis, closing speed, m/s.
    pub plastic: Vec<(u32, u32, Axis, f64)>,
    /// What hit each body from above, N·s, by slot.
    pub struck: Vec<f64>,
    /// Whether any were looked for in this step.
    pub any: bool,
    /// By slot, where there were any: free velocities before them, and predicted positions after them.
    saved: Vec<[f64; 2]>,
    predicted: Vec<[f64; 2]>,
    /// By slot: the count of the follow-up in which a body was hit last.
    hit_in: Vec<u64>,
    follow_ups: u64,
    pairs: Vec<Pair>,
    /// By slot: whether a body or surface stands still if it is not hit; and how many pairs were skipped because both do.
    still: Vec<bool>,
    skipped: usize,
    /// The pairs of each body, by slot: a chain of links 2·pair (as its first) and 2·pair + 1 (as its second).
    chain: Vec<u32>,
    next: Vec<u32>,
    courses: [Vec<Course>; 2],
    due: BinaryHeap<Due>,
    dt: f64,
    rest_speed: f64,
    touch: f64,
    hair: f64,
}

const NONE: u32 = u32::MAX;

impl Impacts {
    pub fn new(count: usize, all: usize) -> Self {
        Self {
            all: Vec::with_capacity(count),
            struck: vec![0.0; all],
            saved: vec![[0.0; 2]; count],
            predicted: vec![[0.0; 2]; count],
            hit_in: vec![0; count],
            pairs: Vec::with_capacity(4 * count),
            still: vec![false; all],
            chain: vec![NONE; all],
            next: Vec::with_capacity(8 * count),
            courses: [vec![Course::default(); all], vec![Course::default(); all]],
            due: BinaryHeap::with_capacity(4 * count),
            ..Self::default()
        }
    }

    /// Follows the impacts of an island; sets predicted positions and free velocities to what they leave. Returns whether any were looked
    /// for, and whether the budget ran out.
    pub fn follow(
        &mut self,
        bodies: &mut Bodies,
        (contacts, anchors): (&Contacts, &Anchors),
        around: &mut Around<'_>,
        size: StepSize,
    ) -> (bool, bool) {
        (self.dt, self.rest_speed) = (size.dt, size.rest_speed);
        let island = around.island;
        (self.touch, self.hair) = (contacts.tolerances.touch, contacts.tolerances.hair);
        self.all.clear();
        self.any = false;
        for &i in island.members {
            self.struck[i as usize] = 0.0;
        }
        if !bodies.lively || !self.any_due(bodies, island, contacts) {
            return (false, false);
        }
        self.gather(bodies, island, anchors);
        self.follow_ups += 1;
        for pair in 0..self.pairs.len() {
            self.look(bodies, pair, 0.0);
        }
        let (mut left, mut exhausted) = (self.budget(), false);
        while let Some(due) = self.due.pop() {
            if self.pairs[due.pair as usize].version != due.version {
                continue;
            }
            if left == 0 {
                exhausted = true;
                break;
            }
            left -= 1;
            self.bounce(bodies, anchors, around, due);
        }
        self.any = true;
        for &i in island.members {
            self.predicted[i as usize] = [bodies.px[i as usize], bodies.py[i as usize]];
        }
        (true, exhausted)
    }

    /// Where a body is predicted, after impacts.
    pub fn predicted(&self, bodies: &Bodies, i: usize) -> (f64, f64) {
        if self.any { self.predicted[i].into() } else { (bodies.free_x[i], bodies.free_y[i]) }
    }

    /// As if nothing had been solved.
    pub fn undo(&mut self, bodies: &mut Bodies, members: &[u32]) {
        for &i in members {
            let i = i as usize;
            (bodies.px[i], bodies.py[i]) = (bodies.free_x[i], bodies.free_y[i]);
        }
        self.restore_free(bodies, members);
        self.all.clear();
        self.any = false;
    }

    /// Whether a body was hit when impacts were followed last.
    pub fn was_hit(&self, i: usize) -> bool {
        self.hit_in[i] == self.follow_ups
    }

    /// Sets the free velocities to what they were before the impacts.
    pub fn restore_free(&mut self, bodies: &mut Bodies, members: &[u32]) {
        if self.any {
            for &i in members {
                (bodies.free_vx[i as usize], bodies.free_vy[i as usize]) = self.saved[i as usize].into();
            }
        }
    }

    /// How many impacts one island may have in one step.
    fn budget(&self) -> usize {
        64 + 8 * (self.pairs.len() + self.skipped)
    }

    /// A quick test whether any pair that bounces closes.
    fn any_due(&self, bodies: &Bodies, island: Island<'_>, contacts: &Contacts) -> bool {
        let lively = |a: usize, b: usize| bodies.traits[a].restitution > 0.0 || bodies.traits[b].restitution > 0.0;
        let n = bodies.len();
        let per_second = 1.0 / self.dt;
        let stacks = island.members.iter().any(|&i| {
            let i = i as usize;
            let mean = (bodies.py[i] - bodies.y[i]) * per_second;
            contacts.stacks[contacts.under(i)].iter().any(|stack| {
                let j = stack.below as usize;
                let closes = mean > bodies.mean_vy[j] + stack.bound && (stack.bound > 0.0 || !bodies.rides_along(i, j, 0.0));
                closes && lively(i, j)
            })
        });
        let mean = |i: usize| if i < n { (bodies.px[i] - bodies.x[i]) * per_second } else { bodies.mean_vx[i] };
        stacks
            || contacts.sides.iter().any(|side| {
                let (a, b) = (side.first as usize, side.second as usize);
                let closes = mean(a) > mean(b) + side.bound && (side.bound > 0.0 || bodies.vx[a] != bodies.vx[b]);
                closes && lively(a, b)
            })
            || contacts.ceilings.iter().any(|c| lively(c.first as usize, c.second as usize))
    }

    fn gather(&mut self, bodies: &Bodies, island: Island<'_>, anchors: &Anchors) {
        self.pairs.clear();
        self.next.clear();
        self.due.clear();
        let per_second = 1.0 / self.dt;
        for &i in island.members {
            let i = i as usize;
            self.chain[i] = NONE;
            self.saved[i] = [bodies.free_vx[i], bodies.free_vy[i]];
            let pull = |free: f64, v: f64| (free - v) * per_second;
            self.courses[0][i] = Course { at: bodies.x[i], velocity: bodies.vx[i], pull: pull(bodies.free_vx[i], bodies.vx[i]) };
            let pull = if anchors.rests[i] { 0.0 } else { pull(bodies.free_vy[i], bodies.vy[i]) };
            let velocity = if anchors.rests[i] { bodies.uy[i] } else { bodies.vy[i] };
            self.courses[1][i] = Course { at: bodies.y[i], velocity, pull };
            let stands = |course: &Course| course.velocity == 0.0 && course.pull == 0.0;
            self.still[i] = stands(&self.courses[0][i]) && stands(&self.courses[1][i]);
        }
        self.skipped = 0;
        for &i in island.members {
            for &j in island.near(i) {
                if self.stand(bodies, i, j) {
                    self.skipped += 1;
                } else {
                    self.add(bodies, i, j);
                }
            }
        }
    }

    /// Whether both of a pair stand still if nothing hits them.
    fn stand(&self, bodies: &Bodies, i: u32, j: u32) -> bool {
        let (i, j) = (i as usize, j as usize);
        self.still[i] && if j < bodies.len() { self.still[j] } else { bodies.vx[j] == 0.0 && bodies.vy[j] == 0.0 }
    }

    /// Adds the pairs that were skipped: something that stood still was hit.
    fn add_skipped(&mut self, bodies: &Bodies, island: Island<'_>) {
        self.skipped = 0;
        for &i in island.members {
            if self.still[i as usize] {
                for &j in island.near(i) {
                    if self.stand(bodies, i, j) {
                        self.add(bodies, i, j);
                    }
                }
            }
        }
    }

    /// Adds a pair if it bounces.
    fn add(&mut self, bodies: &Bodies, i: u32, j: u32) {
        let (a, b) = (i as usize, j as usize);
        let restitution = bodies.traits[a].restitution.max(bodies.traits[b].restitution);
        if restitution == 0.0 {
            return;
        }
        let pair = self.pairs.len() as u32;
        self.pairs.push(Pair { a: i, b: j, restitution, version: 0, hits: 0 });
        self.next.extend([self.chain[a], NONE]);
        self.chain[a] = 2 * pair;
        if b < bodies.len() {
            self.next[2 * pair as usize + 1] = self.chain[b];
            self.chain[b] = 2 * pair + 1;
        } else {
            self.courses[0][b] = Course { at: bodies.x[b], velocity: bodies.vx[b], pull: 0.0 };
            self.courses[1][b] = Course { at: bodies.y[b], velocity: bodies.vy[b], pull: 0.0 };
        }
    }

    /// Finds when a pair touches next, from `now` on.
    fn look(&mut self, bodies: &Bodies, pair: usize, now: f64) {
        let Pair { a, b, restitution, version, hits } = self.pairs[pair];
        if restitution < 1.0 && hits >= RATTLE {
            return;
        }
        let (a, b) = (a as usize, b as usize);
        let alike = |of: &[Course]| (of[a].velocity == of[b].velocity) & (of[a].pull == of[b].pull);
        if alike(&self.courses[0]) && alike(&self.courses[1]) {
            return;
        }
        let reach = [bodies.hx[a] + bodies.hx[b], bodies.hy[a] + bodies.hy[b]];
        let mut best: Option<Due> = None;
        for axis in 0..2 {
            let (of_a, of_b) = (&self.courses[axis][a], &self.courses[axis][b]);
            let d = of_b.place(now) - of_a.place(now);
            let side = if d < 0.0 { -1.0 } else { 1.0 };
            let gap = d * side - reach[axis];
            if gap < -self.touch {
                continue;
            }
            let closing = (of_a.speed(now) - of_b.speed(now)) * side;
            let pull = (of_a.pull - of_b.pull) * side;
            let Some((after, speed)) = time_of_impact(if gap > self.hair { gap } else { 0.0 }, closing, pull) else { continue };
            let time = now + after;
            let ends = restitution < 1.0 && restitution * speed < self.rest_speed;
            if time >= self.dt || speed <= SLOWEST || ends || best.is_some_and(|best| best.time <= time) {
                continue;
            }
            let (across_a, across_b) = (&self.courses[1 - axis][a], &self.courses[1 - axis][b]);
            let beside = (across_b.place(time) - across_a.place(time)).abs() - reach[1 - axis];
            let open = b >= bodies.len() && !bodies.sides[b].face(axis, side < 0.0);
            if beside < -self.touch && !open {
                best = Some(Due { time, speed, pair: pair as u32, version, axis });
            }
        }
        if let Some(due) = best {
            self.due.push(due);
        }
    }

    /// One impact.
    fn bounce(&mut self, bodies: &mut Bodies, anchors: &Anchors, around: &mut Around<'_>, due: Due) {
        let n = bodies.len();
        let Due { time, speed, axis, .. } = due;
        let Pair { a, b, restitution, .. } = self.pairs[due.pair as usize];
        let (a, b) = (a as usize, b as usize);
        let (of_a, of_b) = (self.courses[axis][a], self.courses[axis][b]);
        let (at_a, at_b) = (of_a.place(time), of_b.place(time));
        let side = if at_b < at_a { -1.0 } else { 1.0 };
        // What rests is ground for what falls on it.
        let courses = &self.courses[1];
        let is_held = |i: usize| axis == 1 && i < n && anchors.rests[i] && courses[i].velocity == bodies.uy[i];
        let (a_rests, b_rests) = (is_held(a), is_held(b));
        let held = |upper: usize, rests: bool, falls: bool| falls && upper < n && rests;
        let share = |i: usize, fixed: bool| if i < n && !fixed { 1.0 / bodies.mass[i] } else { 0.0 };
        let (share_a, share_b) = (share(a, held(b, a_rests, side < 0.0)), share(b, held(a, b_rests, side > 0.0)));
        if share_a + share_b == 0.0 {
            return;
        }
        self.pairs[due.pair as usize].hits += 1;
        let (until, leaves) = self.pass_over(due, restitution, share_a == 0.0 || share_b == 0.0);
        // Relative velocity after, and what it takes.
        let change = speed + leaves;
        let impulse = change / (share_a + share_b);
        let before = [of_a.speed(time), of_b.speed(time)];
        let after = if share_b == 0.0 {
            [before[1] - side * leaves, before[1]]
        } else if share_a == 0.0 {
            [before[0], before[0] + side * leaves]
        } else {
            [before[0] - side * impulse * share_a, before[1] + side * impulse * share_b]
        };
        let rub = self.rub(bodies, due, side, impulse);
        let stirs = |i: usize, share: f64| i < n && self.still[i] && (share > 0.0 || rub != 0.0);
        if self.skipped > 0 && (stirs(a, share_a) || stirs(b, share_b)) {
            self.add_skipped(bodies, around.island);
        }
        for (i, share, rests) in [(a, share_a, a_rests), (b, share_b, b_rests)] {
            if share > 0.0 && rests {
                // Thrown off what carried it.
                let pull = (bodies.free_vy[i] - bodies.vy[i]) / self.dt;
                self.courses[1][i] = Course { at: bodies.y[i], velocity: bodies.vy[i], pull };
                self.note_carried(bodies, i, anchors.on[i], pull * time);
            }
        }
        if share_a > 0.0 {
            let carried = if share_b == 0.0 { of_b.velocity * (until - time) } else { 0.0 };
            self.set(bodies, a, axis, until, (at_a + carried, after[0]));
        }
        if share_b > 0.0 {
            let carried = if share_a == 0.0 { of_a.velocity * (until - time) } else { 0.0 };
            self.set(bodies, b, axis, until, (at_b + carried, after[1]));
        }
        for (i, rub) in [(a, rub), (b, -rub)] {
            if rub != 0.0 && i < n {
                let course = self.courses[1 - axis][i];
                self.set(bodies, i, 1 - axis, time, (course.place(time), course.speed(time) + rub / bodies.mass[i]));
            }
        }
        // Over whole bounces gravity has been answered too.
        let pulled = (of_a.pull - of_b.pull) * side * (until - time) / (share_a + share_b);
        let normal = -side * (impulse + pulled);
        if axis == 1 {
            for (i, share) in [(a, share_a), (b, share_b)] {
                if share == 0.0 && i < n {
                    self.struck[i] += normal.abs();
                }
            }
        }
        self.note(bodies, due, (normal, rub), side);
        for i in [a, b] {
            if i < n {
                if !bodies.is_swept(i) {
                    self.widen(bodies, around, i);
                }
                self.look_again(bodies, i, time.max(until));
            }
        }
    }

    /// Adds the pairs of a body that was thrown further than contacts were looked for.
    fn widen(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, i: usize) {
        around.reach.widen(bodies, around.neighbours, around.island, i, around.last);
        for &(a, b) in &around.reach.new {
            self.add(bodies, a, b);
        }
    }

    /// When the bounces that are passed over end, and how fast the pair parts then.
    fn pass_over(&self, due: Due, restitution: f64, fixed: bool) -> (f64, f64) {
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let (of_a, of_b) = (&self.courses[due.axis][a as usize], &self.courses[due.axis][b as usize]);
        let side = if of_b.place(due.time) < of_a.place(due.time) { -1.0 } else { 1.0 };
        let (pull, leaves, left) = ((of_a.pull - of_b.pull) * side, restitution * due.speed, self.dt - due.time);
        if !fixed || pull <= 0.0 {
            return (due.time, leaves);
        }
        let first = 2.0 * leaves / pull;
        if restitution < 1.0 && first <= left * (1.0 - restitution) {
            return (due.time, 0.0);
        }
        if first > SHORT * left {
            return (due.time, leaves);
        }
        if restitution >= 1.0 {
            return ((due.time + (left / first).floor() * first).min(self.dt), leaves);
        }
        // n bounces take first·(1 − eⁿ)/(1 − e).
        let count = (libm::log1p(-left * (1.0 - restitution) / first) / libm::log(restitution)).floor();
        let slower = libm::pow(restitution, count);
        ((due.time + first * (1.0 - slower) / (1.0 - restitution)).min(self.dt), leaves * slower)
    }

    /// Friction's impulse on the first of the pair, N·s.
    fn rub(&self, bodies: &Bodies, due: Due, side: f64, impulse: f64) -> f64 {
        let n = bodies.len();
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let (a, b) = (a as usize, b as usize);
        let across = &self.courses[1 - due.axis];
        let sliding = across[a].speed(due.time) - across[b].speed(due.time) - bodies.skin(b, due.axis, side < 0.0);
        let kinetic = |i: usize| bodies.traits[i].kinetic_friction;
        let coefficient = if b < n { kinetic(a).min(kinetic(b)) } else { kinetic(b) };
        let mass = 1.0 / (1.0 / bodies.mass[a] + if b < n { 1.0 / bodies.mass[b] } else { 0.0 });
        -(coefficient * impulse).min(sliding.abs() * mass).copysign(sliding) * if sliding == 0.0 { 0.0 } else { 1.0 }
    }

    /// From `time` on, body i moves on from a place with a velocity.
    fn set(&mut self, bodies: &mut Bodies, i: usize, axis: usize, time: f64, (place, speed): (f64, f64)) {
        let dt = self.dt;
        self.hit_in[i] = self.follow_ups;
        let course = &mut self.courses[axis][i];
        let old = *course;
        if bodies.drag_wide[i] + bodies.drag_tall[i] > 0.0 {
            let outer = if axis == 0 { bodies.ax[i] } else { bodies.ay[i] };
            course.pull = outer + slowed(old.pull - outer, old.speed(time), speed, dt - time);
        }
        course.velocity = speed - course.pull * time;
        course.at = place - (course.velocity + 0.5 * course.pull * time) * time;
        let (p, free) = if axis == 0 { (&mut bodies.px, &mut bodies.free_vx) } else { (&mut bodies.py, &mut bodies.free_vy) };
        let pulled = course.pull - old.pull;
        p[i] += (course.at - old.at) + (course.velocity - old.velocity + 0.5 * pulled * dt) * dt;
        free[i] += course.velocity - old.velocity + pulled * dt;
    }

    fn note(&mut self, bodies: &Bodies, due: Due, (normal, friction): (f64, f64), side: f64) {
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let axis = if due.axis == 0 { Axis::Across } else { Axis::Gravity };
        let place = |axis: usize, i: u32| self.courses[axis][i as usize].place(due.time);
        let half = |axis: usize, i: u32| if axis == 0 { bodies.hx[i as usize] } else { bodies.hy[i as usize] };
        let other = 1 - due.axis;
        let low = (place(other, a) - half(other, a)).max(place(other, b) - half(other, b));
        let high = (place(other, a) + half(other, a)).min(place(other, b) + half(other, b));
        let (on, along) = (place(due.axis, a) + side * half(due.axis, a), 0.5 * (low + high));
        let point = if due.axis == 0 { (on, along) } else { (along, on) };
        self.all.push(Impact { a, b, axis, speed: due.speed, normal, friction, point });
    }

    /// Until a hit threw it off, what carried body i has given it this change of velocity, and taken what struck it from above.
    fn note_carried(&mut self, bodies: &Bodies, i: usize, on: u32, change: f64) {
        let impulse = bodies.mass[i] * change + std::mem::take(&mut self.struck[i]);
        if on == NONE || impulse == 0.0 {
            return;
        }
        if (on as usize) < bodies.len() {
            self.struck[on as usize] += impulse;
        }
        let point = (bodies.x[i], bodies.y[i] + bodies.hy[i]);
        self.all.push(Impact { a: i as u32, b: on, axis: Axis::Gravity, speed: 0.0, normal: -impulse, friction: 0.0, point });
    }

    /// Looks at all pairs of a body that has been hit.
    fn look_again(&mut self, bodies: &Bodies, i: usize, now: f64) {
        let mut at = self.chain[i];
        while at != NONE {
            let pair = at as usize / 2;
            self.pairs[pair].version += 1;
            self.look(bodies, pair, now);
            at = self.next[at as usize];
        }
    }
}

/// The acceleration by drag after a hit, m/s²: it was `drag` at a velocity `before`, grows with the square, acts against the motion,
/// and does not turn it round in the time `left`.
fn slowed(drag: f64, before: f64, after: f64, left: f64) -> f64 {
    let part = if before == 0.0 { 0.0 } else { after / before };
    let most = if left > 0.0 { after.abs() / left } else { 0.0 };
    -(drag * part * part).abs().min(most).copysign(after)
}

/// When a gap closes, s from now, and how fast it closes then, m/s: `closing` now, growing by `pull` a second.
fn time_of_impact(gap: f64, closing: f64, pull: f64) -> Option<(f64, f64)> {
    let square = closing * closing + 2.0 * pull * gap;
    if square <= 0.0 {
        return None;
    }
    let speed = square.sqrt();
    if closing > 0.0 {
        return Some((2.0 * gap / (closing + speed), speed));
    }
    (pull > 0.0).then(|| ((speed - closing) / pull, speed))
}

#[cfg(test)]
mod tests {
    use super::time_of_impact;

    #[test]
    fn gaps_close_when_the_parabola_says_so() {
        assert_eq!(time_of_impact(1.0, 1.0, 0.0), Some((1.0, 1.0)));
        assert_eq!(time_of_impact(0.0, 3.0, 10.0), Some((0.0, 3.0)));
        assert_eq!(time_of_impact(0.0, -3.0, 10.0), Some((0.6, 3.0)));
        assert_eq!(time_of_impact(1.25, 0.0, 10.0), Some((0.5, 5.0)));
        assert_eq!(time_of_impact(1.0, 1.0, -10.0), None);
        assert_eq!(time_of_impact(1.0, -1.0, 0.0), None);
    }
}
