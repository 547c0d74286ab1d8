//! An observer stops the world, takes it a tick on or back, changes its pace, and picks out the body of the details.

use crate::sitting::{Sitting, level};
use resultant::game::TICK_RATE;
use resultant::physics::BodyId;
use resultant::screens::{Input, Key, OBSERVED_PACES};

fn flying() -> Sitting {
    let mut sitting = Sitting::with(|root| {
        level(root, "0", "PLAYER,380,60,40,40\n", "");
        std::fs::write(root.join("levels/0/objects.csv"), "100,100,box:30x30,5,1,FALSE,0\n300,100,box:30x30,5,1,FALSE,0\n")
            .unwrap();
    });
    sitting.fly("0");
    assert_eq!(sitting.at(), "flight");
    sitting
}

#[test]
fn a_frozen_world_stands_and_goes_on_and_back_by_single_ticks_bit_for_bit() {
    let mut sitting = flying();
    sitting.wait(0.5).press(Key::B);
    let (frozen, hash) = (sitting.ticks(), sitting.game().hash());
    assert!(frozen > 0 && sitting.flight().observer().frozen() && !sitting.flight().is_assisted());
    sitting.wait(1.0);
    assert_eq!(sitting.ticks(), frozen, "nothing moves");
    sitting.press_all(&[Key::Comma; 5]);
    assert_eq!(sitting.ticks(), frozen - 5);
    sitting.press_all(&[Key::Period; 5]);
    assert_eq!((sitting.ticks(), sitting.game().hash()), (frozen, hash));
    sitting.press_keys(&[Key::Period], &[Key::Space, Key::Period]);
    assert_eq!(sitting.ticks(), frozen + 1);
    assert!(sitting.game().ship().burning > 0, "the tick was made with thrust");
    sitting.press_all(&[Key::Comma; 200]);
    assert_eq!(sitting.ticks(), 0);
    assert!(sitting.flight().is_assisted(), "taking time back is help");
}

#[test]
fn time_is_slowed_down_to_a_hundredth_and_hurried_up_to_eight_times() {
    let mut sitting = flying();
    assert_eq!((OBSERVED_PACES[0], OBSERVED_PACES[OBSERVED_PACES.len() - 1]), (0.01, 8.0));
    let in_a_second = |sitting: &mut Sitting| {
        let before = sitting.ticks();
        sitting.wait(1.0);
        sitting.ticks() - before
    };
    assert!(in_a_second(&mut sitting).abs_diff(TICK_RATE as u64) <= 1);
    sitting.press_all(&[Key::LeftBracket; 20]);
    assert_eq!(sitting.flight().observer().pace(), 0.01);
    assert!(in_a_second(&mut sitting).abs_diff(1) <= 1);
    let said = sitting.flight().observer().words(0, TICK_RATE).unwrap();
    assert!(sitting.flight().is_assisted() && said.starts_with("1/100"), "{said}");
    sitting.press_all(&[Key::RightBracket; 7]);
    assert_eq!(sitting.flight().observer().pace(), 2.0);
    assert!(in_a_second(&mut sitting).abs_diff(2 * TICK_RATE as u64) <= 2);
}

#[test]
fn bodies_are_picked_out_by_key_and_by_click_while_the_details_are_open() {
    let mut sitting = flying();
    let focus = |sitting: &Sitting| (sitting.flight().observer().focus().followed, sitting.flight().observer().focus().compared);
    sitting.press(Key::N);
    assert_eq!(focus(&sitting), (None, None), "without details there is nothing to pick");
    sitting.press(Key::Tab).press(Key::N).press(Key::N);
    assert_eq!(focus(&sitting), (Some(BodyId(1)), None));
    let shift = [Key::Shift].into_iter().collect();
    sitting.give(Input { click: true, pointed: Some(BodyId(2)), held: shift, ..Input::default() });
    assert_eq!(focus(&sitting), (Some(BodyId(1)), Some(BodyId(2))));
    sitting.give(Input { click: true, ..Input::default() });
    assert_eq!(focus(&sitting), (None, None), "a click beside them tells of all again");
    // Arrows grow by Ctrl and +, and the view stays as it is.
    let (length, zoom) = (
        |sitting: &Sitting| sitting.flight().observer().focus().length(),
        |sitting: &Sitting| sitting.flight().observer().focus().zoom(),
    );
    (0..2).for_each(|_| _ = sitting.press_keys(&[Key::Equal], &[Key::Control, Key::Equal]));
    assert!((length(&sitting) - 2.0).abs() < 1e-12 && zoom(&sitting) == 1.0);
}

/// In every flight, with or without details, + and − and the wheel zoom, Shift or not, for + is Shift and = on many keyboards; F fits the view to
/// what moves, and follows again.
#[test]
fn the_view_is_zoomed_and_fitted_in_any_flight() {
    let mut sitting = flying();
    let view = |sitting: &Sitting| (sitting.flight().observer().focus().zoom(), sitting.flight().observer().focus().fits());
    sitting.press_all(&[Key::Equal, Key::KpAdd]);
    assert!((view(&sitting).0 - 2.0).abs() < 1e-12, "{:?}", view(&sitting));
    sitting.press_keys(&[Key::Equal], &[Key::Shift, Key::Equal]);
    assert!((view(&sitting).0 - 8f64.sqrt()).abs() < 1e-12);
    sitting.give(Input { wheel: -1.0, ..Input::default() }).give(Input { wheel: -1.0, ..Input::default() });
    assert!((view(&sitting).0 - 2.0).abs() < 1e-12);
    sitting.press_all(&[Key::Minus, Key::KpSubtract, Key::Minus]);
    assert!((view(&sitting).0 - 0.5f64.sqrt()).abs() < 1e-12);
    sitting.press(Key::F);
    assert_eq!(view(&sitting), (1.0, true));
    sitting.press(Key::Equal).press(Key::F);
    assert_eq!(view(&sitting), (1.0, true), "F fits a view that was zoomed");
    sitting.press(Key::F);
    assert_eq!(view(&sitting), (1.0, false), "F follows again, as close as usual");
    assert!(!sitting.flight().is_assisted() && sitting.flight().observer().focus().length() == 1.0);
}

#[test]
fn the_wheel_over_the_rail_does_not_zoom() {
    let mut sitting = flying();
    sitting.press(Key::I);
    let pointer = sitting.flight().instruments().areas(&sitting.frame)[0].centre();
    sitting.give(Input { pointer, wheel: 1.0, ..Input::default() });
    assert_eq!(sitting.flight().observer().focus().zoom(), 1.0);
    sitting.give(Input { pointer: sitting.frame.size / 2.0, wheel: 1.0, ..Input::default() });
    assert!(sitting.flight().observer().focus().zoom() > 1.0);
}
