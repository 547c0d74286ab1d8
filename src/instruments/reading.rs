//! Readings as pupils write them: numbers with either decimal mark, among units, labels and words, held against the quantities that a
//! sheet wants. docs/teaching.md has the rules.

use super::numerals::{Numeral, NumeralStyle, numerals};
use crate::words::tr;
use std::ops::Range;

/// How far a number may be from the right one, as a share of that.
const CLOSE: f64 = 0.05;
/// How far from a right zero, units.
const CLOSE_TO_ZERO: f64 = 0.01;
/// The quantity of a value follows what it is of: `e = 0.5, height`.
const OF: &str = ", ";

/// A quantity with its right value, as in `e = 0.5, height: 2.50 m`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wanted {
    what: String,
    value: f64,
    /// Empty for a mere number.
    unit: String,
    /// The numbers in `what`.
    conditions: Vec<Numeral>,
}

/// What stands in a reading, in order.
#[derive(Clone, Debug)]
enum LinePart {
    /// It names some of the wanted quantities, by their indices.
    Label(Vec<usize>),
    Reading(Numeral),
}

impl Wanted {
    /// A value with its unit, and the text that says of what, whose numbers may be repeated.
    pub fn new(what: &str, value: &str) -> Option<Self> {
        let plain = NumeralStyle::default();
        let [Numeral { values, .. }] = &numerals(value, plain)[..] else { return None };
        let number = value.find(' ').map_or(value, |end| &value[..end]);
        let unit = value[number.len()..].trim().to_owned();
        Some(Self { what: what.to_owned(), value: *values.first()?, unit, conditions: numerals(what, plain) })
    }

    /// A cell of quantities, parted by `|`.
    pub fn all(cell: &str) -> Option<Vec<Self>> {
        let each = cell.split('|').filter(|part| !part.trim().is_empty());
        each.map(|part| part.trim().rsplit_once(": ").and_then(|(what, value)| Self::new(what, value))).collect()
    }

    /// What it is of, and the quantity with its unit, in the player's language.
    fn names(&self) -> (String, String) {
        let (of, quantity) = self.what.split_once(OF).unwrap_or(("", &self.what));
        let unit = if self.unit.is_empty() { String::new() } else { format!(" ({})", self.unit) };
        (tr(of).to_owned(), format!("{}{unit}", tr(quantity)))
    }

    /// Whether a number may be one of this quantity, by its unit or, without one, by its sign in formulas.
    fn takes(&self, number: &Numeral) -> bool {
        let own = Numeral::dimension(&self.unit);
        match (own, number.unit) {
            (None, _) => true,
            (Some((dimension, _)), Some((other, _))) => dimension == other,
            (Some((dimension, _)), None) => number.meant.is_none_or(|meant| meant.contains(&dimension)),
        }
    }

    fn is(&self, number: &Numeral) -> bool {
        let factor = match (Numeral::dimension(&self.unit), number.unit) {
            (Some((_, one)), Some((_, other))) => other / one,
            _ => 1.0,
        };
        // The sign of a force or an impulse is a matter of the direction that one counts in.
        let directed = !["N", "N·s"].contains(&self.unit.as_str());
        let within = if self.value == 0.0 { CLOSE_TO_ZERO } else { CLOSE * self.value.abs() };
        self.takes(number)
            && number.values.iter().any(|value| {
                let value = value * factor;
                let (value, right) = if directed { (value, self.value) } else { (value.abs(), self.value.abs()) };
                (value - right).abs() <= within
            })
    }
}

/// The wanted quantities in words: those of the same things together.
pub fn named(wanted: &[Wanted]) -> String {
    let mut quantities: Vec<(String, Vec<String>)> = Vec::new();
    for (of, quantity) in wanted.iter().map(Wanted::names) {
        match quantities.iter_mut().find(|(other, _)| *other == quantity) {
            Some((_, all)) => all.push(of),
            None => quantities.push((quantity, vec![of])),
        }
    }
    let mut groups: Vec<(Vec<String>, Vec<String>)> = Vec::new();
    for (quantity, of) in quantities {
        match groups.iter_mut().find(|(_, all)| *all == of) {
            Some((quantities, _)) => quantities.push(quantity),
            None => groups.push((vec![quantity], of)),
        }
    }
    let words = groups.iter().map(|(quantities, of)| {
        let of = of.join(OF);
        format!("{}{}{of}", quantities.join(OF), if of.is_empty() { "" } else { ": " })
    });
    words.collect::<Vec<_>>().join("; ")
}

/// Whether a reading is right: each number that can be one of the wanted quantities is, and there is one. `None` without any number.
pub fn judge(text: &str, wanted: &[Wanted]) -> Option<bool> {
    let found = NumeralStyle::ALL.map(|style| numerals(text, style));
    if found.iter().all(Vec::is_empty) || wanted.is_empty() {
        return None;
    }
    Some(found.into_iter().any(|numbers| is_right(text, &numbers, wanted)))
}

fn is_right(text: &str, numbers: &[Numeral], wanted: &[Wanted]) -> bool {
    let mut parts = phrases(text, wanted);
    let mut right = false;
    for (i, number) in numbers.iter().enumerate() {
        let names: Vec<usize> = (0..wanted.len()).filter(|q| wanted[*q].conditions.iter().any(|c| number.repeats(c))).collect();
        let is_reading = |number: &Numeral| wanted.iter().any(|quantity| quantity.is(number));
        let next = numbers.get(i + 1).filter(|next| !next.is_label());
        if !names.is_empty() {
            right |= number.unit.is_some() && number.symbol.is_none() && is_reading(number);
            parts.push((number.at.clone(), LinePart::Label(names)));
        } else if number.in_formula
            || number.is_label() && next.is_some()
            || number.could_repeat(wanted.iter().flat_map(|q| &q.conditions))
        {
            right |= is_reading(number);
        } else if wanted.iter().any(|quantity| quantity.takes(number)) {
            parts.push((number.at.clone(), LinePart::Reading(number.clone())));
        }
    }
    parts.sort_by_key(|(at, _)| at.start);
    let mut parts: Vec<LinePart> = parts.into_iter().map(|(_, part)| part).collect();
    // A label stands before its readings, or behind each.
    if matches!(parts.first(), Some(LinePart::Reading(_))) {
        parts.reverse();
    }
    let readings = parts.iter().filter(|part| matches!(part, LinePart::Reading(_))).count();
    (right || readings > 0) && agree(&parts, wanted)
}

/// Whether each reading is one of the quantities that the labels before it name; as many readings as there are such quantities.
fn agree(parts: &[LinePart], wanted: &[Wanted]) -> bool {
    let (mut named, mut left, mut run): (Vec<usize>, usize, bool) = (Vec::new(), 0, false);
    for part in parts {
        match part {
            LinePart::Label(names) => {
                let both: Vec<usize> = named.iter().copied().filter(|quantity| names.contains(quantity)).collect();
                named = match (run, both.is_empty()) {
                    (true, true) => [named.as_slice(), names].concat(),
                    (true, false) => both,
                    (false, _) => names.clone(),
                };
                (left, run) = (named.len(), true);
            }
            LinePart::Reading(number) => {
                let own: Vec<usize> =
                    named.iter().copied().filter(|quantity| left > 0 && wanted[*quantity].takes(number)).collect();
                let fits = |quantity: &Wanted| quantity.is(number);
                let right =
                    if own.is_empty() { wanted.iter().any(fits) } else { own.iter().any(|quantity| fits(&wanted[*quantity])) };
                if !right {
                    return false;
                }
                (left, run) = (left.saturating_sub(1), false);
            }
        }
    }
    true
}

/// Where a reading says in words, without a number, what some quantities are of.
fn phrases(text: &str, wanted: &[Wanted]) -> Vec<(Range<usize>, LinePart)> {
    let lower = text.to_lowercase();
    let mut found: Vec<(Range<usize>, Vec<usize>)> = Vec::new();
    for (i, quantity) in wanted.iter().enumerate() {
        let Some((of, _)) = quantity.what.split_once(OF) else { continue };
        let spellings = if of.contains(|c: char| c.is_ascii_digit()) { Vec::new() } else { vec![of, tr(of)] };
        for spelling in spellings.into_iter().map(str::to_lowercase) {
            for at in lower.match_indices(&spelling).map(|(start, _)| start..start + spelling.len()) {
                let letter = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
                if letter(lower[..at.start].chars().next_back()) || letter(lower[at.end..].chars().next()) {
                    continue;
                }
                match found.iter_mut().find(|(other, _)| *other == at) {
                    Some((_, names)) if !names.contains(&i) => names.push(i),
                    Some(_) => {}
                    None => found.push((at, vec![i])),
                }
            }
        }
    }
    found.into_iter().map(|(at, names)| (at, LinePart::Label(names))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNCE: &str = "e = 0.9, height: 8.10 m|e = 0.9, energy: 81.0 %|e = 0.7, height: 4.90 m|e = 0.7, energy: 49.0 %|\
                          e = 0.5, height: 2.50 m|e = 0.5, energy: 25.0 %";
    const HOOKE: &str = "2 kg at rest, stretch: 0.392 m|4 kg at rest, stretch: 0.785 m|soft spring, force for each metre: 50.0 N/m|\
                         hard spring, force for each metre: 100 N/m";
    const FALL: &str = "1 kg, terminal speed: 5.71 m/s|4 kg, terminal speed: 11.4 m/s|4 kg, distance after 5 s: 47.9 m";
    const WATER: &str = "300 kg, depth: 0.300 m|300 kg, buoyancy: 2943 N|500 kg, depth: 0.500 m|500 kg, buoyancy: 4905 N";
    const ROW: &str = "crate 1, push: 100 N|crate 2, push: 80.0 N|crate 3, push: 60.0 N";
    const FANS: &str = "45 N, friction: 45.0 N|55 N, friction: 39.2 N|55 N, acceleration: 1.58 m/s²";
    const FLOORS: &str = "steel, friction: 19.6 N|wood, friction: 39.2 N|asphalt, friction: 60.0 N|asphalt, acceleration: 0 m/s²";
    const LIFT: &str = "standing, normal force: 392 N|starting, normal force: 472 N|at 4 m/s, normal force: 392 N";
    const SHOVE: &str = "5 kg, acceleration: 4.00 m/s²|10 kg, acceleration: 2.00 m/s²|20 kg, acceleration: 1.00 m/s²|\
                         5 kg, distance after 3 s: 18.0 m";
    const CRASH: &str = "e = 1, 2 kg after it: −2.00 m/s|e = 1, 4 kg after it: 4.00 m/s|e = 0.5, 2 kg after it: 0 m/s";

    fn check(cell: &str, verdict: Option<bool>, texts: &[&str]) {
        let wanted = Wanted::all(cell).unwrap();
        for text in texts {
            assert_eq!(judge(text, &wanted), verdict, "{text}");
        }
    }

    #[test]
    fn right_readings_are_right_however_they_are_written() {
        let right = Some(true);
        check(
            BOUNCE,
            right,
            &[
                "8.1 4.9 2.5",
                "2.5 4.9 8.1",
                "8,10; 4,90; 2,45",
                "8,1 4,9 2,5",
                "8.1,4.9,2.5",
                "8,1/4,9/2,5",
                "8,1,4,9,2,5",
                "e = 0.5: 2.5",
                "e=0,5: 2,5 m",
                "2.5 m (e = 0.5), 4.9 m (e = 0.7)",
                "e = 0.9 8.1 m 81 % e = 0.7 4.9 m 49 %",
                "0.9: 8.1, 0.7: 4.9, 0.5: 2.5",
                "0.9 8.1\n0.7 4.9",
                "h1 = 8.1 m, h2 = 490 cm, h_3=2.5m",
                "1. 8.1 2. 4.9 3. 2.5",
                "1) 8.1 2) 4.9 3) 2.5",
                "about 2.5 metres",
                "2.5.",
                "t = 1.4 s, h = 8.1",
                "8.1–4.9–2.5",
                "8.1e0 m",
                "8100 mm",
            ],
        );
        check(
            HOOKE,
            right,
            &[
                "0,39 m",
                ",39 m",
                "50",
                "49,5 N/m and 100",
                "50 or more",
                "2 kg: 0,39; 4 kg: 0,79; 50 N/m; 100 N/m",
                "19.6/0.39 = 50",
            ],
        );
        check(HOOKE, right, &["soft spring 50 N/m, hard spring 100 N/m", "0.5 N/cm", "k = 50, m = 3"]);
        check(FALL, right, &["t=1.2s v=11,8m/s", "t=3 v=11.4", "1 kg 5.7 m/s; 4 kg 11.4 m/s, 48 m after 5 s", "41 km/h"]);
        check(
            WATER,
            right,
            &["2943 N", "2 943 N", "2'943 N", "2,943 N", "2.943,0 N", "2.943 kN", "2.9·10³ N", "2,9e3 N", "0,3 0,5 2943 4905"],
        );
        check(WATER, right, &["300 kg: 30 cm, 2\u{202f}943 N; 500 kg: 50 cm"]);
        check(
            ROW,
            right,
            &[
                "100 80 60",
                "100, 80, 60",
                "crate 1: 100, crate 2: 80",
                "1: 100 2: 80 3: 60",
                "1 100 2 80",
                "100 N 80 N 60 N",
                "-100 N",
            ],
        );
        check(FANS, right, &["45 N: 45 N; 55 N: 39.2 N", "45 39.2 1.58"]);
        check(
            FLOORS,
            right,
            &["steel 19.6, wood 39.2, asphalt 60", "19.6 N on steel, 39.2 N on wood", "−19.6 N", "60 N and 0 m/s²"],
        );
        check(LIFT, right, &["392 472 392", "392,472,392", "starting: 472 N", "at 4 m/s: 392 N"]);
        check(
            SHOVE,
            right,
            &[
                "4 2 1",
                "4,2,1",
                "5 kg, 10 kg and 20 kg: 4, 2, 1",
                "with 20 N: 4 m/s²",
                "2 m/s² for 10 kg and 4 for 5 kg",
                "a = 4 m/s^2, 18 m after 3 s",
            ],
        );
        check(CRASH, right, &["−2 m/s and 4 m/s", "- 4.0", "e = 1: -2 m/s, 4 m/s; e = 0.5: 0 m/s", "e = 1, 2 kg: −2"]);
    }

    #[test]
    fn wrong_readings_stay_wrong() {
        let wrong = Some(false);
        check(
            BOUNCE,
            wrong,
            &[
                "8.6 5.4 3.0",
                "8.1 4.9 3.5",
                "1 2 2.5 3 4",
                "1: 2: 2.5: 3:",
                "8.1/4.9/3.5",
                "e = 0.5: 8.1",
                "8.1 m (e = 0.5)",
                "e = 0.5",
                "0.5",
                "-2.5",
                "2.5 s",
                "25 m",
                "2.5 %",
                "10 m",
                "1.2.3",
                "2.5 m 2.8 m",
                "h2 3",
            ],
        );
        check(HOOKE, wrong, &["-50", "0.5 0.39", "39 m", "50 N", "10-20", "45-55", "soft spring 100 N/m", "2 kg: 0.785 m"]);
        check(WATER, wrong, &["29.43 N", "3 kN 5 kN 7 kN", "300 kg: 0.5 m"]);
        check(FLOORS, wrong, &["steel 60, wood 39.2, asphalt 19.6", "0.5 m/s²"]);
        check(LIFT, wrong, &["starting 392 N", "at 4 m/s: 472 N", "392 500"]);
        check(CRASH, wrong, &["2 m/s", "-4 m/s", "0.5 m/s"]);
        check(SHOVE, wrong, &["1.4", "5 kg: 2, 10 kg: 4"]);
        check(HOOKE, None, &["", "soft", "h1", "m/s²", "x^2"]);
    }

    #[test]
    fn the_wanted_quantities_are_named_with_their_units() {
        let named = |cell| named(&Wanted::all(cell).unwrap());
        assert_eq!(named(BOUNCE), "height (m), energy (%): e = 0.9, e = 0.7, e = 0.5");
        assert_eq!(named(HOOKE), "stretch (m): 2 kg at rest, 4 kg at rest; force for each metre (N/m): soft spring, hard spring");
        assert_eq!(named("period: 2 s"), "period (s)");
        assert_eq!(named(""), "");
        assert_eq!((Wanted::all("height 2"), Wanted::all("height: m"), Wanted::all("a: 1 m 2 m")), (None, None, None));
    }
}
