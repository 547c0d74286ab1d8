pub(crate) mod broad_phase;
pub(crate) mod columns;
pub(crate) mod grid;
pub(crate) mod islands;
pub(crate) mod motions;
pub(crate) mod sleep;

pub(crate) use broad_phase::BroadPhase;
pub(crate) use islands::{Island, Islands};
pub(crate) use motions::{MARGIN, Method, Motions, SurfaceMotion};
pub(crate) use sleep::Sleep;
