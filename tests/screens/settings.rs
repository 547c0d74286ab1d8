//! The settings: from the menu and from a flight, at once and for good; help in flight is marked.

use super::sitting::Sitting;
use resultant::screens::{Input, Key};
use resultant::settings::Action;
use std::fs;

#[test]
fn arrows_change_values_and_enter_takes_a_key() {
    let mut sitting = Sitting::new();
    sitting.choose("Settings");
    assert_eq!(sitting.press(Key::Left).app.settings().master, 70);
    assert_eq!(sitting.press(Key::Right).app.settings().master, 80);
    let keys = |sitting: &Sitting| sitting.app.settings().keys.of(Action::Thrust);
    assert_eq!(sitting.press(Key::Tab).focused(), "Thrust 1");
    assert!(sitting.press(Key::Enter).shows("press a key"));
    assert_eq!(keys(sitting.press(Key::Tab)), [Some(Key::Tab), Some(Key::W)], "any key, Tab too");
    assert_eq!(keys(sitting.press(Key::Delete)), [None, Some(Key::W)]);
    assert_eq!(keys(sitting.press(Key::Enter).press(Key::W)), [Some(Key::W), None], "a key stands once");
    sitting.press(Key::Enter).press(Key::Escape);
    assert!(!sitting.shows("press a key") && sitting.at() == "settings");
    sitting.press(Key::Enter).click("Defaults");
    assert!(!sitting.shows("press a key"));
    assert_eq!(keys(&sitting), [Some(Key::W), None]);
}

#[test]
fn a_key_that_was_set_flies_and_the_old_one_does_not() {
    let burning = |key: Key| {
        let mut sitting = Sitting::new();
        sitting.choose("Settings").press(Key::Tab).press(Key::Enter).press(Key::T).press(Key::Escape).press(Key::Up).fly("3");
        let held = [key].into_iter().collect();
        sitting.give(Input { held, ..Input::default() }).give(Input { held, ..Input::default() });
        sitting.game().ship().burning
    };
    assert_eq!([Key::T, Key::W, Key::Space, Key::PadR2].map(burning), [1, 1, 0, 1]);
}

#[test]
fn a_key_that_looks_on_is_set_like_one_that_flies() {
    let rows = "setting,value,player\nkey_freeze,V,\nkey_instruments,,\n";
    let mut sitting = Sitting::with(|root| fs::write(root.join("settings.csv"), rows).unwrap());
    sitting.fly("1").press(Key::B).press(Key::I);
    assert!(!sitting.flight().observer().frozen() && !sitting.flight().instruments().is_open());
    assert!(sitting.press(Key::V).flight().observer().frozen());
}

#[test]
fn f11_and_alt_enter_fill_the_screen_and_press_nothing_else() {
    let mut sitting = Sitting::new();
    sitting.press(Key::F11);
    assert!(sitting.app.settings().fullscreen);
    let (pressed, held) = ([Key::Enter].into_iter().collect(), [Key::Alt, Key::Enter].into_iter().collect());
    sitting.give(Input { pressed, held, ..Input::default() });
    assert!(!sitting.app.settings().fullscreen);
    assert_eq!(sitting.at(), "menu");
}

#[test]
fn a_flight_with_help_is_marked() {
    for (steps, marked) in [(0, false), (1, true)] {
        let mut sitting = Sitting::new();
        sitting.choose("Settings");
        while sitting.focused() != "Assist: game speed" {
            sitting.press(Key::Down);
        }
        sitting.press_all(&[Key::Left][..steps]).press(Key::Escape).complete();
        assert_eq!(sitting.scoring().result.assisted, marked);
    }
}

#[test]
fn a_file_that_is_wrong_is_told_where_it_is_set() {
    let mut sitting = Sitting::with(|root| fs::write(root.join("settings.csv"), "setting,value,player\nvolume,loud\n").unwrap());
    sitting.choose("Settings");
    let expected = "settings.csv:2: column \"value\" of volume: found \"loud\", expected a whole number of percents from 0 to 100";
    // In lines that end before the values of the next column.
    let words: Vec<String> = sitting.texts().into_iter().map(|(words, _)| words).collect();
    assert!(words.join(" ").contains(expected), "{words:?}");
}
