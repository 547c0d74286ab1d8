//! Test flights from the editor: from the pointer, stopped and gone on, what stays of them over the picture, and what they prove;
//! and an author's whole way, by mouse alone but for the level's name and the flight itself.

use crate::editor::{control, drag, draw, file, open, rows, write_into};
use crate::sitting::Sitting;
use resultant::draw::Shape;
use resultant::game::Medal;
use resultant::level;
use resultant::level::document::{Kind, LinkForm, Table};
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
    sitting.click("Fly here");
    assert!(sitting.at() == "editor" && sitting.shows("Click where the ship is to start."));
    let at = point(&sitting, 600.0, 300.0);
    sitting.click_at(at);
    assert!(ship(&sitting).distance(DVec2::new(600.0, 300.0)) < 1.0);
    sitting.press(Key::F5);
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

#[test]
fn a_ship_and_a_size_are_enough_to_fly() {
    let mut sitting = open();
    drag(&mut sitting, (20.0, 20.0), (20.0, 20.0));
    sitting.press(Key::Delete);
    draw(&mut sitting, Kind::Picture, (100.0, 100.0), (160.0, 140.0));
    write_into(&mut sitting, "image", "nowhere.png");
    draw(&mut sitting, Kind::Object, (100.0, 500.0), (140.0, 540.0));
    write_into(&mut sitting, "mass", "heavy");
    sitting.press(Key::F5);
    assert_eq!(sitting.at(), "test flight");
    assert!(sitting.shows("Flown as far as it goes. What is left:") && sitting.shows("nowhere.png"));
    assert!(sitting.texts().iter().filter(|(line, _)| line.contains(".csv")).count() >= 3, "{:?}", sitting.texts());
    let level = sitting.game().level().clone();
    assert_eq!((level.objectives.len(), level.objects.len(), level.decoration.len()), (0, 0, 0));
    sitting.wait(1.0);
    assert!(sitting.at() == "test flight", "nothing is completed where nothing is asked for");
    assert_eq!(sitting.press(Key::F5).at(), "editor");
    drag(&mut sitting, (400.0, 300.0), (400.0, 300.0));
    write_into(&mut sitting, "mass", "light");
    assert_eq!(sitting.press(Key::F5).at(), "editor");
    assert!(sitting.shows("It cannot be flown until this is mended: player.csv:2"));
}

#[test]
fn a_test_flight_is_nobodys_attempt() {
    let mut sitting = open();
    sitting.press(Key::F5).wait(0.2).press(Key::R);
    assert_eq!(sitting.at(), "test flight");
    sitting.press(Key::Escape);
    draw(&mut sitting, Kind::Deadly, (300.0, 400.0), (500.0, 420.0));
    sitting.press(Key::F5).wait(4.0);
    assert_eq!(sitting.at(), "editor");
    assert!(sitting.shows("Lost after"));
    assert_eq!(sitting.scores_file("attempts.csv"), "");
}

#[test]
fn editing_that_begins_in_a_pause_ends_in_it() {
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(1.0).press(Key::Escape);
    let ticks = sitting.ticks();
    let edit = "Edit Level";
    sitting.click(edit).rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2"));
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    sitting.press(Key::F5).wait(0.5);
    assert_eq!(sitting.at(), "test flight");
    sitting.press(Key::F5);
    control(&mut sitting, Key::S);
    sitting.press_all(&[Key::Escape, Key::Escape, Key::Enter]);
    assert_eq!((sitting.at(), sitting.ticks()), ("pause", ticks));
    sitting.wait(0.5).press(Key::Escape).wait(0.2);
    assert_eq!((sitting.at(), sitting.game().level().world.len()), ("flight", 1));
    // An experiment's copy, too, is made without leaving it.
    let shipped = |root: &std::path::Path| fs::write(root.join("levels/shipped.csv"), "folder\n2\n").unwrap();
    let mut sitting = Sitting::with(shipped);
    sitting.fly("2").wait(1.0).press(Key::Escape).click(edit).rest();
    assert_eq!(sitting.at(), "levels to edit");
    assert_eq!(sitting.press(Key::Escape).at(), "pause");
    sitting.click(edit).press(Key::Enter).rest();
    assert_eq!(sitting.editor().name(), "2-copy");
    assert_eq!(sitting.press_all(&[Key::Escape, Key::Enter]).at(), "pause");
    assert_eq!(sitting.game().level().name, "2");
}

fn fly(sitting: &mut Sitting) {
    sitting.hold(&[Key::Space], 20);
    sitting.hold_until(&[], |sitting| !["test flight", "flight"].contains(&sitting.at()));
}

#[test]
fn a_level_is_drawn_proven_shared_and_flown_elsewhere() {
    let mut sitting = Sitting::new();
    sitting.choose("Editor").click("New").write("yard").press(Key::Enter).rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "yard"));
    // Three goals: one of the ship, and two of keys, of which one lies there and one hangs on a rope.
    draw(&mut sitting, Kind::Pad, (100.0, 700.0), (200.0, 720.0));
    draw(&mut sitting, Kind::KeyPad, (500.0, 700.0), (600.0, 720.0));
    draw(&mut sitting, Kind::Key, (530.0, 640.0), (570.0, 680.0));
    draw(&mut sitting, Kind::KeyPad, (780.0, 290.0), (820.0, 330.0));
    draw(&mut sitting, Kind::Key, (780.0, 280.0), (820.0, 320.0));
    for (form, from, to) in [
        (LinkForm::Rope, (800.0, 300.0), (800.0, 100.0)),
        // A spring between the ship and what lies there is weak enough to fly with.
        (LinkForm::Spring, (550.0, 660.0), (800.0, 310.0)),
    ] {
        sitting.click(form.name());
        drag(&mut sitting, from, to);
    }
    draw(&mut sitting, Kind::Mover, (1000.0, 600.0), (1120.0, 620.0));
    draw(&mut sitting, Kind::Switch, (300.0, 640.0), (360.0, 680.0));
    let wire = sitting.editor().handles().last().unwrap().1;
    drag(&mut sitting, (wire.x, wire.y), (1060.0, 610.0));
    assert_eq!(sitting.editor().document().wires().len(), 1);
    let rows = |table| sitting.editor().document().rows(table).count();
    assert_eq!((rows(Table::Objectives), rows(Table::Links), rows(Table::Movers)), (5, 2, 1));
    sitting.wait(0.3);
    assert!(sitting.editor().problems().iter().all(|(_, refused)| !refused), "{:?}", sitting.editor().problems());

    sitting.click("Fly");
    fly(&mut sitting);
    assert_eq!(sitting.at(), "editor");
    assert!(sitting.shows("Completed in"), "{:?}", sitting.texts());
    sitting.click("Gold").rest();
    assert!(sitting.shows("flights/gold.replay.csv") && !sitting.editor().is_unsaved());
    sitting.click("Back").rest();
    assert!(sitting.shows("proven: Gold"));
    sitting.click("Share").click("yard").rest();
    let file = sitting.folder.path().join("exports/yard.zip");

    let mut other = Sitting::new();
    other.give(Input { dropped: vec![file], ..Input::default() }).rest();
    assert!(other.shows("Installed: yard"));
    other.press(Key::Escape).choose("yard").rest();
    assert_eq!((other.at(), other.flown()), ("flight", "yard"));
    let level = Arc::new(other.game().level().clone());
    let (proven, problems) = pack::proven(&other.folder.path().join("levels/yard"), &level);
    assert!(proven.len() == 1 && proven[0].starts_with("gold") && problems.is_empty(), "{proven:?} {problems:?}");
    fly(&mut other);
    assert_eq!(other.at(), "scoring");
    assert!(other.app.session.journal.medals("yard").medal >= Some(Medal::Silver), "{:?}", other.texts());
}
