//! Sticking and sliding contacts: an active set over the tree of supports.
//!
//! One pass top-down adds up the riders of each body; one bottom-up takes each body with its riders to its support's velocity if the limit allows,
//! or lets it slide. Rounds that do not settle are relaxed contact by contact, which dissipates. Exact on trees; on several supports that move
//! differently a body sticks to the strongest and slides on the others.

use crate::physics::crowd::friction::{Friction, Grip, Riders};
use crate::physics::crowd::{ROUNDING, bodies::Bodies, bodies::Member};
use crate::physics::data::{lists::first, lists::refill, tuning::MANY};

/// The most rounds of the active set. Fewer: contacts at their limit slide or stick a step late.
const ROUNDS: usize = 5;
/// Sweeps where those do not settle. Fewer: columns shear more.
const SWEEPS: usize = 4;

impl Friction {
    /// Whether bodies have more kinetic energy across than with the velocities `free`, m/s; where something slides back within the step, than
    /// with those or the velocities at its start, whichever are faster. Moving surfaces may drive.
    pub fn gains(&self, bodies: &Bodies, of: impl Iterator<Item = usize>, free: impl Fn(usize) -> f64) -> bool {
        let (mut had, mut has) = (0.0, 0.0);
        for i in of {
            let began = if self.turned { bodies[i].before.x.abs() } else { 0.0 };
            let speed = free(i).abs().max(began);
            had += bodies[i].mass * speed * speed;
            has += bodies[i].mass * bodies[i].end.x * bodies[i].end.x;
        }
        !self.carried && has > had * (1.0 + ROUNDING)
    }

    pub fn carries(&self, bodies: &Bodies, i: usize) -> bool {
        if !self.is_awake[i] || !self.is_gripped[i] {
            return false;
        }
        let rubs = self.tight[self.under(i)].iter().filter(|tight| tight.static_limit > 0.0);
        rubs.map(|tight| tight.load).sum::<f64>() > bodies[i].mass * (bodies[i].free.y - bodies[i].end.y).abs() * (1.0 + ROUNDING)
    }

    /// Solves the velocities across from the momenta `given`. A slide at the start that is faster than friction could stop the body alone is
    /// expected to last: a body between two that slide over it is no part of both.
    pub fn solve(&mut self, bodies: &mut Bodies, given: &[f64]) {
        for i in self.gripped.iter().map(|i| *i as usize) {
            let body = &bodies[i];
            for tight in &mut self.tight[self.start[i] as usize..self.end[i] as usize] {
                let sliding = body.before.x - bodies[tight.below as usize].was.x - tight.belt_velocity;
                let lasts = !tight.stood && body.mass * sliding.abs() > tight.kinetic_limit;
                tight.grip = if lasts { Grip::Slip(-sliding.signum()) } else { Grip::Stick };
                tight.sense = 1.0;
            }
        }
        self.turned = false;
        let mut solved = std::mem::take(&mut self.solved);
        solved.clone_from(&self.gripped);
        let mut settles = false;
        for round in 0..ROUNDS {
            self.gather(bodies, given, &solved);
            self.spread(bodies, &solved);
            if self.changed.is_empty() {
                // A body on several supports is not left with a slip that drives.
                settles = self.turned && self.gripped.len() > MANY || !self.drives(bodies, given);
                break;
            }
            self.keep_changed(&mut solved, round);
        }
        self.solved = solved;
        if !settles {
            self.relax(bodies, given);
        }
    }

    /// Keeps of those `solved` the groups in which a grip has changed: another round would change no bit of the others.
    fn keep_changed(&mut self, solved: &mut Vec<u32>, round: usize) {
        let Self { start, end, tight, gripped, is_gripped, is_awake, group, stirred, changed, .. } = self;
        if round == 0 {
            gripped.iter().for_each(|i| group[*i as usize] = *i);
            for i in gripped.iter().map(|i| *i as usize) {
                for tight in &tight[start[i] as usize..end[i] as usize] {
                    let below = tight.below as usize;
                    if is_awake[below] && is_gripped[below] {
                        let (a, b) = (first(group, i), first(group, below));
                        group[a.max(b)] = a.min(b) as u32;
                    }
                }
            }
        }
        refill(stirred, group.len(), false);
        changed.drain(..).for_each(|i| stirred[first(group, i as usize)] = true);
        solved.retain(|i| stirred[first(group, *i as usize)]);
    }

    fn drives(&self, bodies: &Bodies, given: &[f64]) -> bool {
        self.gains(bodies, self.gripped.iter().map(|i| *i as usize), |i| given[i] / bodies[i].mass)
    }

    /// Contact by contact, as far as the limits allow, from the impulses so far unless those drive: dissipates, but stops bodies high up late.
    fn relax(&mut self, bodies: &mut Bodies, given: &[f64]) {
        self.turned = false;
        self.relaxed += 1;
        self.begin_relaxing(bodies, given, 1.0);
        if self.drives(bodies, given) {
            self.begin_relaxing(bodies, given, 0.0);
        }
        for _ in 0..SWEEPS {
            self.sweep(bodies);
        }
    }

    fn begin_relaxing(&mut self, bodies: &mut Bodies, given: &[f64], part: f64) {
        for i in self.gripped.iter().map(|i| *i as usize) {
            bodies[i].end.x = given[i] / bodies[i].mass;
            self.riders[i] = alone(&bodies[i], given[i]);
        }
        for i in self.gripped.iter().map(|i| *i as usize) {
            for tight in &mut self.tight[self.start[i] as usize..self.end[i] as usize] {
                let below = tight.below as usize;
                (tight.grip, tight.impulse) = (Grip::Stick, part * tight.impulse.clamp(-tight.static_limit, tight.static_limit));
                bodies[i].end.x += tight.impulse / bodies[i].mass;
                self.riders[below].momentum -= tight.impulse;
                if below < bodies.len() && self.is_awake[below] {
                    bodies[below].end.x -= tight.impulse / bodies[below].mass;
                }
            }
        }
    }

    pub fn sweep(&mut self, bodies: &mut Bodies) -> f64 {
        let n = bodies.len();
        let mut most = 0.0f64;
        for k in 0..self.gripped.len() {
            let i = self.gripped[k] as usize;
            for c in self.under(i) {
                let tight = &mut self.tight[c];
                let below = tight.below as usize;
                let mine = 1.0 / bodies[i].mass;
                let other = if below < n && self.is_awake[below] { 1.0 / bodies[below].mass } else { 0.0 };
                let wanted = tight.impulse - (bodies[i].end.x - bodies[below].end.x - tight.belt_velocity) / (mine + other);
                let more = wanted.clamp(-tight.static_limit, tight.static_limit) - tight.impulse;
                tight.impulse += more;
                bodies[i].end.x += more * mine;
                bodies[below].end.x -= more * other;
                self.riders[below].momentum -= more;
                most = most.max(more.abs() * mine.max(other));
            }
        }
        most
    }

    fn gather(&mut self, bodies: &Bodies, given: &[f64], of: &[u32]) {
        let Self { start, end, tight, riders, .. } = self;
        for i in of.iter().map(|i| *i as usize) {
            riders[i] = alone(&bodies[i], given[i]);
        }
        for i in of.iter().rev().map(|i| *i as usize) {
            let tight = &mut tight[start[i] as usize..end[i] as usize];
            let (mut mine, mut static_limit) = (riders[i], 0.0);
            for tight in &mut *tight {
                match tight.grip {
                    Grip::Slip(sign) => {
                        tight.impulse = sign * tight.kinetic_limit * tight.sense;
                        mine.momentum += tight.impulse;
                        riders[tight.below as usize].momentum -= tight.impulse;
                    }
                    Grip::Stick => static_limit += tight.static_limit,
                }
            }
            riders[i] = mine;
            for tight in &*tight {
                if tight.sticks() {
                    let (part, below) = (tight.static_limit / static_limit, &mut riders[tight.below as usize]);
                    below.momentum += part * mine.momentum;
                    below.began += part * mine.began;
                    below.mass += part * mine.mass;
                }
            }
        }
    }

    /// Bottom-up. Notes the bodies of which some contact had to change its grip.
    fn spread(&mut self, bodies: &mut Bodies, of: &[u32]) {
        let Self { start, end, tight, riders, changed, turned, .. } = self;
        changed.clear();
        for i in of.iter().map(|i| *i as usize) {
            let (tight, mine) = (&mut tight[start[i] as usize..end[i] as usize], riders[i]);
            // The strongest support that it sticks to, and the limits of all of them.
            let (mut best, mut strongest, mut static_limit, mut holds) = (None, 0.0, 0.0, 0.0);
            for tight in &*tight {
                if tight.sticks() {
                    (static_limit, holds) = (static_limit + tight.static_limit, holds + tight.holds);
                    if tight.static_limit > strongest {
                        (best, strongest) = (Some((tight.below as usize, tight.belt_velocity, tight.stood)), tight.static_limit);
                    }
                }
            }
            let mut changes = false;
            let Some((below, belt_velocity, stood)) = best else {
                bodies[i].end.x = mine.momentum / mine.mass;
                for tight in tight {
                    let slip = bodies[i].end.x - bodies[tight.below as usize].end.x - tight.belt_velocity;
                    if matches!(tight.grip, Grip::Slip(sign) if slip * sign > 0.0) {
                        (tight.grip, changes) = (Grip::Stick, true);
                    }
                }
                changed.extend(changes.then_some(i as u32));
                continue;
            };
            let target = bodies[below].end.x + belt_velocity;
            let impulse = mine.mass * target - mine.momentum;
            bodies[i].end.x = target;
            // Static friction holds a slide that has ended within the step.
            let began = mine.began - mine.mass * (bodies[below].was.x + belt_velocity);
            let ends = !stood && (impulse.abs() <= static_limit || began * impulse > 0.0);
            let (holds, needs) = if ends { (holds, impulse + began) } else { (static_limit, impulse) };
            // Or it slides back, for what is left of the step.
            let sense = if ends { 1.0 - 2.0 * began.abs() / (needs.abs() + static_limit) } else { 1.0 };
            let mut slips = 0.0;
            for tight in tight {
                if !tight.sticks() {
                    continue;
                }
                let other = bodies[tight.below as usize].end.x + tight.belt_velocity;
                tight.impulse = impulse * (tight.static_limit / static_limit);
                if other != target {
                    (tight.grip, changes) = (Grip::Slip((other - target).signum()), true);
                } else if needs.abs() > holds * (1.0 + ROUNDING) {
                    (tight.grip, tight.sense, changes) = (Grip::Slip(needs.signum()), sense, true);
                    *turned |= ends;
                    slips += needs.signum() * tight.kinetic_limit * sense;
                }
            }
            // Its riders have a body that slides under them.
            if slips != 0.0 {
                bodies[i].end.x = (mine.momentum + slips) / mine.mass;
            }
            changed.extend(changes.then_some(i as u32));
        }
    }
}

fn alone(body: &Member, given: f64) -> Riders {
    Riders { momentum: given, began: body.mass * body.before.x, mass: body.mass }
}
