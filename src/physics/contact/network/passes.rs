//! The quick ways through a block: loads handed on along the axis, once.
//!
//! A pile at rest and a pushed row settle in one such pass. Nothing is found here that `routing` would not find too; it is for what these
//! refuse.

use crate::physics::contact::network::routing::NOWHERE;
use crate::physics::contact::network::{Carries, GROUND, Link, Network, Note};
use crate::physics::data::tuning::FORCE_TOLERANCE;

impl Network {
    /// The direct answer where nothing but the ground is pressed against: what presses lies, each support with an equal share, and what does
    /// not is free. It is what the blocks come to. False, and nothing done, if there is more to it.
    pub(crate) fn lies_on_ground(&mut self) -> bool {
        let lies = |link: &Link| link.carries == Carries::Push && (link.lo == GROUND) != (link.hi == GROUND) && link.ground == 0.0;
        if !self.links.iter().all(lies) {
            return false;
        }
        self.notes.clear();
        self.notes.resize(self.nodes.len(), Note::NEW);
        // A body and how hard it presses on the ground of a link.
        let ends = |link: &Link| if link.hi == GROUND { (link.lo as usize, 1.0) } else { (link.hi as usize, -1.0) };
        for link in &self.links {
            let (body, side) = ends(link);
            self.notes[body].waits_for += u32::from(side * self.nodes[body].force >= 0.0);
        }
        for link in &mut self.links {
            let (body, side) = ends(link);
            link.flow = (side * self.nodes[body].force).max(0.0) / f64::from(self.notes[body].waits_for.max(1));
        }
        for (node, note) in self.nodes.iter_mut().zip(&self.notes) {
            node.acceleration = if note.waits_for > 0 { 0.0 } else { node.force / node.mass };
        }
        true
    }

    /// The direct answer for one push between two bodies: they move as one if that presses them together, else each for itself.
    pub(crate) fn is_pair(&mut self) -> bool {
        let [Link { lo, hi, carries: Carries::Push, .. }] = self.links[..] else { return false };
        if lo == GROUND || hi == GROUND {
            return false;
        }
        for node in &mut self.nodes {
            node.acceleration = node.force / node.mass;
        }
        let (below, above) = (self.nodes[lo as usize], self.nodes[hi as usize]);
        let together = (below.force + above.force) / (below.mass + above.mass);
        let tolerance = below.force.abs().max(above.force.abs()) * FORCE_TOLERANCE;
        let push = below.force - below.mass * together;
        if push >= -tolerance {
            self.links[0].flow = push.max(0.0);
            self.nodes[lo as usize].acceleration = together;
            self.nodes[hi as usize].acceleration = together;
        }
        true
    }

    /// The direct answer for one column on ground that stands: each body hands on its own excess and what it bears. It is what [`Self::passes`]
    /// comes to. False if there is more to it.
    pub(crate) fn is_column(&mut self) -> bool {
        let mut grounds = self.links.iter().filter(|link| link.is_grounded());
        let (Some(&Link { hi, ground: 0.0, .. }), None) = (grounds.next(), grounds.next()) else { return false };
        if self.links.len() != self.nodes.len() {
            return false;
        }
        let (sign, downwards) = if hi == GROUND { (1.0, true) } else { (-1.0, false) };
        self.notes.clear();
        self.notes.resize(self.nodes.len(), Note::NEW);
        for (index, link) in self.links.iter().enumerate() {
            let (from, to) = if downwards { (link.lo, link.hi) } else { (link.hi, link.lo) };
            if link.carries != Carries::Push || from == GROUND || self.notes[from as usize].came_by != NOWHERE {
                return false;
            }
            self.notes[from as usize].came_by = index as u32;
            if to != GROUND {
                self.notes[to as usize].waits_for += 1;
            }
        }
        if self.notes.iter().any(|note| note.waits_for > 1) {
            return false;
        }
        let Some(mut at) = self.notes.iter().position(|note| note.waits_for == 0) else { return false };
        let mut borne = 0.0;
        for count in 1..=self.nodes.len() {
            let load = sign * self.nodes[at].force + borne;
            if load < -borne * FORCE_TOLERANCE {
                return false;
            }
            let link = &mut self.links[self.notes[at].came_by as usize];
            borne = load.max(0.0);
            link.flow = borne;
            let next = link.other(at as u32);
            if next == GROUND {
                self.nodes.iter_mut().for_each(|node| node.acceleration = 0.0);
                // What is left besides would go round in a ring.
                return count == self.nodes.len();
            }
            at = next as usize;
        }
        false
    }

    /// The direct answer where nothing pulls and no ground moves: nothing is passed on. False, and nothing done, if something does.
    pub(crate) fn stays(&mut self) -> bool {
        let stays = self.nodes.iter().all(|node| node.force == 0.0) && self.links.iter().all(|link| link.ground == 0.0);
        if stays {
            self.nodes.iter_mut().for_each(|node| node.acceleration = 0.0);
            self.links.iter_mut().for_each(|link| link.flow = 0.0);
        }
        stays
    }

    /// One pass along the axis: every body hands its excess on to the bodies (or the ground) that it presses against, in equal shares, as
    /// soon as it has been handed all of its own (Kahn's order). True if that settles the block: nobody would have to pull.
    pub(crate) fn passes(&mut self, begin: usize, end: usize, upwards: bool, tolerance: f64) -> bool {
        self.reset_flows(begin, end);
        let sign = if upwards { 1.0 } else { -1.0 };
        let presses =
            |link: &Link, i: u32| !link.cut && link.carries == Carries::Push && (if upwards { link.lo } else { link.hi }) == i;
        self.queue.clear();
        for at in begin..end {
            let i = self.order[at];
            let bearing = self.links_of(i).filter(|&slot| {
                let link = &self.links[self.around[slot] as usize];
                let from = link.other(i);
                from != GROUND && presses(link, from)
            });
            self.notes[i as usize].waits_for = bearing.count() as u32;
            if self.notes[i as usize].waits_for == 0 {
                self.queue.push(i);
            }
        }
        let mut next = 0;
        while next < self.queue.len() {
            let i = self.queue[next];
            next += 1;
            let load = sign * self.notes[i as usize].excess;
            if load < -tolerance {
                return false;
            }
            let range = self.links_of(i);
            let supports = range.clone().filter(|&slot| presses(&self.links[self.around[slot] as usize], i)).count();
            if supports == 0 {
                if load > tolerance {
                    return false;
                }
                continue;
            }
            let share = load.max(0.0) / supports as f64;
            for slot in range {
                let link = &mut self.links[self.around[slot] as usize];
                if presses(link, i) {
                    link.flow = share;
                    let other = link.other(i);
                    if other != GROUND {
                        self.notes[other as usize].excess += sign * share;
                        self.notes[other as usize].waits_for -= 1;
                        if self.notes[other as usize].waits_for == 0 {
                            self.queue.push(other);
                        }
                    }
                }
            }
        }
        self.queue.len() == end - begin
    }
}
