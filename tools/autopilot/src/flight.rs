//! One flight of a level: by the pilot, or again by the keys that it held; and what the flight is worth.

use crate::pilot::Autopilot;
use crate::plan::{FlightPlan, StepKind};
use crate::sight::Sight;
use resultant::game::{Controls, Game, Inputs, Medals, Outcome, RunResult, SHIP, TICK_RATE};
use resultant::level::{Level, Mark, ObjectiveKind, SHIP_HALF};
use resultant::physics::{Aabb, DVec2, Event, Guards, Obstacle};
use std::sync::Arc;

/// No flight takes longer, s.
pub const LONGEST: f64 = 60.0;
/// How far the ship shall stay from what is deadly, and from walls and roofs, m.
const OFF_RED: f64 = 0.7;
const OFF_WALLS: f64 = 0.4;
/// A careful flight takes at least this factor of the time for gold, if the search finds one.
const CARE_BEYOND_GOLD: f64 = 1.08;
/// Hits that are gentle enough.
const GENTLE: Hits = Hits { bump: 0.5, push: 3.0, landing: 3.0 };

/// Speeds of hits of walls in flight, of objects, and of the ground where the ship lands, m/s.
struct Hits {
    bump: f64,
    push: f64,
    landing: f64,
}

/// What a flight is to show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// That the level can be completed with care: cleanly, off red, with keys that bear small changes.
    Careful,
    /// That gold can be reached.
    Gold,
    /// That the level's own mark can be earned.
    Mark,
}

impl Aim {
    pub const ALL: [Self; 3] = [Self::Careful, Self::Gold, Self::Mark];

    /// The name of its plan and of its record.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Careful => "careful",
            Self::Gold => "gold",
            Self::Mark => "mark",
        }
    }
}

/// A flight and what was seen of it.
#[derive(Clone, Debug)]
pub struct Flight {
    pub inputs: Inputs,
    pub result: RunResult,
    pub ticks: u64,
    /// Rows of the inputs' file.
    pub rows: usize,
    /// Steps of the plan that were done, and how far it was to the next one's place, m.
    pub steps: usize,
    pub distance: f64,
    /// Pushes of the plan that were not done.
    pub pushes_left: u32,
    /// The least distance to a death box, m.
    pub red: f64,
    /// Ticks with a wall or a roof closer than it should be.
    pub near_walls: u32,
    /// Hits of walls in flight that were not gentle.
    pub bumps: u32,
    /// Hits of objects while none was to be pushed, that were not gentle.
    pub knocks: u32,
    /// The hardest hits of an object and of the level, m/s.
    pub hardest_push: f64,
    pub hardest_landing: f64,
    /// The share of the ship's width that was not above or below the player's objectives at the end.
    pub aside: f64,
    /// The speed at the end, m/s.
    pub last_speed: f64,
    /// Whether a guard of the engine had to give something up.
    pub given_up: bool,
}

impl Flight {
    /// Flies by the plan.
    pub fn by_plan(level: &Arc<Level>, plan: &FlightPlan) -> Self {
        let mut game = new_game(level);
        let mut pilot = Autopilot::new(plan, &Sight::of(&game));
        let mut flight = Self::begun(&game);
        // What goes on for twice its time will not do any more.
        let longest = (2.0 * plan.settings.par).min(LONGEST);
        while game.outcome() == Outcome::Running && game.elapsed() < longest {
            let controls = pilot.keys(&Sight::of(&game));
            flight.inputs.record(controls);
            flight.last_speed = game.world().body(SHIP).velocity.length();
            game.step(controls);
            flight.watch(&game, pilot.flies(), pilot.pushes());
        }
        flight.end(&game);
        flight.steps = pilot.step();
        let left = &plan.steps[flight.steps.min(plan.steps.len())..];
        flight.pushes_left = left.iter().filter(|step| step.kind == StepKind::Push).count() as u32;
        flight.distance = pilot.distance(&Sight::of(&game));
        flight
    }

    /// Flies the keys of a record again, as long as there are any and the flight goes on.
    pub fn by_keys(level: &Arc<Level>, keys: &Inputs) -> Self {
        let mut game = new_game(level);
        let mut flight = Self::begun(&game);
        for controls in keys.clone() {
            if game.outcome() != Outcome::Running {
                break;
            }
            flight.inputs.record(controls);
            flight.last_speed = game.world().body(SHIP).velocity.length();
            game.step(controls);
            // What its plan meant to do in a tick is not known.
            flight.watch(&game, false, true);
        }
        flight.end(&game);
        flight
    }

    /// A flight of which nothing is flown yet.
    fn begun(game: &Game) -> Self {
        Self {
            inputs: Inputs::default(),
            result: game.result(),
            ticks: 0,
            rows: 0,
            steps: 0,
            distance: 0.0,
            pushes_left: 0,
            red: f64::INFINITY,
            near_walls: 0,
            bumps: 0,
            knocks: 0,
            hardest_push: 0.0,
            hardest_landing: 0.0,
            aside: 0.0,
            last_speed: 0.0,
            given_up: false,
        }
    }

    /// Takes up what the flight has come to at its end.
    fn end(&mut self, game: &Game) {
        let ship = game.world().body(SHIP).bounds();
        let wanted = game.level().objectives.iter().filter(|objective| objective.kind == ObjectiveKind::Player);
        let shared = wanted.map(|objective| ship.max.x.min(objective.bounds.max.x) - ship.min.x.max(objective.bounds.min.x));
        self.aside = shared.fold(0.0, |aside: f64, shared| aside.max(1.0 - shared / (2.0 * SHIP_HALF.x)));
        // A press that waits for a crate is meant.
        self.given_up = Guards { islands_grown: 0, surfaces_stopped: 0, ..*game.world().guards() } != Guards::default();
        self.result = game.result();
        self.ticks = game.ticks();
        self.rows = self.inputs.to_string().lines().count() - 1;
    }

    fn watch(&mut self, game: &Game, flies: bool, pushes: bool) {
        let (level, ship) = (game.level(), game.world().body(SHIP).bounds());
        for deadly in &level.obstacles {
            self.red = self.red.min((deadly.min - ship.max).max(ship.min - deadly.max).max_element());
        }
        // The ground below is no wall.
        let near = Aabb::new(ship.min - OFF_WALLS, ship.max + DVec2::new(OFF_WALLS, -OFF_WALLS));
        self.near_walls += u32::from(flies && level.world.iter().any(|solid| near.touches(&solid.bounds, 0.0)));
        for event in game.world().events() {
            let &Event::Impact { a, b, speed, .. } = event else { continue };
            match b {
                Obstacle::Body(b) if a == SHIP || b == SHIP => {
                    self.hardest_push = self.hardest_push.max(speed);
                    self.knocks += u32::from(!pushes && speed > GENTLE.bump);
                }
                Obstacle::Surface(_) if a == SHIP => {
                    self.hardest_landing = self.hardest_landing.max(speed);
                    self.bumps += u32::from(flies && speed > GENTLE.bump);
                }
                _ => {}
            }
        }
    }

    /// What the flight is worth for its aim. Below 0 where the level was not completed.
    pub fn worth(&self, aim: Aim, level: &Level) -> f64 {
        if self.result.outcome != Outcome::Completed {
            let died = f64::from(u8::from(self.result.outcome == Outcome::Failed));
            return 1e3 * self.steps as f64 - 10.0 * self.distance.min(90.0) - 200.0 * died - 1e6;
        }
        let result = &self.result;
        let clean = 1e5 - 2e3 * f64::from(result.collisions) - 5e3 * f64::from(u8::from(self.given_up));
        match (aim, level.awards.mark) {
            (Aim::Careful, _) | (Aim::Mark, None) => {
                // Care that is enough for gold is no care.
                let hasty = level.awards.gold.map_or(0.0, |gold| (CARE_BEYOND_GOLD * gold - result.time).max(0.0));
                self.worth_of_care() - 1e3 * hasty
            }
            // A second is worth more than a few rows.
            (Aim::Gold, _) => clean - 1e3 * result.time - self.rows as f64 - 5e4 * f64::from(u8::from(self.earns_mark(level))),
            (Aim::Mark, Some(Mark::Hits(_))) => clean - 10.0 * result.time,
            (Aim::Mark, Some(Mark::Fuel(_))) => clean + 1e4 * result.fuel - 10.0 * result.time,
            (Aim::Mark, Some(Mark::Pushes(_))) => clean - 1e3 * f64::from(result.pushes) - 10.0 * result.time,
            (Aim::Mark, Some(Mark::Speed(_))) => clean - 1e3 * result.top_speed - 10.0 * result.time,
            (Aim::Mark, Some(Mark::Burns(_))) => clean - 1e3 * f64::from(result.burns) - 10.0 * result.time,
            (Aim::Mark, Some(Mark::Together(..))) => clean - 1e3 * result.together - 10.0 * result.time,
            (Aim::Mark, Some(Mark::Stars)) => clean - 1e4 * result.stars_left as f64 - 10.0 * result.time,
        }
    }

    /// The game's points, less what makes it a worse example.
    fn worth_of_care(&self) -> f64 {
        self.result.score.total as f64
            - 5.0 * self.rows as f64
            - 2e3 * f64::from(self.result.collisions)
            - 2e3 * (OFF_RED - self.red).max(0.0)
            - 5.0 * f64::from(self.near_walls)
            - 200.0 * f64::from(self.bumps)
            - 600.0 * f64::from(self.knocks)
            - 400.0 * (self.hardest_push - GENTLE.push).max(0.0)
            - 400.0 * (self.hardest_landing - GENTLE.landing).max(0.0)
            - 800.0 * (self.last_speed - GENTLE.landing).max(0.0)
            - 300.0 * f64::from(self.pushes_left)
            - 3e3 * self.aside
    }

    fn earns_mark(&self, level: &Level) -> bool {
        Medals::of(&level.awards, &self.result).mark
    }

    /// What keeps it from being recorded; `None` where nothing does.
    pub fn lacks(&self, aim: Aim, level: &Level, par: f64) -> Option<String> {
        let (result, awards) = (&self.result, &level.awards);
        if result.outcome != Outcome::Completed || result.collisions > 0 {
            return Some(format!("{} with {} damaging hits", result.outcome.name(), result.collisions));
        }
        if self.given_up {
            return Some("the engine had to give something up".to_owned());
        }
        let time = result.time;
        if aim != Aim::Mark && self.earns_mark(level) {
            return Some("it earns the level's mark, too".to_owned());
        }
        match (aim, awards.gold) {
            (Aim::Careful, _) if time > par => Some(format!("{time:.3} s, its par is {par} s")),
            (Aim::Careful, _) if self.red < OFF_RED - 0.1 => Some(format!("{:.2} m off red", self.red)),
            (Aim::Careful, Some(gold)) if time <= gold => Some(format!("{time:.3} s, which is gold ({gold} s)")),
            (Aim::Careful, _) => None,
            (Aim::Gold, None) => Some(format!("{time:.3} s; the level says no time for gold")),
            (Aim::Gold, Some(gold)) if time > gold => Some(format!("{time:.3} s, gold is {gold} s")),
            (Aim::Gold, Some(gold)) if time < SPARE_FOR_GOLD * gold => {
                Some(format!("{time:.3} s: gold should be at most {:.2} s, it is {gold} s", time / SPARE_FOR_GOLD))
            }
            (Aim::Gold, Some(_)) => None,
            (Aim::Mark, _) => {
                let mark = awards.mark.map_or("none".to_owned(), resultant::game::words);
                (!self.earns_mark(level)).then(|| format!("the level's mark: {mark}"))
            }
        }
    }
}

/// The recorded flight for gold takes at least this share of the time for gold: gold needs a good line.
pub const SPARE_FOR_GOLD: f64 = 0.9;

/// Changes a quantity of a level by a share of itself, the start by metres.
pub type Change = fn(&mut Level, f64);

/// What is changed to see how much a recorded flight bears.
pub const CHANGES: [(&str, Change); 6] = [
    ("mass", |level, by| level.player.mass *= 1.0 + by),
    ("thrust", |level, by| level.player.thrust *= 1.0 + by),
    ("gravity", |level, by| level.gravity *= 1.0 + by),
    ("air", |level, by| level.air_density *= 1.0 + by),
    ("objects' mass", |level, by| level.objects.iter_mut().for_each(|object| object.mass *= 1.0 + by)),
    ("start", |level, by| level.player.position.x += by),
];

/// What became of the keys of a flight in a level that was changed a little.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Again {
    /// It was completed in the same tick.
    Same,
    /// It was completed in another tick.
    Completed,
    /// It was not, or not without damage.
    Lost,
}

/// Flies the keys again with one quantity changed.
pub fn again(level: &Level, inputs: &Inputs, change: Change, by: f64) -> Again {
    let mut level = level.clone();
    change(&mut level, by);
    let mut game = new_game(&Arc::new(level));
    inputs.clone().into_iter().for_each(|controls| game.step(controls));
    let ticks = game.ticks();
    // A flight that comes a little late.
    (0..(TICK_RATE as u32)).for_each(|_| game.step(Controls::default()));
    match (game.outcome(), game.collisions()) {
        (Outcome::Completed, 0) if game.ticks() == ticks && ticks == inputs.ticks() => Again::Same,
        (Outcome::Completed, 0) => Again::Completed,
        _ => Again::Lost,
    }
}

/// Whether the keys bear all changes by `same`, to the tick, and all by `late`, more or less.
pub fn bears(level: &Level, inputs: &Inputs, same: f64, late: f64) -> bool {
    let worst = |by: f64| CHANGES.iter().flat_map(move |&(_, change)| [by, -by].map(|by| again(level, inputs, change, by)));
    worst(same).all(|again| again == Again::Same) && worst(late).all(|again| again != Again::Lost)
}

/// A fresh attempt.
pub fn new_game(level: &Arc<Level>) -> Game {
    Game::new(Arc::clone(level)).unwrap_or_else(|error| panic!("level {}: {error}", level.name))
}
