//! Scores that are earned: a row leads to its flight, and a forged row, or one flown elsewhere or in another version of the level, is
//! found.

use super::fixture::{Fixture, name};
use crate::support::shipped::{fixture as level, record};
use resultant::game::{Controls, Game, Mismatch, Outcome, Recorder, Replay, level_hash};
use resultant::scores::{Doubt, Placement, Score, Scores, Standing, judge};
use std::fs;

fn save(scores: &Scores, user: &str, flight: &Replay) -> Placement {
    let score = Score { name: &name(user), points: flight.score, flight: Some(flight) };
    scores.save_with_flight("1", score).unwrap().placement
}

/// How the rows of the board of level 1 stand, and the number of ticks that were flown.
fn judged(scores: &Scores) -> (Vec<Standing>, u64) {
    let board = scores.load("1").unwrap().board;
    let mut ticks = 0;
    let standings = judge(scores, "1", Ok(level("1")), &board, |_| ticks += 1);
    (standings, ticks)
}

fn first(scores: &Scores) -> Standing {
    judged(scores).0.remove(0)
}

fn board(rows: &str, flights: &[(&str, &str)]) -> (Fixture, Scores) {
    let fixture = Fixture::with("1.csv", rows);
    flights.iter().for_each(|(file, text)| fixture.write(&format!("flights/1/{file}"), text));
    let scores = fixture.scores();
    (fixture, scores)
}

fn gold_of(player: &str) -> Replay {
    Replay { player: Some(player.into()), ..record("1", "gold") }
}

#[test]
fn a_row_leads_to_its_flight_and_is_proven_by_it() {
    let fixture = Fixture::new();
    let scores = fixture.scores();
    let (careful, gold) = (record("1", "careful"), gold_of("ann"));
    assert_eq!(save(&scores, "ann", &careful), Placement::New { rank: 1 });
    assert_eq!(first(&scores), Standing::Proven);
    // A better one takes its place, a worse one leaves no trace.
    assert!(matches!(save(&scores, "ann", &gold), Placement::Raised { rank: 1, .. }));
    let flights = || fs::read_dir(fixture.file("flights/1")).unwrap().count();
    let (board, kept) = (scores.load("1").unwrap().board, flights());
    assert!(matches!(save(&scores, "ann", &careful), Placement::Kept { .. }));
    assert_eq!((scores.load("1").unwrap().board, flights()), (board.clone(), kept));
    assert_eq!(scores.flight("1", board.flight(0).unwrap()), Ok(gold.clone()), "with its player's name");
    assert_eq!(board.time(0), Some((gold.time * 1000.0).round() / 1000.0));
    // A score that is saved without a flight is not that of the old one.
    let saved = scores.save("1", &name("ann"), 20_999).unwrap().board;
    assert_eq!((saved.flight(0), saved.time(0), first(&scores)), (None, None, Standing::Unproven));
}

#[test]
fn boards_without_flights_gain_their_columns_and_keep_their_cells() {
    for (old, new) in [
        ("name,score\nbob,9\n", "name,score,time,flight\n"),
        ("bob,9\n", "name,score,time,flight\n"),
        ("name,score,class\nbob,9,7b\n", "name,score,class,time,flight\n"),
        ("bob,9,7b\n", "name,score,,time,flight\n"),
    ] {
        let fixture = Fixture::with("1.csv", old);
        let scores = fixture.scores();
        assert_eq!(first(&scores), Standing::Unproven);
        save(&scores, "ann", &record("1", "gold"));
        let text = fixture.text("1.csv");
        assert!(text.starts_with(new), "{text}");
        assert_eq!(text.contains("7b"), old.contains("7b"), "{text}");
        assert_eq!(judged(&scores).0, [Standing::Proven, Standing::Unproven]);
    }
}

#[test]
fn what_is_forged_is_found() {
    let fixture = Fixture::new();
    let scores = fixture.scores();
    let gold = gold_of("ann");
    save(&scores, "ann", &gold);
    let sound = fixture.text("1.csv");
    let name_of_flight = scores.load("1").unwrap().board.flight(0).unwrap().to_owned();
    let flight = format!("flights/1/{name_of_flight}");
    let flown = fixture.text(&flight);
    let doubt = |row: &str, text: &str| {
        fixture.write("1.csv", row);
        fixture.write(&flight, text);
        match first(&scores) {
            Standing::Doubtful(doubt) => Some(doubt),
            Standing::Proven => None,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(doubt(&sound, &flown), None);
    let raised = sound.replacen(&gold.score.to_string(), "20000", 1);
    assert_eq!(doubt(&raised, &flown), Some(Doubt::Score(20_000, gold.score)));
    // The record's, too: more than that time can bring, and, with the time, another score than the flight comes to.
    let forged = flown.replace(&format!("# score: {}", gold.score), "# score: 20000");
    assert_eq!(doubt(&raised, &forged), Some(Doubt::TooMuch(20_000, 18_222, Some(5.0))));
    let lower = sound.replacen(&gold.score.to_string(), "18000", 1);
    let forged = flown.replace(&format!("# score: {}", gold.score), "# score: 18000");
    assert!(matches!(doubt(&lower, &forged), Some(Doubt::Flown(Mismatch::End { .. }, None))));
    let other = flown.replacen("\n60,1,0,0,0\n10,", "\n61,1,0,0,0\n9,", 1);
    assert_ne!(other, flown);
    assert!(matches!(doubt(&sound, &other), Some(Doubt::Flown(Mismatch::Second(1, ..), None))));
    // More of them than its own time has.
    let longer = flown.replacen("\n60,1,0,0,0\n10,", "\n60,1,0,0,0\n11,", 1);
    assert_eq!(doubt(&sound, &longer), Some(Doubt::Flown(Mismatch::RunsOn(600, 601), None)));
    // A flight that somebody else has saved, or nobody.
    let others = flown.replace("# player: ann\n", "# player: bob\n");
    assert_eq!(doubt(&sound, &others), Some(Doubt::Player(Some("bob".into()))));
    assert_eq!(doubt(&sound, &flown.replace("# player: ann\n", "")), Some(Doubt::Player(None)));
    let elsewhere = Replay { score: gold.score, ..record("2", "gold") }.to_string();
    let hashes = Mismatch::Level(level_hash(&level("2")), level_hash(&level("1")));
    assert_eq!(doubt(&sound, &elsewhere), Some(Doubt::Flown(hashes, None)));
    // Slower ticks, in which a person is faster.
    let slow = Replay { tick_rate: 30.0, ..gold.clone() }.to_string();
    assert_eq!(doubt(&sound, &slow), Some(Doubt::Rate(30.0)));
    // A flight without its end is worth nothing.
    let failed = flown.replace("# outcome: completed", "# outcome: failed");
    assert_eq!(doubt(&sound, &failed), Some(Doubt::Unfinished(Outcome::Failed)));
    let short: String = flown.lines().filter(|line| !line.starts_with("# hash")).take(13).map(|line| format!("{line}\n")).collect();
    assert!(doubt(&sound, &short).is_some());
    // Another program's flight that departs says whose it was.
    let foreign = other.replace("# program: resultant", "# program: something");
    assert!(matches!(doubt(&sound, &foreign), Some(Doubt::Flown(_, Some(program))) if program.starts_with("something")));
    // More points than any flight can have.
    let without = sound.replace(&name_of_flight, "").replace(&gold.score.to_string(), "21001");
    assert_eq!(doubt(&without, &flown), Some(Doubt::TooMuch(21_001, 21_000, None)));
    fs::remove_file(fixture.file(&flight)).unwrap();
    fixture.write("1.csv", &sound);
    assert!(matches!(first(&scores), Standing::Doubtful(Doubt::Unreadable(_))));
    for away in ["../../../1.csv", "/etc/passwd", "..", ".hidden.replay.csv", "sub/x.replay.csv", "C:x.replay.csv"] {
        fixture.write("1.csv", &sound.replace(&name_of_flight, away));
        let found = first(&scores);
        let Standing::Doubtful(Doubt::Unreadable(words)) = &found else { panic!("{found:?}") };
        assert!(words.contains("expected a file's name"), "{words}");
    }
}

/// A copy under another name, one that waits before its first key, and one whose rows are parted otherwise: all hold, and nothing tells
/// which of them was flown.
#[test]
fn copies_are_told_by_their_keys_from_the_first_one_on() {
    let gold = gold_of("ann");
    let copy = |player: &str, from: &str, to: &str| {
        let text = Replay { player: Some(player.into()), ..gold.clone() }.to_string().replacen(from, to, 1);
        let inputs = resultant::game::Inputs::parse("copy", &text).unwrap();
        let mut game = Game::new(level("1")).unwrap();
        let mut recorder = Recorder::default();
        for controls in inputs {
            game.step(controls);
            recorder.note(&game, controls);
        }
        Replay { player: Some(player.into()), ..recorder.finish(&game) }
    };
    let flights = [
        copy("bob", "\n60,1,0,0,0", "\n120,0,0,0,0\n60,1,0,0,0"),
        gold.clone(),
        copy("cid", "\n60,1,0,0,0", "\n30,1,0,0,0\n30,1,0,0,0"),
        Replay { player: Some("dan".into()), ..record("1", "careful") },
    ];
    let fixture = Fixture::new();
    let scores = fixture.scores();
    for flight in &flights {
        save(&scores, flight.player.as_deref().unwrap(), flight);
    }
    let copies = |others: [&str; 2]| Standing::Copies(others.map(name).to_vec());
    let expected = [copies(["ann", "cid"]), copies(["bob", "cid"]), copies(["bob", "ann"]), Standing::Proven];
    assert_eq!(judged(&scores).0, expected);
}

/// The cost of judging is counted in ticks flown.
#[test]
fn a_forged_row_costs_no_more_than_the_honest_part_of_its_flight() {
    let text = gold_of("ann").to_string();
    let without_hashes: String = text.lines().filter(|line| !line.starts_with("# hash ")).map(|line| format!("{line}\n")).collect();
    let hour = |ticks: u64, hashes: u64| {
        let time = ticks as f64 / 120.0;
        let seconds: String = (1..=hashes).map(|second| format!("# hash {second}: 0123456789abcdef\n")).collect();
        let timed = without_hashes.replace("# time: 5\n", &format!("# time: {time}\n{seconds}"));
        timed.replacen("\n60,1,0,0,0", &format!("\n{},1,0,0,0", ticks - 540), 1)
    };
    let one = |text: &str| {
        let score = text.lines().find_map(|line| line.strip_prefix("# score: ")).unwrap();
        let (_fixture, scores) = board(&format!("name,score,flight\nann,{score},a.replay.csv\n"), &[("a.replay.csv", text)]);
        let (mut standings, ticks) = judged(&scores);
        (standings.remove(0), ticks)
    };
    // 10⁹ ticks behind its own end.
    let runs_on = Standing::Doubtful(Doubt::Flown(Mismatch::RunsOn(600, 1_000_000_000), None));
    assert_eq!(one(&(text.clone() + "999999400,0,0,0,0\n")), (runs_on, 0));
    // The same, with the time that they take: so slow a flight is not worth its score.
    let slow = hour(1_000_000_000, 0);
    assert!(matches!(one(&slow), (Standing::Doubtful(Doubt::TooMuch(18_222, 1000, Some(_))), 0)));
    let slow = slow.replace("# score: 18222", "# score: 1");
    assert_eq!(one(&slow), (Standing::Doubtful(Doubt::TooLong(1_000_000_000)), 0));
    // An hour of it, without the hashes of its seconds, and with some.
    let slow = |hashes| hour(432_000, hashes).replace("# score: 18222", "# score: 1");
    assert_eq!(one(&slow(0)), (Standing::Doubtful(Doubt::Seconds(0, 3600)), 0));
    assert!(matches!(one(&slow(3600)), (Standing::Doubtful(Doubt::Flown(Mismatch::Second(1, ..), None)), 120)));
    // Before the first key: nothing of it counts as time, but it is flown.
    let idle = without_hashes.replace("\n60,1,0,0,0", "\n999999400,0,0,0,0\n60,1,0,0,0");
    assert_eq!(one(&idle), (Standing::Doubtful(Doubt::TooLong(1_000_000_000)), 0));
    assert_eq!(one(&text), (Standing::Proven, 600));
    // One that holds up to its end, at which it has not completed anything, is not flown.
    let mut game = Game::new(level("1")).unwrap();
    let mut recorder = Recorder::default();
    for _ in 0..120 {
        game.step(Controls::default());
        recorder.note(&game, Controls::default());
    }
    let running = Replay { score: 1000, player: Some("ann".into()), ..recorder.finish(&game) };
    assert_eq!(one(&running.to_string()), (Standing::Doubtful(Doubt::Unfinished(Outcome::Running)), 0));
}

#[cfg(unix)]
#[test]
fn a_flight_that_cannot_be_kept_saves_no_row() {
    let fixture = Fixture::with("flights", "in the way");
    let gold = record("1", "gold");
    let score = Score { name: &name("ann"), points: gold.score, flight: Some(&gold) };
    assert!(fixture.scores().save_with_flight("1", score).is_err());
    assert!(!fixture.file("1.csv").exists());
}
