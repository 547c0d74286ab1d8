//! How each body moves between two events.
//!
//! A tick is a chain of intervals in each of which every body follows one smooth law. Free bodies follow their own flow; bodies in
//! contact follow the solved accelerations, which are constant unless a medium acts on one of them: then all of them are integrated
//! together by RK4 with a contact solve in every stage.

use super::World;
use super::flow::{Pose, flow, parabola};
use super::tuning::{COUPLED_REACH, COUPLED_STEP, STIFF_REACH};
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

/// The rate of the fastest change within an interval that a cubic still follows.
const CUBIC_REACH: f64 = 0.5;
/// The shortest interval into which light things near others cut a tick, as a fraction of it.
const SHORTEST: f64 = 1.0 / 64.0;

impl World {
    /// Decides how everything moves during the next interval, at most `left` seconds of a `tick`, and returns its greatest length.
    pub(super) fn choose_motions(&mut self, left: f64, tick: f64) -> f64 {
        let mut longest = left;
        let (mut coupled, mut fastest) = (false, 0.0f64);
        for &body in &self.awake {
            let i = body as usize;
            let (body, law) = (&self.bodies[i], &self.laws[i]);
            let at_rest = body.velocity == DVec2::ZERO && self.solved[i] == DVec2::ZERO;
            let media = !law.is_constant();
            let motion = match (at_rest, media, self.in_contact[i]) {
                (true, _, true) | (true, false, false) => Motion::Still,
                (_, false, _) => Motion::Parabola,
                (_, true, false) => Motion::Flow,
                (_, true, true) => Motion::Coupled,
            };
            if matches!(motion, Motion::Flow | Motion::Coupled) {
                let mut rate = self.media.rate(body, law, body.velocity);
                if motion == Motion::Coupled {
                    // Friction or a push may throw something light so fast that the medium answers within the interval: √(k·a).
                    let thrown = self.media.rate(body, law, body.velocity + self.solved[i] * left) - rate;
                    rate = rate.max((thrown.max(0.0) / left).sqrt());
                    fastest = rate.max(fastest);
                }
                let splashes = || {
                    law.is_near_liquid()
                        && self.media.rate(body, law, DVec2::ZERO) * left <= STIFF_REACH
                        && self.media.cuts(body, law)
                };
                if rate * left > CUBIC_REACH && (self.candidates.has_neighbours(i) || splashes()) {
                    longest = longest.min((CUBIC_REACH / rate).max(tick * SHORTEST));
                }
            }
            coupled |= motion == Motion::Coupled;
            self.motions[i] = motion;
        }
        if coupled {
            self.couple(fastest, longest);
        }
        longest
    }

    /// Prepares for the integration of everything that moves in contact, for `longest` seconds and rates up to `fastest`.
    fn couple(&mut self, fastest: f64, longest: f64) {
        self.coupled_bodies.clear();
        for &body in &self.awake {
            let i = body as usize;
            // Forces pass from one body in contact to the next: whatever moves in contact moves with them.
            if self.in_contact[i] && self.motions[i] != Motion::Still {
                self.motions[i] = Motion::Coupled;
                self.coupled_bodies.push(body);
            }
        }
        self.coupled_at = f64::NAN;
        self.coupled_nodes.clear();
        let reach = fastest * longest;
        if reach > COUPLED_REACH {
            self.laws_hold = false;
            for &body in &self.coupled_bodies {
                let i = body as usize;
                let (body, law) = (&self.bodies[i], &mut self.laws[i]);
                law.soft = (COUPLED_REACH / (self.media.rate(body, law, body.velocity) * longest)).min(1.0);
            }
        }
        let steps = (reach.min(COUPLED_REACH) / COUPLED_STEP).ceil().max(1.0);
        self.coupled_steps = steps as usize;
        self.coupled_step = longest / steps;
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
        let n = self.coupled_bodies.len();
        let whole = ((t / self.coupled_step) as usize).min(self.coupled_steps - 1);
        let known = (self.coupled_nodes.len() / n).saturating_sub(1);
        if self.coupled_nodes.is_empty() {
            let start = self.coupled_bodies.iter().map(|&body| &self.bodies[body as usize]);
            self.coupled_nodes.extend(start.map(|body| (body.position, body.velocity)));
        }
        let from = known.min(whole);
        for (&body, &node) in self.coupled_bodies.iter().zip(&self.coupled_nodes[from * n..]) {
            self.coupled[body as usize] = node;
        }
        for step in from..whole {
            self.step_coupled(self.coupled_step, step == 0);
            self.coupled_nodes.extend(self.coupled_bodies.iter().map(|&body| self.coupled[body as usize]));
        }
        self.step_coupled(t - whole as f64 * self.coupled_step, whole == 0);
    }

    /// One step of all coupled bodies from `self.coupled`; the interval's first begins with the accelerations already solved.
    fn step_coupled(&mut self, h: f64, first: bool) {
        // Stage poses, and the weighted sums of velocities and accelerations.
        for &body in &self.coupled_bodies {
            let i = body as usize;
            self.stage[i] = self.coupled[i];
            self.sums[i] = (DVec2::ZERO, DVec2::ZERO);
            self.stage_accelerations[i] = self.solved[i];
        }
        for (index, (weight, reach)) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)].into_iter().enumerate() {
            if index > 0 || !first {
                self.stage_solve();
            }
            for &body in &self.coupled_bodies {
                let i = body as usize;
                let (a, v) = (self.stage_accelerations[i], self.stage[i].1);
                self.sums[i].0 += v * weight;
                self.sums[i].1 += a * weight;
                let (x0, v0) = self.coupled[i];
                self.stage[i] = (x0 + v * (reach * h), v0 + a * (reach * h));
            }
        }
        let sixth = h / 6.0;
        for &body in &self.coupled_bodies {
            let i = body as usize;
            let (x, v) = &mut self.coupled[i];
            *x += self.sums[i].0 * sixth;
            *v += self.sums[i].1 * sixth;
        }
    }

    /// Accelerations at the stage poses. The contacts keep their forces of the interval's start: those are what is shown.
    fn stage_solve(&mut self) {
        for &body in &self.coupled_bodies {
            let i = body as usize;
            let (x, v) = self.stage[i];
            self.free[i] = self.media.acceleration(&self.bodies[i], &self.laws[i], x, v);
        }
        self.stage_contacts.clone_from(&self.contacts);
        let items = self.bodies.len() + self.blocks.len();
        self.reactions.accelerate(&mut self.stage_contacts, &self.bodies, items, &self.free, &mut self.stage_accelerations);
    }
}
