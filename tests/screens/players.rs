//! Who plays, and what they have done.

use crate::sitting::{Sitting, level};
use resultant::game::Medal;
use resultant::scores::Scores;
use resultant::screens::{Input, Key};
use std::fs;

/// How many levels of the list are done.
fn done(sitting: &mut Sitting) -> usize {
    sitting.choose(1).rest();
    let done = sitting.level_select().entries().iter().filter(|entry| entry.medals.medal == Some(Medal::Bronze)).count();
    sitting.press(Key::Escape);
    done
}

#[test]
fn what_a_player_has_done_follows_the_player() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.become_new("ann").app.player().as_str(), "ann");
    sitting.complete().press(Key::Escape);
    assert_eq!(done(&mut sitting), 1);
    sitting.become_new("bob");
    assert_eq!(done(&mut sitting), 0, "what ann did is not bob's");
    assert_eq!(sitting.menu().facts().next.as_ref().unwrap().0, "1");
    sitting.reopen();
    assert_eq!(sitting.app.player().as_str(), "bob", "who was chosen last plays on");
    sitting.choose(7);
    let names: Vec<&str> = sitting.players().candidates().iter().map(|candidate| candidate.name.as_str()).collect();
    assert_eq!((names, sitting.buttons().focus()), (vec!["ann", "bob"], 1));
    assert_eq!(sitting.choose(0).at(), "menu");
    assert_eq!(sitting.app.player().as_str(), "ann");
    assert_eq!(done(&mut sitting), 1);
    assert_eq!(sitting.menu().facts().next.as_ref().unwrap().0, "2");
    assert!(sitting.scores_file("players.csv").starts_with("player,level,time,medal,mark\nann,,,,\nann,1,0.0"));
}

#[test]
fn without_a_name_one_may_fly_and_keeps_what_was_done_once_it_is_said() {
    let mut sitting = Sitting::new();
    assert!(sitting.app.player().is_guest());
    sitting.complete().press(Key::Escape);
    assert_eq!(done(&mut sitting), 1);
    assert!(sitting.scores_file("players.csv").contains("Guest,1,"), "not lost, whatever happens next");
    sitting.become_new("ann");
    assert_eq!(done(&mut sitting), 1, "ann has flown it");
    sitting.become_new("bob");
    assert_eq!(done(&mut sitting), 0, "bob has not");
    sitting.reopen();
    sitting.choose(7);
    let guest = sitting.players().candidates().iter().position(|candidate| candidate.name.is_guest()).unwrap();
    assert_eq!(sitting.choose(guest).app.player().as_str(), "Guest");
    sitting.choose(7);
    let row = sitting.players().candidates().iter().position(|candidate| candidate.name.as_str() == "bob").unwrap();
    sitting.choose(row);
    assert_eq!(done(&mut sitting), 0, "to choose somebody from the list gives them nothing");
}

#[test]
fn nobody_is_called_guest_and_names_follow_the_rules() {
    let mut sitting = Sitting::new();
    sitting.click(7).write("guest").press(Key::Enter);
    assert_eq!(sitting.at(), "new player");
    assert!(sitting.players().field().unwrap().error().is_some_and(|error| error.contains("no name yet")));
    sitting.press_all(&[Key::Backspace; 5]).write("1bob").press(Key::Enter);
    assert!(sitting.players().field().unwrap().error().is_some_and(|error| error.contains("letter")));
    assert_eq!(sitting.press(Key::Escape).at(), "menu");
    assert!(sitting.app.player().is_guest());
}

#[test]
fn a_long_list_of_players_scrolls_with_the_highlight() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        let rows: String = (10..30).map(|i| format!("user{i},,\n")).collect();
        fs::write(root.join("scores/players.csv"), format!("player,level,time\n{rows}")).unwrap();
    });
    sitting.click(7);
    assert_eq!((sitting.players().range(), sitting.buttons().focus()), (0..7, 0));
    sitting.press_all(&[Key::Down; 12]);
    assert_eq!((sitting.players().range(), sitting.buttons().focus()), (6..13, 6));
    sitting.press_all(&[Key::Up; 8]);
    assert_eq!((sitting.players().range(), sitting.buttons().focus()), (4..11, 0));
    assert_eq!(sitting.press(Key::Enter).app.player().as_str(), "user14");
    sitting.click(7).press_all(&[Key::Down; 40]);
    assert_eq!((sitting.players().range(), sitting.buttons().focus()), (13..20, 7), "below the list are the buttons");
}

#[test]
fn every_attempt_that_ends_is_written_down() {
    let mut sitting = Sitting::new();
    sitting.become_new("ann").complete().press(Key::Escape).fly(2).wait(0.1).press(Key::R).wait(0.1);
    sitting.press(Key::Enter).press(Key::Escape);
    sitting.fly(1).wait(0.5).press(Key::R).press_all(&[Key::Escape, Key::Escape]);
    let text = sitting.scores_file("attempts.csv");
    let lines: Vec<&str> = text.split("\r\n").collect();
    assert_eq!(lines[0], "level,player,result,time,fuel,hits,cause,assisted");
    assert!(lines[1].starts_with("1,ann,completed,0.0") && lines[1].ends_with(",1.000,0,,false"), "{text}");
    // R flies again before the score: that attempt has ended all the same. What is given up has not.
    assert!(
        lines[2..4].iter().all(|line| line.starts_with("3,ann,failed,0.0") && line.ends_with(",1.000,0,obstacle 1,false")),
        "{text}"
    );
    assert_eq!(lines[4..], [""]);
}

#[test]
fn what_cannot_be_written_is_told_and_written_later() {
    let mut sitting = Sitting::with(|root| fs::write(root.join("scores"), "a file, no folder").unwrap());
    sitting.complete();
    assert!(sitting.scoring().remark().contains("cannot create the scores folder"), "{}", sitting.scoring().remark());
    sitting.press(Key::Escape);
    assert_eq!(done(&mut sitting), 1, "it counts all the same");
    assert!(sitting.menu().facts().trouble.is_some());
    fs::remove_file(sitting.folder.path().join("scores")).unwrap();
    sitting.wait(2.5);
    assert_eq!(sitting.scores_file("attempts.csv").lines().count(), 2);
    assert!(sitting.scores_file("players.csv").contains("Guest,1,"));
}

#[test]
fn a_file_that_another_game_holds_is_written_when_it_lets_go_at_the_latest_at_the_end() {
    let mut sitting = Sitting::with(|root| fs::create_dir(root.join("scores")).unwrap());
    let hold = |sitting: &Sitting| {
        let held = fs::File::create(sitting.folder.path().join("scores/.players.csv.lock")).unwrap();
        held.lock().unwrap();
        held
    };
    let held = hold(&sitting);
    let before = resultant::files::pauses();
    sitting.complete();
    assert_eq!(resultant::files::pauses(), before, "frames were spent on waiting");
    assert_eq!(sitting.scores_file("players.csv"), "");
    drop(held);
    assert!(sitting.rest().scores_file("players.csv").contains("Guest,1,"));

    let held = hold(&sitting);
    sitting.press(Key::Escape).become_new("ann");
    assert!(!sitting.scores_file("players.csv").contains("ann"));
    drop(held);
    let quit = sitting.buttons().areas()[6].centre();
    sitting.give(Input { pointer: quit, click: true, ..Input::default() });
    assert!(!sitting.open && sitting.scores_file("players.csv").contains("ann"));
}

/// The window's own button says nothing to the game: it is dropped.
#[test]
fn a_window_that_is_closed_while_another_game_writes_loses_no_attempt() {
    let mut sitting = Sitting::with(|root| fs::create_dir(root.join("scores")).unwrap());
    let held = [".players.csv.lock", ".attempts.csv.lock"].map(|file| {
        let held = fs::File::create(sitting.folder.path().join("scores").join(file)).unwrap();
        held.lock().unwrap();
        held
    });
    sitting.complete();
    sitting.reopen();
    assert_eq!((sitting.scores_file("players.csv"), sitting.scores_file("attempts.csv")), (String::new(), String::new()));
    assert!(sitting.scores_file("players.csv.waiting-1").contains("Guest,1,"));
    assert_eq!(sitting.scores_file("attempts.csv.waiting-1").lines().count(), 2);
    drop(held);
    sitting.reopen();
    assert!(sitting.scores_file("players.csv").contains("Guest,1,"));
    assert_eq!(sitting.scores_file("attempts.csv").lines().count(), 2);
    let left: Vec<_> =
        fs::read_dir(sitting.folder.path().join("scores")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert!(!left.iter().any(|name| name.to_string_lossy().contains("waiting")), "{left:?}");
}

#[test]
fn a_damaged_file_of_players_is_told_kept_aside_and_costs_nobody_anything() {
    let damaged = "player,level,time\nann,1,7.5\nann,2,fast\nbob,,\n";
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/players.csv"), damaged).unwrap();
    });
    assert_eq!(sitting.app.player().as_str(), "ann");
    assert!(sitting.menu().facts().trouble.as_ref().is_some_and(|trouble| trouble.contains("players.csv:3: column \"time\"")));
    assert_eq!((done(&mut sitting), sitting.scores_file("players.csv").as_str()), (1, damaged), "looking changes nothing");
    sitting.complete();
    assert!(sitting.scoring().remark().contains("kept as"), "{}", sitting.scoring().remark());
    assert_eq!(sitting.scores_file("players.csv.damaged-1"), damaged);
    let (players, damage) = Scores::new(sitting.folder.path().join("scores")).players().unwrap();
    assert_eq!((players.all().len(), damage.len()), (2, 0));
}

#[test]
fn a_level_that_shares_a_name_with_the_players_file_is_refused() {
    let mut sitting = Sitting::with(|root| level(root, "Players", crate::sitting::FAR_AWAY, ""));
    sitting.choose(1).rest();
    let entry = sitting.level_select().entries().iter().find(|entry| entry.name == "Players").unwrap();
    assert!(entry.level.as_ref().unwrap().as_ref().is_err_and(|problems| problems[0].contains("players.csv")), "{entry:?}");
}

#[test]
fn the_credits_name_every_licence() {
    let mut sitting = Sitting::new();
    sitting.choose(8);
    let resultant::screens::Screen::Credits(credits) = sitting.app.screen() else { panic!("at {}", sitting.at()) };
    let said = format!("{:?}", credits.lines());
    for words in ["Ubuntu Font Licence 1.0", "Bitstream Vera", "Apache 2.0", "MIT License", "MERCHANTABILITY"] {
        assert!(said.contains(words), "{words}");
    }
    let first = credits.range();
    sitting.press(Key::End);
    let resultant::screens::Screen::Credits(credits) = sitting.app.screen() else { panic!("at {}", sitting.at()) };
    assert_eq!(credits.range().end, credits.lines().len());
    assert!(credits.range().start > first.start);
    assert_eq!(sitting.give(Input::default()).press(Key::Enter).at(), "menu");
}
