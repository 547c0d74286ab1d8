//! States and events of an attempt.

use super::clock::TICK_RATES;
#[cfg(doc)]
use super::impacts::{DAMAGING_SPEED, DUST_SPEED};
use crate::physics::{DVec2, DefError};
use crate::words::tr;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    Running,
    /// All objectives are met at once.
    Completed,
    /// The ship touched a death box, or a surface squeezed it.
    Failed,
}

impl Outcome {
    pub const fn name(self) -> &'static str {
        match self {
            Self::Running => "running",
            Self::Completed => "completed",
            Self::Failed => "failed",
        }
    }

    /// For people.
    pub fn shown(self) -> &'static str {
        tr(self.name())
    }

    pub fn named(name: &str) -> Option<Self> {
        [Self::Running, Self::Completed, Self::Failed].into_iter().find(|outcome| outcome.name() == name)
    }
}

#[derive(Clone, Debug, PartialEq)]
pub enum GameEvent {
    /// At least [`DUST_SPEED`].
    Impact {
        /// m.
        point: DVec2,
        /// m/s along the normal.
        speed: f64,
        /// Away from the other body or surface.
        normal: DVec2,
    },
    /// A hit of the ship at [`DAMAGING_SPEED`] or more: −500 points.
    DamagingHit {
        /// m.
        point: DVec2,
        /// m/s along the normal.
        speed: f64,
    },
    /// By index in `Level::objectives`.
    ObjectiveMet(usize),
    ObjectiveLost(usize),
    /// By index in `Level::switches`; true when pressed, false when let go.
    Switched(usize, bool),
    /// By index in `Level::world`.
    Broke(usize),
    /// By index in `Level::pods`.
    Refuelled(usize),
    /// By index in `Level::links`: a force larger than it bears has broken it.
    Snapped(usize),
    /// By index in `Level::links`: its ends have touched, and it acts from now on.
    Hooked(usize),
    Completed,
    /// A body begins to be squeezed.
    Crushed {
        /// The body's centre, m.
        point: DVec2,
    },
    Died,
}

#[derive(Clone, Debug, PartialEq)]
pub enum GameError {
    /// Outside [`TICK_RATES`].
    TickRate(f64),
    World(DefError),
}

impl std::fmt::Display for GameError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TickRate(rate) => {
                let (least, most) = (TICK_RATES.start(), TICK_RATES.end());
                f.write_str(&tr!("{rate} ticks a second, expected {least} to {most}", rate, least, most))
            }
            Self::World(error) => error.fmt(f),
        }
    }
}
