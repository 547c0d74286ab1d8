//! Lists whose buffers are kept from step to step, and union–find.

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
