//! Contact forces along one axis, exactly: which bodies move together, how fast, and what each contact carries.
//!
//! On axis-aligned boxes the normals are axis-aligned, so each axis is a problem of its own: bodies are nodes with a mass and an
//! applied force; a *normal* link passes any pushing force from its lower to its upper body, a *tie* (static friction) passes up to its
//! limit either way; the ground is immovable. By Gauss's principle of least constraint the accelerations minimise
//! `Σ ½ m (a − F/m)²` subject to `a_hi ≥ a_lo` on every normal link, plus `Σ limit·|a_hi − a_lo|` over the ties. That is isotonic
//! regression on a partial order with total variation, which splits exactly into blocks of equal acceleration: start from a whole
//! connected component, route every body's excess force `F − m·a` through the links to where it is missing (a maximum flow: the flows
//! *are* the contact forces), and where that cannot be done, cut at the bottleneck and go on with the parts (the decomposition
//! algorithm for separable convex functions: Fujishige 1980, Groenevelt 1991).
//!
//! No iteration towards a limit, no dependence on mass ratio; a block with the ground has a = 0 bit for bit. Where several supports
//! could carry a load (statically indeterminate), they share it equally if no tie is needed. Cost: one linear pass for a pile at rest
//! or a pushed row; otherwise O(nodes · links) a block, meant for up to a few hundred bodies.

use super::tuning::FORCE_TOLERANCE;

/// The index of the ground as an end of a link.
pub(super) const GROUND: u32 = u32::MAX;

/// What a link can carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Carries {
    /// Any push, never a pull.
    Push,
    /// Up to this many newtons either way.
    UpTo(f64),
}

/// A contact as seen along one axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    /// The body at the smaller coordinate, or the ground.
    pub lo: u32,
    /// The body at the larger coordinate, or the ground.
    pub hi: u32,
    /// What it can carry.
    pub carries: Carries,
    /// The force passed on from `lo` to `hi`, N: `hi` feels it along the axis, `lo` against it.
    pub flow: f64,
    /// Cut: its ends move apart (a tie then slips at its limit).
    pub cut: bool,
}

impl Link {
    fn room(&self, from: u32) -> f64 {
        match (self.carries, self.lo == from) {
            (Carries::Push, true) => f64::INFINITY,
            (Carries::Push, false) => self.flow,
            (Carries::UpTo(limit), true) => limit - self.flow,
            (Carries::UpTo(limit), false) => limit + self.flow,
        }
    }

    fn other(&self, end: u32) -> u32 {
        if self.lo == end { self.hi } else { self.lo }
    }
}

/// A body along one axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// kg.
    pub mass: f64,
    /// Applied force without the contacts of this network, N.
    pub force: f64,
    /// The solution, m/s².
    pub acceleration: f64,
}

/// The network of one axis; its buffers are kept from solve to solve.
#[derive(Clone, Debug, Default)]
pub(super) struct Network {
    pub nodes: Vec<Node>,
    pub links: Vec<Link>,
    /// Links of node i: `around[first[i]..first[i + 1]]`; the last node is the ground.
    first: Vec<u32>,
    around: Vec<u32>,
    /// All nodes, each block a contiguous range of it.
    order: Vec<u32>,
    blocks: Vec<(u32, u32)>,
    block_of: Vec<u32>,
    excess: Vec<f64>,
    /// Bodies that have not handed their load on to node i yet.
    waits_for: Vec<u32>,
    side: Vec<Side>,
    came_by: Vec<u32>,
    queue: Vec<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Side {
    Slower,
    Same,
    Faster,
}

const NOWHERE: u32 = u32::MAX;
const START: u32 = u32::MAX - 1;

impl Network {
    /// Empties it, keeping the buffers.
    pub fn clear(&mut self) {
        self.nodes.clear();
        self.links.clear();
    }

    /// Adds a link.
    pub fn link(&mut self, lo: u32, hi: u32, carries: Carries) {
        self.links.push(Link { lo, hi, carries, flow: 0.0, cut: false });
    }

    /// Finds every node's acceleration and every link's flow.
    pub fn solve(&mut self) {
        if self.links.is_empty() {
            for node in &mut self.nodes {
                node.acceleration = node.force / node.mass;
            }
            return;
        }
        if self.nodes.len() == 1 && self.rests_alone() {
            return;
        }
        self.index_links();
        self.find_components();
        let mut next = 0;
        while next < self.blocks.len() {
            self.settle_block(next);
            next += 1;
        }
    }

    /// The direct answer for one body that presses against the ground, shared equally between all that carries it: what `settle_block`
    /// comes to. False, and nothing done, if friction has to hold it or nothing does.
    fn rests_alone(&mut self) -> bool {
        let force = self.nodes[0].force;
        let carries = |link: &Link| link.carries == Carries::Push && (link.hi == GROUND) == (force > 0.0);
        let supports = self.links.iter().filter(|link| carries(link)).count();
        if force == 0.0 || supports == 0 {
            return false;
        }
        let share = force.abs() / supports as f64;
        for link in &mut self.links {
            if carries(link) {
                link.flow = share;
            }
        }
        self.nodes[0].acceleration = 0.0;
        true
    }

    fn slot(&self, end: u32) -> usize {
        if end == GROUND { self.nodes.len() } else { end as usize }
    }

    fn index_links(&mut self) {
        let n = self.nodes.len();
        self.first.clear();
        self.first.resize(n + 2, 0);
        for link in &self.links {
            for end in [link.lo, link.hi] {
                let slot = self.slot(end);
                self.first[slot + 1] += 1;
            }
        }
        for i in 0..=n {
            self.first[i + 1] += self.first[i];
        }
        self.around.clear();
        self.around.resize(2 * self.links.len(), 0);
        // Filling from the back leaves `first` at each node's beginning, with its links in ascending order.
        for (index, link) in self.links.iter().enumerate().rev() {
            for end in [link.lo, link.hi] {
                let slot = self.slot(end);
                self.first[slot + 1] -= 1;
                let at = self.first[slot + 1] as usize;
                self.around[at] = index as u32;
            }
        }
        // Each `first[i + 1]` now holds the beginning of node i: shift back by one.
        self.first.remove(0);
        self.first.push(2 * self.links.len() as u32);
        self.excess.clear();
        self.excess.resize(n, 0.0);
        self.waits_for.clear();
        self.waits_for.resize(n, 0);
        self.side.clear();
        self.side.resize(n, Side::Same);
        self.came_by.clear();
        self.came_by.resize(n + 1, NOWHERE);
        self.block_of.clear();
        self.block_of.resize(n, NOWHERE);
    }

    fn links_of(&self, node: u32) -> std::ops::Range<usize> {
        let slot = self.slot(node);
        self.first[slot] as usize..self.first[slot + 1] as usize
    }

    /// Bodies joined by links; the ground joins nothing, because it moves for nobody.
    fn find_components(&mut self) {
        self.order.clear();
        self.blocks.clear();
        for root in 0..self.nodes.len() as u32 {
            if self.block_of[root as usize] != NOWHERE {
                continue;
            }
            let block = self.blocks.len() as u32;
            let begin = self.order.len();
            self.block_of[root as usize] = block;
            self.order.push(root);
            let mut at = begin;
            while at < self.order.len() {
                let node = self.order[at];
                at += 1;
                for slot in self.links_of(node) {
                    let other = self.links[self.around[slot] as usize].other(node);
                    if other != GROUND && self.block_of[other as usize] == NOWHERE {
                        self.block_of[other as usize] = block;
                        self.order.push(other);
                    }
                }
            }
            self.blocks.push((begin as u32, self.order.len() as u32));
        }
    }

    /// Gives the block one acceleration if its links can make it move as one; otherwise cuts it into parts, which come later.
    fn settle_block(&mut self, block: usize) {
        let (begin, end) = (self.blocks[block].0 as usize, self.blocks[block].1 as usize);
        let (mut mass, mut force, mut largest, mut grounded) = (0.0, 0.0, 0.0f64, false);
        for at in begin..end {
            let i = self.order[at];
            let node = self.nodes[i as usize];
            mass += node.mass;
            force += node.force;
            largest = largest.max(node.force.abs());
            grounded |= self.links_of(i).any(|slot| {
                let link = &self.links[self.around[slot] as usize];
                !link.cut && link.other(i) == GROUND
            });
        }
        let acceleration = if grounded { 0.0 } else { force / mass };
        for at in begin..end {
            self.nodes[self.order[at] as usize].acceleration = acceleration;
        }
        if end - begin == 1 && !grounded {
            return;
        }
        let tolerance = largest * FORCE_TOLERANCE;
        if self.passes(begin, end, true, tolerance) || self.passes(begin, end, false, tolerance) {
            return;
        }
        self.reset_flows(begin, end);
        self.route(begin, end, grounded, tolerance);
        self.split(begin, end, grounded);
    }

    fn reset_flows(&mut self, begin: usize, end: usize) {
        for at in begin..end {
            let i = self.order[at];
            let node = self.nodes[i as usize];
            self.excess[i as usize] = node.force - node.mass * node.acceleration;
            for slot in self.links_of(i) {
                let link = &mut self.links[self.around[slot] as usize];
                if !link.cut {
                    link.flow = 0.0;
                }
            }
        }
    }

    /// One pass along the axis: every body hands its excess on to the bodies (or the ground) that it presses against, in equal shares, as
    /// soon as it has been handed all of its own (Kahn's order). True if that settles the block: nobody would have to pull.
    fn passes(&mut self, begin: usize, end: usize, upwards: bool, tolerance: f64) -> bool {
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
            self.waits_for[i as usize] = bearing.count() as u32;
            if self.waits_for[i as usize] == 0 {
                self.queue.push(i);
            }
        }
        let mut next = 0;
        while next < self.queue.len() {
            let i = self.queue[next];
            next += 1;
            let load = sign * self.excess[i as usize];
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
                        self.excess[other as usize] += sign * share;
                        self.waits_for[other as usize] -= 1;
                        if self.waits_for[other as usize] == 0 {
                            self.queue.push(other);
                        }
                    }
                }
            }
        }
        self.queue.len() == end - begin
    }

    /// Routes as much excess as the links allow along shortest paths: first from where it is to where it is missing or into the ground,
    /// then from the ground to where it is still missing.
    fn route(&mut self, begin: usize, end: usize, grounded: bool, tolerance: f64) {
        while let Some(goal) = self.search(begin, end, false, grounded, tolerance) {
            self.augment(goal);
        }
        // What the search still reaches from unrouted excess cannot be held back by the rest.
        for at in begin..end {
            let i = self.order[at] as usize;
            self.side[i] = if self.came_by[i] == NOWHERE { Side::Same } else { Side::Faster };
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
            self.came_by[self.order[at] as usize] = NOWHERE;
        }
        self.came_by[ground] = NOWHERE;
        self.queue.clear();
        if from_ground {
            self.came_by[ground] = START;
            self.queue.push(GROUND);
        } else {
            for at in begin..end {
                let i = self.order[at];
                if self.excess[i as usize] > tolerance {
                    self.came_by[i as usize] = START;
                    self.queue.push(i);
                }
            }
        }
        let block = self.block_of[self.order[begin] as usize];
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
                if self.came_by[place] != NOWHERE {
                    continue;
                }
                if other == GROUND {
                    if grounded {
                        self.came_by[place] = index;
                        return Some(GROUND);
                    }
                    continue;
                }
                if self.block_of[place] != block {
                    continue;
                }
                self.came_by[place] = index;
                if self.excess[place] < -tolerance {
                    return Some(other);
                }
                self.queue.push(other);
            }
        }
        None
    }

    /// Sends as much as fits along the path just found.
    fn augment(&mut self, goal: u32) {
        let mut amount = if goal == GROUND { f64::INFINITY } else { -self.excess[goal as usize] };
        let mut node = goal;
        while self.came_by[self.slot(node)] != START {
            let link = &self.links[self.came_by[self.slot(node)] as usize];
            let from = link.other(node);
            amount = amount.min(link.room(from));
            node = from;
        }
        if node != GROUND {
            amount = amount.min(self.excess[node as usize]);
            self.excess[node as usize] -= amount;
        }
        let mut node = goal;
        while self.came_by[self.slot(node)] != START {
            let index = self.came_by[self.slot(node)] as usize;
            let from = self.links[index].other(node);
            self.links[index].flow += if self.links[index].lo == from { amount } else { -amount };
            node = from;
        }
        if goal != GROUND {
            self.excess[goal as usize] += amount;
        }
    }

    /// Whatever could still pass force on to an unmet lack shares that lack.
    fn mark_slower(&mut self, begin: usize, end: usize, tolerance: f64) {
        let block = self.block_of[self.order[begin] as usize];
        self.queue.clear();
        for at in begin..end {
            let i = self.order[at];
            if self.excess[i as usize] < -tolerance && self.side[i as usize] == Side::Same {
                self.side[i as usize] = Side::Slower;
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
                let joined = !link.cut && other != GROUND && self.block_of[other as usize] == block;
                if joined && self.side[other as usize] == Side::Same && link.room(other) > tolerance {
                    self.side[other as usize] = Side::Slower;
                    self.queue.push(other);
                }
            }
        }
    }

    /// Cuts the block where the routing got stuck: ties across the cut slip at their limits, pushes across it have ended.
    fn split(&mut self, begin: usize, end: usize, grounded: bool) {
        let first = self.side[self.order[begin] as usize];
        let whole = (begin..end).all(|at| self.side[self.order[at] as usize] == first);
        if whole && (first == Side::Same || !grounded) {
            return;
        }
        for at in begin..end {
            let i = self.order[at];
            for slot in self.links_of(i) {
                let index = self.around[slot] as usize;
                let link = self.links[index];
                let other = link.other(i);
                let other_side = if other == GROUND { Side::Same } else { self.side[other as usize] };
                if link.cut || other_side == self.side[i as usize] {
                    continue;
                }
                self.links[index].cut = true;
                // Friction is passed on from the faster to the slower side.
                let i_is_faster = self.side[i as usize] > other_side;
                let flow = match link.carries {
                    Carries::Push => 0.0,
                    Carries::UpTo(limit) if (link.lo == i) == i_is_faster => limit,
                    Carries::UpTo(limit) => -limit,
                };
                self.links[index].flow = flow;
                for (end, sign) in [(link.lo, -1.0), (link.hi, 1.0)] {
                    if end != GROUND {
                        self.nodes[end as usize].force += sign * flow;
                    }
                }
            }
        }
        let side = &self.side;
        self.order[begin..end].sort_unstable_by_key(|&i| (side[i as usize], i));
        let mut at = begin;
        while at < end {
            let side = self.side[self.order[at] as usize];
            let from = at;
            while at < end && self.side[self.order[at] as usize] == side {
                self.block_of[self.order[at] as usize] = self.blocks.len() as u32;
                at += 1;
            }
            self.blocks.push((from as u32, at as u32));
        }
    }
}

#[cfg(test)]
mod tests;
