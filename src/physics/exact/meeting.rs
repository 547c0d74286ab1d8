//! Items that meet, brought exactly together: along cubics that follow media they may be found a hair apart or in each other.

use crate::physics::data::{Contact, SLOP, STRAY};
use crate::physics::exact::{events::Events, events::Scene, item::EventKind, item::Next};

impl Events {
    /// Brings two items to the instant at which they meet by Newton's method, and closes the gap left. Returns false if something else comes before.
    pub(crate) fn put_together(&mut self, scene: &Scene, contact: &Contact) -> bool {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let reach = self.reach_of(contact);
        if !(self.tracks[lo].is_exact() && self.tracks[hi].is_exact()) {
            let begin = self.items[lo].since.max(self.items[hi].since);
            let of_pair = |k: usize, next: &Next| next.kind.other().is_some_and(|other| contact.is_of(k as u32, other));
            let others = self.nexts.iter().enumerate().filter(|(k, next)| !of_pair(*k, next) && !self.is_void(next));
            let last = self.items[lo].until.min(self.items[hi].until).min(scene.tick);
            let end = others.map(|(_, next)| next.at).fold(last, f64::min);
            // Four steps of Newton's method end at the rounding of the time.
            for _ in 0..4 {
                let (a, b) = (self.items[lo].pose(scene.media, self.now), self.items[hi].pose(scene.media, self.now));
                let (gap, closing) = (b.0[axis] - a.0[axis] - reach, a.1[axis] - b.1[axis]);
                let next = self.now + gap / closing;
                // Where they only graze, Newton's method would run off to the moment at which they parted.
                if closing <= 0.0 || next < begin || next == self.now {
                    break;
                }
                if next > end && !(gap <= SLOP && next <= last && self.all_meet_later(scene, contact, next)) {
                    return gap <= SLOP;
                }
                self.now = next;
            }
            self.bracket(scene, contact);
        }
        self.close(scene, contact);
        true
    }

    /// Whether all that is foreseen before `at` are meetings that have not happened by then: what meets at one instant is foreseen in any order.
    fn all_meet_later(&self, scene: &Scene, besides: &Contact, at: f64) -> bool {
        self.nexts.iter().enumerate().all(|(k, next)| {
            let EventKind::Hit { other, axis, ascending } = next.kind else { return next.at >= at };
            let (lo, hi) = if ascending { (k as u32, other) } else { (other, k as u32) };
            let known = at <= self.items[lo as usize].until.min(self.items[hi as usize].until);
            let apart = || self.gap_at(scene, &Contact::between(lo, hi, axis), at) >= -SLOP;
            next.at >= at || besides.is_of(lo, hi) || self.is_void(next) || known && apart()
        })
    }

    /// The gap of two items along the axis of their contact at a time on their paths, m.
    fn gap_at(&self, scene: &Scene, contact: &Contact, at: f64) -> f64 {
        let place = |item: u32| self.items[item as usize].pose(scene.media, at).0[contact.axis];
        place(contact.hi) - place(contact.lo) - self.reach_of(contact)
    }

    /// Takes away the gap or overlap of two that meet now, by their masses, with all behind them; no surface, nor what stands against one, gives way.
    pub(crate) fn close(&mut self, scene: &Scene, contact: &Contact) {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        let reach = self.reach_of(contact);
        let gap = self.locate(scene, hi)[axis] - self.locate(scene, lo)[axis] - reach;
        let begun = (self.begun[hi] - self.begun[lo]).abs() - (self.items[lo].body.half + self.items[hi].body.half);
        if gap < -STRAY && begun.max_element() < -STRAY {
            return;
        }
        if lo >= self.movable || hi >= self.movable {
            let (body, ground, side) = if lo >= self.movable { (hi, lo, 1.0) } else { (lo, hi, -1.0) };
            if gap < -1e-12 {
                self.push_along(scene, body as u32, -side * gap, contact);
            }
            self.places[body][axis] = self.places[ground][axis] + side * reach;
        } else if gap.abs() > 1e-12 {
            let share = [(lo, gap), (hi, -gap)].map(|(item, way)| {
                if self.find_behind(item as u32, way, contact) { 0.0 } else { 1.0 / self.items[item].body.mass }
            });
            let sum = share[0] + share[1];
            if sum > 0.0 {
                self.push_along(scene, lo as u32, gap * (share[0] / sum), contact);
                self.push_along(scene, hi as u32, -gap * (share[1] / sum), contact);
            }
        }
    }

    /// Where Newton's method has ended with the two in each other: halves the time since the last event until they are apart.
    fn bracket(&mut self, scene: &Scene, contact: &Contact) {
        let mut apart = self.items.iter().map(|item| item.since).fold(0.0, f64::max);
        if apart >= self.now || self.gap_at(scene, contact, self.now) >= -SLOP || self.gap_at(scene, contact, apart) < 0.0 {
            return;
        }
        let mut met = self.now;
        // 64 halvings leave nothing of any time.
        for _ in 0..64 {
            let middle = 0.5 * (apart + met);
            let between = self.gap_at(scene, contact, middle);
            (apart, met) = if between >= -SLOP { (middle, met) } else { (apart, middle) };
            if between.abs() <= SLOP {
                break;
            }
        }
        self.now = apart;
    }

    /// Lists in `behind` a body and all that stands behind it, not by the contact `besides`. Returns whether a surface does.
    fn find_behind(&mut self, body: u32, side: f64, besides: &Contact) -> bool {
        self.behind.clear();
        self.behind.push(body);
        let mut next = 0;
        while let Some(&carrier) = self.behind.get(next) {
            next += 1;
            let all = self.contacts.iter().chain(&self.touching).chain(&self.met);
            for contact in all.filter(|contact| contact.axis == besides.axis && !contact.is_of(besides.lo, besides.hi)) {
                let (near, far) = if side > 0.0 { (contact.lo, contact.hi) } else { (contact.hi, contact.lo) };
                if near != carrier {
                    continue;
                }
                if far as usize >= self.movable {
                    return true;
                }
                if !self.behind.contains(&far) {
                    self.behind.push(far);
                }
            }
        }
        false
    }

    /// Moves a body by `way` (m) along the axis of a contact, and all that stands behind it by as much.
    fn push_along(&mut self, scene: &Scene, body: u32, way: f64, besides: &Contact) {
        if way == 0.0 {
            return;
        }
        self.find_behind(body, way, besides);
        for k in 0..self.behind.len() {
            let item = self.behind[k];
            self.concern(item);
            self.locate(scene, item as usize);
            self.places[item as usize][besides.axis] += way;
        }
    }

    /// Distance of the centres along the axis of a contact at which its ends touch, m.
    fn reach_of(&self, contact: &Contact) -> f64 {
        let half = |item: u32| self.items[item as usize].body.half[contact.axis];
        half(contact.lo) + half(contact.hi)
    }

    /// How deep its ends are in each other along its axis, m.
    pub(crate) fn depth_of(&self, contact: &Contact) -> f64 {
        let (lo, hi, axis) = (contact.lo as usize, contact.hi as usize, contact.axis);
        self.reach_of(contact) - (self.places[hi][axis] - self.places[lo][axis])
    }
}
