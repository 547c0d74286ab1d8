//! Boxes in a hashed grid, each in all cells that it covers.

use crate::physics::data::{Aabb, NONE};

/// A box that covers more cells is tested one by one. More: more memory for long walls; fewer: more tests.
const MOST_CELLS: i64 = 4096;
/// Up to this many boxes all are tested one by one.
const FEW: usize = 32;

/// An entry of a linked list of items; the list of a cell ends with [`NONE`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct ListEntry {
    pub item: u32,
    pub next: u32,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct CellGrid {
    boxes: Vec<Aabb>,
    /// Cells a metre.
    per_metre: f64,
    heads: Vec<u32>,
    entries: Vec<ListEntry>,
    unused: Vec<u32>,
    large: Vec<u32>,
    /// By item: the search that has found it last.
    found: Vec<u32>,
    search: u32,
}

impl CellGrid {
    /// An empty grid with room for this many boxes.
    pub fn new(count: usize, per_metre: f64) -> Self {
        Self {
            boxes: vec![Aabb::NOWHERE; count],
            per_metre,
            heads: vec![NONE; (4 * count).next_power_of_two().max(64)],
            entries: Vec::with_capacity(8 * count),
            unused: Vec::with_capacity(8 * count),
            large: Vec::with_capacity(count),
            found: vec![0; count],
            ..Self::default()
        }
    }

    pub fn clear(&mut self) {
        self.boxes.fill(Aabb::NOWHERE);
        self.heads.fill(NONE);
        self.entries.clear();
        self.unused.clear();
        self.large.clear();
    }

    pub fn enter(&mut self, item: usize, bounds: Aabb) {
        self.boxes[item] = bounds;
        let Some(cells) = self.cells(&bounds) else {
            return self.large.push(item as u32);
        };
        for head in cells.all(self.heads.len()) {
            let entry = ListEntry { item: item as u32, next: self.heads[head] };
            let at = self.unused.pop().unwrap_or(self.entries.len() as u32);
            match self.entries.get_mut(at as usize) {
                Some(unused) => *unused = entry,
                None => self.entries.push(entry),
            }
            self.heads[head] = at;
        }
    }

    pub fn leave(&mut self, item: usize) {
        let bounds = std::mem::replace(&mut self.boxes[item], Aabb::NOWHERE);
        let Some(cells) = self.cells(&bounds) else {
            return self.large.retain(|other| *other as usize != item);
        };
        for head in cells.all(self.heads.len()) {
            let (mut at, mut before) = (self.heads[head], NONE);
            while let Some(&ListEntry { item: other, next }) = self.entries.get(at as usize) {
                if other as usize == item {
                    match self.entries.get_mut(before as usize) {
                        Some(entry) => entry.next = next,
                        None => self.heads[head] = next,
                    }
                    self.unused.push(at);
                    break;
                }
                (before, at) = (at, next);
            }
        }
    }

    /// Adds the items whose boxes meet these bounds, each once.
    pub fn find(&mut self, bounds: &Aabb, into: &mut Vec<u32>) {
        self.search = self.search.wrapping_add(1);
        // To visit more cells than there are boxes would take longer than all boxes.
        let cells = self.cells(bounds).filter(|cells| cells.count <= self.boxes.len() as i64);
        let Self { boxes, found, search, heads, entries, large, .. } = self;
        let mut test = |j: u32| {
            if std::mem::replace(&mut found[j as usize], *search) != *search && bounds.meets(&boxes[j as usize]) {
                into.push(j);
            }
        };
        let Some(cells) = cells else {
            return (0..boxes.len() as u32).for_each(test);
        };
        large.iter().for_each(|j| test(*j));
        for head in cells.all(heads.len()) {
            let mut at = heads[head];
            while let Some(entry) = entries.get(at as usize) {
                test(entry.item);
                at = entry.next;
            }
        }
    }

    fn cells(&self, of: &Aabb) -> Option<Cells> {
        let [left, right] = [of.min.x, of.max.x].map(|edge| cell(edge, self.per_metre));
        let [top, bottom] = [of.min.y, of.max.y].map(|edge| cell(edge, self.per_metre));
        let count = (right.saturating_sub(left).saturating_add(1)).saturating_mul(bottom.saturating_sub(top).saturating_add(1));
        let sorts = self.boxes.len() > FEW && right >= left && count <= MOST_CELLS;
        sorts.then_some(Cells { columns: (left, right), rows: (top, bottom), count })
    }
}

/// The number of the cell, of a row of them, in which a coordinate lies.
pub(crate) fn cell(edge: f64, per_metre: f64) -> i64 {
    let scaled = edge * per_metre;
    // `f64::floor` is a call where the processor may lack the instruction.
    let whole = scaled as i64;
    whole.saturating_sub(i64::from(whole as f64 > scaled))
}

#[derive(Clone, Copy)]
struct Cells {
    columns: (i64, i64),
    rows: (i64, i64),
    count: i64,
}

impl Cells {
    /// Their places among the lists, whose number is a power of two. Two cells may share one.
    fn all(&self, lists: usize) -> impl Iterator<Item = usize> + use<> {
        let (Self { columns, rows, .. }, mask) = (*self, lists - 1);
        (rows.0..=rows.1).flat_map(move |row| {
            let row = row.wrapping_mul(0x9E37_79B9_7F4A_7C15_u64 as i64);
            (columns.0..=columns.1).map(move |column| (row ^ column.wrapping_mul(0x2545_F491_4F6C_DD1D)) as usize >> 7 & mask)
        })
    }
}
