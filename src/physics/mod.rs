//! The engine: boxes moved by named forces, as exact as a scene allows.
//!
//! It knows no pixel, window, clock, file or randomness. One call, [`World::step`], advances a world by one tick. The same start and the same
//! calls give the same bits everywhere: arithmetic is `+ − × ÷ √` and the `libm` crate. Rules (fuel, objectives, score), files and drawing
//! stand elsewhere. `docs/physics.md` has the tick stage by stage and every law with its file, formulas, errors and sources, and says how to add
//! to the engine.
//!
//! | room | holds |
//! |---|---|
//! | `data` | plain structs: bodies, surfaces, materials, contacts, definitions, ranges, tolerances, the plan |
//! | `forces` | the force manager that moves a body, and a file a law |
//! | `flight` | one body, or one linked group, without contacts |
//! | `contact` | reactions and friction of contact networks, exact |
//! | `exact` | the method of events: time of impact, impacts, ties, bounces, slides |
//! | `crowd` | one step of an island of any size |
//! | `store` | arrays of all bodies, broad phase, islands, sleep, the loop over islands |
//! | `world`, `step`, `commit`, `acting`, `changes`, `links`, `scratch`, `space` | the state, a tick, changes between ticks, buffers |
//! | `validate`, `hash` | laws that hold after every tick, the bits of the state |
//!
//! Rotation, round contact shapes, compressible or moving liquids are not modelled.

pub(crate) mod acting;
pub(crate) mod changes;
pub(crate) mod checks;
pub(crate) mod commit;
pub(crate) mod contact;
pub(crate) mod crowd;
pub(crate) mod data;
pub(crate) mod exact;
pub(crate) mod flight;
pub(crate) mod forces;
pub(crate) mod hash;
pub(crate) mod islands;
pub(crate) mod links;
pub(crate) mod scratch;
pub(crate) mod space;
pub(crate) mod state;
pub(crate) mod step;
pub(crate) mod store;
#[cfg(test)]
mod tests;
pub(crate) mod validate;
pub(crate) mod world;

/// Names the engine's sources: what was measured with others is stale.
pub const SOURCES: &str = env!("PHYSICS_SOURCES");

pub use data::def::{FieldDef, FluidDef, StreamDef, WorldDef};
pub(crate) use data::domain;
pub use data::surface::{Leg, Path, PathPoint, Sides, Surface, SurfaceDef};
pub use data::{aabb::Aabb, body::Body, body::BodyDef, body::BodyId, contact::Impulse, contact::Obstacle, domain::DefError};
pub use data::{link::*, material::Material, plan::OPTIONAL, plan::Plan};
pub use forces::{kind::ForceKind, kind::Source, link::Link, manager::Force, manager::ForceManager};
pub use glam::DVec2;
pub use state::{Event, Guards, Methods};
pub use world::World;
