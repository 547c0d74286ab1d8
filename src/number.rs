//! Numbers, quantities and flight times as results, exports and the screen print them.

use crate::physics::DVec2;
use serde::{Serialize, Serializer};
use std::fmt;

/// Magnitudes without an exponent: outside, the plain form fills up with zeros.
const PLAIN: std::ops::Range<f64> = 1e-5..1e16;

/// The fewest digits that read back as the same f64, bit for bit (also −0).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shortest(pub f64);

impl fmt::Display for Shortest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number) = self;
        if *number == 0.0 || PLAIN.contains(&number.abs()) { write!(f, "{number}") } else { write!(f, "{number:e}") }
    }
}

impl Serialize for Shortest {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

/// With a true minus sign, and no sign on a number that rounds to zero.
pub fn fixed(value: f64, decimals: usize) -> String {
    let plain = format!("{value:.decimals$}");
    match plain.strip_prefix('-') {
        Some(size) if size.bytes().all(|digit| digit == b'0' || digit == b'.') => size.to_owned(),
        Some(size) => format!("−{size}"),
        None => plain,
    }
}

/// Without the zeros behind a decimal point.
pub fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A power of ten, as 10⁻³.
pub fn power(exponent: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised =
        exponent.to_string().bytes().map(|c| if c == b'-' { '⁻' } else { RAISED[usize::from(c - b'0')] }).collect::<String>();
    format!("10{raised}")
}

/// Three digits at most, with a power of ten where zeros would fill it up.
pub fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "∞".to_owned();
    }
    if (1e-3..1e5).contains(&value.abs()) {
        let digits = (2 - value.abs().log10().floor() as i32).clamp(0, 6) as usize;
        let mut text = trimmed(&fixed(value, digits)).to_owned();
        if value.abs() >= 1e4 {
            text.insert(text.len() - 3, ' ');
        }
        return text;
    }
    let text = format!("{value:.1e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{}·{}", digits.replace('-', "−"), power(exponent.parse().unwrap_or(0)))
}

/// A step as people write it: 1/120 s where it is one part of a second.
pub fn step(seconds: f64) -> String {
    let parts = 1.0 / seconds;
    if parts.is_finite() && parts >= 2.0 && (parts / parts.round() - 1.0).abs() < 1e-9 {
        return format!("1/{} s", short(parts.round()));
    }
    format!("{} s", short(seconds))
}

/// From the largest.
pub const PREFIXES: [(f64, &str); 6] = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ")];
/// Masses have a prefix already, and larger ones names of their own.
const MASSES: [(f64, &str); 6] = [(1e9, "Mt"), (1e6, "kt"), (1e3, "t"), (1.0, "kg"), (1e-3, "g"), (1e-6, "mg")];
/// Units: a smaller number is rounding.
pub const NOTHING: f64 = 1e-9;
/// The unit without a prefix serves down to this part of it: 0.5 N reads better than 500 mN.
const PLAIN_FROM: f64 = 0.1;
/// A number from this share of the next power of ten on counts as that.
const ROUNDS_UP: f64 = 0.9995;

/// The format of a quantity's numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct QuantityScale {
    /// The size of one written unit in plain units; none beyond all prefixes.
    pub one: Option<f64>,
    pub decimals: usize,
    unit: String,
}

impl QuantityScale {
    /// `largest` is the largest number of the quantity.
    pub fn of(largest: f64, unit: &str) -> Self {
        let scales: &[(f64, &str)] = match unit {
            "kg" => &MASSES,
            // School writes slow motions as 0.05 m/s.
            "m/s" | "m/s²" => &PREFIXES[..4],
            _ => &PREFIXES,
        };
        let size = largest.abs();
        let fits = |(one, _): &&(f64, &str)| size >= one * if *one == 1.0 { PLAIN_FROM } else { 1.0 } * ROUNDS_UP;
        let smallest = scales[scales.len() - 1];
        let (one, name) = if size < NOTHING { (1.0, scales[3].1) } else { *scales.iter().find(fits).unwrap_or(&smallest) };
        let unit = if unit == "kg" { name.to_owned() } else { format!("{name}{unit}") };
        let parts = size / one;
        let decimals = decimals(parts).min(if smallest.0 == 1.0 { 6 } else { 3 });
        if parts < 1000.0 * ROUNDS_UP { Self { one: Some(one), decimals, unit } } else { Self { one: None, decimals, unit } }
    }

    /// The same unit for numbers of which this is the largest: three digits of their own, with up to two more places.
    #[must_use]
    pub fn finer(&self, largest: f64) -> Self {
        let own = self.one.filter(|_| largest.abs() >= NOTHING).map_or(self.decimals, |one| decimals(largest.abs() / one));
        Self { decimals: own.clamp(self.decimals, self.decimals + 2), ..self.clone() }
    }

    pub fn number(&self, value: f64) -> String {
        if value.abs() < NOTHING {
            return "0".to_owned();
        }
        let Some(one) = self.one else { return short(value / PREFIXES[0].0) };
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

/// Ticks in seconds, to the millisecond: "1.350".
pub fn seconds(ticks: u64, rate: f64) -> String {
    fixed(ticks as f64 / rate, 3)
}

/// FNV-1a, 32 bits.
pub fn hash(text: &str) -> u32 {
    text.bytes().fold(0x811C_9DC5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

/// A vector's x and y, two cells of a row.
pub type Pair = (Shortest, Shortest);

pub const fn pair(vector: DVec2) -> Pair {
    (Shortest(vector.x), Shortest(vector.y))
}

/// A hundredth begun by less than this share of it does not count: 0.29 s is 29 hundredths and a rounding. Far below a tick.
const ROUNDING: f64 = 1e-6;

/// Hundredths of a second, rounded up. The screen shows this time, and a medal asks for it within [`whole_hundredths`] of its limit.
pub fn hundredths(seconds: f64) -> u64 {
    (seconds * 100.0 - ROUNDING).ceil().max(0.0) as u64
}

/// A medal's limit in hundredths of a second, rounded down.
pub fn whole_hundredths(limit: f64) -> u64 {
    (limit * 100.0 + ROUNDING).max(0.0) as u64
}

/// Whether it is a number and nothing else: digits, with a sign in front and a decimal point or comma among them.
pub fn is_plain(text: &str) -> bool {
    let digits = text.strip_prefix(['+', '-', '−']).unwrap_or(text);
    digits.contains(|c: char| c.is_ascii_digit())
        && digits.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | ','))
        && digits.matches(['.', ',']).count() < 2
}

/// mm:ss.hh; minutes go on beyond 99.
pub fn clock(seconds: f64) -> String {
    let hundredths = hundredths(seconds);
    format!("{:02}:{:02}.{:02}", hundredths / 6000, hundredths / 100 % 60, hundredths % 100)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::FileFailurePersistence;

    #[test]
    fn shown_numbers_have_a_true_minus_and_zero_has_no_sign() {
        for (value, decimals, text) in [
            (1500.0, 1, "1500.0"),
            (-731.25, 1, "−731.2"),
            (-0.04, 1, "0.0"),
            (-0.0, 1, "0.0"),
            (-0.06, 1, "−0.1"),
            (-0.4, 0, "0"),
            (-1.0, 0, "−1"),
            (f64::NEG_INFINITY, 1, "−inf"),
        ] {
            assert_eq!(fixed(value, decimals), text);
        }
    }

    #[test]
    fn numbers_are_short() {
        for (number, text) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1500.0, "1500"),
            (-0.1, "-0.1"),
            (1.0 / 3.0, "0.3333333333333333"),
            (1e-5, "0.00001"),
            (9.5e-6, "9.5e-6"),
            (1e300, "1e300"),
            (-1.5e16, "-1.5e16"),
            (f64::from_bits(1), "5e-324"),
        ] {
            assert_eq!(Shortest(number).to_string(), text);
        }
    }

    #[test]
    fn three_digits_say_most_numbers() {
        let cases = [
            (1.0 / 300.0, "0.00333"),
            (1e-9, "1.0·10⁻⁹"),
            (1234.5, "1234"),
            (12_345.6, "12 346"),
            (0.5, "0.5"),
            (36.04, "36"),
            (0.0, "0"),
            (1e6, "1.0·10⁶"),
        ];
        for (value, text) in cases {
            assert_eq!(short(value), text);
        }
        assert_eq!((power(-12), power(2), power(0)), ("10⁻¹²".to_owned(), "10²".to_owned(), "10⁰".to_owned()));
        assert_eq!(
            (step(1.0 / 120.0), step(0.1), step(1e-4)),
            ("1/120 s".to_owned(), "1/10 s".to_owned(), "1/10 000 s".to_owned())
        );
    }

    #[test]
    fn three_digits_and_a_prefix_say_any_number() {
        for (value, unit, text) in [
            (1500.0, "N", "1.50 kN"),
            (-731.25, "N", "−731 N"),
            (0.5, "m/s", "0.500 m/s"),
            (0.05, "m/s", "0.0500 m/s"),
            (2e-5, "m/s²", "0.000020 m/s²"),
            (1500.0, "m/s", "1.50 km/s"),
            (0.05, "N", "50.0 mN"),
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
    fn the_clock_shows_the_hundredth_that_has_begun() {
        let shown = [
            (0.0, "00:00.00"),
            (1.0 / 120.0, "00:00.01"),
            (0.29, "00:00.29"),
            (119.0 / 120.0, "00:01.00"),
            (5.5, "00:05.50"),
            (661.0 / 120.0, "00:05.51"),
            (59.0 * 60.0 + 59.9, "59:59.90"),
            (6000.0, "100:00.00"),
        ];
        assert_eq!(shown.map(|(seconds, _)| clock(seconds)), shown.map(|(_, text)| text));
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("proptest-regressions"))),
            ..ProptestConfig::default()
        })]

        #[test]
        fn every_number_reads_back(number in proptest::num::f64::ANY.prop_filter("finite", |number| number.is_finite())) {
            let read: f64 = Shortest(number).to_string().parse().unwrap();
            prop_assert_eq!(read.to_bits(), number.to_bits());
        }
    }
}
