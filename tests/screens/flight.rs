//! A flight: its keys, its pause panel, its end, and who watches it.

use crate::sitting::{FAR_AWAY, Sitting, enter, level};
use resultant::game::Outcome;
use resultant::screens::{Input, Key, Spectator};
use std::fs;
use std::path::Path;

#[test]
fn the_pause_panel_does_what_it_says_by_mouse_and_by_keyboard() {
    let away = [("Settings", "settings in flight"), ("Level Select", "level select"), ("Main Menu", "menu")];
    for (button, screen) in [("Resume", "flight"), ("Restart", "flight")].into_iter().chain(away) {
        let mut sitting = Sitting::new();
        assert_eq!(sitting.fly("2").wait(0.5).press(Key::Escape).at(), "pause");
        let ticks = sitting.ticks();
        assert!(ticks > 50);
        assert_eq!(sitting.wait(0.5).flight().game().ticks(), ticks, "time stands still");
        assert_eq!(sitting.click(button).at(), screen);
        let mut sitting = Sitting::new();
        assert_eq!(sitting.fly("2").wait(0.5).press(Key::Escape).choose(button).at(), screen);
        if button == "Resume" {
            assert!(sitting.ticks() >= ticks, "resumed");
        } else if button == "Restart" {
            assert!(sitting.ticks() < 10, "restarted");
        }
    }
    assert_eq!(Sitting::new().fly("2").press(Key::Escape).press(Key::Escape).at(), "flight", "Esc resumes");
}

#[test]
fn keys_of_the_game_act_once_a_press() {
    let mut sitting = Sitting::new();
    sitting.fly("2");
    let overlays = |sitting: &Sitting| (sitting.scene().overlays.details, sitting.scene().overlays.hitboxes);
    assert_eq!(overlays(sitting.press(Key::Tab)), (true, false));
    assert_eq!(overlays(sitting.press(Key::F3)), (true, true));
    sitting.wait(0.5).press(Key::R);
    assert!(sitting.ticks() < 10, "restarted");
    assert_eq!(overlays(&sitting), (true, true), "a restart keeps the overlays");
    assert_eq!(overlays(sitting.press(Key::Escape).press(Key::Tab)), (false, true), "also while paused");
}

#[test]
fn an_attempt_that_ends_comes_to_its_score_after_a_moment() {
    let mut sitting = Sitting::new();
    sitting.fly("1").wait(0.3);
    assert_eq!(sitting.at(), "flight", "the end can be seen");
    assert_eq!(sitting.wait(1.0).at(), "scoring");
    assert!(sitting.scoring().result.score.total > 10_000);
    let mut sitting = Sitting::new();
    assert_eq!(sitting.fly("1").wait(0.1).press(Key::Escape).at(), "scoring", "Esc need not wait");
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
    (0..30).for_each(|_| _ = sitting.give_to(Input::default(), &mut count));
    assert_eq!((count.0, u64::from(count.1)), (1, count.2));
    sitting.give_to(Input { pressed: [Key::R].into_iter().collect(), ..Input::default() }, &mut count);
    assert_eq!(count.0, 2, "a restart is another attempt");
}

/// Level 3 is lost by its first tick.
#[test]
fn from_death_to_flying_again_it_is_one_key_also_on_the_screen_that_follows() {
    let mut sitting = Sitting::new();
    sitting.fly("3").wait(0.1);
    assert_eq!(sitting.press(Key::R).at(), "flight");
    assert!(sitting.ticks() <= 2, "a fresh attempt at once");
    sitting.press(Key::Enter);
    assert_eq!(sitting.at(), "scoring");
    assert!(sitting.shows("Touched a red box"), "{:?}", sitting.texts());
    assert_eq!(sitting.press(Key::R).at(), "flight");
}

/// A level in which the ship has to turn and thrust to get to the red.
fn with_red_above(root: &Path) {
    level(root, "2", FAR_AWAY, "0,240,800,20\n");
    fs::write(root.join("levels/2/world.csv"), "x,y,width,height\n0,325.5,800,20\n").unwrap();
}

#[test]
fn after_a_death_the_level_flies_within_half_a_second_and_keys_that_are_held_wait() {
    let mut sitting = Sitting::with(with_red_above);
    sitting.fly("2");
    let lost = |sitting: &Sitting| sitting.game().outcome() == Outcome::Failed;
    sitting.hold_until(&[Key::Space], lost);
    let frames = (1..=60).find(|_| {
        sitting.hold(&[Key::Space], 1);
        !lost(&sitting) && sitting.ticks() > 0
    });
    assert!(frames.is_some_and(|frames| frames < 30), "flies again after {frames:?} frames of 1/60 s");
    assert_eq!(sitting.game().ship().burning, 0, "thrust is held from before");
    assert!(sitting.flight().lost().is_some_and(|death| death.contains("Touched a red box")), "{:?}", sitting.flight().lost());
    sitting.press(Key::Enter);
    assert_eq!(sitting.at(), "scoring");
    assert_eq!((sitting.scoring().result.outcome, sitting.scoring().result.score.total), (Outcome::Failed, 0));
    assert!(sitting.scoring().result.time > 0.2 && sitting.shows("Touched a red box"));
    assert_eq!(sitting.scores_file("attempts.csv").lines().filter(|line| line.contains(",failed,")).count(), 1);
    sitting.wait(0.5).choose("Watch").wait(0.2);
    assert_eq!(sitting.game().level().name, "2");
    assert!(sitting.flight().history().ticks() > 24, "{}", sitting.flight().history().ticks());
}

#[test]
fn what_is_told_of_a_death_goes_by_itself_and_enter_flies_on_then() {
    let mut sitting = Sitting::with(with_red_above);
    sitting.fly("2");
    sitting.hold_until(&[Key::Space], |sitting| sitting.flight().lost().is_some());
    assert!(sitting.wait(6.0).flight().lost().is_none());
    assert_eq!(sitting.press(Key::Enter).at(), "flight");
}

#[test]
fn keys_of_the_flight_move_nothing_on_the_page_that_follows() {
    let right = &[Key::Right];
    let mut sitting = Sitting::new();
    sitting.fly("1").hold_until(right, |sitting| sitting.at() != "flight");
    let focus = sitting.focused().to_owned();
    // Pressed once more, and held for longer than the page has a guard: it is the hand of the flight still.
    sitting.press_keys(right, right).hold(right, 60).press_keys(right, right);
    assert_eq!(sitting.focused(), focus);
    sitting.rest().press(Key::Right);
    assert_ne!(sitting.focused(), focus, "once it was let go, it chooses");
}

#[test]
fn the_pause_panel_gives_a_level_s_hints_one_at_a_time_after_three_losses() {
    let hints = "text\n\"Red kills, grey does not.\"\nThe pad is to the left.\n";
    let mut sitting = Sitting::with(|root| fs::write(root.join("levels/3/hints.csv"), hints).unwrap());
    let offered = |sitting: &Sitting| sitting.labels().contains(&"Hint");
    sitting.fly("3");
    (0..2).for_each(|_| _ = sitting.wait(0.1).press(Key::R));
    assert!(!offered(sitting.press(Key::Escape)), "two losses are not enough: {:?}", sitting.labels());
    sitting.press(Key::Escape).wait(0.1).press(Key::R);
    assert!(sitting.shows("H: a hint"), "{:?}", sitting.texts());
    assert!(offered(sitting.press(Key::Escape)));
    assert!(!sitting.shows("Red kills"), "on demand");
    sitting.choose("Hint");
    assert!(sitting.shows("Red kills, grey does not.") && !sitting.shows("to the left"), "{:?}", sitting.texts());
    sitting.choose("Hint");
    assert!(sitting.shows("The pad is to the left.") && !offered(&sitting), "there are no more");
    sitting.choose("Resume").press(Key::Escape);
    assert!(sitting.shows("The pad is to the left."), "what was given stays readable");
}

#[test]
fn a_hint_is_offered_after_three_restarts_of_any_length_or_ninety_seconds_and_its_key_gives_it() {
    let with_hint = || Sitting::with(|root| fs::write(root.join("levels/2/hints.csv"), "text\nThe pad is up there.\n").unwrap());
    let offers = |sitting: &Sitting| sitting.shows("H: a hint");
    let mut sitting = with_hint();
    sitting.fly("2");
    for _ in 0..3 {
        assert!(!offers(sitting.press(Key::H)) && sitting.at() == "flight");
        sitting.hold(&[Key::Space], 6).press(Key::R);
    }
    assert!(offers(sitting.rest()) && !sitting.shows("up there"));
    assert_eq!(sitting.press(Key::H).at(), "pause");
    assert!(sitting.shows("The pad is up there."));
    assert!(!offers(sitting.press(Key::Escape)), "there are no more");
    let mut sitting = with_hint();
    assert!(!offers(sitting.fly("2").wait(80.0)));
    assert!(offers(sitting.wait(11.0)));
}

#[test]
fn a_level_introduces_itself_once_and_any_key_ends_that() {
    let words = "any key starts the flight";
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(0.5);
    assert!(sitting.shows("Level 2") && sitting.shows(words), "{:?}", sitting.texts());
    assert!(sitting.scene().overlays.map && !sitting.scene().overlays.shown.status && sitting.game().is_idle());
    sitting.hold(&[Key::Space], 2).press(Key::Space);
    assert!(!sitting.shows(words) && !sitting.scene().overlays.map && sitting.scene().overlays.shown.status);
    assert!(sitting.game().ship().fuel < 500.0, "the key has flown");
    assert!(!sitting.press(Key::R).shows(words), "not again");
    let mut sitting = Sitting::new();
    sitting.fly("2").wait(2.1);
    assert!(!sitting.shows(words) && !sitting.scene().overlays.map, "it ends by itself");
}

#[test]
fn an_overview_lasts_until_the_first_key() {
    let mut sitting = Sitting::with(|root| {
        fs::write(root.join("levels/2/constants.csv"), "width,800\nheight,600\noverview,1\n").unwrap();
    });
    sitting.fly("2").wait(5.0);
    assert!(sitting.scene().overlays.map && sitting.scene().overlays.shown.status);
    assert!(!sitting.hold(&[Key::Space], 3).scene().overlays.map);
}

#[test]
fn who_has_not_completed_a_level_sees_no_clock_of_medals() {
    let timed = "width,800\nheight,600\nsilver,5\ngold,3\n";
    let mut sitting = Sitting::with(|root| {
        ["1", "2"].iter().for_each(|level| fs::write(root.join(format!("levels/{level}/constants.csv")), timed).unwrap());
    });
    sitting.fly("2").press(Key::Left);
    assert!(!sitting.scene().overlays.shown.medal);
    sitting.press(Key::Escape).choose("Main Menu").complete().home().fly("1").press(Key::Left);
    assert!(sitting.scene().overlays.shown.medal);
}

#[test]
fn backspace_flies_backwards_and_the_flight_goes_on_from_there_as_practice() {
    for rewinds in [Key::Backspace, Key::PadL1] {
        let mut sitting = Sitting::new();
        sitting.fly("2").hold(&[Key::Space], 30);
        let early = (sitting.ticks(), sitting.flight().history().clone());
        sitting.hold(&[Key::Right], 30);
        assert!(!sitting.flight().is_assisted());
        let late = sitting.ticks();
        sitting.hold(&[rewinds], 15);
        assert!(sitting.shows("Rewinding"), "{:?}", sitting.texts());
        let back = sitting.ticks();
        assert!(back < late - 20, "{back} of {late}");
        sitting.hold(&[rewinds], 18);
        let now = sitting.ticks();
        assert!(now < back);
        assert_eq!(sitting.game().hash(), early.1.at(now.min(early.0)).hash(), "the state is the one that was flown");
        sitting.wait(0.2);
        assert!(sitting.ticks() > now && sitting.flight().history().ticks() == sitting.ticks());
        assert!(sitting.flight().is_assisted() && sitting.shows("Practice"), "{:?}", sitting.texts());
        sitting.hold(&[rewinds], 180);
        assert_eq!(sitting.ticks(), 0, "up to its start");
        sitting.press(Key::R).wait(0.1);
        assert!(!sitting.flight().is_assisted() && !sitting.shows("Practice"), "a fresh flight counts");
    }
}

#[test]
fn a_rewound_flight_is_done_with_help_and_cannot_be_saved() {
    let mut sitting = Sitting::with(|root| {
        level(root, "1", "PLAYER,380,280,40,40,1\n", "");
        fs::write(root.join("levels/1/world.csv"), "x,y,width,height\n0,325.5,800,20\n").unwrap();
    });
    sitting.fly("1").wait(0.5).hold(&[Key::Backspace], 12).wait(3.5);
    assert_eq!(sitting.at(), "scoring");
    assert!(sitting.shows("with help") && !sitting.labels().contains(&"Save Score"), "{:?}", sitting.texts());
}

#[test]
fn backspace_takes_back_a_loss() {
    let mut sitting = Sitting::with(with_red_above);
    sitting.fly("2");
    let lost = |sitting: &Sitting| sitting.game().outcome() == Outcome::Failed;
    sitting.hold_until(&[Key::Space], lost);
    let end = sitting.ticks();
    sitting.wait(0.5);
    assert!(sitting.ticks() < end && !lost(&sitting), "the level is back");
    sitting.hold(&[Key::Backspace], 6);
    let ticks = sitting.ticks();
    assert!(ticks < end && ticks + 40 > end, "{ticks} of {end}");
    assert_eq!(sitting.wait(0.05).flight().game().outcome(), Outcome::Running);
}

#[test]
fn m_shows_the_whole_level_while_it_is_held() {
    let mut sitting = Sitting::new();
    sitting.fly("2").press(Key::Left).hold(&[Key::M], 6);
    assert!(sitting.scene().overlays.map);
    assert!(!sitting.rest().scene().overlays.map);
}

#[test]
fn a_goal_that_is_met_slows_the_picture_down_and_changes_no_tick() {
    let in_turn = "PLAYER,380,280,40,40,0.001,1\nPLAYER,10,10,20,20,0,2\n";
    let mut sitting = Sitting::with(|root| level(root, "2", in_turn, ""));
    sitting.fly("2").rest();
    assert!(sitting.scene().speed < 1.0);
    let begun = sitting.ticks();
    sitting.wait(0.3);
    let slow = sitting.ticks() - begun;
    assert!((8..24).contains(&slow), "{slow} ticks in 0.3 s");
    sitting.wait(0.5);
    assert_eq!(sitting.scene().speed, 1.0);
    let (game, history) = (sitting.game(), sitting.flight().history());
    let mut again = resultant::game::Game::new(game.shared_level().clone()).unwrap();
    history.inputs().after(0).for_each(|controls| again.step(controls));
    assert_eq!(again.hash(), game.hash());
}
