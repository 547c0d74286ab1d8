//! Resultant: the usual choice of methods for small scenes, the crowd step alone for crowds.

use crate::engine::{Engine, Spec, V};
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, FluidDef, Material, Path, Plan, SOURCES, SurfaceDef, World, WorldDef};

fn vector((x, y): V) -> DVec2 {
    DVec2::new(x, y)
}

fn rectangle(&(centre, half): &(V, V)) -> Aabb {
    Aabb::around(vector(centre), vector(half))
}

fn material(spec: &Spec) -> Material {
    Material { name: "", static_friction: spec.friction, kinetic_friction: spec.friction, restitution: 0.0 }
}

/// [`World`]. It skips ticks while nothing moves and nothing is changed; where nothing may sleep, a drive that comes and goes, and that
/// friction holds, makes it solve all contacts in every step.
pub struct Scenes {
    world: World,
    restless: bool,
    nudged: bool,
    force: f64,
}

/// The viscosity of water, Pa·s.
const WATER: f64 = 1e-3;
/// Sideways, N: it changes the acceleration without contacts, and friction holds it.
const NUDGE: f64 = 1e-3;

impl Engine for Scenes {
    const NAME: &'static str = "Resultant";
    const QUADRATIC: bool = true;

    fn version() -> String {
        SOURCES.to_owned()
    }

    fn settings(_: bool) -> String {
        String::new()
    }

    fn new(spec: &Spec) -> Option<Self> {
        let material = material(spec);
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
        let fluids =
            spec.liquid.iter().map(|liquid| FluidDef { zone: rectangle(&liquid.zone), density: liquid.density, viscosity: WATER });
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
        Some(Self { world, restless: !spec.sleep, nudged: false, force: spec.bodies[0].force })
    }

    fn step(&mut self, dt: f64) {
        if self.restless && self.world.bodies().iter().all(|body| body.velocity == DVec2::ZERO) {
            self.nudged = !self.nudged;
            let nudge = if self.nudged { NUDGE } else { 0.0 };
            self.world.set_drive(BodyId(0), DVec2::new(self.force + nudge, 0.0));
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

/// A [`World`] of which every island takes the crowd step.
pub struct Crowds {
    world: World,
}

impl Engine for Crowds {
    const NAME: &'static str = "Resultant";
    const QUADRATIC: bool = true;

    fn version() -> String {
        SOURCES.to_owned()
    }

    fn settings(_: bool) -> String {
        String::new()
    }

    fn new(spec: &Spec) -> Option<Self> {
        let material = material(spec);
        let bodies = spec.bodies.iter().map(|body| BodyDef {
            position: vector(body.position),
            velocity: vector(body.velocity),
            half: vector(body.half),
            mass: body.mass,
            restitution: body.restitution,
            material,
            // The air has 1 kg/m³, so that k = ½·(drag area)/m.
            drag: if spec.terminal.is_finite() {
                body.mass * spec.gravity / (spec.terminal * spec.terminal * body.half.0)
            } else {
                0.0
            },
            ..BodyDef::default()
        });
        let still = spec.statics.iter().map(|rect| SurfaceDef::fixed(rectangle(rect), material));
        let lift = spec.lift.iter().map(|lift| SurfaceDef {
            path: Path::shuttle(DVec2::new(0.0, -lift.rise), 0.5 * lift.period, 0.25 * lift.period, 0.0),
            ..SurfaceDef::fixed(rectangle(&lift.place), material)
        });
        let def = WorldDef {
            gravity: spec.gravity,
            air_density: if spec.terminal.is_finite() { 1.0 } else { 0.0 },
            rest_speed: 1.0,
            bodies: bodies.collect(),
            surfaces: still.chain(lift).collect(),
            ..WorldDef::default()
        };
        let plan = Plan { dense: true, direct: spec.sleep, ..Plan::of(&def) };
        let mut world = World::with_plan(def, plan).ok()?;
        for (i, body) in spec.bodies.iter().enumerate() {
            world.set_drive(BodyId(i as u32), DVec2::new(body.force, 0.0));
        }
        Some(Self { world })
    }

    fn step(&mut self, dt: f64) {
        self.world.step(dt);
    }

    fn position(&mut self, body: usize) -> V {
        self.world.bodies()[body].position.into()
    }

    fn velocity(&mut self, body: usize) -> V {
        self.world.bodies()[body].velocity.into()
    }
}
