//! Drag of air and liquids: −½·ρ·C_d·(w·|u_y| + h·|u_x|)·u on a box of w × h, 1 m deep (the area that it shows along u); on a round body
//! −½·ρ·C_d·d·|u|·u with d its diameter (Batchelor, *An Introduction to Fluid Dynamics*, 5.11).

use crate::physics::{data::Body, data::Part, data::called, forces::media::Media};
use glam::DVec2;

/// Drag of a medium on a body, per mass: s(u) = tall·|u_x| + wide·|u_y| + round·|u|, each ½·ρ·C_d·side/m, 1/m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Drag {
    /// Of the height, met by motion across.
    pub tall: f64,
    /// Of the width, met by motion up and down.
    pub wide: f64,
    /// Of the diameter of a round thing; its other two are 0.
    pub round: f64,
}

impl Drag {
    /// In a medium of `density`, kg/m³.
    pub fn of(body: &Body, density: f64) -> Self {
        let of = |side: f64| 0.5 * density * (body.drag * side) / body.mass;
        if body.round {
            return Self { round: of(body.half.x + body.half.y), ..Self::default() };
        }
        Self { tall: of(2.0 * body.half.y), wide: of(2.0 * body.half.x), round: 0.0 }
    }

    /// s(u), 1/s.
    pub fn rate(&self, u: DVec2) -> f64 {
        let box_ = self.tall * u.x.abs() + self.wide * u.y.abs();
        if self.round > 0.0 { box_ + self.round * u.length() } else { box_ }
    }

    /// How s(u) changes with u, 1/m.
    pub fn slope(&self, u: DVec2) -> DVec2 {
        let box_ = DVec2::new(self.tall.copysign(u.x), self.wide.copysign(u.y));
        let speed = u.length();
        if self.round > 0.0 && speed > 0.0 { box_ + u * (self.round / speed) } else { box_ }
    }

    /// −∂a/∂u along the axes, 1/s.
    pub fn stiffness(&self, u: DVec2) -> DVec2 {
        let speed = u.length();
        let round = if speed > 0.0 { self.round / speed } else { 0.0 };
        DVec2::splat(self.rate(u)) + DVec2::new(self.tall * u.x.abs(), self.wide * u.y.abs()) + u * u * round
    }

    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    pub fn scaled(&self, factor: f64) -> Self {
        Self { tall: self.tall * factor, wide: self.wide * factor, round: self.round * factor }
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self { tall: self.tall + other.tall, wide: self.wide + other.wide, round: self.round + other.round }
    }
}

impl Media {
    pub fn air(&self, body: &Body) -> Drag {
        if !(self.airy && body.feels_air) {
            return Drag::default();
        }
        called(Part::Air);
        Drag::of(body, self.air_density)
    }
}
