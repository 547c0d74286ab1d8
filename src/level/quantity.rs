//! Which numbers a level may hold, and the scale from pixels to metres.
//!
//! Physical ranges are those of the engine's domain. What depends on two cells together is in `strength`.

use super::route::SHORTEST;
use crate::physics::domain::{self, Range};
use crate::physics::{Aabb, DVec2};

/// Farthest that anything may lie from the level's top left corner, and the largest size, m. Above it f64 resolves positions
/// more coarsely than 1e-10 m and contacts lose their exactness.
const MAX_DISTANCE: f64 = 1e6;
/// Smallest side of anything, m. It must stay well above the tolerances of contacts, also at [`MAX_DISTANCE`].
pub(super) const MIN_SIZE: f64 = 1e-3;

/// A range of accepted numbers, both ends included, with its unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity {
    low: f64,
    high: f64,
    unit: &'static str,
    /// Nothing between 0 and this.
    gap: f64,
}

pub(super) const MASS: Quantity = Quantity::of(domain::MASS);
pub(super) const FORCE: Quantity = Quantity::of(domain::FORCE);
pub(super) const THRUST: Quantity = Quantity { low: 0.0, ..Quantity::of(domain::FORCE) };
pub(super) const FUEL: Quantity = Quantity::new(0.0, 1e12, "fuel units");
pub(super) const VELOCITY: Quantity = Quantity::of(domain::SPEED);
pub(super) const ANGLE: Quantity = Quantity::new(-1e6, 1e6, "degrees");
pub(super) const DRAG: Quantity = Quantity::new(0.0, 1e3, "");
pub(super) const RESTITUTION: Quantity = Quantity::new(0.0, 1.0, "");
pub(super) const DENSITY: Quantity = Quantity::of(domain::DENSITY);
pub(super) const AIR_DENSITY: Quantity = Quantity::of(domain::AIR_DENSITY);
pub(super) const VISCOSITY: Quantity = Quantity::of(domain::VISCOSITY);
pub(super) const COLOUR: Quantity = Quantity::new(0.0, 255.0, "");
pub(super) const GRAVITY: Quantity = Quantity::of(domain::FIELD);
pub(super) const OPTIMAL_TIME: Quantity = Quantity::new(1e-3, 1e9, "s");
pub(super) const HOLD: Quantity = Quantity::new(0.0, 1e6, "s");
/// Faster than anything that one could ride on or see.
pub(super) const SPEED: Quantity = Quantity::new(1e-3, 1e3, "m/s");
pub(super) const BELT: Quantity = Quantity::new(-1e3, 1e3, "m/s");
pub(super) const PERIOD: Quantity = Quantity::new(1e-2, 1e6, "s");
/// Of a mover: nothing, or as long as the engine's shortest leg.
pub(super) const PAUSE: Quantity = Quantity { gap: SHORTEST, ..Quantity::new(0.0, 1e6, "s") };
pub(super) const IMPULSE: Quantity = Quantity::new(1e-3, 1e9, "N·s");
pub(super) const LOAD: Quantity = Quantity::new(1e-3, 1e9, "N");
pub(super) const METRE: Quantity = Quantity::new(1e-3, 1e6, "pixels a metre");
pub(super) const REST_SPEED: Quantity = Quantity { low: 0.0, ..Quantity::of(domain::SPEED) };
/// What all winds are multiplied by.
pub(super) const WIND: Quantity = Quantity::new(0.0, 1e3, "");
/// A factor; with rubber it makes a coefficient of 11.5, beyond anything there is.
pub(super) const FRICTION: Quantity = Quantity::new(0.0, 10.0, "");
/// 0 or 1.
pub(super) const YES: Quantity = Quantity { gap: 1.0, ..Quantity::new(0.0, 1.0, "") };

impl Quantity {
    pub const fn new(low: f64, high: f64, unit: &'static str) -> Self {
        Self { low, high, unit, gap: 0.0 }
    }

    pub const fn of(Range { low, high, unit }: Range) -> Self {
        Self::new(low, high, unit)
    }

    /// The number that a cell holds.
    ///
    /// # Errors
    /// What is expected instead: the text is no finite number, or it lies outside the range.
    pub fn parse(&self, text: &str) -> Result<f64, String> {
        let value = number(text)?;
        self.judge(value).map(|()| value)
    }

    /// The least and the most that is accepted.
    pub const fn limits(&self) -> (f64, f64) {
        (self.low, self.high)
    }

    /// Whether a number is accepted.
    ///
    /// # Errors
    /// What is expected instead.
    pub fn judge(&self, value: f64) -> Result<(), String> {
        if !value.is_finite() {
            return Err("a finite number".into());
        }
        if value < self.low || value > self.high {
            return Err(self.range(value));
        }
        if value > 0.0 && value < self.gap {
            return Err(format!("0, or at least {} {}", short(self.gap), self.unit).trim_end().to_owned());
        }
        Ok(())
    }

    /// What is expected instead of a `value` outside the range.
    fn range(&self, value: f64) -> String {
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        if self.low > 0.0 && value <= 0.0 {
            "a number above 0".to_owned() + &unit
        } else if self.low == 0.0 && value < 0.0 && self.high >= 1e3 {
            "a number of 0 or more".to_owned() + &unit
        } else {
            format!("a number from {} to {}{unit}", short(self.low), short(self.high))
        }
    }
}

/// A finite number with a decimal point, whatever the locale; Rust's own `nan` and `inf` are none.
fn number(text: &str) -> Result<f64, String> {
    let plain = |text: &str| {
        let digits = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E'));
        if digits { text.parse::<f64>().ok() } else { None }
    };
    match plain(text) {
        Some(value) if value.is_finite() => Ok(value),
        Some(_) => Err("a finite number".into()),
        None if text.parse::<f64>().is_ok() => Err("a finite number".into()),
        None if plain(&text.replacen(',', ".", 1)).is_some() => Err("a number with a decimal point, not a comma".into()),
        None => Err("a number such as 12.5".into()),
    }
}

/// A limit as people write it.
fn short(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e6).contains(&value.abs()) { format!("{value:e}") } else { value.to_string() }
}

/// The author's pixels against metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    /// Pixels a metre, > 0.
    pub metre: f64,
}

impl Scale {
    /// Any coordinate, in pixels.
    pub fn coordinate(&self) -> Quantity {
        Quantity::new(-MAX_DISTANCE * self.metre, MAX_DISTANCE * self.metre, "pixels")
    }

    /// Any width, height or size, in pixels.
    pub fn size(&self) -> Quantity {
        Quantity::new(MIN_SIZE * self.metre, MAX_DISTANCE * self.metre, "pixels")
    }

    /// Pixels to metres.
    pub fn metres(&self, x: f64, y: f64) -> DVec2 {
        DVec2::new(x / self.metre, y / self.metre)
    }

    /// A rectangle between two opposite corners in pixels. Each edge is scaled by itself, so that edges which share a pixel share
    /// every bit.
    pub fn rectangle(&self, a: DVec2, b: DVec2) -> Aabb {
        Aabb::new(a.min(b) / self.metre, a.max(b) / self.metre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let scale = Scale { metre: 30.0 };
        let left = scale.rectangle(DVec2::new(0.1, 0.0), DVec2::new(0.1 + 0.2, 1.0));
        let right = scale.rectangle(DVec2::new(0.1 + 0.2, 0.0), DVec2::new(7.0, 1.0));
        assert_eq!(left.max.x.to_bits(), right.min.x.to_bits());
    }
}
