//! The same inputs by tick give the same bits, whatever the frames do.

mod support;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use resultant::game::{Clock, Controls, Game, Inputs, Latch, Outcome, TICK_RATE};
use resultant::level::Level;
use std::sync::Arc;
use support::rooms::{room, yard};

/// The hash of the state after [`TICKS`] ticks of [`script`] in [`yard`]. It changes whenever the engine, the rules or the state
/// that they keep change on purpose: then take over the value that the failing test prints.
const GOLDEN: u64 = 0xb5c62cfb33df3e3f;
/// Ten seconds.
const TICKS: u32 = 1200;

/// What the player holds during each tick: keys that change every few ticks, the same on every machine.
fn script() -> Vec<Controls> {
    let mut random = Pcg32::seed_from_u64(7);
    let mut controls = Controls::default();
    let mut change = |tick| {
        if tick % 7 == 0 {
            controls = Controls {
                thrust: random.random_bool(0.6),
                reverse: random.random_bool(0.1),
                left: random.random_bool(0.2),
                right: random.random_bool(0.2),
            };
        }
        controls
    };
    (0..TICKS).map(&mut change).collect()
}

/// Plays the script tick by tick while frames take the given times; the keys of a frame are those of its next tick.
fn play(mut frame_time: impl FnMut() -> f64) -> Game {
    let script = script();
    let mut game = Game::new(Arc::new(yard())).unwrap();
    let mut clock = Clock::new(TICK_RATE);
    let mut latch = Latch::default();
    while game.ticks() < u64::from(TICKS) {
        clock.add(frame_time());
        while game.ticks() < u64::from(TICKS) && clock.tick() {
            latch.frame(script[game.ticks() as usize], Controls::default());
            game.step(latch.take());
        }
    }
    game
}

#[test]
fn the_golden_hash() {
    let game = play(|| 1.0 / 60.0);
    assert_eq!(game.outcome(), Outcome::Running, "the script is meant to fly to its end");
    assert_eq!(game.hash(), GOLDEN, "the hash is now {:#018x}", game.hash());
}

#[test]
fn every_frame_rate_gives_the_same_bits() {
    let expected = play(|| 1.0 / 60.0).hash();
    for frame_rate in [30.0, 60.0, 144.0, 1000.0, 7.0] {
        assert_eq!(play(|| 1.0 / frame_rate).hash(), expected, "{frame_rate} frames a second");
    }
    for seed in 0..5 {
        let mut random = Pcg32::seed_from_u64(seed);
        let irregular = play(|| if random.random_bool(0.01) { 2.0 } else { random.random_range(0.0..0.05) });
        assert_eq!(irregular.hash(), expected, "irregular frames, seed {seed}");
    }
}

#[test]
fn recorded_inputs_give_the_same_bits_also_through_a_file() {
    let mut inputs = Inputs::default();
    script().into_iter().for_each(|controls| inputs.record(controls));
    let mut game = Game::new(Arc::new(yard())).unwrap();
    Inputs::parse("script", &inputs.to_string()).unwrap().into_iter().for_each(|controls| game.step(controls));
    assert_eq!(game.hash(), play(|| 1.0 / 60.0).hash());
}

#[test]
fn one_bit_more_is_another_hash() {
    let hash = |level: Level| Game::new(Arc::new(level)).unwrap().hash();
    let mut nudged = yard();
    nudged.objects[1].velocity.x = 3.0_f64.next_up();
    assert_eq!(hash(yard()), hash(yard()));
    assert_ne!(hash(yard()), hash(nudged));
}

/// Frames in which each key is down and went down, as (frame time, held, pressed), and the ticks in which the ship burnt.
fn ticks_burnt(frames: &[(f64, bool, bool)]) -> Vec<u64> {
    let thrust = |thrust| Controls { thrust, ..Controls::default() };
    let mut game = Game::new(Arc::new(room())).unwrap();
    let (mut clock, mut latch, mut burnt) = (Clock::new(TICK_RATE), Latch::default(), Vec::new());
    for &(frame_time, held, pressed) in frames {
        latch.frame(thrust(held), thrust(pressed));
        clock.add(frame_time);
        while clock.tick() {
            game.step(latch.take());
            burnt.extend((game.ship().burning == 1).then_some(game.ticks()));
        }
    }
    burnt
}

#[test]
fn a_press_shorter_than_a_frame_is_felt_for_one_tick() {
    let slow = 4.0 / TICK_RATE;
    assert_eq!(ticks_burnt(&[(slow, false, true), (slow, false, false)]), [1]);
    assert_eq!(ticks_burnt(&[(slow, true, true), (slow, false, false)]), [1, 2, 3, 4]);
}

#[test]
fn a_press_in_a_frame_without_a_tick_is_not_lost() {
    let fast = 0.25 / TICK_RATE;
    let press = [(fast, true, true), (fast, false, false), (fast, false, false), (fast, false, false), (1.0 / 60.0, false, false)];
    assert_eq!(ticks_burnt(&press), [1]);
}
