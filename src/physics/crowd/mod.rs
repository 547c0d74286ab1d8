//! Many bodies at once: the general method for piles, rows and rain, from about 64 moving bodies to many thousands.
//!
//! Here live the store of all bodies, in separate arrays, the broad phase, free flight, and the dense method over them, without a world
//! around them; named forces, streams and liquids do not. A step goes so:
//!
//! 1. `flight`: where would everything be, and how fast, if it touched nothing;
//! 2. `neighbours`: who may meet whom, sought anew only when a body leaves the box in which its neighbours were sought;
//! 3. `islands`: who could meet within this step, and whom it could meet then;
//! 4. `dense`: each island solved by itself; where a hit throws a body further than was looked for, its island grows and is solved again.
//!
//! Nothing iterates towards an answer except where bodies hang together in the air, so what comes to rest has velocity zero
//! exactly, after which a step changes no bit and the island sleeps until something outside changes or something else comes near.
//! What happens in one island changes no bit of another.
//!
//! Without forces from outside, kinetic and potential energy together never rise: whatever merges takes the velocity of the whole, and
//! impacts return at most what they took. So a pile rests when its last ball has bounced out. Those that fall on the heap when the others
//! lie still bounce alone, for up to √(2H/g)·(1 + e)/(1 − e): 20 s from 27 m at e = 0.8, and longer where a heavy body throws a light
//! one. That is no fault of the method, and no method that keeps restitution can rest earlier.

pub(crate) mod bounce;
pub(crate) mod clusters;
pub(crate) mod contacts;
pub(crate) mod cross;
pub(crate) mod dense;
pub(crate) mod drag;
pub(crate) mod flight;
pub(crate) mod friction;
pub(crate) mod gravity;
pub(crate) mod place;
pub(crate) mod report;
pub(crate) mod walls;

/// The direction of a contact's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    /// Left and right.
    Across,
    /// Up and down.
    Gravity,
}

/// What a body touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Other {
    /// The body of that number.
    Body(usize),
    /// The surface of that number.
    Surface(usize),
}

/// Two things hit each other during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CrowdImpact {
    /// The body that hit.
    pub a: usize,
    /// What it hit.
    pub b: Other,
    /// Along which axis.
    pub axis: Axis,
    /// Closing speed when they touched, m/s, > 0.
    pub speed: f64,
}

/// A body was squeezed between surfaces that close: the moving one was kept where it was for that step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Squeeze {
    /// The body that had no way out.
    pub body: usize,
    /// The surface that was stopped.
    pub surface: usize,
    /// How fast the surfaces would have closed, m/s.
    pub speed: f64,
}
