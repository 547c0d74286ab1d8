//! Contact forces along one axis, exactly: Gauss's principle of least constraint as isotonic regression with total variation, solved block by block
//! (`docs/physics.md`, Contact networks; Fujishige 1980, Groenevelt 1991). A *normal* link passes any push from its lower to its upper body, a *tie*
//! (static friction) up to its limit either way. Most blocks settle in one pass of loads, the rest by maximum flow, O(nodes · links) a block. The error
//! does not depend on the mass ratio; a block with the ground has a = 0 bit for bit, and is `squeezed` between two grounds that close on it.

mod grounds;
mod routing;

use crate::physics::data::{FORCE_TOLERANCE, Incidence, LIGHT, NONE, refill};
use std::ops::Range;

pub(crate) const GROUND: u32 = u32::MAX;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Carries {
    Push,
    /// Up to this many newtons either way.
    UpTo(f64),
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct NetworkEdge {
    pub lo: u32,
    pub hi: u32,
    pub carries: Carries,
    /// The acceleration of the ground, if one of the ends is it, m/s².
    pub ground: f64,
    /// The force passed on from `lo` to `hi`, N: `hi` feels it along the axis, `lo` against it.
    pub flow: f64,
    /// Cut: its ends move apart (a tie then slips at its limit).
    pub cut: bool,
}

impl NetworkEdge {
    fn room(&self, onwards: bool) -> f64 {
        match (self.carries, onwards) {
            (Carries::Push, true) => f64::INFINITY,
            (Carries::Push, false) => self.flow,
            (Carries::UpTo(limit), true) => limit - self.flow,
            (Carries::UpTo(limit), false) => limit + self.flow,
        }
    }

    fn hands_on(&self, end: u32, upwards: bool) -> bool {
        !self.cut && self.carries == Carries::Push && (if upwards { self.lo } else { self.hi }) == end
    }

    fn other(&self, end: u32) -> u32 {
        if self.lo == end { self.hi } else { self.lo }
    }

    /// What it gives to one of its ends, N.
    fn gives(&self, end: u32) -> f64 {
        if self.lo == end { -self.flow } else { self.flow }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct NetworkNode {
    /// kg.
    pub mass: f64,
    /// Force without the contacts of this network, N.
    pub force: f64,
    /// The solution, m/s².
    pub acceleration: f64,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Network {
    pub nodes: Vec<NetworkNode>,
    pub links: Vec<NetworkEdge>,
    /// The nodes of blocks that cannot follow the grounds that close on them.
    pub squeezed: Vec<u32>,
    /// The links of each node; the last node is the ground.
    incident: Incidence,
    /// What its links join, whatever they carry: nodes, block by block, and where each begins and ends; the ends of all links, to know it again.
    joined: (Vec<u32>, Vec<Range<u32>>),
    ends: Vec<[u32; 2]>,
    /// Its last question with these links, the force on each node, N; the answer, and whether it stands.
    asked: Vec<f64>,
    answer: (Vec<NetworkNode>, Vec<NetworkEdge>),
    pub answered: bool,
    order: Vec<u32>,
    blocks: Vec<Range<u32>>,
    /// What is noted about each node; the last one is the ground.
    notes: Vec<Note>,
    queue: Vec<u32>,
    starts: Vec<u32>,
    lacks: Vec<u32>,
    /// Where a search arrived, and by which link.
    goals: Vec<(u32, u32)>,
    grounds_move_alike: bool,
    /// Links of the present block to ground that moves otherwise than that it is held against.
    aside: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Block {
    begin: usize,
    end: usize,
    /// The acceleration of the ground that the block is held against, m/s².
    ground: Option<f64>,
    largest: f64,
}

impl Block {
    /// A smaller force left over is none, N.
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
        std::mem::swap(&mut self.nodes, &mut self.answer.0);
        std::mem::swap(&mut self.links, &mut self.answer.1);
        self.nodes.clear();
        self.links.clear();
        self.squeezed.clear();
    }

    pub fn link(&mut self, lo: u32, hi: u32, carries: Carries, ground: f64) {
        self.links.push(NetworkEdge { lo, hi, carries, ground, flow: 0.0, cut: false });
    }

    pub fn solve(&mut self) {
        if self.links.is_empty() {
            self.answered = false;
            return self.nodes.iter_mut().for_each(|node| node.acceleration = node.force / node.mass);
        }
        let frame = self.common_frame();
        self.find_blocks();
        self.enter_frame(frame);
        self.repeat_answers(frame);
        self.asked.clear();
        self.asked.extend(self.nodes.iter().map(|node| node.force));
        let mut next = 0;
        while next < self.blocks.len() {
            if !self.blocks[next].is_empty() {
                self.settle_block(next);
            }
            next += 1;
        }
        self.answered = frame == 0.0 && self.squeezed.is_empty();
        self.leave_frame(frame);
    }

    /// Whether all can stay at rest on ground that stands, beginning with the flow of each link: the links take up what is left over.
    pub fn holds(&mut self) -> bool {
        self.find_blocks();
        (0..self.blocks.len()).all(|index| {
            let Range { start, end } = self.blocks[index];
            let mut block = Block { begin: start as usize, end: end as usize, ground: Some(0.0), largest: 0.0 };
            for &i in &self.order[block.begin..block.end] {
                let force = self.nodes[i as usize].force;
                let given: f64 = self.links_of(i).map(|link| link.gives(i)).sum();
                block.largest = block.largest.max(force.abs());
                self.notes[i as usize].excess = force + given;
            }
            self.route(block);
            self.order[block.begin..block.end].iter().all(|i| self.notes[*i as usize].excess.abs() <= block.tolerance())
        })
    }

    fn slot(&self, end: u32) -> usize {
        if end == GROUND { self.nodes.len() } else { end as usize }
    }

    fn links_of(&self, node: u32) -> impl Iterator<Item = &NetworkEdge> {
        self.incident.of(node as usize).iter().map(|index| &self.links[*index as usize])
    }

    fn find_blocks(&mut self) {
        let n = self.nodes.len();
        refill(&mut self.notes, n + 1, Note { excess: 0.0, block: NONE, waits_for: 0, came_by: NONE, side: Side::Same });
        let ends = self.links.iter().map(|link| [link.lo, link.hi]);
        if self.joined.0.len() != n || !self.ends.iter().copied().eq(ends.clone()) {
            self.ends.clear();
            self.ends.extend(ends);
            self.answered = false;
            // The number of the ground is the largest.
            self.incident.index(n + 1, self.ends.iter().map(|ends| ends.map(|end| end.min(n as u32))));
            self.find_components();
        }
        self.order.clone_from(&self.joined.0);
        self.blocks.clone_from(&self.joined.1);
        for (number, block) in (0..).zip(&self.blocks) {
            self.order[block.start as usize..block.end as usize].iter().for_each(|i| self.notes[*i as usize].block = number);
        }
    }

    /// Blocks of which nothing is asked that was not asked last have the same answer, and are none any more.
    fn repeat_answers(&mut self, frame: f64) {
        let Self { nodes, links, asked, answer, order, blocks, incident, .. } = self;
        if frame != 0.0 || !self.answered {
            return;
        }
        for block in blocks.iter_mut() {
            let of = &order[block.start as usize..block.end as usize];
            let links_of = |i: u32| incident.of(i as usize).iter().map(|index| *index as usize);
            let same_node = |i: usize| nodes[i].mass == answer.0[i].mass && nodes[i].force.to_bits() == asked[i].to_bits();
            let same_link = |a: &NetworkEdge, b: &NetworkEdge| a.carries == b.carries && a.ground == b.ground;
            let known = |i: &u32| same_node(*i as usize) && links_of(*i).all(|index| same_link(&links[index], &answer.1[index]));
            if of.iter().all(known) {
                for &i in of {
                    nodes[i as usize].acceleration = answer.0[i as usize].acceleration;
                    links_of(i).for_each(|index| links[index] = answer.1[index]);
                }
                block.end = block.start;
            }
        }
    }

    fn find_components(&mut self) {
        let (order, blocks) = &mut self.joined;
        order.clear();
        blocks.clear();
        for root in 0..self.nodes.len() as u32 {
            let begin = order.len();
            let mut join = |node: u32, order: &mut Vec<u32>| {
                if node != GROUND && std::mem::replace(&mut self.notes[node as usize].block, 0) == NONE {
                    order.push(node);
                }
            };
            join(root, order);
            let mut at = begin;
            while at < order.len() {
                let node = order[at];
                at += 1;
                self.incident.of(node as usize).iter().for_each(|index| join(self.links[*index as usize].other(node), order));
            }
            if begin < order.len() {
                blocks.push(begin as u32..order.len() as u32);
            }
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
            let held = || self.links_of(i).find(|link| !link.cut && link.other(i) == GROUND).map(|link| link.ground);
            block.ground = block.ground.or_else(held);
        }
        let acceleration = block.ground.unwrap_or(force / mass);
        self.order[block.begin..block.end].iter().for_each(|i| self.nodes[*i as usize].acceleration = acceleration);
        if block.end - block.begin == 1 && block.ground.is_none() {
            return;
        }
        let elsewhere = !self.grounds_move_alike && block.ground.is_some_and(|ground| self.part_with_other_grounds(block, ground));
        // Nothing flows in what has not been cut yet.
        self.reset(block, index >= self.joined.1.len());
        for upwards in [true, false] {
            if !elsewhere && self.may_pass(block, upwards) {
                if self.passes(block, upwards) {
                    return self.settle_light(block);
                }
                self.reset(block, true);
            }
        }
        if elsewhere {
            self.pull_by_other_grounds(block, acceleration);
        }
        self.route(block);
        if !self.split(block) && !elsewhere {
            self.settle_light(block);
        }
    }

    /// What is no force beside the rest of its block may be all that acts on a light body. The lightest first, it is handed on to a body that is
    /// heavy, heavier, or numbered later; a body that is pulled away from all that pushes it goes on by itself.
    fn settle_light(&mut self, block: Block) {
        let own = |node: &NetworkNode| node.force.abs().max(node.mass * node.acceleration.abs());
        let is_light = |node: &NetworkNode| own(node) < LIGHT * block.largest;
        self.queue.clear();
        self.queue.extend(self.order[block.begin..block.end].iter().filter(|i| is_light(&self.nodes[**i as usize])));
        let nodes = &self.nodes;
        self.queue.sort_unstable_by(|a, b| nodes[*a as usize].mass.total_cmp(&nodes[*b as usize].mass).then(a.cmp(b)));
        for k in 0..self.queue.len() {
            let i = self.queue[k];
            let node = self.nodes[i as usize];
            let links = || self.incident.of(i as usize).iter().copied().filter(|link| !self.links[*link as usize].cut);
            let gotten: f64 = links().map(|link| self.links[link as usize].gives(i)).sum();
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

    fn reset(&mut self, block: Block, flows: bool) {
        for &i in &self.order[block.begin..block.end] {
            let node = self.nodes[i as usize];
            self.notes[i as usize].excess = node.force - node.mass * node.acceleration;
            for index in self.incident.of(i as usize).iter().filter(|_| flows) {
                let link = &mut self.links[*index as usize];
                link.flow = if link.cut { link.flow } else { 0.0 };
            }
        }
    }
}

#[cfg(test)]
mod tests;
