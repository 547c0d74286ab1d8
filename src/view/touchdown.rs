//! Landings: the ship's legs give way under it, and a gentle one is praised.

use crate::game::{Game, SHIP};
use crate::physics::{DVec2, Event, ForceKind, Obstacle};
use std::f64::consts::PI;

/// The least flight before a landing, s: a box that tips to rest is no landing.
const FLOWN: f64 = 0.4;
/// A slower landing is gentle, m/s.
pub const GENTLE: f64 = 2.0;
/// Time in which the legs straighten, s; the speed that presses them down fully, m/s; and that depth, of the height.
const SPRING: f64 = 0.22;
const FULL: f64 = 8.0;
const DEPTH: f64 = 0.14;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing {
    /// m.
    pub point: DVec2,
    /// m/s.
    pub speed: f64,
}

/// Whether the ship flies, and the compression of its legs.
#[derive(Clone, Debug, Default)]
pub struct Touchdown {
    /// Ticks since the last touch.
    flown: u64,
    /// The last landing's speed (m/s) and age (s).
    last: Option<(f64, f64)>,
}

impl Touchdown {
    /// Takes up a tick; returns its landing.
    pub fn after_tick(&mut self, game: &Game) -> Option<Landing> {
        let flown = self.flown as f64 / game.tick_rate();
        let landing = landing(game.world().events()).filter(|_| flown >= FLOWN);
        let touches = landing.is_some() || touches(game);
        self.flown = if touches { 0 } else { self.flown + 1 };
        if let Some(landing) = landing {
            self.last = Some((landing.speed, 0.0));
        }
        landing
    }

    pub fn advance(&mut self, frame_time: f64) {
        self.last = self.last.map(|(speed, age)| (speed, age + frame_time)).filter(|(_, age)| *age < SPRING);
    }

    /// Compression of the ship as a part of its height, 0 … 0.14.
    pub fn squash(&self) -> f64 {
        self.last.map_or(0.0, |(speed, age)| {
            let t = age / SPRING;
            DEPTH * (speed / FULL).min(1.0) * (PI * t.sqrt()).sin()
        })
    }
}

/// Whether a body or surface touches the ship.
fn touches(game: &Game) -> bool {
    let forces = game.world().forces(SHIP);
    forces.forces().iter().any(|force| matches!(force.kind, ForceKind::Reaction | ForceKind::Push))
}

/// The hardest hit of the ship from above in a tick with these events.
fn landing(events: &[Event]) -> Option<Landing> {
    let hits = events.iter().filter_map(|event| match *event {
        Event::Impact { a, b, point, speed, normal } => {
            // The normal points away from the hit body: up, where the ship is `a`.
            let up = if a == SHIP {
                -normal.y
            } else if b == Obstacle::Body(SHIP) {
                normal.y
            } else {
                0.0
            };
            (up > 0.5).then_some(Landing { point, speed })
        }
        Event::Crushed { .. } | Event::Snapped { .. } | Event::Hooked { .. } => None,
    });
    hits.max_by(|a, b| a.speed.total_cmp(&b.speed))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::BodyId;

    fn hit(a: u32, b: Obstacle, normal: DVec2) -> Event {
        Event::Impact { a: BodyId(a), b, point: DVec2::ZERO, normal, speed: 3.0 }
    }

    #[test]
    fn a_landing_is_what_hits_the_ship_from_below() {
        let floor = Obstacle::Surface(0);
        assert_eq!(landing(&[hit(0, floor, DVec2::NEG_Y)]).map(|landing| landing.speed), Some(3.0));
        assert!(landing(&[hit(0, floor, DVec2::Y), hit(0, floor, DVec2::X), hit(1, floor, DVec2::NEG_Y)]).is_none());
        assert!(landing(&[hit(1, Obstacle::Body(SHIP), DVec2::Y)]).is_some(), "it lands on a crate");
    }

    #[test]
    fn the_legs_straighten_again() {
        let mut touchdown = Touchdown { flown: 0, last: Some((100.0, 0.0)) };
        let mut deepest: f64 = 0.0;
        for _ in 0..30 {
            touchdown.advance(0.01);
            deepest = deepest.max(touchdown.squash());
        }
        assert!(deepest > 0.05 && deepest <= DEPTH);
        assert_eq!(touchdown.squash(), 0.0);
    }
}
