//! Two methods side by side.

use super::*;
use resultant::lab::side_by_side::exhibits;

#[test]
fn two_methods_run_side_by_side_and_part() {
    let mut sitting = lab_at("Side by side");
    sitting.press(Key::R).wait(30.0);
    let page = |sitting: &Sitting| {
        let page = &lab(sitting).side_by_side;
        let [left, right] = page.halves();
        (page.exhibit().title, left.method, right.method, left.error, right.error, page.time())
    };
    let (first, left, right, wrong, exact, time) = page(&sitting);
    assert_eq!((left, right), ("snap to the floor", "shipped engine"));
    assert!((time - 30.0).abs() < 0.1, "{time}");
    assert!(wrong > 0.01 && exact < 1e-6, "{wrong} m and {exact} m after {time} s");
    // Each half has its own two keys, and its own two buttons.
    let methods = exhibits()[0].methods.iter().map(|(name, _)| *name).collect::<Vec<_>>();
    let last = methods.len() - 1;
    for (key, button, expected) in [
        (Key::D, "Next method, left", (methods[1], methods[last])),
        (Key::A, "Method before, left", (methods[last], methods[last])),
        (Key::Right, "Next method, right", (methods[0], methods[0])),
        (Key::Left, "Method before, right", (methods[0], methods[last - 1])),
    ] {
        let both = |sitting: &Sitting| (page(sitting).1, page(sitting).2);
        sitting.press(Key::Down).press(Key::Up).wait(0.5);
        assert_eq!(both(sitting.press(key)), expected, "{key:?}");
        assert!(page(&sitting).5 < 0.1, "it starts again");
        sitting.press(Key::Down).press(Key::Up);
        assert_eq!(both(sitting.click(button)), expected, "{button}");
        assert!(sitting.shows(expected.0) && sitting.shows(expected.1));
    }
    let mut titles = vec![first];
    while page(sitting.press(Key::Down)).0 != first {
        titles.push(page(&sitting).0);
        assert!(titles.len() < 20);
        let spring = page(&sitting).0 == "A body on a spring goes round";
        assert!(!spring || sitting.rest().shows("It uses what holds at the start"), "of explicit Euler");
    }
    assert_eq!(titles, exhibits().iter().map(|exhibit| exhibit.title).collect::<Vec<_>>());
    assert_eq!(page(sitting.press(Key::Up)).0, titles[titles.len() - 1]);
}

#[test]
fn it_pauses_ends_and_starts_again() {
    let mut sitting = lab_at("Side by side");
    sitting.press(Key::Down).wait(1.0);
    let time = |sitting: &Sitting| lab(sitting).side_by_side.time();
    sitting.press(Key::Space);
    let stopped = time(&sitting);
    assert!(stopped > 0.9 && lab(&sitting).side_by_side.is_paused());
    assert_eq!(time(sitting.wait(1.0)), stopped);
    assert!(time(sitting.press(Key::Space).wait(0.5)) > stopped);
    let end = lab(&sitting).side_by_side.exhibit().seconds;
    sitting.wait(end);
    assert!(lab(&sitting).side_by_side.is_over() && (time(&sitting) - end).abs() < 0.02);
    let [left, right] = lab(&sitting).side_by_side.halves();
    assert!(left.error > 0.3 && right.error < 1e-6, "they stay where they are: {left:?} {right:?}");
    assert!(time(sitting.press(Key::R)) < 0.1 && !lab(&sitting).side_by_side.is_over());
    // A hitch is no leap.
    let before = time(&sitting);
    sitting.give(Input { frame_time: 1e9, ..Input::default() });
    assert!(time(&sitting) - before < 0.2);
}

#[test]
fn it_goes_on_by_single_steps_of_any_length_and_remembers_the_way() {
    let mut sitting = lab_at("Side by side");
    sitting.press(Key::R).press(Key::Space);
    let page = |sitting: &Sitting| {
        let page = &lab(sitting).side_by_side;
        let [left, right] = page.halves();
        (page.step(), page.time(), page.is_paused(), left.trail.len(), left.errors.to_vec(), right.error)
    };
    let before = page(&sitting);
    for single in 1..=90 {
        let after = page(sitting.press(Key::Period));
        assert!((after.1 - before.1 - f64::from(single) * after.0).abs() < 1e-9 && after.2, "{} s", after.1);
    }
    let (step, time, paused, trail, errors, ours) = page(&sitting);
    assert!(paused && trail >= 90 && time >= 1.5 && ours < 1e-9);
    // One in each part of the scene that has begun, and the fall is wrong from the first step on.
    assert_eq!(errors.len(), (time / 60.0 * 400.0 - 1e-9).ceil() as usize);
    assert!(errors[0] > 0.0 && errors.iter().all(|error| error.is_finite()));
    let mut met = vec![step];
    for _ in 0..4 {
        let (step, time, _, trail, errors, _) = page(sitting.press(Key::S).press(Key::Space));
        assert!(time <= 0.1 + step && trail as f64 * step <= time + 1e-9 && errors.len() <= 2, "it starts again: {time} s");
        assert!(!met.contains(&step));
        met.push(step);
        sitting.press(Key::Space).wait(2.0);
        assert!(page(&sitting).5 < 1e-9, "the engine is right at any step");
    }
    assert_eq!(page(sitting.press(Key::S)).0, met[0]);
}
