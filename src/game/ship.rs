//! The ship's engine and its rotation: what the keys do.

use super::Controls;
pub use crate::level::BURN_RATE;
use crate::level::Player;
use crate::physics::DVec2;

/// Degrees a second while a rotation key is held. Higher is twitchier: a quarter turn takes half a second.
pub const ROTATION_RATE: f64 = 180.0;

/// What the ship has besides its body.
#[derive(Clone, Debug, PartialEq)]
pub struct Ship {
    /// Degrees clockwise; 0 is nose up. Not wrapped: a full turn is 360.
    pub angle: f64,
    /// The angle one tick ago (for interpolation).
    pub previous_angle: f64,
    /// Fuel units left.
    pub fuel: f64,
    /// The engine during the last tick: 1 along the nose, −1 against it, 0 off.
    pub burning: i8,
    /// Ticks rotated clockwise minus ticks rotated anticlockwise. Angle and fuel are counted, not added up, so that they stay
    /// free of rounding that grows with the flight.
    turned: i64,
    /// Ticks burnt since the tank was last filled, how much was in it then, and what had been used before, fuel units.
    burnt: u64,
    filled: f64,
    used: f64,
    /// Whether the engine burns no fuel.
    pub(super) fuel_lasts: bool,
}

impl Ship {
    /// The ship at the start of a level.
    pub(super) fn new(player: &Player) -> Self {
        Self {
            angle: player.angle,
            previous_angle: player.angle,
            fuel: player.fuel,
            burning: 0,
            turned: 0,
            burnt: 0,
            filled: player.fuel,
            used: 0.0,
            fuel_lasts: false,
        }
    }

    /// Obeys the keys for one tick and returns the engine's drive during it, N. Left and right cancel each other; so do thrust and
    /// reverse, which then burn nothing. The last tick with fuel burns what is left of it, at full thrust.
    pub(super) fn obey(&mut self, controls: Controls, player: &Player, tick_rate: f64) -> DVec2 {
        self.previous_angle = self.angle;
        self.turned += i64::from(controls.right) - i64::from(controls.left);
        self.angle = player.angle + self.turned as f64 * ROTATION_RATE / tick_rate;

        self.burning = if self.fuel > 0.0 { i8::from(controls.thrust) - i8::from(controls.reverse) } else { 0 };
        if self.burning == 0 {
            return DVec2::ZERO;
        }
        self.burnt += u64::from(!self.fuel_lasts);
        self.fuel = (self.filled - self.burnt as f64 * BURN_RATE / tick_rate).max(0.0);
        // Adding zero turns a negative zero into zero.
        nose(self.angle) * (f64::from(self.burning) * player.thrust) + DVec2::ZERO
    }

    /// Takes up fuel, as much of it as the tank holds.
    pub(super) fn refuel(&mut self, fuel: f64, player: &Player) {
        self.used = self.fuel_used();
        self.fuel += fuel.min((player.fuel - self.fuel).max(0.0));
        (self.filled, self.burnt) = (self.fuel, 0);
    }

    /// Begins with so much in the tank, fuel units.
    pub(super) fn fill(&mut self, fuel: f64) {
        (self.fuel, self.filled) = (fuel, fuel);
    }

    /// Fuel units burnt.
    pub(super) fn fuel_used(&self) -> f64 {
        self.used + (self.filled - self.fuel)
    }

    /// The unit vector along the nose.
    pub fn nose(&self) -> DVec2 {
        nose(self.angle)
    }

    /// Feeds every bit of the state to `write`.
    pub(super) fn hash_state(&self, write: &mut impl FnMut(u64)) {
        for value in [self.angle, self.previous_angle, self.fuel] {
            write(value.to_bits());
        }
        write(self.burning as u64);
        write(self.turned as u64);
        write(self.burnt);
        if self.fuel_lasts {
            write(1);
        }
        if self.used != 0.0 {
            write(self.used.to_bits());
            write(self.filled.to_bits());
        }
    }
}

/// The unit vector that points `angle` degrees clockwise from straight up. Whole quarter turns are taken out before the sine and
/// the cosine, so that right angles are exact and many turns cost no digits.
pub fn nose(angle: f64) -> DVec2 {
    let quarters = (angle / 90.0).round();
    let (sin, cos) = libm::sincos((angle - quarters * 90.0).to_radians());
    match quarters.rem_euclid(4.0) as u8 {
        0 => DVec2::new(sin, -cos),
        1 => DVec2::new(cos, sin),
        2 => DVec2::new(-sin, cos),
        _ => DVec2::new(-cos, -sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nose_points_where_the_angle_says() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        for (angle, expected) in [
            (0.0, DVec2::new(0.0, -1.0)),
            (90.0, DVec2::new(1.0, 0.0)),
            (180.0, DVec2::new(0.0, 1.0)),
            (270.0, DVec2::new(-1.0, 0.0)),
            (-90.0, DVec2::new(-1.0, 0.0)),
            (-360_000.0, DVec2::new(0.0, -1.0)),
        ] {
            assert_eq!(nose(angle), expected, "{angle} degrees");
        }
        for (angle, expected) in
            [(45.0, DVec2::new(half, -half)), (-45.0, DVec2::new(-half, -half)), (585.0, DVec2::new(-half, half))]
        {
            assert!(nose(angle).distance(expected) < 1e-15, "{angle} degrees: {}", nose(angle));
        }
        for angle in (-720..720).map(|tenth| f64::from(tenth) * 0.7) {
            let (sin, cos) = angle.to_radians().sin_cos();
            assert!(nose(angle).distance(DVec2::new(sin, -cos)) < 1e-14, "{angle} degrees");
        }
    }
}
