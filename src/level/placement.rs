//! Where things start: inside the level, in free space, within reach. And a static tree that finds the boxes that a box touches: a node parts its
//! boxes at the median of their centres along its longer side; nodes lie in the order of a descent, each with the index that follows a miss.

use super::problem::{MOST_PROBLEMS, Problem, at_most};
use super::reach::{FreeSpace, OVERLAP};
use super::types::{Fluid, SHIP_HALF, Solid};
use super::wiring::{SwitchesByName, Worked};
use super::{draft::Draft, schema::typed::FromRow};
use crate::number::{fixed, trimmed};
use crate::physics::domain::{LIQUIDS_OVERLAP, MOST_LIQUIDS, MOST_ZONES};
use crate::physics::{Aabb, DVec2, Sides};
use crate::words::tr;

/// Its name in messages, and its box.
type Named = (&'static str, FromRow<Aabb>);

/// More streams, fields and liquids than a level may have, and liquids that overlap: one problem a row.
pub(super) fn check_zones(draft: &Draft) -> Vec<Problem> {
    let mut problems = Vec::new();
    let sideways = usize::from(draft.settings.row.gravity_x != 0.0);
    too_many(&draft.streams, tr("air streams"), MOST_ZONES, &mut problems);
    too_many(&draft.fields, tr("gravity zones"), MOST_ZONES - sideways, &mut problems);
    too_many(&draft.fluids, tr("liquids"), MOST_LIQUIDS, &mut problems);
    for (i, fluid) in draft.fluids.iter().take(MOST_LIQUIDS).enumerate() {
        let inside = |other: &&FromRow<Fluid>| other.item.zone.overlaps(&fluid.item.zone, LIQUIDS_OVERLAP);
        if let Some(other) = draft.fluids[..i].iter().find(inside) {
            let (column, deep, side) = depth(&fluid.item.zone, &other.item.zone, draft.scale.metre);
            let found = tr!("a liquid {deep} pixels inside that of line {line}", deep, line = other.line);
            let expected = tr!("liquids that at most touch, such as {deep} pixels further {side}", deep, side);
            problems.push(fluid.problem(column, found, expected));
        }
    }
    problems
}

fn too_many<T>(rows: &[FromRow<T>], kind: &str, most: usize, problems: &mut Vec<Problem>) {
    let beyond = rows.iter().skip(most).take(MOST_PROBLEMS);
    problems.extend(beyond.map(|row| row.problem("x", format!("{} {kind}", rows.len()), at_most(most))));
}

/// The ship and every object that start outside the level or inside something solid: one problem a body.
pub(super) fn check(draft: &Draft) -> Vec<Problem> {
    let blocks = draft.world.iter().filter(|solid| solid.item.sides == Sides::ALL);
    let mut solids: Vec<Named> = blocks.map(|solid| (tr("the solid"), solid.map(|solid| solid.bounds))).collect();
    solids.extend(draft.movers.iter().map(|mover| (tr("the mover"), mover.map(|mover| mover.solid.bounds))));
    // A door that is open at the start closes once it is free.
    let switches = SwitchesByName::new(draft.switches.iter().map(|switch| &switch.item));
    let wire = |door: &Solid| switches.wire(door.name.as_deref()?, Worked::Door(0));
    let off = vec![false; draft.switches.len()];
    let open = |door: &Solid| wire(door).is_some_and(|wire| wire.is_on(&off));
    solids.extend(draft.doors.iter().filter(|door| !open(&door.item)).map(|door| (tr("the door"), door.map(|door| door.bounds))));
    let plates = draft.switches.iter().filter(|switch| switch.item.weight.is_some());
    solids.extend(plates.map(|plate| (tr("the plate"), plate.map(|plate| plate.bounds))));
    solids.extend(draft.streams.iter().map(|stream| (tr("the source block"), stream.map(|stream| stream.source))));
    let ship = draft.player.iter().map(|ship| (tr("the ship"), ship.map(|ship| Aabb::around(ship.position, SHIP_HALF))));
    let objects = draft.objects.iter().map(|row| (tr("the object"), row.map(|body| Aabb::around(body.position, body.size * 0.5))));
    let bodies: Vec<Named> = ship.chain(objects).collect();
    let mut problems = Vec::new();
    let all: Vec<&Named> = solids.iter().chain(&bodies).collect();
    let tree = BoxTree::of(all.iter().map(|(_, thing)| thing.item));
    for (i, (name, body)) in bodies.iter().enumerate() {
        if problems.len() > MOST_PROBLEMS {
            return problems;
        }
        // The first of all solids and of the bodies before it.
        let mut first = solids.len() + i;
        tree.search(&body.item, -0.5 * OVERLAP, |index| {
            let index = index as usize;
            if index < first && all[index].1.item.overlaps(&body.item, OVERLAP) {
                first = index;
            }
            true
        });
        if let Some(problem) = outside(name, body, draft) {
            problems.push(problem);
        } else if let Some((what, other)) = all.get(first).filter(|_| first < solids.len() + i) {
            let (column, deep, side) = depth(&body.item, &other.item, draft.scale.metre);
            let found =
                tr!("{name} {deep} pixels inside {what} of {file}:{line}", name, deep, what, file = other.file, line = other.line);
            let expected = tr!("a start in free space, such as {deep} pixels further {side}", deep, side);
            problems.push(body.problem(column, found, expected));
        }
    }
    for mover in &draft.movers {
        let half = mover.item.solid.bounds.size() * 0.5;
        let beyond = mover.item.stops.iter().enumerate().find_map(|(index, stop)| {
            let block = mover.map(|_| Aabb::around(*stop, half));
            let name = if index == 0 { tr("the mover").to_owned() } else { tr!("way point {index} of the mover", index) };
            let problem = outside(&name, &block, draft)?;
            let column = if index == 0 { problem.column.clone() } else { "way_points".to_owned() };
            Some(Problem { column, ..problem })
        });
        problems.extend(beyond);
    }
    problems
}

/// The shortest move out of another body: its column, its length in pixels, its side.
fn depth(body: &Aabb, other: &Aabb, metre: f64) -> (&'static str, String, &'static str) {
    let moves = [
        ("x", body.max.x - other.min.x, tr("left")),
        ("x", other.max.x - body.min.x, tr("right")),
        ("y", body.max.y - other.min.y, tr("up")),
        ("y", other.max.y - body.min.y, tr("down")),
    ];
    let (column, metres, side) = moves.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(moves[0]);
    let pixels = metres * metre;
    // Four digits.
    let decimals = (3 - pixels.log10().floor() as i32).clamp(0, 9) as usize;
    (column, trimmed(&fixed(pixels, decimals)).to_owned(), side)
}

/// The problem of a body that reaches out of the level, if it does.
fn outside(name: &str, body: &FromRow<Aabb>, draft: &Draft) -> Option<Problem> {
    let (size, metre) = (draft.size?, draft.scale.metre);
    let Aabb { min, max } = body.item;
    let out = |min: f64, max: f64, size: f64| min < -OVERLAP || max > size / metre + OVERLAP;
    let (column, size, side) = match (out(min.x, max.x, size.x), out(min.y, max.y, size.y)) {
        (true, _) => ("x", size.x, "width"),
        (_, true) => ("y", size.y, "height"),
        _ => return None,
    };
    let found = tr!("{name} outside the level", name);
    Some(body.problem(column, found, tr!("all of it between 0 and {size} pixels, the level's {side}", size, side)))
}

/// The space without rock, in a level of that size in metres.
pub(super) fn space(draft: &Draft, size: DVec2) -> FreeSpace {
    let rock = draft.world.iter().filter(|solid| solid.item.is_rock()).map(|solid| solid.item.bounds);
    let solids = rock.chain(draft.streams.iter().map(|stream| stream.item.source)).collect();
    FreeSpace::new(Aabb::new(DVec2::ZERO, size), solids)
}

/// The node is no leaf.
const INNER: u32 = u32::MAX;

/// The box of a leaf, and the node that follows where its bounds are missed.
#[derive(Clone, Copy, Debug)]
struct TreeNode {
    bounds: Aabb,
    leaf: u32,
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
