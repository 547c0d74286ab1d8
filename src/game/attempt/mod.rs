//! One attempt at a level: the rules, tick by tick.

mod carried;

use super::clock::{Controls, TICK_RATE, TICK_RATES};
use super::event::{Death, GameError, GameEvent, Outcome, crushed};
use super::fingerprint::Fnv1a;
use super::impacts::{APART, DUST_SPEED, Felt, Impacts, PushCount, READABLE, SHIP_BOX, TOUCH, damaging_hit, has_passed};
use super::mechanisms::{Mechanisms, Objectives};
use super::score::{RunResult, ScoreParts, Tricks};
use super::ship::{SHIP, Ship, stands};
use crate::level::{Level, Mark, SHIP_HALF, ship_body};
use crate::physics::{Aabb, BodyId, DVec2, Event, Plan, World};
use std::sync::Arc;

#[derive(Clone, Debug, PartialEq)]
struct FlightFigures {
    collisions: u32,
    /// m.
    distance: f64,
    /// m/s.
    top_speed: f64,
    /// N.
    peak_resultant: f64,
}

#[derive(Clone, Debug)]
pub struct Game {
    level: Arc<Level>,
    tick_rate: f64,
    world: World,
    ship: Ship,
    outcome: Outcome,
    ticks: u64,
    /// Ticks before the first one with an input: they are not on the clock.
    idle: u64,
    objectives: Objectives,
    pushes: PushCount,
    mechanisms: Mechanisms,
    tricks: Tricks,
    flight: FlightFigures,
    events: Vec<GameEvent>,
    /// Impacts and squeezed bodies are for the screen: no rule reads them.
    impacts: Impacts,
    squeezed: Vec<BodyId>,
}

impl Game {
    pub fn new(level: Arc<Level>) -> Result<Self, GameError> {
        Self::with_tick_rate(level, TICK_RATE)
    }

    /// The level at its start, at `tick_rate` ticks a second.
    /// Errors: a tick rate outside [`TICK_RATES`]; a world that the engine refuses, of a level that did not come from the loader.
    pub fn with_tick_rate(level: Arc<Level>, tick_rate: f64) -> Result<Self, GameError> {
        if !TICK_RATES.contains(&tick_rate) {
            return Err(GameError::TickRate(tick_rate));
        }
        let mut world = World::new(level.world_def()).map_err(GameError::World)?;
        let mechanisms = Mechanisms::new(&level, &mut world);
        let flight = FlightFigures {
            collisions: 0,
            distance: 0.0,
            top_speed: world.body(SHIP).velocity.length(),
            peak_resultant: world.forces(SHIP).resultant().length(),
        };
        let mut game = Self {
            tick_rate,
            objectives: Objectives::new(&level, &world, tick_rate),
            pushes: PushCount::new(level.objects.len()),
            mechanisms,
            tricks: Tricks::new(&level),
            world,
            ship: Ship::new(&level.player),
            outcome: Outcome::Running,
            ticks: 0,
            idle: 0,
            flight,
            events: Vec::new(),
            impacts: Impacts::default(),
            squeezed: Vec::new(),
            level,
        };
        game.remember_impacts();
        Ok(game)
    }

    pub const fn set_plan(&mut self, plan: Plan) {
        self.world.set_plan(plan);
    }

    pub const fn set_lasting_fuel(&mut self, lasts: bool) {
        self.ship.fuel_lasts = lasts;
    }

    pub const fn lasting_fuel(&self) -> bool {
        self.ship.fuel_lasts
    }

    /// Whether the tank is empty and the ship at rest, so that no key moves it any more.
    pub fn is_stranded(&self) -> bool {
        let ship = self.world.body(SHIP);
        let at_rest = ship.velocity == DVec2::ZERO && ship.acceleration == DVec2::ZERO;
        self.outcome == Outcome::Running && self.ship.fuel == 0.0 && at_rest
    }

    /// Advances the attempt by one tick. After its end a tick only clears the events.
    pub fn step(&mut self, controls: Controls) {
        self.events.clear();
        if self.outcome != Outcome::Running {
            return;
        }
        // Counts on while no tick before this one had an input.
        self.idle += u64::from(self.is_idle() && controls == Controls::default());
        self.mechanisms.work(&self.level, &mut self.world);
        let world = &self.world;
        let drive = self.ship.obey(controls, &self.level.player, self.tick_rate, || stands(world));
        self.world.set_drive(SHIP, drive);
        self.world.step(1.0 / self.tick_rate);
        self.ticks += 1;
        self.measure();
        self.note_impacts();
        self.note_crushed();
        self.note_mechanisms();
        self.objectives.note(&self.level, &self.world, &mut self.events);
        let at = (self.ticks, self.tick_rate);
        self.tricks.note(&self.level, &self.world, at, self.ship.burning != 0, &mut self.events);
        self.judge();
    }

    fn measure(&mut self) {
        let mut from = self.world.previous_position(SHIP);
        for to in self.world.path(SHIP) {
            self.flight.distance += from.distance(to);
            from = to;
        }
        self.flight.top_speed = self.flight.top_speed.max(self.world.body(SHIP).velocity.length());
        let forces = self.world.forces(SHIP);
        self.flight.peak_resultant = self.flight.peak_resultant.max(forces.resultant().length());
        self.pushes.note(self.ticks, APART * self.tick_rate, &forces, self.world.impulses());
    }

    fn remember_impacts(&mut self) {
        self.impacts.note(self.ticks, (READABLE * self.tick_rate) as u64, self.world.impulses());
    }

    fn note_impacts(&mut self) {
        self.remember_impacts();
        for event in self.world.events() {
            let &Event::Impact { point, speed, normal, .. } = event else { continue };
            if speed >= DUST_SPEED {
                self.events.push(GameEvent::Impact { point, speed, normal });
            }
        }
        if let Some((point, speed)) = damaging_hit(self.world.events()) {
            self.flight.collisions += 1;
            self.events.push(GameEvent::DamagingHit { point, speed });
        }
    }

    fn note_crushed(&mut self) {
        for (body, _) in crushed(self.world.events()) {
            if !self.squeezed.contains(&body) {
                self.events.push(GameEvent::Crushed { point: self.world.body(body).position });
            }
        }
        self.squeezed.clear();
        self.squeezed.extend(crushed(self.world.events()).map(|(body, _)| body));
    }

    fn note_mechanisms(&mut self) {
        for event in self.world.events() {
            match event {
                Event::Snapped { link } => self.events.push(GameEvent::Snapped(*link as usize)),
                Event::Hooked { link } => self.events.push(GameEvent::Hooked(*link as usize)),
                Event::Impact { .. } | Event::Crushed { .. } => {}
            }
        }
        self.mechanisms.note(&self.level, &mut self.world, &mut self.events);
        for (index, pod) in self.level.pods.iter().enumerate() {
            let full = self.ship.fuel >= self.level.player.fuel;
            let touched = !full && !self.mechanisms.is_taken(index) && has_passed(&self.world, SHIP, &SHIP_BOX, &pod.bounds);
            if touched && self.mechanisms.take_pod(index) {
                self.ship.refuel(pod.fuel, &self.level.player);
                self.events.push(GameEvent::Refuelled(index));
            }
        }
    }

    /// Death goes before completion.
    fn judge(&mut self) {
        if self.death().is_some() {
            self.outcome = Outcome::Failed;
            self.events.push(GameEvent::Died);
        } else if self.objectives.are_all_met() {
            self.outcome = Outcome::Completed;
            self.events.push(GameEvent::Completed);
        }
    }

    /// Of several death boxes that the ship touches, the first in the level's order.
    pub fn killed_by(&self) -> Option<Death> {
        if self.outcome == Outcome::Failed { self.death() } else { None }
    }

    fn death(&self) -> Option<Death> {
        let body = ship_body(self.ship.angle);
        let swept = self.swept();
        let touches = |deadly: &Aabb| swept.touches(deadly, TOUCH) && has_passed(&self.world, SHIP, &body, deadly);
        let touched = self.level.obstacles.iter().position(touches).map(Death::Obstacle);
        let squeezed = || crushed(self.world.events()).find(|(body, _)| *body == SHIP).map(|(_, by)| Death::Crushed(by));
        touched.or_else(squeezed)
    }

    fn swept(&self) -> Aabb {
        let places = self.world.path(SHIP).map(|at| Aabb::around(at, SHIP_HALF));
        places.fold(Aabb::around(self.world.previous_position(SHIP), SHIP_HALF), |all, place| all.union(&place))
    }

    pub fn level(&self) -> &Level {
        &self.level
    }

    pub const fn shared_level(&self) -> &Arc<Level> {
        &self.level
    }

    /// The body that the view follows until the player picks one: the ship, or the first object where the ship plays no part.
    pub fn lead(&self) -> BodyId {
        if self.level.ship_plays() || self.level.objects.is_empty() { SHIP } else { BodyId(1) }
    }

    /// Object i of the level is body i + 1.
    pub fn world(&self) -> &World {
        &self.world
    }

    pub fn mechanisms(&self) -> &Mechanisms {
        &self.mechanisms
    }

    /// By index in `Level::stars`.
    pub fn stars(&self) -> &[bool] {
        &self.tricks.touched
    }

    pub fn ship(&self) -> &Ship {
        &self.ship
    }

    pub fn outcome(&self) -> Outcome {
        self.outcome
    }

    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    pub fn tick_rate(&self) -> f64 {
        self.tick_rate
    }

    /// Whether no tick so far had an input: the clock stands at 0 until then.
    pub const fn is_idle(&self) -> bool {
        self.idle == self.ticks
    }

    pub fn elapsed(&self) -> f64 {
        self.ticks as f64 / self.tick_rate
    }

    /// Seconds on the clock, which score, medals and boards count: from the first tick with an input on, or from the start where no tick has one.
    pub fn time(&self) -> f64 {
        self.ticks_on_clock() as f64 / self.tick_rate
    }

    pub const fn ticks_on_clock(&self) -> u64 {
        if self.is_idle() { self.ticks } else { self.ticks - self.idle }
    }

    /// The fraction of the fuel left, 0 … 1; 0 in a level without fuel.
    pub fn fuel(&self) -> f64 {
        let full = self.level.player.fuel;
        if full > 0.0 { self.ship.fuel / full } else { 0.0 }
    }

    pub fn collisions(&self) -> u32 {
        self.flight.collisions
    }

    pub fn met(&self) -> &[bool] {
        self.objectives.met()
    }

    /// The share of an objective's hold time that has passed, 0 … 1.
    pub fn held(&self, index: usize) -> f64 {
        self.objectives.held(&self.level.objectives[index], index)
    }

    /// Whether all objectives with smaller numbers are met.
    pub fn is_open(&self, index: usize) -> bool {
        self.objectives.is_open(&self.level, index)
    }

    pub fn events(&self) -> &[GameEvent] {
        &self.events
    }

    /// The impacts on a body in the last [`READABLE`] seconds of the game, the largest first.
    pub fn impacts(&self, body: BodyId) -> Vec<Felt> {
        self.impacts.on(body)
    }

    pub fn result(&self) -> RunResult {
        let (time, optimal_time) = (self.time(), self.level.optimal_time);
        RunResult {
            level: self.level.name.clone(),
            outcome: self.outcome,
            time,
            optimal_time,
            objectives_met: self.met().iter().filter(|&&met| met).count(),
            objectives_all: self.met().len(),
            collisions: self.flight.collisions,
            pushes: self.pushes.count,
            burns: self.tricks.burns,
            stars_left: self.stars().iter().filter(|&&touched| !touched).count(),
            together: match self.level.awards.mark {
                Some(Mark::Together(count, _)) => self.tricks.together(count, self.tick_rate),
                _ => 0.0,
            },
            fuel: self.fuel(),
            fuel_used: self.ship.fuel_used(),
            distance: self.flight.distance,
            top_speed: self.flight.top_speed,
            peak_resultant: self.flight.peak_resultant,
            assisted: false,
            death: self.killed_by().map(|death| death.words(&self.level)),
            score: match self.outcome {
                Outcome::Completed => ScoreParts::completed(time, optimal_time, self.fuel(), self.flight.collisions),
                Outcome::Running | Outcome::Failed => ScoreParts::default(),
            },
        }
    }

    /// A hash of every bit of the state: two games with the same hash go on alike under the same controls. Tricks are left out: a level
    /// that asks for another mark keeps its recorded flights.
    pub fn hash(&self) -> u64 {
        let mut hash = Fnv1a::new();
        let mut write = |word| hash.write(word);
        write(self.ticks);
        write(self.outcome as u64);
        if self.idle != 0 {
            write(self.idle);
        }
        self.objectives.hash_state(&self.level, &mut write);
        self.ship.hash_state(&mut write);
        write(u64::from(self.flight.collisions));
        for value in [self.flight.distance, self.flight.top_speed, self.flight.peak_resultant] {
            write(value.to_bits());
        }
        self.pushes.hash_state(&mut write);
        self.mechanisms.hash_state(&mut write);
        self.world.hash_state(&mut write);
        hash.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{BodyDef, Material, Path, SurfaceDef, WorldDef};

    /// A lift presses the bodies on it against a ceiling. No level has lifts: the test puts the world in.
    #[test]
    fn a_squeezed_body_is_reported_once_and_a_squeezed_ship_is_lost() {
        let level = Arc::new(crate::level::fixture());
        let block = |top: f64, bottom: f64| {
            let bounds = Aabb::new(DVec2::new(-520.0, top), DVec2::new(-500.0, bottom));
            SurfaceDef::fixed(bounds, Material::ASPHALT)
        };
        let lift = SurfaceDef { path: Path::steady(DVec2::new(0.0, -1.0)), ..block(51.0, 52.0) };
        let body = |x: f64, half: DVec2| BodyDef { position: DVec2::new(x, 50.0), half, ..BodyDef::default() };
        for (ship, ends) in [(-510.0, Some(Death::Crushed(0))), (-900.0, None)] {
            let bodies = vec![body(ship, SHIP_HALF), body(-505.0, DVec2::splat(0.5))];
            let surfaces = vec![lift.clone(), block(48.0, 49.0)];
            let mut game = Game::new(level.clone()).unwrap();
            game.world = World::new(WorldDef { surfaces, bodies, ..WorldDef::default() }).unwrap();
            let mut marks = 0;
            for _ in 0..240 {
                game.step(Controls::default());
                marks += game.events().iter().filter(|event| matches!(event, GameEvent::Crushed { .. })).count();
            }
            assert_eq!((game.killed_by(), marks), (ends, 1));
            assert_eq!(game.outcome(), if ends.is_some() { Outcome::Failed } else { Outcome::Running });
        }
        assert_eq!(Death::Crushed(0).name(&level), "crushed by world 1");
        assert_eq!(Death::Crushed(level.world.len() as u32 + 2).name(&level), "crushed by edge top");
    }
}
