//! The instruments beside a flight: the rail, and whose clicks are whose.

use crate::sitting::Sitting;
use resultant::screens::{Input, Instrument, Key};
use resultant::view::layout::Vec2;

fn flying() -> Sitting {
    let mut sitting = Sitting::with(|_| {});
    sitting.choose(1).choose(0);
    assert_eq!(sitting.at(), "flight");
    sitting
}

#[test]
fn the_rail_opens_by_key_and_its_buttons_take_their_clicks_from_the_flight() {
    let mut sitting = flying();
    assert!(!sitting.flight().instruments().is_open());
    sitting.press(Key::Tab).press(Key::N).press(Key::I);
    assert!(sitting.flight().instruments().is_open());
    let followed = sitting.flight().observer().focus().followed();
    assert!(followed.is_some());
    let areas = sitting.flight().instruments().areas(&Input::default().frame);
    sitting.give(Input { pointer: areas[0].centre(), click: true, ..Input::default() });
    assert!(sitting.flight().instruments().uses(Instrument::Centre));
    assert_eq!(sitting.flight().observer().focus().followed(), followed, "the click was the button's");
    sitting.give(Input { pointer: Vec2::new(640.0, 200.0), click: true, ..Input::default() });
    assert_eq!(sitting.flight().observer().focus().followed(), None, "the click was the flight's");
    sitting.press(Key::R);
    assert!(sitting.flight().instruments().uses(Instrument::Centre), "it stays in use when the level begins anew");
    sitting.press(Key::I);
    assert!(!sitting.flight().instruments().uses(Instrument::Centre) && !sitting.flight().is_assisted());
}
