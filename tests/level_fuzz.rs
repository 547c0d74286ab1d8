//! Random levels at and beyond the limits of what is accepted: what is not refused can be played, stays finite and stays in the level.
//! `tools/fuzz_levels` plays many more of the same, and holds them against every law.

mod support;

use resultant::game::{Controls, Game};
use resultant::level;
use resultant::physics::Aabb;
use std::sync::Arc;
use support::{Random, level_texts};

#[global_allocator]
static ALLOCATOR: support::memory::Counting = support::memory::Counting;

/// Bytes. A tick once took 1.27 GB.
const MOST_HELD: isize = 64 << 20;
const LEVELS: u64 = 300;
const TICKS: u32 = 15;

/// Levels of the tool that once broke a law, and the tick in which they did; it lets go of keys as seldom.
#[rustfmt::skip]
const ONCE_BROKEN: [(u64, u32); 96] = [
    (500074, 75), (500568, 79), (500617, 9), (500652, 4), (500808, 101), (500843, 1), (500870, 298), (500894, 111),
    (501228, 1), (501617, 4), (501982, 25), (501992, 7), (502184, 1), (503083, 18), (503400, 106), (504331, 47),
    (504856, 254), (505315, 1), (505516, 11), (505520, 1), (506173, 28), (506486, 44), (506570, 92), (506667, 190),
    (506821, 37), (506930, 25), (506985, 1), (507042, 193), (507070, 77), (507875, 1), (508076, 4), (508753, 1), (508901, 1),
    (509044, 18), (509219, 8), (509565, 1), (509814, 59), (510049, 1), (510092, 1), (510212, 1), (510397, 63), (510402, 85),
    (510828, 98), (511081, 80), (511314, 10), (511562, 30), (511764, 19), (511983, 74), (604289, 49), (605446, 64),
    (608896, 1), (610169, 118), (616979, 60), (620805, 97), (621893, 88), (623739, 13), (624323, 1), (627380, 1),
    (628263, 77), (634683, 18), (639291, 49), (643769, 1), (645211, 98), (647564, 10), (652350, 17), (653695, 43),
    (654225, 93), (655714, 38), (656106, 112), (658187, 88), (701286, 17), (714198, 1), (721997, 25), (722527, 38),
    (733578, 2), (805849, 60), (836876, 10), (840273, 1), (857557, 196), (1040710, 117), (1099756, 86), (1216171, 84),
    (2006763, 97), (2007912, 149), (2008008, 190), (2011246, 179), (2012905, 263), (2013505, 130), (2013743, 277), (2018977, 126),
    (2024784, 5), (5013553, 72), (1050404, 204), (1312082, 76), (2041870, 196), (2026899, 133),
];

/// What a tick is held against in tests says what is broken.
#[test]
fn what_once_broke_a_law_holds() {
    for (seed, ticks) in ONCE_BROKEN {
        let loaded = level::read("fuzz", &level_texts(seed)).unwrap_or_else(|problems| panic!("seed {seed}: {problems:?}"));
        let mut game = Game::new(Arc::new(loaded.level)).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        let (mut random, mut controls) = (Random(!seed), Controls::default());
        for tick in 1..=ticks {
            if random.chance(0.08) {
                let mut key = || random.chance(0.4);
                controls = Controls { thrust: key(), reverse: key(), left: key(), right: key() };
            }
            game.step(controls);
            game.world().validate().unwrap_or_else(|fault| panic!("seed {seed}, tick {tick}: {fault}"));
        }
    }
}

#[test]
fn what_is_accepted_stays_finite_and_in_the_level() {
    let mut played = 0;
    for seed in 0..LEVELS {
        let Ok(loaded) = level::read("fuzz", &level_texts(seed)) else { continue };
        played += 1;
        let bounds = loaded.level.bounds();
        let rounding = 1e-6 + 1e-14 * bounds.max.max_element();
        let mut game = Game::new(Arc::new(loaded.level)).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        let mut random = Random(!seed);
        for tick in 0..TICKS {
            let mut key = || random.chance(0.4);
            let controls = Controls { thrust: key(), reverse: key(), left: key(), right: key() };
            let (held, ()) = support::memory::most_held(|| game.step(controls));
            assert!(held < MOST_HELD, "seed {seed}, tick {tick}: {held} bytes");
            for (i, body) in game.world().bodies().iter().enumerate() {
                let finite = body.position.is_finite() && body.velocity.is_finite() && body.acceleration.is_finite();
                assert!(finite, "seed {seed}, tick {tick}: body {i} is {body:?}");
                let inside = |of: &Aabb| bounds.contains(of, rounding);
                assert!(inside(&body.bounds()), "seed {seed}, tick {tick}: body {i} is at {:?}, outside {bounds:?}", body.bounds());
            }
        }
    }
    assert!((LEVELS / 2..LEVELS).contains(&played), "{played} of {LEVELS} are accepted");
}
