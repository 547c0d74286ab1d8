//! The world: what is in it, and how a tick goes.

use super::candidates::Candidates;
use super::contacts::Contact;
use super::crowd::{CROWD, Crowd};
use super::flow::Pose;
use super::happenings::Happening;
use super::impact_time::Cubic;
use super::impacts::Resume;
use super::interval::Motion;
use super::media::{Law, Media};
use super::reactions::Reactions;
use super::tuning::{EDGE_THICKNESS, MAX_INTERVALS, RETRIES, RETRY_PART, SLOP};
use super::{Aabb, Body, BodyDef, BodyId, DefError, ForceManager, Material, Plan, SurfaceDef, WorldDef};
use glam::DVec2;

/// What a body can run into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Obstacle {
    /// The surface of that index in [`World::surfaces`].
    Surface(u32),
    /// Another body.
    Body(BodyId),
}

/// What happened during the last tick, for rules, view and sound.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// Two things hit each other.
    Impact {
        /// The body that hit.
        a: BodyId,
        /// What it hit.
        b: Obstacle,
        /// The middle of the shared edge, m.
        point: DVec2,
        /// Unit vector from `b` towards `a`.
        normal: DVec2,
        /// Closing speed along the normal just before, m/s, > 0.
        speed: f64,
    },
}

/// Bodies, surfaces, zones, and the state of their motion. Two worlds that began alike and were stepped alike are alike to the bit.
#[derive(Clone, Debug)]
pub struct World {
    // The state: this and nothing else decides what happens next.
    pub(super) bodies: Vec<Body>,
    pub(super) drives: Vec<DVec2>,
    pub(super) surfaces: Vec<SurfaceDef>,
    pub(super) media: Media,
    pub(super) rest_speed: f64,
    pub(super) plan: Plan,
    // What the last tick leaves to be read.
    previous: Vec<DVec2>,
    pub(super) forces: Vec<ForceManager>,
    pub(super) events: Vec<Event>,
    pub(super) corners: Vec<(u32, DVec2)>,
    overflows: u64,
    /// Nothing moved or will move until something is changed from outside.
    pub(super) still: bool,
    /// Still, and the previous positions say so too.
    settled: bool,
    /// Set where the plan says so: it then advances the bodies.
    pub(super) crowd: Option<Box<Crowd>>,
    // Scratch, kept so that a tick allocates nothing once warm.
    /// Centre and half of every surface, m.
    pub(super) blocks: Vec<(DVec2, DVec2)>,
    pub(super) candidates: Candidates,
    pub(super) contacts: Vec<Contact>,
    pub(super) touching: Vec<Contact>,
    pub(super) reactions: Reactions,
    pub(super) laws: Vec<Law>,
    pub(super) motions: Vec<Motion>,
    pub(super) cubics: Vec<Cubic>,
    pub(super) in_contact: Vec<bool>,
    pub(super) in_stream: Vec<bool>,
    pub(super) across: Vec<bool>,
    pub(super) crossings: Vec<u32>,
    pub(super) hits: Vec<u32>,
    pub(super) resumes: Vec<Resume>,
    pub(super) now: f64,
    pub(super) overflowing: bool,
    pub(super) free: Vec<DVec2>,
    pub(super) solved: Vec<DVec2>,
    pub(super) coupled: Vec<Pose>,
    pub(super) coupled_at: f64,
    pub(super) coupled_nodes: Vec<Pose>,
    pub(super) coupled_step: f64,
    pub(super) coupled_steps: usize,
    pub(super) stage: Vec<Pose>,
    pub(super) stage_free: Vec<DVec2>,
    pub(super) stage_accelerations: Vec<DVec2>,
    pub(super) stage_contacts: Vec<Contact>,
    pub(super) sums: Vec<Pose>,
    poses: Vec<Pose>,
}

impl World {
    /// Checks the definition and builds the world.
    ///
    /// # Errors
    /// A number that is not finite or out of its range.
    pub fn new(def: WorldDef) -> Result<Self, DefError> {
        let plan = Plan::of(&def);
        Self::with_plan(def, plan)
    }

    /// As [`World::new`] with parts of the model that the definition does not need: they cost time and change no bit, which is what
    /// this is for showing. A plan without a part that is needed leaves its effect out.
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn with_plan(mut def: WorldDef, plan: Plan) -> Result<Self, DefError> {
        def.check()?;
        def.surfaces.extend(def.bounds.iter().flat_map(edges));
        let n = def.bodies.len();
        let mut world = Self {
            bodies: def.bodies.iter().map(Body::new).collect(),
            drives: vec![DVec2::ZERO; n],
            blocks: def.surfaces.iter().map(|surface| (surface.bounds.centre(), surface.bounds.size() * 0.5)).collect(),
            surfaces: def.surfaces,
            media: Media { gravity: def.gravity, air_density: def.air_density, streams: def.streams, fluids: def.fluids },
            rest_speed: def.rest_speed,
            plan,
            previous: def.bodies.iter().map(|body| body.position).collect(),
            forces: vec![ForceManager::default(); n],
            events: Vec::new(),
            corners: Vec::new(),
            overflows: 0,
            still: false,
            settled: false,
            crowd: None,
            candidates: Candidates::default(),
            contacts: Vec::new(),
            touching: Vec::new(),
            reactions: Reactions::default(),
            laws: Vec::new(),
            motions: Vec::new(),
            cubics: Vec::new(),
            in_contact: Vec::new(),
            in_stream: Vec::new(),
            across: Vec::new(),
            crossings: Vec::new(),
            hits: Vec::new(),
            resumes: Vec::new(),
            now: 0.0,
            overflowing: false,
            free: Vec::new(),
            solved: Vec::new(),
            coupled: Vec::new(),
            coupled_at: f64::NAN,
            coupled_nodes: Vec::new(),
            coupled_step: 0.0,
            coupled_steps: 1,
            stage: Vec::new(),
            stage_free: Vec::new(),
            stage_accelerations: Vec::new(),
            stage_contacts: Vec::new(),
            sums: Vec::new(),
            poses: Vec::new(),
        };
        world.gather_crowd()?;
        world.show_start();
        Ok(world)
    }

    /// Adds a body while the world runs (the menu's balls).
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn add_body(&mut self, def: BodyDef) -> Result<BodyId, DefError> {
        def.check()?;
        let id = BodyId(self.bodies.len() as u32);
        self.bodies.push(Body::new(&def));
        self.drives.push(DVec2::ZERO);
        self.previous.push(def.position);
        self.forces.push(ForceManager::default());
        self.plan.pairs |= self.bodies.len() > 1;
        self.plan.crowd |= self.bodies.len() > CROWD;
        self.plan.contacts |= self.plan.pairs;
        self.plan.air |= self.media.air_density > 0.0 && def.feels_air && def.drag > 0.0;
        self.plan.bounces |= def.restitution > 0.0;
        // Contacts and pairs count surfaces on from the number of bodies.
        self.contacts.clear();
        self.candidates.spoil();
        self.wake();
        self.gather_crowd()?;
        Ok(id)
    }

    /// Sets the force of a body's engine (N) from the next tick on. A force that is not finite is none.
    pub fn set_drive(&mut self, body: BodyId, force: DVec2) {
        let force = if force.is_finite() { force } else { DVec2::ZERO };
        if self.drives[body.index()] != force {
            self.drives[body.index()] = force;
            self.wake();
        }
    }

    fn wake(&mut self) {
        self.still = false;
        self.settled = false;
    }

    /// Advances the world by exactly one tick of `dt` seconds, in intervals between the things that happen within it.
    pub fn step(&mut self, dt: f64) {
        self.events.clear();
        self.corners.clear();
        if !self.settled {
            self.settled = self.still;
            self.begin_tick();
        }
        if self.still {
            return;
        }
        if let Some(mut crowd) = self.crowd.take() {
            self.step_crowd(&mut crowd, dt);
            self.crowd = Some(crowd);
            return;
        }
        self.refresh_laws();
        self.refresh_candidates(dt);
        let mut intervals = 0;
        let mut hit = None;
        loop {
            let left = dt - self.now;
            self.refresh_laws();
            if self.plan.contacts {
                self.resolve_impacts(hit.take(), self.now, left);
                if self.plan.media() {
                    // Impacts turn motions, and with them the side that meets the air.
                    self.refresh_laws();
                }
                self.refresh_candidates(left);
                self.find_contacts();
            }
            self.solve_accelerations();
            let longest = self.choose_motions(left, dt);
            let (t, happening) = self.next_happening(longest);
            let (t, happening) = self.advance(t, happening);
            intervals += 1;
            self.overflowing = intervals > MAX_INTERVALS / 2;
            let last = (matches!(happening, Happening::Nothing) && t >= left) || intervals > MAX_INTERVALS;
            if last {
                // Shown are the forces at the beginning of the interval that leads to what is shown with them.
                self.show_forces();
            }
            self.commit();
            self.now += t;
            if last {
                break;
            }
            hit = self.apply(happening);
        }
        self.overflows += u64::from(self.overflowing);
        self.still = self.motions.iter().all(|&motion| motion == Motion::Still);
    }

    fn begin_tick(&mut self) {
        for (previous, body) in self.previous.iter_mut().zip(&self.bodies) {
            *previous = body.position;
        }
        self.now = 0.0;
        self.overflowing = false;
        self.resumes.clear();
        let n = self.bodies.len();
        self.hits.clear();
        self.hits.resize(n, 0);
        self.crossings.clear();
        self.crossings.resize(n, 0);
        self.find_zones();
    }

    /// Which body feels which stream, from where they are; crossings within the tick keep it true.
    fn find_zones(&mut self) {
        self.in_stream.clear();
        self.across.clear();
        for (body, drive) in self.bodies.iter().zip(&self.drives) {
            let bounds = body.bounds();
            self.in_stream.extend(self.media.streams.iter().map(|stream| bounds.touches(&stream.zone, SLOP)));
            // On the border between the two sides (and at rest) it is the force that decides: drag alone leaves the direction as it is.
            let v = body.velocity;
            let force = *drive + DVec2::new(0.0, body.mass * self.media.gravity);
            let turns = |v: f64, force: f64| if v == 0.0 { force.abs() } else { force * v.signum() };
            let across = if v.x.abs() == v.y.abs() { turns(v.x, force.x) > turns(v.y, force.y) } else { v.x.abs() > v.y.abs() };
            self.across.push(across);
        }
    }

    /// The law of motion of every body in the coming interval.
    pub(super) fn refresh_laws(&mut self) {
        self.laws.clear();
        let streams = self.media.streams.len();
        for (i, body) in self.bodies.iter().enumerate() {
            let speed = body.velocity.abs();
            if speed.x != speed.y {
                self.across[i] = speed.x > speed.y;
            }
            let mut force = self.drives[i];
            for (stream, inside) in self.media.streams.iter().zip(&self.in_stream[i * streams..]) {
                if *inside {
                    force += stream.force;
                }
            }
            let mut law = Law { constant: DVec2::new(0.0, self.media.gravity) + force / body.mass, ..Law::default() };
            law.area = 2.0 * if self.across[i] { body.half.y } else { body.half.x };
            if self.plan.air && body.feels_air {
                law.air = 0.5 * self.media.air_density * body.drag * law.area / body.mass;
            }
            if self.plan.liquids {
                let reach = body.half + body.velocity.abs() + DVec2::ONE;
                let near = Aabb::around(body.position, reach);
                law.wet = self.media.fluids.iter().any(|fluid| near.touches(&fluid.zone, 0.0));
            }
            self.laws.push(law);
        }
    }

    /// Finds where everything is after `t` seconds. Where a motion is no cubic, an impact can have been overlooked: if anything has sunk
    /// into anything on the way, the interval was too long, and a part of it is taken instead.
    fn advance(&mut self, mut t: f64, mut happening: Happening) -> (f64, Happening) {
        for _ in 0..RETRIES {
            self.find_poses(t);
            if !self.plan.media() || !self.has_sunk() {
                return (t, happening);
            }
            t *= RETRY_PART;
            happening = Happening::Look;
        }
        self.find_poses(t);
        (t, happening)
    }

    fn find_poses(&mut self, t: f64) {
        self.poses.clear();
        for i in 0..self.bodies.len() {
            let pose = self.pose(i, t);
            self.poses.push(pose);
        }
    }

    /// Whether some pair of which one is no cubic overlaps at the new poses, and more than before.
    fn has_sunk(&self) -> bool {
        let follows = |item: u32| self.motions.get(item as usize).is_some_and(|m| matches!(m, Motion::Flow | Motion::Coupled));
        let after = |item: u32| self.poses.get(item as usize).map_or_else(|| self.place(item), |pose| pose.0);
        self.candidates.pairs.iter().any(|pair| {
            let reach = self.half(pair.a) + self.half(pair.b);
            let depth = |a: DVec2, b: DVec2| (reach - (b - a).abs()).min_element();
            let now = depth(after(pair.a), after(pair.b));
            now > 2.0 * SLOP && (follows(pair.a) || follows(pair.b)) && now > depth(self.place(pair.a), self.place(pair.b)) + SLOP
        })
    }

    /// Moves everything to the poses found.
    fn commit(&mut self) {
        for (body, &(position, velocity)) in self.bodies.iter_mut().zip(&self.poses) {
            (body.position, body.velocity) = (position, velocity);
        }
    }

    /// Does what ended the interval; returns the pair that met, if that was it.
    fn apply(&mut self, happening: Happening) -> Option<Contact> {
        match happening {
            Happening::Nothing | Happening::Edge | Happening::Look => {}
            Happening::Hit(contact) => {
                self.place_against(&contact);
                return Some(contact);
            }
            Happening::Stop(axis) => {
                let items = self.bodies.len() + self.blocks.len();
                self.reactions.merge_speeds(axis, &self.contacts, &mut self.bodies, items);
            }
            Happening::Stream(body, stream) => {
                let at = body as usize * self.media.streams.len() + stream as usize;
                self.in_stream[at] = !self.in_stream[at];
                self.crossings[body as usize] += 1;
            }
            Happening::Kink(body) => {
                let i = body as usize;
                let v = self.bodies[i].velocity;
                self.across[i] = v.x.abs() > v.y.abs();
                self.crossings[i] += 1;
            }
            Happening::Resume(index) => {
                let resume = self.resumes.swap_remove(index as usize);
                self.bodies[resume.body as usize].velocity[resume.axis] += resume.speed;
            }
        }
        None
    }

    /// Sets a body exactly against the immovable face that it met: no rounding of the time of impact is left.
    fn place_against(&mut self, contact: &Contact) {
        let axis = contact.axis;
        let (body, other, side) =
            if self.immovable(contact.hi) { (contact.lo, contact.hi, -1.0) } else { (contact.hi, contact.lo, 1.0) };
        if !self.immovable(other) {
            return;
        }
        let at = self.place(other)[axis] + side * (self.half(other)[axis] + self.half(body)[axis]);
        self.bodies[body as usize].position[axis] = at;
    }

    /// The forces before the first tick.
    fn show_start(&mut self) {
        self.begin_tick();
        self.refresh_laws();
        self.refresh_candidates(0.0);
        if self.plan.contacts {
            self.find_contacts();
        }
        self.solve_accelerations();
        self.choose_motions(0.0, 0.0);
        self.show_forces();
    }

    /// All bodies, by [`BodyId::index`].
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// One body.
    pub fn body(&self, id: BodyId) -> &Body {
        &self.bodies[id.index()]
    }

    /// Where a body's centre was one tick ago, m: the view interpolates from here.
    pub fn previous_position(&self, id: BodyId) -> DVec2 {
        self.previous[id.index()]
    }

    /// The forces on a body: those that acted last during the last tick; before the first tick those at the start.
    pub fn forces(&self, id: BodyId) -> &ForceManager {
        &self.forces[id.index()]
    }

    /// The immovable surfaces: those of the definition, then the four edges (left, right, top, bottom) where there are any.
    pub fn surfaces(&self) -> &[SurfaceDef] {
        &self.surfaces
    }

    /// What happened during the last tick.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The corners of the path of a body's centre during the last tick, from where it was to where it is.
    pub fn path(&self, id: BodyId) -> impl Iterator<Item = DVec2> + '_ {
        let corners = self.corners.iter().filter(move |(body, _)| *body == id.0).map(|(_, at)| *at);
        std::iter::once(self.previous[id.index()]).chain(corners).chain(std::iter::once(self.bodies[id.index()].position))
    }

    /// The parts of the model that this world uses.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Ticks so far in which so much happened that the rest of their impacts became plastic.
    pub fn overflows(&self) -> u64 {
        self.overflows
    }

    /// Feeds every bit of the state to `write`, for the state's hash.
    pub fn hash_state(&self, write: &mut impl FnMut(u64)) {
        for body in &self.bodies {
            for value in [body.position.x, body.position.y, body.velocity.x, body.velocity.y] {
                write(value.to_bits());
            }
        }
    }
}

/// The four solid edges around a level: left, right, top, bottom.
fn edges(bounds: &Aabb) -> [SurfaceDef; 4] {
    let (min, max) = (bounds.min, bounds.max);
    let t = EDGE_THICKNESS;
    let edge =
        |x0, y0, x1, y1| SurfaceDef { bounds: Aabb::new(DVec2::new(x0, y0), DVec2::new(x1, y1)), material: Material::ASPHALT };
    [
        edge(min.x - t, min.y - t, min.x, max.y + t),
        edge(max.x, min.y - t, max.x + t, max.y + t),
        edge(min.x, min.y - t, max.x, min.y),
        edge(min.x, max.y, max.x, max.y + t),
    ]
}
