//! Pairs of bodies whose boxes meet, found in each step: a body looks, in the columns that its box covers, at the bodies below it.

use crate::physics::data::{Aabb, NONE, refill};
use crate::physics::store::grid::{ListEntry, cell};
use std::ops::Range;

/// A box that covers more columns, or is as tall, is tested against all.
const MOST_COLUMNS: f64 = 64.0;
/// Up to this many boxes all are tested against all.
const FEW: usize = 12;

#[derive(Clone, Debug, Default)]
pub(crate) struct Columns {
    /// Columns a metre.
    per_metre: f64,
    /// The highest entry of each column, from which the list goes down; several columns may share one.
    heads: Vec<u32>,
    entries: Vec<ListEntry>,
    /// Places of boxes that cover too many columns.
    wide: Vec<u32>,
    /// By place: the first column, and how far down the centre is, m.
    begins: Vec<(i64, f64)>,
    /// How far up from its centre any box reaches that is not wide, m.
    reach: f64,
    /// −1 if gravity points to smaller y, else 1.
    pub down: f64,
}

impl Columns {
    pub fn new(count: usize, per_metre: f64) -> Self {
        Self {
            per_metre,
            entries: Vec::with_capacity(8 * count),
            wide: Vec::with_capacity(count),
            begins: Vec::with_capacity(count),
            ..Self::default()
        }
    }

    /// Begins with boxes that stand bottom-up, each with how far down its centre is, m.
    pub fn begin(&mut self, depths: &[(f64, u32)], boxes: &[Aabb]) {
        refill(&mut self.heads, (2 * boxes.len()).next_power_of_two().max(2 * MOST_COLUMNS as usize), NONE);
        self.entries.clear();
        self.wide.clear();
        self.begins.clear();
        self.reach = 0.0;
        for (&(depth, _), of) in depths.iter().zip(boxes) {
            self.begins.push((cell(of.min.x, self.per_metre), depth));
            if !self.is_wide(of) {
                self.reach = self.reach.max(depth - if self.down > 0.0 { of.min.y } else { -of.max.y });
            }
        }
    }

    /// Whether a box is tested against all: it is wide, or so tall that others would have to look far down for it.
    fn is_wide(&self, of: &Aabb) -> bool {
        of.size().max_element() * self.per_metre >= MOST_COLUMNS
    }

    /// Whether the entries are the same where the box of a place is another one.
    pub fn serve(&self, (k, depth): (usize, f64), before: &Aabb, now: &Aabb) -> bool {
        let cells = |of: &Aabb| [of.min.x, of.max.x].map(|x| cell(x, self.per_metre));
        let up = depth - if self.down > 0.0 { now.min.y } else { -now.max.y };
        depth == self.begins[k].1 && cells(before) == cells(now) && !self.is_wide(before) && !self.is_wide(now) && up <= self.reach
    }

    /// Enters the box at place `k`, and adds the places below `k` whose boxes meet it, each once.
    #[inline(always)]
    pub fn pass(&mut self, k: usize, boxes: &[Aabb], into: &mut Vec<u32>) {
        let mine = &boxes[k];
        let columns = self.begins[k].0..cell(mine.max.x, self.per_metre) + 1;
        let tests_all = self.tests_all(mine);
        self.visit_columns(columns.clone(), tests_all, (mine, &boxes[..k]), |place| into.push(place));
        if tests_all {
            return self.wide.push(k as u32);
        }
        for column in columns {
            let head = self.head(column);
            self.entries.push(ListEntry { item: k as u32, next: self.heads[head] });
            self.heads[head] = self.entries.len() as u32 - 1;
        }
    }

    fn tests_all(&self, mine: &Aabb) -> bool {
        self.begins.len() <= FEW || self.is_wide(mine)
    }

    fn head(&self, column: i64) -> usize {
        column as usize & (self.heads.len() - 1)
    }

    /// Calls `each` for the places of the `boxes` entered so far that meet this one, once for each.
    pub fn visit(&self, mine: &Aabb, boxes: &[Aabb], each: impl FnMut(u32)) {
        let columns = cell(mine.min.x, self.per_metre)..cell(mine.max.x, self.per_metre) + 1;
        self.visit_columns(columns, self.tests_all(mine), (mine, boxes), each);
    }

    #[inline(always)]
    fn visit_columns(&self, columns: Range<i64>, tests_all: bool, of: (&Aabb, &[Aabb]), mut each: impl FnMut(u32)) {
        let (mine, boxes) = of;
        let mut test = |place: u32| {
            if mine.meets(&boxes[place as usize]) {
                each(place);
            }
        };
        if tests_all {
            return (0..boxes.len() as u32).for_each(test);
        }
        self.wide.iter().for_each(|place| test(*place));
        let first = columns.start;
        let lowest = (if self.down > 0.0 { mine.max.y } else { -mine.min.y }) + self.reach;
        for column in columns {
            let mut at = self.heads[self.head(column)];
            while let Some(&ListEntry { item: place, next: below }) = self.entries.get(at as usize) {
                let (begins, depth) = self.begins[place as usize];
                if depth > lowest {
                    break;
                }
                // A pair is found in the first column that both cover.
                if begins.max(first) == column {
                    test(place);
                }
                at = below;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use glam::DVec2;

    /// The pairs are those of all against all, each once, giants and boxes far away included.
    #[test]
    fn finds_the_pairs_that_brute_force_finds() {
        let mut random = Random(1);
        let mut columns = Columns::new(300, 1.25);
        for (round, down) in [1.0, -1.0, 1.0, -1.0].into_iter().enumerate() {
            let n = [300, 300, 12, 40][round];
            let mut boxes: Vec<Aabb> = Vec::new();
            for k in 0..n {
                let size = if k % 50 == 0 { 6.0 } else { 0.4 };
                let far = if k % 7 == 0 { 1e7 } else { 0.0 };
                let centre = DVec2::new(far + 20.0 * random.unit(), 20.0 * random.unit());
                let half = DVec2::new(size * (0.2 + random.unit()), size * (0.2 + random.unit()));
                boxes.push(Aabb::around(centre, if k == 5 { half * DVec2::new(1e6, 1.0) } else { half }));
            }
            boxes.sort_by(|a, b| (b.centre().y * down).total_cmp(&(a.centre().y * down)));
            let depths: Vec<(f64, u32)> = (0..).zip(&boxes).map(|(k, of)| (of.centre().y * down, k)).collect();
            columns.down = down;
            columns.begin(&depths, &boxes);
            for k in 0..n {
                let mut found = Vec::new();
                columns.pass(k, &boxes, &mut found);
                found.sort_unstable();
                let meet: Vec<u32> = (0..k as u32).filter(|j| boxes[k].meets(&boxes[*j as usize])).collect();
                assert_eq!(found, meet, "{n} boxes, place {k}");
            }
        }
    }
}
