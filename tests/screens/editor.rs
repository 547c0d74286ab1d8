//! The editor, without a window: each button and field is pressed by its label.

use crate::sitting::Sitting;
use resultant::draw::layout::Vec2;
use resultant::draw::{Contour, Shape};
use resultant::level;
use resultant::level::document::{Kind, Place, RowId, Table};
use resultant::physics::DVec2;
use resultant::screens::{Destination, Input, Key, Places, Stack};
use resultant::view::theme;
use std::fs;
use std::path::PathBuf;

/// An editor of level 2: a room of 800 × 600 pixels with the ship and a pad in a corner.
pub fn open() -> Sitting {
    let mut sitting = Sitting::new();
    sitting.choose("Editor").choose("2").rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2"));
    sitting
}

pub fn file(sitting: &Sitting, name: &str) -> PathBuf {
    sitting.folder.path().join("levels/2").join(name)
}

pub fn text(sitting: &Sitting, table: Table) -> String {
    String::from_utf8(sitting.editor().document().bytes(table).unwrap_or_default().to_vec()).unwrap()
}

pub fn cell<'a>(sitting: &'a Sitting, row: RowId, column: &str) -> Option<&'a str> {
    sitting.editor().document().cell(row, column)
}

pub fn rows(sitting: &Sitting, table: Table) -> usize {
    sitting.editor().document().rows(table).count()
}

#[track_caller]
pub fn assert_ends(sitting: &Sitting, table: Table, end: &str) {
    assert!(text(sitting, table).ends_with(end), "{}", text(sitting, table));
}

/// With the left button, in pixels of the picture.
pub fn drag(sitting: &mut Sitting, from: (f64, f64), to: (f64, f64)) {
    let point = |sitting: &Sitting, (x, y)| sitting.editor().point(DVec2::new(x, y));
    let from = point(sitting, from);
    sitting.point_at(from).give(Input { pointer: from, click: true, holding: true, ..Input::default() });
    let to = point(sitting, to);
    for part in [0.3, 0.7, 1.0] {
        let pointer = from + (to - from) * part;
        sitting.give(Input { pointer, holding: true, ..Input::default() });
    }
    sitting.point_at(to);
}

/// Whether the button of a tool is picked out.
pub fn is_picked(sitting: &Sitting, tool: &str) -> bool {
    let at = sitting.area(tool);
    let shapes = sitting.app.canvas().shapes();
    shapes.iter().any(|shape| match shape {
        Shape::Edge { outline: Contour::Rounded(area, _), colour, .. } => *area == at && *colour == theme::accent(),
        _ => false,
    })
}

fn tool(sitting: &mut Sitting, kind: Kind) {
    sitting.click(kind.name());
    assert!(is_picked(sitting, kind.name()) && !is_picked(sitting, "Select"));
}

pub fn draw(sitting: &mut Sitting, kind: Kind, from: (f64, f64), to: (f64, f64)) -> RowId {
    tool(sitting, kind);
    drag(sitting, from, to);
    assert!(is_picked(sitting, kind.name()), "a tool stays");
    sitting.press(Key::Escape);
    assert!(is_picked(sitting, "Select"));
    let [row] = sitting.editor().selection()[..] else { panic!("{:?}", sitting.editor().selection()) };
    row
}

pub fn control(sitting: &mut Sitting, key: Key) {
    let held = [Key::Control, key].into_iter().collect();
    sitting.give(Input { pressed: [key].into_iter().collect(), held, ..Input::default() }).rest();
}

pub fn write_into(sitting: &mut Sitting, column: &str, text: &str) {
    sitting.click(column).press(Key::End);
    (0..20).for_each(|_| _ = sitting.press(Key::Backspace));
    sitting.write(text).press(Key::Enter);
}

#[test]
fn an_authors_round_trip_by_mouse() {
    let mut sitting = open();
    // The pad that is there goes: one ship can be at one of them only.
    drag(&mut sitting, (20.0, 20.0), (20.0, 20.0));
    sitting.press(Key::Delete);
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    draw(&mut sitting, Kind::Mover, (500.0, 500.0), (620.0, 520.0));
    let switch = draw(&mut sitting, Kind::Switch, (300.0, 500.0), (360.0, 560.0));
    // Its wire, pulled from the handle above it onto the lift.
    let above = sitting.editor().point(DVec2::new(330.0, 500.0)) - Vec2::new(0.0, 22.0);
    let origin = sitting.editor().point(DVec2::ZERO);
    let scale = (sitting.editor().point(DVec2::new(100.0, 0.0)).x - origin.x) / 100.0;
    let from = ((above - origin) / scale).as_dvec2();
    drag(&mut sitting, (from.x, from.y), (560.0, 510.0));
    assert_eq!((cell(&sitting, switch, "works"), sitting.editor().document().wires().len()), (Some("lift"), 1));
    draw(&mut sitting, Kind::Pad, (660.0, 550.0), (760.0, 560.0));
    assert_ends(&sitting, Table::World, "0,560,800,40\n");
    assert!(text(&sitting, Table::Movers).contains("500,500,120,20,"), "{}", text(&sitting, Table::Movers));
    sitting.wait(0.3);
    assert_eq!(sitting.warning(), None);

    assert_eq!(sitting.press(Key::F5).at(), "test flight");
    assert_eq!(sitting.game().level().movers.len(), 1);
    assert_eq!(level::load(&file(&sitting, ""), sitting.folder.path()).unwrap().level.movers.len(), 0, "nothing is saved yet");
    assert_eq!(sitting.wait(0.3).press(Key::F5).at(), "editor");
    control(&mut sitting, Key::S);
    assert!(!sitting.editor().is_unsaved());
    let loaded = level::load(&file(&sitting, ""), sitting.folder.path()).unwrap();
    assert_eq!((loaded.level.world.len(), loaded.level.movers.len(), loaded.level.switches.len()), (1, 1, 1));
    assert_eq!(sitting.press_all(&[Key::Escape, Key::Escape, Key::Enter]).at(), "levels to edit");
}

#[test]
fn a_test_flight_is_nobodys_attempt() {
    let mut sitting = open();
    sitting.press(Key::F5).wait(0.2).press(Key::R);
    assert_eq!(sitting.at(), "test flight");
    // Onto a death box: it leads back, and says how it ended.
    sitting.press(Key::Escape);
    draw(&mut sitting, Kind::Deadly, (300.0, 400.0), (500.0, 420.0));
    sitting.press(Key::F5).wait(4.0);
    assert_eq!(sitting.at(), "editor");
    assert!(sitting.shows("Lost after"));
    assert_eq!(sitting.scores_file("attempts.csv"), "");
}

#[test]
fn things_are_selected_moved_sized_doubled_and_deleted() {
    let mut sitting = open();
    let block = draw(&mut sitting, Kind::Solid, (100.0, 100.0), (200.0, 150.0));
    drag(&mut sitting, (150.0, 125.0), (350.0, 225.0));
    assert_ends(&sitting, Table::World, "300,200,100,50\n");
    // By its lower right corner, onto the grid.
    drag(&mut sitting, (400.0, 250.0), (443.0, 291.0));
    assert_ends(&sitting, Table::World, "300,200,140,90\n");
    control(&mut sitting, Key::D);
    assert_eq!(sitting.editor().selection(), [RowId { row: 1, ..block }]);
    sitting.press(Key::Left);
    assert_ends(&sitting, Table::World, "300,200,140,90\n319,220,140,90\n");
    // A frame around both.
    drag(&mut sitting, (250.0, 150.0), (500.0, 400.0));
    assert_eq!(sitting.editor().selection().len(), 3, "and around the ship, which cannot be deleted");
    sitting.press(Key::Delete);
    assert_eq!(rows(&sitting, Table::World), 0);
    (0..6).for_each(|_| control(&mut sitting, Key::Z));
    assert_eq!(sitting.editor().document().bytes(Table::World), None);
    assert!(!sitting.editor().is_unsaved());
    (0..6).for_each(|_| control(&mut sitting, Key::Y));
    assert_eq!(rows(&sitting, Table::World), 0);
    assert_eq!(sitting.editor().document().history(), (6, 0), "drawn, moved, sized, doubled, nudged, deleted");
}

#[test]
fn the_ship_cannot_be_deleted_but_moved() {
    let mut sitting = open();
    drag(&mut sitting, (400.0, 300.0), (200.0, 300.0));
    assert!(text(&sitting, Table::Player).contains("\n200,300,"), "{}", text(&sitting, Table::Player));
    sitting.press(Key::Delete);
    assert_eq!(rows(&sitting, Table::Player), 1);
    assert!(sitting.shows("A level has a ship: it stays."));
}

#[test]
fn every_column_can_be_written_and_what_is_wrong_is_the_loaders_own_word() {
    let mut sitting = open();
    let row = draw(&mut sitting, Kind::Object, (100.0, 500.0), (140.0, 540.0));
    write_into(&mut sitting, "mass", "heavy");
    assert_eq!(cell(&sitting, row, "mass"), Some("heavy"));
    sitting.wait(0.3);
    let message = "objects.csv:2: column \"mass\": found \"heavy\", expected a number such as 12.5";
    assert!(sitting.warning().is_some() && sitting.shows(message));
    // A click on the problem selects the thing; the view and the keyboard stay where they are. Tab leads to its wrong cell, and the next
    // letters take the place of the text there.
    sitting.press(Key::Escape);
    assert!(sitting.editor().selection().is_empty());
    let before = sitting.editor().point(DVec2::ZERO);
    sitting.click(message);
    assert_eq!((sitting.editor().selection(), sitting.focused()), (&[row][..], ""));
    assert_eq!(sitting.editor().point(DVec2::ZERO), before, "it is in view");
    sitting.press(Key::Tab);
    assert_eq!((sitting.focused(), sitting.field().as_str()), ("mass", "heavy"));
    sitting.press(Key::Escape);
    assert_eq!(sitting.focused(), "");
    sitting.click(message);
    assert_eq!((sitting.focused(), sitting.field().as_str()), ("mass", "heavy"), "and so does another click");
    sitting.write("70").press(Key::Enter).wait(0.3);
    assert_eq!((cell(&sitting, row, "mass"), sitting.warning()), (Some("70"), None));
    // A click goes on to the next word of a choice.
    sitting.click("material");
    assert_eq!(cell(&sitting, row, "material"), Some("Steel"));
    // The level's own settings, where nothing is selected.
    sitting.press_all(&[Key::Enter, Key::Escape]);
    write_into(&mut sitting, "title", "A, B");
    assert_ends(&sitting, Table::Constants, "\ntitle,\"A, B\"\n");
    control(&mut sitting, Key::Z);
    assert!(!text(&sitting, Table::Constants).contains("title"));
}

#[test]
fn all_that_the_files_can_hold_can_be_added() {
    let mut sitting = open();
    for (i, kind) in Kind::ADDED.into_iter().enumerate() {
        let x = 20.0 + 50.0 * i as f64;
        let row = draw(&mut sitting, kind, (x, 450.0), (x + 30.0, 480.0));
        assert_eq!(sitting.editor().document().kind(row), Some(kind));
        assert!(sitting.editor().document().place(row).is_some(), "{kind:?}");
        sitting.press(Key::Escape);
    }
    sitting.wait(0.3);
    // The problems are about places, not about cells that cannot be read.
    let cells = sitting.editor().problems().iter().filter(|(_, refused)| *refused);
    let unreadable =
        |text: &String| ["a number such", "whole number", "cell", "decoration", "picture"].iter().any(|word| text.contains(word));
    let unread: Vec<String> = cells.map(|(problem, _)| problem.to_string()).filter(unreadable).collect();
    assert!(unread.is_empty(), "{unread:?}");
}

#[test]
fn the_picture_tool_puts_a_shape_down_and_offers_the_pictures_that_are_there() {
    let mut sitting = open();
    // The head of a PNG and its end: as much as the loader looks at.
    let icon = fs::read(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/flight.png")).unwrap();
    fs::write(file(&sitting, "rock.png"), &icon).unwrap();
    fs::create_dir_all(sitting.folder.path().join("assets/sprites")).unwrap();
    fs::write(sitting.folder.path().join("assets/sprites/tree.png"), &icon).unwrap();
    sitting.wait(0.4);
    let row = draw(&mut sitting, Kind::Picture, (100.0, 100.0), (160.0, 140.0));
    assert_eq!(cell(&sitting, row, "image"), Some("box:60x40"));
    let assert_sound = |sitting: &mut Sitting| {
        let problems = sitting.wait(0.3).editor().problems();
        assert!(problems.iter().all(|(problem, _)| problem.file != "decoration.csv"), "{problems:?}");
    };
    assert_sound(&mut sitting);
    for picture in ["rock.png", "assets/sprites/tree.png"] {
        sitting.click(picture);
        assert_eq!(cell(&sitting, row, "image"), Some(picture));
        assert!(sitting.editor().document().place(row).unwrap().size.x > 100.0, "as large as the picture");
    }
    assert_sound(&mut sitting);
    control(&mut sitting, Key::Z);
    assert_eq!(cell(&sitting, row, "image"), Some("rock.png"));
    assert!(!sitting.labels().contains(&"background.png"));
}

#[test]
fn a_ship_and_a_size_are_enough_to_fly() {
    let mut sitting = open();
    // No pad any more, a picture that is not there, a number that is none, a switch of nothing.
    drag(&mut sitting, (20.0, 20.0), (20.0, 20.0));
    sitting.press(Key::Delete);
    draw(&mut sitting, Kind::Switch, (500.0, 100.0), (560.0, 160.0));
    draw(&mut sitting, Kind::Picture, (100.0, 100.0), (160.0, 140.0));
    write_into(&mut sitting, "image", "nowhere.png");
    draw(&mut sitting, Kind::Object, (100.0, 500.0), (140.0, 540.0));
    write_into(&mut sitting, "mass", "heavy");
    // And an object in the middle of a block.
    draw(&mut sitting, Kind::Solid, (600.0, 500.0), (700.0, 600.0));
    draw(&mut sitting, Kind::Object, (630.0, 530.0), (670.0, 570.0));
    sitting.press(Key::F5);
    assert_eq!(sitting.at(), "test flight");
    assert!(sitting.shows("Flown as far as it goes. What is left:") && sitting.shows("nowhere.png"));
    assert!(sitting.texts().iter().filter(|(line, _)| line.contains(".csv")).count() >= 5, "{:?}", sitting.texts());
    let level = sitting.game().level().clone();
    assert_eq!((level.objectives.len(), level.objects.len(), level.decoration.len(), level.switches.len()), (0, 0, 0, 1));
    sitting.wait(1.0);
    assert!(sitting.at() == "test flight", "nothing is completed where nothing is asked for");
    assert_eq!(sitting.press(Key::F5).at(), "editor");
    // Without a ship there is nothing to fly.
    drag(&mut sitting, (400.0, 300.0), (400.0, 300.0));
    write_into(&mut sitting, "mass", "light");
    assert_eq!(sitting.press(Key::F5).at(), "editor");
    assert!(sitting.shows("It cannot be flown until this is mended: player.csv:2"));
}

#[test]
fn words_have_a_colour_of_their_own() {
    let mut sitting = open();
    let row = draw(&mut sitting, Kind::Text, (100.0, 450.0), (200.0, 480.0));
    for (column, text) in [("text", "Dark"), ("r", "20"), ("g", "30")] {
        write_into(&mut sitting, column, text);
    }
    sitting.wait(0.3);
    let problem = sitting.editor().problems().iter().find(|(problem, _)| problem.file == "texts.csv").unwrap().0.to_string();
    assert!(problem.contains("\"b\""), "{problem}");
    write_into(&mut sitting, "b", "40");
    assert_eq!(sitting.editor().document().number(row, "b"), Some(40.0));
    sitting.press(Key::F5);
    assert_eq!(sitting.game().level().texts[0].colour, Some([20, 30, 40]));
}

#[test]
fn fields_share_a_clipboard_and_tab_selects_what_is_there() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Door, (100.0, 400.0), (120.0, 500.0));
    sitting.click("name").write("hatch");
    [Key::A, Key::C].into_iter().for_each(|key| control(&mut sitting, key));
    let switch = draw(&mut sitting, Kind::Switch, (300.0, 500.0), (360.0, 560.0));
    sitting.click("works");
    control(&mut sitting, Key::V);
    assert_eq!(cell(&sitting, switch, "works"), Some("hatch"));
    assert_eq!(sitting.editor().document().things().count(), 4, "the ship, the pad, the door, the switch");
    sitting.press(Key::Tab);
    assert_eq!(sitting.focused(), "weight");
    sitting.write("900").press(Key::Tab);
    let shift = [Key::Shift, Key::Tab].into_iter().collect();
    sitting.give(Input { pressed: [Key::Tab].into_iter().collect(), held: shift, ..Input::default() }).rest();
    sitting.write("45").press(Key::Enter);
    assert_eq!(cell(&sitting, switch, "weight"), Some("45"));
}

#[test]
fn a_door_that_is_renamed_keeps_its_switch() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Door, (100.0, 400.0), (120.0, 500.0));
    let switch = draw(&mut sitting, Kind::Switch, (300.0, 500.0), (360.0, 560.0));
    let wired = |sitting: &Sitting, to: &str| {
        assert_eq!((cell(sitting, switch, "works"), sitting.editor().document().wires().len()), (Some(to), 1));
    };
    wired(&sitting, "gate");
    drag(&mut sitting, (110.0, 450.0), (110.0, 450.0));
    sitting.click("name");
    for letter in ["h", "a", "t", "c", "h"] {
        sitting.write(letter);
    }
    sitting.press(Key::Enter);
    wired(&sitting, "hatch");
    control(&mut sitting, Key::Z);
    wired(&sitting, "gate");
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
    // Esc: the list, and nothing was made.
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
    sitting.press_all(&[Key::Escape, Key::Escape, Key::Enter]).rest();
    sitting.choose("2-copy").rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2-copy"));
    sitting.press_all(&[Key::Escape, Key::Enter]).choose("2").rest();
    assert_eq!(sitting.field(), "2-copy-2");
    sitting.press(Key::Escape);
    sitting.choose("Rename").choose("2").write("x").press(Key::Enter);
    assert!(sitting.shows("comes with the game"));
    // A developer edits the original.
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
    sitting.app.begin(
        &sitting.folder.path().join("levels/2"),
        Destination::Edit { name: "2".to_owned(), original: false },
        &mut (),
    );
    assert_eq!(sitting.rest().field(), "2-copy");
    assert_eq!(sitting.press(Key::Enter).rest().editor().name(), "2-copy");
    // One of the author's own, from the list.
    sitting.press_all(&[Key::Escape, Key::Enter]).choose("Copy").choose("2-copy").press(Key::Enter).rest();
    assert_eq!(sitting.editor().name(), "2-copy-copy");
}

#[test]
fn editing_that_begins_in_a_pause_ends_in_it() {
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(1.0).press(Key::Escape);
    let ticks = sitting.ticks();
    let edit = "Edit Level";
    sitting.click(edit).rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2"));
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    sitting.press(Key::F5).wait(0.5);
    assert_eq!(sitting.at(), "test flight");
    sitting.press(Key::F5);
    control(&mut sitting, Key::S);
    sitting.press_all(&[Key::Escape, Key::Escape, Key::Enter]);
    assert_eq!((sitting.at(), sitting.ticks()), ("pause", ticks));
    // It goes on in the level as it was saved.
    sitting.wait(0.5).press(Key::Escape).wait(0.2);
    assert_eq!((sitting.at(), sitting.game().level().world.len()), ("flight", 1));
    // An experiment's copy, too, is made without leaving it.
    let shipped = |root: &std::path::Path| fs::write(root.join("levels/shipped.csv"), "folder\n2\n").unwrap();
    let mut sitting = Sitting::with(shipped);
    sitting.fly("2").wait(1.0).press(Key::Escape).click(edit).rest();
    assert_eq!(sitting.at(), "levels to edit");
    assert_eq!(sitting.press(Key::Escape).at(), "pause");
    sitting.click(edit).press(Key::Enter).rest();
    assert_eq!(sitting.editor().name(), "2-copy");
    assert_eq!(sitting.press_all(&[Key::Escape, Key::Enter]).at(), "pause");
    assert_eq!(sitting.game().level().name, "2");
}

#[test]
fn what_there_is_to_say_stays_until_it_is_read() {
    let mut sitting = open();
    sitting.press(Key::Delete);
    drag(&mut sitting, (400.0, 300.0), (400.0, 300.0));
    sitting.press(Key::Delete);
    let words = "A level has a ship: it stays.";
    assert!(sitting.shows(words));
    // It stays under the pointer.
    let below = Vec2::new(sitting.frame.size.x / 2.0, sitting.frame.size.y - 6.0);
    for _ in 0..1200 {
        sitting.point_at(below);
    }
    assert!(sitting.shows(words));
    sitting.point_at(Vec2::ZERO).wait(10.0);
    assert!(!sitting.shows(words));
}

#[test]
fn leaving_asks_and_a_crash_loses_nothing() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    sitting.press_all(&[Key::Escape, Key::Escape]);
    assert!(sitting.shows("There are edits that are not saved."));
    assert_eq!(sitting.press(Key::Escape).at(), "editor", "Esc stays");
    assert!(file(&sitting, ".autosave").exists());
    // The program ends here.
    sitting.reopen();
    sitting.choose("Editor").choose("2").rest();
    assert_eq!(rows(&sitting, Table::World), 0);
    sitting.click("Have them back").rest();
    assert_eq!(rows(&sitting, Table::World), 1, "had back");
    // Thrown away.
    sitting.press(Key::Escape).click("Throw away");
    assert_eq!(sitting.at(), "levels to edit");
    assert!(!file(&sitting, ".autosave").exists() && !file(&sitting, "world.csv").exists());
}

#[test]
fn what_another_program_writes_is_taken_over_or_asked_about() {
    let mut sitting = open();
    fs::write(file(&sitting, "world.csv"), "0,580,800,20\n").unwrap();
    sitting.wait(0.4);
    assert_eq!(rows(&sitting, Table::World), 1);
    draw(&mut sitting, Kind::Solid, (100.0, 100.0), (200.0, 150.0));
    fs::write(file(&sitting, "world.csv"), "0,500,800,20\n").unwrap();
    sitting.wait(0.4);
    assert_eq!(sitting.labels(), ["Decide later", "Theirs", "Mine"]);
    sitting.press(Key::Enter).rest();
    assert!(!sitting.labels().contains(&"Mine") && sitting.editor().is_unsaved(), "Enter harms nothing");
    control(&mut sitting, Key::S);
    sitting.rest();
    assert!(sitting.shows("Another program has changed world.csv."));
    assert_eq!(fs::read_to_string(file(&sitting, "world.csv")).unwrap(), "0,500,800,20\n", "nothing is written over");
    sitting.click("Theirs").rest();
    assert_eq!(text(&sitting, Table::World), "0,500,800,20\n");
    assert!(!sitting.editor().is_unsaved());
    control(&mut sitting, Key::Z);
    assert!(text(&sitting, Table::World).contains("100,100,100,50"), "theirs can be undone, too");
    // The other answer: their file is kept beside it, and Undo brings it back.
    fs::write(file(&sitting, "world.csv"), "0,400,800,20\n").unwrap();
    sitting.wait(0.4);
    sitting.click("Mine").rest();
    assert!(fs::read_to_string(file(&sitting, "world.csv")).unwrap().contains("100,100,100,50"));
    assert_eq!(fs::read_to_string(file(&sitting, "world.csv.theirs-1")).unwrap(), "0,400,800,20\n");
    assert!(sitting.shows("world.csv.theirs-1"));
    control(&mut sitting, Key::Z);
    assert_eq!(text(&sitting, Table::World), "0,400,800,20\n");
}

#[test]
fn a_click_changes_no_size_and_the_middle_of_a_small_thing_moves_it() {
    let mut sitting = open();
    // A switch as flat as a plate: drawn, clicked twice at every point of it, and at its handles.
    let switch = draw(&mut sitting, Kind::Switch, (300.0, 500.0), (360.0, 510.0));
    let before = text(&sitting, Table::Switches);
    for x in [300.0, 301.0, 315.0, 330.0, 345.0, 359.0, 360.0] {
        for y in [500.0, 502.0, 505.0, 508.0, 510.0] {
            for _ in 0..2 {
                drag(&mut sitting, (x, y), (x, y));
            }
            assert_eq!(sitting.editor().selection(), [switch]);
        }
    }
    let place = sitting.editor().document().place(switch).unwrap();
    for side in [DVec2::Y, DVec2::NEG_Y, DVec2::ONE, DVec2::NEG_ONE] {
        assert!(!place.contains(handle(&sitting, side)), "the handles of a flat thing stand beside it");
    }
    for (_, point) in sitting.editor().handles() {
        drag(&mut sitting, (point.x, point.y), (point.x, point.y));
        sitting.click_at(sitting.editor().point(DVec2::new(330.0, 505.0)));
    }
    assert_eq!(text(&sitting, Table::Switches), before);
    // A box of 40 × 40 pixels, moved from wherever in its inner half it is grabbed.
    let small = draw(&mut sitting, Kind::Object, (100.0, 100.0), (140.0, 140.0));
    for (x, y) in [(0.0, 0.0), (-10.0, 0.0), (10.0, 10.0), (0.0, -10.0)] {
        let at = sitting.editor().document().place(small).unwrap().centre();
        drag(&mut sitting, (at.x + x, at.y + y), (at.x + x + 50.0, at.y + y + 30.0));
        let place = sitting.editor().document().place(small).unwrap();
        assert_eq!((place.size, place.centre()), (DVec2::splat(40.0), at + DVec2::new(50.0, 30.0)), "grabbed at {x}, {y}");
    }
    // Its right edge: it goes as far as the pointer does, not to the pointer.
    let (place, right) = (sitting.editor().document().place(small).unwrap(), handle(&sitting, DVec2::X));
    drag(&mut sitting, (right.x + 3.0, right.y), (right.x + 23.0, right.y));
    assert_eq!(sitting.editor().document().place(small).unwrap(), Place { size: DVec2::new(60.0, 40.0), ..place });
}

/// The place of the handle that moves these edges.
fn handle(sitting: &Sitting, side: DVec2) -> DVec2 {
    let place = sitting.editor().document().place(sitting.editor().selection()[0]).unwrap();
    let signs = |value: DVec2| DVec2::new((value.x * 1e3).round().clamp(-1.0, 1.0), (value.y * 1e3).round().clamp(-1.0, 1.0));
    let along = |point: &DVec2| signs(*point - place.centre()).distance(side);
    sitting.editor().handles().into_iter().map(|(_, point)| point).min_by(|a, b| along(a).total_cmp(&along(b))).unwrap()
}

#[test]
fn a_click_puts_things_down_by_the_point_that_their_cells_name() {
    let mut sitting = open();
    tool(&mut sitting, Kind::Object);
    drag(&mut sitting, (203.0, 198.0), (203.0, 198.0));
    assert_ends(&sitting, Table::Objects, "\n200,200,box:40x40,50,1.05,FALSE,0.2\n");
    tool(&mut sitting, Kind::Solid);
    drag(&mut sitting, (203.0, 298.0), (203.0, 298.0));
    assert_ends(&sitting, Table::World, "\n200,300,160,40\n");
    sitting.press(Key::Escape);
    // Beside the ship, whose edge is at 425.5, and with the grid off: whole pixels.
    drag(&mut sitting, (280.0, 320.0), (508.0, 320.0));
    assert_eq!(sitting.editor().document().number(RowId { table: Table::World, row: 0 }, "x"), Some(426.0));
    sitting.press(Key::G);
    drag(&mut sitting, (200.0, 200.0), (233.3, 251.7));
    assert_ends(&sitting, Table::Objects, "\n233,252,box:40x40,50,1.05,FALSE,0.2\n");
}

#[test]
fn the_wheel_zooms_the_right_button_pans_and_a_key_shows_all() {
    let mut sitting = open();
    let fixed = sitting.editor().point(DVec2::new(400.0, 300.0));
    sitting.give(Input { pointer: fixed, wheel: 1.0, ..Input::default() });
    assert!(sitting.editor().point(DVec2::new(400.0, 300.0)).distance(fixed) < 0.01);
    let spread = |sitting: &Sitting| sitting.editor().point(DVec2::new(800.0, 0.0)).x - sitting.editor().point(DVec2::ZERO).x;
    let large = spread(&sitting);
    let by = Vec2::new(50.0, -30.0);
    sitting.give(Input { pointer: fixed, right_click: true, dragging: true, ..Input::default() });
    sitting.give(Input { pointer: fixed + by, dragging: true, ..Input::default() }).rest();
    assert!(sitting.editor().point(DVec2::new(400.0, 300.0)).distance(fixed + by) < 0.01);
    sitting.press(Key::F);
    assert!(spread(&sitting) < large);
}

#[test]
fn the_world_is_picked_from_five_in_small_beside_its_word() {
    let mut sitting = Sitting::new();
    sitting.choose("Editor").choose("2").rest();
    sitting.click("water").rest();
    assert!(sitting.editor().document().setting("world") == Some("water"), "one click writes it");
    sitting.click("orbit").click("Save").rest();
    let written = fs::read_to_string(sitting.folder.path().join("levels/2/constants.csv")).unwrap();
    assert!(written.lines().any(|line| line == "world,orbit"), "{written}");
}
