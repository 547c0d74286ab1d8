//! The list of levels, also where levels are broken or missing.

use crate::sitting::{FAR_AWAY, Sitting, level};
use resultant::screens::{Key, Press};
use resultant::view::layout::{Area, Vec2};
use std::fs;
use std::path::Path;

#[test]
fn levels_are_listed_in_numeric_order_in_a_grid_of_slices() {
    let mut sitting = Sitting::new();
    sitting.choose(1).rest();
    let names: Vec<&str> = sitting.level_select().entries().iter().map(|entry| entry.name.as_str()).collect();
    assert_eq!(names, ["1", "2", "3", "10", "broken"]);
    let slice = Vec2::new(1280.0 / 11.0, 720.0 / 7.0);
    for index in 0..5 {
        let expected = Area { min: slice * Vec2::new(1.0 + 2.0 * index as f32, 1.0), size: slice };
        let area = sitting.buttons().areas()[index];
        assert!((area.min - expected.min).abs().max_element() < 0.01 && (area.size - expected.size).abs().max_element() < 0.01);
    }
    let marked: Vec<bool> = sitting.level_select().entries().iter().map(|entry| entry.title.is_err()).collect();
    assert_eq!(marked, [false, false, false, false, true]);
}

#[test]
fn the_list_comes_back_where_it_was_left() {
    let mut sitting = Sitting::new();
    sitting.fly(3).press_all(&[Key::Escape, Key::Down, Key::Down, Key::Down, Key::Enter]);
    assert_eq!((sitting.at(), sitting.buttons().focus()), ("level select", 3));
}

#[test]
fn more_than_fifteen_levels_make_pages() {
    let many = |root: &Path| (20..40).for_each(|i| level(root, &i.to_string(), FAR_AWAY, ""));
    let mut sitting = Sitting::with(many);
    sitting.choose(1).rest();
    let shown = |sitting: &Sitting| (sitting.level_select().page(), sitting.buttons().areas().len());
    assert_eq!(shown(&sitting), (0, 15 + 3), "a page, Back, Previous and Next");
    sitting.press(Key::PageUp);
    assert_eq!(shown(&sitting), (0, 18), "no page before the first");
    sitting.choose(17).rest();
    assert_eq!(shown(&sitting), (1, 10 + 3));
    sitting.click(12).press(Key::PageDown);
    assert_eq!(shown(&sitting), (1, 13), "no page after the last");
    assert_eq!(sitting.choose(0).flight().game().level().name, "31", "the sixteenth level of the list");
    sitting.press(Key::Escape).click(3).press(Key::PageUp).press(Key::PageDown).click(10 + 1).rest();
    assert_eq!(shown(&sitting).0, 0);
}

#[test]
fn a_level_that_does_not_load_shows_its_problems_and_closes_nothing() {
    for by_mouse in [true, false] {
        let mut sitting = Sitting::new();
        sitting.choose(1);
        if by_mouse {
            sitting.click(4)
        } else {
            sitting.choose(4)
        };
        let problems = sitting.level_select().problems().expect("the panel is open").problems().to_vec();
        assert_eq!(problems.len(), 1);
        assert!(problems[0].starts_with("obstacles.csv:1: column \"width\": found \"wide\""), "{problems:?}");
        sitting.press(Key::Enter);
        assert_eq!(sitting.at(), "level select", "Enter closes the panel and does not open it again");
        sitting.choose(4).press(Key::Escape);
        assert_eq!(sitting.at(), "level select");
        assert_eq!(sitting.press(Key::Escape).at(), "menu");
    }
}

#[test]
fn a_broken_level_met_on_the_way_lands_on_level_select_with_its_problems() {
    let mut sitting = Sitting::with(|root| {
        fs::remove_dir_all(root.join("levels/2")).unwrap();
        level(root, "2", FAR_AWAY, "nonsense\n");
    });
    sitting.complete();
    let next = sitting.scoring().presses().iter().position(|press| *press == Press::NextLevel).unwrap();
    sitting.choose(next);
    assert_eq!(sitting.at(), "problems");
    assert!(sitting.level_select().problems().unwrap().heading().contains('2'));

    // A level may break, or vanish, while the list is open.
    let mut sitting = Sitting::new();
    sitting.choose(1);
    fs::remove_dir_all(sitting.folder.path().join("levels/1")).unwrap();
    assert_eq!(sitting.choose(0).at(), "problems");
}

#[test]
fn without_levels_nothing_breaks() {
    let mut sitting = Sitting::with(|root| fs::remove_dir_all(root.join("levels")).unwrap());
    assert_eq!(sitting.choose(0).at(), "level select", "there is nothing to play");
    assert!(sitting.level_select().entries().is_empty());
    assert_eq!(sitting.choose(0).at(), "menu", "Back is the only button");
}
