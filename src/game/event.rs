//! States and events of an attempt, and the names of all that exerts a force: bodies by their numbers in the telemetry, the rest by the rows of
//! the level's files. Files and players' pages have names of their own, with the same numbers.

use super::clock::TICK_RATES;
#[cfg(doc)]
use super::impacts::{DAMAGING_SPEED, DUST_SPEED};
use crate::level::{Level, Look, SurfaceOf};
use crate::physics::{BodyId, DVec2, DefError, Event, Obstacle, Source};
use crate::words::tr;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    Running,
    Completed,
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

    pub fn shown(self) -> &'static str {
        tr(self.name())
    }

    pub fn named(name: &str) -> Option<Self> {
        [Self::Running, Self::Completed, Self::Failed].into_iter().find(|outcome| outcome.name() == name)
    }
}

#[derive(Clone, Debug, PartialEq)]
pub enum GameEvent {
    /// At least [`DUST_SPEED`], m/s along the normal, which points away from the other body or surface; the point in m.
    Impact {
        point: DVec2,
        speed: f64,
        normal: DVec2,
    },
    /// A hit of the ship at [`DAMAGING_SPEED`] or more, m/s along the normal: −500 points.
    DamagingHit {
        point: DVec2,
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
    /// A body, with its centre there, m, begins to be squeezed.
    Crushed {
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
    /// `obstacle N` for the Nth row of obstacles.csv, `crushed by world N` for the Nth row of world.csv, as the command line prints it.
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

/// In the engine's order.
const EDGES: [&str; 4] = ["edge left", "edge right", "edge top", "edge bottom"];

/// The name of a source: `gravity`, `engine`, `air`; `stream N`, `fluid N` and `world N`, the Nth row of hazards.csv, fluids.csv and
/// world.csv; likewise `mover N`, `door N`, `switch N` (its plate) and `gravity N`; `hazard N`, the source block of stream N; `edge left`
/// (`right`, `top`, `bottom`); `object N`, of which 0 is the ship.
pub fn source_name(level: &Level, source: Source) -> String {
    match source {
        Source::Gravity => "gravity".to_owned(),
        Source::Engine => "engine".to_owned(),
        Source::Air => "air".to_owned(),
        Source::Stream(index) => format!("stream {}", index + 1),
        // The level's own sideways gravity has the index behind the zones.
        Source::Field(index) if index as usize >= level.fields.len() => "gravity".to_owned(),
        Source::Field(index) => format!("gravity {}", index + 1),
        Source::Fluid(index) => format!("fluid {}", index + 1),
        Source::Surface(index) => surface_name(level, index as usize),
        Source::Body(body) => format!("object {}", body.0),
        Source::Link(index) => format!("link {}", index + 1),
    }
}

/// N/kg.
const EARTH: f64 = 9.81;
/// A field this near to the Earth's has its name, N/kg.
const EARTH_WITHIN: f64 = 0.05;
const WALLS: [&str; 4] = ["left edge", "right edge", "roof", "floor"];

/// In a player's words: `Earth` (`planet` under another gravity), `exhaust` (the gas that leaves the engine pushes the ship),
/// `air`, `fan N`, `liquid N`, `block N`, `mover N`, `floor` …; numbers as in [`source_name`].
pub fn plain_name(level: &Level, source: Source) -> String {
    match source {
        Source::Gravity if (level.gravity - EARTH).abs() <= EARTH_WITHIN => tr("Earth").to_owned(),
        Source::Gravity => tr("planet").to_owned(),
        Source::Engine => tr("exhaust").to_owned(),
        Source::Stream(index) => tr!("fan {number}", number = index + 1),
        Source::Fluid(index) => tr!("liquid {number}", number = index + 1),
        Source::Surface(index) => match level.surface(index as usize) {
            SurfaceOf::World(index) => tr!("block {number}", number = index + 1),
            SurfaceOf::Source(index) => tr!("fan {number}", number = index + 1),
            SurfaceOf::Edge(index) => tr(WALLS[index]).to_owned(),
            SurfaceOf::Mover(index) => tr!("mover {number}", number = index + 1),
            SurfaceOf::Door(index) => tr!("door {number}", number = index + 1),
            SurfaceOf::Plate(index) => tr!("switch {number}", number = index + 1),
        },
        Source::Air => tr("air").to_owned(),
        Source::Field(index) if (index as usize) < level.fields.len() => tr!("gravity {number}", number = index + 1),
        Source::Field(_) => tr("gravity").to_owned(),
        Source::Body(body) => tr!("object {number}", number = body.0),
        Source::Link(index) => tr!("link {number}", number = index + 1),
    }
}

pub fn obstacle_name(level: &Level, obstacle: Obstacle) -> String {
    match obstacle {
        Obstacle::Surface(index) => surface_name(level, index as usize),
        Obstacle::Body(body) => format!("object {}", body.0),
    }
}

/// `Ship`, `Key object 2`, `Ball 3`, `Box 4`, numbered as in [`source_name`].
pub fn body_title(level: &Level, id: BodyId) -> String {
    let Some(object) = id.index().checked_sub(1).and_then(|i| level.objects.get(i)) else {
        return tr("Ship").to_owned();
    };
    let kind = match object.look {
        _ if object.key.is_some() => "Key object {number}",
        _ if object.circular => "Ball {number}",
        Look::Ball => "Ball {number}",
        Look::Image(_) | Look::Box => "Box {number}",
    };
    tr!(kind, number = id.0)
}

fn surface_name(level: &Level, index: usize) -> String {
    match level.surface(index) {
        SurfaceOf::World(index) => format!("world {}", index + 1),
        SurfaceOf::Source(index) => format!("hazard {}", index + 1),
        SurfaceOf::Mover(index) => format!("mover {}", index + 1),
        SurfaceOf::Door(index) => format!("door {}", index + 1),
        SurfaceOf::Plate(index) => format!("switch {}", index + 1),
        SurfaceOf::Edge(index) => EDGES[index].to_owned(),
    }
}
