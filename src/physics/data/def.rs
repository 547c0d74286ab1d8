//! How a world begins, and the refusals at the door: no number that is accepted becomes non-finite.

use crate::physics::data::domain::{self, DefError, LIQUIDS_OVERLAP, MOST_LIQUIDS, MOST_ZONES, Range, SMALLEST};
use crate::physics::data::domain::{at_most, both, expect, material, number, rectangle, restitution, vector, within};
use crate::physics::data::{aabb::Aabb, body::BodyDef, link::LinkDef, material::Material, surface::SurfaceDef};
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
    /// Springs, ropes and magnets between them.
    pub links: Vec<LinkDef>,
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
            links: Vec::new(),
        }
    }
}

impl WorldDef {
    /// Refuses a number that is not finite or out of its range; too many zones; liquids that overlap.
    pub(crate) fn check(&self) -> Result<(), DefError> {
        at_most("streams", self.streams.len(), MOST_ZONES)?;
        at_most("fields", self.fields.len(), MOST_ZONES)?;
        at_most("liquids", self.fluids.len(), MOST_LIQUIDS)?;
        within("gravity", self.gravity, domain::FIELD)?;
        within("air density", self.air_density, domain::AIR_DENSITY)?;
        within("rest speed", self.rest_speed, Range { low: 0.0, ..domain::SPEED })?;
        if let Some(bounds) = &self.bounds {
            rectangle("the level's edge", bounds)?;
            material(&self.edge)?;
        }
        self.surfaces.iter().try_for_each(SurfaceDef::check)?;
        for stream in &self.streams {
            rectangle("a stream", &stream.zone)?;
            both("a stream's force", stream.force, domain::FORCE)?;
        }
        for field in &self.fields {
            rectangle("a field", &field.zone)?;
            both("a field's strength", field.strength, domain::FIELD)?;
        }
        for fluid in &self.fluids {
            rectangle("a liquid", &fluid.zone)?;
            within("a liquid's density", fluid.density, domain::DENSITY)?;
            within("a liquid's viscosity", fluid.viscosity, domain::VISCOSITY)?;
        }
        for (i, fluid) in self.fluids.iter().enumerate() {
            let other = self.fluids[..i].iter().position(|other| other.zone.overlaps(&fluid.zone, LIQUIDS_OVERLAP));
            let reason = || format!("the liquids {} and {i} overlap, expected liquids that at most touch", other.unwrap_or(0));
            expect(other.is_none(), reason)?;
        }
        self.bodies.iter().try_for_each(BodyDef::check)
    }
}

impl BodyDef {
    pub(crate) fn check(&self) -> Result<(), DefError> {
        vector("a body's position", self.position)?;
        both("a body's velocity", self.velocity, domain::LAB_SPEED)?;
        number("a body's half width", self.half.x, SMALLEST)?;
        number("a body's half height", self.half.y, SMALLEST)?;
        within("a body's mass", self.mass, domain::LAB_MASS)?;
        number("a drag coefficient", self.drag, 0.0)?;
        restitution(self.restitution)?;
        material(&self.material)
    }
}
