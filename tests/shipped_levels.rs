//! The levels that ship, each flown to its end by its recorded inputs.

use resultant::game::{BURN_RATE, Controls, Game, Inputs, Outcome, SHIP, TICK_RATE};
use resultant::level::{self, Level, ObjectiveKind, SHIP_HALF};
use resultant::physics::{Aabb, Body, DVec2, Guards, World};
use std::path::Path;
use std::sync::Arc;

/// How far two solids may ever overlap, m.
const OVERLAP: f64 = 1e-3;
/// How far the recorded flights stay from what is deadly, m.
const CLEARANCE: f64 = 0.3;

fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn load(name: &str) -> Arc<Level> {
    let loaded = level::load(&project().join("levels").join(name), project());
    let loaded = loaded.unwrap_or_else(|problems| panic!("level {name}: {problems:?}"));
    assert!(loaded.warnings.is_empty(), "level {name}: {:?}", loaded.warnings);
    Arc::new(loaded.level)
}

fn inputs(name: &str) -> Inputs {
    let file = format!("tests/inputs/{name}.csv");
    let text = std::fs::read_to_string(project().join(&file)).unwrap();
    Inputs::parse(&file, &text).unwrap()
}

/// Flies a level by its recorded inputs; `each_tick` sees the game after every tick.
fn fly(name: &str, mut each_tick: impl FnMut(&Game)) -> Game {
    let mut game = Game::new(load(name)).unwrap();
    for controls in inputs(name) {
        game.step(controls);
        each_tick(&game);
    }
    game
}

/// How far two boxes overlap, m; less than 0 where there is a gap.
fn overlap(a: &Aabb, b: &Aabb) -> f64 {
    (a.max.min(b.max) - a.min.max(b.min)).min_element()
}

/// Nothing is inside of anything else, and every number is one.
fn assert_sound(world: &World, tick: u64) {
    let bodies = world.bodies();
    for (i, body) in bodies.iter().enumerate() {
        let Body { position, velocity, acceleration, .. } = *body;
        assert!(position.is_finite() && velocity.is_finite() && acceleration.is_finite(), "tick {tick}: body {i} is at {position}");
        let others = bodies[..i].iter().map(Body::bounds).chain(world.surfaces().iter().map(|surface| surface.bounds));
        for other in others {
            let deep = overlap(&body.bounds(), &other);
            assert!(deep <= OVERLAP, "tick {tick}: body {i} is {deep} m inside {other:?}");
        }
    }
}

/// The recorded flight completes the level, cleanly, with no fault of the physics on the way.
fn assert_flown(name: &str) {
    let game = fly(name, |game| assert_sound(game.world(), game.ticks()));
    let result = game.result();
    assert_eq!(result.outcome, Outcome::Completed, "level {name}: {result:?}");
    assert_eq!(result.collisions, 0, "level {name}");
    assert!(result.score.total > 10_000, "level {name}: {:?}", result.score);
    assert!(result.time < result.optimal_time, "level {name}: {} s", result.time);
    assert_eq!(game.ticks(), inputs(name).ticks(), "level {name}: the record ends with the flight");
    let given_up = Guards { islands_grown: 0, ..*game.world().guards() };
    assert_eq!(given_up, Guards::default(), "level {name}: nothing had to be given up");
}

#[test]
fn level_1_is_flown_cleanly() {
    assert_flown("1");
}

#[test]
fn level_2_is_flown_cleanly() {
    assert_flown("2");
}

#[test]
fn level_3_is_flown_cleanly() {
    assert_flown("3");
}

#[test]
fn level_4_is_flown_cleanly() {
    assert_flown("4");
}

#[test]
fn level_5_is_flown_cleanly() {
    assert_flown("5");
}

#[test]
fn level_6_is_flown_cleanly() {
    assert_flown("6");
}

#[test]
fn level_7_is_flown_cleanly() {
    assert_flown("7");
}

#[test]
fn level_8_is_flown_cleanly() {
    assert_flown("8");
}

#[test]
fn level_9_is_flown_cleanly() {
    assert_flown("9");
}

#[test]
fn level_10_is_flown_cleanly() {
    assert_flown("10");
}

#[test]
fn the_recorded_flight_of_level_1_keeps_off_red() {
    let obstacles = load("1").obstacles.clone();
    fly("1", |game| {
        let ship = game.world().body(SHIP).bounds();
        let near = Aabb::new(ship.min - CLEARANCE, ship.max + CLEARANCE);
        assert!(!obstacles.iter().any(|deadly| near.touches(deadly, 0.0)), "tick {}: {ship:?}", game.ticks());
    });
}

/// The level with the ship at another place, flown with the same keys held until the tank is empty and everything is at rest.
fn hold(mut level: Level, position: DVec2, angle: f64, controls: Controls, mut each_tick: impl FnMut(&Game)) -> Game {
    (level.player.position, level.player.angle) = (position, angle);
    let seconds = level.player.fuel / BURN_RATE + 5.0;
    let mut game = Game::new(Arc::new(level)).unwrap();
    for _ in 0..(seconds * TICK_RATE) as u32 {
        game.step(controls);
        each_tick(&game);
    }
    game
}

#[test]
fn a_careless_climb_of_level_2_hits_the_roof() {
    let level = Level::clone(&load("2"));
    let start = level.player.position;
    let game = hold(level, start, 0.0, Controls { thrust: true, ..Controls::default() }, |_| {});
    assert!(game.collisions() > 0, "{:?}", game.result());
    assert_eq!(game.outcome(), Outcome::Running);
}

#[test]
fn the_wind_of_level_3_carries_the_ship_to_the_top_without_its_engine() {
    let level = Level::clone(&load("3"));
    let floor = level.streams[0].zone.max.y - SHIP_HALF.y;
    let start = DVec2::new(level.streams[0].zone.centre().x, floor);
    let player = level.objectives.iter().position(|objective| objective.kind == ObjectiveKind::Player).unwrap();
    let mut met = false;
    hold(level, start, 0.0, Controls::default(), |game| met |= game.met()[player]);
    assert!(met, "the ship never got there");
}

#[test]
fn the_chamber_of_level_3_lets_no_ship_out_again() {
    let level = load("3");
    let zone = level.streams[1].zone;
    let start = DVec2::new(zone.centre().x, zone.max.y - SHIP_HALF.y);
    for angle in (-180..180).step_by(15) {
        for (thrust, reverse) in [(true, false), (false, true)] {
            let controls = Controls { thrust, reverse, ..Controls::default() };
            let game = hold(Level::clone(&level), start, f64::from(angle), controls, |_| {});
            assert_eq!(game.world().body(SHIP).position, start, "{angle} degrees, {controls:?}");
        }
    }
}
