//! Which pairs will touch, in which order, and who knows of it.

use std::cmp::Ordering;

/// Two that bounce off each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub a: u32,
    pub b: u32,
    pub restitution: f64,
    /// On which ways of its bodies, counted as in [`Due::ways`], it has been seen to touch: that comes once.
    pub passed: u32,
    /// How often it has bounced.
    pub hits: u32,
}

/// A pair in the chain of one of its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub other: u32,
    pub next: u32,
}

/// What somebody has found looking ahead.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Looked {
    /// Where it stays until then: left, right, top, bottom, m.
    pub lane: [f64; 4],
    /// When it touches something, s; infinite if it does not in this step.
    pub next: f64,
    /// How often it has set out on another way.
    pub ways: u32,
    /// When it set out last, s, and how many had before, of all.
    pub since: f64,
    pub departure: u32,
}

/// A pair will touch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Due {
    pub time: f64,
    pub speed: f64,
    pub pair: u32,
    /// How many ways its bodies had set out on: if these are more, it is void.
    pub ways: u32,
    pub axis: usize,
}

impl PartialEq for Due {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Due {}

impl PartialOrd for Due {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Due {
    /// The greatest is the earliest, then the fastest, then the first of the list.
    fn cmp(&self, other: &Self) -> Ordering {
        (other.time.total_cmp(&self.time)).then(self.speed.total_cmp(&other.speed)).then(other.pair.cmp(&self.pair))
    }
}
