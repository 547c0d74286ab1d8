//! The path of a flight and its impacts, for the picture of the level.

use crate::game::{Game, GameEvent, SHIP};
use crate::physics::DVec2;

/// From one point of the path to the next, ticks.
const EVERY: u64 = 4;
/// The most impacts in memory: a crowd has more, and the picture is full.
const MOST: usize = 500;

#[derive(Clone, Debug, Default)]
pub struct FlownTrail {
    path: Vec<(u64, DVec2)>,
    impacts: Vec<(u64, Bump)>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bump {
    /// m.
    pub at: DVec2,
    /// Along the normal, m/s.
    pub speed: f64,
    /// Whether it cost the ship points.
    pub damages: bool,
}

impl FlownTrail {
    /// Takes up the tick just made. A flight that was taken back goes on from there.
    pub fn note(&mut self, game: &Game) {
        let now = game.ticks();
        self.path.truncate(self.path.partition_point(|(tick, _)| *tick < now));
        self.impacts.truncate(self.impacts.partition_point(|(tick, _)| *tick < now));
        if self.path.last().is_none_or(|(tick, _)| tick + EVERY <= now) {
            self.path.push((now, game.world().body(SHIP).position));
        }
        let bump = |event: &GameEvent| match event {
            GameEvent::Impact { point, speed, .. } => Some(Bump { at: *point, speed: *speed, damages: false }),
            GameEvent::DamagingHit { point, speed } => Some(Bump { at: *point, speed: *speed, damages: true }),
            _ => None,
        };
        let room = MOST.saturating_sub(self.impacts.len());
        self.impacts.extend(game.events().iter().filter_map(bump).take(room).map(|bump| (now, bump)));
    }

    /// Goes on as another one does from its first tick.
    pub fn go_on_with(&mut self, other: &Self) {
        let Some((first, _)) = other.path.first() else { return };
        self.path.retain(|(tick, _)| tick < first);
        self.impacts.retain(|(tick, _)| tick < first);
        self.path.extend(&other.path);
        self.impacts.extend(&other.impacts);
    }

    /// Of the ship, m.
    pub fn path(&self) -> impl Iterator<Item = DVec2> + '_ {
        self.path.iter().map(|(_, at)| *at)
    }

    pub fn impacts(&self) -> impl Iterator<Item = Bump> + '_ {
        self.impacts.iter().map(|(_, bump)| *bump)
    }
}
