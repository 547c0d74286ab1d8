//! Restitution: impacts found by the plastic solve get their rebound after the move.
//!
//! A contact that had to stop more than [`IMPACT`] steps of gravity is an impact. Its closing speed is that at the moment of
//! touching, w² = v² + 2·a·gap; the pair leaves with e·w, e the larger restitution of the two, unless that is below the world's
//! rest speed. On what the ground holds only the upper body turns round; in the air both do, with equal and opposite impulses.
//! One after the other, rebounds can add up to more energy than there was (a body thrown by one neighbour is thrown again by the
//! next). So bodies that hit each other or were merged in the same step form a group, and where it would get back more energy than
//! its members lost, all its rebounds are made smaller by one factor: momentum is conserved whatever the factor. In the end the same is
//! asked of all bodies together.

use super::bodies::Bodies;
use super::clusters::Clusters;
use super::energy;

/// A contact that stops more than this many steps of gravity is an impact. Below 1: resting contacts bounce for ever.
const IMPACT: f64 = 2.0;
/// The smallest impact, m/s, where there is no gravity to compare with.
const SMALLEST: f64 = 1e-6;
/// Rounding of the energy of a group, as a part of it.
const ROUNDING: f64 = 1e-12;

/// The direction of a contact's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Left and right.
    Across,
    /// Up and down.
    Gravity,
}

/// An impact in this step, by inner numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Impact {
    pub a: u32,
    pub b: u32,
    pub axis: Axis,
    /// Closing speed when touching, m/s.
    pub speed: f64,
}

/// The impacts of one step.
#[derive(Clone, Debug, Default)]
pub(super) struct Impacts {
    pub all: Vec<Impact>,
    /// Bodies that were solved together.
    bonds: Vec<(u32, u32, Axis)>,
    threshold: f64,
    thrown: Vec<Thrown>,
    /// For each body: where in `thrown` it is, and one; 0 if it is not.
    place: Vec<u32>,
}

/// A body that takes part in a rebound.
#[derive(Clone, Copy, Debug)]
struct Thrown {
    body: u32,
    /// Another one of its group, itself if it is the first.
    group: u32,
    /// Its velocity along the axis before, m/s.
    before: f64,
    /// Of the whole group, kept by its first: the energy that was lost, J; what the rebounds give back at a part s of them is
    /// s·linear + s²·square.
    lost: f64,
    linear: f64,
    square: f64,
}

impl Impacts {
    pub fn new(count: usize) -> Self {
        Self {
            all: Vec::with_capacity(count),
            bonds: Vec::with_capacity(4 * count),
            threshold: 0.0,
            thrown: Vec::with_capacity(count),
            place: vec![0; count],
        }
    }

    pub fn clear(&mut self, gravity: f64, dt: f64) {
        self.all.clear();
        self.bonds.clear();
        self.threshold = (IMPACT * gravity.abs() * dt).max(SMALLEST);
    }

    /// Remembers a contact in which the solver stopped `excess` m/s.
    pub fn note(&mut self, a: usize, b: usize, axis: Axis, excess: f64) {
        if excess > self.threshold {
            self.all.push(Impact { a: a as u32, b: b as u32, axis, speed: excess });
        }
    }

    /// Remembers which bodies were merged along one axis, for they may have given each other energy.
    pub fn bind(&mut self, clusters: &Clusters, axis: Axis) {
        let n = self.place.len();
        for &i in &clusters.joined {
            let root = clusters.root(i as usize);
            if (i as usize) < n && root < n {
                self.bonds.push((i, root as u32, axis));
            }
        }
    }

    /// Finds the closing speeds when touching and forgets what did not close.
    pub fn measure(&mut self, bodies: &Bodies, dt: f64) {
        let (n, threshold) = (bodies.len(), self.threshold);
        self.all.retain_mut(|hit| {
            let (a, b) = (hit.a as usize, hit.b as usize);
            let (x, v, free, half) = match hit.axis {
                Axis::Across => (&bodies.x, &bodies.vx, &bodies.free_vx, &bodies.hx),
                Axis::Gravity => (&bodies.y, &bodies.vy, &bodies.free_vy, &bodies.hy),
            };
            let side = if x[b] >= x[a] { 1.0 } else { -1.0 };
            let gap = ((x[b] - x[a]).abs() - half[a] - half[b]).max(0.0);
            // What stands on the ground does not fall along with what falls on it.
            let held = b >= n || (hit.axis == Axis::Gravity && bodies.uy[b] == 0.0);
            let gained = (free[a] - v[a]) - if held { 0.0 } else { free[b] - v[b] };
            let before = side * (v[a] - v[b]);
            hit.speed = (before * before.abs() + 2.0 * side * gained / dt * gap).max(0.0).sqrt();
            hit.speed > threshold
        });
    }

    /// Gives every impact its rebound.
    pub fn rebound(&mut self, bodies: &mut Bodies, anchored: &[bool], rest_speed: f64, dt: f64) {
        for axis in [Axis::Across, Axis::Gravity] {
            self.throw(bodies, anchored, axis, rest_speed);
            if !self.thrown.is_empty() {
                self.widen(bodies, axis);
                self.restrain(bodies, axis, dt);
                self.balance(bodies, axis, dt);
            }
        }
    }

    /// Applies the impulses along one axis, one after the other, and groups whom they act on.
    fn throw(&mut self, bodies: &mut Bodies, anchored: &[bool], axis: Axis, rest_speed: f64) {
        let n = bodies.len();
        self.thrown.clear();
        for k in 0..self.all.len() {
            let hit = self.all[k];
            if hit.axis != axis {
                continue;
            }
            let (x, u) = match axis {
                Axis::Across => (&bodies.x, &mut bodies.ux),
                Axis::Gravity => (&bodies.y, &mut bodies.uy),
            };
            let (a, b) = (hit.a as usize, hit.b as usize);
            // Of a stack, a is the upper one. What rises is not held, whatever stopped it.
            let held = axis == Axis::Gravity && b < n && anchored[b] && bodies.free_vy[b] >= 0.0;
            let of_a = if a < n { 1.0 / bodies.mass[a] } else { 0.0 };
            let of_b = if b < n && !held { 1.0 / bodies.mass[b] } else { 0.0 };
            let rebound = hit.speed * bodies.traits[a].restitution.max(bodies.traits[b].restitution);
            let side = if x[b] >= x[a] { 1.0 } else { -1.0 };
            let wanted = rebound + side * (u[a] - u[b]);
            if rebound <= 0.0 || rebound < rest_speed || wanted <= 0.0 {
                continue;
            }
            let (first, second) = (self.enlist(a, of_a, u), self.enlist(b, of_b, u));
            if let (Some(first), Some(second)) = (first, second) {
                self.thrown[second].group = first as u32;
            }
            let impulse = side * wanted / (of_a + of_b);
            u[a] -= impulse * of_a;
            u[b] += impulse * of_b;
        }
    }

    /// Lets whoever was solved together with the thrown share their energy.
    fn widen(&mut self, bodies: &Bodies, axis: Axis) {
        let u = if axis == Axis::Across { &bodies.ux } else { &bodies.uy };
        for k in 0..self.bonds.len() {
            let (i, root, along) = self.bonds[k];
            if along == axis
                && let (Some(first), Some(second)) = (self.enlist(i as usize, 1.0, u), self.enlist(root as usize, 1.0, u))
            {
                self.thrown[second].group = first as u32;
            }
        }
    }

    /// The first of a body's group; `None` if no impulse moves it.
    fn enlist(&mut self, body: usize, share: f64, u: &[f64]) -> Option<usize> {
        if share == 0.0 {
            return None;
        }
        if self.place[body] == 0 {
            let group = self.thrown.len() as u32;
            self.thrown.push(Thrown { body: body as u32, group, before: u[body], lost: 0.0, linear: 0.0, square: 0.0 });
            self.place[body] = group + 1;
        }
        Some(self.first(self.place[body] as usize - 1))
    }

    /// The first of a group.
    fn first(&mut self, mut at: usize) -> usize {
        while self.thrown[at].group as usize != at {
            let next = self.thrown[at].group as usize;
            self.thrown[at].group = self.thrown[next].group;
            at = next;
        }
        at
    }

    /// Makes the rebounds of a group smaller if they give back more energy than its members lost in the step.
    fn restrain(&mut self, bodies: &mut Bodies, axis: Axis, dt: f64) {
        let work = |i: usize| energy::work(bodies, axis, dt, i);
        let (v, u) = match axis {
            Axis::Across => (&bodies.vx, &bodies.ux),
            Axis::Gravity => (&bodies.vy, &bodies.uy),
        };
        for k in 0..self.thrown.len() {
            let (i, before) = (self.thrown[k].body as usize, self.thrown[k].before);
            let (mass, change) = (bodies.mass[i], u[i] - before);
            let first = self.first(k);
            let group = &mut self.thrown[first];
            group.lost += 0.5 * mass * (v[i] * v[i] - before * before) + work(i);
            group.linear += mass * before * change;
            group.square += 0.5 * mass * change * change;
        }
        let u = solved(bodies, axis);
        for k in 0..self.thrown.len() {
            let first = self.first(k);
            let Thrown { lost, linear, square, .. } = self.thrown[first];
            let Thrown { body, before, .. } = self.thrown[k];
            self.place[body as usize] = 0;
            if square > 0.0 && linear + square > lost + ROUNDING * lost.abs() {
                u[body as usize] = before + part(linear, square, lost.max(0.0)) * (u[body as usize] - before);
            }
        }
    }

    /// Makes all rebounds smaller if they give back more energy than all bodies lost in the step: friction may have handed what a
    /// group lost to somebody outside of it.
    fn balance(&self, bodies: &mut Bodies, axis: Axis, dt: f64) {
        let Some(gained) = energy::gained(bodies, axis, dt) else { return };
        let (mut linear, mut square) = (0.0, 0.0);
        for thrown in &self.thrown {
            let i = thrown.body as usize;
            let (mass, change) = (bodies.mass[i], solved(bodies, axis)[i] - thrown.before);
            linear += mass * thrown.before * change;
            square += 0.5 * mass * change * change;
        }
        if square > 0.0 {
            let part = part(linear, square, (linear + square - gained).max(0.0));
            let u = solved(bodies, axis);
            for thrown in &self.thrown {
                u[thrown.body as usize] = thrown.before + part * (u[thrown.body as usize] - thrown.before);
            }
        }
    }
}

/// The solved velocities along an axis, m/s.
fn solved(bodies: &mut Bodies, axis: Axis) -> &mut Vec<f64> {
    if axis == Axis::Across { &mut bodies.ux } else { &mut bodies.uy }
}

/// The part s, 0 … 1, of rebounds that gives back an energy of s·linear + s²·square = `energy`.
fn part(linear: f64, square: f64, energy: f64) -> f64 {
    (0.5 * ((linear * linear + 4.0 * square * energy).sqrt() - linear) / square).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball that was stopped by the floor at 5 m/s leaves at 2.5 m/s with restitution 0.5, and stays with a rest speed of 3.
    #[test]
    fn leaves_the_floor_with_its_part_of_the_closing_speed() {
        for (rest_speed, leaves) in [(1.0, -2.5), (3.0, 0.0)] {
            let mut bodies = Bodies::new(1, 1);
            (bodies.y[1], bodies.hy[0], bodies.hy[1]) = (1.0, 0.5, 0.5);
            (bodies.vy[0], bodies.free_vy[0], bodies.mass[0]) = (5.0, 5.1, 2.0);
            bodies.traits[0].restitution = 0.5;
            let mut impacts = Impacts::new(1);
            impacts.clear(10.0, 0.01);
            impacts.note(0, 1, Axis::Gravity, 5.1);
            impacts.measure(&bodies, 0.01);
            impacts.rebound(&mut bodies, &[true, true], rest_speed, 0.01);
            assert_eq!(bodies.uy[0], leaves);
        }
    }
}
