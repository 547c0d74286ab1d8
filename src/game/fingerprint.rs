//! The hash of a level: of all that a flight and its score depend on. SHA-256, so that nobody can make another level with the same
//! hash. The encoding is unambiguous: numbers are 8 bytes, lists and texts begin with their length, an optional part with a byte
//! for its presence.

use super::notes::hex;
use crate::level::{
    AirStream, Fluid, GravityZone, Level, LevelLink, Mover, Object, Objective, Pod, SHIP_DRAG, ShipStart, Solid, Switch, Work,
};
use crate::physics::{Aabb, DVec2, Leg, LinkDef, LinkEnd, Material, Path, Sides};
use sha2::{Digest, Sha256};
use std::fmt;
use std::str::FromStr;

/// The beginning of the hashed bytes. A change of the encoding needs another number.
const ENCODING: &str = "resultant level 1";
/// Hex digits of a hash in a message.
const SHORT: usize = 16;

/// SHA-256, 64 hex digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LevelHash(pub [u8; 32]);

impl LevelHash {
    pub const EXPECTED: &str = "64 hex digits";

    pub fn short(self) -> String {
        self.to_string().chars().take(SHORT).collect()
    }
}

impl fmt::Display for LevelHash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl FromStr for LevelHash {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        if text.len() != 64 || !text.is_ascii() {
            return Err(());
        }
        let mut bytes = [0; 32];
        for (bytes, digits) in bytes.chunks_mut(8).zip([0, 16, 32, 48]) {
            bytes.copy_from_slice(&hex(&text[digits..digits + 16]).ok_or(())?.to_be_bytes());
        }
        Ok(Self(bytes))
    }
}

impl LevelHash {
    /// Names, texts and looks of the level are left out, and so is the form of its files: two levels with the same hash fly alike.
    /// A new field of a level has to be named here, on one side or the other.
    pub fn of(level: &Level) -> Self {
        let Level {
            name: _,
            title: _,
            metre: _,
            texts: _,
            hints: _,
            background: _,
            // Prizes follow from a result at any time.
            awards: _,
            landscape: _,
            decoration: _,
            // Shown and scored, without an effect on the flight.
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
            links,
        } = level;
        let mut hash = Hash { sha256: Sha256::new() };
        hash.text(ENCODING);
        hash.vectors(&[*size]);
        hash.numbers(&[*gravity, *air_density, *optimal_time, *rest_speed]);
        hash.player(player);
        hash.given(*friction != 1.0, |hash| hash.numbers(&[*friction]));
        hash.given(*gravity_x != 0.0, |hash| hash.numbers(&[*gravity_x]));
        hash.each(world, Hash::solid);
        hash.each(objects, Hash::object);
        hash.each(objectives, Hash::objective);
        hash.given(objectives.iter().any(|objective| objective.colour.is_some()), |hash| {
            objects.iter().filter_map(|object| object.key).for_each(|key| hash.colour(key));
        });
        hash.each(obstacles, Hash::area);
        hash.each(streams, Hash::stream);
        hash.each(fluids, Hash::fluid);
        hash.list(movers, Hash::mover);
        hash.list(doors, Hash::solid);
        hash.list(switches, Hash::switch);
        hash.list(fields, Hash::field);
        hash.list(pods, Hash::pod);
        // Levels without links keep the hash that they had before there were any.
        if !links.is_empty() {
            hash.list(links, Hash::link);
        }
        Self(hash.sha256.finalize().into())
    }
}

pub fn level_hash(level: &Level) -> LevelHash {
    LevelHash::of(level)
}

struct Hash {
    sha256: Sha256,
}

impl Hash {
    fn word(&mut self, word: u64) {
        self.sha256.update(word.to_le_bytes());
    }

    /// Adds a text with its length.
    fn text(&mut self, text: &str) {
        self.sha256.update((text.len() as u64).to_le_bytes());
        self.sha256.update(text);
    }

    fn numbers(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|number| self.word(number.to_bits()));
    }

    fn vectors(&mut self, vectors: &[DVec2]) {
        vectors.iter().for_each(|vector| self.numbers(&[vector.x, vector.y]));
    }

    fn area(&mut self, Aabb { min, max }: &Aabb) {
        self.vectors(&[*min, *max]);
    }

    /// Adds an optional part.
    fn given(&mut self, given: bool, write: impl FnOnce(&mut Self)) {
        self.sha256.update([u8::from(given)]);
        if given {
            write(self);
        }
    }

    fn colour(&mut self, colour: [u8; 3]) {
        colour.into_iter().for_each(|channel| self.word(u64::from(channel)));
    }

    fn each<T>(&mut self, things: &[T], write: impl Fn(&mut Self, &T)) {
        self.word(things.len() as u64);
        things.iter().for_each(|thing| write(self, thing));
    }

    /// Adds an optional list.
    fn list<T>(&mut self, things: &[T], write: impl Fn(&mut Self, &T)) {
        self.given(!things.is_empty(), |hash| hash.each(things, write));
    }

    fn objective(&mut self, Objective { kind, bounds, hold, order, colour }: &Objective) {
        self.word(*kind as u64);
        self.area(bounds);
        self.given(*hold != 0.0, |hash| hash.numbers(&[*hold]));
        self.given(order.is_some(), |hash| hash.word(u64::from(order.unwrap_or_default())));
        self.given(colour.is_some(), |hash| hash.colour(colour.unwrap_or_default()));
    }

    fn stream(&mut self, AirStream { source, zone, force, name }: &AirStream) {
        self.area(source);
        self.area(zone);
        self.vectors(&[*force]);
        self.name(name.as_deref());
    }

    fn fluid(&mut self, Fluid { zone, density, viscosity, colour: _ }: &Fluid) {
        self.area(zone);
        self.numbers(&[*density, *viscosity]);
    }

    fn field(&mut self, GravityZone { zone, strength }: &GravityZone) {
        self.area(zone);
        self.vectors(&[*strength]);
    }

    fn pod(&mut self, Pod { bounds, fuel }: &Pod) {
        self.area(bounds);
        self.numbers(&[*fuel]);
    }

    fn link(&mut self, LevelLink { def, name }: &LevelLink) {
        let LinkDef { body, to, law, as_found, hook, breaks, rate } = def;
        self.word(u64::from(body.0));
        match to {
            LinkEnd::Body(body) => self.word(u64::from(body.0)),
            LinkEnd::Place(place) => self.given(true, |hash| hash.vectors(&[*place])),
        }
        self.word(law.kind() as u64);
        self.numbers(&law.numbers());
        [as_found, hook].into_iter().for_each(|flag| self.word(u64::from(*flag)));
        self.given(breaks.is_some(), |hash| hash.numbers(&[breaks.unwrap_or_default()]));
        self.numbers(&[*rate]);
        self.name(name.as_deref());
    }

    fn material(&mut self, Material { name: _, static_friction, kinetic_friction, restitution }: &Material) {
        self.numbers(&[*static_friction, *kinetic_friction]);
        self.given(*restitution != 0.0, |hash| hash.numbers(&[*restitution]));
    }

    /// The name by which switches find a part.
    fn name(&mut self, name: Option<&str>) {
        self.given(name.is_some(), |hash| {
            hash.text(name.unwrap_or_default());
        });
    }

    fn solid(&mut self, Solid { bounds, material, sides, belt, breaks, name }: &Solid) {
        let Sides { left, right, top, bottom } = *sides;
        self.area(bounds);
        self.material(material);
        self.given(*sides != Sides::ALL, |hash| {
            [left, right, top, bottom].into_iter().for_each(|solid| hash.word(u64::from(solid)));
        });
        self.given(*belt != 0.0, |hash| hash.numbers(&[*belt]));
        self.given(breaks.is_some(), |hash| hash.numbers(&[breaks.unwrap_or_default()]));
        self.name(name.as_deref());
    }

    /// A path holds the mover's stops and route.
    fn mover(&mut self, Mover { solid, stops: _, route: _, path: Path { legs, repeats } }: &Mover) {
        self.solid(solid);
        self.each(legs, |hash, Leg { duration, velocity, acceleration }| {
            hash.numbers(&[*duration]);
            hash.vectors(&[*velocity, *acceleration]);
        });
        self.word(u64::from(*repeats));
    }

    fn switch(&mut self, Switch { bounds, works, weight, by, latch }: &Switch) {
        self.area(bounds);
        self.each(works, |hash, Work { name, inverted }| {
            hash.name(Some(name));
            hash.word(u64::from(*inverted));
        });
        self.given(weight.is_some(), |hash| hash.numbers(&[weight.unwrap_or_default()]));
        self.word(*by as u64);
        self.word(*latch as u64);
    }

    fn player(&mut self, player: &ShipStart) {
        let ShipStart { position, velocity, angle, mass, fuel, thrust, feels_air, material, drag, restitution } = player;
        self.vectors(&[*position, *velocity]);
        self.numbers(&[*angle, *mass, *fuel, *thrust]);
        self.material(material);
        self.word(u64::from(*feels_air));
        self.given(*drag != SHIP_DRAG, |hash| hash.numbers(&[*drag]));
        self.given(*restitution != 0.0, |hash| hash.numbers(&[*restitution]));
    }

    fn object(&mut self, object: &Object) {
        let Object { position, velocity, size, mass, drag, restitution, circular, look: _, key, material, weightless, name: _ } =
            object;
        self.vectors(&[*position, *velocity, *size]);
        self.numbers(&[*mass, *drag, *restitution]);
        self.material(material);
        self.word(u64::from(*circular));
        self.word(u64::from(key.is_some()));
        self.given(*weightless, |_| {});
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hash_reads_back_and_nothing_else_is_one() {
        let hash = LevelHash(std::array::from_fn(|at| at as u8 * 7));
        assert_eq!(hash.to_string().parse(), Ok(hash));
        for text in ["", "000000000000001f", &hash.to_string()[1..], &format!("{hash}0"), &"é".repeat(32)] {
            assert_eq!(text.parse::<LevelHash>(), Err(()), "{text}");
        }
    }

    /// SHA-256 of "abc" (FIPS 180-4).
    #[test]
    fn sha_256_is_the_one_of_the_standard() {
        let digest = LevelHash(Sha256::digest("abc").into());
        assert_eq!(digest.to_string(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
