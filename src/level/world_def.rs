//! A level as the engine sees it.

use super::types::{Level, SHIP_DRAG, SHIP_HALF};
use crate::physics::{Aabb, BodyDef, DVec2, FluidDef, Material, StreamDef, SurfaceDef, WorldDef};

impl Level {
    /// The edge of the level, m.
    pub fn bounds(&self) -> Aabb {
        Aabb::new(DVec2::ZERO, self.size)
    }

    /// How the level's world begins. Body 0 is the ship, body i + 1 is object i; the surfaces are those of the world, then the
    /// source blocks of the streams (Asphalt); stream i and liquid i are the level's.
    pub fn world_def(&self) -> WorldDef {
        let ship = BodyDef {
            position: self.player.position,
            velocity: self.player.velocity,
            half: SHIP_HALF,
            mass: self.player.mass,
            drag: SHIP_DRAG,
            restitution: 0.0,
            feels_air: self.player.feels_air,
            material: self.player.material,
            ..BodyDef::default()
        };
        let objects = self.objects.iter().map(|object| BodyDef {
            position: object.position,
            velocity: object.velocity,
            half: object.size * 0.5,
            mass: object.mass,
            drag: object.drag,
            round: object.circular,
            restitution: object.restitution,
            material: object.material,
            ..BodyDef::default()
        });
        let world = self.world.iter().map(|solid| SurfaceDef::fixed(solid.bounds, solid.material));
        let sources = self.streams.iter().map(|stream| SurfaceDef::fixed(stream.source, Material::ASPHALT));
        WorldDef {
            gravity: self.gravity,
            air_density: self.air_density,
            rest_speed: self.rest_speed,
            bounds: Some(self.bounds()),
            surfaces: world.chain(sources).collect(),
            streams: self.streams.iter().map(|stream| StreamDef { zone: stream.zone, force: stream.force }).collect(),
            fluids: self
                .fluids
                .iter()
                .map(|fluid| FluidDef { zone: fluid.zone, density: fluid.density, viscosity: fluid.viscosity })
                .collect(),
            bodies: std::iter::once(ship).chain(objects).collect(),
        }
    }
}
