//! Places of a work–precision diagram on the canvas: plot, legend, points. Plain arithmetic; `diagram` draws it.

use super::looks::{with_order, without_version};
use crate::draw::chart::{Decades, LEAST_ERROR, RING, WORDS};
use crate::draw::layout::{Area, DETAILS, Frame, Vec2, words_width};
use crate::lab::curve::{Measured, MethodCurve, WorkPoint};
use std::collections::BTreeSet;

/// The longest base of the triangles of orders, canvas units.
pub(super) const SLOPE: f32 = 120.0;
/// Left of the plot: the error's powers of ten.
const LEFT: f32 = 80.0;
/// Above the plot: the name of the error.
const TOP: f32 = 48.0;
/// Below the plot: the work's powers of ten, and its name.
const BOTTOM: f32 = 64.0;
const LEGEND: f32 = 392.0;
/// Where words are large: the letters of a note, and the width of a letter in heights of them.
const LETTERS: f32 = 35.0;
const LETTER: f32 = 0.44;
/// The most of the panel's width that the legend takes, the room at its right, and above and below it.
const MOST: f32 = 0.52;
const BESIDE: f32 = 16.0;
const MARGIN: f32 = 16.0;
const BETWEEN: f32 = 32.0;
/// Line height of the legend, where there is room.
const LINE: f32 = 26.0;
/// Lines of the legend below the curves': tolerance, shipped, cheapest, the meaning of the edges, and a word on the axes.
const NOTES: usize = 10;
/// The pointer picks a point up to this far away.
const NEAR: f32 = 12.0;
/// From one place that is looked at for the triangles to the next, and between the points that stand for a line.
const SPACING: f32 = 12.0;

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
    /// Above and below the legend, its line height and its width.
    margin: f32,
    pub(super) pitch: f32,
    legend: f32,
}

impl DiagramPlaces {
    pub fn of(panel: Area, measured: &Measured, frame: &Frame) -> Self {
        let text = frame.text_height(DETAILS);
        let is_large = frame.text > 1.0;
        let names = measured.curves.iter().map(|curve| words_width(&without_version(&with_order(measured, curve)), text));
        let widest = names.fold(if is_large { LETTER * LETTERS * text } else { 0.0 }, f32::max);
        let legend = LEGEND.max((widest + WORDS + 2.0 * BESIDE).min(MOST * panel.size.x));
        let margin = if is_large { MARGIN / 3.0 } else { MARGIN };
        let width = panel.size.x - LEFT - BETWEEN - legend;
        let area = Area::new(panel.min.x + LEFT, panel.min.y + TOP, width, panel.size.y - TOP - BOTTOM);
        let pitch = |lines: usize| (panel.size.y - 2.0 * margin) / lines.max(1) as f32;
        // Where words are large, notes give way to the curves.
        let least = (1.08 * text).min(pitch(measured.curves.len()));
        let pitch = LINE.min(pitch(measured.curves.len() + NOTES)).max(least);
        Self { panel, area, axes: Axes::of(measured), margin, pitch, legend }
    }

    /// Ten times the work to the right, and ten times the error upwards.
    pub(super) fn decade(&self) -> Vec2 {
        let Axes { work, error } = self.axes;
        self.area.size / Vec2::new((work.to - work.from) as f32, (error.to - error.from) as f32)
    }

    /// The orders that curves show, and the room of their triangles: the lowest one, then the leftmost, where no curve runs.
    pub(super) fn slopes(&self, measured: &Measured, frame: &Frame) -> Option<(BTreeSet<i32>, Area)> {
        let orders = measured.curves.iter().filter_map(MethodCurve::order).map(|order| order.round() as i32);
        let orders: BTreeSet<i32> = orders.collect();
        let decade = self.decade();
        let base = SLOPE.min(decade.x);
        let numbers = frame.text_height(DETAILS);
        let size = Vec2::new(base + numbers, *orders.last()? as f32 * decade.y * base / decade.x + 0.5 * numbers);
        let drawn: Vec<Vec2> = measured.curves.iter().flat_map(|curve| self.along(curve)).collect();
        let tolerance = self.upwards(self.axes.error.part(measured.tolerance));
        let free = |area: &Area| {
            let around = area.inset(-RING);
            (tolerance < area.min.y || tolerance > area.max().y) && !drawn.iter().any(|at| around.contains(*at))
        };
        let room = self.area.size - size - 2.0 * NEAR;
        let steps = |length: f32| (0..=(length / SPACING).max(-1.0) as i32).map(|step| step as f32 * SPACING);
        let corner = Vec2::new(self.area.min.x + NEAR, self.area.max().y - NEAR - size.y);
        let places = steps(room.y).flat_map(|up| steps(room.x).map(move |right| corner + Vec2::new(right, -up)));
        Some((orders, places.map(|min| Area { min, size }).find(free)?))
    }

    pub(super) fn along(&self, curve: &MethodCurve) -> Vec<Vec2> {
        points_along(&curve.points.iter().map(|point| self.at(point)).collect::<Vec<_>>())
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
        let top = self.panel.min.y + self.margin + line as f32 * self.pitch;
        Area::new(self.panel.max().x - self.legend, top, self.legend - BESIDE, self.pitch)
    }

    /// The point under the pointer: its curve and its place in it.
    pub fn point_near(&self, measured: &Measured, pointer: Vec2) -> Option<(usize, usize)> {
        let points = measured.curves.iter().enumerate().flat_map(|(curve, measured)| {
            measured.points.iter().enumerate().map(move |(index, point)| ((curve, index), self.at(point).distance(pointer)))
        });
        points.filter(|(_, distance)| *distance <= NEAR).min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(found, _)| found)
    }
}

/// Points along a line from corner to corner, close to each other.
pub(super) fn points_along(line: &[Vec2]) -> Vec<Vec2> {
    let between = |pair: &[Vec2]| {
        let (from, way) = (pair[0], pair[1] - pair[0]);
        let parts = (way.length() / SPACING).ceil().max(1.0) as usize;
        (0..parts).map(move |part| from + way * (part as f32 / parts as f32)).collect::<Vec<_>>()
    };
    line.windows(2).flat_map(between).chain(line.last().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::chart::CurveOrigin;
    use crate::lab::curve::MethodCurve;

    #[test]
    fn a_point_is_found_where_it_is_drawn() {
        let point = |work, error| WorkPoint { step: 0.1, work, spread: 0.0, error };
        let curve = MethodCurve {
            name: "a".into(),
            origin: CurveOrigin::Lab,
            version: String::new(),
            points: vec![point(10.0, 1.0), point(1e3, 1e-6), point(1e3, f64::NAN)],
        };
        let measured = Measured::of_curves(vec![curve]);
        let plot = DiagramPlaces::of(Area::new(24.0, 104.0, 1232.0, 488.0), &measured, &Frame::default());
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
