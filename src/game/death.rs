use super::names::obstacle_name;
use crate::level::{Level, SurfaceOf};
use crate::physics::{Aabb, BodyId, Event, Obstacle};
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

    /// For the player, with the place: m from the level's left and bottom, as on the screen's graph paper.
    pub fn words(self, level: &Level) -> String {
        let at = |bounds: Aabb| {
            let centre = bounds.centre();
            tr!("at x = {x} m, y = {y} m", x = format_args!("{:.0}", centre.x), y = format_args!("{:.0}", level.size.y - centre.y))
        };
        match self {
            Self::Obstacle(index) => tr!("Touched a red box {place}", place = at(level.obstacles[index])),
            Self::Crushed(surface) => match level.surface(surface as usize) {
                SurfaceOf::World(index) => tr!("Crushed by a block {place}", place = at(level.world[index].bounds)),
                SurfaceOf::Source(index) => tr!("Crushed by a block {place}", place = at(level.streams[index].source)),
                SurfaceOf::Mover(index) => {
                    tr!("Crushed by a moving block that starts {place}", place = at(level.movers[index].solid.bounds))
                }
                SurfaceOf::Door(index) => tr!("Crushed by a door {place}", place = at(level.doors[index].bounds)),
                SurfaceOf::Plate(index) => tr!("Crushed against a plate {place}", place = at(level.switches[index].bounds)),
                SurfaceOf::Edge(_) => tr("Crushed against the edge of the level").into(),
            },
        }
    }
}

/// The bodies that a tick with these events squeezed, each with the surface that did it.
pub fn crushed(events: &[Event]) -> impl Iterator<Item = (BodyId, u32)> + '_ {
    events.iter().filter_map(|event| match *event {
        Event::Crushed { body, by, .. } => Some((body, by)),
        Event::Impact { .. } | Event::Snapped { .. } | Event::Hooked { .. } => None,
    })
}
