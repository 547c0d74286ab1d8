//! The ship's engine and its rotation under the keys.

use super::clock::Controls;
pub use crate::level::BURN_RATE;
use crate::level::ShipStart;
pub use crate::level::nose;
use crate::physics::{BodyId, DVec2, Force, ForceKind, Source, World};

pub const SHIP: BodyId = BodyId(0);
/// Degrees a second. Higher is twitchier: a quarter turn takes half a second.
pub const ROTATION_RATE: f64 = 180.0;
/// How long the ship stands tilted and without a key before it turns upright or on its side, s. Shorter, and it turns back while a
/// player who aims on the ground changes keys.
const RIGHTING_AFTER: f64 = 0.5;

pub const fn object_body(index: usize) -> BodyId {
    BodyId(index as u32 + 1)
}

#[derive(Clone, Debug, PartialEq)]
pub struct Ship {
    /// Degrees clockwise; 0 is nose up. Not wrapped: a full turn is 360.
    pub angle: f64,
    /// One tick ago, for interpolation.
    pub previous_angle: f64,
    /// Fuel units left.
    pub fuel: f64,
    /// The engine during the last tick: 1 along the nose, −1 against it, 0 off.
    pub burning: i8,
    /// Clockwise ticks minus anticlockwise ticks, and the angle from which they count: that of the start, or the last right angle
    /// of a turn by itself. Angle and fuel are counted, not added up, so that no rounding grows with the flight.
    turned: i64,
    from: f64,
    /// Ticks on the ground, tilted and without a key.
    tilted: u32,
    /// Ticks burnt since the last filling, the fuel then, and the fuel used before, fuel units.
    burnt: u64,
    filled: f64,
    used: f64,
    pub(super) fuel_lasts: bool,
}

impl Ship {
    pub(super) fn new(player: &ShipStart) -> Self {
        Self {
            angle: player.angle,
            previous_angle: player.angle,
            fuel: player.fuel,
            burning: 0,
            turned: 0,
            from: player.angle,
            tilted: 0,
            burnt: 0,
            filled: player.fuel,
            used: 0.0,
            fuel_lasts: false,
        }
    }

    /// Obeys the keys for one tick and returns the engine's drive, N. Left and right cancel each other; so do thrust and reverse, which then burn
    /// nothing. The last tick with fuel burns the rest at full thrust. `stands` answers whether the ship stands still on a surface.
    pub(super) fn obey(&mut self, controls: Controls, player: &ShipStart, tick_rate: f64, stands: impl FnOnce() -> bool) -> DVec2 {
        self.burning = if self.fuel > 0.0 { i8::from(controls.thrust) - i8::from(controls.reverse) } else { 0 };
        self.turn(controls, tick_rate, stands);
        if self.burning == 0 {
            return DVec2::ZERO;
        }
        self.burnt += u64::from(!self.fuel_lasts);
        self.fuel = (self.filled - self.burnt as f64 * BURN_RATE / tick_rate).max(0.0);
        // Adding zero turns a negative zero into zero.
        nose(self.angle) * (f64::from(self.burning) * player.thrust) + DVec2::ZERO
    }

    /// Turns by the keys; a ship that has stood tilted for a while turns by itself, as fast, to the nearest right angle.
    fn turn(&mut self, controls: Controls, tick_rate: f64, stands: impl FnOnce() -> bool) {
        self.previous_angle = self.angle;
        let goal = (self.angle / 90.0).round() * 90.0;
        let let_go = !controls.left && !controls.right && self.burning == 0;
        self.tilted = if let_go && self.angle != goal && stands() { self.tilted.saturating_add(1) } else { 0 };
        if f64::from(self.tilted) <= RIGHTING_AFTER * tick_rate {
            self.turned += i64::from(controls.right) - i64::from(controls.left);
        } else if (goal - self.angle).abs() <= ROTATION_RATE / tick_rate {
            (self.from, self.turned, self.tilted) = (goal, 0, 0);
        } else {
            self.turned += if goal > self.angle { 1 } else { -1 };
        }
        self.angle = self.from + self.turned as f64 * ROTATION_RATE / tick_rate;
    }

    /// Fuel beyond a full tank is lost.
    pub(super) fn refuel(&mut self, fuel: f64, player: &ShipStart) {
        self.used = self.fuel_used();
        self.fuel += fuel.min((player.fuel - self.fuel).max(0.0));
        (self.filled, self.burnt) = (self.fuel, 0);
    }

    pub(super) fn fill(&mut self, fuel: f64) {
        (self.fuel, self.filled) = (fuel, fuel);
    }

    pub(super) fn fuel_used(&self) -> f64 {
        self.used + (self.filled - self.fuel)
    }

    pub fn nose(&self) -> DVec2 {
        nose(self.angle)
    }

    /// Feeds every bit of the state to `write`. The angle from which turns count follows from the angle and the turns.
    pub(super) fn hash_state(&self, write: &mut impl FnMut(u64)) {
        for value in [self.angle, self.previous_angle, self.fuel] {
            write(value.to_bits());
        }
        write(self.burning as u64);
        write(self.turned as u64);
        write(self.burnt);
        if self.tilted != 0 {
            write(u64::from(self.tilted));
        }
        if self.fuel_lasts {
            write(1);
        }
        if self.used != 0.0 {
            write(self.used.to_bits());
            write(self.filled.to_bits());
        }
    }
}

/// The ship stands still below this speed relative to its ground, m/s: far above the rounding of a belt's or a lift's speed.
const STILL: f64 = 1e-6;

/// Whether a body or surface carries the ship against its weight, and the ship does not move on it.
pub(super) fn stands(world: &World) -> bool {
    let (forces, velocity) = (world.forces(SHIP), world.body(SHIP).velocity);
    let weight = forces.total(ForceKind::Weight);
    let carries = |force: &Force| {
        let carrier = match force.source {
            Source::Surface(surface) => world.surfaces()[surface as usize].skin(force.vector.normalize_or_zero()),
            Source::Body(body) => world.body(body).velocity,
            _ => return false,
        };
        matches!(force.kind, ForceKind::Reaction | ForceKind::Push)
            && force.vector.dot(weight) < 0.0
            && velocity.distance(carrier) < STILL
    };
    forces.forces().iter().any(carries)
}
