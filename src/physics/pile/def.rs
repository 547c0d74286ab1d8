//! How a pile starts, and what is refused.

use super::super::Aabb;
use glam::DVec2;

/// A body as it starts.
#[derive(Clone, Debug, PartialEq)]
pub struct PileBody {
    /// Centre, m.
    pub position: DVec2,
    /// Half the width and half the height, m, both > 0.
    pub half: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// kg, > 0.
    pub mass: f64,
    /// Coefficient of restitution, 0 … 1; a pair uses the larger.
    pub restitution: f64,
    /// Coefficient of static friction μ_s; a pair uses the smaller, on a surface the surface's counts.
    pub static_friction: f64,
    /// Coefficient of kinetic friction μ_k, likewise.
    pub kinetic_friction: f64,
    /// Drag coefficient times the area of a side, m²: `x` with the width (met by motion up and down), `y` with the height (by motion
    /// across).
    pub drag_area: DVec2,
    /// The same of a round thing, with its diameter; `drag_area` is 0 then.
    pub drag_round: f64,
}

impl Default for PileBody {
    fn default() -> Self {
        Self {
            position: DVec2::ZERO,
            half: DVec2::splat(0.5),
            velocity: DVec2::ZERO,
            mass: 1.0,
            restitution: 0.0,
            static_friction: 0.9,
            kinetic_friction: 0.65,
            drag_area: DVec2::ZERO,
            drag_round: 0.0,
        }
    }
}

/// A solid. It stands still unless it is moved from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct PileSurface {
    /// Where it is, m.
    pub bounds: Aabb,
    /// Coefficient of static friction of what stands on it.
    pub static_friction: f64,
    /// Coefficient of kinetic friction of what slides on it.
    pub kinetic_friction: f64,
}

/// How a pile starts.
#[derive(Clone, Debug, PartialEq)]
pub struct PileDef {
    /// What moves, at least 0 and fewer than 2³¹.
    pub bodies: Vec<PileBody>,
    /// What does not.
    pub surfaces: Vec<PileSurface>,
    /// Gravitational field strength towards larger y, N/kg; negative: towards smaller y.
    pub gravity: f64,
    /// kg/m³, ≥ 0.
    pub air_density: f64,
    /// A rebound slower than this, m/s, is none.
    pub rest_speed: f64,
    /// Whether a pile that rests stops computing. Changes no bit.
    pub sleep: bool,
}

impl Default for PileDef {
    fn default() -> Self {
        Self { bodies: Vec::new(), surfaces: Vec::new(), gravity: 9.81, air_density: 0.0, rest_speed: 1.0, sleep: true }
    }
}

/// Why a definition was refused: what is wrong, and of which body or surface.
#[derive(Clone, Debug, PartialEq)]
pub struct PileError(pub String);

impl std::fmt::Display for PileError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for PileError {}

/// What is wrong with a definition, if anything.
pub(super) fn check(def: &PileDef) -> Result<(), PileError> {
    let wrong = |what: String| Err(PileError(what));
    for (name, value, least) in
        [("gravity", def.gravity, f64::MIN), ("air density", def.air_density, 0.0), ("rest speed", def.rest_speed, 0.0)]
    {
        if !value.is_finite() || value < least {
            return wrong(format!("{name}: {value} is not a number in range"));
        }
    }
    for (i, b) in def.bodies.iter().enumerate() {
        let finite = b.position.is_finite() && b.half.is_finite() && b.velocity.is_finite() && b.drag_area.is_finite();
        let coefficients = [b.restitution, b.static_friction, b.kinetic_friction, b.drag_area.x, b.drag_area.y, b.drag_round];
        if !finite || coefficients.iter().any(|c| !c.is_finite() || *c < 0.0) || b.restitution > 1.0 {
            return wrong(format!("body {i}: a number is not finite or out of range"));
        }
        if b.half.min_element() <= 0.0 || !b.mass.is_finite() || b.mass <= 0.0 {
            return wrong(format!("body {i}: size and mass must be positive"));
        }
    }
    for (i, s) in def.surfaces.iter().enumerate() {
        let finite = s.bounds.min.is_finite() && s.bounds.max.is_finite();
        if !finite || s.bounds.size().min_element() < 0.0 || !(s.static_friction >= 0.0 && s.kinetic_friction >= 0.0) {
            return wrong(format!("surface {i}: a number is not finite or out of range"));
        }
    }
    Ok(())
}
