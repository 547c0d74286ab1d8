//! The engine: boxes moved by named forces, as exact as a scene allows.
//!
//! It knows no pixel, window, clock, file or randomness. One call, [`World::step`], advances a world by one tick. The same start and the same
//! calls give the same bits everywhere: arithmetic is `+ − × ÷ √` and the `libm` crate. Bodies, forces, contacts and motion live here; rules
//! (fuel, objectives, score), files and drawing do not.
//!
//! # A tick
//!
//! `step` holds the stages in their order. Surfaces follow their paths; linked groups and bodies near liquids or borders of zones get their
//! flight (`links`, `acting`); every awake body flies as if it touched nothing (`crowd::flight`); the broad phase finds the pairs that may meet
//! (`store::broad_phase`), and the groups of those pairs are **islands** (`store::islands`). `islands` chooses a method for each:
//!
//! - an island asleep costs nothing; a body alone keeps its free flight (`forces::air`, `flight`);
//! - up to 64 bodies go from event to event (`exact`), within a budget of events;
//! - a larger island, or one beyond its budget, takes its whole tick in one crowd step (`crowd`).
//!
//! From event to event means: resolve impacts, the fastest first (`exact::impacts`); solve contacts for accelerations (`exact::motions`,
//! `contact`); move along parabolas, flows or slides; find the next event on those paths (`exact::predict`, `data::impact_time`).
//!
//! # Rooms
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
//! | `world`, `step`, `acting`, `changes`, `links`, `known_contacts`, `scratch`, `space` | the state, a tick, changes between ticks, buffers |
//! | `validate`, `guards`, `hash` | laws that hold after every tick, counts of every cap, the bits of the state |
//!
//! # Principles
//!
//! - **Closed forms first.** Free fall is a parabola; a box in air has a closed form; a step through a liquid is as long as its own error estimate
//!   allows and never crosses a kink of the law.
//! - **Nothing tunnels.** Impacts are roots of a polynomial along the whole path; a crowd step limits each approach to its gap.
//! - **Axes separate.** Normals of boxes are axis-aligned, so contact forces are one exact problem an axis; only friction couples them.
//! - **Rest is exact.** A resting body has velocity, acceleration and resultant 0, bit for bit, and sleeps until a change reaches it.
//! - **Islands are independent.** No bit of an island depends on another one.
//! - **No tick freezes.** Events are counted, not time; `guards` counts every cap and approximation.
//!
//! Rotation, round contact shapes, compressible or moving liquids are not modelled. `docs/physics.md` has every law with its file, formulas, errors
//! and sources, and says how to add to the engine. `data::tuning` holds the tolerances that several files share; others stand beside their use.

pub(crate) mod acting;
pub(crate) mod changes;
pub(crate) mod checks;
pub(crate) mod contact;
pub(crate) mod crowd;
pub(crate) mod data;
pub(crate) mod exact;
pub(crate) mod flight;
pub(crate) mod forces;
pub(crate) mod guards;
pub(crate) mod hash;
pub(crate) mod islands;
pub(crate) mod known_contacts;
pub(crate) mod links;
pub(crate) mod look;
pub(crate) mod scratch;
pub(crate) mod space;
pub(crate) mod state;
pub(crate) mod step;
pub(crate) mod store;
#[cfg(test)]
mod tests;
pub(crate) mod validate;
pub(crate) mod world;

pub use data::aabb::Aabb;
pub use data::body::{Body, BodyDef, BodyId};
pub use data::def::{FieldDef, FluidDef, StreamDef, WorldDef};
pub(crate) use data::domain;
pub use data::domain::DefError;
pub use data::impulse::{Impulse, Obstacle};
pub use data::material::Material;
pub use data::plan::Plan;
pub use data::surface::{Leg, Path, PathPoint, Sides, Surface, SurfaceDef};
pub use forces::kind::{ForceKind, Source};
pub use forces::link::*;
pub use forces::manager::{Force, ForceManager};
pub use glam::DVec2;
pub use guards::Guards;
pub use state::{Event, Methods};
pub use world::World;
