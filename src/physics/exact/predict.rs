//! The next event of an item, on the paths that have been foreseen (`docs/physics.md`, From event to event; Lubachevsky 1991).

use crate::physics::data::tuning::{MICRO_SPEED, MOST_BORDERS, SLOP, SPEED_TOLERANCE};
use crate::physics::data::{Aabb, Contact, Cubic, Polynomial, Sides, earliest, time_of_impact};
use crate::physics::exact::{events::Events, events::Scene, item::EventKind, item::Next, item::Travel};
use crate::physics::forces::zones;
use glam::DVec2;

impl Events {
    pub(crate) fn predict(&mut self, scene: &Scene, i: usize) {
        let mut next = self.own_next(scene, i);
        self.next_border(scene, i, &mut next);
        self.pressing.clear();
        for slot in self.incident.slots(i) {
            let contact = &self.contacts[self.incident.list[slot] as usize];
            self.next_contact_change(i as u32, contact, &mut next);
            if contact.normal > 0.0 {
                self.pressing.push(contact.other(i as u32));
            }
        }
        self.next_hit(i, &mut next);
        if let Some(other) = next.kind.other() {
            next.foreseen_on = self.ways[other as usize];
        }
        self.nexts[i] = next;
        self.keep_to_lane(i);
    }

    /// Sets the box of an item until its next event. The island grows where that leads out of the box in which others were sought.
    fn keep_to_lane(&mut self, i: usize) {
        let track = &self.tracks[i];
        let until = track.until.min(self.nexts[i].at);
        // An item whose path is not exact may be elsewhere than on its cubic.
        let as_foreseen = track.since == self.now && until >= track.until;
        let lane = if track.is_exact() && !track.is_still() && !as_foreseen {
            track.way_from(self.now).swept(track.half, until - self.now)
        } else {
            track.swept
        };
        self.lanes[i] = track.lane(&lane);
        self.grown |= i < self.movable && !self.items[i].searched.contains(&lane, 0.0);
    }

    pub(crate) fn own_next(&self, scene: &Scene, i: usize) -> Next {
        let at = self.items[i].until;
        if at < scene.tick { Next { at, kind: EventKind::Renew, ..Next::NEVER } } else { Next::NEVER }
    }

    fn next_hit(&self, i: usize, next: &mut Next) {
        let mine = &self.tracks[i];
        let from_here = mine.way_from(self.now);
        let (left, reach) = ((mine.until.min(next.at) - self.now), mine.rounding + SLOP);
        if left <= 0.0 {
            return;
        }
        let whole = mine.since == self.now && left == mine.until - self.now;
        let lane = if whole { mine.swept } else { from_here.swept(mine.half, left) };
        let lane = Aabb::new(lane.min - reach, lane.max + reach);
        for (j, theirs) in self.lanes.iter().enumerate() {
            if j != i && theirs.meets(&lane) {
                self.next_meeting(i, j, &from_here, next);
            }
        }
    }

    fn next_meeting(&self, i: usize, j: usize, from_here: &Cubic, next: &mut Next) {
        let (now, mine, other) = (self.now, &self.tracks[i], &self.tracks[j]);
        let end = mine.until.min(other.until).min(self.nexts[j].at).min(next.at) - now;
        if mine.is_still() && other.is_still() || end <= 0.0 {
            return;
        }
        if let Some(of) = [i, j].into_iter().find(|k| self.items[*k].train.is_some()) {
            let (with, members) = (if of == i { j } else { i }, self.items[of].train.map_or([i as u32; 3], |train| train.members));
            if !self.tracks[with].is_still() && !members.contains(&(with as u32)) {
                next.or_earlier(now, EventKind::Begin { other: j as u32 });
            }
            return;
        }
        // Bodies that press on each other have met already; in media they may part, and meet again.
        let press = self.pressing.contains(&(j as u32));
        if mine.motion != Travel::Coupled && press {
            return;
        }
        let from_there = other.way_from(now);
        // Seen from the one of the lower number, so that both come to the same bits.
        let motion = if i < j { from_here.relative(&from_there) } else { from_there.relative(from_here) };
        if motion.stands() {
            return;
        }
        let (halves, sides) = (mine.half + other.half, self.items[i.max(j)].sides);
        // A contact that has begun may be outside its level by the rounding of a place.
        let has_begun = |axis: usize| self.contacts_of(i as u32).any(|contact| contact.axis == axis && contact.has(j as u32));
        if let Some((t, axis)) = begins_flush(&motion, halves, end, sides)
            && !has_begun(axis)
        {
            next.or_earlier(now + t, EventKind::Begin { other: j as u32 });
        }
        let reach = reach_of(&motion, halves, sides);
        let at_once = meets_at_once(&motion, reach, sides).map(|axis| (0.0, axis));
        if let Some((t, axis)) = at_once.or_else(|| time_of_impact(&motion, reach, end, sides)) {
            let path = motion.axis(axis);
            let side = path.at(t).signum();
            // Roundings of two places sink in by less than 1e-11 m within a tick; errors of a step of two that press by less than 1e-10 m until
            // it ends.
            let left = if press { mine.until.min(other.until) - now - t } else { f64::INFINITY };
            let (slow, slight) = (SPEED_TOLERANCE.max(1e-10 / left), 1e-6_f64.max(1e-10 / (left * left)));
            if -side * path.slope(t) > slow || -side * path.curvature(t) > slight {
                next.or_earlier(now + t, EventKind::Hit { other: j as u32, axis, ascending: (side > 0.0) == (i < j) });
            }
        }
    }

    fn next_contact_change(&self, i: u32, contact: &Contact, next: &mut Next) {
        let (lo, hi) = (&self.tracks[contact.lo as usize], &self.tracks[contact.hi as usize]);
        if lo.is_still() && hi.is_still() {
            return;
        }
        let along = 1 - contact.axis;
        // Where both have the same path the rest would say no more: most of what moves as one.
        if lo.since == hi.since && (1..4).all(|k| lo.way.c[k][along] == hi.way.c[k][along]) {
            return;
        }
        let end = lo.until.min(hi.until) - self.now;
        let motion = lo.way_from(self.now).relative(&hi.way_from(self.now)).axis(along);
        if motion.stands() {
            return;
        }
        if contact.slides != 0.0
            && let Some(t) = end_of_slide(&motion, contact.slides, self.skin_of(contact), end)
        {
            next.or_earlier(self.now + t, EventKind::Stop { other: contact.other(i) });
        }
        // Half the slop: a contact needs all of it, so that this one is over then, however the time is rounded.
        let level = lo.half[along] + hi.half[along] - 0.5 * SLOP;
        let motion = motion.until(end);
        if let Some(t) = earliest(motion.rises_through(level, 0.0), motion.falls_through(-level, 0.0)) {
            next.or_earlier(self.now + t, EventKind::Edge { other: contact.other(i) });
        }
    }

    fn next_border(&mut self, scene: &Scene, i: usize, next: &mut Next) {
        let (item, track) = (&self.items[i], &self.tracks[i]);
        let may = i < self.movable && !track.is_still() && !self.streams.is_empty();
        if !may || self.borders[i].is_empty() || item.crossed.0 >= MOST_BORDERS {
            return;
        }
        let (way, pose, end) = (track.way_from(self.now), item.pose(scene.media, self.now), track.until - self.now);
        for stream in self.borders[i].iter() {
            let zone = &scene.media.streams[stream as usize].zone;
            let inside = zones::feels(zone, &item.body, pose);
            if zones::stays(&track.swept, item.body.half, zone, inside) {
                continue;
            }
            if let Some(t) = zones::border(&way, item.body.half, zone, inside, end) {
                next.or_earlier(self.now + t, EventKind::Border);
            }
        }
    }
}

/// How near two boxes may come along each axis, m: those that are in each other by more than the slop get no deeper.
fn reach_of(motion: &Cubic, mut reach: DVec2, sides: Sides) -> DVec2 {
    let apart = motion.c[0].abs();
    let gap = apart - reach;
    let axis = usize::from(gap.x <= gap.y);
    if gap[axis] < -SLOP && sides == Sides::ALL {
        reach[axis] = apart[axis];
    }
    reach
}

/// When boxes in one plane come to face each other across it, and along which axis. They overlap by more than the slop then, however time is rounded.
fn begins_flush(motion: &Cubic, reach: DVec2, end: f64, sides: Sides) -> Option<(f64, usize)> {
    let along = |axis: usize| {
        let (across, other) = (motion.axis(axis), 1 - axis);
        let flush = |t: f64| (across.at(t).abs() - reach[axis]).abs() <= SLOP;
        if !flush(0.0) || !sides.face(axis, across.at(0.0) <= 0.0) {
            return None;
        }
        let (path, level) = (motion.axis(other).until(end), reach[other] - 2.0 * SLOP);
        let t = earliest(path.falls_through(level, 0.0), path.rises_through(-level, 0.0));
        t.filter(|t| flush(*t) && across.slope(*t).abs() <= MICRO_SPEED).map(|t| (t, axis))
    };
    along(1).or_else(|| along(0))
}

/// Along which axis two boxes that touch, or are in each other by the roughness of a path, approach now. After an impact they do not.
fn meets_at_once(motion: &Cubic, reach: DVec2, sides: Sides) -> Option<usize> {
    let apart = motion.c[0];
    let gap = apart.abs() - reach;
    let axis = usize::from(gap.x <= gap.y);
    let meets = gap[axis] <= 0.0 && gap[1 - axis] < -SLOP && -apart[axis].signum() * motion.c[1][axis] > SPEED_TOLERANCE;
    (meets && sides.face(axis, apart[axis] <= 0.0) && (sides == Sides::ALL || gap[axis] >= -SLOP)).then_some(axis)
}

/// When a slide of `hi` over `lo` in the direction `slides` ends: the relative speed of `motion`, less the `skin` of a belt, comes to 0.
fn end_of_slide(motion: &Polynomial, slides: f64, skin: f64, end: f64) -> Option<f64> {
    let [_, v, a, j] = motion.0;
    let (speed, braking) = (slides * (v + skin), -slides * 2.0 * a);
    if speed <= 0.0 {
        return None;
    }
    let t = if j == 0.0 {
        speed / braking
    } else {
        // speed − braking·t + q·t² = 0, by the form that subtracts no like numbers.
        let q = 3.0 * slides * j;
        let discriminant = braking * braking - 4.0 * q * speed;
        if discriminant < 0.0 {
            return None;
        }
        2.0 * speed / (braking + discriminant.sqrt())
    };
    // The time of the slowest slides underflows to 0: they end now. That of one that speeds up underflows to −0.
    (t.is_sign_positive() && t < end).then_some(t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slide_ends_when_its_speed_does() {
        assert_eq!(end_of_slide(&Polynomial([0.0, 6.0, -1.5, 0.0]), 1.0, 0.0, 3.0), Some(2.0));
        assert_eq!(end_of_slide(&Polynomial([0.0, -6.0, 1.5, 0.0]), -1.0, 0.0, 3.0), Some(2.0));
        assert_eq!(end_of_slide(&Polynomial([0.0, 6.0, 1.5, 0.0]), 1.0, 0.0, 3.0), None);
        assert_eq!(end_of_slide(&Polynomial([0.0, 5e-324, -2.0, 0.0]), 1.0, 0.0, 3.0), Some(0.0));
        assert_eq!(end_of_slide(&Polynomial([0.0, 5e-324, 2.0, 0.0]), 1.0, 0.0, 3.0), None);
        // On a belt that runs along with 2 m/s it ends there.
        assert_eq!(end_of_slide(&Polynomial([0.0, 6.0, -1.5, 0.0]), 1.0, -2.0, 3.0), Some(4.0 / 3.0));
        // 4 − 5t + t² has its first root at 1.
        assert!((end_of_slide(&Polynomial([0.0, 4.0, -2.5, 1.0 / 3.0]), 1.0, 0.0, 3.0).unwrap() - 1.0).abs() < 1e-15);
    }
}
