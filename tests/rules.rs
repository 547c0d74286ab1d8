//! The rules of one attempt: controls, fuel, objectives, death boxes, figures.

mod support;

use resultant::game::{BURN_RATE, Controls, Game, GameError, GameEvent, Outcome, ROTATION_RATE, SHIP, TICK_RATE};
use resultant::level::{Level, Objective, ObjectiveKind};
use resultant::physics::DVec2;
use std::sync::Arc;
use support::rooms::{area, crate_at, objective, room};

const NONE: Controls = Controls { thrust: false, reverse: false, left: false, right: false };
const THRUST: Controls = Controls { thrust: true, ..NONE };
const REVERSE: Controls = Controls { reverse: true, ..NONE };
const LEFT: Controls = Controls { left: true, ..NONE };
const RIGHT: Controls = Controls { right: true, ..NONE };

fn start(level: Level) -> Game {
    Game::new(Arc::new(level)).expect("the level can be played")
}

fn fly(game: &mut Game, controls: Controls, ticks: u32) {
    for _ in 0..ticks {
        game.step(controls);
    }
}

/// The room with the ship moving.
fn moving(x: f64, y: f64) -> Level {
    let mut level = room();
    level.player.velocity = DVec2::new(x, y);
    level
}

// Controls and fuel

#[test]
fn rotation_is_a_rate_and_moves_nothing() {
    for tick_rate in [30.0, 60.0, 120.0, 144.0] {
        let mut game = Game::with_tick_rate(Arc::new(room()), tick_rate).unwrap();
        fly(&mut game, RIGHT, tick_rate as u32 / 2);
        assert_eq!(game.ship().angle, ROTATION_RATE / 2.0, "{tick_rate} ticks a second");
        fly(&mut game, LEFT, tick_rate as u32);
        assert_eq!(game.ship().angle, -ROTATION_RATE / 2.0, "{tick_rate} ticks a second");
        assert_eq!(game.world().body(SHIP).position, DVec2::splat(50.0));
        assert_eq!(game.world().body(SHIP).velocity, DVec2::ZERO);
    }
}

#[test]
fn left_and_right_cancel_and_the_last_angle_is_remembered() {
    let mut game = start(room());
    fly(&mut game, RIGHT, 2);
    let step = ROTATION_RATE / TICK_RATE;
    assert_eq!((game.ship().previous_angle, game.ship().angle), (step, 2.0 * step));
    fly(&mut game, Controls { left: true, ..RIGHT }, 1);
    assert_eq!((game.ship().previous_angle, game.ship().angle), (2.0 * step, 2.0 * step));
}

#[test]
fn thrust_goes_along_the_nose_and_reverse_against_it() {
    let diagonal = 2000.0 * std::f64::consts::FRAC_1_SQRT_2;
    for (angle, along) in [
        (0.0, DVec2::new(0.0, -2000.0)),
        (45.0, DVec2::new(diagonal, -diagonal)),
        (90.0, DVec2::new(2000.0, 0.0)),
        (180.0, DVec2::new(0.0, 2000.0)),
        (-90.0, DVec2::new(-2000.0, 0.0)),
    ] {
        for (controls, sign) in [(THRUST, 1.0), (REVERSE, -1.0)] {
            let mut level = room();
            level.player.angle = angle;
            let mut game = start(level);
            game.step(controls);
            let acceleration = game.world().body(SHIP).acceleration;
            assert!(acceleration.distance(along * (sign / 100.0)) < 1e-12, "{angle} degrees: {acceleration}");
            assert_eq!(f64::from(game.ship().burning), sign);
        }
    }
}

#[test]
fn thrust_and_reverse_cancel_and_burn_nothing() {
    let mut game = start(room());
    fly(&mut game, Controls { reverse: true, ..THRUST }, 60);
    assert_eq!((game.ship().fuel, game.ship().burning), (500.0, 0));
    assert_eq!(game.world().body(SHIP).velocity, DVec2::ZERO);
}

#[test]
fn fuel_burns_at_a_steady_rate_whatever_the_tick() {
    for tick_rate in [30.0, 60.0, 120.0, 144.0] {
        for controls in [THRUST, REVERSE] {
            let mut game = Game::with_tick_rate(Arc::new(room()), tick_rate).unwrap();
            fly(&mut game, controls, tick_rate as u32);
            fly(&mut game, NONE, 10);
            assert_eq!(game.ship().fuel, 500.0 - BURN_RATE, "{tick_rate} ticks a second");
            assert_eq!(game.fuel(), (500.0 - BURN_RATE) / 500.0);
        }
    }
}

#[test]
fn without_fuel_there_is_no_thrust() {
    let mut level = room();
    level.player.fuel = 2.5 * BURN_RATE / TICK_RATE;
    let mut game = start(level);
    fly(&mut game, THRUST, 2);
    assert!(game.ship().fuel > 0.0);
    game.step(THRUST);
    assert_eq!((game.ship().fuel, game.ship().burning), (0.0, 1), "the last tick burns what is left");
    let fastest = game.world().body(SHIP).velocity;
    fly(&mut game, THRUST, 10);
    assert_eq!((game.ship().fuel, game.ship().burning), (0.0, 0));
    assert_eq!(game.world().body(SHIP).velocity, fastest);
    assert_eq!((game.fuel(), game.result().fuel_used), (0.0, 2.5 * BURN_RATE / TICK_RATE));
}

#[test]
fn a_tank_that_never_held_anything_is_empty() {
    let mut level = room();
    level.player.fuel = 0.0;
    let mut game = start(level);
    fly(&mut game, THRUST, 10);
    assert_eq!(game.world().body(SHIP).velocity, DVec2::ZERO);
    assert_eq!(game.fuel(), 0.0);
}

// Objectives

#[test]
fn a_player_objective_is_met_while_the_ship_touches_it() {
    let mut level = moving(12.0, 0.0);
    level.objectives = vec![
        objective(ObjectiveKind::Player, area(52.0, 49.0, 53.0, 51.0)),
        objective(ObjectiveKind::Player, area(0.0, 0.0, 1.0, 1.0)),
    ];
    let mut game = start(level);
    let mut changes = Vec::new();
    for tick in 1..=60 {
        game.step(NONE);
        changes.extend(game.events().iter().map(|event| (tick, event.clone())));
        let x = game.world().body(SHIP).position.x;
        assert_eq!(game.met()[0], x + 0.85 >= 52.0 - 1e-9 && x - 0.85 <= 53.0 + 1e-9, "at {x} m");
    }
    // It moves 0.1 m a tick: touching from 51.15 m on, until 53.85 m.
    assert_eq!(changes, [(12, GameEvent::ObjectiveMet(0)), (39, GameEvent::ObjectiveLost(0))]);
    assert_eq!(game.outcome(), Outcome::Running);
}

#[test]
fn touching_an_objective_is_enough_and_a_micrometre_is_not() {
    for (left, met) in [(50.85, true), (50.85 + 1e-6, false)] {
        let mut level = room();
        level.objectives = vec![objective(ObjectiveKind::Player, area(left, 50.0, 60.0, 51.0))];
        let mut game = start(level);
        assert_eq!(game.met(), [met], "before the first tick");
        assert_eq!(game.outcome(), Outcome::Running, "an attempt takes a tick at least");
        game.step(NONE);
        assert_eq!(game.outcome() == Outcome::Completed, met);
    }
}

#[test]
fn a_physics_objective_waits_for_a_key_object() {
    let block = area(10.0, 10.0, 11.0, 11.0);
    for (key, met) in [(None, false), (Some([255, 0, 255]), true)] {
        let mut level = room();
        level.objectives = vec![objective(ObjectiveKind::Physics, block)];
        level.objects = vec![
            crate_at(DVec2::new(80.0, 80.0), DVec2::ZERO, Some([0, 255, 0])),
            crate_at(DVec2::new(10.5, 9.5), DVec2::ZERO, key),
        ];
        let mut game = start(level);
        game.step(NONE);
        assert_eq!(game.met(), [met], "key {key:?}");
    }
    let mut level = room();
    level.objectives = vec![objective(ObjectiveKind::Physics, area(49.0, 49.0, 51.0, 51.0))];
    let mut game = start(level);
    game.step(NONE);
    assert_eq!(game.met(), [false], "the ship is no key object");
}

#[test]
fn a_hold_wants_the_ship_for_so_long_without_a_break() {
    let pad = || Objective { hold: 0.5, ..objective(ObjectiveKind::Player, area(49.0, 50.85, 51.0, 51.0)) };
    for tick_rate in [30.0, 60.0, 120.0, 144.0] {
        let level = Level { objectives: vec![pad()], ..room() };
        let mut game = Game::with_tick_rate(Arc::new(level), tick_rate).unwrap();
        assert_eq!((game.met(), game.held(0)), (&[false][..], 0.0));
        let half = (tick_rate / 2.0) as u32;
        fly(&mut game, NONE, half - 1);
        assert_eq!(game.outcome(), Outcome::Running);
        assert!((game.held(0) - f64::from(half - 1) / f64::from(half)).abs() < 1e-12);
        fly(&mut game, NONE, 1);
        assert_eq!((game.outcome(), game.held(0)), (Outcome::Completed, 1.0), "{tick_rate} ticks a second");
    }
    // Flying through is no landing: 2.7 m at 12 m/s take 0.225 s.
    let through = Objective { hold: 0.25, ..objective(ObjectiveKind::Player, area(52.0, 49.0, 53.0, 51.0)) };
    let mut game = start(Level { objectives: vec![through], ..moving(12.0, 0.0) });
    let mut most = 0.0f64;
    for _ in 0..60 {
        game.step(NONE);
        most = most.max(game.held(0));
        assert_eq!(game.met(), [false]);
    }
    assert!(most > 0.8 && game.held(0) == 0.0, "once it has left, nothing is held: {most}");
}

#[test]
fn what_is_held_is_part_of_the_state() {
    let level = |hold| {
        let pad = Objective { hold, ..objective(ObjectiveKind::Player, area(49.0, 50.85, 51.0, 51.0)) };
        Level { objectives: vec![pad, objective(ObjectiveKind::Player, area(0.0, 0.0, 1.0, 1.0))], ..room() }
    };
    let mut games = [start(level(5.0)), start(level(5.0))];
    games.iter_mut().for_each(|game| fly(game, NONE, 10));
    assert_eq!(games[0].hash(), games[1].hash());
    games[0].step(NONE);
    assert_ne!(games[0].hash(), games[1].hash());
}

#[test]
fn turns_are_taken_in_order_and_kept() {
    // From 50 m to the right: the first lies behind the second, so that the second is passed in vain at first.
    let gate = |order, x: f64| Objective { order: Some(order), ..objective(ObjectiveKind::Player, area(x, 49.0, x + 1.0, 51.0)) };
    let level = Level { objectives: vec![gate(2, 53.0), gate(1, 58.0), gate(2, 62.0)], ..moving(12.0, 0.0) };
    let mut game = start(level);
    assert_eq!([0, 1, 2].map(|index| game.is_open(index)), [false, true, false]);
    let mut met = Vec::new();
    for _ in 0..180 {
        game.step(NONE);
        met.extend(game.events().iter().filter_map(|event| match event {
            GameEvent::ObjectiveMet(index) => Some(*index),
            GameEvent::ObjectiveLost(_) => panic!("what has had its turn stays met"),
            _ => None,
        }));
    }
    assert_eq!((met, game.met()), (vec![1, 2], &[false, true, true][..]));
}

#[test]
fn a_key_of_another_colour_does_not_fit() {
    for (colour, met) in [([255, 0, 255], true), ([255, 0, 254], false)] {
        let block = objective(ObjectiveKind::Physics, area(10.0, 10.0, 11.0, 11.0));
        let mut level = Level { objectives: vec![Objective { colour: Some(colour), ..block }], ..room() };
        level.objects = vec![crate_at(DVec2::new(10.5, 9.5), DVec2::ZERO, Some([255, 0, 255]))];
        let mut game = start(level);
        game.step(NONE);
        assert_eq!(game.met(), [met], "{colour:?}");
    }
}

#[test]
fn a_level_is_complete_when_all_are_met_at_once() {
    // The ship passes its objective before the key object reaches the other one, or while it is there.
    for (start_x, outcome) in [(12.0, Outcome::Running), (8.0, Outcome::Completed)] {
        let mut level = moving(12.0, 0.0);
        level.objectives = vec![
            objective(ObjectiveKind::Player, area(52.0, 49.0, 53.0, 51.0)),
            objective(ObjectiveKind::Physics, area(5.0, 10.0, 6.0, 11.0)),
        ];
        level.objects = vec![crate_at(DVec2::new(start_x, 10.5), DVec2::new(-6.0, 0.0), Some([255, 0, 255]))];
        let mut game = start(level);
        fly(&mut game, NONE, 120);
        assert_eq!(game.outcome(), outcome, "the key object starts at {start_x} m");
        if outcome == Outcome::Completed {
            assert!(game.events().is_empty(), "what happened is told once");
            assert_eq!((game.result().objectives_met, game.result().objectives_all), (2, 2));
        }
    }
}

// Death boxes

#[test]
fn a_death_box_ends_the_attempt_at_once_with_nothing() {
    let mut level = moving(12.0, 0.0);
    level.obstacles = vec![area(52.0, 49.0, 53.0, 51.0)];
    let mut game = start(level);
    fly(&mut game, NONE, 11);
    assert_eq!(game.outcome(), Outcome::Running);
    game.step(NONE);
    assert_eq!((game.outcome(), game.events()), (Outcome::Failed, &[GameEvent::Died][..]));
    assert_eq!((game.result().score.total, game.result().time), (0, 0.1));
}

#[test]
fn touching_is_lethal_and_a_micrometre_is_not() {
    for (left, outcome) in [(50.85, Outcome::Failed), (50.85 + 1e-6, Outcome::Running)] {
        let mut level = room();
        level.obstacles = vec![area(left, 50.0, 60.0, 51.0)];
        let mut game = start(level);
        game.step(NONE);
        assert_eq!(game.outcome(), outcome);
    }
}

#[test]
fn no_death_box_is_skipped_at_any_speed() {
    for speed in [100.0, 1_000.0, 4_000.0] {
        let mut level = moving(0.0, speed);
        level.player.position.y = 5.0;
        level.obstacles = vec![area(0.0, 30.0, 100.0, 30.001)];
        let mut game = start(level);
        let ticks = (40.0 / speed * TICK_RATE).ceil() as u32;
        fly(&mut game, NONE, ticks);
        assert_eq!(game.outcome(), Outcome::Failed, "{speed} m/s");
    }
}

#[test]
fn death_goes_before_completion() {
    let mut level = room();
    level.objectives = vec![objective(ObjectiveKind::Player, area(50.0, 50.0, 51.0, 51.0))];
    level.obstacles = vec![area(49.0, 49.0, 50.0, 50.0)];
    let mut game = start(level);
    game.step(NONE);
    assert_eq!((game.outcome(), game.met(), game.result().score.total), (Outcome::Failed, &[true][..], 0));
}

// The end

#[test]
fn after_the_end_nothing_changes() {
    let mut level = moving(3.0, 0.0);
    level.obstacles = vec![area(50.0, 50.0, 51.0, 51.0)];
    let mut game = start(level);
    game.step(NONE);
    let (hash, result) = (game.hash(), game.result());
    fly(&mut game, Controls { right: true, ..THRUST }, 100);
    assert_eq!((game.hash(), game.result(), game.ticks()), (hash, result, 1));
    assert!(game.events().is_empty());
}

#[test]
fn a_result_tells_the_flight() {
    let mut level = moving(3.0, 4.0);
    level.optimal_time = 2.0;
    level.objectives = vec![objective(ObjectiveKind::Player, area(49.0, 58.85, 60.0, 60.0))];
    let mut game = start(level);
    fly(&mut game, NONE, 239);
    assert_eq!(game.outcome(), Outcome::Running);
    assert_eq!(game.result().score.total, 0, "nothing is won before the end");
    game.step(NONE);
    let result = game.result();
    assert_eq!((result.outcome, result.level.as_str()), (Outcome::Completed, "room"));
    assert_eq!((result.time, result.optimal_time), (2.0, 2.0));
    assert_eq!((result.collisions, result.fuel, result.fuel_used), (0, 1.0, 0.0));
    assert!((result.distance - 10.0).abs() < 1e-9, "{} m", result.distance);
    assert_eq!((result.top_speed, result.peak_resultant), (5.0, 0.0));
    assert_eq!((result.score.base, result.score.time, result.score.fuel, result.score.total), (10_000, 0, 1_000, 11_000));
}

#[test]
fn a_push_begins_when_an_object_is_touched_that_was_not_for_half_a_second() {
    let mut level = moving(2.0, 0.0);
    level.player.angle = 90.0;
    level.objects = vec![crate_at(DVec2::new(51.6, 50.0), DVec2::ZERO, None), crate_at(DVec2::new(53.6, 50.0), DVec2::ZERO, None)];
    let mut game = start(level);
    let pushes = |game: &Game| game.result().pushes;
    assert_eq!(pushes(&game), 0);
    fly(&mut game, NONE, 30);
    assert_eq!(pushes(&game), 1, "it was met after an eighth of a second");
    fly(&mut game, THRUST, 60);
    assert_eq!(pushes(&game), 1, "pushing on is the same push, and what is pushed along pushes the next one itself");
    fly(&mut game, REVERSE, 6);
    fly(&mut game, NONE, 6);
    fly(&mut game, THRUST, 24);
    assert_eq!(pushes(&game), 1, "it was let go of too shortly");
    fly(&mut game, REVERSE, 12);
    fly(&mut game, NONE, 60);
    fly(&mut game, THRUST, 60);
    assert_eq!(pushes(&game), 2);
}

#[test]
fn top_speed_is_kept() {
    let mut game = start(moving(0.0, 1.0));
    fly(&mut game, THRUST, 12);
    fly(&mut game, REVERSE, 6);
    // 20 m/s² against 1 m/s for a tenth of a second, and half of that back.
    assert!((game.result().top_speed - 1.0).abs() < 1e-12, "{} m/s", game.result().top_speed);
    fly(&mut game, THRUST, 24);
    assert!((game.result().top_speed - 4.0).abs() < 1e-12, "{} m/s", game.result().top_speed);
}

#[test]
fn absurd_tick_rates_are_refused() {
    for tick_rate in [0.0, -120.0, f64::NAN, f64::INFINITY, 0.5, 1e7] {
        let refused = Game::with_tick_rate(Arc::new(room()), tick_rate);
        assert!(matches!(refused, Err(GameError::TickRate(_))), "{tick_rate}");
    }
}
