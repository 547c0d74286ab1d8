//! The score of a flight, which is saved by itself, and its leaderboard.

use crate::sitting::{HERE, Sitting, board, hold, level, with_scores};
use resultant::scores::Scores;
use resultant::screens::{Attempt, Destination, Input, Key, Request};
use resultant::view::theme;
use std::fs;
use std::path::Path;
use std::sync::Arc;

#[test]
fn save_and_next_are_there_only_when_they_may_be_used() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.complete().labels(), ["Next", "Again", "Watch", "Board", "Save Score"]);
    assert_eq!(sitting.focused(), "Next", "where most go on");
    assert_eq!(Sitting::new().become_new("ann").complete().labels(), ["Next", "Again", "Watch", "Board"]);
    let mut sitting = Sitting::new();
    assert_eq!(sitting.lose().labels(), ["Again", "Next", "Watch", "Board"], "a lost attempt cannot be saved");
    assert_eq!(sitting.focused(), "Again");
    let mut sitting = Sitting::new();
    let flown = sitting.fly("1").flight().game().level().clone();
    let recording = Attempt { level: Arc::new(flown), inputs: Some(Arc::default()), rivals: Vec::new() };
    sitting.app.grant(Request::Reset(Destination::Fly(recording)), &mut ());
    assert_eq!(sitting.wait(1.5).labels(), ["Next", "Again", "Board"], "nor one that was watched");
    assert!(sitting.scoring().result.score.total > 0 && sitting.shows("recording"), "{:?}", sitting.texts());
    let last = |root: &Path| level(root, "z-last", HERE, "");
    let mut sitting = Sitting::with(last);
    assert_eq!(sitting.fly("z-last").wait(1.5).labels(), ["Again", "Watch", "Board", "Save Score"]);
    assert_eq!(sitting.focused(), "Again", "there is no next level");
}

#[test]
fn every_button_of_the_score_leads_where_it_says() {
    for (button, screen) in
        [("Next", "flight"), ("Again", "flight"), ("Watch", "watch"), ("Board", "leaderboard"), ("Save Score", "new player")]
    {
        assert_eq!(Sitting::new().complete().click(button).at(), screen);
        let mut sitting = Sitting::new();
        assert_eq!(sitting.complete().choose(button).at(), screen);
        if screen == "flight" {
            assert_eq!(sitting.flown(), if button == "Again" { "1" } else { "2" });
        }
    }
}

#[test]
fn the_score_is_explained_part_by_part() {
    let mut sitting = Sitting::new();
    sitting.complete();
    let rows = ["Objectives met", "Time", "Damaging collisions", "Fuel left"].map(|part| sitting.row(part));
    let reached: Vec<&str> = rows.iter().map(|row| row[1].as_str()).collect();
    assert_eq!(reached, ["1/1", "00:00.01", "0", "100 %"]);
    assert!(sitting.shows("optimal 00:10.00 · best 00:00.01") && sitting.shows("−500 each"));
    let colours = ["Objectives met", "Time", "Damaging collisions", "Fuel left"].map(|part| sitting.colour(part));
    assert_eq!(colours, [theme::good(), theme::good(), theme::text(), theme::good()]);
    let sum: i64 = rows.iter().map(|row| row[row.len() - 1].replace('−', "-").parse::<i64>().unwrap()).sum();
    assert_eq!((sum, sitting.row("Score")[1].as_str()), (sitting.scoring().result.score.total, sum.to_string().as_str()));
    let mut lost = Sitting::new();
    assert_eq!((lost.lose().row("Objectives met")[1].as_str(), lost.colour("Objectives met")), ("0/1", theme::bad()));
}

#[test]
fn a_name_is_judged_on_submit_and_its_error_stays_until_it_is_mended() {
    let mut sitting = Sitting::new();
    sitting.complete().choose("Save Score").write("1bo");
    assert_eq!(sitting.warning(), None, "not while typing");
    sitting.press(Key::Enter);
    let error = sitting.warning().expect("refused");
    assert!(error.contains("letter"), "{error}");
    sitting.write("b").wait(1.0);
    assert_eq!(sitting.warning(), Some(error.clone()), "still wrong");
    sitting.press_all(&[Key::Backspace; 4]);
    assert!(sitting.warning().is_some_and(|empty| empty != error), "still wrong, in another way");
    sitting.write("bob");
    assert_eq!(sitting.warning(), None, "mended");
    assert!(!sitting.folder.path().join("scores/1.csv").exists(), "nothing is saved before it is asked for");
    sitting.press(Key::Enter);
    assert_eq!(sitting.at(), "scoring");
    assert!(sitting.shows("Saved for bob."));
    let file = fs::read_to_string(sitting.folder.path().join("scores/1.csv")).unwrap();
    assert!(file.lines().nth(1).unwrap().starts_with("bob,"), "{file}");
}

#[test]
fn an_empty_board_invites_to_fly() {
    let mut sitting = Sitting::new();
    sitting.choose("Boards").choose("1");
    assert_eq!(sitting.at(), "leaderboard");
    assert!(sitting.leaderboard().board.rows().is_empty() && sitting.shows("No scores yet") && sitting.warning().is_none());
    assert_eq!(sitting.labels(), ["Play", "Flights", "Back"]);
    assert_eq!(sitting.press(Key::Enter).flown(), "1");
}

#[test]
fn once_a_player_has_a_name_a_score_is_saved_by_itself() {
    let mut sitting = Sitting::new();
    sitting.become_new("robert").complete();
    assert_eq!(sitting.scores_file("1.csv").lines().count(), 2);
    assert!(sitting.scores_file("1.csv").contains("\nrobert,"), "no key was pressed since");
    assert_eq!(sitting.choose("Again").flown(), "1");
    sitting.reopen();
    assert_eq!(sitting.app.player().as_str(), "robert", "also in another sitting");
    assert_eq!(sitting.complete().choose("Next").flown(), "2");
    assert_eq!(sitting.scores_file("1.csv").lines().count(), 2);
}

#[test]
fn a_score_that_cannot_be_saved_says_why_and_waits() {
    let mut sitting = Sitting::with(|root| fs::create_dir(root.join("scores")).unwrap());
    sitting.become_new("ann");
    let held = hold(&sitting, "1.csv");
    sitting.complete();
    assert!(sitting.shows(".1.csv.lock"), "{:?}", sitting.texts());
    assert!(sitting.home().shows("1.csv.lock") && sitting.app.is_at_risk());
    drop(held);
    assert!(!sitting.click("Try again").shows("1.csv.lock"));
    assert!(sitting.scores_file("1.csv").contains("\nann,") && !sitting.app.is_at_risk());
}

#[test]
fn the_players_row_is_in_view_and_highlighted() {
    let mut sitting = with_scores("1.csv", &board(40).replace("20000", "30000"));
    sitting.save_as("zoe");
    let (row, names) = (sitting.row("zoe"), sitting.texts().iter().filter(|(text, _)| text.starts_with("user")).count());
    assert_eq!((sitting.picked().expect("a row is highlighted"), names), (sitting.place("zoe").y, 9), "{row:?}");
}

#[test]
fn a_worse_score_says_that_the_best_stays() {
    let mut sitting = with_scores("1.csv", "name,score\nann,30000\n");
    sitting.become_new("ann").complete();
    assert!(sitting.shows("Your best of 30000"), "{:?}", sitting.texts());
    sitting.choose("Board");
    assert_eq!((sitting.picked(), sitting.row("ann")[0].as_str()), (Some(sitting.place("ann").y), "1"));
}

#[test]
fn a_leaderboard_turns_aligned_pages_of_ten_and_scrolls_by_wheel() {
    let mut sitting = with_scores("1.csv", &board(24));
    assert_eq!(sitting.choose("Boards").choose("1").at(), "leaderboard");
    // The rows in view, of names with numbers from 0.
    let range = |sitting: &mut Sitting| {
        let texts = sitting.rest().texts();
        let mut rows = texts.iter().filter_map(|(text, _)| text.strip_prefix("user")?.parse::<usize>().ok());
        let first = rows.next().unwrap_or_default();
        first..rows.next_back().unwrap_or(first) + 1
    };
    assert_eq!(range(&mut sitting), 0..10);
    assert_eq!(range(sitting.press(Key::Down)), 10..20);
    assert_eq!(range(sitting.press(Key::Right)), 20..24);
    sitting.press(Key::Left);
    assert_eq!(range(sitting.give(Input { wheel: 1.0, ..Input::default() })), 7..17);
}

#[test]
fn a_damaged_file_is_reported_beside_its_sound_rows() {
    let mut sitting = with_scores("2.csv", "name,score\nann,30000\nbob,many\n");
    sitting.choose("Boards").choose("2");
    assert_eq!(sitting.leaderboard().board.rows().len(), 1, "sound rows are shown");
    assert!(sitting.shows("2.csv:3"));
    let scores = Scores::new(sitting.folder.path().join("scores"));
    assert_eq!(scores.load("2").unwrap().damage.len(), 1, "looking changes nothing");
}

#[test]
fn points_count_up_and_the_button_names_the_key_that_flies_again() {
    let mut sitting = Sitting::new();
    sitting.fly("1").wait(1.25);
    assert_eq!(sitting.at(), "scoring");
    let total = sitting.scoring().result.score.total.to_string();
    assert_ne!(sitting.row("Score")[1], total, "it has just begun to count");
    sitting.wait(0.6);
    assert_eq!(sitting.row("Score")[1], total);
    let again = sitting.area("Again");
    assert!(sitting.texts().iter().any(|(text, at)| text.starts_with('R') && again.contains(*at)), "{:?}", sitting.texts());
}
