//! The sounds of a game: one for each event, and the ambience of the ship.

use super::{Arrangement, Cue, Stuff};
use crate::game::{DAMAGING_SPEED, DUST_SPEED, Game, GameEvent, Outcome, SHIP};
use crate::number::hash;
use crate::physics::{Body, DVec2, Event, Obstacle};

/// The distance from the ship that halves the loudness, m, and the distance to the side that puts a sound wholly there.
const HALVES: f64 = 12.0;
const ASIDE: f64 = 25.0;
/// Speed through the air of the level's density 1.2041 kg/m³ at which the wind is loudest, m/s.
const STORM: f64 = 35.0;
const AIR: f64 = 1.2041;
/// Speed in a liquid at which the liquid is loudest, m/s.
const TORRENT: f64 = 8.0;
/// A change of the ship's share under water that is a splash.
const SPLASH: f64 = 0.08;
/// The ship's least speed for a splash, m/s.
const SPLASH_SPEED: f64 = 0.8;

/// Speed with all layers of the music, m/s.
const BRISK: f64 = 14.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sound {
    pub cue: Cue,
    /// 0 … 1.
    pub loudness: f32,
    /// −1 left, 0 middle, 1 right.
    pub place: f32,
}

impl Sound {
    /// In the middle.
    pub const fn new(cue: Cue, loudness: f32) -> Self {
        Self { cue, loudness, place: 0.0 }
    }
}

/// The continuous sounds, each 0 … 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ambience {
    pub engine: f32,
    /// The speed of the air past the ship.
    pub wind: f32,
    /// The share of the ship under water.
    pub liquid: f32,
    /// The speed of the ship in the liquid.
    pub motion: f32,
}

/// Listens to one attempt, tick by tick.
#[derive(Debug, Default)]
pub struct Ear {
    /// The share of the ship under water; `None` before the first tick.
    wet: Option<f64>,
}

impl Ear {
    /// Passes on the sounds of the last tick.
    pub fn listen(&mut self, game: &Game, mut hear: impl FnMut(Sound)) {
        for event in game.world().events() {
            if let &Event::Impact { a, b, point, speed, .. } = event
                && speed >= DUST_SPEED
            {
                let bodies = game.world().bodies();
                let hit = match b {
                    Obstacle::Surface(surface) => game.world().surfaces().get(surface as usize).map(|surface| surface.material),
                    // The sound is that of the other body, not of the ship's hull.
                    Obstacle::Body(SHIP) => bodies.get(a.0 as usize).map(|body| body.material),
                    Obstacle::Body(other) => bodies.get(other.0 as usize).map(|body| body.material),
                };
                if let (Some(material), Some(body)) = (hit, bodies.get(a.0 as usize)) {
                    let heavy = (body.mass / game.level().player.mass).powf(0.25).clamp(0.3, 1.0);
                    hear(at(Cue::Knock(Stuff::of(&material)), heavy * (speed / DAMAGING_SPEED).min(1.0), point, game));
                }
            }
        }
        for event in game.events() {
            match event {
                GameEvent::DamagingHit { point, .. } => hear(at(Cue::Crash, 1.0, *point, game)),
                GameEvent::Crushed { point } => hear(at(Cue::Crash, 0.7, *point, game)),
                GameEvent::ObjectiveMet(_) => hear(Sound::new(Cue::Met, 1.0)),
                GameEvent::Switched(_, true) => hear(Sound::new(Cue::Press, 1.0)),
                GameEvent::Switched(_, false) => hear(Sound::new(Cue::Move, 1.0)),
                GameEvent::Broke(_) => hear(Sound::new(Cue::Knock(Stuff::Glass), 1.0)),
                GameEvent::Snapped(_) => hear(Sound::new(Cue::Knock(Stuff::Rubber), 1.0)),
                GameEvent::Hooked(_) => hear(Sound::new(Cue::Click, 1.0)),
                GameEvent::Refuelled(_) | GameEvent::StarTouched(_) => hear(Sound::new(Cue::Bubble, 1.0)),
                GameEvent::ObjectiveLost(_) => hear(Sound::new(Cue::Lost, 1.0)),
                GameEvent::Completed => hear(Sound::new(Cue::Success, 1.0)),
                GameEvent::Died => hear(Sound::new(Cue::Death, 1.0)),
                // The collision above has its material.
                GameEvent::Impact { .. } => {}
            }
        }
        let (wet, speed) = (wetness(game), game.world().body(SHIP).velocity.length());
        let before = *self.wet.get_or_insert(wet);
        if (wet - before).abs() >= SPLASH {
            self.wet = Some(wet);
            // Only the surface splashes: a ship nearly out or nearly under.
            if speed >= SPLASH_SPEED && (before < SPLASH || wet < SPLASH) {
                hear(Sound::new(Cue::Splash, (speed / TORRENT).min(1.0) as f32));
            }
        }
    }
}

impl Ambience {
    /// Around the ship as it is now. `burning` is the growth of the engine's plume, 0 … 1.
    pub fn of(game: &Game, burning: f64) -> Self {
        let (level, ship) = (game.level(), game.world().body(SHIP));
        let (speed, wet) = (ship.velocity.length(), wetness(game));
        let burning = if game.outcome() == Outcome::Running { burning } else { 0.0 };
        let lift = level.player.thrust / (2.0 * ship.mass * level.gravity.abs().max(1.0));
        let air = if ship.feels_air { (level.air_density / AIR).sqrt() * speed / STORM } else { 0.0 };
        Self {
            engine: (burning * (0.5 + 0.5 * lift.min(1.0))) as f32,
            wind: (air.max(stream(game, ship)).min(1.0) * (1.0 - wet)) as f32,
            liquid: wet as f32,
            motion: (speed / TORRENT).min(1.0) as f32,
        }
    }
}

impl Arrangement {
    /// The ensemble of the level's world, with the layers for the ship's speed and for the goals that are met.
    pub fn of(game: &Game) -> Self {
        let met = game.met().iter().filter(|met| **met).count();
        Self {
            world: game.level().landscape.map_or(0, |landscape| landscape as usize),
            pace: (game.world().body(SHIP).velocity.length() / BRISK).min(1.0) as f32,
            goals: met as f32 / game.met().len().max(1) as f32,
        }
    }
}

/// The number of a name's tune: the level's number, or a hash.
pub fn tune(name: &str) -> u32 {
    name.parse().unwrap_or_else(|_| hash(name))
}

/// Strength of the air stream at the ship: 1 at one and a half times its weight.
fn stream(game: &Game, ship: &Body) -> f64 {
    let weight = 1.5 * ship.mass * game.level().gravity.abs().max(1.0);
    let felt = game.level().streams.iter().filter(|stream| stream.zone.touches(&ship.bounds(), 0.0));
    felt.map(|stream| stream.force).sum::<DVec2>().length() / weight
}

/// 0 … 1.
fn wetness(game: &Game) -> f64 {
    let ship = game.world().body(SHIP).bounds();
    let shared = |zone: &crate::physics::Aabb| (zone.max.min(ship.max) - zone.min.max(ship.min)).max(DVec2::ZERO).element_product();
    (game.level().fluids.iter().map(|fluid| shared(&fluid.zone)).sum::<f64>() / ship.size().element_product()).min(1.0)
}

/// A sound at a point of the level, heard from the ship.
fn at(cue: Cue, loudness: f64, point: DVec2, game: &Game) -> Sound {
    let away = point - game.world().body(SHIP).position;
    let loudness = loudness / (1.0 + away.length() / HALVES);
    Sound { cue, loudness: loudness as f32, place: (away.x / ASIDE).clamp(-1.0, 1.0) as f32 }
}
