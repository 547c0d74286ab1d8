//! Lists whose buffers are kept from step to step, union–find, and incidence.

use std::ops::Range;

/// The number of nothing, in lists of numbers.
pub(crate) const NONE: u32 = u32::MAX;

pub(crate) fn refill<T: Clone>(list: &mut Vec<T>, count: usize, value: T) {
    list.clear();
    list.resize(count, value);
}

/// The first of those that a union–find forest joins to `i`; halves the path to it.
#[inline(always)]
pub(crate) fn first(parent: &mut [u32], mut i: usize) -> usize {
    while parent[i] as usize != i {
        parent[i] = parent[parent[i] as usize];
        i = parent[i] as usize;
    }
    i
}

/// In which pairs of a list each item is (compressed sparse rows).
#[derive(Clone, Debug, Default)]
pub(crate) struct Incidence {
    /// The pairs of item i stand in `list[first[i]..first[i + 1]]`, in ascending order.
    first: Vec<u32>,
    pub list: Vec<u32>,
}

impl Incidence {
    pub fn index(&mut self, items: usize, pairs: impl DoubleEndedIterator<Item = [u32; 2]> + ExactSizeIterator + Clone) {
        // Count, sum up to where each item's pairs end, and fill from the back.
        refill(&mut self.first, items + 1, 0);
        pairs.clone().flatten().for_each(|item| self.first[item as usize] += 1);
        let mut all = 0;
        for count in &mut self.first {
            all += *count;
            *count = all;
        }
        refill(&mut self.list, all as usize, 0);
        for (number, pair) in pairs.enumerate().rev() {
            for item in pair {
                let end = &mut self.first[item as usize];
                *end -= 1;
                self.list[*end as usize] = number as u32;
            }
        }
    }

    pub fn slots(&self, item: usize) -> Range<usize> {
        self.first[item] as usize..self.first[item + 1] as usize
    }

    pub fn of(&self, item: usize) -> &[u32] {
        &self.list[self.slots(item)]
    }
}
