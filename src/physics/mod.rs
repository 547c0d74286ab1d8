//! The engine: boxes moved by named forces, as exact as a scene allows.
//!
//! It knows no pixel, window, clock, file or randomness. One call, [`World::step`], advances a world by one tick; the same start and the
//! same calls give the same bits everywhere, because nothing but `+ − × ÷ √` and the `libm` crate ever touches a number. Here live bodies,
//! forces, contacts and motion; rules (fuel, objectives, score), files and drawing do not.
//!
//! # How a tick goes
//!
//! The world tells the store what acts on each body (`step`); all fly freely, and what could meet within the tick is an **island**
//! ([`pile`]). Each island is advanced by the least method that is right for it (`islands` has the choice and what each costs): rest,
//! flight in closed form, from event to event within a budget (`events`), or, for large islands and where the budget is used up, in one
//! step of the dense method ([`pile`]) for what is left of the tick. From event to event it goes so:
//!
//! 1. **Laws** (`media`): what acts on each body without touching it: weight, drive, wind, air, liquids.
//! 2. **Impacts** (`events::impacts`): whatever touches and approaches is given its impulses, the fastest first; what only has to stop,
//!    stops all at once.
//! 3. **Contacts and accelerations** (`events::motions`, `reactions`, `face`, `network`): Reaction, Push and Friction follow from the free
//!    accelerations, on ground that may move (`surface`).
//! 4. **Motion** (`flow`): a parabola, a flow through `air` or `liquid`, a slide, or rest.
//! 5. **What happens next** (`events::predict`, `impact_time`): an impact, the end of a slide, an edge, a zone's border. Only what it
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

mod aabb;
mod acting;
mod ahead;
mod air;
mod bath;
mod body;
mod changes;
mod contact;
mod def;
mod displaced;
mod events;
mod expansion;
mod face;
mod flow;
mod forces;
mod glide;
mod guards;
mod hash;
mod held;
mod impact_time;
mod implicit;
mod impulse;
mod islands;
mod known_contacts;
mod liquid;
mod material;
mod media;
mod network;
pub mod pile;
mod plan;
mod reactions;
mod scratch;
mod series;
mod spring;
mod step;
mod steps;
mod surface;
mod tuning;
mod validate;
mod world;
pub(crate) mod zone_tree;
mod zones;

pub use aabb::Aabb;
pub use body::{Body, BodyDef, BodyId};
pub use def::{DefError, FieldDef, FluidDef, StreamDef, WorldDef};
pub use forces::{Force, ForceKind, ForceManager, Source};
pub use glam::DVec2;
pub use guards::Guards;
pub use impulse::Impulse;
pub use material::Material;
pub use plan::Plan;
pub use surface::{Leg, Path, PathPoint, Sides, Surface, SurfaceDef};
pub use world::{Event, Methods, Obstacle, World};
