//! A level as the rest of the game knows it: in metres, checked, ready to play.

use super::awards::Awards;
use crate::physics::{Aabb, DVec2, Material};

/// The ship's height, m: it fixes the scale.
pub const SHIP_HEIGHT: f64 = 1.7;
/// Half the ship's collision box, m: as wide as high.
pub const SHIP_HALF: DVec2 = DVec2::new(0.85, 0.85);
/// The ship's height in pixels at the default scale of 30 pixels a metre.
pub const SHIP_PIXELS: f64 = 51.0;
/// The ship's drag coefficient.
pub const SHIP_DRAG: f64 = 1.15;

/// A level that can be played. All lengths in metres.
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
    /// N/kg.
    pub gravity: f64,
    /// kg/m³.
    pub air_density: f64,
    /// s.
    pub optimal_time: f64,
    /// m/s.
    pub rest_speed: f64,
    /// What its medals ask for.
    pub awards: Awards,
    /// The ship.
    pub player: Player,
    /// Solid, immovable rectangles.
    pub world: Vec<Solid>,
    /// Those of objects.csv, then the key objects, each in file order.
    pub objects: Vec<Object>,
    /// Objective blocks.
    pub objectives: Vec<Objective>,
    /// Death boxes.
    pub obstacles: Vec<Aabb>,
    /// Air streams.
    pub streams: Vec<Stream>,
    /// Liquids.
    pub fluids: Vec<Fluid>,
    /// Words in the level.
    pub texts: Vec<Text>,
    /// The path of background.png, where there is one.
    pub background: Option<std::path::PathBuf>,
}

/// The ship at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct Player {
    /// Centre, m.
    pub position: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// Degrees clockwise, 0 is nose up.
    pub angle: f64,
    /// kg.
    pub mass: f64,
    /// Fuel units.
    pub fuel: f64,
    /// N.
    pub thrust: f64,
    /// Whether air acts on it.
    pub feels_air: bool,
    /// What it is made of.
    pub material: Material,
}

/// A solid rectangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Where it is.
    pub bounds: Aabb,
    /// What it is made of.
    pub material: Material,
}

/// How an object is drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Look {
    /// A PNG.
    Image(std::path::PathBuf),
    /// A plain box drawn by the game.
    Box,
    /// A plain ball drawn by the game.
    Ball,
}

/// A physics object.
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
    /// Whether it is round: drawn so, and met by air and liquids as a ball; every collision is that of its box.
    pub circular: bool,
    /// How it is drawn.
    pub look: Look,
    /// What it is made of.
    pub material: Material,
    /// A key object's colour; `None` for an ordinary object.
    pub key: Option<[u8; 3]>,
}

/// What an objective waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjectiveKind {
    /// The ship.
    Player,
    /// A key object.
    Physics,
}

/// An objective block.
#[derive(Clone, Debug, PartialEq)]
pub struct Objective {
    /// What it waits for.
    pub kind: ObjectiveKind,
    /// Where it is.
    pub bounds: Aabb,
    /// How long it has to be touched without a break before it is met, s.
    pub hold: f64,
    /// Its turn: it waits for those with smaller numbers, and stays met once it is. `None`: it is met whenever it is touched.
    pub order: Option<u32>,
    /// The colour of the only key objects that fit; any fits where there is none.
    pub colour: Option<[u8; 3]>,
}

impl Objective {
    /// One that is met as soon as it is touched, and as long as it is.
    pub const fn new(kind: ObjectiveKind, bounds: Aabb) -> Self {
        Self { kind, bounds, hold: 0.0, order: None, colour: None }
    }

    /// Whether a key object of that colour fits.
    pub fn fits(&self, key: [u8; 3]) -> bool {
        self.colour.is_none_or(|colour| colour == key)
    }
}

/// An air stream.
#[derive(Clone, Debug, PartialEq)]
pub struct Stream {
    /// The solid source block.
    pub source: Aabb,
    /// Where it blows.
    pub zone: Aabb,
    /// N.
    pub force: DVec2,
}

/// A zone of thick liquid.
#[derive(Clone, Debug, PartialEq)]
pub struct Fluid {
    /// Where it is.
    pub zone: Aabb,
    /// kg/m³.
    pub density: f64,
    /// Pa·s.
    pub viscosity: f64,
    /// Red, green, blue.
    pub colour: [u8; 3],
}

/// Words written in the level.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// Top left corner, m.
    pub position: DVec2,
    /// Height of the letters, m.
    pub size: f64,
    /// The words.
    pub text: String,
}
