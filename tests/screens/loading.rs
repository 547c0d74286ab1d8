//! Levels that are read beside the screens: no frame waits for one.

use crate::sitting::{FAR_AWAY, Sitting, level};
use resultant::screens::{Destination, Key, Purpose, Request, Visit};
use std::fs;

fn by_hand() -> Sitting {
    Sitting::new().by_hand()
}

#[test]
fn a_level_opens_once_it_is_read_and_the_frames_until_then_go_on() {
    let mut sitting = by_hand();
    sitting.app.grant(Request::Reset(Destination::Play("2".into())), &mut ());
    for frame in 0..100 {
        assert_eq!(sitting.rest().at(), "menu", "nothing is read by the frames themselves");
        assert!(sitting.app.is_loading() && (frame > 10 || sitting.app.loading().is_none()), "told before a moment has passed");
    }
    assert_eq!(sitting.app.loading(), Some("level 2"));
    // Keys pressed meanwhile are for no screen.
    sitting.press_all(&[Key::Down, Key::Enter]);
    assert_eq!((sitting.at(), sitting.app.is_loading()), ("menu", true));
    assert_eq!((sitting.work(1), sitting.at()), (1, "flight"), "before all that nobody waits for");
    assert_eq!(sitting.app.loading(), None);
}

#[test]
fn esc_takes_back_what_loads_and_nothing_of_it_comes_later() {
    let mut sitting = by_hand();
    sitting.app.grant(Request::Reset(Destination::Play("2".into())), &mut ());
    sitting.rest().press(Key::Escape);
    assert!(!sitting.app.is_loading());
    sitting.work(10);
    assert_eq!(sitting.at(), "menu");
    sitting.app.grant(Request::Reset(Destination::Play("2".into())), &mut ());
    sitting.app.grant(Request::Reset(Destination::Play("10".into())), &mut ());
    sitting.work(10);
    assert_eq!(sitting.flown(), "10");
}

#[test]
fn cards_appear_one_after_the_other_and_a_level_that_is_chosen_goes_before_them() {
    let mut sitting = by_hand();
    sitting.work(10);
    sitting.app.grant(Request::Reset(Destination::Levels(Purpose::Play)), &mut ());
    let known = |sitting: &Sitting| sitting.level_select().entries.iter().filter(|entry| entry.level.is_some()).count();
    sitting.rest();
    for count in 0..3 {
        assert_eq!(known(sitting.rest()), count);
        sitting.work(1);
    }
    sitting.choose("10");
    assert_eq!((sitting.work(1), sitting.at()), (1, "flight"));
    assert_eq!(sitting.flown(), "10");
    assert_eq!(sitting.work(10), 0, "the other cards are not read for nobody");
}

#[test]
fn play_opens_the_first_level_that_loads_once_it_is_found() {
    let mut sitting = Sitting::with(|root| {
        fs::remove_dir_all(root.join("levels/1")).unwrap();
        level(root, "1", FAR_AWAY, "nonsense\n");
    })
    .by_hand();
    assert_eq!(sitting.choose("Play").at(), "level select", "not known yet");
    sitting.press(Key::Escape).work(20);
    sitting.choose("Play");
    sitting.work(1);
    assert_eq!((sitting.at(), sitting.flown()), ("flight", "2"));
}

#[test]
fn every_screen_that_needs_a_level_waits_for_it() {
    let mut sitting = by_hand();
    let visit = resultant::screens::Visit { level: "2".into(), flown: None, chosen: None };
    for (request, at) in [
        (Request::Reset(Destination::Edit { name: "2".into(), original: false }), "editor"),
        (Request::Reset(Destination::Board(Visit::of("2"))), "leaderboard"),
        (Request::Reset(Destination::Flights(visit)), "flights"),
        (Request::Reset(Destination::Play("broken".into())), "problems"),
    ] {
        sitting.work(20);
        let before = sitting.at();
        sitting.app.grant(request, &mut ());
        assert_eq!((sitting.rest().at(), sitting.app.is_loading()), (before, true), "{at}");
        sitting.work(1);
        assert_eq!((sitting.at(), sitting.app.is_loading()), (at, false));
    }
    sitting.press(Key::Escape);
    sitting.app.grant(Request::Reset(Destination::Play("2".into())), &mut ());
    sitting.work(20);
    let flown = |sitting: &Sitting| sitting.ticks();
    sitting.wait(0.3);
    fs::write(sitting.folder.path().join("levels/2/world.csv"), "0,580,800,20\n").unwrap();
    sitting.wait(0.5);
    assert!(sitting.game().level().world.is_empty() && flown(&sitting) > 80, "it flies on meanwhile");
    assert_eq!((sitting.work(1), sitting.game().level().world.len()), (1, 1));
    let ticks = flown(&sitting);
    assert!(flown(sitting.press(Key::R)) >= ticks && sitting.app.is_loading());
    sitting.work(1);
    assert!(flown(&sitting) < 5);
}

#[test]
fn levels_that_come_and_go_while_the_list_is_open_are_listed() {
    let mut sitting = Sitting::new();
    sitting.choose("Levels").press(Key::Right).rest();
    level(sitting.folder.path(), "0", FAR_AWAY, "");
    fs::remove_dir_all(sitting.folder.path().join("levels/3")).unwrap();
    sitting.wait(0.6);
    assert_eq!(sitting.level_names(), ["0", "1", "2", "10", "broken"]);
    assert!(sitting.level_select().entries[0].level.as_ref().is_some_and(Result::is_ok));
    assert_eq!(sitting.press(Key::Enter).flown(), "2", "the keyboard stays on its level");
}

/// Level 3 is lost by its first tick.
#[test]
fn after_a_loss_the_level_is_asked_for_once_and_comes_back() {
    let mut sitting = by_hand();
    sitting.work(10);
    sitting.app.grant(Request::Reset(Destination::Play("3".into())), &mut ());
    sitting.work(10);
    assert_eq!(sitting.at(), "flight");
    assert_eq!(sitting.wait(0.6).work(10), 1, "one errand, however many frames it takes");
    assert!(sitting.shows("Touched a red box"), "{:?}", sitting.texts());
}
