//! Reading what `resultant chart` wrote.

use super::{
    COURSES_HEAD, Charts, LATER, MOST_SCENES, POINTS_HEAD, SCENES, SCENES_HEAD, SETTING, SETTING_HEAD, STRESS, STRESS_HEAD,
    Setting, courses_file, origin_word, points_file,
};
use crate::lab::course::{Course, Moment, OverTime};
use crate::lab::curve::{Curve, MOST_CURVES, Measured, Origin, Point};
use crate::lab::report::PI;
use crate::lab::rows::{Row, rows};
use crate::lab::stress::Survival;

impl Charts {
    /// Reads them again; `file` gives the text of a file, or says why it cannot.
    ///
    /// # Errors
    /// The first problem, with file and line where it has one.
    pub fn read(file: impl Fn(&str) -> Result<String, String>) -> Result<Self, String> {
        let setting = rows(SETTING, &file(SETTING)?, &SETTING_HEAD)?;
        let Some(row) = setting.first() else { return Err(format!("{SETTING}: expected a row below the head, found none")) };
        let commit = Some(row.word(1)).filter(|commit| !commit.is_empty());
        let setting = Setting { machine: row.word(0), commit, profile: row.word(2), quick: row.flag(3)? };
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
        Ok(Self { setting, diagrams, stress })
    }
}

/// A scene's row and the file of its points.
fn diagram(row: &Row<'_>, file: &impl Fn(&str) -> Result<String, String>) -> Result<Measured, String> {
    let name = row.word(0);
    // It names a file in the same folder, and none elsewhere.
    if name.is_empty() || !name.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-') {
        return Err(row.problem(0, "a name of letters a to z, digits and -"));
    }
    let points_file = points_file(&name);
    let mut curves: Vec<Curve> = Vec::new();
    for row in rows(&points_file, &file(&points_file)?, &POINTS_HEAD)? {
        let origin = origin(&row)?;
        let point = Point { step: row.above_zero(2)?, work: row.above_zero(3)?, error: row.error(4)? };
        let known = curves.iter().position(|curve| curve.name == row.word(0) && curve.origin == origin);
        match known {
            Some(index) => curves[index].points.push(point),
            None if curves.len() == MOST_CURVES => return Err(row.problem(0, &format!("at most {MOST_CURVES} methods"))),
            None => curves.push(Curve { name: row.word(0), origin, points: vec![point] }),
        }
    }
    if name == PI {
        check_steps(&points_file, &curves)?;
    }
    let (title, error, work) = (row.word(1), row.word(2), row.word(3));
    let (tolerance, shipped_step) = (row.above_zero(4)?, row.above_zero(5)?);
    let step = if row.word(8).is_empty() { None } else { Some(row.above_zero(8)?) };
    let over_time = step.map(|step| over_time(&name, step, file)).transpose()?;
    Ok(Measured { name, title, error, work, tolerance, shipped_step, alike: row.flag(6)?, note: row.word(7), curves, over_time })
}

fn origin(row: &Row<'_>) -> Result<Origin, String> {
    let origins = [Origin::Lab, Origin::Shipped, Origin::Peer];
    let found = origins.into_iter().find(|origin| origin_word(*origin) == row.word(1));
    found.ok_or_else(|| row.problem(1, "lab, shipped or peer"))
}

/// The courses of a scene that was followed at that step.
fn over_time(scene: &str, step: f64, file: &impl Fn(&str) -> Result<String, String>) -> Result<OverTime, String> {
    let name = courses_file(scene);
    let mut courses: Vec<Course> = Vec::new();
    for row in rows(&name, &file(&name)?, &COURSES_HEAD)? {
        let origin = origin(&row)?;
        let energy = if row.word(4).is_empty() { None } else { Some(row.number(4, "a number, or nothing", |_| true)?) };
        let time = row.number(2, LATER, |time| time.is_finite() && time >= 0.0)?;
        let moment = Moment { time, error: row.error(3)?, energy };
        match courses.iter().position(|course| course.name == row.word(0) && course.origin == origin) {
            Some(index) if courses[index].moments.last().is_some_and(|last| last.time >= time) => {
                return Err(row.problem(2, LATER));
            }
            Some(index) => courses[index].moments.push(moment),
            None if courses.len() == MOST_CURVES => return Err(row.problem(0, &format!("at most {MOST_CURVES} methods"))),
            None => courses.push(Course { name: row.word(0), origin, moments: vec![moment] }),
        }
    }
    Ok(OverTime { step, courses })
}

/// The methods by hand of the scene π are the values of N, which stand in one table: a row a step.
fn check_steps(file: &str, curves: &[Curve]) -> Result<(), String> {
    let mut by_hand = curves.iter().filter(|curve| curve.origin == Origin::Lab);
    let steps = |curve: &Curve| curve.points.iter().map(|point| point.step).collect::<Vec<_>>();
    let Some(first) = by_hand.next() else { return Ok(()) };
    match by_hand.find(|curve| steps(curve) != steps(first)) {
        Some(other) => Err(format!("{file}: found other steps at {:?} than at {:?}, expected the same", other.name, first.name)),
        None => Ok(()),
    }
}

fn survival(row: &Row<'_>) -> Result<Survival, String> {
    let number = |column| row.number(column, "a number of 0 or more", |value| value.is_finite() && value >= 0.0);
    let (test, parameter, method) = (row.word(0), row.word(1), row.word(2));
    Ok(Survival { test, parameter, method, largest: number(3)?, tried: number(4)?, shipped: row.flag(5)? })
}
