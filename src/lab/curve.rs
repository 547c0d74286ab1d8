//! What measuring a scene gives: the numbers behind a diagram.

use super::course::OverTime;

/// One run of a method at one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// s.
    pub step: f64,
    /// CPU time in the diagram's unit, ns.
    pub work: f64,
    /// In the diagram's unit; not finite where the method blew up.
    pub error: f64,
}

impl Point {
    /// Whether the error is beyond all bounds.
    pub fn blew_up(&self) -> bool {
        self.error.is_nan() || self.error > BLOWN_UP
    }
}

/// Errors beyond this are no answer any more, whatever their unit.
const BLOWN_UP: f64 = 1e4;

/// Errors of which an order is read: below stands rounding, above the motion's own size.
const FITTED: std::ops::RangeInclusive<f64> = 1e-11..=1.0;
/// Slopes that differ by more are no order.
const ALIKE: f64 = 0.25;

/// Steps, work and tolerances: outside, a number is a slip, and logarithmic axes to it would have no end.
pub const NUMBERS: std::ops::RangeInclusive<f64> = 1e-100..=1e100;
/// The most curves of a diagram: more could neither be told apart nor named in its legend.
pub const MOST_CURVES: usize = 64;

/// Who answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A method by hand.
    Lab,
    /// The engine as it is shipped.
    Shipped,
    /// Another engine, from the file that `benches/peers` wrote.
    Peer,
}

/// A method's points, from the coarsest step.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// For the legend.
    pub name: String,
    /// Who answered.
    pub origin: Origin,
    /// In the order of the steps.
    pub points: Vec<Point>,
}

/// Everything that a diagram shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Name of its files.
    pub name: String,
    /// Its heading.
    pub title: String,
    /// What the error is, with its unit.
    pub error: String,
    /// What the work is, with its unit.
    pub work: String,
    /// The largest error that nobody sees.
    pub tolerance: f64,
    /// The step at which the game ships, s.
    pub shipped_step: f64,
    /// Whether all methods answer the same question.
    pub alike: bool,
    /// What a reader should know; empty where that is nothing.
    pub note: String,
    /// All methods.
    pub curves: Vec<Curve>,
    /// How they fare meanwhile, where the scene was followed.
    pub over_time: Option<OverTime>,
}

impl Curve {
    /// The order of convergence p: halving the step divides the error by 2ᵖ. It is the median of the slopes between neighbouring steps,
    /// where the error is neither of the motion's own size nor rounding; nothing where these disagree, or are fewer than two.
    pub fn order(&self) -> Option<f64> {
        let pairs = self.points.windows(2).filter(|pair| pair.iter().all(|point| FITTED.contains(&point.error)));
        let slope = |pair: &[Point]| (pair[0].error / pair[1].error).ln() / (pair[0].step / pair[1].step).ln();
        let mut slopes: Vec<f64> = pairs.map(slope).filter(|slope| slope.is_finite()).collect();
        slopes.sort_by(f64::total_cmp);
        let (least, most) = (slopes.first()?, slopes.last()?);
        let median = slopes[slopes.len() / 2];
        (slopes.len() > 1 && most - least <= ALIKE && median >= 1.0 - ALIKE).then_some(median)
    }

    /// The point with the finest step of which an order is read.
    pub fn finest_fitted(&self) -> Option<Point> {
        self.points.iter().rev().copied().find(|point| FITTED.contains(&point.error))
    }
}

impl Measured {
    /// A diagram of such curves, for tests.
    #[cfg(test)]
    pub(crate) fn of_curves(curves: Vec<Curve>) -> Self {
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

    /// The curve of the engine as it is shipped, if the scene has one, and its points at the step at which the game ships.
    pub fn shipped(&self) -> Option<(&Curve, impl Iterator<Item = Point>)> {
        let curve = self.curves.iter().find(|curve| curve.origin == Origin::Shipped)?;
        let step = self.shipped_step;
        Some((curve, curve.points.iter().copied().filter(move |point| (point.step / step - 1.0).abs() < SAME_STEP)))
    }

    /// The first of those points.
    pub fn shipped_point(&self) -> Option<Point> {
        self.shipped()?.1.next()
    }

    /// The cheapest point with an error of at most `error`, where all answer the same question.
    pub fn cheapest_within(&self, error: f64) -> Option<(&Curve, Point)> {
        if !self.alike {
            return None;
        }
        let points = self.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, *point)));
        points.filter(|(_, point)| point.error <= error).min_by(|(_, a), (_, b)| a.work.total_cmp(&b.work))
    }

    /// The cheapest point within the tolerance.
    pub fn cheapest(&self) -> Option<(&Curve, Point)> {
        self.cheapest_within(self.tolerance)
    }

    /// The cheapest point that is as exact as the shipped one.
    pub fn cheapest_as_exact(&self) -> Option<(&Curve, Point)> {
        self.cheapest_within(self.shipped_point()?.error.max(EXACT))
    }
}

/// Relative: steps that differ by less are the same one.
const SAME_STEP: f64 = 1e-6;
/// Errors up to this are none but rounding: which of two is smaller says nothing.
const EXACT: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_is_read_where_there_is_one() {
        let curve = |errors: &[f64]| Curve {
            name: String::new(),
            origin: Origin::Lab,
            points: errors
                .iter()
                .enumerate()
                .map(|(i, error)| Point { step: 0.5f64.powi(i as i32), work: 1.0, error: *error })
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
