//! The screens as a player meets them, without a window: every way between them by mouse and by keyboard, one action a press.

use resultant::scores::Scores;
use resultant::screens::{App, Buttons, Effect, Input, Key, LevelSelect, Places, Press, Purpose, Screen, Spectator};
use resultant::view::layout::{Area, Frame, Vec2};
use std::fs;
use std::path::Path;

/// A sitting with levels of its own: `1` is completed by its first tick, `2` lasts, `3` is lost by its first tick, `10` lasts too,
/// `broken` does not load.
struct Sitting {
    app: App,
    frame: Frame,
    folder: tempfile::TempDir,
    open: bool,
}

const PLAYER: &str = "x,y,mass,fuel,thrust\n400,300,100,500,3000\n";
const HERE: &str = "PLAYER,380,280,40,40\n";
const FAR_AWAY: &str = "PLAYER,10,10,20,20\n";

impl Sitting {
    fn new() -> Self {
        Self::with(|_| {})
    }

    fn with(prepare: impl FnOnce(&Path)) -> Self {
        let folder = tempfile::tempdir().unwrap();
        level(folder.path(), "1", HERE, "");
        level(folder.path(), "2", FAR_AWAY, "");
        level(folder.path(), "3", FAR_AWAY, "380,280,40,40\n");
        level(folder.path(), "10", FAR_AWAY, "");
        level(folder.path(), "broken", FAR_AWAY, "380,280,wide,40\n");
        prepare(folder.path());
        let root = folder.path().to_path_buf();
        let places = Places { levels: root.join("levels"), scores: root.join("scores"), root };
        let mut sitting = Self { app: App::new(places), frame: Frame::default(), folder, open: true };
        sitting.rest();
        sitting
    }

    /// One frame.
    fn give(&mut self, input: Input) -> &mut Self {
        self.give_to(input, &mut ())
    }

    fn give_to(&mut self, input: Input, spectator: &mut dyn Spectator) -> &mut Self {
        assert!(self.open, "the window is closed");
        let frame_time = if input.frame_time > 0.0 { input.frame_time } else { 1.0 / 60.0 };
        self.open = self.app.update(&Input { frame: self.frame, frame_time, ..input }, spectator);
        self
    }

    /// A frame without input.
    fn rest(&mut self) -> &mut Self {
        self.give(Input::default())
    }

    fn wait(&mut self, seconds: f64) -> &mut Self {
        for _ in 0..(seconds * 60.0).ceil() as u32 {
            self.rest();
        }
        self
    }

    /// A key goes down and up again.
    fn press(&mut self, key: Key) -> &mut Self {
        let keys = [key].into_iter().collect();
        self.give(Input { pressed: keys, held: keys, ..Input::default() })
    }

    fn press_all(&mut self, keys: &[Key]) -> &mut Self {
        for key in keys {
            self.press(*key);
        }
        self
    }

    fn write(&mut self, text: &str) -> &mut Self {
        self.give(Input { typed: text.into(), ..Input::default() })
    }

    fn point_at(&mut self, pointer: Vec2) -> &mut Self {
        self.give(Input { pointer, ..Input::default() })
    }

    fn click_at(&mut self, pointer: Vec2) -> &mut Self {
        self.point_at(pointer).give(Input { pointer, click: true, holding: true, ..Input::default() }).point_at(pointer)
    }

    /// Clicks a button of the screen by its index.
    fn click(&mut self, index: usize) -> &mut Self {
        let at = self.buttons().areas()[index].centre();
        self.click_at(at)
    }

    /// Presses a button of the screen by arrows and Enter.
    fn choose(&mut self, index: usize) -> &mut Self {
        for _ in 0..20 {
            let (areas, focus) = (self.buttons().areas().to_vec(), self.buttons().focus());
            if focus == index {
                return self.press(Key::Enter);
            }
            let way = areas[index].centre() - areas[focus].centre();
            let key = match (way.x.abs() > way.y.abs(), way.x > 0.0, way.y > 0.0) {
                (true, true, _) => Key::Right,
                (true, false, _) => Key::Left,
                (false, _, true) => Key::Down,
                (false, _, false) => Key::Up,
            };
            self.press(key);
        }
        panic!("the arrows do not lead to button {index}");
    }

    fn buttons(&self) -> &Buttons {
        match self.app.screen() {
            Screen::Menu(screen) => screen.buttons(),
            Screen::LevelSelect(screen) => screen.buttons(),
            Screen::Flight(screen) => screen.pause().expect("the pause panel is open"),
            Screen::Scoring(screen) => screen.buttons(),
            Screen::SaveScore(screen) => screen.buttons(),
            Screen::Leaderboard(screen) => screen.buttons(),
            Screen::Classics(screen) => screen.buttons(),
            Screen::Lab(screen) => screen.toolbar().buttons(),
            Screen::TileRun(screen) => screen.toolbar().buttons(),
            Screen::Jumper(screen) => screen.buttons().expect("the panel is open"),
            Screen::Pi(screen) => screen.toolbar().buttons(),
        }
    }

    fn at(&self) -> &'static str {
        match self.app.screen() {
            Screen::Menu(_) => "menu",
            Screen::LevelSelect(screen) if screen.problems().is_some() => "problems",
            Screen::LevelSelect(screen) => match screen.purpose() {
                Purpose::Play => "level select",
                Purpose::Leaderboard => "leaderboards",
            },
            Screen::Flight(screen) if screen.pause().is_some() => "pause",
            Screen::Flight(_) => "flight",
            Screen::Scoring(_) => "scoring",
            Screen::SaveScore(_) => "save score",
            Screen::Leaderboard(_) => "leaderboard",
            Screen::Classics(_) => "classics",
            Screen::Lab(_) => "lab",
            Screen::TileRun(_) => "tile run",
            Screen::Jumper(_) => "jumper",
            Screen::Pi(_) => "pi",
        }
    }

    fn level_select(&self) -> &LevelSelect {
        let Screen::LevelSelect(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    fn flight(&self) -> &resultant::screens::Flight {
        let Screen::Flight(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    fn scoring(&self) -> &resultant::screens::Scoring {
        let Screen::Scoring(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    fn leaderboard(&self) -> &resultant::screens::Leaderboard {
        let Screen::Leaderboard(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    fn save_score(&self) -> &resultant::screens::SaveScore {
        let Screen::SaveScore(screen) = self.app.screen() else { panic!("at {}", self.at()) };
        screen
    }

    /// From the menu into a level, by its index in the list.
    fn fly(&mut self, index: usize) -> &mut Self {
        self.choose(1).choose(index)
    }

    /// From the menu to the score of level 1.
    fn complete(&mut self) -> &mut Self {
        self.fly(0).wait(1.5);
        assert_eq!(self.at(), "scoring");
        self
    }

    /// From the menu to the field for the name.
    fn reach_save_score(&mut self) -> &mut Self {
        let save = self.complete().scoring().presses().iter().position(|press| *press == Press::SaveScore).unwrap();
        self.choose(save)
    }
}

fn level(root: &Path, name: &str, objectives: &str, obstacles: &str) {
    let folder = root.join("levels").join(name);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("constants.csv"), "width,800\nheight,600\noptimal_time,10\n").unwrap();
    fs::write(folder.join("player.csv"), PLAYER).unwrap();
    fs::write(folder.join("objectives.csv"), objectives).unwrap();
    fs::write(folder.join("obstacles.csv"), obstacles).unwrap();
}

fn board(rows: usize) -> String {
    let rows: String = (0..rows).map(|i| format!("user{i},{}\n", 20_000 - 100 * i)).collect();
    format!("name,score\n{rows}")
}

#[test]
fn every_button_of_the_menu_leads_where_it_says_by_mouse_and_by_keyboard() {
    for (index, screen) in [(0, "flight"), (1, "level select"), (2, "leaderboards"), (3, "classics"), (4, "lab")] {
        assert_eq!(Sitting::new().click(index).at(), screen);
        assert_eq!(Sitting::new().choose(index).at(), screen);
    }
    let mut sitting = Sitting::new();
    let quit = sitting.rest().buttons().areas()[5].centre();
    assert!(!sitting.give(Input { pointer: quit, click: true, ..Input::default() }).open);
    let mut sitting = Sitting::new();
    sitting.press_all(&[Key::Down; 9]);
    assert_eq!(sitting.buttons().focus(), 5, "the arrows stop at the last button");
    assert!(!sitting.give(enter()).open);
}

fn enter() -> Input {
    Input { pressed: [Key::Enter].into_iter().collect(), held: [Key::Enter].into_iter().collect(), ..Input::default() }
}

#[test]
fn one_press_is_one_action_however_long_it_is_held() {
    let mut sitting = Sitting::new();
    sitting.press(Key::Down).give(enter());
    for _ in 0..60 {
        sitting.give(Input { held: [Key::Enter].into_iter().collect(), ..Input::default() });
    }
    assert_eq!(sitting.at(), "level select", "Enter held does not choose a level as well");

    let mut sitting = Sitting::new();
    sitting.rest();
    let pointer = sitting.buttons().areas()[1].centre();
    sitting.give(Input { pointer, click: true, holding: true, ..Input::default() });
    for _ in 0..60 {
        sitting.give(Input { pointer, holding: true, ..Input::default() });
    }
    assert_eq!(sitting.at(), "level select");

    let mut sitting = Sitting::new();
    sitting.rest().give(Input { held: [Key::Down].into_iter().collect(), ..Input::default() }).wait(1.0);
    assert_eq!(sitting.buttons().focus(), 0, "no press edge, no movement");
}

#[test]
fn hover_and_focus_are_told_apart() {
    let mut sitting = Sitting::new();
    sitting.rest();
    let third = sitting.buttons().areas()[2].centre();
    sitting.press(Key::Down).point_at(third);
    assert_eq!((sitting.buttons().hover(), sitting.buttons().focus()), (Some(2), 1));
    assert_eq!(sitting.at(), "menu");
}

#[test]
fn a_right_click_in_the_menu_drops_a_ball_that_stays_in_the_window() {
    let mut sitting = Sitting::new();
    let drop_at = |sitting: &mut Sitting, pointer: Vec2| {
        sitting.give(Input { pointer, right_click: true, ..Input::default() });
        let Screen::Menu(menu) = sitting.app.screen() else { panic!("at {}", sitting.at()) };
        menu.balls().len()
    };
    assert_eq!(drop_at(&mut sitting, Vec2::new(100.0, 100.0)), 1);
    assert_eq!(drop_at(&mut sitting, Vec2::new(100.0, 100.0)), 2, "beside the first one");
    let button = sitting.buttons().areas()[0].centre();
    assert_eq!(drop_at(&mut sitting, button), 3, "beside the button");
    assert_eq!(drop_at(&mut sitting, Vec2::new(-50.0, 9000.0)), 4, "at the window's edge");
    for _ in 0..100 {
        drop_at(&mut sitting, Vec2::new(200.0, 300.0));
    }
    for size in [Vec2::new(1280.0, 720.0), Vec2::new(900.0, 500.0), Vec2::new(500.0, 700.0)] {
        sitting.frame = Frame::of_window(size);
        sitting.wait(1.0);
        let (areas, frame) = (sitting.buttons().areas().to_vec(), sitting.frame);
        let Screen::Menu(menu) = sitting.app.screen() else { panic!("at {}", sitting.at()) };
        let balls = menu.balls();
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
fn play_opens_the_first_level_not_yet_completed() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.choose(0).flight().game().level().name, "1");
    sitting.wait(1.5).press(Key::Escape);
    assert_eq!(sitting.at(), "menu");
    assert_eq!(sitting.choose(0).flight().game().level().name, "2", "1 was completed in this sitting");

    let scored = |root: &Path| {
        fs::create_dir(root.join("scores")).unwrap();
        for level in ["1", "2", "3"] {
            fs::write(root.join(format!("scores/{level}.csv")), board(1)).unwrap();
        }
    };
    assert_eq!(Sitting::with(scored).choose(0).flight().game().level().name, "10", "the others have scores");
}

#[test]
fn levels_are_listed_in_numeric_order_in_a_grid_of_slices() {
    let mut sitting = Sitting::new();
    sitting.choose(1).rest();
    let names: Vec<&str> = sitting.level_select().entries().iter().map(|entry| entry.name.as_str()).collect();
    assert_eq!(names, ["1", "2", "3", "10", "broken"]);
    let slice = Vec2::new(1280.0 / 11.0, 720.0 / 7.0);
    for index in 0..5 {
        let expected = Area { min: slice * Vec2::new(1.0 + 2.0 * index as f32, 1.0), size: slice };
        let area = sitting.buttons().areas()[index];
        assert!((area.min - expected.min).abs().max_element() < 0.01 && (area.size - expected.size).abs().max_element() < 0.01);
    }
    let marked: Vec<bool> = sitting.level_select().entries().iter().map(|entry| entry.title.is_err()).collect();
    assert_eq!(marked, [false, false, false, false, true]);
}

#[test]
fn the_list_comes_back_where_it_was_left() {
    let mut sitting = Sitting::new();
    sitting.fly(3).press_all(&[Key::Escape, Key::Down, Key::Down, Key::Enter]);
    assert_eq!((sitting.at(), sitting.buttons().focus()), ("level select", 3));
}

#[test]
fn more_than_fifteen_levels_make_pages() {
    let many = |root: &Path| (20..40).for_each(|i| level(root, &i.to_string(), FAR_AWAY, ""));
    let mut sitting = Sitting::with(many);
    sitting.choose(1).rest();
    let shown = |sitting: &Sitting| (sitting.level_select().page(), sitting.buttons().areas().len());
    assert_eq!(shown(&sitting), (0, 15 + 3), "a page, Back, Previous and Next");
    sitting.press(Key::PageUp);
    assert_eq!(shown(&sitting), (0, 18), "no page before the first");
    sitting.choose(17).rest();
    assert_eq!(shown(&sitting), (1, 10 + 3));
    sitting.click(12).press(Key::PageDown);
    assert_eq!(shown(&sitting), (1, 13), "no page after the last");
    assert_eq!(sitting.choose(0).flight().game().level().name, "31", "the sixteenth level of the list");
    sitting.press(Key::Escape).click(2).press(Key::PageUp).press(Key::PageDown).click(10 + 1).rest();
    assert_eq!(shown(&sitting).0, 0);
}

#[test]
fn a_level_that_does_not_load_shows_its_problems_and_closes_nothing() {
    for by_mouse in [true, false] {
        let mut sitting = Sitting::new();
        sitting.choose(1);
        if by_mouse {
            sitting.click(4)
        } else {
            sitting.choose(4)
        };
        let problems = sitting.level_select().problems().expect("the panel is open").problems().to_vec();
        assert_eq!(problems.len(), 1);
        assert!(problems[0].starts_with("obstacles.csv:1: column \"width\": found \"wide\""), "{problems:?}");
        sitting.press(Key::Enter);
        assert_eq!(sitting.at(), "level select", "Enter closes the panel and does not open it again");
        sitting.choose(4).press(Key::Escape);
        assert_eq!(sitting.at(), "level select");
        assert_eq!(sitting.press(Key::Escape).at(), "menu");
    }
}

#[test]
fn a_broken_level_met_on_the_way_lands_on_level_select_with_its_problems() {
    let mut sitting = Sitting::with(|root| {
        fs::remove_dir_all(root.join("levels/2")).unwrap();
        level(root, "2", FAR_AWAY, "nonsense\n");
    });
    sitting.complete();
    let next = sitting.scoring().presses().iter().position(|press| *press == Press::NextLevel).unwrap();
    sitting.choose(next);
    assert_eq!(sitting.at(), "problems");
    assert!(sitting.level_select().problems().unwrap().heading().contains('2'));

    // A level may break, or vanish, while the list is open.
    let mut sitting = Sitting::new();
    sitting.choose(1);
    fs::remove_dir_all(sitting.folder.path().join("levels/1")).unwrap();
    assert_eq!(sitting.choose(0).at(), "problems");
}

#[test]
fn without_levels_nothing_breaks() {
    let mut sitting = Sitting::with(|root| fs::remove_dir_all(root.join("levels")).unwrap());
    assert_eq!(sitting.choose(0).at(), "level select", "there is nothing to play");
    assert!(sitting.level_select().entries().is_empty());
    assert_eq!(sitting.choose(0).at(), "menu", "Back is the only button");
}

#[test]
fn the_pause_panel_does_what_it_says_by_mouse_and_by_keyboard() {
    for (index, screen) in [(0, "flight"), (1, "flight"), (2, "level select"), (3, "menu")] {
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
fn save_and_next_are_there_only_when_they_may_be_used() {
    let presses = |index: usize| Sitting::new().fly(index).wait(1.5).scoring().presses().to_vec();
    assert_eq!(presses(0), [Press::Replay, Press::NextLevel, Press::SaveScore, Press::MainMenu]);
    assert_eq!(presses(2), [Press::Replay, Press::NextLevel, Press::MainMenu], "a lost attempt cannot be saved");

    let last = |root: &Path| level(root, "z-last", HERE, "");
    let mut sitting = Sitting::with(last);
    assert_eq!(sitting.fly(5).wait(1.5).scoring().presses(), [Press::Replay, Press::SaveScore, Press::MainMenu]);
}

#[test]
fn every_button_of_the_score_leads_where_it_says() {
    for (index, screen) in [(0, "flight"), (1, "flight"), (2, "save score"), (3, "menu")] {
        assert_eq!(Sitting::new().complete().click(index).at(), screen);
        let mut sitting = Sitting::new();
        assert_eq!(sitting.complete().choose(index).at(), screen);
        match index {
            0 => assert_eq!(sitting.flight().game().level().name, "1"),
            1 => assert_eq!(sitting.flight().game().level().name, "2"),
            _ => {}
        }
    }
}

#[test]
fn the_score_is_explained_part_by_part() {
    let mut sitting = Sitting::new();
    let parts = sitting.complete().scoring().parts();
    let lines: Vec<_> = parts.iter().map(|part| (part.label, part.value.as_str(), part.effect)).collect();
    assert_eq!(
        lines,
        [
            ("Objectives met", "1/1", Effect::Helped),
            ("Time", "00:00", Effect::Helped),
            ("Damaging collisions", "0", Effect::Nothing),
            ("Fuel left", "100 %", Effect::Helped),
        ]
    );
    assert_eq!((parts[1].beside.as_str(), parts[2].beside.as_str()), ("optimal 00:10", "−500 each"));
    let sum: i64 = parts.iter().map(|part| part.points.replace('−', "-").parse::<i64>().unwrap()).sum();
    assert_eq!(sum, sitting.scoring().result().score.total);

    let lost = Sitting::new().fly(2).wait(1.5).scoring().parts();
    assert_eq!((lost[0].value.as_str(), lost[0].effect), ("0/1", Effect::Cost));
}

#[test]
fn a_name_is_judged_on_submit_and_its_error_stays_until_it_is_mended() {
    let mut sitting = Sitting::new();
    sitting.reach_save_score().write("1bo");
    assert_eq!(sitting.save_score().error(), None, "not while typing");
    sitting.press(Key::Enter);
    let error = sitting.save_score().error().expect("refused").to_owned();
    assert!(error.contains("letter"), "{error}");
    sitting.write("b").wait(1.0);
    assert_eq!(sitting.save_score().error(), Some(error.as_str()), "still wrong");
    sitting.press_all(&[Key::Backspace; 4]);
    let empty = sitting.save_score().error().expect("still wrong, in another way").to_owned();
    assert_ne!(empty, error);
    sitting.write("bob");
    assert_eq!(sitting.save_score().error(), None, "mended");
    assert!(!sitting.folder.path().join("scores/1.csv").exists(), "nothing is saved before it is asked for");
    sitting.press(Key::Enter);
    assert_eq!(sitting.at(), "leaderboard");
    let file = fs::read_to_string(sitting.folder.path().join("scores/1.csv")).unwrap();
    assert!(file.lines().nth(1).unwrap().starts_with("bob,"), "{file}");
}

#[test]
fn the_field_takes_forty_characters() {
    let mut sitting = Sitting::new();
    sitting.reach_save_score().write(&"a".repeat(50));
    assert_eq!(sitting.save_score().text().len(), 40);
    sitting.press(Key::Enter);
    assert!(sitting.save_score().error().is_some_and(|error| error.contains("long")));
}

#[test]
fn a_score_is_saved_by_mouse_and_by_keyboard() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").click(0).at(), "leaderboard");
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").press_all(&[Key::Down, Key::Enter]).at(), "leaderboard");
    let mut sitting = Sitting::new();
    assert_eq!(sitting.reach_save_score().write("ann").press_all(&[Key::Tab, Key::Right, Key::Enter]).at(), "scoring", "Back");
    assert_eq!(Sitting::new().reach_save_score().click(1).at(), "scoring");
}

#[test]
fn the_name_is_kept_for_the_sitting_and_offered_again() {
    let mut sitting = Sitting::new();
    sitting.reach_save_score().write("robert").press_all(&[Key::Enter, Key::Escape]);
    assert_eq!(sitting.at(), "menu");
    assert_eq!(sitting.reach_save_score().save_score().text(), "robert");
    assert_eq!(Sitting::new().reach_save_score().save_score().text(), "", "another sitting");
}

#[test]
fn a_score_that_cannot_be_saved_says_why_and_stays() {
    let mut sitting = Sitting::with(|root| fs::write(root.join("scores"), "a file, no folder").unwrap());
    sitting.reach_save_score().write("ann").press(Key::Enter);
    assert!(sitting.save_score().error().is_some());
    fs::remove_file(sitting.folder.path().join("scores")).unwrap();
    assert_eq!(sitting.press(Key::Enter).at(), "leaderboard");
}

#[test]
fn the_row_just_saved_is_in_view_and_highlighted() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/1.csv"), board(40).replace("20000", "30000")).unwrap();
    });
    sitting.reach_save_score().write("zoe").press(Key::Enter);
    let screen = sitting.leaderboard();
    let saved = screen.saved().expect("a row is highlighted");
    assert_eq!(screen.board().rows()[saved].name.as_str(), "zoe");
    assert!(screen.range().contains(&saved));
    assert_eq!(screen.range().len(), 10);
}

#[test]
fn a_worse_score_says_that_the_best_stays() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/1.csv"), "name,score\nann,30000\n").unwrap();
    });
    sitting.reach_save_score().write("ann").press(Key::Enter);
    assert_eq!(sitting.leaderboard().saved(), Some(0));
    assert!(sitting.leaderboard().remark().is_some_and(|remark| remark.contains("30000")));
}

#[test]
fn a_leaderboard_scrolls_by_keys_wheel_and_bar_and_never_past_its_ends() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/1.csv"), board(24)).unwrap();
    });
    assert_eq!(sitting.choose(2).choose(0).at(), "leaderboard");
    let first = |sitting: &mut Sitting| sitting.rest().leaderboard().range().start;
    assert_eq!(sitting.leaderboard().range(), 0..10);
    assert_eq!(first(sitting.press(Key::Up)), 0);
    assert_eq!(first(sitting.press_all(&[Key::Down; 3])), 3);
    assert_eq!(first(sitting.press_all(&[Key::Down; 30])), 14);
    assert_eq!(first(sitting.give(Input { wheel: 1.0, ..Input::default() })), 11);
    for (wheel, end) in [(1.0, 0), (-1.0, 14)] {
        for _ in 0..20 {
            sitting.give(Input { wheel, ..Input::default() });
        }
        assert_eq!(first(&mut sitting), end);
    }
    let bar = sitting.leaderboard().bar().expect("there is a bar");
    let grab = bar.handle.centre();
    let hold = |at: Vec2, click| Input { pointer: at, click, holding: true, ..Input::default() };
    sitting.give(hold(grab, true)).give(hold(grab - Vec2::new(300.0, 9000.0), false));
    assert_eq!(sitting.leaderboard().range().start, 0, "dragged to the top, and beyond");
    sitting.give(hold(grab, false));
    assert_eq!(sitting.leaderboard().range(), 14..24);
    sitting.rest().point_at(bar.track.min);
    assert_eq!(first(&mut sitting), 14, "let go");
}

#[test]
fn an_empty_board_is_a_board_and_a_damaged_file_is_reported() {
    let mut sitting = Sitting::with(|root| {
        fs::create_dir(root.join("scores")).unwrap();
        fs::write(root.join("scores/2.csv"), "name,score\nann,30000\nbob,many\n").unwrap();
    });
    sitting.choose(2).choose(0);
    assert!(sitting.leaderboard().board().rows().is_empty() && sitting.leaderboard().damage().is_none());
    sitting.press(Key::Escape).choose(1);
    assert_eq!(sitting.leaderboard().board().rows().len(), 1, "sound rows are shown");
    assert!(sitting.leaderboard().damage().is_some_and(|damage| damage.contains("2.csv:3")));
    let scores = Scores::new(sitting.folder.path().join("scores"));
    assert_eq!(scores.load("2").unwrap().damage.len(), 1, "looking changes nothing");
}

#[test]
fn esc_goes_back_everywhere() {
    let esc = |sitting: &mut Sitting| sitting.press(Key::Escape).at();
    assert_eq!(esc(&mut Sitting::new()), "menu", "the menu is where Esc ends");
    assert_eq!(esc(Sitting::new().choose(1)), "menu");
    assert_eq!(esc(Sitting::new().choose(2)), "menu");
    assert_eq!(esc(Sitting::new().choose(3)), "menu");
    assert_eq!(esc(Sitting::new().choose(4)), "menu");
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
    assert_eq!(Sitting::new().click(2).click(0).click(0).at(), "leaderboards");
    assert_eq!(Sitting::new().click(3).click(3).at(), "menu");
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
        whole(sitting.choose(3).complete());
        whole(sitting.choose(2));
        whole(sitting.write("ann").press(Key::Enter));
        whole(sitting.press(Key::Escape).choose(3));
    }
}
