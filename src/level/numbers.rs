//! The numbers that a level may hold, and the scale from pixels to metres. Physical ranges come from the engine's domain.

use super::route::SHORTEST;
use super::types::{SHIP_HEIGHT, SHIP_PIXELS};
use crate::physics::domain::{self, Range};
use crate::physics::{Aabb, DVec2, Material};
use crate::words::tr;

/// The farthest place from the top left corner, and the largest size, m: beyond it f64 resolves more coarsely than 1e-10 m, and contacts get inexact.
const MAX_DISTANCE: f64 = 1e6;
/// The smallest side, m: well above the tolerances of contacts, also at [`MAX_DISTANCE`].
pub(super) const MIN_SIZE: f64 = 1e-3;

/// A range of accepted numbers, both ends included, with its unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct NumberRange {
    pub low: f64,
    pub high: f64,
    /// In words; empty where there is none.
    pub unit: &'static str,
    /// No number between 0 and this.
    gap: f64,
}

pub(super) const MASS: NumberRange = NumberRange::of(domain::MASS);
pub(super) const FORCE: NumberRange = NumberRange::of(domain::FORCE);
pub(super) const THRUST: NumberRange = NumberRange { low: 0.0, ..NumberRange::of(domain::FORCE) };
pub(super) const FUEL: NumberRange = NumberRange::new(0.0, 1e12, "fuel units");
pub(super) const VELOCITY: NumberRange = NumberRange::of(domain::SPEED);
pub(super) const ANGLE: NumberRange = NumberRange::new(-1e6, 1e6, "degrees");
pub(super) const DRAG: NumberRange = NumberRange::new(0.0, 1e3, "");
pub(super) const RESTITUTION: NumberRange = NumberRange::new(0.0, 1.0, "");
pub(super) const DENSITY: NumberRange = NumberRange::of(domain::DENSITY);
pub(super) const AIR_DENSITY: NumberRange = NumberRange::of(domain::AIR_DENSITY);
pub(super) const VISCOSITY: NumberRange = NumberRange::of(domain::VISCOSITY);
pub(super) const GRAVITY: NumberRange = NumberRange::of(domain::FIELD);
pub(super) const OPTIMAL_TIME: NumberRange = NumberRange::new(1e-3, 1e9, "s");
pub(super) const HOLD: NumberRange = NumberRange::new(0.0, 1e6, "s");
pub(super) const SPEED: NumberRange = NumberRange::new(1e-3, 1e3, "m/s");
pub(super) const BELT: NumberRange = NumberRange::new(-1e3, 1e3, "m/s");
pub(super) const PERIOD: NumberRange = NumberRange::new(1e-2, 1e6, "s");
/// Of a mover: 0, or as long as the engine's shortest leg.
pub(super) const PAUSE: NumberRange = NumberRange { gap: SHORTEST, ..NumberRange::new(0.0, 1e6, "s") };
pub(super) const IMPULSE: NumberRange = NumberRange::new(1e-3, 1e9, "N·s");
pub(super) const LOAD: NumberRange = NumberRange::new(1e-3, 1e9, "N");
pub(super) const STIFFNESS: NumberRange = NumberRange::new(0.0, 1e12, "N/m");
pub(super) const DAMPING: NumberRange = NumberRange::new(0.0, 1e9, "N·s/m");
pub(super) const STRENGTH: NumberRange = NumberRange::new(-1e9, 1e9, "N·m²");
pub(super) const METRE: NumberRange = NumberRange::new(1e-3, 1e6, "pixels a metre");
pub(super) const REST_SPEED: NumberRange = NumberRange { low: 0.0, ..NumberRange::of(domain::SPEED) };
pub(super) const PLACE: NumberRange = NumberRange::new(0.0, MAX_DISTANCE, "m");
pub(super) const SIZE: NumberRange = NumberRange::new(MIN_SIZE, MAX_DISTANCE, "m");
pub(super) const MATERIAL: NumberRange = NumberRange::new(0.0, Material::ALL.len() as f64 - 1.0, "");
pub(super) const WIND: NumberRange = NumberRange::new(0.0, 1e3, "");
/// A factor; with rubber its maximum makes a coefficient of 11.5, beyond any material.
pub(super) const FRICTION: NumberRange = NumberRange::new(0.0, 10.0, "");
pub(super) const MEDAL_TIME: NumberRange = NumberRange::new(1e-3, 1e9, "s");
/// Hits or pushes: a million are more than a flight can have.
pub(super) const MARK_COUNT: NumberRange = NumberRange::new(0.0, 1e6, "");
pub(super) const MARK_FUEL: NumberRange = NumberRange::new(0.0, 100.0, "% of the fuel left");
pub(super) const MARK_SPEED: NumberRange = NumberRange::new(1e-3, 1e4, "m/s");
pub(super) const YES: NumberRange = NumberRange { gap: 1.0, ..NumberRange::new(0.0, 1.0, "") };

impl NumberRange {
    pub const fn new(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, unit, gap: 0.0 }
    }

    pub const fn of(Range { low, high, unit }: Range) -> Self {
        Self::new(low, high, unit)
    }

    /// The number that a cell holds. Errors: the text is no finite number, or it lies outside the range; the number that is expected instead.
    pub fn parse(&self, text: &str) -> Result<f64, String> {
        number(text).and_then(|value| self.judge(value).map(|()| value))
    }

    /// The unit as a field shows it beside a number, or the limits where a number of few digits has no unit.
    pub fn sign(&self) -> String {
        match self.unit {
            "" if self.high < 1e3 => format!("{}–{}", self.low, self.high),
            "fuel units" => tr("units").to_owned(),
            "degrees" => "°".to_owned(),
            "pixels" => "px".to_owned(),
            "pixels a metre" => "px/m".to_owned(),
            unit => unit.split(' ').next().unwrap_or_default().to_owned(),
        }
    }

    /// The limits and the unit, for the documentation.
    pub fn in_words(&self) -> String {
        let gap =
            if self.gap > 0.0 && self.gap < self.high { tr!("0, or {least} … ", least = power(self.gap)) } else { String::new() };
        let low = if gap.is_empty() { power(self.low) + " … " } else { gap };
        let numbers = if self.gap == self.high { tr("0 or 1").to_owned() } else { low + &power(self.high) };
        format!("{numbers} {}", tr(self.unit)).trim_end().to_owned()
    }

    /// Errors: the number that is expected instead.
    pub fn judge(&self, value: f64) -> Result<(), String> {
        if !value.is_finite() {
            return Err(tr("a finite number").into());
        }
        if value < self.low || value > self.high {
            return Err(self.range(value));
        }
        if value > 0.0 && value < self.gap {
            return Err(tr!("0, or at least {least} {unit}", least = short(self.gap), unit = tr(self.unit)).trim_end().to_owned());
        }
        Ok(())
    }

    /// The expected numbers, in place of a `value` outside the range.
    fn range(&self, value: f64) -> String {
        let unit = tr(self.unit);
        let range = if self.low > 0.0 && value <= 0.0 {
            tr!("a number above 0 {unit}", unit)
        } else if self.low == 0.0 && value < 0.0 && self.high >= 1e3 {
            tr!("a number of 0 or more {unit}", unit)
        } else {
            tr!("a number from {low} to {high} {unit}", low = short(self.low), high = short(self.high), unit)
        };
        range.trim_end().to_owned()
    }
}

/// A finite number with a decimal point in every locale; `nan` and `inf`, which Rust accepts, are refused.
pub(super) fn number(text: &str) -> Result<f64, String> {
    let is_plain = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'e' | b'E');
    let plain = |text: &str| text.parse::<f64>().ok().filter(|_| text.bytes().all(is_plain));
    match plain(text) {
        Some(value) if value.is_finite() => Ok(value),
        _ if text.parse::<f64>().is_ok() => Err(tr("a finite number").into()),
        _ if plain(&text.replacen(',', ".", 1)).is_some() => Err(tr("a number with a decimal point, not a comma").into()),
        _ => Err(tr("a number such as 12.5").into()),
    }
}

fn short(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e6).contains(&value.abs()) { format!("{value:e}") } else { value.to_string() }
}

/// A limit as it is printed: from a thousand on, and below a tenth, as a power of ten.
pub(super) fn power(value: f64) -> String {
    let size = value.abs();
    let sign = if value < 0.0 { "−" } else { "" };
    if size == 0.0 || (0.1..1e3).contains(&size) {
        return format!("{sign}{size}");
    }
    let scientific = format!("{size:e}");
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let raised = crate::number::power(exponent.parse().unwrap_or(0));
    if digits == "1" { format!("{sign}{raised}") } else { format!("{sign}{digits}·{raised}") }
}

/// The author's pixels against metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct PixelScale {
    /// Pixels a metre, > 0.
    pub metre: f64,
}

impl PixelScale {
    /// Of a level that gives none: the ship is 51 pixels high.
    pub const USUAL: Self = Self { metre: SHIP_PIXELS / SHIP_HEIGHT };
    /// The smallest size and the farthest distance, m.
    pub const LIMITS: [f64; 2] = [MIN_SIZE, MAX_DISTANCE];

    pub fn coordinate(&self) -> NumberRange {
        NumberRange::new(-MAX_DISTANCE * self.metre, MAX_DISTANCE * self.metre, "pixels")
    }

    pub fn size(&self) -> NumberRange {
        NumberRange::new(MIN_SIZE * self.metre, MAX_DISTANCE * self.metre, "pixels")
    }

    pub fn length(&self) -> NumberRange {
        NumberRange { low: 0.0, ..self.coordinate() }
    }

    /// Pixels to metres.
    pub fn metres(&self, x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y) / self.metre
    }

    /// The rectangle of a row's x, y, width and height, in metres.
    pub fn bounds(&self, place: [f64; 4]) -> Aabb {
        let (min, max) = corners(place);
        self.rectangle(min, max)
    }

    /// A rectangle between two opposite corners in pixels. Each edge is scaled by itself, so that edges which share a pixel share every bit.
    pub fn rectangle(&self, a: DVec2, b: DVec2) -> Aabb {
        Aabb::new(a.min(b) / self.metre, a.max(b) / self.metre)
    }
}

/// The top left and the bottom right corner of x, y, width and height.
pub(super) fn corners([x, y, width, height]: [f64; 4]) -> (DVec2, DVec2) {
    let min = DVec2::new(x, y);
    (min, min + DVec2::new(width, height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_printed_as_powers_of_ten() {
        for (value, text) in [(0.0, "0"), (1e6, "10⁶"), (-1e3, "−10³"), (1e-3, "10⁻³"), (2e4, "2·10⁴"), (255.0, "255")] {
            assert_eq!(power(value), text);
        }
        assert_eq!(PAUSE.in_words(), "0, or 10⁻³ … 10⁶ s");
        assert_eq!(FUEL.in_words(), "0 … 10¹² fuel units");
        assert_eq!((RESTITUTION.sign().as_str(), FUEL.sign().as_str(), YES.in_words().as_str()), ("0–1", "units", "0 or 1"));
    }

    #[test]
    fn numbers_are_plain_and_finite() {
        for (text, value) in [("50", 50.0), ("-0.5", -0.5), ("+3", 3.0), (".5", 0.5), ("1e3", 1000.0), ("2.", 2.0)] {
            assert_eq!(number(text), Ok(value), "{text}");
        }
        for text in ["", "1 000", "0x10", "12px", "−5", "1_0", "e", "--1", "1.2.3"] {
            assert_eq!(number(text), Err("a number such as 12.5".into()), "{text}");
        }
        for text in ["nan", "-NaN", "inf", "-infinity", "1e999"] {
            assert_eq!(number(text), Err("a finite number".into()), "{text}");
        }
        assert_eq!(number("1,5"), Err("a number with a decimal point, not a comma".into()));
    }

    #[test]
    fn ranges_say_what_they_want() {
        assert_eq!(MASS.parse("0"), Err("a number above 0 kg".into()));
        assert_eq!(MASS.parse("1e-10"), Err("a number from 0.001 to 100000 kg".into()));
        assert_eq!(DRAG.parse("-1"), Err("a number of 0 or more".into()));
        assert_eq!(RESTITUTION.parse("1.01"), Err("a number from 0 to 1".into()));
        assert_eq!(RESTITUTION.parse("1"), Ok(1.0));
    }

    #[test]
    fn shared_pixels_share_bits() {
        let scale = PixelScale { metre: 30.0 };
        let left = scale.rectangle(DVec2::new(0.1, 0.0), DVec2::new(0.1 + 0.2, 1.0));
        let right = scale.rectangle(DVec2::new(0.1 + 0.2, 0.0), DVec2::new(7.0, 1.0));
        assert_eq!(left.max.x.to_bits(), right.min.x.to_bits());
    }
}
