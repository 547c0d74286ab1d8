//! Changes of a world between ticks.

use crate::physics::data::{Body, BodyId, Surface, WorldDef, domain::DefError, domain::expect};
use crate::physics::forces::{ForceKind, ForceManager, Source, link::Link};
use crate::physics::{space::Space, state::State, world::World};
use glam::DVec2;

impl World {
    /// Sets the force of a body's engine (N) from the next tick on. A force that is not finite is none.
    pub fn set_drive(&mut self, body: BodyId, force: DVec2) {
        self.add_force(body, Source::Engine, ForceKind::Drive, force);
    }

    /// Adds a constant push (N) to the force manager of a body, from the next tick on: [`ForceManager::add`].
    pub fn add_force(&mut self, body: BodyId, source: Source, kind: ForceKind, vector: DVec2) {
        self.change_forces(body, |forces| forces.add(source, kind, vector));
    }

    /// Removes one.
    pub fn remove_force(&mut self, body: BodyId, source: Source, kind: ForceKind) {
        self.change_forces(body, |forces| forces.remove(source, kind));
    }

    fn change_forces(&mut self, body: BodyId, change: impl FnOnce(&mut ForceManager) -> bool) {
        let i = body.index();
        // A force that changes no bit of the acceleration changes nothing that a tick comes to.
        if change(&mut self.state.forces[i]) && self.space.set_force(&self.state, i, self.state.forces[i].push()) {
            self.disturb(body.0);
        }
    }

    /// Lets a surface go on along its path, or wait where it is.
    pub fn set_running(&mut self, surface: usize, runs: bool) {
        if std::mem::replace(&mut self.state.surfaces[surface].runs, runs) != runs {
            self.disturb_around(surface);
        }
    }

    /// Takes a surface away, or brings it back as soon as no body is in its way.
    pub fn set_present(&mut self, surface: usize, present: bool) {
        self.state.surfaces[surface].wanted = present;
        if present && !self.state.surfaces[surface].present && !self.awaited.contains(&(surface as u32)) {
            self.awaited.push(surface as u32);
        }
        if !present && self.state.surfaces[surface].present {
            self.state.surfaces[surface].present = false;
            self.space.set_present(surface, false);
            self.disturb_around(surface);
        }
    }

    /// Sets how fast the belt of a surface runs, m/s: see [`crate::physics::data::surface::SurfaceDef::belt`].
    pub fn set_belt(&mut self, surface: usize, speed: f64) {
        let speed = if speed.is_finite() { speed } else { 0.0 };
        if self.state.surfaces[surface].belt != speed {
            self.state.surfaces[surface].belt = speed;
            self.space.motions.surfaces[surface].belt = speed;
            self.space.sleep.wake_all();
            self.disturb_around(surface);
        }
    }

    /// Lets an air stream blow, or not.
    pub fn set_blowing(&mut self, stream: usize, blows: bool) {
        if std::mem::replace(&mut self.state.media.streams[stream].blows, blows) != blows {
            let zone = self.state.media.streams[stream].zone;
            self.disturb_in(&zone);
            self.feel_zones();
        }
    }

    /// Goes on by another definition of the same bodies, surfaces and zones: all keep their places and velocities, under other masses,
    /// coefficients, gravity and media.
    ///
    /// # Errors
    /// What [`World::new`] refuses, or another number of bodies, surfaces or zones; nothing has changed then.
    pub fn go_on_by(&mut self, def: WorldDef) -> Result<(), DefError> {
        let mut next = Self::new(def)?;
        let counts = |world: &Self| {
            let State { bodies, surfaces, media, links, .. } = &world.state;
            [bodies.len(), surfaces.len(), media.streams.len(), links.all.len()]
        };
        let alike = counts(&next) == counts(self);
        expect(alike, || "a world goes on with as many bodies, surfaces, zones and links as it has".to_owned())?;
        let State { bodies, forces, links, surfaces, media, ticks, .. } = &self.state;
        for (body, now) in next.state.bodies.iter_mut().zip(bodies) {
            *body = Body { position: now.position, velocity: now.velocity, ..body.clone() };
        }
        for (surface, now) in next.state.surfaces.iter_mut().zip(surfaces) {
            *surface = Surface { material: surface.material, def: surface.def.clone(), ..now.clone() };
        }
        for (stream, now) in next.state.media.streams.iter_mut().zip(&media.streams) {
            stream.blows = now.blows;
        }
        (next.state.forces, next.state.ticks) = (forces.clone(), *ticks);
        for (link, now) in next.state.links.all.iter_mut().zip(&links.all) {
            let law = now.law.length().map_or(link.law, |length| link.law.of_length(length));
            *link = Link { def: link.def, law, ..*now };
        }
        next.state.links.gather();
        next.feel_zones();
        *next.space = Space::new(&next.state);
        next.space.keep_previous(&self.space);
        next.state.contacts.clear();
        (next.records, next.awaited) = (self.records.clone(), self.awaited.clone());
        next.begin();
        *self = next;
        Ok(())
    }

    /// Whether an air stream blows.
    pub fn blows(&self, stream: usize) -> bool {
        self.state.media.streams[stream].blows
    }

    /// The force with which what lies on a surface presses down on it, N, as the last tick ended.
    pub fn load_on(&self, surface: usize) -> f64 {
        self.asked.set(true);
        let item = (self.state.bodies.len() + surface) as u32;
        let below = self.state.contacts.iter().filter(|contact| contact.axis == 1 && contact.hi == item);
        below.map(|contact| contact.normal).sum()
    }
}
