//! The facts in a body's details box, read from the world's own state without computing them again. Their wording is elsewhere.
//! Rows of quantities for players, y upwards as in school: the engine and the level's files count y downwards.

use crate::game::{Game, SHIP, body_title, plain_name};
use crate::number::{NOTHING, QuantityScale, fixed};
use crate::physics::{BodyId, DVec2, ForceKind, ForceManager, LinkEnd, Obstacle, Source};
use crate::words::tr;

/// Below this length (N) a force's direction is no more than rounding: the force stays by itself.
const SMALLEST_FORCE: f64 = 1e-9;
/// Two forces of a name with directions closer than this (sine of the angle) are one arrow and one line.
const SAME_DIRECTION: f64 = 1e-6;
/// A resultant below this part of the strongest force reads as none: a body that nears its terminal velocity.
const BALANCED: f64 = 1e-7;

/// Below this part of the largest force (impulse) a resultant has no arrow, and a force (impulse) none in its picture.
pub const NO_PART: f64 = 1e-3;

/// Impacts that together change a body's velocity by less (m/s) are left out: a body at rest has many of them.
const SMALLEST_IMPACT: f64 = 1e-3;
const IMPULSE_UNIT: &str = "N·s";
/// The most impacts with lines and arrows of their own; the smaller ones share one line.
const IMPACTS: usize = 3;

/// The source of the colour of a line or an arrow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ArrowKind {
    Resultant,
    Force(ForceKind),
    Impact,
}

impl ArrowKind {
    pub const fn is_impact(self) -> bool {
        matches!(self, Self::Impact)
    }

    /// Shown to the player.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Resultant => "Resultant",
            Self::Force(kind) => kind.shown(),
            Self::Impact => "Impulse",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Scalar(f64),
    Vector(DVec2),
}

#[derive(Clone, Debug, PartialEq)]
pub struct FactRow {
    pub name: &'static str,
    /// The exerting body in words; empty where there is none, or for a sum.
    pub by: String,
    pub value: Value,
    pub unit: &'static str,
    pub shown: Option<ArrowKind>,
    pub causes: Vec<Source>,
}

impl FactRow {
    pub const fn plain(name: &'static str, value: Value, unit: &'static str) -> Self {
        Self { name, by: String::new(), value, unit, shown: None, causes: Vec::new() }
    }

    /// As in "Normal force by floor".
    pub fn label(&self) -> String {
        let name = tr(self.name);
        if self.by.is_empty() { name.to_owned() } else { tr!("{name} by {body}", name, body = self.by) }
    }

    /// The line's force or impulse, where it has a source.
    pub fn exerted(&self) -> Option<(ArrowKind, DVec2)> {
        match (self.shown, self.value) {
            (Some(shown), Value::Vector(vector)) if !self.causes.is_empty() => Some((shown, vector)),
            _ => None,
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct BodyFacts {
    pub body: BodyId,
    pub title: String,
    pub rows: Vec<FactRow>,
}

pub fn facts(game: &Game, id: BodyId) -> BodyFacts {
    let (world, ship) = (game.world(), id == SHIP);
    let (body, forces) = (world.body(id), world.forces(id));
    let mut rows = Vec::with_capacity(16);
    if ship {
        rows.push(FactRow::plain("Engine", Value::Scalar(game.level().player.thrust), "N"));
        // Along the nose positive, against it negative.
        let drive = forces.total(ForceKind::Drive).length() * if game.ship().burning < 0 { -1.0 } else { 1.0 };
        rows.push(FactRow::plain("Burning", Value::Scalar(drive), "N"));
    }
    rows.push(FactRow::plain("Mass", Value::Scalar(body.mass), "kg"));
    rows.push(FactRow::plain("Velocity", Value::Vector(body.velocity), "m/s"));
    let strongest = forces.forces().iter().map(|force| force.vector.length()).fold(0.0, f64::max);
    let balanced = |vector: DVec2, strongest: f64| if vector.length() < BALANCED * strongest { DVec2::ZERO } else { vector };
    rows.push(FactRow::plain("Acceleration", Value::Vector(balanced(body.acceleration, strongest / body.mass)), "m/s²"));
    let line = |shown: ArrowKind, vector, unit| FactRow {
        shown: Some(shown),
        ..FactRow::plain(shown.name(), Value::Vector(vector), unit)
    };
    rows.push(line(ArrowKind::Resultant, balanced(forces.resultant(), strongest), "N"));
    let exerted = |row: FactRow, causes: Vec<Source>| FactRow { by: by_whom(game, id, &causes), causes, ..row };
    rows.extend(by_name(&forces).into_iter().map(|(kind, force, by)| exerted(line(ArrowKind::Force(kind), force, "N"), by)));
    let (mut count, mut others, least) = (0, DVec2::ZERO, SMALLEST_IMPACT * body.mass);
    for (i, felt) in game.impacts(id).iter().enumerate() {
        if i < IMPACTS + count && felt.impulse.length() >= least {
            rows.push(exerted(line(ArrowKind::Impact, felt.impulse, IMPULSE_UNIT), vec![source(felt.by)]));
        } else {
            (count, others) = (count + 1, others + felt.impulse);
        }
    }
    if count > 0 && others.length() >= least {
        let by = if count == 1 { tr("a lesser one").to_owned() } else { tr!("{count} lesser ones", count) };
        rows.push(FactRow { by, ..line(ArrowKind::Impact, others, IMPULSE_UNIT) });
    }
    BodyFacts { body: id, title: body_title(game.level(), id), rows }
}

const fn source(obstacle: Obstacle) -> Source {
    match obstacle {
        Obstacle::Surface(index) => Source::Surface(index),
        Obstacle::Body(body) => Source::Body(body),
    }
}

/// The body at the other end of a link; `None` where that is a place.
pub fn linked_to(game: &Game, body: BodyId, link: u32) -> Option<BodyId> {
    let def = game.world().links().get(link as usize)?.def();
    match def.to {
        LinkEnd::Body(other) => Some(if def.body == body { other } else { def.body }),
        LinkEnd::Place(_) => None,
    }
}

/// The source of a force or an impact in words: bodies by the titles of their boxes, also at the other end of a link. Several are counted.
pub fn by_whom(game: &Game, on: BodyId, causes: &[Source]) -> String {
    let all = |sort: fn(&Source) -> bool| causes.iter().all(sort);
    match causes {
        [] => String::new(),
        [Source::Body(body)] => body_title(game.level(), *body),
        [Source::Link(link)] => {
            let other = linked_to(game, on, *link).map(|other| body_title(game.level(), other));
            other.unwrap_or_else(|| tr!("anchor {number}", number = link + 1))
        }
        [one] => plain_name(game.level(), *one),
        many if all(|cause| matches!(cause, Source::Body(_))) => tr!("{count} objects", count = many.len()),
        many if all(|cause| matches!(cause, Source::Surface(_))) => tr!("{count} blocks", count = many.len()),
        many if all(|cause| matches!(cause, Source::Stream(_))) => tr!("{count} winds", count = many.len()),
        many if all(|cause| matches!(cause, Source::Fluid(_))) => tr!("{count} liquids", count = many.len()),
        many => tr!("{count} things", count = many.len()),
    }
}

/// The forces by name: the sum, N, and each source once. Those of one name and way are one, opposed ones not: their sum would hide the pressure.
fn by_name(forces: &ForceManager) -> Vec<(ForceKind, DVec2, Vec<Source>)> {
    let mut named: Vec<(ForceKind, DVec2, Vec<Source>)> = Vec::new();
    for kind in ForceKind::ALL {
        let first = named.len();
        for force in forces.forces().iter().filter(|force| force.kind == kind) {
            match named[first..].iter_mut().find(|(_, sum, _)| same_way(*sum, force.vector)) {
                Some((_, sum, by)) => {
                    *sum += force.vector;
                    if !by.contains(&force.source) {
                        by.push(force.source);
                    }
                }
                None => named.push((kind, force.vector, vec![force.source])),
            }
        }
    }
    named
}

fn same_way(a: DVec2, b: DVec2) -> bool {
    let lengths = a.length() * b.length();
    a.length().min(b.length()) < SMALLEST_FORCE || a.dot(b) > 0.0 && a.perp_dot(b).abs() <= SAME_DIRECTION * lengths
}

/// The next number from …, 0.1, 0.2, 0.5, 1, 2, 5, 10, …: the value of one square of the graph paper where arrows are to scale.
pub fn round_up(value: f64) -> f64 {
    // A round number up to rounding counts as round.
    let value = value * (1.0 - 1e-9);
    let mut decade = NOTHING;
    while decade * 10.0 < value {
        decade *= 10.0;
    }
    [1.0, 2.0, 5.0].into_iter().map(|step| step * decade).find(|step| *step >= value).unwrap_or(10.0 * decade)
}

fn largest(row: &FactRow) -> f64 {
    match row.value {
        Value::Scalar(value) => value.abs(),
        Value::Vector(v) => v.abs().max_element(),
    }
}

/// The numbers of a row beside those of other rows, y upwards: each quantity in one unit, so that a column adds up.
fn numbers(row: &FactRow, beside: &[FactRow]) -> (Vec<String>, QuantityScale) {
    let values = match row.value {
        Value::Scalar(value) => vec![value],
        Value::Vector(v) => vec![v.x, -v.y],
    };
    let scale = scale(row, beside);
    (values.into_iter().map(|value| scale.number(value)).collect(), scale)
}

/// The format of a row beside others.
fn scale(row: &FactRow, beside: &[FactRow]) -> QuantityScale {
    let of_all = beside.iter().filter(|other| other.unit == row.unit).map(largest).fold(largest(row), f64::max);
    QuantityScale::of(of_all, row.unit).finer(largest(row))
}

/// Whether all numbers of a row are zeros as written beside those of other rows.
pub fn reads_as_nothing(row: &FactRow, beside: &[FactRow]) -> bool {
    let scale = scale(row, beside);
    largest(row) < scale.one.map_or(0.0, |one| 0.5 * one / 10f64.powi(scale.decimals as i32)).max(NOTHING)
}

/// The rows of a box, each number at least `least` characters wide. Forces are rounded together: each column adds up to its resultant as written.
pub fn quantities(rows: &[FactRow], least: usize) -> Vec<String> {
    let mut all: Vec<(Vec<String>, QuantityScale)> = rows.iter().map(|row| numbers(row, rows)).collect();
    if let Some(resultant) = rows.iter().position(|row| row.shown == Some(ArrowKind::Resultant)) {
        balance(rows, resultant, &mut all);
    }
    let width = all.iter().flat_map(|(numbers, _)| numbers).map(|number| number.chars().count()).fold(least, usize::max);
    all.iter().map(|(numbers, scale)| written(numbers, scale, width)).collect()
}

/// The numbers of a row by itself, each in a field of `width` characters, and the unit.
pub fn quantity(row: &FactRow, width: usize) -> String {
    let (numbers, scale) = numbers(row, &[]);
    written(&numbers, &scale, width)
}

fn written(numbers: &[String], scale: &QuantityScale, width: usize) -> String {
    match numbers {
        [x, y] => format!("({x:>width$}, {y:>width$}) {}", scale.unit()),
        numbers => format!(" {:>width$}  {:width$}  {}", numbers.concat(), "", scale.unit()),
    }
}

/// Writes the forces and their resultant with as many decimals as the finest of them has.
fn balance(rows: &[FactRow], resultant: usize, all: &mut [(Vec<String>, QuantityScale)]) {
    let is_force = |row: &&FactRow| matches!(row.shown, Some(ArrowKind::Force(_) | ArrowKind::Resultant));
    let finest = rows.iter().filter(is_force).filter(|row| !reads_as_nothing(row, rows)).map(|row| scale(row, rows).decimals).max();
    let (Some(one), Some(decimals)) = (all[resultant].1.one, finest) else { return };
    let forces: Vec<usize> = (0..rows.len()).filter(|i| is_force(&&rows[*i]) && *i != resultant).collect();
    let digit = one / 10f64.powi(decimals as i32);
    for axis in 0..2 {
        let value = |row: usize| match rows[row].value {
            Value::Vector(v) => [v.x, -v.y][axis],
            Value::Scalar(_) => 0.0,
        };
        let parts: Vec<(f64, bool)> = forces.iter().map(|row| (value(*row) / digit, reads_as_nothing(&rows[*row], rows))).collect();
        let sum = (value(resultant) / digit).round();
        for (row, count) in forces.iter().copied().chain([resultant]).zip(rounded_to(sum, &parts).into_iter().chain([sum])) {
            if value(row).abs() >= NOTHING {
                all[row].0[axis] = fixed(count * digit / one, decimals);
            }
        }
    }
}

/// Whole numbers with that sum, the nearest to their parts but for the parts farthest from them; a part that reads as zero should stay so.
fn rounded_to(sum: f64, parts: &[(f64, bool)]) -> Vec<f64> {
    let mut counts: Vec<f64> = parts.iter().map(|(part, _)| part.round()).collect();
    let missing = sum - counts.iter().sum::<f64>();
    let step = missing.signum();
    let left = |i: usize| (parts[i].0 - parts[i].0.round()) * step;
    let mut order: Vec<usize> = (0..parts.len()).filter(|i| parts[*i].0 != 0.0).collect();
    order.sort_by(|a, b| {
        let rank = |i: usize| (left(i) <= 0.0, parts[i].1);
        rank(*a).cmp(&rank(*b)).then(left(*b).total_cmp(&left(*a)))
    });
    for i in order.into_iter().take(missing.abs() as usize) {
        counts[i] += step;
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::PREFIXES;
    use crate::physics::{DVec2, ForceKind};
    use proptest::prelude::*;

    #[test]
    fn only_forces_that_point_the_same_way_are_one() {
        assert!(same_way(DVec2::new(0.0, -3.0), DVec2::new(0.0, -5.0)));
        assert!(!same_way(DVec2::new(0.0, -3.0), DVec2::new(0.0, 5.0)));
        assert!(!same_way(DVec2::new(0.0, -3.0), DVec2::new(2.0, 0.0)));
    }

    #[test]
    fn round_numbers_are_one_two_five() {
        for (value, wanted) in [(0.3, 0.5), (0.99, 1.0), (1.1, 2.0), (375.0, 500.0), (501.0, 1000.0), (0.0, 1e-9)] {
            assert!((round_up(value) / wanted - 1.0).abs() < 1e-9, "{value}: {}", round_up(value));
        }
    }

    #[test]
    fn vectors_share_a_unit_and_count_y_upwards() {
        let row = |value, unit| FactRow::plain("", value, unit);
        let texts = [
            (row(Value::Vector(DVec2::new(-12.34, 0.0)), "m/s"), "( −12.3,      0) m/s"),
            (row(Value::Vector(DVec2::new(0.04, 123_456.7)), "N"), "(     0,   −123) kN"),
            // A number that rounds to zero has no sign.
            (row(Value::Vector(DVec2::new(-4.0, -1500.0)), "N"), "(  0.00,   1.50) kN"),
            (row(Value::Scalar(100.0), "kg"), "    100          kg"),
        ];
        for (row, text) in &texts {
            assert_eq!(quantities(std::slice::from_ref(row), 6)[0].trim_end(), *text);
        }
        assert_eq!(quantities(&[texts[0].0.clone()], 3), ["(−12.3,     0) m/s"]);
    }

    #[test]
    fn forces_beside_each_other_share_a_unit_so_that_they_add_up() {
        let row = |x: f64, unit| FactRow::plain("", Value::Vector(DVec2::new(x, 0.0)), unit);
        let rows = [row(1520.0, "N"), row(20.0, "N"), row(-0.004, "N"), row(0.05, "m/s"), row(0.0, "N")];
        let texts = quantities(&rows, 0).into_iter().map(|text| text.replace(' ', "")).collect::<Vec<_>>();
        assert_eq!(texts, ["(1.52,0)kN", "(0.0200,0)kN", "(0.0000,0)kN", "(0.0500,0)m/s", "(0,0)kN"]);
        assert_eq!(rows.each_ref().map(|row| reads_as_nothing(row, &rows)), [false, false, true, false, true]);
    }

    fn forces(each: &[DVec2]) -> Vec<FactRow> {
        let row = |shown, vector| FactRow { shown: Some(shown), ..FactRow::plain("", Value::Vector(vector), "N") };
        let sum = row(ArrowKind::Resultant, each.iter().sum());
        [sum].into_iter().chain(each.iter().map(|force| row(ArrowKind::Force(ForceKind::Push), *force))).collect()
    }

    /// The numbers of a line as written, and its last digit.
    fn read(line: &str) -> [(f64, f64); 2] {
        let inside = line.split(['(', ')']).nth(1).unwrap();
        let number = |text: &str| {
            let decimals = text.trim().split_once('.').map_or(0, |(_, decimals)| decimals.len());
            (text.trim().replace('−', "-").parse().unwrap(), 10f64.powi(-(decimals as i32)))
        };
        let (x, y) = inside.split_once(',').unwrap();
        [number(x), number(y)]
    }

    #[test]
    fn the_lines_of_a_box_add_up_as_they_are_written() {
        let rows = forces(&[DVec2::new(89.44, 0.0), DVec2::new(-71.554, 0.0), DVec2::new(0.0, 50.0), DVec2::new(0.0, -50.0)]);
        let written: Vec<[f64; 2]> = quantities(&rows, 0).iter().map(|line| read(line).map(|number| number.0)).collect();
        assert_eq!(written, [[17.9, 0.0], [89.4, 0.0], [-71.5, 0.0], [0.0, -50.0], [0.0, 50.0]]);
    }

    proptest! {
        #[test]
        fn any_forces_add_up_as_they_are_written_and_zero_stays_zero(
            each in proptest::collection::vec((-1e4..1e4_f64, -5..2_i32, 0..4_u8), 1..9),
            size in -3..6_i32,
            rests: bool,
        ) {
            let force = |(value, power, along): &(f64, i32, u8)| {
                let length = value * 10f64.powi(power + size);
                DVec2::new(if *along == 1 { 0.0 } else { length }, if *along == 2 { 0.0 } else { length * 0.37 })
            };
            let mut each: Vec<DVec2> = each.iter().map(force).collect();
            if rests {
                each.extend(each.clone().iter().rev().map(|force| -*force));
            }
            let mut rows = forces(&each);
            if rests {
                rows[0].value = Value::Vector(DVec2::ZERO);
            }
            let lines = quantities(&rows, 0);
            let unit = lines[0].rsplit_once(' ').unwrap().1;
            let one = PREFIXES.iter().find(|(_, name)| unit == format!("{name}N")).unwrap().0;
            let read: Vec<[(f64, f64); 2]> = lines.iter().map(|line| read(line)).collect();
            for axis in 0..2 {
                let digit = read.iter().map(|row| row[axis].1).fold(1.0, f64::min);
                let count = |row: &[(f64, f64); 2]| (row[axis].0 / digit).round() as i64;
                prop_assert_eq!(count(&read[0]), read[1..].iter().map(count).sum::<i64>(), "{:#?}", lines);
                for (row, line) in rows.iter().zip(&read) {
                    let Value::Vector(v) = row.value else { unreachable!() };
                    let exact = [v.x, -v.y][axis];
                    let off = (line[axis].0 - exact / one).abs();
                    prop_assert!(off <= digit * (1.0 + 1e-6), "{} is {}: {:#?}", line[axis].0, exact, lines);
                    prop_assert!(exact != 0.0 || line[axis].0 == 0.0);
                }
            }
            prop_assert!(!rests || lines[0].replace(' ', "").starts_with("(0,0)"));
        }
    }
}
