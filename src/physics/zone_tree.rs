//! Which zones a box touches: a tree of boxes around boxes, built once, for zones that never move.
//!
//! Zones are parted at the median of their centres along the longer side of what they fill, again and again; nodes lie in the order of a
//! descent, each with the place of the one that follows where its box is missed, so that a search is one loop without a stack. It takes
//! time with the logarithm of the number of zones, and with the number found.

use super::Aabb;
use glam::DVec2;

/// Zones of a list that are named each; where there are more, those between are looked at as well.
const FEW: usize = 32;
/// The node is no leaf.
const INNER: u32 = u32::MAX;

/// Some of a world's zones, by their indices in ascending order.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ZoneList {
    /// Short, for every law of a body has such a list, wet or not.
    few: [u16; FEW],
    count: u32,
    /// Where they are more: from the first of them to the last, those between included.
    range: (u32, u32),
}

impl ZoneList {
    /// Of indices in any order.
    pub fn of(indices: impl Iterator<Item = u32>) -> Self {
        let mut list = Self::default();
        indices.for_each(|index| list.add(index));
        list
    }

    /// Of one.
    pub fn only(index: u32) -> Self {
        let mut list = Self::default();
        list.add(index);
        list
    }

    fn add(&mut self, index: u32) {
        let count = self.count as usize;
        match u16::try_from(index) {
            Ok(index) if count < FEW => {
                let at = self.few[..count].partition_point(|known| *known < index);
                self.few.copy_within(at..count, at + 1);
                self.few[at] = index;
            }
            // Of so high a number, or of so many, none is named.
            _ => self.count = self.count.max(FEW as u32),
        }
        self.range = if count == 0 { (index, index + 1) } else { (self.range.0.min(index), self.range.1.max(index + 1)) };
        self.count += 1;
    }

    /// Whether it yields those alone of which it was made.
    pub fn names_each(&self) -> bool {
        self.count as usize <= FEW
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// How many [`Self::iter`] yields.
    pub fn len(&self) -> u32 {
        if self.names_each() { self.count } else { self.range.1 - self.range.0 }
    }

    pub fn iter(&self) -> impl Iterator<Item = u32> {
        let (few, range) =
            if self.names_each() { (&self.few[..self.count as usize], 0..0) } else { (&self.few[..0], self.range.0..self.range.1) };
        few.iter().map(|index| u32::from(*index)).chain(range)
    }
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Aabb,
    /// The zone of a leaf.
    zone: u32,
    /// The node that follows where the box is missed.
    skip: u32,
}

/// The tree.
#[derive(Clone, Debug, Default)]
pub(crate) struct ZoneTree {
    nodes: Vec<Node>,
}

impl ZoneTree {
    /// Of zones by their indices.
    pub fn of(zones: impl Iterator<Item = Aabb>) -> Self {
        let mut zones: Vec<(u32, Aabb)> = (0..).zip(zones).collect();
        let mut tree = Self::default();
        if !zones.is_empty() {
            tree.grow(&mut zones);
        }
        tree
    }

    fn grow(&mut self, zones: &mut [(u32, Aabb)]) {
        let bounds = zones.iter().skip(1).fold(zones[0].1, |all, (_, zone)| all.union(zone));
        let at = self.nodes.len();
        let zone = if zones.len() == 1 { zones[0].0 } else { INNER };
        self.nodes.push(Node { bounds, zone, skip: 0 });
        if zones.len() > 1 {
            let DVec2 { x, y } = bounds.size();
            let axis = usize::from(y > x);
            let middle = zones.len() / 2;
            zones.select_nth_unstable_by(middle, |a, b| a.1.centre()[axis].total_cmp(&b.1.centre()[axis]).then(a.0.cmp(&b.0)));
            let (first, second) = zones.split_at_mut(middle);
            self.grow(first);
            self.grow(second);
        }
        self.nodes[at].skip = self.nodes.len() as u32;
    }

    /// Hands every zone that a box touches within `slop` metres to `goes_on`, in no order that means anything, until that says no. Returns
    /// whether it never did.
    pub fn search(&self, near: &Aabb, slop: f64, mut goes_on: impl FnMut(u32) -> bool) -> bool {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            if !near.touches(&node.bounds, slop) {
                at = node.skip as usize;
                continue;
            }
            if node.zone != INNER && !goes_on(node.zone) {
                return false;
            }
            at += 1;
        }
        true
    }

    /// Whether a box touches a zone.
    pub fn any(&self, near: &Aabb) -> bool {
        !self.search(near, 0.0, |_| false)
    }

    /// Hands every zone that a box touches within `slop` metres to `found`, in no order that means anything.
    pub fn touching(&self, near: &Aabb, slop: f64, mut found: impl FnMut(u32)) {
        self.search(near, slop, |zone| {
            found(zone);
            true
        });
    }

    /// The zones that a box touches, if they are no more than `most`.
    pub fn few_near(&self, near: &Aabb, most: u32) -> Option<ZoneList> {
        let mut list = ZoneList::default();
        let all = self.search(near, 0.0, |zone| {
            let room = list.count < most;
            if room {
                list.add(zone);
            }
            room
        });
        all.then_some(list)
    }

    /// The zones that a box touches.
    pub fn near(&self, near: &Aabb, slop: f64) -> ZoneList {
        let mut list = ZoneList::default();
        self.touching(near, slop, |zone| list.add(zone));
        list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tree_finds_what_a_look_at_each_finds() {
        let mut seed = 1u64;
        let mut random = |most: f64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 * most
        };
        for count in [0, 1, 2, 3, 17, 200] {
            let mut area = |size: f64| {
                let min = DVec2::new(random(20.0), random(20.0));
                Aabb::new(min, min + DVec2::new(random(size), random(size)))
            };
            let zones: Vec<Aabb> = (0..count).map(|_| area(5.0)).collect();
            let tree = ZoneTree::of(zones.iter().copied());
            for _ in 0..200 {
                let near = area(3.0);
                let all: Vec<u32> = (0..).zip(&zones).filter(|(_, zone)| near.touches(zone, 0.0)).map(|(index, _)| index).collect();
                let mut found = Vec::new();
                tree.touching(&near, 0.0, |zone| found.push(zone));
                found.sort_unstable();
                assert_eq!(found, all);
                let list = tree.near(&near, 0.0);
                let listed: Vec<u32> = list.iter().collect();
                assert!(all.iter().all(|zone| listed.contains(zone)) && listed.is_sorted(), "{listed:?}, not {all:?}");
                assert!(all.len() > FEW || listed == all);
                let few = tree.few_near(&near, 3).map(|list| list.iter().collect::<Vec<u32>>());
                assert_eq!(few, (all.len() <= 3).then_some(all.clone()));
                assert_eq!((list.is_empty(), tree.any(&near)), (all.is_empty(), !all.is_empty()));
            }
        }
    }
}
