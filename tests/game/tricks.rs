//! Marks for tricks: burns, stars, objectives together; from a level's files to the prize.

use crate::support::Memory;
use crate::support::rooms::{REVERSE, THRUST, fly};
use crate::support::written::{begun, texts};
use resultant::game::{Controls, Game, GameEvent, Medals, Outcome};
use resultant::level::{self, Mark};
use std::sync::Arc;

fn press(game: &mut Game, steps: &[(Controls, u32)]) {
    steps.iter().for_each(|(controls, ticks)| fly(game, *controls, *ticks));
}

#[test]
fn a_burn_begins_after_a_tenth_of_a_second_without_one() {
    let off = Controls::default();
    for (steps, burns) in [
        (&[(off, 30)][..], 0),
        (&[(THRUST, 1)], 1),
        (&[(THRUST, 20), (off, 11), (THRUST, 20)], 1),
        (&[(THRUST, 20), (off, 12), (THRUST, 20)], 2),
        (&[(THRUST, 20), (off, 12), (REVERSE, 20), (THRUST, 3), (off, 12), (REVERSE, 1)], 3),
        (&[(Controls { thrust: true, reverse: true, ..off }, 60)], 0),
    ] {
        let mut game = begun(&[]);
        press(&mut game, steps);
        assert_eq!(game.result().burns, burns, "{steps:?}");
    }
}

/// Two burns that lift the ship to a pad above its start.
fn completed(files: &[(&'static str, &str)]) -> Game {
    let Memory(mut texts) = texts(files);
    texts.retain(|(file, _)| *file != "objectives.csv");
    texts.push(("objectives.csv", "PLAYER,0,700,120,30\n".to_owned()));
    let loaded = level::read("room", &Memory(texts)).unwrap();
    let mut game = Game::new(Arc::new(loaded.level)).unwrap();
    press(&mut game, &[(THRUST, 12), (Controls::default(), 12), (THRUST, 200)]);
    assert_eq!((game.outcome(), game.result().burns), (Outcome::Completed, 2));
    game
}

#[test]
fn few_burns_earn_the_mark() {
    for (most, lacks) in [(1, true), (2, false)] {
        let game = completed(&[("constants.csv", &format!("mark_burns,{most}\n"))]);
        assert_eq!(!Medals::of(&game.level().awards, &game.result()).mark, lacks, "{most}");
    }
}

#[test]
fn a_star_is_touched_once_by_those_who_may_at_any_speed() {
    // A crate and a key fall through stars beside each other at more than their height a tick.
    let objects = ("objects.csv", "x,y,image,mass,drag,circular,restitution,vx,vy\n345,100,box:30x30,5,0,FALSE,0,0,900\n");
    let keys = ("objectives.csv", "OBJECT,600,100,box:30x30,10,200,0,200,0,0,0,900\n");
    let stars = "340,600,10,3,object\n345,600,10,3,key\n345,600,10,3,\n595,600,10,3,key\n595,600,10,3,object\n";
    let mut game = begun(&[objects, keys, ("stars.csv", stars), ("world.csv", "300,800,400,70\n")]);
    let mut told = Vec::new();
    for _ in 0..120 {
        game.step(Controls::default());
        told.extend(game.events().iter().filter(|event| matches!(event, GameEvent::StarTouched(_))).cloned());
    }
    assert_eq!(game.stars(), [true, false, false, true, true]);
    assert_eq!((told.len(), game.result().stars_left), (3, 2), "each once");
}

#[test]
fn every_star_earns_the_mark() {
    for (second, lacks) in [("60,780,10,10\n", false), ("200,780,10,10\n", true)] {
        let stars = "60,760,10,10\n".to_owned() + second;
        let game = completed(&[("stars.csv", &stars)]);
        assert_eq!(game.level().awards.mark, Some(Mark::Stars));
        assert_eq!(!Medals::of(&game.level().awards, &game.result()).mark, lacks, "{second}");
        assert_eq!(game.result().stars_left, usize::from(lacks));
    }
}

#[test]
fn goals_together_are_met_within_their_time() {
    // Two areas above each other, some 0.75 s apart, and the room's own pad in the ship's way.
    let pads = "PLAYER,0,700,120,30,,1\nPLAYER,0,500,120,30,,2\n";
    let mut game = begun(&[("constants.csv", "mark_together,2 0.5\n"), ("objectives.csv", pads)]);
    press(&mut game, &[(THRUST, 240)]);
    let slow = game.result().together;
    assert!(slow > 0.3 && slow < 2.0, "{slow} s");
}

#[test]
fn what_no_flight_can_do_is_refused() {
    let refused = |files: &[(&'static str, &str)]| {
        let problems = level::read("room", &texts(files)).map(|_| ()).unwrap_err();
        problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    for text in ["8", "1 8", "2.5 8", "2 0", "2 8 9", "two 8"] {
        let told = refused(&[("constants.csv", &format!("mark_together,{text}\n"))]);
        assert!(told.starts_with("constants.csv:5: column \"value\": found"), "{text}: {told}");
    }
    let more = "constants.csv:5: column \"value\": found 2 objectives of 1 for mark_together, expected at most 1 in a level";
    assert_eq!(refused(&[("constants.csv", "mark_together,2 8\n")]), more);
    let beside = "stars.csv:1: column \"x\": found a star beside mark_fuel, expected one mark a level";
    assert_eq!(refused(&[("constants.csv", "mark_fuel,50\n"), ("stars.csv", "100,100,30,30\n")]), beside);
    let by = "stars.csv:2: column \"by\": found \"crate\", expected one of ship, key, object";
    assert_eq!(refused(&[("stars.csv", "x,y,width,height,by\n100,100,30,30,crate\n")]), by);
}
