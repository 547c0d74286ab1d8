//! One run of `resultant chart` as CSV and back: the machine, the diagrams, a file of points and one of courses a scene, the limits of each method.
//! Numbers are in the shortest form that reads back as the same f64; an error of `inf` or `NaN` is a run that blew up.

use super::curve::{
    CoursePoint, MOST_CURVES, Measured, MethodCurve, OverTime, PI, WorkPoint, above_zero, curve_of, error, head, of_flags,
    of_words, rows, shortest, table, work_point,
};
use super::{savings, savings::Saving, stress::Survival};
use crate::files::{CsvColumn, CsvRow, CsvStruct};
use crate::{draw::chart::CurveOrigin, physics::SOURCES};
use serde::Deserialize;

#[derive(Clone, Debug, Default, Deserialize, PartialEq, Eq)]
pub struct MeasuredWith {
    /// Kind of processor and system; no names of machines.
    pub machine: String,
    pub profile: String,
    /// The run made fewer repetitions.
    pub quick: bool,
}

impl CsvStruct for MeasuredWith {
    const COLUMNS: &'static [CsvColumn] = &[of_words("machine"), of_words("profile"), of_flags("quick")];
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Charts {
    pub setting: MeasuredWith,
    /// In the order of the charts' screen.
    pub diagrams: Vec<Measured>,
    /// Rows of one test stand together.
    pub stress: Vec<Survival>,
    pub savings: Vec<Saving>,
}

pub const SETTING: &str = "setting.csv";
const LATER: &str = "a time of 0 or more, s, later than the one before";
pub const SCENES: &str = "scenes.csv";
pub const STRESS: &str = "stress.csv";
const MOST_SCENES: usize = 64;
const SETTING_HEAD: [&str; 3] = head(MeasuredWith::COLUMNS);
const SCENES_HEAD: [&str; 9] = ["scene", "title", "error", "work", "tolerance", "shipped_step", "alike", "note", "over_time"];
const COURSES_HEAD: [&str; 5] = ["method", "origin", "time", "error", "energy"];
const POINTS_HEAD: [&str; 7] = ["method", "origin", "version", "step", "work", "spread", "error"];
const STRESS_HEAD: [&str; 6] = head(Survival::COLUMNS);

impl Charts {
    /// What was measured with another build than this one.
    pub fn stale(&self) -> Vec<&str> {
        let diagrams = self.diagrams.iter().filter(|measured| measured.is_stale()).map(|measured| measured.name.as_str());
        diagrams.chain(self.savings.iter().any(|saving| saving.version != SOURCES).then_some(savings::FILE)).collect()
    }

    pub fn files(&self) -> Vec<(String, String)> {
        let MeasuredWith { machine, profile, quick } = &self.setting;
        let setting = [machine.clone(), profile.clone(), quick.to_string()];
        let scenes = self.diagrams.iter().map(|m| {
            let words = [&m.name, &m.title, &m.error, &m.work].map(String::clone);
            let over_time = m.over_time.as_ref().map_or_else(String::new, |over_time| shortest(over_time.step));
            let rest = [shortest(m.tolerance), shortest(m.shipped_step), m.alike.to_string(), m.note.clone(), over_time];
            words.into_iter().chain(rest).collect()
        });
        let stress = self.stress.iter().map(|row| {
            let words = [&row.test, &row.parameter, &row.method].map(String::clone);
            words.into_iter().chain([row.largest.to_string(), row.tried.to_string(), row.shipped.to_string()]).collect()
        });
        let mut files = vec![
            (SETTING.to_owned(), table(&SETTING_HEAD, [setting.to_vec()])),
            (SCENES.to_owned(), table(&SCENES_HEAD, scenes)),
            (STRESS.to_owned(), table(&STRESS_HEAD, stress)),
            (savings::FILE.to_owned(), savings::csv(&self.savings)),
        ];
        files.extend(self.diagrams.iter().map(|measured| (format!("{}.csv", measured.name), points(measured))));
        let followed =
            self.diagrams.iter().filter_map(|measured| measured.over_time.as_ref().map(|over_time| (measured, over_time)));
        files.extend(followed.map(|(measured, over_time)| (format!("{}-over-time.csv", measured.name), courses(over_time))));
        files
    }
}

fn courses(over_time: &OverTime) -> String {
    let rows = over_time.courses.iter().flat_map(|course| {
        let row = |moment: &CoursePoint| {
            let energy = moment.energy.map_or_else(String::new, shortest);
            let words = [course.name.clone(), origin_word(course.origin).to_owned()];
            words.into_iter().chain([shortest(moment.time), shortest(moment.error), energy]).collect()
        };
        course.points.iter().map(row)
    });
    table(&COURSES_HEAD, rows)
}

fn points(measured: &Measured) -> String {
    let rows = measured.curves.iter().flat_map(|curve| {
        let row = |point: &WorkPoint| {
            let numbers = [point.step, point.work, point.spread, point.error].map(shortest);
            [curve.name.clone(), origin_word(curve.origin).to_owned(), curve.version.clone()].into_iter().chain(numbers).collect()
        };
        curve.points.iter().map(row)
    });
    table(&POINTS_HEAD, rows)
}

fn origin_word(origin: CurveOrigin) -> &'static str {
    match origin {
        CurveOrigin::Lab => "lab",
        CurveOrigin::Shipped => "shipped",
        CurveOrigin::Peer => "peer",
    }
}

impl Charts {
    /// `file` gives the text of a file, or a reason. Errors: the first problem, with file and line where it has one.
    pub fn read(file: impl Fn(&str) -> Result<String, String>) -> Result<Self, String> {
        let setting = rows(SETTING, &file(SETTING)?, &SETTING_HEAD)?;
        let Some(row) = setting.first() else { return Err(format!("{SETTING}: expected a row below the head, found none")) };
        let setting = row.read().map_err(|wrong| row.problems(wrong))?;
        let diagrams = rows(SCENES, &file(SCENES)?, &SCENES_HEAD)?;
        if let Some(row) = diagrams.get(MOST_SCENES) {
            return Err(format!("{SCENES}:{}: found a scene more, expected at most {MOST_SCENES}", row.line));
        }
        let diagrams = diagrams.iter().map(|row| diagram(row, &file)).collect::<Result<Vec<_>, _>>()?;
        if diagrams.is_empty() {
            return Err(format!("{SCENES}: expected a row a scene, found none"));
        }
        let stress = rows(STRESS, &file(STRESS)?, &STRESS_HEAD)?;
        let stress = stress.iter().map(|row| row.read().map_err(|wrong| row.problems(wrong))).collect::<Result<_, _>>()?;
        let savings = savings::read(&file(savings::FILE)?)?;
        Ok(Self { setting, diagrams, stress, savings })
    }
}

fn diagram(row: &CsvRow<'_>, file: &impl Fn(&str) -> Result<String, String>) -> Result<Measured, String> {
    let name = row.get("scene").to_owned();
    // A name in the same folder, none elsewhere.
    if name.is_empty() || !name.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-') {
        return Err(row.bad_cell("scene", "a name of letters a to z, digits and -"));
    }
    let points_file = format!("{name}.csv");
    let mut curves: Vec<MethodCurve> = Vec::new();
    for row in rows(&points_file, &file(&points_file)?, &POINTS_HEAD)? {
        let (origin, method) = (origin(&row)?, row.get("method"));
        let point = work_point(&row)?;
        let curve = curve_of(&mut curves, method, origin).ok_or_else(|| too_many(&row))?;
        curve.version = row.get("version").to_owned();
        curve.points.push(point);
    }
    if name == PI {
        check_steps(&points_file, &curves)?;
    }
    let step = if row.get("over_time").is_empty() { None } else { Some(above_zero(row, "over_time")?) };
    let over_time = step.map(|step| over_time(&name, step, file)).transpose()?;
    let word = |column| row.get(column).to_owned();
    Ok(Measured {
        name,
        title: word("title"),
        error: word("error"),
        work: word("work"),
        tolerance: above_zero(row, "tolerance")?,
        shipped_step: above_zero(row, "shipped_step")?,
        alike: row.parse("alike", "true or false", |_| true)?,
        note: word("note"),
        curves,
        over_time,
    })
}

fn too_many(row: &CsvRow<'_>) -> String {
    row.bad_cell("method", format_args!("at most {MOST_CURVES} methods"))
}

fn origin(row: &CsvRow<'_>) -> Result<CurveOrigin, String> {
    let origins = [CurveOrigin::Lab, CurveOrigin::Shipped, CurveOrigin::Peer];
    let found = origins.into_iter().find(|origin| origin_word(*origin) == row.get("origin"));
    found.ok_or_else(|| row.bad_cell("origin", "lab, shipped or peer"))
}

/// The courses of a scene that was followed at that step.
fn over_time(scene: &str, step: f64, file: &impl Fn(&str) -> Result<String, String>) -> Result<OverTime, String> {
    let name = format!("{scene}-over-time.csv");
    let mut courses: Vec<MethodCurve<CoursePoint>> = Vec::new();
    for row in rows(&name, &file(&name)?, &COURSES_HEAD)? {
        let (origin, method) = (origin(&row)?, row.get("method"));
        let energy = if row.get("energy").is_empty() { None } else { Some(row.parse("energy", "a number, or nothing", |_| true)?) };
        let time = row.parse("time", LATER, |time: &f64| time.is_finite() && *time >= 0.0)?;
        let moment = CoursePoint { time, error: error(&row)?, energy };
        let course = curve_of(&mut courses, method, origin).ok_or_else(|| too_many(&row))?;
        if course.points.last().is_some_and(|last| last.time >= time) {
            return Err(row.bad_cell("time", LATER));
        }
        course.points.push(moment);
    }
    Ok(OverTime { step, courses })
}

/// The methods by hand of the scene π are the values of N, which stand in one table: a row a step.
fn check_steps(file: &str, curves: &[MethodCurve]) -> Result<(), String> {
    let mut by_hand = curves.iter().filter(|curve| curve.origin == CurveOrigin::Lab);
    let steps = |curve: &MethodCurve| curve.points.iter().map(|point| point.step).collect::<Vec<_>>();
    let Some(first) = by_hand.next() else { return Ok(()) };
    match by_hand.find(|curve| steps(curve) != steps(first)) {
        Some(other) => Err(format!("{file}: found other steps at {:?} than at {:?}, expected the same", other.name, first.name)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::curve::MethodCurve;
    use std::collections::HashMap;

    fn some() -> Charts {
        let point = |step, work, error| WorkPoint { step, work, spread: 0.0, error };
        let curve = |name: &str, origin, points| MethodCurve { name: name.into(), origin, version: "1.0".into(), points };
        let measured = Measured {
            name: "a-scene".into(),
            title: "Ten bounces, \"exact\"".into(),
            ..Measured::of_curves(vec![
                curve(
                    "Euler, explicit",
                    CurveOrigin::Lab,
                    vec![point(0.1, 10.0 / 3.0, f64::INFINITY), point(0.05, 7.0, 0.1 + 0.2)],
                ),
                curve("shipped engine", CurveOrigin::Shipped, vec![point(1.0 / 120.0, 50.0, 0.0)]),
                curve("Box2D", CurveOrigin::Peer, vec![point(1.0 / 60.0, 1e5, 5e-324)]),
            ])
        };
        let survival = |test: &str, largest, shipped| Survival {
            test: test.into(),
            parameter: "speed, m/s".into(),
            method: "swept".into(),
            largest,
            tried: 1e6,
            shipped,
        };
        let setting = MeasuredWith { machine: "a, b".into(), profile: "release".into(), quick: true };
        let other = Measured { name: "b".into(), curves: Vec::new(), alike: false, ..measured.clone() };
        Charts {
            setting,
            diagrams: vec![measured, other],
            stress: vec![survival("one", 36.04, false), survival("one", 1e6, true)],
            savings: Vec::new(),
        }
    }

    fn read(files: &HashMap<String, String>) -> Result<Charts, String> {
        Charts::read(|name| files.get(name).cloned().ok_or_else(|| format!("{name}: not found")))
    }

    #[test]
    fn what_was_written_reads_back_to_the_last_bit() {
        let mut charts = some();
        let files = charts.files().into_iter().collect();
        assert_eq!(read(&files), Ok(charts.clone()));
        // NaN is not equal to itself.
        charts.diagrams[0].curves[0].points[0].error = f64::NAN;
        let again = read(&charts.files().into_iter().collect()).unwrap();
        assert!(again.diagrams[0].curves[0].points[0].error.is_nan());
    }

    #[test]
    fn damage_is_told_by_file_and_line() {
        let points = "method,origin,version,step,work,spread,error\n";
        for (file, text, problem) in [
            ("setting.csv", None, "setting.csv: not found"),
            ("a-scene.csv", None, "a-scene.csv: not found"),
            ("setting.csv", Some(""), "setting.csv: found nothing, expected the head machine,profile,quick"),
            ("setting.csv", Some("machine,profile,quick\n"), "setting.csv: expected a row below the head, found none"),
            (
                "setting.csv",
                Some("machine,profile,quick\na,c,maybe\n"),
                "setting.csv:2: column \"quick\": found \"maybe\", expected true or false",
            ),
            (
                "stress.csv",
                Some("test,method\n"),
                "stress.csv:1: found \"test,method\", expected the head test,parameter,method,largest,tried,shipped",
            ),
            (
                "scenes.csv",
                Some("scene,title,error,work,tolerance,shipped_step,alike,note,over_time\n../x,t,e,w,1,1,true,,\n"),
                "scenes.csv:2: column \"scene\": found \"../x\", expected a name of letters a to z, digits and -",
            ),
            (
                "scenes.csv",
                Some("scene,title,error,work,tolerance,shipped_step,alike,note,over_time\n"),
                "scenes.csv: expected a row a scene, found none",
            ),
            (
                "a-scene.csv",
                Some(&format!("{points}\r\n\r\na,lab,v,1,2,0,0\r\na,lab,1\r\n")),
                "a-scene.csv:5: found 3 cells, expected 7: method,origin,version,step,work,spread,error",
            ),
            (
                "a-scene.csv",
                Some(&format!("{points}a,us,v,1,2,0,0\n")),
                "a-scene.csv:2: column \"origin\": found \"us\", expected lab, shipped or peer",
            ),
            (
                "a-scene.csv",
                Some(&format!("{points}a,lab,v,1,NaN,0,0\n")),
                "a-scene.csv:2: column \"work\": found \"NaN\", expected a number above 0, from 1e-100 to 1e100",
            ),
            (
                "a-scene.csv",
                Some(&format!("{points}a,lab,v,0,2,0,0\n")),
                "a-scene.csv:2: column \"step\": found \"0\", expected a number above 0, from 1e-100 to 1e100",
            ),
            (
                "a-scene.csv",
                Some(&format!("{points}a,lab,v,1,2,0,-1\n")),
                "a-scene.csv:2: column \"error\": found \"-1\", expected an error of 0 or more, inf or NaN",
            ),
        ] {
            let mut files: HashMap<String, String> = some().files().into_iter().collect();
            match text {
                Some(text) => drop(files.insert(file.to_owned(), text.to_owned())),
                None => drop(files.remove(file)),
            }
            assert_eq!(read(&files), Err(problem.to_owned()));
        }
    }

    #[test]
    fn no_text_is_a_fault_of_the_program() {
        for text in [
            "\0",
            "\"",
            "method,origin,version,step,work,spread,error\n\"",
            ",,,,\n,,,,",
            "method,origin,version,step,work,spread,error\na,lab,v,1e-320,1e308,0,1e308",
        ] {
            let mut files: HashMap<String, String> = some().files().into_iter().collect();
            for name in ["setting.csv", "scenes.csv", "stress.csv", "a-scene.csv"] {
                let kept = files.insert(name.to_owned(), text.to_owned());
                let _ = read(&files);
                files.extend(kept.map(|kept| (name.to_owned(), kept)));
            }
        }
    }
}
