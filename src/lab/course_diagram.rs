//! A scene over time as SVG: the error of every method above, and the energy that it has kept below where that is known.

use super::axes::{power, step};
use super::course::{CoursePoint, OverTime};
use super::curve::MethodCurve;
use super::lanes::{self, Lane, Sheet, Way};
use super::linear::Linear;
use super::look::Look;
use super::measured::Measured;
use super::timeline::{Timeline, energy_name, round_numbers};

/// How high the lane of the error is beside that of the energy.
const UPPER: u32 = 11;
const LOWER: u32 = 9;
/// Named values of an energy, about.
const NAMED: usize = 6;

/// Draws it; nothing where the scene was not followed.
///
/// # Errors
/// What the plotting library reports.
pub fn svg(measured: &Measured) -> Result<Option<String>, String> {
    measured.over_time.as_ref().map(|over_time| lanes::svg(&sheet(measured, over_time))).transpose()
}

fn sheet(measured: &Measured, over_time: &OverTime) -> Sheet {
    let axes = Timeline::of(over_time);
    let decades = axes.error;
    let errors = decades.named(8).map(|exponent| (decades.part(10f64.powi(exponent)), power(exponent)));
    let ways = |place: &dyn Fn(&CoursePoint) -> Option<(f64, f64)>| {
        let points = |course: &MethodCurve<CoursePoint>| {
            course.points.iter().filter_map(place).map(|(right, up)| (right * axes.end, up)).collect()
        };
        let way = |course: &MethodCurve<CoursePoint>| Way { look: look(measured, course), points: points(course), marker: None };
        over_time.courses.iter().map(way).collect()
    };
    let mut lanes = vec![Lane {
        name: "error, m".to_owned(),
        height: UPPER,
        named: errors.collect(),
        line: Some(decades.part(super::TOLERANCE)),
        marks: Vec::new(),
        ways: ways(&|moment| Some(axes.error_at(moment))),
    }];
    lanes.extend(axes.energy.map(|(least, most)| {
        Lane {
            name: "energy, parts of the right one".to_owned(),
            height: LOWER,
            named: round_numbers(least, most, NAMED)
                .into_iter()
                .map(|energy| ((energy - least) / (most - least), energy_name(energy)))
                .collect(),
            line: None,
            marks: Vec::new(),
            ways: ways(&|moment| axes.energy_at(moment)),
        }
    }));
    Sheet {
        title: format!("{}: over time, step {}", measured.title, step(over_time.step)),
        notes: Vec::new(),
        across: Linear { from: 0.0, to: axes.end },
        across_name: "time, s".to_owned(),
        lanes,
        legend: over_time.courses.iter().map(|course| (course.name.clone(), look(measured, course))).collect(),
    }
}

/// As the same method looks in the scene's other diagram.
fn look(measured: &Measured, course: &MethodCurve<CoursePoint>) -> Look {
    let same = |curve: &MethodCurve| curve.name == course.name && curve.origin == course.origin;
    let index = measured.curves.iter().position(same).unwrap_or(0);
    let look = Look::of(index, course.origin);
    Look { width: look.width.min(2), ..look }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::curve::CurveOrigin;

    #[test]
    fn what_blew_up_is_drawn_without_bad_numbers() {
        let moment = |time, error, energy| CoursePoint { time, error, energy: Some(energy) };
        let moments = vec![moment(1.0, 0.0, 1.0), moment(2.0, f64::NAN, f64::INFINITY), moment(3.0, 1e300, f64::NAN)];
        let course = MethodCurve { name: "wild".into(), origin: CurveOrigin::Lab, points: moments };
        let over_time = Some(OverTime { step: 1.0 / 60.0, courses: vec![course] });
        let mut measured = Measured { over_time, ..Measured::of_curves(Vec::new()) };
        let drawn = svg(&measured).unwrap().unwrap();
        for word in ["A title: over time, step 1/60 s", "error, m", "energy", "wild", "time, s"] {
            assert!(drawn.contains(word), "{word}");
        }
        assert!(!drawn.contains("NaN") && !drawn.contains("inf"));
        measured.over_time = None;
        assert!(svg(&measured).unwrap().is_none());
    }
}
