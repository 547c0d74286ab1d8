//! Numbers and flight times as results, exports and the screen print them.

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

/// Hundredths of a second, rounded up. The screen shows this time, and a medal asks for it within [`whole_hundredths`] of its
/// limit.
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
    use super::{Shortest, clock, fixed};
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
