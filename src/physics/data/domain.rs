//! The domain: the ranges of numbers that a level may hold, both ends included, and the refusal of what is outside. The loader of levels and the
//! engine's door read them here.

use crate::physics::data::aabb::Aabb;
use crate::physics::data::material::Material;
use glam::DVec2;

/// A range of accepted numbers with its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    pub low: f64,
    pub high: f64,
    pub unit: &'static str,
}

const fn range(low: f64, high: f64, unit: &'static str) -> Range {
    Range { low, high, unit }
}

/// Of every component. At 120 Hz a body passes 83 m a tick.
pub(crate) const SPEED: Range = range(-1e4, 1e4, "m/s");
/// The lightest weighs 1e-8 of the heaviest: ten thousand times what counts as no force when reactions are shared out.
pub(crate) const MASS: Range = range(1e-3, 1e5, "kg");
/// Of a liquid; osmium has 2.26e4.
pub(crate) const DENSITY: Range = range(0.0, 2e4, "kg/m³");
/// Of the air; that of Venus has 65 at the ground.
pub(crate) const AIR_DENSITY: Range = range(0.0, 100.0, "kg/m³");
/// Of a liquid; pitch at 80 °C has about 1e3.
pub(crate) const VISCOSITY: Range = range(0.0, 1e3, "Pa·s");
/// Of gravity and of other fields, each component; the Sun's surface has 274.
pub(crate) const FIELD: Range = range(-1e3, 1e3, "N/kg");
/// Of an engine or a stream, each component.
pub(crate) const FORCE: Range = range(-1e6, 1e6, "N");
/// What a force may give to the lightest body, m/s²: 0.7 m a tick at 120 Hz.
pub(crate) const MOST_ACCELERATION: f64 = 1e4;

/// The Lab compares methods beyond every level: up to a mass ratio of 1e8 and to 1e6 m/s.
pub(crate) const LAB_MASS: Range = range(1e-9, 1e9, "kg");
pub(crate) const LAB_SPEED: Range = range(-1e6, 1e6, "m/s");

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
pub(crate) const LARGEST: f64 = 1e12;
/// The smallest accepted size, m, for the same reason.
pub(crate) const SMALLEST: f64 = 1e-12;

/// The most streams, fields of gravity and liquids of a world. A set of zones is a word of bits.
pub(crate) const MOST_STREAMS: usize = 64;
pub(crate) const MOST_FIELDS: usize = 64;
pub(crate) const MOST_LIQUIDS: usize = 16;
/// m. The insides of two liquids may share so much: the rounding of places in pixels.
pub(crate) const LIQUIDS_OVERLAP: f64 = 1e-6;

pub(crate) fn at_most(what: &str, count: usize, most: usize) -> Result<(), DefError> {
    if count <= most { Ok(()) } else { Err(DefError(format!("{count} {what}, expected at most {most}"))) }
}

pub(crate) fn restitution(value: f64) -> Result<(), DefError> {
    number("a restitution", value, 0.0)?;
    if value <= 1.0 { Ok(()) } else { Err(DefError(format!("a restitution is {value}, expected 0 … 1"))) }
}

pub(crate) fn within(what: &str, value: f64, range: Range) -> Result<(), DefError> {
    let Range { low, high, unit } = range;
    if (low..=high).contains(&value) {
        Ok(())
    } else {
        Err(DefError(format!("{what} is {value}, expected {low} to {high} {unit}")))
    }
}

pub(crate) fn both(what: &str, value: DVec2, range: Range) -> Result<(), DefError> {
    within(what, value.x, range).and_then(|()| within(what, value.y, range))
}

pub(crate) fn number(what: &str, value: f64, least: f64) -> Result<(), DefError> {
    if value.is_finite() && value >= least && value.abs() <= LARGEST {
        return Ok(());
    }
    Err(DefError(format!("{what} is {value}, expected a number from {least} to {LARGEST}")))
}

pub(crate) fn vector(what: &str, value: DVec2) -> Result<(), DefError> {
    number(what, value.x, -LARGEST).and_then(|()| number(what, value.y, -LARGEST))
}

pub(crate) fn rectangle(what: &str, bounds: &Aabb) -> Result<(), DefError> {
    vector(what, bounds.min)?;
    vector(what, bounds.max)?;
    if bounds.min.cmplt(bounds.max).all() {
        return Ok(());
    }
    Err(DefError(format!("{what} is {} m wide and {} m high, expected more than 0", bounds.size().x, bounds.size().y)))
}

pub(crate) fn material(material: &Material) -> Result<(), DefError> {
    number("a static friction", material.static_friction, 0.0)?;
    number("a kinetic friction", material.kinetic_friction, 0.0)?;
    restitution(material.restitution)?;
    if material.kinetic_friction <= material.static_friction {
        return Ok(());
    }
    Err(DefError(format!("{}: kinetic friction above static friction", material.name)))
}
