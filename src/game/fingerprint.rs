//! The identity of a level: the SHA-256 of the rows of the files that decide a flight and its score, as `csv` and serde write them, so that
//! nobody can make another level with the same one. Names, texts and looks are left out, and so is the form of the files: two levels with the
//! same hash fly alike. A new field of a level has to be named here, on one side or the other.

use crate::level::{
    AirStream, Fluid, GravityZone, Level, LevelLink, Mover, Object, Objective, Pod, ShipStart, Solid, Switch, Work,
};
use crate::physics::{Aabb, DVec2, LinkDef, LinkEnd, Material, Sides};
use csv::{Writer, WriterBuilder};
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::{fmt, str::FromStr};

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

pub fn level_hash(level: &Level) -> LevelHash {
    LevelHash(Sha256::digest(rows(level)).into())
}

struct HashedRows(Writer<Vec<u8>>);

impl HashedRows {
    /// The cells of a thing, behind the word for its file.
    fn add(&mut self, file: &str, cells: impl Serialize) {
        // Memory takes all writes, and all cells are numbers, words or flags.
        let written = self.0.serialize((file, cells));
        debug_assert!(written.is_ok(), "{file}: {written:?}");
    }
}

fn rows(level: &Level) -> Vec<u8> {
    let Level {
        name: _,
        title: _,
        metre: _,
        texts: _,
        hints: _,
        background: _,
        landscape: _,
        decoration: _,
        // Prizes follow from a result at any time.
        awards: _,
        stars: _,
        // Shown and scored, without an effect on the flight.
        experiment: _,
        overview: _,
        storeys: _,
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
    let mut rows = HashedRows(WriterBuilder::new().has_headers(false).flexible(true).from_writer(Vec::new()));
    rows.add("constants", (vector(size), gravity, gravity_x, air_density, optimal_time, rest_speed, friction));
    let ShipStart { position, velocity, angle, mass, fuel, thrust, feels_air, material, drag, restitution } = player;
    let tank = (mass, fuel, thrust, feels_air, drag, restitution);
    rows.add("player", (vector(position), vector(velocity), angle, tank, surface(material)));
    world.iter().for_each(|wall| rows.add("world", solid(wall)));
    // A path holds the mover's stops and route.
    for Mover { solid: moved, stops: _, manner: _, path } in movers {
        let legs: Vec<_> = path.legs.iter().map(|leg| (leg.duration, vector(&leg.velocity), vector(&leg.acceleration))).collect();
        rows.add("movers", (solid(moved), path.repeats, legs));
    }
    doors.iter().for_each(|door| rows.add("doors", solid(door)));
    for Switch { bounds, works, weight, by, latch } in switches {
        let works: Vec<_> = works.iter().map(|Work { name, inverted }| (name, inverted)).collect();
        rows.add("switches", (area(bounds), weight, *by as u8, *latch as u8, works));
    }
    // What colour a key has matters where an objective asks for one.
    let coloured = objectives.iter().any(|objective| objective.colour.is_some());
    for Object { position, velocity, size, mass, drag, restitution, circular, look: _, key, material, weightless, name: _ } in
        objects
    {
        let place = (vector(position), vector(velocity), vector(size));
        let key = (key.is_some(), key.filter(|_| coloured));
        rows.add("objects", (place, mass, drag, restitution, circular, surface(material), weightless, key));
    }
    for Objective { kind, bounds, hold, order, colour } in objectives {
        rows.add("objectives", (*kind as u8, area(bounds), hold, order, colour));
    }
    obstacles.iter().for_each(|bounds| rows.add("obstacles", area(bounds)));
    for AirStream { source, zone, force, name } in streams {
        rows.add("hazards", (area(source), area(zone), vector(force), name));
    }
    for Fluid { zone, density, viscosity, colour: _ } in fluids {
        rows.add("fluids", (area(zone), density, viscosity));
    }
    for GravityZone { zone, strength } in fields {
        rows.add("gravity", (area(zone), vector(strength)));
    }
    for Pod { bounds, fuel } in pods {
        rows.add("pods", (area(bounds), fuel));
    }
    for LevelLink { def, name } in links {
        let LinkDef { body, to, law, as_found, hook, breaks, rate } = def;
        let to = match to {
            LinkEnd::Body(body) => ("body", [f64::from(body.0), 0.0]),
            LinkEnd::Place(place) => ("place", vector(place)),
        };
        rows.add("links", (body.0, to, as_found, hook, breaks, rate, name, law.kind() as u8, law.numbers()));
    }
    rows.0.into_inner().unwrap_or_default()
}

fn vector(vector: &DVec2) -> [f64; 2] {
    [vector.x, vector.y]
}

fn area(Aabb { min, max }: &Aabb) -> [f64; 4] {
    [min.x, min.y, max.x, max.y]
}

fn surface(Material { name: _, static_friction, kinetic_friction, restitution }: &Material) -> [f64; 3] {
    [*static_friction, *kinetic_friction, *restitution]
}

fn solid(Solid { bounds, material, sides, belt, breaks, name }: &Solid) -> impl Serialize {
    let Sides { left, right, top, bottom } = *sides;
    (area(bounds), surface(material), [left, right, top, bottom], *belt, *breaks, name.clone())
}

/// FNV-1a, 64 bits (Fowler, Noll, Vo): the same on every machine and in every version of this program; not for secrets.
pub struct Fnv1a(u64);

impl Fnv1a {
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Takes in the eight bytes, the least significant one first.
    pub fn write(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    pub const fn finish(&self) -> u64 {
        self.0
    }
}

/// 16 digits.
pub(super) fn hex(text: &str) -> Option<u64> {
    let digits = text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    digits.then(|| u64::from_str_radix(text, 16).ok()).flatten()
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

    #[test]
    fn rows_are_as_csv_writes_them() {
        let mut rows = HashedRows(WriterBuilder::new().has_headers(false).flexible(true).from_writer(Vec::new()));
        rows.add("world", ([1.0, 0.5], (true, None::<f64>, Some([1_u8, 2])), Some("a, b"), vec![("x", 0.1 + 0.2)]));
        let text = String::from_utf8(rows.0.into_inner().unwrap()).unwrap();
        assert_eq!(text, "world,1.0,0.5,true,,1,2,\"a, b\",x,0.30000000000000004\n");
    }

    #[test]
    fn agrees_with_an_independent_computation() {
        assert_eq!(Fnv1a::new().finish(), 0xcbf2_9ce4_8422_2325);
        let mut hash = Fnv1a::new();
        hash.write(u64::from_le_bytes(*b"resultan"));
        assert_eq!(hash.finish(), 0xa849_dace_30d6_5343);
    }
}
