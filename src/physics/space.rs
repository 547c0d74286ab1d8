//! The space of a world: how all bodies and surfaces move in a step, which of them may meet, which sleep, and the crowd step.

use crate::physics::crowd::dense::Crowd;
use crate::physics::crowd::{CrowdImpact, Squeeze};
use crate::physics::data::{Aabb, Pose};
use crate::physics::state::State;
use crate::physics::store::broad_phase::BroadPhase;
use crate::physics::store::islands::Islands;
use crate::physics::store::motions::Motions;
use crate::physics::store::sleep::Sleep;
use glam::DVec2;

/// What a step works with. Bodies and surfaces themselves are those of the state.
#[derive(Clone, Debug)]
pub(crate) struct Space {
    pub motions: Motions,
    pub broad_phase: BroadPhase,
    pub islands: Islands,
    pub crowd: Crowd,
    pub sleep: Sleep,
    /// Surfaces that have moved.
    pub moving: Vec<u32>,
    /// What the last step of crowds came to.
    pub impacts: Vec<CrowdImpact>,
    pub squeezed: Vec<Squeeze>,
    /// Bodies that may get further in this step than others were looked for.
    pub grown: Vec<u32>,
    /// −1 if gravity points to smaller y, else 1.
    pub down: f64,
    /// Length of the last step, s; 0 before the first.
    pub last_dt: f64,
}

impl Space {
    pub fn new(state: &State) -> Self {
        let (n, surfaces) = (state.bodies.len(), state.surfaces.len());
        let motions = Motions::new(&state.bodies, &state.surfaces, &state.media);
        let mut space = Self {
            broad_phase: BroadPhase::new(&state.bodies, &motions),
            islands: Islands::new(n, surfaces),
            crowd: Crowd::new(n, n + surfaces),
            sleep: Sleep::new(n),
            moving: Vec::new(),
            impacts: Vec::with_capacity(n),
            squeezed: Vec::new(),
            grown: Vec::with_capacity(n),
            down: if state.media.gravity < 0.0 { -1.0 } else { 1.0 },
            last_dt: 0.0,
            motions,
        };
        (0..n).for_each(|i| space.set_force(state, i, state.forces[i].push()));
        space
    }

    /// Sets the force (N) that acts on a body from now on besides weight and drag: drive, wind, buoyancy. A change wakes its island.
    pub fn set_force(&mut self, state: &State, i: usize, force: DVec2) {
        if self.motions.set_force(i, (&state.bodies[i], &state.media), force) {
            self.sleep.wake(i);
        }
    }

    /// Sets where a body would be after the next step (m) and how fast (m/s) if it touched nothing, for a motion that no constant force
    /// describes. Holds for that step; wakes nothing.
    pub fn guide(&mut self, body: usize, end: Pose) {
        self.motions.guided.push((body as u32, end));
    }

    /// Begins a step: surfaces stand unless they are led.
    pub fn begin_step(&mut self) {
        for &surface in &self.moving {
            let motion = &mut self.motions.surfaces[surface as usize];
            motion.was = motion.end;
            motion.stand();
            self.motions.sweep_surface(surface as usize);
        }
    }

    /// Moves a surface within `dt` seconds so that it ends at a place (m) with a velocity (m/s), and sweeps a box on its way.
    pub fn lead_surface(&mut self, surface: usize, (centre, velocity): Pose, swept: &Aabb, dt: f64) {
        let j = self.motions.len() + surface;
        let motion = &mut self.motions.surfaces[surface];
        if !self.moving.contains(&(surface as u32)) {
            self.moving.push(surface as u32);
            self.islands.set_moving(j);
        }
        (motion.to, motion.mean, motion.end) = (centre, (centre - motion.from) / dt, velocity);
        self.motions.sweep_surface(surface);
        let [left, right, top, bottom] = self.motions.swept[j];
        self.motions.swept[j] = [left.min(swept.min.x), right.max(swept.max.x), top.min(swept.min.y), bottom.max(swept.max.y)];
    }

    /// Ends a step: surfaces are where they were led.
    pub fn end_step(&mut self) {
        for &surface in &self.moving {
            let motion = &mut self.motions.surfaces[surface as usize];
            motion.from = motion.to;
        }
    }

    /// Puts a surface where it is, m, without a step.
    pub fn place_surface(&mut self, surface: usize, centre: DVec2) {
        self.motions.surfaces[surface].from = centre;
    }

    /// Feeds how fast surfaces moved when the last step ended to `write`: what had that velocity rides on them.
    pub fn hash_surfaces(&self, write: &mut impl FnMut(u64)) {
        for surface in &self.moving {
            let DVec2 { x, y } = self.motions.surfaces[*surface as usize].end;
            [x, y].into_iter().for_each(|value| write(value.to_bits()));
        }
    }

    /// Makes a surface a belt, m/s: clockwise around it, the upper side runs to the right. Wakes all.
    pub fn set_belt(&mut self, surface: usize, speed: f64) {
        self.motions.surfaces[surface].belt = speed;
        self.sleep.wake_all();
    }

    /// Sets whether a surface is there. Wakes all.
    pub fn set_present(&mut self, surface: usize, present: bool) {
        if std::mem::replace(&mut self.motions.surfaces[surface].present, present) != present {
            self.motions.sweep_surface(surface);
            self.islands.forget();
            self.sleep.wake_all();
        }
    }

    /// Whether a body is awake or a surface moves.
    pub fn is_stirred(&self) -> bool {
        !self.sleep.all_asleep() || self.moving.iter().any(|surface| self.motions.surfaces[*surface as usize].carries())
    }

    /// Takes over from another space where its bodies were before its last step.
    pub fn keep_previous(&mut self, of: &Self) {
        self.motions.before[..of.motions.len()].copy_from_slice(&of.motions.before);
    }

    /// The pose of a body before the last step.
    pub fn previous(&self, body: usize) -> Pose {
        self.motions.before[body]
    }
}
