//! What impacts pass on.

use crate::physics::data::body::BodyId;
use glam::DVec2;

/// What a body can run into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Obstacle {
    /// The surface of that index in `World::surfaces`.
    Surface(u32),
    /// Another body.
    Body(BodyId),
}

/// What one impact passed on: to `a` the impulse, and to `b`, if that is a body, the opposite. Shown by the name "Impact". Or what a contact that has
/// ended within the tick had passed on in it: no list of forces has that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impulse {
    /// The body that felt it.
    pub a: BodyId,
    /// What exerted it.
    pub b: Obstacle,
    /// N·s, normal and friction together.
    pub vector: DVec2,
    /// The middle of the shared edge, m.
    pub point: DVec2,
    /// When in the tick it was, s from the tick's start.
    pub at: f64,
    /// Whether it is an impact.
    pub impact: bool,
}

impl Impulse {
    /// Its name as shown to the player.
    pub const NAME: &'static str = "Impact";

    /// What a body felt of it, N·s, and from what.
    pub fn on(&self, body: BodyId) -> Option<(DVec2, Obstacle)> {
        if self.a == body {
            Some((self.vector, self.b))
        } else {
            (self.b == Obstacle::Body(body)).then_some((-self.vector, Obstacle::Body(self.a)))
        }
    }
}

/// An impulse with what events and paths tell of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    pub impulse: Impulse,
    /// From `b` towards `a`.
    pub normal: DVec2,
    /// Closing speed just before, m/s; 0 where what had bounced goes on.
    pub speed: f64,
    /// Where `a` and `b` were, m.
    pub places: [DVec2; 2],
}
