//! Quantities for players: three significant digits, a unit with a prefix, a true minus sign, and y upwards as in school. The
//! engine and the level's files count y downwards.

use super::facts::{FactRow, Value};
use crate::lab::axes;
use crate::number::fixed;

/// From the largest.
const PREFIXES: [(f64, &str); 6] = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ")];
/// Masses have a prefix already, and larger ones names of their own.
const MASSES: [(f64, &str); 6] = [(1e9, "Mt"), (1e6, "kt"), (1e3, "t"), (1.0, "kg"), (1e-3, "g"), (1e-6, "mg")];
/// Units: a smaller number is rounding.
pub const NOTHING: f64 = 1e-9;
/// The unit without a prefix serves down to this part of it: 0.5 m/s reads better than 500 mm/s.
const PLAIN_FROM: f64 = 0.1;
/// A number from this share of the next power of ten on counts as that.
const ROUNDS_UP: f64 = 0.9995;

/// The format of a quantity's numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct QuantityScale {
    /// The size of one written unit in plain units; none beyond all prefixes.
    one: Option<f64>,
    decimals: usize,
    unit: String,
}

impl QuantityScale {
    /// `largest` is the largest number of the quantity.
    pub fn of(largest: f64, unit: &str) -> Self {
        let scales = if unit == "kg" { MASSES } else { PREFIXES };
        let size = largest.abs();
        let fits = |(one, _): &&(f64, &str)| size >= one * if *one == 1.0 { PLAIN_FROM } else { 1.0 } * ROUNDS_UP;
        let smallest = scales[scales.len() - 1];
        let (one, name) = if size < NOTHING { (1.0, scales[3].1) } else { *scales.iter().find(fits).unwrap_or(&smallest) };
        let unit = if unit == "kg" { name.to_owned() } else { format!("{name}{unit}") };
        let parts = size / one;
        let decimals = decimals(parts).min(3);
        if parts < 1000.0 * ROUNDS_UP { Self { one: Some(one), decimals, unit } } else { Self { one: None, decimals, unit } }
    }

    /// The same unit for numbers of which this is the largest: three digits of their own, with up to two more places.
    #[must_use]
    pub fn finer(&self, largest: f64) -> Self {
        let own = self.one.filter(|_| largest.abs() >= NOTHING).map_or(self.decimals, |one| decimals(largest.abs() / one));
        Self { decimals: own.clamp(self.decimals, self.decimals + 2), ..self.clone() }
    }

    /// Without its unit.
    pub fn number(&self, value: f64) -> String {
        if value.abs() < NOTHING {
            return "0".to_owned();
        }
        let Some(one) = self.one else { return axes::number(value / PREFIXES[0].0) };
        fixed(value / one, self.decimals)
    }

    /// With its prefix.
    pub fn unit(&self) -> &str {
        &self.unit
    }
}

/// Decimal places that show three digits of a number of units.
fn decimals(parts: f64) -> usize {
    let (mut places, mut least) = (0, 100.0 * ROUNDS_UP);
    while parts < least && places < 9 {
        (places, least) = (places + 1, least / 10.0);
    }
    places
}

/// As in "1.50 kN".
pub fn scalar(value: f64, unit: &str) -> String {
    let scale = QuantityScale::of(value, unit);
    format!("{} {}", scale.number(value), scale.unit())
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
    let least = scale.one.map_or(0.0, |one| 0.5 * one / 10f64.powi(scale.decimals as i32));
    largest(row) < least.max(NOTHING)
}

/// The numbers of a row beside others, each in a field of `width` characters, and the unit.
pub fn quantity(row: &FactRow, beside: &[FactRow], width: usize) -> String {
    let (numbers, scale) = numbers(row, beside);
    match &numbers[..] {
        [x, y] => format!("({x:>width$}, {y:>width$}) {}", scale.unit()),
        numbers => format!(" {:>width$}  {:width$}  {}", numbers.concat(), "", scale.unit()),
    }
}

/// The width of the longest number in the rows, at least `least`, characters.
pub fn number_width(rows: &[FactRow], least: usize) -> usize {
    rows.iter().flat_map(|row| numbers(row, rows).0).map(|number| number.chars().count()).fold(least, usize::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_and_a_prefix_say_any_number() {
        for (value, unit, text) in [
            (1500.0, "N", "1.50 kN"),
            (-731.25, "N", "−731 N"),
            (0.5, "m/s", "0.500 m/s"),
            (0.05, "m/s", "50.0 mm/s"),
            (9.81, "m/s²", "9.81 m/s²"),
            (-0.0, "N", "0 N"),
            (1e-12, "N", "0 N"),
            (2e-7, "N", "0.200 µN"),
            (999.4, "N", "999 N"),
            (999.6, "N", "1.00 kN"),
            (0.09996, "N", "0.100 N"),
            (99.96, "N", "100 N"),
            (100.0, "kg", "100 kg"),
            (1500.0, "kg", "1.50 t"),
            (0.05, "kg", "50.0 g"),
            (4.2e7, "N·s", "42.0 MN·s"),
            (-3e20, "N", "−3.0·10¹¹ GN"),
        ] {
            assert_eq!(scalar(value, unit), text);
        }
    }

    #[test]
    fn round_numbers_are_one_two_five() {
        for (value, wanted) in [(0.3, 0.5), (0.99, 1.0), (1.1, 2.0), (375.0, 500.0), (501.0, 1000.0), (0.0, 1e-9)] {
            assert!((round_up(value) / wanted - 1.0).abs() < 1e-9, "{value}: {}", round_up(value));
        }
    }

    #[test]
    fn vectors_share_a_unit_and_count_y_upwards() {
        use crate::physics::DVec2;
        let row = |value, unit| FactRow::plain("", value, unit);
        let texts = [
            (row(Value::Vector(DVec2::new(-12.34, 0.0)), "m/s"), "( −12.3,      0) m/s"),
            (row(Value::Vector(DVec2::new(0.04, 123_456.7)), "N"), "(     0,   −123) kN"),
            // A number that rounds to zero has no sign.
            (row(Value::Vector(DVec2::new(-4.0, -1500.0)), "N"), "(  0.00,   1.50) kN"),
            (row(Value::Scalar(100.0), "kg"), "    100          kg"),
        ];
        for (row, text) in &texts {
            assert_eq!(quantity(row, &[], 6).trim_end(), *text);
        }
        let all = texts.map(|(row, _)| row);
        assert_eq!(number_width(&all[..1], 3), 5);
    }

    #[test]
    fn forces_beside_each_other_share_a_unit_so_that_they_add_up() {
        use crate::physics::DVec2;
        let row = |x: f64, unit| FactRow::plain("", Value::Vector(DVec2::new(x, 0.0)), unit);
        let rows = [row(1520.0, "N"), row(20.0, "N"), row(-0.004, "N"), row(0.05, "m/s"), row(0.0, "N")];
        let texts = rows.each_ref().map(|row| quantity(row, &rows, 0));
        assert_eq!(texts, ["(1.52, 0) kN", "(0.0200, 0) kN", "(0.0000, 0) kN", "(50.0, 0) mm/s", "(0, 0) kN"]);
        assert_eq!(rows.each_ref().map(|row| reads_as_nothing(row, &rows)), [false, false, true, false, true]);
    }
}
