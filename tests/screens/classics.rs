//! The classics' screens: the ways to them and back by mouse and keyboard, and what is played there. No window.

use resultant::classics::jumper::scene::{self, Scene};
use resultant::classics::pi::Blocks;
use resultant::classics::tile_run::{Command, Map};
use resultant::screens::{
    App, Buttons, Classic, Input, Jumper, JumperPress as Press, Key, Keys, Noise, Pi, Places, Request, Screen, TileRun,
};
use resultant::view::layout::Vec2;
use std::path::{Path, PathBuf};

/// A frame of the screen, s.
const FRAME: f64 = 1.0 / 60.0;

fn keys(keys: &[Key]) -> Keys {
    keys.iter().copied().collect()
}

/// A frame in which these keys are held, the last of them just pressed.
fn press(held: &[Key]) -> Input {
    let pressed = held.last().copied().into_iter().collect();
    Input { frame_time: FRAME, held: keys(held), pressed, ..Input::default() }
}

fn hold(held: &[Key]) -> Input {
    Input { pressed: Keys::default(), ..press(held) }
}

fn click(at: Vec2) -> Input {
    Input { pointer: at, click: true, ..press(&[]) }
}

/// The shipped files in a folder of its own.
struct Sitting {
    app: App,
    folder: tempfile::TempDir,
}

impl Sitting {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let tile_run = folder.path().join("assets/tile_run");
        std::fs::create_dir_all(&tile_run).unwrap();
        for name in ["map.txt", "commands.txt"] {
            let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/tile_run").join(name);
            std::fs::copy(shipped, tile_run.join(name)).unwrap();
        }
        let within = |name: &str| -> PathBuf { folder.path().join(name) };
        let places = Places { root: folder.path().to_owned(), levels: within("levels"), scores: within("scores") };
        Self { app: App::new(places), folder }
    }

    fn frame(&mut self, input: Input) -> &mut Self {
        self.app.update(&input, &mut ());
        self
    }

    fn press(&mut self, key: Key) -> &mut Self {
        self.frame(press(&[key])).frame(hold(&[]))
    }

    /// Clicks on the middle of a button, once the screen has been laid out.
    fn click(&mut self, button: usize) -> &mut Self {
        self.frame(hold(&[]));
        let at = self.buttons().areas()[button].centre();
        self.frame(click(at)).frame(hold(&[]))
    }

    fn buttons(&self) -> &Buttons {
        match self.app.screen() {
            Screen::Menu(screen) => screen.buttons(),
            Screen::Classics(screen) => screen.buttons(),
            Screen::TileRun(screen) => screen.toolbar().buttons(),
            Screen::Jumper(screen) => screen.buttons().unwrap(),
            Screen::Pi(screen) => screen.toolbar().buttons(),
            Screen::SaveScore(screen) => screen.buttons(),
            Screen::Leaderboard(screen) => screen.buttons(),
            other => panic!("no buttons looked for on {other:?}"),
        }
    }

    fn at(&self) -> &'static str {
        match self.app.screen() {
            Screen::Menu(_) => "menu",
            Screen::Classics(_) => "classics",
            Screen::TileRun(_) => "tile run",
            Screen::Jumper(_) => "jumper",
            Screen::Pi(_) => "pi",
            Screen::SaveScore(_) => "save score",
            Screen::Leaderboard(_) => "leaderboard",
            _ => "elsewhere",
        }
    }

    fn classics(&mut self) -> &mut Self {
        self.app.grant(Request::Classics(None), &mut ());
        self
    }
}

const SCENES: [&str; 3] = ["tile run", "jumper", "pi"];

#[test]
fn each_is_reached_and_left_by_keyboard() {
    let mut sitting = Sitting::new();
    sitting.press(Key::Down).press(Key::Down).press(Key::Down).press(Key::Enter);
    assert_eq!(sitting.at(), "classics");
    for (i, scene) in SCENES.into_iter().enumerate() {
        assert_eq!(sitting.buttons().focus(), i.saturating_sub(1), "the keyboard stays on the scene that was left");
        if i > 0 {
            sitting.press(Key::Down);
        }
        assert_eq!(sitting.press(Key::Enter).at(), scene);
        assert_eq!(sitting.press(Key::Escape).at(), "classics");
    }
    assert_eq!(sitting.press(Key::Escape).at(), "menu");
}

#[test]
fn each_is_reached_and_left_by_mouse() {
    let mut sitting = Sitting::new();
    assert_eq!(sitting.click(3).at(), "classics");
    for (i, scene) in SCENES.into_iter().enumerate() {
        assert_eq!(sitting.click(i).at(), scene);
        let back = if scene == "jumper" { 3 } else { 0 };
        assert_eq!(sitting.click(back).at(), "classics");
    }
    assert_eq!(sitting.click(3).at(), "menu");
}

#[test]
fn a_bad_map_is_told_on_the_list() {
    let mut sitting = Sitting::new();
    std::fs::write(sitting.folder.path().join("assets/tile_run/map.txt"), "s\n#x").unwrap();
    sitting.classics().press(Key::Enter);
    let Screen::Classics(screen) = sitting.app.screen() else { panic!("at {}", sitting.at()) };
    assert!(screen.problem().unwrap().contains("map.txt:2: column 2: found 'x'"));
    std::fs::remove_file(sitting.folder.path().join("assets/tile_run/commands.txt")).unwrap();
    assert_eq!(sitting.classics().press(Key::Enter).at(), "classics");
}

// Tile run

fn tile_run() -> TileRun {
    let shipped = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/tile_run").join(name);
    let read = |name: &str| std::fs::read_to_string(shipped(name)).unwrap();
    TileRun::new(Map::parse(&read("map.txt")).unwrap(), Command::parse_all(&read("commands.txt")).unwrap())
}

fn frames(screen: &mut TileRun, input: &Input, count: usize) {
    for _ in 0..count {
        assert!(screen.update(input).is_none());
    }
}

#[test]
fn the_arrow_keys_run_and_space_jumps() {
    let mut screen = tile_run();
    frames(&mut screen, &hold(&[]), 60);
    assert!(screen.runner().on_ground && screen.frame() == 30, "30 frames of the run a second");
    frames(&mut screen, &hold(&[Key::Left]), 2);
    assert_eq!(screen.runner().vx, -0.1 * 0.80);
    frames(&mut screen, &hold(&[Key::Left, Key::Right]), 2);
    frames(&mut screen, &press(&[Key::Space]), 1);
    frames(&mut screen, &hold(&[]), 1);
    assert_eq!(screen.runner().vy, -0.6 + 0.06);
    frames(&mut screen, &hold(&[]), 60);
    assert!(screen.runner().on_ground, "one press, one jump");
    frames(&mut screen, &press(&[Key::R]), 1);
    assert_eq!((screen.frame(), screen.runner().tile()), (0, (58, 18)));
}

#[test]
fn a_jump_and_a_landing_are_heard_once_each() {
    let mut screen = tile_run();
    let mut heard = |input: &Input, count: usize| {
        let mut all = Vec::new();
        for _ in 0..count {
            frames(&mut screen, input, 1);
            all.extend_from_slice(screen.noises());
        }
        all
    };
    assert!(matches!(heard(&hold(&[]), 60)[..], [Noise::Landing(_)]), "it begins above the ground");
    assert_eq!(heard(&press(&[Key::Space]), 1), []);
    assert_eq!(heard(&hold(&[]), 1), [Noise::Jump]);
    let landed = heard(&hold(&[]), 60);
    let [Noise::Landing(hard)] = landed[..] else { panic!("{landed:?}") };
    assert!((0.5..=1.0).contains(&hard), "{hard}");
}

#[test]
fn climbers_are_heard_when_they_jump_land_and_bump() {
    let mut sitting = Sitting::new();
    sitting.app.grant(Request::Classic(Classic::Jumper), &mut ());
    sitting.click(1);
    let mut heard = |input: Input, count: usize| {
        let mut all = Vec::new();
        for _ in 0..count {
            sitting.frame(input.clone());
            all.extend(sitting.app.screen().noises());
        }
        all
    };
    assert_eq!(heard(hold(&[]), 30), [], "who stands is silent");
    assert_eq!(heard(press(&[Key::W]), 1), [Noise::Jump]);
    let landed = heard(hold(&[]), 120);
    assert!(matches!(landed[..], [Noise::Landing(hard)] if hard > 0.2), "{landed:?}");
    assert!(heard(hold(&[Key::D, Key::Left]), 120).contains(&Noise::Bump));
}

#[test]
fn the_commands_are_watched_paused_and_stepped() {
    let mut screen = tile_run();
    frames(&mut screen, &hold(&[]), 20);
    frames(&mut screen, &press(&[Key::Tab]), 1);
    assert!(screen.watching() && !screen.paused() && screen.frame() == 0);
    frames(&mut screen, &hold(&[]), 20);
    let paused_at = screen.frame();
    assert!((9..=10).contains(&paused_at));
    frames(&mut screen, &press(&[Key::Space]), 1);
    frames(&mut screen, &hold(&[Key::Left]), 60);
    assert_eq!((screen.paused(), screen.frame()), (true, paused_at));
    for step in 1..=3 {
        frames(&mut screen, &press(&[Key::Right]), 1);
        frames(&mut screen, &hold(&[Key::Right]), 30);
        assert_eq!(screen.frame(), paused_at + step, "one press, one frame");
    }
    frames(&mut screen, &press(&[Key::Space]), 1);
    frames(&mut screen, &hold(&[]), 600);
    assert_eq!((screen.frame(), screen.runner().tile()), (245, (58, 2)));
    frames(&mut screen, &press(&[Key::Tab]), 1);
    assert!(!screen.watching() && screen.runner().tile() == (58, 18));
}

#[test]
fn the_run_is_as_fast_at_every_frame_rate() {
    for rate in [24.0, 60.0, 144.0] {
        let mut screen = tile_run();
        frames(&mut screen, &Input { frame_time: 1.0 / rate, ..hold(&[Key::Left]) }, rate as usize * 3);
        assert!((89..=90).contains(&screen.frame()), "{} frames in 3 s at {rate} a second", screen.frame());
    }
}

// Jumper

/// A climb that has come to an end by waiting at the foot, after a height that counts.
fn ended() -> Scene {
    let mut scene = Scene::new(1, false);
    for tick in 0..240 {
        scene.tick([scene::Keys { jump: tick % 60 < 30, ..Default::default() }, Default::default()]);
    }
    scene
}

fn jumper(sitting: &Sitting) -> &Jumper {
    let Screen::Jumper(screen) = sitting.app.screen() else { panic!("at {}", sitting.at()) };
    screen
}

#[test]
fn one_or_two_climb_with_their_keys() {
    for (button, players) in [(0, 1), (1, 2)] {
        let mut sitting = Sitting::new();
        sitting.app.grant(Request::Classic(Classic::Jumper), &mut ());
        assert_eq!(jumper(&sitting).presses(), [Press::One, Press::Two, Press::Leaderboard, Press::Back]);
        sitting.click(button);
        assert_eq!((jumper(&sitting).presses(), jumper(&sitting).scene().players().count()), (&[][..], players));
        sitting.frame(hold(&[Key::D, Key::Left]));
        sitting.frame(hold(&[Key::D, Key::Left]));
        let speeds: Vec<f64> = jumper(&sitting).scene().players().map(|(_, body)| body.velocity.x).collect();
        assert_eq!(speeds, if players == 2 { vec![4.0, -4.0] } else { vec![0.0] });
        // A press between two frames is not lost.
        sitting.frame(Input { held: Keys::default(), ..press(&[Key::W]) });
        let rises = jumper(&sitting).scene().players().next().unwrap().1.velocity.z > 0.0;
        assert!(rises);
    }
}

#[test]
fn a_climb_stands_still_while_it_is_paused() {
    let mut sitting = Sitting::new();
    sitting.app.grant(Request::Classic(Classic::Jumper), &mut ());
    sitting.click(0).frame(hold(&[])).press(Key::Escape);
    let ticks = jumper(&sitting).scene().ticks();
    assert_eq!(jumper(&sitting).presses(), [Press::Resume, Press::Again, Press::Back]);
    assert_eq!(jumper(&sitting).heading(), Some("Paused"));
    sitting.frame(hold(&[])).frame(hold(&[]));
    assert_eq!(jumper(&sitting).scene().ticks(), ticks);
    sitting.press(Key::Escape).frame(hold(&[]));
    assert!(jumper(&sitting).scene().ticks() > ticks);
    sitting.press(Key::Escape);
    assert_eq!(sitting.click(2).at(), "classics");
}

#[test]
fn a_climb_is_saved_on_the_jumpers_leaderboard() {
    let mut sitting = Sitting::new();
    let scene = ended();
    let score = scene.score();
    assert!(score > 0, "the test's climb came to nothing");
    sitting.app.grant(Request::Climbed(Box::new(scene)), &mut ());
    assert_eq!(jumper(&sitting).presses(), [Press::Again, Press::SaveScore, Press::Leaderboard, Press::Back]);
    sitting.click(1);
    assert_eq!(sitting.at(), "save score");
    // The way back loses nothing.
    assert_eq!(sitting.press(Key::Escape).at(), "jumper");
    assert_eq!(jumper(&sitting).scene().score(), score);
    sitting.click(1).frame(Input { typed: "Ada".to_owned(), ..hold(&[]) }).press(Key::Enter);
    let Screen::Leaderboard(board) = sitting.app.screen() else { panic!("at {}", sitting.at()) };
    assert_eq!((board.subject(), board.saved(), board.board().rows()[0].score), ("the Jumper", Some(0), score));
    let file = std::fs::read_to_string(sitting.folder.path().join("scores/jumper.csv")).unwrap();
    assert_eq!(file, format!("name,score\nAda,{score}\n"));
    assert_eq!(sitting.press(Key::Escape).at(), "jumper");
    assert_eq!(sitting.click(2).at(), "leaderboard");
    assert_eq!(sitting.press(Key::Escape).at(), "jumper");
}

#[test]
fn a_climb_that_came_to_nothing_cannot_be_saved() {
    let mut sitting = Sitting::new();
    sitting.app.grant(Request::Climbed(Box::new(Scene::new(1, true))), &mut ());
    assert_eq!(jumper(&sitting).presses(), [Press::Again, Press::Leaderboard, Press::Back]);
    sitting.click(0);
    assert_eq!(jumper(&sitting).scene().players().count(), 2, "again as many");
}

// π

fn run(screen: &mut Pi, frame_time: f64, seconds: f64) {
    for _ in 0..(seconds / frame_time) as usize {
        assert!(screen.update(&Input { frame_time, ..hold(&[]) }).is_none());
    }
}

#[test]
fn the_digits_come_out_right_at_every_frame_rate() {
    for rate in [10.0, 30.0, 60.0, 144.0, 1000.0] {
        let mut screen = Pi::default();
        run(&mut screen, 1.0 / rate, 12.0);
        assert_eq!((screen.counter(), screen.blocks().next_time()), (("314".to_owned(), 3), None));
        let mut exact = Blocks::new(2);
        while exact.collide().is_some() {}
        assert_eq!(*screen.blocks(), exact, "{rate} frames a second");
    }
}

#[test]
fn digits_count_as_right_only_behind_right_ones() {
    let mut screen = Pi::default();
    assert_eq!(screen.counter(), ("000".to_owned(), 0));
    screen.update(&press(&[Key::Down]));
    for _ in 0..4000 {
        screen.update(&hold(&[]));
        let (counter, right) = screen.counter();
        assert_eq!(right, counter.bytes().zip("314".bytes()).take_while(|(a, b)| a == b).count());
    }
    assert_eq!(screen.counter().1, 3);
}

#[test]
fn arrow_keys_change_n_and_speed_and_r_restarts() {
    let mut screen = Pi::default();
    let tap = |screen: &mut Pi, key: Key| {
        screen.update(&press(&[key]));
        (screen.n(), screen.speed())
    };
    assert_eq!(tap(&mut screen, Key::Right), (3, 1.0));
    for _ in 0..20 {
        tap(&mut screen, Key::Right);
    }
    assert_eq!(screen.n(), 9);
    for _ in 0..20 {
        tap(&mut screen, Key::Left);
    }
    assert_eq!(tap(&mut screen, Key::Down), (0, 0.25));
    assert_eq!(tap(&mut screen, Key::Up), (0, 1.0));
    run(&mut screen, FRAME, 5.0);
    assert_eq!(screen.counter(), ("3".to_owned(), 1));
    tap(&mut screen, Key::R);
    assert_eq!((screen.counter(), screen.speed()), (("0".to_owned(), 0), 1.0));
}

#[test]
fn a_frame_holds_any_number_of_collisions_but_its_work_is_bounded() {
    let mut screen = Pi::default();
    for _ in 0..4 {
        screen.update(&press(&[Key::Right]));
    }
    let mut most = 0;
    for _ in 0..400 {
        let before = screen.blocks().collisions();
        run(&mut screen, FRAME, FRAME);
        most = most.max(screen.blocks().collisions() - before);
    }
    assert_eq!((most, screen.counter()), (300_000, ("3141592".to_owned(), 7)));
}
