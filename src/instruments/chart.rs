//! Several curves in one picture: one axis to the right, and a lane upwards for each unit, so that metres and metres a second never share an axis;
//! the screen and the exported picture draw the same. Curves for a file: a table with every tick and every digit, and the sheet of a picture.

use super::curve::{Curve, Extremes, around};
use super::quantity::{Quantity, Unit};
use super::{fit::Fit, track::BodyTrack};
use crate::draw::chart::{CurveLook, CurveOrigin, Linear, Marker, Piece, Sheet, Strip};
use crate::{files::csv_line, number::Shortest, physics::ForceKind};
use std::ops::Range;

/// s.
pub type TimeWindow = (f64, f64);

#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    pub across: Quantity,
    pub axis: Linear,
    /// From the top.
    pub lanes: Vec<ChartLane>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct ChartLane {
    pub unit: Unit,
    pub axis: Linear,
    /// As in [`ChartMember`].
    pub curves: Vec<usize>,
}

/// A curve with its number and its points in the window. Several may share a number: a curve of the run before has its successor's.
pub type ChartMember<'a> = (usize, &'a Curve, Range<usize>);

impl Chart {
    pub fn of(across: Quantity, window: TimeWindow, members: &[ChartMember]) -> Self {
        let mut found: Option<Extremes> = None;
        let mut lanes: Vec<(Unit, Option<Extremes>, Vec<usize>)> = Vec::new();
        for (number, curve, places) in members {
            let unit = curve.up.unit();
            let lane = lanes.iter().position(|(of, ..)| *of == unit).unwrap_or_else(|| {
                lanes.push((unit, None, Vec::new()));
                lanes.len() - 1
            });
            let (_, heights, numbers) = &mut lanes[lane];
            if !numbers.contains(number) {
                numbers.push(*number);
            }
            if let Some((widths, own)) = curve.extremes(places.clone()) {
                found = Some(found.map_or(widths, |found| around(found, widths)));
                *heights = Some(heights.map_or(own, |heights| around(heights, own)));
            }
        }
        let spread =
            |found: Option<Extremes>| found.map_or_else(|| Linear::between(-1.0, 1.0), |(least, most)| Linear::around(least, most));
        let axis = if across == Quantity::Time { Linear::between(window.0, window.1) } else { spread(found) };
        let lane = |(unit, heights, curves)| ChartLane { unit, axis: spread(heights), curves };
        Self { across, axis, lanes: lanes.into_iter().map(lane).collect() }
    }

    pub fn lane_of(&self, number: usize) -> Option<usize> {
        self.lanes.iter().position(|lane| lane.curves.contains(&number))
    }
}

impl ChartLane {
    /// The label of its axis: the symbols of its curves, and the unit.
    pub fn name(&self, symbol: impl Fn(usize) -> String) -> String {
        let mut symbols: Vec<String> = Vec::new();
        for symbol in self.curves.iter().map(|number| symbol(*number)) {
            if !symbols.contains(&symbol) {
                symbols.push(symbol);
            }
        }
        format!("{} ({})", symbols.join(", "), self.unit.name())
    }
}

pub const RESULTANT: u32 = 0xFFFFFF;
/// By the curve's number: none of them is the colour of a force.
const COLOURS: [u32; 4] = [0x7FA7FF, 0xF28DB2, 0x9AD14B, 0xE6EBF2];

/// As 0xRRGGBB.
pub const fn force(kind: ForceKind) -> u32 {
    match kind {
        ForceKind::Weight => 0xB79CED,
        ForceKind::Drive => 0xFF9F1C,
        ForceKind::Reaction => 0x56B4E9,
        ForceKind::Friction => 0xD55E00,
        ForceKind::AirResistance => 0x8FD3FF,
        ForceKind::Wind => 0xDCE6F5,
        ForceKind::Buoyancy => 0x009E73,
        ForceKind::ViscousDrag => 0xA3A847,
        ForceKind::Push => 0xF0E442,
        ForceKind::Spring => 0xCC79A7,
        ForceKind::Tension => 0xE8A0C8,
        ForceKind::Magnetic => 0xF2545B,
    }
}

pub fn curve_look(number: usize, up: Quantity) -> CurveLook {
    let colour = match up {
        Quantity::Force(kind, _) => force(kind),
        Quantity::Resultant(_) => RESULTANT,
        _ => COLOURS[number % COLOURS.len()],
    };
    // Dash and marker are the Lab's.
    CurveLook { colour, ..CurveLook::of(number, CurveOrigin::Lab) }
}

/// Labels of an upright axis over the whole height, about.
const NAMED: usize = 8;
/// Columns of points in a picture: two a pixel.
const COLUMNS: f64 = 1300.0;
/// Characters of the level's name and of the curves' in a file's name.
const NAME: usize = 40;

#[derive(Clone, Copy)]
pub struct Exported<'a> {
    pub body: &'a str,
    pub curve: &'a Curve,
    pub track: &'a BodyTrack,
    /// Its number, which gives its look.
    pub number: usize,
    pub fit: Option<&'a Fit>,
}

impl Exported<'_> {
    fn look(&self) -> CurveLook {
        curve_look(self.number, self.curve.up)
    }

    fn label(&self) -> String {
        format!("{} {}", self.body, self.curve.up.symbol())
    }
}

/// A table: tick, time, and each quantity of each body, in SI with y upwards, as numbers that read back the same; empty where a body was not read.
pub fn csv(curves: &[Exported]) -> String {
    let mut columns: Vec<(String, &[f64])> = Vec::new();
    for Exported { body, curve, .. } in curves {
        for (quantity, values) in curve.columns() {
            let heading = format!("{body} {}", quantity.column());
            if quantity != Quantity::Time && !columns.iter().any(|(other, _)| *other == heading) {
                columns.push((heading, values));
            }
        }
    }
    let track = curves.iter().map(|curve| curve.track).max_by_key(|track| track.len());
    let cell = |value: &f64| Shortest(*value).to_string();
    let head = ["tick".to_owned(), Quantity::Time.heading()].into_iter().chain(columns.iter().map(|(heading, _)| heading.clone()));
    let row = |(track, place): (&BodyTrack, usize)| {
        let cells = columns.iter().map(|(_, values)| values.get(place).map_or_else(String::new, cell));
        csv_line([track.tick_of(place).to_string(), cell(&track.time(place))].into_iter().chain(cells))
    };
    let rows = track.into_iter().flat_map(|track| (0..track.len()).map(move |place| (track, place)));
    csv_line(head) + &rows.map(row).collect::<String>()
}

pub fn sheet(window: TimeWindow, curves: &[Exported]) -> Sheet {
    let across = curves.first().map_or(Quantity::Time, |exported| exported.curve.across);
    let places = |track: &BodyTrack| track.places(window);
    let chart = Chart::of(across, window, &curves.iter().map(|it| (it.number, it.curve, places(it.track))).collect::<Vec<_>>());
    let of_number = |number: usize| curves.iter().find(|exported| exported.number == number);
    let lane = |lane: &ChartLane| {
        let shown: Vec<&Exported> = lane.curves.iter().filter_map(|number| of_number(*number)).collect();
        let grain = ((chart.axis.to - chart.axis.from) / COLUMNS, (lane.axis.to - lane.axis.from) / COLUMNS);
        let ways = shown.iter().flat_map(|exported| {
            let mut ways = exported.curve.drawn(places(exported.track), grain);
            ways.iter_mut().flatten().for_each(|(_, up)| *up = lane.axis.part(*up));
            let longest = (0..ways.len()).max_by_key(|way| ways[*way].len());
            let marker = move |way: usize, points: &[(f64, f64)]| (Some(way) == longest).then_some(points.len() / 2);
            let look = exported.look();
            let ways = ways.into_iter().enumerate();
            ways.map(move |(i, points)| Piece { look, marker: marker(i, &points), points }).collect::<Vec<_>>()
        });
        let named = lane.axis.named(NAMED / chart.lanes.len().max(1)).into_iter();
        Strip {
            name: lane.name(|number| of_number(number).map_or_else(String::new, |exported| exported.curve.up.symbol())),
            named: named.map(|(value, name)| (lane.axis.part(value), name)).collect(),
            marks: impacts(&shown, across, window),
            curves: ways.chain(shown.iter().filter_map(|exported| Some(fitted(exported.fit?, &lane.axis)))).collect(),
        }
    };
    let mut notes = vec!["SI units, y upwards.".to_owned(), "Dotted upright: an impact.".to_owned()];
    for exported in curves {
        let words = exported.fit.map(|fit| fit.words(exported.curve.up, across)).unwrap_or_default();
        notes.extend(words.split("; ").filter(|part| !part.is_empty()).map(str::to_owned));
    }
    Sheet {
        notes,
        across: chart.axis,
        across_name: across.heading(),
        strips: chart.lanes.iter().map(lane).collect(),
        legend: curves.iter().map(|exported| (exported.label(), exported.look())).collect(),
    }
}

fn fitted(fit: &Fit, up: &Linear) -> Piece {
    let look = CurveLook { colour: RESULTANT, width: 1, dash: Some((8, 4)), marker: Marker::Square };
    Piece { look, points: fit.drawn().map(|(x, y)| (x, up.part(y))).collect(), marker: None }
}

/// The times of impacts, s; over anything but time they are the curve's breaks.
fn impacts(shown: &[&Exported], across: Quantity, window: TimeWindow) -> Vec<f64> {
    let times = shown.iter().flat_map(|exported| exported.track.impacts.iter().map(|place| exported.track.time(*place)));
    let mut times: Vec<f64> = times.filter(|time| across == Quantity::Time && *time >= window.0 && *time <= window.1).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// The name of these curves' files, without number and ending: the level and the quantities, in letters that every system takes.
pub fn stem(level: &str, curves: &[Exported]) -> String {
    let plain =
        |text: &str| -> String { text.chars().map(|c| if c.is_alphanumeric() || c == '_' { c } else { '-' }).take(NAME).collect() };
    let mut symbols: Vec<String> = curves.iter().map(|exported| exported.curve.up.stem().replace('|', "")).collect();
    symbols.dedup();
    format!("{}-{}", plain(level), plain(&symbols.join("-")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Controls;
    use crate::instruments::curve::fixture::{curve, flown};
    use crate::instruments::quantity::VectorPart;

    fn track(ticks: u64) -> BodyTrack {
        flown(ticks, |tick| Controls { thrust: tick < 60, right: tick % 7 == 0, ..Controls::default() })
    }

    #[test]
    fn every_cell_of_a_table_reads_back_bit_for_bit_and_no_column_is_there_twice() {
        let (long, short) = (track(300), track(100));
        let curves = [Quantity::Velocity(VectorPart::X), Quantity::Kinetic, Quantity::X].map(|up| curve(&long, Quantity::X, up));
        let other = curve(&short, Quantity::X, Quantity::Y);
        let mut exported: Vec<Exported> = curves
            .iter()
            .enumerate()
            .map(|(number, curve)| Exported { body: "Ship", curve, track: &long, number, fit: None })
            .collect();
        exported.push(Exported { body: "Box, 1", curve: &other, track: &short, number: 3, fit: None });
        let text = csv(&exported);
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let head: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
        let heads = ["tick", "t (s)", "Ship x (m)", "Ship v_x (m/s)", "Ship E_kin (J)", "Box, 1 x (m)", "Box, 1 y (m)"];
        assert_eq!(head, heads);
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 301);
        for (place, row) in rows.iter().enumerate() {
            let moment = long.moment(place);
            let ours = [Quantity::Time, Quantity::X, Quantity::Velocity(VectorPart::X), Quantity::Kinetic]
                .map(|quantity| quantity.of(&moment));
            assert_eq!(row[0].parse::<usize>().unwrap(), place);
            for (cell, value) in row.iter().skip(1).zip(ours) {
                assert_eq!(cell.parse::<f64>().unwrap().to_bits(), value.to_bits(), "{cell}");
            }
            assert_eq!(row[6].is_empty(), place > 100, "not read so far");
        }
    }

    #[test]
    fn names_of_files_are_words() {
        let track = track(1);
        let curve = curve(&track, Quantity::Time, Quantity::Velocity(VectorPart::Size));
        let exported = [Exported { body: "Ship", curve: &curve, track: &track, number: 0, fit: None }];
        for (level, name) in
            [("1", "1-v"), ("../../etc", "------etc-v"), ("a:b\\c", "a-b-c-v"), ("höhle 2", "höhle-2-v"), ("con", "con-v")]
        {
            assert_eq!(stem(level, &exported), name);
        }
        assert!(stem(&"x".repeat(500), &exported).len() < 100);
    }
}
