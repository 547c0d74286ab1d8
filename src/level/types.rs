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

#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// The folder's name.
    pub name: String,
    /// Shown to the player; the name where the author gave none.
    pub title: String,
    /// Pixels a metre of the author's picture.
    pub metre: f64,
    /// Width and height, m.
    pub size: DVec2,
    /// N/kg, downwards.
    pub gravity: f64,
    /// N/kg, to the right.
    pub gravity_x: f64,
    /// kg/m³.
    pub air_density: f64,
    /// s.
    pub optimal_time: f64,
    /// m/s.
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

#[derive(Clone, Debug, PartialEq)]
pub struct ShipStart {
    /// Centre, m.
    pub position: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// Degrees clockwise, 0 is nose up.
    pub angle: f64,
    /// kg.
    pub mass: f64,
    pub fuel: f64,
    /// N.
    pub thrust: f64,
    pub feels_air: bool,
    pub material: Material,
    /// Drag coefficient.
    pub drag: f64,
    /// Coefficient of restitution.
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

#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// At the start.
    pub bounds: Aabb,
    pub material: Material,
    /// The sides from which it is solid.
    pub sides: Sides,
    /// The speed of its skin, m/s, clockwise: the top runs to the right.
    pub belt: f64,
    /// The impulse, N·s, beyond which a hit breaks it.
    pub breaks: Option<f64>,
    /// Its name for switches; several things may share it.
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

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwitchStay {
    Held,
    /// For ever, once it has been pressed.
    Latched,
    /// Until it is pressed again.
    Toggled,
}

/// The things of one name, as a switch works them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Work {
    pub name: String,
    /// They are on while the switch is off, and off while it is on.
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

#[derive(Clone, Debug, PartialEq)]
pub enum Look {
    Image(std::path::PathBuf),
    /// A plain box drawn by the game.
    Box,
    /// A plain ball drawn by the game.
    Ball,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Centre, m.
    pub position: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// Width and height, m.
    pub size: DVec2,
    /// kg.
    pub mass: f64,
    /// Drag coefficient.
    pub drag: f64,
    /// Coefficient of restitution.
    pub restitution: f64,
    /// It is drawn round, and air and liquids act on it as on a ball; its box collides.
    pub circular: bool,
    pub look: Look,
    pub material: Material,
    /// A key object's colour; `None` for an ordinary object.
    pub key: Option<[u8; 3]>,
    pub weightless: bool,
    /// Its name for links.
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

#[derive(Clone, Debug, PartialEq)]
pub struct AirStream {
    /// The solid source block.
    pub source: Aabb,
    pub zone: Aabb,
    /// N.
    pub force: DVec2,
    pub name: Option<String>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Fluid {
    pub zone: Aabb,
    /// kg/m³.
    pub density: f64,
    /// Pa·s.
    pub viscosity: f64,
    /// Red, green, blue.
    pub colour: [u8; 3],
}

/// A zone whose gravity adds to the gravity of the level.
#[derive(Clone, Debug, PartialEq)]
pub struct GravityZone {
    pub zone: Aabb,
    /// N/kg.
    pub strength: DVec2,
}

/// A spring, rope or magnet.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelLink {
    pub def: LinkDef,
    /// Its name for switches.
    pub name: Option<String>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Pod {
    pub bounds: Aabb,
    pub fuel: f64,
}

/// A picture that nothing touches.
#[derive(Clone, Debug, PartialEq)]
pub struct Decoration {
    pub bounds: Aabb,
    pub look: Look,
    /// Whether it covers moving bodies.
    pub in_front: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// Top left corner, m.
    pub position: DVec2,
    /// Height of the letters, m.
    pub size: f64,
    pub text: String,
    /// Red, green, blue; `None`: the usual colour of words.
    pub colour: Option<[u8; 3]>,
}

/// The demands of a level's medals; a level that names none has bronze alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Awards {
    /// The longest time for silver, s.
    pub silver: Option<f64>,
    /// The longest time for gold, s, at most the time for silver.
    pub gold: Option<f64>,
    pub mark: Option<Mark>,
}

/// The demand of a level's own mark on a flight that completes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// The most damaging hits.
    Hits(u32),
    /// The least fuel left, %.
    Fuel(f64),
    /// The most pushes of objects by the ship.
    Pushes(u32),
    /// The highest speed, m/s.
    Speed(f64),
    /// The most burns.
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

/// What touches a star.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StarTouch {
    #[default]
    Ship,
    /// A key object.
    Key,
    /// Any object, key objects too.
    Object,
}
