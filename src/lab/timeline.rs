//! The axes of a scene over time: error upwards in decades, energy in parts of what it should be, both above the same time. A
//! moment lies at parts of the axes, 0 … 1, so that paper and screen draw the same.

use super::TOLERANCE;
use super::curve::{CoursePoint, OverTime};
use crate::draw::chart::{Decades, LEAST_ERROR};
use crate::number::short;

/// The range of energies on the axis, in parts of the exact one. A method beyond it has gained or lost all there is.
const ENERGIES: (f64, f64) = (0.0, 2.0);
/// The least that the axis of the energy spans, in parts of 1: a steady energy looks steady.
const LEAST_SPAN: f64 = 0.01;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timeline {
    pub end: f64,
    pub error: Decades,
    /// Range of the energies, where any is known.
    pub energy: Option<(f64, f64)>,
}

impl Timeline {
    /// Around all points and the tolerance.
    pub fn of(over_time: &OverTime) -> Self {
        let moments = || over_time.courses.iter().flat_map(|course| &course.points);
        let errors = moments().map(|moment| moment.error).filter(|error| error.is_finite()).map(shown);
        let end = moments().map(|moment| moment.time).fold(0.0, f64::max);
        let energies = moments().filter_map(|moment| moment.energy).filter(|energy| energy.is_finite());
        let span = |(least, most): (f64, f64), energy: f64| {
            let seen = energy.clamp(ENERGIES.0, ENERGIES.1);
            (least.min(seen), most.max(seen))
        };
        let energy = over_time.has_energy().then(|| energies.fold((1.0 - LEAST_SPAN, 1.0 + LEAST_SPAN), span));
        Self { end: if end > 0.0 { end } else { 1.0 }, error: Decades::around(errors.chain([TOLERANCE])), energy }
    }

    /// Parts of the axes to the right and upwards, 0 … 1; a run that blew up lies at the upper edge.
    pub fn error_at(&self, moment: &CoursePoint) -> (f64, f64) {
        let up = if moment.error.is_finite() { self.error.part(shown(moment.error)) } else { 1.0 };
        (moment.time / self.end, up)
    }

    /// The same of an energy, where it is known; clamped at the edges.
    pub fn energy_at(&self, moment: &CoursePoint) -> Option<(f64, f64)> {
        let (least, most) = self.energy?;
        let energy = moment.energy?;
        let part = ((energy - least) / (most - least)).clamp(0.0, 1.0);
        Some((moment.time / self.end, if part.is_nan() { 1.0 } else { part }))
    }
}

/// An energy as a label: the largest stands for all beyond it.
pub fn energy_name(energy: f64) -> String {
    if energy >= ENERGIES.1 { format!("≥ {}", short(ENERGIES.1)) } else { short(energy) }
}

/// An error clamped to the axis: rounding at the lower edge, blown-up runs at the upper one.
fn shown(error: f64) -> f64 {
    error.clamp(LEAST_ERROR, 1e4)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::chart::look::CurveOrigin;
    use crate::lab::curve::MethodCurve;

    #[test]
    fn moments_lie_between_the_axes_whatever_they_are() {
        let moment = |time, error, energy| CoursePoint { time, error, energy };
        let moments = vec![
            moment(1.0, 0.0, Some(1.0)),
            moment(2.0, 0.1, Some(1.5)),
            moment(3.0, f64::INFINITY, Some(1e300)),
            moment(4.0, f64::NAN, Some(f64::NAN)),
        ];
        let over_time = OverTime {
            step: 0.1,
            courses: vec![MethodCurve { name: "a".into(), origin: CurveOrigin::Lab, version: String::new(), points: moments }],
        };
        let axes = Timeline::of(&over_time);
        assert_eq!((axes.end, axes.energy), (4.0, Some((0.99, 2.0))));
        let at: Vec<_> = over_time.courses[0].points.iter().map(|m| (axes.error_at(m), axes.energy_at(m).unwrap())).collect();
        assert_eq!(at[0].0, (0.25, 0.0));
        assert_eq!((at[2].0.1, at[3].0.1, at[2].1.1, at[3].1.1), (1.0, 1.0, 1.0, 1.0));
        assert!((at[1].1.1 - 0.51 / 1.01).abs() < 1e-12);
    }
}
