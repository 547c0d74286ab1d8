//! The files of players and of attempts on disk, also when they are damaged, or a process is killed in the middle.

use super::fixture::{Fixture, Worker, in_a_worker, kill_within, name, until_its_turn};
use resultant::game::Medals;
use resultant::scores::{AttemptRow, Deed, ScoresError};
use std::fs;

fn empty() -> Fixture {
    let fixture = Fixture::new();
    fs::create_dir(fixture.folder()).unwrap();
    fixture
}

/// All that there is but for locks.
fn names(fixture: &Fixture) -> Vec<String> {
    fixture.names().into_iter().filter(|name| !name.ends_with(".lock")).collect()
}

fn done(player: &str, level: &str, time: f64) -> Deed {
    Deed::Done { player: name(player), level: level.to_owned(), time: Some(time), medals: Medals::default() }
}

fn attempt(player: &str, level: &str) -> AttemptRow {
    AttemptRow {
        level: level.to_owned(),
        player: name(player),
        result: "failed",
        time: 1.25,
        fuel: 0.5,
        hits: 1,
        cause: "obstacle 2".to_owned(),
        assisted: false,
    }
}

const HEADER: &str = "level,player,result,time,fuel,hits,cause,assisted\r\n";
const ROW: &str = "1,ann,failed,1.250,0.500,1,obstacle 2,false\r\n";

#[test]
fn deeds_of_two_games_stand_in_one_file() {
    let fixture = empty();
    let (one, two) = (fixture.scores(), fixture.scores());
    one.record(&[Deed::Chosen(name("ann")), done("ann", "1", 9.0)]).unwrap();
    two.record(&[Deed::Chosen(name("bob")), done("ann", "1", 8.0), done("bob", "2", 5.0)]).unwrap();
    let players = one.record(&[done("ann", "1", 8.5), done("ann", "3", 1.0)]).unwrap();
    let wanted = "player,level,time,medal,mark\nbob,,,,\nbob,2,5.000,bronze,\nann,,,,\nann,1,8.000,bronze,\nann,3,1.000,bronze,\n";
    assert_eq!(fixture.text("players.csv"), wanted);
    assert_eq!(one.players().unwrap(), (players, vec![]));
    assert_eq!(names(&fixture), ["players.csv"]);
}

#[test]
fn lines_are_added_whole_whatever_an_editor_left() {
    for (before, after) in [
        (None, format!("{HEADER}{ROW}")),
        (Some(String::new()), format!("{HEADER}{ROW}")),
        (Some(HEADER.to_owned()), format!("{HEADER}{ROW}")),
        (Some(format!("{HEADER}{ROW}")), format!("{HEADER}{ROW}{ROW}")),
        (Some(format!("{HEADER}torn,li")), format!("{HEADER}torn,li\r\n{ROW}")),
        (Some(format!("\u{feff}{}", HEADER.replace('\r', ""))), format!("\u{feff}{}{ROW}", HEADER.replace('\r', ""))),
    ] {
        let fixture = empty();
        if let Some(before) = before {
            fs::write(fixture.file("attempts.csv"), before).unwrap();
        }
        fixture.scores().append(&[attempt("ann", "1")]).unwrap();
        assert_eq!(fixture.text("attempts.csv"), after);
    }
}

#[test]
fn a_file_that_is_no_list_of_attempts_is_left_alone() {
    let fixture = empty();
    for other in ["level;player\n1;ann\n", "x"] {
        fs::write(fixture.file("attempts.csv"), other).unwrap();
        assert!(matches!(fixture.scores().append(&[attempt("ann", "1")]), Err(ScoresError::Foreign(_))));
        assert_eq!(fixture.text("attempts.csv"), other);
    }
}

#[test]
fn what_a_spreadsheet_reads_is_what_was_flown() {
    let fixture = empty();
    let levels = ["1", "Höhle, \"tief\"", "=cmd|' /C calc'!A0", "two\nlines"];
    for level in levels {
        fixture.scores().append(&[attempt("ann", level)]).unwrap();
    }
    let mut reader = csv::Reader::from_path(fixture.file("attempts.csv")).unwrap();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.iter().map(|row| row[0].trim_start_matches('\'')).collect::<Vec<_>>(), levels);
    assert!(rows.iter().all(|row| row.len() == 8 && !row[0].starts_with('=')));
}

#[test]
fn no_board_takes_the_place_of_another_file() {
    let fixture = empty();
    for board in ["players", "Players", "ATTEMPTS"] {
        assert!(matches!(fixture.scores().save(board, &name("ann"), 5), Err(ScoresError::LevelName(_))), "{board}");
    }
    assert_eq!(names(&fixture), [""; 0]);
}

const WORKER: &str = "players::a_kill_at_any_moment_loses_nothing_that_was_confirmed";

#[test]
fn a_kill_at_any_moment_loses_nothing_that_was_confirmed() {
    in_a_worker(|scores, player, level| {
        until_its_turn(|| scores.record(&[done(player, &level.to_string(), 1.0)]).map(drop));
        until_its_turn(|| scores.append(&[attempt(player, &level.to_string())]));
    });
    const ROUNDS: u64 = 20;
    let fixture = empty();
    for round in 0..ROUNDS {
        let player = format!("r{round}");
        let last = kill_within(Worker::start(WORKER, &fixture.folder(), &player, u32::MAX), round);
        let (players, damage) = fixture.scores().players().unwrap();
        assert_eq!(damage, [""; 0], "round {round}");
        let known = players.get(&name(&player)).unwrap();
        assert!((1..=last).all(|level| known.best(&level.to_string()).is_some()), "round {round}");
        let attempts = fixture.text("attempts.csv");
        assert!((1..=last).all(|level| attempts.contains(&format!("\n{level},{player},"))), "round {round}");
    }
}
