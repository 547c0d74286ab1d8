//! The instants at which a law of linked bodies bends, or a link breaks.

use crate::physics::{data::Pose, flight::linked::Linked, flight::linked::LinkedBodies, flight::linked::Pull};

/// m. How far beyond the border of its law a link may be where a step ends there. Larger: energy is lost as a rope becomes taut; smaller: more steps.
const BENT: f64 = 1e-13;

impl LinkedBodies<'_> {
    /// Where a law bends within a step of `h` s: brings the members near to it. Returns the length of a last step up to it, which their ends belong to.
    pub(super) fn bend(&mut self, h: f64) -> Option<f64> {
        let (mut high, mut after) = (h, self.margin(h, Linked::end));
        if after >= 0.0 {
            high = self.turn(h)?;
            self.step(high);
            after = self.margin(high, Linked::end);
            if after >= 0.0 {
                self.step(h);
                return None;
            }
        }
        self.members.iter_mut().for_each(|member| member.beyond = member.end());
        let least = 1e-12 * self.tick;
        for round in 0..80 {
            if high <= least || after > -BENT {
                break;
            }
            // First a little short of the bend, so that a short step is left, then a little past it. Halves, where that does not find it.
            let crossing = self.crossing(high);
            let middle = match round % 4 {
                0 => (crossing - high * (1.0 / 256.0)).max(0.5 * crossing),
                3 => 0.5 * high,
                _ => crossing,
            };
            let middle = middle.clamp(0.5 * least, high - 0.5 * least);
            self.step(middle);
            let margin = self.margin(middle, Linked::end);
            if margin <= 0.0 {
                (high, after) = (middle, margin);
                self.members.iter_mut().for_each(|member| member.beyond = member.end());
            } else {
                self.accept(middle);
                high -= middle;
            }
        }
        self.step(high);
        Some(high)
    }

    /// When the first law bends on the cubics from where the members are to where they are beyond the bend, `h` seconds later.
    fn crossing(&self, h: f64) -> f64 {
        let mut first = h;
        for pull in self.pulls.iter().filter(|pull| !pull.broken) {
            let margin = |t: f64| self.margin_of(pull, t, |member| member.on_cubic(member.beyond, h, t)) + 0.5 * BENT;
            if margin(first) < 0.0 {
                let mut before = 0.0;
                for _ in 0..40 {
                    let middle = 0.5 * (before + first);
                    if margin(middle) < 0.0 { first = middle } else { before = middle }
                }
            }
        }
        first
    }

    /// When within a step of `h` seconds a rope is nearest to its border, if it comes near it and turns back.
    fn turn(&self, h: f64) -> Option<f64> {
        let turn = |pull: &Pull| {
            let side = if pull.above { -1.0 } else { 1.0 };
            let rate = |(apart, parting): Pose| side * (apart.normalize_or_zero().dot(parting) - pull.growth);
            let from = rate(self.apart(pull, |member| member.pose));
            let to = if from > 0.0 { rate(self.apart(pull, Linked::end)) } else { 0.0 };
            let turn = h * from / (from - to);
            let near = || self.margin_of(pull, turn, |member| member.on_cubic(member.end(), h, turn)) < from * h * (1.0 / 64.0);
            (to < 0.0 && near()).then_some(turn)
        };
        self.pulls.iter().filter(|pull| !pull.broken && pull.law.length().is_some()).filter_map(turn).reduce(f64::min)
    }

    /// Below 0 where in those poses, `offset` seconds after the begin of the step, a law has bent or a link has broken.
    fn margin(&self, offset: f64, pose: impl Fn(&Linked) -> Pose) -> f64 {
        let unbroken = self.pulls.iter().filter(|pull| !pull.broken);
        unbroken.map(|pull| self.margin_of(pull, offset, &pose)).fold(f64::INFINITY, f64::min)
    }

    fn margin_of(&self, pull: &Pull, offset: f64, pose: impl Fn(&Linked) -> Pose) -> f64 {
        let (border, over) = self.border(pull, offset, pose);
        (if pull.above { border } else { -border }).min(-over)
    }
}
