//! From the score of a flight over the field for a name to the leaderboard.

use crate::sitting::{HERE, Sitting, board, hold, level, with_scores};
use resultant::draw::layout::Vec2;
use resultant::scores::Scores;
use resultant::screens::{Attempt, Destination, Input, Key, Request};
use resultant::view::theme;
use std::fs;
use std::path::Path;
use std::sync::Arc;

#[test]
fn save_and_next_are_there_only_when_they_may_be_used() {
    assert_eq!(Sitting::new().complete().labels(), ["Try Again", "Next Level", "Save Score", "Flights", "Main Menu"]);
    let without_save = ["Try Again", "Next Level", "Flights", "Main Menu"];
    assert_eq!(Sitting::new().lose().labels(), without_save, "a lost attempt cannot be saved");
    let mut sitting = Sitting::new();
    let flown = sitting.fly("1").flight().game().level().clone();
    let recording = Attempt { level: Arc::new(flown), inputs: Some(Arc::default()), rivals: Vec::new() };
    sitting.app.grant(Request::Reset(Destination::Fly(recording)), &mut ());
    assert_eq!(sitting.wait(1.5).labels(), without_save, "nor one that was watched");
    assert!(sitting.scoring().result().score.total > 0 && sitting.shows("recording"), "{:?}", sitting.texts());

    let last = |root: &Path| level(root, "z-last", HERE, "");
    let mut sitting = Sitting::with(last);
    assert_eq!(sitting.fly("z-last").wait(1.5).labels(), ["Try Again", "Save Score", "Flights", "Main Menu"]);
}

#[test]
fn the_keyboard_is_where_most_go_on() {
    assert_eq!(Sitting::new().complete().focused(), "Next Level");
    assert_eq!(Sitting::new().lose().focused(), "Try Again");
    let last = |root: &Path| level(root, "z-last", HERE, "");
    let mut sitting = Sitting::with(last);
    assert_eq!(sitting.fly("z-last").wait(1.5).focused(), "Save Score", "there is no next level");
}

#[test]
fn every_button_of_the_score_leads_where_it_says() {
    for (button, screen) in [
        ("Try Again", "flight"),
        ("Next Level", "flight"),
        ("Save Score", "save score"),
        ("Flights", "flights"),
        ("Main Menu", "menu"),
    ] {
        assert_eq!(Sitting::new().complete().click(button).at(), screen);
        let mut sitting = Sitting::new();
        assert_eq!(sitting.complete().choose(button).at(), screen);
        if screen == "flight" {
            assert_eq!(sitting.flown(), if button == "Try Again" { "1" } else { "2" });
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
    assert_eq!((rows[1][2].as_str(), rows[2][2].as_str()), ("optimal 00:10.00 · best 00:00.01", "−500 each"));
    let colours = ["Objectives met", "Time", "Damaging collisions", "Fuel left"].map(|part| sitting.colour(part));
    assert_eq!(colours, [theme::good(), theme::good(), theme::text(), theme::good()]);
    let sum: i64 = rows.iter().map(|row| row[row.len() - 1].replace('−', "-").parse::<i64>().unwrap()).sum();
    assert_eq!((sum, sitting.row("Score")[1].as_str()), (sitting.scoring().result().score.total, sum.to_string().as_str()));

    let mut lost = Sitting::new();
    assert_eq!((lost.lose().row("Objectives met")[1].as_str(), lost.colour("Objectives met")), ("0/1", theme::bad()));
}

#[test]
fn a_name_is_judged_on_submit_and_its_error_stays_until_it_is_mended() {
    let mut sitting = Sitting::new();
    sitting.reach_save_score().write("1bo");
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
    assert_eq!(sitting.at(), "leaderboard");
    let file = fs::read_to_string(sitting.folder.path().join("scores/1.csv")).unwrap();
    assert!(file.lines().nth(1).unwrap().starts_with("bob,"), "{file}");
}

#[test]
fn an_empty_board_invites_to_fly() {
    let mut sitting = Sitting::new();
    sitting.choose("Leaderboards").choose("1");
    assert_eq!(sitting.at(), "leaderboard");
    assert!(sitting.leaderboard().board().rows().is_empty() && sitting.shows("No scores yet"));
    assert_eq!(sitting.labels(), ["Play", "Flights", "Back"]);
    assert_eq!(sitting.press(Key::Enter).flown(), "1");
}

#[test]
fn a_score_is_saved_by_mouse_and_by_keyboard() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").click("Save").at(), "leaderboard");
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").press_all(&[Key::Down, Key::Enter]).at(), "leaderboard");
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").press_all(&[Key::Tab, Key::Right, Key::Enter]).at(), "scoring", "Back");
    assert_eq!(Sitting::new().reach_save_score().click("Back").at(), "scoring");
}

#[test]
fn once_a_player_has_a_name_a_score_is_saved_with_one_press() {
    let mut sitting = Sitting::new();
    sitting.reach_save_score().write("robert").press(Key::Enter);
    assert_eq!(sitting.labels(), ["Next Level", "Try Again", "Flights", "Main Menu"]);
    assert_eq!(sitting.press(Key::Escape).at(), "menu");
    assert_eq!(sitting.reach_save_score().at(), "leaderboard", "no name is asked for");
    assert_eq!(sitting.choose("Try Again").flown(), "1");
    sitting.reopen();
    assert_eq!(sitting.app.player().as_str(), "robert", "nor in another sitting");
    assert_eq!(sitting.reach_save_score().at(), "leaderboard");
    assert_eq!(sitting.choose("Next Level").flown(), "2");
    assert_eq!(sitting.scores_file("1.csv").lines().count(), 2);
}

#[test]
fn a_score_that_cannot_be_saved_says_why_and_stays() {
    let mut sitting = Sitting::with(|root| fs::write(root.join("scores"), "a file, no folder").unwrap());
    sitting.reach_save_score().write("ann").press(Key::Enter);
    assert!(sitting.warning().is_some());
    fs::remove_file(sitting.folder.path().join("scores")).unwrap();
    assert_eq!(sitting.press(Key::Enter).at(), "leaderboard");
}

#[test]
fn a_board_that_another_program_holds_is_saved_by_another_try() {
    let mut sitting = Sitting::with(|root| fs::create_dir(root.join("scores")).unwrap());
    let held = hold(&sitting, "1.csv");
    sitting.reach_save_score().write("ann").press(Key::Enter);
    assert_eq!(sitting.at(), "save score");
    assert!(sitting.shows("try again"), "{:?}", sitting.texts());
    drop(held);
    assert_eq!(sitting.click("Try again").at(), "leaderboard");
}

#[test]
fn the_row_just_saved_is_in_view_and_highlighted() {
    let mut sitting = with_scores("1.csv", &board(40).replace("20000", "30000"));
    sitting.reach_save_score().write("zoe").press(Key::Enter);
    let (row, names) = (sitting.row("zoe"), sitting.texts().iter().filter(|(text, _)| text.starts_with("user")).count());
    assert_eq!((sitting.picked().expect("a row is highlighted"), names), (sitting.place("zoe").y, 9), "{row:?}");
}

#[test]
fn a_worse_score_says_that_the_best_stays() {
    let mut sitting = with_scores("1.csv", "name,score\nann,30000\n");
    sitting.reach_save_score().write("ann").press(Key::Enter);
    assert!(sitting.shows("Leaderboard of level 1") && sitting.shows("Your best of 30000 points stays."));
    assert_eq!((sitting.picked(), sitting.row("ann")[0].as_str()), (Some(sitting.place("ann").y), "1"));
}

#[test]
fn a_leaderboard_turns_pages_by_keys_and_scrolls_by_wheel_and_bar_never_past_its_ends() {
    let mut sitting = with_scores("1.csv", &board(24));
    assert_eq!(sitting.choose("Leaderboards").choose("1").at(), "leaderboard");
    // The rows in view, of names with numbers from 0.
    let range = |sitting: &Sitting| {
        let texts = sitting.texts();
        let mut rows = texts.iter().filter_map(|(text, _)| text.strip_prefix("user")?.parse::<usize>().ok());
        let first = rows.next().unwrap_or_default();
        first..rows.next_back().unwrap_or(first) + 1
    };
    let first = |sitting: &mut Sitting| range(sitting.rest()).start;
    assert_eq!(range(&sitting), 0..10);
    assert_eq!(first(sitting.press(Key::Up)), 0);
    assert_eq!(first(sitting.press(Key::Down)), 10);
    assert_eq!(range(sitting.press(Key::Right)), 20..24, "aligned pages of ten");
    assert_eq!(first(sitting.press_all(&[Key::Down; 30])), 20);
    assert_eq!(first(sitting.press(Key::Left)), 10);
    assert_eq!(first(sitting.press(Key::End)), 14);
    assert_eq!(first(sitting.give(Input { wheel: 1.0, ..Input::default() })), 11);
    assert_eq!(first(sitting.press(Key::Up)), 10, "aligned again");
    for (wheel, end) in [(1.0, 0), (-1.0, 14)] {
        for _ in 0..20 {
            sitting.give(Input { wheel, ..Input::default() });
        }
        assert_eq!(first(&mut sitting), end);
    }
    // The bar is at the panel's right edge; its handle is at the foot.
    let (grab, up) = (Vec2::new(1126.0, 550.0), Vec2::new(826.0, -8450.0));
    let hold = |at: Vec2, click| Input { pointer: at, click, holding: true, ..Input::default() };
    sitting.give(hold(grab, true)).give(hold(up, false));
    assert_eq!(range(&sitting).start, 0, "dragged to the top, and beyond");
}

#[test]
fn an_empty_board_is_a_board_and_a_damaged_file_is_reported() {
    let mut sitting = with_scores("2.csv", "name,score\nann,30000\nbob,many\n");
    sitting.choose("Leaderboards").choose("1");
    assert!(sitting.leaderboard().board().rows().is_empty() && sitting.warning().is_none());
    sitting.press(Key::Escape).choose("2");
    assert_eq!(sitting.leaderboard().board().rows().len(), 1, "sound rows are shown");
    assert!(sitting.shows("2.csv:3"));
    let scores = Scores::new(sitting.folder.path().join("scores"));
    assert_eq!(scores.load("2").unwrap().damage.len(), 1, "looking changes nothing");
}

#[test]
fn points_count_up_and_the_button_names_the_key_that_flies_again() {
    let mut sitting = Sitting::new();
    sitting.fly("1").wait(1.25);
    assert_eq!(sitting.at(), "scoring");
    let total = sitting.scoring().result().score.total.to_string();
    assert_ne!(sitting.row("Score")[1], total, "it has just begun to count");
    sitting.wait(0.6);
    assert_eq!(sitting.row("Score")[1], total);
    let again = sitting.area("Try Again");
    assert!(sitting.texts().iter().any(|(text, at)| text.starts_with('R') && again.contains(*at)), "{:?}", sitting.texts());
}
