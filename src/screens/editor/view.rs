//! The part of the level in view, and its scale.

use crate::draw::layout::{Area, Vec2};
use crate::level::document::Place;
use crate::physics::DVec2;

/// Canvas units a pixel of the picture, at least and at most.
const SCALES: (f64, f64) = (1e-5, 16.0);
/// Magnification of a notch of the wheel.
const NOTCH: f64 = 1.15;
/// Room on each side of a rectangle that is fitted into view, as a share of the window.
const ROOM: f64 = 0.025;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EditorView {
    /// The point of the picture at the top left corner of `area`, pixels.
    origin: DVec2,
    /// Canvas units a pixel of the picture.
    scale: f64,
    pub area: Area,
}

impl Default for EditorView {
    fn default() -> Self {
        Self { origin: DVec2::ZERO, scale: 1.0, area: Area::default() }
    }
}

impl EditorView {
    pub fn shows_as(&self, other: &Self) -> bool {
        (self.origin, self.scale) == (other.origin, other.scale)
    }

    /// Canvas units a pixel of the picture.
    pub const fn scale(&self) -> f64 {
        self.scale
    }

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
}
