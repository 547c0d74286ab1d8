//! Levels that are not finished, and the flights that are possible in them.

use crate::lines;
use crate::support::Memory;
use resultant::game::{Controls, Game, Outcome};
use resultant::level::{self, Look};
use std::sync::Arc;

const CONSTANTS: (&str, &str) = ("constants.csv", "name,value\nwidth,800\nheight,600\n");
const PLAYER: (&str, &str) = ("player.csv", "x,y,mass,fuel,thrust\n400,300,100,500,3000\n");

fn files(files: &[(&'static str, &str)]) -> Memory {
    Memory(files.iter().map(|(name, text)| (*name, (*text).to_owned())).collect())
}

#[test]
fn a_ship_and_a_size_are_enough_and_no_pad_is_ever_met() {
    let files = files(&[CONSTANTS, PLAYER]);
    let refused = level::read("l", &files).unwrap_err();
    let loaded = level::read_unfinished("l", &files).unwrap();
    assert_eq!(lines(&loaded.warnings), lines(&refused), "the warnings are the problems of a finished level");
    let mut game = Game::new(Arc::new(loaded.level)).unwrap();
    (0..240).for_each(|_| game.step(Controls { thrust: true, ..Controls::default() }));
    assert_eq!((game.outcome(), game.ticks()), (Outcome::Running, 240));
    for only in [CONSTANTS, PLAYER] {
        assert!(level::read_unfinished("l", &self::files(&[only])).is_err(), "{} alone", only.0);
    }
}

#[test]
fn what_cannot_be_read_or_placed_is_left_out_and_a_missing_picture_is_a_box() {
    let files = files(&[
        CONSTANTS,
        PLAYER,
        ("world.csv", "0,580,800,20\n100,wide,10,10\n"),
        ("objects.csv", "100,100,nowhere.png,50,1,FALSE,0\n200,100,box:40x40,50,1,FALSE,0\n300,595,box:40x40,50,1,FALSE,0\n"),
        ("switches.csv", "0,0,10,10,gate\n"),
        ("objectives.csv", "PHYS,10,10,20,20\n"),
    ]);
    let loaded = level::read_unfinished("l", &files).unwrap();
    let told = lines(&loaded.warnings);
    for place in ["world.csv:2", "objects.csv:1", "objects.csv:3", "switches.csv:1", "objectives.csv:1"] {
        assert!(told.contains(place), "{place}: {told}");
    }
    let level = loaded.level;
    assert_eq!((level.world.len(), level.objects.len(), level.switches.len(), level.objectives.len()), (1, 2, 1, 1));
    assert_eq!((&level.objects[0].look, level.objects[0].size.x), (&Look::Box, 40.0 / 30.0));
    assert!(Game::new(Arc::new(level)).is_ok());
}

#[test]
fn a_ship_without_a_place_cannot_be_flown() {
    let inside = files(&[CONSTANTS, PLAYER, ("world.csv", "300,200,200,200\n")]);
    let refused = lines(&level::read_unfinished("l", &inside).unwrap_err());
    assert!(refused.contains("player.csv:2: column") && refused.contains("the ship"), "{refused}");
}
