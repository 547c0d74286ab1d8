//! From the score of a flight over the field for a name to the leaderboard.

use crate::sitting::{HERE, Sitting, board, level};
use resultant::scores::Scores;
use resultant::screens::{Attempt, Effect, Input, Key, Press, Request};
use resultant::view::layout::Vec2;
use std::fs;
use std::path::Path;
use std::sync::Arc;

#[test]
fn save_and_next_are_there_only_when_they_may_be_used() {
    let presses = |sitting: &Sitting| sitting.scoring().presses().to_vec();
    assert_eq!(
        presses(Sitting::new().complete()),
        [Press::Replay, Press::NextLevel, Press::SaveScore, Press::Flights, Press::MainMenu]
    );
    assert_eq!(
        presses(Sitting::new().lose()),
        [Press::Replay, Press::NextLevel, Press::Flights, Press::MainMenu],
        "a lost attempt cannot be saved"
    );
    let mut sitting = Sitting::new();
    let flown = sitting.fly(0).flight().game().level().clone();
    let recording = Attempt { level: Arc::new(flown), inputs: Some(Arc::default()), rivals: Vec::new() };
    sitting.app.grant(Request::Attempt(recording), &mut ());
    let watched = sitting.wait(1.5).scoring();
    assert_eq!(watched.presses(), [Press::Replay, Press::NextLevel, Press::Flights, Press::MainMenu], "nor one that was watched");
    assert!(watched.result().score.total > 0 && watched.remark().contains("recording"), "{}", watched.remark());

    let last = |root: &Path| level(root, "z-last", HERE, "");
    let mut sitting = Sitting::with(last);
    assert_eq!(sitting.fly(5).wait(1.5).scoring().presses(), [Press::Replay, Press::SaveScore, Press::Flights, Press::MainMenu]);
}

#[test]
fn the_keyboard_is_where_most_go_on() {
    let focused = |sitting: &Sitting| sitting.scoring().presses()[sitting.buttons().focus()];
    assert_eq!((focused(Sitting::new().complete()), focused(Sitting::new().lose())), (Press::NextLevel, Press::Replay));
    let last = |root: &Path| level(root, "z-last", HERE, "");
    let mut sitting = Sitting::with(last);
    let focus = sitting.fly(5).wait(1.5).buttons().focus();
    assert_eq!(sitting.scoring().presses()[focus], Press::SaveScore, "there is no next level");
}

#[test]
fn every_button_of_the_score_leads_where_it_says() {
    for (index, screen) in [(0, "flight"), (1, "flight"), (2, "save score"), (3, "flights"), (4, "menu")] {
        assert_eq!(Sitting::new().complete().click(index).at(), screen);
        let mut sitting = Sitting::new();
        assert_eq!(sitting.complete().choose(index).at(), screen);
        match index {
            0 => assert_eq!(sitting.flight().game().level().name, "1"),
            1 => assert_eq!(sitting.flight().game().level().name, "2"),
            _ => {}
        }
    }
}

#[test]
fn the_score_is_explained_part_by_part() {
    let mut sitting = Sitting::new();
    let parts = sitting.complete().scoring().parts();
    let lines: Vec<_> = parts.iter().map(|part| (part.label, part.value.as_str(), part.effect)).collect();
    assert_eq!(
        lines,
        [
            ("Objectives met", "1/1", Effect::Helped),
            ("Time", "00:00.01", Effect::Helped),
            ("Damaging collisions", "0", Effect::Nothing),
            ("Fuel left", "100 %", Effect::Helped),
        ]
    );
    assert_eq!((parts[1].beside.as_str(), parts[2].beside.as_str()), ("optimal 00:10.00 · best 00:00.01", "−500 each"));
    let sum: i64 = parts.iter().map(|part| part.points.replace('−', "-").parse::<i64>().unwrap()).sum();
    assert_eq!(sum, sitting.scoring().result().score.total);

    let lost = Sitting::new().lose().scoring().parts();
    assert_eq!((lost[0].value.as_str(), lost[0].effect), ("0/1", Effect::Cost));
}

#[test]
fn a_name_is_judged_on_submit_and_its_error_stays_until_it_is_mended() {
    let mut sitting = Sitting::new();
    sitting.reach_save_score().write("1bo");
    assert_eq!(sitting.save_score().error(), None, "not while typing");
    sitting.press(Key::Enter);
    let error = sitting.save_score().error().expect("refused").to_owned();
    assert!(error.contains("letter"), "{error}");
    sitting.write("b").wait(1.0);
    assert_eq!(sitting.save_score().error(), Some(error.as_str()), "still wrong");
    sitting.press_all(&[Key::Backspace; 4]);
    let empty = sitting.save_score().error().expect("still wrong, in another way").to_owned();
    assert_ne!(empty, error);
    sitting.write("bob");
    assert_eq!(sitting.save_score().error(), None, "mended");
    assert!(!sitting.folder.path().join("scores/1.csv").exists(), "nothing is saved before it is asked for");
    sitting.press(Key::Enter);
    assert_eq!(sitting.at(), "leaderboard");
    let file = fs::read_to_string(sitting.folder.path().join("scores/1.csv")).unwrap();
    assert!(file.lines().nth(1).unwrap().starts_with("bob,"), "{file}");
}

#[test]
fn an_empty_board_invites_to_fly() {
    let mut sitting = Sitting::new();
    sitting.choose(2).choose(0);
    assert_eq!(sitting.at(), "leaderboard");
    assert!(sitting.leaderboard().board().rows().is_empty());
    assert_eq!(sitting.leaderboard().labels().collect::<Vec<_>>(), ["Play", "Flights", "Back"]);
    assert_eq!(sitting.press(Key::Enter).flight().game().level().name, "1");
}

#[test]
fn the_field_takes_forty_characters() {
    let mut sitting = Sitting::new();
    sitting.reach_save_score().write(&"a".repeat(50));
    assert_eq!(sitting.save_score().text().len(), 40);
    sitting.press(Key::Enter);
    assert!(sitting.save_score().error().is_some_and(|error| error.contains("long")));
}

#[test]
fn a_score_is_saved_by_mouse_and_by_keyboard() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").click(0).at(), "leaderboard");
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").press_all(&[Key::Down, Key::Enter]).at(), "leaderboard");
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").press_all(&[Key::Tab, Key::Right, Key::Enter]).at(), "scoring", "Back");
    assert_eq!(Sitting::new().reach_save_score().click(1).at(), "scoring");
}

#[test]
fn once_a_player_has_a_name_a_score_is_saved_with_one_press() {
    let mut sitting = Sitting::new();
    sitting.reach_save_score().write("robert").press(Key::Enter);
    assert_eq!(sitting.leaderboard().labels().collect::<Vec<_>>(), ["Next Level", "Try Again", "Flights", "Main Menu"]);
    assert_eq!(sitting.press(Key::Escape).at(), "menu");
    assert_eq!(sitting.reach_save_score().at(), "leaderboard", "no name is asked for");
    assert_eq!(sitting.choose(1).flight().game().level().name, "1");
    sitting.reopen();
    assert_eq!(sitting.app.player().as_str(), "robert", "nor in another sitting");
    assert_eq!(sitting.reach_save_score().at(), "leaderboard");
    assert_eq!(sitting.choose(0).flight().game().level().name, "2");
    assert_eq!(sitting.scores_file("1.csv").lines().count(), 2);
}

#[test]
fn a_score_that_cannot_be_saved_says_why_and_stays() {
    let mut sitting = Sitting::with(|root| fs::write(root.join("scores"), "a file, no folder").unwrap());
    sitting.reach_save_score().write("ann").press(Key::Enter);
    assert!(sitting.save_score().error().is_some());
    fs::remove_file(sitting.folder.path().join("scores")).unwrap();
    assert_eq!(sitting.press(Key::Enter).at(), "leaderboard");
}

#[test]
fn a_board_that_another_program_holds_is_waited_for_without_holding_up_a_frame() {
    let hold = |sitting: &Sitting| {
        let held = fs::File::create(sitting.folder.path().join("scores/.1.csv.lock")).unwrap();
        held.lock().unwrap();
        held
    };
    let mut sitting = Sitting::with(|root| fs::create_dir(root.join("scores")).unwrap());
    let held = hold(&sitting);
    sitting.reach_save_score().write("ann");
    let before = resultant::files::pauses();
    sitting.press(Key::Enter).rest();
    assert_eq!(resultant::files::pauses(), before, "a frame was spent on waiting");
    sitting.wait(1.0);
    assert!(sitting.save_score().error().is_some_and(|error| error.contains("waiting")), "{:?}", sitting.save_score().error());
    drop(held);
    assert_eq!(sitting.rest().at(), "leaderboard", "saved as soon as it can be");

    let mut sitting = Sitting::with(|root| fs::create_dir(root.join("scores")).unwrap());
    let held = hold(&sitting);
    sitting.reach_save_score().write("ann").press(Key::Enter).wait(2.1);
    assert!(sitting.save_score().error().is_some_and(|error| error.contains("try again")), "{:?}", sitting.save_score().error());
    drop(held);
    assert_eq!(sitting.wait(1.0).at(), "save score", "given up");
    assert_eq!(sitting.press(Key::Enter).at(), "leaderboard", "tried again");

    let mut sitting = Sitting::with(|root| fs::create_dir(root.join("scores")).unwrap());
    let held = hold(&sitting);
    sitting.reach_save_score().write("ann").press(Key::Enter).write("a");
    drop(held);
    assert_eq!(sitting.wait(0.5).at(), "save score", "another name was being typed");
}

#[test]
fn the_row_just_saved_is_in_view_and_highlighted() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/1.csv"), board(40).replace("20000", "30000")).unwrap();
    });
    sitting.reach_save_score().write("zoe").press(Key::Enter);
    let screen = sitting.leaderboard();
    let saved = screen.saved().expect("a row is highlighted");
    assert_eq!(screen.board().rows()[saved].name.as_str(), "zoe");
    assert!(screen.range().contains(&saved));
    assert_eq!(screen.range().len(), 10);
}

#[test]
fn a_worse_score_says_that_the_best_stays() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/1.csv"), "name,score\nann,30000\n").unwrap();
    });
    sitting.reach_save_score().write("ann").press(Key::Enter);
    assert_eq!(sitting.leaderboard().subject(), "level 1");
    assert_eq!(sitting.leaderboard().saved(), Some(0));
    assert!(sitting.leaderboard().remark().is_some_and(|remark| remark.contains("30000")));
}

#[test]
fn a_leaderboard_turns_pages_by_keys_and_scrolls_by_wheel_and_bar_never_past_its_ends() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/1.csv"), board(24)).unwrap();
    });
    assert_eq!(sitting.choose(2).choose(0).at(), "leaderboard");
    let first = |sitting: &mut Sitting| sitting.rest().leaderboard().range().start;
    assert_eq!(sitting.leaderboard().range(), 0..10);
    assert_eq!(first(sitting.press(Key::Up)), 0);
    assert_eq!(first(sitting.press(Key::Down)), 10);
    assert_eq!(sitting.press(Key::Right).leaderboard().range(), 20..24, "aligned pages of ten");
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
    let bar = sitting.leaderboard().bar().expect("there is a bar");
    let grab = bar.handle.centre();
    let hold = |at: Vec2, click| Input { pointer: at, click, holding: true, ..Input::default() };
    sitting.give(hold(grab, true)).give(hold(grab - Vec2::new(300.0, 9000.0), false));
    assert_eq!(sitting.leaderboard().range().start, 0, "dragged to the top, and beyond");
    sitting.give(hold(grab, false));
    assert_eq!(sitting.leaderboard().range(), 14..24);
    sitting.rest().point_at(bar.track.min);
    assert_eq!(first(&mut sitting), 14, "let go");
}

#[test]
fn an_empty_board_is_a_board_and_a_damaged_file_is_reported() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/2.csv"), "name,score\nann,30000\nbob,many\n").unwrap();
    });
    sitting.choose(2).choose(0);
    assert!(sitting.leaderboard().board().rows().is_empty() && sitting.leaderboard().damage().is_none());
    sitting.press(Key::Escape).choose(1);
    assert_eq!(sitting.leaderboard().board().rows().len(), 1, "sound rows are shown");
    assert!(sitting.leaderboard().damage().is_some_and(|damage| damage.contains("2.csv:3")));
    let scores = Scores::new(sitting.folder.path().join("scores"));
    assert_eq!(scores.load("2").unwrap().damage.len(), 1, "looking changes nothing");
}
