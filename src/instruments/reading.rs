//! The numbers in a text, with what stands beside them: a unit behind, a sign of a formula before. Readings as pupils write them: a number with
//! either decimal mark, among words and units, held against the quantity that a cell of the sheet wants. docs/teaching.md has the rules.

use crate::words::tr;
use std::ops::Range;

/// Where two ways of reading digits are possible.
#[derive(Clone, Copy, Debug, Default)]
pub struct NumeralStyle {
    /// `2 943` is one number.
    joined: bool,
    /// `1,234,567` is one number, not three.
    grouped: bool,
    /// `8,1,4,9` is two numbers, not four.
    paired: bool,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Numeral {
    /// `2.943` is either of two numbers.
    pub values: Vec<f64>,
    /// The dimension by its unit in SI, and how many of those one is.
    pub unit: Option<(&'static str, f64)>,
    /// What stands before an equals sign, as `e` in `e = 0.5`.
    pub symbol: Option<String>,
    /// The units in SI of what that sign usually means.
    pub meant: Option<&'static [&'static str]>,
    /// Part of a sum that is worked out: `19.6/0.392 =`.
    pub in_formula: bool,
    /// Bytes of the text.
    pub at: Range<usize>,
}

/// Units in SI, the factor, and how they are written.
const UNITS: [(&str, f64, &str); 35] = [
    ("m/s", 1.0 / 3.6, "km/h"),
    ("m/s", 0.01, "cm/s"),
    ("m/s", 0.001, "mm/s"),
    ("m/s", 1000.0, "km/s"),
    ("m/s", 1.0, "m/s"),
    ("m/s²", 0.01, "cm/s²"),
    ("m/s²", 1.0, "m/s², m/s^2, m/s2, m/s/s, N/kg"),
    ("N/m", 1000.0, "kN/m, N/mm"),
    ("N/m", 100.0, "N/cm"),
    ("N/m", 1.0, "N/m"),
    ("N·s", 1000.0, "kN·s"),
    ("N·s", 1.0, "N·s, N*s, N s, Ns, kg·m/s, kg*m/s, kg m/s"),
    ("kg/m³", 1.0, "kg/m³"),
    ("N", 1.0, "newtons, newton, N"),
    ("N", 1000.0, "kN"),
    ("N", 0.001, "mN"),
    ("J", 1.0, "joules, joule, J"),
    ("J", 1000.0, "kJ"),
    ("J", 0.001, "mJ"),
    ("kg", 1.0, "kg"),
    ("kg", 0.001, "g"),
    ("kg", 1000.0, "t"),
    ("m", 1.0, "meters, metres, meter, metre, mètres, mètre, m"),
    ("m", 1000.0, "km"),
    ("m", 0.1, "dm"),
    ("m", 0.01, "cm"),
    ("m", 0.001, "mm"),
    ("m³", 1.0, "m³"),
    ("m²", 1.0, "m²"),
    ("s", 60.0, "min"),
    ("s", 0.001, "ms"),
    ("s", 1.0, "seconds, sekunden, secondes, second, sek, sec, s"),
    ("%", 1.0, "%"),
    ("°", 1.0, "°"),
    ("Hz", 1.0, "Hz"),
];

fn units() -> impl Iterator<Item = (&'static str, &'static str, f64)> {
    UNITS.iter().flat_map(|(dimension, factor, names)| names.split(", ").map(|name| (name, *dimension, *factor)))
}

/// Signs in formulas, and the units in SI of what they may mean.
const SYMBOLS: [(&str, &[&str]); 13] = [
    ("t", &["s"]),
    ("T", &["s"]),
    ("v", &["m/s"]),
    ("a", &["m/s²"]),
    ("g", &["m/s²"]),
    ("F", &["N"]),
    ("m", &["kg"]),
    ("h", &["m"]),
    ("s", &["m", "s"]),
    ("E", &["J", "%"]),
    ("p", &["N·s"]),
    ("k", &["N/m"]),
    ("D", &["N/m"]),
];

/// Spaces that stand within a number.
const THIN: [char; 4] = ['\u{a0}', '\u{202f}', '\u{2009}', '\u{2007}'];
const MINUS: [char; 6] = ['-', '−', '‐', '‑', '–', '﹣'];

impl NumeralStyle {
    pub fn all() -> [Self; 8] {
        std::array::from_fn(|i| Self { joined: i & 1 > 0, grouped: i & 2 > 0, paired: i & 4 > 0 })
    }
}

impl Numeral {
    /// The dimension of a unit and its factor; `None` for none.
    pub fn dimension(unit: &str) -> Option<(&'static str, f64)> {
        units().find(|(name, ..)| *name == unit).map(|(_, dimension, factor)| (dimension, factor))
    }
}

/// All numbers in a text. Digits that belong to a word, as in `h1`, are none.
pub fn numerals(text: &str, style: NumeralStyle) -> Vec<Numeral> {
    let mut found: Vec<Numeral> = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find(|c: char| c.is_ascii_digit()).map(|digit| at + digit) {
        let before = text[at..start].trim_end_matches(['.', ',']);
        let marked = start - at > before.len() && before.chars().next_back().is_none_or(|c| !c.is_alphanumeric());
        let begin = if marked { start - 1 } else { start };
        let end = begin + length(&text[begin..], style);
        let preceding = text[..begin].chars().next_back().filter(|_| begin > 0);
        at = end;
        if preceding.is_some_and(|c| c.is_alphabetic() || matches!(c, '_' | '^') || c.is_ascii_digit()) {
            continue;
        }
        let lead = &text[found.last().map_or(0, |last| last.at.end)..begin];
        let (power, end) = exponent(text, end);
        let (unit, behind) = unit(text, end);
        let mut numbers = values(&text[begin..at], style);
        let count = numbers.len();
        for (i, values) in numbers.iter_mut().enumerate() {
            let sign = if i == 0 && is_negative(&text[..begin]) { -1.0 } else { 1.0 };
            values.iter_mut().for_each(|value| *value *= sign * if i + 1 == count { power } else { 1.0 });
            let mut number = Numeral { values: std::mem::take(values), at: begin..behind, ..Numeral::default() };
            if i == 0 {
                number.symbol = led_by(lead);
                number.meant = number.symbol.as_deref().and_then(meaning);
            }
            if i + 1 == count {
                number.unit = unit;
            }
            found.push(number);
        }
        at = behind;
    }
    mark_formulas(text, &mut found);
    found
}

/// The bytes of a number, with its marks; a mark is followed by a digit.
fn length(text: &str, style: NumeralStyle) -> usize {
    let digit_at = |at: usize| text[at..].starts_with(|c: char| c.is_ascii_digit());
    let three = |at: usize| {
        let digits = text[at..].bytes().take_while(u8::is_ascii_digit).count();
        digits == 3 && text[..at].bytes().rev().skip_while(|b| !b.is_ascii_digit()).take_while(u8::is_ascii_digit).count() <= 3
    };
    let mut end = 0;
    while let Some(c) = text[end..].chars().next() {
        let next = end + c.len_utf8();
        let goes_on = match c {
            '0'..='9' => true,
            '.' | ',' => digit_at(next),
            '\'' | '’' => three(next),
            ' ' => style.joined && three(next),
            c => THIN.contains(&c) && three(next),
        };
        if !goes_on {
            break;
        }
        end = next;
    }
    end
}

/// The numbers of digits with marks among them, each with all that it may be.
fn values(digits: &str, style: NumeralStyle) -> Vec<Vec<f64>> {
    let plain: String = digits.chars().filter(|c| c.is_ascii_digit() || matches!(c, '.' | ',')).collect();
    let marks: Vec<char> = plain.chars().filter(|c| !c.is_ascii_digit()).collect();
    let number = |text: &str| -> Vec<f64> { text.replace(',', ".").parse().into_iter().collect() };
    let groups: Vec<&str> = plain.split(['.', ',']).collect();
    let thousands = |groups: &[&str]| {
        groups.len() > 1
            && (1..=3).contains(&groups[0].len())
            && groups[0] != "0"
            && groups[1..].iter().all(|group| group.len() == 3)
    };
    let whole = |groups: &[&str]| number(&groups.concat());
    let alike = marks.iter().all(|mark| mark == &marks[0]);
    match marks.len() {
        0 => vec![number(&plain)],
        1 if thousands(&groups) => vec![[number(&plain), whole(&groups)].concat()],
        1 => vec![number(&plain)],
        _ if alike && thousands(&groups) && style.grouped => vec![whole(&groups)],
        _ if alike && style.paired && groups.len().is_multiple_of(2) => {
            groups.chunks(2).map(|pair| number(&pair.join("."))).collect()
        }
        _ if alike => groups.iter().map(|group| number(group)).collect(),
        last if marks[..last - 1].iter().all(|mark| *mark == marks[0] && *mark != marks[last - 1])
            && thousands(&groups[..last]) =>
        {
            vec![number(&format!("{}.{}", groups[..last].concat(), groups[last]))]
        }
        _ => {
            let pieces = |by: char| plain.split(by).map(str::to_owned).collect::<Vec<String>>();
            let single = |pieces: &[String]| pieces.iter().all(|piece| piece.matches(['.', ',']).count() < 2);
            let by_comma = pieces(',');
            let parted = if single(&by_comma) { by_comma } else { pieces('.') };
            parted.iter().map(|piece| number(piece)).collect()
        }
    }
}

const HIGH: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/// The power of ten behind a number, as in `2.9e3` and `2.9·10³`, and where it ends.
fn exponent(text: &str, end: usize) -> (f64, usize) {
    let rest = &text[end..];
    let written = rest.strip_prefix(['e', 'E']).map(|power| (power, false));
    let times = || rest.trim_start().strip_prefix(['·', '*', '×', 'x'])?.trim_start().strip_prefix("10").map(|power| (power, true));
    let Some((power, times)) = written.or_else(times) else { return (1.0, end) };
    let plain = !times || power.starts_with('^');
    let power = power.strip_prefix('^').unwrap_or(power);
    let high = |c: char| HIGH.chars().position(|high| high == c).map(|digit| digit as u32);
    let digit = |c: char| if plain { c.to_digit(10) } else { high(c) };
    let (sign, digits) = match power.strip_prefix(['-', '−', '⁻']) {
        Some(digits) => (-1, digits),
        None => (1, power.strip_prefix('+').unwrap_or(power)),
    };
    let figures: Vec<u32> = digits.chars().map_while(digit).take(2).collect();
    if figures.is_empty() {
        return (1.0, end);
    }
    let length: usize = digits.chars().take(figures.len()).map(char::len_utf8).sum();
    let power = figures.iter().fold(0, |power, figure| 10 * power + *figure as i32);
    (10f64.powi(sign * power), text.len() - digits.len() + length)
}

/// The unit behind a number, and where it ends; a word that is no unit is none.
fn unit(text: &str, end: usize) -> (Option<(&'static str, f64)>, usize) {
    let rest = &text[end..];
    let bare = rest.trim_start_matches([' ', '\u{a0}', '\u{202f}', '\u{2009}']);
    let from = end + rest.len() - bare.len();
    let ends = |length: usize| {
        let mut behind = bare[length..].chars();
        match behind.next() {
            Some('/' | '*' | '·') => behind.next().is_none_or(|c| !c.is_alphabetic()),
            Some(c) => !c.is_alphanumeric() && !matches!(c, '²' | '³' | '^'),
            None => true,
        }
    };
    let is = |name: &str| {
        let begins = match bare.get(..name.len()) {
            Some(written) if name.chars().count() > 3 => written.to_lowercase() == name.to_lowercase(),
            written => written == Some(name),
        };
        begins && (!name.ends_with(char::is_alphanumeric) || ends(name.len()))
    };
    let found = units().filter(|(name, ..)| is(name)).max_by_key(|(name, ..)| name.len());
    found.map_or((None, end), |(name, dimension, factor)| (Some((dimension, factor)), from + name.len()))
}

/// A minus counts where it begins a word.
fn is_negative(before: &str) -> bool {
    let mut before = before.chars().rev();
    before.next().is_some_and(|c| MINUS.contains(&c))
        && before.next().is_none_or(|c| c.is_whitespace() || matches!(c, '=' | ':' | ';' | ',' | '(' | '[' | '|' | '~' | '≈'))
}

/// The sign before an equals sign at the end of a text.
fn led_by(lead: &str) -> Option<String> {
    let before = lead.trim_end_matches(MINUS).trim_end().strip_suffix(['=', '≈'])?;
    let reversed: String = before.trim_end().chars().rev().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    Some(reversed.chars().rev().collect()).filter(|symbol: &String| !symbol.is_empty())
}

/// Of a sign with or without an index, as `v_1` and `h2`.
fn meaning(symbol: &str) -> Option<&'static [&'static str]> {
    let first = symbol.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_' || ('₀'..='₉').contains(&c));
    SYMBOLS.iter().find(|(name, _)| *name == first).map(|(_, meant)| *meant)
}

/// Numbers with a sign of arithmetic between them, up to an equals sign, are worked out.
fn mark_formulas(text: &str, numbers: &mut [Numeral]) {
    const OPERATORS: [&str; 5] = ["/", "*", "·", "×", "+"];
    let between = |from: &Numeral, to: &Numeral| text.get(from.at.end..to.at.start).unwrap_or_default().trim();
    let mut first = 0;
    for i in 0..numbers.len() {
        let goes_on = numbers.get(i + 1).is_some_and(|next| OPERATORS.contains(&between(&numbers[i], next)));
        if goes_on {
            continue;
        }
        let equals = text[numbers[i].at.end..].trim_start().starts_with(['=', '≈']);
        numbers[first..=i].iter_mut().for_each(|number| number.in_formula = equals);
        first = i + 1;
    }
}

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
        Some(Self { what: what.to_owned(), value: *values.first()?, unit: value[number.len()..].trim().to_owned() })
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
        let found = NumeralStyle::all().map(|style| numerals(text, style));
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
