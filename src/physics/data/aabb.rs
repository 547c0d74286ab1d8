//! Axis-aligned boxes.

use glam::DVec2;

/// An axis-aligned box in metres, x to the right, y down: `min` is its top left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Aabb {
    /// The corner with the smallest coordinates (top left), m.
    pub min: DVec2,
    /// The corner with the largest coordinates (bottom right), m.
    pub max: DVec2,
}

impl Aabb {
    /// A box that meets none.
    pub(crate) const NOWHERE: Self = Self { min: DVec2::INFINITY, max: DVec2::NEG_INFINITY };

    /// The box between two corners.
    pub const fn new(min: DVec2, max: DVec2) -> Self {
        Self { min, max }
    }

    /// The box around `centre` that reaches `half` to each side.
    pub fn around(centre: DVec2, half: DVec2) -> Self {
        Self { min: centre - half, max: centre + half }
    }

    /// Its centre, m.
    pub fn centre(&self) -> DVec2 {
        (self.min + self.max) * 0.5
    }

    /// Its width and height, m.
    pub fn size(&self) -> DVec2 {
        self.max - self.min
    }

    /// The largest absolute coordinate, m.
    pub(crate) fn largest(&self) -> f64 {
        self.min.abs().max(self.max.abs()).max_element()
    }

    /// The gap to another box along each axis, m: negative where they overlap along it.
    pub fn gap(&self, other: &Self) -> DVec2 {
        (other.min - self.max).max(self.min - other.max)
    }

    /// The middle of the edge that two boxes which touch share, m.
    pub fn shared_middle(&self, other: &Self) -> DVec2 {
        (self.min.max(other.min) + self.max.min(other.max)) * 0.5
    }

    /// Whether the boxes share an area by more than `slop` metres along both axes.
    pub fn overlaps(&self, other: &Self, slop: f64) -> bool {
        let gap = self.gap(other);
        gap.x < -slop && gap.y < -slop
    }

    /// Whether the boxes touch or overlap: [`Self::touches`] without a branch, for the broad phase.
    #[inline(always)]
    pub(crate) fn meets(&self, other: &Self) -> bool {
        let (along_x, along_y) = (self.min.x <= other.max.x, self.min.y <= other.max.y);
        along_x & (other.min.x <= self.max.x) & along_y & (other.min.y <= self.max.y)
    }

    /// Whether the boxes touch or overlap, within `slop` metres.
    pub fn touches(&self, other: &Self, slop: f64) -> bool {
        let (before, behind) = (other.min - self.max, self.min - other.max);
        // Without `max`, which minds what is no number, and without a branch between the axes.
        (before.x <= slop) & (behind.x <= slop) & (before.y <= slop) & (behind.y <= slop)
    }

    /// The smallest box around both.
    pub fn union(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether `other` lies inside this box, edges included, within `slop` metres.
    pub fn contains(&self, other: &Self, slop: f64) -> bool {
        (other.min + slop).cmpge(self.min).all() && (other.max - slop).cmple(self.max).all()
    }
}
