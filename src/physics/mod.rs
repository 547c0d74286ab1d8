//! The engine: boxes moved by named forces, as exact as a scene allows.
//!
//! It knows no pixel, window, clock, file or randomness. One call, [`World::step`], advances a world by one tick; the same start and the
//! same calls give the same bits everywhere, because nothing but `+ − × ÷ √` and the `libm` crate ever touches a number. Here live bodies,
//! forces, contacts and motion; rules (fuel, objectives, score), files and drawing do not.
//!
//! # How a tick goes
//!
//! The world tells the store what acts on each body (`step`); all fly freely, and what could meet within the tick is an **island**
//! (`crowd`). Each island is advanced by the least method that is right for it (`islands` has the choice and what each costs): rest,
//! flight in closed form, from event to event within a budget (`exact`), or, for large islands and where the budget is used up, in one
//! step of the dense method (`crowd`) for what is left of the tick. From event to event it goes so:
//!
//! 1. **Laws** (`media`): what acts on each body without touching it: weight, drive, wind, air, liquids.
//! 2. **Impacts** (`exact::impacts`): whatever touches and approaches is given its impulses, the fastest first; what only has to stop,
//!    stops all at once.
//! 3. **Contacts and accelerations** (`exact::motions`, `reactions`, `face`, `network`): Reaction, Push and Friction follow from the free
//!    accelerations, on ground that may move (`surface`).
//! 4. **Motion** (`flow`): a parabola, a flow through `air` or `liquid`, a slide, or rest.
//! 5. **What happens next** (`exact::predict`, `impact_time`): an impact, the end of a slide, an edge, a zone's border. Only what it
//!    concerns is brought there, and looked at anew.
//!
//! `docs/physics.md` tells the whole with formulas, sources, and how to add to it.
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
//! - **What cannot change is not computed anew.** What rests sleeps until something touches it, and small contact networks have their
//!   answers in closed form. What rests or keeps its contacts can be computed in full instead (`Plan::direct`), and gives the same bits.
//! - **Nothing depends on what is elsewhere.** Islands do not know of each other.
//! - **No tick freezes.** What an island does is counted; beyond its budget the rest of its tick is one dense step. Each time that
//!   happens is counted, too (`guards`).
//!
//! What is not modelled: rotation (boxes keep their orientation, so contacts exert no torque), round collision shapes (a ball's contact is
//! that of its box), the compression of air or liquids, and moving liquids.
//!
//! Tolerances that several files share stand in `tuning`, the others beside what they serve, each with what breaks when it changes.

pub(crate) mod acting;
pub(crate) mod changes;
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
pub(crate) mod scratch;
pub(crate) mod space;
pub(crate) mod step;
pub(crate) mod store;
pub(crate) mod validate;
pub(crate) mod world;

pub use data::aabb::Aabb;
pub use data::body::{Body, BodyDef, BodyId};
pub(crate) use data::def as most;
pub use data::def::{DefError, FieldDef, FluidDef, StreamDef, WorldDef};
pub(crate) use data::domain;
pub use data::impulse::Impulse;
pub use data::material::Material;
pub use data::plan::Plan;
pub use data::surface::{Leg, Path, PathPoint, Sides, Surface, SurfaceDef};
pub use forces::kind::{ForceKind, Source};
pub use forces::link::*;
pub use forces::manager::{Force, ForceManager};
pub use glam::DVec2;
pub use guards::Guards;
pub use world::{Event, Methods, Obstacle, World};
