//! Who sticks and who slides: an active set over the tree of supports.
//!
//! One pass top-down adds up, where contacts stick, mass and momentum of all that rides on a body; one pass bottom-up takes each body with its
//! riders to its support's velocity if the limit allows, and lets it slide otherwise. A contact that slides hands down its limit instead of
//! its riders, so the passes are done again with what they found; it ends after two or three rounds, and every impulse is applied to both, so
//! momentum is exact also where it slips. Where they do not settle, or a body on several supports would be driven, the contacts are relaxed one
//! by one instead, which always dissipates. Exact on trees; a body on several supports that move differently sticks to the strongest and
//! slides on the others.

use crate::physics::crowd::clusters::Node;
use crate::physics::crowd::friction::{Friction, Grip, Tight};
use crate::physics::store::bodies::Bodies;

/// The most rounds of the active set. Fewer: contacts at their limit slide or stick a step late.
const ROUNDS: usize = 5;
/// Sweeps of the way out. Fewer: columns shear more.
const SWEEPS: usize = 4;

/// A limit exceeded by this part still holds: sums of many impulses are rounded.
const ROUNDING: f64 = 1e-12;

impl Friction {
    /// Solves the velocities across of what is gripped, from the momenta `given`; leaves in `riders` what each body carries.
    ///
    /// What slid at the start, faster than friction could stop the body alone, is expected to go on sliding: so what lies between bodies that slide over it is not taken for a part of both.
    pub fn solve(&mut self, bodies: &mut Bodies, given: &[f64]) {
        for k in 0..self.gripped.len() {
            let i = self.gripped[k] as usize;
            for c in self.under(i) {
                let tight = &mut self.tight[c];
                let sliding = bodies.vx[i] - bodies.began_across(tight.below as usize) - tight.skin;
                let lasts = !tight.stood && bodies.mass[i] * sliding.abs() > tight.dragged;
                tight.grip = if lasts { Grip::Slip(-sliding.signum()) } else { Grip::Stick };
                tight.sense = 1.0;
            }
        }
        self.turned = false;
        for round in 0..ROUNDS {
            if round == 0 {
                self.gather(bodies, given);
            } else {
                self.gather_again(bodies, given);
            }
            if !self.spread(bodies) {
                if self.carried || self.turned || self.dissipates(bodies, given) {
                    return;
                }
                break;
            }
        }
        self.relax(bodies, given);
    }

    /// Whether there is no more kinetic energy than before: a body on several supports may have been left with a slip that drives.
    fn dissipates(&self, bodies: &Bodies, given: &[f64]) -> bool {
        let (mut before, mut after) = (0.0, 0.0);
        for &i in &self.gripped {
            let (mass, i) = (bodies.mass[i as usize], i as usize);
            before += given[i] * given[i] / mass;
            after += mass * bodies.ux[i] * bodies.ux[i];
        }
        after <= before * (1.0 + ROUNDING)
    }

    /// The way out where the grips do not settle: contact by contact, friction brings its two bodies together as far as its limit
    /// allows, beginning with the impulses that the grips have come to. Always dissipates, but what sticks high up may be stopped only after
    /// many steps.
    fn relax(&mut self, bodies: &mut Bodies, given: &[f64]) {
        self.turned = false;
        self.relaxed += 1;
        self.begin_relaxing(bodies, given);
        let without = self.kinetic(bodies);
        let n = bodies.len();
        let mut work = 0.0;
        for k in 0..self.gripped.len() {
            let i = self.gripped[k] as usize;
            for c in self.under(i) {
                let tight = &mut self.tight[c];
                let below = tight.below as usize;
                tight.impulse = tight.impulse.clamp(-tight.held, tight.held);
                bodies.ux[i] += tight.impulse / bodies.mass[i];
                if below < n && self.is_awake[below] {
                    bodies.ux[below] -= tight.impulse / bodies.mass[below];
                } else {
                    work += tight.impulse * (bodies.ux[below] + tight.skin);
                }
                self.riders[below].momentum -= tight.impulse;
            }
        }
        // What friction makes as small as its limits allow: the kinetic energy, less the work of ground that moves.
        if self.kinetic(bodies) - work > without {
            self.begin_relaxing(bodies, given);
            self.tight.iter_mut().for_each(|tight| tight.impulse = 0.0);
        }
        self.tight.iter_mut().for_each(|tight| tight.grip = Grip::Stick);
        for _ in 0..SWEEPS {
            self.sweep(bodies);
        }
    }

    /// Everybody by itself, with the momenta that are `given`.
    fn begin_relaxing(&mut self, bodies: &mut Bodies, given: &[f64]) {
        for &i in &self.gripped {
            let i = i as usize;
            bodies.ux[i] = given[i] / bodies.mass[i];
            self.riders[i] = Node { momentum: given[i], mass: bodies.mass[i], ..Node::default() };
        }
    }

    /// The kinetic energy of what is gripped, J.
    fn kinetic(&self, bodies: &Bodies) -> f64 {
        self.gripped.iter().map(|i| *i as usize).map(|i| 0.5 * bodies.mass[i] * bodies.ux[i] * bodies.ux[i]).sum()
    }

    /// Contact by contact, brings two bodies together as far as the limit allows. Returns the greatest change of a velocity, m/s.
    pub fn sweep(&mut self, bodies: &mut Bodies) -> f64 {
        let n = bodies.len();
        let mut most = 0.0f64;
        for k in 0..self.gripped.len() {
            let i = self.gripped[k] as usize;
            for c in self.under(i) {
                let tight = &mut self.tight[c];
                let below = tight.below as usize;
                let share = |i: usize, moves: bool| if moves { 1.0 / bodies.mass[i] } else { 0.0 };
                let (mine, other) = (share(i, true), share(below, below < n && self.is_awake[below]));
                let wanted = tight.impulse - (bodies.ux[i] - bodies.ux[below] - tight.skin) / (mine + other);
                let more = wanted.clamp(-tight.held, tight.held) - tight.impulse;
                tight.impulse += more;
                bodies.ux[i] += more * mine;
                bodies.ux[below] -= more * other;
                self.riders[below].momentum -= more;
                most = most.max(more.abs() * mine.max(other));
            }
        }
        most
    }

    /// Top-down: mass and momentum of all that sticks to a body, and what slides on it gives.
    fn gather(&mut self, bodies: &Bodies, given: &[f64]) {
        let n = bodies.len();
        for &i in &self.gripped {
            let i = i as usize;
            self.concerned[i] = true;
            self.riders[i] = self.alone(bodies, i, given[i]);
        }
        for k in (0..self.gripped.len()).rev() {
            let i = self.gripped[k] as usize;
            let under = self.under(i);
            let mine = self.riders[i];
            if under.is_empty() {
                continue;
            }
            let held: f64 = self.tight[under.clone()].iter().map(|t| t.held).sum();
            let on_surfaces = self.tight[under.clone()].iter().all(|t| t.below as usize >= n);
            if on_surfaces {
                let first = &self.tight[under.start];
                let sliding = mine.momentum - mine.mass * (bodies.ux[first.below as usize] + first.skin);
                if sliding.abs() > held {
                    for tight in self.tight[under.clone()].iter_mut().filter(|tight| tight.stood) {
                        tight.grip = Grip::Slip(-sliding.signum());
                    }
                }
            }
            self.hand_down(i, n, |_| true);
        }
    }

    /// A body by itself, with a momentum.
    fn alone(&self, bodies: &Bodies, i: usize, given: f64) -> Node {
        let mass = bodies.mass[i];
        Node { momentum: given, began: mass * bodies.vx[i], mass, ..Node::default() }
    }

    /// The same after some grips have changed: only sums are told anew that this concerns.
    fn gather_again(&mut self, bodies: &Bodies, given: &[f64]) {
        let n = bodies.len();
        for k in (0..self.gripped.len()).rev() {
            let i = self.gripped[k] as usize;
            if self.concerned[i] {
                for tight in self.tight[self.under(i)].iter().filter(|tight| tight.grip == Grip::Stick) {
                    self.concerned[tight.below as usize] = true;
                }
                self.riders[i] = self.alone(bodies, i, given[i]);
            }
        }
        for k in (0..self.gripped.len()).rev() {
            let i = self.gripped[k] as usize;
            let concerned = std::mem::take(&mut self.concerned);
            if self.tight[self.under(i)].iter().any(|tight| concerned[i] || concerned[tight.below as usize]) {
                self.hand_down(i, n, |j| concerned[j]);
            }
            self.concerned = concerned;
        }
    }

    /// Gives what a body carries, or what it rubs with, to those of its supports that are `concerned`.
    fn hand_down(&mut self, i: usize, n: usize, concerned: impl Fn(usize) -> bool) {
        let (under, mine) = (self.under(i), concerned(i));
        let mut held = 0.0;
        for tight in &mut self.tight[under.clone()] {
            let below = tight.below as usize;
            match tight.grip {
                Grip::Slip(sign) => {
                    if mine {
                        tight.impulse = sign * tight.dragged * tight.sense;
                        self.riders[i].momentum += tight.impulse;
                    }
                    if below < n && concerned(below) {
                        self.riders[below].momentum -= tight.impulse;
                    }
                }
                Grip::Stick => held += tight.held,
            }
        }
        if held <= 0.0 {
            return;
        }
        let mine = self.riders[i];
        for tight in self.tight[under].iter().filter(|tight| tight.grip == Grip::Stick) {
            let below = tight.below as usize;
            if below < n && concerned(below) {
                let (part, below) = (tight.held / held, &mut self.riders[below]);
                below.momentum += part * mine.momentum;
                below.began += part * mine.began;
                below.mass += part * mine.mass;
            }
        }
    }

    /// What static friction can hold of a body, by all supports to which it sticks, N·s.
    fn holds(&self, under: std::ops::Range<usize>) -> f64 {
        self.tight[under].iter().filter(|tight| tight.grip == Grip::Stick).map(|tight| tight.holds).sum()
    }

    /// Bottom-up: the velocities. Returns whether some contact had to change its grip.
    fn spread(&mut self, bodies: &mut Bodies) -> bool {
        let mut changed = false;
        for k in 0..self.gripped.len() {
            let i = self.gripped[k] as usize;
            let under = self.under(i);
            let concerned = std::mem::replace(&mut self.concerned[i], false);
            self.moved[i] = false;
            if !concerned && !self.tight[under.clone()].iter().any(|tight| self.moved[tight.below as usize]) {
                continue;
            }
            let known = changed;
            changed = false;
            let mine = self.riders[i];
            let mut velocity = mine.momentum / mine.mass;
            // The strongest support that it sticks to.
            let mut best: Option<usize> = None;
            let mut held = 0.0;
            for c in under.clone() {
                let tight = &self.tight[c];
                if tight.grip == Grip::Stick && tight.held > 0.0 {
                    held += tight.held;
                    if best.is_none_or(|b| tight.held > self.tight[b].held) {
                        best = Some(c);
                    }
                }
            }
            if let Some(best) = best {
                let carry = |tight: &Tight| bodies.ux[tight.below as usize] + tight.skin;
                let target = carry(&self.tight[best]);
                let impulse = mine.mass * target - mine.momentum;
                velocity = target;
                // What slid and has come to its end within the step is held by static friction then, which need not answer what it began with.
                let first = mine.began - mine.mass * (bodies.began_across(self.tight[best].below as usize) + self.tight[best].skin);
                let ends = !self.tight[best].stood && (impulse.abs() <= held || first * impulse > 0.0);
                let (holds, needs) = if ends { (self.holds(under.clone()), impulse + first) } else { (held, impulse) };
                // Or it slides back, for what is left of the step.
                let sense = if ends { 1.0 - 2.0 * first.abs() / (needs.abs() + held) } else { 1.0 };
                for c in under.clone() {
                    let other = carry(&self.tight[c]);
                    let tight = &mut self.tight[c];
                    if tight.grip != Grip::Stick || tight.held <= 0.0 {
                        continue;
                    }
                    tight.impulse = impulse * (tight.held / held);
                    if other != target {
                        tight.grip = Grip::Slip((other - target).signum());
                        changed = true;
                    } else if needs.abs() > holds * (1.0 + ROUNDING) {
                        (tight.grip, tight.sense) = (Grip::Slip(needs.signum()), sense);
                        self.turned |= ends;
                        changed = true;
                    }
                }
            }
            for c in under {
                if let Grip::Slip(sign) = self.tight[c].grip {
                    let below = self.tight[c].below as usize;
                    let slip = velocity - bodies.ux[below] - self.tight[c].skin;
                    if best.is_none() && slip * sign > 0.0 {
                        self.tight[c].grip = Grip::Stick;
                        changed = true;
                    }
                }
            }
            if changed {
                self.concerned[i] = true;
                self.tight[self.under(i)].iter().for_each(|tight| self.concerned[tight.below as usize] = true);
            }
            changed |= known;
            self.moved[i] = velocity.to_bits() != bodies.ux[i].to_bits();
            bodies.ux[i] = velocity;
        }
        changed
    }
}
