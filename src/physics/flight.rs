//! Flight past nothing, the direct answer: where no awake body is near anything, a tick is one formula for each.
//!
//! The general chain of intervals (`tick`) comes to the same bits by the same formulas: it would find no contact, no hit and no border,
//! and end its first interval with the tick.

use super::World;
use super::flow::flow;
use glam::DVec2;

impl World {
    /// Moves everything by a whole tick, if that is all that happens; returns whether it was.
    pub(super) fn fly(&mut self, dt: f64) -> bool {
        if !self.contacts.is_empty() {
            return false;
        }
        for &body in &self.awake {
            let i = body as usize;
            if self.candidates.is_near(i) || self.laws[i].is_near_liquid() {
                return false;
            }
            let (body, law) = (&self.bodies[i], &self.laws[i]);
            if law.air.is_none() && body.velocity == DVec2::ZERO && law.constant == DVec2::ZERO {
                return false;
            }
            self.poses[i] = flow(&self.media, body, law, dt);
        }
        let holds = self.forces_hold;
        self.forces_hold = true;
        for index in 0..self.awake.len() {
            let i = self.awake[index] as usize;
            if !holds || !self.laws[i].air.is_none() {
                self.list_media_forces(i);
                let body = &mut self.bodies[i];
                body.acceleration = self.forces[i].close(None) / body.mass;
            }
            let body = &mut self.bodies[i];
            (body.position, body.velocity) = self.poses[i];
        }
        true
    }
}
