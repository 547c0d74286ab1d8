//! How a world begins, and what is refused at the door: nothing that is accepted may ever become non-finite.

use super::{Aabb, BodyDef, Material, SurfaceDef};
use glam::DVec2;

/// A zone that exerts a constant force named "Wind" on every body that touches it.
#[derive(Clone, Debug, PartialEq)]
pub struct StreamDef {
    /// Where it blows, m.
    pub zone: Aabb,
    /// N.
    pub force: DVec2,
}

/// A zone of liquid.
#[derive(Clone, Debug, PartialEq)]
pub struct FluidDef {
    /// Where it is, m.
    pub zone: Aabb,
    /// kg/m³, ≥ 0.
    pub density: f64,
    /// Dynamic viscosity, Pa·s, ≥ 0.
    pub viscosity: f64,
}

/// A zone with a gravity of its own, besides that of the world: a field that accelerates every body that touches it.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldDef {
    /// Where it is, m.
    pub zone: Aabb,
    /// N/kg.
    pub strength: DVec2,
}

/// How a world begins.
#[derive(Clone, Debug, PartialEq)]
pub struct WorldDef {
    /// Gravitational field strength, N/kg, downwards.
    pub gravity: f64,
    /// kg/m³, ≥ 0.
    pub air_density: f64,
    /// A rebound slower than this (m/s) is none. 0: every bounce is kept, and a series of them ends when its sum does.
    pub rest_speed: f64,
    /// The edge of the level: solid on all four sides. `None`: no edge.
    pub bounds: Option<Aabb>,
    /// What the edge is made of.
    pub edge: Material,
    /// Solid, immovable rectangles.
    pub surfaces: Vec<SurfaceDef>,
    /// Air streams.
    pub streams: Vec<StreamDef>,
    /// Fields of gravity besides that of the world; they add up.
    pub fields: Vec<FieldDef>,
    /// Liquids.
    pub fluids: Vec<FluidDef>,
    /// What moves.
    pub bodies: Vec<BodyDef>,
}

impl Default for WorldDef {
    fn default() -> Self {
        Self {
            gravity: 15.0,
            air_density: 1.2041,
            rest_speed: 0.0,
            bounds: None,
            edge: Material::ASPHALT,
            surfaces: Vec::new(),
            streams: Vec::new(),
            fields: Vec::new(),
            fluids: Vec::new(),
            bodies: Vec::new(),
        }
    }
}

/// Why a definition was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct DefError(pub String);

impl std::fmt::Display for DefError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for DefError {}

/// The largest magnitude of any accepted number: squares, products of three and sums of these stay far from overflow.
pub(super) const LARGEST: f64 = 1e12;
/// The smallest accepted mass (kg) and size (m), for the same reason.
const SMALLEST: f64 = 1e-12;

impl WorldDef {
    /// # Errors
    /// The first number that is not finite, too large or out of its range.
    pub(super) fn check(&self) -> Result<(), DefError> {
        number("gravity", self.gravity, -LARGEST)?;
        number("air density", self.air_density, 0.0)?;
        number("rest speed", self.rest_speed, 0.0)?;
        if let Some(bounds) = &self.bounds {
            rectangle("the level's edge", bounds)?;
            material(&self.edge)?;
        }
        for surface in &self.surfaces {
            surface.check()?;
        }
        for stream in &self.streams {
            rectangle("a stream", &stream.zone)?;
            vector("a stream's force", stream.force)?;
        }
        for field in &self.fields {
            rectangle("a field", &field.zone)?;
            vector("a field's strength", field.strength)?;
        }
        for fluid in &self.fluids {
            rectangle("a liquid", &fluid.zone)?;
            number("a liquid's density", fluid.density, 0.0)?;
            number("a liquid's viscosity", fluid.viscosity, 0.0)?;
        }
        self.bodies.iter().try_for_each(BodyDef::check)
    }
}

impl BodyDef {
    /// # Errors
    /// As [`WorldDef::check`].
    pub(super) fn check(&self) -> Result<(), DefError> {
        vector("a body's position", self.position)?;
        vector("a body's velocity", self.velocity)?;
        number("a body's half width", self.half.x, SMALLEST)?;
        number("a body's half height", self.half.y, SMALLEST)?;
        number("a body's mass", self.mass, SMALLEST)?;
        number("a drag coefficient", self.drag, 0.0)?;
        restitution(self.restitution)?;
        material(&self.material)
    }
}

fn restitution(value: f64) -> Result<(), DefError> {
    number("a restitution", value, 0.0)?;
    if value <= 1.0 { Ok(()) } else { Err(DefError(format!("a restitution is {value}, expected 0 … 1"))) }
}

pub(super) fn number(what: &str, value: f64, least: f64) -> Result<(), DefError> {
    if value.is_finite() && value >= least && value.abs() <= LARGEST {
        return Ok(());
    }
    Err(DefError(format!("{what} is {value}, expected a number from {least} to {LARGEST}")))
}

pub(super) fn vector(what: &str, value: DVec2) -> Result<(), DefError> {
    number(what, value.x, -LARGEST).and_then(|()| number(what, value.y, -LARGEST))
}

pub(super) fn rectangle(what: &str, bounds: &Aabb) -> Result<(), DefError> {
    vector(what, bounds.min)?;
    vector(what, bounds.max)?;
    if bounds.min.cmplt(bounds.max).all() {
        return Ok(());
    }
    Err(DefError(format!("{what} is {} m wide and {} m high, expected more than 0", bounds.size().x, bounds.size().y)))
}

pub(super) fn material(material: &Material) -> Result<(), DefError> {
    number("a static friction", material.static_friction, 0.0)?;
    number("a kinetic friction", material.kinetic_friction, 0.0)?;
    restitution(material.restitution)?;
    if material.kinetic_friction <= material.static_friction {
        return Ok(());
    }
    Err(DefError(format!("{}: kinetic friction above static friction", material.name)))
}
