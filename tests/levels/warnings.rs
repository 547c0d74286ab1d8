//! Warnings about good levels: goals that nobody can fly to, push, press or earn. `tests/game/built_levels.rs` checks that no warning calls
//! impossible a goal that a flight has met.

use crate::lines;
use crate::support::{Memory, written};
use resultant::game::{Controls, Game, Outcome, SHIP};
use resultant::level;
use std::sync::Arc;

fn warned(files: &[(&'static str, &str)]) -> String {
    warned_with(&[], files)
}

/// As [`warned`], with files in place of the room's.
fn warned_with(instead: &[(&str, &str)], files: &[(&'static str, &str)]) -> String {
    let Memory(mut all) = written::texts(files);
    for (name, text) in instead {
        all.iter_mut().filter(|(file, _)| file == name).for_each(|(_, old)| *old = (*text).to_owned());
    }
    match level::read("room", &Memory(all)) {
        Ok(loaded) => lines(&loaded.warnings),
        Err(problems) => panic!("refused: {}", lines(&problems)),
    }
}

#[test]
fn an_engine_below_the_weight_is_warned_about_where_nothing_else_lifts() {
    let weak = &[("player.csv", "60,844.5,100,500,900\n")];
    let told = "player.csv:1: column \"thrust\": found 900 N, less than the ship's weight of 1000 N, expected more than that";
    assert!(warned_with(weak, &[]).starts_with(told), "{}", warned_with(weak, &[]));
    let lifts: [(&'static str, &str); 3] = [
        ("hazards.csv", "600,850,60,20,0,-300,0,-500\n"),
        ("movers.csv", "300,800,60,20,300 300,2\n"),
        ("gravity.csv", "300,300,300,300,0,-12\n"),
    ];
    for lift in lifts {
        assert!(!warned_with(weak, &[lift]).contains("thrust"), "{lift:?}");
    }
    let downwards = ("hazards.csv", "600,850,60,20,0,-300,0,500\n");
    assert!(warned_with(weak, &[downwards]).contains("thrust"));
    assert_eq!(warned(&[]), "");
}

#[test]
fn a_plate_that_nothing_presses_is_warned_about() {
    let room = |weight: f64| {
        warned(&[("doors.csv", "500,0,20,870,gate\n"), ("switches.csv", &format!("200,860,60,10,gate,{weight},,latched\n"))])
    };
    let told = "switches.csv:1: column \"weight\": found 5000 N, with 3000 N of weight and thrust in all to press it";
    assert!(room(5000.0).starts_with(told), "{}", room(5000.0));
    assert!(room(3000.0).contains("weight") && room(2999.0).is_empty(), "{}", room(2999.0));
    let crate_ = ("objects.csv", "400,850,box:40x40,250,1,FALSE,0\n");
    let doors = ("doors.csv", "500,0,20,870,gate\n");
    assert_eq!(warned(&[doors, crate_, ("switches.csv", "200,860,60,10,gate,5000\n")]), "", "the crate helps");
    let wind = ("hazards.csv", "180,600,100,20,0,250,0,4000\n");
    assert_eq!(warned(&[doors, wind, ("switches.csv", "200,860,60,10,gate,5000,,latched\n")]), "", "the wind helps");
}

#[test]
fn a_switch_behind_its_own_door_and_a_pad_behind_doors_that_nothing_opens_are_warned_about() {
    let doors = "500,0,20,870,gate\n800,0,20,870,hall\n";
    let behind = warned(&[("doors.csv", doors), ("switches.csv", "600,700,60,60,gate\n200,700,60,60,hall\n")]);
    let told = "switches.csv:1: column \"x\": found a switch behind a door that nothing opens, expected ";
    assert!(behind.starts_with("objectives.csv:1:") || behind.starts_with(told), "{behind}");
    let pad = "objectives.csv:1: column \"x\": found an objective behind a door";
    assert!(behind.contains(told) && behind.contains(pad), "{behind}");
    let latched = "200,700,60,60,gate,,,latched\n600,700,60,60,hall,,,latched\n";
    assert_eq!(warned(&[("doors.csv", doors), ("switches.csv", latched)]), "");
    let both = [("doors.csv", "500,0,20,870,a&b\n"), ("switches.csv", "200,700,60,60,a,,,latched\n300,700,60,60,b,,,latched\n")];
    assert_eq!(warned(&both), "");
    let one = warned(&[both[0], ("switches.csv", "200,700,60,60,a\n600,700,60,60,b\n")]);
    assert!(
        one.contains("switches.csv:2: column \"x\": found a switch behind a door that nothing opens") && one.contains(pad),
        "{one}"
    );
    let unworked = warned(&[both[0], ("switches.csv", "200,700,60,60,a\n")]);
    assert!(unworked.starts_with("doors.csv:1: column \"name\": found \"b\", which no switch works"), "{unworked}");
    let crossed = "900,700,60,60,gate\n600,700,60,60,hall\n";
    assert_eq!(warned(&[("doors.csv", doors), ("switches.csv", crossed)]).lines().count(), 3);
    // A door that is open until its switch is pressed, and a crate that presses a switch out of the ship's reach.
    assert_eq!(warned(&[("doors.csv", doors), ("switches.csv", "600,700,60,60,!gate hall,,,latched\n")]), "");
    let crate_ = ("objects.csv", "600,850,box:40x40,50,1,FALSE,0\n");
    assert_eq!(warned(&[("doors.csv", doors), crate_, ("switches.csv", "600,700,60,60,gate hall\n")]), "");
}

#[test]
fn a_wall_of_red_before_a_pad_is_warned_about() {
    let wall = warned(&[("obstacles.csv", "600,0,20,870\n")]);
    let told = "objectives.csv:1: column \"x\": found an objective that the ship gets to through red alone, expected ";
    assert!(wall.starts_with(told) && wall.lines().count() == 1, "{wall}");
    assert_eq!(warned(&[("obstacles.csv", "600,0,20,810\n")]), "", "60 pixels for a ship of 51");
    let switch =
        [("doors.csv", "900,0,20,870,gate\n"), ("obstacles.csv", "600,0,20,870\n"), ("switches.csv", "700,700,60,60,gate\n")];
    assert!(warned(&switch).contains("switches.csv:1: column \"x\": found a switch that the ship gets to through red alone"));
}

/// A link lifts what is too heavy, and presses what is too light.
#[test]
fn whatever_a_link_carries_draws_no_alarm() {
    let key = ("objects.csv", "400,850,box:40x40,75,1,FALSE,0,,,,,k\n");
    let own = [key, ("switches.csv", "200,860,60,10,gate,5000\n"), ("doors.csv", "500,0,20,870,gate\n")];
    let weak = &[("player.csv", "60,844.5,100,0,900\n")];
    assert!(warned(&own).contains("\"weight\"") && warned_with(weak, &[]).contains("\"thrust\""));
    let to_ship = ["rope,ship,600 50,,5000,100,,,,-1\n", "spring,ship,600 50,100,200,10\n", "magnet,ship,900 100,,,,5000\n"];
    let to_key = ["rope,k,500 100,,5000,100,,,,-1\n", "rope,ship,k,300,5000,100\n", "magnet,ship,k,,,,5000,touch\n"];
    for link in to_ship.into_iter().chain(to_key) {
        assert_eq!(warned(&[&own[..], &[("links.csv", link)]].concat()), "", "{link}");
        assert_eq!(warned_with(weak, &[key, ("links.csv", link)]), "", "{link}");
    }
    let pool = ("fluids.csv", "300,500,300,300,1000,0.001\n");
    assert_eq!(warned_with(weak, &[pool]), "", "a liquid lifts");
}

/// A goal that a falling or sliding ship gets to needs no engine that lifts it, and a body that bounces or is thrown may lift it.
#[test]
fn an_engine_below_the_weight_is_enough_for_what_lies_below_or_beside() {
    let told = |player: &str, goal: &str, more: &[(&'static str, &str)]| {
        warned_with(&[("player.csv", player), ("objectives.csv", goal)], more)
    };
    let weak = "60,400,100,500,900\n";
    let (below, beside, above) = ("PLAYER,60,860,10,10\n", "PLAYER,1190,400,10,10\n", "PLAYER,1190,0,10,10\n");
    assert_eq!(told(weak, below, &[]), "");
    assert!(!told(weak, beside, &[]).contains("thrust"));
    assert!(told(weak, above, &[]).contains("thrust"));
    let thrown = ("objects.csv", "400,850,box:40x40,75,1,FALSE,0,-9,-9\n");
    for lift in [thrown, ("objects.csv", "400,850,box:40x40,75,1,FALSE,0.5\n"), ("doors.csv", "500,0,20,870,gate\n")] {
        assert!(!told(weak, above, &[lift]).contains("thrust"), "{lift:?}");
    }
    assert!(!told("60,400,100,500,900,TRUE,0,-20\n", above, &[]).contains("thrust"));
}

/// A body that a link pulls reaches others where nobody gets to.
#[test]
fn what_a_linked_body_pushes_is_reached() {
    let chamber = "400,400,200,10\n400,590,200,10\n400,400,10,200\n590,400,10,200\n";
    let objects = "460,560,box:20x20,5,1,FALSE,0,,,,,a\n520,560,box:20x20,5,1,FALSE,0,,,,,b\n";
    let own = [("world.csv", chamber), ("objects.csv", objects)];
    assert_eq!(warned(&own).matches("an object that no one can reach").count(), 2);
    assert_eq!(warned(&[own[0], own[1], ("links.csv", "magnet,ship,a,,,,50\n")]), "");
}

/// A ship and objectives are neither asked for nor read there, and nothing is tied to a ship.
#[test]
fn an_experiment_has_no_ship_and_no_objectives() {
    let read = |more: &[(&'static str, &str)]| {
        let own = [("constants.csv", "experiment,1\nwidth,900\nheight,600\n"), ("objects.csv", "450,300,box:30x30,10,0,FALSE,0\n")];
        let files = own.iter().chain(more).map(|(file, text)| (*file, (*text).to_owned()));
        level::read("lone", &Memory(files.collect())).map_err(|problems| lines(&problems))
    };
    let lone = read(&[]).unwrap();
    assert!(lone.warnings.is_empty() && lone.level.objectives.is_empty() && !lone.level.ship_plays());
    let more = [("player.csv", "no ship\n"), ("objectives.csv", "PLAYER,10,10,20,20\n")];
    assert_eq!(read(&more).unwrap().level, lone.level);
    assert!(read(&[("links.csv", "a,b,stiffness\nship,450 10,5\n")]).unwrap_err().contains("an experiment has no ship"));
    let mut game = Game::new(Arc::new(lone.level)).unwrap();
    let parked = game.world().body(SHIP).clone();
    (0..300).for_each(|_| game.step(Controls { thrust: true, ..Controls::default() }));
    assert!(game.outcome() == Outcome::Running && game.world().body(SHIP) == &parked, "nothing moves it");
}
