//! The domain: the ranges of numbers that a level may hold, both ends included. The loader of levels and the engine's door read them here.

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
