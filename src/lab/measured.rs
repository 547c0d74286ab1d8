//! The numbers behind a scene's diagrams.

use super::course::OverTime;
use super::curve::{MethodCurve, WorkPoint};
use crate::draw::chart::look::CurveOrigin;

#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    pub name: String,
    pub title: String,
    /// With its unit.
    pub error: String,
    /// With its unit.
    pub work: String,
    pub tolerance: f64,
    /// s.
    pub shipped_step: f64,
    pub alike: bool,
    /// A note for the reader, or empty.
    pub note: String,
    pub curves: Vec<MethodCurve>,
    /// Empty where no method was followed.
    pub over_time: Option<OverTime>,
}

impl Measured {
    #[cfg(test)]
    pub(crate) fn of_curves(curves: Vec<MethodCurve>) -> Self {
        Self {
            name: "n".into(),
            title: "A title".into(),
            error: "error, m".into(),
            work: "work, ns".into(),
            tolerance: 1e-3,
            shipped_step: 0.01,
            alike: true,
            note: String::new(),
            curves,
            over_time: None,
        }
    }

    /// The curve of the shipped engine, if the scene has one, and its points at the step at which the game ships.
    pub fn shipped(&self) -> Option<(&MethodCurve, impl Iterator<Item = WorkPoint>)> {
        let curve = self.curves.iter().find(|curve| curve.origin == CurveOrigin::Shipped)?;
        let step = self.shipped_step;
        Some((curve, curve.points.iter().copied().filter(move |point| (point.step / step - 1.0).abs() < SAME_STEP)))
    }

    pub fn shipped_point(&self) -> Option<WorkPoint> {
        self.shipped()?.1.next()
    }

    /// The cheapest point with an error of at most `error`, where all methods answer the same question.
    pub fn cheapest_within(&self, error: f64) -> Option<(&MethodCurve, WorkPoint)> {
        if !self.alike {
            return None;
        }
        let points = self.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, *point)));
        points.filter(|(_, point)| point.error <= error).min_by(|(_, a), (_, b)| a.work.total_cmp(&b.work))
    }

    pub fn cheapest(&self) -> Option<(&MethodCurve, WorkPoint)> {
        self.cheapest_within(self.tolerance)
    }

    /// The cheapest point that is as exact as the shipped one.
    pub fn cheapest_as_exact(&self) -> Option<(&MethodCurve, WorkPoint)> {
        self.cheapest_within(self.shipped_point()?.error.max(EXACT))
    }
}

/// Relative: steps that differ by less are the same one.
const SAME_STEP: f64 = 1e-6;
/// Errors up to this are none but rounding: which of two is smaller says nothing.
const EXACT: f64 = 1e-9;
