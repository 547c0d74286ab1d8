//! A static tree of boxes that finds the boxes that a box touches. A node parts its boxes at the median of their centres along its longer
//! side. Nodes lie in the order of a descent, each with the index of the node that follows a miss: a search is one loop without a stack.

use crate::physics::data::aabb::Aabb;
use glam::DVec2;

/// The node is no leaf.
const INNER: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct TreeNode {
    bounds: Aabb,
    /// The box of a leaf.
    leaf: u32,
    /// The node that follows where the box is missed.
    skip: u32,
}

#[derive(Clone, Debug, Default)]
pub(super) struct BoxTree {
    nodes: Vec<TreeNode>,
}

impl BoxTree {
    pub fn of(boxes: impl Iterator<Item = Aabb>) -> Self {
        let mut boxes: Vec<(u32, Aabb)> = (0..).zip(boxes).collect();
        let mut tree = Self::default();
        if !boxes.is_empty() {
            tree.grow(&mut boxes);
        }
        tree
    }

    fn grow(&mut self, boxes: &mut [(u32, Aabb)]) {
        let bounds = boxes.iter().skip(1).fold(boxes[0].1, |all, (_, leaf)| all.union(leaf));
        let at = self.nodes.len();
        let leaf = if boxes.len() == 1 { boxes[0].0 } else { INNER };
        self.nodes.push(TreeNode { bounds, leaf, skip: 0 });
        if boxes.len() > 1 {
            let DVec2 { x, y } = bounds.size();
            let axis = usize::from(y > x);
            let middle = boxes.len() / 2;
            boxes.select_nth_unstable_by(middle, |a, b| a.1.centre()[axis].total_cmp(&b.1.centre()[axis]).then(a.0.cmp(&b.0)));
            let (first, second) = boxes.split_at_mut(middle);
            self.grow(first);
            self.grow(second);
        }
        self.nodes[at].skip = self.nodes.len() as u32;
    }

    /// Calls `goes_on` with the index of every box that `near` touches within `slop` metres, in any order, until it returns false. Returns
    /// whether it never did.
    pub fn search(&self, near: &Aabb, slop: f64, mut goes_on: impl FnMut(u32) -> bool) -> bool {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            if !near.touches(&node.bounds, slop) {
                at = node.skip as usize;
                continue;
            }
            if node.leaf != INNER && !goes_on(node.leaf) {
                return false;
            }
            at += 1;
        }
        true
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
            let boxes: Vec<Aabb> = (0..count).map(|_| area(5.0)).collect();
            let tree = BoxTree::of(boxes.iter().copied());
            for _ in 0..200 {
                let near = area(3.0);
                let all: Vec<u32> = (0..).zip(&boxes).filter(|(_, leaf)| near.touches(leaf, 0.0)).map(|(index, _)| index).collect();
                let mut found = Vec::new();
                tree.search(&near, 0.0, |leaf| {
                    found.push(leaf);
                    true
                });
                found.sort_unstable();
                assert_eq!(found, all);
            }
        }
    }
}
