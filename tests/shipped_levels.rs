//! The levels that ship, each flown to its end by its recorded inputs.

use resultant::game::{Game, Inputs, Outcome, SHIP};
use resultant::level::{self, Level};
use resultant::physics::{Aabb, Body, World};
use std::path::Path;
use std::sync::Arc;

/// How far two solids may ever overlap, m.
const OVERLAP: f64 = 1e-3;
/// How near the ship has to be at the end to what it came for, m; and how far it stays from what is deadly.
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
fn the_recorded_flight_of_level_1_keeps_off_red() {
    let obstacles = load("1").obstacles.clone();
    fly("1", |game| {
        let ship = game.world().body(SHIP).bounds();
        let near = Aabb::new(ship.min - CLEARANCE, ship.max + CLEARANCE);
        assert!(!obstacles.iter().any(|deadly| near.touches(deadly, 0.0)), "tick {}: {ship:?}", game.ticks());
    });
}
