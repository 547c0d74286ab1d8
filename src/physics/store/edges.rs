//! Boxes by their edges.

/// A box as left, right, top, bottom, m.
pub(crate) type Edges = [f64; 4];

/// A box that overlaps none.
pub(crate) const NOWHERE: Edges = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];

/// Whether two boxes overlap or touch.
pub(crate) fn overlap(a: &Edges, b: &Edges) -> bool {
    (a[0] <= b[1]) & (b[0] <= a[1]) & (a[2] <= b[3]) & (b[2] <= a[3])
}

/// Whether the first box contains the second.
pub(crate) fn contains(outer: &Edges, inner: &Edges) -> bool {
    (outer[0] <= inner[0]) & (inner[1] <= outer[1]) & (outer[2] <= inner[2]) & (inner[3] <= outer[3])
}
