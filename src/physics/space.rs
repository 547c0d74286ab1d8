//! The space of a world: all bodies and surfaces in arrays, what finds which of them may meet, and the crowd step over them.

use crate::physics::crowd::dense::Dense;
use crate::physics::crowd::impulses::ContactImpulse;
use crate::physics::crowd::{CrowdImpact, Squeeze};
use crate::physics::data::aabb::Aabb;
use crate::physics::data::body::Body;
use crate::physics::data::surface::Surface;
use crate::physics::forces::weight::fall;
use crate::physics::guards::Guards;
use crate::physics::store::bodies::Bodies;
use crate::physics::store::broad_phase::BroadPhase;
use crate::physics::store::islands::Islands;
use crate::physics::store::sleep::Sleep;
use glam::DVec2;

/// All bodies and surfaces, and their motion. Bodies keep their ids for the outside.
#[derive(Clone, Debug)]
pub(crate) struct Space {
    pub(crate) bodies: Bodies,
    pub(crate) broad_phase: BroadPhase,
    pub(crate) islands: Islands,
    pub(crate) dense: Dense,
    pub(crate) sleep: Sleep,
    pub(crate) movers: Movers,
    /// What the last step of crowds came to.
    pub(crate) impacts: Vec<CrowdImpact>,
    pub(crate) squeezed: Vec<Squeeze>,
    /// How often the island of each body has been solved, by the numbers outside: what an earlier solution listed holds no longer.
    pub(crate) solved: Vec<u32>,
    /// By slot: how often its island has grown in this step, and whether it has to be solved again.
    pub(crate) growths: Vec<u32>,
    pub(crate) again: Vec<bool>,
    /// 1, or −1 if gravity points to smaller y: inside, y grows along gravity.
    pub(crate) down: f64,
    pub(crate) gravity: f64,
    /// Whether no gravity acts on a body.
    weightless: Vec<bool>,
    pub(crate) drag: bool,
    pub(crate) rest_speed: f64,
    pub(crate) may_sleep: bool,
    /// Length of the last step, s; 0 before the first.
    pub(crate) last_dt: f64,
}

/// Where a surface is at the end of the step, m, and how fast it moves then, m/s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    pub surface: u32,
    pub centre: DVec2,
    pub velocity: DVec2,
}

/// Surfaces that have moved, and where they go next.
#[derive(Clone, Debug, Default)]
pub(crate) struct Movers {
    pub moving: Vec<u32>,
    pub targets: Vec<Target>,
    /// What they sweep on the way, where that is no straight line: left, right, top, bottom.
    pub ways: Vec<(u32, [f64; 4])>,
}

impl Movers {
    /// Lets them go on for a step of `dt` seconds.
    pub fn advance(&self, bodies: &mut Bodies, dt: f64) {
        let n = bodies.len();
        for j in self.moving.iter().map(|j| n + *j as usize) {
            (bodies.was_vx[j], bodies.was_vy[j]) = (bodies.vx[j], bodies.vy[j]);
            stand(bodies, j);
        }
        for Target { surface, centre, velocity } in &self.targets {
            let j = n + *surface as usize;
            (bodies.px[j], bodies.py[j]) = (centre.x, centre.y);
            let (vx, vy) = ((centre.x - bodies.x[j]) / dt, (centre.y - bodies.y[j]) / dt);
            (bodies.vx[j], bodies.mean_vx[j], bodies.vy[j], bodies.mean_vy[j]) = (vx, vx, vy, vy);
            // What rides on it moves so when the step ends.
            (bodies.free_vx[j], bodies.ux[j]) = (velocity.x, velocity.x);
            (bodies.free_vy[j], bodies.uy[j]) = (velocity.y, velocity.y);
        }
    }
}

/// Lets a surface stand for a step.
pub(crate) fn stand(bodies: &mut Bodies, j: usize) {
    (bodies.px[j], bodies.py[j]) = (bodies.x[j], bodies.y[j]);
    (bodies.vx[j], bodies.mean_vx[j], bodies.free_vx[j], bodies.ux[j]) = (0.0, 0.0, 0.0, 0.0);
    (bodies.vy[j], bodies.mean_vy[j], bodies.free_vy[j], bodies.uy[j]) = (0.0, 0.0, 0.0, 0.0);
}

/// What acts on all bodies, and which parts run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setting {
    /// Gravitational field strength towards larger y, N/kg.
    pub gravity: f64,
    /// kg/m³; 0 where no body feels the air.
    pub air_density: f64,
    /// A rebound slower than this, m/s, is none.
    pub rest_speed: f64,
    pub bounces: bool,
    pub sleep: bool,
}

impl Space {
    /// The bodies and surfaces as they are.
    pub fn new(all: &[Body], surfaces: &[Surface], setting: Setting) -> Self {
        let down = if setting.gravity < 0.0 { -1.0 } else { 1.0 };
        let mut bodies = Bodies::new(all.len(), surfaces.len());
        all.iter().enumerate().for_each(|(i, body)| bodies.set_body(i, body, (down, setting.air_density)));
        surfaces.iter().enumerate().for_each(|(j, surface)| bodies.set_surface(j, surface, down));
        bodies.note_kinds();
        if !setting.bounces {
            bodies.make_plastic();
        }
        let mut space = Self {
            broad_phase: BroadPhase::new(&bodies),
            islands: Islands::new(all.len(), surfaces.len()),
            dense: Dense::new(&bodies),
            sleep: Sleep::new(all.len()),
            movers: Movers::default(),
            impacts: Vec::with_capacity(all.len()),
            squeezed: Vec::new(),
            solved: vec![0; all.len()],
            growths: vec![0; all.len()],
            again: vec![false; all.len()],
            down,
            gravity: setting.gravity * down,
            weightless: all.iter().map(|body| body.weightless).collect(),
            drag: bodies.airy,
            rest_speed: setting.rest_speed,
            may_sleep: setting.sleep,
            last_dt: 0.0,
            bodies,
        };
        (0..all.len()).for_each(|i| space.set_force(i, DVec2::ZERO));
        space
    }

    /// Sets the force (N) that acts on a body from outside from now on, besides weight and drag: drive, wind, buoyancy. A change
    /// wakes the body's island.
    pub fn set_force(&mut self, body: usize, force: DVec2) {
        let i = body;
        let ax = force.x / self.bodies.mass[i];
        let gravity = if self.weightless[body] { 0.0 } else { self.gravity };
        let ay = fall(gravity, force.y * self.down / self.bodies.mass[i]);
        if ax != self.bodies.ax[i] || ay != self.bodies.ay[i] {
            (self.bodies.ax[i], self.bodies.ay[i]) = (ax, ay);
            self.sleep.wake(body);
        }
    }

    /// Sets where a body would be after the next step (m) and how fast (m/s) if it touched nothing, for a motion that no constant force
    /// describes. Holds for that step; wakes nothing.
    pub fn guide(&mut self, body: usize, position: DVec2, velocity: DVec2) {
        let turned = DVec2::new(1.0, self.down);
        self.bodies.guided.push((body as u32, position * turned, velocity * turned));
    }

    /// Moves a surface during the next step so that its centre is there at the end of it (m), and says how fast it moves then (m/s): what rides
    /// on it does so, too. After that it stands, unless moved again.
    pub fn lead_surface(&mut self, surface: usize, centre: DVec2, velocity: DVec2) {
        if !self.movers.moving.contains(&(surface as u32)) {
            self.movers.moving.push(surface as u32);
            let j = self.bodies.len() + surface;
            self.islands.set_moving(j);
        }
        let turned = DVec2::new(1.0, self.down);
        let (centre, velocity) = (centre * turned, velocity * turned);
        self.movers.targets.push(Target { surface: surface as u32, centre, velocity });
    }

    /// Tells all that a surface sweeps in the next step, m, where it does not go straight to its end.
    pub(crate) fn sweep_surface(&mut self, surface: usize, swept: &Aabb) {
        let (top, bottom) = if self.down < 0.0 { (-swept.max.y, -swept.min.y) } else { (swept.min.y, swept.max.y) };
        self.movers.ways.push((surface as u32, [swept.min.x, swept.max.x, top, bottom]));
    }

    /// Feeds how fast surfaces moved when the last step ended to `write`: what had that velocity rides on them.
    pub(crate) fn hash_surfaces(&self, write: &mut impl FnMut(u64)) {
        let (n, moving) = (self.bodies.len(), &self.movers.moving);
        for j in moving.iter().map(|j| n + *j as usize) {
            [self.bodies.vx[j], self.bodies.vy[j]].into_iter().for_each(|value| write(value.to_bits()));
        }
    }

    /// Puts a surface where it is, m, without a step.
    pub(crate) fn place_surface(&mut self, surface: usize, centre: DVec2) {
        let j = self.bodies.len() + surface;
        (self.bodies.x[j], self.bodies.y[j]) = (centre.x, centre.y * self.down);
        self.bodies.changed_surfaces = true;
    }

    /// Lets pairs of bodies share an island wherever they are, in the next step.
    pub(crate) fn join(&mut self, pairs: &[(u32, u32)]) {
        self.islands.link(pairs);
    }

    /// Lets a body, and what is in its island, be looked at again.
    pub(crate) fn wake(&mut self, body: usize) {
        self.sleep.wake(body);
    }

    /// Whom the last step looked at, and who has been woken since; all others sleep.
    pub(crate) fn looked_at(&self) -> &[u32] {
        self.sleep.looked_at()
    }

    /// Bodies that slept and were woken since this was asked last.
    pub(crate) fn take_woken(&mut self, into: &mut Vec<u32>) {
        into.append(&mut self.sleep.woken);
    }

    /// The contacts of the last step that were listed.
    pub(crate) fn listed(&self) -> &[ContactImpulse] {
        &self.dense.report.list
    }

    /// Makes a surface a belt, m/s: clockwise around it, the upper side runs to the right. Wakes all.
    pub fn set_belt(&mut self, surface: usize, speed: f64) {
        let j = self.bodies.len() + surface;
        self.bodies.belt[j] = speed * self.down;
        self.wake_all();
    }

    /// Sets whether a surface is there. Wakes all.
    pub fn set_present(&mut self, surface: usize, present: bool) {
        let j = self.bodies.len() + surface;
        if self.bodies.present[j] != present {
            self.bodies.present[j] = present;
            self.bodies.changed_surfaces = true;
            self.wake_all();
        }
    }

    fn wake_all(&mut self) {
        self.sleep.wake_all();
    }

    /// Whom surfaces would have squeezed in the last step.
    pub fn squeezed(&self) -> &[Squeeze] {
        &self.squeezed
    }

    /// The guards since they were asked for last.
    pub(crate) fn take_guards(&mut self) -> Guards {
        self.dense.take_guards()
    }

    /// Whether there has been a step.
    pub fn has_stepped(&self) -> bool {
        self.last_dt > 0.0
    }

    /// Whether the body's island rests, so that nothing is computed for it.
    pub fn is_sleeping(&self, body: usize) -> bool {
        self.sleep.sleeps(body)
    }

    /// A body's centre, m.
    pub fn position(&self, body: usize) -> DVec2 {
        let i = body;
        DVec2::new(self.bodies.x[i], self.bodies.y[i] * self.down)
    }

    /// Where a body's centre was before the last step, m.
    pub fn previous(&self, body: usize) -> DVec2 {
        let i = body;
        DVec2::new(self.bodies.px[i], self.bodies.py[i] * self.down)
    }

    /// How fast a body was before the last step, m/s.
    pub fn previous_velocity(&self, body: usize) -> DVec2 {
        let i = body;
        DVec2::new(self.bodies.ux[i], self.bodies.uy[i] * self.down)
    }

    /// Takes over from another space where its bodies were before its last step.
    pub fn keep_previous(&mut self, of: &Self) {
        for body in 0..of.bodies.len() {
            let i = body;
            (self.bodies.px[i], self.bodies.py[i]) = (of.previous(body) * DVec2::new(1.0, self.down)).into();
        }
    }

    /// How many bodies sleep.
    pub fn sleepers(&self) -> usize {
        self.sleep.sleepers()
    }

    /// A body's velocity, m/s.
    pub fn velocity(&self, body: usize) -> DVec2 {
        let i = body;
        DVec2::new(self.bodies.vx[i], self.bodies.vy[i] * self.down)
    }

    /// What hit what during the last step.
    pub fn impacts(&self) -> &[CrowdImpact] {
        &self.impacts
    }
}
