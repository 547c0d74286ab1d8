//! The space of a world: motions, broad phase, islands, sleep, and the crowd step.

use crate::physics::data::{Aabb, Body, Pose};
use crate::physics::store::{BroadPhase, Islands, Motions, Sleep, broad_phase::cells_per_metre};
use crate::physics::{crowd::CrowdImpact, crowd::island::Crowd, state::State};
use glam::DVec2;

#[derive(Clone, Debug)]
pub(crate) struct Space {
    pub motions: Motions,
    pub broad_phase: BroadPhase,
    pub islands: Islands,
    pub crowd: Crowd,
    pub sleep: Sleep,
    pub moving: Vec<u32>,
    pub impacts: Vec<CrowdImpact>,
    pub grown: Vec<u32>,
    /// Bodies that sweep more than was looked for and meet nobody new, and what they sweep.
    pub widened: Vec<(u32, Aabb)>,
    /// −1 if gravity points to smaller y, else 1.
    pub down: f64,
    /// Length of the last step, s; 0 before the first.
    pub last_dt: f64,
}

impl Space {
    pub fn new(state: &State) -> Self {
        let (n, surfaces) = (state.bodies.len(), state.surfaces.len());
        let motions = Motions::new(&state.bodies, &state.surfaces, &state.media);
        let cells_per_metre = cells_per_metre(&state.bodies);
        let mut space = Self {
            broad_phase: BroadPhase::new(&state.bodies, &motions),
            islands: Islands::new(n, surfaces, cells_per_metre),
            crowd: Crowd::new(n, n + surfaces),
            sleep: Sleep::new(n, cells_per_metre),
            moving: Vec::new(),
            impacts: Vec::with_capacity(n),
            grown: Vec::with_capacity(n),
            widened: Vec::with_capacity(n),
            down: if state.media.gravity < 0.0 { -1.0 } else { 1.0 },
            last_dt: 0.0,
            motions,
        };
        for i in 0..n {
            space.set_force(state, i, state.forces[i].push());
        }
        space
    }

    /// Sets the force on a body besides weight and drag, N. A change wakes its island: returns whether it does.
    pub fn set_force(&mut self, state: &State, i: usize, force: DVec2) -> bool {
        let changes = self.motions.set_force(i, (&state.bodies[i], &state.media), force);
        if changes {
            self.sleep.wake(i);
        }
        changes
    }

    pub fn begin_step(&mut self) {
        for &surface in &self.moving {
            let motion = &mut self.motions.surfaces[surface as usize];
            motion.was = motion.end;
            motion.stand();
            self.motions.sweep_surface(surface as usize);
        }
    }

    /// Leads a surface to a place (m) with a velocity (m/s), over a swept box.
    pub fn lead_surface(&mut self, surface: usize, (centre, velocity): Pose, swept: &Aabb, dt: f64) {
        let j = self.motions.len() + surface;
        let motion = &mut self.motions.surfaces[surface];
        if !self.moving.contains(&(surface as u32)) {
            self.moving.push(surface as u32);
            self.islands.set_moving(j);
        }
        (motion.to, motion.mean, motion.end) = (centre, (centre - motion.from) / dt, velocity);
        self.motions.sweep_surface(surface);
        self.motions.swept[j] = self.motions.swept[j].union(swept);
    }

    pub fn set_present(&mut self, surface: usize, present: bool) {
        if std::mem::replace(&mut self.motions.surfaces[surface].present, present) != present {
            self.motions.sweep_surface(surface);
            self.islands.forget();
            self.sleep.wake_all();
        }
    }

    pub fn is_stirred(&self) -> bool {
        !self.sleep.all_asleep() || self.moving.iter().any(|surface| self.motions.surfaces[*surface as usize].carries())
    }

    pub fn keep_previous(&mut self, of: &Self) {
        self.motions.before[..of.motions.len()].copy_from_slice(&of.motions.before);
    }

    pub fn previous(&self, body: usize) -> Pose {
        self.motions.before[body]
    }

    /// Finds the flights, swept boxes and surfaces near bodies that are awake, and of sleepers that these may reach.
    pub(crate) fn fly(&mut self, bodies: &[Body], dt: f64) {
        let Self { motions, broad_phase, sleep, moving, .. } = self;
        // Sleepers have the free flight of a step of the same length.
        if dt == self.last_dt && sleep.sleepers > 0 {
            sleep.set_aside(&motions.swept);
        } else if !sleep.looks_at_all() {
            sleep.rouse_all();
        }
        motions.fly(bodies, &sleep.looked_at, dt);
        broad_phase.update(bodies, motions, &sleep.looked_at, dt);
        // Sleepers near moving surfaces are looked at, set aside or not: no bit may depend on that.
        for surface in moving.iter().map(|surface| *surface as usize) {
            if motions.surfaces[surface].carries() && !sleep.looks_at_all() {
                let swept = motions.swept[motions.len() + surface];
                sleep.reach(&swept, |j| motions.fall_freely(j));
            }
        }
        self.rouse_reached();
    }

    pub(crate) fn rouse_reached(&mut self) {
        let Self { sleep, motions, islands, .. } = self;
        let mut next = 0;
        while next < sleep.looked_at.len() && !sleep.looks_at_all() {
            let swept = motions.swept[sleep.looked_at[next] as usize];
            next += 1;
            sleep.reach(&swept, |j| motions.fall_freely(j));
        }
        islands.look_at(&sleep.looked_at);
    }
}
