//! The editor, without a window: each button and field is pressed by its label.

use crate::sitting::Sitting;
use resultant::draw::layout::Vec2;
use resultant::level::document::{Kind, Place, RowId, Table};
use resultant::physics::DVec2;
use resultant::screens::{Input, Key};
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

fn tool(sitting: &mut Sitting, kind: Kind) {
    sitting.click(kind.name());
    assert!(sitting.is_chosen(kind.name()) && !sitting.is_chosen("Select"));
}

pub fn draw(sitting: &mut Sitting, kind: Kind, from: (f64, f64), to: (f64, f64)) -> RowId {
    tool(sitting, kind);
    drag(sitting, from, to);
    assert!(sitting.is_chosen(kind.name()), "a tool stays");
    sitting.press(Key::Escape);
    assert!(sitting.is_chosen("Select"));
    let [row] = sitting.editor().selection()[..] else { panic!("{:?}", sitting.editor().selection()) };
    row
}

pub fn control(sitting: &mut Sitting, key: Key) {
    sitting.press_keys(&[key], &[Key::Control, key]).rest();
}

pub fn write_into(sitting: &mut Sitting, column: &str, text: &str) {
    sitting.click(column).press(Key::End);
    (0..20).for_each(|_| _ = sitting.press(Key::Backspace));
    sitting.write(text).press(Key::Enter);
}

#[test]
fn things_are_selected_moved_sized_doubled_and_deleted() {
    let mut sitting = open();
    let block = draw(&mut sitting, Kind::Solid, (100.0, 100.0), (200.0, 150.0));
    drag(&mut sitting, (150.0, 125.0), (350.0, 225.0));
    assert_ends(&sitting, Table::World, "300,200,100,50\n");
    drag(&mut sitting, (400.0, 250.0), (443.0, 291.0));
    assert_ends(&sitting, Table::World, "300,200,140,90\n");
    control(&mut sitting, Key::D);
    assert_eq!(sitting.editor().selection(), [RowId { row: 1, ..block }]);
    sitting.press(Key::Left);
    assert_ends(&sitting, Table::World, "300,200,140,90\n319,220,140,90\n");
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
    sitting.click("material");
    assert_eq!(cell(&sitting, row, "material"), Some("Steel"));
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
    let words = ["a number such", "whole number", "cell", "decoration", "picture"];
    let unreadable = |text: &String| words.iter().any(|word| text.contains(word));
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
    sitting.write("900").press(Key::Tab).press_keys(&[Key::Tab], &[Key::Shift, Key::Tab]).rest().write("45").press(Key::Enter);
    assert_eq!(cell(&sitting, switch, "weight"), Some("45"));
}

#[test]
fn what_there_is_to_say_stays_until_it_is_read() {
    let mut sitting = open();
    sitting.press(Key::Delete);
    drag(&mut sitting, (400.0, 300.0), (200.0, 300.0));
    assert!(text(&sitting, Table::Player).contains("\n200,300,"), "{}", text(&sitting, Table::Player));
    sitting.press(Key::Delete);
    assert_eq!(rows(&sitting, Table::Player), 1);
    let words = "A level has a ship: it stays.";
    assert!(sitting.shows(words));
    let below = Vec2::new(sitting.frame.size.x / 2.0, sitting.frame.size.y - 6.0);
    (0..1200).for_each(|_| _ = sitting.point_at(below));
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
    sitting.reopen().choose("Editor").choose("2").rest();
    assert_eq!(rows(&sitting, Table::World), 0);
    sitting.click("Have them back").rest();
    assert_eq!(rows(&sitting, Table::World), 1, "had back");
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
    fs::write(file(&sitting, "world.csv"), "0,400,800,20\n").unwrap();
    sitting.wait(0.4).click("Mine").rest();
    assert!(sitting.shows("world.csv.theirs-1"));
}

#[test]
fn a_click_changes_no_size_and_the_middle_of_a_small_thing_moves_it() {
    let mut sitting = open();
    // A switch as flat as a plate: drawn, clicked twice at every point of it, and at its handles.
    let switch = draw(&mut sitting, Kind::Switch, (300.0, 500.0), (360.0, 510.0));
    let before = text(&sitting, Table::Switches);
    for x in [300.0, 301.0, 315.0, 330.0, 345.0, 359.0, 360.0] {
        for y in [500.0, 502.0, 505.0, 508.0, 510.0] {
            (0..2).for_each(|_| drag(&mut sitting, (x, y), (x, y)));
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
    sitting.choose("Editor").choose("2").rest().click("water").rest();
    assert!(sitting.editor().document().setting("world") == Some("water"), "one click writes it");
    sitting.click("orbit").click("Save").rest();
    let written = fs::read_to_string(sitting.folder.path().join("levels/2/constants.csv")).unwrap();
    assert!(written.lines().any(|line| line == "world,orbit"), "{written}");
}
