//! Rows of what is solid: world.csv, movers.csv, doors.csv and switches.csv.

use super::nearest::meant;
use super::problem::{Problem, quoted};
use super::quantity::{self as q, Scale};
use super::route::{self, Manner, Pace};
use super::rows::{bounds, material, place};
use super::table::{CellText, Given, Layout, Record, cell};
use super::types::{Latch, Mover, Presser, Route, Solid, Switch, Work};
use crate::physics::{DVec2, Sides};
use serde::Deserialize;

pub(super) const WORLD: Layout =
    Layout { file: "world.csv", columns: "x,y,width,height,[material],[one_way],[belt],[breaks],[name]" };
pub(super) const MOVERS: Layout = Layout {
    file: "movers.csv",
    columns: "x,y,width,height,way_points,[speed],[period],[wait],[ease],[route],[material],[one_way],[belt],[name]",
};
pub(super) const DOORS: Layout = Layout { file: "doors.csv", columns: "x,y,width,height,name,[material]" };
pub(super) const SWITCHES: Layout = Layout { file: "switches.csv", columns: "x,y,width,height,works,[weight],[by],[stays]" };

/// The most way points of a mover, and the most names that a switch works.
const MOST_STOPS: usize = 50;
const MOST_WORKS: usize = 50;

/// A row of any of these files.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct BlockRow {
    x: CellText,
    y: CellText,
    width: CellText,
    height: CellText,
    way_points: CellText,
    speed: CellText,
    period: CellText,
    wait: CellText,
    ease: CellText,
    route: CellText,
    material: CellText,
    one_way: CellText,
    belt: CellText,
    breaks: CellText,
    name: CellText,
    works: CellText,
    weight: CellText,
    by: CellText,
    stays: CellText,
}

/// A row of world.csv, movers.csv or doors.csv: the block that it begins as.
pub(super) fn solid(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Solid> {
    let row: BlockRow = record.row();
    let bounds = bounds(record, place!(row), scale, problems);
    let material = material(record, cell!(row.material), problems);
    let sides = one_of(record, cell!(row.one_way), Sides::ALL, &SIDES, problems);
    let belt = record.number_or(cell!(row.belt), 0.0, q::BELT, problems);
    let breaks = if row.breaks.is_given() { record.number(cell!(row.breaks), q::IMPULSE, problems).map(Some) } else { Some(None) };
    let name = if row.name.is_given() || record.file == DOORS.file {
        name(record, cell!(row.name), problems).map(Some)
    } else {
        Some(None)
    };
    Some(Solid { bounds: bounds?, material: material?, sides: sides?, belt: belt?, breaks: breaks?, name: name? })
}

/// A row of movers.csv.
pub(super) fn mover(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Mover> {
    let row: BlockRow = record.row();
    let solid = solid(record, scale, problems);
    let corners = record.parse(cell!(row.way_points), problems, |text| way_points(text, scale));
    let pace = pace(&row, record, problems);
    let wait = record.number_or(cell!(row.wait), 0.0, q::PAUSE, problems);
    let ease = record.number_or(cell!(row.ease), 0.0, q::PAUSE, problems);
    let route = one_of(record, cell!(row.route), Route::Back, &ROUTES, problems);
    let (solid, corners) = (solid?, corners?);
    let (start, half) = (solid.bounds.min, solid.bounds.size() * 0.5);
    let stops: Vec<DVec2> = std::iter::once(start).chain(corners).map(|corner| corner + half).collect();
    if stops.windows(2).any(|pair| pair[0].distance(pair[1]) < q::MIN_SIZE) {
        let found = format!("{}, with a way point where the block is already", quoted(row.way_points.as_str()?));
        problems.push(record.problem("way_points", found, "each way point apart from the one before (the first, from x and y)"));
        return None;
    }
    let (route, pace) = (route?, pace?);
    let path = route::path(&stops, Manner { route, pace, wait: wait?, ease: ease? }).map_err(|least| {
        let found = quoted(row.period.as_str().unwrap_or_default());
        let expected = format!("at least {least:.3} s, which its waits and easings take");
        problems.push(record.problem("period", found, expected));
    });
    Some(Mover { solid, stops, route, path: path.ok()? })
}

/// Exactly one of speed and period.
fn pace(row: &BlockRow, record: &Record, problems: &mut Vec<Problem>) -> Option<Pace> {
    match (row.speed.is_given(), row.period.is_given()) {
        (true, false) => record.number(cell!(row.speed), q::SPEED, problems).map(Pace::Speed),
        (false, true) => record.number(cell!(row.period), q::PERIOD, problems).map(Pace::Period),
        (both, _) => {
            let found = if both { "a speed and a period" } else { "neither a speed nor a period" };
            problems.push(record.problem("speed", found, "one of the two: speed in m/s, or period in s"));
            None
        }
    }
}

/// `600 300; 600 100`: top left corners in pixels, here in metres.
fn way_points(text: &str, scale: Scale) -> Result<Vec<DVec2>, String> {
    let expected = || "way points such as 600 300; 600 100: x and y in pixels, a semicolon between them".to_owned();
    let points: Vec<&str> = text.split(';').map(str::trim).filter(|point| !point.is_empty()).collect();
    if points.is_empty() {
        return Err(expected());
    }
    if points.len() > MOST_STOPS {
        return Err(format!("at most {MOST_STOPS} way points"));
    }
    let range = scale.coordinate();
    let point = |point: &&str| match point.split_whitespace().collect::<Vec<_>>()[..] {
        [x, y] => Ok(scale.metres(range.parse(x)?, range.parse(y)?)),
        _ => Err(expected()),
    };
    points.iter().map(point).collect()
}

/// A row of switches.csv.
pub(super) fn switch(record: &Record, scale: Scale, problems: &mut Vec<Problem>) -> Option<Switch> {
    let row: BlockRow = record.row();
    let bounds = bounds(record, place!(row), scale, problems);
    let works = record.parse(cell!(row.works), problems, works);
    let weight = if row.weight.is_given() { record.number(cell!(row.weight), q::LOAD, problems).map(Some) } else { Some(None) };
    let by = one_of(record, cell!(row.by), Presser::Any, &PRESSERS, problems);
    let latch = one_of(record, cell!(row.stays), Latch::Held, &LATCHES, problems);
    if row.weight.is_given() && by.is_some_and(|by| by != Presser::Any) {
        let found = format!("{} beside a weight", quoted(row.by.as_str()?));
        problems.push(record.problem("by", found, "nothing or any: a plate is pressed by whatever weighs on it"));
        return None;
    }
    Some(Switch { bounds: bounds?, works: works?, weight: weight?, by: by?, latch: latch? })
}

/// `lift !fan`: the names of what is worked, with a `!` before what is on while the switch is off.
fn works(text: &str) -> Result<Vec<Work>, String> {
    let works: Vec<Work> = text
        .split_whitespace()
        .map(|word| Work { name: word.trim_start_matches('!').to_owned(), inverted: word.starts_with('!') })
        .collect();
    let named = works.iter().all(|work| is_name(&work.name));
    let expected = "names with spaces between them, such as: gate !fan";
    if works.is_empty() || works.len() > MOST_WORKS || !named { Err(expected.into()) } else { Ok(works) }
}

fn is_name(text: &str) -> bool {
    text.chars().count() <= 40
        && text.chars().next().is_some_and(char::is_alphabetic)
        && text.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_'))
}

/// What switches call a thing.
pub(super) fn name(record: &Record, cell: Given, problems: &mut Vec<Problem>) -> Option<String> {
    let expected = "a name of letters, digits, - and _ that begins with a letter";
    record.parse(cell, problems, |text| if is_name(text) { Ok(text.to_owned()) } else { Err(expected.into()) })
}

const SIDES: [(&str, Sides); 4] = [
    ("top", Sides::TOP),
    ("bottom", Sides { top: false, bottom: true, ..Sides::TOP }),
    ("left", Sides { top: false, left: true, ..Sides::TOP }),
    ("right", Sides { top: false, right: true, ..Sides::TOP }),
];
const ROUTES: [(&str, Route); 3] = [("back", Route::Back), ("round", Route::Round), ("once", Route::Once)];
const PRESSERS: [(&str, Presser); 4] =
    [("any", Presser::Any), ("ship", Presser::Ship), ("key", Presser::Key), ("object", Presser::Object)];
const LATCHES: [(&str, Latch); 3] = [("held", Latch::Held), ("latched", Latch::Latched), ("toggled", Latch::Toggled)];

/// One of a few words, in any case.
pub(super) fn one_of<T: Copy>(
    record: &Record,
    cell: Given,
    default: T,
    words: &[(&str, T)],
    problems: &mut Vec<Problem>,
) -> Option<T> {
    if !cell.1.is_given() {
        return Some(default);
    }
    record.parse(cell, problems, |text| {
        let found = words.iter().find(|(word, _)| word.eq_ignore_ascii_case(text));
        let all = words.iter().map(|(word, _)| *word);
        found
            .map(|(_, value)| *value)
            .ok_or_else(|| format!("one of {}{}", all.clone().collect::<Vec<_>>().join(", "), meant(text, all)))
    })
}
