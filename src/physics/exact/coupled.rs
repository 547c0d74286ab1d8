//! What is in contact in media and moves: Runge–Kutta steps of fifth order ([`crate::physics::flight::steps`]) with a contact solve at each stage, so
//! that bodies that press on each other fly as one. A step ends where a liquid begins or ends, or where a contact begins to part or to slip.

use crate::physics::data::{Body, Contact, Cubic, EVENTS_OF_A_BODY, FLIGHT_TOLERANCE, FORCE_TOLERANCE, Pose, SPEED_TOLERANCE};
use crate::physics::exact::events::{Events, Scene};
use crate::physics::exact::item::{Item, Travel};
use crate::physics::exact::motions::SHORTEST;
use crate::physics::flight::steps::{ERROR, STAGES, sum};
use glam::DVec2;

/// Steps up to an event. More: what an implicit step takes for less; fewer: implicit steps, of second order, take bodies that are not that stiff.
const MOST_STEPS: u32 = 8;

/// Trials for the length of a step that ends at an event. Fewer: a contact slips or parts late.
const TRIALS: u32 = 8;

/// An item's part of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CoupledStep {
    start: Pose,
    /// How far it gets from there: bodies that move as one have the same bits of it, whatever their places. And how fast it is then.
    end: Pose,
    /// How far it is at the present stage.
    way: DVec2,
    /// Velocities and accelerations at the stages.
    speeds: [DVec2; 7],
    pulls: [DVec2; 7],
    /// Whether an acceleration differs from the first.
    bends: bool,
}

impl Events {
    /// Gives the items concerned that are in contact cubics for `left` seconds, or up to an event. Returns false where they are too stiff for that.
    pub(crate) fn fly_coupled(&mut self, scene: &Scene, left: f64) -> bool {
        let afloat = self.rests_afloat(scene);
        let budget = EVENTS_OF_A_BODY * (32 + self.movable as u64) / 2;
        let cheap = |events: &Self| events.count + events.reactions.solved < budget;
        let (mut h, mut count) = (self.while_slides_last(left), 1);
        loop {
            if !cheap(self) {
                return false;
            }
            let error = self.step_coupled(scene, (h, count), afloat);
            let kink = self.first_kink(h).max(scene.tick * SHORTEST * SHORTEST * SHORTEST);
            if kink < h {
                h = kink;
                continue;
            }
            if error <= FLIGHT_TOLERANCE {
                break;
            }
            // The error of that many steps falls with their fourth power.
            let more = f64::from(count) * (1.2 * libm::sqrt(libm::sqrt(error / FLIGHT_TOLERANCE))).max(1.5);
            if more.is_nan() || more > f64::from(MOST_STEPS) {
                return false;
            }
            count = more.ceil() as u32;
        }
        let mut holds = 0.0;
        if cheap(self) && self.changes_on_the_way(h) {
            for _ in 0..TRIALS {
                let middle = 0.5 * (holds + h);
                self.step_coupled(scene, (middle, count), afloat);
                *(if self.changes_on_the_way(middle) { &mut h } else { &mut holds }) = middle;
            }
            self.step_coupled(scene, (h, count), afloat);
        }
        for (step, i) in self.coupled.iter().zip(&self.concerned) {
            let item = &mut self.items[*i as usize];
            if !matches!(item.motion, Travel::Parabola | Travel::Still)
                || item.motion == Travel::Still && step.end.1.length() <= SPEED_TOLERANCE
            {
                continue;
            }
            item.until = item.until.min(self.now + h);
            if step.bends {
                item.motion = Travel::Coupled;
                item.course = step.course(h);
                item.mean = (step.end.1 - step.start.1) / h;
            }
        }
        true
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

    /// Takes that many steps through `h` seconds. Returns their error, m.
    fn step_coupled(&mut self, scene: &Scene, (h, count): (f64, u32), afloat: bool) -> f64 {
        self.coupled.clear();
        for &i in &self.concerned {
            let Item { body: Body { position, velocity, .. }, .. } = self.items[i as usize];
            let (speeds, pulls) = ([velocity; 7], [self.solved[i as usize]; 7]);
            let (start, end) = ((position, velocity), (DVec2::ZERO, velocity));
            self.coupled.push(CoupledStep { start, end, way: DVec2::ZERO, speeds, pulls, bends: false });
        }
        let (part, mut error) = (h / f64::from(count), 0.0);
        for _ in 0..count {
            for stage in 1..7 {
                self.take_stage(scene, (stage, part), afloat);
            }
            error += self.coupled.iter_mut().map(|step| step.finish(part)).fold(0.0, |most: f64, of| most.max(of));
        }
        error
    }

    /// Where a stage is, and the accelerations with contacts there.
    fn take_stage(&mut self, scene: &Scene, (stage, h): (usize, f64), afloat: bool) {
        for (step, &i) in self.coupled.iter_mut().zip(&self.concerned) {
            let weights = STAGES[stage - 1];
            step.way = step.end.0 + sum(&step.speeds, weights) * h;
            step.speeds[stage] = step.end.1 + sum(&step.pulls, weights) * h;
            let item = &self.items[i as usize];
            self.free[i as usize] = scene.media.acceleration(&item.body, &item.law, step.start.0 + step.way, step.speeds[stage]);
        }
        self.solve_means();
        for (step, &i) in self.coupled.iter_mut().zip(&self.concerned) {
            step.pulls[stage] = self.means[i as usize] * DVec2::new(1.0, if afloat { 0.0 } else { 1.0 });
            step.bends |= step.pulls[stage] != self.solved[i as usize];
        }
    }

    /// The first of the kinks where a body enters or leaves a liquid within `h` seconds, or those.
    fn first_kink(&self, h: f64) -> f64 {
        let of = self.coupled.iter().zip(&self.concerned);
        let kinks = of.filter_map(|(step, i)| self.items[*i as usize].law.displaced.end_of(&step.course(h), h));
        kinks.fold(h, f64::min)
    }

    /// Whether by the end of a step a contact that held at its begin parts or slips, and one that gave way holds.
    fn changes_on_the_way(&self, h: f64) -> bool {
        let most = self.coupled.iter().map(|step| step.pulls[6].abs().max_element()).fold(0.0, f64::max);
        let least = (FORCE_TOLERANCE * most).max(1.0 * FLIGHT_TOLERANCE / (h * h));
        let rate = |item: u32| if self.is_body(item) { self.means[item as usize] } else { self.free[item as usize] };
        let changes = |(before, after): (&Contact, &Contact)| {
            let gain = rate(after.hi) - rate(after.lo);
            let parts = before.normal > 0.0 && after.normal == 0.0 && gain[after.axis] > least;
            let slips = before.slides != after.slides && gain[1 - after.axis].abs() > least;
            parts || slips
        };
        self.trial.iter().zip(&self.asked).any(changes)
    }
}

impl CoupledStep {
    fn course(&self, h: f64) -> Cubic {
        let Self { start: (x, v), end: (way, w), .. } = *self;
        let [_, speed, pull, change] = Cubic::hermite(DVec2::ZERO, v, way, w, h).c;
        Cubic { c: [x, speed, pull, change] }
    }

    /// Ends a step of `h` seconds where its last stage is. Returns its error, m.
    fn finish(&mut self, h: f64) -> f64 {
        self.end = (self.way, self.speeds[6]);
        let error = (sum(&self.speeds, &ERROR) * h).abs().max((sum(&self.pulls, &ERROR) * (h * h)).abs()).max_element();
        (self.speeds[0], self.pulls[0]) = (self.speeds[6], self.pulls[6]);
        error
    }
}
