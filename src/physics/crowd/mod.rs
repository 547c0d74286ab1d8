//! The crowd step: one step of one island, with any number of bodies and any mass ratio.
//!
//! It is plastic first and bounces last, in the seven stages of `docs/physics.md`. `island` chooses the members that are looked at, `bodies` holds them, `dense` runs
//! the stages, `loads` hands weights down; `report` and `record` list the impulses of contacts.
//!
//! A pile rests when its last ball has bounced out; a ball that falls on a resting heap bounces for up to √(2H/g)·(1 + e)/(1 − e), 20 s from 27 m
//! at e = 0.8, by any method that keeps restitution.

pub(crate) mod bodies;
pub(crate) mod bounce;
pub(crate) mod clusters;
pub(crate) mod contacts;
pub(crate) mod cross;
pub(crate) mod dense;
pub(crate) mod drag;
pub(crate) mod friction;
pub(crate) mod gravity;
pub(crate) mod impulses;
pub(crate) mod island;
pub(crate) mod loads;
pub(crate) mod place;
pub(crate) mod record;
pub(crate) mod report;
pub(crate) mod restitution;
pub(crate) mod settled;
pub(crate) mod walls;

/// Axes: left and right; up and down.
pub(crate) const ACROSS: usize = 0;
pub(crate) const ALONG: usize = 1;

/// The rounding of velocities, of sums of many impulses, and of the energy that these give, as a part of themselves. Smaller: rounding slows what
/// it should not.
pub(crate) const ROUNDING: f64 = 1e-12;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CrowdImpact {
    pub a: u32,
    pub b: u32,
    pub axis: usize,
    /// Closing speed when they touched, m/s, > 0.
    pub speed: f64,
    pub solved: u32,
}
