//! Islands: groups of bodies that could meet within this step.
//!
//! Union–find joins bodies whose swept boxes overlap; surfaces that stand join nothing. Bodies stand bottom-up, equal heights by their numbers,
//! each body's pairs by the order of the other: no other island changes a bit.

use crate::physics::data::{Aabb, Body, NONE, first, refill};
use crate::physics::store::{broad_phase::BroadPhase, columns::Columns, motions::Motions};

/// After more moves a body, insertion gives up and all is sorted: the same order.
const MOST_MOVES: usize = 8;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Island<'a> {
    pub members: &'a [u32],
    /// The items that each body may touch, a member before it or a surface: `others[from..to]`.
    pub ranges: &'a [(u32, u32)],
    pub others: &'a [u32],
}

impl<'a> Island<'a> {
    pub fn is_alone(&self) -> bool {
        self.members.len() == 1 && self.near(self.members[0]).is_empty()
    }

    #[inline(always)]
    pub fn near(&self, member: u32) -> &'a [u32] {
        let (from, to) = self.ranges[member as usize];
        &self.others[from as usize..to as usize]
    }

    /// The surfaces that its members may touch, some maybe twice.
    pub fn surfaces(&self, bodies: usize) -> impl Iterator<Item = u32> + use<'a> {
        let island = *self;
        island.members.iter().flat_map(move |i| island.near(*i)).filter_map(move |j| j.checked_sub(bodies as u32))
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Islands {
    /// The bodies that a step looks at, bottom-up, and their heights. They and surfaces that stand are listed, all others not.
    order: Vec<u32>,
    heights: Vec<(f64, u32)>,
    is_listed: Vec<bool>,
    parent: Vec<u32>,
    /// Bodies island by island, and where each island begins, and one more.
    members: Vec<u32>,
    begins: Vec<u32>,
    island_of_root: Vec<u32>,
    ranges: Vec<(u32, u32)>,
    others: Vec<u32>,
    columns: Columns,
    /// The boxes from which the islands were found last: while these stay, so do they.
    swept: Vec<Aabb>,
    is_known: bool,
    same_order: bool,
    /// Bodies that share an island wherever they are.
    links: Vec<(u32, u32)>,
    /// By surface that moves: a body that it may touch.
    carried: Vec<u32>,
    turned: Turned,
}

/// An island in the order of other heights.
#[derive(Clone, Debug, Default)]
struct Turned {
    members: Vec<u32>,
    /// Of each body: its place among the members.
    place: Vec<u32>,
    ranges: Vec<(u32, u32)>,
    others: Vec<u32>,
    /// Each pair that may touch, the upper one first.
    pairs: Vec<(u32, u32)>,
}

impl Turned {
    fn set(&mut self, of: Island<'_>, height: impl Fn(u32) -> f64) {
        let Self { members, place, ranges, others, pairs } = self;
        let n = of.ranges.len() as u32;
        members.clear();
        members.extend_from_slice(of.members);
        members.sort_unstable_by(|a, b| height(*b).total_cmp(&height(*a)).then(a.cmp(b)));
        place.resize(of.ranges.len(), 0);
        (0..).zip(&*members).for_each(|(k, i)| place[*i as usize] = k);
        let order = |j: u32| if j < n { place[j as usize] } else { j };
        pairs.clear();
        for &i in of.members {
            let lower_last = |j: &u32| if *j < n && order(*j) > order(i) { (*j, i) } else { (i, *j) };
            pairs.extend(of.near(i).iter().map(lower_last));
        }
        pairs.sort_unstable_by_key(|(i, j)| (order(*i), order(*j)));
        refill(ranges, of.ranges.len(), (0, 0));
        others.clear();
        for group in pairs.chunk_by(|a, b| a.0 == b.0) {
            let from = others.len() as u32;
            others.extend(group.iter().map(|(_, j)| *j));
            ranges[group[0].0 as usize] = (from, others.len() as u32);
        }
    }
}

impl Islands {
    pub fn new(count: usize, surfaces: usize, cells_per_metre: f64) -> Self {
        Self {
            is_listed: vec![true; count + surfaces],
            parent: (0..count as u32).collect(),
            island_of_root: vec![NONE; count],
            ranges: vec![(0, 0); count],
            others: Vec::with_capacity(4 * count),
            columns: Columns::new(count, cells_per_metre),
            ..Self::default()
        }
    }

    pub fn set_moving(&mut self, j: usize) {
        self.is_listed[j] = false;
        self.forget();
    }

    pub fn link(&mut self, pairs: &[(u32, u32)]) {
        if self.links != pairs {
            self.links.clear();
            self.links.extend_from_slice(pairs);
            self.forget();
        }
    }

    pub fn forget(&mut self) {
        self.is_known = false;
    }

    pub fn are_alone(&self) -> bool {
        self.others.is_empty() && self.links.is_empty()
    }

    pub fn look_at(&mut self, bodies: &[u32]) {
        if self.order.len() == bodies.len() && bodies.iter().all(|i| self.is_listed[*i as usize]) {
            return;
        }
        self.order.iter().for_each(|i| self.is_listed[*i as usize] = false);
        self.order.clear();
        self.order.extend_from_slice(bodies);
        self.order.iter().for_each(|i| self.is_listed[*i as usize] = true);
        self.forget();
    }

    pub fn len(&self) -> usize {
        self.begins.len().saturating_sub(1)
    }

    pub fn get(&self, island: usize) -> Island<'_> {
        let (from, to) = (self.begins[island] as usize, self.begins[island + 1] as usize);
        Island { members: &self.members[from..to], ..self.whole() }
    }

    fn whole(&self) -> Island<'_> {
        Island { members: &self.members, ranges: &self.ranges, others: &self.others }
    }

    /// The island in the order of these heights, the largest first.
    pub fn turn(&mut self, island: usize, height: impl Fn(u32) -> f64) {
        let mut turned = std::mem::take(&mut self.turned);
        turned.set(self.get(island), height);
        self.turned = turned;
    }

    pub fn turned(&self) -> Island<'_> {
        let Turned { members, ranges, others, .. } = &self.turned;
        Island { members, ranges, others }
    }

    /// Puts the bodies in order, bottom-up; `down` is −1 if gravity points to smaller y, else 1.
    pub fn sort(&mut self, bodies: &[Body], down: f64) {
        self.columns.down = down;
        self.same_order = self.put_in_order(bodies, down) == 0 && self.is_known;
    }

    pub fn find(&mut self, motions: &Motions, broad_phase: &BroadPhase, moving: &[u32]) {
        if self.same_order && moving.is_empty() && self.swept.len() == self.order.len() && self.finds_the_same(motions, broad_phase)
        {
            return;
        }
        self.is_known = true;
        self.swept.clear();
        self.swept.extend(self.order.iter().map(|i| motions.swept[*i as usize]));
        self.columns.begin(&self.heights, &self.swept);
        self.join(motions, broad_phase, moving);
        if self.are_alone() {
            self.members.clone_from(&self.order);
            self.begins.clear();
            self.begins.extend(0..=self.order.len() as u32);
        } else {
            self.gather();
        }
    }

    /// Whether a body that sweeps `mine` may meet what is not listed with it, where `widened` bodies sweep more than before, moving surfaces aside.
    pub fn meets_more(&self, (i, mine): (u32, &Aabb), widened: &[(u32, Aabb)], motions: &Motions, surfaces: &BroadPhase) -> bool {
        let (n, all) = (motions.len() as u32, self.whole());
        let unlisted = |j: u32| j != i && !all.near(i).contains(&j) && (j >= n || !all.near(j).contains(&i));
        let surface = |s: &u32| {
            let j = n + *s;
            self.is_listed[j as usize] && mine.meets(&motions.swept[j as usize]) && unlisted(j)
        };
        let mut meets = !surfaces.covers(i as usize, mine) || surfaces.near(i as usize).iter().any(surface);
        meets |= widened.iter().any(|(j, of)| mine.meets(of) && unlisted(*j));
        self.columns.visit(mine, &self.swept, |place| meets |= unlisted(self.order[place as usize]));
        meets
    }

    /// Whether no box has changed since islands were found, or one that meets the same all the same.
    fn finds_the_same(&mut self, motions: &Motions, broad_phase: &BroadPhase) -> bool {
        let Self { order, swept, is_listed, .. } = &*self;
        let (n, of) = (motions.len() as u32, |k: usize| motions.swept[order[k] as usize]);
        let mut changed = (0..order.len()).filter(|k| swept[*k] != of(*k));
        let Some(k) = changed.next() else { return true };
        let (i, before, now) = (order[k], swept[k], of(k));
        let near = broad_phase.near(i as usize).iter().map(|surface| n + surface);
        let near = near.filter(|j| is_listed[*j as usize] && now.meets(&motions.swept[*j as usize]));
        let same = changed.next().is_none()
            && self.columns.serve((k, self.heights[k].0), &before, &now)
            && swept.iter().all(|of| before.meets(of) == now.meets(of))
            && near.eq(self.whole().near(i).iter().copied().filter(|j| *j >= n));
        self.swept[k] = if same { now } else { before };
        same
    }

    fn put_in_order(&mut self, bodies: &[Body], down: f64) -> usize {
        let Self { order, heights, .. } = self;
        heights.clear();
        heights.extend(order.iter().map(|i| (bodies[*i as usize].position.y * down + 0.0, *i)));
        let above = |a: &(f64, u32), b: &(f64, u32)| a.0 > b.0 || (a.0 == b.0 && a.1 < b.1);
        if heights.is_sorted_by(|a, b| !above(b, a)) {
            return 0;
        }
        let most = MOST_MOVES * order.len();
        let mut moves = 0;
        for i in 1..heights.len() {
            let moved = heights[i];
            let mut at = i;
            while at > 0 && above(&moved, &heights[at - 1]) {
                heights[at] = heights[at - 1];
                at -= 1;
            }
            if at < i {
                heights[at] = moved;
                moves += i - at;
            }
            if moves > most {
                heights.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
                break;
            }
        }
        order.iter_mut().zip(heights).for_each(|(i, (_, sorted))| *i = *sorted);
        moves
    }

    fn join(&mut self, motions: &Motions, broad_phase: &BroadPhase, moving: &[u32]) {
        let Self { order, is_listed, parent, ranges, others, carried, columns, swept, .. } = self;
        let n = motions.len();
        others.clear();
        refill(carried, moving.len(), NONE);
        order.iter().for_each(|i| parent[*i as usize] = *i);
        for (k, &i) in order.iter().enumerate() {
            let (from, mine) = (others.len(), swept[k]);
            let mut root = i as usize;
            // The lower one of a pair is listed under the upper one.
            columns.pass(k, swept, others);
            others[from..].sort_unstable();
            for other in &mut others[from..] {
                *other = order[*other as usize];
                join_with(parent, &mut root, *other as usize);
            }
            let bodies = others.len();
            for j in broad_phase.near(i as usize).iter().map(|surface| n + *surface as usize) {
                if is_listed[j] && mine.meets(&motions.swept[j]) {
                    others.push(j as u32);
                }
            }
            if !moving.is_empty() {
                for (k, &surface) in moving.iter().enumerate() {
                    let (first, j) = (&mut carried[k], n + surface as usize);
                    if !mine.meets(&motions.swept[j]) {
                        continue;
                    }
                    others.push(j as u32);
                    // What one moving surface may carry is one island: all of it decides whether the surface stops.
                    if *first == NONE {
                        *first = i;
                    } else if motions.surfaces[surface as usize].moves() {
                        join_with(parent, &mut root, *first as usize);
                    }
                }
                others[bodies..].sort_unstable();
            }
            parent[i as usize] = root as u32;
            ranges[i as usize] = (from as u32, others.len() as u32);
        }
    }

    fn gather(&mut self) {
        let Self { order, parent, links, members, begins, island_of_root, .. } = self;
        for (a, b) in links.iter() {
            let (a, b) = (first(parent, *a as usize), first(parent, *b as usize));
            parent[a.max(b)] = a.min(b) as u32;
        }
        order.iter().for_each(|i| parent[*i as usize] = first(parent, *i as usize) as u32);
        begins.clear();
        order.iter().for_each(|i| island_of_root[parent[*i as usize] as usize] = NONE);
        // Counts the members of each island, sums up, and fills from the last to the first.
        for i in &*order {
            let island = &mut island_of_root[parent[*i as usize] as usize];
            if *island == NONE {
                *island = begins.len() as u32;
                begins.push(0);
            }
            begins[*island as usize] += 1;
        }
        for k in 1..begins.len() {
            begins[k] += begins[k - 1];
        }
        begins.push(order.len() as u32);
        members.resize(order.len(), 0);
        for i in order.iter().rev() {
            let begin = &mut begins[island_of_root[parent[*i as usize] as usize] as usize];
            *begin -= 1;
            members[*begin as usize] = *i;
        }
    }
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
