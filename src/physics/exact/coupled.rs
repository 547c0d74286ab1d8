//! What links join, or contacts in media, as one: Runge–Kutta steps with a contact solve at each stage, up to a kink, a bend or a change of contacts.

use crate::physics::data::{Contact, Cubic, FORCE_TOLERANCE, LONGEST_SHORT, Pose, SPEED_TOLERANCE};
use crate::physics::exact::{events::Events, events::Scene, item::Item, item::Travel, motions::SHORTEST};
use crate::physics::flight::steps::{CoupledStep, FIFTH_ORDER, RungeKutta, THIRD_ORDER, step_factor};
use crate::physics::forces::Link;
use glam::DVec2;

/// Trials for the instant at which a contact begins to part or to slip. Fewer: a contact slips late, and a stick-slip drifts.
const TRIALS: u32 = 24;

/// The shortest step to a kink, in parts of a tick. Longer: energy is gained where a rope becomes taut; shorter: roundings make many steps.
const LEAST: f64 = SHORTEST * SHORTEST * SHORTEST;

/// m. Most error of a step, without and with links. Larger: what parts for less than a step overlaps, and swings are off by 1e-9 m after a second.
const MOST_ERROR: [f64; 2] = [1e-10, 1e-11];

impl Events {
    /// Gives what links or contacts join paths for `left` seconds, or up to an event. Returns false where that is too stiff, or uses up the budget.
    pub(crate) fn fly_coupled(&mut self, scene: &Scene, left: f64) -> bool {
        let afloat = self.rests_afloat(scene);
        let Some((h, changes)) = self.find_step(scene, self.while_slides_last(left), afloat) else {
            self.guards.flows_cut_short += u64::from(!self.links.is_empty());
            return false;
        };
        for (step, i) in self.coupled.iter().zip(&self.concerned) {
            let item = &mut self.items[*i as usize];
            if !matches!(item.motion, Travel::Parabola | Travel::Still) {
                continue;
            }
            let rests = item.is_still() && step.end.1.length() <= SPEED_TOLERANCE;
            item.until = item.until.min(self.now + h);
            if step.bends && !rests {
                item.motion = Travel::Coupled;
                item.course = step.course(self.now, h, changes);
                item.mean = (step.end.1 - step.start.1) / h;
            }
        }
        true
    }

    /// Takes a step whose error is small enough, of `longest` seconds at most. Returns its length, and whether contacts change just before its end.
    fn find_step(&mut self, scene: &Scene, longest: f64, afloat: bool) -> Option<(f64, bool)> {
        let linked = !self.links.is_empty();
        let budget = self.budget() / 2;
        let tolerance = MOST_ERROR[usize::from(linked)];
        let least = scene.tick * LEAST;
        let least_of = |k: usize| self.concerned.iter().map(|i| self.strides[*i as usize][k]).fold(f64::INFINITY, f64::min);
        let (mut stride, mut sliver) = (least_of(0), f64::INFINITY);
        let mut h = longest.min(stride).min(least_of(1));
        let method = if !linked && self.error_of_third_order(scene, h) <= tolerance { &THIRD_ORDER } else { &FIFTH_ORDER };
        while self.spent + self.count + self.reactions.solved <= budget {
            let solved = self.reactions.solved;
            let error = self.step_coupled(scene, method, h, afloat);
            // A part of a stiff tick takes some twenty steps: each counts as one event for two bodies.
            (self.reactions.solved, self.count) = (solved, self.count + 1 + self.concerned.len() as u64 / 2);
            let kink = self.first_kink(scene, h);
            if kink < h && h > least {
                h = kink.max(least);
                continue;
            }
            let changes = self.changed;
            if changes && h > least {
                // In a heap that falls apart the search takes longer than all else.
                self.count += u64::from(TRIALS) * (self.concerned.len() as u64 / 2);
                let (mut holds, mut over) = (0.0, h);
                for _ in 0..TRIALS {
                    let middle = 0.5 * (holds + over);
                    self.step_coupled(scene, method, middle, afloat);
                    *(if self.changed { &mut over } else { &mut holds }) = middle;
                }
                self.reactions.solved = solved;
                // The step ends just before that instant, and the next one just behind it.
                (h, sliver) = if holds > least { (holds, over - holds) } else { (least, f64::INFINITY) };
                continue;
            }
            if error <= tolerance || h <= least {
                if h > least && h < longest {
                    stride = h * step_factor((error / tolerance).sqrt().sqrt());
                }
                self.concerned.iter().for_each(|i| self.strides[*i as usize] = [stride, sliver]);
                return Some((h, changes));
            }
            h *= step_factor((error / tolerance).sqrt().sqrt()).min(0.5);
            (stride, sliver) = (h, f64::INFINITY);
            if h < LONGEST_SHORT.min(scene.tick * SHORTEST) {
                return None;
            }
        }
        None
    }

    /// Whether what floats in contact bobs by less than the rounding of its forces. It is at rest along gravity then.
    fn rests_afloat(&mut self, scene: &Scene) -> bool {
        let (mut rounding, mut bobs, mut damped) = (0.0_f64, 0.0_f64, false);
        for item in self.concerned.iter().map(|i| &self.items[*i as usize]).filter(|item| item.law.is_near_liquid()) {
            let Item { body, law, .. } = item;
            let bath = law.regime(scene.media, body, body.position).bath(body.position);
            rounding = rounding.max(bath.rounding(law.constant, body, body.position.y));
            (bobs, damped) = (bobs.max(bath.stiffness.sqrt()), damped || bath.linear + bath.waves > 0.0);
        }
        let slow = |i: &u32| {
            let speed = self.items[*i as usize].body.velocity.y;
            speed.abs() * bobs <= rounding && self.solved[*i as usize].y.abs() <= rounding
        };
        let rests = damped && bobs > 0.0 && self.concerned.iter().all(slow);
        if rests {
            for &i in &self.concerned {
                let (item, solved) = (&mut self.items[i as usize], &mut self.solved[i as usize]);
                (item.body.velocity.y, self.speeds[i as usize].y, solved.y) = (0.0, 0.0, 0.0);
                (item.solved, item.mean) = (*solved, *solved);
                if item.body.velocity == DVec2::ZERO && *solved == DVec2::ZERO {
                    item.motion = Travel::Still;
                }
            }
        }
        rests
    }

    /// What a step of third order is off by at most in air, m, where no contact changes: less than a twentieth of (a + ωv)·h²·(ωh)³.
    fn error_of_third_order(&self, scene: &Scene, h: f64) -> f64 {
        let error = |Item { body, law, solved, .. }: &Item| {
            // What bobs would add up the errors of many steps.
            if law.is_near_liquid() {
                return f64::INFINITY;
            }
            let rate = scene.media.rate(body, law, (body.position, body.velocity), h);
            0.05 * (solved.length() + rate * body.velocity.length()) * (rate * h).powi(3) * (h * h)
        };
        self.concerned.iter().map(|i| error(&self.items[*i as usize])).fold(0.0, f64::max)
    }

    /// Takes a step of `h` seconds. Returns its error, m.
    fn step_coupled(&mut self, scene: &Scene, method: &RungeKutta, h: f64, afloat: bool) -> f64 {
        self.coupled.clear();
        self.changed = false;
        self.coupled.extend(self.concerned.iter().map(|i| {
            let body = &self.items[*i as usize].body;
            CoupledStep::new((body.position, body.velocity), self.solved[*i as usize])
        }));
        for (stage, (weights, time)) in (1..).zip(method.stages.iter().zip(method.times)) {
            self.coupled.iter_mut().for_each(|step| step.go_to(weights, h));
            self.pull_coupled(scene, h * time);
            self.changed |= self.contacts_change(h);
            for (step, &i) in self.coupled.iter_mut().zip(&self.concerned) {
                step.take(stage, self.means[i as usize] * DVec2::new(1.0, if afloat { 0.0 } else { 1.0 }));
            }
        }
        let errors = self.coupled.iter().map(|step| step.error(method.error, h));
        errors.fold(0.0, |most: f64, error| if error <= most { most } else { error })
    }

    /// The accelerations with contacts where a stage is, `t` seconds from now.
    fn pull_coupled(&mut self, scene: &Scene, t: f64) {
        for (step, &i) in self.coupled.iter().zip(&self.concerned) {
            let item = &self.items[i as usize];
            let mut pull = scene.media.acceleration(&item.body, &item.law, step.start.0 + step.end.0, step.end.1);
            if item.linked {
                pull += (self.links_on(scene, item.id, self.now + t, |k| self.coupled[k].pose()) - item.link) / item.body.mass;
            }
            self.free[i as usize] = pull;
        }
        self.solve_means();
    }

    /// The force of the links on a body, N, at a time (s from the tick's start), where items concerned have those poses.
    pub(crate) fn links_on(&self, scene: &Scene, id: u32, at: f64, pose: impl Fn(usize) -> Pose) -> DVec2 {
        let links = self.links.iter().filter(|link| link.acts_on(id));
        links.map(|link| link.sooner(scene.tick - at, scene.tick).on(id, |id| self.pose_of(id, &pose))).sum()
    }

    /// Breaks the links that pull harder now than they bear, and takes the forces of the others on the items concerned.
    pub(crate) fn renew_links(&mut self, scene: &Scene) {
        let pose = |events: &Self, k: usize| {
            let body = &events.items[events.concerned[k] as usize].body;
            (body.position, body.velocity)
        };
        for at in 0..self.links.len() {
            let Link { def, .. } = self.links[at];
            let first = def.body.0;
            let concerned = self.concerned.iter().any(|i| self.items[*i as usize].id == first);
            if let Some(most) = def.breaks.filter(|_| concerned && self.links[at].acts()) {
                let now = self.links[at].sooner(scene.tick - self.now, scene.tick);
                self.links[at].broken = now.on(first, |id| self.pose_of(id, |k| pose(self, k))).length() > most;
            }
        }
        for i in self.concerned.iter().map(|i| *i as usize) {
            if self.items[i].linked {
                self.items[i].link = self.links_on(scene, self.items[i].id, self.now, |k| pose(self, k));
            }
        }
    }

    fn pose_of(&self, id: u32, pose: impl Fn(usize) -> Pose) -> Pose {
        self.concerned.iter().position(|k| self.items[*k as usize].id == id).map_or_else(|| self.end_of(id), pose)
    }

    /// When within a step of `h` seconds a body enters or leaves a liquid, or the law of a link bends; `h` where nothing does.
    fn first_kink(&self, scene: &Scene, h: f64) -> f64 {
        let kinks = self.coupled.iter().zip(&self.concerned).filter_map(|(step, i)| {
            let ((x, v), (way, w)) = (step.start, step.end);
            self.items[*i as usize].law.displaced.end_of(&Cubic::hermite(x, v, x + way, w, h), h)
        });
        let mut first = kinks.fold(h, f64::min);
        for link in self.links.iter().filter(|link| link.acts()) {
            // Which law holds, and whether it is beyond what it bears.
            let side = |t: f64| {
                let path = |k: usize| self.coupled[k].course(0.0, h, false).pose(t);
                let (apart, parting) = link.def.apart(|id| self.pose_of(id, path));
                let law = link.sooner(scene.tick - self.now - t, scene.tick).law;
                let above = law.border(apart, parting) > 0.0;
                (above, link.def.breaks.is_some_and(|most| law.force(above, apart, parting).length() > most))
            };
            let before = side(0.0);
            if side(first) != before {
                let mut holds = 0.0;
                for _ in 0..50 {
                    let middle = 0.5 * (holds + first);
                    *(if side(middle) == before { &mut holds } else { &mut first }) = middle;
                }
            }
        }
        first
    }

    /// Whether at a stage of a step of `h` seconds a contact parts or slips that held at its begin, or holds that gave way.
    fn contacts_change(&self, h: f64) -> bool {
        let most = self.concerned.iter().map(|i| self.means[*i as usize].abs().max_element()).fold(0.0, f64::max);
        // What parts does so more and more, what slips at once.
        let error = MOST_ERROR[usize::from(!self.links.is_empty())];
        let [parting, slipping] = [h * h, h].map(|of| (FORCE_TOLERANCE * most).max(error / of));
        let rate = |item: u32| if self.is_body(item) { self.means[item as usize] } else { self.free[item as usize] };
        let changes = |(before, after): (&Contact, &Contact)| {
            let gain = rate(after.hi) - rate(after.lo);
            let parts = before.normal > 0.0 && after.normal == 0.0 && gain[after.axis] > parting;
            let slips = before.slides != after.slides && gain[1 - after.axis].abs() > slipping;
            parts || slips
        };
        self.trial.iter().zip(&self.asked).any(changes)
    }
}
