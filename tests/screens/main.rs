//! The screens without a window: every path between them by mouse and by keyboard, one action a press.

mod by_hand;
mod classics;
mod closing;
mod editor;
mod editor_flights;
mod editor_hand;
mod editor_links;
mod editor_share;
mod flight;
mod flights;
mod frames;
mod instruments;
mod keys;
mod lab;
mod languages;
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
#[path = "../lab/lessons/sheet.rs"]
mod sheet;
mod sitting;
#[path = "../support/mod.rs"]
mod support;
mod what_if;
mod worksheet;

use resultant::draw::layout::{Frame, Vec2};
use resultant::screens::Key;
use sitting::Sitting;

#[test]
fn esc_goes_back_everywhere() {
    let esc = |sitting: &mut Sitting| sitting.press(Key::Escape).at();
    assert_eq!(esc(&mut Sitting::new()), "menu", "the menu is where Esc ends");
    for button in ["Levels", "Boards", "Classics", "Lab", "Editor", "Settings", "Players", "Credits"] {
        assert_eq!(esc(Sitting::new().choose(button)), "menu");
    }
    assert_eq!(esc(Sitting::new().choose("More")), "menu");
    assert_eq!(esc(Sitting::new().become_new("ann").choose("Players")), "menu");
    assert_eq!(esc(Sitting::new().become_new("ann").choose("Players").choose("New Player")), "players");
    assert_eq!(esc(Sitting::new().choose("Levels").choose("broken")), "level select");
    assert_eq!(esc(Sitting::new().fly("2")), "pause");
    assert_eq!(esc(Sitting::new().fly("2").press(Key::Escape)), "flight");
    assert_eq!(esc(Sitting::new().fly("2").press(Key::Escape).choose("Settings")), "pause");
    assert_eq!(esc(Sitting::new().complete()), "level select");
    assert_eq!(esc(Sitting::new().complete().choose("Save Score")), "scoring");
    assert_eq!(esc(Sitting::new().save_as("ann")), "scoring");
    assert_eq!(esc(Sitting::new().choose("Boards").choose("1")), "leaderboards");
}

#[test]
fn every_screen_is_whole_in_every_window() {
    for (width, height) in [(900.0, 500.0), (1280.0, 720.0), (1920.0, 1080.0), (600.0, 1000.0), (3000.0, 500.0)] {
        let mut sitting = Sitting::new();
        sitting.frame = Frame::of_window(Vec2::new(width, height));
        let whole = Sitting::assert_whole;
        whole(&mut sitting);
        whole(sitting.choose("Levels"));
        whole(sitting.choose("2").press(Key::Escape));
        whole(sitting.choose("Settings"));
        whole(sitting.press(Key::Escape).choose("Main Menu").complete());
        whole(sitting.choose("Save Score"));
        whole(sitting.write("ann").press(Key::Enter).wait(0.6));
        whole(sitting.choose("Board"));
        whole(sitting.home().choose("Classics"));
        whole(sitting.press(Key::Escape).choose("Settings"));
        whole(sitting.press(Key::Escape).choose("Credits"));
        whole(sitting.press(Key::Escape).choose("Players"));
        whole(sitting.choose("New Player"));
    }
}
