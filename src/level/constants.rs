//! constants.csv: the settings of a level, and its scale.

use super::awards::{self, Awards};
use super::nearest::meant;
use super::problem::quoted;
use super::quantity::{self as q, Quantity, Scale};
use super::read::Reader;
use super::rows::{self, ConstantRow};
use super::table::{Record, cell};
use super::types::{SHIP_HEIGHT, SHIP_PIXELS};

/// The settings of constants.csv.
pub(super) struct Constants {
    pub gravity: f64,
    pub gravity_x: f64,
    pub air_density: f64,
    pub optimal_time: f64,
    pub rest_speed: f64,
    pub friction: f64,
    /// The line of each constant that is given.
    pub lines: Vec<(&'static str, usize)>,
    pub experiment: bool,
    pub awards: Awards,
    pub title: Option<String>,
    pub width: Option<f64>,
    pub height: Option<f64>,
    /// Whether width and height are given, whatever they hold.
    pub sized: [bool; 2],
}

const CONSTANT_NAMES: [&str; 11] = [
    "gravity",
    "gravity_x",
    "air_density",
    "optimal_time",
    "title",
    "metre",
    "rest_speed",
    "friction",
    "width",
    "height",
    "experiment",
];

/// All that constants.csv can name.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    CONSTANT_NAMES.into_iter().chain(awards::SETTINGS.map(|(name, _)| name))
}

impl Reader<'_> {
    /// Reads the constants, and sets the scale.
    pub fn constants(&mut self) -> Constants {
        let mut given: Vec<(&str, Record)> = Vec::new();
        for record in self.table(rows::CONSTANTS).records {
            let row: ConstantRow = record.row();
            let Some(name) = record.words(cell!(row.name), &mut self.problems) else { continue };
            let known = names().find(|known| known.eq_ignore_ascii_case(&name));
            let Some(known) = known else {
                let expected = format!("one of {}{}", names().collect::<Vec<_>>().join(", "), meant(&name, names()));
                self.warnings.push(record.problem("name", format!("the unknown constant {}", quoted(&name)), expected));
                continue;
            };
            if given.iter().any(|(earlier, _)| *earlier == known) {
                self.problems.push(record.problem("name", format!("{} a second time", quoted(known)), "each constant once"));
            } else {
                given.push((known, record));
            }
        }
        let find = |name: &str| given.iter().find(|(given, _)| *given == name).map(|(_, record)| record);
        let metre = SHIP_PIXELS / SHIP_HEIGHT;
        let metre = self.constant(find("metre"), "metre", q::METRE).unwrap_or(metre);
        self.scale = Scale { metre };
        let size = self.scale.size();
        let awards = awards::SETTINGS.map(|(name, quantity)| Some((name, find(name)?, self.constant(find(name), name, quantity)?)));
        let awards = Awards::of(&awards.into_iter().flatten().collect::<Vec<_>>(), &mut self.problems);
        let mut constant = |name: &str, quantity: Quantity| self.constant(find(name), name, quantity);
        Constants {
            gravity: constant("gravity", q::GRAVITY).unwrap_or(15.0),
            gravity_x: constant("gravity_x", q::GRAVITY).unwrap_or(0.0),
            air_density: constant("air_density", q::AIR_DENSITY).unwrap_or(1.2041),
            optimal_time: constant("optimal_time", q::OPTIMAL_TIME).unwrap_or(60.0),
            rest_speed: constant("rest_speed", q::REST_SPEED).unwrap_or(0.0),
            friction: constant("friction", q::FRICTION).unwrap_or(1.0),
            lines: given.iter().map(|(name, record)| (*name, record.line)).collect(),
            experiment: constant("experiment", q::YES).is_some_and(|yes| yes == 1.0),
            awards,
            title: find("title").and_then(value).filter(|title| !title.is_empty()),
            width: constant("width", size),
            height: constant("height", size),
            sized: ["width", "height"].map(|name| find(name).is_some()),
        }
    }

    /// The number in one row of constants.csv; `None` where it is not given or not accepted.
    fn constant(&mut self, record: Option<&Record>, name: &str, quantity: Quantity) -> Option<f64> {
        let record = record?;
        let text = value(record)?;
        let optional = matches!(name, "metre" | "rest_speed" | "friction" | "gravity_x" | "experiment");
        if text.is_empty() && optional {
            return None;
        }
        let found = || if text.is_empty() { format!("nothing for {name}") } else { format!("{} for {name}", quoted(&text)) };
        quantity.parse(&text).map_err(|expected| self.problems.push(record.problem("value", found(), expected))).ok()
    }
}

/// What a row of constants.csv gives.
fn value(record: &Record) -> Option<String> {
    let ConstantRow { value, .. } = record.row();
    value.as_str().map(str::to_owned)
}
