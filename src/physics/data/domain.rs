//! The domain: the ranges of numbers that a level may hold, both ends included, and the refusals of others.

use crate::physics::data::{aabb::Aabb, material::Material};
use glam::DVec2;

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
/// The ratio of 1e-8 is ten thousand times the tolerance of reactions.
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

/// 1/s² and 1/s: the most stiffness and damping per mass that the links of a body may come to. More: a tick takes thousands of steps.
pub(crate) const MOST_STIFFNESS: f64 = 1e7;
pub(crate) const MOST_DAMPING: f64 = 1e4;

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

/// The largest magnitude of any accepted number, and the smallest size, m: products of three stay far from overflow.
pub(crate) const LARGEST: f64 = 1e12;
pub(crate) const SMALLEST: f64 = 1e-12;

/// The most streams of a world, and the most fields of gravity: a set of zones is a word of bits. The most liquids.
pub(crate) const MOST_ZONES: usize = 64;
pub(crate) const MOST_LIQUIDS: usize = 16;
/// m. The insides of two liquids may share so much: the rounding of places in pixels.
pub(crate) const LIQUIDS_OVERLAP: f64 = 1e-6;

/// Refuses by the reason, unless the condition `holds`.
pub(crate) fn expect(holds: bool, reason: impl FnOnce() -> String) -> Result<(), DefError> {
    if holds { Ok(()) } else { Err(DefError(reason())) }
}

pub(crate) fn at_most(what: &str, count: usize, most: usize) -> Result<(), DefError> {
    expect(count <= most, || format!("{count} {what}, expected at most {most}"))
}

pub(crate) fn restitution(value: f64) -> Result<(), DefError> {
    number("a restitution", value, 0.0)?;
    expect(value <= 1.0, || format!("a restitution is {value}, expected 0 … 1"))
}

pub(crate) fn within(what: &str, value: f64, Range { low, high, unit }: Range) -> Result<(), DefError> {
    expect((low..=high).contains(&value), || format!("{what} is {value}, expected {low} to {high} {unit}"))
}

pub(crate) fn both(what: &str, value: DVec2, range: Range) -> Result<(), DefError> {
    within(what, value.x, range).and_then(|()| within(what, value.y, range))
}

pub(crate) fn number(what: &str, value: f64, least: f64) -> Result<(), DefError> {
    let holds = value >= least && value.abs() <= LARGEST;
    expect(holds, || format!("{what} is {value}, expected a number from {least} to {LARGEST}"))
}

pub(crate) fn vector(what: &str, value: DVec2) -> Result<(), DefError> {
    number(what, value.x, -LARGEST).and_then(|()| number(what, value.y, -LARGEST))
}

pub(crate) fn rectangle(what: &str, bounds: &Aabb) -> Result<(), DefError> {
    vector(what, bounds.min)?;
    vector(what, bounds.max)?;
    let DVec2 { x, y } = bounds.size();
    expect(x > 0.0 && y > 0.0, || format!("{what} is {x} m wide and {y} m high, expected more than 0"))
}

pub(crate) fn material(material: &Material) -> Result<(), DefError> {
    number("a static friction", material.static_friction, 0.0)?;
    number("a kinetic friction", material.kinetic_friction, 0.0)?;
    restitution(material.restitution)?;
    let holds = material.kinetic_friction <= material.static_friction;
    expect(holds, || format!("{}: kinetic friction above static friction", material.name))
}
