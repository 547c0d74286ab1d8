//! When two boxes meet: crossings are bracketed on the monotone pieces of cubics and found by Newton's method inside: none is missed at any speed.

use crate::physics::data::{aabb::Aabb, surface::Sides, tuning::SLOP, tuning::SPEED_TOLERANCE};
use glam::DVec2;

/// x(t) = c₀ + c₁t + c₂t² + c₃t³, m, for each axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Cubic {
    pub c: [DVec2; 4],
}

impl Cubic {
    /// The box around a box on it for `t` seconds, m.
    pub fn swept(&self, half: DVec2, t: f64) -> Aabb {
        let (x, y) = (self.axis(0).bounds(t), self.axis(1).bounds(t));
        Aabb::new(DVec2::new(x.0, y.0) - half, DVec2::new(x.1, y.1) + half)
    }

    pub fn parabola(x: DVec2, v: DVec2, a: DVec2) -> Self {
        Self { c: [x, v, a * 0.5, DVec2::ZERO] }
    }

    /// The cubic through both ends of an interval of `t` seconds with the velocities there.
    pub fn hermite(x0: DVec2, v0: DVec2, x1: DVec2, v1: DVec2, t: f64) -> Self {
        let mean = (x1 - x0) / t;
        Self { c: [x0, v0, (3.0 * mean - 2.0 * v0 - v1) / t, (v0 + v1 - 2.0 * mean) / (t * t)] }
    }

    pub fn from(&self, t: f64) -> Self {
        if t == 0.0 {
            return *self;
        }
        let [x, v, a, j] = self.c;
        Self { c: [x + (v + (a + j * t) * t) * t, v + (2.0 * a + 3.0 * j * t) * t, a + 3.0 * j * t, j] }
    }

    pub fn relative(&self, other: &Self) -> Self {
        let ([x, v, a, j], of) = (other.c, self.c);
        Self { c: [x - of[0], v - of[1], a - of[2], j - of[3]] }
    }

    pub fn stands(&self) -> bool {
        self.c[1..].iter().all(|c| *c == DVec2::ZERO)
    }

    pub fn axis(&self, axis: usize) -> Polynomial {
        // `map` calls a function for each part.
        let [x, v, a, j] = self.c;
        Polynomial(if axis == 0 { [x.x, v.x, a.x, j.x] } else { [x.y, v.y, a.y, j.y] })
    }
}

/// A path of fifth degree from a time on, s from the tick's start.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Quintic {
    since: f64,
    c: [DVec2; 6],
}

impl Quintic {
    /// From a place (m) with a velocity and an acceleration by a `way` to others `h` seconds later.
    pub fn through(since: f64, [x, v, a]: [DVec2; 3], [way, w, b]: [DVec2; 3], h: f64) -> Self {
        let (p, q, r) = (way - (v + a * (0.5 * h)) * h, (w - v - a * h) * h, (b - a) * (0.5 * h * h));
        let third = h * h * h;
        let of = |sum: DVec2| sum / third;
        let last = of(6.0 * p - 3.0 * q + r) / (h * h);
        Self { since, c: [x, v, a * 0.5, of(10.0 * p - 4.0 * q + r), of(7.0 * q - 15.0 * p - 2.0 * r) / h, last] }
    }

    pub fn pose(&self, at: f64) -> (DVec2, DVec2) {
        let (t, c) = (at - self.since, &self.c);
        let place = c[0] + (c[1] + (c[2] + (c[3] + (c[4] + c[5] * t) * t) * t) * t) * t;
        (place, c[1] + (2.0 * c[2] + (3.0 * c[3] + (4.0 * c[4] + 5.0 * c[5] * t) * t) * t) * t)
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Polynomial(pub [f64; 4]);

impl Polynomial {
    pub fn stands(&self) -> bool {
        let [_, v, a, j] = self.0;
        (v == 0.0) & (a == 0.0) & (j == 0.0)
    }

    pub fn at(&self, t: f64) -> f64 {
        let c = &self.0;
        c[0] + t * (c[1] + t * (c[2] + t * c[3]))
    }

    pub fn slope(&self, t: f64) -> f64 {
        let c = &self.0;
        c[1] + t * (2.0 * c[2] + t * 3.0 * c[3])
    }

    pub fn curvature(&self, t: f64) -> f64 {
        2.0 * self.0[2] + 6.0 * self.0[3] * t
    }

    /// Bounds of its values on [0, t]: the hull of its Bézier points.
    pub fn bounds(&self, t: f64) -> (f64, f64) {
        let (c, third) = (&self.0, t / 3.0);
        let (p0, p3) = (c[0], self.at(t));
        let p1 = p0 + c[1] * third;
        let p2 = p1 + (c[1] + c[2] * t) * third;
        (p0.min(p1).min(p2.min(p3)), p0.max(p1).max(p2.max(p3)))
    }

    pub fn until(self, end: f64) -> Stretch {
        Stretch { path: self, end, bounds: self.bounds(end) }
    }

    /// The roots of the slope in ascending order; infinite where there are none.
    fn turning_points(&self) -> (f64, f64) {
        let (a, b, c) = (3.0 * self.0[3], self.0[2], self.0[1]);
        let discriminant = b * b - a * c;
        if discriminant < 0.0 || (a == 0.0 && b == 0.0) {
            return (f64::INFINITY, f64::INFINITY);
        }
        // The form that subtracts no like numbers.
        let q = -(b + discriminant.sqrt().copysign(b));
        let (s, t) = (if a == 0.0 { f64::INFINITY } else { q / a }, if q == 0.0 { 0.0 } else { c / q });
        (s.min(t), s.max(t))
    }

    /// The root between `begin` (positive) and `end` (not positive), the function falling in between.
    fn root(&self, mut begin: f64, mut end: f64) -> f64 {
        let mut t = begin;
        // Within four roundings of its bracket Newton's method has converged.
        let converged = 4.0 * f64::EPSILON;
        for _ in 0..60 {
            let (value, slope) = (self.at(t), self.slope(t));
            (begin, end) = if value > 0.0 { (t, end) } else { (begin, t) };
            let newton = t - value / slope;
            let next = if newton > begin && newton < end {
                newton
            } else if newton >= end && newton - end <= converged * end {
                end.next_down()
            } else if newton <= begin && begin - newton <= converged * begin {
                begin.next_up()
            } else {
                0.5 * (begin + end)
            };
            if next == t || next <= begin || next >= end {
                break;
            }
            t = next;
        }
        end
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    path: Polynomial,
    end: f64,
    pub bounds: (f64, f64),
}

impl Stretch {
    /// The first t in (from, end] at which it falls to `level`, or falls back from a rise that ended within [`SLOP`] below: boxes that come back.
    pub fn falls_through(&self, level: f64, from: f64) -> Option<f64> {
        let (least, most) = self.bounds;
        if least > level + SLOP || most < level - 3.0 * SLOP {
            return None;
        }
        self.find_fall(level, from)
    }
    pub fn rises_through(&self, level: f64, from: f64) -> Option<f64> {
        let (least, most) = self.bounds;
        let [x, v, a, j] = self.path.0;
        Self { path: Polynomial([-x, -v, -a, -j]), end: self.end, bounds: (-most, -least) }.falls_through(-level, from)
    }

    fn find_fall(&self, level: f64, from: f64) -> Option<f64> {
        let [c0, c1, c2, c3] = self.path.0;
        let shifted = Polynomial([c0 - level, c1, c2, c3]);
        let (first, second) = shifted.turning_points();
        let mut begin = from;
        for stop in [first, second, self.end] {
            let stop = stop.min(self.end).max(begin);
            let (high, low) = (shifted.at(begin), shifted.at(stop));
            if high > 0.0 && low <= 0.0 {
                return Some(shifted.root(begin, stop));
            }
            if begin > from && low < high && (-2.0 * SLOP..=0.0).contains(&high) {
                return Some(begin);
            }
            begin = stop;
        }
        None
    }
}

/// How far boxes that met along both axes at once overlap along the `other` one at least, m, when they are the slop deep along an axis on which they
/// close with `closing` m/s: half of what they must. So the faster axis is hit, and what slides along a face never meets it.
fn least_at_a_corner(closing: f64, other: &Polynomial, t: f64) -> f64 {
    let closes = -other.at(t).signum() * other.slope(t);
    if closes > SPEED_TOLERANCE { 0.5 * SLOP * (closes / closing.abs()).min(1.0) } else { f64::INFINITY }
}

/// The first time in (0, end] at which boxes whose halves sum to `reach` meet, and the axis; `motion` is that of the second relative to the first,
/// `sides` are the solid ones of the second. Boxes that touch meet again only after they have parted.
pub(crate) fn time_of_impact(motion: &Cubic, reach: DVec2, end: f64, sides: Sides) -> Option<(f64, usize)> {
    let paths = [motion.axis(0).until(end), motion.axis(1).until(end)];
    if (0..2).any(|axis| paths[axis].bounds.0 >= reach[axis] || paths[axis].bounds.1 <= -reach[axis]) {
        return None;
    }
    let mut first: Option<(f64, usize)> = None;
    // The second level catches a corner that met both faces at once, when neither overlapped along the other axis yet.
    for depth in [0.0, SLOP] {
        for axis in 0..2 {
            let (path, other) = (&paths[axis], &paths[1 - axis].path);
            let level = reach[axis] - depth;
            let mut from = 0.0;
            let fall = |from: f64| if sides.face(axis, false) { path.falls_through(level, from) } else { None };
            let rise = |from: f64| if sides.face(axis, true) { path.rises_through(-level, from) } else { None };
            while let Some(t) = earliest(fall(from), rise(from)) {
                if first.is_some_and(|(best, _)| best <= t) {
                    break;
                }
                let overlap = reach[1 - axis] - other.at(t).abs();
                if overlap > SLOP || depth > 0.0 && overlap >= least_at_a_corner(path.path.slope(t), other, t) {
                    first = Some((t, axis));
                    break;
                }
                if t <= from {
                    break;
                }
                from = t;
            }
        }
        if first.is_some() {
            break;
        }
    }
    first
}

pub(crate) fn earliest(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.into_iter().chain(b).reduce(f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn straight(x: DVec2, v: DVec2) -> Cubic {
        Cubic::parabola(x, v, DVec2::ZERO)
    }

    #[test]
    fn a_falling_box_meets_the_floor_when_the_quadratic_says_so() {
        let motion = Cubic::parabola(DVec2::new(0.0, -5.0), DVec2::ZERO, DVec2::new(0.0, 10.0));
        let (t, axis) = time_of_impact(&motion, DVec2::splat(1.0), 2.0, Sides::ALL).unwrap();
        assert_eq!(axis, 1);
        assert!((t - 0.8f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn nothing_jumps_over_a_thin_wall() {
        let hit = time_of_impact(
            &straight(DVec2::new(-50.0, 0.0), DVec2::new(8333.0, 0.0)),
            DVec2::new(0.11, 1.0),
            1.0 / 60.0,
            Sides::ALL,
        );
        assert!(matches!(hit, Some((_, 0))));
    }

    #[test]
    fn passing_by_is_no_hit_and_touching_along_the_other_axis_is_none() {
        let reach = DVec2::splat(1.0);
        assert_eq!(time_of_impact(&straight(DVec2::new(-5.0, 1.5), DVec2::new(10.0, 0.0)), reach, 2.0, Sides::ALL), None);
        assert_eq!(time_of_impact(&straight(DVec2::new(-5.0, 1.0), DVec2::new(10.0, 0.0)), reach, 2.0, Sides::ALL), None);
    }

    #[test]
    fn a_corner_met_exactly_is_a_hit() {
        let hit = time_of_impact(&straight(DVec2::new(-2.0, -2.0), DVec2::new(1.0, 1.0)), DVec2::splat(1.0), 2.0, Sides::ALL);
        assert!((hit.unwrap().0 - 1.0).abs() < 1e-8);
        for (at, v) in [(12.5, 16.0), (11.0, 64.0), (7.3, 9.1)] {
            let hit = time_of_impact(&straight(DVec2::splat(-at), DVec2::splat(v)), DVec2::splat(1.0), 4.0, Sides::ALL);
            assert!((hit.unwrap().0 - (at - 1.0) / v).abs() < 1e-9);
        }
    }

    #[test]
    fn a_corner_is_met_along_the_faster_axis() {
        for (v, axis) in
            [(DVec2::new(3.0, 1.0), 0), (DVec2::new(1.0, 3.0), 1), (DVec2::new(-900.0, 1.0), 0), (DVec2::new(-1.0, -40.0), 1)]
        {
            let hit = time_of_impact(&straight(-DVec2::splat(1.0) * v.signum() - v, v), DVec2::splat(1.0), 2.0, Sides::ALL);
            assert!(hit.is_some_and(|(t, of)| (t - 1.0).abs() < 1e-8 && of == axis), "{v}: {hit:?}");
        }
    }

    #[test]
    fn boxes_that_part_and_come_back_meet_again() {
        let motion = Cubic::parabola(DVec2::new(0.0, -1.0), DVec2::new(0.0, -1.0), DVec2::new(0.0, 2.0));
        let (t, _) = time_of_impact(&motion, DVec2::splat(1.0), 2.0, Sides::ALL).unwrap();
        assert!((t - 1.0).abs() < 1e-15);
    }
}
