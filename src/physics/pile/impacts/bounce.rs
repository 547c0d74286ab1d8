//! One impact: velocities after it by restitution and masses, whole bounces passed over in closed form, friction, and what is told of it.

use super::super::bodies::Bodies;
use super::super::gravity::Anchors;
use super::course::{Course, parting, slowed};
use super::due::{Due, Pair};
use super::{Around, Axis, Impact, Impacts, NONE};

/// A bounce this part of what is left of the step long, or shorter, is passed over with those that follow.
const SHORT: f64 = 0.25;

impl Impacts {
    /// One impact.
    pub(super) fn bounce(&mut self, bodies: &mut Bodies, anchors: &Anchors, around: &mut Around<'_>, due: Due) {
        let n = bodies.len();
        let Due { time, speed, axis, .. } = due;
        let Pair { a, b, restitution, .. } = self.pairs[due.pair as usize];
        let (a, b) = (a as usize, b as usize);
        let (of_a, of_b) = (self.courses[a][axis], self.courses[b][axis]);
        let (at_a, at_b) = (of_a.place(time), of_b.place(time));
        let side = if at_b < at_a { -1.0 } else { 1.0 };
        // What rests is ground for what falls on it.
        let courses = &self.courses;
        let is_held = |i: usize| axis == 1 && i < n && anchors.rests[i] && courses[i][1].velocity == bodies.uy[i];
        let (a_rests, b_rests) = (is_held(a), is_held(b));
        let held = |upper: usize, rests: bool, falls: bool| falls && upper < n && rests;
        let share = |i: usize, fixed: bool| if i < n && !fixed { 1.0 / bodies.mass[i] } else { 0.0 };
        let (share_a, share_b) = (share(a, held(b, a_rests, side < 0.0)), share(b, held(a, b_rests, side > 0.0)));
        if share_a + share_b == 0.0 {
            return;
        }
        let (until, leaves) = self.pass_over(due, restitution, share_a == 0.0 || share_b == 0.0);
        // Whom it meets while its bounces are passed over is not followed.
        self.ends |= until > time;
        // Relative velocity after, and what it takes.
        let change = speed + leaves;
        let impulse = change / (share_a + share_b);
        let before = [of_a.speed(time), of_b.speed(time)];
        let after = if share_b == 0.0 {
            [before[1] - side * leaves, before[1]]
        } else if share_a == 0.0 {
            [before[0], before[0] + side * leaves]
        } else {
            [before[0] - side * impulse * share_a, before[1] + side * impulse * share_b]
        };
        let rub = self.rub(bodies, due, side, impulse);
        let moves = |i: usize, share: f64| around.island.is_settled(i) && (share > 0.0 || rub != 0.0);
        self.stirred.extend([(a, share_a), (b, share_b)].into_iter().filter(|(i, share)| moves(*i, *share)).map(|(i, _)| i as u32));
        if !self.stirred.is_empty() {
            return;
        }
        self.pairs[due.pair as usize].hits += 1;
        for i in [a, b] {
            if i < n {
                self.hits[i] += 1;
            }
        }
        let stirs = |i: usize, share: f64| i < n && self.still[i] && (share > 0.0 || rub != 0.0);
        if self.skipped > 0 && (stirs(a, share_a) || stirs(b, share_b)) {
            self.add_skipped(bodies, around.island);
        }
        for (i, share, rests) in [(a, share_a, a_rests), (b, share_b, b_rests)] {
            if share > 0.0 && rests {
                // Thrown off what carried it.
                let pull = (bodies.free_vy[i] - bodies.vy[i]) / self.dt;
                self.courses[i][1] = Course { pull, ..Course::straight(bodies.y[i], bodies.vy[i]) };
                self.note_carried(bodies, i, anchors.on[i], pull * time);
            }
        }
        if share_a > 0.0 {
            let carried = if share_b == 0.0 { of_b.velocity * (until - time) } else { 0.0 };
            self.set(bodies, a, axis, until, (at_a + carried, after[0]));
        }
        if share_b > 0.0 {
            let carried = if share_a == 0.0 { of_a.velocity * (until - time) } else { 0.0 };
            self.set(bodies, b, axis, until, (at_b + carried, after[1]));
        }
        for (i, rub) in [(a, rub), (b, -rub)] {
            if rub != 0.0 && i < n {
                self.rub_along(bodies, i, 1 - axis, time, rub / bodies.mass[i]);
            }
        }
        // Over whole bounces gravity has been answered too.
        let pulled = (of_a.pull - of_b.pull) * side * (until - time) / (share_a + share_b);
        let normal = -side * (impulse + pulled);
        if axis == 1 {
            for (i, share) in [(a, share_a), (b, share_b)] {
                if share == 0.0 && i < n {
                    self.struck[i] += normal.abs();
                }
            }
        }
        self.note(bodies, due, (normal, rub), side);
        for i in [a, b] {
            if i < n {
                self.leave(bodies, around, i, time.max(until));
            }
        }
    }

    /// Adds the pairs of a body that was thrown further than contacts were looked for.
    pub(super) fn widen(&mut self, bodies: &mut Bodies, around: &mut Around<'_>, i: usize) {
        around.reach.widen(bodies, around.neighbours, around.island, i, around.last);
        for &(a, b) in &around.reach.new {
            let left_out = [a, b].into_iter().filter(|i| around.island.is_settled(*i as usize));
            let known = self.stirred.len();
            self.stirred.extend(left_out);
            if self.stirred.len() == known {
                self.add(bodies, a, b);
            }
        }
    }

    /// When the bounces that are passed over end, and how fast the pair parts then.
    fn pass_over(&self, due: Due, restitution: f64, fixed: bool) -> (f64, f64) {
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let (of_a, of_b) = (&self.courses[a as usize][due.axis], &self.courses[b as usize][due.axis]);
        let side = if of_b.place(due.time) < of_a.place(due.time) { -1.0 } else { 1.0 };
        let (pull, leaves, left) = ((of_a.pull - of_b.pull) * side, restitution * due.speed, self.dt - due.time);
        let fade = of_a.fade.max(of_b.fade);
        if fade > 0.0 {
            // What a medium brakes and presses on is back at once, again and again, and ever slower.
            let closing = (of_a.ends(self.dt) - of_b.ends(self.dt)) * side;
            return (due.time, parting(leaves, closing, fade, left).clamp(0.0, leaves));
        }
        if !fixed || pull <= 0.0 {
            return (due.time, leaves);
        }
        let first = 2.0 * leaves / pull;
        if restitution < 1.0 && first <= left * (1.0 - restitution) {
            return (due.time, 0.0);
        }
        if first > SHORT * left {
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
    fn rub(&self, bodies: &Bodies, due: Due, side: f64, impulse: f64) -> f64 {
        let n = bodies.len();
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let (a, b) = (a as usize, b as usize);
        let across = |i: usize| &self.courses[i][1 - due.axis];
        let sliding = across(a).speed(due.time) - across(b).speed(due.time) - bodies.skin(b, due.axis, side < 0.0);
        let kinetic = |i: usize| bodies.traits[i].kinetic_friction;
        let coefficient = if b < n { kinetic(a).min(kinetic(b)) } else { kinetic(b) };
        let mass = 1.0 / (1.0 / bodies.mass[a] + if b < n { 1.0 / bodies.mass[b] } else { 0.0 });
        -(coefficient * impulse).min(sliding.abs() * mass).copysign(sliding) * if sliding == 0.0 { 0.0 } else { 1.0 }
    }

    /// From `time` on, body i is faster by a `change` (m/s) along the axis on which it slides.
    fn rub_along(&mut self, bodies: &mut Bodies, i: usize, axis: usize, time: f64, change: f64) {
        let course = self.courses[i][axis];
        if !course.braked {
            return self.set(bodies, i, axis, time, (course.place(time), course.speed(time) + change));
        }
        // Its way is another one by no more than that, and what brakes it takes most of that too.
        let left = self.dt - time;
        self.hit_in[i] = self.follow_ups;
        self.courses[i][axis] = Course { at: course.at - change * time, velocity: course.velocity + change, ..course };
        let (p, free) = if axis == 0 { (&mut bodies.px, &mut bodies.free_vx) } else { (&mut bodies.py, &mut bodies.free_vy) };
        p[i] += change * left;
        free[i] += change * libm::exp(-course.fade * left);
    }

    /// From `time` on, body i moves on from a place with a velocity.
    fn set(&mut self, bodies: &mut Bodies, i: usize, axis: usize, time: f64, (place, speed): (f64, f64)) {
        let dt = self.dt;
        self.hit_in[i] = self.follow_ups;
        let course = &mut self.courses[i][axis];
        let old = *course;
        // Weight and air are not all that pulls at what is led, and what goes straight is not as fast in the end.
        let is_told = old.braked || bodies.is_guided[bodies.id[i] as usize];
        if !is_told && bodies.meets_air(i) {
            let outer = if axis == 0 { bodies.ax[i] } else { bodies.ay[i] };
            course.pull = outer + slowed(old.pull - outer, old.speed(time), speed, dt - time);
        }
        course.velocity = speed - course.pull * time;
        course.at = place - (course.velocity + 0.5 * course.pull * time) * time;
        let (p, free) = if axis == 0 { (&mut bodies.px, &mut bodies.free_vx) } else { (&mut bodies.py, &mut bodies.free_vy) };
        if is_told {
            // It may have been on another way: from now on it is on this course.
            (p[i], free[i]) = (course.place(dt), course.speed(dt));
            return;
        }
        let pulled = course.pull - old.pull;
        p[i] += (course.at - old.at) + (course.velocity - old.velocity + 0.5 * pulled * dt) * dt;
        free[i] += course.velocity - old.velocity + pulled * dt;
    }

    fn note(&mut self, bodies: &Bodies, due: Due, (normal, friction): (f64, f64), side: f64) {
        let Pair { a, b, .. } = self.pairs[due.pair as usize];
        let axis = if due.axis == 0 { Axis::Across } else { Axis::Gravity };
        let place = |axis: usize, i: u32| self.courses[i as usize][axis].place(due.time);
        let half = |axis: usize, i: u32| if axis == 0 { bodies.hx[i as usize] } else { bodies.hy[i as usize] };
        let other = 1 - due.axis;
        let low = (place(other, a) - half(other, a)).max(place(other, b) - half(other, b));
        let high = (place(other, a) + half(other, a)).min(place(other, b) + half(other, b));
        let (on, along) = (place(due.axis, a) + side * half(due.axis, a), 0.5 * (low + high));
        let point = if due.axis == 0 { (on, along) } else { (along, on) };
        self.all.push(Impact { a, b, axis, speed: due.speed, normal, friction, point });
    }

    /// Until a hit threw it off, what carried body i has given it this change of velocity, and taken what struck it from above.
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
