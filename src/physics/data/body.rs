//! Bodies: what moves.

use crate::physics::data::{aabb::Aabb, material::Coefficients, material::Material};
use glam::DVec2;

/// Place (m) and velocity (m/s).
pub(crate) type Pose = (DVec2, DVec2);

/// Uniformly accelerated motion for `t` seconds.
pub(crate) fn parabola((x, v): Pose, a: DVec2, t: f64) -> Pose {
    (x + (v * t + a * (0.5 * t * t)), v + a * t)
}

/// A vector with this part along an axis (0: x, 1: y) and that part across.
#[inline(always)]
pub(crate) fn on_axis(axis: usize, along: f64, across: f64) -> DVec2 {
    if axis == 0 { DVec2::new(along, across) } else { DVec2::new(across, along) }
}

/// A body's index in its world; the ship of a level is body 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyId(pub u32);

impl BodyId {
    /// As an index into per-body arrays.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// How a body begins: a [`Body`] whose acceleration says nothing yet.
pub type BodyDef = Body;

/// A body as it is after the last tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Centre, m.
    pub position: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// The acceleration that acted last, m/s².
    pub acceleration: DVec2,
    /// Half the width and half the height, m, both > 0.
    pub half: DVec2,
    /// kg, > 0.
    pub mass: f64,
    /// Drag coefficient C_d, ≥ 0.
    pub drag: f64,
    /// Whether a medium meets it as a ball with the mean of width and height as diameter; contacts are those of its box in any case.
    pub round: bool,
    /// Coefficient of restitution, 0 … 1.
    pub restitution: f64,
    /// What it is made of; a pair of bodies slides with the smaller coefficients of the two.
    pub material: Material,
    /// Whether air resistance acts on it.
    pub feels_air: bool,
    /// Whether no gravity acts on it.
    pub weightless: bool,
}

impl Default for Body {
    fn default() -> Self {
        Self {
            position: DVec2::ZERO,
            velocity: DVec2::ZERO,
            acceleration: DVec2::ZERO,
            half: DVec2::splat(0.5),
            mass: 1.0,
            drag: 1.0,
            round: false,
            restitution: 0.0,
            material: Material::ASPHALT,
            feels_air: true,
            weightless: false,
        }
    }
}

impl Body {
    /// A body at the start; it bounces at least as its material does.
    pub(crate) fn new(def: &BodyDef) -> Self {
        Self { acceleration: DVec2::ZERO, restitution: def.restitution.max(def.material.restitution), ..def.clone() }
    }

    /// The mean force that takes up its motion at this `speed` (m/s) while it gives way by half of its smaller side, N.
    pub(crate) fn crushing_force(&self, speed: f64) -> f64 {
        0.5 * self.mass * speed * speed / self.half.min_element()
    }

    pub(crate) fn coefficients(&self) -> Coefficients {
        Coefficients { restitution: self.restitution, ..self.material.coefficients() }
    }

    /// The box it fills, m.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.position, self.half)
    }
}
