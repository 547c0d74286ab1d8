//! How an attempt stands, what happens in it, and why one cannot begin.

use super::clock::TICK_RATES;
#[cfg(doc)]
use super::impacts::{DAMAGING_SPEED, DUST_SPEED};
use crate::physics::{DVec2, DefError};

/// How an attempt stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Still flying.
    Running,
    /// All objectives were met at once.
    Completed,
    /// The ship is lost: a death box was touched, or something squeezed it.
    Failed,
}

impl Outcome {
    /// In lower case, as the command line prints it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Running => "running",
            Self::Completed => "completed",
            Self::Failed => "failed",
        }
    }
}

/// An event of the last tick, for view and sound.
#[derive(Clone, Debug, PartialEq)]
pub enum GameEvent {
    /// Two things hit each other at `speed` m/s, at least [`DUST_SPEED`].
    Impact {
        /// Where, m.
        point: DVec2,
        /// m/s along the normal.
        speed: f64,
        /// Away from what was hit.
        normal: DVec2,
    },
    /// The ship hit something at [`DAMAGING_SPEED`] or more: −500 points.
    DamagingHit {
        /// Where, m.
        point: DVec2,
        /// m/s along the normal.
        speed: f64,
    },
    /// The objective of that index in `Level::objectives` has become met.
    ObjectiveMet(usize),
    /// … is no longer met.
    ObjectiveLost(usize),
    /// The switch of that index in `Level::switches` has been pressed, or let go.
    Switched(usize, bool),
    /// The block of that index in `Level::world` has broken.
    Broke(usize),
    /// The pod of that index in `Level::pods` has been taken.
    Refuelled(usize),
    /// All were met.
    Completed,
    /// Something begins to be squeezed.
    Crushed {
        /// Its centre, m.
        point: DVec2,
    },
    /// The ship is lost.
    Died,
}

/// Why a game cannot begin.
#[derive(Clone, Debug, PartialEq)]
pub enum GameError {
    /// The tick rate lies outside [`TICK_RATES`].
    TickRate(f64),
    /// The engine refuses the level's world.
    World(DefError),
}

impl std::fmt::Display for GameError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TickRate(rate) => {
                write!(f, "{rate} ticks a second, expected {} to {}", TICK_RATES.start(), TICK_RATES.end())
            }
            Self::World(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for GameError {}
