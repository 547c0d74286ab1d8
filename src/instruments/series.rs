//! Numbers, tick by tick, with the extremes of any stretch in a few steps: a curve of an hour is drawn in a frame.

use std::ops::Range;

const BLOCK: usize = 64;

pub type Extremes = (f64, f64);

#[derive(Clone, Debug, Default, PartialEq)]
pub struct NumberSeries {
    values: Vec<f64>,
    /// Of each full block.
    blocks: Vec<Extremes>,
}

impl NumberSeries {
    pub fn push(&mut self, value: f64) {
        self.values.push(value);
        if self.values.len().is_multiple_of(BLOCK) {
            self.blocks.extend(extremes(&self.values[self.values.len() - BLOCK..]));
        }
    }

    pub fn truncate(&mut self, length: usize) {
        self.values.truncate(length);
        self.blocks.truncate(length / BLOCK);
    }

    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The extremes of a stretch; `None` where it is empty.
    pub fn extremes(&self, stretch: Range<usize>) -> Option<Extremes> {
        let stretch = stretch.start..stretch.end.min(self.values.len());
        if stretch.is_empty() {
            return None;
        }
        let blocks = stretch.start.div_ceil(BLOCK)..stretch.end / BLOCK;
        if blocks.is_empty() {
            return extremes(&self.values[stretch]);
        }
        let before = extremes(&self.values[stretch.start..blocks.start * BLOCK]);
        let after = extremes(&self.values[blocks.end * BLOCK..stretch.end]);
        let between = self.blocks[blocks].iter().copied();
        before.into_iter().chain(between).chain(after).reduce(around)
    }
}

pub fn around(a: Extremes, b: Extremes) -> Extremes {
    (a.0.min(b.0), a.1.max(b.1))
}

fn extremes(values: &[f64]) -> Option<Extremes> {
    values.iter().map(|value| (*value, *value)).reduce(around)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn extremes_are_those_of_the_numbers(values in proptest::collection::vec(-9.0..9.0_f64, 0..700), ends in (0..700_usize, 0..700_usize), kept in 0..700_usize) {
            let mut series = NumberSeries::default();
            values.iter().for_each(|value| series.push(*value));
            series.truncate(kept);
            values.iter().for_each(|value| series.push(*value));
            let all: Vec<f64> = values[..kept.min(values.len())].iter().chain(&values).copied().collect();
            prop_assert_eq!(series.values(), &all[..]);
            let stretch = ends.0.min(all.len())..ends.1.min(all.len());
            let found = if stretch.is_empty() { None } else { extremes(&all[stretch]) };
            prop_assert_eq!(series.extremes(ends.0..ends.1), found);
        }
    }
}
