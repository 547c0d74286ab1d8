//! Many bodies at once: the general method for piles, rows and rain, from about 64 moving bodies to many thousands.
//!
//! Here live the store of all bodies, in separate arrays, the broad phase, free flight, and the dense method over them, without a world
//! around them; named forces, streams and liquids do not. A step goes so:
//!
//! 1. `flight`: where would everything be, and how fast, if it touched nothing;
//! 2. `neighbours`: who may meet whom, sought anew only when a body leaves the box in which its neighbours were sought;
//! 3. `islands`: who could meet within this step, and whom it could meet then;
//! 4. `dense`: each island solved by itself; where a hit throws a body further than was looked for, its island grows and is solved again.
//!
//! Nothing iterates towards an answer except where bodies hang together in the air, so what comes to rest has velocity zero
//! exactly, after which a step changes no bit and the island sleeps until something outside changes or something else comes near.
//! What happens in one island changes no bit of another.
//!
//! Without forces from outside, kinetic and potential energy together never rise: whatever merges takes the velocity of the whole, and
//! impacts return at most what they took. So a pile rests when its last ball has bounced out. Those that fall on the heap when the others
//! lie still bounce alone, for up to √(2H/g)·(1 + e)/(1 − e): 20 s from 27 m at e = 0.8, and longer where a heavy body throws a light
//! one. That is no fault of the method, and no method that keeps restitution can rest earlier.

mod bodies;
mod clusters;
mod contacts;
mod cross;
mod def;
mod dense;
mod drag;
mod driver;
mod flight;
mod friction;
mod gas;
mod gravity;
mod grid;
mod impacts;
mod islands;
mod neighbours;
mod place;
mod reach;
mod report;
mod settled;
mod walls;

use super::guards::Guards;
use super::zones::fall;
use super::{Aabb, Sides};
use bodies::{Bodies, Traits};
use def::check;
pub use def::{PileBody, PileDef, PileError, PileSurface};
use dense::Dense;
pub(in crate::physics) use driver::{Advance, Store, Verdict};
use driver::{Driver, Target};
use glam::DVec2;
pub use impacts::Axis;
use islands::Islands;
use neighbours::Neighbours;
pub use report::{ContactForce, ContactImpulse};

/// What a body touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Other {
    /// The body of that number.
    Body(usize),
    /// The surface of that number.
    Surface(usize),
}

/// Two things hit each other during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PileImpact {
    /// The body that hit.
    pub a: usize,
    /// What it hit.
    pub b: Other,
    /// Along which axis.
    pub axis: Axis,
    /// Closing speed when they touched, m/s, > 0.
    pub speed: f64,
}

/// A body was squeezed between surfaces that close: the moving one was kept where it was for that step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Squeeze {
    /// The body that had no way out.
    pub body: usize,
    /// The surface that was stopped.
    pub surface: usize,
    /// How fast the surfaces would have closed, m/s.
    pub speed: f64,
}

/// Many boxes and their motion. Bodies keep the numbers of the definition for the outside.
#[derive(Clone, Debug)]
pub struct Pile {
    bodies: Bodies,
    neighbours: Neighbours,
    islands: Islands,
    dense: Dense,
    driver: Driver,
    /// 1, or −1 if gravity points to smaller y: inside, y grows along gravity.
    down: f64,
    gravity: f64,
    /// Those on which gravity does not act, by body; empty where it acts on all.
    weightless: Vec<bool>,
    drag: bool,
    rest_speed: f64,
    may_sleep: bool,
    /// Length of the last step, s; 0 before the first.
    last_dt: f64,
}

impl Pile {
    /// Checks the definition and builds the pile.
    ///
    /// # Errors
    /// A number that is not finite or out of its range.
    pub fn new(def: PileDef) -> Result<Self, PileError> {
        check(&def)?;
        let (n, s) = (def.bodies.len(), def.surfaces.len());
        let down = if def.gravity < 0.0 { -1.0 } else { 1.0 };
        let gravity = def.gravity * down;
        let mut bodies = Bodies::new(n, s);
        for (i, body) in def.bodies.iter().enumerate() {
            (bodies.x[i], bodies.y[i]) = (body.position.x, body.position.y * down);
            (bodies.px[i], bodies.py[i]) = (bodies.x[i], bodies.y[i]);
            (bodies.hx[i], bodies.hy[i]) = (body.half.x, body.half.y);
            (bodies.vx[i], bodies.vy[i]) = (body.velocity.x, body.velocity.y * down);
            bodies.ay[i] = gravity;
            bodies.mass[i] = body.mass;
            bodies.bounce[i] = body.restitution;
            let per_mass = |area: f64| 0.5 * def.air_density * area / body.mass;
            (bodies.drag_wide[i], bodies.drag_tall[i]) = (per_mass(body.drag_area.x), per_mass(body.drag_area.y));
            bodies.drag_round[i] = per_mass(body.drag_round);
            bodies.traits[i] = Traits {
                restitution: body.restitution,
                static_friction: body.static_friction,
                kinetic_friction: body.kinetic_friction,
            };
        }
        bodies.airy = def.air_density > 0.0 && def.bodies.iter().any(|body| body.drag_area != DVec2::ZERO || body.drag_round > 0.0);
        bodies.elastic = def.bodies.iter().any(|body| body.restitution == 1.0);
        let friction = |body: &PileBody| (body.static_friction, body.kinetic_friction);
        bodies.alike = def.bodies.iter().all(|body| friction(body) == friction(&def.bodies[0]));
        bodies.lively = def.bodies.iter().any(|body| body.restitution > 0.0);
        for (j, surface) in def.surfaces.iter().enumerate() {
            let (i, centre, half) = (n + j, surface.bounds.centre(), surface.bounds.size() * 0.5);
            (bodies.x[i], bodies.y[i]) = (centre.x, centre.y * down);
            (bodies.px[i], bodies.py[i]) = (bodies.x[i], bodies.y[i]);
            (bodies.hx[i], bodies.hy[i]) = (half.x, half.y);
            bodies.traits[i] =
                Traits { restitution: 0.0, static_friction: surface.static_friction, kinetic_friction: surface.kinetic_friction };
        }
        Ok(Self {
            neighbours: Neighbours::new(&bodies),
            islands: Islands::new(n),
            dense: Dense::new(&bodies),
            driver: Driver::new(n),
            down,
            gravity,
            weightless: Vec::new(),
            drag: bodies.airy,
            rest_speed: def.rest_speed,
            may_sleep: def.sleep,
            last_dt: 0.0,
            bodies,
        })
    }

    /// Sets the force (N) that acts on a body from outside from now on, besides weight and drag: drive, wind, buoyancy. A change
    /// wakes the body's island.
    pub fn set_force(&mut self, body: usize, force: DVec2) {
        let i = self.bodies.slot[body] as usize;
        let ax = force.x / self.bodies.mass[i];
        let gravity = if self.weightless.get(body).is_some_and(|weightless| *weightless) { 0.0 } else { self.gravity };
        let ay = fall(gravity, force.y * self.down / self.bodies.mass[i]);
        if ax != self.bodies.ax[i] || ay != self.bodies.ay[i] {
            (self.bodies.ax[i], self.bodies.ay[i]) = (ax, ay);
            self.driver.wake(body);
        }
    }

    /// Sets where a body would be after the next step (m) and how fast (m/s) if it touched nothing, for a motion that no constant force
    /// describes. Holds for that step; wakes nothing.
    pub fn guide(&mut self, body: usize, position: DVec2, velocity: DVec2) {
        let turned = DVec2::new(1.0, self.down);
        self.bodies.guided.push((body as u32, position * turned, velocity * turned));
    }

    /// Moves a surface during the next step so that its centre is there at the end of it, m. After that it stands, unless moved again.
    pub fn move_surface(&mut self, surface: usize, centre: DVec2) {
        self.lead_surface(surface, centre, None);
    }

    /// The same for a surface that speeds up or slows down: with how fast it moves when the step ends, m/s. What rides on it does so, too.
    pub fn lead_surface(&mut self, surface: usize, centre: DVec2, velocity: Option<DVec2>) {
        if self.driver.add_moving(surface) {
            self.neighbours.set_moving(surface);
        }
        let turned = DVec2::new(1.0, self.down);
        let (centre, velocity) = (centre * turned, velocity.map(|velocity| velocity * turned));
        self.driver.targets.push(Target { surface: surface as u32, centre, velocity });
    }

    /// Tells all that a surface sweeps in the next step, m, where it does not go straight to its end.
    pub(in crate::physics) fn sweep_surface(&mut self, surface: usize, swept: &Aabb) {
        let (top, bottom) = if self.down < 0.0 { (-swept.max.y, -swept.min.y) } else { (swept.min.y, swept.max.y) };
        self.driver.ways.push((surface as u32, [swept.min.x, swept.max.x, top, bottom]));
    }

    /// Feeds how fast surfaces moved when the last step ended to `write`: what had that velocity rides on them.
    pub(in crate::physics) fn hash_surfaces(&self, write: &mut impl FnMut(u64)) {
        let (n, moving) = (self.bodies.len(), &self.driver.moving);
        for j in moving.iter().map(|j| n + *j as usize) {
            [self.bodies.vx[j], self.bodies.vy[j]].into_iter().for_each(|value| write(value.to_bits()));
        }
    }

    /// Puts a surface where it is, m, without a step.
    pub(in crate::physics) fn place_surface(&mut self, surface: usize, centre: DVec2) {
        let j = self.bodies.len() + surface;
        (self.bodies.x[j], self.bodies.y[j]) = (centre.x, centre.y * self.down);
        self.bodies.changed_surfaces = true;
    }

    /// Lets a body, and what is in its island, be looked at again.
    pub(in crate::physics) fn wake(&mut self, body: usize) {
        self.driver.wake(body);
    }

    /// Whom the last step looked at, and who has been woken since; all others sleep.
    pub(in crate::physics) fn looked_at(&self) -> &[u32] {
        self.driver.looked_at()
    }

    /// The contacts of the last step that were listed.
    pub(in crate::physics) fn listed(&self) -> &[ContactImpulse] {
        &self.dense.report.list
    }

    /// Says that gravity does not act on a body. Its force has to be set anew after that.
    pub fn set_weightless(&mut self, body: usize) {
        self.weightless.resize(self.bodies.len(), false);
        self.weightless[body] = true;
        self.set_force(body, DVec2::ZERO);
    }

    /// Lets a surface throw back what hits it, 0 … 1.
    pub fn set_restitution(&mut self, surface: usize, restitution: f64) {
        let j = self.bodies.len() + surface;
        self.bodies.traits[j].restitution = restitution;
        self.bodies.elastic |= restitution == 1.0;
        self.bodies.lively |= restitution > 0.0;
        // Whatever falls on it may fly as far as if it bounced itself.
        let n = self.bodies.len();
        self.bodies.bounce[..n].iter_mut().for_each(|bounce| *bounce = bounce.max(restitution));
    }

    /// Makes a surface a belt, m/s: clockwise around it, the upper side runs to the right. Wakes all.
    pub fn set_belt(&mut self, surface: usize, speed: f64) {
        let j = self.bodies.len() + surface;
        self.bodies.belt[j] = speed * self.down;
        self.wake_all();
    }

    /// Sets from which sides a surface is solid. Wakes all.
    pub fn set_sides(&mut self, surface: usize, sides: Sides) {
        let j = self.bodies.len() + surface;
        let turned = Sides { top: sides.bottom, bottom: sides.top, ..sides };
        self.bodies.sides[j] = if self.down < 0.0 { turned } else { sides };
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
        self.driver.wake_all();
        self.dense.settled.forget();
    }

    /// Whom surfaces would have squeezed in the last step.
    pub fn squeezed(&self) -> &[Squeeze] {
        &self.driver.squeezed
    }

    /// How often each guard of the dense method has acted since the start.
    pub fn guards(&self) -> &Guards {
        &self.dense.guards
    }

    /// The same, and begins to count anew.
    pub(in crate::physics) fn take_guards(&mut self) -> Guards {
        self.dense.take_guards()
    }

    /// The number of bodies.
    pub fn len(&self) -> usize {
        self.bodies.len()
    }

    /// Whether there is no body.
    pub fn is_empty(&self) -> bool {
        self.bodies.len() == 0
    }

    /// Whether there has been a step.
    pub fn has_stepped(&self) -> bool {
        self.last_dt > 0.0
    }

    /// Whether all rest and nothing is computed until a force changes.
    pub fn is_asleep(&self) -> bool {
        self.driver.all_asleep()
    }

    /// Whether the body's island rests, so that nothing is computed for it.
    pub fn is_sleeping(&self, body: usize) -> bool {
        self.driver.sleeps(body)
    }

    /// A body's centre, m.
    pub fn position(&self, body: usize) -> DVec2 {
        let i = self.bodies.slot[body] as usize;
        DVec2::new(self.bodies.x[i], self.bodies.y[i] * self.down)
    }

    /// A body's velocity, m/s.
    pub fn velocity(&self, body: usize) -> DVec2 {
        let i = self.bodies.slot[body] as usize;
        DVec2::new(self.bodies.vx[i], self.bodies.vy[i] * self.down)
    }

    /// A body's mean acceleration over the last step, m/s²: impacts included. Zero before the first step.
    pub fn acceleration(&self, body: usize) -> DVec2 {
        let (i, b) = (self.bodies.slot[body] as usize, &self.bodies);
        if self.last_dt == 0.0 || self.driver.sleeps(body) {
            return DVec2::ZERO;
        }
        DVec2::new(b.vx[i] - b.ux[i], (b.vy[i] - b.uy[i]) * self.down) / self.last_dt
    }

    /// The box that a body fills, m.
    pub fn bounds(&self, body: usize) -> Aabb {
        let i = self.bodies.slot[body] as usize;
        Aabb::around(self.position(body), DVec2::new(self.bodies.hx[i], self.bodies.hy[i]))
    }

    /// What hit what during the last step.
    pub fn impacts(&self) -> &[PileImpact] {
        &self.driver.events
    }
}
