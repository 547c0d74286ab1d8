//! Readings as pupils write them: a number with either decimal mark, among words and units, held against the quantity that a cell of the
//! sheet wants. docs/teaching.md has the rules.

use super::numerals::{Numeral, NumeralStyle, numerals};
use crate::words::tr;

/// How far a number may be from the right one, as a share of that.
const CLOSE: f64 = 0.05;
/// How far from a right zero, units.
const CLOSE_TO_ZERO: f64 = 0.01;
/// The quantity of a value follows what it is of: `e = 0.5, height`.
const OF: &str = ", ";

/// A quantity with its right value, as in `e = 0.5, height: 2.50 m`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wanted {
    /// What it is of, and the quantity.
    pub what: String,
    value: f64,
    /// Empty for a mere number.
    pub unit: String,
}

impl Wanted {
    /// A value with its unit, and the text that says of what.
    pub fn new(what: &str, value: &str) -> Option<Self> {
        let [Numeral { values, .. }] = &numerals(value, NumeralStyle::default())[..] else { return None };
        let number = value.find(' ').map_or(value, |end| &value[..end]);
        let unit = value[number.len()..].trim().to_owned();
        Some(Self { what: what.to_owned(), value: *values.first()?, unit })
    }

    /// A cell of quantities, parted by `|`.
    pub fn all(cell: &str) -> Option<Vec<Self>> {
        let each = cell.split('|').filter(|part| !part.trim().is_empty());
        each.map(|part| part.trim().rsplit_once(": ").and_then(|(what, value)| Self::new(what, value))).collect()
    }

    /// In the player's language, without its unit.
    pub fn name(&self) -> String {
        self.what.splitn(2, OF).map(tr).collect::<Vec<_>>().join(OF)
    }

    /// Whether a reading is right: each number in it that can be one of this quantity is, and there is one. `None` without any number.
    pub fn judge(&self, text: &str) -> Option<bool> {
        let found = NumeralStyle::ALL.map(|style| numerals(text, style));
        let is_right = |numbers: &Vec<Numeral>| {
            numbers.iter().any(|number| self.is(number)) && numbers.iter().all(|number| self.is(number) || !self.takes(number))
        };
        found.iter().any(|numbers| !numbers.is_empty()).then(|| found.iter().any(is_right))
    }

    /// Whether a number may be one of this quantity: by its unit or, without one, by its sign in formulas. What is worked out is none.
    fn takes(&self, number: &Numeral) -> bool {
        let of_another = number.symbol.is_some() && number.meant.is_none();
        !number.in_formula
            && match (Numeral::dimension(&self.unit), number.unit) {
                (None, Some(_)) => false,
                (Some((dimension, _)), Some((other, _))) => dimension == other,
                (Some((dimension, _)), None) => number.meant.map_or(!of_another, |meant| meant.contains(&dimension)),
                (None, None) => !of_another,
            }
    }

    fn is(&self, number: &Numeral) -> bool {
        let factor = match (Numeral::dimension(&self.unit), number.unit) {
            (Some((dimension, one)), Some((other, of))) if dimension == other => of / one,
            (_, Some(_)) => return false,
            (_, None) => 1.0,
        };
        // The sign of a force or an impulse is a matter of the direction that one counts in.
        let directed = !["N", "N·s"].contains(&self.unit.as_str());
        let within = if self.value == 0.0 { CLOSE_TO_ZERO } else { CLOSE * self.value.abs() };
        number.values.iter().any(|value| {
            let value = value * factor;
            let (value, right) = if directed { (value, self.value) } else { (value.abs(), self.value.abs()) };
            (value - right).abs() <= within
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(value: &str, verdict: Option<bool>, texts: &[&str]) {
        let wanted = Wanted::new("e = 0.5, height", value).unwrap();
        for text in texts {
            assert_eq!(wanted.judge(text), verdict, "{text} for {value}");
        }
    }

    #[test]
    fn right_readings_are_right_however_they_are_written() {
        let right = Some(true);
        check(
            "2.50 m",
            right,
            &[
                "2.5",
                "2,5",
                "2,45 m",
                "250 cm",
                "h = 2.5",
                "h_3=2.5m",
                "about 2.5 metres",
                "2.5.",
                "e = 0.5: 2.5",
                "2.5 m (e = 0.5)",
            ],
        );
        check("2.50 m", right, &["2.5e0 m", "2500 mm", "t = 1.4 s, h = 2.5", "10/4 = 2.5", "2.5 or more", "+2.5"]);
        check("0.392 m", right, &["0,39 m", ",39 m", "39 cm", "392 mm"]);
        check("50.0 N/m", right, &["50", "49,5 N/m", "0.5 N/cm", "k = 50, m = 3", "19.6/0.39 = 50"]);
        check("11.4 m/s", right, &["t=1.2s v=11,8m/s", "41 km/h"]);
        check(
            "2943 N",
            right,
            &["2943 N", "2 943 N", "2'943 N", "2,943 N", "2.943,0 N", "2.943 kN", "2.9·10³ N", "2,9e3 N", "-2943"],
        );
        check("45.0 N", right, &["45", "−45 N"]);
        check("0 m/s²", right, &["0", "0 m/s²", "0.0"]);
        check("−2.00 m/s", right, &["−2 m/s", "-2.0", "-2"]);
        check("2", right, &["2", "2,0", "about 2", "m = 3 kg: 2"]);
    }

    #[test]
    fn wrong_readings_stay_wrong() {
        let wrong = Some(false);
        check(
            "2.50 m",
            wrong,
            &["3.0", "8.1 m (e = 0.9)", "1 2 2.5 3 4", "e = 0.5", "-2.5", "2.5 s", "25 m", "2.5 %", "1.2.3", "2.5 m 2.8 m", "h2 3"],
        );
        check("50.0 N/m", wrong, &["-50", "39 m", "50 N", "10-20", "45-55"]);
        check("2943 N", wrong, &["29.43 N", "3 kN 5 kN 7 kN"]);
        check("−2.00 m/s", wrong, &["2 m/s", "-4 m/s", "0.5 m/s"]);
        check("50.0 N/m", None, &["", "soft", "h1", "m/s²", "x^2"]);
    }

    #[test]
    fn a_cell_of_quantities_is_read_and_named() {
        let wanted = Wanted::all("e = 0.9, height: 8.10 m|period: 2 s").unwrap();
        assert_eq!(
            wanted.iter().map(|one| (one.name(), one.unit.as_str())).collect::<Vec<_>>()[..],
            [("e = 0.9, height".to_owned(), "m"), ("period".to_owned(), "s")]
        );
        assert_eq!((Wanted::all("height 2"), Wanted::all("height: m"), Wanted::all("a: 1 m 2 m")), (None, None, None));
    }
}
