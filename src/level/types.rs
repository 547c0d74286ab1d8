//! A level as the rest of the game knows it: in metres, checked, ready to play.

use super::route::RouteShape;
use crate::physics::{Aabb, DVec2, LinkDef, Material, Path, Sides};

/// The ship's height, m: it fixes the scale.
pub const SHIP_HEIGHT: f64 = 1.7;
/// Half the ship's collision box, m: as wide as high.
pub const SHIP_HALF: DVec2 = DVec2::new(0.85, 0.85);
/// The ship's height in pixels at the default scale of 30 pixels a metre.
pub const SHIP_PIXELS: f64 = 51.0;
/// Ticks a second.
pub const TICK_RATE: f64 = 120.0;
/// Fuel units a second while the engine burns: the usual 500 units last 25 s.
pub const BURN_RATE: f64 = 20.0;

/// Lengths in m, `gravity` in N/kg downwards and `gravity_x` to the right, air density in kg/m³, the optimal time in s, the rest speed in m/s.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// The folder's name.
    pub name: String,
    /// Shown to the player; the name where the author gave none.
    pub title: String,
    /// Pixels a metre of the author's picture.
    pub metre: f64,
    pub size: DVec2,
    pub gravity: f64,
    pub gravity_x: f64,
    pub air_density: f64,
    pub optimal_time: f64,
    pub rest_speed: f64,
    /// Factor of all coefficients of friction.
    pub friction: f64,
    /// The level shows a law: the ship plays no part, and no flight is scored.
    pub experiment: bool,
    /// All of it is in view until the first key.
    pub overview: bool,
    /// Whether the colours of five worlds lie one above the other.
    pub storeys: bool,
    pub awards: Awards,
    /// The colours, the sky and the music; without one the level lies on plain paper.
    pub landscape: Option<Landscape>,
    pub player: ShipStart,
    pub world: Vec<Solid>,
    pub movers: Vec<Mover>,
    pub doors: Vec<Solid>,
    pub switches: Vec<Switch>,
    /// The objects of objects.csv, then the key objects, each in file order.
    pub objects: Vec<Object>,
    pub objectives: Vec<Objective>,
    pub obstacles: Vec<Aabb>,
    pub streams: Vec<AirStream>,
    pub fluids: Vec<Fluid>,
    pub fields: Vec<GravityZone>,
    pub pods: Vec<Pod>,
    pub stars: Vec<Star>,
    pub links: Vec<LevelLink>,
    pub decoration: Vec<Decoration>,
    pub texts: Vec<Text>,
    /// Given one at a time, on demand.
    pub hints: Vec<String>,
    /// The path of background.png, where there is one.
    pub background: Option<std::path::PathBuf>,
}

/// A world of levels, as a player sees and hears it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Landscape {
    Launch,
    Quarry,
    Wind,
    Water,
    Orbit,
}

impl Landscape {
    pub const ALL: [Self; 5] = [Self::Launch, Self::Quarry, Self::Wind, Self::Water, Self::Orbit];

    pub const fn title(self) -> &'static str {
        match self {
            Self::Launch => "Launch site",
            Self::Quarry => "Quarry",
            Self::Wind => "Wind works",
            Self::Water => "Deep water",
            Self::Orbit => "Orbit",
        }
    }
}

/// Centre in m, velocity in m/s, angle in degrees clockwise (0 is nose up), mass in kg, thrust in N; drag and restitution are coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct ShipStart {
    pub position: DVec2,
    pub velocity: DVec2,
    pub angle: f64,
    pub mass: f64,
    pub fuel: f64,
    pub thrust: f64,
    pub feels_air: bool,
    pub material: Material,
    pub drag: f64,
    pub restitution: f64,
}

impl ShipStart {
    /// The ship of an experiment, farther out than anything of a level reaches. Nothing acts on it, and it has no engine.
    pub const PARKED: Self = Self {
        position: DVec2::splat(-1e7),
        velocity: DVec2::ZERO,
        angle: 0.0,
        mass: 100.0,
        fuel: 0.0,
        thrust: 0.0,
        feels_air: false,
        material: Material::ASPHALT,
        drag: 1.0,
        restitution: 0.0,
    };

    pub fn has_engine(&self) -> bool {
        self.thrust > 0.0 && self.fuel > 0.0
    }
}

/// Bounds at the start, and the sides from which it is solid. Its name is for switches; several things may share it.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    pub bounds: Aabb,
    pub material: Material,
    pub sides: Sides,
    /// The speed of its skin, m/s, clockwise: the top runs to the right.
    pub belt: f64,
    /// The impulse, N·s, beyond which a hit breaks it.
    pub breaks: Option<f64>,
    pub name: Option<String>,
}

impl Solid {
    pub const fn new(bounds: Aabb, material: Material) -> Self {
        Self { bounds, material, sides: Sides::ALL, belt: 0.0, breaks: None, name: None }
    }

    /// Solid all around for the whole flight: part of the mass that a level is cut out of.
    pub fn is_rock(&self) -> bool {
        self.sides == Sides::ALL && self.breaks.is_none()
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Mover {
    pub solid: Solid,
    /// The stops of its centre, m, the start first.
    pub stops: Vec<DVec2>,
    pub manner: RouteShape,
    pub path: Path,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Presser {
    Any,
    Ship,
    Key,
    /// Any object, but not the ship.
    Object,
}

/// On while it is pressed, for ever once it has been pressed, or until it is pressed again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwitchStay {
    Held,
    Latched,
    Toggled,
}

/// The things of one name, as a switch works them; inverted ones are on while it is off, and off while it is on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Work {
    pub name: String,
    pub inverted: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Switch {
    pub bounds: Aabb,
    pub works: Vec<Work>,
    /// The load, N, beyond which a solid plate is pressed. `None`: an area that only has to be touched.
    pub weight: Option<f64>,
    pub by: Presser,
    pub latch: SwitchStay,
}

impl Level {
    pub fn objectives_of(&self, kind: ObjectiveKind) -> usize {
        self.objectives.iter().filter(|objective| objective.kind == kind).count()
    }

    pub fn pictures(&self) -> impl Iterator<Item = &std::path::PathBuf> {
        let looks = self.objects.iter().map(|object| &object.look).chain(self.decoration.iter().map(|shown| &shown.look));
        looks.filter_map(|look| match look {
            Look::Image(path) => Some(path),
            Look::Box | Look::Ball => None,
        })
    }
}

/// A picture, or a plain shape that the game draws.
#[derive(Clone, Debug, PartialEq)]
pub enum Look {
    Image(std::path::PathBuf),
    Box,
    Ball,
}

/// Centre and size in m, velocity in m/s, mass in kg; drag and restitution are coefficients. Its name is for links.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    pub position: DVec2,
    pub velocity: DVec2,
    pub size: DVec2,
    pub mass: f64,
    pub drag: f64,
    pub restitution: f64,
    /// It is drawn round, and air and liquids act on it as on a ball; its box collides.
    pub circular: bool,
    pub look: Look,
    pub material: Material,
    /// A key object's colour; `None` for an ordinary object.
    pub key: Option<[u8; 3]>,
    pub weightless: bool,
    pub name: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjectiveKind {
    Player,
    Physics,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Objective {
    pub kind: ObjectiveKind,
    pub bounds: Aabb,
    /// The seconds of unbroken touch after which it is met.
    pub hold: f64,
    /// Its turn: objectives with smaller numbers come first, and it stays met. `None`: it is met whenever it is touched.
    pub order: Option<u32>,
    /// The colour of the only key objects that fit; every key fits where there is none.
    pub colour: Option<[u8; 3]>,
}

impl Objective {
    /// Met as long as it is touched.
    pub const fn new(kind: ObjectiveKind, bounds: Aabb) -> Self {
        Self { kind, bounds, hold: 0.0, order: None, colour: None }
    }

    pub fn fits(&self, key: [u8; 3]) -> bool {
        self.colour.is_none_or(|colour| colour == key)
    }
}

/// It blows from a solid block, with a force in N.
#[derive(Clone, Debug, PartialEq)]
pub struct AirStream {
    pub source: Aabb,
    pub zone: Aabb,
    pub force: DVec2,
    pub name: Option<String>,
}

/// Density in kg/m³, viscosity in Pa·s; the colour is red, green, blue.
#[derive(Clone, Debug, PartialEq)]
pub struct Fluid {
    pub zone: Aabb,
    pub density: f64,
    pub viscosity: f64,
    pub colour: [u8; 3],
}

/// A zone whose gravity, N/kg, adds to the gravity of the level.
#[derive(Clone, Debug, PartialEq)]
pub struct GravityZone {
    pub zone: Aabb,
    pub strength: DVec2,
}

/// A spring, rope or magnet; its name is for switches.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelLink {
    pub def: LinkDef,
    pub name: Option<String>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Pod {
    pub bounds: Aabb,
    pub fuel: f64,
}

/// A picture that nothing touches; one in front covers moving bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Decoration {
    pub bounds: Aabb,
    pub look: Look,
    pub in_front: bool,
}

/// Its top left corner and the height of its letters in m; red, green and blue, or the usual colour of words.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    pub position: DVec2,
    pub size: f64,
    pub text: String,
    pub colour: Option<[u8; 3]>,
}

/// What a level's medals demand: the longest times, s, gold's at most silver's, and a mark. A level that names none has bronze alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Awards {
    pub silver: Option<f64>,
    pub gold: Option<f64>,
    pub mark: Option<Mark>,
}

/// A mark's demand on a flight that completes its level: the most damaging hits, pushes of objects or burns, the least fuel left (%), the highest
/// speed (m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    Hits(u32),
    Fuel(f64),
    Pushes(u32),
    Speed(f64),
    Burns(u32),
    /// A number of objectives, met within that time, s.
    Together(u32, f64),
    /// All stars of the level touched.
    Stars,
}

/// A place that a body has to touch once for the level's mark.
#[derive(Clone, Debug, PartialEq)]
pub struct Star {
    pub bounds: Aabb,
    pub by: StarTouch,
}

/// What touches a star; any object may be a key object, too.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StarTouch {
    #[default]
    Ship,
    Key,
    Object,
}
