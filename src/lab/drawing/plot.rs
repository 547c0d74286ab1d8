//! Places of a work–precision diagram on the canvas: plot, legend, points. Plain arithmetic; `diagram` draws it.

use crate::draw::chart::axes::{Decades, LEAST_ERROR};
use crate::draw::layout::{Area, Vec2};
use crate::lab::curve::WorkPoint;
use crate::lab::measured::Measured;

/// Left of the plot: the error's powers of ten.
const LEFT: f32 = 80.0;
/// Above the plot: the name of the error.
const TOP: f32 = 48.0;
/// Below the plot: the work's powers of ten, and its name.
const BOTTOM: f32 = 64.0;
/// Width of the legend.
const LEGEND: f32 = 340.0;
/// Between the plot and the legend.
const BETWEEN: f32 = 32.0;
/// Line height of the legend, where there is room.
const LINE: f32 = 26.0;
/// Lines of the legend below the curves': tolerance, shipped, cheapest, the meaning of the edges, and a word on the axes.
const NOTES: usize = 8;
/// The pointer picks a point up to this far away.
const NEAR: f32 = 12.0;

/// The two logarithmic axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axes {
    pub work: Decades,
    pub error: Decades,
}

impl Axes {
    pub fn of(measured: &Measured) -> Self {
        let points = || measured.curves.iter().flat_map(|curve| &curve.points);
        let errors = points().filter(|point| !point.blew_up()).map(|point| point.error.max(LEAST_ERROR));
        Self {
            work: Decades::around(points().map(|point| point.work).filter(|work| *work > 0.0)),
            error: Decades::around(errors.chain([measured.tolerance])),
        }
    }

    /// The parts of the axes to the right and upwards. A run that blew up is at the upper edge, one without error at the lower.
    pub fn place(&self, point: &WorkPoint) -> (f64, f64) {
        let up = if point.blew_up() { 1.0 } else { self.error.part(point.error.max(LEAST_ERROR)) };
        (self.work.part(point.work), up)
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagramPlaces {
    pub panel: Area,
    /// Between the axes.
    pub area: Area,
    pub axes: Axes,
    /// Line height of the legend.
    pitch: f32,
}

impl DiagramPlaces {
    pub fn of(panel: Area, measured: &Measured) -> Self {
        let width = panel.size.x - LEFT - BETWEEN - LEGEND;
        let area = Area::new(panel.min.x + LEFT, panel.min.y + TOP, width, panel.size.y - TOP - BOTTOM);
        let lines = (measured.curves.len() + NOTES) as f32;
        Self { panel, area, axes: Axes::of(measured), pitch: LINE.min((panel.size.y - 32.0) / lines) }
    }

    pub fn at(&self, point: &WorkPoint) -> Vec2 {
        self.area.part(self.axes.place(point))
    }

    /// A part (0 … 1) of the work's axis.
    pub fn across(&self, part: f64) -> f32 {
        self.area.part((part, 0.0)).x
    }

    /// A part (0 … 1) of the error's axis.
    pub fn upwards(&self, part: f64) -> f32 {
        self.area.part((0.0, part)).y
    }

    /// A line of the legend: first the curves, then the notes.
    pub fn legend(&self, line: usize) -> Area {
        let top = self.panel.min.y + 16.0 + line as f32 * self.pitch;
        Area::new(self.panel.max().x - LEGEND, top, LEGEND - 16.0, self.pitch)
    }

    /// The point under the pointer: its curve and its place in it.
    pub fn point_near(&self, measured: &Measured, pointer: Vec2) -> Option<(usize, usize)> {
        let points = measured.curves.iter().enumerate().flat_map(|(curve, measured)| {
            measured.points.iter().enumerate().map(move |(index, point)| ((curve, index), self.at(point).distance(pointer)))
        });
        points.filter(|(_, distance)| *distance <= NEAR).min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(found, _)| found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::chart::look::CurveOrigin;
    use crate::lab::curve::MethodCurve;

    #[test]
    fn a_point_is_found_where_it_is_drawn() {
        let point = |work, error| WorkPoint { step: 0.1, work, error };
        let curve = MethodCurve {
            name: "a".into(),
            origin: CurveOrigin::Lab,
            points: vec![point(10.0, 1.0), point(1e3, 1e-6), point(1e3, f64::NAN)],
        };
        let measured = Measured::of_curves(vec![curve]);
        let plot = DiagramPlaces::of(Area::new(24.0, 104.0, 1232.0, 488.0), &measured);
        for (index, point) in measured.curves[0].points.iter().enumerate() {
            let at = plot.at(point);
            assert!(at.cmpge(plot.area.min).all() && at.cmple(plot.area.max()).all());
            assert_eq!(plot.point_near(&measured, at + 5.0), Some((0, index)));
        }
        assert_eq!(plot.point_near(&measured, plot.area.min + 60.0), None);
        assert!(plot.area.max().x < plot.legend(0).min.x && plot.legend(0).max().x <= plot.panel.max().x);
        assert!(plot.legend(NOTES).max().y <= plot.panel.max().y);
    }
}
