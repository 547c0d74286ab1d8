//! How often frames come and which of them are drawn, and clocks that jump.

use super::sitting::{Sitting, enter};
use resultant::screens::{Input, Key, Picture};

/// Frames without input, a second of thirty: how many of them were drawn.
fn drawn(sitting: &mut Sitting, frames: usize) -> usize {
    let mut frame = || sitting.give(Input { frame_time: 1.0 / 30.0, ..Input::default() }).app.picture();
    (0..frames).filter(|_| frame() != Picture::Again).count()
}

/// The least time to a next frame without input, s.
fn interval(sitting: &Sitting) -> f64 {
    sitting.app.interval(&Input::default())
}

#[test]
fn a_clock_that_jumps_hides_no_screen_and_ends_nothing() {
    for jump in [-3600.0, -1e300, f64::NEG_INFINITY, f64::NAN, 1e300, f64::INFINITY] {
        let mut sitting = Sitting::new();
        sitting.wait(1.0);
        let frame = sitting.frame;
        assert!(sitting.app.update(&Input { frame_time: jump, frame, ..Input::default() }, &mut ()));
        assert_eq!(sitting.app.veil(), 0.0, "{jump}");
        assert!((0.9..=1.5).contains(&sitting.app.shown_for), "{jump}: {}", sitting.app.shown_for);
        // A screen that opens in that very frame fades in soon after, and its level arrives.
        let mut sitting = Sitting::new();
        sitting.press(Key::Down);
        sitting.app.update(&Input { frame_time: jump, frame, ..enter() }, &mut ());
        assert_eq!(sitting.wait(0.2).at(), "level select", "{jump}");
        assert_eq!(sitting.app.veil(), 0.0, "{jump}");
        let mut sitting = Sitting::new();
        sitting.choose("Play");
        sitting.app.update(&Input { frame_time: jump, frame, ..Input::default() }, &mut ());
        assert_eq!(sitting.wait(2.0).at(), "scoring", "{jump}");
    }
}

#[test]
fn flights_have_every_frame_and_menus_thirty_a_second_at_most() {
    let mut sitting = Sitting::new();
    for button in ["Levels", "Boards", "Classics", "Lab", "Settings", "Credits"] {
        assert_eq!(interval(sitting.choose(button)), 1.0 / 30.0, "{}", sitting.at());
        sitting.press(Key::Escape);
    }
    assert_eq!(interval(&sitting), 1.0 / 30.0, "the menu");
    assert_eq!(sitting.app.interval(&enter()), 0.0, "a key is felt at once");
    sitting.fly("2");
    assert_eq!((interval(&sitting), drawn(&mut sitting, 200)), (0.0, 200));
    sitting.press(Key::Escape);
    assert_eq!((sitting.at(), interval(&sitting)), ("pause", 1.0 / 30.0));
}

#[test]
fn a_paused_flight_and_a_menu_of_buttons_are_drawn_when_something_changes() {
    let mut sitting = Sitting::new();
    sitting.fly("2").press(Key::Escape);
    let settings = |sitting: &mut Sitting| {
        sitting.press(Key::Escape).press(Key::Escape).choose("Main Menu").choose("Settings");
    };
    for open in [|_: &mut Sitting| {}, settings] {
        open(&mut sitting);
        assert_eq!(drawn(&mut sitting, 30), 30, "{}: what has begun comes to its end", sitting.at());
        let beats = drawn(&mut sitting, 300);
        assert!(beats <= 21, "{}: {beats} of 300", sitting.at());
        sitting.press(Key::Down);
        assert_eq!(sitting.app.picture(), Picture::Drawn, "{}", sitting.at());
        drawn(&mut sitting, 100);
        sitting.point_at(sitting.frame.size / 2.0);
        assert_eq!(sitting.app.picture(), Picture::Drawn, "{}", sitting.at());
    }
    drawn(&mut sitting, 100);
    assert!(sitting.app.interval(&Input { away: true, ..Input::default() }) > 1.0 / 30.0);
}

#[test]
fn the_menu_moves_until_nobody_has_touched_it_for_a_minute_or_the_player_is_elsewhere() {
    let mut sitting = Sitting::new();
    assert_eq!(drawn(&mut sitting, 55 * 30), 55 * 30);
    drawn(&mut sitting, 10 * 30);
    let ship = sitting.menu().ship();
    assert!(drawn(&mut sitting, 300) <= 21);
    assert_eq!(sitting.menu().ship(), ship);
    sitting.press(Key::Down);
    assert_eq!(drawn(&mut sitting, 300), 300);
    assert_ne!(sitting.menu().ship(), ship);
    let away = |sitting: &mut Sitting| {
        let frame = |_| sitting.give(Input { away: true, frame_time: 1.0 / 30.0, ..Input::default() }).app.picture();
        (0..300).map(frame).filter(|picture| *picture != Picture::Again).count()
    };
    assert!(away(&mut sitting) <= 60);
}
