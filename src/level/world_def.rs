//! A level as the engine sees it.

use super::types::{Level, SHIP_HALF, Solid};
use super::wiring::Worked;
use crate::physics::{Aabb, BodyDef, DVec2, FieldDef, FluidDef, Material, StreamDef, SurfaceDef, WorldDef};
use std::collections::BTreeMap;

/// The reach of its own sideways gravity beyond the level, in sizes of the level: no body comes near its end.
const BEYOND: f64 = 2.0;

impl Level {
    /// m.
    pub fn bounds(&self) -> Aabb {
        Aabb::new(DVec2::ZERO, self.size)
    }

    /// False in an experiment: the ship is [parked](super::types::ShipStart::PARKED) there, and neither fuel nor time nor score matter.
    pub const fn ship_plays(&self) -> bool {
        !self.experiment
    }

    /// The world before the first switch is pressed, but all streams blow. Body 0 is the ship, body i + 1 is object i; [`Level::surface`]
    /// names the surfaces; stream i and liquid i are the level's.
    pub fn world_def(&self) -> WorldDef {
        let ship = BodyDef {
            position: self.player.position,
            velocity: self.player.velocity,
            half: SHIP_HALF,
            mass: self.player.mass,
            drag: self.player.drag,
            restitution: self.player.restitution,
            feels_air: self.player.feels_air,
            material: self.rubbing(self.player.material),
            weightless: !self.ship_plays(),
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
            material: self.rubbing(object.material),
            weightless: object.weightless,
            ..BodyDef::default()
        });
        WorldDef {
            gravity: self.gravity,
            air_density: self.air_density,
            rest_speed: self.rest_speed,
            bounds: Some(self.bounds()),
            edge: self.rubbing(Material::ASPHALT),
            surfaces: self.surfaces(),
            streams: self.streams.iter().map(|stream| StreamDef { zone: stream.zone, force: stream.force }).collect(),
            fields: self.fields(),
            fluids: self
                .fluids
                .iter()
                .map(|fluid| FluidDef { zone: fluid.zone, density: fluid.density, viscosity: fluid.viscosity })
                .collect(),
            bodies: std::iter::once(ship).chain(objects).collect(),
            links: self.links.iter().map(|link| link.def).collect(),
        }
    }

    fn rubbing(&self, material: Material) -> Material {
        let Material { static_friction, kinetic_friction, .. } = material;
        Material {
            static_friction: self.friction * static_friction,
            kinetic_friction: self.friction * kinetic_friction,
            ..material
        }
    }

    /// In the order of [`Level::surface`].
    fn surfaces(&self) -> Vec<SurfaceDef> {
        let off: Vec<bool> = vec![false; self.switches.len()];
        let wires: BTreeMap<Worked, bool> = self.wires().into_iter().map(|wire| (wire.worked, wire.is_on(&off))).collect();
        let starts_on = |worked| wires.get(&worked).copied();
        let block = |solid: &Solid| SurfaceDef {
            sides: solid.sides,
            belt: solid.belt,
            ..SurfaceDef::fixed(solid.bounds, self.rubbing(solid.material))
        };
        let world = self.world.iter().enumerate().map(|(i, solid)| {
            let runs = starts_on(Worked::Belt(i)).unwrap_or(true);
            SurfaceDef { belt: if runs { solid.belt } else { 0.0 }, ..block(solid) }
        });
        let sources = self.streams.iter().map(|stream| SurfaceDef::fixed(stream.source, self.rubbing(Material::STEEL)));
        let movers = self.movers.iter().enumerate().map(|(i, mover)| {
            let runs = starts_on(Worked::Mover(i)).unwrap_or(true);
            SurfaceDef { path: mover.path.clone(), runs, ..block(&mover.solid) }
        });
        let doors = self.doors.iter().enumerate().map(|(i, door)| {
            let open = starts_on(Worked::Door(i)).unwrap_or(false);
            SurfaceDef { present: !open, ..block(door) }
        });
        let plates = self.plates().map(|switch| SurfaceDef::fixed(self.switches[switch].bounds, self.rubbing(Material::STEEL)));
        world.chain(sources).chain(movers).chain(doors).chain(plates).collect()
    }

    /// The zones of gravity.csv, then the level's own sideways gravity.
    fn fields(&self) -> Vec<FieldDef> {
        let zones = self.fields.iter().map(|field| FieldDef { zone: field.zone, strength: field.strength });
        let everywhere = Aabb::new(-self.size * BEYOND, self.size * (1.0 + BEYOND));
        let sideways = FieldDef { zone: everywhere, strength: DVec2::new(self.gravity_x, 0.0) };
        zones.chain((self.gravity_x != 0.0).then_some(sideways)).collect()
    }
}
