//! The engine.

mod aabb;
mod body;
mod forces;
mod material;
pub mod pile;
mod world;

pub use aabb::Aabb;
pub use body::{Body, BodyDef, BodyId};
pub use forces::{Force, ForceKind, ForceManager, Source};
pub use glam::DVec2;
pub use material::Material;
pub use world::{DefError, Event, FluidDef, Obstacle, StreamDef, SurfaceDef, World, WorldDef};
