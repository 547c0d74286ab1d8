//! Impacts with restitution: one pair after the other, in the order of their times.
//!
//! Before the step is solved as a whole, pairs that bounce are followed through it on their parabolas: the time of impact of two faces is
//! the root of a quadratic, and the closing speed w is the one at that time. A pair leaves with e·w (e is the larger restitution of the
//! two), by an impulse that is shared by mass; simultaneous impacts come fastest first, which carries one block's motion through a
//! touching row to the last one (Newton's cradle). Friction changes the sliding by at most μ_k times the impulse and never reverses it.
//! What rests on the ground is ground for what falls on it.
//!
//! On something immovable the bounces of e < 1 have a sum: once all of them end within the step, the body stays; where many would come,
//! as many whole ones as fit are passed over in closed form.
//!
//! All of it is counted. Once half of an island's budget is used up, who has bounced often *waits* instead of bouncing again: it stays where
//! it is until the step ends and keeps its velocity, and so does who comes upon it. Once all of it is used up, everybody who is to bounce
//! does. Waiting takes no momentum and no energy, and nothing gets into anything; what it takes is time, from those alone, and it is counted.

mod bounce;
mod calendar;
mod course;
mod due;
mod look;

use super::bodies::Bodies;
use super::contacts::{Contacts, Tolerances};
use super::dense::StepSize;
use super::gravity::Anchors;
use super::islands::Island;
use super::neighbours::Neighbours;
use super::reach::Reach;
use calendar::Calendar;
use course::Course;
use due::{Due, Link, Looked, Pair};

/// Impacts slower than this are none, m/s. Smaller: rounding bounces.
pub(super) const SLOWEST: f64 = 1e-9;
/// A pair of e < 1 that has bounced so often in one step is left to the plastic solution: such series have a sum. Fewer: bounces end
/// early; more: inelastic collapse costs the whole budget.
const RATTLE: u32 = 12;
/// What the impacts of an island may take in a step, and what each of its bodies adds, in units of work. Larger: a hot gas costs more; smaller:
/// bodies wait where fewer impacts fall into one step.
const BUDGET: u64 = 20_000;
const BUDGET_OF_A_BODY: u64 = 300;
/// The same of a gas that has time for it.
const BUDGET_OF_A_GAS: u64 = 200_000;
/// What the budget of an island, a gas or not, is at most, for each of its bodies. Larger: many islands of few bodies cost more; smaller: these
/// wait where those of a larger one would not.
const BUDGET_OF_FEW: u64 = 6_000;
/// Once half of the budget is used up, who has been hit so often waits. Fewer: what is hit seldom loses time; more: what is hit often takes
/// the other half too.
const OFTEN: u32 = 4;
/// Units of work, about a nanosecond each: a pair looked at, when it touches, and an impact without that.
const WORK_OF_A_LINK: u64 = 2;
const WORK_OF_A_LOOK: u64 = 10;
const WORK_OF_AN_IMPACT: u64 = 150;

/// Air that leaves less than this part of the speed may be too strong for a parabola: [`Course::to`] decides. Smaller: what it stops is sought
/// where it does not get; larger: the same is asked where it is known.
const BRAKED: f64 = 0.5;

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
    /// Who was taken for ground and would have been moved: then the impacts are not followed to the end.
    pub stirred: Vec<u32>,
    /// Whether some that touch, or will, do not bounce, or bounce without being followed: that is left to the plastic solution.
    ends: bool,
    /// By slot, where there were any: free velocities before them, and predicted positions after them.
    saved: Vec<[f64; 2]>,
    predicted: Vec<[f64; 2]>,
    /// By slot: the count of the follow-up in which a body was hit last, and of that in which its way was noted last.
    hit_in: Vec<u64>,
    entered_in: Vec<u64>,
    follow_ups: u64,
    pairs: Vec<Pair>,
    /// By slot: whether a body or surface stands still if it is not hit; and how many pairs were skipped because both do.
    still: Vec<bool>,
    skipped: usize,
    /// By slot: how often a body has been hit in this step, and whether it waits for its end; and how many do.
    hits: Vec<u32>,
    waits: Vec<bool>,
    pub waiting: u64,
    /// What impacts have taken since the start, in units of work.
    pub work: u64,
    /// What they may take in this step, in units of work.
    allowed: u64,
    /// The pairs of each body, by slot: a chain of links 2·pair (as its first) and 2·pair + 1 (as its second).
    chain: Vec<u32>,
    links: Vec<Link>,
    /// What each body does next, by slot; of surfaces only where they are.
    looks: Vec<Looked>,
    /// The time up to which impacts have been followed, s, and how often somebody set out on another way.
    clock: f64,
    departures: u32,
    courses: Vec<[Course; 2]>,
    calendar: Calendar,
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
            entered_in: vec![0; count],
            pairs: Vec::with_capacity(4 * count),
            still: vec![false; all],
            hits: vec![0; count],
            waits: vec![false; count],
            chain: vec![NONE; all],
            links: Vec::with_capacity(8 * count),
            looks: vec![Looked::default(); all],
            courses: vec![[Course::default(); 2]; all],
            calendar: Calendar::new(count),
            ..Self::default()
        }
    }

    /// Follows the impacts of an island; sets predicted positions and free velocities to what they leave. Returns whether any were looked
    /// for.
    pub fn follow(
        &mut self,
        bodies: &mut Bodies,
        (contacts, anchors): (&Contacts, &Anchors),
        around: &mut Around<'_>,
        size: StepSize,
    ) -> bool {
        self.begin(&contacts.tolerances, around.island, size);
        let any = bodies.lively && self.any_due(bodies, around.island, (contacts, anchors));
        if any {
            self.follow_each(bodies, anchors, around, false);
        }
        any
    }

    /// The same for a gas, in which nothing lies and all pairs bounce: none of them has to be a contact. Returns false as soon as
    /// something is left to the plastic solution.
    pub fn follow_alone(
        &mut self,
        bodies: &mut Bodies,
        (contacts, anchors): (&Contacts, &Anchors),
        around: &mut Around<'_>,
        size: StepSize,
    ) -> bool {
        self.begin(&contacts.tolerances, around.island, size);
        self.follow_each(bodies, anchors, around, true)
    }

    fn begin(&mut self, tolerances: &Tolerances, island: Island<'_>, size: StepSize) {
        (self.dt, self.rest_speed) = (size.dt, size.rest_speed);
        let (budget, count) = (if size.gas { BUDGET_OF_A_GAS } else { BUDGET }, island.all.len() as u64);
        self.allowed = budget.min(BUDGET_OF_FEW * count) + BUDGET_OF_A_BODY * count;
        (self.touch, self.hair) = (tolerances.touch, tolerances.hair);
        self.all.clear();
        self.any = false;
        for &i in island.members {
            self.struck[i as usize] = 0.0;
        }
    }

    /// Follows one impact after the other; `alone`: until one is left to the plastic solution. Returns whether none was.
    fn follow_each(&mut self, bodies: &mut Bodies, anchors: &Anchors, around: &mut Around<'_>, alone: bool) -> bool {
        let island = around.island;
        self.follow_ups += 1;
        self.ends = false;
        self.gather(bodies, island, anchors, &around.reach.added);
        let most = self.work + self.allowed;
        while let Some((by, due)) = self.calendar.first() {
            if alone && self.ends {
                break;
            }
            if self.is_next(bodies, around, by, &due) {
                self.go_on(bodies, anchors, around, (due, most));
                if !self.stirred.is_empty() {
                    break;
                }
                self.pass(bodies, around, by, &due);
            }
        }
        self.any = true;
        for &i in island.members {
            self.predicted[i as usize] = [bodies.px[i as usize], bodies.py[i as usize]];
        }
        !self.ends
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

    /// How fast a body was across when the step began, or would have been to have now what impacts gave it, m/s.
    pub fn began_across(&self, bodies: &Bodies, i: usize) -> f64 {
        match self.any && self.was_hit(i) {
            true if self.waits[i] => bodies.free_vx[i],
            true => self.courses[i][0].velocity,
            false => bodies.vx[i],
        }
    }

    /// The free velocity of a body before impacts, m/s.
    pub fn free_before(&self, bodies: &Bodies, i: usize) -> [f64; 2] {
        let saved = self.any && self.entered_in[i] == self.follow_ups;
        if saved { self.saved[i] } else { [bodies.free_vx[i], bodies.free_vy[i]] }
    }

    /// Whether a body was hit when impacts were followed last.
    pub fn was_hit(&self, i: usize) -> bool {
        self.hit_in[i] == self.follow_ups
    }

    /// Sets the free velocities to what they were before the impacts.
    pub fn restore_free(&mut self, bodies: &mut Bodies, members: &[u32]) {
        if self.any {
            for i in members.iter().map(|i| *i as usize).filter(|i| self.entered_in[*i] == self.follow_ups) {
                (bodies.free_vx[i], bodies.free_vy[i]) = self.saved[i].into();
            }
        }
    }

    /// What becomes of a pair that touches: it bounces, or one of the two waits. `most` is how far the work may go.
    fn go_on(&mut self, bodies: &mut Bodies, anchors: &Anchors, around: &mut Around<'_>, (due, most): (Due, u64)) {
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let (a, b, n) = (a as usize, b as usize, bodies.len());
        let left = most.saturating_sub(self.work);
        if self.waits[a] && b >= n {
            // What moves comes upon what waits.
            if left == 0 {
                return;
            }
            self.go_along(bodies, a, due.time);
            let (of_a, of_b) = (&self.courses[a][due.axis], &self.courses[b][due.axis]);
            let side = if of_b.place(due.time) < of_a.place(due.time) { -1.0 } else { 1.0 };
            let speed = (of_a.speed(due.time) - of_b.speed(due.time)) * side;
            self.work += WORK_OF_AN_IMPACT;
            if speed > SLOWEST {
                return self.bounce(bodies, anchors, around, Due { speed, ..due });
            }
            return self.leave(bodies, around, a, due.time);
        } else if self.waits[a] {
            return self.put_off(bodies, around, b, due.time);
        } else if b < n && self.waits[b] {
            return self.put_off(bodies, around, a, due.time);
        } else {
            let hits = |i: usize| self.hits[i];
            let first = b >= n || (hits(a), bodies.mass[b]) >= (hits(b), bodies.mass[a]);
            let busier = if first { a } else { b };
            if left == 0 || (2 * left < self.allowed && hits(busier) >= OFTEN) {
                return self.put_off(bodies, around, busier, due.time);
            }
        }
        self.work += WORK_OF_AN_IMPACT;
        self.bounce(bodies, anchors, around, due);
    }

    /// From `time` on, body i stays where it is until the step ends, with the velocity that it has.
    fn put_off(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, i: usize, time: f64) {
        if around.island.is_settled(i) {
            return self.stirred.push(i as u32);
        }
        self.waiting += 1;
        self.waits[i] = true;
        self.hit_in[i] = self.follow_ups;
        for (axis, course) in self.courses[i].iter_mut().enumerate() {
            let (p, free) = if axis == 0 { (&mut bodies.px, &mut bodies.free_vx) } else { (&mut bodies.py, &mut bodies.free_vy) };
            p[i] = course.place(time);
            free[i] += course.speed(time) - course.speed(self.dt);
            *course = Course::straight(p[i], 0.0);
        }
        self.leave(bodies, around, i, time);
    }

    /// From `time` on, body i waits no more: it goes on with the velocity that it has kept, and nothing pulls at it until the step ends.
    fn go_along(&mut self, bodies: &mut Bodies, i: usize, time: f64) {
        self.waits[i] = false;
        for (axis, course) in self.courses[i].iter_mut().enumerate() {
            let (p, kept) = if axis == 0 { (&mut bodies.px, bodies.free_vx[i]) } else { (&mut bodies.py, bodies.free_vy[i]) };
            *course = Course::straight(p[i] - kept * time, kept);
            p[i] += kept * (self.dt - time);
        }
    }

    /// A quick test whether any pair that bounces closes.
    fn any_due(&self, bodies: &Bodies, island: Island<'_>, (contacts, anchors): (&Contacts, &Anchors)) -> bool {
        let lively = |a: usize, b: usize| bodies.traits[a].restitution > 0.0 || bodies.traits[b].restitution > 0.0;
        let n = bodies.len();
        let per_second = 1.0 / self.dt;
        let stacks = island.members.iter().any(|&i| {
            let i = i as usize;
            let mean = if anchors.rests[i] { bodies.mean_vy[i] } else { (bodies.py[i] - bodies.y[i]) * per_second };
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

    fn gather(&mut self, bodies: &Bodies, island: Island<'_>, anchors: &Anchors, added: &[(u32, u32)]) {
        self.pairs.clear();
        self.links.clear();
        self.calendar.clear();
        (self.clock, self.departures) = (0.0, 0);
        for &i in island.members {
            self.enter(bodies, i as usize, anchors);
        }
        if !island.states.is_empty() {
            let near = island.members.iter().flat_map(|i| island.near(*i));
            for &j in near.chain(added.iter().flat_map(|(a, b)| [a, b])) {
                if island.is_settled(j as usize) && self.entered_in[j as usize] != self.follow_ups {
                    self.enter(bodies, j as usize, anchors);
                }
            }
        }
        self.skipped = 0;
        for &i in island.members {
            for &j in island.near(i) {
                if self.stand(bodies, i, j) {
                    self.skipped += 1;
                } else {
                    self.meet(bodies, i, j);
                }
            }
        }
        for &(i, j) in added {
            self.meet(bodies, i, j);
        }
        self.note_first_looks(bodies);
    }

    /// Notes on which way a body sets out.
    fn enter(&mut self, bodies: &Bodies, i: usize, anchors: &Anchors) {
        self.entered_in[i] = self.follow_ups;
        self.calendar.enter(i);
        self.chain[i] = NONE;
        (self.hits[i], self.waits[i]) = (0, false);
        self.saved[i] = [bodies.free_vx[i], bodies.free_vy[i]];
        // Through liquids and streams bodies are led; what the air brakes is on a parabola nearly enough, unless that takes most of its speed.
        let (led, dt) = (bodies.is_guided[bodies.id[i] as usize], self.dt);
        let meets_air = bodies.meets_air(i);
        let course = |at: f64, velocity: f64, end: (f64, f64)| match led || meets_air && end.1.abs() < BRAKED * velocity.abs() {
            true => Course::to(end, (at, velocity), dt),
            false => Course::by((velocity, end.1), at, dt),
        };
        self.courses[i][0] = course(bodies.x[i], bodies.vx[i], (bodies.px[i], bodies.free_vx[i]));
        self.courses[i][1] = match anchors.rests[i] {
            true => Course::straight(bodies.y[i], bodies.uy[i]),
            false => course(bodies.y[i], bodies.vy[i], (bodies.py[i], bodies.free_vy[i])),
        };
        let stands = |course: &Course| course.velocity == 0.0 && course.pull == 0.0;
        self.still[i] = stands(&self.courses[i][0]) && stands(&self.courses[i][1]);
        self.looks[i] = Looked { lane: self.lane(bodies, i, (0.0, self.dt)), next: f64::INFINITY, ..Looked::default() };
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

    /// Adds a pair if it bounces, and looks ahead for it.
    fn meet(&mut self, bodies: &Bodies, i: u32, j: u32) {
        if self.add(bodies, i, j) {
            self.look_first(bodies, i, j);
        }
    }

    /// Adds a pair if it bounces. Returns whether it does.
    fn add(&mut self, bodies: &Bodies, i: u32, j: u32) -> bool {
        let (a, b) = (i as usize, j as usize);
        let restitution = bodies.traits[a].restitution.max(bodies.traits[b].restitution);
        if restitution == 0.0 {
            return false;
        }
        let pair = self.pairs.len() as u32;
        self.pairs.push(Pair { a: i, b: j, restitution, passed: NONE, hits: 0 });
        let of_b = if b < bodies.len() { std::mem::replace(&mut self.chain[b], 2 * pair + 1) } else { NONE };
        self.links.extend([Link { other: j, next: self.chain[a] }, Link { other: i, next: of_b }]);
        self.chain[a] = 2 * pair;
        if b >= bodies.len() {
            self.courses[b][0] = Course::straight(bodies.x[b], bodies.vx[b]);
            self.courses[b][1] = Course::straight(bodies.y[b], bodies.vy[b]);
            self.looks[b] = Looked { lane: self.lane(bodies, b, (0.0, self.dt)), ..Looked::default() };
        }
        true
    }
}
