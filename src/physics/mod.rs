//! The engine.

mod aabb;
mod body;
mod candidates;
mod contacts;
mod crowd;
mod def;
mod flow;
mod forces;
mod impact_time;
mod impacts;
mod interval;
mod material;
mod media;
mod network;
pub mod pile;
mod plan;
mod reactions;
mod show;
mod tuning;
mod world;

pub use aabb::Aabb;
pub use body::{Body, BodyDef, BodyId};
pub use def::{DefError, FluidDef, StreamDef, SurfaceDef, WorldDef};
pub use forces::{Force, ForceKind, ForceManager, Source};
pub use glam::DVec2;
pub use material::Material;
pub use plan::Plan;
pub use world::{Event, Obstacle, World};
