//! The levels that ship, each flown to its end by every flight that is recorded in its folder.

use crate::support::adversary;
use crate::support::shipped::{flights, levels, load, project};
use resultant::game::{BURN_RATE, Controls, Game, Medal, Medals, Outcome, PROGRAM, Replay, SHIP, TICK_RATE};
use resultant::level::{self, Level, ObjectiveKind, SHIP_HALF};
use resultant::physics::{Aabb, Body, DVec2, Guards, World};
use std::path::Path;
use std::sync::Arc;

/// How far two solids may ever overlap, m.
const OVERLAP: f64 = 1e-3;
/// Clearance of the recorded flights from deadly things, m.
const CLEARANCE: f64 = 0.3;

/// How long the adversary plays each level, s of its time.
const HUNT: f64 = 120.0;
/// The adversary must find this: in level 3 a ship that flies into the chamber stays there.
const KNOWN: [(&str, adversary::Kind); 1] = [("3", adversary::Kind::Trapped)];

/// Flies a level by a record; `each_tick` sees the game after every tick.
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
        // An open door is not there.
        let solid = world.surfaces().iter().filter(|surface| surface.present);
        let others = bodies[..i].iter().map(Body::bounds).chain(solid.map(|surface| surface.bounds));
        for other in others {
            let deep = overlap(&body.bounds(), &other);
            assert!(deep <= OVERLAP, "tick {tick}: body {i} is {deep} m inside {other:?}");
        }
    }
}

fn assert_flown(level: &Arc<Level>, replay: &Replay) -> Game {
    let Replay { program, level: name, level_hash, outcome, time, seconds, inputs, .. } = replay;
    assert_eq!((program.as_deref(), name, *level_hash), (Some(PROGRAM), &level.name, Some(resultant::game::level_hash(level))));
    replay.verify(Arc::clone(level), |_| {}).unwrap().unwrap_or_else(|mismatch| panic!("level {name}: {mismatch}"));
    let game = fly(level, replay, |game| assert_sound(game.world(), game.ticks()));
    let result = game.result();
    assert_eq!((*outcome, result.outcome), (Some(Outcome::Completed), Outcome::Completed), "level {name}: {result:?}");
    assert_eq!((*time, seconds.len()), (Some(result.time), result.time as usize), "level {name}");
    assert_eq!(game.ticks(), inputs.ticks(), "level {name}: the record ends with the flight");
    let given_up = Guards { islands_grown: 0, ..*game.world().guards() };
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
                "mark" => assert!(medals.mark, "level {name}: {:?}, {result:?}", level.awards.mark),
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
    for name in levels() {
        let report = adversary::hunt(&load(&name), HUNT, 1);
        let known = |finding: &&adversary::Finding| KNOWN.iter().any(|(level, kind)| *level == name && *kind == finding.kind);
        let news: Vec<_> = report.findings.iter().filter(|finding| !known(finding)).collect();
        assert!(news.is_empty(), "level {name}: {report}");
        assert!(report.attempts > 0 && report.seconds >= HUNT);
    }
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

#[test]
fn the_list_of_what_comes_with_the_game_names_every_level_and_experiment() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (folder, count) in [("levels", 15), ("experiments", 12)] {
        let names = level::list(&root.join(folder));
        assert!(names.iter().all(|name| level::is_shipped(&root.join(folder).join(name))), "{names:?}");
        let list =
            std::fs::read_to_string(root.join(folder).join(if folder == "levels" { "shipped.csv" } else { "experiments.csv" }));
        let listed = list.unwrap().lines().filter(|line| !line.starts_with('#')).count() - 1;
        assert_eq!((names.len(), listed), (count, count), "{folder}");
    }
    assert!(!level::is_shipped(&root.join("tests")) && !level::is_shipped(&root.join("levels/none")));
}
