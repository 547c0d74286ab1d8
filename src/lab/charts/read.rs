use super::{
    COURSES_HEAD, Charts, LATER, MOST_SCENES, MeasuredWith, POINTS_HEAD, SCENES, SCENES_HEAD, SETTING, SETTING_HEAD, STRESS,
    STRESS_HEAD, courses_file, origin_word, points_file,
};
use crate::draw::chart::look::CurveOrigin;
use crate::files::CsvRow;
use crate::lab::curve::{CoursePoint, MOST_CURVES, Measured, MethodCurve, OverTime, curve_of};
use crate::lab::report::PI;
use crate::lab::rows::{above_zero, error, not_negative, rows, work_point};
use crate::lab::savings;
use crate::lab::stress::Survival;

/// The words of a switch, for a message.
const FLAG: &str = "true or false";

impl Charts {
    /// `file` gives the text of a file, or a reason.
    ///
    /// # Errors
    /// The first problem, with file and line where it has one.
    pub fn read(file: impl Fn(&str) -> Result<String, String>) -> Result<Self, String> {
        let setting = rows(SETTING, &file(SETTING)?, &SETTING_HEAD)?;
        let Some(row) = setting.first() else { return Err(format!("{SETTING}: expected a row below the head, found none")) };
        let setting = MeasuredWith {
            machine: row.get("machine").to_owned(),
            profile: row.get("profile").to_owned(),
            quick: row.parse("quick", FLAG, |_| true)?,
        };
        let diagrams = rows(SCENES, &file(SCENES)?, &SCENES_HEAD)?;
        if let Some(row) = diagrams.get(MOST_SCENES) {
            return Err(format!("{SCENES}:{}: found a scene more, expected at most {MOST_SCENES}", row.line));
        }
        let diagrams = diagrams.iter().map(|row| diagram(row, &file)).collect::<Result<Vec<_>, _>>()?;
        if diagrams.is_empty() {
            return Err(format!("{SCENES}: expected a row a scene, found none"));
        }
        let stress = rows(STRESS, &file(STRESS)?, &STRESS_HEAD)?;
        let stress = stress.iter().map(survival).collect::<Result<Vec<_>, _>>()?;
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
    let points_file = points_file(&name);
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
        alike: row.parse("alike", FLAG, |_| true)?,
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
    let name = courses_file(scene);
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

fn survival(row: &CsvRow<'_>) -> Result<Survival, String> {
    let word = |column| row.get(column).to_owned();
    Ok(Survival {
        test: word("test"),
        parameter: word("parameter"),
        method: word("method"),
        largest: not_negative(row, "largest")?,
        tried: not_negative(row, "tried")?,
        shipped: row.parse("shipped", FLAG, |_| true)?,
    })
}
