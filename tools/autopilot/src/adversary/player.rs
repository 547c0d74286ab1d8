//! Players who mean no good: one hits keys at random, one heads for the objectives by the shortest way, one goes anywhere.

use super::Random;
use super::way::{Space, Way};
use resultant::game::{Controls, Game, ROTATION_RATE, SHIP};
use resultant::level::{Level, ObjectiveKind};
use resultant::physics::{Aabb, BodyId, DVec2, ForceKind};

const BEAT: u64 = 6;
/// How fast an error of the velocity is mended, 1/s.
const GRIP: f64 = 3.0;

/// The aim of a player.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Any keys for any time.
    Random,
    /// Objectives that are not met yet.
    Greedy,
    /// Any place.
    Wander,
}

pub struct Player<'a> {
    style: Style,
    random: Random,
    space: &'a Space,
    /// The speed that it goes for, m/s.
    speed: f64,
    way: Option<Way<'a>>,
    /// When another goal is chosen, in ticks.
    until: u64,
    held: Controls,
    /// How long, in ticks.
    held_until: u64,
    turn: i64,
}

impl<'a> Player<'a> {
    pub fn new(style: Style, seed: u64, space: &'a Space) -> Self {
        let mut random = Random(seed);
        let speed = random.between(3.0, 16.0);
        Self { style, random, space, speed, way: None, until: 0, held: Controls::default(), held_until: 0, turn: 0 }
    }

    pub fn after(goal: &Aabb, space: &'a Space) -> Self {
        Self { way: Some(space.to(goal)), until: u64::MAX, speed: 6.0, ..Self::new(Style::Greedy, 1, space) }
    }

    pub fn keys(&mut self, game: &Game) -> Controls {
        if game.ticks() >= self.held_until {
            self.decide(game);
        }
        let mut held = self.held;
        if self.turn != 0 {
            (held.left, held.right) = (self.turn < 0, self.turn > 0);
            self.turn -= self.turn.signum();
        }
        held
    }

    fn decide(&mut self, game: &Game) {
        (self.held, self.turn) = (Controls::default(), 0);
        if self.style == Style::Random || self.random.chance(0.03) {
            return self.hit_keys(game, 0.8);
        }
        if game.ticks() >= self.until {
            self.choose(game);
        }
        let at = game.world().body(SHIP).position;
        self.held_until = game.ticks() + BEAT;
        match self.way.as_ref().and_then(|way| Some((way.next(at)?, way.far(at)?))) {
            Some((_, far)) if far == 0.0 && self.until != u64::MAX => self.shove(game),
            Some((to, far)) => self.steer(game, (to - at).normalize_or_zero() * self.speed.min(1.0 + 2.0 * far)),
            None => self.hit_keys(game, 0.8),
        }
    }

    /// Holds any keys for a while, the engine mostly.
    fn hit_keys(&mut self, game: &Game, longest: f64) {
        let random = &mut self.random;
        let (thrust, side) = (random.chance(0.7), random.unit());
        self.held = Controls { thrust, reverse: !thrust && random.chance(0.3), left: side < 0.3, right: side > 0.7 };
        self.held_until = game.ticks() + 1 + (random.between(0.0, longest) * game.tick_rate()) as u64;
    }

    /// Chooses where to go for some seconds.
    fn choose(&mut self, game: &Game) {
        self.until = game.ticks() + (self.random.between(2.0, 10.0) * game.tick_rate()) as u64;
        let goals = wanted(game);
        self.way = match (self.style, goals.is_empty()) {
            (Style::Greedy, false) => Some(self.space.to(&goals[self.random.below(goals.len())])),
            _ => self.space.any(self.random.bits() as usize >> 8).map(|place| self.space.to(&Aabb::around(place, DVec2::ZERO))),
        };
    }

    /// Pushes the goal that it has reached to some side, most often towards the nearest pit.
    fn shove(&mut self, game: &Game) {
        let ship = game.world().body(SHIP).position;
        let pits = game.level().objectives.iter().filter(|objective| objective.kind == ObjectiveKind::Physics);
        let aim = pits.map(|pit| pit.bounds.centre().x - ship.x).min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or_default();
        let side = if self.random.chance(0.7) { aim.signum() } else { self.random.pick(&[-1.0, 1.0]) };
        self.turn_to(game, 90.0 * side, u64::MAX);
        let ticks = self.turn.unsigned_abs() + (self.random.between(0.1, 1.0) * game.tick_rate()) as u64;
        self.held.thrust = self.random.chance(0.9);
        self.held_until = game.ticks() + ticks;
        self.until = self.until.min(self.held_until + BEAT);
    }

    /// Turns and burns for a beat so that the ship's velocity becomes the wanted one.
    fn steer(&mut self, game: &Game, wanted: DVec2) {
        let (ship, forces, player) = (game.world().body(SHIP), game.world().forces(SHIP), &game.level().player);
        let others = [ForceKind::Weight, ForceKind::Wind, ForceKind::AirResistance, ForceKind::Buoyancy, ForceKind::ViscousDrag];
        let others: DVec2 = others.map(|kind| forces.total(kind)).into_iter().sum();
        let engine = (wanted - ship.velocity) * GRIP - others / player.mass;
        self.turn_to(game, libm::atan2(engine.x, -engine.y).to_degrees(), BEAT);
        self.held.thrust = engine.dot(game.ship().nose()) > 0.5 * player.thrust / player.mass;
    }

    fn turn_to(&mut self, game: &Game, angle: f64, most: u64) {
        let error = (angle - game.ship().angle + 180.0).rem_euclid(360.0) - 180.0;
        let ticks = (error * game.tick_rate() / ROTATION_RATE).round();
        self.turn = ticks.clamp(-(most.min(1000) as f64), most.min(1000) as f64) as i64;
    }
}

/// Objectives for the ship that are not met, and keys where one is missing.
pub fn wanted(game: &Game) -> Vec<Aabb> {
    let level: &Level = game.level();
    let open = || level.objectives.iter().zip(game.met()).filter(|(_, met)| !**met).map(|(objective, _)| objective);
    let keys = (1..).zip(&level.objects).filter(|(_, object)| object.key.is_some());
    let mut goals: Vec<Aabb> =
        open().filter(|objective| objective.kind == ObjectiveKind::Player).map(|objective| objective.bounds).collect();
    if open().any(|objective| objective.kind == ObjectiveKind::Physics) {
        goals.extend(keys.map(|(body, _)| game.world().body(BodyId(body)).bounds()));
    }
    goals
}
