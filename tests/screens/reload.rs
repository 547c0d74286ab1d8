//! A level whose files change while it is flown.

use crate::sitting::{FAR_AWAY, Sitting, level};
use crate::what_if::{message, type_in, varying};
use resultant::level::Parameter;
use resultant::physics::DVec2;
use resultant::screens::{Input, Key};
use std::fs;
use std::path::PathBuf;

const BROKEN: &str = "The files do not load now";

fn file(sitting: &Sitting, name: &str) -> PathBuf {
    sitting.folder.path().join("levels/2").join(name)
}

fn solids(sitting: &Sitting) -> usize {
    sitting.game().level().world.len()
}

#[test]
fn a_saved_file_is_there_within_half_a_second_and_the_flight_goes_on_where_it_was() {
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(0.3);
    let before = sitting.game().clone();
    fs::write(file(&sitting, "world.csv"), "0,580,800,20\n").unwrap();
    let frames = (0..60).find(|_| solids(sitting.rest()) == 1).expect("it is read");
    assert!(frames <= 28, "{frames} frames of a 60th of a second");
    let game = sitting.game();
    let fallen = game.world().body(resultant::game::SHIP).position - before.world().body(resultant::game::SHIP).position;
    assert!(fallen.length() < 4.0 && fallen.y > 0.0, "{fallen}");
    assert!(game.ticks() > before.ticks() && game.fuel() == before.fuel());
    assert!(sitting.shows("Read again: you fly on in it, with help."));
    assert!(sitting.flight().is_assisted(), "what was flown in two levels is no score");
    sitting.press(Key::R);
    assert_eq!((sitting.game().level().player.position, solids(&sitting)), (DVec2::new(400.0, 300.0) / 30.0, 1));
    assert!(!sitting.flight().is_assisted() && !sitting.shows("Read again"));
}

#[test]
fn where_the_ship_has_no_room_the_level_begins_again() {
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(0.3);
    fs::write(file(&sitting, "player.csv"), "100,100,100,500,3000\n").unwrap();
    fs::write(file(&sitting, "world.csv"), "200,200,600,400\n").unwrap();
    sitting.wait(0.4);
    assert!(sitting.shows("Read again, from its start."));
    assert!((sitting.game().world().body(resultant::game::SHIP).position.x - 100.0 / 30.0).abs() < 0.1);
}

#[test]
fn a_broken_edit_is_reported_above_the_flight_until_it_is_mended() {
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(0.2);
    let sound = fs::read(file(&sitting, "objectives.csv")).unwrap();
    fs::write(file(&sitting, "objectives.csv"), "PLAYER,10,ten,20,20\n").unwrap();
    sitting.wait(0.4);
    assert!(sitting.shows(BROKEN));
    let problem = "objectives.csv:1: column \"y\": found \"ten\"";
    assert!(sitting.texts().iter().any(|(line, _)| line.starts_with(problem)), "{:?}", sitting.texts());
    let ticks = sitting.ticks();
    sitting.wait(0.2);
    assert!(sitting.ticks() > ticks && sitting.shows(BROKEN));
    sitting.press(Key::R);
    assert!(sitting.ticks() < 5 && sitting.shows(BROKEN));
    fs::write(file(&sitting, "objectives.csv"), sound).unwrap();
    sitting.wait(0.4);
    assert!(!sitting.shows(BROKEN));
}

#[test]
fn r_reads_the_files_afresh_at_once() {
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(0.05);
    fs::write(file(&sitting, "world.csv"), "0,580,800,20\n").unwrap();
    assert_eq!(solids(sitting.press(Key::R)), 1);
    sitting.wait(0.5);
    assert!(!sitting.shows("Read again"), "it is known already");
}

#[test]
fn a_paused_flight_is_read_again_too_and_stays_paused() {
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(0.1).press(Key::Escape);
    fs::write(file(&sitting, "world.csv"), "0,580,800,20\n").unwrap();
    sitting.wait(0.4);
    assert_eq!((sitting.at(), solids(&sitting)), ("pause", 1));
}

#[test]
fn what_is_dropped_on_the_window_opens() {
    let mut sitting = Sitting::new();
    let elsewhere = tempfile::tempdir().unwrap();
    level(elsewhere.path(), "mine", FAR_AWAY, "");
    let folder = elsewhere.path().join("levels/mine");
    for path in [folder.clone(), folder.join("player.csv")] {
        sitting.give(Input { dropped: vec![path], ..Input::default() });
        assert_eq!((sitting.at(), sitting.flown()), ("flight", "mine"));
        fs::write(folder.join("world.csv"), "0,580,800,20\n").unwrap();
        sitting.wait(0.4);
        assert_eq!(solids(sitting.press(Key::R)), 1);
    }
    fs::write(folder.join("player.csv"), "1,2\n").unwrap();
    sitting.give(Input { dropped: vec![folder], ..Input::default() });
    assert_eq!(sitting.at(), "problems");
    sitting.give(Input { dropped: vec![elsewhere.path().join("nothing/there")], ..Input::default() });
    assert_eq!(sitting.at(), "problems");
}

#[test]
fn what_the_flight_does_not_depend_on_changes_nothing_of_it() {
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(0.2);
    fs::write(file(&sitting, "obstacles.csv"), "# a comment\n").unwrap();
    sitting.wait(0.5);
    assert!(!sitting.flight().is_assisted() && !sitting.shows("Read again"));
}

#[test]
fn an_edit_of_the_files_varies_the_new_level_from_its_start() {
    let mut sitting = varying();
    sitting.wait(0.3);
    type_in(&mut sitting, Parameter::Gravity, "3");
    let file = sitting.folder.path().join("levels/2/player.csv");
    fs::write(&file, "x,y,mass,fuel,thrust\n300,300,50,500,3000\n").unwrap();
    sitting.wait(0.4);
    let flight = sitting.flight();
    assert_eq!((flight.game().level().gravity, flight.game().level().player.mass), (3.0, 50.0));
    assert!(flight.game().time() < 0.4 && flight.variation().is_some() && flight.is_assisted());
    // A number of an object that is gone cannot vary: the level is flown as it is, as a fresh attempt.
    sitting.press(Key::Tab).press_all(&[Key::N, Key::N]).rest();
    type_in(&mut sitting, Parameter::Mass(1), "3");
    fs::remove_file(sitting.folder.path().join("levels/2/objects.csv")).unwrap();
    sitting.wait(0.4);
    let flight = sitting.flight();
    assert!(flight.variation().is_none() && flight.game().level().gravity == 15.0 && !flight.is_assisted());
    assert!(message(&mut sitting).is_some_and(|(_, bad)| bad));
}
