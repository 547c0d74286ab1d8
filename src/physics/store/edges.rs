//! Boxes by their edges.

use glam::DVec2;

/// A box as left, right, top, bottom, m.
pub(crate) type Edges = [f64; 4];

/// A box that overlaps none.
pub(crate) const NOWHERE: Edges = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];

/// The box around a centre.
#[inline(always)]
pub(crate) fn edges(centre: DVec2, half: DVec2) -> Edges {
    let (min, max) = (centre - half, centre + half);
    [min.x, max.x, min.y, max.y]
}

/// Whether two boxes overlap or touch.
pub(crate) fn overlap(a: &Edges, b: &Edges) -> bool {
    (a[0] <= b[1]) & (b[0] <= a[1]) & (a[2] <= b[3]) & (b[2] <= a[3])
}

pub(crate) fn contains(outer: &Edges, inner: &Edges) -> bool {
    (outer[0] <= inner[0]) & (inner[1] <= outer[1]) & (outer[2] <= inner[2]) & (inner[3] <= outer[3])
}
