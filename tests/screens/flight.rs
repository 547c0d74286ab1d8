//! A flight: its keys, its pause panel, its end, and who watches it.

use crate::sitting::{Sitting, enter};
use resultant::screens::{Input, Key, Spectator};

#[test]
fn the_pause_panel_does_what_it_says_by_mouse_and_by_keyboard() {
    for (index, screen) in [(0, "flight"), (1, "flight"), (2, "settings in flight"), (3, "level select"), (4, "menu")] {
        let mut sitting = Sitting::new();
        assert_eq!(sitting.fly(1).wait(0.5).press(Key::Escape).at(), "pause");
        let ticks = sitting.flight().game().ticks();
        assert!(ticks > 50);
        assert_eq!(sitting.wait(0.5).flight().game().ticks(), ticks, "time stands still");
        assert_eq!(sitting.click(index).at(), screen);

        let mut sitting = Sitting::new();
        assert_eq!(sitting.fly(1).wait(0.5).press(Key::Escape).choose(index).at(), screen);
        if index == 0 {
            assert!(sitting.flight().game().ticks() >= ticks, "resumed");
        } else if index == 1 {
            assert!(sitting.flight().game().ticks() < 10, "restarted");
        }
    }
    assert_eq!(Sitting::new().fly(1).press(Key::Escape).press(Key::Escape).at(), "flight", "Esc resumes");
}

#[test]
fn keys_of_the_game_act_once_a_press() {
    let mut sitting = Sitting::new();
    sitting.fly(1);
    let overlays = |sitting: &Sitting| (sitting.flight().details(), sitting.flight().hitboxes());
    assert_eq!(overlays(sitting.press(Key::Tab)), (true, false));
    assert_eq!(overlays(sitting.press(Key::F3)), (true, true));
    sitting.wait(0.5).press(Key::R);
    assert!(sitting.flight().game().ticks() < 10, "restarted");
    assert_eq!(overlays(&sitting), (true, true), "a restart keeps the overlays");
    assert_eq!(overlays(sitting.press(Key::Escape).press(Key::Tab)), (false, true), "also while paused");
}

#[test]
fn a_press_shorter_than_a_frame_reaches_the_ship_once() {
    let mut sitting = Sitting::new();
    sitting.fly(1);
    let full = sitting.flight().game().ship().fuel;
    // Frames without a tick first: the press waits for one.
    sitting.give(Input { pressed: [Key::Space].into_iter().collect(), frame_time: 1e-9, ..Input::default() });
    assert_eq!(sitting.flight().game().ship().fuel, full);
    sitting.rest();
    let after_one = sitting.flight().game().ship().fuel;
    assert!(after_one < full, "the press was lost");
    assert_eq!(sitting.wait(0.2).flight().game().ship().fuel, after_one, "the press was repeated");
}

#[test]
fn the_keys_are_those_of_the_controls() {
    for (key, sign) in [(Key::Right, 1.0), (Key::Left, -1.0)] {
        let mut sitting = Sitting::new();
        let angle = sitting.fly(1).press(key).flight().game().ship().angle;
        assert!(angle * sign > 0.0, "{key:?} turned the ship to {angle}°");
    }
    for (key, burning) in [(Key::Space, 1), (Key::Shift, -1)] {
        let mut sitting = Sitting::new();
        sitting.fly(1).give(Input { held: [key].into_iter().collect(), ..Input::default() });
        assert_eq!(sitting.flight().game().ship().burning, burning, "{key:?}");
    }
}

#[test]
fn an_attempt_that_ends_comes_to_its_score_after_a_moment() {
    let mut sitting = Sitting::new();
    sitting.fly(0).wait(0.3);
    assert_eq!(sitting.at(), "flight", "the end can be seen");
    assert_eq!(sitting.wait(1.0).at(), "scoring");
    assert!(sitting.scoring().result().score.total > 10_000);

    let mut sitting = Sitting::new();
    assert_eq!(sitting.fly(0).wait(0.1).press(Key::Escape).at(), "scoring", "Esc need not wait");
}

#[test]
fn a_spectator_sees_every_attempt_and_every_tick() {
    #[derive(Default)]
    struct Count(u32, u32, u64);
    impl Spectator for Count {
        fn begins(&mut self, _game: &resultant::game::Game) {
            self.0 += 1;
        }
        fn before_tick(&mut self) {
            self.1 += 1;
        }
        fn after_tick(&mut self, game: &resultant::game::Game) {
            self.2 = game.ticks();
        }
    }
    let mut count = Count::default();
    let mut sitting = Sitting::new();
    sitting.press(Key::Down).press(Key::Enter).press(Key::Right).give_to(enter(), &mut count);
    assert_eq!(sitting.at(), "flight");
    for _ in 0..30 {
        sitting.give_to(Input::default(), &mut count);
    }
    assert_eq!((count.0, u64::from(count.1)), (1, count.2));
    sitting.give_to(Input { pressed: [Key::R].into_iter().collect(), ..Input::default() }, &mut count);
    assert_eq!(count.0, 2, "a restart is another attempt");
}

/// Level 3 is lost by its first tick.
#[test]
fn from_death_to_flying_again_it_is_one_key_also_on_the_screen_that_follows() {
    let mut sitting = Sitting::new();
    sitting.fly(2).wait(0.1);
    assert_eq!(sitting.press(Key::R).at(), "flight");
    assert!(sitting.flight().game().ticks() <= 2, "a fresh attempt at once");
    sitting.wait(2.0);
    assert_eq!(sitting.at(), "scoring");
    assert!(sitting.scoring().remark().contains("Touched a red box at x = "), "{}", sitting.scoring().remark());
    assert_eq!(sitting.press(Key::R).at(), "flight");
}
