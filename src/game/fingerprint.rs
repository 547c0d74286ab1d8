//! Which level a run was flown in: a hash of all that a flight and its score depend on.

use super::hash::Fnv1a;
use crate::level::{Fluid, Level, Object, Objective, Player, Solid, Stream};
use crate::physics::{Aabb, DVec2, Material};

/// The hash of a level. Its name, its words and how things look are left out, and so is how its files are written: two levels with the
/// same hash are flown alike. Whatever is added to a level has to be named here, on one side or the other.
pub fn level_hash(level: &Level) -> u64 {
    let Level {
        name: _,
        title: _,
        metre: _,
        texts: _,
        background: _,
        // What is earned is worked out from a result, whenever it is asked for.
        awards: _,
        size,
        gravity,
        air_density,
        optimal_time,
        rest_speed,
        player,
        world,
        objects,
        objectives,
        obstacles,
        streams,
        fluids,
    } = level;
    let mut hash = Hash(Fnv1a::new());
    hash.vectors(&[*size]);
    hash.numbers(&[*gravity, *air_density, *optimal_time, *rest_speed]);
    hash.player(player);
    hash.each(world, |hash, Solid { bounds, material }| {
        let Material { name: _, static_friction, kinetic_friction } = material;
        hash.area(bounds);
        hash.numbers(&[*static_friction, *kinetic_friction]);
    });
    hash.each(objects, Hash::object);
    hash.each(objectives, |hash, Objective { kind, bounds, hold, order, colour }| {
        hash.0.write(*kind as u64);
        hash.area(bounds);
        hash.given("hold", *hold != 0.0, |hash| hash.numbers(&[*hold]));
        hash.given("order", order.is_some(), |hash| hash.0.write(u64::from(order.unwrap_or_default())));
        hash.given("colour", colour.is_some(), |hash| hash.colour(colour.unwrap_or_default()));
    });
    hash.given("keys", objectives.iter().any(|objective| objective.colour.is_some()), |hash| {
        objects.iter().filter_map(|object| object.key).for_each(|key| hash.colour(key));
    });
    hash.each(obstacles, Hash::area);
    hash.each(streams, |hash, Stream { source, zone, force }| {
        hash.area(source);
        hash.area(zone);
        hash.vectors(&[*force]);
    });
    hash.each(fluids, |hash, Fluid { zone, density, viscosity, colour: _ }| {
        hash.area(zone);
        hash.numbers(&[*density, *viscosity]);
    });
    hash.0.finish()
}

struct Hash(Fnv1a);

impl Hash {
    fn numbers(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|number| self.0.write(number.to_bits()));
    }

    fn vectors(&mut self, vectors: &[DVec2]) {
        vectors.iter().for_each(|vector| self.numbers(&[vector.x, vector.y]));
    }

    fn area(&mut self, Aabb { min, max }: &Aabb) {
        self.vectors(&[*min, *max]);
    }

    /// Something that older levels do not have: nothing is written where it is not given, so that their hashes stay what they were.
    fn given(&mut self, name: &str, given: bool, write: impl FnOnce(&mut Self)) {
        if given {
            name.bytes().for_each(|byte| self.0.write(u64::from(byte)));
            write(self);
        }
    }

    fn colour(&mut self, colour: [u8; 3]) {
        colour.into_iter().for_each(|channel| self.0.write(u64::from(channel)));
    }

    /// How many there are, and each of them.
    fn each<T>(&mut self, things: &[T], write: impl Fn(&mut Self, &T)) {
        self.0.write(things.len() as u64);
        things.iter().for_each(|thing| write(self, thing));
    }

    fn material(&mut self, Material { name: _, static_friction, kinetic_friction }: &Material) {
        self.numbers(&[*static_friction, *kinetic_friction]);
    }

    fn player(&mut self, player: &Player) {
        let Player { position, velocity, angle, mass, fuel, thrust, feels_air, material } = player;
        self.vectors(&[*position, *velocity]);
        self.numbers(&[*angle, *mass, *fuel, *thrust]);
        self.material(material);
        self.0.write(u64::from(*feels_air));
    }

    fn object(&mut self, object: &Object) {
        let Object { position, velocity, size, mass, drag, restitution, circular, look: _, key, material } = object;
        self.vectors(&[*position, *velocity, *size]);
        self.numbers(&[*mass, *drag, *restitution]);
        self.material(material);
        self.0.write(u64::from(*circular));
        self.0.write(u64::from(key.is_some()));
    }
}
