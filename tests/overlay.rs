//! The details overlay tells the truth: what its boxes show is what the world says, on every tick.
#![cfg(feature = "window")]

mod common;

use common::{area, crate_at, room};
use resultant::game::{Controls, Game, SHIP};
use resultant::level::Level;
use resultant::physics::{BodyId, DVec2, ForceKind};
use resultant::view::facts::{Facts, Row, Value, facts};
use std::sync::Arc;

/// The ship and a crate of 10 kg at rest on the floor of the room, at g = 15 N/kg.
fn on_the_floor() -> Level {
    let mut level = room();
    level.gravity = 15.0;
    level.player.position = DVec2::new(50.0, 99.15);
    level.objects = vec![crate_at(DVec2::new(60.0, 99.5), DVec2::ZERO, None)];
    level.objectives[0].bounds = area(2.0, 2.0, 3.0, 3.0);
    level
}

fn game(level: Level) -> Game {
    Game::new(Arc::new(level)).expect("the level makes a world")
}

fn row<'a>(facts: &'a Facts, name: &str) -> &'a Row {
    facts.rows.iter().find(|row| row.name == name).unwrap_or_else(|| panic!("no row {name} in {facts:?}"))
}

fn vector(facts: &Facts, name: &str) -> DVec2 {
    match row(facts, name).value {
        Value::Vector(vector) => vector,
        Value::Scalar(value) => panic!("{name} is the number {value}"),
    }
}

#[test]
fn at_rest_every_tick_shows_a_resultant_of_exactly_zero_and_the_forces_that_cancel() {
    let mut game = game(on_the_floor());
    for tick in 0..240 {
        for (id, weight) in [(SHIP, 1500.0), (BodyId(1), 150.0)] {
            let facts = facts(&game, id);
            assert_eq!(vector(&facts, "Resultant"), DVec2::ZERO, "tick {tick}");
            assert_eq!(vector(&facts, "Velocity"), DVec2::ZERO, "tick {tick}");
            assert_eq!(vector(&facts, "Acceleration"), DVec2::ZERO, "tick {tick}");
            assert_eq!(vector(&facts, "Weight"), DVec2::new(0.0, weight), "tick {tick}");
            assert_eq!(vector(&facts, "Reaction"), DVec2::new(0.0, -weight), "tick {tick}");
        }
        game.step(Controls::default());
    }
}

#[test]
fn the_ship_begins_with_its_engine_and_other_bodies_have_none() {
    let mut game = game(on_the_floor());
    game.step(Controls { thrust: true, ..Controls::default() });
    let ship = facts(&game, SHIP);
    assert_eq!((ship.rows[0].name, ship.rows[0].value, ship.rows[0].unit), ("Engine drive", Value::Scalar(2000.0), "N"));
    assert_eq!(vector(&ship, "Drive"), DVec2::new(0.0, -2000.0));
    assert_eq!(ship.title, "Ship");
    let crate_box = facts(&game, BodyId(1));
    assert_eq!((crate_box.rows[0].name, crate_box.rows[0].value), ("Mass", Value::Scalar(10.0)));
    game.step(Controls { reverse: true, ..Controls::default() });
    assert_eq!(facts(&game, SHIP).rows[0].value, Value::Scalar(-2000.0));
    game.step(Controls::default());
    assert_eq!(facts(&game, SHIP).rows[0].value, Value::Scalar(0.0));
}

#[test]
fn in_flight_the_lines_add_up_to_the_resultant_and_are_the_worlds_own_numbers() {
    let mut level = room();
    (level.gravity, level.air_density) = (15.0, 1.2041);
    let mut game = game(level);
    for tick in 0..360 {
        let controls = Controls { thrust: tick % 90 < 60, right: tick % 50 < 20, ..Controls::default() };
        game.step(controls);
        let facts = facts(&game, SHIP);
        let (forces, body) = (game.world().forces(SHIP), game.world().body(SHIP));
        assert_eq!(vector(&facts, "Resultant"), forces.resultant());
        assert_eq!((vector(&facts, "Velocity"), vector(&facts, "Acceleration")), (body.velocity, body.acceleration));
        let shown: DVec2 = facts.rows.iter().filter(|row| row.force.is_some()).map(|row| vector(&facts, row.name)).sum();
        assert!((shown - forces.resultant()).length() < 1e-9 * (1.0 + shown.length()), "tick {tick}: {shown}");
        for kind in ForceKind::ALL.into_iter().filter(|kind| forces.total(*kind) != DVec2::ZERO) {
            assert_eq!(vector(&facts, kind.name()), forces.total(kind), "tick {tick}");
        }
    }
}
