//! Which level a run was flown in: a hash of all that a flight and its score depend on.

use super::hash::Fnv1a;
use crate::level::{Field, Fluid, Level, Mover, Object, Objective, Player, Pod, SHIP_DRAG, Solid, Stream, Switch, Work};
use crate::physics::{Aabb, DVec2, Leg, Material, Path, Sides};

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
        decoration: _,
        // What is shown and scored, not how it is flown.
        experiment: _,
        size,
        gravity,
        gravity_x,
        air_density,
        optimal_time,
        rest_speed,
        friction,
        player,
        world,
        movers,
        doors,
        switches,
        objects,
        objectives,
        obstacles,
        streams,
        fluids,
        fields,
        pods,
    } = level;
    let mut hash = Hash(Fnv1a::new());
    hash.vectors(&[*size]);
    hash.numbers(&[*gravity, *air_density, *optimal_time, *rest_speed]);
    hash.player(player);
    hash.given("friction", *friction != 1.0, |hash| hash.numbers(&[*friction]));
    hash.given("gravity_x", *gravity_x != 0.0, |hash| hash.numbers(&[*gravity_x]));
    hash.each(world, Hash::solid);
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
    hash.each(streams, |hash, Stream { source, zone, force, name }| {
        hash.area(source);
        hash.area(zone);
        hash.vectors(&[*force]);
        hash.name(name.as_deref());
    });
    hash.each(fluids, |hash, Fluid { zone, density, viscosity, colour: _ }| {
        hash.area(zone);
        hash.numbers(&[*density, *viscosity]);
    });
    hash.given("movers", !movers.is_empty(), |hash| hash.each(movers, Hash::mover));
    hash.given("doors", !doors.is_empty(), |hash| hash.each(doors, Hash::solid));
    hash.given("switches", !switches.is_empty(), |hash| hash.each(switches, Hash::switch));
    hash.given("fields", !fields.is_empty(), |hash| {
        hash.each(fields, |hash, Field { zone, strength }| {
            hash.area(zone);
            hash.vectors(&[*strength]);
        });
    });
    hash.given("pods", !pods.is_empty(), |hash| {
        hash.each(pods, |hash, Pod { bounds, fuel }| {
            hash.area(bounds);
            hash.numbers(&[*fuel]);
        });
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

    fn material(&mut self, Material { name: _, static_friction, kinetic_friction, restitution }: &Material) {
        self.numbers(&[*static_friction, *kinetic_friction]);
        self.given("bounces", *restitution != 0.0, |hash| hash.numbers(&[*restitution]));
    }

    /// What switches find it by.
    fn name(&mut self, name: Option<&str>) {
        self.given("name", name.is_some(), |hash| {
            name.unwrap_or_default().bytes().for_each(|byte| hash.0.write(u64::from(byte)));
        });
    }

    fn solid(&mut self, Solid { bounds, material, sides, belt, breaks, name }: &Solid) {
        let Sides { left, right, top, bottom } = *sides;
        self.area(bounds);
        self.material(material);
        self.given("sides", *sides != Sides::ALL, |hash| {
            [left, right, top, bottom].into_iter().for_each(|solid| hash.0.write(u64::from(solid)));
        });
        self.given("belt", *belt != 0.0, |hash| hash.numbers(&[*belt]));
        self.given("breaks", breaks.is_some(), |hash| hash.numbers(&[breaks.unwrap_or_default()]));
        self.name(name.as_deref());
    }

    /// Its stops and its route are in its path.
    fn mover(&mut self, Mover { solid, stops: _, route: _, path: Path { legs, repeats } }: &Mover) {
        self.solid(solid);
        self.each(legs, |hash, Leg { duration, velocity, acceleration }| {
            hash.numbers(&[*duration]);
            hash.vectors(&[*velocity, *acceleration]);
        });
        self.0.write(u64::from(*repeats));
    }

    fn switch(&mut self, Switch { bounds, works, weight, by, latch }: &Switch) {
        self.area(bounds);
        self.each(works, |hash, Work { name, inverted }| {
            hash.name(Some(name));
            hash.0.write(u64::from(*inverted));
        });
        self.given("weight", weight.is_some(), |hash| hash.numbers(&[weight.unwrap_or_default()]));
        self.0.write(*by as u64);
        self.0.write(*latch as u64);
    }

    fn player(&mut self, player: &Player) {
        let Player { position, velocity, angle, mass, fuel, thrust, feels_air, material, drag, restitution } = player;
        self.vectors(&[*position, *velocity]);
        self.numbers(&[*angle, *mass, *fuel, *thrust]);
        self.material(material);
        self.0.write(u64::from(*feels_air));
        self.given("drag", *drag != SHIP_DRAG, |hash| hash.numbers(&[*drag]));
        self.given("bounces", *restitution != 0.0, |hash| hash.numbers(&[*restitution]));
    }

    fn object(&mut self, object: &Object) {
        let Object { position, velocity, size, mass, drag, restitution, circular, look: _, key, material, weightless } = object;
        self.vectors(&[*position, *velocity, *size]);
        self.numbers(&[*mass, *drag, *restitution]);
        self.material(material);
        self.0.write(u64::from(*circular));
        self.0.write(u64::from(key.is_some()));
        self.given("weightless", *weightless, |_| {});
    }
}
