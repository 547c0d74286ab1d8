use super::names::obstacle_name;
use crate::level::{Level, SurfaceOf};
use crate::physics::{BodyId, Event, Obstacle};
use crate::words::tr;

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

    /// For the player.
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
