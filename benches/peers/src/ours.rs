//! Resultant: the exact engine for small scenes, the pile engine for piles.

use crate::engine::{Engine, Lift, Spec, V, version};
use resultant::physics::pile::{Pile, PileBody, PileDef, PileSurface};
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, FluidDef, Material, SurfaceDef, World, WorldDef};

fn vector((x, y): V) -> DVec2 {
    DVec2::new(x, y)
}

fn rectangle(&(centre, half): &(V, V)) -> Aabb {
    Aabb::around(vector(centre), vector(half))
}

/// [`World`]. It skips ticks while nothing moves and nothing is changed; where nothing may sleep, a drive that comes and goes and is
/// too small to change a bit keeps it awake then, which costs it more than it would to be awake.
pub struct Scenes {
    world: World,
    restless: bool,
    nudged: bool,
    force: f64,
}

/// The viscosity of water, Pa·s.
const WATER: f64 = 1e-3;
/// Downwards, N: far less than the last bit of any weight.
const NUDGE: f64 = 1e-100;

impl Engine for Scenes {
    const NAME: &'static str = "Resultant";
    const QUADRATIC: bool = true;

    fn version() -> String {
        version("resultant")
    }

    fn settings(_: bool) -> String {
        String::new()
    }

    fn new(spec: &Spec) -> Option<Self> {
        let material = Material {
            name: "",
            static_friction: spec.friction,
            kinetic_friction: spec.friction,
            restitution: 0.0,
        };
        let bodies = spec.bodies.iter().map(|body| BodyDef {
            position: vector(body.position),
            velocity: vector(body.velocity),
            half: vector(body.half),
            mass: body.mass,
            restitution: body.restitution,
            material,
            feels_air: spec.terminal.is_finite(),
            // In water it counts as well, and damps what bobs.
            drag: if spec.terminal.is_finite() {
                body.mass * spec.gravity / (spec.terminal * spec.terminal * body.half.0)
            } else {
                1.0
            },
            ..BodyDef::default()
        });
        let fluids = spec.liquid.iter().map(|liquid| FluidDef {
            zone: rectangle(&liquid.zone),
            density: liquid.density,
            viscosity: WATER,
        });
        let surfaces = spec.statics.iter().map(|rect| SurfaceDef::fixed(rectangle(rect), material));
        let def = WorldDef {
            gravity: spec.gravity,
            // The air has 1 kg/m³, as that of piles.
            air_density: if spec.terminal.is_finite() { 1.0 } else { 0.0 },
            rest_speed: 0.0,
            fluids: fluids.collect(),
            bodies: bodies.collect(),
            surfaces: surfaces.collect(),
            ..WorldDef::default()
        };
        let mut world = World::new(def).ok()?;
        for (i, body) in spec.bodies.iter().enumerate() {
            world.set_drive(BodyId(i as u32), DVec2::new(body.force, 0.0));
        }
        Some(Self {
            world,
            restless: !spec.sleep,
            nudged: false,
            force: spec.bodies[0].force,
        })
    }

    fn step(&mut self, dt: f64) {
        if self.restless && self.world.bodies().iter().all(|body| body.velocity == DVec2::ZERO) {
            self.nudged = !self.nudged;
            let nudge = if self.nudged { NUDGE } else { 0.0 };
            self.world.set_drive(BodyId(0), DVec2::new(self.force, nudge));
        }
        self.world.step(dt);
    }

    fn position(&mut self, body: usize) -> V {
        self.world.bodies()[body].position.into()
    }

    fn velocity(&mut self, body: usize) -> V {
        self.world.bodies()[body].velocity.into()
    }
}

/// [`Pile`].
pub struct Piles {
    pile: Pile,
    lift: Option<Lift>,
    /// The number of the lift among the surfaces.
    moving: usize,
    time: f64,
}

impl Engine for Piles {
    const NAME: &'static str = "Resultant";
    const QUADRATIC: bool = true;

    fn version() -> String {
        version("resultant")
    }

    fn settings(_: bool) -> String {
        String::new()
    }

    fn new(spec: &Spec) -> Option<Self> {
        let bodies = spec.bodies.iter().map(|body| PileBody {
            position: vector(body.position),
            velocity: vector(body.velocity),
            half: vector(body.half),
            mass: body.mass,
            restitution: body.restitution,
            static_friction: spec.friction,
            kinetic_friction: spec.friction,
            // The air has 1 kg/m³, so that k = ½·(drag area)/m.
            drag_area: DVec2::splat(2.0 * body.mass * spec.gravity / (spec.terminal * spec.terminal)),
            ..PileBody::default()
        });
        let rectangles = spec.statics.iter().chain(spec.lift.as_ref().map(|lift| &lift.place));
        let surfaces = rectangles.map(|rect| PileSurface {
            bounds: rectangle(rect),
            static_friction: spec.friction,
            kinetic_friction: spec.friction,
        });
        let def = PileDef {
            gravity: spec.gravity,
            bodies: bodies.collect(),
            surfaces: surfaces.collect(),
            air_density: if spec.terminal.is_finite() { 1.0 } else { 0.0 },
            sleep: spec.sleep,
            ..PileDef::default()
        };
        let mut pile = Pile::new(def).ok()?;
        for (i, body) in spec.bodies.iter().enumerate() {
            pile.set_force(i, DVec2::new(body.force, 0.0));
        }
        Some(Self {
            pile,
            lift: spec.lift.clone(),
            moving: spec.statics.len(),
            time: 0.0,
        })
    }

    fn step(&mut self, dt: f64) {
        self.time += dt;
        if let Some(lift) = &self.lift {
            self.pile.move_surface(self.moving, vector(lift.at(self.time)));
        }
        self.pile.step(dt);
    }

    fn position(&mut self, body: usize) -> V {
        self.pile.position(body).into()
    }

    fn velocity(&mut self, body: usize) -> V {
        self.pile.velocity(body).into()
    }
}
