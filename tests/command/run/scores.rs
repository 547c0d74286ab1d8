//! `resultant verify --scores`, `pack` and `unpack`, through the program.

use crate::support::program::{Data, Ran, resultant};
use crate::support::shipped::{copy_fixture, fixtures, record as flight};
use resultant::game::Replay;
use resultant::scores::{Name, PATIENCE, Score, Scores};
use std::fs;

/// A data folder with two levels, and a board of level 1 with ann's flight for gold.
fn data() -> Data {
    let data = Data::new();
    ["1", "2"].iter().for_each(|level| copy_fixture(level, &data.path(".")));
    data.write("assets/keep", "");
    save(&data, "1", "ann", &flight("1", "gold"));
    data
}

fn save(data: &Data, level: &str, user: &str, flight: &Replay) {
    let name = Name::new(user).unwrap();
    let score = Score { name: &name, points: flight.score, flight: Some(flight), version: None };
    Scores::new(data.path("scores")).save_within(PATIENCE, level, score).unwrap();
}

#[test]
fn boards_are_proven_and_what_does_not_hold_is_named() {
    let data = data();
    save(&data, "1", "bob", &flight("1", "careful"));
    save(&data, "2", "ann", &flight("2", "mark"));
    fs::write(data.path("scores/jumper.csv"), "name,score\nann,12\n").unwrap();
    fs::write(data.path("scores/players.csv"), "player,level,time,medal,mark\n").unwrap();
    let held = data.resultant(&["verify", "--scores"]);
    assert_eq!((held.status, held.out.as_str(), held.err.as_str()), (0, "1: 2 proven\n2: 1 proven\n", ""));
    // A row without a flight can be neither proven nor refused.
    let board = fs::read_to_string(data.path("scores/1.csv")).unwrap();
    fs::write(data.path("scores/1.csv"), format!("{board}old,5\n")).unwrap();
    let held = data.resultant(&["verify", "--scores"]);
    assert_eq!((held.status, held.out.as_str()), (0, "1: 2 proven, 1 unproven\n2: 1 proven\n"));
    // One that is forged.
    let points = flight("1", "gold").score;
    fs::write(data.path("scores/1.csv"), board.replace(&format!("ann,{points}"), "ann,29999")).unwrap();
    let forged = data.resultant(&["verify", "--scores"]);
    assert_eq!((forged.status, forged.out.as_str()), (1, "1: 1 proven, 1 not\n2: 1 proven\n"));
    assert_eq!(
        forged.err,
        "1: rank 1, ann, 29999 points: does not hold: 29999 points are more than the 21000 that the rules allow\n"
    );
}

#[test]
fn a_flight_under_another_name_and_an_emptied_row_are_told() {
    let data = data();
    let board = fs::read_to_string(data.path("scores/1.csv")).unwrap();
    let row = board.lines().nth(1).unwrap();
    let file = row.split(',').nth(2).unwrap();
    // bob's row leads to ann's flight, cid's to a copy of it, dan's to nothing any more, and eve's was never flown.
    fs::copy(data.path("scores/flights/1").join(file), data.path("scores/flights/1/copy.replay.csv")).unwrap();
    let others = format!(
        "{}\n{}\n{}\neve,20999\n",
        row.replacen("ann,", "bob,", 1),
        row.replacen("ann,", "cid,", 1).replace(file, "copy.replay.csv"),
        row.replacen("ann,", "dan,", 1).replace(file, "")
    );
    fs::write(data.path("scores/1.csv"), board.clone() + &others).unwrap();
    fs::write(data.path("scores/players.csv"), "player,level,time,medal,mark\neve,1,0.01,gold,TRUE\n").unwrap();
    let told = data.resultant(&["verify", "--scores"]);
    assert_eq!(
        (told.status, told.out.as_str()),
        (1, "1: 1 proven, 1 unproven, 3 not\nplayers.csv: 1 levels done, on the players' own word\n")
    );
    let lines: Vec<&str> = told.err.lines().collect();
    assert!(
        lines[0].ends_with("rank 3, bob, 18222 points: does not hold: its flight stands under the name ann, too"),
        "{}",
        told.err
    );
    assert!(lines[1].ends_with("rank 4, cid, 18222 points: does not hold: its flight was saved by ann"), "{}", told.err);
    assert!(lines[2].contains("rank 5, dan, 18222 points: does not hold: the row says how it was flown"), "{}", told.err);
}

#[test]
fn an_edited_level_has_another_board_and_a_level_that_is_gone_none() {
    let data = data();
    let world = data.path("levels/1/world.csv");
    let before = fs::read_to_string(&world).unwrap();
    fs::write(&world, format!("{before}0,0,1,1\n")).unwrap();
    let edited = data.resultant(&["verify", "--scores"]);
    let told = "1: 0 proven; 1 boards of other versions of the level aside\n";
    assert_eq!((edited.status, edited.out.as_str(), edited.err.as_str()), (0, told, ""));
    // Its row without word of a version is found all the same.
    let board = fs::read_to_string(data.path("scores/1.csv")).unwrap();
    let version = flight("1", "gold").level_hash;
    fs::write(data.path("scores/1.csv"), board.replace(&format!(",{version},"), ",,")).unwrap();
    let found = data.resultant(&["verify", "--scores"]);
    assert_eq!(found.status, 1);
    assert!(found.err.contains("recorded in a level with the hash"), "{}", found.err);
    fs::remove_dir_all(data.path("levels/1")).unwrap();
    let gone = data.resultant(&["verify", "--scores"]);
    assert_eq!((gone.status, gone.out.as_str()), (1, "1: 0 proven, 1 not\n"));
    assert!(gone.err.contains("the level cannot be flown"), "{}", gone.err);
    assert_eq!(data.resultant(&["verify", "--scores", "x.csv"]).status, 2);
    assert_eq!(data.resultant(&["verify"]).status, 2);
}

#[test]
fn a_level_is_packed_and_unpacked_elsewhere_and_nothing_is_written_over() {
    let there = Data::new();
    let zip = there.path("tower.zip");
    let pack = || Ran::new(resultant().arg("--data").arg(fixtures()).args(["pack", "15", "--out"]).arg(&zip));
    let packed = pack();
    assert_eq!((packed.status, packed.err.as_str()), (0, ""), "{packed:?}");
    assert!(packed.out.contains("files, 3 flights, "), "{}", packed.out);
    let again = pack();
    assert_eq!(again.status, 2);
    assert!(again.err.contains("there is a file of that name already"), "{}", again.err);
    let zip = zip.to_str().unwrap();
    let unpacked = there.resultant(&["unpack", zip]);
    assert_eq!(unpacked.status, 0, "{unpacked:?}");
    assert_eq!(there.resultant(&["check", "15"]).status, 0);
    let flown = there.resultant(&["verify", there.path("levels/15/flights/gold.replay.csv").to_str().unwrap()]);
    assert_eq!(flown.status, 0, "{flown:?}");
    assert!(there.resultant(&["unpack", zip]).out.ends_with("there already\n"));
    fs::write(there.path("levels/15/mine.txt"), "mine").unwrap();
    assert!(there.resultant(&["unpack", zip]).out.ends_with("there already, and more in its folder: mine.txt\n"));
    fs::write(there.path("levels/15/texts.csv"), "x,y,size,text\n1,1,20,mine\n").unwrap();
    let taken = there.resultant(&["unpack", zip]);
    assert_eq!(taken.status, 2);
    assert!(taken.err.contains("--as NAME"), "{}", taken.err);
    assert_eq!(fs::read_to_string(there.path("levels/15/texts.csv")).unwrap(), "x,y,size,text\n1,1,20,mine\n");
    assert_eq!(there.resultant(&["unpack", zip, "--as", "mill"]).status, 0);
    assert_eq!(there.resultant(&["check", "mill"]).status, 0);
    assert_eq!(there.resultant(&["unpack", zip, "--as", "../mill"]).status, 2);
    assert_eq!(there.resultant(&["unpack", "/nowhere.zip"]).status, 2);
    let bad = there.write("bad.zip", "no archive");
    let refused = there.resultant(&["unpack", &bad]);
    assert_eq!(refused.status, 2);
    assert!(refused.err.contains("bad.zip: found no ZIP archive"), "{}", refused.err);
    assert_eq!(there.resultant(&["pack", "none"]).status, 2);
}
