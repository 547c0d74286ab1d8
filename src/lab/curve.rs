//! What measuring a scene gives: the numbers behind a diagram.

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
    /// All methods.
    pub curves: Vec<Curve>,
}

impl Measured {
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
