//! Which keys count in a flight and when; keys of other layouts than that of the tests.

use crate::sitting::{Sitting, keys};
use resultant::screens::{Input, Key, Keys};
use resultant::settings::{Action, layout};
use std::fs;

/// A key of another layout: where it is, and what it types.
fn foreign(place: Key, typed: Key) -> Keys {
    let mut keys = Keys::default();
    keys.add_place(place);
    keys.add_typed(typed);
    keys
}

impl Sitting {
    fn burning(&self) -> i8 {
        self.flight().game().ship().burning
    }

    fn has_begun(&self) -> bool {
        !self.flight().game().is_idle()
    }
}

fn flying() -> Sitting {
    let mut sitting = Sitting::new();
    sitting.fly("2").rest();
    sitting
}

#[test]
fn what_is_held_at_a_restart_a_pause_or_as_the_focus_goes_counts_once_it_was_released() {
    let space = &[Key::Space];
    type Part = fn(&mut Sitting);
    let restart: Part = |sitting| _ = sitting.press_keys(&[Key::R], &[Key::R, Key::Space]);
    let pause: Part = |sitting| {
        sitting.press_keys(&[Key::Escape], &[Key::Escape, Key::Space]);
        sitting.hold(&[Key::Space], 3).press_keys(&[Key::Escape], &[Key::Escape, Key::Space]);
    };
    let resume: Part = |sitting| {
        sitting.press_keys(&[Key::PadStart], &[Key::PadStart, Key::Space]);
        sitting.hold(&[Key::Space], 3).press_keys(&[Key::PadA], &[Key::PadA, Key::Space]).hold(&[Key::PadA, Key::Space], 3);
    };
    let focus: Part = |sitting| _ = sitting.give(Input { away: true, held: keys(&[Key::Space]), ..Input::default() });
    for (what, part) in [("restart", restart), ("pause", pause), ("resume", resume), ("focus", focus)] {
        let mut sitting = flying();
        sitting.press_keys(space, space).hold(space, 5);
        assert_eq!(sitting.burning(), 1, "{what}");
        part(&mut sitting);
        sitting.hold(space, 10);
        assert_eq!((sitting.at(), sitting.burning()), ("flight", 0), "{what}");
        sitting.rest().press_keys(space, space).hold(space, 2);
        assert_eq!(sitting.burning(), 1, "{what}");
    }
}

#[test]
fn a_record_agrees_with_what_flew_around_a_pause() {
    let mut sitting = flying();
    sitting.press_keys(&[Key::Space], &[Key::Space]).hold(&[Key::Space], 5);
    sitting.press_keys(&[Key::Escape], &[Key::Escape, Key::Space]).press_keys(&[Key::Escape], &[Key::Escape, Key::Space]);
    sitting.hold(&[Key::Space], 20).rest();
    let flight = sitting.flight();
    assert_eq!(flight.history().at(u64::MAX).hash(), flight.game().hash());
    assert!(flight.history().inputs().clone().into_iter().skip(14).all(|controls| !controls.thrust));
}

/// W3: on a US keyboard + is Shift and =, and Shift thrusts backwards.
#[test]
fn zooming_burns_no_fuel_and_starts_no_clock() {
    for (frames, begun) in [(0, false), (5, false), (20, false), (2, true), (6, true)] {
        let mut sitting = flying();
        if begun {
            sitting.press_keys(&[Key::Left], &[Key::Left]).rest();
        }
        let fuel = sitting.game().ship().fuel;
        sitting.press_keys(&[Key::Shift], &[Key::Shift]).hold(&[Key::Shift], frames);
        (0..2).for_each(|_| _ = sitting.press_keys(&[Key::Equal], &[Key::Shift, Key::Equal]).hold(&[Key::Shift], 30));
        sitting.wait(1.0);
        assert_eq!(sitting.game().ship().fuel, fuel, "Shift {frames} frames before +");
        assert_eq!(sitting.has_begun(), begun);
        assert!(sitting.flight().observer().focus().zoom() > 1.9);
    }
    let mut sitting = flying();
    sitting.press_keys(&[Key::Shift, Key::Equal], &[]).wait(1.0);
    assert!(!sitting.has_begun());
}

#[test]
fn what_is_taken_back_was_never_flown() {
    let mut sitting = flying();
    sitting.press_keys(&[Key::Space], &[Key::Space]).hold(&[Key::Space], 30);
    let before = sitting.ticks();
    sitting.press_keys(&[Key::Shift], &[Key::Shift]).hold(&[Key::Shift], 12);
    assert_eq!(sitting.burning(), -1);
    sitting.press_keys(&[Key::Equal], &[Key::Shift, Key::Equal]).rest();
    let flight = sitting.flight();
    assert_eq!(flight.history().at(u64::MAX).hash(), flight.game().hash());
    assert!(flight.history().inputs().clone().into_iter().all(|controls| !controls.reverse));
    assert!(flight.game().ticks() > before + 24, "time goes on");
    assert!(!sitting.game().is_idle());
}

#[test]
fn shift_alone_thrusts_as_long_as_it_is_held() {
    for (frames, begun) in [(1, true), (3, true), (12, true), (60, true), (3, false), (60, false)] {
        let mut sitting = flying();
        if begun {
            sitting.press_keys(&[Key::Left], &[Key::Left]).rest();
        }
        sitting.press_keys(&[Key::Shift], &[Key::Shift]).hold(&[Key::Shift], frames - 1).wait(1.0);
        let burnt = sitting.flight().history().inputs().clone().into_iter().filter(|controls| controls.reverse).count();
        // Two ticks a frame.
        assert!(burnt.abs_diff(2 * frames) <= 2, "{frames} frames: {burnt} ticks");
    }
    assert_eq!(flying().press_keys(&[Key::Shift], &[Key::Shift]).burning(), -1, "at once");
}

#[test]
fn ctrl_z_is_the_key_that_types_z() {
    let mut sitting = Sitting::new();
    sitting.choose("Editor").choose("2").rest();
    assert_eq!(sitting.at(), "editor");
    let control = |key: Keys| Input { pressed: key, held: keys(&[Key::Control]) | key, ..Input::default() };
    sitting.give(control(keys(&[Key::A]))).press(Key::Right);
    let moved = |sitting: &Sitting| sitting.editor().is_unsaved();
    assert!(moved(&sitting));
    sitting.give(control(foreign(Key::Z, Key::Y)));
    assert!(moved(&sitting), "the key at the place of Z types y on QWERTZ");
    sitting.give(control(foreign(Key::Y, Key::Z)));
    assert!(!moved(&sitting));
}

#[test]
fn umlauts_and_signs_are_set_and_named_and_kept() {
    layout::note(Key::Semicolon, 'ö');
    let mut sitting = Sitting::new();
    sitting.choose("Settings").click("All keys");
    while sitting.focused() != "Thrust 1" {
        sitting.press(Key::Up);
    }
    let umlaut = foreign(Key::Semicolon, Key::Sign('ö'));
    let set = |sitting: &mut Sitting, typed: &str, pressed: Keys| {
        sitting.press(Key::Enter).give(Input { pressed, typed: typed.into(), ..Input::default() });
    };
    set(&mut sitting, "ö", umlaut);
    while sitting.focused() != "Whole map 1" {
        sitting.press(Key::Down);
    }
    set(&mut sitting, "ö", umlaut);
    assert_eq!(sitting.row("Whole map")[1], "Ö");
    assert!(sitting.shows("Ö does two things: Thrust and Whole map."));
    // [ is AltGr and 8 on QWERTZ: Alt goes down first.
    let mut bracket = foreign(Key::Key8, Key::Key8);
    bracket.add_typed(Key::LeftBracket);
    sitting.press(Key::Enter).press_keys(&[Key::Alt], &[Key::Alt]);
    assert!(sitting.shows("press a key"));
    sitting.give(Input { pressed: bracket, held: keys(&[Key::Alt]) | bracket, typed: "[".into(), ..Input::default() });
    assert_eq!(sitting.row("Whole map")[1], "[");
    // Shift by itself is taken as it goes up.
    sitting.press(Key::Right).press(Key::Enter).press(Key::Shift).rest();
    assert_eq!(sitting.row("Whole map")[2], "Shift");
    let file = fs::read_to_string(sitting.folder.path().join("settings.csv")).unwrap();
    assert!(file.contains("key_thrust,Semicolon W,\n") && file.contains("key_map,LeftBracket Shift,\n"), "{file}");
    sitting.press(Key::Left);
    set(&mut sitting, "ö", umlaut);
    let file = fs::read_to_string(sitting.folder.path().join("settings.csv")).unwrap();
    assert!(file.contains("key_map,ö Shift,\n"), "{file}");
    sitting.reopen();
    assert_eq!(sitting.app.settings().keys.of(Action::Map)[0], Some(Key::Sign('ö')));
    sitting.fly("2").give(Input { pressed: umlaut, held: umlaut, ..Input::default() });
    assert_eq!(sitting.burning(), 1, "a key that flies does nothing else");
    assert!(!sitting.flight().observer().shows_map());
}
