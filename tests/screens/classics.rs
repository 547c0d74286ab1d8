//! The classics' screens without a window: the ways to them and back by mouse and keyboard, and their games.

use crate::sitting::{Sitting, keys};
use crate::support::shipped::{copy, project};
use resultant::classics::jumper::{JumpKeys, JumperScene};
use resultant::screens::{Classic, Destination, Input, Jumper, Key, Keys, Noise, Pi, Request, TileRun};

/// A frame of the screen, s.
const FRAME: f64 = 1.0 / 60.0;

/// A frame in which these keys are held, the last of them just pressed.
fn press(held: &[Key]) -> Input {
    let pressed = held.last().copied().into_iter().collect();
    Input { frame_time: FRAME, held: keys(held), pressed, ..Input::default() }
}

fn hold(held: &[Key]) -> Input {
    Input { pressed: Keys::default(), ..press(held) }
}

fn sitting() -> Sitting {
    Sitting::with(|root| {
        copy(&project().join("assets/tile_run"), &root.join("assets/tile_run"));
    })
}

/// One that begins in a classic, or in a climb that has ended.
fn at(request: Request) -> Sitting {
    let mut sitting = sitting();
    sitting.app.grant(request, &mut ());
    sitting.app.update(&Input { frame: sitting.frame, ..Input::default() }, &mut ());
    sitting
}

const SCENES: [&str; 3] = ["tile run", "jumper", "pi"];
const BUTTONS: [&str; 3] = ["Tile Run", "Jumper", "π from Collisions"];

#[test]
fn each_is_reached_and_left_by_keyboard() {
    let mut sitting = sitting();
    sitting.choose("Classics");
    assert_eq!(sitting.at(), "classics");
    for (i, scene) in SCENES.into_iter().enumerate() {
        assert_eq!(sitting.focused(), BUTTONS[i.saturating_sub(1)], "the focus stays on the scene that was left");
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
    let mut sitting = sitting();
    assert_eq!(sitting.click("Classics").at(), "classics");
    for (button, scene) in BUTTONS.into_iter().zip(SCENES) {
        assert_eq!(sitting.click(button).at(), scene);
        assert_eq!(sitting.click("Back").at(), "classics");
    }
    assert_eq!(sitting.click("Back").at(), "menu");
}

#[test]
fn a_bad_map_is_told_on_the_list() {
    let mut sitting = at(Request::Reset(Destination::Classics(None)));
    std::fs::write(sitting.folder.path().join("assets/tile_run/map.txt"), "s\n#x").unwrap();
    sitting.press(Key::Enter);
    assert!(sitting.shows("map.txt:2: column 2: found 'x'"));
    std::fs::remove_file(sitting.folder.path().join("assets/tile_run/commands.txt")).unwrap();
    sitting.app.grant(Request::Reset(Destination::Classics(None)), &mut ());
    assert_eq!(sitting.rest().press(Key::Enter).at(), "classics");
}

fn tile_run() -> Sitting {
    at(Request::Reset(Destination::Classic(Classic::TileRun)))
}

fn run_of(sitting: &Sitting) -> &TileRun {
    sitting.screen()
}

fn frames(sitting: &mut Sitting, input: &Input, count: usize) {
    (0..count).for_each(|_| _ = sitting.give(input.clone()));
    assert_eq!(sitting.at(), "tile run");
}

#[test]
fn the_arrow_keys_run_and_space_jumps() {
    let mut screen = tile_run();
    frames(&mut screen, &hold(&[]), 60);
    assert!(run_of(&screen).runner.on_ground && run_of(&screen).frame == 30, "30 frames of the run a second");
    frames(&mut screen, &hold(&[Key::Left]), 2);
    assert_eq!(run_of(&screen).runner.vx, -0.1 * 0.80);
    frames(&mut screen, &hold(&[Key::Left, Key::Right]), 2);
    frames(&mut screen, &press(&[Key::Space]), 1);
    frames(&mut screen, &hold(&[]), 1);
    assert_eq!(run_of(&screen).runner.vy, -0.6 + 0.06);
    frames(&mut screen, &hold(&[]), 60);
    assert!(run_of(&screen).runner.on_ground, "one press, one jump");
    frames(&mut screen, &press(&[Key::R]), 1);
    assert_eq!((run_of(&screen).frame, run_of(&screen).runner.tile()), (0, (58, 18)));
}

fn heard(sitting: &mut Sitting, input: Input, count: usize) -> Vec<Noise> {
    (0..count).flat_map(|_| sitting.give(input.clone()).app.screen().noises()).collect()
}

#[test]
fn a_jump_and_a_landing_are_heard_once_each() {
    let mut screen = tile_run();
    let mut heard = |input, count| heard(&mut screen, input, count);
    assert!(matches!(heard(hold(&[]), 60)[..], [Noise::Landing(_)]), "it begins above the ground");
    assert_eq!(heard(press(&[Key::Space]), 1), []);
    assert_eq!(heard(hold(&[]), 1), [Noise::Jump]);
    let landed = heard(hold(&[]), 60);
    let [Noise::Landing(hard)] = landed[..] else { panic!("{landed:?}") };
    assert!((0.5..=1.0).contains(&hard), "{hard}");
}

#[test]
fn climbers_are_heard_when_they_jump_land_and_bump() {
    let mut sitting = at(Request::Reset(Destination::Classic(Classic::Jumper)));
    sitting.click("Two Players");
    let mut heard = |input, count| heard(&mut sitting, input, count);
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
    assert!(run_of(&screen).watching && !run_of(&screen).paused && run_of(&screen).frame == 0);
    frames(&mut screen, &hold(&[]), 20);
    let paused_at = run_of(&screen).frame;
    assert!((9..=10).contains(&paused_at));
    frames(&mut screen, &press(&[Key::Space]), 1);
    frames(&mut screen, &hold(&[Key::Left]), 60);
    assert_eq!((run_of(&screen).paused, run_of(&screen).frame), (true, paused_at));
    for step in 1..=3 {
        frames(&mut screen, &press(&[Key::Right]), 1);
        frames(&mut screen, &hold(&[Key::Right]), 30);
        assert_eq!(run_of(&screen).frame, paused_at + step, "one press, one frame");
    }
    frames(&mut screen, &press(&[Key::Space]), 1);
    frames(&mut screen, &hold(&[]), 600);
    assert_eq!((run_of(&screen).frame, run_of(&screen).runner.tile()), (245, (58, 2)));
    frames(&mut screen, &press(&[Key::Tab]), 1);
    assert!(!run_of(&screen).watching && run_of(&screen).runner.tile() == (58, 18));
}

#[test]
fn the_run_is_as_fast_at_every_frame_rate() {
    for rate in [24.0, 60.0, 144.0] {
        let mut screen = tile_run();
        frames(&mut screen, &Input { frame_time: 1.0 / rate, ..hold(&[Key::Left]) }, rate as usize * 3);
        assert!((89..=90).contains(&run_of(&screen).frame), "{} frames in 3 s at {rate} a second", run_of(&screen).frame);
    }
}

/// A climb that has come to an end by waiting at the foot, after a height that counts.
fn ended() -> JumperScene {
    let mut scene = JumperScene::new(1, false);
    for tick in 0..240 {
        scene.tick([JumpKeys { jump: tick % 60 < 30, ..Default::default() }, Default::default()]);
    }
    scene
}

fn jumper(sitting: &Sitting) -> &Jumper {
    sitting.screen()
}

#[test]
fn one_or_two_climb_with_their_keys() {
    for (button, players) in [("One Player", 1), ("Two Players", 2)] {
        let mut sitting = at(Request::Reset(Destination::Classic(Classic::Jumper)));
        assert_eq!(sitting.labels(), ["One Player", "Two Players", "Leaderboard", "Back"]);
        sitting.click(button);
        assert_eq!((sitting.labels().len(), jumper(&sitting).scene.players().count()), (0, players));
        sitting.give(hold(&[Key::D, Key::Left])).give(hold(&[Key::D, Key::Left]));
        let speeds: Vec<f64> = jumper(&sitting).scene.players().map(|(_, body)| body.velocity.x).collect();
        assert_eq!(speeds, if players == 2 { vec![4.0, -4.0] } else { vec![0.0] });
        // A press between two frames is not lost.
        sitting.give(Input { held: Keys::default(), ..press(&[Key::W]) });
        let rises = jumper(&sitting).scene.players().next().unwrap().1.velocity.z > 0.0;
        assert!(rises);
    }
}

#[test]
fn a_climb_stands_still_while_it_is_paused() {
    let mut sitting = at(Request::Reset(Destination::Classic(Classic::Jumper)));
    sitting.click("One Player").give(hold(&[])).press(Key::Escape);
    let ticks = jumper(&sitting).scene.ticks;
    assert_eq!(sitting.labels(), ["Resume", "Climb Again", "Back"]);
    assert!(sitting.shows("Paused"));
    sitting.give(hold(&[])).give(hold(&[]));
    assert_eq!(jumper(&sitting).scene.ticks, ticks);
    sitting.press(Key::Escape).give(hold(&[]));
    assert!(jumper(&sitting).scene.ticks > ticks);
    sitting.press(Key::Escape);
    assert_eq!(sitting.click("Back").at(), "classics");
}

#[test]
fn a_climb_is_saved_on_the_jumpers_leaderboard() {
    let scene = ended();
    let score = scene.score();
    assert!(score > 0, "the test's climb came to nothing");
    let mut sitting = at(Request::Reset(Destination::Climbed(Box::new(scene))));
    assert_eq!(sitting.labels(), ["Climb Again", "Save Score", "Leaderboard", "Back"]);
    sitting.click("Save Score");
    assert_eq!(sitting.at(), "new player");
    assert_eq!(sitting.press(Key::Escape).at(), "jumper");
    assert_eq!(jumper(&sitting).scene.score(), score);
    sitting.click("Save Score").give(Input { typed: "Ada".to_owned(), ..hold(&[]) }).press(Key::Enter);
    assert_eq!(sitting.labels(), ["Climb Again", "Leaderboard", "Back"]);
    sitting.click("Leaderboard");
    assert!(sitting.shows("Leaderboard of the Jumper") && sitting.picked() == Some(sitting.place("Ada").y));
    assert_eq!(sitting.row("Ada"), ["1".to_owned(), "Ada".to_owned(), score.to_string()]);
    let file = std::fs::read_to_string(sitting.folder.path().join("scores/jumper.csv")).unwrap();
    assert_eq!(file, format!("name,score\nAda,{score}\n"));
    assert_eq!(sitting.press(Key::Escape).at(), "jumper");
    assert_eq!(sitting.click("Leaderboard").at(), "leaderboard");
    assert_eq!(sitting.press(Key::Escape).at(), "jumper");
}

#[test]
fn a_climb_that_came_to_nothing_cannot_be_saved() {
    let mut sitting = at(Request::Reset(Destination::Climbed(Box::new(JumperScene::new(1, true)))));
    assert_eq!(sitting.labels(), ["Climb Again", "Leaderboard", "Back"]);
    sitting.click("Climb Again");
    assert_eq!(jumper(&sitting).scene.players().count(), 2, "again as many");
}

fn run(sitting: &mut Sitting, frame_time: f64, seconds: f64) {
    for _ in 0..(seconds / frame_time) as usize {
        sitting.give(Input { frame_time, ..hold(&[]) });
    }
}

fn pi() -> Sitting {
    at(Request::Reset(Destination::Classic(Classic::Pi)))
}

fn blocks_of(sitting: &Sitting) -> &Pi {
    sitting.screen()
}

#[test]
fn digits_count_as_right_only_behind_right_ones() {
    let mut screen = pi();
    assert_eq!(blocks_of(&screen).counter(), ("000".to_owned(), 0));
    screen.give(press(&[Key::Down]));
    for _ in 0..4000 {
        screen.give(hold(&[]));
        let (counter, right) = blocks_of(&screen).counter();
        assert_eq!(right, counter.bytes().zip("314".bytes()).take_while(|(a, b)| a == b).count());
    }
    assert_eq!(blocks_of(&screen).counter().1, 3);
}

#[test]
fn arrow_keys_change_n_and_speed_and_r_restarts() {
    let mut screen = pi();
    let tap = |screen: &mut Sitting, key: Key| {
        screen.give(press(&[key]));
        (blocks_of(screen).n, blocks_of(screen).speed())
    };
    assert_eq!(tap(&mut screen, Key::Right), (3, 1.0));
    (0..20).for_each(|_| _ = tap(&mut screen, Key::Right));
    assert_eq!(blocks_of(&screen).n, 9);
    (0..20).for_each(|_| _ = tap(&mut screen, Key::Left));
    assert_eq!(tap(&mut screen, Key::Down), (0, 0.25));
    assert_eq!(tap(&mut screen, Key::Up), (0, 1.0));
    run(&mut screen, FRAME, 5.0);
    assert_eq!(blocks_of(&screen).counter(), ("3".to_owned(), 1));
    tap(&mut screen, Key::R);
    assert_eq!((blocks_of(&screen).counter(), blocks_of(&screen).speed()), (("0".to_owned(), 0), 1.0));
}

#[test]
fn a_frame_holds_any_number_of_collisions_but_its_work_is_bounded() {
    let mut screen = pi();
    (0..4).for_each(|_| _ = screen.give(press(&[Key::Right])));
    let mut most = 0;
    for _ in 0..400 {
        let before = blocks_of(&screen).blocks.collisions;
        run(&mut screen, FRAME, FRAME);
        most = most.max(blocks_of(&screen).blocks.collisions - before);
    }
    assert_eq!((most, blocks_of(&screen).counter()), (300_000, ("3141592".to_owned(), 7)));
}
