//! A law through a stretch of a curve by least squares: a line, a parabola or a sine, with its figures and what it leaves over.

use super::quantity::{Quantity, Unit};
use crate::number::{fixed, short};
use crate::words::tr;

/// Points of a search for a frequency, at most.
const SEARCHED: usize = 400;
/// Frequencies in a search: from half a period in the stretch on, eight a period more.
const FREQUENCIES: usize = 320;
/// Corrections of a sine's frequency; near its root the error squares itself.
const CORRECTIONS: usize = 12;
/// Pieces of a drawn fit.
const DRAWN: usize = 240;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FitLaw {
    Line,
    Parabola,
    Sine,
}

/// y = c₀ + c₁·x + c₂·x², or y = c₀ + c₁·sin(ω·x) + c₂·cos(ω·x).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    pub law: FitLaw,
    pub c: [f64; 3],
    /// rad a unit across; 0 but for a sine.
    pub rate: f64,
    /// The square root of the mean of the squares of what is left over, in the unit of y.
    pub residual: f64,
    /// The stretch, across.
    pub from: f64,
    pub to: f64,
}

impl FitLaw {
    pub const ALL: [Self; 3] = [Self::Line, Self::Parabola, Self::Sine];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Parabola => "parabola",
            Self::Sine => "sine",
        }
    }

    fn at(self, c: [f64; 3], rate: f64, x: f64) -> f64 {
        if self == Self::Sine { wave(c, rate, x) } else { c[0] + x * (c[1] + x * c[2]) }
    }

    /// The fewest points that leave anything over.
    const fn fewest(self) -> usize {
        match self {
            Self::Line => 3,
            Self::Parabola => 4,
            Self::Sine => 5,
        }
    }
}

impl Fit {
    /// `None` where there are too few points, or all stand above each other.
    pub fn of(law: FitLaw, points: &[(f64, f64)]) -> Option<Self> {
        let (from, to) = points.iter().fold((f64::MAX, f64::MIN), |(from, to), (x, _)| (from.min(*x), to.max(*x)));
        if points.len() < law.fewest() || !(to - from).is_finite() || to - from <= f64::EPSILON * from.abs().max(to.abs()) {
            return None;
        }
        // Around the middle of the stretch, in halves of it: nothing cancels.
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let near: Vec<(f64, f64)> = points.iter().map(|(x, y)| ((x - middle) / half, *y)).collect();
        let (c, rate) = match law {
            FitLaw::Line => {
                let [a, b] = least_squares(&near, |u| [1.0, u])?;
                ([a, b, 0.0], 0.0)
            }
            FitLaw::Parabola => (least_squares(&near, |u| [1.0, u, u * u])?, 0.0),
            FitLaw::Sine => sine(&near)?,
        };
        let residual = (near.iter().map(|(u, y)| (y - law.at(c, rate, *u)).powi(2)).sum::<f64>() / near.len() as f64).sqrt();
        let (c, rate) = match law {
            FitLaw::Sine => {
                let (rate, turn) = (rate / half, rate * middle / half);
                ([c[0], c[1] * turn.cos() + c[2] * turn.sin(), c[2] * turn.cos() - c[1] * turn.sin()], rate)
            }
            _ => {
                let (b, a) = (c[1] / half, c[2] / (half * half));
                ([c[0] - middle * (b - middle * a), b - 2.0 * middle * a, a], 0.0)
            }
        };
        residual.is_finite().then_some(Self { law, c, rate, residual, from, to })
    }

    pub fn at(&self, x: f64) -> f64 {
        self.law.at(self.c, self.rate, x)
    }

    /// Of a sine.
    pub fn amplitude(&self) -> f64 {
        self.c[1].hypot(self.c[2])
    }

    pub fn drawn(&self) -> impl Iterator<Item = (f64, f64)> + use<'_> {
        let at = |i: usize| self.from + (self.to - self.from) * i as f64 / DRAWN as f64;
        (0..=DRAWN).map(move |i| (at(i), self.at(at(i))))
    }

    /// Its formula for those quantities upwards and across, with its figures, each with its unit, and the residual.
    pub fn words(&self, up: Quantity, across: Quantity) -> String {
        let (y, y_unit, x, x_unit) = (up.symbol(), up.unit(), across.symbol(), across.unit());
        let term = |value: f64, unit: Unit, of: &str| {
            let sign = if value < 0.0 { "− " } else { "+ " };
            format!(" {sign}{}{of}", figure(value.abs(), unit))
        };
        let [a, b, c] = self.c;
        let slope = y_unit.per(x_unit);
        let law = match self.law {
            FitLaw::Line => format!("{}·{x}{}", figure(b, slope), term(a, y_unit, "")),
            FitLaw::Parabola => {
                let square = figure(c, slope.per(x_unit));
                format!("{square}·{x}²{}{}", term(b, slope, &format!("·{x}")), term(a, y_unit, ""))
            }
            FitLaw::Sine => {
                let rate = format!("{} rad/{}", digits(self.rate), x_unit.name());
                let phase = digits(c.atan2(b));
                let sine = format!("{}·sin({rate}·{x} + {phase}){}", figure(self.amplitude(), y_unit), term(a, y_unit, ""));
                format!("{sine}; {} {}", tr("period"), figure(std::f64::consts::TAU / self.rate, x_unit)).replace("+ −", "− ")
            }
        };
        format!("{y} = {law}; {} {}", tr("residual"), with_unit(&short(self.residual), y_unit))
    }
}

/// With five digits.
fn digits(value: f64) -> String {
    match value.abs() {
        size if size != 0.0 && !(1e-4..1e6).contains(&size) => short(value),
        size => fixed(value, (4 - size.max(1e-4).log10().floor() as i32).clamp(0, 8) as usize),
    }
}

fn figure(value: f64, unit: Unit) -> String {
    with_unit(&digits(value), unit)
}

fn with_unit(digits: &str, unit: Unit) -> String {
    format!("{digits} {}", unit.name()).trim_end().to_owned()
}

fn wave(c: [f64; 3], rate: f64, x: f64) -> f64 {
    c[0] + c[1] * (rate * x).sin() + c[2] * (rate * x).cos()
}

/// The factors of some functions whose sum is nearest to the points; `None` where the functions are not told apart there.
fn least_squares<const N: usize>(points: &[(f64, f64)], functions: impl Fn(f64) -> [f64; N]) -> Option<[f64; N]> {
    let (mut matrix, mut right) = ([[0.0; N]; N], [0.0; N]);
    for (x, y) in points {
        let row = functions(*x);
        for i in 0..N {
            right[i] += row[i] * y;
            for j in 0..N {
                matrix[i][j] += row[i] * row[j];
            }
        }
    }
    solved(matrix, right)
}

/// Of a symmetric positive matrix, by elimination.
fn solved<const N: usize>(mut matrix: [[f64; N]; N], mut right: [f64; N]) -> Option<[f64; N]> {
    for i in 0..N {
        let pivot = matrix[i][i];
        if !(pivot.is_finite() && pivot > 1e-13 * (0..N).map(|i| matrix[i][i].abs()).fold(0.0, f64::max)) {
            return None;
        }
        for j in i + 1..N {
            let part = matrix[j][i] / pivot;
            let above = matrix[i];
            matrix[j].iter_mut().zip(above).for_each(|(below, above)| *below -= part * above);
            right[j] -= part * right[i];
        }
    }
    for i in (0..N).rev() {
        right[i] = (right[i] - (i + 1..N).map(|j| matrix[i][j] * right[j]).sum::<f64>()) / matrix[i][i];
    }
    Some(right)
}

/// The factors and the rate of the sine that is nearest to points in −1 … 1: the best of many frequencies, then corrected.
fn sine(points: &[(f64, f64)]) -> Option<([f64; 3], f64)> {
    let few: Vec<(f64, f64)> = points.iter().copied().step_by(points.len().div_ceil(SEARCHED)).collect();
    let of = |rate: f64, points: &[(f64, f64)]| {
        let c = least_squares(points, |u| [1.0, (rate * u).sin(), (rate * u).cos()])?;
        Some((points.iter().map(|(u, y)| (y - wave(c, rate, *u)).powi(2)).sum::<f64>(), c, rate))
    };
    // More than a period for each four points is not seen in them.
    let highest = 0.25 * std::f64::consts::PI * few.len() as f64;
    let rates = (2..FREQUENCIES).map(|i| i as f64 * std::f64::consts::PI / 8.0).take_while(|rate| *rate <= highest);
    let (_, _, rate) = rates.filter_map(|rate| of(rate, &few)).min_by(|a, b| a.0.total_cmp(&b.0))?;
    let mut best = of(rate, points)?;
    let (mut c, mut rate) = (best.1, rate);
    for _ in 0..CORRECTIONS {
        let left: Vec<(f64, f64)> = points.iter().map(|(u, y)| (*u, y - wave(c, rate, *u))).collect();
        let slope = |u: f64| u * (c[1] * (rate * u).cos() - c[2] * (rate * u).sin());
        rate += least_squares(&left, |u| [1.0, (rate * u).sin(), (rate * u).cos(), slope(u)])?[3];
        let Some(next) = of(rate, points) else { break };
        (c, best) = (next.1, if next.0 < best.0 { next } else { best });
    }
    // A negative rate is the same wave.
    let (_, [a, b, c], rate) = best;
    Some(if rate < 0.0 { ([a, -b, c], -rate) } else { ([a, b, c], rate) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::instruments::quantity::VectorPart;
    use proptest::prelude::*;

    fn sampled(from: f64, count: usize, of: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        (0..count).map(|i| from + i as f64 / 120.0).map(|x| (x, of(x))).collect()
    }

    #[test]
    fn a_throw_is_a_parabola_with_half_of_g_and_a_fall_of_speed_a_line_with_g() {
        let throw = Fit::of(FitLaw::Parabola, &sampled(7.0, 200, |t| 3.0 + 12.0 * t - 0.5 * 9.81 * t * t)).unwrap();
        for (found, exact) in throw.c.into_iter().zip([3.0, 12.0, -4.905]) {
            assert!((found - exact).abs() < 1e-9, "{found} for {exact}");
        }
        let words = throw.words(Quantity::Y, Quantity::Time);
        assert!(words.starts_with("y = −4.9050 m/s²·t² + 12.000 m/s·t + 3.0000 m; residual "), "{words}");
        let speed = Fit::of(FitLaw::Line, &sampled(0.0, 100, |t| 12.0 - 9.81 * t)).unwrap();
        assert!((speed.c[1] + 9.81).abs() < 1e-12 && speed.residual < 1e-13);
        assert!(
            speed
                .words(Quantity::Velocity(VectorPart::Y), Quantity::Time)
                .starts_with("v_y = −9.8100 m/s²·t + 12.000 m/s; residual ")
        );
    }

    #[test]
    fn a_residual_is_what_a_law_leaves_over() {
        // Of x² on −1 … 1 a line leaves over x² − 1/3: its root mean square is √(4/45).
        let points: Vec<(f64, f64)> = (0..=20_000).map(|i| f64::from(i) / 10_000.0 - 1.0).map(|x| (x, x * x)).collect();
        let line = Fit::of(FitLaw::Line, &points).unwrap();
        assert!((line.residual - (4.0_f64 / 45.0).sqrt()).abs() < 1e-4, "{}", line.residual);
        assert_eq!(Fit::of(FitLaw::Line, &points[..2]), None);
        assert_eq!(Fit::of(FitLaw::Parabola, &[(1.0, 0.0); 9]), None);
        assert_eq!(Fit::of(FitLaw::Sine, &[]), None);
    }

    proptest! {
        #[test]
        fn a_sine_is_found_with_its_frequency(rate in 0.8..40.0_f64, phase in -3.0..3.0_f64, size in 0.1..9.0_f64, middle in -9.0..9.0_f64) {
            let fit = Fit::of(FitLaw::Sine, &sampled(3.0, 601, |t| middle + size * (rate * t + phase).sin())).unwrap();
            prop_assert!((fit.rate - rate).abs() < 1e-8 * rate, "{} for {rate}", fit.rate);
            prop_assert!((fit.amplitude() - size).abs() < 1e-7 && (fit.c[0] - middle).abs() < 1e-7 && fit.residual < 1e-8);
        }

        #[test]
        fn whatever_it_is_given_its_numbers_are_finite(ys in proptest::collection::vec(-1e3..1e3_f64, 0..200)) {
            for law in FitLaw::ALL {
                let points: Vec<(f64, f64)> = ys.iter().enumerate().map(|(i, y)| (i as f64, *y)).collect();
                if let Some(fit) = Fit::of(law, &points) {
                    prop_assert!(fit.residual.is_finite() && fit.at(3.0).is_finite());
                }
            }
        }
    }
}
