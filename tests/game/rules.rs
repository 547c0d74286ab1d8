//! The rules of one attempt: controls, fuel, objectives, death boxes, figures.

use crate::support::rooms::*;
use resultant::game::{BURN_RATE, Controls, Game, GameError, GameEvent, Outcome, ROTATION_RATE, SHIP, TICK_RATE};
use resultant::level::{Level, Mover, MoverPace, Objective, ObjectiveKind, Route, RouteShape, Solid};
use resultant::physics::{DVec2, Material, Path};
use std::sync::Arc;

const BOTH: Controls = Controls { reverse: true, ..THRUST };

fn goal(left: f64, top: f64, right: f64, bottom: f64) -> Objective {
    objective(ObjectiveKind::Player, area(left, top, right, bottom))
}

fn pit(left: f64, top: f64, right: f64, bottom: f64) -> Objective {
    objective(ObjectiveKind::Physics, area(left, top, right, bottom))
}

fn moving(x: f64, y: f64) -> Level {
    let mut level = room();
    level.player.velocity = DVec2::new(x, y);
    level
}

#[test]
fn rotation_is_a_rate_and_moves_nothing() {
    for tick_rate in [30.0, 60.0, 120.0, 144.0] {
        let mut game = Game::with_tick_rate(Arc::new(room()), tick_rate).unwrap();
        fly(&mut game, RIGHT, tick_rate as u32 / 2);
        assert_eq!(game.ship().angle, ROTATION_RATE / 2.0, "{tick_rate} ticks a second");
        fly(&mut game, LEFT, tick_rate as u32);
        assert_eq!(game.ship().angle, -ROTATION_RATE / 2.0, "{tick_rate} ticks a second");
        let ship = game.world().body(SHIP);
        assert_eq!((ship.position, ship.velocity), (DVec2::splat(50.0), DVec2::ZERO));
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
fn thrust_goes_along_the_nose_reverse_against_it_and_both_cancel() {
    let diagonal = 2000.0 * std::f64::consts::FRAC_1_SQRT_2;
    for (angle, along) in [
        (0.0, DVec2::new(0.0, -2000.0)),
        (45.0, DVec2::new(diagonal, -diagonal)),
        (90.0, DVec2::new(2000.0, 0.0)),
        (180.0, DVec2::new(0.0, 2000.0)),
        (-90.0, DVec2::new(-2000.0, 0.0)),
    ] {
        for (controls, sign) in [(THRUST, 1.0), (REVERSE, -1.0), (BOTH, 0.0)] {
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
fn fuel_burns_at_a_steady_rate_whatever_the_tick_and_not_by_what_cancels() {
    for tick_rate in [30.0, 60.0, 120.0, 144.0] {
        for (controls, left) in [(THRUST, 500.0 - BURN_RATE), (REVERSE, 500.0 - BURN_RATE), (BOTH, 500.0)] {
            let mut game = Game::with_tick_rate(Arc::new(room()), tick_rate).unwrap();
            fly(&mut game, controls, tick_rate as u32);
            fly(&mut game, NONE, 10);
            assert_eq!((game.ship().fuel, game.fuel()), (left, left / 500.0), "{tick_rate} ticks a second");
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
    let mut level = room();
    level.player.fuel = 0.0;
    assert_eq!(start(level).fuel(), 0.0, "a tank that never held anything is empty");
}

#[test]
fn a_player_objective_is_met_while_the_ship_touches_it() {
    let objectives = vec![goal(52.0, 49.0, 53.0, 51.0), goal(0.0, 0.0, 1.0, 1.0)];
    let mut game = start(Level { objectives, ..moving(12.0, 0.0) });
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
        let mut game = start(Level { objectives: vec![goal(left, 50.0, 60.0, 51.0)], ..room() });
        assert_eq!(game.met(), [met], "before the first tick");
        assert_eq!(game.outcome(), Outcome::Running, "an attempt takes a tick at least");
        game.step(NONE);
        assert_eq!(game.outcome() == Outcome::Completed, met);
    }
}

#[test]
fn a_physics_objective_waits_for_a_key_object_that_fits() {
    let pink = Some([255, 0, 255]);
    for (key, colour, met) in [(None, None, false), (pink, None, true), (pink, pink, true), (pink, Some([255, 0, 254]), false)] {
        let objectives = vec![Objective { colour, ..pit(10.0, 10.0, 11.0, 11.0) }];
        let other = crate_at(DVec2::new(80.0, 80.0), DVec2::ZERO, Some([0, 255, 0]));
        let objects = vec![other, crate_at(DVec2::new(10.5, 9.5), DVec2::ZERO, key)];
        let mut game = start(Level { objectives, objects, ..room() });
        game.step(NONE);
        assert_eq!(game.met(), [met], "key {key:?}, asked for {colour:?}");
    }
    let mut game = start(Level { objectives: vec![pit(49.0, 49.0, 51.0, 51.0)], ..room() });
    game.step(NONE);
    assert_eq!(game.met(), [false], "the ship is no key object");
}

#[test]
fn a_hold_wants_the_ship_for_so_long_without_a_break() {
    let pad = || Objective { hold: 0.5, ..goal(49.0, 50.85, 51.0, 51.0) };
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
    let through = Objective { hold: 0.25, ..goal(52.0, 49.0, 53.0, 51.0) };
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
fn what_is_held_and_the_clock_are_part_of_the_state() {
    let after = |idle: u32| {
        let mut game = start(room());
        fly(&mut game, NONE, idle);
        fly(&mut game, Controls { right: true, ..LEFT }, 1);
        fly(&mut game, NONE, 60 - idle);
        game
    };
    assert_eq!((after(10).ticks(), after(10).hash()), (after(20).ticks(), after(10).hash()));
    assert_ne!(after(10).hash(), after(20).hash(), "one of them will have the better time");
    let mut level = room();
    level.objectives.push(Objective { hold: 5.0, ..goal(49.0, 50.85, 51.0, 51.0) });
    let mut games = [start(level.clone()), start(level)];
    games.iter_mut().for_each(|game| fly(game, NONE, 10));
    games[0].step(NONE);
    assert_ne!(games[0].hash(), games[1].hash(), "one has held for longer");
}

#[test]
fn turns_are_taken_in_order_and_kept() {
    // From 50 m to the right: the first lies behind the second, so that the second is passed in vain at first.
    let gate = |order, x: f64| Objective { order: Some(order), ..goal(x, 49.0, x + 1.0, 51.0) };
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
fn a_level_is_complete_when_all_are_met_at_once() {
    // The ship passes its objective before the key object reaches the other one, or while it is there.
    for (start_x, outcome) in [(12.0, Outcome::Running), (8.0, Outcome::Completed)] {
        let objectives = vec![goal(52.0, 49.0, 53.0, 51.0), pit(5.0, 10.0, 6.0, 11.0)];
        let objects = vec![crate_at(DVec2::new(start_x, 10.5), DVec2::new(-6.0, 0.0), Some([255, 0, 255]))];
        let mut game = start(Level { objectives, objects, ..moving(12.0, 0.0) });
        fly(&mut game, NONE, 120);
        assert_eq!(game.outcome(), outcome, "the key object starts at {start_x} m");
        if outcome == Outcome::Completed {
            assert!(game.events().is_empty(), "an event is listed once");
            assert_eq!((game.result().objectives_met, game.result().objectives_all), (2, 2));
        }
    }
}

#[test]
fn the_clock_starts_with_the_first_tick_that_has_an_input() {
    for key in [THRUST, REVERSE, LEFT, RIGHT, Controls { right: true, ..LEFT }] {
        let mut game = start(moving(1.0, 0.0));
        fly(&mut game, NONE, 60);
        assert!(game.is_idle() && (game.elapsed() - 0.5).abs() < 1e-12, "{key:?}");
        assert!((game.world().body(SHIP).position.x - 50.5).abs() < 1e-9, "the world goes on");
        game.step(key);
        assert!(!game.is_idle(), "{key:?}");
        assert_eq!((game.ticks(), game.ticks_on_clock(), game.time()), (61, 1, 1.0 / 120.0), "{key:?}");
        fly(&mut game, NONE, 119);
        assert_eq!((game.elapsed(), game.time(), game.result().time), (1.5, 1.0, 1.0), "{key:?}");
    }
}

#[test]
fn score_and_medals_count_what_is_on_the_clock() {
    let flown = |idle: u32| {
        let mut game = start(Level { objectives: vec![goal(49.0, 40.0, 51.0, 45.0)], ..room() });
        fly(&mut game, NONE, idle);
        while game.outcome() == Outcome::Running {
            game.step(THRUST);
        }
        (game.result(), game.ticks() - u64::from(idle))
    };
    let (at_once, late) = (flown(0), flown(600));
    assert_eq!((&at_once.0, at_once.1), (&late.0, late.1), "a look at the level before the first key costs nothing");
}

/// The room with gravity and a floor below the ship, which leans by this angle, degrees.
fn leaning(angle: f64) -> Level {
    let mut level = room();
    (level.gravity, level.player.angle) = (15.0, angle);
    level.world = vec![Solid::new(area(0.0, 50.85, 100.0, 52.0), Material::ASPHALT)];
    level
}

#[test]
fn the_ship_comes_to_rest_upright_or_on_its_side() {
    for (angle, rest) in [(30.0, 0.0), (-44.0, 0.0), (45.0, 90.0), (60.5, 90.0), (181.25, 180.0), (-80.0, -90.0), (405.0, 450.0)] {
        let mut game = start(leaning(angle));
        let mut before = angle;
        for tick in 0..120 {
            game.step(NONE);
            let now = game.ship().angle;
            let turned = (now - before).abs();
            assert!(turned <= ROTATION_RATE / TICK_RATE + 1e-12, "{angle}°: by {turned}° in tick {tick}");
            assert!((now - rest).abs() <= (before - rest).abs(), "{angle}°: away from {rest}° in tick {tick}");
            before = now;
        }
        assert_eq!(game.ship().angle, rest, "{angle}°");
        // From there keys count by whole ticks again.
        fly(&mut game, RIGHT, 2);
        assert_eq!(game.ship().angle, rest + 2.0 * ROTATION_RATE / TICK_RATE);
    }
}

#[test]
fn a_ship_that_turns_burns_flies_or_slides_does_not_right_itself() {
    let turned = |level: Level, controls: Controls| {
        let mut game = start(level);
        fly(&mut game, controls, 100);
        game.ship().angle - 30.0
    };
    assert_eq!(turned(leaning(30.0), RIGHT), 150.0);
    assert_eq!(turned(leaning(30.0), Controls { right: true, ..LEFT }), 0.0, "keys that cancel each other hold it");
    assert_eq!(turned(leaning(30.0), THRUST), 0.0);
    assert_eq!(turned(Level { gravity: 0.0, ..leaning(30.0) }, NONE), 0.0, "nothing carries it");
    let mut above = leaning(30.0);
    above.player.position.y = 20.0;
    assert_eq!(turned(above, NONE), 0.0, "it falls");
    let mut slides = leaning(30.0);
    (slides.player.velocity.x, slides.friction) = (9.0, 0.1);
    assert_eq!(turned(slides, NONE), 0.0, "it slides");
}

#[test]
fn what_carries_the_ship_may_move() {
    let righted = |level: Level| {
        let mut game = start(level);
        fly(&mut game, NONE, 360);
        game.ship().angle
    };
    let mut belt = leaning(30.0);
    belt.world[0].belt = 2.0;
    assert_eq!(righted(belt), 0.0, "a belt");
    let mut lift = leaning(30.0);
    let solid = lift.world.remove(0);
    let path = Path::steady(DVec2::new(0.0, -1.0));
    let manner = RouteShape { route: Route::Once, pace: MoverPace::Speed(1.0), wait: 0.0, ease: 0.0 };
    lift.movers = vec![Mover { solid, path, stops: vec![], manner }];
    assert_eq!(righted(lift), 0.0, "a lift");
    let mut crates = leaning(30.0);
    crates.player.position.y -= 1.0;
    crates.objects = vec![crate_at(DVec2::new(50.0, 50.35), DVec2::ZERO, None)];
    assert_eq!(righted(crates), 0.0, "a crate");
}

#[test]
fn a_death_box_ends_the_attempt_at_once_with_nothing() {
    let mut game = start(Level { obstacles: vec![area(52.0, 49.0, 53.0, 51.0)], ..moving(12.0, 0.0) });
    // The tip of its fin is 1.2435 m away.
    fly(&mut game, NONE, 12);
    assert_eq!(game.outcome(), Outcome::Running);
    game.step(NONE);
    assert_eq!((game.outcome(), game.events()), (Outcome::Failed, &[GameEvent::Died][..]));
    assert_eq!((game.result().score.total, game.result().time), (0, 13.0 / 120.0));
}

#[test]
fn what_kills_touches_the_ships_body_and_not_the_box_around_it() {
    let killed = |angle: f64, obstacle| {
        let mut level = room();
        level.player.angle = angle;
        level.obstacles = vec![obstacle];
        let mut game = start(level);
        game.step(NONE);
        game.outcome() == Outcome::Failed
    };
    const PIXEL: f64 = 1.0 / 30.0;
    // Beside the cabin there is a gap of six pixels; beside the fins, of almost three; in the box's corners, of more than ten.
    let right = |pixels: f64, top: f64, bottom: f64| area(50.85 - pixels * PIXEL, top, 60.0, bottom);
    assert!(!killed(0.0, right(5.0, 49.15, 49.9)), "beside the cabin");
    assert!(killed(0.0, right(5.0, 49.15, 50.85)), "beside the fins");
    assert!(!killed(0.0, right(2.5, 49.15, 50.85)) && killed(0.0, right(3.0, 49.15, 50.85)), "at the fins' tips");
    for (x, y) in [(49.15, 49.15), (50.85, 49.15), (49.15, 50.85), (50.85, 50.85)] {
        let corner = |pixels: f64| area(x - pixels * PIXEL, y - pixels * PIXEL, x + pixels * PIXEL, y + pixels * PIXEL);
        assert!(!killed(0.0, corner(4.0)) && killed(0.0, corner(15.0)), "the corner at ({x}, {y}) m");
    }
    // On its side the nose reaches where the fins did not.
    let ahead = right(4.0, 49.9, 50.1);
    assert!(!killed(0.0, ahead) && killed(90.0, ahead) && !killed(-90.0, right(1.0, 49.9, 50.1)));
    // A strip that is flatter than the gap below the nozzle, on the floor that the box stands on.
    let strip = |pixels: f64| area(40.0, 50.85 - pixels * PIXEL, 60.0, 50.85);
    assert!(!killed(0.0, strip(1.0)) && killed(0.0, strip(1.5)), "below the nozzle the gap is a little more than a pixel");
    assert!(!killed(90.0, strip(2.5)) && killed(90.0, strip(3.0)), "below a fin almost three");
}

#[test]
fn no_death_box_is_skipped_at_any_speed() {
    for speed in [100.0, 1_000.0, 4_000.0] {
        let mut level = moving(0.0, speed);
        level.player.position.y = 5.0;
        level.obstacles = vec![area(0.0, 30.0, 100.0, 30.001)];
        let mut game = start(level);
        fly(&mut game, NONE, (40.0 / speed * TICK_RATE).ceil() as u32);
        assert_eq!(game.outcome(), Outcome::Failed, "{speed} m/s");
    }
}

#[test]
fn death_goes_before_completion() {
    let (objectives, obstacles) = (vec![goal(50.0, 50.0, 51.0, 51.0)], vec![area(49.5, 49.5, 50.0, 50.0)]);
    let mut game = start(Level { objectives, obstacles, ..room() });
    game.step(NONE);
    assert_eq!((game.outcome(), game.met(), game.result().score.total), (Outcome::Failed, &[true][..], 0));
}

#[test]
fn after_the_end_nothing_changes() {
    let mut game = start(Level { obstacles: vec![area(50.0, 50.0, 51.0, 51.0)], ..moving(3.0, 0.0) });
    game.step(NONE);
    let (hash, result) = (game.hash(), game.result());
    fly(&mut game, Controls { right: true, ..THRUST }, 100);
    assert_eq!((game.hash(), game.result(), game.ticks()), (hash, result, 1));
    assert!(game.events().is_empty());
}

#[test]
fn a_result_tells_the_flight() {
    let objectives = vec![goal(49.0, 58.85, 60.0, 60.0)];
    let mut game = start(Level { optimal_time: 2.0, objectives, ..moving(3.0, 4.0) });
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
