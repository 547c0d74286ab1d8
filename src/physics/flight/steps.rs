//! Steps through liquids by their own estimate of their error: explicit ones, the embedded Runge–Kutta pair of J. R. Dormand and P. J. Prince
//! (1980), of fifth order; or, where drag has taken a body to the speed that its place gives it and would cut those short, implicit ones
//! ([`crate::physics::flight::implicit`]).
//!
//! No step is taken across what bends the law: a kink, where a side of the body passes a side of a liquid ([`crate::physics::forces::displaced`]), or a turn,
//! where a component of the velocity changes its sign and drag with it (|u|·u has a corner at 0). Small turns are passed over: what a corner
//! `τ` seconds from the end of a step of `h` seconds is worth is about k·a²·τ³·h, with k the drag per m and a the acceleration.

use crate::physics::data::impact_time::Cubic;
use crate::physics::flight::flow::Pose;
use crate::physics::flight::implicit;
use crate::physics::flight::liquid::{Taken, step_factor};
use crate::physics::forces::bath::{Bath, Regime, Slopes};
use crate::physics::forces::media::Media;
use glam::DVec2;

/// m. Error of one step, at most, by its own estimate. Larger: the tick shows in a splash; smaller: more steps for digits nobody sees.
const TOLERANCE: f64 = 1e-9;
/// What a turn may be worth of that.
const PART_OF_A_TURN: f64 = 0.1;
/// How often the end of a step is brought nearer to a turn.
const MOST_CUTS: u32 = 3;
/// Rate × time that a first step may always have, and its error for a·ω³·h⁵ = 1.
const SHORT: f64 = 0.25;
const ERROR_OF_FIRST: f64 = 1e-4;
/// By which part of itself a speed may change in an implicit step.
const MOST_CHANGE: f64 = 0.5;

/// A body somewhere between kinks: what media do where it is, and its constant acceleration, m/s².
pub(crate) struct Steps<'a> {
    pub media: &'a Media,
    pub regime: &'a Regime<'a>,
    pub bath: &'a Bath,
    pub constant: DVec2,
    /// The law where a step begins, linearised, where it is to be implicit.
    pub slopes: Option<Slopes>,
}

impl Steps<'_> {
    /// How long the first of some steps may be, in a law of that `rate`, 1/s: the error is about [`ERROR_OF_FIRST`]·a·ω³·h⁵, and a fourth root that
    /// is quickly found errs on the side of caution.
    pub fn first(&self, v: DVec2, rate: f64, left: f64) -> f64 {
        if rate * left < SHORT {
            return left;
        }
        let pull = self.bath.acceleration(self.constant, v).length();
        (TOLERANCE * (rate * rate) / (ERROR_OF_FIRST * pull)).sqrt().sqrt() / rate
    }

    /// One step of at most `h` of the `left` seconds.
    ///
    /// # Errors
    /// How short a step would still resolve too little.
    pub fn take(&self, pose: Pose, mut h: f64, left: f64) -> Result<Taken, f64> {
        let (x, v) = pose;
        let least = TOLERANCE + 8.0 * f64::EPSILON * x.abs().max_element();
        let rough = self.media.roughness();
        let shortest = left * f64::EPSILON;
        let pull = self.bath.acceleration(self.constant, v);
        let mut next = h;
        let (mut to_kink, mut shrunk) = (false, false);
        if !self.regime.holds_along([x + v * (0.5 * h), x + (v + pull * (0.5 * h)) * h])
            && let Some(kink) = self.regime.end_of(&Cubic::parabola(x, v, pull), h)
        {
            (h, to_kink) = (kink.max(shortest), true);
        }
        if self.slopes.is_none()
            && let Some(turn) = self.turn_ahead(v, pull, h, least)
        {
            (h, to_kink) = (turn.max(shortest), false);
        }
        let mut cuts = 0;
        loop {
            let Step { end, pull: last, error } = self.step(pose, pull, h);
            let tolerance = least + rough * (end.0 - x).abs().max_element();
            // Drag that grows with the speed is told by no slope where the speed is another one.
            let even = self.slopes.is_none() || (end.1 - v).length() <= MOST_CHANGE * v.length();
            let fits = even && error <= tolerance && end.0.is_finite() && end.1.is_finite();
            if !fits && h <= shortest {
                return Err(h);
            }
            if !fits {
                h *= step_factor((error / tolerance).sqrt().sqrt()).min(0.5);
                (next, to_kink, shrunk) = (h, false, true);
                continue;
            }
            if cuts < MOST_CUTS
                && let Some(since) = self.since_turn(v, end.1, last, h, tolerance)
            {
                cuts += 1;
                (h, to_kink) = ((h - since).max(0.1 * h), false);
                continue;
            }
            let third = h / 3.0;
            let way = || Cubic::hermite(x, v, end.0, end.1, h);
            if !self.regime.holds_along([x + v * third, end.0 - end.1 * third, end.0])
                && let Some(kink) = self.regime.end_of(&way(), h)
                && kink < h
                && h > shortest
                && !(to_kink && self.regime.all_but_holds(end.0))
            {
                (h, to_kink) = (kink.max(shortest), true);
                continue;
            }
            if h >= next && !shrunk {
                next = h * step_factor((error / tolerance).sqrt().sqrt());
            }
            return Ok(Taken { time: h, end, next, pull: Some(last) });
        }
    }

    /// When a component of the velocity is going to change its sign within `h` seconds, if that bends the law.
    fn turn_ahead(&self, v: DVec2, pull: DVec2, h: f64, tolerance: f64) -> Option<f64> {
        let turn = |axis: usize| {
            let t = -v[axis] / pull[axis];
            (t > 0.0 && t < h && self.worth(axis, v, pull, (t.min(h - t), h)) > PART_OF_A_TURN * tolerance).then_some(t)
        };
        crate::physics::data::impact_time::earliest(turn(0), turn(1))
    }

    /// How long before the end of a step of `h` seconds a component of the velocity has changed its sign, if that bends the law.
    fn since_turn(&self, before: DVec2, v: DVec2, pull: DVec2, h: f64, tolerance: f64) -> Option<f64> {
        let turn = |axis: usize| {
            let t = if before[axis] * v[axis] < 0.0 { v[axis] / pull[axis] } else { 0.0 };
            (t > 0.0 && self.worth(axis, v, pull, (t.min(h), h)) > PART_OF_A_TURN * tolerance).then_some(t)
        };
        let (x, y) = (turn(0), turn(1));
        if x > y { x } else { y }
    }

    /// What the corner of the drag along an axis is worth that lies so many seconds from an end of a step, m.
    fn worth(&self, axis: usize, v: DVec2, pull: DVec2, (t, h): (f64, f64)) -> f64 {
        let (drag, gain, beside) = (&self.bath.drag, pull[axis].abs(), v[1 - axis].abs());
        let round = if beside < gain * h { drag.round } else { 0.0 };
        let rate = round + if axis == 0 { drag.tall } else { drag.wide };
        rate * gain * (t * t) * h * (gain * t + beside)
    }

    /// One step of the pair from where the acceleration is `pull`.
    #[inline]
    fn step(&self, (x, v): Pose, pull: DVec2, h: f64) -> Step {
        if let Some(slopes) = &self.slopes {
            let (end, error) = implicit::step(self.regime, self.constant, slopes, (x, v), h);
            return Step { end, pull: self.regime.pull(self.constant, end.0, end.1), error };
        }
        let (mut speeds, mut pulls) = ([v; 7], [pull; 7]);
        self.stage(&mut speeds, &mut pulls, (x, h), SECOND);
        self.stage(&mut speeds, &mut pulls, (x, h), THIRD);
        self.stage(&mut speeds, &mut pulls, (x, h), FOURTH);
        self.stage(&mut speeds, &mut pulls, (x, h), FIFTH);
        self.stage(&mut speeds, &mut pulls, (x, h), SIXTH);
        let end = self.stage(&mut speeds, &mut pulls, (x, h), RESULT);
        let error = (sum(&speeds, ERROR) * h).abs().max((sum(&pulls, ERROR) * (h * h)).abs());
        Step { end: (end, speeds[6]), pull: pulls[6], error: error.max_element() }
    }

    /// Adds the velocity and the acceleration of the stage that follows `N` others; returns its place.
    #[inline]
    fn stage<const N: usize>(
        &self,
        speeds: &mut [DVec2; 7],
        pulls: &mut [DVec2; 7],
        (x, h): (DVec2, f64),
        weights: [f64; N],
    ) -> DVec2 {
        let (at, speed) = (x + sum(speeds, weights) * h, speeds[0] + sum(pulls, weights) * h);
        (speeds[N], pulls[N]) = (speed, self.regime.pull(self.constant, at, speed));
        at
    }
}

/// Where a step leads, the acceleration there, and its error, m.
struct Step {
    end: Pose,
    pull: DVec2,
    error: f64,
}

#[inline]
fn sum<const N: usize>(of: &[DVec2; 7], weights: [f64; N]) -> DVec2 {
    let mut sum = of[0] * weights[0];
    for i in 1..N {
        if weights[i] != 0.0 {
            sum += of[i] * weights[i];
        }
    }
    sum
}

/// The stages of the pair.
const SECOND: [f64; 1] = [1.0 / 5.0];
const THIRD: [f64; 2] = [3.0 / 40.0, 9.0 / 40.0];
const FOURTH: [f64; 3] = [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0];
const FIFTH: [f64; 4] = [19_372.0 / 6561.0, -25_360.0 / 2187.0, 64_448.0 / 6561.0, -212.0 / 729.0];
const SIXTH: [f64; 5] = [9017.0 / 3168.0, -355.0 / 33.0, 46_732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18_656.0];
pub(crate) const RESULT: [f64; 6] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
/// The difference of its results of fifth and fourth order.
pub(crate) const ERROR: [f64; 7] =
    [71.0 / 57_600.0, 0.0, -71.0 / 16_695.0, 71.0 / 1920.0, -17_253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
/// All stages but the first.
pub(crate) const STAGES: [&[f64]; 6] = [&SECOND, &THIRD, &FOURTH, &FIFTH, &SIXTH, &RESULT];
