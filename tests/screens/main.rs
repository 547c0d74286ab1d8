//! The screens as a player meets them, without a window: every way between them by mouse and by keyboard, one action a press.

mod classics;
mod editor;
mod flight;
mod flights;
mod frames;
mod instruments;
mod lab;
mod lesson;
mod levels;
mod loading;
mod menu;
mod observed;
mod pace;
mod players;
mod plot;
mod reload;
mod scores;
mod settings;
mod sitting;
#[path = "../support/mod.rs"]
mod support;
mod what_if;

use resultant::screens::Key;
use resultant::view::layout::{Frame, Vec2};
use sitting::Sitting;

#[test]
fn esc_goes_back_everywhere() {
    let esc = |sitting: &mut Sitting| sitting.press(Key::Escape).at();
    assert_eq!(esc(&mut Sitting::new()), "menu", "the menu is where Esc ends");
    assert_eq!(esc(Sitting::new().choose(1)), "menu");
    assert_eq!(esc(Sitting::new().choose(2)), "menu");
    assert_eq!(esc(Sitting::new().choose(3)), "menu");
    assert_eq!(esc(Sitting::new().choose(4)), "menu");
    assert_eq!(esc(Sitting::new().choose(7)), "menu");
    assert_eq!(esc(Sitting::new().become_new("ann").choose(7)), "menu");
    assert_eq!(esc(Sitting::new().become_new("ann").choose(7).choose(1)), "players");
    assert_eq!(esc(Sitting::new().choose(8)), "menu");
    assert_eq!(esc(Sitting::new().choose(1).choose(4)), "level select");
    assert_eq!(esc(Sitting::new().fly(1)), "pause");
    assert_eq!(esc(Sitting::new().fly(1).press(Key::Escape)), "flight");
    assert_eq!(esc(Sitting::new().complete()), "menu");
    assert_eq!(esc(Sitting::new().reach_save_score()), "scoring");
    assert_eq!(esc(Sitting::new().reach_save_score().write("ann").press(Key::Enter)), "menu");
    assert_eq!(esc(Sitting::new().choose(2).choose(0)), "leaderboards");
}

#[test]
fn every_back_button_goes_back_by_mouse() {
    assert_eq!(Sitting::new().click(1).click(5).at(), "menu");
    assert_eq!(Sitting::new().click(2).click(0).click(2).at(), "leaderboards");
    assert_eq!(Sitting::new().click(3).click(3).at(), "menu");
}

#[test]
fn every_screen_is_whole_in_every_window() {
    for (width, height) in [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0), (600.0, 1000.0), (3000.0, 500.0)] {
        let frame = Frame::of_window(Vec2::new(width, height));
        let mut sitting = Sitting::new();
        sitting.frame = frame;
        let whole = |sitting: &mut Sitting| {
            let areas = sitting.rest().buttons().areas().to_vec();
            for (i, area) in areas.iter().enumerate() {
                assert!(area.min.min_element() >= 0.0 && area.max().cmple(frame.size).all(), "{} {area:?}", sitting.at());
                for other in &areas[i + 1..] {
                    let apart = area.max().cmple(other.min).any() || other.max().cmple(area.min).any();
                    assert!(apart, "{}: {area:?} and {other:?} overlap", sitting.at());
                }
            }
        };
        whole(&mut sitting);
        whole(sitting.choose(1));
        whole(sitting.choose(1).press(Key::Escape));
        whole(sitting.choose(2));
        whole(sitting.press(Key::Escape).choose(4).complete());
        whole(sitting.choose(2));
        whole(sitting.write("ann").press(Key::Enter));
        whole(sitting.press(Key::Escape).choose(3));
        whole(sitting.press(Key::Escape).choose(8));
        whole(sitting.press(Key::Escape).choose(7));
        whole(sitting.choose(2));
    }
}
