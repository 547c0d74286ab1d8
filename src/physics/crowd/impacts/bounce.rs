//! One impact: velocities after it by restitution and masses, whole bounces passed over in closed form, and friction.

use crate::physics::crowd::gravity::Anchors;
use crate::physics::crowd::impacts::course::{Course, slowed};
use crate::physics::crowd::impacts::look::{Due, Pair};
use crate::physics::crowd::impacts::{Around, Axis, Impact, Impacts, NONE};
use crate::physics::store::bodies::Bodies;

/// Bounces that last no longer than this part of the rest of the step are passed over together. Larger: impacts with others come later; smaller:
/// more impacts a step.
const SHORT: f64 = 0.25;

impl Impacts {
    pub(crate) fn bounce(&mut self, bodies: &mut Bodies, anchors: &Anchors, around: &mut Around<'_>, due: Due) {
        let (n, Due { time, speed, axis, .. }) = (bodies.len(), due);
        let Pair { a, b, restitution, .. } = self.pairs[due.pair as usize];
        let of = [a as usize, b as usize];
        let course = of.map(|i| self.flyers[i].course[axis]);
        let place = course.map(|course| course.place(time));
        let side = if place[1] < place[0] { -1.0 } else { 1.0 };
        // A body that rests is ground for the one that falls on it.
        let rests = [0, 1].map(|k| axis == 1 && of[k] < n && anchors.rests[of[k]] && course[k].velocity == bodies.uy[of[k]]);
        let grounded = [rests[0] && side < 0.0, rests[1] && side > 0.0];
        let share = [0, 1].map(|k| if of[k] < n && !grounded[k] { 1.0 / bodies.mass[of[k]] } else { 0.0 });
        if share[0] + share[1] == 0.0 {
            return;
        }
        let fixed = share[0] == 0.0 || share[1] == 0.0;
        let (until, leaves) = if fixed {
            self.pass_over(&due, restitution, (course[0].pull - course[1].pull) * side)
        } else {
            (time, restitution * speed)
        };
        let impulse = (speed + leaves) / (share[0] + share[1]);
        let rub = self.rub(bodies, &due, side, impulse);
        self.pairs[due.pair as usize].hits += 1;
        for k in 0..2 {
            self.flyers[of[k]].hits += u32::from(of[k] < n);
            if self.skipped && self.flyers[of[k]].still && (share[k] > 0.0 || rub != 0.0) {
                self.add_skipped(bodies, around.island);
            }
            if share[k] > 0.0 && rests[k] {
                // The hit throws it off its support.
                let pull = (bodies.free_vy[of[k]] - bodies.vy[of[k]]) / self.dt;
                self.flyers[of[k]].course[1] = Course { pull, ..Course::straight(bodies.y[of[k]], bodies.vy[of[k]]) };
                self.note_carried(bodies, of[k], anchors.on[of[k]], pull * time);
            }
        }
        let before = course.map(|course| course.speed(time));
        for (k, sign) in [(0, -side), (1, side)] {
            let other = 1 - k;
            if share[k] == 0.0 {
                continue;
            }
            let (carried, after) = match share[other] == 0.0 {
                true => (course[other].velocity * (until - time), before[other] + sign * leaves),
                false => (0.0, before[k] + sign * impulse * share[k]),
            };
            self.set(bodies, of[k], axis, until, (place[k] + carried, after));
        }
        for (i, rub) in [(of[0], rub), (of[1], -rub)].into_iter().filter(|(i, rub)| *rub != 0.0 && *i < n) {
            let across = self.flyers[i].course[1 - axis];
            self.set(bodies, i, 1 - axis, time, (across.place(time), across.speed(time) + rub / bodies.mass[i]));
        }
        // Over whole bounces the surface has borne the weight besides.
        let borne = (course[0].pull - course[1].pull) * side * (until - time) / (share[0] + share[1]);
        let normal = -side * (impulse + borne);
        for k in (0..2).filter(|k| axis == 1 && share[*k] == 0.0 && of[*k] < n) {
            self.struck[of[k]] += normal.abs();
        }
        self.note(bodies, &due, (normal, rub), side);
        for i in of.into_iter().filter(|i| *i < n) {
            self.leave(bodies, around, i, until);
        }
    }

    /// When the bounces on something immovable that are passed over end, and how fast the pair parts then; `pull` presses it together.
    fn pass_over(&self, due: &Due, restitution: f64, pull: f64) -> (f64, f64) {
        let (leaves, left) = (restitution * due.speed, self.dt - due.time);
        let first = 2.0 * leaves / pull;
        if pull > 0.0 && restitution < 1.0 && first <= left * (1.0 - restitution) {
            return (due.time, 0.0);
        }
        if pull <= 0.0 || first > SHORT * left {
            return (due.time, leaves);
        }
        if restitution >= 1.0 {
            return ((due.time + (left / first).floor() * first).min(self.dt), leaves);
        }
        // n bounces take first·(1 − eⁿ)/(1 − e).
        let count = (libm::log1p(-left * (1.0 - restitution) / first) / libm::log(restitution)).floor();
        let slower = libm::pow(restitution, count);
        ((due.time + first * (1.0 - slower) / (1.0 - restitution)).min(self.dt), leaves * slower)
    }

    /// Friction's impulse on the first of the pair, N·s.
    fn rub(&self, bodies: &Bodies, due: &Due, side: f64, impulse: f64) -> f64 {
        let n = bodies.len();
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let (a, b) = (a as usize, b as usize);
        let across = |i: usize| self.flyers[i].course[1 - due.axis].speed(due.time);
        let sliding = across(a) - across(b) - bodies.skin(b, due.axis, side < 0.0);
        let coefficient = bodies.coefficients(a, b).kinetic_friction;
        let mass = 1.0 / (1.0 / bodies.mass[a] + if b < n { 1.0 / bodies.mass[b] } else { 0.0 });
        if sliding == 0.0 { 0.0 } else { -(coefficient * impulse).min(sliding.abs() * mass).copysign(sliding) }
    }

    /// From `time` on, body i moves on from a place with a velocity.
    fn set(&mut self, bodies: &mut Bodies, i: usize, axis: usize, time: f64, (place, speed): (f64, f64)) {
        let dt = self.dt;
        let old = self.flyers[i].course[axis];
        let mut pull = old.pull;
        if bodies.meets_air(i) {
            let outer = if axis == 0 { bodies.ax[i] } else { bodies.ay[i] };
            pull = outer + slowed(pull - outer, old.speed(time), speed, dt - time);
        }
        let course = Course::through(place, speed, time, pull);
        let flyer = &mut self.flyers[i];
        (flyer.course[axis], flyer.was_hit) = (course, true);
        let (p, free) = if axis == 0 { (&mut bodies.px, &mut bodies.free_vx) } else { (&mut bodies.py, &mut bodies.free_vy) };
        if bodies.is_guided[bodies.id[i] as usize] {
            (p[i], free[i]) = (course.place(dt), course.speed(dt));
            return;
        }
        let (faster, pulled) = (course.velocity - old.velocity, pull - old.pull);
        p[i] += (course.at - old.at) + (faster + 0.5 * pulled * dt) * dt;
        free[i] += faster + pulled * dt;
    }

    fn note(&mut self, bodies: &Bodies, due: &Due, (normal, friction): (f64, f64), side: f64) {
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let axis = if due.axis == 0 { Axis::Across } else { Axis::Gravity };
        let place = |axis: usize, i: u32| self.flyers[i as usize].course[axis].place(due.time);
        let half = |axis: usize, i: u32| if axis == 0 { bodies.hx[i as usize] } else { bodies.hy[i as usize] };
        let other = 1 - due.axis;
        let low = (place(other, a) - half(other, a)).max(place(other, b) - half(other, b));
        let high = (place(other, a) + half(other, a)).min(place(other, b) + half(other, b));
        let (on, along) = (place(due.axis, a) + side * half(due.axis, a), 0.5 * (low + high));
        let point = if due.axis == 0 { (on, along) } else { (along, on) };
        self.all.push(Impact { a, b, axis, speed: due.speed, normal, friction, point });
    }

    /// Until a hit threw it off, the support of body i has given it this change of velocity, and taken what struck it from above.
    fn note_carried(&mut self, bodies: &Bodies, i: usize, on: u32, change: f64) {
        let impulse = bodies.mass[i] * change + std::mem::take(&mut self.struck[i]);
        if on == NONE || impulse == 0.0 {
            return;
        }
        if (on as usize) < bodies.len() {
            self.struck[on as usize] += impulse;
        }
        let point = (bodies.x[i], bodies.y[i] + bodies.hy[i]);
        self.all.push(Impact { a: i as u32, b: on, axis: Axis::Gravity, speed: 0.0, normal: -impulse, friction: 0.0, point });
    }
}
