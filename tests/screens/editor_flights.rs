//! Test flights from the editor: from the pointer, stopped and gone on, what stays of them over the picture, and what they prove.

use crate::editor::{control, drag, draw, file, open, rows};
use crate::sitting::Sitting;
use resultant::draw::Shape;
use resultant::level;
use resultant::level::document::{Kind, Table};
use resultant::pack;
use resultant::physics::DVec2;
use resultant::screens::{Input, Key};
use resultant::view::theme;
use std::fs;
use std::sync::Arc;

fn point(sitting: &Sitting, x: f64, y: f64) -> resultant::draw::layout::Vec2 {
    sitting.editor().point(DVec2::new(x, y))
}

fn ship(sitting: &Sitting) -> DVec2 {
    sitting.game().world().body(resultant::game::SHIP).position * sitting.game().level().metre
}

fn press_at(sitting: &mut Sitting, key: Key, (x, y): (f64, f64)) {
    let pointer = point(sitting, x, y);
    sitting.point_at(pointer).give(Input { pointer, pressed: [key].into_iter().collect(), ..Input::default() });
}

#[test]
fn a_flight_from_here_begins_at_the_pointer_in_the_level_as_it_stands() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    press_at(&mut sitting, Key::F6, (200.0, 500.0));
    assert_eq!((sitting.at(), sitting.game().level().world.len()), ("test flight", 1));
    assert!(ship(&sitting).distance(DVec2::new(200.0, 500.0)) < 1.0, "{}", ship(&sitting));
    sitting.press(Key::F5);
    assert!(!fs::read_to_string(file(&sitting, "player.csv")).unwrap().contains("200,500"));
    // By its button the next click says where.
    sitting.click("Fly here");
    assert!(sitting.at() == "editor" && sitting.shows("Click where the ship is to start."));
    let at = point(&sitting, 600.0, 300.0);
    sitting.click_at(at);
    assert!(ship(&sitting).distance(DVec2::new(600.0, 300.0)) < 1.0);
    sitting.press(Key::F5);
    // In rock there is no room.
    press_at(&mut sitting, Key::F6, (400.0, 580.0));
    assert!(sitting.at() == "editor" && sitting.shows("It cannot be flown until this is mended: player.csv:2"));
}

#[test]
fn the_path_and_each_impact_stay_over_the_picture() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    assert!(sitting.editor().flown_path().is_empty());
    // It falls, and hits the ground at more than 10 m/s.
    sitting.press(Key::F5).wait(2.0).press(Key::F5);
    let path = sitting.editor().flown_path();
    assert!(path.len() > 20 && path.first().unwrap().y + 5.0 < path.last().unwrap().y, "{path:?}");
    assert!(sitting.shows("m/s") && sitting.shows("Stopped after"));
    let rings = |sitting: &Sitting| {
        let shapes = sitting.app.canvas().shapes();
        shapes.iter().filter(|shape| matches!(shape, Shape::Edge { colour, .. } if *colour == theme::bad())).count()
    };
    assert_eq!(rings(&sitting), 1);
    draw(&mut sitting, Kind::Solid, (100.0, 100.0), (200.0, 120.0));
    assert!(!sitting.editor().flown_path().is_empty(), "and stay while it is edited");
}

#[test]
fn a_flight_that_was_stopped_goes_on_in_the_level_as_it_is_edited() {
    let mut sitting = open();
    sitting.press(Key::F7);
    assert!(sitting.at() == "editor" && sitting.shows("No flight goes on"));
    sitting.press(Key::F5).wait(0.8);
    let (place, ticks) = (ship(&sitting), sitting.ticks());
    sitting.press(Key::F5);
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    sitting.press(Key::F7);
    assert_eq!((sitting.at(), sitting.game().level().world.len()), ("test flight", 1));
    assert!(sitting.ticks() >= ticks && ship(&sitting).distance(place) < 20.0, "{} {place}", ship(&sitting));
    let before = sitting.wait(0.5).press(Key::F5).editor().flown_path();
    assert!(before.windows(2).all(|pair| pair[0].distance(pair[1]) < 2.0), "one path of both parts");
    // A block where the ship is leaves it no room.
    let at = *before.last().unwrap() * sitting.editor().document().metre();
    draw(&mut sitting, Kind::Solid, (at.x - 60.0, at.y - 60.0), (at.x + 60.0, at.y + 60.0));
    sitting.press(Key::F7);
    assert!(sitting.at() == "editor" && sitting.shows("No flight goes on"));
    drag(&mut sitting, (at.x, at.y), (at.x, at.y));
}

/// A pad below the ship, in place of the one that is there, and a flight from the editor that lands on it.
pub fn land() -> Sitting {
    let mut sitting = open();
    drag(&mut sitting, (20.0, 20.0), (20.0, 20.0));
    sitting.press(Key::Delete);
    draw(&mut sitting, Kind::Pad, (300.0, 580.0), (500.0, 600.0));
    sitting.press(Key::F5).hold(&[Key::Space], 4);
    sitting.hold_until(&[], |sitting| sitting.at() == "editor");
    sitting
}

#[test]
fn a_completed_flight_is_made_the_proof_of_gold_and_the_list_shows_it() {
    let mut sitting = land();
    assert_eq!(sitting.labels(), ["Nothing", "Gold", "Silver", "Careful", "Mark"]);
    assert!(sitting.shows("Completed in") && sitting.editor().is_unsaved());
    sitting.click("Mark").rest();
    assert!(sitting.shows("the level has no medal or mark of that name") && sitting.editor().is_unsaved());
    assert!(!file(&sitting, "flights").exists(), "nothing was written");
    // Flown again: the level is saved with the time, and the flight with its name.
    sitting.press(Key::F5).hold(&[Key::Space], 4);
    sitting.hold_until(&[], |sitting| sitting.at() == "editor").click("Gold").rest();
    assert!(sitting.shows("Saved, with the flight as flights/gold.replay.csv.") && !sitting.editor().is_unsaved());
    let loaded = level::load(&file(&sitting, ""), sitting.folder.path()).unwrap().level;
    assert!(loaded.awards.gold.is_some_and(|gold| gold > 0.0 && gold < 9.0), "{:?}", loaded.awards);
    let (proven, problems) = pack::proven(&file(&sitting, ""), &Arc::new(loaded));
    assert!(proven.len() == 1 && proven[0].starts_with("gold") && problems.is_empty(), "{proven:?} {problems:?}");
    // The time is an edit like any other.
    control(&mut sitting, Key::Z);
    assert!(sitting.editor().is_unsaved() && rows(&sitting, Table::Objectives) == 1);
    control(&mut sitting, Key::Y);
    sitting.click("Back").rest();
    assert!(sitting.at() == "levels to edit" && sitting.shows("proven: Gold") && sitting.shows("no flight proves it yet"));
}

#[test]
fn a_flight_from_elsewhere_or_in_parts_proves_nothing() {
    let mut sitting = land();
    sitting.click("Nothing").rest();
    press_at(&mut sitting, Key::F6, (420.0, 300.0));
    sitting.hold(&[Key::Space], 4).hold_until(&[], |sitting| sitting.at() == "editor");
    assert!(sitting.shows("Completed in") && !sitting.labels().contains(&"Gold"));
    sitting.press(Key::F5).hold(&[Key::Space], 2).press(Key::F5).press(Key::F7);
    sitting.hold_until(&[], |sitting| sitting.at() == "editor");
    assert!(sitting.shows("Completed in") && !sitting.labels().contains(&"Gold"));
}
