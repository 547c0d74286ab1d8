//! The details overlay tells the truth: its boxes agree with the world, on every tick.

use super::onlook::centres;
use crate::support::rooms::{area, crate_at, room};
use resultant::draw::layout::{Frame, Vec2};
use resultant::game::{Controls, Game, SHIP};
use resultant::level::Level;
use resultant::physics::{BodyId, DVec2, ForceKind};
use resultant::view::camera::{CanvasWindow, Viewport};
use resultant::view::details::{Details, Looking, PlacedBox};
use resultant::view::facts::{ArrowKind, BodyFacts, FactRow, Value, facts, quantity};
use resultant::view::focus::Focus;
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

fn row<'a>(facts: &'a BodyFacts, name: &str) -> &'a FactRow {
    facts.rows.iter().find(|row| row.name == name).unwrap_or_else(|| panic!("no row {name} in {facts:?}"))
}

fn vector(facts: &BodyFacts, name: &str) -> DVec2 {
    match row(facts, name).value {
        Value::Vector(vector) => vector,
        other => panic!("{name} is {other:?}"),
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
            assert_eq!(vector(&facts, "Normal force"), DVec2::new(0.0, -weight), "tick {tick}");
        }
        game.step(Controls::default());
    }
}

#[test]
fn the_ship_begins_with_its_engine_and_other_bodies_have_none() {
    let mut game = game(on_the_floor());
    game.step(Controls { thrust: true, ..Controls::default() });
    let ship = facts(&game, SHIP);
    let engine = ship.rows[..2].iter().map(|row| (row.name, row.value, row.unit)).collect::<Vec<_>>();
    assert_eq!(engine, [("Engine", Value::Scalar(2000.0), "N"), ("Burning", Value::Scalar(2000.0), "N")]);
    assert_eq!(vector(&ship, "Drive"), DVec2::new(0.0, -2000.0));
    assert_eq!(ship.title, "Ship");
    let crate_box = facts(&game, BodyId(1));
    assert_eq!((crate_box.rows[0].name, crate_box.rows[0].value), ("Mass", Value::Scalar(10.0)));
    game.step(Controls { reverse: true, ..Controls::default() });
    let engine = |game: &Game| facts(game, SHIP).rows[..2].iter().map(|row| row.value).collect::<Vec<_>>();
    assert_eq!(engine(&game), [Value::Scalar(2000.0), Value::Scalar(-2000.0)]);
    game.step(Controls::default());
    assert_eq!(engine(&game), [Value::Scalar(2000.0), Value::Scalar(0.0)], "the engine is there, and burns nothing");
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
        let of_forces = facts.rows.iter().filter(|row| matches!(row.shown, Some(ArrowKind::Force(_))));
        let shown: DVec2 = of_forces.map(|row| vector(&facts, row.name)).sum();
        assert!((shown - forces.resultant()).length() < 1e-9 * (1.0 + shown.length()), "tick {tick}: {shown}");
        for kind in ForceKind::ALL.into_iter().filter(|kind| forces.total(*kind) != DVec2::ZERO) {
            assert_eq!(vector(&facts, kind.shown()), forces.total(kind), "tick {tick}");
        }
    }
}

/// By name, size and source; no longer, and no shorter for a pause.
#[test]
fn an_impact_is_told_for_half_a_second() {
    let mut level = on_the_floor();
    level.objects[0].position.y = 98.0;
    level.objects.push(crate_at(DVec2::new(70.0, 99.5), DVec2::ZERO, None));
    level.objects.push(crate_at(DVec2::new(69.0 - 1e-9, 99.5), DVec2::new(4.0, 0.0), None));
    let mut game = game(level);
    let lines = |game: &Game, body: u32| -> Vec<String> {
        let told = facts(game, BodyId(body)).rows.into_iter().skip_while(|row| row.shown != Some(ArrowKind::Impact));
        told.map(|row| format!("{} {}", row.label(), quantity(&row, 6))).collect()
    };
    while game.world().impulses().iter().all(|impulse| impulse.on(BodyId(1)).is_none()) {
        assert_eq!(lines(&game, 1), Vec::<String>::new());
        game.step(Controls::default());
    }
    let told = ["Impulse by floor (     0,   67.1) N·s"];
    for _ in 0..=60 {
        assert_eq!(lines(&game, 1), told);
        game.step(Controls::default());
    }
    assert_eq!(lines(&game, 1), Vec::<String>::new());
}

/// The details of a game as they are laid out for a pointer at that place.
fn arrange(details: &mut Details, game: &Game, focus: &Focus, pointer: Option<Vec2>) {
    let frame = Frame::default();
    let centres = centres(game);
    let window = CanvasWindow { size: frame.size.as_dvec2(), pixel: 1.0 };
    let view = Viewport::new(centres[0], centres[0], game.level().size, game.level().metre, window);
    details.arrange(game, &Looking { centres: &centres, focus, pointer, model: false, velocity: false }, &[], &view, &frame);
}

fn placed(details: &Details, body: u32) -> &PlacedBox {
    details.boxes.iter().find(|placed| placed.text.body == BodyId(body)).expect("it has a box")
}

/// The middle of a line of a body's box.
fn line(details: &Details, body: u32, label: &str) -> Vec2 {
    let placed = placed(details, body);
    let index = placed.text.lines.iter().position(|line| line.label == label);
    placed.line(index.unwrap_or_else(|| panic!("{label}: {:?}", placed.text))).centre()
}

fn lit(details: &Details, game: &Game) -> Vec<(u32, String, DVec2)> {
    let told = |(body, row): &(BodyId, usize)| {
        let row = facts(game, *body).rows.swap_remove(*row);
        let Value::Vector(vector) = row.value else { panic!("{row:?}") };
        (body.0, row.label(), vector)
    };
    details.lit.iter().map(told).collect()
}

fn stack() -> Game {
    let mut level = on_the_floor();
    level.objects = [99.5, 98.5].map(|y| crate_at(DVec2::new(60.0, y), DVec2::ZERO, None)).into();
    game(level)
}

/// The two lines of the force between the crates of the stack.
fn pair_of_the_stack() -> [(u32, String, DVec2); 2] {
    [(2, 1, -150.0), (1, 2, 150.0)].map(|(on, by, y)| (on, format!("Normal force by Box {by}"), DVec2::new(0.0, y)))
}

/// The other body's line and arrow light up; a partner that is no part of the level is named in words.
#[test]
fn pointing_at_a_force_lights_its_partner() {
    let (game, mut details, all) = (stack(), Details::default(), Focus::default());
    arrange(&mut details, &game, &all, None);
    assert!(details.lit.is_empty() && details.tip.is_none());
    let at = line(&details, 2, "Normal force by Box 1");
    arrange(&mut details, &game, &all, Some(at));
    assert_eq!(lit(&details, &game), pair_of_the_stack());
    let words = |details: &Details| details.tip.as_ref().expect("a tip").lines.join(" ");
    assert_eq!(words(&details), "Third law: Box 2 presses on Box 1 with (0, −150) N");
    assert!(details.tip.as_ref().is_some_and(|tip| tip.area.is_some()));
    let arrow = details.arranged.arrows.iter().find(|arrow| arrow.body == BodyId(1) && arrow.name() == "Weight").expect("an arrow");
    let at = arrow.to;
    arrange(&mut details, &game, &all, Some(at));
    assert_eq!(lit(&details, &game), [(1, "Weight by planet".to_owned(), DVec2::new(0.0, 150.0))]);
    assert_eq!(words(&details), "Third law: Box 1 pulls planet with (0, 150) N");
    let at = line(&details, 2, "Resultant");
    arrange(&mut details, &game, &all, Some(at));
    assert!(details.lit.is_empty() && details.tip.is_none());
}

#[test]
fn the_partner_of_the_one_that_is_followed_keeps_its_box() {
    let (game, mut details, mut focus) = (stack(), Details::default(), Focus::default());
    focus.pick(Some(BodyId(2)), false);
    arrange(&mut details, &game, &focus, None);
    let told: Vec<u32> = details.boxes.iter().map(|placed| placed.text.body.0).collect();
    assert_eq!(told, [2, 1], "the crate below, and not the ship");
    let at = line(&details, 2, "Normal force by Box 1");
    arrange(&mut details, &game, &focus, Some(at));
    assert_eq!(lit(&details, &game), pair_of_the_stack());
}

/// Also once the impact can no longer be read.
#[test]
fn who_was_hit_stays_beside_the_one_that_is_followed() {
    let mut level = on_the_floor();
    level.gravity = 0.0;
    level.objects = [(60.0, 4.0), (63.0, 0.0)].map(|(x, speed)| crate_at(DVec2::new(x, 90.0), DVec2::new(speed, 0.0), None)).into();
    let (mut game, mut details, mut focus) = (game(level), Details::default(), Focus::default());
    focus.pick(Some(BodyId(1)), false);
    let mut told = Vec::new();
    for tick in 0..240 {
        arrange(&mut details, &game, &focus, None);
        let boxes: Vec<u32> = details.boxes.iter().map(|placed| placed.text.body.0).collect();
        if told.last().is_none_or(|(_, last)| *last != boxes) {
            told.push((tick, boxes));
        }
        game.step(Controls::default());
    }
    // 2 m at 4 m/s, and the tick in which they meet.
    assert_eq!(told, [(0, vec![1]), (61, vec![1, 2])]);
}

#[test]
fn an_idle_ship_has_no_box_and_no_arrows() {
    let mut level = on_the_floor();
    level.experiment = true;
    let (game, mut details) = (game(level), Details::default());
    arrange(&mut details, &game, &Focus::default(), None);
    assert!(details.boxes.iter().all(|placed| placed.text.body != SHIP) && details.boxes.len() == 1);
    assert!(details.arranged.arrows.iter().all(|arrow| arrow.body != SHIP && arrow.to_scale));
    let mut focus = Focus::default();
    focus.pick(Some(SHIP), false);
    arrange(&mut details, &game, &focus, None);
    assert_eq!(details.boxes[0].text.body, SHIP);
}

#[test]
fn who_exerts_a_force_is_named() {
    let mut level = on_the_floor();
    (level.gravity, level.air_density) = (9.81, 1.2);
    level.player.position = DVec2::new(50.0, 60.0);
    level.objects = [(60.0, 99.5), (61.2, 99.5), (60.6, 98.5)].map(|(x, y)| crate_at(DVec2::new(x, y), DVec2::ZERO, None)).into();
    let mut game = game(level);
    game.step(Controls { thrust: true, ..Controls::default() });
    let labels = |body: u32| -> Vec<String> {
        let told = facts(&game, BodyId(body)).rows.into_iter().filter(|row| !row.causes.is_empty());
        told.map(|row| row.label()).collect()
    };
    assert_eq!(labels(0), ["Weight by Earth", "Drive by exhaust", "Air Resistance by air"]);
    assert_eq!(labels(1), ["Weight by Earth", "Normal force by Box 3", "Normal force by floor"]);
    assert_eq!(labels(3), ["Weight by Earth", "Normal force by 2 objects"]);
}

/// Arrows are as long as the scale says, except marked ones, and none is nothing, however small its force.
#[test]
fn every_force_has_an_arrow_and_what_is_not_to_scale_is_marked() {
    let mut level = on_the_floor();
    level.objects = [55.0, 60.0].map(|x| crate_at(DVec2::new(x, 99.5), DVec2::ZERO, None)).into();
    (level.objects[0].mass, level.objects[1].mass) = (1e-6, 1e6);
    let (game, mut details) = (game(level), Details::default());
    arrange(&mut details, &game, &Focus::default(), None);
    let arrows = &details.arranged.arrows;
    assert_eq!((arrows.len(), details.arranged.left_out), (6, 0));
    for arrow in arrows {
        assert_eq!(arrow.to_scale, arrow.body == SHIP, "{arrow:?}");
        assert!((15.0..720.0).contains(&arrow.length()), "{arrow:?}");
    }
    assert!(details.legend.lines.iter().any(|line| line.contains("not to scale")));
    for body in [1, 2] {
        let mut focus = Focus::default();
        focus.pick(Some(BodyId(body)), false);
        arrange(&mut details, &game, &focus, None);
        assert!(details.arranged.arrows.iter().all(|arrow| arrow.to_scale && arrow.body == BodyId(body)), "{:?}", details.arranged);
    }
    // By hand, however long or short: they stay in the window, and none becomes nothing.
    for steps in [24, -24] {
        let mut focus = Focus::default();
        focus.lengthen(steps);
        arrange(&mut details, &game, &focus, None);
        assert_eq!((details.arranged.arrows.len(), details.arranged.left_out), (6, 0));
        for arrow in &details.arranged.arrows {
            let inside = |point: Vec2| Frame::default().area().contains(point);
            assert!(arrow.length() >= 15.0 && inside(arrow.from) && inside(arrow.to), "{steps}: {arrow:?}");
        }
    }
}
