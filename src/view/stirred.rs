//! The objects that the ship has set in motion: the camera keeps them in view while they move.

use crate::game::{Game, SHIP};
use crate::physics::{Aabb, BodyId, DVec2, Event, LinkEnd, Obstacle, Source};

/// A slower object rests, m/s; it is forgotten after this time, s.
const RESTS: f64 = 0.3;
const FORGOTTEN: f64 = 1.0;

/// Each with the time for which it has rested, s.
#[derive(Clone, Debug, Default)]
pub struct StirredObjects(Vec<(BodyId, f64)>);

impl StirredObjects {
    /// Takes up a tick: an object that the ship, or one of these objects, hits, pushes or pulls by a link is one of them.
    pub fn after_tick(&mut self, game: &Game) {
        let world = game.world();
        for event in world.events() {
            if let Event::Impact { a, b: Obstacle::Body(b), .. } = *event {
                for (by, hit) in [(a, b), (b, a)] {
                    if by == SHIP || self.has(by) {
                        self.add(hit);
                    }
                }
            }
        }
        for link in world.links().iter().filter(|link| link.acts()) {
            if let LinkEnd::Body(b) = link.def().to {
                for (by, pulled) in [(link.def().body, b), (b, link.def().body)] {
                    if by == SHIP || self.has(by) {
                        self.add(pulled);
                    }
                }
            }
        }
        for force in world.forces(SHIP).forces() {
            if let Source::Body(body) = force.source {
                self.add(body);
            }
        }
        let tick = 1.0 / game.tick_rate();
        for (body, rested) in &mut self.0 {
            let moves = world.body(*body).velocity.length() > RESTS;
            *rested = if moves { 0.0 } else { *rested + tick };
        }
        self.0.retain(|(_, rested)| *rested < FORGOTTEN);
    }

    fn has(&self, body: BodyId) -> bool {
        self.0.iter().any(|(known, _)| *known == body)
    }

    fn add(&mut self, body: BodyId) {
        if body != SHIP && !self.has(body) {
            // Contact alone moves nothing.
            self.0.push((body, FORGOTTEN * 0.5));
        }
    }

    /// The bodies that have moved by it, in the order in which they began.
    pub fn moving(&self) -> impl Iterator<Item = BodyId> {
        self.0.iter().filter(|(_, rested)| *rested < FORGOTTEN * 0.5).map(|(body, _)| *body)
    }

    /// The box around the ship and as many of them, nearest first, as fit into `room` (m); `centre` returns drawn centres, m. `None`
    /// where there is none of them.
    pub fn framed(&self, game: &Game, room: DVec2, centre: impl Fn(BodyId) -> DVec2) -> Option<Aabb> {
        let area = |body: BodyId| Aabb::around(centre(body), game.world().body(body).half);
        let ship = area(SHIP);
        let mut others: Vec<_> = self.moving().map(area).collect();
        others.sort_by(|a, b| a.centre().distance(ship.centre()).total_cmp(&b.centre().distance(ship.centre())));
        let mut framed = None;
        for other in others {
            let both = framed.unwrap_or(ship).union(&other);
            if both.size().cmpgt(room).any() {
                break;
            }
            framed = Some(both);
        }
        framed
    }
}
