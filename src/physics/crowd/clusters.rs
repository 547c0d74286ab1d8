//! Perfectly plastic merging along one axis by pooling adjacent violators (Ayer et al. 1955): exact on a row or a column; on branching groups a
//! member may be carried along for one step although it would have parted. Momentum is conserved and kinetic energy never grows.
//!
//! On immovable ground a cluster with momentum P, mass M and the ground's largest impulses S (static) and K (kinetic) has the velocity 0 while |P|
//! ≤ S, else (P ∓ K)/M. Pooling stays exact, as the terms K·|v| are convex.

use crate::physics::{crowd::Edge, crowd::contacts::CrowdContact, data::lists::NONE, data::lists::refill};

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Node {
    /// At the end of the step without the cluster and the ground's friction, N·s; and at its start.
    pub momentum: f64,
    pub began: f64,
    /// Mass times mean velocity without them, N·s.
    pub way: f64,
    pub mass: f64,
    /// Mass times how much faster than their cluster members go on average, N·s.
    pub offset: f64,
    pub static_limit: f64,
    pub kinetic_limit: f64,
}

impl Node {
    pub fn free(mass: f64, before: f64, velocity: f64, mean: f64) -> Self {
        Self { momentum: mass * velocity, began: mass * before, way: mass * mean, mass, ..Self::default() }
    }

    /// Its motion: as friction leaves it, spread evenly over the step, or until it stops.
    pub fn motion(&self) -> ClusterMotion {
        let velocity = slide(self.momentum, self.mass, self.static_limit, self.kinetic_limit);
        if velocity == 0.0 && (self.kinetic_limit > 0.0 || (self.static_limit > 0.0 && self.began == 0.0)) {
            let until = time_to_stop(self.began, self.momentum - self.began, self.kinetic_limit);
            return ClusterMotion { velocity, mean: (0.5 * until * self.began - self.offset) / self.mass };
        }
        ClusterMotion { velocity, mean: (self.way - 0.5 * (self.momentum - self.mass * velocity)) / self.mass }
    }
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ClusterMotion {
    pub velocity: f64,
    pub mean: f64,
}

/// Mean velocities (m/s) or places (m) before pooling, and their rounding.
pub(crate) struct Pool<Before> {
    pub before: Before,
    pub slack: f64,
    pub places: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct ClusterMember {
    root: u32,
    next: u32,
    /// Its mean velocity is the cluster's and this.
    offset: f64,
    fixed: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Root {
    /// The way is less what the members' offsets make of it.
    node: Node,
    motion: ClusterMotion,
    fixed: bool,
    /// The smallest restitution of the impacts by which it came about; 1 where there was none yet (`hit`).
    restitution: f64,
    hit: bool,
    size: u32,
    last: u32,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Clusters {
    is_joined: Vec<bool>,
    members: Vec<ClusterMember>,
    roots: Vec<Root>,
    pub joined: Vec<u32>,
    /// The pairs through which they were merged: a tree a cluster.
    pub edges: Vec<Edge>,
}

impl Clusters {
    pub fn begin(&mut self, all: usize) {
        self.joined.clear();
        refill(&mut self.is_joined, all, false);
        self.members.resize(all, ClusterMember::default());
        self.roots.resize(all, Root::default());
    }

    pub fn clear(&mut self) {
        self.edges.clear();
        self.joined.drain(..).for_each(|i| self.is_joined[i as usize] = false);
    }

    pub fn mean(&self, i: usize, own: f64) -> f64 {
        if !self.is_joined(i) {
            return own;
        }
        let member = &self.members[i];
        self.roots[member.root as usize].motion.mean + member.offset
    }

    pub fn velocity(&self, i: usize) -> f64 {
        self.roots[self.members[i].root as usize].motion.velocity
    }

    pub fn came_fixed(&self, i: usize) -> bool {
        self.members[i].fixed
    }

    pub fn is_fixed(&self, i: usize) -> bool {
        self.is_joined(i) && self.roots[self.members[i].root as usize].fixed
    }

    pub fn restitution(&self, i: usize) -> f64 {
        let root = &self.roots[self.members[i].root as usize];
        if root.hit { root.restitution } else { 0.0 }
    }

    pub fn bouncing(&self) -> impl Iterator<Item = Edge> + '_ {
        self.edges.iter().map(|edge| Edge { restitution: self.restitution(edge.a as usize), ..*edge })
    }

    pub fn hit(&mut self, contacts: [&[CrowdContact]; 2], hits: impl Fn(&CrowdContact) -> Option<f64>) {
        for contact in contacts.into_iter().flatten().filter(|contact| contact.live) {
            let (a, b) = (contact.first as usize, contact.second as usize);
            if !self.is_joined(a) || !self.is_joined(b) || self.members[a].root != self.members[b].root {
                continue;
            }
            let root = &mut self.roots[self.members[a].root as usize];
            if let Some(restitution) = hits(contact) {
                (root.restitution, root.hit) = (root.restitution.min(restitution), true);
            }
        }
    }

    pub fn is_joined(&self, i: usize) -> bool {
        self.is_joined[i]
    }

    /// The impulse that the ground takes up under a joined body's cluster while it stands, and its limit.
    pub fn held(&self, i: usize) -> (f64, f64) {
        let node = &self.roots[self.members[i].root as usize].node;
        (node.momentum, node.static_limit)
    }

    /// Lets a body in: `fixed` with a motion that nothing changes, or free with its node.
    pub fn join(&mut self, i: usize, fixed: Option<ClusterMotion>, node: Node) {
        if self.is_joined(i) {
            return;
        }
        let motion = fixed.unwrap_or_else(|| node.motion());
        self.is_joined[i] = true;
        self.members[i] = ClusterMember { root: i as u32, next: NONE, offset: 0.0, fixed: fixed.is_some() };
        self.roots[i] = Root { node, motion, fixed: fixed.is_some(), restitution: 1.0, hit: false, size: 1, last: i as u32 };
        self.joined.push(i as u32);
    }

    /// Merges pairs until no live contact, for places none at all, closes by more than its bound; `bring` lets a pair join, or refuses.
    /// Returns whether any closed, and whether some could not be merged.
    pub fn pool(
        &mut self,
        pool: Pool<impl Fn(usize) -> f64>,
        contacts: [&[CrowdContact]; 2],
        mut bring: impl FnMut(&mut Self, &CrowdContact) -> bool,
    ) -> (bool, bool) {
        self.clear();
        let (mut any, mut stuck, mut first) = (false, false, true);
        loop {
            let mut merged = false;
            for list in contacts {
                for contact in list {
                    let (a, b) = (contact.first as usize, contact.second as usize);
                    if !(contact.live || pool.places) || !(first || self.is_joined[a] || self.is_joined[b]) {
                        continue;
                    }
                    let bound = if pool.places { -contact.reach } else { contact.bound };
                    if self.mean(a, (pool.before)(a)) > self.mean(b, (pool.before)(b)) + bound + pool.slack {
                        let done = bring(self, contact) && self.merge(a, b, bound);
                        (any, merged, stuck) = (true, merged | done, stuck | !done);
                    }
                }
            }
            if !merged {
                return (any, stuck);
            }
            first = false;
        }
    }

    /// Makes the mean velocities of two joined bodies differ by `difference` (first minus second). Returns whether that was possible.
    pub fn merge(&mut self, first: usize, second: usize, difference: f64) -> bool {
        let (a, b) = (self.members[first], self.members[second]);
        let (ra, rb) = (self.roots[a.root as usize], self.roots[b.root as usize]);
        if a.root == b.root || (ra.fixed && rb.fixed) {
            return false;
        }
        self.edges.push(Edge { a: first as u32, b: second as u32, ..Edge::default() });
        // The frame of the larger one stays.
        let (keep, gone, kept, lost, shift) = if ra.size >= rb.size {
            (a.root, b.root, ra, rb, b.offset + difference - a.offset)
        } else {
            (b.root, a.root, rb, ra, a.offset - difference - b.offset)
        };
        // Kept mean = lost mean + shift.
        let node = Node {
            momentum: kept.node.momentum + lost.node.momentum,
            began: kept.node.began + lost.node.began,
            way: kept.node.way + lost.node.way + lost.node.mass * shift,
            mass: kept.node.mass + lost.node.mass,
            offset: kept.node.offset + lost.node.offset - lost.node.mass * shift,
            static_limit: kept.node.static_limit + lost.node.static_limit,
            kinetic_limit: kept.node.kinetic_limit + lost.node.kinetic_limit,
        };
        let mut at = gone;
        while at != NONE {
            let member = &mut self.members[at as usize];
            member.root = keep;
            member.offset -= shift;
            at = member.next;
        }
        self.members[kept.last as usize].next = gone;
        let fixed = kept.fixed || lost.fixed;
        let motion = if kept.fixed {
            kept.motion
        } else if lost.fixed {
            ClusterMotion { mean: lost.motion.mean + shift, ..lost.motion }
        } else {
            node.motion()
        };
        let size = kept.size + lost.size;
        self.roots[keep as usize] = Root { node, motion, fixed, restitution: 1.0, hit: false, size, last: lost.last };
        true
    }
}

/// The velocity of mass M and momentum P on ground whose friction can take `held` while it stands and `dragged` while it slides.
pub(crate) fn slide(momentum: f64, mass: f64, held: f64, dragged: f64) -> f64 {
    if momentum.abs() <= held { 0.0 } else { (momentum.abs() - dragged.min(momentum.abs())).copysign(momentum) / mass }
}

/// The part of the step for which a slide lasts that friction up to `dragged` stops; without it, it would gain `gained`.
pub(crate) fn time_to_stop(slide: f64, gained: f64, dragged: f64) -> f64 {
    let slowed = dragged.copysign(slide) - gained;
    if slowed == 0.0 { 1.0 } else { (slide / slowed).clamp(0.0, 1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_takes_the_common_velocity_and_its_ways_differ_by_the_gaps() {
        let mut clusters = Clusters::default();
        clusters.begin(3);
        for (i, velocity) in [6.0, 0.0, 0.0].into_iter().enumerate() {
            clusters.join(i, None, Node::free(1.0, velocity, velocity, velocity));
        }
        assert!(clusters.merge(0, 1, 0.0) && clusters.merge(1, 2, 0.5) && !clusters.merge(0, 2, 0.0));
        let mean: Vec<f64> = (0..3).map(|i| clusters.mean(i, 0.0)).collect();
        assert!((mean.iter().sum::<f64>() - 6.0).abs() < 1e-14);
        assert!((mean[0] - mean[1]).abs() < 1e-14 && (mean[1] - mean[2] - 0.5).abs() < 1e-14);
        assert!((0..3).all(|i| clusters.velocity(i) == 2.0));
    }

    #[test]
    fn a_wall_stops_all() {
        let mut clusters = Clusters::default();
        clusters.begin(3);
        clusters.join(0, None, Node::free(5.0, 2.0, 2.0, 2.0));
        clusters.join(1, None, Node::free(1.0, 1.0, 1.0, 1.0));
        clusters.join(2, Some(ClusterMotion::default()), Node::default());
        assert!(clusters.merge(0, 1, 0.0) && clusters.merge(1, 2, 0.0));
        assert_eq!((clusters.velocity(0), clusters.mean(1, 9.0)), (0.0, 0.0));
    }

    #[test]
    fn static_friction_of_the_whole_row_holds_it() {
        let mut clusters = Clusters::default();
        clusters.begin(2);
        let ground = |momentum| Node { momentum, mass: 1.0, static_limit: 1.0, kinetic_limit: 0.5, ..Node::default() };
        clusters.join(0, None, ground(1.9));
        clusters.join(1, None, ground(0.0));
        assert!(clusters.velocity(0) > 0.0);
        clusters.merge(0, 1, 0.0);
        assert_eq!(clusters.velocity(0), 0.0);
    }

    #[test]
    fn friction_holds_drags_and_never_reverses() {
        assert_eq!(slide(0.99, 2.0, 1.0, 0.5), 0.0);
        assert_eq!(slide(2.5, 2.0, 1.0, 0.5), 1.0);
        assert_eq!(slide(-2.5, 2.0, 1.0, 0.5), -1.0);
        assert_eq!(slide(0.3, 2.0, 0.2, 0.5), 0.0);
    }
}
