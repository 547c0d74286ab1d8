//! The crowd step: one step of one island, with any number of bodies and any mass ratio.
//!
//! It takes islands of more than 64 bodies, and smaller ones in ticks with too many events. It is plastic first and bounces last:
//!
//! 1. `contacts`: which pairs touch in this step, and along which axis; an approach may not exceed its gap;
//! 2. `gravity`: paths and velocities along gravity, bottom-up; pairs that still close merge into `clusters` (pooling adjacent violators);
//! 3. `cross`: the same across gravity, in turns with the `friction` of the stacks, and with `drag` on what rubs in air;
//! 4. `walls`: upright faces hold or slow bodies by friction, as hard as the solution across presses them; 2 and 3 then run again;
//! 5. `place`: positions that cannot overlap;
//! 6. `bounce`: restitution. Each contact returns the part e of its impulse (Poisson), a merged group the smallest e of its impacts. The plastic
//!    velocities v_p are a projection of the free ones v (Moreau 1988), so |v⁺|² = |v_p|² + e²|v_p − v|² ≤ |v|². A body that falls on something
//!    immovable leaves with e times its closing speed; a bounce that would end within the step is none. An island returns only that part of its
//!    bounces that adds no energy.
//!
//! `bodies` holds the island that the step works on; `dense` runs the stages; `loads` hands weights down; `report` lists what each contact gave.
//!
//! Momentum is exact, boxes do not overlap, energy rises only by work from outside, and rest is exact: a body at rest has velocity 0, and a
//! step changes no bit of it. A crowd gives up the instant of a bounce within the step, the order of impacts in a row, and a little energy of
//! elastic gases with gravity. A pile rests when its last ball has bounced out; a ball that falls on a resting heap bounces for up to √(2H/g)·(1 + e)/(1 − e), 20 s
//! from 27 m at e = 0.8, by any method that keeps restitution.

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
pub(crate) mod loads;
pub(crate) mod place;
pub(crate) mod polish;
pub(crate) mod record;
pub(crate) mod report;
pub(crate) mod restitution;
pub(crate) mod walls;

/// The axes of boxes that do not turn: left and right; up and down.
pub(crate) const ACROSS: usize = 0;
pub(crate) const ALONG: usize = 1;

/// Two things hit each other during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CrowdImpact {
    /// The body that hit, and the body or surface that it hit.
    pub a: u32,
    pub b: u32,
    pub axis: usize,
    /// Closing speed when they touched, m/s, > 0.
    pub speed: f64,
    /// How often the island had been solved.
    pub solved: u32,
}

/// A body was squeezed between surfaces that close: the moving one was kept where it was for that step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Squeeze {
    pub body: u32,
    pub surface: u32,
    /// How fast the surfaces would have closed, m/s.
    pub speed: f64,
}
