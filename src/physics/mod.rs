//! The engine: boxes moved by named forces, as exact as a scene allows.
//!
//! It knows no pixel, window, clock, file or randomness. One call, [`World::step`], advances a world by one tick; the same start and the
//! same calls give the same bits everywhere, because nothing but `+ − × ÷ √` and the `libm` crate ever touches a number. Here live bodies,
//! forces, contacts and motion; rules (fuel, objectives, score), files and drawing do not.
//!
//! # How a tick goes
//!
//! Groups of bodies in which nothing moves are not looked at (`rest`). Where nothing else is near anything, a tick is one formula for each
//! body (`flight`). Otherwise it is a chain of **intervals** (`tick`). Within one, every body follows one smooth law; it ends with the
//! first thing that *happens*.
//!
//! 1. **Laws** (`media`): what acts on each body without touching it: weight, drive, wind, air, liquids.
//! 2. **Impacts** (`impacts`): whatever touches and approaches is given its impulses, the fastest first; what only has to stop, stops all
//!    at once.
//! 3. **Contacts** (`candidates`, `contacts`): what touches, along which axis, and whether it slides.
//! 4. **Accelerations** (`reactions`, `face`, `network`): Reaction, Push and Friction follow from the free accelerations. While the
//!    contacts and these stay the same, so does the answer.
//! 5. **Motion** (`interval`, `flow`): a parabola, a flow through `air` or `liquid`, or rest; and when something next happens (`happenings`,
//!    `impact_time`): an impact, the end of a slide, an edge, a zone's border.
//! 6. Everything moves to that instant exactly, and the next interval begins. The last one ends with the tick; its forces are the ones
//!    shown (`show`).
//!
//! # Which idea handles what, and why
//!
//! - **Free fall is a parabola**, written as one: no step size enters. With drag one step a tick is right to 1e-9 m for ordinary things, its
//!   velocity to rounding; a body is told apart by rate × time, and feathers take finer steps until they have their terminal velocity
//!   (`air`). In a liquid steps end where its surface meets a side of the body, and are as many as their error asks for (`liquid`).
//! - **Tunnelling cannot happen**, because impacts are sought along the whole path and not at its ends: two boxes on cubics meet where a
//!   polynomial has a root, bracketed and found to the last bit (`impact_time`). There is no speed limit.
//! - **Bounces keep their energy**, because the impact happens at its own time on the parabola; endless ones end by the sum of their series
//!   (`impacts`).
//! - **Axes separate.** The normals of boxes are axis-aligned, so contact forces are one problem along x and one along y, each the
//!   projection of the free accelerations on an ordering, solved exactly by blocks and flows (`network`). A column or a row of any length
//!   and any mass ratio costs one pass. Only friction couples the axes, and only where something slides on a wall.
//! - **Rest is exact.** A block with the ground has acceleration 0, not nearly 0; static friction is decided before anything is integrated;
//!   the resultant shown is what the solver found.
//! - **Impacts go in the order of their times**, then by speed: that makes the cradle. What is plastic is solved at once, with the same
//!   network on momenta: that makes ten tonnes on a kilogram.
//! - **What cannot change is not computed anew.** What rests sleeps until something touches it, a pushed row keeps its forces, and small
//!   contact networks have their answers in closed form. What rests, flies past nothing or keeps its contacts can be computed in full
//!   instead (`Plan::direct`), and gives the same bits. Contact forces in one group of bodies never depend on another; but an event
//!   anywhere ends the interval of all, so what moves through a medium elsewhere may differ in its last digits.
//! - **Crowds take another path.** Above 64 bodies (`crowd`) the same world is advanced by [`pile`], one step a tick for all: a pass along
//!   gravity, positions that cannot overlap by construction, sleep; only what flies through zones parts its tick (`passage`). The
//!   choice stands in the [`Plan`].
//!
//! What is not modelled: rotation (boxes keep their orientation, so contacts exert no torque), round collision shapes (a ball's contact is
//! that of its box), the compression of air or liquids, and moving liquids.
//!
//! Tolerances that several files share stand in `tuning`, the others beside what they serve, each with what breaks when it changes.

mod aabb;
mod air;
mod body;
mod contact;
mod def;
mod events;
mod face;
mod flow;
mod forces;
mod guards;
mod impact_time;
mod impulse;
mod islands;
mod liquid;
mod material;
mod media;
mod network;
pub mod pile;
mod plan;
mod reactions;
mod spring;
mod step;
mod surface;
mod tuning;
mod validate;
mod world;
mod zones;

pub use aabb::Aabb;
pub use body::{Body, BodyDef, BodyId};
pub use def::{DefError, FluidDef, StreamDef, WorldDef};
pub use forces::{Force, ForceKind, ForceManager, Source};
pub use glam::DVec2;
pub use guards::Guards;
pub use impulse::Impulse;
pub use material::Material;
pub use plan::Plan;
pub use surface::{Leg, Path, PathPoint, Sides, Surface, SurfaceDef};
pub use world::{Event, Methods, Obstacle, World};
