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
//! A column on ground is answered directly; most blocks settle in one pass of loads along the axis (`passes`), the rest by maximum flow
//! (`routing`). What a settled block leaves over within its tolerance is handed on by what is light in it, for which it may be all that acts.
//!
//! Ground may move: a link to it knows its acceleration (or, when impulses are solved for, its velocity). Where all ground of a network
//! moves alike, the network is solved in its frame. Otherwise a block is held against one of its grounds at a time: seen from there,
//! ties to the others drag with their limits, and what others push is pushed by more than all else together can hold. A block between two
//! grounds that close on it can follow neither, and says so (`squeezed`).
//!
//! No iteration towards a limit, no dependence on mass ratio; a block with the ground has a = 0 bit for bit. Where several supports
//! could carry a load (statically indeterminate), they share it equally if no tie is needed. Cost: one linear pass for a pile at rest
//! or a pushed row; otherwise O(nodes · links) a block, meant for up to a few hundred bodies.

pub(crate) mod passes;
pub(crate) mod routing;

use crate::physics::contact::network::routing::NOWHERE;
use crate::physics::data::tuning::FORCE_TOLERANCE;

/// The index of the ground as an end of a link.
pub(crate) const GROUND: u32 = u32::MAX;

/// What a link can carry.
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
    /// What it can carry.
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
    blocks: Vec<(u32, u32)>,
    /// What is noted about each node; the last one is the ground.
    notes: Vec<Note>,
    queue: Vec<u32>,
    /// Whether a node has a link, where that is asked.
    linked: Vec<bool>,
    /// Links of the present block to ground that moves otherwise than that it is held against.
    aside: Vec<u32>,
}

/// What is pulled at by less than such a part of what pulls at the rest of its block is light: what the block leaves over is looked at once more.
const LIGHT: f64 = 1e-3;

/// What a ground pushes with that moves otherwise than the one a block is held against, by the sum of all that acts in the block. It
/// has to exceed what all else can hold.
const OVERWHELMING: f64 = 4.0;

/// What a solve notes about a node.
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

impl Note {
    const NEW: Self = Self { excess: 0.0, block: NOWHERE, waits_for: 0, came_by: NOWHERE, side: Side::Same };
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Side {
    Slower,
    Same,
    Faster,
}

impl Network {
    /// Empties it, keeping the buffers.
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
        if !self.lies_on_ground() && !self.is_pair() && !self.is_column() {
            self.solve_by_blocks();
        }
        self.leave_frame(frame);
    }

    /// The acceleration of all ground, if it moves alike; else 0.
    fn common_frame(&self) -> f64 {
        let mut grounds = self.links.iter().filter(|link| link.is_grounded()).map(|link| link.ground);
        let first = grounds.next().unwrap_or(0.0);
        if grounds.all(|ground| ground == first) { first } else { 0.0 }
    }

    /// What nothing is linked to stays outside: in that frame what little pulls at it could be lost to rounding.
    fn enter_frame(&mut self, frame: f64) {
        self.linked.clear();
        if frame != 0.0 {
            self.linked.resize(self.nodes.len(), false);
            for end in self.links.iter().flat_map(|link| [link.lo, link.hi]).filter(|end| *end != GROUND) {
                self.linked[end as usize] = true;
            }
            self.linked_nodes().for_each(|node| node.force -= node.mass * frame);
            self.links.iter_mut().for_each(|link| link.ground = 0.0);
        }
    }

    fn linked_nodes(&mut self) -> impl Iterator<Item = &mut Node> {
        self.nodes.iter_mut().zip(&self.linked).filter(|(_, linked)| **linked).map(|(node, _)| node)
    }

    fn leave_frame(&mut self, frame: f64) {
        if frame != 0.0 {
            self.linked_nodes().for_each(|node| node.acceleration += frame);
        }
    }

    fn solve_by_blocks(&mut self) {
        if self.stays() {
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

    fn slot(&self, end: u32) -> usize {
        if end == GROUND { self.nodes.len() } else { end as usize }
    }

    fn index_links(&mut self) {
        let n = self.nodes.len();
        // Count, sum up to where each node's links end, and fill from the back: their order stays ascending.
        self.first.clear();
        self.first.resize(n + 2, 0);
        for link in &self.links {
            for end in [link.lo, link.hi] {
                let slot = self.slot(end);
                self.first[slot] += 1;
            }
        }
        for i in 0..=n {
            self.first[i + 1] += self.first[i];
        }
        self.around.clear();
        self.around.resize(2 * self.links.len(), 0);
        for (index, link) in self.links.iter().enumerate().rev() {
            for end in [link.lo, link.hi] {
                let slot = self.slot(end);
                self.first[slot] -= 1;
                let at = self.first[slot] as usize;
                self.around[at] = index as u32;
            }
        }
        self.notes.clear();
        self.notes.resize(n + 1, Note::NEW);
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
            self.blocks.push((begin as u32, self.order.len() as u32));
        }
    }

    /// Gives the block one acceleration if its links can make it move as one; otherwise cuts it into parts, which come later.
    fn settle_block(&mut self, block: usize) {
        let (begin, end) = (self.blocks[block].0 as usize, self.blocks[block].1 as usize);
        let (mut mass, mut force, mut largest, mut ground) = (0.0, 0.0, 0.0f64, None);
        for at in begin..end {
            let i = self.order[at];
            let node = self.nodes[i as usize];
            mass += node.mass;
            force += node.force;
            largest = largest.max(node.force.abs());
            let grounds = self.links_of(i).map(|slot| &self.links[self.around[slot] as usize]);
            ground = ground.or_else(|| grounds.filter(|link| !link.cut && link.other(i) == GROUND).map(|link| link.ground).next());
        }
        let acceleration = ground.unwrap_or(force / mass);
        for at in begin..end {
            self.nodes[self.order[at] as usize].acceleration = acceleration;
        }
        if end - begin == 1 && ground.is_none() {
            return;
        }
        let elsewhere = ground.is_some_and(|ground| self.part_with_other_grounds(begin, end, ground));
        let tolerance = largest * FORCE_TOLERANCE;
        if !elsewhere && (self.passes(begin, end, true, tolerance) || self.passes(begin, end, false, tolerance)) {
            return self.settle_light(begin, end, largest);
        }
        self.reset_flows(begin, end);
        if elsewhere {
            self.pull_by_other_grounds(begin, end, acceleration);
        }
        self.route(begin, end, ground.is_some(), tolerance);
        if !self.split(begin, end, ground) && !elsewhere {
            self.settle_light(begin, end, largest);
        }
    }

    /// What is nothing beside the rest of its block may be all that acts on something light. The lightest first, it is handed on to what is not light,
    /// or at least heavier, or numbered later; what is pulled away from all that it is only pushed by goes on by itself.
    fn settle_light(&mut self, begin: usize, end: usize, largest: f64) {
        let own = |node: &Node| node.force.abs().max(node.mass * node.acceleration.abs());
        let is_light = |node: &Node| own(node) < LIGHT * largest;
        self.queue.clear();
        self.queue.extend(self.order[begin..end].iter().copied().filter(|i| is_light(&self.nodes[*i as usize])));
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

    /// Sets those links aside (`cut`) that lead to ground which moves otherwise than `ground`. Returns whether there are any.
    fn part_with_other_grounds(&mut self, begin: usize, end: usize, ground: f64) -> bool {
        let mut any = false;
        for at in begin..end {
            let i = self.order[at];
            for slot in self.links_of(i) {
                let link = &mut self.links[self.around[slot] as usize];
                if !link.cut && link.other(i) == GROUND && link.ground != ground {
                    (link.cut, any) = (true, true);
                    self.aside.push(self.around[slot]);
                }
            }
        }
        any
    }

    /// Adds to the excess of the nodes what the grounds set aside do to them while they move with the acceleration `held`: ties drag with
    /// their limit, and what is pushed is pushed by more than everything else in the block together.
    fn pull_by_other_grounds(&mut self, begin: usize, end: usize, held: f64) {
        let (mut all, mut mass) = (0.0, 0.0);
        for at in begin..end {
            let i = self.order[at];
            all += self.notes[i as usize].excess.abs();
            mass += self.nodes[i as usize].mass;
            for slot in self.links_of(i) {
                if let Carries::UpTo(limit) = self.links[self.around[slot] as usize].carries {
                    all += if limit.is_finite() { limit } else { 0.0 };
                }
            }
        }
        for k in 0..self.aside.len() {
            let link = &mut self.links[self.aside[k] as usize];
            let node = if link.lo == GROUND { link.hi } else { link.lo };
            let ahead = (link.ground - held).signum();
            let side = if link.lo == GROUND { 1.0 } else { -1.0 };
            let drag = match link.carries {
                Carries::UpTo(limit) if limit.is_finite() => limit,
                Carries::Push if ahead != side => 0.0,
                // Where nothing else acts it is what the block's own inertia asks for.
                Carries::Push | Carries::UpTo(_) => OVERWHELMING * (all + mass * (link.ground - held).abs()),
            };
            link.flow = side * ahead * drag;
            self.notes[node as usize].excess += ahead * drag;
        }
    }

    fn reset_flows(&mut self, begin: usize, end: usize) {
        for at in begin..end {
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
