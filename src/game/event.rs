//! States and events of an attempt.

use super::clock::TICK_RATES;
#[cfg(doc)]
use super::impacts::{DAMAGING_SPEED, DUST_SPEED};
use super::names::obstacle_name;
use crate::level::{Level, SurfaceOf};
use crate::physics::{BodyId, DVec2, DefError, Event, Obstacle};
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
    /// By index in `Level::stars`.
    StarTouched(usize),
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

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Death {
    /// The death box of that index in `Level::obstacles`.
    Obstacle(usize),
    /// The surface of that index in `World::surfaces` squeezed it.
    Crushed(u32),
}

impl Death {
    /// `obstacle N` for the Nth row of obstacles.csv, `crushed by world N` for the Nth row of world.csv, as the command line prints
    /// it.
    pub fn name(self, level: &Level) -> String {
        match self {
            Self::Obstacle(index) => format!("obstacle {}", index + 1),
            Self::Crushed(surface) => format!("crushed by {}", obstacle_name(level, Obstacle::Surface(surface))),
        }
    }

    pub fn words(self, level: &Level) -> &'static str {
        tr(match self {
            Self::Obstacle(_) => "Touched a red box",
            Self::Crushed(surface) => match level.surface(surface as usize) {
                SurfaceOf::World(_) | SurfaceOf::Source(_) => "Crushed by a block",
                SurfaceOf::Mover(_) => "Crushed by a moving block",
                SurfaceOf::Door(_) => "Crushed by a door",
                SurfaceOf::Plate(_) => "Crushed against a plate",
                SurfaceOf::Edge(_) => "Crushed against the edge of the level",
            },
        })
    }
}

/// The bodies that a tick with these events squeezed, each with the surface that did it.
pub fn crushed(events: &[Event]) -> impl Iterator<Item = (BodyId, u32)> + '_ {
    events.iter().filter_map(|event| match *event {
        Event::Crushed { body, by, .. } => Some((body, by)),
        Event::Impact { .. } | Event::Snapped { .. } | Event::Hooked { .. } => None,
    })
}
