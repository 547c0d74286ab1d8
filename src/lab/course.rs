//! The course of a method while a scene runs: its error and its energy over time, which a final error hides. A method that gains
//! energy slowly, one whose clock is wrong, and one that is merely coarse may end equally far from the truth.

use super::curve::MethodCurve;

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

/// Thinned out, evenly spaced; the last moment stays. Each takes the largest error since the one before, and the energy furthest from
/// 1.
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

#[cfg(test)]
mod tests {
    use super::*;

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
