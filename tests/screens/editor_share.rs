//! The author's list of levels: own ones first, shared as one file, imported, put into the bin and taken back; and copies of what comes with the game.

use crate::editor::{control, draw, file};
use crate::sitting::Sitting;
use crate::support::tiled::{map, object, things};
use resultant::level::document::Kind;
use resultant::screens::{Destination, Input, Key, Places, Stack};
use std::fs;
use std::path::Path;

fn shipped(root: &Path) {
    fs::write(root.join("levels/shipped.csv"), "folder\n1\n2\n").unwrap();
    for level in ["1", "2"] {
        let constants = root.join("levels").join(level).join("constants.csv");
        let before = fs::read_to_string(&constants).unwrap_or_else(|_| "name,value\n".to_owned());
        fs::write(constants, before + "world,launch\n").unwrap();
    }
}

fn list() -> Sitting {
    let mut sitting = Sitting::with(shipped);
    sitting.choose("Editor").rest();
    sitting
}

fn undo(sitting: &mut Sitting) {
    sitting.press_keys(&[Key::Z], &[Key::Control, Key::Z]).rest();
}

#[test]
fn an_authors_own_levels_stand_first() {
    let mut sitting = list();
    assert_eq!(sitting.level_names(), ["3", "10", "broken", "1", "2"]);
    assert!(sitting.shows("Your levels"));
    sitting.assert_whole();
    sitting.home().choose("Levels").rest();
    assert_eq!(sitting.level_names()[..2], ["1", "2"], "players begin with the game's");
}

#[test]
fn a_level_is_one_file_that_another_game_takes_in() {
    let mut sitting = list();
    sitting.click("Share");
    assert!(sitting.shows("Which level is to be shared?"));
    sitting.click("10").rest();
    let file = sitting.folder.path().join("exports/10.zip");
    assert!(file.exists() && sitting.at() == "problems" && sitting.shows("10 is one file now"));
    sitting.press(Key::Escape).click("Share").click("broken").rest();
    assert!(sitting.at() == "problems" && sitting.shows("That cannot be done") && sitting.shows("obstacles.csv"));
    let mut other = Sitting::with(|root| fs::remove_dir_all(root.join("levels/10")).unwrap());
    other.choose("Editor").click("Import");
    assert!(other.shows("Which file?"));
    other.write(file.to_str().unwrap()).press(Key::Enter).rest();
    assert!(other.shows("Installed: 10"), "{:?}", other.texts());
    assert!(other.folder.path().join("levels/10/player.csv").exists());
    other.press(Key::Escape).choose("10").rest();
    assert_eq!(other.at(), "flight");
}

#[test]
fn a_map_of_tiled_is_taken_in_by_a_drop_or_by_its_path() {
    let with = |class: &str| map(&[&things()[..], &[object(9, class, [300.0, 100.0, 40.0, 40.0], &[])]].concat().join(","));
    let mut sitting = list();
    let root = sitting.folder.path().to_path_buf();
    let write = |name: &str, text: String| {
        fs::write(root.join(name), text).unwrap();
        root.join(name)
    };
    sitting.give(Input { dropped: vec![write("tower.tmj", with("world"))], ..Input::default() }).rest();
    assert!(sitting.shows("Installed: tower") && sitting.shows("flowers"), "what is left out is named: {:?}", sitting.texts());
    assert!(root.join("levels/tower/player.csv").exists());
    for (name, class, said) in [("hut.tmj", "houses", "houses"), ("a hut.tmj", "world", "a level cannot have this name")] {
        let path = write(name, with(class));
        sitting.home().choose("Editor").click("Import").write(path.to_str().unwrap()).press(Key::Enter).rest();
        assert!(sitting.shows("This file cannot be opened") && sitting.shows(said), "{name}: {:?}", sitting.texts());
        sitting.press(Key::Escape);
    }
    assert!(!root.join("levels/hut").exists());
}

#[test]
fn what_is_deleted_goes_to_the_bin_and_one_key_brings_it_back() {
    let mut sitting = list();
    let folder = sitting.folder.path().join("levels/10");
    let before = fs::read(folder.join("player.csv")).unwrap();
    sitting.click("Delete").click("10").rest();
    assert!(!folder.exists() && sitting.shows("10 is in the bin: Ctrl Z brings it back."));
    assert_eq!(sitting.level_names(), ["3", "broken", "1", "2"]);
    assert_eq!(fs::read(sitting.folder.path().join("bin/10/player.csv")).unwrap(), before);
    sitting.click("Delete").click("3").rest();
    undo(&mut sitting);
    undo(&mut sitting);
    assert_eq!(sitting.level_names(), ["3", "10", "broken", "1", "2"]);
    assert!(fs::read(folder.join("player.csv")).unwrap() == before && !sitting.shows("in the bin"));
    sitting.click("Delete").click("2").rest();
    assert!(sitting.shows("2 comes with the game and stays as it is."));
    assert!(sitting.folder.path().join("levels/2").exists());
    sitting.press(Key::Escape).click("Delete").press(Key::Escape).click("10").rest();
    assert_eq!(sitting.at(), "editor");
}

#[test]
fn what_comes_with_the_game_is_edited_as_a_copy() {
    let shipped = |root: &std::path::Path| fs::write(root.join("levels/shipped.csv"), "# ours\nfolder\n2\n").unwrap();
    let mut sitting = Sitting::with(shipped);
    let before = fs::read(file(&sitting, "player.csv")).unwrap();
    sitting.choose("Editor").choose("2").rest();
    assert_eq!(sitting.at(), "levels to edit");
    assert!(sitting.shows("What is your copy of 2 called?") && sitting.shows("2 comes with the game and stays as it is."));
    assert_eq!(sitting.field(), "2-copy");
    sitting.press(Key::Escape);
    assert!(sitting.at() == "levels to edit" && !sitting.labels().contains(&"OK"));
    assert!(!sitting.folder.path().join("levels/2-copy").exists());
    sitting.choose("2").press(Key::Enter).rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2-copy"));
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    control(&mut sitting, Key::S);
    assert!(sitting.folder.path().join("levels/2-copy/world.csv").exists() && !file(&sitting, "world.csv").exists());
    assert_eq!(fs::read(file(&sitting, "player.csv")).unwrap(), before);
    // The copy is the author's own; one more gets another name; and the original keeps its own.
    sitting.press_all(&[Key::Escape, Key::Escape, Key::Enter]).rest().choose("2-copy").rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2-copy"));
    sitting.press_all(&[Key::Escape, Key::Enter]).choose("2").rest();
    assert_eq!(sitting.field(), "2-copy-2");
    sitting.press(Key::Escape).choose("Rename").choose("2").write("x").press(Key::Enter);
    assert!(sitting.shows("comes with the game"));
    let folder = file(&sitting, "");
    sitting.app.begin(&folder, Destination::Edit { name: "2".to_owned(), original: true }, &mut ());
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2"));
}

/// As in a checkout, where the data folder is `.`, and in a browser's page.
#[cfg(unix)]
#[test]
fn a_copy_is_made_with_a_relative_data_folder() {
    let mut sitting = Sitting::with(|root| fs::write(root.join("levels/shipped.csv"), "folder\n2\n").unwrap());
    let up = std::env::current_dir().unwrap().components().skip(1).map(|_| "../").collect::<String>();
    let root = std::path::PathBuf::from(up).join(sitting.folder.path().strip_prefix("/").unwrap());
    let places = Places { levels: root.join("levels"), scores: root.join("scores"), settings: root.join("settings.csv"), root };
    sitting.app = Stack::new(places);
    let copy = Destination::Edit { name: "2".to_owned(), original: false };
    sitting.app.begin(&sitting.folder.path().join("levels/2"), copy, &mut ());
    assert_eq!(sitting.rest().field(), "2-copy");
    assert_eq!(sitting.press(Key::Enter).rest().editor().name(), "2-copy");
    sitting.press_all(&[Key::Escape, Key::Enter]).choose("Copy").choose("2-copy").press(Key::Enter).rest();
    assert_eq!(sitting.editor().name(), "2-copy-copy");
}
