//! The general way through a block: a maximum flow from where force is left over to where it is missing, along shortest paths, and a cut
//! where it gets stuck (Ford and Fulkerson's method in Edmonds and Karp's order).

use crate::physics::contact::network::{Carries, GROUND, Network, Side};

/// How a search reached a node: not at all, or by starting there.
pub(crate) const NOWHERE: u32 = u32::MAX;
const START: u32 = u32::MAX - 1;

impl Network {
    /// Routes as much excess as the links allow along shortest paths: first from where it is to where it is missing or into the ground,
    /// then from the ground to where it is still missing.
    pub(crate) fn route(&mut self, begin: usize, end: usize, grounded: bool, tolerance: f64) {
        while let Some(goal) = self.search(begin, end, false, grounded, tolerance) {
            self.augment(goal);
        }
        // What the search still reaches from unrouted excess cannot be held back by the rest.
        for at in begin..end {
            let i = self.order[at] as usize;
            self.notes[i].side = if self.notes[i].came_by == NOWHERE { Side::Same } else { Side::Faster };
        }
        if grounded {
            while let Some(goal) = self.search(begin, end, true, grounded, tolerance) {
                self.augment(goal);
            }
        }
        self.mark_slower(begin, end, tolerance);
    }

    /// Breadth first from all excess (or from the ground) to the nearest lack; leaves in `came_by` how each node was reached.
    fn search(&mut self, begin: usize, end: usize, from_ground: bool, grounded: bool, tolerance: f64) -> Option<u32> {
        let ground = self.nodes.len();
        for at in begin..end {
            self.notes[self.order[at] as usize].came_by = NOWHERE;
        }
        self.notes[ground].came_by = NOWHERE;
        self.queue.clear();
        if from_ground {
            self.notes[ground].came_by = START;
            self.queue.push(GROUND);
        } else {
            for at in begin..end {
                let i = self.order[at];
                if self.notes[i as usize].excess > tolerance {
                    self.notes[i as usize].came_by = START;
                    self.queue.push(i);
                }
            }
        }
        let block = self.notes[self.order[begin] as usize].block;
        let mut next = 0;
        while next < self.queue.len() {
            let node = self.queue[next];
            next += 1;
            for slot in self.links_of(node) {
                let index = self.around[slot];
                let link = &self.links[index as usize];
                let other = link.other(node);
                if link.cut || link.room(node) <= tolerance {
                    continue;
                }
                let place = self.slot(other);
                if self.notes[place].came_by != NOWHERE {
                    continue;
                }
                if other == GROUND {
                    if grounded {
                        self.notes[place].came_by = index;
                        return Some(GROUND);
                    }
                    continue;
                }
                if self.notes[place].block != block {
                    continue;
                }
                self.notes[place].came_by = index;
                if self.notes[place].excess < -tolerance {
                    return Some(other);
                }
                self.queue.push(other);
            }
        }
        None
    }

    /// Sends as much as fits along the path just found.
    fn augment(&mut self, goal: u32) {
        let mut amount = if goal == GROUND { f64::INFINITY } else { -self.notes[goal as usize].excess };
        let mut node = goal;
        while self.notes[self.slot(node)].came_by != START {
            let link = &self.links[self.notes[self.slot(node)].came_by as usize];
            let from = link.other(node);
            amount = amount.min(link.room(from));
            node = from;
        }
        if node != GROUND {
            amount = amount.min(self.notes[node as usize].excess);
            self.notes[node as usize].excess -= amount;
        }
        let mut node = goal;
        while self.notes[self.slot(node)].came_by != START {
            let index = self.notes[self.slot(node)].came_by as usize;
            let from = self.links[index].other(node);
            self.links[index].flow += if self.links[index].lo == from { amount } else { -amount };
            node = from;
        }
        if goal != GROUND {
            self.notes[goal as usize].excess += amount;
        }
    }

    /// Whatever could still pass force on to an unmet lack shares that lack.
    fn mark_slower(&mut self, begin: usize, end: usize, tolerance: f64) {
        let block = self.notes[self.order[begin] as usize].block;
        self.queue.clear();
        for at in begin..end {
            let i = self.order[at];
            if self.notes[i as usize].excess < -tolerance && self.notes[i as usize].side == Side::Same {
                self.notes[i as usize].side = Side::Slower;
                self.queue.push(i);
            }
        }
        let mut next = 0;
        while next < self.queue.len() {
            let node = self.queue[next];
            next += 1;
            for slot in self.links_of(node) {
                let link = &self.links[self.around[slot] as usize];
                let other = link.other(node);
                let joined = !link.cut && other != GROUND && self.notes[other as usize].block == block;
                if joined && self.notes[other as usize].side == Side::Same && link.room(other) > tolerance {
                    self.notes[other as usize].side = Side::Slower;
                    self.queue.push(other);
                }
            }
        }
    }

    /// Cuts the block where the routing got stuck: ties across the cut slip at their limits, pushes across it have ended. `ground` is the
    /// acceleration of the ground that it was held against. Returns whether it was cut.
    pub(crate) fn split(&mut self, begin: usize, end: usize, ground: Option<f64>) -> bool {
        let first = self.notes[self.order[begin] as usize].side;
        let whole = (begin..end).all(|at| self.notes[self.order[at] as usize].side == first);
        if let Some(side) = self.settle_other_grounds(ground.unwrap_or(0.0)) {
            let notes = &self.notes;
            self.squeezed.extend(self.order[begin..end].iter().filter(|&&i| notes[i as usize].side == side));
        }
        if whole && (first == Side::Same || ground.is_none()) {
            return false;
        }
        for at in begin..end {
            let i = self.order[at];
            for slot in self.links_of(i) {
                let index = self.around[slot] as usize;
                let link = self.links[index];
                let other = link.other(i);
                let other_side = match (other, ground) {
                    (GROUND, Some(ground)) => side_of(link.ground, ground),
                    (GROUND, None) => Side::Same,
                    (other, _) => self.notes[other as usize].side,
                };
                if link.cut || other_side == self.notes[i as usize].side {
                    continue;
                }
                self.links[index].cut = true;
                // Friction is passed on from the faster to the slower side.
                let i_is_faster = self.notes[i as usize].side > other_side;
                let flow = match link.carries {
                    Carries::Push => 0.0,
                    Carries::UpTo(limit) if (link.lo == i) == i_is_faster => limit,
                    Carries::UpTo(limit) => -limit,
                };
                self.pass_on(index, flow);
            }
        }
        let notes = &self.notes;
        self.order[begin..end].sort_unstable_by_key(|&i| (notes[i as usize].side, i));
        let mut at = begin;
        while at < end {
            let side = self.notes[self.order[at] as usize].side;
            let from = at;
            while at < end && self.notes[self.order[at] as usize].side == side {
                self.notes[self.order[at] as usize].block = self.blocks.len() as u32;
                at += 1;
            }
            self.blocks.push((from as u32, at as u32));
        }
        true
    }

    /// Lets a link that has been cut pass on a force that stays.
    fn pass_on(&mut self, index: usize, flow: f64) {
        let link = &mut self.links[index];
        link.flow = flow;
        for (end, sign) in [(link.lo, -1.0), (link.hi, 1.0)] {
            if end != GROUND {
                self.nodes[end as usize].force += sign * flow;
            }
        }
    }

    /// Of the grounds set aside, those on whose side a node ended up may still hold it; the others drag or have let go for good. What
    /// stayed although it is pushed by more than all else together is squeezed between two of them: returns the side on which it stayed, if anything is.
    fn settle_other_grounds(&mut self, held: f64) -> Option<Side> {
        let mut squeezed = None;
        for k in 0..self.aside.len() {
            let index = self.aside[k] as usize;
            let link = self.links[index];
            let node = if link.lo == GROUND { link.hi } else { link.lo };
            let (mine, its) = (self.notes[node as usize].side, side_of(link.ground, held));
            if mine == its {
                (self.links[index].cut, self.links[index].flow) = (false, 0.0);
                continue;
            }
            match link.carries {
                Carries::UpTo(limit) if limit.is_finite() => self.pass_on(index, link.flow),
                Carries::Push | Carries::UpTo(_) => {
                    if link.flow != 0.0 {
                        squeezed = Some(mine);
                    }
                    self.links[index].flow = 0.0;
                }
            }
        }
        self.aside.clear();
        squeezed
    }
}

/// On which side of a block that is held at `held` a ground moves.
fn side_of(ground: f64, held: f64) -> Side {
    if ground > held {
        Side::Faster
    } else if ground < held {
        Side::Slower
    } else {
        Side::Same
    }
}
