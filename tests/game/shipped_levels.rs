//! The levels that ship, each flown to its end by every flight that is recorded in its folder.

use crate::support::adversary;
use crate::support::shipped::{fixture, flights, levels, load, project};
use resultant::files;
use resultant::game::{Game, Medal, Medals, Outcome, PROGRAM, Replay, SHIP, TICK_RATE};
use resultant::level::{self, Level};
use resultant::physics::{Aabb, Body, Guards, Sides, World};
use std::path::Path;
use std::sync::Arc;

/// How far two solids may ever overlap, m.
const OVERLAP: f64 = 1e-3;
/// Clearance of the recorded flights from deadly things, m.
const CLEARANCE: f64 = 0.3;

/// How long the adversary plays each level, s of its time.
const HUNT: f64 = 120.0;
/// The adversary must find this: in the fixture 3 a ship that flies into the chamber stays there.
const KNOWN: (&str, adversary::Kind) = ("Two winds", adversary::Kind::Trapped);

fn fly(level: &Arc<Level>, replay: &Replay, mut each_tick: impl FnMut(&Game)) -> Game {
    let mut game = Game::new(Arc::clone(level)).unwrap();
    for controls in replay.inputs.clone() {
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
        // An open door is not there, and a platform of one side is passed through.
        let solid = world.surfaces().iter().filter(|surface| surface.present && surface.sides() == Sides::ALL);
        let others = bodies[..i].iter().map(Body::bounds).chain(solid.map(|surface| surface.bounds));
        for other in others {
            let deep = overlap(&body.bounds(), &other);
            assert!(deep <= OVERLAP, "tick {tick}: body {i} is {deep} m inside {other:?}");
        }
    }
}

fn assert_flown(level: &Arc<Level>, replay: &Replay) -> Game {
    let Replay { program, level: name, level_hash, outcome, time, seconds, inputs, .. } = replay;
    assert_eq!((program.as_str(), name, *level_hash), (PROGRAM, &level.name, resultant::game::level_hash(level)));
    replay.verify(Arc::clone(level), |_| {}).unwrap().unwrap_or_else(|mismatch| panic!("level {name}: {mismatch}"));
    let game = fly(level, replay, |game| assert_sound(game.world(), game.ticks()));
    let result = game.result();
    assert_eq!((*outcome, result.outcome), (Outcome::Completed, Outcome::Completed), "level {name}: {result:?}");
    // Seconds count from the start, the time from the first key.
    assert_eq!((*time, seconds.len()), (result.time, (inputs.ticks() as f64 / TICK_RATE) as usize), "level {name}");
    assert_eq!(game.ticks(), inputs.ticks(), "level {name}: the record ends with the flight");
    // A press that waits for a crate is meant.
    let given_up = Guards { islands_grown: 0, surfaces_stopped: 0, ..*game.world().guards() };
    assert_eq!(given_up, Guards::default(), "level {name}: nothing had to be given up");
    game
}

#[test]
fn every_flight_that_is_recorded_shows_what_it_is_named_for() {
    for name in levels() {
        let (level, flights) = (load(&name), flights(&name));
        for wanted in ["careful", "gold", "mark"] {
            assert!(flights.contains_key(wanted), "level {name} has no {wanted} flight");
        }
        let gold = level.awards.gold.unwrap_or_else(|| panic!("level {name} has no gold"));
        assert!(level.awards.silver.is_some() && level.awards.mark.is_some(), "level {name}: {:?}", level.awards);
        for (flight, replay) in &flights {
            let result = assert_flown(&level, replay).result();
            let medals = Medals::of(&level.awards, &result);
            assert_eq!(medals.mark, flight == "mark", "level {name}, {flight}: {:?}, {result:?}", level.awards.mark);
            match flight.as_str() {
                "careful" => {
                    assert_eq!(result.collisions, 0, "level {name}");
                    assert!(result.score.total > 10_000 && result.time < result.optimal_time, "level {name}: {result:?}");
                    assert!(medals.medal < Some(Medal::Gold), "level {name}: care is enough for gold, {} s", result.time);
                }
                "gold" => {
                    assert_eq!(medals.medal, Some(Medal::Gold), "level {name}: {} s", result.time);
                    assert!(result.time >= 0.9 * gold, "level {name}: gold needs no good line, {} s of {gold} s", result.time);
                }
                _ => {}
            }
        }
    }
}

#[test]
fn the_inputs_that_people_can_read_are_those_of_the_careful_flights() {
    for name in levels() {
        let text = std::fs::read_to_string(project().join(format!("tests/inputs/{name}.csv"))).unwrap();
        assert_eq!(text, flights(&name)["careful"].inputs.to_string(), "level {name}");
    }
}

#[test]
fn the_careful_flights_keep_off_red() {
    for name in levels() {
        let (level, flights) = (load(&name), flights(&name));
        fly(&level, &flights["careful"], |game| {
            let ship = game.world().body(SHIP).bounds();
            let near = Aabb::new(ship.min - CLEARANCE, ship.max + CLEARANCE);
            let touched = level.obstacles.iter().any(|deadly| near.touches(deadly, 0.0));
            assert!(!touched, "level {name}, tick {}: {ship:?}", game.ticks());
        });
    }
}

/// A short hunt of the autopilot's adversary, of which `tools/autopilot` makes long ones.
#[test]
fn the_adversary_finds_what_is_known_and_nothing_else() {
    for level in levels().iter().map(|name| load(name)).chain([fixture("3")]) {
        let report = adversary::hunt(&level, HUNT, 1);
        let known = |finding: &adversary::Finding| level.title == KNOWN.0 && finding.kind == KNOWN.1;
        assert!(report.findings.iter().all(known), "level {}: {report}", level.name);
        assert!(report.attempts > 0 && report.seconds >= HUNT);
        assert_eq!(report.findings.iter().any(known), level.title == KNOWN.0, "level {}: {report}", level.name);
    }
}

#[test]
fn the_list_of_what_comes_with_the_game_names_every_level_and_experiment() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (folder, list) in [("levels", "shipped.csv"), (files::EXPERIMENTS, "experiments.csv")] {
        let names = level::list(&root.join(folder));
        assert!(names.iter().all(|name| level::is_shipped(&root.join(folder).join(name))), "{names:?}");
        let list = std::fs::read_to_string(root.join(folder).join(list)).unwrap();
        let listed = list.lines().filter(|line| !line.starts_with('#')).count() - 1;
        assert_eq!(names.len(), listed, "{folder}");
    }
    assert!(!level::is_shipped(&root.join("tests")) && !level::is_shipped(&root.join("levels/none")));
}
