//! The crowd step: one step of one island, with any number of bodies and any mass ratio.
//!
//! It is plastic first and bounces last, in the seven stages of `docs/physics.md`, which `dense` runs for the members that `island` chooses.
//! A ball on a resting heap bounces for up to √(2H/g)·(1 + e)/(1 − e), 20 s from 27 m at e = 0.8, by any method that keeps restitution.

pub(crate) mod bodies;
pub(crate) mod bounce;
pub(crate) mod clusters;
pub(crate) mod contacts;
pub(crate) mod cross;
pub(crate) mod dense;
pub(crate) mod friction;
pub(crate) mod gravity;
pub(crate) mod island;
pub(crate) mod place;
pub(crate) mod record;
pub(crate) mod report;
pub(crate) mod settled;
pub(crate) mod walls;

use glam::DVec2;

/// Axes: left and right; up and down.
pub(crate) const ACROSS: usize = 0;
pub(crate) const ALONG: usize = 1;

/// The rounding of velocities, sums of many impulses and their energy, as a part of themselves. Smaller: rounding slows what it should not.
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

/// The impulse of a contact in the last step, in the numbers of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactImpulse {
    /// The body that feels it, and the body or surface that exerts it and feels the opposite.
    pub a: u32,
    pub b: u32,
    pub axis: usize,
    /// N·s along the axis, and friction along the other one, on `a`.
    pub normal: f64,
    pub friction: f64,
    /// The middle of the contact, m.
    pub point: DVec2,
    /// Whether the two came together in this step; if not, what a lasting contact exerted.
    pub impact: bool,
    pub solved: u32,
}

/// One contact in the island's numbers; impulses on `a`, N·s, `normal` along the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record {
    pub a: u32,
    pub b: u32,
    pub axis: usize,
    pub normal: f64,
    pub friction: f64,
}

/// A contact through which a cluster was merged, in the island's numbers, and the impulse that went through it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Edge {
    pub a: u32,
    pub b: u32,
    /// On `b`, N·s.
    pub impulse: f64,
    /// Which part of it the contact returns when the step ends.
    pub restitution: f64,
}
