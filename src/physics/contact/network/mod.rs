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
//! Most blocks settle in one pass of loads along the axis (`passes`), the rest by maximum flow (`routing`). What a settled block leaves over within its tolerance is handed on by what is light in it, for which it may be all that acts.
//!
//! Ground may move: a link to it knows its acceleration (or, when impulses are solved for, its velocity). Where all ground of a network
//! moves alike, the network is solved in its frame. Otherwise a block is held against one of its grounds at a time: seen from there,
//! ties to the others drag with their limits, and what others push is pushed by more than all else together can hold. A block between two
//! grounds that close on it can follow neither, and says so (`squeezed`).
//!
//! No iteration towards a limit, no dependence on mass ratio; a block with the ground has a = 0 bit for bit. Where several supports
//! could carry a load (statically indeterminate), they share it equally if no tie is needed. Cost: one linear pass for a pile at rest
//! or a pushed row; otherwise O(nodes · links) a block, meant for up to a few hundred bodies.

pub(crate) mod grounds;
pub(crate) mod passes;
pub(crate) mod routing;

use crate::physics::data::lists::refill;
use crate::physics::data::tuning::{FORCE_TOLERANCE, LIGHT};
use std::ops::Range;

/// The index of the ground as an end of a link.
pub(crate) const GROUND: u32 = u32::MAX;

/// No block and no link.
const NOWHERE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Carries {
    /// Any push, never a pull.
    Push,
    /// Up to this many newtons either way.
    UpTo(f64),
}

/// A contact as seen along one axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    /// The body at the smaller coordinate, or the ground.
    pub lo: u32,
    /// The body at the larger coordinate, or the ground.
    pub hi: u32,
    pub carries: Carries,
    /// What the ground does, if one of the ends is it, m/s².
    pub ground: f64,
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

    fn is_grounded(&self) -> bool {
        self.lo == GROUND || self.hi == GROUND
    }
}

/// A body along one axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    /// kg.
    pub mass: f64,
    /// Applied force without the contacts of this network, N.
    pub force: f64,
    /// The solution, m/s².
    pub acceleration: f64,
}

/// The network of one axis; its buffers are kept from solve to solve.
#[derive(Clone, Debug, Default)]
pub(crate) struct Network {
    pub nodes: Vec<Node>,
    pub links: Vec<Link>,
    /// The nodes of blocks that cannot follow the grounds that close on them.
    pub squeezed: Vec<u32>,
    /// Links of node i: `around[first[i]..first[i + 1]]`; the last node is the ground.
    first: Vec<u32>,
    around: Vec<u32>,
    /// All nodes, each block a contiguous range of it.
    order: Vec<u32>,
    blocks: Vec<Range<u32>>,
    /// What is noted about each node; the last one is the ground.
    notes: Vec<Note>,
    queue: Vec<u32>,
    /// Whether a node has a link, where that is asked.
    linked: Vec<bool>,
    /// Links of the present block to ground that moves otherwise than that it is held against.
    aside: Vec<u32>,
}

/// The block that is being settled: a part of `order`.
#[derive(Clone, Copy, Debug)]
struct Block {
    begin: usize,
    end: usize,
    /// What the ground does that the block is held against, m/s².
    ground: Option<f64>,
    /// The largest force that acts on one of its nodes, N.
    largest: f64,
}

impl Block {
    /// Up to where a force left over is none, N.
    fn tolerance(&self) -> f64 {
        self.largest * FORCE_TOLERANCE
    }
}

#[derive(Clone, Copy, Debug)]
struct Note {
    /// Force that is left to be passed on, N.
    excess: f64,
    block: u32,
    /// How many nodes have not handed their load on to this one yet.
    waits_for: u32,
    /// The link by which a search reached it.
    came_by: u32,
    side: Side,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Side {
    Slower,
    Same,
    Faster,
}

impl Network {
    pub fn clear(&mut self) {
        self.nodes.clear();
        self.links.clear();
        self.squeezed.clear();
    }

    /// Adds a link; `ground` is what the ground does (m/s²) if one of the ends is it.
    pub fn link(&mut self, lo: u32, hi: u32, carries: Carries, ground: f64) {
        self.links.push(Link { lo, hi, carries, ground, flow: 0.0, cut: false });
    }

    /// Finds every node's acceleration and every link's flow.
    pub fn solve(&mut self) {
        if self.links.is_empty() {
            for node in &mut self.nodes {
                node.acceleration = node.force / node.mass;
            }
            return;
        }
        let frame = self.common_frame();
        self.enter_frame(frame);
        self.index_links();
        self.find_components();
        let mut next = 0;
        while next < self.blocks.len() {
            self.settle_block(next);
            next += 1;
        }
        self.leave_frame(frame);
    }

    fn slot(&self, end: u32) -> usize {
        if end == GROUND { self.nodes.len() } else { end as usize }
    }

    fn index_links(&mut self) {
        let n = self.nodes.len();
        // Count, sum up to where each node's links end, and fill from the back: their order stays ascending.
        refill(&mut self.first, n + 2, 0);
        for link in &self.links {
            for end in [link.lo, link.hi] {
                let slot = self.slot(end);
                self.first[slot] += 1;
            }
        }
        for i in 0..=n {
            self.first[i + 1] += self.first[i];
        }
        refill(&mut self.around, 2 * self.links.len(), 0);
        for (index, link) in self.links.iter().enumerate().rev() {
            for end in [link.lo, link.hi] {
                let slot = self.slot(end);
                self.first[slot] -= 1;
                let at = self.first[slot] as usize;
                self.around[at] = index as u32;
            }
        }
        refill(&mut self.notes, n + 1, Note { excess: 0.0, block: NOWHERE, waits_for: 0, came_by: NOWHERE, side: Side::Same });
    }

    fn links_of(&self, node: u32) -> Range<usize> {
        let slot = self.slot(node);
        self.first[slot] as usize..self.first[slot + 1] as usize
    }

    /// Bodies joined by links; the ground joins nothing, because it moves for nobody.
    fn find_components(&mut self) {
        self.order.clear();
        self.blocks.clear();
        for root in 0..self.nodes.len() as u32 {
            if self.notes[root as usize].block != NOWHERE {
                continue;
            }
            let block = self.blocks.len() as u32;
            let begin = self.order.len();
            self.notes[root as usize].block = block;
            self.order.push(root);
            let mut at = begin;
            while at < self.order.len() {
                let node = self.order[at];
                at += 1;
                for slot in self.links_of(node) {
                    let other = self.links[self.around[slot] as usize].other(node);
                    if other != GROUND && self.notes[other as usize].block == NOWHERE {
                        self.notes[other as usize].block = block;
                        self.order.push(other);
                    }
                }
            }
            self.blocks.push(begin as u32..self.order.len() as u32);
        }
    }

    /// Gives the block one acceleration if its links can make it move as one; otherwise cuts it into parts, which come later.
    fn settle_block(&mut self, index: usize) {
        let Range { start, end } = self.blocks[index];
        let mut block = Block { begin: start as usize, end: end as usize, ground: None, largest: 0.0 };
        let (mut mass, mut force) = (0.0, 0.0);
        for &i in &self.order[block.begin..block.end] {
            let node = self.nodes[i as usize];
            mass += node.mass;
            force += node.force;
            block.largest = block.largest.max(node.force.abs());
            let grounds = self.links_of(i).map(|slot| &self.links[self.around[slot] as usize]);
            let mut held = grounds.filter(|link| !link.cut && link.other(i) == GROUND).map(|link| link.ground);
            block.ground = block.ground.or_else(|| held.next());
        }
        let acceleration = block.ground.unwrap_or(force / mass);
        for &i in &self.order[block.begin..block.end] {
            self.nodes[i as usize].acceleration = acceleration;
        }
        if block.end - block.begin == 1 && block.ground.is_none() {
            return;
        }
        let elsewhere = block.ground.is_some_and(|ground| self.part_with_other_grounds(block, ground));
        if !elsewhere && (self.passes(block, true) || self.passes(block, false)) {
            return self.settle_light(block);
        }
        self.reset_flows(block);
        if elsewhere {
            self.pull_by_other_grounds(block, acceleration);
        }
        self.route(block);
        if !self.split(block) && !elsewhere {
            self.settle_light(block);
        }
    }

    /// What is nothing beside the rest of its block may be all that acts on something light. The lightest first, it is handed on to what is not light,
    /// or at least heavier, or numbered later; what is pulled away from all that it is only pushed by goes on by itself.
    fn settle_light(&mut self, block: Block) {
        let own = |node: &Node| node.force.abs().max(node.mass * node.acceleration.abs());
        let is_light = |node: &Node| own(node) < LIGHT * block.largest;
        self.queue.clear();
        self.queue.extend(self.order[block.begin..block.end].iter().copied().filter(|i| is_light(&self.nodes[*i as usize])));
        let nodes = &self.nodes;
        self.queue.sort_unstable_by(|a, b| nodes[*a as usize].mass.total_cmp(&nodes[*b as usize].mass).then(a.cmp(b)));
        for k in 0..self.queue.len() {
            let i = self.queue[k];
            let node = self.nodes[i as usize];
            let links = || self.links_of(i).map(|slot| self.around[slot]).filter(|link| !self.links[*link as usize].cut);
            let gets = |link: &Link| if link.lo == i { -link.flow } else { link.flow };
            let gotten: f64 = links().map(|link| gets(&self.links[link as usize])).sum();
            let left = node.force - node.mass * node.acceleration + gotten;
            if left.abs() <= own(&node) * FORCE_TOLERANCE {
                continue;
            }
            let (mut best, mut fits, mut idle) = ((node.mass, i, None), false, true);
            for index in links() {
                let link = &self.links[index as usize];
                let other = link.other(i);
                let heavy =
                    self.nodes.get(other as usize).filter(|other| is_light(other)).map_or(f64::INFINITY, |other| other.mass);
                let flow = if link.lo == i { link.flow + left } else { link.flow - left };
                idle &= link.flow == 0.0 && link.carries == Carries::Push;
                let carried = match link.carries {
                    Carries::Push => flow >= 0.0,
                    Carries::UpTo(limit) => flow.abs() <= limit,
                };
                fits |= carried;
                if carried && (heavy > best.0 || heavy == best.0 && other > best.1) {
                    best = (heavy, other, Some((index, flow)));
                }
            }
            if let (.., Some((link, flow))) = best {
                self.links[link as usize].flow = flow;
            } else if idle && !fits {
                self.nodes[i as usize].acceleration += left / node.mass;
            }
        }
    }

    fn reset_flows(&mut self, block: Block) {
        for at in block.begin..block.end {
            let i = self.order[at];
            let node = self.nodes[i as usize];
            self.notes[i as usize].excess = node.force - node.mass * node.acceleration;
            for slot in self.links_of(i) {
                let link = &mut self.links[self.around[slot] as usize];
                if !link.cut {
                    link.flow = 0.0;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
