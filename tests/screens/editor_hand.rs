//! The author's hand: tools by key, the clipboard, doubling, several things at once, layers, and what is seen of a block's nature.

use crate::editor::{assert_ends, cell, control, drag, draw, open, rows, text, write_into};
use crate::sitting::{Sitting, keys};
use resultant::draw::layout::Vec2;
use resultant::level::document::{Kind, LinkForm, RowId, Table};
use resultant::physics::DVec2;
use resultant::screens::{Input, Key};

fn point(sitting: &Sitting, (x, y): (f64, f64)) -> Vec2 {
    sitting.editor().point(DVec2::new(x, y))
}

fn control_at(sitting: &mut Sitting, key: Key, at: (f64, f64)) {
    let pointer = point(sitting, at);
    let held = [Key::Control, key].into_iter().collect();
    sitting.point_at(pointer).give(Input { pointer, pressed: [key].into_iter().collect(), held, ..Input::default() });
}

fn click_with(sitting: &mut Sitting, held: &[Key], at: (f64, f64)) {
    let (pointer, held) = (point(sitting, at), keys(held));
    sitting.point_at(pointer).give(Input { pointer, click: true, holding: true, held, ..Input::default() }).point_at(pointer);
}

fn control_shift(sitting: &mut Sitting, key: Key) {
    sitting.press_keys(&[key], &[Key::Control, Key::Shift, key]).rest();
}

fn block(row: usize) -> RowId {
    RowId { table: Table::World, row }
}

fn with_blocks() -> Sitting {
    let mut sitting = open();
    for (from, to) in [((100.0, 100.0), (200.0, 150.0)), ((300.0, 200.0), (340.0, 220.0)), ((600.0, 400.0), (700.0, 500.0))] {
        draw(&mut sitting, Kind::Solid, from, to);
    }
    sitting.press(Key::Escape);
    sitting
}

fn select_all_blocks(sitting: &mut Sitting) {
    for (at, held) in [((110.0, 110.0), &[][..]), ((310.0, 210.0), &[Key::Shift]), ((610.0, 410.0), &[Key::Shift])] {
        click_with(sitting, held, at);
    }
    assert_eq!(sitting.editor().selection().len(), 3);
}

fn places(sitting: &Sitting) -> Vec<[f64; 2]> {
    (0..rows(sitting, Table::World)).map(|row| sitting.editor().document().place(block(row)).unwrap().min.to_array()).collect()
}

#[test]
fn a_tool_stays_until_esc_or_another_one_and_its_tooltip_names_its_key() {
    let mut sitting = open();
    sitting.press(Key::B);
    assert!(sitting.is_chosen("Block"));
    for y in [100.0, 200.0, 300.0] {
        drag(&mut sitting, (100.0, y), (200.0, y + 20.0));
    }
    assert_eq!(rows(&sitting, Table::World), 3);
    sitting.press(Key::R);
    assert!(sitting.is_chosen("Rope"));
    sitting.press(Key::Escape);
    assert!(sitting.is_chosen("Select") && !sitting.editor().selection().is_empty(), "Esc puts the tool down first");
    let at = sitting.area("Coil spring").centre();
    sitting.point_at(at);
    assert!(sitting.shows("Coil spring · key N."), "{:?}", sitting.texts());
}

#[test]
fn things_are_copied_cut_and_pasted_where_the_pointer_is_also_into_another_level() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Object, (200.0, 400.0), (240.0, 440.0));
    draw(&mut sitting, Kind::Object, (300.0, 400.0), (340.0, 440.0));
    sitting.click(LinkForm::Spring.name());
    drag(&mut sitting, (220.0, 420.0), (320.0, 420.0));
    sitting.press_all(&[Key::Escape, Key::Escape]);
    drag(&mut sitting, (150.0, 380.0), (380.0, 460.0));
    assert_eq!(sitting.editor().selection().len(), 3);
    control(&mut sitting, Key::C);
    assert!(sitting.shows("3 copied"));
    control_at(&mut sitting, Key::V, (270.0, 220.0));
    let objects = text(&sitting, Table::Objects);
    assert!(objects.contains("\n220,220,") && objects.contains("\n320,220,"), "{objects}");
    let second = RowId { table: Table::Links, row: 1 };
    assert_eq!([cell(&sitting, second, "a"), cell(&sitting, second, "b")], [Some("box3"), Some("box4")], "the copies are joined");
    control(&mut sitting, Key::Z);
    assert_eq!((rows(&sitting, Table::Objects), rows(&sitting, Table::Links)), (2, 1), "one act");
    drag(&mut sitting, (150.0, 380.0), (380.0, 460.0));
    control(&mut sitting, Key::X);
    assert_eq!((rows(&sitting, Table::Objects), rows(&sitting, Table::Links)), (0, 0));
    control(&mut sitting, Key::S);
    sitting.click("Back").rest().choose("10").rest();
    assert_eq!(sitting.editor().name(), "10");
    control_at(&mut sitting, Key::V, (270.0, 120.0));
    assert_eq!((rows(&sitting, Table::Objects), rows(&sitting, Table::Links)), (2, 1));
    sitting.press(Key::Escape);
    control(&mut sitting, Key::C);
    assert!(sitting.shows("Nothing is selected that can be copied."));
}

#[test]
fn a_drag_with_alt_moves_a_copy() {
    let mut sitting = with_blocks();
    let (from, to) = (point(&sitting, (110.0, 110.0)), point(&sitting, (110.0, 310.0)));
    let held = keys(&[Key::Alt]);
    sitting.point_at(from).give(Input { pointer: from, click: true, holding: true, held, ..Input::default() });
    sitting.give(Input { pointer: to, holding: true, held, ..Input::default() }).point_at(to);
    assert_eq!(places(&sitting), [[100.0, 100.0], [300.0, 200.0], [600.0, 400.0], [100.0, 300.0]]);
    control(&mut sitting, Key::Z);
    assert_eq!(rows(&sitting, Table::World), 3, "one act");
    click_with(&mut sitting, &[Key::Alt], (110.0, 110.0));
    assert_eq!(rows(&sitting, Table::World), 3);
}

#[test]
fn several_are_aligned_spread_grouped_and_locked() {
    let mut sitting = with_blocks();
    select_all_blocks(&mut sitting);
    sitting.click("Align left");
    assert_eq!(places(&sitting), [[100.0, 100.0], [100.0, 200.0], [100.0, 400.0]]);
    control(&mut sitting, Key::Z);
    sitting.click("Align bottom");
    assert_eq!(places(&sitting), [[100.0, 450.0], [300.0, 480.0], [600.0, 400.0]]);
    control(&mut sitting, Key::Z);
    // Equal gaps: 600 pixels with 240 of blocks in them.
    sitting.click("Spread across");
    assert_eq!(places(&sitting), [[100.0, 100.0], [380.0, 200.0], [600.0, 400.0]]);
    control(&mut sitting, Key::Z);
    click_with(&mut sitting, &[Key::Shift], (110.0, 110.0));
    assert_eq!(sitting.editor().selection(), [block(1), block(2)]);
    control(&mut sitting, Key::G);
    sitting.press(Key::Escape);
    drag(&mut sitting, (110.0, 110.0), (110.0, 110.0));
    sitting.press(Key::Delete);
    drag(&mut sitting, (310.0, 210.0), (310.0, 210.0));
    assert_eq!(sitting.editor().selection().len(), 2);
    control_shift(&mut sitting, Key::G);
    sitting.press(Key::Escape);
    drag(&mut sitting, (310.0, 210.0), (310.0, 210.0));
    assert_eq!(sitting.editor().selection(), [block(0)]);
    control(&mut sitting, Key::L);
    drag(&mut sitting, (310.0, 210.0), (350.0, 250.0));
    assert!(sitting.editor().selection().is_empty() && places(&sitting)[0] == [300.0, 200.0]);
    control_shift(&mut sitting, Key::L);
    drag(&mut sitting, (310.0, 210.0), (350.0, 250.0));
    assert!(places(&sitting)[0] > [320.0, 220.0]);
}

#[test]
fn layers_hide_words_and_zones_from_sight_and_hand() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Fluid, (100.0, 100.0), (300.0, 200.0));
    draw(&mut sitting, Kind::Text, (500.0, 100.0), (600.0, 140.0));
    write_into(&mut sitting, "text", "Mind the gap");
    sitting.press_all(&[Key::Enter, Key::Escape]);
    assert!(sitting.shows("Mind the gap"));
    let shapes = |sitting: &Sitting| sitting.app.canvas().shapes().len();
    let before = shapes(&sitting);
    sitting.press_all(&[Key::F9, Key::F10]);
    assert!(!sitting.shows("Mind the gap") && shapes(&sitting) < before);
    drag(&mut sitting, (200.0, 150.0), (200.0, 150.0));
    assert!(sitting.editor().selection().is_empty());
    sitting.click("Hide zones");
    drag(&mut sitting, (200.0, 150.0), (200.0, 150.0));
    assert_eq!(sitting.editor().selection().len(), 1);
}

#[test]
fn arrow_keys_in_quick_succession_are_one_act() {
    let mut sitting = with_blocks();
    drag(&mut sitting, (110.0, 110.0), (110.0, 110.0));
    let acts = sitting.editor().document().history().0;
    (0..7).for_each(|_| _ = sitting.press(Key::Right).wait(0.2));
    sitting.press(Key::Down);
    assert_eq!((places(&sitting)[0], sitting.editor().document().history().0), ([107.0, 101.0], acts + 1));
    sitting.wait(2.0).press(Key::Right);
    assert_eq!(sitting.editor().document().history().0, acts + 2, "later is another one");
    control(&mut sitting, Key::Z);
    control(&mut sitting, Key::Z);
    assert_eq!(places(&sitting)[0], [100.0, 100.0]);
}

#[test]
fn esc_asks_before_it_leaves_also_where_all_is_saved() {
    let mut sitting = open();
    sitting.press(Key::Escape);
    assert_eq!((sitting.at(), sitting.labels()), ("editor", vec!["Leave", "Stay here"]));
    sitting.press(Key::Escape).rest();
    assert!(sitting.at() == "editor" && sitting.labels().contains(&"Block"));
    assert_eq!(sitting.press(Key::Escape).press(Key::Enter).at(), "levels to edit");
}

#[test]
fn a_blocks_nature_is_seen() {
    let mut sitting = open();
    let plain = draw(&mut sitting, Kind::Solid, (100.0, 100.0), (260.0, 140.0));
    let lines = |sitting: &Sitting| sitting.app.canvas().shapes().len();
    sitting.press(Key::Escape);
    for (column, value) in [("belt", "2"), ("breaks", "5"), ("one_way", "top"), ("material", "Trampoline")] {
        sitting.wait(0.3);
        let before = lines(&sitting);
        drag(&mut sitting, (180.0, 120.0), (180.0, 120.0));
        match column {
            "one_way" | "material" => {
                while cell(&sitting, plain, column) != Some(value) {
                    sitting.click(column);
                }
                sitting.press(Key::Escape);
            }
            _ => write_into(&mut sitting, column, value),
        }
        sitting.press(Key::Escape).wait(0.3);
        assert!(lines(&sitting) > before, "{column}");
    }
    let key = draw(&mut sitting, Kind::Key, (300.0, 300.0), (340.0, 340.0));
    sitting.click("#50 96 F0".replace(' ', "").as_str());
    assert_eq!(["r", "g", "b"].map(|column| cell(&sitting, key, column)), [Some("80"), Some("150"), Some("240")]);
}

#[test]
fn a_low_pad_keeps_its_height_beside_an_edge() {
    let mut sitting = open();
    draw(&mut sitting, Kind::Solid, (100.0, 500.0), (500.0, 540.0));
    draw(&mut sitting, Kind::Pad, (200.0, 494.0), (320.0, 500.0));
    assert_ends(&sitting, Table::Objectives, "200,494,120,6,1\n");
}
