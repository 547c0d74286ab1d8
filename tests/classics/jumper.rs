//! The climb: keys, the rising view, who is out, and the score.

use crate::support::program::{Ran, resultant};
use glam::DVec3;
use resultant::classics::jumper::engine::{CuboidFace, CuboidHit, Dynamic};
use resultant::classics::jumper::{JumpKeys, JumperScene, PLAYER_SIZE, VISIBLE};
use resultant::game::TICK_RATE;

const NOTHING: JumpKeys = JumpKeys { left: false, right: false, jump: false };
const RIGHT: JumpKeys = JumpKeys { right: true, ..NOTHING };
const LEFT: JumpKeys = JumpKeys { left: true, ..NOTHING };
const JUMP: JumpKeys = JumpKeys { jump: true, ..NOTHING };
const RIGHT_JUMP: JumpKeys = JumpKeys { jump: true, ..RIGHT };
/// One tick of gravity, from an upward velocity, m/s.
const FALL: f64 = 10.0 / TICK_RATE;
/// A tower without a platform right above the first player's start, where jumps are not cut short by landing.
const SEED: u64 = 1;

fn alone() -> JumperScene {
    JumperScene::new(SEED, false)
}

fn tick(scene: &mut JumperScene, keys: JumpKeys) -> Dynamic {
    scene.tick([keys, NOTHING]);
    body(scene, 0)
}

fn body(scene: &JumperScene, player: usize) -> Dynamic {
    *scene.players().nth(player).unwrap().1
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

#[test]
fn players_start_on_the_ground() {
    for two in [false, true] {
        let scene = JumperScene::new(3, two);
        let places: Vec<DVec3> = scene.players().map(|(_, body)| body.cuboid.location).collect();
        assert_eq!(places, [DVec3::new(5.0, 0.0, 0.0), DVec3::new(10.0, 0.0, 0.0)][..places.len()]);
        assert_eq!((places.len(), scene.score(), scene.is_over()), (1 + usize::from(two), 0, false));
        let narrow = |body: &Dynamic| body.cuboid.dimensions.x == 0.3 && body.cuboid.dimensions.z == 0.3;
        assert!(scene.players().all(|(_, body)| body.on_ground && narrow(body)));
    }
}

#[test]
fn walking_is_4_and_stops_with_the_keys() {
    let mut scene = alone();
    assert_eq!(tick(&mut scene, RIGHT).velocity.x, 4.0);
    assert_eq!(tick(&mut scene, LEFT).velocity.x, -4.0);
    assert_eq!(tick(&mut scene, JumpKeys { left: true, ..RIGHT }).velocity.x, 0.0);
    assert_eq!(tick(&mut scene, RIGHT).velocity.x, 4.0);
    assert_eq!(tick(&mut scene, NOTHING).velocity.x, 0.0);
}

#[test]
fn a_jump_is_6_standing_and_8_walking() {
    assert!(near(tick(&mut alone(), JUMP).velocity.z, 6.0 - FALL));
    let jumped = tick(&mut alone(), RIGHT_JUMP);
    assert!(near(jumped.velocity.z, 8.0 - FALL) && jumped.velocity.x == 4.0);
}

#[test]
fn in_the_air_only_a_change_of_direction_changes_the_speed() {
    let mut scene = alone();
    tick(&mut scene, RIGHT_JUMP);
    for (keys, speed) in [(RIGHT_JUMP, 4.0), (JUMP, 4.0), (RIGHT_JUMP, 4.0), (LEFT, -2.5), (NOTHING, -2.5), (RIGHT, 2.5)] {
        assert_eq!(tick(&mut scene, keys).velocity.x, speed, "{keys:?}");
    }
}

#[test]
fn there_is_one_more_jump_in_the_air() {
    let mut scene = alone();
    tick(&mut scene, JUMP);
    tick(&mut scene, NOTHING);
    assert!(near(tick(&mut scene, JUMP).velocity.z, 6.0 - FALL));
    let released = tick(&mut scene, NOTHING).velocity.z;
    assert!(near(tick(&mut scene, JUMP).velocity.z, released - FALL), "a third jump");
    while !tick(&mut scene, NOTHING).on_ground {}
    assert!(near(tick(&mut scene, JUMP).velocity.z, 6.0 - FALL), "none after landing");
}

#[test]
fn letting_go_while_rising_halves_the_upward_velocity_once() {
    let mut scene = alone();
    tick(&mut scene, JUMP);
    let rising = tick(&mut scene, JUMP).velocity.z;
    let cut = tick(&mut scene, NOTHING).velocity.z;
    assert!(near(cut, rising / 2.0 - FALL));
    assert!(near(tick(&mut scene, NOTHING).velocity.z, cut - FALL));
    let mut scene = alone();
    while tick(&mut scene, JUMP).velocity.z > 0.0 {}
    let falling = tick(&mut scene, JUMP).velocity.z;
    assert!(near(tick(&mut scene, NOTHING).velocity.z, falling - FALL));
}

#[test]
fn a_held_jump_key_jumps_once() {
    let mut scene = alone();
    tick(&mut scene, JUMP);
    let flight = (0..).take_while(|_| !tick(&mut scene, JUMP).on_ground).count();
    assert!(flight > 30);
    for _ in 0..20 {
        assert!(tick(&mut scene, JUMP).on_ground);
    }
    tick(&mut scene, NOTHING);
    assert!(!tick(&mut scene, JUMP).on_ground);
}

#[test]
fn the_walls_hold() {
    for (keys, end) in [(RIGHT, 15.0 - PLAYER_SIZE), (LEFT, 0.0)] {
        let mut scene = alone();
        (0..600).for_each(|_| _ = tick(&mut scene, keys));
        assert!(near(body(&scene, 0).cuboid.location.x, end));
        let against = |hit: &CuboidHit| matches!(hit, CuboidHit::Static { face: CuboidFace::MinX | CuboidFace::MaxX, .. });
        assert!(scene.hits.iter().any(against), "{:?}", scene.hits);
    }
}

/// The keys, a tick each, of the hop that ends highest on the ground: walk, jump, jump once more, each to a side. It is tried out on
/// copies of the scene.
fn hop(scene: &JumperScene) -> Vec<JumpKeys> {
    let sides = [LEFT, NOTHING, RIGHT];
    let walks = sides.into_iter().flat_map(|side| [0, 15, 45, 90].map(|ticks| vec![side; ticks]));
    let jumps = sides.into_iter().flat_map(|first| sides.map(|second| (first, second)));
    let hops = walks.flat_map(|walk| jumps.clone().map(move |jump| (walk.clone(), jump))).map(|(mut keys, (first, second))| {
        keys.extend([first; 1]);
        keys.extend([JumpKeys { jump: true, ..first }; 70]);
        keys.extend([second; 1]);
        keys.extend([JumpKeys { jump: true, ..second }; 55]);
        keys.extend([NOTHING; 60]);
        keys
    });
    let end = |keys: &Vec<JumpKeys>| {
        let mut scene = scene.clone();
        let after = keys.iter().map(|&keys| tick(&mut scene, keys)).last().unwrap();
        if after.on_ground { after.cuboid.location.z } else { -1.0 }
    };
    hops.max_by(|a, b| end(a).total_cmp(&end(b))).unwrap()
}

#[test]
fn a_climb_raises_the_view_which_never_falls_and_leaves_behind_who_stays() {
    let mut scene = JumperScene::new(SEED, true);
    let mut bottom = 0.0;
    while scene.score() < 30 && scene.ticks < 120 * 120 {
        for keys in hop(&scene) {
            tick(&mut scene, keys);
            let now = scene.view_bottom(1.0);
            assert!(now >= bottom, "the view fell");
            bottom = now;
            let climber = body(&scene, 0).cuboid.location.z;
            assert!(climber - bottom <= 0.5 * VISIBLE + 1e-9 && scene.height >= climber);
            let out: Vec<bool> = scene.players().map(|(player, _)| player.is_out()).collect();
            assert_eq!(out, [false, bottom > PLAYER_SIZE], "the second player never left the ground");
            let top = scene.tower.statics.iter().map(|it| it.cuboid.location.z).fold(0.0, f64::max);
            assert!(top >= bottom + VISIBLE - 2.0, "the tower ends in the view");
        }
    }
    assert!(scene.score() >= 30, "the test's climber came to {} m only", scene.height);
    assert_eq!(scene.score(), scene.height.floor() as i64);
    // Off the lower edge the climber is out too, which ends the climb; the score stays.
    let score = scene.score();
    let mut ticks = 0;
    while !scene.is_over() && ticks < 120 * 60 {
        tick(&mut scene, if ticks / 600 % 2 == 0 { LEFT } else { RIGHT });
        ticks += 1;
    }
    assert!(scene.is_over() && scene.score() >= score);
    let end = scene.ticks;
    tick(&mut scene, RIGHT_JUMP);
    assert_eq!(scene.ticks, end);
}

#[test]
fn a_climb_repeats_bit_by_bit_and_another_seed_is_another_tower() {
    let climb = |seed| {
        let mut scene = JumperScene::new(seed, true);
        for tick in 0..2000_u32 {
            let (side, jump) = (tick / 90 % 2, tick / 13 % 3 == 0);
            let keys = |shift: u32| JumpKeys { left: side == shift, right: side != shift, jump };
            scene.tick([keys(0), keys(1)]);
        }
        let bodies: Vec<Dynamic> = scene.players().map(|(_, body)| *body).collect();
        (bodies, scene.height.to_bits(), scene.tower.statics.to_vec())
    };
    assert_eq!(climb(5), climb(5));
    assert_ne!(climb(5).2, climb(6).2);
}

#[test]
fn players_bounce_off_each_other() {
    let mut scene = JumperScene::new(SEED, true);
    let bumped = (0..240).any(|_| {
        scene.tick([RIGHT, LEFT]);
        scene.hits.contains(&CuboidHit::Pair(0, 1))
    });
    assert!(bumped);
    for _ in 0..10 {
        scene.tick([RIGHT, LEFT]);
        assert_eq!((body(&scene, 0).velocity.x, body(&scene, 1).velocity.x), (-4.0, 4.0));
    }
    assert!(body(&scene, 1).cuboid.location.x - body(&scene, 0).cuboid.end().x > 0.5);
}

#[test]
fn the_command_line_climbs_and_refuses() {
    let folder = tempfile::tempdir().unwrap();
    let inputs = folder.path().join("keys.csv");
    let climb = |text: &str, more: &[&str]| {
        std::fs::write(&inputs, text).unwrap();
        let args = ["--data", env!("CARGO_MANIFEST_DIR"), "jumper", "--seed", "1", "--inputs"];
        let ran = Ran::new(resultant().args(args).arg(&inputs).args(more));
        (ran.status, ran.out, ran.err)
    };
    let mut scene = JumperScene::new(1, true);
    (0..30).for_each(|_| scene.tick([RIGHT, LEFT]));
    let [x1, x2] = [0, 1].map(|player| body(&scene, player).cuboid.location.x);
    let (status, printed, _) = climb("ticks,left1,right1,jump1,left2,right2,jump2\n30,0,1,0,1,0,0\n", &["--players", "2"]);
    assert_eq!((status, printed), (0, format!("outcome=climbing\nscore=0\nheight=0\nticks=30\nx1={x1}\nz1=0\nx2={x2}\nz2=0\n")));
    assert_eq!(climb("ticks,left1,right1,jump1\n30,0,1,x\n", &[]).0, 2);
    assert_eq!(climb("ticks,left1,right1,jump1\n", &["--players", "3"]).0, 2);
}
