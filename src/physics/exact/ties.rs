//! Impacts at one instant and of one speed, solved together by conjugate gradients (`docs/physics.md`, Ties; Hestenes and Stiefel 1952).

use crate::physics::data::{Contact, EQUAL_SPEED, SPEED_ROUNDING, on_axis, refill};
use crate::physics::exact::events::{Events, Scene, Tie};
use glam::DVec2;

impl Events {
    /// Finds the impacts that tie with one of `speed` at the contact of that index; those along gravity come before those across.
    pub(crate) fn find_ties(&mut self, scene: &Scene, index: usize, speed: f64) {
        let mut ties = std::mem::take(&mut self.ties);
        ties.clear();
        let tied = |index: usize| self.tie(scene, index, speed);
        let down = (0..self.touching.len()).filter(|i| self.touching[*i].axis == 1).find_map(tied);
        ties.extend(down.or_else(|| self.tie(scene, index, speed)));
        let mut next = 0;
        while let Some(from) = ties.get(next).map(|tie: &Tie| self.touching[tie.index]) {
            for other in 0..self.touching.len() {
                let contact = &self.touching[other];
                let shares = [from.lo, from.hi].iter().any(|item| self.is_body(*item) && contact.has(*item));
                if shares && contact.axis == from.axis && ties.iter().all(|tie| tie.index != other) {
                    ties.extend(self.tie(scene, other, speed));
                }
            }
            next += 1;
        }
        self.ties = ties;
    }

    fn tie(&self, scene: &Scene, index: usize, speed: f64) -> Option<Tie> {
        let contact = &self.touching[index];
        let approach = self.approach(contact);
        if (approach - speed).abs() > EQUAL_SPEED * speed || self.is_struck(contact) || !self.is_shut(contact, speed) {
            return None;
        }
        let e = self.restitution(scene, contact, approach);
        let target = (1.0 + e) * approach;
        (e > 0.0).then_some(Tie { index, e, target, impulse: 0.0, left: 0.0, direction: 0.0, change: 0.0 })
    }

    /// Whether the gap of a pair that approaches with that speed is closed, or closes within 1e-12 s or 16 roundings of the coordinates.
    pub(crate) fn is_shut(&self, contact: &Contact, speed: f64) -> bool {
        let [a, b] = [contact.lo, contact.hi].map(|item| item as usize);
        let reach = self.items[a].body.half + self.items[b].body.half;
        let gap = (self.places[b] - self.places[a] - reach)[contact.axis];
        let size = (self.places[a].abs() + self.places[b].abs() + reach)[contact.axis];
        contact.closed || gap <= speed * 1e-12 + 16.0 * f64::EPSILON * size
    }

    pub(crate) fn resolve_ties(&mut self, scene: &Scene, speed: f64) {
        let mut ties = std::mem::take(&mut self.ties);
        loop {
            let solved = self.find_impulses(&mut ties);
            let least = ties.iter().map(|tie| tie.target).fold(f64::INFINITY, f64::min);
            let before = ties.len();
            ties.retain(|tie| if solved { tie.impulse > 0.0 } else { tie.target > least });
            if ties.len() == before || ties.is_empty() {
                break;
            }
        }
        self.before.clone_from(&self.speeds);
        (0..ties.len()).for_each(|k| self.rebound(&ties, k, speed));
        if let Some((contact, e)) = ties.first().map(|tie| (self.touching[tie.index], tie.e)) {
            self.begin_train(scene, &contact, e * speed, e);
        }
        self.ties = ties;
    }

    /// Solves for the impulses. Returns false where the targets contradict each other.
    fn find_impulses(&mut self, ties: &mut [Tie]) -> bool {
        let most = ties.iter().map(|tie| tie.target).fold(0.0, f64::max);
        ties.iter_mut().for_each(|tie| (tie.impulse, tie.left) = (0.0, tie.target));
        let mut last = 0.0;
        for step in 0..4 * ties.len() {
            let size: f64 = ties.iter().map(|tie| tie.left * tie.left * self.reduced(&self.touching[tie.index])).sum();
            if ties.iter().all(|tie| tie.left.abs() <= 1e-15 * most) {
                break;
            }
            let carried = if step == 0 { 0.0 } else { size / last };
            for tie in &mut *ties {
                tie.direction = tie.left * self.reduced(&self.touching[tie.index]) + carried * tie.direction;
            }
            self.find_changes(ties);
            let slope: f64 = ties.iter().map(|tie| tie.direction * tie.change).sum();
            if slope <= 0.0 {
                break;
            }
            for tie in &mut *ties {
                tie.impulse += size / slope * tie.direction;
                tie.left -= size / slope * tie.change;
            }
            last = size;
        }
        ties.iter().all(|tie| tie.left.abs() <= 1e-9 * most)
    }

    /// The changes of the approach speeds by impulses along the directions of the search.
    fn find_changes(&mut self, ties: &mut [Tie]) {
        refill(&mut self.means, self.movable, DVec2::ZERO);
        for tie in &*ties {
            let Contact { lo, hi, axis, .. } = self.touching[tie.index];
            for (item, sign) in [(lo as usize, -1.0), (hi as usize, 1.0)] {
                if item < self.movable {
                    self.means[item][axis] += sign * tie.direction / self.items[item].body.mass;
                }
            }
        }
        for tie in ties {
            let Contact { lo, hi, axis, .. } = self.touching[tie.index];
            let of = |item: u32| self.means.get(item as usize).map_or(0.0, |speed| speed[axis]);
            tie.change = of(hi) - of(lo);
        }
    }

    /// The reduced mass of two things in contact, kg; with a surface it is the body's own.
    fn reduced(&self, contact: &Contact) -> f64 {
        let per_mass = |item: u32| if self.is_body(item) { 1.0 / self.items[item as usize].body.mass } else { 0.0 };
        1.0 / (per_mass(contact.lo) + per_mass(contact.hi))
    }

    /// Gives two items their impulse. Friction goes by the slide before all of them; each impact of a body may stop its part.
    fn rebound(&mut self, ties: &[Tie], k: usize, speed: f64) {
        let Tie { index, impulse, .. } = ties[k];
        let contact = self.touching[index];
        std::mem::swap(&mut self.speeds, &mut self.before);
        let relative = self.sliding(&contact);
        std::mem::swap(&mut self.speeds, &mut self.before);
        let of = |item: u32| ties.iter().filter(|tie| self.is_body(item) && self.touching[tie.index].has(item)).count();
        let parts = of(contact.lo).max(of(contact.hi)) as f64;
        let rub = (contact.kinetic_friction * impulse).min(relative.abs() * self.reduced(&contact) / parts);
        let given = on_axis(contact.axis, impulse, if relative == 0.0 { 0.0 } else { -relative.signum() * rub });
        self.note(&contact, given, Some(speed));
        self.count_hit(&contact);
        for (item, sign) in [(contact.lo as usize, -1.0), (contact.hi as usize, 1.0)] {
            if item < self.movable {
                self.speeds[item] += given * (sign / self.items[item].body.mass);
            }
        }
        // Where friction has stopped a slide over a surface, up to the rounding of the slide before, nothing is left of it: that would slide on.
        let ((body, surface), slides) = (contact.ends(), self.sliding(&contact));
        if !self.is_body(surface) && slides.abs() <= SPEED_ROUNDING * relative.abs() {
            let side = if body == contact.lo { 1.0 } else { -1.0 };
            self.speeds[body as usize][1 - contact.axis] += side * slides;
        }
    }
}
