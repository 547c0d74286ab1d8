//! Warnings about good levels: goals that nobody can fly to, push, press or earn. `tests/game/built_levels.rs` checks that no warning calls
//! impossible a goal that a flight has met.

use crate::support::{Memory, written};
use crate::{lines, package};
use resultant::game::{Controls, Game, Outcome, SHIP};
use resultant::level;
use std::sync::Arc;

/// The warnings about the room with these files.
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
fn too_little_fuel_for_the_climb_or_the_distance_is_warned_about() {
    // 28 m up: √(2·10·28) m/s, of which a second of burning gives 20.
    let flown = |fuel: f64, y: f64, goal: &str, more: &[(&'static str, &str)]| {
        let player = format!("60,{y},100,{fuel},2000\n");
        warned_with(&[("player.csv", &player), ("objectives.csv", goal)], more)
    };
    let corner = "PLAYER,1190,0,10,10\n";
    let one = flown(1.0, 844.5, corner, &[]);
    let told = "player.csv:1: column \"fuel\": found 1 fuel units, expected at least 23.";
    assert!(one.starts_with(told) && one.ends_with("no flight to line 1 of objectives.csv takes\n"), "{one}");
    assert_eq!(flown(26.0, 844.5, corner, &[]), "");
    assert_eq!(flown(1.0, 844.5, corner, &[("pods.csv", "300,800,30,30,25\n")]), "");
    // Along the floor; a little above it, and to a key that nothing else moves.
    let key = "PHYS,1100,860,60,10\nOBJECT,600,850,box:40x40,75,120,220,190,0,0.5\n";
    let pad = "PLAYER,1100,860,60,10\n";
    for (y, goal) in [(844.5, pad), (844.0, pad), (844.0, key)] {
        for fuel in [0.0, 1.0] {
            let found = flown(fuel, y, goal, &[]);
            assert!(found.contains(&format!("found {fuel} fuel units")), "{fuel}: {found}");
        }
        assert_eq!(flown(20.0, y, goal, &[]), "");
    }
}

#[test]
fn a_plate_that_nothing_presses_is_warned_about() {
    let room =
        |weight: f64| warned(&[("doors.csv", "500,0,20,870,gate\n"), ("switches.csv", &format!("200,860,60,10,gate,{weight}\n"))]);
    let told = "switches.csv:1: column \"weight\": found 5000 N, with 3000 N of weight, thrust and wind in all to press it";
    assert!(room(5000.0).starts_with(told), "{}", room(5000.0));
    assert!(room(3000.0).contains("weight") && room(2999.0).is_empty(), "{}", room(2999.0));
    let crate_ = ("objects.csv", "400,850,box:40x40,250,1,FALSE,0\n");
    let doors = ("doors.csv", "500,0,20,870,gate\n");
    assert_eq!(warned(&[doors, crate_, ("switches.csv", "200,860,60,10,gate,5000\n")]), "", "the crate helps");
    let wind = ("hazards.csv", "180,600,100,20,0,250,0,4000\n");
    assert_eq!(warned(&[doors, wind, ("switches.csv", "200,860,60,10,gate,5000\n")]), "", "the wind helps");
}

#[test]
fn a_switch_behind_its_own_door_and_a_pad_behind_doors_that_nothing_opens_are_warned_about() {
    let doors = "500,0,20,870,gate\n800,0,20,870,hall\n";
    let behind = warned(&[("doors.csv", doors), ("switches.csv", "600,700,60,60,gate\n200,700,60,60,hall\n")]);
    let told = "switches.csv:1: column \"x\": found a switch behind its own door, line 1 of doors.csv, expected ";
    assert!(behind.starts_with("objectives.csv:1:") || behind.starts_with(told), "{behind}");
    let pad = "objectives.csv:1: column \"x\": found an objective behind a door";
    assert!(behind.contains(told) && behind.contains(pad), "{behind}");
    // One door after the other.
    assert_eq!(warned(&[("doors.csv", doors), ("switches.csv", "200,700,60,60,gate\n600,700,60,60,hall\n")]), "");
    // A door that two switches open together.
    let both = [("doors.csv", "500,0,20,870,a&b\n"), ("switches.csv", "200,700,60,60,a\n300,700,60,60,b\n")];
    assert_eq!(warned(&both), "");
    let one = warned(&[both[0], ("switches.csv", "200,700,60,60,a\n600,700,60,60,b\n")]);
    assert!(one.contains("switches.csv:2: column \"x\": found a switch behind its own door") && one.contains(pad), "{one}");
    let unworked = warned(&[both[0], ("switches.csv", "200,700,60,60,a\n")]);
    assert!(unworked.starts_with("doors.csv:1: column \"name\": found \"b\", which no switch works"), "{unworked}");
    // Two rooms that wait for each other.
    let crossed = "900,700,60,60,gate\n600,700,60,60,hall\n";
    assert_eq!(warned(&[("doors.csv", doors), ("switches.csv", crossed)]).lines().count(), 3);
    // A door that is open until its switch is pressed, and a crate that presses a switch out of the ship's reach.
    assert_eq!(warned(&[("doors.csv", doors), ("switches.csv", "600,700,60,60,!gate hall\n")]), "");
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

#[test]
fn a_key_below_a_step_is_warned_about_unless_something_lifts_it() {
    let step = |height: f64, more: &[(&'static str, &str)]| {
        let block = format!("700,{},500,{height}\n", 870.0 - height);
        let goal = format!("PHYS,900,{},60,10\nOBJECT,400,850,box:40x40,75,120,220,190,0.2,0.5\n", 860.0 - height);
        let files = [&[("world.csv", block.as_str()), ("objectives.csv", goal.as_str())], more].concat();
        warned(&files)
    };
    let told = "objectives.csv:2: column \"y\": found an objective up a step that no key which fits can be pushed over, expected ";
    assert!(step(160.0, &[]).starts_with(told), "{}", step(160.0, &[]));
    assert_eq!(step(10.0, &[]), "", "a hit makes it hop so far");
    assert_eq!(step(160.0, &[("movers.csv", "500,850,60,20,500 600,2\n")]), "");
    assert_eq!(step(160.0, &[("world.csv", "300,870,5,5,Trampoline\n300,400,200,20\n")]).lines().count(), 1);
    // From a ledge as high as the step the ship lifts it, or lets it fall there.
    let ledge = ("objectives.csv", "OBJECT,100,400,box:40x40,75,120,220,190,0.2,0.5\n");
    assert_eq!(step(160.0, &[("world.csv", "60,420,200,20\n"), ledge]), "");
}

/// Levels that win themselves, or with a rope from the ship. Each draws its alarms without the link.
#[test]
fn whatever_a_link_carries_draws_no_alarm() {
    let key = "PHYS,900,700,60,10\nOBJECT,400,850,box:40x40,75,120,220,190,0.2,0.5,,,,,k\n";
    let own: [(&'static str, &str); 5] = [
        ("world.csv", "700,710,500,160\n"),
        ("objectives.csv", key),
        ("switches.csv", "200,860,60,10,gate,5000\n"),
        ("doors.csv", "500,0,20,100,gate\n"),
        ("constants.csv", "gold,0.1\nmark_pushes,0\n"),
    ];
    let alone = warned(&own);
    for alarm in ["\"y\": found an objective up a step", "\"weight\"", "0.1 s for gold", "found 0 pushes"] {
        assert!(alone.contains(alarm), "{alarm}: {alone}");
    }
    let weak = &[("player.csv", "60,844.5,100,0,900\n")];
    let to_ship = ["rope,ship,600 50,,5000,100,,,,-1\n", "spring,ship,600 50,100,200,10\n", "magnet,ship,900 100,,,,5000\n"];
    let to_key = ["rope,k,500 100,,5000,100,,,,-1\n", "rope,ship,k,300,5000,100\n", "magnet,ship,k,,,,5000,touch\n"];
    for link in to_ship.into_iter().chain(to_key) {
        let links = ("links.csv", link);
        assert_eq!(warned(&[&own[..], &[links]].concat()), "", "{link}");
        if to_ship.contains(&link) {
            assert_eq!(warned_with(weak, &[links]), "", "{link}");
        }
    }
    assert!(warned_with(weak, &[]).contains("\"thrust\""));
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

#[test]
fn medals_that_nobody_can_earn_are_warned_about() {
    let with = |constants: &str| warned(&[("constants.csv", constants)]);
    // 37 m aside and 27 up, with 30 m/s² at the most.
    let gold = with("gold,0.1\n");
    let told = "constants.csv:5: column \"value\": found 0.1 s for gold, expected at least 1.7";
    assert!(gold.starts_with(told) && gold.ends_with("no flight to line 1 of objectives.csv takes\n"), "{gold}");
    assert_eq!(with("silver,0.2\ngold,0.1\n").lines().count(), 2);
    assert_eq!(with("gold,5\n"), "");
    let fuel = with("mark_fuel,100\n");
    assert!(fuel.starts_with("constants.csv:5: column \"value\": found 100 % of the fuel left, expected at most 95."), "{fuel}");
    assert_eq!(with("mark_fuel,90\n"), "");
    assert_eq!(with("mark_hits,0\n"), "");
    let player = ("player.csv", "60,844.5,100,500,2000,TRUE,8\n");
    assert!(warned_with(&[player], &[("constants.csv", "mark_speed,7\n")]).contains("7 m/s, with a start at 8.000 m/s"));
    let key = ("objectives.csv", "PHYS,900,860,60,10\nOBJECT,400,850,box:40x40,75,120,220,190,0.2,0.5\n");
    assert!(warned(&[key, ("constants.csv", "mark_pushes,0\n")]).contains("found 0 pushes, expected at least 1"));
    assert_eq!(warned(&[key, ("constants.csv", "mark_pushes,1\n")]), "");
}

#[test]
fn no_experiment_is_warned_about() {
    let experiments = package().join("experiments");
    for name in level::list(&experiments) {
        let loaded =
            level::load(&experiments.join(&name), package()).unwrap_or_else(|problems| panic!("{name}: {}", lines(&problems)));
        assert_eq!(lines(&loaded.warnings), "", "{name}");
    }
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
