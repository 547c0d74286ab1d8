//! The part of the level in view, its scale, and what things snap to: edges of other things near by, else the grid, else whole pixels.

use crate::{draw::layout::Area, draw::layout::Vec2, level::document::Place, physics::DVec2};

/// Canvas units a pixel of the picture, at least and at most.
const SCALES: (f64, f64) = (1e-5, 16.0);
/// Magnification of a notch of the wheel.
const NOTCH: f64 = 1.15;
/// Room on each side of a rectangle that is fitted into view, as a share of the window.
const ROOM: f64 = 0.025;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EditorView {
    /// The point of the picture at the top left corner of `area`, pixels.
    pub origin: DVec2,
    /// Canvas units a pixel of the picture.
    pub scale: f64,
    pub area: Area,
}

impl Default for EditorView {
    fn default() -> Self {
        Self { origin: DVec2::ZERO, scale: 1.0, area: Area::default() }
    }
}

impl EditorView {
    /// From the picture to the canvas.
    pub fn point(&self, pixels: DVec2) -> Vec2 {
        self.area.min + ((pixels - self.origin) * self.scale).as_vec2()
    }

    pub fn rect(&self, place: &Place) -> Area {
        let (min, max) = (self.point(place.min), self.point(place.max()));
        Area { min, size: max - min }
    }

    /// From the canvas to the picture.
    pub fn pixels(&self, point: Vec2) -> DVec2 {
        self.origin + (point - self.area.min).as_dvec2() / self.scale
    }

    /// The part in view, pixels of the picture.
    pub fn visible(&self) -> Place {
        Place { min: self.origin, size: self.area.size.as_dvec2() / self.scale }
    }

    /// Brings all of a rectangle into view, as large as fits.
    pub fn fit(&mut self, place: &Place) {
        let room = self.area.size.as_dvec2() * (1.0 - 2.0 * ROOM);
        let scale = (room / place.size.max(DVec2::ONE)).min_element();
        self.scale = scale.clamp(SCALES.0, SCALES.1);
        self.centre(place.centre());
    }

    pub fn centre(&mut self, pixels: DVec2) {
        self.origin = pixels - self.area.size.as_dvec2() / self.scale * 0.5;
    }

    /// Moves the picture by that, canvas units.
    pub fn pan(&mut self, by: Vec2) {
        self.origin -= by.as_dvec2() / self.scale;
    }

    /// Magnifies by a number of notches of the wheel around a point of the canvas, which stays where it is.
    pub fn zoom(&mut self, notches: f64, around: Vec2) {
        let fixed = self.pixels(around);
        self.scale = (self.scale * NOTCH.powf(notches)).clamp(SCALES.0, SCALES.1);
        self.origin = fixed - (around - self.area.min).as_dvec2() / self.scale;
    }
}

/// The grid, pixels.
pub const GRID: f64 = 10.0;

#[derive(Clone, Debug, Default)]
pub struct Snap {
    /// Off: whole pixels only.
    pub on: bool,
    /// An edge further away than this is none, pixels.
    pub reach: f64,
    /// The edges of other things along x and y, whole pixels.
    pub edges: [Vec<f64>; 2],
}

impl Snap {
    pub fn new(on: bool, reach: f64, others: impl Iterator<Item = Place>) -> Self {
        let mut edges = [Vec::new(), Vec::new()];
        for place in others.take(if on { usize::MAX } else { 0 }) {
            // On whole pixels, outside of the thing: a snapped rectangle does not reach into it.
            let (min, max) = (place.min.floor(), place.max().ceil());
            edges[0].extend([min.x, max.x]);
            edges[1].extend([min.y, max.y]);
        }
        Self { on, reach, edges }
    }

    /// From a value along an axis to the snapped one, pixels.
    fn offset(&self, axis: usize, value: f64) -> f64 {
        if !self.on {
            return value.round() - value;
        }
        let near = self.edges[axis].iter().map(|edge| edge - value).filter(|offset| offset.abs() <= self.reach);
        near.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or_else(|| (value / GRID).round() * GRID - value)
    }

    pub fn point(&self, point: DVec2) -> DVec2 {
        point + DVec2::new(self.offset(0, point.x), self.offset(1, point.y))
    }

    /// By its edge that is nearest to one of the others, else by its corner; the point that its cells name, corner or middle, is a whole pixel then.
    pub fn moved(&self, place: Place, by_centre: bool) -> Place {
        let along = |axis: usize| {
            let (near, far) = (place.min[axis], place.max()[axis]);
            let named = if by_centre { 0.5 * (near + far) } else { near };
            if !self.on {
                return named.round() - named;
            }
            let meets = |edge: &f64| [(edge - near, 1.0), (edge - far, -1.0)];
            let edges = self.edges[axis].iter().flat_map(meets).filter(|(offset, _)| offset.abs() <= self.reach);
            match edges.min_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs())) {
                // Rounded away from the other thing.
                Some((offset, away)) => ((named + offset) * away).ceil() * away - named,
                None => (named / GRID).round() * GRID - named,
            }
        };
        Place { min: place.min + DVec2::new(along(0), along(1)), ..place }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_point_under_the_pointer_stays_there_while_it_zooms() {
        let mut view = EditorView { area: Area::new(100.0, 50.0, 800.0, 600.0), ..EditorView::default() };
        view.fit(&Place { min: DVec2::ZERO, size: DVec2::new(1280.0, 720.0) });
        let at = Vec2::new(333.0, 222.0);
        let fixed = view.pixels(at);
        for notches in [1.0, -5.0, 12.0, -100.0, 100.0] {
            view.zoom(notches, at);
            assert!(view.pixels(at).distance(fixed) < 1e-6 && view.point(fixed).distance(at) < 1e-2);
        }
    }

    #[test]
    fn all_of_a_fitted_rectangle_is_in_view() {
        let mut view = EditorView { area: Area::new(100.0, 50.0, 800.0, 600.0), ..EditorView::default() };
        for place in
            [Place { min: DVec2::new(-50.0, 3.0), size: DVec2::new(9000.0, 20.0) }, Place { min: DVec2::ZERO, size: DVec2::ONE }]
        {
            view.fit(&place);
            let seen = view.visible();
            assert!(seen.contains(place.min) && seen.contains(place.max()));
        }
    }

    #[test]
    fn edges_go_before_the_grid_and_the_grid_before_pixels() {
        let other = Place { min: DVec2::new(103.0, 7.0), size: DVec2::new(50.0, 20.0) };
        let snap = Snap::new(true, 4.0, [other].into_iter());
        assert_eq!(snap.point(DVec2::new(105.4, 88.2)), DVec2::new(103.0, 90.0));
        // Its right edge meets the other's left one.
        let moved = snap.moved(Place { min: DVec2::new(71.6, 46.0), size: DVec2::new(30.0, 10.0) }, false);
        assert_eq!(moved.min, DVec2::new(73.0, 50.0));
        let off = Snap::new(false, 4.0, [other].into_iter());
        assert_eq!(off.point(DVec2::new(105.4, 88.2)), DVec2::new(105.0, 88.0));
    }

    #[test]
    fn snapped_points_are_whole_pixels_also_beside_the_ship() {
        let ship = Place { min: DVec2::new(124.5, 100.0), size: DVec2::splat(51.0) };
        let snap = Snap::new(true, 4.0, [ship].into_iter());
        assert_eq!(snap.point(DVec2::new(174.0, 43.0)), DVec2::new(176.0, 40.0), "its edge is at 175.5");
        let block = snap.moved(Place { min: DVec2::new(94.0, 40.0), size: DVec2::new(30.0, 10.0) }, false);
        assert_eq!(block.min, DVec2::new(94.0, 40.0));
        // A ship is placed by its middle; its right edge meets the left one of the other.
        let other = snap.moved(Place { min: DVec2::new(72.0, 40.0), ..ship }, true);
        assert_eq!(other.centre().x, 98.0);
        assert!(other.max().x <= 124.0);
        assert_eq!(Snap::default().moved(Place { min: DVec2::new(72.0, 40.2), ..ship }, true).centre(), DVec2::new(98.0, 66.0));
    }
}
