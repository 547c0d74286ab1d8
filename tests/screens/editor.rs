//! The editor as an author meets it, without a window.

use crate::sitting::Sitting;
use resultant::level;
use resultant::level::document::{Kind, RowId, Table};
use resultant::physics::DVec2;
use resultant::screens::{EditorTool, Input, Key};
use resultant::view::layout::Vec2;
use std::fs;
use std::path::PathBuf;

/// An editor of level 2: a room of 800 × 600 pixels with the ship and a pad in a corner.
fn open() -> Sitting {
    let mut sitting = Sitting::new();
    sitting.choose(1).choose(6).choose(1).rest();
    assert_eq!((sitting.at(), sitting.editor().name()), ("editor", "2"));
    sitting
}

fn file(sitting: &Sitting, name: &str) -> PathBuf {
    sitting.folder.path().join("levels/2").join(name)
}

fn text(sitting: &Sitting, table: Table) -> String {
    String::from_utf8(sitting.editor().document().bytes(table).unwrap_or_default().to_vec()).unwrap()
}

/// With the left button, in pixels of the picture.
fn drag(sitting: &mut Sitting, from: (f64, f64), to: (f64, f64)) {
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
    let index = Kind::ADDED.iter().position(|other| *other == kind).unwrap() + 1;
    let at = sitting.editor().tools().areas()[index].centre();
    sitting.click_at(at);
    assert_eq!(sitting.editor().tool(), EditorTool::Add(kind));
}

fn draw(sitting: &mut Sitting, kind: Kind, from: (f64, f64), to: (f64, f64)) -> RowId {
    tool(sitting, kind);
    drag(sitting, from, to);
    assert_eq!(sitting.editor().tool(), EditorTool::Select);
    let [row] = sitting.editor().selection()[..] else { panic!("{:?}", sitting.editor().selection()) };
    row
}

fn control(sitting: &mut Sitting, key: Key) {
    let held = [Key::Control, key].into_iter().collect();
    sitting.give(Input { pressed: [key].into_iter().collect(), held, ..Input::default() }).rest();
}

fn write_into(sitting: &mut Sitting, column: &str, text: &str) {
    let at = sitting.editor().field(column).unwrap().centre();
    sitting.click_at(at).press(Key::End);
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
    let from = {
        let origin = sitting.editor().point(DVec2::ZERO);
        let scale = (sitting.editor().point(DVec2::new(100.0, 0.0)).x - origin.x) / 100.0;
        ((above - origin) / scale).as_dvec2()
    };
    drag(&mut sitting, (from.x, from.y), (560.0, 510.0));
    assert_eq!(sitting.editor().document().cell(switch, "works"), Some("lift"));
    assert_eq!(sitting.editor().document().wires().len(), 1);
    draw(&mut sitting, Kind::Pad, (660.0, 550.0), (760.0, 560.0));
    assert!(text(&sitting, Table::World).ends_with("0,560,800,40\n"), "{}", text(&sitting, Table::World));
    assert!(text(&sitting, Table::Movers).contains("500,500,120,20,"), "{}", text(&sitting, Table::Movers));
    sitting.wait(0.3);
    assert!(sitting.editor().problems().iter().all(|(_, refused)| !refused), "{:?}", sitting.editor().problems());

    assert_eq!(sitting.press(Key::F5).at(), "test flight");
    assert_eq!(sitting.flight().game().level().movers.len(), 1);
    assert_eq!(level::load(&file(&sitting, ""), sitting.folder.path()).unwrap().level.movers.len(), 0, "nothing is saved yet");
    assert_eq!(sitting.wait(0.3).press(Key::F5).at(), "editor");
    control(&mut sitting, Key::S);
    assert!(!sitting.editor().is_unsaved());
    let loaded = level::load(&file(&sitting, ""), sitting.folder.path()).unwrap();
    assert_eq!((loaded.level.world.len(), loaded.level.movers.len(), loaded.level.switches.len()), (1, 1, 1));
    assert_eq!(sitting.press(Key::Escape).press(Key::Escape).at(), "levels to edit");
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
    assert!(sitting.editor().remark().unwrap().starts_with("Lost after"), "{:?}", sitting.editor().remark());
    assert_eq!(sitting.scores_file("attempts.csv"), "");
}

#[test]
fn things_are_selected_moved_sized_doubled_and_deleted() {
    let mut sitting = open();
    let block = draw(&mut sitting, Kind::Solid, (100.0, 100.0), (200.0, 150.0));
    drag(&mut sitting, (150.0, 125.0), (350.0, 225.0));
    assert!(text(&sitting, Table::World).ends_with("300,200,100,50\n"), "{}", text(&sitting, Table::World));
    // By its lower right corner, onto the grid.
    drag(&mut sitting, (400.0, 250.0), (443.0, 291.0));
    assert!(text(&sitting, Table::World).ends_with("300,200,140,90\n"), "{}", text(&sitting, Table::World));
    control(&mut sitting, Key::D);
    assert_eq!(sitting.editor().selection(), [RowId { row: 1, ..block }]);
    sitting.press(Key::Left);
    assert!(text(&sitting, Table::World).ends_with("300,200,140,90\n319,220,140,90\n"), "{}", text(&sitting, Table::World));
    // A frame around both.
    drag(&mut sitting, (250.0, 150.0), (500.0, 400.0));
    assert_eq!(sitting.editor().selection().len(), 3, "and around the ship, which cannot be deleted");
    sitting.press(Key::Delete);
    assert_eq!(sitting.editor().document().rows(Table::World).count(), 0);
    for _ in 0..6 {
        control(&mut sitting, Key::Z);
    }
    assert_eq!(sitting.editor().document().bytes(Table::World), None);
    assert!(!sitting.editor().is_unsaved());
    for _ in 0..6 {
        control(&mut sitting, Key::Y);
    }
    assert_eq!(sitting.editor().document().rows(Table::World).count(), 0);
    assert_eq!(sitting.editor().document().history(), (6, 0), "drawn, moved, sized, doubled, nudged, deleted");
}

#[test]
fn the_ship_cannot_be_deleted_but_moved() {
    let mut sitting = open();
    drag(&mut sitting, (400.0, 300.0), (200.0, 300.0));
    assert!(
        text(&sitting, Table::Player).contains("\n200.5,300,") || text(&sitting, Table::Player).contains("\n195.5,"),
        "{}",
        text(&sitting, Table::Player)
    );
    sitting.press(Key::Delete);
    assert_eq!(sitting.editor().document().rows(Table::Player).count(), 1);
    assert!(sitting.editor().remark().is_some());
}

#[test]
fn every_column_can_be_written_and_what_is_wrong_is_the_loaders_own_word() {
    let mut sitting = open();
    let row = draw(&mut sitting, Kind::Object, (100.0, 500.0), (140.0, 540.0));
    write_into(&mut sitting, "mass", "heavy");
    assert_eq!(sitting.editor().document().cell(row, "mass"), Some("heavy"));
    sitting.wait(0.3);
    let message = sitting.editor().problems()[0].0.to_string();
    assert_eq!(message, "objects.csv:2: column \"mass\": found \"heavy\", expected a number such as 12.5");
    assert_eq!(sitting.press(Key::F5).at(), "editor", "it cannot be flown");
    // A click on the problem selects the thing and opens its column.
    sitting.press(Key::Escape);
    assert!(sitting.editor().selection().is_empty());
    let line = sitting.editor().problem_line(0).centre();
    sitting.click_at(line);
    assert_eq!(sitting.editor().selection(), [row]);
    (0..5).for_each(|_| _ = sitting.press(Key::Backspace));
    sitting.write("70").press(Key::Enter).wait(0.3);
    assert_eq!(sitting.editor().document().cell(row, "mass"), Some("70"));
    assert!(sitting.editor().problems().iter().all(|(_, refused)| !refused));
    // Words are gone through by clicks.
    let at = sitting.editor().field("material").unwrap().centre();
    sitting.click_at(at);
    assert_eq!(sitting.editor().document().cell(row, "material"), Some("Steel"));
    // The level's own settings, where nothing is selected.
    sitting.press_all(&[Key::Enter, Key::Escape]);
    write_into(&mut sitting, "title", "A, B");
    assert!(text(&sitting, Table::Constants).ends_with("\ntitle,\"A, B\"\n"), "{}", text(&sitting, Table::Constants));
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
    // What is wrong is about what is where, not about cells that cannot be read; but a picture there is none.
    let cells = sitting.editor().problems().iter().filter(|(problem, refused)| *refused && problem.file != "decoration.csv");
    let unread: Vec<String> =
        cells.map(|(problem, _)| problem.to_string()).filter(|text| text.contains("number") || text.contains("cell")).collect();
    assert!(unread.is_empty(), "{unread:?}");
}

#[test]
fn leaving_asks_and_a_crash_loses_nothing() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Solid, (0.0, 560.0), (800.0, 600.0));
    sitting.press_all(&[Key::Escape, Key::Escape]);
    assert_eq!(sitting.editor().asked().unwrap()[0], "There are edits that are not saved.");
    assert_eq!(sitting.press(Key::Escape).at(), "editor", "Esc stays");
    assert!(file(&sitting, ".autosave").exists());
    // The program ends here.
    sitting.reopen();
    sitting.choose(1).choose(6).choose(1).rest();
    assert_eq!(sitting.editor().document().rows(Table::World).count(), 0);
    sitting.click(0).rest();
    assert_eq!(sitting.editor().document().rows(Table::World).count(), 1, "had back");
    // Thrown away.
    sitting.press(Key::Escape).click(1);
    assert_eq!(sitting.at(), "levels to edit");
    assert!(!file(&sitting, ".autosave").exists() && !file(&sitting, "world.csv").exists());
}

#[test]
fn what_another_program_writes_is_taken_over_or_asked_about() {
    let mut sitting = open();
    fs::write(file(&sitting, "world.csv"), "0,580,800,20\n").unwrap();
    sitting.wait(0.4);
    assert_eq!(sitting.editor().document().rows(Table::World).count(), 1);
    draw(&mut sitting, Kind::Solid, (100.0, 100.0), (200.0, 150.0));
    fs::write(file(&sitting, "world.csv"), "0,500,800,20\n").unwrap();
    sitting.wait(0.4);
    assert_eq!(sitting.buttons().areas().len(), 2, "Mine, Theirs");
    sitting.click(1).rest();
    assert_eq!(text(&sitting, Table::World), "0,500,800,20\n");
    assert!(!sitting.editor().is_unsaved());
    control(&mut sitting, Key::Z);
    assert!(text(&sitting, Table::World).contains("100,100,100,50"), "theirs can be undone, too");
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
