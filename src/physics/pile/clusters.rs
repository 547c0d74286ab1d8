//! Perfectly plastic merging along one axis, for whatever is not carried by the ground.
//!
//! Two bodies that close faster than their gap allows become a cluster that moves as one: momentum is exactly conserved, energy
//! never grows, and after at most n − 1 merges nothing is violated. On a row or a column this is isotonic regression by pooling
//! adjacent violators (Ayer et al. 1955), the exact answer of the plastic impact; on branching groups a member may be carried
//! along for one step although it would have parted, since clusters never split; where that would create energy, the cluster is
//! calmed.
//!
//! A cluster may lie on immovable ground with friction: with momentum P, mass M and the ground's largest impulses S (static) and
//! K (kinetic), its velocity is 0 while |P| ≤ S, else (P ∓ K)/M. Pooling stays exact, as the terms K·|v| are convex. Where
//! members on the ground still close a gap, their velocities differ by it, and each is held or dragged by its own: then the
//! common velocity is where the momentum's balance, which rises with it, changes sign; found between the members' stops.

use super::gravity::slide;

/// What a body brings into its cluster.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Node {
    pub momentum: f64,
    pub mass: f64,
    pub static_limit: f64,
    pub kinetic_limit: f64,
}

impl Node {
    fn has_grip(&self) -> bool {
        self.static_limit > 0.0 || self.kinetic_limit > 0.0
    }
}

/// The ground under a cluster.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Ground {
    #[default]
    Smooth,
    /// All members that it holds or drags have this offset.
    Even(f64),
    /// Their offsets differ.
    Uneven,
}

#[derive(Clone, Copy, Debug, Default)]
struct Member {
    stamp: u32,
    root: u32,
    next: u32,
    /// Its velocity is the cluster's and this.
    offset: f64,
    /// Whether nothing changes its velocity.
    fixed: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Root {
    /// Of all members, the momentum less what their offsets make of it.
    node: Node,
    ground: Ground,
    velocity: f64,
    fixed: bool,
    size: u32,
    last: u32,
}

const NONE: u32 = u32::MAX;
/// Rounding of a cluster's energy, as a part of it.
const ROUNDING: f64 = 1e-12;

/// Groups of bodies that move as one along one axis. Only bodies that were merged are in one.
#[derive(Clone, Debug, Default)]
pub(super) struct Clusters {
    stamp: u32,
    members: Vec<Member>,
    /// What each member brought.
    brought: Vec<Node>,
    roots: Vec<Root>,
    /// All that are in a cluster, in the order of joining.
    pub joined: Vec<u32>,
}

impl Clusters {
    pub fn new(all: usize) -> Self {
        Self {
            stamp: 0,
            members: vec![Member::default(); all],
            brought: vec![Node::default(); all],
            roots: vec![Root::default(); all],
            joined: Vec::with_capacity(all),
        }
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

    /// The first body of a joined body's cluster.
    pub fn root(&self, i: usize) -> usize {
        self.members[i].root as usize
    }

    /// The roots of all clusters that are not fixed.
    pub fn free_roots(&self) -> impl Iterator<Item = usize> {
        self.joined.iter().map(|i| *i as usize).filter(|i| self.members[*i].root as usize == *i && !self.roots[*i].fixed)
    }

    /// All that are in the cluster of a root.
    pub fn of(&self, root: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(root), |i| Some(self.members[*i].next).filter(|next| *next != NONE).map(|next| next as usize))
    }

    /// The impulse that the ground takes up in all under those members of a joined body's cluster that stand, and their limits.
    pub fn held(&self, i: usize) -> (f64, f64) {
        let root = &self.roots[self.members[i].root as usize];
        let Node { momentum, mass, static_limit, .. } = root.node;
        match root.ground {
            Ground::Smooth => (0.0, 0.0),
            Ground::Even(offset) => (momentum + mass * offset, static_limit),
            Ground::Uneven => self.balance(self.members[i].root as usize, root.velocity),
        }
    }

    /// Slows clusters that have more kinetic energy than their members brought: those that close a gap drag along others that
    /// would have parted. Their motion against the centre of mass is made smaller, against what is fixed all motion; nothing
    /// within a cluster closes faster for that.
    pub fn calm(&mut self) {
        for k in 0..self.joined.len() {
            let root = self.joined[k] as usize;
            let Root { velocity, fixed, size, .. } = self.roots[root];
            if self.members[root].root as usize != root || size < 2 {
                continue;
            }
            let (mut mass, mut momentum, mut before, mut after) = (0.0, 0.0, 0.0, 0.0);
            for i in self.of(root).filter(|i| !self.members[*i].fixed) {
                let (node, own) = (&self.brought[i], velocity + self.members[i].offset);
                mass += node.mass;
                momentum += node.mass * own;
                before += node.momentum * node.momentum / node.mass;
                after += node.mass * own * own;
            }
            if after <= before * (1.0 + ROUNDING) {
                continue;
            }
            let common = if fixed { 0.0 } else { momentum / mass };
            let (of_all, within) = (momentum * common, after - momentum * common);
            let part = if within > 0.0 { ((before - of_all).max(0.0) / within).sqrt().min(1.0) } else { 0.0 };
            let new = if fixed { velocity } else { common + part * (velocity - common) };
            self.roots[root].velocity = new;
            let mut at = root as u32;
            while at != NONE {
                let member = &mut self.members[at as usize];
                if !member.fixed {
                    member.offset = common + part * (velocity + member.offset - common) - new;
                }
                at = member.next;
            }
            self.reframe(root);
        }
    }

    /// Restores what a root knows of its members after their offsets changed.
    fn reframe(&mut self, root: usize) {
        let shifted: f64 = self.of(root).map(|i| self.brought[i].momentum - self.brought[i].mass * self.members[i].offset).sum();
        self.roots[root].node.momentum = shifted;
        if self.roots[root].ground != Ground::Smooth {
            self.roots[root].ground = Ground::Uneven;
        }
    }

    /// The velocity of a root that nothing fixes.
    fn settle(&self, root: usize) -> f64 {
        let Root { node, ground, .. } = self.roots[root];
        match ground {
            Ground::Smooth => node.momentum / node.mass,
            Ground::Even(offset) => {
                slide(node.momentum + node.mass * offset, node.mass, node.static_limit, node.kinetic_limit) - offset
            }
            Ground::Uneven => {
                // The least and the greatest velocity that it may have, closing in on the answer stop by stop.
                let mut range = (f64::NEG_INFINITY, f64::INFINITY);
                for i in self.of(root) {
                    let stop = -self.members[i].offset;
                    if !self.brought[i].has_grip() || stop <= range.0 || stop >= range.1 {
                        continue;
                    }
                    let (lacks, held) = self.balance(root, stop);
                    if lacks > held {
                        range.0 = stop;
                    } else if lacks < -held {
                        range.1 = stop;
                    } else {
                        return stop;
                    }
                }
                // Between two stops nobody stands.
                let backward = |i: usize| -self.members[i].offset >= range.1;
                let drag = |i: usize| if backward(i) { -self.brought[i].kinetic_limit } else { self.brought[i].kinetic_limit };
                let dragged: f64 = self.of(root).map(drag).sum();
                ((node.momentum - dragged) / node.mass).clamp(range.0, range.1)
            }
        }
    }

    /// Of a root at the velocity `stop`, at which some of its members stand: the impulse that they would have to take up, and their
    /// limit.
    fn balance(&self, root: usize, stop: f64) -> (f64, f64) {
        let node = &self.roots[root].node;
        let mut balance = (node.momentum - node.mass * stop, 0.0);
        for i in self.of(root) {
            match stop + self.members[i].offset {
                0.0 => balance.1 += self.brought[i].static_limit,
                velocity => balance.0 -= self.brought[i].kinetic_limit.copysign(velocity),
            }
        }
        balance
    }

    /// Lets a body in: `fixed` with a velocity that nothing changes, or free with what it brings. Nothing if it is in already.
    pub fn join(&mut self, i: usize, fixed: Option<f64>, node: Node) {
        if self.is_joined(i) {
            return;
        }
        let velocity = fixed.unwrap_or_else(|| slide(node.momentum, node.mass, node.static_limit, node.kinetic_limit));
        let ground = if node.has_grip() { Ground::Even(0.0) } else { Ground::Smooth };
        self.members[i] = Member { stamp: self.stamp, root: i as u32, next: NONE, offset: 0.0, fixed: fixed.is_some() };
        self.brought[i] = node;
        self.roots[i] = Root { node, ground, velocity, fixed: fixed.is_some(), size: 1, last: i as u32 };
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
        let ground = match (kept.ground, lost.ground) {
            (Ground::Smooth, Ground::Even(offset)) => Ground::Even(offset - shift),
            (ground, Ground::Smooth) => ground,
            (Ground::Even(one), Ground::Even(other)) if one == other - shift => kept.ground,
            _ => Ground::Uneven,
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
        self.roots[keep as usize] = Root { node, ground, velocity: 0.0, fixed, size: kept.size + lost.size, last: lost.last };
        self.roots[keep as usize].velocity = if kept.fixed {
            kept.velocity
        } else if lost.fixed {
            lost.velocity + shift
        } else {
            self.settle(keep as usize)
        };
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
