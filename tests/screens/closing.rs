//! The window is closed while something is neither saved nor kept: the game asks, and nothing is lost unless the player says so.

use crate::editor;
use crate::lesson::{opened, predict};
use crate::sitting::Sitting;
use resultant::level::document::Kind;
use resultant::screens::Key;
use std::fs;
use std::path::Path;

const STAY: &str = "Stay here";
const ANYWAY: &str = "Close anyway";

#[track_caller]
fn asks(sitting: &mut Sitting, words: &str) {
    assert!(sitting.app.is_at_risk() && !sitting.app.may_close(), "{words}");
    assert_eq!((sitting.rest().at(), sitting.focused()), ("closing", STAY));
    assert!(sitting.shows(words), "{words}: {:?}", sitting.texts());
    assert!(!sitting.app.may_close(), "it asks already");
}

#[track_caller]
fn closes(sitting: &mut Sitting) {
    assert!(!sitting.app.is_at_risk() && sitting.app.may_close(), "{}", sitting.at());
}

/// As on a full disk, or in a folder that is read-only: nothing takes the place of a folder with a file in it.
fn block(file: &Path) {
    fs::create_dir(file).unwrap();
    fs::write(file.join("in-the-way"), "").unwrap();
}

fn edited(prepare: impl Fn(&Path)) -> Sitting {
    let mut sitting = editor::open();
    prepare(&sitting.folder.path().join("levels/2/.autosave"));
    editor::draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    assert!(sitting.rest().editor().is_unsaved());
    sitting
}

#[test]
fn edits_that_are_kept_close_and_come_back() {
    let mut sitting = edited(|_| {});
    closes(&mut sitting);
    sitting.reopen().choose("Editor").choose("2").rest();
    assert!(sitting.shows("There are edits that were not saved."));
    closes(&mut sitting);
    assert!(sitting.click("Have them back").editor().is_unsaved());
}

#[test]
fn edits_that_cannot_be_kept_are_asked_about_also_while_they_are_flown() {
    let mut sitting = edited(block);
    let kept = sitting.folder.path().join("levels/2/.autosave");
    for key in [Key::Escape, Key::Enter] {
        asks(&mut sitting, "The edits cannot be kept beside the files");
        assert_eq!(sitting.press(key).rest().at(), "editor");
        assert!(sitting.editor().is_unsaved() && sitting.open);
    }
    sitting.press(Key::F5).wait(0.2);
    assert_eq!(sitting.at(), "test flight");
    asks(&mut sitting, "The edits cannot be kept beside the files");
    assert_eq!(sitting.click(STAY).rest().at(), "test flight");
    fs::remove_dir_all(&kept).unwrap();
    assert!(sitting.app.may_close() && kept.is_file());
    fs::remove_file(&kept).unwrap();
    block(&kept);
    assert!(!sitting.app.may_close());
    sitting.rest().choose(ANYWAY);
    assert!(!sitting.open);
}

#[test]
fn a_guests_scores_are_asked_about_until_they_have_a_name() {
    let mut sitting = Sitting::new();
    sitting.fly("1").wait(0.2);
    assert_eq!(sitting.at(), "flight");
    asks(&mut sitting, "points in");
    sitting.press(Key::Escape).wait(2.0);
    assert_eq!(sitting.at(), "scoring");
    asks(&mut sitting, "points in");
    assert_eq!(sitting.press(Key::Enter).rest().at(), "scoring");
    sitting.home();
    asks(&mut sitting, "points in");
    assert_eq!(sitting.press(Key::Escape).rest().at(), "menu");
    sitting.become_new("ann");
    assert!(sitting.scores_file("1.csv").contains("\nann,"), "what ann has flown without a name");
    closes(&mut sitting);
    sitting.complete();
    closes(&mut sitting);
}

#[test]
fn what_was_done_and_set_is_asked_about_where_it_cannot_be_written() {
    let mut sitting = Sitting::with(|root| {
        fs::write(root.join("scores"), "a file").unwrap();
        fs::create_dir(root.join("settings.csv")).unwrap();
    });
    closes(&mut sitting);
    sitting.press(Key::F11);
    asks(&mut sitting, "settings.csv");
    sitting.press(Key::Enter).rest();
    fs::remove_dir(sitting.folder.path().join("settings.csv")).unwrap();
    assert!(sitting.app.may_close());
    closes(&mut sitting);
    assert!(fs::read_to_string(sitting.folder.path().join("settings.csv")).unwrap().contains("fullscreen,on"));
    sitting.complete().home().rest();
    asks(&mut sitting, "scores");
    assert_eq!(sitting.click(STAY).rest().at(), "menu");
    sitting.choose("Quit").rest();
    assert_eq!((sitting.at(), sitting.open), ("closing", true));
    sitting.click(STAY).rest();
    fs::remove_file(sitting.folder.path().join("scores")).unwrap();
    sitting.choose("Quit").rest().choose(ANYWAY);
    assert!(!sitting.open && sitting.scores_file("attempts.csv").lines().count() == 2, "{}", sitting.scores_file("attempts.csv"));
}

#[test]
fn an_answer_that_cannot_be_written_is_asked_about_and_is_written_once() {
    let mut sitting = opened("hooke");
    predict(&mut sitting, "40");
    let folder = sitting.folder.path().join("results");
    fs::write(&folder, "a file").unwrap();
    asks(&mut sitting, "results");
    assert_eq!(sitting.click(STAY).rest().at(), "pause");
    assert!(sitting.shows("40"), "the sheet is still there");
    // It is remembered once its experiment is left.
    sitting.click("Main Menu").rest();
    asks(&mut sitting, "hooke");
    sitting.click(STAY).rest();
    fs::remove_file(&folder).unwrap();
    assert!(sitting.app.may_close());
    closes(&mut sitting);
    let rows = fs::read_to_string(folder.join("Guest.csv")).unwrap();
    assert_eq!((rows.lines().count(), rows.matches(",hooke,").count()), (2, 1), "{rows}");
}
