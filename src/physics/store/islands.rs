//! Islands: groups of bodies that could meet within this step, each solved by itself.
//!
//! Bodies whose swept boxes overlap are joined (union–find); surfaces that stand join nothing. What an island's solution depends on is found here
//! in an order that only its own bodies decide: bodies bottom-up, equal heights by their numbers outside, and each body's pairs by the
//! order of the other. So nothing that is added elsewhere changes one bit of it.

use crate::physics::store::bodies::Bodies;
use crate::physics::store::neighbours::Neighbours;
use std::cmp::Ordering;

/// After so many moves a body, insertion gives up and all is sorted anew. Either way the order is the same.
const MOST_MOVES: usize = 8;

/// While no more than this part of the bodies sweep something else than in the step before, the lists of the others are kept.
const MOST_CHANGED: f64 = 0.6;

/// Boxes that are compared at once.
const BLOCK: usize = 32;

/// No island yet.
const NONE: u32 = u32::MAX;

/// One island, as the solver takes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Island<'a> {
    /// Slots of its bodies, bottom-up.
    pub members: &'a [u32],
    /// What a member may touch, each a member before it or a surface: `others[from..to]`, by slot.
    ranges: &'a [(u32, u32)],
    others: &'a [u32],
}

impl<'a> Island<'a> {
    /// Whether it is one body, near nothing.
    pub fn is_alone(&self) -> bool {
        self.members.len() == 1 && self.near(self.members[0]).is_empty()
    }

    /// What a member may touch, each a member before it or a surface.
    #[inline(always)]
    pub fn near(&self, member: u32) -> &'a [u32] {
        let (from, to) = self.ranges[member as usize];
        &self.others[from as usize..to as usize]
    }
}

/// The islands of one step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Islands {
    /// All slots, bottom-up, and the place of each among them.
    order: Vec<u32>,
    place: Vec<u32>,
    parent: Vec<u32>,
    /// Slots island by island, and where each island begins, and one more.
    members: Vec<u32>,
    begins: Vec<u32>,
    island_of_root: Vec<u32>,
    ranges: Vec<(u32, u32)>,
    others: Vec<u32>,
    /// Pairs whose order has changed since bodies were numbered: place and slot of the upper one, the lower one.
    turned: Vec<(u32, u32, u32)>,
    spare: Vec<u32>,
    later: Vec<u32>,
    near: Vec<u32>,
    /// From what the islands were found last: while all of it stays, so do they. What has changed, by slot, and who is in a turned pair.
    swept: Vec<[f64; 4]>,
    heights: Vec<f64>,
    changed: Vec<bool>,
    is_turned: Vec<bool>,
    revision: u64,
    listings: u64,
    /// How long all lists were when they were made last.
    listed: usize,
    same_order: bool,
    /// Whether others are looked at than when they were brought into order.
    others_in_it: bool,
    /// Bodies, by their numbers outside, that share an island wherever they are.
    links: Vec<(u32, u32)>,
    /// By surface that moves: one whom it may touch.
    carried: Vec<u32>,
}

impl Islands {
    /// Room for `count` bodies.
    pub fn new(count: usize) -> Self {
        Self {
            order: (0..count as u32).collect(),
            place: vec![0; count],
            parent: vec![0; count],
            members: vec![0; count],
            begins: Vec::with_capacity(count + 1),
            island_of_root: vec![NONE; count],
            ranges: vec![(0, 0); count],
            others: Vec::with_capacity(4 * count),
            turned: Vec::with_capacity(count),
            spare: Vec::with_capacity(4 * count),
            later: Vec::with_capacity(64),
            near: vec![0; 64],
            swept: Vec::with_capacity(count),
            heights: vec![0.0; count],
            changed: vec![false; count],
            is_turned: vec![false; count],
            revision: 0,
            listings: 0,
            listed: 0,
            same_order: false,
            others_in_it: false,
            links: Vec::new(),
            carried: Vec::new(),
        }
    }

    /// Lets pairs of bodies, by their numbers outside, share an island wherever they are.
    pub fn link(&mut self, pairs: &[(u32, u32)]) {
        if self.links != pairs {
            self.links.clear();
            self.links.extend_from_slice(pairs);
            self.forget();
        }
    }

    /// Bodies were renumbered, and all are looked at: begins with their new order.
    pub fn renumbered(&mut self) {
        self.order.clear();
        self.order.extend(0..self.place.len() as u32);
        self.revision = 0;
        self.others_in_it = false;
    }

    /// Something else than the bodies has changed: the islands have to be found anew.
    pub fn forget(&mut self) {
        self.revision = 0;
    }

    /// Chooses whose islands are found: those of these slots, who meet nobody else.
    pub fn look_at(&mut self, slots: &[u32]) {
        if slots.len() == self.place.len() && self.order.len() == slots.len() {
            return;
        }
        self.spare.clear();
        self.spare.extend_from_slice(&self.order);
        self.spare.sort_unstable();
        if self.spare == slots {
            return;
        }
        self.others_in_it = true;
        // What is left out is of no island.
        self.order.iter().for_each(|i| self.parent[*i as usize] = *i);
        self.order.clear();
        self.order.extend_from_slice(slots);
    }

    /// Whether they have to be brought into order again, because others are looked at.
    pub fn are_others(&self) -> bool {
        self.others_in_it
    }

    /// The number of islands.
    pub fn len(&self) -> usize {
        self.begins.len().saturating_sub(1)
    }

    /// An island by its number.
    pub fn get(&self, island: usize) -> Island<'_> {
        let (from, to) = (self.begins[island] as usize, self.begins[island + 1] as usize);
        Island { members: &self.members[from..to], ranges: &self.ranges, others: &self.others }
    }

    /// Brings the bodies into their order, once a step.
    pub fn sort(&mut self, bodies: &Bodies) {
        self.same_order = self.put_in_order(bodies) == 0 && !self.others_in_it;
        if self.same_order && self.revision != 0 {
            return;
        }
        self.others_in_it = false;
        for (k, i) in self.order.iter().enumerate() {
            self.place[*i as usize] = k as u32;
        }
    }

    /// Finds the islands of all bodies, from the boxes that they sweep.
    pub fn find(&mut self, bodies: &Bodies, neighbours: &Neighbours) {
        if self.same_order && neighbours.is_as_in(self.revision) && self.sweep_the_same(bodies) {
            return;
        }
        let n = bodies.len();
        let all = self.order.len() == n;
        let known = all && self.swept.len() == n && self.revision != 0 && neighbours.are_listed_as_in(self.listings);
        (self.listings, self.revision) = (neighbours.listings, neighbours.revision);
        // Lists that hold no longer stay behind, up to as many as there are.
        let kept =
            known && self.find_changes(bodies) <= (MOST_CHANGED * n as f64) as usize && self.others.len() <= 2 * self.listed + n;
        if !kept {
            self.changed.fill(true);
            self.others.clear();
        }
        if !known {
            self.swept.clear();
            if all {
                self.swept.extend_from_slice(&bodies.swept[..n]);
                self.heights.copy_from_slice(&bodies.y[..n]);
            } else {
                self.swept.extend(self.order.iter().map(|i| bodies.swept[*i as usize]));
            }
        }
        self.join(bodies, neighbours);
        if !kept {
            self.listed = self.others.len();
        }
        self.turn();
        self.gather();
    }

    /// Tells who sweeps something else than when islands were found last, or is elsewhere in their order. What is in a turned pair counts to them.
    /// Returns how many they are.
    fn find_changes(&mut self, bodies: &Bodies) -> usize {
        let Self { swept, heights, changed, is_turned, .. } = self;
        let now = bodies.swept.iter().zip(&bodies.y).zip(&*is_turned);
        let mut count = 0;
        let then = swept.iter_mut().zip(heights).zip(changed);
        for (((swept, y), turned), ((known, height), changed)) in now.zip(then) {
            *changed = (differ(swept, known) | (y.to_bits() ^ height.to_bits()) != 0) | *turned;
            (*known, *height) = (*swept, *y);
            count += usize::from(*changed);
        }
        count
    }

    /// Whether all that are looked at sweep what they did when islands were found last.
    fn sweep_the_same(&self, bodies: &Bodies) -> bool {
        let Self { order, swept, .. } = self;
        // Block by block without a branch inside: vector code.
        let alike = |(a, b): (&[[f64; 4]], &[[f64; 4]])| a.iter().zip(b).fold(0, |bits, (a, b)| bits | differ(a, b)) == 0;
        if swept.len() != order.len() {
            return false;
        }
        if order.len() == bodies.len() {
            return bodies.swept[..order.len()].chunks(BLOCK).zip(swept.chunks(BLOCK)).all(alike);
        }
        order.iter().zip(swept).all(|(i, swept)| differ(&bodies.swept[*i as usize], swept) == 0)
    }

    /// Bottom-up, equal heights by the numbers outside. Returns how many moves it took.
    fn put_in_order(&mut self, bodies: &Bodies) -> usize {
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
                break;
            }
        }
        moves
    }

    /// Joins what may meet, and lists whom each body may meet: as it was listed last if neither has changed.
    fn join(&mut self, bodies: &Bodies, neighbours: &Neighbours) {
        let Self { order, place, parent, ranges, others, turned, later, near, changed, links, carried, .. } = self;
        let n = bodies.len();
        carried.clear();
        carried.resize(bodies.x.len() - n, NONE);
        order.iter().for_each(|i| parent[*i as usize] = *i);
        turned.clear();
        for (k, &i) in order.iter().enumerate() {
            let (from, mine) = (others.len(), bodies.swept[i as usize]);
            let (mut root, mut latest) = (first(parent, i as usize), 0);
            let known = neighbours.of(i as usize, later);
            let stays = |j: &u32| changed.get(*j as usize) != Some(&true);
            if later.is_empty() && stays(&i) && known.iter().all(stays) {
                let (begin, end) = ranges[i as usize];
                for j in others[begin as usize..end as usize].iter().map(|j| *j as usize).filter(|j| *j < n) {
                    join_with(parent, &mut root, j);
                }
                parent[i as usize] = root as u32;
                continue;
            }
            // Without a branch for each: most are apart, and which is not to be foreseen.
            let mut met = 0;
            near.resize(near.len().max(known.len() + later.len()), 0);
            for list in [known, &*later] {
                for &other in list {
                    near[met] = other;
                    met += usize::from(!apart(&mine, &bodies.swept[other as usize]));
                }
            }
            for &other in &near[..met] {
                let j = other as usize;
                let mut key = other;
                if j < n {
                    join_with(parent, &mut root, j);
                    key = place[j];
                    if key > k as u32 {
                        turned.push((key, other, i));
                        continue;
                    }
                } else if bodies.moves(j) {
                    // What one moving surface may carry is one island: all of it decides whether the surface stops.
                    match carried[j - n] {
                        NONE => carried[j - n] = i,
                        first => join_with(parent, &mut root, first as usize),
                    }
                }
                others.push(other);
                if key < latest {
                    put_last(others, from, key, place);
                }
                latest = latest.max(key);
            }
            parent[i as usize] = root as u32;
            ranges[i as usize] = (from as u32, others.len() as u32);
        }
        for (a, b) in links.iter().map(|(a, b)| (bodies.slot[*a as usize], bodies.slot[*b as usize])) {
            let (a, b) = (first(parent, a as usize), first(parent, b as usize));
            parent[a.max(b)] = a.min(b) as u32;
        }
        // The first of an island is its lowest slot: whoever stands for a body has been told already.
        if order.len() == n {
            (0..n).for_each(|i| parent[i] = parent[parent[i] as usize]);
            return;
        }
        for &i in &*order {
            parent[i as usize] = first(parent, i as usize) as u32;
        }
    }

    /// Lists pairs whose order has turned under the one that is above now.
    fn turn(&mut self) {
        let Self { place, ranges, others, turned, is_turned, .. } = self;
        is_turned.fill(false);
        turned.sort_unstable();
        for group in turned.chunk_by(|a, b| a.1 == b.1) {
            let upper = group[0].1 as usize;
            let (from, to) = ranges[upper];
            let begin = others.len();
            others.extend_from_within(from as usize..to as usize);
            is_turned[upper] = true;
            for &(_, _, lower) in group {
                is_turned[lower as usize] = true;
                others.push(lower);
                put_last(others, begin, place[lower as usize], place);
            }
            ranges[upper] = (begin as u32, others.len() as u32);
        }
    }

    /// Lists the members island by island, in their order.
    fn gather(&mut self) {
        let Self { order, parent, members, begins, island_of_root, .. } = self;
        begins.clear();
        begins.push(0);
        order.iter().for_each(|i| island_of_root[parent[*i as usize] as usize] = NONE);
        members.resize(order.len(), 0);
        // Neighbours in the order are mostly of one island: counted run by run.
        let (mut last, mut run) = (usize::MAX, 0);
        for &i in &*order {
            let root = parent[i as usize] as usize;
            if island_of_root[root] == NONE {
                island_of_root[root] = begins.len() as u32 - 1;
                begins.push(0);
            }
            if root != last {
                if last != usize::MAX {
                    begins[island_of_root[last] as usize + 1] += run;
                }
                (last, run) = (root, 0);
            }
            run += 1;
        }
        if last != usize::MAX {
            begins[island_of_root[last] as usize + 1] += run;
        }
        for k in 1..begins.len() {
            begins[k] += begins[k - 1];
        }
        if begins.len() == 2 {
            members.copy_from_slice(order);
            return;
        }
        // While they are filled, the place after the last member of an island is kept in its own beginning.
        let (mut last, mut at) = (u32::MAX, 0);
        for &i in &*order {
            let root = parent[i as usize];
            if root != last {
                if last != u32::MAX {
                    begins[island_of_root[last as usize] as usize] = at;
                }
                (last, at) = (root, begins[island_of_root[root as usize] as usize]);
            }
            members[at as usize] = i;
            at += 1;
        }
        if last != u32::MAX {
            begins[island_of_root[last as usize] as usize] = at;
        }
        for k in (1..begins.len()).rev() {
            begins[k] = begins[k - 1];
        }
        begins[0] = 0;
    }
}

/// Moves the last of a list, whose key is `key`, to its place among those that begin at `from`: bodies by their places, then surfaces.
#[inline(always)]
fn put_last(list: &mut [u32], from: usize, key: u32, place: &[u32]) {
    let mut at = list.len() - 1;
    let moved = list[at];
    while at > from && place.get(list[at - 1] as usize).copied().unwrap_or(list[at - 1]) > key {
        list[at] = list[at - 1];
        at -= 1;
    }
    list[at] = moved;
}

/// Joins body j to those of `root`, whose first is kept.
#[inline(always)]
fn join_with(parent: &mut [u32], root: &mut usize, j: usize) {
    if parent[j] as usize != *root {
        let other = first(parent, j);
        parent[j] = other as u32;
        if other != *root {
            (parent[other.max(*root)], *root) = (other.min(*root) as u32, other.min(*root));
        }
    }
}

#[inline(always)]
fn first(parent: &mut [u32], mut i: usize) -> usize {
    while parent[i] as usize != i {
        parent[i] = parent[parent[i] as usize];
        i = parent[i] as usize;
    }
    i
}

/// Zero if two boxes are the same to the bit.
fn differ(a: &[f64; 4], b: &[f64; 4]) -> u64 {
    (0..4).fold(0, |bits, k| bits | (a[k].to_bits() ^ b[k].to_bits()))
}

/// Whether two boxes do not touch.
pub(crate) fn apart(a: &[f64; 4], b: &[f64; 4]) -> bool {
    (a[0] > b[1]) | (b[0] > a[1]) | (a[2] > b[3]) | (b[2] > a[3])
}
