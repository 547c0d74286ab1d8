//! Perfectly plastic merging along one axis, for whatever is not carried by the ground.
//!
//! Two bodies that close faster than their gap allows become a cluster that moves as one: momentum is exactly conserved, energy
//! never grows, and after at most n − 1 merges nothing is violated. On a row or a column this is isotonic regression by pooling
//! adjacent violators (Ayer et al. 1955), the exact answer of the plastic impact; on branching groups a member may be carried
//! along for one step although it would have parted, since clusters never split.
//!
//! A cluster may lie on immovable ground with friction: with momentum P, mass M and the ground's largest impulses S (static) and
//! K (kinetic), its velocity is 0 while |P| ≤ S, else (P ∓ K)/M. Pooling stays exact, as the terms K·|v| are convex.

use super::gravity::slide;

/// What a body brings into its cluster.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Node {
    pub momentum: f64,
    pub mass: f64,
    pub static_limit: f64,
    pub kinetic_limit: f64,
}

#[derive(Clone, Copy, Debug, Default)]
struct Member {
    stamp: u32,
    root: u32,
    next: u32,
    /// Its velocity is the cluster's and this.
    offset: f64,
}

#[derive(Clone, Copy, Debug, Default)]
struct Root {
    node: Node,
    velocity: f64,
    fixed: bool,
    size: u32,
    last: u32,
}

const NONE: u32 = u32::MAX;

/// Groups of bodies that move as one along one axis. Only bodies that were merged are in one.
#[derive(Clone, Debug, Default)]
pub(super) struct Clusters {
    stamp: u32,
    members: Vec<Member>,
    roots: Vec<Root>,
    /// All that are in a cluster, in the order of joining.
    pub joined: Vec<u32>,
}

impl Clusters {
    pub fn new(all: usize) -> Self {
        Self { stamp: 0, members: vec![Member::default(); all], roots: vec![Root::default(); all], joined: Vec::with_capacity(all) }
    }

    /// Forgets all clusters.
    pub fn clear(&mut self) {
        self.joined.clear();
        self.stamp = self.stamp.wrapping_add(1);
        if self.stamp == 0 {
            self.members.fill(Member::default());
            self.stamp = 1;
        }
    }

    /// The velocity of a body in a cluster; of one that is in none, its own.
    pub fn velocity(&self, i: usize, own: f64) -> f64 {
        let member = &self.members[i];
        if member.stamp == self.stamp { self.roots[member.root as usize].velocity + member.offset } else { own }
    }

    /// Whether the body's velocity can no longer change.
    pub fn is_fixed(&self, i: usize) -> bool {
        let member = &self.members[i];
        member.stamp == self.stamp && self.roots[member.root as usize].fixed
    }

    pub fn is_joined(&self, i: usize) -> bool {
        self.members[i].stamp == self.stamp
    }

    /// What the whole cluster of a joined body brings.
    pub fn total(&self, i: usize) -> Node {
        self.roots[self.members[i].root as usize].node
    }

    /// Lets a body in: `fixed` with a velocity that nothing changes, or free with what it brings. Nothing if it is in already.
    pub fn join(&mut self, i: usize, fixed: Option<f64>, node: Node) {
        if self.is_joined(i) {
            return;
        }
        let velocity = fixed.unwrap_or_else(|| slide(node.momentum, node.mass, node.static_limit, node.kinetic_limit));
        self.members[i] = Member { stamp: self.stamp, root: i as u32, next: NONE, offset: 0.0 };
        self.roots[i] = Root { node, velocity, fixed: fixed.is_some(), size: 1, last: i as u32 };
        self.joined.push(i as u32);
    }

    /// Makes the velocities of two joined bodies differ by `difference` (first minus second) from now on. Returns whether that
    /// was possible: not within one cluster, nor between two fixed ones.
    pub fn merge(&mut self, first: usize, second: usize, difference: f64) -> bool {
        let (a, b) = (self.members[first], self.members[second]);
        let (ra, rb) = (self.roots[a.root as usize], self.roots[b.root as usize]);
        if a.root == b.root || (ra.fixed && rb.fixed) {
            return false;
        }
        // The frame of the larger one stays.
        let (keep, gone, kept, lost, shift) = if ra.size >= rb.size {
            (a.root, b.root, ra, rb, b.offset + difference - a.offset)
        } else {
            (b.root, a.root, rb, ra, a.offset - difference - b.offset)
        };
        // Kept velocity = lost velocity + shift.
        let node = Node {
            momentum: kept.node.momentum + lost.node.momentum + lost.node.mass * shift,
            mass: kept.node.mass + lost.node.mass,
            static_limit: kept.node.static_limit + lost.node.static_limit,
            kinetic_limit: kept.node.kinetic_limit + lost.node.kinetic_limit,
        };
        let velocity = if kept.fixed {
            kept.velocity
        } else if lost.fixed {
            lost.velocity + shift
        } else {
            slide(node.momentum, node.mass, node.static_limit, node.kinetic_limit)
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
        self.roots[keep as usize] = Root { node, velocity, fixed, size: kept.size + lost.size, last: lost.last };
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn free(mass: f64, velocity: f64) -> Node {
        Node { momentum: mass * velocity, mass, ..Node::default() }
    }

    #[test]
    fn a_row_takes_the_common_velocity_and_keeps_its_momentum() {
        let mut clusters = Clusters::new(3);
        clusters.clear();
        for (i, velocity) in [6.0, 0.0, 0.0].into_iter().enumerate() {
            clusters.join(i, None, free(1.0, velocity));
        }
        assert!(clusters.merge(0, 1, 0.0) && clusters.merge(1, 2, 0.5) && !clusters.merge(0, 2, 0.0));
        let v: Vec<f64> = (0..3).map(|i| clusters.velocity(i, 0.0)).collect();
        assert!((v.iter().sum::<f64>() - 6.0).abs() < 1e-14);
        assert!((v[0] - v[1]).abs() < 1e-14 && (v[1] - v[2] - 0.5).abs() < 1e-14);
    }

    #[test]
    fn a_wall_stops_all() {
        let mut clusters = Clusters::new(3);
        clusters.clear();
        clusters.join(0, None, free(5.0, 2.0));
        clusters.join(1, None, free(1.0, 1.0));
        clusters.join(2, Some(0.0), Node::default());
        assert!(clusters.merge(0, 1, 0.0) && clusters.merge(1, 2, 0.0));
        assert_eq!((clusters.velocity(0, 9.0), clusters.velocity(1, 9.0)), (0.0, 0.0));
    }

    #[test]
    fn static_friction_of_the_whole_row_holds_it() {
        let mut clusters = Clusters::new(2);
        clusters.clear();
        let ground = |momentum| Node { momentum, mass: 1.0, static_limit: 1.0, kinetic_limit: 0.5 };
        clusters.join(0, None, ground(1.9));
        clusters.join(1, None, ground(0.0));
        assert!(clusters.velocity(0, 0.0) > 0.0);
        clusters.merge(0, 1, 0.0);
        assert_eq!(clusters.velocity(0, 9.0), 0.0);
    }
}
