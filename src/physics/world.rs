//! The world: what is in it, and how a tick goes.

use super::{Aabb, Body, BodyDef, BodyId, ForceManager, Material};
use glam::DVec2;

/// Something solid that never moves.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceDef {
    /// Where it is, m.
    pub bounds: Aabb,
    /// What slides on it.
    pub material: Material,
}

/// A zone that exerts a constant force named "Wind" on every body that touches it.
#[derive(Clone, Debug, PartialEq)]
pub struct StreamDef {
    /// Where it blows, m.
    pub zone: Aabb,
    /// N.
    pub force: DVec2,
}

/// A zone of liquid.
#[derive(Clone, Debug, PartialEq)]
pub struct FluidDef {
    /// Where it is, m.
    pub zone: Aabb,
    /// kg/m³, ≥ 0.
    pub density: f64,
    /// Dynamic viscosity, Pa·s, ≥ 0.
    pub viscosity: f64,
}

/// How a world begins.
#[derive(Clone, Debug, PartialEq)]
pub struct WorldDef {
    /// Gravitational field strength, N/kg, downwards.
    pub gravity: f64,
    /// kg/m³, ≥ 0.
    pub air_density: f64,
    /// A rebound slower than this (m/s) is none; 0 keeps every bounce.
    pub rest_speed: f64,
    /// The edge of the level: solid on all four sides. `None`: no edge.
    pub bounds: Option<Aabb>,
    /// Solid, immovable rectangles.
    pub surfaces: Vec<SurfaceDef>,
    /// Air streams.
    pub streams: Vec<StreamDef>,
    /// Liquids.
    pub fluids: Vec<FluidDef>,
    /// What moves.
    pub bodies: Vec<BodyDef>,
}

impl Default for WorldDef {
    fn default() -> Self {
        Self {
            gravity: 15.0,
            air_density: 1.2041,
            rest_speed: 1.0,
            bounds: None,
            surfaces: Vec::new(),
            streams: Vec::new(),
            fluids: Vec::new(),
            bodies: Vec::new(),
        }
    }
}

/// Why a definition was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct DefError(pub String);

impl std::fmt::Display for DefError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for DefError {}

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

/// Bodies, surfaces, zones, and the state of their motion.
#[derive(Clone, Debug)]
pub struct World {
    bodies: Vec<Body>,
    previous: Vec<DVec2>,
    forces: Vec<ForceManager>,
    drives: Vec<DVec2>,
    surfaces: Vec<SurfaceDef>,
    events: Vec<Event>,
    gravity: f64,
}

impl World {
    /// Checks the definition and builds the world.
    ///
    /// # Errors
    /// A number that is not finite or out of its range.
    pub fn new(def: WorldDef) -> Result<Self, DefError> {
        let bodies: Vec<Body> = def
            .bodies
            .into_iter()
            .map(|b| Body {
                position: b.position,
                velocity: b.velocity,
                acceleration: DVec2::ZERO,
                half: b.half,
                mass: b.mass,
                drag: b.drag,
                restitution: b.restitution,
                material: b.material,
                feels_air: b.feels_air,
            })
            .collect();
        let n = bodies.len();
        Ok(Self {
            previous: bodies.iter().map(|b| b.position).collect(),
            bodies,
            forces: vec![ForceManager::default(); n],
            drives: vec![DVec2::ZERO; n],
            surfaces: def.surfaces,
            events: Vec::new(),
            gravity: def.gravity,
        })
    }

    /// Adds a body while the world runs (the menu's balls).
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn add_body(&mut self, _def: BodyDef) -> Result<BodyId, DefError> {
        Err(DefError("not yet".into()))
    }

    /// Sets the force of a body's engine (N) from the next tick on.
    pub fn set_drive(&mut self, body: BodyId, force: DVec2) {
        self.drives[body.index()] = force;
    }

    /// Advances the world by exactly one tick of `dt` seconds.
    pub fn step(&mut self, dt: f64) {
        self.events.clear();
        for (i, body) in self.bodies.iter_mut().enumerate() {
            self.previous[i] = body.position;
            body.acceleration = DVec2::new(0.0, self.gravity) + self.drives[i] / body.mass;
            body.position += body.velocity * dt + body.acceleration * (0.5 * dt * dt);
            body.velocity += body.acceleration * dt;
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
        [self.previous[id.index()], self.bodies[id.index()].position].into_iter()
    }

    /// The parts of the physics model that this world uses, in words (for `check` and the details overlay).
    pub fn plan(&self) -> Vec<&'static str> {
        Vec::new()
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
