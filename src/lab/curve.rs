//! The numbers behind a scene's diagrams: a method's errors at its steps, its order, and its course over time, which a final error hides.
//! Rows under a head as CSV and back, numbers in the shortest form that reads back as the same f64. A refusal names file, line and column.

use super::methods::motion::{ADAPTIVE, tolerance};
use crate::files::{CsvColumn, CsvFile, CsvRow, csv_line};
use crate::{draw::chart::CurveOrigin, number::short, number::step, physics::SOURCES};

/// One run of a method at one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkPoint {
    /// s.
    pub step: f64,
    /// CPU time in the diagram's unit, ns: the median of the runs.
    pub work: f64,
    /// The distance between the quartiles of the runs, in parts of the median.
    pub spread: f64,
    /// In the diagram's unit; not finite where the method blew up.
    pub error: f64,
}

/// The median of the times of runs, one at least, and the distance of their quartiles in parts of it.
pub fn median_and_spread(times: &mut [f64]) -> (f64, f64) {
    times.sort_by(f64::total_cmp);
    let (median, quarter) = (times[times.len() / 2], times.len() / 4);
    (median, (times[times.len() - 1 - quarter] - times[quarter]) / median)
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
const SLOPES: f64 = 0.25;

/// The scene whose diagram is of counts.
pub const PI: &str = "pi";

/// The diagram of the time of a step, s, against the number of bodies: work is that number, error that time.
pub const GROWTH: &str = "piles-growth";

/// Steps, work and tolerances: outside, a number is a slip, and logarithmic axes to it would have no end.
pub const NUMBERS: std::ops::RangeInclusive<f64> = 1e-100..=1e100;
/// More curves than this neither an eye nor a legend copes with.
pub const MOST_CURVES: usize = 64;

/// What the Lab and its charts say of what is stale.
pub const ANOTHER_BUILD: &str = "measured with another build than this one";

/// A method's points, from the coarsest step or in the order of their times.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodCurve<P = WorkPoint> {
    pub name: String,
    pub origin: CurveOrigin,
    /// With which it was measured: of a peer its version, else the engine's [`SOURCES`]; empty over time.
    pub version: String,
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
        curves.push(MethodCurve { name: name.to_owned(), origin, version: String::new(), points: Vec::new() });
    }
    Some(&mut curves[index])
}

impl MethodCurve {
    /// The step of a point, or the tolerance that it stands for, with its unit.
    pub fn setting(&self, point: WorkPoint) -> String {
        if self.name == ADAPTIVE { format!("{} m/s", short(tolerance(point.step))) } else { step(point.step) }
    }

    /// The order p, by which halving the step divides the error by 2ᵖ: the median of the slopes in `FITTED`; none where they disagree or are too few.
    pub fn order(&self) -> Option<f64> {
        if self.name == ADAPTIVE {
            return None;
        }
        let pairs = self.points.windows(2).filter(|pair| pair.iter().all(|point| FITTED.contains(&point.error)));
        let slope = |pair: &[WorkPoint]| (pair[0].error / pair[1].error).ln() / (pair[0].step / pair[1].step).ln();
        let mut slopes: Vec<f64> = pairs.map(slope).filter(|slope| slope.is_finite()).collect();
        slopes.sort_by(f64::total_cmp);
        let (least, most) = (slopes.first()?, slopes.last()?);
        let median = slopes[slopes.len() / 2];
        (slopes.len() > 1 && most - least <= SLOPES && median >= 1.0 - SLOPES).then_some(median)
    }
}

/// The slope from a curve's first point to its last on logarithmic axes.
pub fn slope(points: &[WorkPoint]) -> Option<f64> {
    let (first, last) = (points.first()?, points.last()?);
    Some((last.error / first.error).ln() / (last.work / first.work).ln()).filter(|slope| slope.is_finite())
}

/// Moments of a course, at most. More would be closer together than the pixels of a diagram.
const MOMENTS: usize = 150;

/// A method at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoursePoint {
    /// Since the start, s.
    pub time: f64,
    /// The largest distance from the truth since the moment before, m; not finite where the method blew up.
    pub error: f64,
    /// Energy over the exact one, where the scene keeps it.
    pub energy: Option<f64>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct OverTime {
    /// s.
    pub step: f64,
    pub courses: Vec<MethodCurve<CoursePoint>>,
}

impl OverTime {
    pub fn has_energy(&self) -> bool {
        self.courses.iter().flat_map(|course| &course.points).any(|moment| moment.energy.is_some())
    }
}

/// The largest of some errors of 0 or more; not a number where one is not, or where there are none.
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |worst: f64, error: f64| if worst.is_nan() || error <= worst { worst } else { error };
    errors.into_iter().reduce(larger).unwrap_or(f64::NAN)
}

/// Thinned out, evenly spaced; the last moment stays. Each takes the largest error since the one before, and the energy furthest from 1.
pub fn sampled(moments: impl Iterator<Item = CoursePoint>) -> Vec<CoursePoint> {
    let all: Vec<CoursePoint> = moments.collect();
    let every = all.len().div_ceil(MOMENTS).max(1);
    let together = |some: &[CoursePoint]| {
        let last = some.last()?;
        let error = worst(some.iter().map(|moment| moment.error));
        let off = |energy: &f64| (energy - 1.0).abs();
        let energy = some.iter().filter_map(|moment| moment.energy).max_by(|a, b| off(a).total_cmp(&off(b)));
        Some(CoursePoint { time: last.time, error, energy })
    };
    all.chunks(every).filter_map(together).collect()
}

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
    /// Whether another build than this one was measured.
    pub fn is_stale(&self) -> bool {
        self.curves.iter().any(|curve| curve.origin != CurveOrigin::Peer && curve.version != SOURCES)
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

    /// The cheapest point that is as exact as the shipped one: within [`ALIKE`], or none but rounding.
    pub fn cheapest_as_exact(&self) -> Option<(&MethodCurve, WorkPoint)> {
        self.cheapest_within(ALIKE * self.shipped_point()?.error.max(EXACT / ALIKE))
    }
}

/// Relative: steps that differ by less are the same one.
const SAME_STEP: f64 = 1e-6;
/// Errors up to this are none but rounding: which of two is smaller says nothing.
pub const EXACT: f64 = 1e-9;
/// Errors within this factor are alike.
pub const ALIKE: f64 = 10.0;

/// The most rows of a file below its head. With more points a diagram takes longer to draw than a frame lasts.
const MOST_ROWS: usize = 2000;

/// The shortest text that reads back as the same number.
pub(super) fn shortest(value: f64) -> String {
    format!("{value:e}")
}

pub(super) fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    csv_line(head) + &rows.into_iter().map(csv_line).collect::<String>()
}

/// Errors: the number is not within [`NUMBERS`].
pub(super) fn above_zero(row: &CsvRow<'_>, column: &str) -> Result<f64, String> {
    let expected = format!("a number above 0, from {:e} to {:e}", NUMBERS.start(), NUMBERS.end());
    row.parse(column, &expected, |value| NUMBERS.contains(value))
}

/// An error of a run: 0 or more, infinite, or not a number where the run blew up. Errors: anything else.
pub(super) fn error(row: &CsvRow<'_>) -> Result<f64, String> {
    row.parse("error", "an error of 0 or more, inf or NaN", |error: &f64| error.is_nan() || *error >= 0.0)
}

pub(super) const fn head<const N: usize>(columns: &[CsvColumn]) -> [&'static str; N] {
    let (mut names, mut i) = ([""; N], 0);
    while i < N {
        names[i] = columns[i].name;
        i += 1;
    }
    names
}

/// For rows that serde reads: a column of words.
pub(super) const fn of_words(name: &'static str) -> CsvColumn {
    CsvColumn { name, plain: |_, text| Ok(text.into()) }
}

pub(super) const fn of_flags(name: &'static str) -> CsvColumn {
    CsvColumn {
        name,
        plain: |_, text| if text.parse::<bool>().is_ok() { Ok(text.into()) } else { Err("true or false".to_owned()) },
    }
}

pub(super) const fn of_amounts(name: &'static str) -> CsvColumn {
    CsvColumn {
        name,
        plain: |dialect, text| {
            let number = dialect.number(text);
            let good = number.parse().is_ok_and(|value: f64| value.is_finite() && value >= 0.0);
            if good { Ok(number) } else { Err("a number of 0 or more".to_owned()) }
        },
    }
}

/// Errors: a number that is none.
pub(super) fn not_negative(row: &CsvRow<'_>, column: &str) -> Result<f64, String> {
    row.parse(column, "a number of 0 or more", |value: &f64| value.is_finite() && *value >= 0.0)
}

/// The columns of a measured point. Errors: the first number that cannot be.
pub(super) fn work_point(row: &CsvRow<'_>) -> Result<WorkPoint, String> {
    let (step, work) = (above_zero(row, "step")?, above_zero(row, "work")?);
    Ok(WorkPoint { step, work, spread: not_negative(row, "spread")?, error: error(row)? })
}

/// The rows of a file below its head. Errors: the line of the first row that is not as long as the head.
pub(super) fn rows<'a>(file: &'a str, text: &str, head: &'a [&'a str]) -> Result<Vec<CsvRow<'a>>, String> {
    let csv = CsvFile { name: file, columns: head, comments: false };
    let mut rows = csv.rows(text.as_bytes());
    let first = rows.next().ok_or_else(|| format!("{file}: found nothing, expected the head {}", csv.header()))?;
    if !first.is_header(head.len()) {
        return Err(first.row_problem(format_args!("\"{}\"", first.joined()), format_args!("the head {}", csv.header())));
    }
    let checked = (1..).zip(rows).map(|(count, row)| match (row.fault(), row.cells.len()) {
        _ if count > MOST_ROWS => Err(row.row_problem("a row more", format_args!("at most {MOST_ROWS} below the head"))),
        (Some(fault), _) => Err(row.row_problem(fault.words().0, fault.words().1)),
        (None, cells) if cells != head.len() => {
            Err(row.row_problem(format_args!("{cells} cells"), format_args!("{}: {}", head.len(), csv.header())))
        }
        (None, _) => Ok(row),
    });
    checked.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Measured {
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
    }

    #[test]
    fn half_of_the_runs_are_within_the_spread() {
        assert_eq!(median_and_spread(&mut [7.0]), (7.0, 0.0));
        assert_eq!(median_and_spread(&mut [90.0, 11.0, 10.0, 8.0, 9.0]), (10.0, 0.2));
    }

    #[test]
    fn an_order_is_read_where_there_is_one() {
        let curve = |errors: &[f64]| MethodCurve {
            name: String::new(),
            origin: CurveOrigin::Lab,
            version: String::new(),
            points: errors
                .iter()
                .enumerate()
                .map(|(i, error)| WorkPoint { step: 0.5f64.powi(i as i32), work: 1.0, spread: 0.0, error: *error })
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

    #[test]
    fn few_moments_stand_for_many_and_forgive_nothing() {
        let wild = |i: usize| if i == 777 { 9.0 } else { 0.5 };
        let many = (1..=1000).map(|i| CoursePoint { time: i as f64, error: wild(i), energy: Some(1.0 - wild(i)) });
        let few = sampled(many);
        assert!(few.len() <= MOMENTS && few.last().unwrap().time == 1000.0);
        let worst = few.iter().find(|moment| moment.error == 9.0).unwrap();
        assert!(worst.time >= 777.0 && worst.time < 790.0 && worst.energy == Some(-8.0));
        let nothing = sampled([1.0, f64::NAN, 2.0].into_iter().map(|error| CoursePoint { time: 0.0, error, energy: None }));
        assert!(nothing.len() == 3 && nothing[1].error.is_nan());
        assert!(sampled(std::iter::empty()).is_empty());
    }
}
