//! Friction on upright faces: along walls, and between bodies side by side.
//!
//! How hard the sides press is told by a merging across without the ground's friction. A body that stands still against a wall hangs
//! there while what it would take, its own weight and all that it carries, stays below μ_s·N; else it slides and loses up to μ_k·N/m.
//! Bodies side by side that slide past each other rub as a pair. Only those are asked that would move along the face: what the ground
//! carries does not.

use super::report::Record;

/// What walls do in one step of one island.
#[derive(Clone, Debug, Default)]
pub(super) struct Walls {
    /// By slot: impulse along gravity that sides gave to a body, N·s.
    given: Vec<f64>,
    any: bool,
    records: Vec<Record>,
}

impl Walls {
    pub fn new(count: usize) -> Self {
        Self { given: vec![0.0; count], ..Self::default() }
    }

    /// What sides gave to a body along gravity, N·s.
    pub fn rubbed(&self, i: usize) -> f64 {
        if self.any { self.given[i] } else { 0.0 }
    }

    pub fn record(&self, into: &mut Vec<Record>) {
        if self.any {
            into.extend_from_slice(&self.records);
        }
    }
}
