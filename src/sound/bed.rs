//! The continuous sounds: the engine, the wind, the liquid around the ship. Noise, filtered by the strength of each.

use super::cue::Recipe;
use super::filter::{BandPass, Glide, LowPass, WhiteNoise};
use super::voice::Voice;
use super::{Ambience, Cue};
use std::f32::consts::TAU;

/// Time constant of the engine's response to thrust, s: immediate, but without a crack.
const ENGINE_TIME: f32 = 0.025;
/// Time constant of wind and liquid, s.
const SLOW: f32 = 0.12;
/// Samples between two updates of the filters.
const STEP: u32 = 64;
/// The loudness of each at its strongest.
const ENGINE: f32 = 0.42;
const RUMBLE: f32 = 0.11;
const WIND: f32 = 0.85;
const LIQUID: f32 = 0.35;
/// Pitch of the rumble below the engine, Hz.
const RUMBLE_PITCH: f32 = 46.0;
/// The most bubbles a second.
const BUBBLES: f32 = 16.0;

/// The filters of the bed and their states.
#[derive(Debug)]
pub struct Bed {
    rate: f32,
    engine: Glide,
    wind: Glide,
    liquid: Glide,
    motion: Glide,
    /// The engine's roar: one for both sides, and one for each.
    roar: [[LowPass; 2]; 3],
    /// The wind on each side.
    howl: [BandPass; 2],
    flow: LowPass,
    /// Phase of the rumble in turns, and the time of the slow wander, s.
    turn: f32,
    time: f32,
    age: u32,
}

impl Bed {
    pub fn new(rate: f32) -> Self {
        let (quick, slow) = (Glide::new(rate, ENGINE_TIME), Glide::new(rate, SLOW));
        Self {
            rate,
            engine: quick,
            wind: slow,
            liquid: slow,
            motion: slow,
            roar: Default::default(),
            howl: Default::default(),
            flow: LowPass::default(),
            turn: 0.0,
            time: 0.0,
            age: 0,
        }
    }

    /// The audible share of the ship under water, 0 … 1.
    pub const fn liquid(&self) -> f32 {
        self.liquid.value()
    }

    /// A bubble that begins at random.
    pub fn bubble(&mut self, noise: &mut WhiteNoise) -> Option<Voice> {
        let liquid = self.liquid.value();
        let rate = BUBBLES * liquid * (0.2 + 0.8 * self.motion.value());
        if liquid < 1e-3 || noise.between(0.0, 1.0) * self.rate >= rate {
            return None;
        }
        let (size, side) = (noise.between(0.0, 1.0), noise.between(0.35, 0.65));
        let gain = 0.5 * noise.between(0.3, 1.0);
        Some(Voice::new(&Recipe::of(Cue::Bubble, size), self.rate, [gain * (1.0 - side), gain * side]))
    }

    /// Left and right.
    pub fn next(&mut self, target: &Ambience, noise: &mut WhiteNoise) -> [f32; 2] {
        self.engine.towards(target.engine);
        self.wind.towards(target.wind);
        self.liquid.towards(target.liquid);
        self.motion.towards(target.motion);
        if self.age.is_multiple_of(STEP) {
            self.set_filters();
        }
        self.age = self.age.wrapping_add(1);
        let mut sum = [0.0; 2];
        if self.engine.value() > 1e-4 {
            self.add_engine(&mut sum, noise);
        }
        if self.wind.value() > 1e-4 {
            let gain = WIND * self.wind.value().powf(1.5);
            sum.iter_mut().zip(&mut self.howl).for_each(|(sum, howl)| *sum += gain * howl.next(noise.next()));
        }
        if self.liquid.value() > 1e-4 {
            let flow = LIQUID * self.liquid.value() * (0.3 + 0.7 * self.motion.value()) * self.flow.next(noise.next());
            sum.iter_mut().for_each(|sum| *sum += flow);
        }
        sum
    }

    fn add_engine(&mut self, sum: &mut [f32; 2], noise: &mut WhiteNoise) {
        let strength = self.engine.value();
        let mut roar = [0.0; 3];
        for (out, [first, second]) in roar.iter_mut().zip(&mut self.roar) {
            *out = second.next(first.next(noise.next()));
        }
        self.turn = (self.turn + RUMBLE_PITCH * (0.85 + 0.3 * strength) / self.rate).fract();
        let rumble = RUMBLE * (TAU * self.turn).sin();
        for (sum, own) in sum.iter_mut().zip(&roar[1..]) {
            *sum += strength * (ENGINE * (1.6 * roar[0] + 0.8 * own) + rumble);
        }
    }

    fn set_filters(&mut self) {
        let rate = self.rate;
        self.time += STEP as f32 / rate;
        let (engine, wind, t) = (self.engine.value(), self.wind.value(), self.time);
        for filter in self.roar.as_flattened_mut() {
            // A wide filter lets more pass: it makes the engine brighter and louder.
            filter.set(rate, 240.0 + 1300.0 * engine);
        }
        let gust = 1.0 + 0.22 * (TAU * 0.31 * t).sin() + 0.13 * (TAU * 0.83 * t).sin();
        for (side, howl) in self.howl.iter_mut().enumerate() {
            howl.set(rate, (170.0 + 1100.0 * wind) * gust * (1.0 + 0.07 * side as f32), 1.3);
        }
        self.flow.set(rate, 160.0 + 240.0 * self.motion.value());
        // Sines of a time that grows for hours lose their precision; the wander repeats after 100 s.
        if self.time >= 100.0 {
            self.time -= 100.0;
        }
    }
}
