//! Steps through liquids by their own error: the embedded Runge–Kutta pair of J. R. Dormand and P. J. Prince (1980), of fifth order; or implicit
//! ones ([`super::implicit`]). No step crosses a kink ([`crate::physics::forces::displaced`]) or a turn that matters: |u|·u has a corner at 0.

use crate::physics::data::{Cubic, FLIGHT_TOLERANCE, Pose, Quintic, earliest};
use crate::physics::forces::liquid::{Bath, Regime, Slopes, Vertical};
use crate::physics::{flight::implicit, forces::displaced::Displaced, forces::displaced::Lanes};
use glam::{DVec2, DVec4};
use std::ops::{Add, AddAssign, Mul};

pub(crate) struct Course {
    pub end: Pose,
    /// How long it takes, s.
    pub time: f64,
    /// The length of a next step through a liquid, s, if that is known.
    pub next: f64,
    /// The acceleration at its end, m/s², if that came out of it.
    pub pull: Option<DVec2>,
}

/// A body between kinks, the media there, and its constant acceleration, m/s².
pub(crate) struct Steps<'a> {
    pub regime: &'a Regime<'a>,
    pub bath: &'a Bath,
    pub constant: DVec2,
    /// The law linearised where a step begins, for an implicit step.
    pub slopes: Option<Slopes>,
    /// The error allowed besides, as a part of its way.
    pub rough: f64,
}

impl Steps<'_> {
    /// The length of the first step in a law of that `rate`, 1/s: the error is about 1e-4·a·ω³·h⁵; a fourth root errs on the side of caution.
    pub fn first(&self, v: DVec2, rate: f64) -> f64 {
        let pull = self.bath.acceleration(self.constant, v).length();
        (FLIGHT_TOLERANCE * (rate * rate) / (1e-4 * pull)).sqrt().sqrt() / rate
    }

    /// One step of at most `h` of the `left` seconds; or how short a step would still resolve too little.
    pub fn take(&self, pose: Pose, mut h: f64, left: f64) -> Result<Course, f64> {
        let ((x, v), shortest) = (pose, left * f64::EPSILON);
        let least = FLIGHT_TOLERANCE + 8.0 * f64::EPSILON * x.abs().max_element();
        let pull = self.bath.acceleration(self.constant, v);
        let (mut next, mut to_kink, mut shrunk, mut cuts) = (h, false, false, 0);
        if !self.regime.displaced.holds_along([x + v * (0.5 * h), x + (v + pull * (0.5 * h)) * h])
            && let Some(kink) = self.regime.displaced.end_of(&Cubic::parabola(x, v, pull), h)
        {
            (h, to_kink) = (kink.max(shortest), true);
        }
        if self.slopes.is_none()
            && let Some(turn) = self.turn_ahead(v, pull, h, least)
        {
            (h, to_kink) = (turn.max(shortest), false);
        }
        loop {
            let step = self.step(pose, pull, h);
            let Step { end, pull: last, error } = step;
            let tolerance = least + self.rough * (end.0 - x).abs().max_element();
            // Slopes say nothing of drag where the speed is another by half.
            let even = self.slopes.is_none() || (end.1 - v).length() <= 0.5 * v.length();
            let fits = even && error <= tolerance && end.0.is_finite() && end.1.is_finite();
            if !fits && h <= shortest {
                return Err(h);
            }
            if !fits {
                h *= step_factor((error / tolerance).sqrt().sqrt()).min(0.5);
                (next, to_kink, shrunk) = (h, false, true);
                continue;
            }
            if cuts < 3
                && let Some(since) = self.since_turn(v, &step, h, tolerance)
            {
                cuts += 1;
                (h, to_kink) = ((h - since).max(0.1 * h), false);
                continue;
            }
            let third = h / 3.0;
            let way = || Cubic::hermite(x, v, end.0, end.1, h);
            if !self.regime.displaced.holds_along([x + v * third, end.0 - end.1 * third, end.0])
                && let Some(kink) = self.regime.displaced.end_of(&way(), h)
                && kink < h
                && h > shortest
                && !(to_kink && self.regime.displaced.all_but_holds(end.0))
            {
                (h, to_kink) = (kink.max(shortest), true);
                continue;
            }
            if h >= next && !shrunk {
                next = h * step_factor((error / tolerance).sqrt().sqrt());
            }
            return Ok(Course { end, time: h, next, pull: Some(last) });
        }
    }

    /// When a component of the velocity is going to change its sign within `h` seconds, if that bends the law.
    fn turn_ahead(&self, v: DVec2, pull: DVec2, h: f64, tolerance: f64) -> Option<f64> {
        let turn = |axis: usize| {
            let t = -v[axis] / pull[axis];
            (t > 0.0 && t < h && self.bends(axis, (v, pull), t.min(h - t), h, tolerance)).then_some(t)
        };
        earliest(turn(0), turn(1))
    }

    /// How long before the end of a step of `h` seconds a component of the velocity has changed its sign, if that bends the law.
    fn since_turn(&self, before: DVec2, Step { end: (_, v), pull, .. }: &Step, h: f64, tolerance: f64) -> Option<f64> {
        let turn = |axis: usize| {
            let t = if before[axis] * v[axis] < 0.0 { v[axis] / pull[axis] } else { 0.0 };
            (t > 0.0 && self.bends(axis, (*v, *pull), t.min(h), h, tolerance)).then_some(t)
        };
        let (x, y) = (turn(0), turn(1));
        if x > y { x } else { y }
    }

    /// Whether the corner of the drag at a turn, `t` seconds from an end of a step of `h` seconds, adds more than a tenth of the error allowed, m.
    fn bends(&self, axis: usize, (v, pull): (DVec2, DVec2), t: f64, h: f64, tolerance: f64) -> bool {
        let (drag, gain, beside) = (&self.bath.drag, pull[axis].abs(), v[1 - axis].abs());
        let rate = if beside < gain * h { drag.round } else { 0.0 } + if axis == 0 { drag.tall } else { drag.wide };
        rate * gain * (t * t) * h * (gain * t + beside) > 0.1 * tolerance
    }

    fn step(&self, (x, v): Pose, pull: DVec2, h: f64) -> Step {
        if let Some(slopes) = &self.slopes {
            let (end, error) = implicit::step(self.regime, self.constant, slopes, (x, v), h);
            return Step { end, pull: self.regime.pull(self.constant, end.0, end.1), error };
        }
        if let Some((law, _)) = self.regime.vertical(self.constant, x, v) {
            let ((y, v), last, [way, speed]) = pair((x.y, v.y), pull.y, h, |y, v| law.pull(y, v));
            return Step::along(x.x, (y, v), last, way.abs().max(speed.abs()));
        }
        let (end, pull, [way, speed]) = pair((x, v), pull, h, |x, v| self.regime.pull(self.constant, x, v));
        Step { end, pull, error: way.abs().max(speed.abs()).max_element() }
    }
}

/// One step of the pair from place and speed with the acceleration there: its end, the acceleration there, and the error of both, m.
#[inline(always)]
fn pair<T>((x, v): (T, T), pull: T, h: f64, law: impl Fn(T, T) -> T) -> ((T, T), T, [T; 2])
where
    T: Copy + Add<Output = T> + AddAssign + Mul<f64, Output = T>,
{
    let (mut speeds, mut pulls) = ([v; 7], [pull; 7]);
    let mut at;
    // Written out, so that the weights are known where they multiply.
    macro_rules! stages {
        ($($stage:literal)*) => {$({
            at = x + sum(&speeds, STAGES[$stage]) * h;
            let speed = v + sum(&pulls, STAGES[$stage]) * h;
            (speeds[$stage + 1], pulls[$stage + 1]) = (speed, law(at, speed));
        })*};
    }
    stages!(0 1 2 3 4 5);
    ((at, speeds[6]), pulls[6], [sum(&speeds, &ERROR) * h, sum(&pulls, &ERROR) * (h * h)])
}

#[derive(Clone, Copy, Default)]
pub(crate) struct Step {
    pub end: Pose,
    pub pull: DVec2,
    error: f64,
}

impl Step {
    fn along(x: f64, (y, v): (f64, f64), pull: f64, error: f64) -> Self {
        Self { end: (DVec2::new(x, y), DVec2::new(0.0, v)), pull: DVec2::new(0.0, pull), error }
    }
}

/// A body that bobs straight up and down, and the speed (m/s) below which it may be at rest.
#[derive(Clone, Copy, Default)]
pub(crate) struct Bob {
    pub x: DVec2,
    pub v: f64,
    pub pull: f64,
    pub slow: f64,
}

impl Bob {
    /// Whether [`Steps::take`] would leave a step of `h` seconds as it is: no turn, no kink, a small error.
    pub fn is_done_by(&self, &Step { end: (end, w), error, .. }: &Step, displaced: &Displaced, h: f64) -> bool {
        let Self { x, v, pull, slow } = *self;
        let third = h / 3.0;
        let heights = [x.y + v * (0.5 * h), x.y + (v + pull * (0.5 * h)) * h, x.y + v * third, end.y - w.y * third];
        let least = heights.iter().fold(end.y, |least, y| if *y < least { *y } else { least });
        let most = heights.iter().fold(end.y, |most, y| if *y > most { *y } else { most });
        v * (v + pull * h) > 0.0
            && v * w.y > 0.0
            && w.y.abs() > slow
            && error <= FLIGHT_TOLERANCE
            && displaced.holds_along([DVec2::new(x.x, least), DVec2::new(x.x, most)])
    }
}

/// Four of them, with their laws: while one waits for a result, the others go on.
#[derive(Clone, Copy, Default)]
pub(crate) struct Bobs {
    pub of: [Bob; 4],
    laws: Vertical<DVec4>,
}

impl Bobs {
    #[inline(always)]
    pub fn set(&mut self, k: usize, (bob, law): (Bob, Vertical)) {
        self.of[k] = bob;
        self.laws.0.iter_mut().zip(law.0).for_each(|(of, part)| of.as_mut()[k] = part);
    }

    /// A step of `h` seconds of each.
    #[inline(always)]
    pub fn step(&self, h: f64) -> [Step; 4] {
        let [a, b, c, d] = &self.of;
        let lanes = |part: fn(&Bob) -> f64| DVec4::new(part(a), part(b), part(c), part(d));
        let pose = (lanes(|bob| bob.x.y), lanes(|bob| bob.v));
        let ((y, v), last, [way, speed]) = pair(pose, lanes(|bob| bob.pull), h, |y, v| self.laws.pull(y, v));
        let error = way.with(speed, |way, speed| way.abs().max(speed.abs()));
        let step = |bob: &Bob, y, v, last, error| Step::along(bob.x.x, (y, v), last, error);
        [
            step(a, y.x, v.x, last.x, error.x),
            step(b, y.y, v.y, last.y, error.y),
            step(c, y.z, v.z, last.z, error.z),
            step(d, y.w, v.w, last.w, error.w),
        ]
    }
}

/// A body's part of a step of several.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CoupledStep {
    pub start: Pose,
    /// How far from there it is at the present stage, and how fast: bodies that move as one have the same bits, whatever their places.
    pub end: Pose,
    /// At the stages of the step.
    speeds: [DVec2; 7],
    pulls: [DVec2; 7],
    /// The acceleration at the present stage, m/s².
    pull: DVec2,
    /// Whether an acceleration differs from the first.
    pub bends: bool,
}

impl CoupledStep {
    pub fn new(start: Pose, pull: DVec2) -> Self {
        Self { start, end: (DVec2::ZERO, start.1), speeds: [start.1; 7], pulls: [pull; 7], pull, bends: false }
    }

    /// Goes to a stage of a step of `h` seconds.
    #[inline(always)]
    pub fn go_to(&mut self, weights: &[f64], h: f64) {
        self.end = (sum(&self.speeds, weights) * h, self.speeds[0] + sum(&self.pulls, weights) * h);
    }

    pub fn take(&mut self, stage: usize, pull: DVec2) {
        (self.speeds[stage], self.pulls[stage], self.pull) = (self.end.1, pull, pull);
        self.bends |= pull != self.pulls[0];
    }

    /// m.
    #[inline(always)]
    pub fn error(&self, weights: &[f64], h: f64) -> f64 {
        (sum(&self.speeds, weights) * h).abs().max((sum(&self.pulls, weights) * (h * h)).abs()).max_element()
    }

    pub fn pose(&self) -> Pose {
        (self.start.0 + self.end.0, self.end.1)
    }

    /// The path through both ends of `h` seconds, from a time on, with the accelerations there; a cubic where contacts change just before the end.
    pub fn course(&self, since: f64, h: f64, changes: bool) -> Quintic {
        let Self { start: (x, v), end: (way, w), .. } = *self;
        let b = if changes { (6.0 * way / h - 2.0 * v - 4.0 * w) / -h } else { self.pull };
        Quintic::through(since, [x, v, self.pulls[0]], [way, w, b], h)
    }
}

#[inline(always)]
fn sum<T: Copy + AddAssign + Mul<f64, Output = T>>(of: &[T; 7], weights: &[f64]) -> T {
    let mut sum = of[0] * weights[0];
    // By number: the compiler writes it out.
    for k in 1..weights.len() {
        if weights[k] != 0.0 {
            sum += of[k] * weights[k];
        }
    }
    sum
}

/// The stages of the pair but the first; the last is its result.
const STAGES: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19_372.0 / 6561.0, -25_360.0 / 2187.0, 64_448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46_732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18_656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// The difference of its results of fifth and fourth order.
const ERROR: [f64; 7] = [71.0 / 57_600.0, 0.0, -71.0 / 16_695.0, 71.0 / 1920.0, -17_253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];

/// Its stages but the first, of which the last is its result, when they are in parts of a step, and the weights of its error.
pub(crate) struct RungeKutta {
    pub stages: &'static [&'static [f64]],
    pub times: &'static [f64],
    pub error: &'static [f64],
}

pub(crate) const FIFTH_ORDER: RungeKutta =
    RungeKutta { stages: &STAGES, times: &[0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0], error: &ERROR };
/// P. Bogacki and L. F. Shampine (1989), without an estimate of the error, for steps in which little changes: half as many solutions of contacts.
pub(crate) const THIRD_ORDER: RungeKutta =
    RungeKutta { stages: &[&[0.5], &[0.0, 0.75], &[2.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0]], times: &[0.5, 0.75, 1.0], error: &[0.0] };

/// The factor for the next step, given a root of the error as a part of the error allowed: the fourth one stands for the fifth.
pub(crate) fn step_factor(root: f64) -> f64 {
    let factor = 0.75 / root;
    // A step whose error is no number is too long.
    if factor >= 0.05 { factor.min(3.0) } else { 0.05 }
}
