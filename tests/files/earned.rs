//! Scores that are earned: a row leads to its flight, and a forged row, or one flown elsewhere or in another version of the level, is
//! found.

use super::fixture::{Fixture, name};
use crate::support::shipped::{fixture as level, record};
use resultant::game::{Controls, Game, LevelHash, Mismatch, Recorder, Replay, level_hash};
use resultant::level::Level;
use resultant::scores::{Doubt, IN_TURN, Judge, PATIENCE, Placement, Score, Scores, Standing, TURN};
use std::fs;
use std::sync::Arc;

fn save(scores: &Scores, user: &str, flight: &Replay) -> Placement {
    let score = Score { name: &name(user), points: flight.score, flight: Some(flight), version: None };
    scores.save_within(PATIENCE, "1", score).unwrap().placement
}

/// The judge of a level's board, once all of it is judged.
fn judged(scores: &Scores, level: Arc<Level>) -> Judge {
    let board = scores.load("1").unwrap().board;
    let mut judge = Judge::new(scores.clone(), level, &board);
    loop {
        while judge.begin(&board, 0..board.rows().len()).is_some() {}
        if !judge.flies() {
            return judge;
        }
        judge.fly(1000);
    }
}

fn judge(scores: &Scores, row: usize, level: Arc<Level>) -> Option<Result<(), Doubt>> {
    let board = scores.load("1").unwrap().board;
    match judged(scores, level).standing(&board.rows()[row].name).expect("it is judged") {
        Standing::Proven => Some(Ok(())),
        Standing::Unproven => None,
        Standing::Doubtful(doubt) => Some(Err(doubt.clone())),
    }
}

/// A board of level 1, and the flights of its rows by their files.
fn board(rows: &str, flights: &[(&str, &str)]) -> (Fixture, Scores) {
    let fixture = Fixture::with("1.csv", rows);
    flights.iter().for_each(|(file, text)| fixture.write(&format!("flights/1/{file}"), text));
    let scores = fixture.scores();
    (fixture, scores)
}

#[test]
fn a_row_leads_to_its_flight_and_is_proven_by_it() {
    let fixture = Fixture::new();
    let scores = fixture.scores();
    let (careful, gold) = (record("1", "careful"), record("1", "gold"));
    assert_eq!(save(&scores, "ann", &careful), Placement::New { rank: 1 });
    assert_eq!(judge(&scores, 0, level("1")), Some(Ok(())));
    let saved = |flight: &Replay| Some(Ok(Replay { player: Some("ann".into()), ..flight.clone() }));
    assert_eq!(scores.flight("1", &scores.load("1").unwrap().board.origin(0)), saved(&careful), "with its player's name");
    // A better one takes its place, a worse one leaves no trace.
    assert!(matches!(save(&scores, "ann", &gold), Placement::Raised { rank: 1, .. }));
    let flights = || fs::read_dir(fixture.file("flights/1")).unwrap().count();
    let (board, kept) = (scores.load("1").unwrap().board, flights());
    assert!(matches!(save(&scores, "ann", &careful), Placement::Kept { .. }));
    assert_eq!((scores.load("1").unwrap().board, flights()), (board.clone(), kept));
    let origin = board.origin(0);
    assert_eq!(scores.flight("1", &origin), saved(&gold));
    assert_eq!((origin.version, origin.program), (Some(gold.level_hash), Some(gold.program)));
    // A score that is saved without a flight is no longer that of the old one.
    assert!(matches!(scores.save("1", &name("ann"), 20_999), Ok(saved) if saved.board.origin(0).flight.is_none()));
    assert_eq!(judge(&scores, 0, level("1")), None);
}

#[test]
fn older_files_load_and_keep_their_cells() {
    for (old, new) in [
        ("name,score\nbob,9\n", "name,score,flight,version,program\n"),
        ("bob,9\n", "name,score,flight,version,program\n"),
        ("name,score,class\nbob,9,7b\n", "name,score,class,flight,version,program\n"),
        ("bob,9,7b\n", "name,score,,flight,version,program\n"),
    ] {
        let fixture = Fixture::with("1.csv", old);
        let scores = fixture.scores();
        assert_eq!(judge(&scores, 0, level("1")), None, "a row without a flight is one");
        save(&scores, "ann", &record("1", "gold"));
        let text = fixture.text("1.csv");
        assert!(text.starts_with(new), "{text}");
        assert_eq!(text.contains("7b"), old.contains("7b"), "{text}");
        assert_eq!((judge(&scores, 0, level("1")), judge(&scores, 1, level("1"))), (Some(Ok(())), None));
    }
}

#[test]
fn what_is_forged_is_found() {
    let fixture = Fixture::new();
    let scores = fixture.scores();
    let gold = record("1", "gold");
    save(&scores, "ann", &gold);
    let sound = fixture.text("1.csv");
    let name_of_flight = scores.load("1").unwrap().board.origin(0).flight.unwrap();
    let flight = format!("flights/1/{name_of_flight}");
    let flown = fixture.text(&flight);
    let verdict = |row: &str, text: &str| {
        fixture.write("1.csv", row);
        fixture.write(&flight, text);
        judge(&scores, 0, level("1")).expect("it has a flight")
    };
    assert_eq!(verdict(&sound, &flown), Ok(()));
    // The row's score alone.
    let raised = sound.replacen(&gold.score.to_string(), "20000", 1);
    assert_eq!(verdict(&raised, &flown), Err(Doubt::Score(20_000, gold.score)));
    // The record's, too: more than that time can bring, and, with the time, another score than the flight comes to.
    let forged = flown.replace(&format!("# score: {}", gold.score), "# score: 20000");
    assert_eq!(verdict(&raised, &forged), Err(Doubt::TooMuch(20_000, 18_222, Some(5.0))));
    let lower = sound.replacen(&gold.score.to_string(), "18000", 1);
    let forged = flown.replace(&format!("# score: {}", gold.score), "# score: 18000");
    assert!(matches!(verdict(&lower, &forged), Err(Doubt::Flown(Mismatch::End { .. }, None))));
    // Its inputs.
    let other = flown.replacen("\n60,1,0,0,0\n10,", "\n61,1,0,0,0\n9,", 1);
    assert_ne!(other, flown);
    // More of them than its own time has.
    let longer = flown.replacen("\n60,1,0,0,0\n10,", "\n60,1,0,0,0\n11,", 1);
    assert_eq!(verdict(&sound, &longer), Err(Doubt::Flown(Mismatch::RunsOn(600, 601), None)));
    // A flight that somebody else has saved.
    let others = flown.replace("# player: ann\n", "# player: bob\n");
    assert_eq!(verdict(&sound, &others), Err(Doubt::Player("bob".into())));
    let nobodys = flown.replace("# player: ann\n", "");
    assert_eq!(verdict(&sound, &nobodys), Ok(()));
    assert!(matches!(verdict(&sound, &other), Err(Doubt::Flown(Mismatch::Second(1, ..), None))));
    // The flight of another level, and one that does not say of which it is.
    let elsewhere = Replay { score: gold.score, ..record("2", "gold") }.to_string();
    let hash = level_hash(&level("2"));
    assert_eq!(verdict(&sound, &elsewhere), Err(Doubt::Version(level_hash(&level("1")), hash)));
    let unversioned = sound.replace(&level_hash(&level("1")).to_string(), "");
    assert!(matches!(verdict(&unversioned, &elsewhere), Err(Doubt::Flown(Mismatch::Level(found, _), None)) if found == hash));
    // Slower ticks, in which a person is faster.
    let slow = Replay { tick_rate: 30.0, ..gold.clone() }.to_string();
    assert_eq!(verdict(&sound, &slow), Err(Doubt::Rate(30.0)));
    // A flight without its end is worth nothing.
    let short: String =
        flown.lines().filter(|line| !line.starts_with("# hash ")).take(12).map(|line| format!("{line}\n")).collect();
    assert!(matches!(verdict(&sound, &short), Err(Doubt::Flown(Mismatch::End { .. }, None))));
    // Another program's flight that departs says whose it was.
    let older = other.replace("# program: resultant", "# program: something");
    assert!(matches!(verdict(&sound, &older), Err(Doubt::Flown(_, Some(program))) if program.starts_with("something")));
    // No flight where the row leads, or a way out of the folder.
    fs::remove_file(fixture.file(&flight)).unwrap();
    assert!(matches!(judge(&scores, 0, level("1")), Some(Err(Doubt::Unreadable(_)))));
    for away in ["../../../1.csv", "/etc/passwd", "..", ".hidden.replay.csv", "sub/x.replay.csv", "C:x.replay.csv"] {
        fixture.write("1.csv", &sound.replace(&name_of_flight, away));
        let verdict = judge(&scores, 0, level("1"));
        assert!(matches!(&verdict, Some(Err(Doubt::Unreadable(words))) if words.contains("expected a file's name")), "{verdict:?}");
    }
}

#[test]
fn a_changed_level_keeps_its_old_board_aside() {
    let fixture = Fixture::with("1.csv", "name,score,class\nold,5,7b\n");
    let scores = fixture.scores();
    let gold = record("1", "gold");
    let (now, then) = (gold.level_hash, LevelHash([0x12; 32]));
    let older = |score: i64| Replay { level_hash: then, score, ..gold.clone() };
    save(&scores, "bob", &older(9000));
    save(&scores, "cid", &older(8000));
    fixture.write("1.csv", &fixture.text("1.csv").replace("cid,8000,,", "cid,8000,8a,"));
    // On the level's present version's board they do not appear; looking writes nothing.
    let shown = |version: LevelHash| {
        let (loaded, others) = scores.load_version("1", version).unwrap();
        let rows: Vec<String> = loaded.board.rows().iter().map(|row| format!("{} {}", row.name, row.score)).collect();
        (rows.join(", "), others)
    };
    assert_eq!(shown(now), ("old 5".to_owned(), 1));
    assert_eq!(shown(then), ("bob 9000, cid 8000, old 5".to_owned(), 0));
    assert!(!fixture.file("aside").exists());
    // A save moves them; a lower score than the one aside is the best of this version.
    assert_eq!(save(&scores, "bob", &Replay { score: 7000, ..gold.clone() }), Placement::New { rank: 1 });
    assert_eq!(shown(now), ("bob 7000, old 5".to_owned(), 1));
    let aside = fixture.text(&format!("aside/1.{then}.csv"));
    assert!(aside.contains("bob,9000") && aside.contains("8a") && !aside.contains("old"), "{aside}");
    assert_eq!(shown(then).0, "bob 9000, cid 8000, old 5");
    // The level is changed back: they are on the board again, and the other version's go aside.
    save(&scores, "dan", &older(8500));
    assert_eq!(shown(then), ("bob 9000, dan 8500, cid 8000, old 5".to_owned(), 1));
    assert_eq!(shown(now), ("bob 7000, old 5".to_owned(), 1));
    let board = fixture.text("1.csv");
    assert!(board.contains("old,5,7b") && board.contains("cid,8000,8a"), "{board}");
}

#[test]
fn what_the_rules_do_not_allow_is_told_at_sight() {
    let gold = record("1", "gold").to_string();
    let points = record("1", "gold").score;
    let rows = format!(
        "name,score,flight,version,program\nhuge,99999999999,,,\nmuch,21001,,,\nmost,21000,,,\nann,{points},a.replay.csv,,\n\
         bob,{points},a.replay.csv,,\ncid,{points},c.replay.csv,,\ndan,{points},,,resultant 0.1.0\neve,5,,,\n"
    );
    let (_fixture, scores) = board(&rows, &[("a.replay.csv", &gold), ("c.replay.csv", &gold)]);
    let verdicts: Vec<_> = (0..8).map(|row| judge(&scores, row, level("1"))).collect();
    let doubt = |doubt| Some(Err(doubt));
    assert_eq!(
        verdicts,
        [
            doubt(Doubt::TooMuch(99_999_999_999, 21_000, None)),
            doubt(Doubt::TooMuch(21_001, 21_000, None)),
            None,
            Some(Ok(())),
            doubt(Doubt::Twice(name("ann"))),
            doubt(Doubt::Twice(name("ann"))),
            doubt(Doubt::Emptied),
            None,
        ]
    );
    // Scores alone rank the rows, whatever is known of their flights.
    let (loaded, _) = scores.load_version("1", level_hash(&level("1"))).unwrap();
    assert!(loaded.board.rows().is_sorted_by_key(|row| std::cmp::Reverse(row.score)), "{:?}", loaded.board.rows());
    assert_eq!(loaded.board.rows()[0].name.as_str(), "huge");
}

/// Of two rows with one flight the one that stands ahead keeps it, whichever is looked at first.
#[test]
fn the_older_of_two_rows_with_one_flight_keeps_it() {
    let (gold, points) = (record("1", "gold").to_string(), record("1", "gold").score);
    let rows = format!("name,score,flight\nann,{points},a.replay.csv\nbob,{points},b.replay.csv\n");
    let (_fixture, scores) = board(&rows, &[("a.replay.csv", &gold), ("b.replay.csv", &gold)]);
    let board = scores.load("1").unwrap().board;
    for order in [[0, 1], [1, 0]] {
        for flown_between in [0, 10_000] {
            let mut judge = Judge::new(scores.clone(), level("1"), &board);
            judge.begin(&board, [order[0]]);
            judge.fly(flown_between);
            judge.begin(&board, [order[1]]);
            judge.fly(10_000);
            let standings = ["ann", "bob"].map(|user| judge.standing(&name(user)).cloned());
            assert_eq!(standings, [Some(Standing::Proven), Some(Standing::Doubtful(Doubt::Twice(name("ann"))))]);
            assert_eq!(board.rows().iter().filter(|row| judge.fails(&row.name)).count(), 1);
        }
    }
}

/// The cost of judging is counted in ticks flown.
#[test]
fn a_forged_row_costs_no_more_than_the_honest_part_of_its_flight() {
    let gold = record("1", "gold");
    let text = gold.to_string();
    let lines = |wanted: bool| move |line: &&str| line.starts_with("# hash ") != wanted;
    let without_hashes: String = text.lines().filter(lines(true)).map(|line| format!("{line}\n")).collect();
    let hour = |ticks: u64, hashes: u64| {
        let time = ticks as f64 / 120.0;
        let seconds: String = (1..=hashes).map(|second| format!("# hash {second}: 0123456789abcdef\n")).collect();
        without_hashes.replace("# time: 5\n", &format!("# time: {time}\n{seconds}")).replacen(
            "\n60,1,0,0,0",
            &format!("\n{},1,0,0,0", ticks - 540),
            1,
        )
    };
    let one = |text: &str| {
        let score = text.lines().find_map(|line| line.strip_prefix("# score: ")).unwrap();
        let (_fixture, scores) = board(&format!("name,score,flight\nann,{score},a.replay.csv\n"), &[("a.replay.csv", text)]);
        let judge = judged(&scores, level("1"));
        (judge.standing(&name("ann")).cloned().unwrap(), judge.ticks())
    };
    // 10⁹ ticks behind its own end.
    let (standing, ticks) = one(&(text.clone() + "999999400,0,0,0,0\n"));
    assert_eq!((standing, ticks), (Standing::Doubtful(Doubt::Flown(Mismatch::RunsOn(600, 1_000_000_000), None)), 0));
    // The same, with the time that they take: so slow a flight is not worth its score.
    let slow = hour(1_000_000_000, 0);
    assert!(matches!(one(&slow), (Standing::Doubtful(Doubt::TooMuch(18_222, 1000, Some(_))), 0)));
    // With a score that it may have.
    let slow = slow.replace("# score: 18222", "# score: 1");
    assert_eq!(one(&slow), (Standing::Doubtful(Doubt::TooLong(1_000_000_000)), 0));
    // An hour of it, without the hashes of its seconds, and with some.
    let slow = |hashes| hour(432_000, hashes).replace("# score: 18222", "# score: 1");
    assert_eq!(one(&slow(0)), (Standing::Doubtful(Doubt::Seconds(0, 3600)), 0));
    assert!(matches!(one(&slow(3600)), (Standing::Doubtful(Doubt::Flown(Mismatch::Second(1, ..), None)), 120)));
    // Before the first key: nothing of it counts as time, but it is flown.
    let idle = without_hashes.replace("\n60,1,0,0,0", "\n999999400,0,0,0,0\n60,1,0,0,0");
    assert_eq!(one(&idle), (Standing::Doubtful(Doubt::TooLong(1_000_000_000)), 0));
    // The honest flight costs its ticks, and the look at its end.
    assert_eq!(one(&text), (Standing::Proven, 601));
}

#[test]
fn rows_are_judged_in_turn() {
    let level = level("1");
    // Slow flights that hold up to their end, at which they have not completed anything.
    let mut game = Game::new(level.clone()).unwrap();
    let mut recorder = Recorder::default();
    for _ in 0..60 * 120 {
        game.step(Controls::default());
        recorder.note(&game, Controls::default());
    }
    let slow = Replay { score: 1000, ..recorder.finish(&game) };
    let gold = record("1", "gold");
    let users: Vec<String> = (0..IN_TURN).map(|user| format!("slow{user}")).collect();
    let mut rows = "name,score,flight\n".to_owned();
    let mut flights = Vec::new();
    for (index, user) in users[1..].iter().enumerate() {
        rows += &format!("{user},1000,{user}.replay.csv\n");
        flights.push((format!("{user}.replay.csv"), Replay { hash: index as u64, ..slow.clone() }.to_string()));
    }
    rows += "honest,18222,gold.replay.csv\n";
    flights.push(("gold.replay.csv".to_owned(), gold.to_string()));
    let flights: Vec<(&str, &str)> = flights.iter().map(|(file, text)| (file.as_str(), text.as_str())).collect();
    let (_fixture, scores) = board(&rows, &flights);
    let board = scores.load("1").unwrap().board;
    let mut judge = Judge::new(scores, level, &board);
    // The honest row comes last into the air.
    while judge.begin(&board, (0..board.rows().len()).rev()).is_some() {}
    while judge.standing(&name("honest")).is_none() {
        judge.fly(TURN);
    }
    assert_eq!(judge.standing(&name("honest")), Some(&Standing::Proven));
    let bound = IN_TURN as u64 * (601 + TURN);
    assert!(judge.ticks() <= bound, "{} ticks were flown, expected at most {bound}", judge.ticks());
    assert!(judge.standing(&name("slow1")).is_none(), "still in the air");
}

#[cfg(unix)]
#[test]
fn a_flight_that_cannot_be_kept_saves_no_row() {
    let fixture = Fixture::with("flights", "in the way");
    let scores = fixture.scores();
    let gold = record("1", "gold");
    let score = Score { name: &name("ann"), points: gold.score, flight: Some(&gold), version: None };
    assert!(scores.save_within(PATIENCE, "1", score).is_err());
    assert!(!fixture.file("1.csv").exists());
}
