//! Resultant: the exact engine for small scenes, the pile engine for piles.

use crate::engine::{Engine, Spec, V};
use resultant::physics::pile::{Pile, PileBody, PileDef, PileSurface};
use resultant::physics::{Aabb, BodyDef, BodyId, DVec2, Material, SurfaceDef, World, WorldDef};

fn vector((x, y): V) -> DVec2 {
    DVec2::new(x, y)
}

fn rectangle(&(centre, half): &(V, V)) -> Aabb {
    Aabb::around(vector(centre), vector(half))
}

/// [`World`].
pub struct Scenes(World);

impl Engine for Scenes {
    const NAME: &'static str = "Resultant";

    fn new(spec: &Spec) -> Option<Self> {
        let material = Material {
            name: "",
            static_friction: spec.friction,
            kinetic_friction: spec.friction,
        };
        let bodies = spec.bodies.iter().map(|body| BodyDef {
            position: vector(body.position),
            velocity: vector(body.velocity),
            half: vector(body.half),
            mass: body.mass,
            restitution: spec.restitution,
            material,
            ..BodyDef::default()
        });
        let surfaces = spec.statics.iter().map(|rect| SurfaceDef {
            bounds: rectangle(rect),
            material,
        });
        let def = WorldDef {
            gravity: spec.gravity,
            air_density: 0.0,
            rest_speed: 0.0,
            bodies: bodies.collect(),
            surfaces: surfaces.collect(),
            ..WorldDef::default()
        };
        let mut world = World::new(def).ok()?;
        for (i, body) in spec.bodies.iter().enumerate() {
            world.set_drive(BodyId(i as u32), DVec2::new(body.force, 0.0));
        }
        Some(Self(world))
    }

    fn step(&mut self, dt: f64) {
        self.0.step(dt);
    }

    fn position(&mut self, body: usize) -> V {
        self.0.bodies()[body].position.into()
    }

    fn velocity(&mut self, body: usize) -> V {
        self.0.bodies()[body].velocity.into()
    }
}

/// [`Pile`].
pub struct Piles(Pile);

impl Engine for Piles {
    const NAME: &'static str = "Resultant";

    fn new(spec: &Spec) -> Option<Self> {
        let bodies = spec.bodies.iter().map(|body| PileBody {
            position: vector(body.position),
            velocity: vector(body.velocity),
            half: vector(body.half),
            mass: body.mass,
            restitution: spec.restitution,
            static_friction: spec.friction,
            kinetic_friction: spec.friction,
            ..PileBody::default()
        });
        let surfaces = spec.statics.iter().map(|rect| PileSurface {
            bounds: rectangle(rect),
            static_friction: spec.friction,
            kinetic_friction: spec.friction,
        });
        let def = PileDef {
            gravity: spec.gravity,
            bodies: bodies.collect(),
            surfaces: surfaces.collect(),
            sleep: false,
            ..PileDef::default()
        };
        Pile::new(def).ok().map(Self)
    }

    fn step(&mut self, dt: f64) {
        self.0.step(dt);
    }

    fn position(&mut self, body: usize) -> V {
        self.0.position(body).into()
    }

    fn velocity(&mut self, body: usize) -> V {
        self.0.velocity(body).into()
    }
}
