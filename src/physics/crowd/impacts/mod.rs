//! Impacts with restitution: one pair after the other, in the order of their times.
//!
//! Before the step is solved as a whole, pairs that bounce are followed through it on their parabolas: the time of impact of two faces is
//! the root of a quadratic, and the closing speed w is the one at that time. A pair leaves with e·w (e is the larger restitution of the
//! two), by an impulse that is shared by mass; simultaneous impacts come fastest first, which carries one block's motion through a
//! touching row to the last one (Newton's cradle). Friction changes the sliding by at most μ_k times the impulse and never reverses it.
//! A body that rests on the ground is ground for the one that falls on it. A body that a medium brakes within the step does not bounce.
//!
//! On something immovable the bounces of e < 1 have a sum: once all of them end within the step, the body stays; where many would come,
//! as many whole ones as fit are passed over in closed form.
//!
//! A body that has been hit [`MOST_HITS`] times *waits* instead of bouncing again: it stays where it is until the step ends and keeps its
//! velocity, and so does a body that comes upon it. Waiting takes no momentum and no energy, but time from those bodies; it is counted.

pub(crate) mod bounce;
pub(crate) mod course;
pub(crate) mod look;

use crate::physics::crowd::contacts::Contacts;
use crate::physics::crowd::dense::StepSize;
use crate::physics::crowd::gravity::Anchors;
use crate::physics::crowd::impacts::course::Course;
use crate::physics::crowd::impacts::look::{Due, Pair};
use crate::physics::data::plan::{Part, called};
use crate::physics::store::bodies::Bodies;
use crate::physics::store::islands::Island;
use crate::physics::store::neighbours::Neighbours;
use crate::physics::store::reach::Reach;
use std::collections::BinaryHeap;

/// Impacts slower than this are none, m/s. Smaller: rounding bounces.
pub(crate) const SLOWEST: f64 = 1e-9;
/// A body that has been hit so often in a step waits. Fewer: a body of a hot gas loses time; more: a body in a narrow gap costs more.
const MOST_HITS: u32 = 24;

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
pub(crate) struct Impact {
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

/// Where an impact may throw a body.
pub(crate) struct Around<'a> {
    pub island: Island<'a>,
    pub neighbours: &'a mut Neighbours,
    pub reach: &'a mut Reach,
    /// Whether islands may not grow any more.
    pub last: bool,
}

/// A body in flight, or a surface: its courses along both axes, and what has happened to it in this step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Flyer {
    pub course: [Course; 2],
    /// How many courses it has taken.
    pub courses: u32,
    pub hits: u32,
    /// The first link of the chain of its pairs.
    pub chain: u32,
    /// Whether it stands still if nothing hits it; a medium brakes it; something hit it; it waits.
    pub still: bool,
    pub braked: bool,
    pub was_hit: bool,
    pub waits: bool,
    /// Its free velocity before impacts, m/s.
    free: [f64; 2],
    /// Where it is predicted after impacts, m.
    predicted: [f64; 2],
}

/// The impacts of one island.
#[derive(Clone, Debug, Default)]
pub(crate) struct Impacts {
    /// Those of this step, in their order.
    pub all: Vec<Impact>,
    /// Those that did not bounce: pair, axis, closing speed, m/s.
    pub plastic: Vec<(u32, u32, Axis, f64)>,
    /// What hit each body from above, N·s, by slot.
    pub struck: Vec<f64>,
    /// Whether any were looked for in this step.
    pub any: bool,
    /// How many bodies have waited.
    pub waiting: u64,
    pairs: Vec<Pair>,
    /// Whether pairs were skipped because both stand still.
    skipped: bool,
    flyers: Vec<Flyer>,
    calendar: BinaryHeap<Due>,
    /// s.
    dt: f64,
    /// m/s.
    rest_speed: f64,
    /// m.
    touch: f64,
    hair: f64,
}

const NONE: u32 = u32::MAX;

impl Impacts {
    pub fn new(count: usize, all: usize) -> Self {
        Self {
            all: Vec::with_capacity(count),
            struck: vec![0.0; all],
            pairs: Vec::with_capacity(4 * count),
            flyers: vec![Flyer::default(); all],
            calendar: BinaryHeap::with_capacity(4 * count),
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
        let island = around.island;
        (self.dt, self.rest_speed) = (size.dt, size.rest_speed);
        (self.touch, self.hair) = (contacts.tolerances.touch, contacts.tolerances.hair);
        self.all.clear();
        for &i in island.members {
            self.struck[i as usize] = 0.0;
        }
        self.any = bodies.lively && self.any_due(bodies, island, (contacts, anchors));
        if self.any {
            self.gather(bodies, island, anchors, &around.reach.added);
            while let Some(due) = self.next_due() {
                self.touch(bodies, anchors, around, due);
            }
            for &i in island.members {
                self.flyers[i as usize].predicted = [bodies.px[i as usize], bodies.py[i as usize]];
            }
        }
        self.any
    }

    /// Where a body is predicted, after impacts.
    pub fn predicted(&self, bodies: &Bodies, i: usize) -> (f64, f64) {
        if self.any { self.flyers[i].predicted.into() } else { (bodies.free_x[i], bodies.free_y[i]) }
    }

    /// As if nothing had been solved.
    pub fn undo(&mut self, bodies: &mut Bodies, members: &[u32]) {
        members.iter().for_each(|i| bodies.fall_freely(*i as usize));
        self.restore_free(bodies, members);
        self.all.clear();
        self.any = false;
    }

    /// How fast a body was across when the step began, or would have been to have now what impacts gave it, m/s.
    pub fn began_across(&self, bodies: &Bodies, i: usize) -> f64 {
        match &self.flyers[i] {
            flyer if !self.any || !flyer.was_hit => bodies.vx[i],
            flyer if flyer.waits => bodies.free_vx[i],
            flyer => flyer.course[0].velocity,
        }
    }

    /// The free velocity of a body before impacts, m/s.
    pub fn free_before(&self, bodies: &Bodies, i: usize) -> [f64; 2] {
        if self.any { self.flyers[i].free } else { [bodies.free_vx[i], bodies.free_vy[i]] }
    }

    /// Sets the free velocities to what they were before the impacts.
    pub fn restore_free(&mut self, bodies: &mut Bodies, members: &[u32]) {
        if self.any {
            for i in members.iter().map(|i| *i as usize) {
                (bodies.free_vx[i], bodies.free_vy[i]) = self.flyers[i].free.into();
            }
        }
    }

    /// A pair touches: it bounces, or one of the two waits.
    fn touch(&mut self, bodies: &mut Bodies, anchors: &Anchors, around: &mut Around<'_>, due: Due) {
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let (a, b, n) = (a as usize, b as usize, bodies.len());
        let hits = |i: usize| self.flyers[i].hits;
        let busier = if b >= n || (hits(a), bodies.mass[b]) >= (hits(b), bodies.mass[a]) { a } else { b };
        if self.flyers[a].waits && b >= n {
            // A moving surface comes upon a body that waits: the body goes on.
            if hits(a) >= 2 * MOST_HITS {
                return;
            }
            self.go_along(bodies, a, due.time);
            let [of_a, of_b] = [a, b].map(|i| self.flyers[i].course[due.axis]);
            let side = if of_b.place(due.time) < of_a.place(due.time) { -1.0 } else { 1.0 };
            let speed = (of_a.speed(due.time) - of_b.speed(due.time)) * side;
            match speed > SLOWEST {
                true => self.bounce(bodies, anchors, around, Due { speed, ..due }),
                false => self.leave(bodies, around, a, due.time),
            }
        } else if self.flyers[a].waits {
            self.wait(bodies, around, b, due.time);
        } else if b < n && self.flyers[b].waits {
            self.wait(bodies, around, a, due.time);
        } else if hits(busier) >= MOST_HITS {
            self.wait(bodies, around, busier, due.time);
        } else {
            self.bounce(bodies, anchors, around, due);
        }
    }

    /// From `time` on, body i stays where it is until the step ends, with the velocity that it has.
    fn wait(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, i: usize, time: f64) {
        self.waiting += 1;
        let flyer = &mut self.flyers[i];
        (flyer.waits, flyer.was_hit) = (true, true);
        for (axis, course) in flyer.course.iter_mut().enumerate() {
            let (p, free) = if axis == 0 { (&mut bodies.px, &mut bodies.free_vx) } else { (&mut bodies.py, &mut bodies.free_vy) };
            p[i] = course.place(time);
            free[i] += course.speed(time) - course.speed(self.dt);
            *course = Course::straight(p[i], 0.0);
        }
        self.leave(bodies, around, i, time);
    }

    /// From `time` on, body i waits no more: it goes on with the velocity that it has kept, and nothing pulls at it until the step ends.
    fn go_along(&mut self, bodies: &mut Bodies, i: usize, time: f64) {
        self.flyers[i].waits = false;
        self.flyers[i].hits += 1;
        for (axis, course) in self.flyers[i].course.iter_mut().enumerate() {
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
                let j = stack.second as usize;
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

    /// Finds the pairs that bounce, and predicts their first impacts.
    fn gather(&mut self, bodies: &Bodies, island: Island<'_>, anchors: &Anchors, added: &[(u32, u32)]) {
        called(Part::Bounces);
        self.pairs.clear();
        self.calendar.clear();
        for &i in island.members {
            self.enter(bodies, i as usize, anchors);
        }
        self.skipped = false;
        for &i in island.members {
            for &j in island.near(i) {
                if self.stand(bodies, i, j) {
                    self.skipped = true;
                } else {
                    self.meet(bodies, i, j);
                }
            }
        }
        for &(i, j) in added {
            self.meet(bodies, i, j);
        }
    }

    /// Notes on which course a body sets out.
    fn enter(&mut self, bodies: &Bodies, i: usize, anchors: &Anchors) {
        let free = [bodies.free_vx[i], bodies.free_vy[i]];
        let to = |at, velocity, end| Course::to(end, (at, velocity), self.dt, self.touch);
        let across = to(bodies.x[i], bodies.vx[i], (bodies.px[i], free[0]));
        let along = match anchors.rests[i] {
            true => Some(Course::straight(bodies.y[i], bodies.uy[i])),
            false => to(bodies.y[i], bodies.vy[i], (bodies.py[i], free[1])),
        };
        let course = [across, along].map(Option::unwrap_or_default);
        let still = course.iter().all(Course::is_still);
        let braked = across.is_none() || along.is_none();
        self.flyers[i] = Flyer { course, chain: NONE, still, braked, free, ..Flyer::default() };
    }

    /// Whether both of a pair stand still if nothing hits them.
    fn stand(&self, bodies: &Bodies, i: u32, j: u32) -> bool {
        let (i, j) = (i as usize, j as usize);
        self.flyers[i].still && if j < bodies.len() { self.flyers[j].still } else { bodies.vx[j] == 0.0 && bodies.vy[j] == 0.0 }
    }

    /// Adds the pairs that were skipped: something that stood still was hit.
    fn add_skipped(&mut self, bodies: &Bodies, island: Island<'_>) {
        self.skipped = false;
        for &i in island.members {
            if self.flyers[i as usize].still {
                for &j in island.near(i) {
                    if self.stand(bodies, i, j) {
                        self.add(bodies, i, j);
                    }
                }
            }
        }
    }
}
