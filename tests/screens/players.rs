//! Players and their progress.

use crate::sitting::{Sitting, hold, level, with_scores};
use resultant::game::Medal;
use resultant::scores::Scores;
use resultant::screens::{Input, Key};
use std::fs;

fn done(sitting: &mut Sitting) -> usize {
    sitting.choose("Levels").rest();
    let done = sitting.level_select().entries.iter().filter(|entry| entry.medals.medal == Some(Medal::Bronze)).count();
    sitting.press(Key::Escape);
    done
}

#[test]
fn what_a_player_has_done_follows_the_player() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.become_new("ann").app.player().as_str(), "ann");
    sitting.complete().home();
    assert_eq!(done(&mut sitting), 1);
    sitting.become_new("bob");
    assert_eq!(done(&mut sitting), 0, "what ann did is not bob's");
    assert!(sitting.row("Play").contains(&"1".to_owned()), "the level that Play opens");
    sitting.reopen();
    assert_eq!(sitting.app.player().as_str(), "bob", "who was chosen last plays on");
    sitting.choose("Players");
    assert_eq!((sitting.labels(), sitting.focused()), (vec!["ann", "bob", "New Player", "Back"], "bob"));
    assert_eq!(sitting.choose("ann").at(), "menu");
    assert_eq!(sitting.app.player().as_str(), "ann");
    assert_eq!(done(&mut sitting), 1);
    assert!(sitting.row("Play").contains(&"2".to_owned()), "the level that Play opens");
    assert!(sitting.scores_file("players.csv").starts_with("player,level,time,medal,mark\nann,,,,\nann,1,0.0"));
}

#[test]
fn without_a_name_one_may_fly_and_keeps_what_was_done_once_it_is_said() {
    let mut sitting = Sitting::new();
    assert!(sitting.app.player().is_guest());
    sitting.complete().home();
    assert_eq!(done(&mut sitting), 1);
    assert!(sitting.scores_file("players.csv").contains("Guest,1,"), "not lost, whatever happens next");
    sitting.become_new("ann");
    assert_eq!(done(&mut sitting), 1, "ann has flown it");
    sitting.become_new("bob");
    assert_eq!(done(&mut sitting), 0, "bob has not");
    sitting.reopen().choose("Players");
    assert_eq!(sitting.choose("Guest").app.player().as_str(), "Guest");
    sitting.choose("Players").choose("bob");
    assert_eq!(done(&mut sitting), 0, "to choose somebody from the list gives them nothing");
}

#[test]
fn nobody_is_called_guest_and_names_follow_the_rules() {
    let mut sitting = Sitting::new();
    sitting.click("Players").write("guest").press(Key::Enter);
    assert_eq!(sitting.at(), "new player");
    assert!(sitting.shows("no name yet"));
    sitting.press_all(&[Key::Backspace; 5]).write("1bob").press(Key::Enter);
    assert!(sitting.shows("letter"));
    assert_eq!(sitting.press(Key::Escape).at(), "menu");
    assert!(sitting.app.player().is_guest());
}

#[test]
fn every_attempt_that_ends_is_written_down() {
    let mut sitting = Sitting::new();
    sitting.become_new("ann").complete().home().fly("3").wait(0.1).press(Key::R).wait(0.1).press(Key::Enter).home();
    sitting.fly("2").wait(0.5).press(Key::R).press_all(&[Key::Escape, Key::Escape]);
    let text = sitting.scores_file("attempts.csv");
    let lines: Vec<&str> = text.split("\r\n").collect();
    assert_eq!(lines[0], "level,player,result,time,fuel,hits,cause,assisted");
    assert!(lines[1].starts_with("1,ann,completed,0.0") && lines[1].ends_with(",1.000,0,,false"), "{text}");
    // R flies again before the score: that attempt has ended all the same. A flight that is given up has not.
    let lost = |line: &&str| line.starts_with("3,ann,failed,0.0") && line.ends_with(",1.000,0,obstacle 1,false");
    assert!(lines[2..4].iter().all(lost), "{text}");
    assert_eq!(lines[4..], [""]);
}

#[test]
fn what_cannot_be_written_is_told_and_written_later() {
    let mut sitting = Sitting::with(|root| fs::write(root.join("scores"), "a file, no folder").unwrap());
    sitting.complete();
    assert!(sitting.shows("cannot create the folder"), "{:?}", sitting.texts());
    sitting.home();
    assert_eq!(done(&mut sitting), 1, "it counts all the same");
    assert!(sitting.shows("cannot create the folder"));
    fs::remove_file(sitting.folder.path().join("scores")).unwrap();
    sitting.click("Try again");
    assert!(sitting.at() == "menu" && !sitting.shows("cannot create the folder"));
    assert_eq!(sitting.scores_file("attempts.csv").lines().count(), 2);
    assert!(sitting.scores_file("players.csv").contains("Guest,1,"));
}

#[test]
fn a_file_that_another_game_holds_is_written_with_the_next_deed_at_the_latest_at_the_end() {
    let mut sitting = Sitting::with(|root| fs::create_dir(root.join("scores")).unwrap());
    let held = hold(&sitting, "players.csv");
    sitting.complete();
    assert!(sitting.shows(".players.csv.lock") && sitting.scores_file("players.csv").is_empty());
    drop(held);
    sitting.home().become_new("ann");
    assert!(sitting.scores_file("players.csv").contains("Guest,1,") && sitting.scores_file("attempts.csv").lines().count() == 2);
    let held = hold(&sitting, "attempts.csv");
    sitting.complete().home();
    let click = |sitting: &mut Sitting, label: &str| {
        let pointer = sitting.area(label).centre();
        sitting.give(Input { pointer, click: true, ..Input::default() });
    };
    click(&mut sitting, "Quit");
    assert!(sitting.open && sitting.rest().labels().contains(&"Try again"), "{:?}", sitting.texts());
    drop(held);
    click(&mut sitting, "Try again");
    assert!(!sitting.open && sitting.scores_file("attempts.csv").lines().count() == 3);
}

#[test]
fn a_damaged_file_of_players_is_told_and_costs_nobody_anything() {
    let damaged = "player,level,time,medal,mark\nann,1,7.5\nann,2,fast\nbob,,\n";
    let mut sitting = with_scores("players.csv", damaged);
    assert_eq!(sitting.app.player().as_str(), "ann");
    assert!(sitting.rest().shows("players.csv:3: column \"time\""));
    assert_eq!(done(&mut sitting), 1);
    sitting.complete();
    assert!(sitting.shows("mend the file"), "{:?}", sitting.texts());
    assert_eq!(sitting.scores_file("players.csv"), damaged);
    fs::write(sitting.folder.path().join("scores/players.csv"), damaged.replace("fast", "9")).unwrap();
    sitting.press(Key::Escape);
    let (players, damage) = Scores::new(sitting.folder.path().join("scores")).players().unwrap();
    assert_eq!((players.all().len(), damage.len()), (2, 0));
}

#[test]
fn a_level_that_shares_a_name_with_the_players_file_is_refused() {
    let mut sitting = Sitting::with(|root| level(root, "Players", crate::sitting::FAR_AWAY, ""));
    sitting.choose("Levels").rest();
    let entry = sitting.level_select().entries.iter().find(|entry| entry.name == "Players").unwrap();
    assert!(entry.level.as_ref().unwrap().as_ref().is_err_and(|problems| problems[0].contains("players.csv")), "{entry:?}");
}

#[test]
fn the_credits_name_every_licence() {
    let mut sitting = Sitting::new();
    sitting.choose("Credits");
    let mut said = String::new();
    for _ in 0..30 {
        said += &sitting.texts().into_iter().map(|(text, _)| text + "\n").collect::<String>();
        sitting.press(Key::PageDown);
    }
    for words in ["Ubuntu Font Licence 1.0", "Bitstream Vera", "Apache 2.0", "MIT License", "MERCHANTABILITY"] {
        assert!(said.contains(words), "{words}");
    }
    assert!(sitting.shows("SOFTWARE.") && !sitting.shows("Built with"), "{:?}", sitting.texts());
    sitting.press(Key::Home);
    assert!(sitting.shows("Built with"));
    assert_eq!(sitting.give(Input::default()).press(Key::Enter).at(), "menu");
}
