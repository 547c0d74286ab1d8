//! The two logarithmic axes of a diagram, in whole decades: where a point lies between them, and which powers of ten are named.

use super::curve::WorkPoint;
use super::measured::Measured;
use std::ops::Range;

/// Smaller errors are drawn on the lower edge: they are rounding of numbers about 1.
pub const LEAST_ERROR: f64 = 1e-16;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decades {
    pub from: i32,
    pub to: i32,
}

impl Decades {
    /// The fewest decades around all values, which are above 0; a single one without values.
    pub(super) fn around(values: impl Iterator<Item = f64>) -> Self {
        let (least, most) =
            values.fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), value| (least.min(value), most.max(value)));
        if least > most {
            return Self { from: 0, to: 1 };
        }
        let (from, to) = (least.log10().floor() as i32, most.log10().ceil() as i32);
        Self { from, to: to.max(from + 1) }
    }

    pub fn range(&self) -> Range<f64> {
        10f64.powi(self.from)..10f64.powi(self.to)
    }

    /// 0 … 1; values beyond an end are drawn at it.
    pub fn part(&self, value: f64) -> f64 {
        ((value.log10() - f64::from(self.from)) / f64::from(self.to - self.from)).clamp(0.0, 1.0)
    }

    /// The powers with a label, at most about `most` of them, evenly spaced and 0 among them where it is within.
    pub fn named(&self, most: i32) -> impl Iterator<Item = i32> {
        let every = ((self.to - self.from + most - 1) / most.max(1)).max(1);
        (self.from..=self.to).filter(move |power| power % every == 0)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axes {
    pub work: Decades,
    pub error: Decades,
}

impl Axes {
    pub fn of(measured: &Measured) -> Self {
        let points = || measured.curves.iter().flat_map(|curve| &curve.points);
        let errors = points().filter(|point| !point.blew_up()).map(|point| point.error.max(LEAST_ERROR));
        Self {
            work: Decades::around(points().map(|point| point.work).filter(|work| *work > 0.0)),
            error: Decades::around(errors.chain([measured.tolerance])),
        }
    }

    /// The parts of the axes to the right and upwards. A run that blew up is at the upper edge, one without error at the lower.
    pub fn place(&self, point: &WorkPoint) -> (f64, f64) {
        let up = if point.blew_up() { 1.0 } else { self.error.part(point.error.max(LEAST_ERROR)) };
        (self.work.part(point.work), up)
    }
}

/// A power of ten, as 10⁻³.
pub fn power(exponent: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised =
        exponent.to_string().bytes().map(|c| if c == b'-' { '⁻' } else { RAISED[usize::from(c - b'0')] }).collect::<String>();
    format!("10{raised}")
}

pub fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "∞".to_owned();
    }
    if (1e-3..1e5).contains(&value.abs()) {
        let digits = (2 - value.abs().log10().floor() as i32).clamp(0, 6) as usize;
        let text = format!("{value:.digits$}");
        let mut text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text };
        if value.abs() >= 1e4 {
            text.insert(text.len() - 3, ' ');
        }
        return text.replace('-', "−");
    }
    let text = format!("{value:.1e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{}·{}", digits.replace('-', "−"), power(exponent.parse().unwrap_or(0)))
}

/// A step as people write it: 1/120 s where it is one part of a second.
pub fn step(seconds: f64) -> String {
    let parts = 1.0 / seconds;
    if parts.is_finite() && parts >= 2.0 && (parts / parts.round() - 1.0).abs() < 1e-9 {
        return format!("1/{} s", number(parts.round()));
    }
    format!("{} s", number(seconds))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_hold_all_values_and_name_evenly() {
        let decades = Decades::around([3.0, 0.02, 450.0].into_iter());
        assert_eq!(decades, Decades { from: -2, to: 3 });
        assert_eq!((decades.part(0.01), decades.part(1000.0), decades.part(1e9)), (0.0, 1.0, 1.0));
        assert!((decades.part(1.0) - 0.4).abs() < 1e-12);
        assert_eq!(decades.named(10).collect::<Vec<_>>(), [-2, -1, 0, 1, 2, 3]);
        assert_eq!(Decades { from: -16, to: 1 }.named(9).collect::<Vec<_>>(), [-16, -14, -12, -10, -8, -6, -4, -2, 0]);
        assert_eq!(Decades::around([100.0].into_iter()), Decades { from: 2, to: 3 });
        assert_eq!(Decades::around(std::iter::empty()), Decades { from: 0, to: 1 });
        assert_eq!(Decades::around([f64::MIN_POSITIVE, f64::MAX].into_iter()).named(10).count(), 9);
    }

    #[test]
    fn numbers_are_short() {
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
            assert_eq!(number(value), text);
        }
        assert_eq!((power(-12), power(2), power(0)), ("10⁻¹²".to_owned(), "10²".to_owned(), "10⁰".to_owned()));
        assert_eq!(
            (step(1.0 / 120.0), step(0.1), step(1e-4)),
            ("1/120 s".to_owned(), "1/10 s".to_owned(), "1/10 000 s".to_owned())
        );
    }
}
