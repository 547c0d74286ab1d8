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
