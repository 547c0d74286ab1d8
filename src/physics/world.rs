//! The world: what is in it, and what can be asked of it. How a tick goes is in `tick`.

use super::candidates::Candidates;
use super::contacts::Contact;
use super::crowd::{CROWD, Crowd};
use super::flow::Pose;
use super::impact_time::Cubic;
use super::impacts::Resume;
use super::interval::Motion;
use super::media::{Law, Media};
use super::reactions::Reactions;
use super::tuning::EDGE_THICKNESS;
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
    pub(super) previous: Vec<DVec2>,
    pub(super) forces: Vec<ForceManager>,
    pub(super) events: Vec<Event>,
    pub(super) corners: Vec<(u32, DVec2)>,
    pub(super) overflows: u64,
    // What is known from the last tick, so that it need not be found again.
    /// The bodies that a tick looks at, in ascending order; the others rest (see `rest`).
    pub(super) awake: Vec<u32>,
    pub(super) resting: Vec<bool>,
    /// The contacts within what rests, as they were solved.
    pub(super) resting_contacts: Vec<Contact>,
    /// Nothing has changed that the laws of motion depend on where there are no media.
    pub(super) laws_hold: bool,
    /// The force managers list what acts now, but for the forces of media.
    pub(super) forces_hold: bool,
    /// Set where the plan says so: it then advances the bodies.
    pub(super) crowd: Option<Box<Crowd>>,
    // Scratch, kept so that a tick allocates nothing once warm.
    /// Centre and half of every surface, m.
    pub(super) blocks: Vec<(DVec2, DVec2)>,
    pub(super) candidates: Candidates,
    /// The contacts as they are solved, and as they were before that with the free accelerations: while these stay, so does the answer.
    pub(super) contacts: Vec<Contact>,
    pub(super) asked: Vec<Contact>,
    pub(super) asked_free: Vec<DVec2>,
    pub(super) answer_holds: bool,
    pub(super) found: Vec<Contact>,
    pub(super) touching: Vec<Contact>,
    pub(super) reactions: Reactions,
    pub(super) laws: Vec<Law>,
    pub(super) motions: Vec<Motion>,
    pub(super) cubics: Vec<Cubic>,
    pub(super) in_contact: Vec<bool>,
    pub(super) in_stream: Vec<bool>,
    pub(super) crossings: Vec<u32>,
    pub(super) hits: Vec<u32>,
    pub(super) clung: Vec<u32>,
    pub(super) resumes: Vec<Resume>,
    pub(super) now: f64,
    pub(super) tick: f64,
    pub(super) overflowing: bool,
    pub(super) free: Vec<DVec2>,
    pub(super) solved: Vec<DVec2>,
    pub(super) coupled_bodies: Vec<u32>,
    pub(super) coupled: Vec<Pose>,
    pub(super) coupled_at: f64,
    pub(super) coupled_nodes: Vec<Pose>,
    pub(super) coupled_step: f64,
    pub(super) coupled_steps: usize,
    pub(super) stage: Vec<Pose>,
    pub(super) speeds: Vec<DVec2>,
    pub(super) stage_accelerations: Vec<DVec2>,
    pub(super) stage_contacts: Vec<Contact>,
    pub(super) sums: Vec<Pose>,
    pub(super) poses: Vec<Pose>,
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
            awake: Vec::new(),
            resting: Vec::new(),
            resting_contacts: Vec::new(),
            laws_hold: false,
            forces_hold: false,
            crowd: None,
            candidates: Candidates::default(),
            contacts: Vec::new(),
            asked: Vec::new(),
            asked_free: Vec::new(),
            answer_holds: false,
            found: Vec::new(),
            touching: Vec::new(),
            reactions: Reactions::default(),
            laws: Vec::new(),
            motions: Vec::new(),
            cubics: Vec::new(),
            in_contact: Vec::new(),
            in_stream: Vec::new(),
            crossings: Vec::new(),
            hits: Vec::new(),
            clung: Vec::new(),
            resumes: Vec::new(),
            now: 0.0,
            tick: 0.0,
            overflowing: false,
            free: Vec::new(),
            solved: Vec::new(),
            coupled_bodies: Vec::new(),
            coupled: Vec::new(),
            coupled_at: f64::NAN,
            coupled_nodes: Vec::new(),
            coupled_step: 0.0,
            coupled_steps: 1,
            stage: Vec::new(),
            speeds: Vec::new(),
            stage_accelerations: Vec::new(),
            stage_contacts: Vec::new(),
            sums: Vec::new(),
            poses: Vec::new(),
        };
        world.make_room();
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
        self.make_room();
        self.gather_crowd()?;
        Ok(id)
    }

    /// Sets the force of a body's engine (N) from the next tick on. A force that is not finite is none.
    pub fn set_drive(&mut self, body: BodyId, force: DVec2) {
        let force = if force.is_finite() { force } else { DVec2::ZERO };
        if self.drives[body.index()] != force {
            self.drives[body.index()] = force;
            self.laws_hold = false;
            self.forces_hold = false;
            self.wake(body.0);
        }
    }

    /// Fits everything that is kept for each body to their number. All of them are awake then, and no contact is known: contacts and
    /// pairs count surfaces on from the number of bodies.
    fn make_room(&mut self) {
        let n = self.bodies.len();
        self.awake.clear();
        self.awake.extend(0..n as u32);
        self.resting.clear();
        self.resting.resize(n, false);
        self.contacts.clear();
        self.answer_holds = false;
        self.resting_contacts.clear();
        self.candidates.spoil();
        self.laws_hold = false;
        self.forces_hold = false;
        self.laws.resize(n, Law::default());
        self.motions.resize(n, Motion::Parabola);
        self.cubics.resize(n, Cubic::default());
        self.in_contact.resize(n, false);
        self.in_stream.clear();
        self.in_stream.resize(n * self.media.streams.len(), false);
        for counts in [&mut self.crossings, &mut self.hits, &mut self.clung] {
            counts.resize(n, 0);
        }
        for vectors in [&mut self.free, &mut self.solved, &mut self.asked_free, &mut self.stage_accelerations] {
            vectors.resize(n, DVec2::ZERO);
        }
        for poses in [&mut self.coupled, &mut self.stage, &mut self.sums, &mut self.poses] {
            poses.resize(n, (DVec2::ZERO, DVec2::ZERO));
        }
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
    let edge = |x0, y0, x1, y1| SurfaceDef::fixed(Aabb::new(DVec2::new(x0, y0), DVec2::new(x1, y1)), Material::ASPHALT);
    [
        edge(min.x - t, min.y - t, min.x, max.y + t),
        edge(max.x, min.y - t, max.x + t, max.y + t),
        edge(min.x, min.y - t, max.x, min.y),
        edge(min.x, max.y, max.x, max.y + t),
    ]
}
