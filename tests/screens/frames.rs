//! Flights at several frame rates, through the flight's screen: keys go down and up at instants, each frame hands the screen its keys and
//! its duration, and the states at the end are compared bit for bit.
//!
//! A frame sees the keys that changed since the frame before, and they act in the ticks that it lasts. A key pressed right behind a frame
//! acts from that frame's end on. So flights agree if their frames all end at the instants at which keys change, here every [`SLOT`].
//! In between they differ: a frame of 24 a second is five ticks, and a key that changes within acts at its end.

use crate::sitting::keys;
use crate::support::hashes::assert_golden;
use crate::support::rooms::{area, crate_at, yard};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use resultant::draw::Canvas;
use resultant::game::{Controls, Game, Outcome, TICK_RATE, TICKS_A_FRAME};
use resultant::level::{AirStream, Fluid, Level};
use resultant::physics::DVec2;
use resultant::screens::{Attempt, Flight, Input, Key, Keys, Screen};
use resultant::ui::{Memory, PassInput};
use std::sync::Arc;

/// From one instant at which keys may change to the next, s: frames of 24, 30, 60, 144 a second all end there.
const SLOT: f64 = 1.0 / 6.0;
const TICKS: u64 = 20;
/// Frames a second; each rate has a whole number of frames in a slot.
const RATES: [u32; 6] = [24, 30, 60, 120, 144, 240];

#[derive(Clone, Copy, Debug, PartialEq)]
enum Edge {
    Down(Key),
    Up(Key),
    /// Down and up again between two frames: it lasts one tick.
    Tap(Key),
    /// Esc, a second of nothing, and Esc again.
    Pause,
}

type Script = Vec<Vec<Edge>>;

/// The times that the frames of a slot take, s; together they take [`SLOT`].
type Frames<'a> = &'a mut dyn FnMut() -> Vec<f64>;

fn regular(rate: u32) -> impl FnMut() -> Vec<f64> {
    move || vec![1.0 / f64::from(rate); (f64::from(rate) * SLOT).round() as usize]
}

/// Frames of all lengths up to the longest that drops no tick.
fn irregular(seed: u64) -> impl FnMut() -> Vec<f64> {
    let mut random = Pcg32::seed_from_u64(seed);
    move || {
        let (mut frames, mut left) = (Vec::new(), SLOT);
        while left > 0.0 {
            let longest = f64::from(TICKS_A_FRAME) / TICK_RATE;
            let frame = random.random_range(1e-5..longest).min(left);
            frames.push(frame);
            left -= frame;
        }
        frames
    }
}

struct Screening {
    flight: Flight,
    memory: Memory,
}

impl Screening {
    fn new(level: &Level) -> Self {
        let flight = Flight::new(Attempt::by_hand(Arc::new(level.clone())), &mut ()).unwrap();
        Self { flight, memory: Memory::default() }
    }

    fn give(&mut self, input: &Input) {
        let canvas = Canvas::new(input.frame);
        let acts = PassInput { input, canvas: &canvas, spectator: &mut (), time: 0.0 };
        assert!(self.memory.act(acts, |ui| self.flight.show(ui)).is_none());
        let input = &input.without_edges();
        let shows = PassInput { input, canvas: &canvas, spectator: &mut (), time: 0.0 };
        assert!(self.memory.show(shows, |ui| self.flight.show(ui)).is_none());
    }
}

/// Flies the script through the screen and returns how its attempt stands at the end.
fn fly(level: &Level, script: &Script, frames: Frames<'_>) -> Game {
    let mut screening = Screening::new(level);
    let mut held: Vec<Key> = Vec::new();
    for edges in script {
        let mut pressed: Vec<Key> = Vec::new();
        for edge in edges {
            match *edge {
                Edge::Down(key) => {
                    held.push(key);
                    pressed.push(key);
                }
                Edge::Up(key) => held.retain(|other| *other != key),
                Edge::Tap(key) => pressed.push(key),
                Edge::Pause => {
                    for pressed in [keys(&[Key::Escape]), Keys::default(), keys(&[Key::Escape])] {
                        let seen = Input { pressed, held: keys(&held), frame_time: 1.0, ..Input::default() };
                        screening.give(&seen);
                    }
                }
            }
        }
        for (index, frame_time) in frames().into_iter().enumerate() {
            let pressed = if index == 0 { keys(&pressed) } else { Keys::default() };
            let seen = Input { pressed, held: keys(&held), frame_time, ..Input::default() };
            screening.give(&seen);
        }
    }
    assert_eq!(screening.flight.game().ticks(), TICKS * script.len() as u64, "the same time is the same ticks");
    screening.flight.game().clone()
}

/// The same tick by tick, without a screen, a clock and frames.
fn by_ticks(level: &Level, script: &Script) -> Game {
    let mut game = Game::new(Arc::new(level.clone())).unwrap();
    let mut held = Controls::default();
    let set = |controls: &mut Controls, key: Key, to: bool| match key {
        Key::Space => controls.thrust = to,
        Key::S => controls.reverse = to,
        Key::Left => controls.left = to,
        Key::Right => controls.right = to,
        other => panic!("{other:?} steers nothing"),
    };
    for edges in script {
        let mut first = held;
        for edge in edges {
            match *edge {
                Edge::Down(key) => [&mut held, &mut first].into_iter().for_each(|controls| set(controls, key, true)),
                Edge::Up(key) => [&mut held, &mut first].into_iter().for_each(|controls| set(controls, key, false)),
                Edge::Tap(key) => set(&mut first, key, true),
                // What is held at a pause counts once it was released.
                Edge::Pause => (held, first) = Default::default(),
            }
        }
        game.step(first);
        (1..TICKS).for_each(|_| game.step(held));
    }
    game
}

/// Keys that go down and up at random, each with a tap now and then.
fn script(seed: u64, slots: usize, pauses: bool) -> Script {
    let mut random = Pcg32::seed_from_u64(seed);
    let mut held: Vec<Key> = Vec::new();
    let mut slot = || {
        let mut edges = Vec::new();
        if pauses && random.random_bool(0.2) {
            edges.push(Edge::Pause);
        }
        for (key, often) in [(Key::Space, 0.5), (Key::S, 0.1), (Key::Left, 0.3), (Key::Right, 0.3)] {
            let is_held = held.contains(&key);
            if random.random_bool(if is_held { 0.5 } else { often }) {
                edges.push(if is_held { Edge::Up(key) } else { Edge::Down(key) });
                if is_held { held.retain(|other| *other != key) } else { held.push(key) }
            } else if !is_held && random.random_bool(0.3) {
                edges.push(Edge::Tap(key));
            }
        }
        edges
    };
    (0..slots).map(|_| slot()).collect()
}

fn yard_with_media() -> Level {
    Level { streams: stream(20.0, 30.0, 0.0), fluids: liquid(60.0, 50.0, 90.0), ..yard() }
}

/// Wind upwards from the floor, and aside by a force, N.
fn stream(left: f64, right: f64, aside: f64) -> Vec<AirStream> {
    let (source, zone) = (area(left, 59.0, right, 60.0), area(left, 20.0, right, 59.0));
    vec![AirStream { source, zone, force: DVec2::new(aside, -900.0), name: None }]
}

fn liquid(left: f64, top: f64, right: f64) -> Vec<Fluid> {
    vec![Fluid { zone: area(left, top, right, 60.0), density: 900.0, viscosity: 50.0, colour: [0; 3] }]
}

/// The yard with 80 crates in a heap beside the ship, more than one island is followed event by event with.
fn crowded_yard() -> Level {
    let mut level = yard();
    let place = |i: u32| DVec2::new(56.0 + 1.1 * f64::from(i % 10) + 0.05 * f64::from(i / 10), 58.0 - 1.2 * f64::from(i / 10));
    level.objects.extend((0..80).map(|i| crate_at(place(i), DVec2::ZERO, None)));
    level
}

#[test]
fn flights_through_a_crowd_a_liquid_and_a_stream_have_their_golden_hashes() {
    // The ship begins in the liquid and in the stream, and a crate is in either, too.
    let liquid = Level { fluids: liquid(40.0, 45.0, 70.0), ..yard() };
    let stream = Level { streams: stream(40.0, 52.0, 40.0), ..yard() };
    let levels = [("crowd", crowded_yard()), ("liquid", liquid), ("stream", stream)];
    let hashes = levels.map(|(name, level)| (name, the_same_at_every_rate(&level, &script(2, 30, false))));
    hashes.into_iter().for_each(|(name, hash)| assert_golden(name, hash));
}

/// Asserts that the script leads to the same bits at every frame rate, and returns their hash.
fn the_same_at_every_rate(level: &Level, script: &Script) -> u64 {
    let expected = by_ticks(level, script);
    assert_eq!(expected.outcome(), Outcome::Running, "the script is meant to fly to its end");
    for rate in RATES {
        let found = fly(level, script, &mut regular(rate)).hash();
        assert_eq!(found, expected.hash(), "{rate} frames a second");
    }
    for seed in 0..10 {
        assert_eq!(fly(level, script, &mut irregular(seed)).hash(), expected.hash(), "irregular frames, seed {seed}");
    }
    // The rates change during a flight, as on a machine that does other things as well.
    let mut slot = 0;
    let mixed = fly(level, script, &mut || {
        slot += 1;
        regular(RATES[slot % RATES.len()])()
    });
    assert_eq!(mixed.hash(), expected.hash(), "changing frame rates");
    expected.hash()
}

#[test]
fn keys_pressed_at_the_same_instants_give_the_same_bits_at_every_frame_rate() {
    for seed in 0..4 {
        the_same_at_every_rate(&yard_with_media(), &script(seed, 60, false));
    }
}

#[test]
fn a_pause_changes_no_bit_at_any_frame_rate() {
    let paused = script(9, 60, true);
    assert!(paused.iter().flatten().filter(|edge| **edge == Edge::Pause).count() > 5);
    let mut held = Vec::new();
    let mut let_go = |edge: Edge| match edge {
        Edge::Pause => held.drain(..).map(Edge::Up).collect(),
        Edge::Down(key) => {
            held.push(key);
            vec![edge]
        }
        Edge::Up(key) if !held.contains(&key) => vec![],
        Edge::Up(key) => {
            held.retain(|other| *other != key);
            vec![edge]
        }
        Edge::Tap(_) => vec![edge],
    };
    let without: Script = paused.iter().map(|edges| edges.iter().copied().flat_map(&mut let_go).collect()).collect();
    assert_eq!(the_same_at_every_rate(&yard_with_media(), &paused), the_same_at_every_rate(&yard_with_media(), &without));
}

/// The hash sees each edge, so that equal hashes above mean equal flights.
#[test]
fn an_edge_that_is_missing_or_comes_later_is_another_flight() {
    let script = script(1, 30, false);
    let expected = fly(&yard_with_media(), &script, &mut regular(60)).hash();
    for slot in (0..script.len() - 1).filter(|slot| !script[*slot].is_empty()).take(8) {
        let mut missing = script.clone();
        let edges = std::mem::take(&mut missing[slot]);
        assert_ne!(fly(&yard_with_media(), &missing, &mut regular(60)).hash(), expected, "without slot {slot}");
        let mut later = missing;
        later[slot + 1].splice(0..0, edges);
        assert_ne!(fly(&yard_with_media(), &later, &mut regular(60)).hash(), expected, "slot {slot} a slot later");
    }
}

/// The screen drops the time openly: it flies fewer ticks, and each is a tick of the fast machine's flight.
#[test]
fn frames_too_long_for_their_ticks_slow_the_flight_down_and_change_no_tick() {
    let level = yard_with_media();
    let mut screening = Screening::new(&level);
    for _ in 0..10 {
        let seen = Input { held: keys(&[Key::Space]), frame_time: 0.25, ..Input::default() };
        screening.give(&seen);
    }
    let ticks = u64::from(TICKS_A_FRAME) * 10;
    assert_eq!(screening.flight.game().ticks(), ticks);
    let mut game = Game::new(Arc::new(level)).unwrap();
    (0..ticks).for_each(|_| game.step(Controls { thrust: true, ..Controls::default() }));
    assert_eq!(screening.flight.game().hash(), game.hash());
}
