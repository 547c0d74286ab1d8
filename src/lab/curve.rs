//! A method's curve: the numbers of its runs, and the order that they show.

use crate::draw::chart::look::CurveOrigin;

/// One run of a method at one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkPoint {
    /// s.
    pub step: f64,
    /// CPU time in the diagram's unit, ns.
    pub work: f64,
    /// In the diagram's unit; not finite where the method blew up.
    pub error: f64,
}

impl WorkPoint {
    pub fn blew_up(&self) -> bool {
        self.error.is_nan() || self.error > BLOWN_UP
    }
}

/// Errors beyond this are no answer any more, whatever their unit.
const BLOWN_UP: f64 = 1e4;

/// An order is read from errors in this range: below stands rounding, above the motion's own size.
const FITTED: std::ops::RangeInclusive<f64> = 1e-11..=1.0;
/// Slopes that differ by more are no order.
const ALIKE: f64 = 0.25;

/// Steps, work and tolerances: outside, a number is a slip, and logarithmic axes to it would have no end.
pub const NUMBERS: std::ops::RangeInclusive<f64> = 1e-100..=1e100;
/// More curves than this neither an eye nor a legend copes with.
pub const MOST_CURVES: usize = 64;

/// A method's points, from the coarsest step or in the order of their times.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodCurve<P = WorkPoint> {
    pub name: String,
    pub origin: CurveOrigin,
    pub points: Vec<P>,
}

/// The curve of a method, begun where there is none. `None` beyond [`MOST_CURVES`].
pub(super) fn curve_of<'a, P>(
    curves: &'a mut Vec<MethodCurve<P>>,
    name: &str,
    origin: CurveOrigin,
) -> Option<&'a mut MethodCurve<P>> {
    let known = curves.iter().position(|curve| curve.name == name && curve.origin == origin);
    let index = known.unwrap_or(curves.len());
    if index == MOST_CURVES {
        return None;
    }
    if known.is_none() {
        curves.push(MethodCurve { name: name.to_owned(), origin, points: Vec::new() });
    }
    Some(&mut curves[index])
}

impl MethodCurve {
    /// The order of convergence p: halving the step divides the error by 2ᵖ. It is the median of the slopes between neighbouring steps,
    /// where the error is neither of the motion's own size nor rounding; nothing where these disagree, or are fewer than two.
    pub fn order(&self) -> Option<f64> {
        let pairs = self.points.windows(2).filter(|pair| pair.iter().all(|point| FITTED.contains(&point.error)));
        let slope = |pair: &[WorkPoint]| (pair[0].error / pair[1].error).ln() / (pair[0].step / pair[1].step).ln();
        let mut slopes: Vec<f64> = pairs.map(slope).filter(|slope| slope.is_finite()).collect();
        slopes.sort_by(f64::total_cmp);
        let (least, most) = (slopes.first()?, slopes.last()?);
        let median = slopes[slopes.len() / 2];
        (slopes.len() > 1 && most - least <= ALIKE && median >= 1.0 - ALIKE).then_some(median)
    }

    /// The point with the finest step that the order is read from.
    pub fn finest_fitted(&self) -> Option<WorkPoint> {
        self.points.iter().rev().copied().find(|point| FITTED.contains(&point.error))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_is_read_where_there_is_one() {
        let curve = |errors: &[f64]| MethodCurve {
            name: String::new(),
            origin: CurveOrigin::Lab,
            points: errors
                .iter()
                .enumerate()
                .map(|(i, error)| WorkPoint { step: 0.5f64.powi(i as i32), work: 1.0, error: *error })
                .collect(),
        };
        // The first is no error of the method any more, the last two are rounding.
        let second = curve(&[3.0, 0.4, 0.1, 0.025, 0.00625, 1e-13, 3e-13]);
        assert!((second.order().unwrap() - 2.0).abs() < 1e-9);
        assert_eq!(curve(&[0.1, 0.02, 0.019, 0.001]).order(), None);
        assert_eq!(curve(&[0.1, 0.05]).order(), None, "a single slope is no fit");
        assert_eq!(curve(&[0.1, 0.1, 0.1]).order(), None);
        assert_eq!(curve(&[f64::NAN, f64::INFINITY, 0.0]).order(), None);
    }
}
