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
    /// The point at which the game ships, if the scene has one.
    pub fn shipped(&self) -> Option<(&Curve, Point)> {
        let curve = self.curves.iter().find(|curve| curve.origin == Origin::Shipped)?;
        let distance = |point: &&Point| (point.step / self.shipped_step - 1.0).abs();
        let point = curve.points.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        Some((curve, *point))
    }

    /// The cheapest point within the tolerance, where all answer the same question.
    pub fn cheapest(&self) -> Option<(&Curve, Point)> {
        if !self.alike {
            return None;
        }
        let points = self.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, *point)));
        points.filter(|(_, point)| point.error <= self.tolerance).min_by(|(_, a), (_, b)| a.work.total_cmp(&b.work))
    }
}
