//! Many bodies at once: the general method for piles, rows and rain, from about 64 moving bodies to many thousands.
//!
//! Here live the passes of one step over separate arrays, without a world around them; the exact, event-driven engine for small
//! scenes, named forces, streams and liquids do not. A step goes so:
//!
//! 1. `flight`: where would everything be, and how fast, if it touched nothing;
//! 2. `neighbours`: who may meet whom, sought anew only when a body leaves the box in which its neighbours were sought;
//! 3. `contacts`: which of these touch in this step, along which axis, and how fast they may close;
//! 4. `gravity`: velocities along gravity, one pass bottom-up; `cross`: those across it, with the `friction` of the stacks;
//!    what is neither carried nor held merges in `clusters`; where a hit threw a body further than was looked for, a
//!    `second_look` adds the contacts on its way, and the step is solved again;
//! 5. `place`: positions that cannot overlap, by construction;
//! 6. `bounce`: restitution, after the move; `energy`: never more than there was.
//!
//! Nothing iterates towards an answer except where bodies hang together in the air, so what comes to rest has velocity zero
//! exactly, after which a step changes no bit and the whole pile sleeps until something outside changes.
//!
//! Without forces from outside, kinetic and potential energy together never rise: whatever merges moves from a common start,
//! friction that would drive is relaxed instead, and rebounds give back no more than was lost. So a pile rests when its last ball
//! has bounced out. Those that fall on the heap when the others lie still bounce alone, for up to √(2H/g)·(1 + e)/(1 − e): 20 s
//! from 27 m at e = 0.8, and longer where a heavy body throws a light one. That is no fault of the method, and no method that keeps
//! restitution can rest earlier.
//!
//! What it costs, 5000 bodies with restitutions up to 0.8 for 10 s, by samples: the passes along and across with merging and moving
//! a third, the narrow phase 22 %, the search 18 %, friction 16 %. Most of it goes into the first three seconds, in which many boxes
//! hit each other in the air: there a step is solved two or three times over, and columns and rows that close gaps are merged one
//! contact at a time, in several passes over all contacts.

mod bodies;
mod bounce;
mod clusters;
mod contacts;
mod cross;
mod def;
mod energy;
mod flight;
mod friction;
mod gravity;
mod grid;
mod neighbours;
mod place;
mod report;
mod second_look;

use super::Aabb;
use bodies::{Bodies, Traits};
pub use bounce::Axis;
use bounce::Impacts;
use clusters::Clusters;
use contacts::Contacts;
use cross::Pushes;
use def::check;
pub use def::{PileBody, PileDef, PileError, PileSurface};
use friction::Friction;
use glam::DVec2;
use neighbours::Neighbours;
pub use report::ContactForce;
use second_look::SecondLook;

/// How often contacts are sought again in one step because a hit threw a body further than was looked for.
const SECOND_LOOKS: usize = 3;

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

/// Many boxes and their motion. Bodies keep the numbers of the definition for the outside.
#[derive(Clone, Debug)]
pub struct Pile {
    bodies: Bodies,
    neighbours: Neighbours,
    contacts: Contacts,
    friction: Friction,
    clusters: Clusters,
    impacts: Impacts,
    second_look: SecondLook,
    report: report::Scratch,
    events: Vec<PileImpact>,
    /// Whether the ground carries a body, in this step; surfaces always.
    anchored: Vec<bool>,
    pushes: Pushes,
    put_back: Vec<[bool; 2]>,
    /// 1, or −1 if gravity points to smaller y: inside, y grows along gravity.
    down: f64,
    gravity: f64,
    drag: bool,
    rest_speed: f64,
    may_sleep: bool,
    asleep: bool,
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
            let per_mass = |area: f64| 0.5 * def.air_density * area / body.mass;
            (bodies.drag_wide[i], bodies.drag_tall[i]) = (per_mass(body.drag_area.x), per_mass(body.drag_area.y));
            bodies.drag_round[i] = per_mass(body.drag_round);
            bodies.traits[i] = Traits {
                restitution: body.restitution,
                static_friction: body.static_friction,
                kinetic_friction: body.kinetic_friction,
            };
        }
        for (j, surface) in def.surfaces.iter().enumerate() {
            let (i, centre, half) = (n + j, surface.bounds.centre(), surface.bounds.size() * 0.5);
            (bodies.x[i], bodies.y[i]) = (centre.x, centre.y * down);
            (bodies.px[i], bodies.py[i]) = (bodies.x[i], bodies.y[i]);
            (bodies.hx[i], bodies.hy[i]) = (half.x, half.y);
            bodies.traits[i] =
                Traits { restitution: 0.0, static_friction: surface.static_friction, kinetic_friction: surface.kinetic_friction };
        }
        let mut anchored = vec![false; n];
        anchored.resize(n + s, true);
        Ok(Self {
            neighbours: Neighbours::new(&bodies),
            contacts: Contacts::new(n),
            friction: Friction::new(&bodies),
            clusters: Clusters::new(n + s),
            impacts: Impacts::new(n),
            second_look: SecondLook::new(n + s),
            report: report::Scratch::default(),
            events: Vec::new(),
            anchored,
            pushes: Pushes::new(n),
            put_back: vec![[false; 2]; n],
            down,
            gravity,
            drag: def.air_density > 0.0 && def.bodies.iter().any(|body| body.drag_area != DVec2::ZERO || body.drag_round > 0.0),
            rest_speed: def.rest_speed,
            may_sleep: def.sleep,
            asleep: n == 0,
            last_dt: 0.0,
            bodies,
        })
    }

    /// Sets the force (N) that acts on a body from outside from now on, besides weight and drag: drive, wind, buoyancy. A change
    /// wakes the pile.
    pub fn set_force(&mut self, body: usize, force: DVec2) {
        let i = self.bodies.slot[body] as usize;
        let ax = force.x / self.bodies.mass[i];
        let ay = self.gravity + force.y * self.down / self.bodies.mass[i];
        if ax != self.bodies.ax[i] || ay != self.bodies.ay[i] {
            (self.bodies.ax[i], self.bodies.ay[i]) = (ax, ay);
            self.asleep = false;
        }
    }

    /// Sets where a body would be after the next step (m) and how fast (m/s) if it touched nothing, for a motion that no constant force
    /// describes. Holds for that step; wakes nothing.
    pub fn guide(&mut self, body: usize, position: DVec2, velocity: DVec2) {
        let turned = DVec2::new(1.0, self.down);
        self.bodies.guided.push((body as u32, position * turned, velocity * turned));
    }

    /// Advances the pile by `dt` seconds, > 0.
    pub fn step(&mut self, dt: f64) {
        self.take_step(dt);
        self.bodies.guided.clear();
    }

    fn take_step(&mut self, dt: f64) {
        self.events.clear();
        if self.asleep {
            return;
        }
        self.last_dt = dt;
        self.neighbours.drift(&mut self.bodies, dt);
        let inside = flight::fly(&mut self.bodies, dt, self.drag);
        if !inside {
            self.neighbours.update(&mut self.bodies, dt);
        }
        if self.neighbours.is_empty() {
            self.fly_on();
            return;
        }
        self.find_contacts(dt);
        let mut inside = false;
        for look in 0..=SECOND_LOOKS {
            if look > 0 {
                self.look_again(dt);
            }
            inside = self.solve_along(dt);
            if !inside && look < SECOND_LOOKS {
                continue;
            }
            inside &= self.solve_across(dt);
            if inside {
                break;
            }
        }
        place::part(&mut self.bodies, &self.contacts, &mut self.clusters, &mut self.put_back, dt, inside);
        self.impacts.measure(&self.bodies, dt);
        self.impacts.rebound(&mut self.bodies, &self.anchored, self.rest_speed, dt);
        energy::restrain(&mut self.bodies, dt);
        self.report_impacts();
        self.bodies.commit();
        self.fall_asleep();
    }

    fn find_contacts(&mut self, dt: f64) {
        let Self { bodies, neighbours, contacts, .. } = self;
        contacts.sweep(bodies);
        if !contacts.find(bodies, neighbours, dt) {
            neighbours.search(bodies, dt);
            contacts.sweep(bodies);
            contacts.find(bodies, neighbours, dt);
        }
    }

    /// With nobody near anybody, free flight is the answer.
    fn fly_on(&mut self) {
        let bodies = &mut self.bodies;
        std::mem::swap(&mut bodies.ux, &mut bodies.free_vx);
        std::mem::swap(&mut bodies.uy, &mut bodies.free_vy);
        bodies.commit();
        self.contacts.clear();
    }

    /// A hit threw bodies further than was looked for: seeks neighbours and contacts on their new ways.
    fn look_again(&mut self, dt: f64) {
        let Self { bodies, neighbours, contacts, second_look, .. } = self;
        second_look.collect(bodies, contacts);
        let known = neighbours.added();
        let renumbered = !flight::stays(bodies) && neighbours.update(bodies, dt);
        if !renumbered && second_look.add(bodies, neighbours, known, contacts, dt) {
            flight::fly(bodies, dt, self.drag);
            return;
        }
        if !renumbered {
            neighbours.search(bodies, dt);
        }
        contacts.sweep(bodies);
        flight::fly(bodies, dt, self.drag);
        (0..bodies.len()).for_each(|i| contacts.widen(bodies, i));
        contacts.find(bodies, neighbours, dt);
    }

    /// Velocities and positions along gravity. Returns whether nobody was thrown further than was looked for.
    fn solve_along(&mut self, dt: f64) -> bool {
        self.impacts.clear(self.gravity, dt);
        let Self { bodies, contacts, anchored, clusters, impacts, .. } = self;
        gravity::solve(bodies, contacts, anchored, clusters, impacts);
        place::move_along(bodies, contacts, dt)
    }

    /// The same across.
    fn solve_across(&mut self, dt: f64) -> bool {
        let Self { bodies, contacts, clusters, impacts, friction, pushes, .. } = self;
        cross::solve(bodies, contacts, friction, clusters, impacts, pushes);
        place::move_across(bodies, contacts, self.gravity, dt)
    }

    fn report_impacts(&mut self) {
        let (n, id) = (self.bodies.len(), &self.bodies.id);
        let other = |i: usize| if i < n { Other::Body(id[i] as usize) } else { Other::Surface(i - n) };
        for hit in &self.impacts.all {
            let (a, b) = (hit.a as usize, hit.b as usize);
            let (a, b) = if a < n { (a, b) } else { (b, a) };
            self.events.push(PileImpact { a: id[a] as usize, b: other(b), axis: hit.axis, speed: hit.speed });
        }
    }

    /// A step that moved nothing and left nothing moving would be followed by the same for ever.
    fn fall_asleep(&mut self) {
        let (bodies, n) = (&self.bodies, self.bodies.len());
        let still = |v: &[f64]| v[..n].iter().rev().all(|v| *v == 0.0);
        let rests = still(&bodies.vy) && still(&bodies.vx) && still(&bodies.uy) && still(&bodies.ux);
        self.asleep = self.may_sleep && rests && bodies.x[..n] == bodies.px[..n] && bodies.y[..n] == bodies.py[..n];
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
        self.asleep
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
        if self.last_dt == 0.0 || self.asleep {
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
        &self.events
    }
}
