//! Surfaces within a tick: the legs of their paths, and their stops.

use crate::physics::exact::events::{Events, Scene};
use crate::physics::exact::item::{Item, Next, Travel};
use glam::DVec2;

impl Scene<'_> {
    pub fn set_on_path(&self, item: &mut Item, at: f64) {
        let surface = &self.surfaces[item.id as usize];
        let point = if at < item.stops_at { surface.at(at) } else { surface.at(item.stops_at).at_rest() };
        item.since = at;
        let end = if at < item.stops_at { item.stops_at } else { f64::INFINITY };
        item.until = (at + point.lasts).min(end).min(self.tick);
        (item.body.position, item.body.velocity) = (point.offset, point.velocity);
        (item.solved, item.mean) = (point.acceleration, point.acceleration);
        let still = point.velocity == DVec2::ZERO && point.acceleration == DVec2::ZERO;
        item.motion = if still { Travel::Still } else { Travel::Parabola };
    }
}

impl Events {
    pub(crate) fn turn(&mut self, scene: &Scene, i: usize) {
        self.set_out(scene, i);
        self.predict(scene, i);
        if !self.concerned.is_empty() {
            self.look(scene);
        }
    }

    pub(crate) fn halt(&mut self, scene: &Scene, surface: u32) {
        self.guards.surfaces_stopped += 1;
        self.halted = true;
        let item = &mut self.items[surface as usize];
        item.stops_at = item.stops_at.min(self.now);
        self.set_out(scene, surface as usize);
    }

    fn set_out(&mut self, scene: &Scene, i: usize) {
        let item = &mut self.items[i];
        scene.set_on_path(item, self.now);
        self.foresee(scene, i);
        self.nexts[i] = Next::NEVER;
        let item = &self.items[i];
        (self.places[i], self.speeds[i], self.is_placed[i]) = (item.body.position, item.body.velocity, true);
        (self.free[i], self.solved[i]) = (item.solved, item.solved);
        self.concern_partners(i as u32);
    }
}
