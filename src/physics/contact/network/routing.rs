//! One pass of loads settles piles and pushed rows; else maximum flow and a cut (Ford and Fulkerson 1956; Edmonds and Karp 1972; Dinic 1970).

use crate::physics::contact::network::{Block, Carries, GROUND, Network, NetworkEdge, Side, grounds::side_of};
use crate::physics::data::NONE;

const START: u32 = u32::MAX - 1;

/// Where a search begins: at all excess, at the ground, or, against the flow, at all lack.
#[derive(Clone, Copy, PartialEq)]
enum From {
    Excess,
    Ground,
    Lack,
}

impl Network {
    /// Whether nothing is pulled away from all that it presses against, or would have to be pulled along, by its own excess.
    pub(super) fn may_pass(&self, block: Block, upwards: bool) -> bool {
        let tolerance = block.tolerance();
        self.order[block.begin..block.end].iter().all(|&i| {
            let load = if upwards { self.notes[i as usize].excess } else { -self.notes[i as usize].excess };
            let mut links = self.links_of(i);
            let bears = |link: &NetworkEdge| link.other(i) != GROUND && link.hands_on(link.other(i), upwards);
            load.abs() <= tolerance || links.any(|link| if load > 0.0 { link.hands_on(i, upwards) } else { bears(link) })
        })
    }

    /// Each body hands its excess on to what it presses against, in equal shares, once it has got all (Kahn's order). Returns whether none has to pull.
    pub(super) fn passes(&mut self, block: Block, upwards: bool) -> bool {
        let (tolerance, sign) = (block.tolerance(), if upwards { 1.0 } else { -1.0 });
        let Self { incident, links, notes, queue, order, .. } = self;
        queue.clear();
        for &i in &order[block.begin..block.end] {
            let bears = |link: &NetworkEdge| link.other(i) != GROUND && link.hands_on(link.other(i), upwards);
            notes[i as usize].waits_for = incident.of(i as usize).iter().filter(|k| bears(&links[**k as usize])).count() as u32;
            if notes[i as usize].waits_for == 0 {
                queue.push(i);
            }
        }
        let mut next = 0;
        while next < queue.len() {
            let i = queue[next];
            next += 1;
            let (load, around) = (sign * notes[i as usize].excess, incident.of(i as usize));
            let supports = around.iter().filter(|index| links[**index as usize].hands_on(i, upwards)).count();
            if load < -tolerance || supports == 0 && load > tolerance {
                return false;
            }
            let share = load.max(0.0) / supports as f64;
            for &index in around {
                let link = &mut links[index as usize];
                if link.hands_on(i, upwards) {
                    link.flow = share;
                    let other = link.other(i);
                    if let Some(note) = notes.get_mut(other as usize) {
                        note.excess += sign * share;
                        note.waits_for -= 1;
                        if note.waits_for == 0 {
                            queue.push(other);
                        }
                    }
                }
            }
        }
        queue.len() == block.end - block.begin
    }

    /// Routes excess to where it is missing or into the ground, then from the ground to where it is still missing.
    pub(super) fn route(&mut self, block: Block) {
        let tolerance = block.tolerance();
        [&mut self.queue, &mut self.starts, &mut self.lacks].into_iter().for_each(Vec::clear);
        for &i in &self.order[block.begin..block.end] {
            let note = &mut self.notes[i as usize];
            note.side = Side::Same;
            if note.excess > tolerance {
                self.starts.push(i);
            } else if note.excess < -tolerance {
                self.lacks.push(i);
            }
        }
        while self.search(block, From::Excess) {
            self.augment_all(block);
        }
        // Nodes reached from unrouted excess are faster.
        self.mark_reached(Side::Faster);
        if block.ground.is_some() {
            self.starts.clear();
            self.starts.push(GROUND);
            while !self.lacks.is_empty() && self.search(block, From::Ground) {
                self.augment_all(block);
            }
            self.mark_reached(Side::Same);
        }
        // Nodes that could still pass force on to an unmet lack share that lack.
        let Self { starts, lacks, notes, .. } = self;
        starts.clear();
        starts.extend(lacks.iter().filter(|i| notes[**i as usize].side == Side::Same));
        self.search(block, From::Lack);
        self.mark_reached(Side::Slower);
    }

    fn mark_reached(&mut self, side: Side) {
        for i in self.queue.drain(..) {
            let note = &mut self.notes[(i as usize).min(self.nodes.len())];
            note.came_by = NONE;
            if note.side == Side::Same {
                note.side = side;
            }
        }
    }

    /// Breadth first to the nearest lacks or, from all excess, the ground; from all lack against the flow. Returns whether there are `goals`.
    fn search(&mut self, block: Block, from: From) -> bool {
        let (ground, tolerance) = (self.nodes.len(), block.tolerance());
        let Self { incident, links, notes, queue, goals, starts, order, .. } = self;
        let number = notes[order[block.begin] as usize].block;
        queue.extend_from_slice(starts);
        starts.iter().for_each(|i| notes[(*i as usize).min(ground)].came_by = START);
        goals.clear();
        let (mut next, mut nearer) = (0, queue.len());
        while next < queue.len() {
            if next == nearer {
                if !goals.is_empty() {
                    break;
                }
                nearer = queue.len();
            }
            let node = queue[next];
            next += 1;
            for &index in incident.of((node as usize).min(ground)) {
                let link = &links[index as usize];
                let other = link.other(node);
                let note = &mut notes[(other as usize).min(ground)];
                if note.came_by != NONE || link.cut || link.room((link.lo == node) != (from == From::Lack)) <= tolerance {
                    continue;
                }
                if other == GROUND {
                    if block.ground.is_some() && from != From::Lack {
                        goals.push((GROUND, index));
                    }
                } else if note.block == number {
                    note.came_by = index;
                    if from != From::Lack && note.excess < -tolerance {
                        goals.push((other, index));
                    } else {
                        queue.push(other);
                    }
                }
            }
        }
        !goals.is_empty()
    }

    fn augment_all(&mut self, block: Block) {
        for k in 0..self.goals.len() {
            let (goal, link) = self.goals[k];
            let place = self.slot(goal);
            self.notes[place].came_by = link;
            self.augment(block, goal);
            self.notes[place].came_by = NONE;
        }
        self.mark_reached(Side::Same);
        let (Self { starts, lacks, notes, .. }, tolerance) = (self, block.tolerance());
        starts.retain(|i| notes.get(*i as usize).is_none_or(|note| note.excess > tolerance));
        lacks.retain(|i| notes[*i as usize].excess < -tolerance);
    }

    /// Routes what a path still has room for: others may have taken it.
    fn augment(&mut self, block: Block, goal: u32) {
        let mut amount = if goal == GROUND { f64::INFINITY } else { -self.notes[goal as usize].excess };
        let mut node = goal;
        while self.notes[self.slot(node)].came_by != START {
            let link = &self.links[self.notes[self.slot(node)].came_by as usize];
            node = link.other(node);
            amount = amount.min(link.room(link.lo == node));
        }
        if node != GROUND {
            amount = amount.min(self.notes[node as usize].excess);
        }
        if amount <= block.tolerance() {
            return;
        }
        if node != GROUND {
            self.notes[node as usize].excess -= amount;
        }
        let mut node = goal;
        while self.notes[self.slot(node)].came_by != START {
            let index = self.notes[self.slot(node)].came_by as usize;
            let link = &mut self.links[index];
            node = link.other(node);
            link.flow += if link.lo == node { amount } else { -amount };
        }
        if goal != GROUND {
            self.notes[goal as usize].excess += amount;
        }
    }

    /// Cuts the block where the routing got stuck. Ties across the cut slip at their limits, pushes end. Returns whether it was cut.
    pub(super) fn split(&mut self, block: Block) -> bool {
        let Block { begin, end, ground, .. } = block;
        let first = self.notes[self.order[begin] as usize].side;
        let whole = (begin..end).all(|at| self.notes[self.order[at] as usize].side == first);
        if let Some(side) = self.settle_other_grounds(ground.unwrap_or(0.0)) {
            let notes = &self.notes;
            self.squeezed.extend(self.order[begin..end].iter().filter(|&&i| notes[i as usize].side == side));
        }
        if whole && (first == Side::Same || ground.is_none()) {
            return false;
        }
        for at in block.begin..block.end {
            let i = self.order[at];
            for slot in self.incident.slots(i as usize) {
                let index = self.incident.list[slot] as usize;
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
            self.blocks.push(from as u32..at as u32);
        }
        true
    }
}
