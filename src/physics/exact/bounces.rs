//! The bounces of two things on each other in closed form: where they are relative to each other, and how fast, at any time of all of them.

/// From a rebound on, m/s and m/s²: up with `rises` against a pull that `falls`, along with `slides` and `pulled` by a force. Each bounce keeps `e` of
/// its speed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounces {
    pub e: f64,
    pub friction: f64,
    pub rises: f64,
    pub falls: f64,
    pub slides: f64,
    pub pulled: f64,
    /// Rate of its drag, 1/s. Under a pull a and drag c·v a bounce comes back slower by (2c/3a)·v², and takes 2v/a.
    pub damping: f64,
}

/// After a number of bounces: s, m along, m/s up and along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct After {
    pub time: f64,
    way: f64,
    rises: f64,
    slides: f64,
}

impl Bounces {
    /// Duration of the first, s.
    pub fn first(&self) -> f64 {
        2.0 * self.rises / self.falls
    }

    /// Of a number of bounces, the sum of eʲ, j from 0.
    fn sum(&self, power: f64, count: f64) -> f64 {
        if self.e == 1.0 { count } else { libm::expm1(count * power * libm::log(self.e)) / libm::expm1(power * libm::log(self.e)) }
    }

    /// How long that many take. With δ = (c/3)·first the speeds fall as eʲ/(1 + δΣeᵏ).
    pub fn lasts(&self, count: f64) -> f64 {
        let (all, slowing) = (self.first() * self.sum(1.0, count), self.damping / 3.0);
        if slowing == 0.0 { all } else { libm::log1p(slowing * all) / slowing }
    }

    /// How many take that long.
    fn count(&self, time: f64) -> f64 {
        let slowing = self.damping / 3.0;
        let all = if slowing == 0.0 { time } else { libm::expm1(slowing * time) / slowing } / self.first();
        let left = 1.0 - all * (1.0 - self.e);
        if self.e == 1.0 {
            all
        } else if left <= 0.0 {
            f64::INFINITY
        } else {
            libm::log1p(-all * (1.0 - self.e)) / libm::log(self.e)
        }
    }

    /// Which way it slides, and what brakes that on average: each bounce with w takes 2w/falls and rubs μ(1 + e)·w off.
    fn brakes(&self) -> (f64, f64) {
        let way = if self.slides == 0.0 { self.pulled } else { self.slides };
        let way = if way == 0.0 { 0.0 } else { way.signum() };
        (way, self.pulled - way * 0.5 * self.friction * (1.0 + self.e) * self.falls)
    }

    /// After how many bounces friction has stopped its slide, and whether it holds it then.
    pub fn stops_after(&self) -> (f64, bool) {
        let ((way, brake), holds) = (self.brakes(), self.pulled.abs() <= 0.5 * self.friction * (1.0 + self.e) * self.falls);
        let count = if self.slides == 0.0 && holds {
            0.0
        } else if way * brake < 0.0 {
            self.count(-self.slides / brake).ceil().max(1.0)
        } else {
            f64::INFINITY
        };
        (count, holds)
    }

    pub fn after(&self, count: f64) -> After {
        let (first, slowing, (_, brake), stops) = (self.first(), self.damping / 3.0, self.brakes(), self.stops_after().0);
        // The sum of the squares of their times.
        let squares = |count: f64| first * first * self.sum(2.0, count) / (1.0 + slowing * first * self.sum(1.0, count));
        let (sliding, time) = (count.min(stops), self.lasts(count));
        let (slid, of_slide) = (self.lasts(sliding), squares(sliding));
        let way = (self.slides + 0.5 * brake * slid) * slid - 0.5 * brake * of_slide + 0.5 * self.pulled * squares(count);
        let kept = if self.e == 1.0 { 1.0 } else { libm::exp(count * libm::log(self.e)) };
        let rises = self.rises * kept / (1.0 + slowing * first * self.sum(1.0, count));
        After { time, way, rises, slides: if stops.is_finite() && count >= stops { 0.0 } else { self.slides + brake * slid } }
    }

    /// The ways up and along at a time, and the speeds; after the last bounce if `over`.
    pub fn at(&self, time: f64, over: bool) -> [[f64; 2]; 2] {
        let count = if over { f64::INFINITY } else { self.count(time).floor().max(0.0) };
        let After { time: before, way, rises, slides } = self.after(count);
        if count.is_infinite() {
            return [[0.0, way], [0.0, slides]];
        }
        let late = (time - before).max(0.0);
        let height = (rises - 0.5 * self.falls * late) * late;
        let along = way + (slides + 0.5 * self.pulled * late) * late;
        [[height.max(0.0), along], [rises - self.falls * late, slides + self.pulled * late]]
    }
}
