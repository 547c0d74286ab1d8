//! The menu: its buttons, its balls, and what Play opens.

use crate::sitting::{Sitting, board, enter};
use crate::support::shipped::{copy, project};
use resultant::draw::layout::{Area, Frame, Vec2};
use resultant::screens::{Input, Key};
use std::fs;
use std::path::Path;

#[test]
fn every_button_of_the_menu_leads_where_it_says_by_mouse_and_by_keyboard() {
    for (button, screen) in [
        ("Play", "flight"),
        ("Levels", "level select"),
        ("Boards", "leaderboards"),
        ("Editor", "levels to edit"),
        ("Classics", "classics"),
        ("Lab", "lab"),
        ("Settings", "settings"),
        ("Players", "new player"),
        ("Credits", "credits"),
    ] {
        assert_eq!(Sitting::new().click(button).at(), screen);
        assert_eq!(Sitting::new().choose(button).at(), screen);
    }
    let mut sitting = Sitting::new();
    let quit = sitting.area("Quit").centre();
    assert!(!sitting.give(Input { pointer: quit, click: true, ..Input::default() }).open);
    let mut sitting = Sitting::new();
    assert_eq!(sitting.press(Key::Up).focused(), "Quit", "the column goes round");
    assert!(!sitting.give(enter()).open);
    assert_eq!(Sitting::new().press_all(&[Key::Down; 6]).focused(), "Play");
}

#[test]
fn the_menu_remembers_what_was_chosen() {
    for button in ["Boards", "Players", "Settings", "Lab"] {
        let mut sitting = Sitting::new();
        assert_eq!(sitting.choose(button).press(Key::Escape).focused(), button);
    }
    let mut sitting = Sitting::new();
    sitting.click("More");
    assert_eq!(sitting.focused(), "Lab");
    assert_eq!(sitting.press(Key::Escape).focused(), "More");
}

#[test]
fn one_press_is_one_action_however_long_it_is_held() {
    let mut sitting = Sitting::new();
    sitting.press(Key::Down).give(enter()).hold(&[Key::Enter], 60);
    assert_eq!(sitting.at(), "level select", "Enter held does not choose a level as well");
    let mut sitting = Sitting::new();
    let pointer = sitting.area("Levels").centre();
    sitting.give(Input { pointer, click: true, holding: true, ..Input::default() });
    for _ in 0..60 {
        sitting.give(Input { pointer, holding: true, ..Input::default() });
    }
    assert_eq!(sitting.at(), "level select");
    let mut sitting = Sitting::new();
    sitting.hold(&[Key::Down], 1).wait(1.0);
    assert_eq!(sitting.focused(), "Play", "no press edge, no movement");
}

#[test]
fn a_right_click_in_the_menu_drops_a_ball_that_stays_in_the_window() {
    let mut sitting = Sitting::new();
    let drop_at = |sitting: &mut Sitting, pointer: Vec2| {
        sitting.give(Input { pointer, right_click: true, ..Input::default() });
        sitting.menu().balls().len()
    };
    assert_eq!(drop_at(&mut sitting, Vec2::new(100.0, 100.0)), 1);
    assert_eq!(drop_at(&mut sitting, Vec2::new(100.0, 100.0)), 2, "beside the first one");
    let button = sitting.area("Play").centre();
    assert_eq!(drop_at(&mut sitting, button), 3, "beside the button");
    assert_eq!(drop_at(&mut sitting, Vec2::new(-50.0, 9000.0)), 4, "at the window's edge");
    (0..100).for_each(|_| _ = drop_at(&mut sitting, Vec2::new(200.0, 300.0)));
    for size in [Vec2::new(1280.0, 720.0), Vec2::new(900.0, 500.0), Vec2::new(500.0, 700.0)] {
        sitting.frame = Frame::of_window(size);
        sitting.wait(1.0);
        let (balls, frame) = (sitting.menu().balls(), sitting.frame);
        let areas: Vec<Area> = sitting.areas().into_iter().chain(sitting.menu().lines.iter().copied()).collect();
        assert_eq!(sitting.menu().lines.len(), 4, "the level's title, who plays, the hint and the game's");
        assert!(balls.len() > 10, "{} balls", balls.len());
        for (i, ball) in balls.iter().enumerate() {
            let inside = ball.min.cmpge(Vec2::splat(-0.1)).all() && ball.max().cmple(frame.size + 0.1).all();
            assert!(inside, "{ball:?} has left {frame:?}");
            for other in areas.iter().chain(&balls[i + 1..]) {
                let overlap = ball.max().min(other.max()) - ball.min.max(other.min);
                assert!(overlap.min_element() < 0.1, "{ball:?} lies in {other:?}");
            }
        }
    }
}

#[test]
fn the_ship_hovers_over_the_buttons_by_its_own_engine() {
    let mut sitting = Sitting::new();
    for size in [Vec2::new(1280.0, 720.0), Vec2::new(600.0, 1000.0), Vec2::new(2400.0, 500.0)] {
        sitting.frame = Frame::of_window(size);
        sitting.wait(1.0);
        let (mut places, mut burnt) = (Vec::new(), 0.0);
        for _ in 0..20 * 60 {
            let (centre, angle, burning) = sitting.rest().menu().ship().expect("there is a ship");
            assert!(angle.abs() <= 31.0 && (0.0..=1.0).contains(&burning));
            places.push(centre);
            burnt += burning;
        }
        let first = sitting.area("Play");
        assert!(places.iter().all(|at| at.y < first.min.y && at.y > first.min.y - 120.0), "it has left its height");
        let (left, right) = places.iter().fold((f32::MAX, f32::MIN), |(a, b), at| (a.min(at.x), b.max(at.x)));
        assert!(right - left > 100.0 && left > first.min.x - 200.0 && right < first.max().x + 200.0, "{left} … {right}");
        assert!(burnt > 100.0, "nothing but the engine carries it");
    }
}

#[test]
fn a_ship_that_balls_knock_away_comes_back() {
    let mut sitting = Sitting::new();
    for i in 0..40 {
        let (ship, ..) = sitting.menu().ship().unwrap();
        let pointer = ship + Vec2::new(if i % 2 == 0 { 45.0 } else { -45.0 }, -20.0);
        sitting.give(Input { pointer, right_click: true, ..Input::default() }).wait(0.5);
    }
    sitting.wait(40.0);
    let (first, (ship, ..)) = (sitting.area("Play"), sitting.menu().ship().unwrap());
    assert!(ship.y < first.min.y, "the ship is at {ship}");
}

#[test]
fn balls_fly_differently_in_each_sitting() {
    let flown = |later: f64| {
        let mut sitting = Sitting::new();
        sitting.wait(later).give(Input { pointer: Vec2::new(100.0, 300.0), right_click: true, ..Input::default() }).wait(0.3);
        sitting.menu().balls()[0].min
    };
    assert_eq!(flown(0.5), flown(0.5), "nothing but when it is dropped decides");
    assert!(flown(0.5).distance(flown(0.6)) > 1.0);
}

#[test]
fn play_opens_the_first_level_that_the_player_has_not_done() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.choose("Play").flown(), "1");
    sitting.wait(1.5).home();
    assert!(sitting.row("Play").contains(&"2".to_owned()), "{:?}", sitting.row("Play"));
    assert_eq!(sitting.choose("Play").flown(), "2", "1 was completed, though no score was saved");
    sitting.reopen();
    assert_eq!(sitting.choose("Play").flown(), "2", "also in another sitting");
    let scored = |root: &Path| {
        fs::create_dir(root.join("scores")).unwrap();
        for level in ["1", "2", "3"] {
            fs::write(root.join(format!("scores/{level}.csv")), board(1)).unwrap();
        }
    };
    assert_eq!(Sitting::with(scored).choose("Play").flown(), "1", "nobody else's scores count");
}

#[test]
fn a_flight_for_gold_plays_behind_the_buttons_over_and_over() {
    let mut sitting = Sitting::with(|folder| copy(&project().join("levels/1"), &folder.join("levels/1")));
    sitting.wait(1.0);
    let (ticks, shown) = (sitting.scene().game.ticks(), sitting.scene().overlays.shown.status);
    assert!(ticks > 60 && !shown, "{ticks}");
    let mut latest = ticks;
    for _ in 0..60 * 30 {
        sitting.rest();
        let now = sitting.scene().game.ticks();
        if now < latest {
            break;
        }
        latest = now;
    }
    assert!(sitting.scene().game.ticks() < latest, "it begins again");
    assert_eq!(sitting.choose("Levels").at(), "level select");
}
