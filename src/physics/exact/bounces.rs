//! Bounces of one tick, passed over in closed form.
//!
//! From the sixth hit of a tick on, as many whole bounces as fit are passed over, or all of them where the series ends: 2w/(g(1 − e)) after a
//! rebound with w. Meanwhile the two count as lying against each other. Pairs without a pull bounce event by event.

use crate::physics::data::{CALM_REACH, Contact, DAMPED_REACH, ZENO_HITS, on_axis};
use crate::physics::exact::events::{Events, Scene};
use crate::physics::exact::item::Resume;

/// How long the bounces take, s, and how fast the two leave each other then, m/s, if they do.
#[derive(Debug, PartialEq)]
struct Series {
    time: f64,
    leaves: Option<f64>,
}

/// The first bounce: s, m/s. Each keeps `e` of its speed, or, with e = 1, loses speed to drag at a rate `damping`, 1/s.
struct First {
    time: f64,
    speed: f64,
    e: f64,
    damping: f64,
}

impl First {
    /// As many bounces as fit into `left` seconds. Under a pull a with drag c·v a bounce comes back slower by (2c/3a)·v², and takes 2v/a: speeds
    /// fall as e^(−c·t/3).
    fn series(&self, left: f64) -> Series {
        let Self { time: first, speed, e, damping } = *self;
        if e < 1.0 {
            // n bounces take first·(1 − eⁿ)/(1 − e).
            let part = left * (1.0 - e) / first;
            let count = if part >= 1.0 { f64::INFINITY } else { (libm::log1p(-part) / libm::log(e)).floor() };
            let time = (first * (1.0 - libm::pow(e, count)) / (1.0 - e)).min(left);
            return Series { time, leaves: count.is_finite().then(|| speed * libm::pow(e, count)) };
        }
        let slowing = damping / 3.0;
        // Of speeds that fall as e^(−x), nothing is left at x = 40.
        if slowing * left >= 40.0 {
            return Series { time: left, leaves: None };
        }
        if slowing * left <= f64::EPSILON {
            return Series { time: ((left / first).floor() * first).min(left), leaves: Some(speed) };
        }
        let count = (libm::expm1(slowing * left) / (slowing * first)).floor();
        let slower = slowing * first * count;
        Series { time: (libm::log1p(slower) / slowing).min(left), leaves: Some(speed / (1.0 + slower)) }
    }
}

impl Events {
    /// Passes over bounces of a pair that has just parted with `speed`, m/s: on a surface that stands, or of two bodies that are pressed together
    /// and that nothing else touches.
    pub(crate) fn pass_over_bounces(&mut self, scene: &Scene, contact: &Contact, speed: f64, e: f64) {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let (body, other) = contact.ends();
        let crowded = self.is_body(other) && self.touching.len() > 1;
        if crowded || self.items[lo].hits.min(self.items[hi].hits) < ZENO_HITS {
            return;
        }
        let shares = self.shares(lo, hi);
        // The speed of their centre of mass, m/s; 0 on a surface.
        let together = if self.is_body(other) { self.speeds[lo][axis] + shares[0] * speed } else { 0.0 };
        let (mut pull, mut damping, mut stiffness) = (0.0, 0.0, 0.0);
        for (i, sign, share) in [(lo, 1.0, shares[0]), (hi, -1.0, shares[1])] {
            if self.is_body(i as u32) {
                let (item, mut velocity) = (&self.items[i], self.speeds[i]);
                velocity[axis] = together;
                pull += sign * scene.media.acceleration(&item.body, &item.law, self.places[i], velocity)[axis];
                let answer = scene.media.stiffness(&item.body, &item.law, self.places[i], velocity);
                damping += share * answer.drag[axis];
                stiffness += answer.lift;
            }
        }
        let (first, left) = (2.0 * speed / pull, scene.tick - self.now);
        let thick = pull > 0.0 && first > 0.0 && first * f64::from(ZENO_HITS) < left;
        let reach = if e < 1.0 { CALM_REACH } else { DAMPED_REACH };
        if !thick || (damping + stiffness.sqrt()) * first > reach {
            return;
        }
        let Series { time, leaves } = First { time: first, speed, e, damping }.series(left);
        self.part_with(contact, -speed);
        for i in [lo, hi].into_iter().filter(|i| *i < self.movable) {
            self.speeds[i][axis] = together;
        }
        self.items[body as usize].resume = leaves.map(|speed| Resume { at: (self.now + time).min(scene.tick), axis, speed, other });
    }

    fn part_with(&mut self, contact: &Contact, speed: f64) {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let shares = self.shares(lo, hi);
        let mut impulse = 0.0;
        for (i, share, sign) in [(lo, shares[0], -1.0), (hi, shares[1], 1.0)] {
            if self.is_body(i as u32) {
                self.speeds[i][axis] += sign * share * speed;
                impulse = share * speed * self.items[i].body.mass;
            }
        }
        self.note(contact, on_axis(axis, impulse, 0.0), 0.0);
    }

    /// Lets a body leave the item on which it has bounced, unless their contact has ended.
    pub(crate) fn resume(&mut self, scene: &Scene, i: usize) {
        let Some(Resume { axis, speed, other, .. }) = self.items[i].resume.take() else { return };
        let held = |contact: &&Contact| contact.axis == axis && contact.is_of(i as u32, other);
        let Some(contact) = self.contacts.iter().find(held).copied() else { return };
        self.concern(other);
        self.locate(scene, i);
        self.locate(scene, other as usize);
        self.part_with(&contact, speed);
    }
}

#[cfg(test)]
mod tests {
    use crate::physics::exact::bounces::{First, Series};

    #[test]
    fn a_series_of_bounces_ends_when_its_sum_does() {
        // 1 + ½ + ¼ + … s.
        let first = First { time: 1.0, speed: 8.0, e: 0.5, damping: 0.0 };
        assert_eq!(first.series(3.0), Series { time: 2.0, leaves: None });
        assert_eq!(first.series(1.8), Series { time: 1.75, leaves: Some(1.0) });
    }

    #[test]
    fn what_loses_nothing_bounces_as_often_as_fits() {
        let first = First { time: 0.5, speed: 8.0, e: 1.0, damping: 0.0 };
        assert_eq!(first.series(2.25), Series { time: 2.0, leaves: Some(8.0) });
    }

    /// One bounce after the other under a pull of 2 m/s², with (2c/3a)·v² off the speed of each.
    #[test]
    fn drag_takes_its_part_of_each_bounce() {
        let (damping, pull, mut speed, mut time) = (0.3, 2.0, 0.01, 0.0);
        let of = First { time: 2.0 * speed / pull, speed, e: 1.0, damping }.series(20.0);
        while time + speed < of.time {
            time += 2.0 * speed / pull;
            speed -= 2.0 * damping / (3.0 * pull) * speed * speed;
        }
        assert!(of.time > 19.99 && of.time <= 20.0, "{} s", of.time);
        assert!(of.leaves.is_some_and(|leaves| (leaves / speed - 1.0).abs() < 0.01), "{:?}, not {speed}", of.leaves);
        assert_eq!(First { time: 1.0, speed: 8.0, e: 1.0, damping: 100.0 }.series(10.0).leaves, None);
    }
}
