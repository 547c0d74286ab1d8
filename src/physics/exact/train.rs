//! Trains of bounces in closed form; and, hit by hit, what bounces to and fro between a wall and another body without loss.

use crate::physics::data::{Aabb, Pose, on_axis};
use glam::DVec2;

/// One body's part in a train.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Train {
    pub members: [u32; 3],
    pub axis: usize,
    /// On which side of the next member each is, or in a row of the one before: 1 or −1.
    pub side: f64,
    /// s from the tick's start; whether no bounce is left then.
    pub until: f64,
    pub over: bool,
    /// The box in which it stays, m.
    pub way: Aabb,
    /// Its acceleration without bounces, m/s².
    pub pull: DVec2,
    pub kind: TrainKind,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum TrainKind {
    /// A part of how the first moves relative to the second; both are carried with a velocity and an acceleration.
    Bounces(BounceSeries, f64, [DVec2; 2]),
    /// That member of a row.
    Wedge(Wedge, usize),
}

impl Train {
    /// At a time, s from the tick's start, `t` seconds after the pose in which it began.
    pub fn pose(&self, (place, speed): Pose, t: f64, at: f64) -> Pose {
        match self.kind {
            TrainKind::Bounces(of, part, [v, a]) => {
                let [way, moves] =
                    of.at(t, self.over && at >= self.until).map(|[up, along]| on_axis(self.axis, self.side * up, along));
                (place + (v + a * (0.5 * t)) * t + way * part, v + a * t + moves * part)
            }
            TrainKind::Wedge(of, member) => {
                let ([way, moves], across) = (of.at(t)[member], speed[1 - self.axis]);
                (place + on_axis(self.axis, self.side * way, across * t), on_axis(self.axis, self.side * moves, across))
            }
        }
    }
}

/// From a rebound on, m/s and m/s²: up with `rises` against a pull that `falls`, along with `slides` and `pulled` by a force. A bounce keeps `e` of
/// its speed w, takes 2w/falls, rubs μ(1 + e)·w off the slide, and with drag of the rate c = `damping` (1/s) is back slower by (2c/3falls)·w².
#[derive(Clone, Copy, Debug)]
pub(crate) struct BounceSeries {
    pub e: f64,
    pub friction: f64,
    pub rises: f64,
    pub falls: f64,
    pub slides: f64,
    pub pulled: f64,
    pub damping: f64,
}

impl BounceSeries {
    /// Duration of the first, s.
    pub fn first(&self) -> f64 {
        2.0 * self.rises / self.falls
    }

    /// Σ(eʲ)ᵖ over that many bounces.
    fn sum(&self, power: f64, count: f64) -> f64 {
        if self.e == 1.0 { count } else { libm::expm1(count * power * libm::log(self.e)) / libm::expm1(power * libm::log(self.e)) }
    }

    /// How long that many take. With δ = (c/3)·first, speeds fall as eʲ/(1 + δΣeᵏ).
    pub fn lasts(&self, count: f64) -> f64 {
        let (all, slowing) = (self.first() * self.sum(1.0, count), self.damping / 3.0);
        if slowing == 0.0 { all } else { libm::log1p(slowing * all) / slowing }
    }

    /// How long all of them take.
    pub fn whole(&self) -> f64 {
        if self.e < 1.0 { self.lasts(f64::INFINITY) } else { f64::INFINITY }
    }

    /// How many take that long.
    fn count(&self, time: f64) -> f64 {
        let slowing = self.damping / 3.0;
        let all = if slowing == 0.0 { time } else { libm::expm1(slowing * time) / slowing } / self.first();
        if self.e == 1.0 { all } else { libm::log1p((-all * (1.0 - self.e)).max(-1.0)) / libm::log(self.e) }
    }

    /// What brakes the slide on average, m/s²; after how many bounces it stops, and whether friction holds it then.
    pub fn brakes(&self) -> (f64, f64, bool) {
        let rubs = 0.5 * self.friction * (1.0 + self.e) * self.falls;
        let (way, holds) = (if self.slides == 0.0 { self.pulled } else { self.slides }, self.pulled.abs() <= rubs);
        let brake = if way == 0.0 { 0.0 } else { self.pulled - rubs * way.signum() };
        if self.slides == 0.0 && holds {
            return (brake, 0.0, true);
        }
        (brake, if self.slides * brake < 0.0 { self.count(-self.slides / brake).ceil() } else { f64::INFINITY }, holds)
    }

    /// The ways up and along at a time, and the speeds; after the last bounce if `over`.
    pub fn at(&self, time: f64, over: bool) -> [[f64; 2]; 2] {
        // Drag has left e⁻³⁰⁰ of the first: no more is a number. Those are bounces without end, and their sums finite.
        let worn = self.damping / 3.0 * time > 300.0;
        let whole = if self.e < 1.0 { f64::INFINITY } else { 1e300 };
        let count = if over || worn { whole } else { self.count(time).floor().max(0.0) };
        let (first, (brake, stops, _)) = (self.first(), self.brakes());
        let slower = |count: f64| 1.0 + self.damping / 3.0 * first * self.sum(1.0, count);
        // The sum of the squares of their times.
        let squares = |count: f64| first * first * self.sum(2.0, count) / slower(count);
        let slid = if worn { self.lasts(stops).min(time) } else { self.lasts(count.min(stops)) };
        let way =
            (self.slides + 0.5 * brake * slid) * slid + 0.5 * (self.pulled * squares(count) - brake * squares(count.min(stops)));
        let slides = if stops.is_finite() && count >= stops { 0.0 } else { self.slides + brake * slid };
        if over || worn {
            return [[0.0, way], [0.0, slides]];
        }
        let rises = self.rises / slower(count) * if self.e == 1.0 { 1.0 } else { libm::exp(count * libm::log(self.e)) };
        let late = (time - self.lasts(count)).max(0.0);
        let (height, along) = ((rises - 0.5 * self.falls * late) * late, way + (slides + 0.5 * self.pulled * late) * late);
        [[height.max(0.0), along], [rises - self.falls * late, slides + self.pulled * late]]
    }
}

/// Of the other body and of the one in between, which begins at the wall: kg, m, m/s and m/s². The wall moves with `wall`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wedge {
    pub wall: f64,
    pub masses: [f64; 2],
    pub gap: f64,
    pub speeds: [f64; 2],
    pub pulls: [f64; 2],
}

impl Wedge {
    /// How many hits come within a time, s, if the gap stays as it is.
    pub fn hits(&self, time: f64) -> f64 {
        (self.speeds[1] - self.speeds[0]) * time / self.gap.max(f64::MIN_POSITIVE)
    }

    /// The highest that the other body gets within a time, m: its energy is never more than that of both, and what pulls has given them.
    pub fn highest(&self, time: f64) -> f64 {
        let [far, middle] = self.speeds.map(|speed| (speed - self.wall) * (speed - self.wall));
        let ratio = self.masses[1] / self.masses[0];
        let pull = self.pulls[0].abs() + ratio * self.pulls[1].abs();
        self.gap + (self.wall.abs() + (far + middle * ratio + 2.0 * pull * self.gap).sqrt() + pull * time) * time
    }

    /// By how much each has moved after `time` seconds, and how fast it moves.
    pub fn at(&self, time: f64) -> [[f64; 2]; 2] {
        let ([mut y, mut x], [mut w, mut u]) = ([self.gap, 0.0], self.speeds.map(|speed| speed - self.wall));
        let ([b, a], sum, mut left) = (self.pulls, self.masses[0] + self.masses[1], time);
        // Bodies at the ends of the domain, 10⁻³ and 10⁵ kg, hit each other and a wall 31 416 times.
        for _ in 0..u16::MAX {
            let (to_other, to_wall) = (closes((y - x).max(0.0), u - w, a - b), closes(x.max(0.0), -u, -a));
            let t = to_other.min(to_wall).min(left);
            (x, y) = (x + (u + 0.5 * a * t) * t, y + (w + 0.5 * b * t) * t);
            (u, w, left) = (u + a * t, w + b * t, left - t);
            if left <= 0.0 {
                break;
            } else if to_other <= to_wall {
                let part = 2.0 * (u - w) / sum;
                (u, w, x) = (u - self.masses[0] * part, w + self.masses[1] * part, y);
            } else {
                (x, u) = (0.0, -u);
            }
        }
        [[y - self.gap + self.wall * time, w + self.wall], [x + self.wall * time, u + self.wall]]
    }
}

/// When a gap (m) closes that falls at a `rate` (m/s) which grows by `more` a second (m/s²), s; infinite where it does not.
fn closes(gap: f64, rate: f64, more: f64) -> f64 {
    let square = rate * rate + 2.0 * more * gap;
    if square < 0.0 || rate <= 0.0 && more <= 0.0 {
        f64::INFINITY
    } else if rate > 0.0 {
        2.0 * gap / (rate + square.sqrt())
    } else {
        (square.sqrt() - rate) / more
    }
}
