//! The quick ways through a block: loads handed on along the axis, once.
//!
//! A pile at rest and a pushed row settle in one such pass. Nothing is found here that `routing` would not find too; it is for what these
//! refuse.

use super::{Carries, GROUND, Link, Network, Note, WORK_OF_A_LOOK};
use crate::physics::tuning::FORCE_TOLERANCE;

impl Network {
    /// The direct answer where nothing but the ground is pressed against: what presses lies, each support with an equal share, and what does
    /// not is free. It is what the blocks come to. False, and nothing done, if there is more to it.
    pub(super) fn lies_on_ground(&mut self) -> bool {
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
    pub(super) fn is_pair(&mut self) -> bool {
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

    /// The direct answer where nothing pulls and no ground moves: nothing is passed on. False, and nothing done, if something does.
    pub(super) fn stays(&mut self) -> bool {
        let stays = self.nodes.iter().all(|node| node.force == 0.0) && self.links.iter().all(|link| link.ground == 0.0);
        if stays {
            self.work += 4 * WORK_OF_A_LOOK * self.nodes.len() as u64;
            self.nodes.iter_mut().for_each(|node| node.acceleration = 0.0);
            self.links.iter_mut().for_each(|link| link.flow = 0.0);
        }
        stays
    }

    /// One pass along the axis: every body hands its excess on to the bodies (or the ground) that it presses against, in equal shares, as
    /// soon as it has been handed all of its own (Kahn's order). True if that settles the block: nobody would have to pull.
    pub(super) fn passes(&mut self, begin: usize, end: usize, upwards: bool, tolerance: f64) -> bool {
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
