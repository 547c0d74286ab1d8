//! Short forms of the questions that tests ask of a world, and of the steps that they make it take.

use resultant::physics::{BodyId, DVec2, World};

pub trait Ask {
    /// Where a body is, m.
    fn at(&self, body: usize) -> DVec2;
    /// m/s.
    fn speed(&self, body: usize) -> DVec2;
    /// Place and velocity.
    fn state(&self, body: usize) -> (DVec2, DVec2) {
        (self.at(body), self.speed(body))
    }
    /// Sets the drive of a body, N.
    fn drive(&mut self, body: usize, x: f64, y: f64);
    fn steps(&mut self, count: u32, tick: f64);
}

impl Ask for World {
    fn at(&self, body: usize) -> DVec2 {
        self.bodies()[body].position
    }

    fn speed(&self, body: usize) -> DVec2 {
        self.bodies()[body].velocity
    }

    fn drive(&mut self, body: usize, x: f64, y: f64) {
        self.set_drive(BodyId(body as u32), DVec2::new(x, y));
    }

    fn steps(&mut self, count: u32, tick: f64) {
        (0..count).for_each(|_| self.step(tick));
    }
}
