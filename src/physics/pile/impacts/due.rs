//! Which pairs will touch, and in which order.

use std::cmp::Ordering;

/// Two that bounce off each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub a: u32,
    pub b: u32,
    pub restitution: f64,
    /// Counts how often its bodies were hit: what was due before is void.
    pub version: u32,
    /// How often it has bounced.
    pub hits: u32,
}

/// A pair will touch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Due {
    pub time: f64,
    pub speed: f64,
    pub pair: u32,
    pub version: u32,
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
