//! Where the pointer's work ends up: on the edges of other things near by, else on the grid, else on whole pixels.

use crate::level::document::Place;
use crate::physics::DVec2;

/// The grid, pixels.
pub const GRID: f64 = 10.0;

/// What there is to snap to.
#[derive(Clone, Debug, Default)]
pub struct Snap {
    /// Whether it is done at all.
    pub on: bool,
    /// How near is near, pixels.
    pub reach: f64,
    /// The edges of other things, across and down.
    pub edges: [Vec<f64>; 2],
}

impl Snap {
    /// Snaps to these things' edges.
    pub fn new(on: bool, reach: f64, others: impl Iterator<Item = Place>) -> Self {
        let mut edges = [Vec::new(), Vec::new()];
        for place in others.take(if on { usize::MAX } else { 0 }) {
            edges[0].extend([place.min.x, place.max().x]);
            edges[1].extend([place.min.y, place.max().y]);
        }
        Self { on, reach, edges }
    }

    /// How far a value along an axis is from where it ends up.
    fn offset(&self, axis: usize, value: f64) -> f64 {
        if !self.on {
            return value.round() - value;
        }
        let near = self.edges[axis].iter().map(|edge| edge - value).filter(|offset| offset.abs() <= self.reach);
        near.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or_else(|| (value / GRID).round() * GRID - value)
    }

    /// Where a point ends up.
    pub fn point(&self, point: DVec2) -> DVec2 {
        point + DVec2::new(self.offset(0, point.x), self.offset(1, point.y))
    }

    /// Where a rectangle ends up that is moved as a whole: by whichever of its edges is nearest to one of the others', else by its corner.
    pub fn moved(&self, place: Place) -> Place {
        let along = |axis: usize| {
            let (near, far) = (place.min[axis], place.max()[axis]);
            if !self.on {
                return near.round() - near;
            }
            let edges =
                self.edges[axis].iter().flat_map(|edge| [edge - near, edge - far]).filter(|offset| offset.abs() <= self.reach);
            edges.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or_else(|| (near / GRID).round() * GRID - near)
        };
        Place { min: place.min + DVec2::new(along(0), along(1)), ..place }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_go_before_the_grid_and_the_grid_before_pixels() {
        let other = Place { min: DVec2::new(103.0, 7.0), size: DVec2::new(50.0, 20.0) };
        let snap = Snap::new(true, 4.0, [other].into_iter());
        assert_eq!(snap.point(DVec2::new(105.4, 88.2)), DVec2::new(103.0, 90.0));
        // Its right edge meets the other's left one.
        let moved = snap.moved(Place { min: DVec2::new(71.6, 46.0), size: DVec2::new(30.0, 10.0) });
        assert_eq!(moved.min, DVec2::new(73.0, 50.0));
        let off = Snap::new(false, 4.0, [other].into_iter());
        assert_eq!(off.point(DVec2::new(105.4, 88.2)), DVec2::new(105.0, 88.0));
    }
}
