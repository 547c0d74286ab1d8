//! Zones that push each body that touches them.

use crate::physics::data::{Aabb, Body, Cubic, FieldDef, Pose, SLOP, StreamDef, earliest};
use crate::physics::forces::kind::{ForceKind, Source};
use glam::DVec2;

/// m. A body this near to a stream counts as touching it; a body this far from a border is clearly on one side of it.
pub(crate) const BESIDE: f64 = 2.0 * SLOP;
/// m. From here on a swept box is clear of a border, whatever its rounding.
pub(crate) const FAR: f64 = 1e-6;

/// Zones by their indices, below 128: streams and fields of gravity, or liquids.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct ZoneList(u128);

impl ZoneList {
    pub fn of(indices: impl Iterator<Item = u32>) -> Self {
        indices.fold(Self::default(), Self::with)
    }

    pub fn touching<'a>(zones: impl Iterator<Item = &'a Aabb>, near: &Aabb, slop: f64) -> Self {
        Self::of((0..).zip(zones).filter(|(_, zone)| near.touches(zone, slop)).map(|(index, _)| index))
    }

    pub fn with(self, index: u32) -> Self {
        Self(self.0 | 1 << index)
    }

    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    pub fn iter(self) -> impl Iterator<Item = u32> {
        let mut bits = self.0;
        std::iter::from_fn(move || {
            let index = bits.trailing_zeros();
            bits &= bits.wrapping_sub(1);
            (index < u128::BITS).then_some(index)
        })
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Stream {
    pub zone: Aabb,
    /// N of a stream, N/kg of a field.
    pub strength: DVec2,
    pub blows: bool,
    pub kind: ForceKind,
    pub source: Source,
}

impl Stream {
    /// An air stream pushes every body that touches it with the same force.
    pub fn wind((index, def): (u32, &StreamDef)) -> Self {
        Self { zone: def.zone, strength: def.force, blows: true, kind: ForceKind::Wind, source: Source::Stream(index) }
    }

    /// A field gives every body that touches it the same acceleration, besides that by the world's gravity.
    pub fn field((index, def): (u32, &FieldDef)) -> Self {
        Self { zone: def.zone, strength: def.strength, blows: true, kind: ForceKind::Weight, source: Source::Field(index) }
    }

    /// The force on a body that touches it, N.
    pub fn on(&self, body: &Body) -> DVec2 {
        match self.kind {
            ForceKind::Weight if self.blows && !body.weightless => self.strength * body.mass,
            ForceKind::Wind if self.blows => self.strength,
            _ => DVec2::ZERO,
        }
    }

    pub fn is_felt(&self, body: &Body) -> bool {
        feels(&self.zone, body, (body.position, body.velocity))
    }
}

/// Whether a body in a pose feels a zone: touching suffices, unless it leaves. No tick depends on the rounding of a crossing.
pub(crate) fn feels(zone: &Aabb, body: &Body, (position, velocity): Pose) -> bool {
    let apart = position - zone.centre();
    let gap = apart.abs() - body.half - zone.size() * 0.5;
    (0..2).all(|axis| gap[axis] < -SLOP || (gap[axis] <= SLOP && velocity[axis] * apart[axis].signum() <= 0.0))
}

/// Whether a body that sweeps this box surely stays on its side of a border: `inside`, or out of it.
pub(crate) fn stays(swept: &Aabb, half: DVec2, zone: &Aabb, inside: bool) -> bool {
    let reaches = || {
        let (low, high) = (swept.min + 2.0 * half, swept.max - 2.0 * half);
        low.cmpgt(zone.min + FAR).all() && high.cmplt(zone.max - FAR).all()
    };
    if inside { reaches() } else { !swept.touches(zone, FAR) }
}

/// When a body enters a zone or, from `inside`, leaves it. A body at the border has crossed it once it is clear of it.
pub(crate) fn border(way: &Cubic, half: DVec2, zone: &Aabb, inside: bool, end: f64) -> Option<f64> {
    let reach = half + zone.size() * 0.5;
    let motion = Cubic::parabola(zone.centre(), DVec2::ZERO, DVec2::ZERO).relative(way);
    let mut first: Option<f64> = None;
    for axis in 0..2 {
        let (path, other, level) = (motion.axis(axis).until(end), motion.axis(1 - axis), reach[axis]);
        // Of the side at which it begins, if it begins at the border.
        let begin = motion.c[0][axis];
        let clear = |side: f64| if (side * begin - level).abs() <= SLOP { BESIDE } else { 0.0 };
        let (above, below) = (clear(1.0), clear(-1.0));
        let t = if inside {
            earliest(path.rises_through(level + above, 0.0), path.falls_through(-level - below, 0.0))
        } else {
            earliest(path.falls_through(level - above, 0.0), path.rises_through(below - level, 0.0))
                .filter(|&t| other.at(t).abs() <= reach[1 - axis])
        };
        first = earliest(first, t.filter(|&t| t < end));
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::DVec2;
    use crate::physics::data::body::BodyDef;

    #[test]
    fn touching_counts_and_leaving_does_not() {
        let zone = Aabb::new(DVec2::ZERO, DVec2::ONE);
        let body = Body::new(&BodyDef::default());
        let feels = |x: f64, v: f64| feels(&zone, &body, (DVec2::new(x, 0.5), DVec2::new(v, 0.0)));
        assert!(feels(1.4, 3.0) && feels(1.5, 0.0) && feels(1.5, -2.0));
        assert!(!feels(1.5, 2.0) && !feels(1.6, -2.0));
    }

    /// Regression: a body at rest beside a fan, with its edge on the border, drove away and kept the wind for a tick.
    #[test]
    fn what_begins_at_a_border_crosses_it() {
        let (zone, half) = (Aabb::new(DVec2::ZERO, DVec2::ONE), DVec2::splat(0.5));
        let way = |a: f64| Cubic::parabola(DVec2::new(1.5, 0.5), DVec2::ZERO, DVec2::new(a, 0.0));
        assert!(border(&way(3.0), half, &zone, true, 0.01).is_some_and(|t| t < 1e-4));
        assert!(border(&way(-3.0), half, &zone, false, 0.01).is_some_and(|t| t < 1e-4));
        assert_eq!(border(&way(-3.0), half, &zone, true, 0.01), None);
        assert_eq!(border(&way(3.0), half, &zone, false, 0.01), None);
    }
}
