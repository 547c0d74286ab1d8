//! Links in the editor, by mouse: pulled from a body, led elsewhere, moved, and their kind in a field.

use crate::editor::{cell, control, drag, draw, open, rows, text};
use crate::sitting::Sitting;
use resultant::level::document::{Kind, LinkForm, RowId, Table};
use resultant::physics::DVec2;
use resultant::screens::Key;

const CRATE: (f64, f64) = (220.0, 420.0);
const KEY: (f64, f64) = (520.0, 420.0);

fn with_bodies() -> Sitting {
    let mut sitting = open();
    draw(&mut sitting, Kind::Object, (200.0, 400.0), (240.0, 440.0));
    draw(&mut sitting, Kind::Key, (500.0, 400.0), (540.0, 440.0));
    sitting.press(Key::Escape);
    sitting
}

fn pull(sitting: &mut Sitting, form: LinkForm, from: (f64, f64), to: (f64, f64)) {
    sitting.click(form.name());
    drag(sitting, from, to);
    assert!(sitting.is_chosen(form.name()), "the tool stays");
    sitting.press(Key::Escape);
}

fn link(row: usize) -> RowId {
    RowId { table: Table::Links, row }
}

fn ends(sitting: &Sitting, row: usize) -> [&str; 2] {
    ["a", "b"].map(|column| cell(sitting, link(row), column).unwrap_or_default())
}

#[track_caller]
fn assert_sound(sitting: &mut Sitting) {
    let problems = sitting.wait(0.3).editor().problems();
    assert!(problems.iter().all(|(problem, _)| problem.file != "links.csv"), "{problems:?}");
}

#[test]
fn each_kind_of_link_is_pulled_from_body_to_body() {
    let mut sitting = with_bodies();
    for (index, form) in LinkForm::ALL.into_iter().enumerate() {
        pull(&mut sitting, form, CRATE, KEY);
        assert_eq!((ends(&sitting, index), sitting.editor().selection()), (["box", "key"], &[link(index)][..]));
        assert_eq!(sitting.editor().document().link_form(link(index)), form);
        assert_sound(&mut sitting);
    }
    (0..4).for_each(|_| control(&mut sitting, Key::Z));
    assert_eq!(rows(&sitting, Table::Links), 0);
    assert!(!text(&sitting, Table::Objects).contains("box,"), "{}", text(&sitting, Table::Objects));
}

#[test]
fn a_link_joins_a_body_and_a_place_but_neither_two_places_nor_one_body() {
    let mut sitting = with_bodies();
    pull(&mut sitting, LinkForm::Rope, (400.0, 300.0), (403.0, 100.0));
    assert_eq!(ends(&sitting, 0), ["ship", "400 100"]);
    for to in [(600.0, 500.0), (101.0, 101.0)] {
        pull(&mut sitting, LinkForm::Rope, (100.0, 100.0), to);
    }
    pull(&mut sitting, LinkForm::Spring, CRATE, (225.0, 425.0));
    assert_eq!(rows(&sitting, Table::Links), 1);
    assert!(sitting.shows("A link joins two bodies, or a body and a place"));
}

#[test]
fn both_ends_have_handles_that_are_led_to_bodies_and_places() {
    let mut sitting = with_bodies();
    pull(&mut sitting, LinkForm::Rope, CRATE, KEY);
    sitting.press(Key::Escape);
    drag(&mut sitting, (300.0, 420.0), (300.0, 420.0));
    assert_eq!(sitting.editor().selection(), [link(0)]);
    let handles: Vec<DVec2> = sitting.editor().handles().into_iter().map(|(_, at)| at).collect();
    assert_eq!(handles, [CRATE, KEY].map(DVec2::from));
    drag(&mut sitting, KEY, (610.0, 100.0));
    drag(&mut sitting, CRATE, (400.0, 300.0));
    assert_eq!(ends(&sitting, 0), ["ship", "610 100"]);
    drag(&mut sitting, (400.0, 300.0), (700.0, 500.0));
    assert_eq!(ends(&sitting, 0), ["ship", "610 100"]);
    assert!(sitting.shows("A link joins two bodies"));
    assert_sound(&mut sitting);
}

#[test]
fn a_link_that_is_moved_moves_both_ends_alike() {
    let mut sitting = with_bodies();
    pull(&mut sitting, LinkForm::Spring, CRATE, (460.0, 420.0));
    sitting.press(Key::Escape).press(Key::G);
    drag(&mut sitting, (340.0, 420.0), (370.0, 370.0));
    assert_eq!(ends(&sitting, 0), ["box", "490 370"]);
    assert!(text(&sitting, Table::Objects).contains("\n250,370,box:40x40,"), "{}", text(&sitting, Table::Objects));
    let place = sitting.editor().document().place(link(0)).unwrap();
    assert_eq!(place.centre(), DVec2::new(370.0, 370.0), "and the middle is where the pointer is");
}

#[test]
fn the_kind_is_a_field_and_takes_the_numbers_of_its_law_along() {
    let mut sitting = with_bodies();
    pull(&mut sitting, LinkForm::Rope, CRATE, KEY);
    let kinds = [("spring", "stiffness", "strength"), ("magnet", "strength", "stiffness"), ("rope", "stiffness", "strength")];
    for (kind, has, lacks) in kinds {
        sitting.click("kind");
        assert_eq!(cell(&sitting, link(0), "kind"), Some(kind));
        let number = |column| sitting.editor().document().number(link(0), column);
        assert!(number(has).is_some() && number(lacks).is_none(), "{kind}");
        assert_sound(&mut sitting);
    }
    // What a number means, with its unit, where the pointer is on its name or its field.
    sitting.press(Key::Escape);
    let at = sitting.area("stiffness").centre();
    sitting.point_at(at);
    assert!(sitting.shows("N/m") && sitting.shows("force k of a spring or rope"));
}
