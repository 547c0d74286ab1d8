//! `resultant verify --scores`, `pack` and `unpack`, through the program.

use crate::support::program::{Data, Ran, resultant};
use crate::support::shipped::{copy_fixture, fixtures, record as flight};
use resultant::game::Replay;
use resultant::scores::{Name, Score, Scores};
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
    let score = Score { name: &name, points: flight.score, flight: Some(flight) };
    Scores::new(data.path("scores")).save_with_flight(level, score).unwrap();
}

#[test]
fn boards_are_proven_and_what_does_not_hold_is_named() {
    let data = data();
    save(&data, "1", "bob", &flight("1", "careful"));
    save(&data, "2", "ann", &flight("2", "mark"));
    fs::write(data.path("scores/jumper.csv"), "name,score\nann,12\n").unwrap();
    fs::write(data.path("scores/players.csv"), "player,level,time,medal,mark\neve,1,0.01,gold,TRUE\n").unwrap();
    let held = data.resultant(&["verify", "--scores"]);
    let claims = "players.csv: 1 levels done, on the players' own word\n";
    assert_eq!((held.status, held.out, held.err.as_str()), (0, format!("1: 2 proven\n2: 1 proven\n{claims}"), ""));
    // A row without a flight can be neither proven nor refused.
    let board = fs::read_to_string(data.path("scores/1.csv")).unwrap();
    fs::write(data.path("scores/1.csv"), format!("{board}old,5\n")).unwrap();
    let held = data.resultant(&["verify", "--scores"]);
    assert_eq!((held.status, held.out), (0, format!("1: 2 proven, 1 unproven\n2: 1 proven\n{claims}")));
    let points = flight("1", "gold").score;
    fs::write(data.path("scores/1.csv"), board.replace(&format!("ann,{points}"), "ann,29999")).unwrap();
    let forged = data.resultant(&["verify", "--scores"]);
    assert_eq!((forged.status, forged.out), (1, format!("1: 1 proven, 1 not\n2: 1 proven\n{claims}")));
    let told = format!("1: rank 1, ann, 29999 points: does not hold: the row says 29999 points, its flight {points}\n");
    assert_eq!(forged.err, told);
    fs::remove_dir_all(data.path("levels/1")).unwrap();
    let gone = data.resultant(&["verify", "--scores"]);
    assert!(gone.status == 1 && gone.err.contains("the level cannot be flown"), "{gone:?}");
    assert_eq!(data.resultant(&["verify", "--scores", "x.csv"]).status, 2);
}

#[test]
fn one_flight_under_two_names_blames_neither_and_a_row_that_leads_to_anothers_does_not_hold() {
    let data = data();
    let gold = flight("1", "gold");
    save(&data, "1", "bob", &gold);
    let board = fs::read_to_string(data.path("scores/1.csv")).unwrap();
    let cid = board.lines().nth(1).unwrap().replacen("ann,", "cid,", 1);
    fs::write(data.path("scores/1.csv"), format!("{board}{cid}\n")).unwrap();
    let told = data.resultant(&["verify", "--scores"]);
    assert_eq!((told.status, told.out.as_str()), (1, "1: 0 proven, 2 with the keys of another, 1 not\n"));
    let points = gold.score;
    let expected = format!(
        "1: rank 1, ann, {points} points: the same keys as the flight of bob\n\
         1: rank 2, bob, {points} points: the same keys as the flight of ann\n\
         1: rank 3, cid, {points} points: does not hold: its flight was saved by ann\n"
    );
    assert_eq!(told.err, expected);
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
    fs::write(there.path("levels/15/texts.csv"), "x,y,size,text\n1,1,20,mine\n").unwrap();
    let taken = there.resultant(&["unpack", zip]);
    assert_eq!(taken.status, 2);
    assert!(taken.err.contains("--as NAME"), "{}", taken.err);
    assert_eq!(fs::read_to_string(there.path("levels/15/texts.csv")).unwrap(), "x,y,size,text\n1,1,20,mine\n");
    assert_eq!(there.resultant(&["unpack", zip, "--as", "mill"]).status, 0);
    assert_eq!(there.resultant(&["check", "mill"]).status, 0);
    assert_eq!(there.resultant(&["unpack", zip, "--as", "../mill"]).status, 2);
    assert_eq!(there.resultant(&["unpack", "/nowhere.zip"]).status, 2);
    assert_eq!(there.resultant(&["pack", "none"]).status, 2);
}
