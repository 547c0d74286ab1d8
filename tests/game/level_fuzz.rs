//! Random levels at and beyond the accepted limits: an accepted level can be played, stays finite and stays in its bounds.
//! `tools/fuzz_levels` plays many more of the same, and holds them against every law.

use crate::support::written::kept;
use crate::support::{Memory, Random, level_texts};
use resultant::game::{Controls, Game};
use resultant::level;
use resultant::physics::Aabb;
use std::sync::Arc;

#[global_allocator]
static ALLOCATOR: crate::support::memory::Counting = crate::support::memory::Counting;

/// Bytes. A tick once took 1.27 GB.
const MOST_HELD: isize = 64 << 20;
const LEVELS: u64 = 300;
const TICKS: u32 = 15;

/// Levels that once broke a law, and the tick in which each did.
const ONCE_BROKEN: &str = include_str!("../fixtures/once_broken.txt");

/// The keys of [`ONCE_BROKEN`] are let go of as seldom as the tool does.
#[test]
fn what_once_broke_a_law_holds() {
    for (name, ticks, files) in kept(ONCE_BROKEN) {
        let files = files.into_iter().map(|(file, rows)| (file, rows.to_owned())).collect();
        let loaded = level::read("fuzz", &Memory(files)).unwrap_or_else(|problems| panic!("{name}: {problems:?}"));
        let mut game = Game::new(Arc::new(loaded.level)).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (mut random, mut controls) = (Random(!name), Controls::default());
        for tick in 1..=ticks {
            if random.chance(0.08) {
                let mut key = || random.chance(0.4);
                controls = Controls { thrust: key(), reverse: key(), left: key(), right: key() };
            }
            game.step(controls);
            game.world().validate().unwrap_or_else(|fault| panic!("{name}, tick {tick}: {fault}"));
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
            let (held, ()) = crate::support::memory::most_held(|| game.step(controls));
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
