//! What every chart has, for paper and screen alike: axes, linear and in whole decades, looks of curves, and a sheet of lanes as values.

use super::layout::{Area, Vec2};
use super::{Canvas, Colour};
use crate::number::{fixed, short};
use std::ops::Range;

/// A picture of curves above one axis: a strip for each kind of number, one above the other.
pub struct Sheet {
    pub across: Linear,
    /// The quantity to the right, with its unit.
    pub across_name: String,
    /// From the top.
    pub strips: Vec<Strip>,
    pub legend: Vec<(String, CurveLook)>,
    /// Lines below the legend.
    pub notes: Vec<String>,
}

pub struct Strip {
    /// With its unit.
    pub name: String,
    /// Values upwards, each with its part of the height.
    pub named: Vec<(f64, String)>,
    /// Values to the right with an upright line.
    pub marks: Vec<f64>,
    pub curves: Vec<Piece>,
}

pub struct Piece {
    pub look: CurveLook,
    /// Values to the right, and parts of the height.
    pub points: Vec<(f64, f64)>,
    /// The point with the curve's marker, if any has it.
    pub marker: Option<usize>,
}

/// Beyond these sizes numbers are written with powers of ten, each for itself, where two digits tell them apart.
const PLAIN: Range<f64> = 1e-4..1e6;
/// The parts of its span that labels may take before the axis ends beyond them.
const MARGIN: f64 = 0.06;
/// An axis names at most this many more numbers than it is asked for, so that there are two.
const FINER: usize = 8;
/// A span of less than this part of its numbers is none: they are one number, and rounding.
const SAME: f64 = 1e-9;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    pub from: f64,
    /// Above `from`.
    pub to: f64,
}

impl Linear {
    /// A little longer where the two numbers are one.
    pub fn between(from: f64, to: f64) -> Self {
        let size = from.abs().max(to.abs());
        if to - from > SAME * size.max(SAME) {
            return Self { from, to };
        }
        let half = if size > SAME { 0.5 * size } else { 1.0 };
        Self { from: from - half, to: from + half }
    }

    /// Around numbers from the least to the largest, with a margin; to 0 where that is near.
    pub fn around(least: f64, largest: f64) -> Self {
        let Self { from, to } = Self::between(least, largest);
        let span = to - from;
        let to_zero = |end: f64, inwards: f64| if (0.0..0.25 * span).contains(&inwards) { 0.0 } else { end };
        let (from, to) = (to_zero(from, from), to_zero(to, -to));
        Self { from: from - MARGIN * span, to: to + MARGIN * span }
    }

    /// How far along a value lies: 0 at the lower end, 1 at the upper one.
    pub fn part(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }

    pub fn value(&self, part: f64) -> f64 {
        self.from + (self.to - self.from) * part
    }

    /// Round numbers, about the number asked for and two at least, each as text with the decimals that they need to differ.
    pub fn named(&self, about: usize) -> Vec<(f64, String)> {
        let numbers = (about.max(1)..about.max(1) + FINER)
            .map(|about| round_numbers(self.from, self.to, about))
            .find(|numbers| numbers.len() >= 2)
            .unwrap_or_default();
        let apart = numbers.get(1).map_or(1.0, |second| second - numbers[0]);
        let size = self.from.abs().max(self.to.abs());
        let plain = PLAIN.contains(&apart) && (size < PLAIN.end || apart < 0.1 * size);
        let decimals = (-(apart * 1.001).log10().floor()).max(0.0) as usize;
        let written = |value: f64| match plain {
            _ if value.abs() < 1e-6 * apart => "0".to_owned(),
            true => fixed(value, decimals),
            false => short(value),
        };
        numbers.into_iter().map(|value| (value, written(value))).collect()
    }
}

/// Round numbers from `from` to `to`, about `about` of them: 1, 2 or 5 times a power of ten apart.
pub fn round_numbers(from: f64, to: f64, about: usize) -> Vec<f64> {
    let rough = (to - from) / about.max(1) as f64;
    if !rough.is_finite() || rough <= 0.0 {
        return Vec::new();
    }
    let power = libm::exp10(rough.log10().floor());
    let apart = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power).into_iter().find(|apart| *apart >= rough * 0.999).unwrap_or(rough);
    let first = (from / apart - 1e-9).ceil() as i64;
    (first..=(to / apart + 1e-9).floor() as i64).map(|i| i as f64 * apart).collect()
}

/// Smaller errors are drawn on the lower edge: they are rounding of numbers about 1.
pub const LEAST_ERROR: f64 = 1e-16;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decades {
    pub from: i32,
    pub to: i32,
}

impl Decades {
    /// The fewest decades around all values, which are above 0; a single one without values.
    pub fn around(values: impl Iterator<Item = f64>) -> Self {
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
pub enum CurveOrigin {
    Lab,
    Shipped,
    /// As `benches/peers` measured it.
    Peer,
}

/// Words, and other engines.
pub const TEXT: u32 = 0xE6EBF2;
/// The shipped engine: the game's accent.
pub const SHIPPED: u32 = 0xFF9F1C;
/// After M. Okabe, K. Ito, "Color Universal Design", 2008, lightened for a dark ground; neighbours stay apart in all common kinds of colour vision.
const COLOURS: [u32; 8] = [0x56B4E9, 0x8870E8, 0xF0E442, 0xD55E00, 0x1FB88F, 0xCC79A7, 0xB8E8B8, 0xA3A847];
/// Pixels drawn and left out.
pub const DASHES: [Option<(u32, u32)>; 4] = [None, Some((8, 4)), Some((3, 3)), Some((14, 5))];
/// Pixels drawn and left out of the line of the tolerance.
pub const TOLERANCE_DASH: (u32, u32) = (2, 4);
/// Pixels. Radius of the ring around the shipped point.
pub const RING: f32 = 11.0;
/// Pixels. Half the side of the square around the cheapest one.
pub const FRAME: f32 = 10.0;

/// From a legend line's left end to its words.
pub const WORDS: f32 = 52.0;
/// Length of the sample of a curve in the legend.
pub const SAMPLE: f32 = 40.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CurveLook {
    /// As 0xRRGGBB.
    pub colour: u32,
    /// Pixels drawn and left out; none: a full line.
    pub dash: Option<(u32, u32)>,
    pub marker: Marker,
    /// Pixels.
    pub width: u32,
}

impl CurveLook {
    /// Other engines are white, ours has the accent's colour.
    pub fn of(index: usize, origin: CurveOrigin) -> Self {
        let marker = Marker::ALL[index % Marker::ALL.len()];
        // One shape further each time the colours begin again, so that no two of many curves share both.
        let dash = DASHES[(index + index / COLOURS.len()) % DASHES.len()];
        match origin {
            CurveOrigin::Shipped => Self { colour: SHIPPED, dash: None, marker: Marker::Star, width: 3 },
            CurveOrigin::Lab => Self { colour: COLOURS[index % COLOURS.len()], dash, marker, width: 2 },
            CurveOrigin::Peer => Self { colour: TEXT, dash: DASHES[2], marker, width: 1 },
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    Square,
    /// Points up.
    Up,
    Diamond,
    /// Points down.
    Down,
    Bar,
    Hexagon,
    Pole,
    Star,
    /// Marks a run that blew up.
    Cross,
}

/// A convex outline around a point, pixels, y down.
pub type Outline = Vec<(f32, f32)>;

impl Marker {
    /// The markers that curves take in turn.
    const ALL: [Self; 7] = [Self::Square, Self::Up, Self::Diamond, Self::Down, Self::Hexagon, Self::Bar, Self::Pole];

    /// Convex pieces that overlap.
    pub fn pieces(self) -> Vec<Outline> {
        match self {
            Self::Square => vec![vec![(-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)]],
            Self::Up => vec![vec![(0.0, -6.0), (6.0, 4.0), (-6.0, 4.0)]],
            Self::Down => vec![vec![(0.0, 6.0), (6.0, -4.0), (-6.0, -4.0)]],
            Self::Diamond => vec![vec![(0.0, -6.0), (6.0, 0.0), (0.0, 6.0), (-6.0, 0.0)]],
            Self::Bar => vec![vec![(-6.0, -2.0), (6.0, -2.0), (6.0, 2.0), (-6.0, 2.0)]],
            Self::Pole => vec![vec![(-2.0, -6.0), (2.0, -6.0), (2.0, 6.0), (-2.0, 6.0)]],
            Self::Hexagon => vec![vec![(-3.0, -5.0), (3.0, -5.0), (6.0, 0.0), (3.0, 5.0), (-3.0, 5.0), (-6.0, 0.0)]],
            Self::Star => star(8.5),
            Self::Cross => vec![
                vec![(-6.0, -4.0), (-4.0, -6.0), (6.0, 4.0), (4.0, 6.0)],
                vec![(6.0, -4.0), (4.0, -6.0), (-6.0, 4.0), (-4.0, 6.0)],
            ],
        }
    }
}

/// The pentagram: from each tip, the triangle to the two corners of the inner pentagon that lie across.
fn star(radius: f32) -> Vec<Outline> {
    // The inner pentagon's radius over the outer one's: 1/φ².
    const INNER: f32 = 0.381_966;
    let at = |fifth: f32, r: f32| {
        let (sine, cosine) = ((fifth / 5.0 - 0.25) * std::f32::consts::TAU).sin_cos();
        (r * cosine, r * sine)
    };
    let inner = |fifth: f32| at(fifth, radius * INNER);
    (0..5).map(|i| i as f32).map(|tip| vec![at(tip, radius), inner(tip + 1.5), inner(tip - 1.5)]).collect()
}

pub fn stroke(canvas: &Canvas, line: &[Vec2], look: &CurveLook, colour: Colour) {
    let width = look.width as f32;
    match look.dash {
        None => line.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], width, colour)),
        Some(dash) => dashed(canvas, line, dash, width, colour),
    }
}

pub fn dashed(canvas: &Canvas, line: &[Vec2], (on, off): (u32, u32), width: f32, colour: Colour) {
    canvas.dashed(line, &[on as f32, off as f32], width, colour);
}

pub fn marker(canvas: &Canvas, at: Vec2, shape: Marker, colour: Colour) {
    for piece in shape.pieces() {
        canvas.convex(&piece.into_iter().map(|corner| at + Vec2::from(corner)).collect::<Vec<_>>(), colour);
    }
}

/// A curve's sample at the left end of its legend line.
pub fn sample(canvas: &Canvas, line: Area, look: &CurveLook, colour: Colour) {
    let [from, middle, to] = [0.0, SAMPLE / 2.0, SAMPLE].map(|right| Vec2::new(line.min.x + right, line.centre().y));
    stroke(canvas, &[from, to], look, colour);
    marker(canvas, middle, look.marker, colour);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn names(from: f64, to: f64, about: usize) -> Vec<String> {
        Linear { from, to }.named(about).into_iter().map(|(_, name)| name).collect()
    }

    #[test]
    fn round_numbers_are_round() {
        assert_eq!(round_numbers(0.0, 60.0, 6), [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0]);
        let near = |found: Vec<f64>, wanted: &[f64]| {
            assert_eq!(found.len(), wanted.len(), "{found:?}");
            assert!(found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-12), "{found:?}");
        };
        near(round_numbers(0.99, 1.01, 4), &[0.99, 0.995, 1.0, 1.005, 1.01]);
        assert_eq!(round_numbers(-3.0, 3.0, 3), [-2.0, 0.0, 2.0]);
        assert!(round_numbers(1.0, 1.0, 3).is_empty() && round_numbers(0.0, f64::INFINITY, 3).is_empty());
    }

    #[test]
    fn numbers_have_the_decimals_that_tell_them_apart() {
        assert_eq!(names(-20.0, 20.0, 4), ["−20", "−10", "0", "10", "20"]);
        assert_eq!(names(100.0, 100.5, 5), ["100.0", "100.1", "100.2", "100.3", "100.4", "100.5"]);
        assert_eq!(names(0.0, 0.02, 2), ["0", "0.01", "0.02"]);
        assert_eq!(names(0.0, 4e7, 2), ["0", "2.0·10⁷", "4.0·10⁷"]);
        assert_eq!(names(9.5e5, 1.01e6, 3), ["960000", "980000", "1000000"]);
    }

    #[test]
    fn an_axis_reaches_to_zero_where_that_is_near_and_holds_a_constant() {
        assert_eq!(Linear::around(1.0, 10.0), Linear { from: -0.54, to: 10.54 });
        assert_eq!(Linear::around(-10.0, -1.0), Linear { from: -10.54, to: 0.54 });
        let steady = Linear::around(-981.0, -981.0);
        assert!(
            steady.from < -981.0 && steady.to > -981.0 && steady.part(-981.0) > 0.3 && steady.part(-981.0) < 0.95,
            "{steady:?}"
        );
        let none = Linear::around(0.0, 0.0);
        assert!(none.from < 0.0 && none.to > 0.0);
    }

    #[test]
    fn an_axis_names_two_numbers_however_little_room_there_is() {
        for (from, to) in [(-0.6, 10.4), (-20.8, 1.2), (-7.0, 7.0), (-981.0 * 1.06, 981.0 * 0.06), (0.013, 0.0141)] {
            let names = names(from, to, 1);
            assert!((2..=4).contains(&names.len()), "{from} to {to}: {names:?}");
        }
    }

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

    proptest! {
        #[test]
        fn all_numbers_lie_on_their_axis(a in -1e6..1e6_f64, span in prop_oneof![Just(0.0), 1e-12..1.0, 1.0..1e6_f64]) {
            let axis = Linear::around(a, a + span);
            prop_assert!(axis.part(a) >= 0.0 && axis.part(a + span) <= 1.0 && axis.to > axis.from);
            let names: Vec<String> = axis.named(5).into_iter().map(|(_, name)| name).collect();
            prop_assert!((2..16).contains(&names.len()));
            let mut distinct = names.clone();
            distinct.dedup();
            prop_assert_eq!(names, distinct);
        }
    }
}
