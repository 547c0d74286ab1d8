//! Islands: groups of bodies that could meet within this step, each solved by itself.
//!
//! Bodies whose swept boxes overlap are joined (union–find); surfaces join nothing. What an island's solution depends on is found here
//! in an order that only its own bodies decide: bodies bottom-up, equal heights by their numbers outside, and each body's pairs by the
//! order of the other. So nothing that is added elsewhere changes one bit of it.

use super::bodies::Bodies;
use super::neighbours::Neighbours;
use std::cmp::Ordering;

/// After so many moves a body, insertion gives up and all is sorted anew. Either way the order is the same.
const MOST_MOVES: usize = 8;

/// No island yet.
const NONE: u32 = u32::MAX;

/// One island, as the solver takes it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Island<'a> {
    /// Slots of its bodies, bottom-up.
    pub members: &'a [u32],
    /// What the k-th member may touch, each a member before it or a surface: `others[start[k]..start[k + 1]]`.
    pub start: &'a [u32],
    pub others: &'a [u32],
}

/// The islands of one step.
#[derive(Clone, Debug, Default)]
pub(super) struct Islands {
    /// All slots, bottom-up.
    order: Vec<u32>,
    parent: Vec<u32>,
    /// Slots island by island, and the place of each slot among them.
    members: Vec<u32>,
    place: Vec<u32>,
    /// Where each island begins among the members, and one more.
    begins: Vec<u32>,
    island_of_root: Vec<u32>,
    found: Vec<(u32, u32)>,
    start: Vec<u32>,
    others: Vec<u32>,
}

impl Islands {
    /// Room for `count` bodies.
    pub fn new(count: usize) -> Self {
        Self {
            order: (0..count as u32).collect(),
            parent: vec![0; count],
            members: vec![0; count],
            place: vec![0; count],
            begins: Vec::with_capacity(count + 1),
            island_of_root: vec![NONE; count],
            found: Vec::with_capacity(4 * count),
            start: Vec::with_capacity(count + 2),
            others: Vec::with_capacity(4 * count),
        }
    }

    /// Bodies were renumbered: begins with their new order.
    pub fn renumbered(&mut self) {
        self.order.iter_mut().enumerate().for_each(|(i, slot)| *slot = i as u32);
    }

    /// The number of islands.
    pub fn len(&self) -> usize {
        self.begins.len().saturating_sub(1)
    }

    /// An island by its number.
    pub fn get(&self, island: usize) -> Island<'_> {
        let (from, to) = (self.begins[island] as usize, self.begins[island + 1] as usize);
        Island { members: &self.members[from..to], start: &self.start[from..=to], others: &self.others }
    }

    /// The first body of the island that a body is in: the same for all of it.
    pub fn root(&self, slot: usize) -> usize {
        self.members[self.begins[self.island_of_root[self.parent[slot] as usize] as usize] as usize] as usize
    }

    /// Finds the islands of all bodies, from the boxes that they sweep.
    pub fn find(&mut self, bodies: &Bodies, neighbours: &Neighbours) {
        self.sort(bodies);
        self.join(bodies, neighbours);
        self.gather();
        self.list_pairs(bodies);
    }

    /// Bottom-up, equal heights by the numbers outside.
    fn sort(&mut self, bodies: &Bodies) {
        let (y, id, order) = (&bodies.y, &bodies.id, &mut self.order);
        let below = |a: u32, b: u32| {
            let (a, b) = (a as usize, b as usize);
            y[a] > y[b] || (y[a] == y[b] && id[a] < id[b])
        };
        let most = MOST_MOVES * order.len();
        let mut moves = 0;
        for i in 1..order.len() {
            let moved = order[i];
            let mut at = i;
            while at > 0 && below(moved, order[at - 1]) {
                order[at] = order[at - 1];
                at -= 1;
            }
            order[at] = moved;
            moves += i - at;
            if moves > most {
                order.sort_unstable_by(|&a, &b| {
                    let (a, b) = (a as usize, b as usize);
                    y[b].partial_cmp(&y[a]).unwrap_or(Ordering::Equal).then(id[a].cmp(&id[b]))
                });
                return;
            }
        }
    }

    /// Joins what may meet.
    fn join(&mut self, bodies: &Bodies, neighbours: &Neighbours) {
        let Self { parent, found, .. } = self;
        let n = bodies.len();
        parent.iter_mut().enumerate().for_each(|(i, parent)| *parent = i as u32);
        found.clear();
        for i in 0..n {
            let mine = bodies.swept[i];
            for j in neighbours.of(i) {
                if apart(&mine, &bodies.swept[j]) {
                    continue;
                }
                found.push((i as u32, j as u32));
                if j < n {
                    let (a, b) = (first(parent, i), first(parent, j));
                    parent[a.max(b)] = a.min(b) as u32;
                }
            }
        }
        // Parents have lower numbers: one pass makes every parent a root.
        for i in 0..n {
            parent[i] = parent[parent[i] as usize];
        }
    }

    /// Lists the members island by island, in their order.
    fn gather(&mut self) {
        let Self { order, parent, members, place, begins, island_of_root, .. } = self;
        begins.clear();
        begins.push(0);
        island_of_root.fill(NONE);
        for &i in &*order {
            let root = parent[i as usize] as usize;
            if island_of_root[root] == NONE {
                island_of_root[root] = begins.len() as u32 - 1;
                begins.push(0);
            }
            begins[island_of_root[root] as usize + 1] += 1;
        }
        for k in 1..begins.len() {
            begins[k] += begins[k - 1];
        }
        // While they are filled, the place after the last member of an island is kept in its own beginning.
        for &i in &*order {
            let at = &mut begins[island_of_root[parent[i as usize] as usize] as usize];
            members[*at as usize] = i;
            place[i as usize] = *at;
            *at += 1;
        }
        for k in (1..begins.len()).rev() {
            begins[k] = begins[k - 1];
        }
        begins[0] = 0;
    }

    /// Lists each member's pairs, by a counting sort and a short insertion.
    fn list_pairs(&mut self, bodies: &Bodies) {
        let Self { place, found, start, others, members, .. } = self;
        let n = bodies.len();
        let key = |other: u32| if (other as usize) < n { place[other as usize] } else { other };
        let upper = |&(i, j): &(u32, u32)| {
            let (a, b) = (i as usize, j as usize);
            if b < n && place[b] > place[a] { (place[b] as usize, i) } else { (place[a] as usize, j) }
        };
        start.clear();
        start.resize(members.len() + 1, 0);
        for pair in &*found {
            start[upper(pair).0] += 1;
        }
        for k in 1..start.len() {
            start[k] += start[k - 1];
        }
        others.clear();
        others.resize(found.len(), 0);
        for pair in found.iter().rev() {
            let (k, other) = upper(pair);
            start[k] -= 1;
            others[start[k] as usize] = other;
        }
        for k in 0..members.len() {
            let list = &mut others[start[k] as usize..start[k + 1] as usize];
            for i in 1..list.len() {
                let (moved, mut at) = (list[i], i);
                while at > 0 && key(list[at - 1]) > key(moved) {
                    list[at] = list[at - 1];
                    at -= 1;
                }
                list[at] = moved;
            }
        }
    }
}

fn first(parent: &mut [u32], mut i: usize) -> usize {
    while parent[i] as usize != i {
        parent[i] = parent[parent[i] as usize];
        i = parent[i] as usize;
    }
    i
}

/// Whether two boxes do not touch.
pub(super) fn apart(a: &[f64; 4], b: &[f64; 4]) -> bool {
    (a[0] > b[1]) | (b[0] > a[1]) | (a[2] > b[3]) | (b[2] > a[3])
}
