//! Harm and help by the engine itself: damaging collisions, wind, key objects that are pushed.

use crate::support::rooms::{NONE, REVERSE, THRUST, area, crate_at, objective, room};
use crate::support::shipped::fixture;
use resultant::game::{Controls, Game, GameEvent, Outcome, SHIP};
use resultant::level::{AirStream, Level, ObjectiveKind, Solid};
use resultant::physics::{BodyId, DVec2, ForceKind, Material};
use std::sync::Arc;

/// The ship's half size, m.
const HALF: f64 = 0.85;
/// A full tank is empty by then, and everything is at rest, ticks.
const EMPTY: u32 = 30 * 120;

fn solid(left: f64, top: f64, right: f64, bottom: f64) -> Solid {
    Solid::new(area(left, top, right, bottom), Material::ASPHALT)
}

/// The room with a floor at y = 60 m and the ship `gap` metres above it, moving.
fn above_floor(gap: f64, velocity: DVec2) -> Level {
    let mut level = room();
    level.world = vec![solid(0.0, 60.0, 100.0, 61.0)];
    level.player.position.y = 60.0 - HALF - gap;
    level.player.velocity = velocity;
    level
}

fn fly(level: Level, controls: Controls, ticks: u32) -> (Game, Vec<(u64, GameEvent)>) {
    let mut game = Game::new(Arc::new(level)).unwrap();
    let mut events = Vec::new();
    for _ in 0..ticks {
        game.step(controls);
        events.extend(game.events().iter().map(|event| (game.ticks(), event.clone())));
    }
    (game, events)
}

fn damaging(events: &[(u64, GameEvent)]) -> Vec<f64> {
    let speed = |(_, event): &_| if let GameEvent::DamagingHit { speed, .. } = event { Some(*speed) } else { None };
    events.iter().filter_map(speed).collect()
}

#[test]
fn a_fall_damages_from_ten_metres_a_second_on_and_resting_does_not() {
    for (speed, hits) in [(9.999, 0), (10.0, 1), (10.001, 1), (30.0, 1)] {
        let mut level = above_floor(speed * speed / 30.0, DVec2::ZERO);
        level.gravity = 15.0;
        let (game, events) = fly(level, NONE, 600);
        assert_eq!((game.collisions(), damaging(&events).len()), (hits, hits as usize), "{speed} m/s");
        assert!(damaging(&events).iter().all(|hit| (hit - speed).abs() < 1e-9), "{speed} m/s: {events:?}");
        assert_eq!(game.world().body(SHIP).velocity, DVec2::ZERO);
    }
}

#[test]
fn exactly_ten_along_the_normal_is_enough_and_what_goes_along_the_surface_does_not_count() {
    for (velocity, hits) in [(DVec2::new(0.0, 10.0), 1), (DVec2::new(40.0, 10.0), 1), (DVec2::new(40.0, 9.0), 0)] {
        let (game, _) = fly(above_floor(0.5, velocity), NONE, 60);
        assert_eq!(game.collisions(), hits, "{velocity} m/s");
    }
}

/// Also a regression test: a body that slid off an edge could stay there for ever, a rounding short of having left it.
#[test]
fn a_floor_of_tiles_is_one_hit_and_sliding_over_its_seams_is_none() {
    let mut level = above_floor(1.0, DVec2::new(15.0, 12.0));
    level.gravity = 15.0;
    level.world = (0..200).map(|tile| solid(f64::from(tile) * 0.5, 60.0, f64::from(tile + 1) * 0.5, 61.0)).collect();
    let (game, events) = fly(level, NONE, 360);
    assert_eq!((game.collisions(), damaging(&events).len()), (1, 1));
    let (landed, _) = events[0];
    let ship = game.world().body(SHIP);
    assert_eq!((ship.position.y, ship.velocity), (60.0 - HALF, DVec2::ZERO));
    assert!(ship.position.x > 52.0, "landed at tick {landed}, stopped at {} m", ship.position.x);
}

#[test]
fn floor_and_wall_at_once_are_one_hit_and_one_after_the_other_are_two() {
    for (wall, hits) in [(53.0, 1), (60.0, 2)] {
        let mut level = above_floor(53.0 - 50.0 - HALF, DVec2::splat(12.0));
        level.world.push(solid(wall, 40.0, wall + 1.0, 60.0));
        let smooth = Material { name: "Smooth", static_friction: 0.0, kinetic_friction: 0.0, ..Material::ASPHALT };
        level.world.iter_mut().for_each(|solid| solid.material = smooth);
        assert_eq!(fly(level, NONE, 240).0.collisions(), hits, "a wall at {wall} m");
    }
}

#[test]
fn what_flies_into_the_ship_damages_it_and_what_flies_into_something_else_does_not() {
    for (x, hits) in [(40.0, 1), (30.0, 0)] {
        let mut level = room();
        level.objects = vec![crate_at(DVec2::new(x, 50.0), DVec2::new(12.0, 0.0), None)];
        level.world = if hits == 0 { vec![solid(39.0, 0.0, 40.0, 100.0)] } else { vec![] };
        let (game, events) = fly(level, NONE, 240);
        assert_eq!(game.collisions(), hits, "a crate from {x} m");
        assert!(events.iter().any(|(_, event)| matches!(event, GameEvent::Impact { .. })), "it raises dust");
    }
}

#[test]
fn a_gentle_touch_raises_no_dust() {
    let (_, events) = fly(above_floor(0.1, DVec2::new(0.0, 1.0)), NONE, 60);
    assert_eq!(events, []);
}

#[test]
fn a_damaging_collision_costs_five_hundred_points() {
    let total = |speed: f64| {
        let mut level = above_floor(1.0, DVec2::new(0.0, speed));
        level.optimal_time = 1e9;
        level.objectives = vec![objective(ObjectiveKind::Player, area(0.0, 60.0, 100.0, 61.0))];
        let (game, _) = fly(level, NONE, 30);
        assert_eq!(game.outcome(), Outcome::Completed);
        game.result().score
    };
    assert_eq!((total(9.0).collisions, total(9.0).total), (0, 20_999));
    assert_eq!((total(11.0).collisions, total(11.0).total), (-500, 20_499));
}

#[test]
fn wind_is_felt_while_the_zone_is_touched_and_the_same_by_all() {
    let mut level = room();
    let zone = area(45.0, 45.0, 60.0, 55.0);
    level.streams = vec![AirStream { source: area(44.0, 45.0, 45.0, 55.0), zone, force: DVec2::new(1200.0, 0.0), name: None }];
    level.objects = vec![crate_at(DVec2::new(48.0, 53.0), DVec2::ZERO, None)];
    let mut game = Game::new(Arc::new(level)).unwrap();
    let mut left = [false; 2];
    for _ in 0..240 {
        let inside = |game: &Game| [0, 1].map(|body| game.world().bodies()[body].bounds().touches(&zone, 0.0));
        let before = inside(&game);
        game.step(NONE);
        for (body, after) in inside(&game).into_iter().enumerate() {
            let wind = game.world().forces(BodyId(body as u32)).total(ForceKind::Wind);
            assert!(before[body] || wind == DVec2::ZERO);
            assert!(!(before[body] && after) || wind == DVec2::new(1200.0, 0.0));
            left[body] |= !before[body];
        }
    }
    assert_eq!(left, [true; 2], "both are blown out");
}

#[test]
fn a_key_object_that_is_pushed_onto_its_objective_completes_the_level() {
    let mut level = above_floor(0.0, DVec2::ZERO);
    level.gravity = 15.0;
    level.player.angle = 90.0;
    level.objects = vec![crate_at(DVec2::new(52.0, 59.5), DVec2::ZERO, Some([181, 49, 201]))];
    level.objectives = vec![objective(ObjectiveKind::Physics, area(54.0, 59.0, 55.0, 60.0))];
    let (game, events) = fly(level, THRUST, 240);
    assert_eq!((game.outcome(), game.collisions()), (Outcome::Completed, 0));
    let told: Vec<&GameEvent> = events.iter().map(|(_, event)| event).filter(|e| !matches!(e, GameEvent::Impact { .. })).collect();
    assert_eq!(told, [&GameEvent::ObjectiveMet(0), &GameEvent::Completed]);
    let key = game.world().body(BodyId(1)).bounds();
    assert!((53.9..54.1).contains(&key.max.x), "{key:?}");
}

#[test]
fn the_peak_resultant_is_what_the_force_manager_held() {
    let mut level = above_floor(0.0, DVec2::ZERO);
    level.gravity = 15.0;
    let (game, _) = fly(level, THRUST, 60);
    let force = |kind| game.world().forces(SHIP).total(kind);
    assert_eq!(force(ForceKind::Drive), DVec2::new(0.0, -2000.0));
    assert_eq!(game.result().peak_resultant, 500.0);
}

/// The fixture 3 with the ship at the foot of that wind.
fn below_wind(stream: usize, angle: f64) -> Level {
    let mut level = Level::clone(&fixture("3"));
    let zone = level.streams[stream].zone;
    (level.player.position, level.player.angle) = (DVec2::new(zone.centre().x, zone.max.y - HALF), angle);
    level
}

#[test]
fn a_wind_carries_the_ship_to_the_top_without_its_engine() {
    let level = below_wind(0, 0.0);
    let player = level.objectives.iter().position(|objective| objective.kind == ObjectiveKind::Player).unwrap();
    let (_, events) = fly(level, NONE, EMPTY);
    assert!(events.iter().any(|(_, event)| *event == GameEvent::ObjectiveMet(player)), "the ship never got there");
}

#[test]
fn a_wind_that_blows_down_lets_no_ship_out_again() {
    let start = below_wind(1, 0.0).player.position;
    for angle in (-180..180).step_by(15) {
        for controls in [THRUST, REVERSE] {
            let (game, _) = fly(below_wind(1, f64::from(angle)), controls, EMPTY);
            assert_eq!(game.world().body(SHIP).position, start, "{angle} degrees, {controls:?}");
        }
    }
}
