//! Some of a world's zones, one bit each.

use crate::physics::data::aabb::Aabb;

/// Zones by their indices, below 128: streams and fields of gravity, or liquids.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct ZoneList(u128);

impl ZoneList {
    pub fn of(indices: impl Iterator<Item = u32>) -> Self {
        Self(indices.fold(0, |bits, index| bits | 1 << index))
    }

    /// Of those zones that a box touches within `slop` metres.
    pub fn touching<'a>(zones: impl Iterator<Item = &'a Aabb>, near: &Aabb, slop: f64) -> Self {
        Self::of((0..).zip(zones).filter(|(_, zone)| near.touches(zone, slop)).map(|(index, _)| index))
    }

    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The indices, ascending.
    pub fn iter(self) -> impl Iterator<Item = u32> {
        let mut bits = self.0;
        std::iter::from_fn(move || {
            let index = bits.trailing_zeros();
            bits &= bits.wrapping_sub(1);
            (index < u128::BITS).then_some(index)
        })
    }
}
